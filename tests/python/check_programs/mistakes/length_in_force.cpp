/* Error: -g sen(theta) es la aceleración tangencial: falta dividirla por l. */
#include <stdlib.h>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <valarray>
using namespace std;

typedef valarray<double> vec;
const double PI = acos(-1.0);
double ALFA;

vec deriv(const vec& x)
{
  vec d(2);
  d[0] = x[1];
  double g = 9.81, l = g / ALFA, F = -ALFA * l * sin(x[0]);
  d[1] = F;
  return d;
}

void RungeKutta4(vec& x, double dt)
{
  vec A(2), B(2), C(2), D(2);
  A = deriv(x) * dt;
  B = deriv(x + A / 2.0) * dt;
  C = deriv(x + B / 2.0) * dt;
  D = deriv(x + C) * dt;
  x += A / 6.0 + B / 3.0 + C / 3.0 + D / 6.0;
}

/* integral eliptica completa, por Simpson */
double K(double r, int n)
{
  double s = 0;
  for (int i = 0; i <= n; i++)
    {
      double u = sin(i * PI / 2 / n);
      s += (i == 0 || i == n ? 1 : i % 2 ? 4 : 2) / sqrt(1 - r * r * u * u);
    }
  return s * PI / 2 / n / 3;
}

double K_con_precision(double r)
{
  int n = 64;
  while (fabs(K(r, n) / K(r, 2 * n) - 1) > 1e-12) n = 2 * n;
  return K(r, 2 * n);
}

double normaliza(double th)
{
  while (th < -PI) th = th + 2 * PI;
  while (th >= PI) th = th - 2 * PI;
  return th;
}

int main(int argc, char** argv)
{
  int cifras = (argc == 2) ? atoi(argv[1]) : 6, ancho = cifras + 8;
  bool primera = true;
  double fdt, fco, fsi, th, w;
  char ut, uw;
  while (cin >> fdt >> fco >> fsi >> th >> ut >> w >> uw >> ALFA)
    {
      if (ut == 's') th *= PI / 180;
      if (uw == 's') w *= PI / 180;
      th = normaliza(th);
      double thM, tau, phi = 0, E = 0.5 * w * w + ALFA * (1 - cos(th));
      int k = (fabs(E / (2 * ALFA) - 1) < 1e-9) ? 0 : (E < 2 * ALFA) ? -1 : +1;
      switch (k)
        {
        case -1:
          thM = acos(1 - E / ALFA);
          tau = 4 / sqrt(ALFA) * K_con_precision(sin(thM / 2));
          if (th / thM >= 1) phi = PI / 2;
          else if (th / thM <= -1) phi = -PI / 2;
          else phi = (w >= 0) ? asin(th / thM) : PI - asin(th / thM);
          break;
        case 0:
          thM = (w >= 0) ? PI : -PI;
          tau = fabs(log(tan(0.999 * thM / 4 + PI / 4) / tan(th / 4 + PI / 4))) / sqrt(ALFA);
          break;
        default:
          thM = PI;
          tau = 2 / sqrt(E / 2) * K_con_precision(sqrt(2 * ALFA / E));
        }
      if (!primera) cout << "\n\n";
      primera = false;
      cout << setw(ancho) << "t" << setw(ancho) << "angulo" << setw(ancho) << "velocidad";
      if (k == -1) cout << " " << setw(ancho + 8) << "funcionSinusoidal";
      cout << "\n" << setprecision(cifras);
      vec x(2);
      x[0] = th;
      x[1] = w;
      double dt = fdt * tau;
      int i = 0, ultimo = int(fsi / fdt + 0.5), salto = int(fco / fdt + 0.5);
      while (true)
        {
          cout << setw(ancho) << i * dt << setw(ancho) << normaliza(x[0]) << setw(ancho) << x[1];
          if (k == -1) cout << " " << setw(ancho + 8) << thM * sin(2 * PI / tau * i * dt + phi);
          cout << "\n";
          if (i + salto > ultimo) break;
          for (int j = 0; j < salto; j++, i++) RungeKutta4(x, dt);
        }
    }
  return 0;
}
