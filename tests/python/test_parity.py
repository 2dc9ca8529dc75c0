"""Python gives the very bits that the program prints with --precision full."""

from fractions import Fraction

import numpy as np
import pendula
import pytest
from doubles import same_bits

STARTS = {
    "at rest": (0.0, 0.0, 1.0),
    "small": (1e-9, 0.0, 9.81),
    "quarter turn": (np.pi / 2, 0.0, 1.0),
    "near the separatrix": (0.0, 1.999999895801368, 1.0),
    "on top": (np.pi, 0.0, 1.0),
    "separatrix": (0.0, -2.0, 1.0),
    "rotation": (0.3, 5.0, 2.0),
    "rotation from many turns": (-40.3, -7.0, 2.0),
}
COLUMNS = "t,theta,omega,sine,exact,error,energy,turns"
TWO_PI = 2 * Fraction(31415926535897932384626433832795028841971693993751, 10**49)


@pytest.fixture(params=STARTS.values(), ids=STARTS.keys())
def start(request):
    return request.param


def options(start, **more):
    theta0, omega0, alpha = map(repr, map(float, start))
    return {"theta0": theta0, "omega0": omega0, "alpha": alpha} | more


def as_printed(values, printed):
    """Whether values are the same doubles as those printed: the program never prints -0."""
    return same_bits(np.asarray(values) + 0.0, printed)


@pytest.mark.parametrize("method", ["rk4", "euler", "verlet", "taylor", "exact"])
def test_solve_has_the_programs_columns(table, start, method):
    theta0, omega0, alpha = start
    times = {"every": 0.25, "until": 20} | ({} if method in ("taylor", "exact") else {"dt": 0.003})
    printed = table(COLUMNS, **options(start, method=method, **times))
    solution = pendula.solve(theta0, omega0, alpha=alpha, method=method, **times)
    for name in ("t", "theta", "omega", "turns", "sine", "error", "energy"):
        assert as_printed(getattr(solution, name), printed[name]), name


def test_solve_has_the_programs_defaults(table, start):
    theta0, omega0, alpha = start
    printed = table("t,theta,omega", **options(start))
    solution = pendula.solve(theta0, omega0, alpha=alpha)
    assert as_printed([solution.t, solution.theta, solution.omega], list(printed.values()))


@pytest.mark.parametrize("method", ["rk4", "euler", "verlet", "taylor", "exact"])
def test_many_pendulums_have_the_bits_of_each_alone(method):
    theta0, omega0, alpha = np.array(list(STARTS.values())).T
    times = {"dt": 0.01, "every": 0.5, "until": 20, "method": method}
    together = pendula.solve(theta0, omega0, alpha=alpha, threads=2, **times)
    for i, start in enumerate(STARTS.values()):
        alone = pendula.solve(start[0], start[1], alpha=start[2], **times)
        for name in ("theta", "omega", "turns"):
            assert same_bits(getattr(together, name)[i], getattr(alone, name)), (name, start)


def test_analyze_has_the_programs_numbers(program, start):
    theta0, omega0, alpha = (repr(float(value)) for value in start)
    printed = program("analyze", "--theta0", theta0, "--omega0", omega0, "--alpha", alpha, "--precision", "full").split()
    assert as_printed(pendula.analyze(start[0], start[1], alpha=start[2]), [float(word) for word in printed])


def test_exact_is_the_programs_angle_with_its_turns_rounded_once(table, start):
    printed = table("t,theta,omega,turns", **options(start, method="exact", every=0.7, until=90))
    theta, omega = pendula.exact(start[0], start[1], printed["t"], alpha=start[2])
    assert as_printed(omega, printed["omega"])
    for got, wrapped, turns in zip(theta, printed["theta"], printed["turns"], strict=True):
        assert got == float(Fraction(float(wrapped)) + TWO_PI * int(turns))


def test_one_time_has_the_bits_of_many(start):
    t = np.linspace(-30, 300, 1001)
    many = pendula.exact(start[0], start[1], t, alpha=start[2])
    each = [pendula.exact(start[0], start[1], float(time), alpha=start[2]) for time in t]
    assert same_bits(many, np.transpose(each))


DRIVEN = {"theta0": 0.2, "beta": 0.5, "pivot_amplitude": 0.3, "drive_frequency": 0.7, "drive_phase": 1.0}
SWEPT = {"torque": "0:0.2:2", "drive_amplitude": "0.9:1.5:4"}
COUNTS = {"transient": 10, "periods": 16, "steps": 100, "method": "rk4"}


@pytest.fixture
def swept(program):
    """The columns that one of the program's measures prints over ranges of torque and amplitude, by name."""

    def columns(measure):
        options = [
            word for name, value in (DRIVEN | SWEPT | COUNTS).items() for word in (f"--{name.replace('_', '-')}", str(value))
        ]
        header, *lines = program(measure, "--format", "csv", "--precision", "full", *options).splitlines()
        words = zip(header.split(","), zip(*(line.split(",") for line in lines), strict=True), strict=True)
        return {name: np.array(column, str if name == "kind" else float) for name, column in words}

    return columns


def measured(function, torque, drive_amplitude):
    counts = {"transient": 10, "periods": 16, "steps_per_period": 100, "method": "rk4"}
    return function(omega0=0.0, torque=torque, drive_amplitude=drive_amplitude, **DRIVEN, **counts)


def test_measures_have_the_programs_numbers(swept):
    velocity = swept("mean-velocity")
    lyapunov = swept("lyapunov")
    swept_values = velocity["torque"], velocity["drive_amplitude"]
    found = measured(pendula.measure.mean_velocity, *swept_values)
    assert as_printed([found.mean_velocity, found.error], [velocity["mean_velocity"], velocity["error"]])
    found = measured(pendula.measure.lyapunov, *swept_values)
    assert as_printed(
        [found.exponent, found.error, found.horizon], [lyapunov[name] for name in ("lyapunov", "error", "horizon")]
    )


def test_sections_have_the_programs_points(swept):
    points = swept("section")
    rows = COUNTS["periods"]
    section = measured(pendula.measure.section, points["torque"][::rows], points["drive_amplitude"][::rows])
    assert as_printed([section.theta.ravel(), section.omega.ravel()], [points["theta"], points["omega"]])


def test_attractors_have_the_programs_numbers(swept):
    found = swept("attractors")
    attractors = measured(pendula.measure.attractors, found["torque"], found["drive_amplitude"])
    for name in ("label", "period", "rotation", "theta", "omega"):
        assert as_printed(getattr(attractors, name), found[name]), name
    assert [pendula.Kind(k).name for k in attractors.kind] == found["kind"].tolist()


@pytest.mark.parametrize("method", ["rk4", "taylor"])
def test_solve_has_the_programs_driven_pendulum(table, method):
    parameters = DRIVEN | {"omega0": -1.0, "alpha": 1.5, "torque": 0.3, "drive_amplitude": 1.4}
    printed = table("t,theta,omega,turns,energy", **parameters, method=method)
    solution = pendula.solve(**parameters, method=method)
    for name, values in printed.items():
        assert as_printed(getattr(solution, name), values), name
