"""Benchmarks of the Python package, with NumPy's ufuncs, SciPy, Numba and heyoka as peers."""

import heyoka
import numba
import numpy as np
import pendula
import scipy
from peers import rk4, samples
from scipy.integrate import solve_ivp

VERSIONS = {"SciPy": scipy.__version__, "Numba": numba.__version__, "NumPy": np.__version__, "heyoka.py": heyoka.__version__}

START, SPEED = 0.0, 1.0  # from the bottom, as in `samples`
TAU = float(pendula.analyze(START, SPEED).tau)
MANY = np.linspace(0, 30 * TAU, 1_000_000)
ROWS = np.linspace(0, 10 * TAU, 501)
MEMBERS = np.linspace(0.01, 2.5, 256)
STEPS, DT = 2000, 7.4e-4


def right_side(_, state):
    return state[1], -np.sin(state[0])


def by_heyoka():
    """The integrator is compiled once; each call sets it to the initial state."""
    theta, omega = heyoka.make_vars("theta", "omega")
    integrator = heyoka.taylor_adaptive([(theta, omega), (omega, -heyoka.sin(theta))], [START, SPEED], tol=1e-15)

    def call():
        integrator.time = 0.0
        integrator.state[:] = START, SPEED
        return integrator.propagate_grid(ROWS)[-1][:, 0]

    return call


def by_solve_ivp():
    return solve_ivp(right_side, (0, ROWS[-1]), (START, SPEED), method="DOP853", t_eval=ROWS, rtol=1e-13, atol=1e-13).y[0]


def by_taylor():
    return pendula.solve(START, SPEED, t=ROWS, method="taylor").theta


def cases():
    """Yields name, call, and the number of items that a call computes. The first call compiles."""
    steps = len(MEMBERS) * STEPS
    still = np.zeros_like(MEMBERS)
    yield "python_call/pendula", lambda: pendula.exact(1.0, 0.5, 2.0), 1
    yield "python_call/ufunc", lambda: np.hypot(1.0, 0.5), 1
    yield "python_exact/pendula", lambda: pendula.exact(START, SPEED, MANY), MANY.size
    yield "python_exact/scipy", lambda: samples(1.0, SPEED, MANY), MANY.size
    yield "python_solve/pendula", by_taylor, ROWS.size
    yield "python_solve/scipy", by_solve_ivp, ROWS.size
    yield "python_solve/heyoka", by_heyoka(), ROWS.size
    until = STEPS * DT
    yield "python_rk4/pendula", lambda: pendula.solve(MEMBERS, 0.0, dt=DT, every=until, until=until, threads=1), steps
    yield "python_rk4/numba", lambda: rk4(MEMBERS.copy(), still.copy(), 1.0, DT, STEPS), steps


def errors():
    """The largest error of the angle [rad], compared with the closed form."""
    exact = pendula.exact(START, SPEED, ROWS)[0]
    solvers = {"pendula": by_taylor, "scipy": by_solve_ivp, "heyoka": by_heyoka()}
    return {f"python_solve/{name}": float(np.abs(call() - exact).max()) for name, call in solvers.items()}
