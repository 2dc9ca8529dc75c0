# Error: método de Euler-Cromer: primero la velocidad y con ella el ángulo.
# Salida como la de MATLAB: fprintf('%g\t%g\t%g\t%g\n', ...)
from math import *
import sys

cifras = 6
if len(sys.argv) > 1:
    cifras = int(sys.argv[1])
formato = '%.' + str(cifras) + 'g'

datos = sys.stdin.read().split()
while len(datos) >= 8:
    fdt = float(datos[0]); fcout = float(datos[1]); fsimul = float(datos[2])
    theta = float(datos[3]); w = float(datos[5]); alfa = float(datos[7])
    if datos[4] == 's': theta = theta*pi/180
    if datos[6] == 's': w = w*pi/180
    datos = datos[8:]
    while theta >= pi: theta -= 2*pi
    while theta < -pi: theta += 2*pi

    # tipo de movimiento
    E = w**2/(2*alfa) - cos(theta)
    fi = 0
    if abs(E - 1) < 1e-9:
        k = 0
        thetaM = pi if w >= 0 else -pi
        tau = abs(log(tan(0.999*thetaM/4 + pi/4)/tan(theta/4 + pi/4)))/sqrt(alfa)
    else:
        if E < 1:
            k = -1
            thetaM = acos(-E)
            T0 = 2*pi/sqrt(alfa)
            r = sin(thetaM/2)
            s = theta/thetaM
            if s >= 1: fi = pi/2
            elif s <= -1: fi = -pi/2
            elif w >= 0: fi = asin(s)
            else: fi = pi - asin(s)
        else:
            k = 1
            thetaM = pi
            A = sqrt(w**2 + 2*alfa*(1 - cos(theta)))/2
            T0 = pi/A
            r = sqrt(alfa)/A
        # la serie converge despacio si r es casi 1: transformacion de Landen hasta que no lo sea
        while r > 0.1:
            rp = sqrt(1 - r**2)
            r = (1 - rp)/(1 + rp)
            T0 = T0*(1 + r)
        a = 1
        S = 1
        n = 1
        while a > 1e-16*S:
            a = a*((2*n - 1)/(2*n)*r)**2
            S = S + a
            n = n + 1
        tau = T0*S

    # metodo de Euler
    dt = fdt*tau
    tcout = fcout*tau
    t = 0.0
    ts = []; ths = []; ws = []
    siguiente = 0.0
    while siguiente <= fsimul*tau*(1 + 1e-9):
        if t >= siguiente - dt/2:
            ts.append(t); ths.append(theta); ws.append(w)
            siguiente = siguiente + tcout
        w = w - alfa*sin(theta)*dt
        theta = theta + w*dt
        t = t + dt

    # tabla
    print('t\tangulo\tvelocidad' + ('\tfuncionSinusoidal' if k == -1 else ''))
    for i in range(len(ts)):
        th = ths[i]
        while th >= pi: th -= 2*pi
        while th < -pi: th += 2*pi
        fila = [ts[i], th, ws[i]]
        if k == -1: fila.append(thetaM*sin(2*pi*ts[i]/tau + fi))
        print('\t'.join(formato % x for x in fila))
    if len(datos) >= 8: print('\n')
