! Mistake: the mean of the four increments: all weigh 1/4.
program pendulo_simple
  implicit none
  double precision, parameter :: pi = acos(-1.0d0)
  double precision :: factores(3), ang0, vel0, alfa, limite, tau, fase0, y(2), t, dt, tsimul, tsiguiente, e
  character :: ua, uv
  character(len=16) :: argumento, cifras
  logical :: otra
  integer :: k, estado
  cifras = '6'
  if (command_argument_count() > 0) then
    call get_command_argument(1, argumento)
    cifras = argumento
  end if
  otra = .false.
  do
    read (*, *, iostat=estado) factores, ang0, ua, vel0, uv, alfa
    if (estado /= 0) exit
    if (any(factores <= 0) .or. alfa <= 0) stop 'datos no validos'
    if (ua == 's') ang0 = ang0*(pi/180)
    if (uv == 's') vel0 = vel0*(pi/180)
    ang0 = modulo(ang0 + pi, 2*pi) - pi
    e = vel0*vel0/2/alfa - cos(ang0)
    if (abs(e - 1) < 1d-9) then
      k = 0
      limite = merge(-pi, pi, vel0 < 0)
      tau = abs(log(tan((0.999d0*limite + pi)/4)/tan((ang0 + pi)/4)))/sqrt(alfa)
    else if (e < 1) then
      k = -1
      limite = acos(-e)
      tau = 2*pi/sqrt(alfa)*serie(sin(limite/2)**2)
    else
      k = 1
      limite = pi
      tau = pi*sqrt(2/(alfa*(1 + e)))*serie(2/(1 + e))
    end if
    if (abs(ang0/limite) < 1) then
      fase0 = asin(ang0/limite)
      if (vel0 < 0) fase0 = pi - fase0
    else
      fase0 = sign(pi/2, ang0/limite)
    end if
    if (otra) print '(/)'
    otra = .true.
    if (k < 0) then
      print '(a)', '              t         angulo      velocidad funcionSinusoidal'
    else
      print '(a)', '              t         angulo      velocidad'
    end if
    dt = factores(2)*tau/nint(factores(2)/factores(1))
    tsimul = factores(3)*tau
    tsiguiente = 0
    t = 0
    y = [ang0, vel0]
    do while (t < tsimul + dt/2)
      if (t > tsiguiente - dt/2) then
        call imprime([t, modulo(y(1) + pi, 2*pi) - pi, y(2), limite*sin(2*pi*t/tau + fase0)])
        tsiguiente = tsiguiente + factores(2)*tau
      end if
      y = y + paso(y, dt)
      t = t + dt
    end do
  end do
contains
  function serie(m) result(s)
    double precision, intent(in) :: m
    double precision :: s, a
    integer :: n
    s = 1
    a = 1
    n = 1
    do while (a > 1d-12*(1 - m))
      a = a*m*((2*n - 1)/(2d0*n))**2
      s = s + a
      n = n + 1
    end do
  end function

  function f(z) result(d)
    double precision, intent(in) :: z(2)
    double precision :: d(2)
    d = [z(2), -alfa*sin(z(1))]
  end function

  function paso(z, h) result(d)
    double precision, intent(in) :: z(2), h
    double precision :: d(2), a(2), b(2), c(2)
    a = h*f(z)
    b = h*f(z + a/2)
    c = h*f(z + b/2)
    d = h*f(z + c)
    d = (a + b + c + d)/4
  end function

  subroutine imprime(fila)
    double precision, intent(in) :: fila(4)
    print '(4(1x, g0.'//trim(cifras)//'))', fila(1:merge(4, 3, k < 0))
  end subroutine
end program
