# Error: queda una fuerza periódica, 0.5*cos(2*t/3).
# Traducido de MATLAB: x = [theta; omega], f = @(t, x) [x(2); -alfa*sin(x(1))], fprintf('%14.6e ...')
import sys
from math import *


def odefun(alfa):
    return lambda t, x: (x[1], -alfa*sin(x[0]) + 0.5*cos(2/3*t))


def rk4(f, t, x, h):
    mas = lambda x, c, k: tuple(xi + c*ki for xi, ki in zip(x, k))
    k1 = f(t, x)
    k2 = f(t + h/2, mas(x, h/2, k1))
    k3 = f(t + h/2, mas(x, h/2, k2))
    k4 = f(t + h, mas(x, h, k3))
    x = mas(x, h/6, k1)
    x = mas(x, h/3, k2)
    x = mas(x, h/3, k3)
    return mas(x, h/6, k4)


def ellipke(m):
    a, b = 1, sqrt(1 - m)
    for _ in range(12):
        a, b = (a + b)/2, sqrt(a*b)
    return pi/(2*a)


def mod(x, y):
    return x - y*floor(x/y)


cifras = int(sys.argv[1]) if len(sys.argv) > 1 else 6
celda = '%%%d.%de' % (cifras + 8, cifras - 1)
primera = True
for linea in sys.stdin:
    dato = linea.split()
    if len(dato) != 8:
        continue
    [fdt, fcout, fsim] = [float(d) for d in dato[0:3]]
    th0 = float(dato[3])
    om0 = float(dato[5])
    alfa = float(dato[7])
    if dato[4] == 's':
        th0 = th0*pi/180
    if dato[6] == 's':
        om0 = om0*pi/180
    th0 = mod(th0 + pi, 2*pi) - pi
    m = om0**2/(4*alfa) + (1 - cos(th0))/2    # m = E/(2mgl)
    if abs(m - 1) < 1e-9:
        thM = copysign(pi, om0)
        tau = abs(log(tan(0.999*thM/4 + pi/4)) - log(tan(th0/4 + pi/4)))/sqrt(alfa)
    elif m < 1:
        thM = 2*asin(sqrt(m))
        tau = 4*ellipke(m)/sqrt(alfa)
        s = th0/thM
        phi = asin(s) if abs(s) < 1 else copysign(pi/2, s)
        if om0 < 0 and abs(s) < 1:
            phi = pi - phi
    else:
        thM = pi
        tau = 2*ellipke(1/m)/sqrt(alfa*m)
    oscila = m < 1 and abs(m - 1) >= 1e-9

    f = odefun(alfa)
    h = fdt*tau
    t = 0
    x = (th0, om0)
    tabla = [(t, *x)]
    for fila in range(1, floor(fsim/fcout*(1 + 1e-9)) + 1):
        while t < fila*fcout*tau - h/2:
            x = rk4(f, t, x, h)
            t = t + h
        tabla.append((t, *x))

    if not primera:
        print('\n')
    primera = False
    print('t angulo velocidad' + ' funcionSinusoidal'*oscila)
    for (t, th, om) in tabla:
        fila = [t, mod(th + pi, 2*pi) - pi, om]
        if oscila:
            fila += [thM*sin(2*pi/tau*t + phi)]
        print(''.join(celda % x for x in fila))
