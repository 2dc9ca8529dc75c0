! Mistake: the default kind of real, of single precision.
module motion
  implicit none
  integer, parameter :: r8 = kind(1.0)
  real(r8) :: alpha
contains
  function f(y) result(dy)
    real(r8), intent(in) :: y(2)
    real(r8) :: dy(2)
    dy = [y(2), -alpha*sin(y(1))]
  end function

  subroutine rk4(y, h)
    real(r8), intent(inout) :: y(2)
    real(r8), intent(in) :: h
    real(r8) :: k1(2), k2(2), k3(2), k4(2)
    k1 = f(y)
    k2 = f(y + h/2*k1)
    k3 = f(y + h/2*k2)
    k4 = f(y + h*k3)
    y = y + h/6*(k1 + 2*k2 + 2*k3 + k4)
  end subroutine

  recursive function agm(a, b) result(m)
    real(r8), intent(in) :: a, b
    real(r8) :: m
    m = a
    if (abs(a - b) > 1e-6*a) m = agm((a + b)/2, sqrt(a*b))
  end function
end module

program table
  use motion
  implicit none
  real(r8) :: pi, f1, f2, f3, y(2), e, limit, tau, phi, a, t, row(4)
  character :: u*1, v*1, words*8, layout*40
  integer :: digits, status, j, i, columns
  logical :: first = .true.
  pi = acos(-1.0_r8)
  digits = 6
  if (command_argument_count() > 0) then
    call get_command_argument(1, words)
    read(words, *) digits
  end if
  write(layout, '("(*(1x,es",i0,".",i0,"))")') digits + 8, digits - 1
  do
    read(*, *, iostat=status) f1, f2, f3, y(1), u, y(2), v, alpha
    if (status /= 0) exit
    if (u == 's') y(1) = y(1)*pi/180
    if (v == 's') y(2) = y(2)*pi/180
    y(1) = modulo(y(1) + pi, 2*pi) - pi
    e = y(2)**2/(2*alpha) - cos(y(1))
    limit = pi
    columns = 3
    phi = 0
    if (abs(e - 1) < 1d-9) then
      limit = sign(pi, y(2))
      tau = abs(log(tan((0.999_r8*limit + pi)/4)/tan((y(1) + pi)/4)))/sqrt(alpha)
    else if (e < 1) then
      columns = 4
      limit = acos(-e)
      tau = 2*pi/sqrt(alpha)/agm(1.0_r8, cos(limit/2))
      phi = asin(max(-1.0_r8, min(1.0_r8, y(1)/limit)))
      if (y(2) < 0) phi = pi - phi
    else
      a = sqrt(y(2)**2 + 2*alpha*(1 - cos(y(1))))/2
      tau = pi/agm(a, sqrt(a**2 - alpha))
    end if
    if (.not. first) print '(/)'
    first = .false.
    print '(a)', trim('t angulo velocidad funcionSinusoidal'(1:merge(36, 18, columns == 4)))
    do j = 0, int(f3/f2 + 1d-6)
      t = j*f2*tau
      row = [t, modulo(y(1) + pi, 2*pi) - pi, y(2), limit*sin(2*pi*t/tau + phi)]
      print layout, row(1:columns)
      do i = 1, nint(f2/f1)
        call rk4(y, f1*tau)
      end do
    end do
  end do
end program
