! A right program: always five significant digits.
program principal
  implicit none
  integer, parameter :: dp = kind(1.0d0)
  real(dp), parameter :: pi = 3.14159265358979323846_dp
  real(dp) :: alpha, fd, fc, fs, th0, w0, th, w, thM, tau, t, h, phi0
  character(len=1) :: ut, uw
  character(len=*), parameter :: formato = '(4es13.4)'
  integer :: k, ios, j, i, n, tablas
  tablas = 0
  do
    read (*, *, iostat=ios) fd, fc, fs, th0, ut, w0, uw, alpha
    if (ios /= 0) exit
    if (ut == 's') th0 = th0*pi/180
    if (uw == 's') w0 = w0*pi/180
    th0 = normaliza(th0)
    call analisis(th0, w0, 1.0e-10_dp, thM, tau, k)
    phi0 = fase(th0/thM, w0)
    n = nint(fc/fd)
    h = fc*tau/n
    if (tablas > 0) write (*, '(/)')
    tablas = tablas + 1
    write (*, '(a)') 't angulo velocidad'//merge(' funcionSinusoidal', '                  ', k == -1)
    th = th0
    w = w0
    do j = 0, int(fs/fc + 1.0e-9_dp)
      t = j*fc*tau
      if (k == -1) then
        write (*, formato) t, normaliza(th), w, thM*sin(2*pi/tau*t + phi0)
      else
        write (*, formato) t, normaliza(th), w
      end if
      do i = 1, n
        call rk4(th, w, h)
      end do
    end do
  end do
contains
  real(dp) function normaliza(x)
    real(dp), intent(in) :: x
    normaliza = x - 2*pi*floor((x + pi)/(2*pi))
  end function

  real(dp) function fase(s, r)
    real(dp), intent(in) :: s, r
    fase = asin(max(-1.0_dp, min(1.0_dp, s)))
    if (r < 0 .and. abs(s) < 1) fase = pi - fase
  end function

  subroutine analisis(th0, w0, eps, thM, tau, k)
    real(dp), intent(in) :: th0, w0, eps
    real(dp), intent(out) :: thM, tau
    integer, intent(out) :: k
    real(dp) :: e, T0, r, a, suma
    integer :: n, m
    e = w0**2/(2*alpha) - cos(th0)
    if (abs(e - 1) < 1.0e-9_dp) then
      k = 0
      thM = sign(pi, w0)
      tau = abs(log(tan(0.999_dp*thM/4 + pi/4)/tan(th0/4 + pi/4)))/sqrt(alpha)
      return
    end if
    if (e < 1) then
      k = -1
      thM = acos(cos(th0) - w0**2/(2*alpha))
      T0 = 2*pi/sqrt(alpha)
      r = sin(thM/2)
    else
      k = 1
      thM = pi
      r = sqrt(w0**2 + 2*alpha*(1 - cos(th0)))/2
      T0 = pi/r
      r = sqrt(alpha)/r
    end if
    m = 0
    if (r > 0) m = ceiling(log(eps*(1 - r**2))/(2*log(r)))
    a = 1
    suma = 1
    do n = 1, m
      a = a*(real(2*n - 1, dp)/(2*n)*r)**2
      suma = suma + a
    end do
    tau = T0*suma
  end subroutine

  subroutine rk4(th, w, h)
    real(dp), intent(inout) :: th, w
    real(dp), intent(in) :: h
    real(dp) :: k(4), l(4)
    k(1) = h*w
    l(1) = -h*alpha*sin(th)
    k(2) = h*(w + l(1)/2)
    l(2) = -h*alpha*sin(th + k(1)/2)
    k(3) = h*(w + l(2)/2)
    l(3) = -h*alpha*sin(th + k(2)/2)
    k(4) = h*(w + l(3))
    l(4) = -h*alpha*sin(th + k(3))
    th = th + (k(1) + 2*k(2) + 2*k(3) + k(4))/6
    w = w + (l(1) + 2*l(2) + 2*l(3) + l(4))/6
  end subroutine
end program
