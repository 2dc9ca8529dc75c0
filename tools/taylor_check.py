"""The pendulum by Taylor series in time, to check the closed form: the two have only the equation in common."""

from mpmath import mpf, sqrt


def coefficients(alpha, theta, omega, order):
    """The coefficients x of theta(t0 + h) = sum of x[n] h^n, by recurrences for s = sin theta and c = cos theta."""
    from mpmath import cos, sin

    x, s, c = [theta, omega], [sin(theta)], [cos(theta)]
    for n in range(order - 1):
        x.append(-alpha * s[n] / ((n + 1) * (n + 2)))
        s.append(sum((j + 1) * x[j + 1] * c[n - j] for j in range(n + 1)) / (n + 1))
        c.append(-sum((j + 1) * x[j + 1] * s[n - j] for j in range(n + 1)) / (n + 1))
    return x


def integrate(alpha, theta, omega, t, order=40):
    """(theta, omega) at time t. The radius of convergence is about 1.5/sqrt(alpha), and smaller for a fast pendulum."""
    steps = int(abs(t) * 5 * (sqrt(alpha) + abs(omega))) + 1
    h = mpf(t) / steps
    for _ in range(steps):
        x = coefficients(alpha, theta, omega, order)
        theta = sum(a * h**n for n, a in enumerate(x))
        omega = sum(n * a * h ** (n - 1) for n, a in enumerate(x) if n)
    return theta, omega
