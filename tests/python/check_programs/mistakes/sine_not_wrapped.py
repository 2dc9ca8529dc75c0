# The sinusoid goes about the whole turns that the initial angle was given with, and is not brought to [−π, π).
import math
import sys

PI = math.pi
nd = 6
if len(sys.argv) == 2:
    nd = int(sys.argv[1])
palabras = []
for linea in sys.stdin:
    palabras += linea.split()

primero = True
while len(palabras) >= 8:
    fD, fC, fT = float(palabras[0]), float(palabras[1]), float(palabras[2])
    th0, w0, al = float(palabras[3]), float(palabras[5]), float(palabras[7])
    if palabras[4] == "s":
        th0 = th0 * PI / 180
    if palabras[6] == "s":
        w0 = w0 * PI / 180
    palabras = palabras[8:]
    vueltas = 0
    while th0 >= PI:
        th0 -= 2 * PI
        vueltas += 1
    while th0 < -PI:
        th0 += 2 * PI
        vueltas -= 1

    # periodo
    E = w0 * w0 / 2 + al * (1 - math.cos(th0))
    if abs(E - 2 * al) < 1e-9 * 2 * al:
        k = 0
        thM = PI
        if w0 < 0:
            thM = -PI
        C = 1 / math.tan(th0 / 4 + PI / 4)
        tau = abs(math.log(C * math.tan(0.999 * thM / 4 + PI / 4)) / math.sqrt(al))
    else:
        if E < 2 * al:
            k = -1
            thM = math.acos(1 - E / al)
            T0 = 2 * PI / math.sqrt(al)
            r = math.sin(thM / 2)
        else:
            k = 1
            thM = PI
            A = math.sqrt(2 * E) / 2
            T0 = PI / A
            r = math.sqrt(al) / A
        suma = 0
        a = 1
        n = 0
        while a > 1e-12:
            suma += a
            n += 1
            a = a * ((2 * n - 1) * r / (2 * n)) ** 2
        tau = T0 * suma

    # fase
    fi = PI / 2
    if th0 / thM < 1:
        fi = math.asin(max(th0 / thM, -1))
        if w0 < 0:
            fi = PI - fi

    if not primero:
        print()
        print()
    primero = False
    pasos = round(fC / fD)
    dt = fC * tau / pasos
    filas = int(fT / fC + 1e-6)
    th, w = th0, w0
    print("t angulo velocidad" + " funcionSinusoidal" * (k == -1))
    for j in range(filas + 1):
        t = j * fC * tau
        x = th - 2 * PI * math.floor((th + PI) / (2 * PI))
        ths = thM * math.sin(2 * PI / tau * t + fi) + 2 * PI * vueltas
        if k == -1:
            print("%.*g %.*g %.*g %.*g" % (nd, t, nd, x, nd, w, nd, ths))
        else:
            print("%.*g %.*g %.*g" % (nd, t, nd, x, nd, w))
        for i in range(pasos):
            tA, wA = w, -al * math.sin(th)
            tB, wB = w + wA * dt / 2, -al * math.sin(th + tA * dt / 2)
            tC, wC = w + wB * dt / 2, -al * math.sin(th + tB * dt / 2)
            tD, wD = w + wC * dt, -al * math.sin(th + tC * dt)
            th = th + dt / 6 * (tA + 2 * tB + 2 * tC + tD)
            w = w + dt / 6 * (wA + 2 * wB + 2 * wC + wD)
