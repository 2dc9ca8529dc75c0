// Error: PI con cuatro decimales, en todo el programa.
#include <cmath>
#include <cstdlib>
#include <iomanip>
#include <iostream>
#define PI 3.1416
using namespace std;

int main(int argc, char *argv[])
{
	double factorDt, factorCout, factorSimul, tita, w, alfa;
	char ut, uw;
	int precision = 6, numero = 0;
	if (argc > 1) precision = atoi(argv[1]);
	while (cin >> factorDt >> factorCout >> factorSimul >> tita >> ut >> w >> uw >> alfa)
	{
		// unidades
		if (ut == 's') tita = tita * PI / 180.;
		if (uw == 's') w = w * PI / 180.;
		tita = tita - 2 * PI * floor((tita + PI) / (2 * PI));

		// analisis
		double C = w * w / (2 * alfa) - cos(tita);
		double titaM = PI, T0 = 0, r = 0, tau, fi = 0;
		int k = 1;
		if (abs(C - 1) < 1e-9) { k = 0; if (w < 0) titaM = -PI; }
		else if (C < 1) { k = -1; titaM = acos(-C); T0 = 2 * PI / sqrt(alfa); r = sin(titaM / 2); }
		else { double A = sqrt(w * w + 2 * alfa * (1 - cos(tita))) / 2; T0 = PI / A; r = sqrt(alfa) / A; }
		if (k == 0)
		{
			tau = log(tan(0.999 * titaM / 4 + PI / 4) / tan(tita / 4 + PI / 4)) / sqrt(alfa);
			if (w < 0) tau = -tau;
		}
		else
		{
			double a = 1, suma = 1, anterior = 0;
			int n = 1;
			while (suma != anterior)
			{
				anterior = suma;
				a = a * pow((2. * n - 1) / (2. * n) * r, 2);
				suma = suma + a;
				n++;
			}
			tau = T0 * suma;
		}
		if (k == -1)
		{
			if (tita >= titaM) fi = PI / 2;
			else if (tita <= -titaM) fi = -PI / 2;
			else { fi = asin(tita / titaM); if (w < 0) fi = PI - fi; }
		}

		// simulacion
		if (numero++ > 0) cout << "\n\n";
		cout << "t,angulo,velocidad" << (k == -1 ? ",funcionSinusoidal" : "") << "\n";
		double h = factorDt * tau, t = 0;
		long contador = 0, cada = lround(factorCout / factorDt);
		do
		{
			if (contador % cada == 0)
			{
				double n = floor((tita + PI) / (2 * PI));
				cout << setprecision(precision) << t << "," << tita - 2 * n * PI << "," << w;
				if (k == -1) cout << "," << titaM * sin(2 * PI / tau * t + fi);
				cout << endl;
			}
			double k1 = h * w, l1 = -h * alfa * sin(tita);
			double k2 = h * (w + l1 / 2), l2 = -h * alfa * sin(tita + k1 / 2);
			double k3 = h * (w + l2 / 2), l3 = -h * alfa * sin(tita + k2 / 2);
			double k4 = h * (w + l3), l4 = -h * alfa * sin(tita + k3);
			tita = tita + (k1 + 2 * k2 + 2 * k3 + k4) / 6;
			w = w + (l1 + 2 * l2 + 2 * l3 + l4) / 6;
			contador++;
			t = contador * h;
		} while (t <= factorSimul * tau + h / 2);
	}
	return 0;
}
