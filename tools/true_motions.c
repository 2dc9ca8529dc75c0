// Two integrators of the pendulum's equation for tools/true_motions.py, independent of pendula's and of each other: Taylor
// series in long double for single orbits, and Dormand and Prince's method of order 8 for many pendulums side by side.
#include <math.h>
#include <string.h>

typedef long double real;
enum { ALPHA, BETA, TORQUE, DRIVE, PIVOT, FREQUENCY, PHASE };  // the order of the parameters
enum { ORDER = 28, STATES = 6 };  // theta, omega, and two displacements (d_theta, d_omega)

// The last coefficient of a product of two series.
static real product(const real* x, const real* y, int n) {
    real sum = 0;
    for (int k = 0; k <= n; ++k) sum += x[k] * y[n - k];
    return sum;
}

// The coefficients of theta, omega and the displacements about a time at which the phase of the drive is given.
static void series(const real* p, real phase, const real* y, int has_displacements, real a[STATES][ORDER + 1]) {
    real s[ORDER + 1], c[ORDER + 1], stiffness[ORDER + 1], slope[ORDER + 1], force[ORDER + 1], pull[ORDER + 1];
    const int pivot = p[PIVOT] != 0, driven = pivot || p[DRIVE] != 0;
    const real wave[4] = {driven ? cosl(phase) : 0, driven ? -sinl(phase) : 0, driven ? -cosl(phase) : 0, driven ? sinl(phase) : 0};
    real power = 1;
    for (int n = 0; n <= ORDER; ++n) {
        const real drive = driven ? power * wave[n % 4] : 0;
        stiffness[n] = p[PIVOT] * drive + (n == 0 ? p[ALPHA] : 0);
        force[n] = p[DRIVE] * drive + (n == 0 ? p[TORQUE] : 0);
        power *= p[FREQUENCY] / (n + 1);
    }
    for (int i = 0; i < STATES; ++i) a[i][0] = y[i];
    s[0] = sinl(y[0]);
    c[0] = cosl(y[0]);
    for (int n = 0; n < ORDER; ++n) {
        pull[n] = pivot ? product(stiffness, s, n) : p[ALPHA] * s[n];
        slope[n] = pivot ? product(stiffness, c, n) : p[ALPHA] * c[n];
        a[0][n + 1] = a[1][n] / (n + 1);
        a[1][n + 1] = (force[n] - pull[n] - p[BETA] * a[1][n]) / (n + 1);
        s[n + 1] = product(a[1], c, n) / (n + 1);
        c[n + 1] = -product(a[1], s, n) / (n + 1);
        for (int i = 2; has_displacements && i < STATES; i += 2) {
            a[i][n + 1] = a[i + 1][n] / (n + 1);
            a[i + 1][n + 1] = (-product(slope, a[i], n) - p[BETA] * a[i + 1][n]) / (n + 1);
        }
    }
}

static real value(const real* a, real h) {
    real sum = 0;
    for (int n = ORDER; n >= 0; --n) sum = sum * h + a[n];
    return sum;
}

// A step in which the last two terms are below 1e-20 of the largest of 1 and the state (Jorba and Zou, 2005).
static real step_of(real a[STATES][ORDER + 1], int states) {
    real h = 1e300L;
    for (int i = 0; i < states; ++i) {
        const real scale = 1e-20L * fmaxl(1, fabsl(a[i][0]));
        for (int n = ORDER - 1; n <= ORDER; ++n)
            if (a[i][n] != 0) h = fminl(h, powl(scale / fabsl(a[i][n]), 1.0L / n));
    }
    return h;
}

// Advances y by the time; the drive has the phase p[PHASE] at the start.
void follow(const real* p, real* y, const real* time, int has_displacements) {
    real a[STATES][ORDER + 1] = {{0}};
    const int states = has_displacements ? STATES : 2;
    for (real t = 0; t < *time;) {
        series(p, p[PHASE] + p[FREQUENCY] * t, y, has_displacements, a);
        const real h = fminl(step_of(a, states), *time - t);
        for (int i = 0; i < states; ++i) y[i] = value(a[i], h);
        t += h;
    }
}

// Advances y, without displacements, until theta has grown by `angle` > 0, and sets the time; -1 if that takes `longest`.
void turn(const real* p, real* y, const real* angle, const real* longest, real* time) {
    real a[STATES][ORDER + 1] = {{0}};
    const real end = y[0] + *angle;
    *time = -1;
    for (real t = 0; t < *longest;) {
        series(p, p[PHASE] + p[FREQUENCY] * t, y, 0, a);
        real h = step_of(a, 2);
        const real next = value(a[0], h);
        if (next >= end) {
            real low = 0, high = h;
            for (int i = 0; i < 80; ++i) {
                const real middle = low + (high - low) / 2;
                *(value(a[0], middle) >= end ? &high : &low) = middle;
            }
            y[0] = end;
            y[1] = value(a[1], high);
            *time = t + high;
            return;
        }
        y[0] = next;
        y[1] = value(a[1], h);
        t += h;
    }
}

enum { LANES = 8, STAGES = 12, PARTS = 4, MOST_STEPS = 8192 };
typedef double Lanes[LANES];

// Follows LANES pendulums through periods of their drives, in `steps` equal steps each. Parameters and states (theta, omega,
// d_theta, d_omega) are rows of LANES numbers. Row n of `advance` is the change of theta in period n, and of `growth` the
// logarithm of the growth of the displacement, which is divided by it. theta is wrapped after each period.
void march(const double* parameters, double* states, int periods, int steps, const double* nodes, const double* weights,
           const double* last, double* advance, double* growth) {
    static double wave[MOST_STEPS][STAGES][LANES];
    const Lanes* p = (const Lanes*)parameters;
    Lanes* state = (Lanes*)states;
    Lanes h;
    for (int l = 0; l < LANES; ++l) h[l] = 2 * M_PI / p[FREQUENCY][l] / steps;
    for (int n = 0; n < steps; ++n)
        for (int i = 0; i < STAGES; ++i)
            for (int l = 0; l < LANES; ++l) wave[n][i][l] = cos(p[PHASE][l] + 2 * M_PI * (n + nodes[i]) / steps);
    // cos(theta) is written as a sine: gcc would join sin and cos in one function that has no version for vectors.
    for (int period = 0; period < periods; ++period) {
        Lanes y[PARTS], start, k[STAGES][PARTS];
        memcpy(y, state, sizeof y);
        memcpy(start, y[0], sizeof start);
        for (int n = 0; n < steps; ++n) {
            for (int i = 0; i < STAGES; ++i) {
                Lanes z[PARTS] = {{0}};
                for (int j = 0; j < i; ++j) {
                    const double weight = weights[STAGES * i + j];
                    if (weight == 0) continue;
                    for (int q = 0; q < PARTS; ++q)
                        for (int l = 0; l < LANES; ++l) z[q][l] += weight * k[j][q][l];
                }
                for (int l = 0; l < LANES; ++l) {
                    const double theta = y[0][l] + h[l] * z[0][l], omega = y[1][l] + h[l] * z[1][l];
                    const double d_theta = y[2][l] + h[l] * z[2][l], d_omega = y[3][l] + h[l] * z[3][l];
                    const double stiffness = p[ALPHA][l] + p[PIVOT][l] * wave[n][i][l];
                    k[i][0][l] = omega;
                    k[i][1][l] =
                        p[TORQUE][l] + p[DRIVE][l] * wave[n][i][l] - stiffness * sin(theta) - p[BETA][l] * omega;
                    k[i][2][l] = d_omega;
                    k[i][3][l] = -stiffness * sin(theta + M_PI / 2) * d_theta - p[BETA][l] * d_omega;
                }
            }
            for (int i = 0; i < STAGES; ++i)
                for (int q = 0; q < PARTS; ++q)
                    for (int l = 0; l < LANES; ++l) y[q][l] += h[l] * last[i] * k[i][q][l];
        }
        for (int l = 0; l < LANES; ++l) {
            const double length = sqrt(y[2][l] * y[2][l] + y[3][l] * y[3][l] / (p[FREQUENCY][l] * p[FREQUENCY][l]));
            advance[LANES * period + l] = y[0][l] - start[l];
            growth[LANES * period + l] = log(length);
            y[0][l] -= 2 * M_PI * floor((y[0][l] + M_PI) / (2 * M_PI));
            y[2][l] /= length;
            y[3][l] /= length;
        }
        memcpy(state, y, sizeof y);
    }
}
