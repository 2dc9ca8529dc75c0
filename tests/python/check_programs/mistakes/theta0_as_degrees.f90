! Error: el angulo inicial se convierte siempre, aunque este en radianes.
program pendulo
  implicit none
  integer, parameter :: dp = kind(1.0d0)
  real(dp), parameter :: pi = 3.141592653589793_dp
  real(dp) :: fdt, fcout, fsim, theta, w, alfa, e, thetaM, tau, A, phi, dt
  character(len=1) :: u1, u2
  character(len=32) :: arg, formato
  integer :: cifras, ios, k, n, cada, total, tabla
  cifras = 6
  call get_command_argument(1, arg)
  if (len_trim(arg) > 0) read(arg, *) cifras
  write(formato, '(a,i0,a,i0,a)') '(4es', cifras + 9, '.', cifras - 1, 'e3)'
  tabla = 0
  do
    read(*, *, iostat=ios) fdt, fcout, fsim, theta, u1, w, u2, alfa
    if (ios /= 0) exit
    theta = theta*pi/180
    if (u2 == 's') w = w*pi/180
    theta = normaliza(theta)
    e = w**2/(2*alfa) - cos(theta)
    phi = 0
    if (abs(e - 1) < 1d-9) then
      k = 0
      thetaM = sign(pi, w)
      tau = abs(log(tan(0.999_dp*thetaM/4 + pi/4)/tan(theta/4 + pi/4)))/sqrt(alfa)
    else if (e < 1) then
      k = -1
      thetaM = acos(-e)
      tau = 2*pi/sqrt(alfa)*serie(sin(thetaM/2))
      phi = asin(max(-1.0_dp, min(1.0_dp, theta/thetaM)))
      if (w < 0) phi = pi - phi
    else
      k = 1
      A = sqrt(w**2 + 2*alfa*(1 - cos(theta)))/2
      tau = pi/A*serie(sqrt(alfa)/A)
    end if
    dt = fdt*tau
    cada = nint(fcout/fdt)
    total = nint(fsim/fdt)
    if (tabla > 0) write(*, '(/)')
    tabla = tabla + 1
    if (k == -1) then
      write(*, '(a)') 't angulo velocidad funcionSinusoidal'
    else
      write(*, '(a)') 't angulo velocidad'
    end if
    do n = 0, total
      if (mod(n, cada) == 0) then
        if (k == -1) then
          write(*, formato) n*dt, normaliza(theta), w, thetaM*sin(2*pi/tau*n*dt + phi)
        else
          write(*, formato) n*dt, normaliza(theta), w
        end if
      end if
      call paso(theta, w)
    end do
  end do
contains
  real(dp) function normaliza(x)
    real(dp), intent(in) :: x
    normaliza = x - 2*pi*floor((x + pi)/(2*pi))
  end function

  real(dp) function serie(r)
    real(dp), intent(in) :: r
    real(dp) :: termino
    integer :: m
    termino = 1
    serie = 1
    do m = 1, int(log(1d-14*(1 - r*r))/(2*log(r))) + 1
      termino = termino*(real(2*m - 1, dp)/(2*m)*r)**2
      serie = serie + termino
    end do
  end function

  real(dp) function acel(x)
    real(dp), intent(in) :: x
    acel = -alfa*sin(x)
  end function

  subroutine paso(x, v)
    real(dp), intent(inout) :: x, v
    real(dp) :: xA, xB, xC, xD, vA, vB, vC, vD
    xA = v*dt
    vA = acel(x)*dt
    xB = (v + vA/2)*dt
    vB = acel(x + xA/2)*dt
    xC = (v + vB/2)*dt
    vC = acel(x + xB/2)*dt
    xD = (v + vC)*dt
    vD = acel(x + xC)*dt
    x = x + xA/6 + xB/3 + xC/3 + xD/6
    v = v + vA/6 + vB/3 + vC/3 + vD/6
  end subroutine
end program
