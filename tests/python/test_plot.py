"""Figures hold what they should: data, labels, limits. Not pixels."""

import subprocess
import sys

import numpy as np
import pendula
import pytest

matplotlib = pytest.importorskip("matplotlib")
matplotlib.use("agg")
from matplotlib import pyplot  # noqa: E402, behind the choice of a backend
from pendula.plot._style import broken  # noqa: E402

PI_TICKS = ["−π", "−π/2", "0", "π/2", "π"]


@pytest.fixture
def ax():
    figure, axes = pyplot.subplots()
    yield axes
    pyplot.close(figure)


@pytest.fixture(scope="module")
def oscillation():
    return pendula.solve(np.pi / 2, 0.0)


@pytest.fixture(scope="module")
def rotation():
    return pendula.solve(0.0, 2.01, until=22.0, every=0.1)


def lines(ax):
    return {line.get_label(): line for line in ax.lines}


def legend(ax):
    return [text.get_text() for text in ax.get_legend().get_texts()]


def test_time_series_draws_circles_triangles_and_the_sinusoid(ax, oscillation):
    assert pendula.plot.time_series(oscillation, ax=ax) is ax
    sine, theta, omega = ax.lines
    assert (theta.get_marker(), omega.get_marker(), sine.get_linestyle()) == ("o", "^", "-")
    for line, values in ((sine, oscillation.sine), (theta, oscillation.theta), (omega, oscillation.omega)):
        assert np.array_equal(line.get_xdata(), oscillation.t)
        assert np.array_equal(line.get_ydata(), values)
    assert len(legend(ax)) == 3


def test_axes_carry_symbols_and_units(ax, oscillation):
    pendula.plot.time_series(oscillation, ax=ax)
    assert (ax.get_xlabel(), ax.get_ylabel()) == ("$t$ [s]", r"$\theta$ [rad],  $\omega$ [rad/s]")
    pendula.plot.phase_portrait(oscillation, ax=ax)
    assert (ax.get_xlabel(), ax.get_ylabel()) == ("$θ$ [rad]", "$ω$ [rad/s]")


def test_a_pendulum_that_does_not_oscillate_has_no_sinusoid(ax, rotation):
    pendula.plot.time_series(rotation, ax=ax)
    assert legend(ax) == [r"$\theta$", r"$\omega$"]


def test_the_legend_lies_outside_the_data(ax, oscillation):
    pendula.plot.time_series(oscillation, ax=ax)
    ax.figure.canvas.draw()
    assert ax.get_legend().get_window_extent().y0 >= ax.get_window_extent().y1


def test_many_rows_are_lines_and_not_marks(ax):
    solution = pendula.solve(0.0, 2.01, until=100.0, every=0.1)
    pendula.plot.time_series(solution, ax=ax)
    theta, omega = ax.lines
    assert {theta.get_marker(), omega.get_marker()} == {"None"}
    assert theta.get_linestyle() != omega.get_linestyle()


def test_pendulums_share_one_legend(ax):
    pendula.plot.time_series(pendula.solve([0.5, 1.0, 1.5], 0.0, until=6.0, every=0.1), ax=ax)
    assert len(ax.lines) == 9
    assert len(legend(ax)) == 3


def test_a_wrapped_angle_draws_no_line_across(ax, rotation):
    pendula.plot.phase_portrait(rotation, ax=ax, separatrix=False)
    theta, omega = ax.lines[0].get_data()
    step = np.diff(theta)
    assert np.abs(step[np.isfinite(step)]).max() < 0.5  # of 0.1 s at some 2 rad/s
    assert np.isnan(theta).sum() == rotation.turns[-1] == 3
    # It goes out by one edge and comes in by the other, at the same velocity.
    for gap in np.flatnonzero(np.isnan(theta)):
        assert (theta[gap - 1], theta[gap + 1]) == (np.pi, -np.pi)
        assert omega[gap - 1] == omega[gap + 1]


def test_broken_keeps_all_points_and_their_order():
    theta, turns = np.array([3.0, -3.1, -3.0, 3.1]), np.array([0.0, 1.0, 1.0, 0.0])
    angle, t = broken(theta, turns, np.arange(4.0))
    assert np.array_equal(angle, [3, np.pi, np.nan, -np.pi, -3.1, -3, -np.pi, np.nan, np.pi, 3.1], equal_nan=True)
    assert np.all(np.diff(t[np.isfinite(t)]) >= 0)
    unbroken = broken(theta[:1], turns[:1], theta[:1])
    assert all(np.array_equal(values, theta[:1]) for values in unbroken)


def test_more_than_a_turn_between_rows_leaves_only_a_gap():
    angle, _ = broken(np.array([0.0, 1.0]), np.array([0.0, 5.0]), np.zeros(2))
    assert np.array_equal(angle, [0, np.nan, np.nan, np.nan, 1], equal_nan=True)


@pytest.mark.parametrize("alpha", [1.0, 9.81])
def test_the_separatrix_has_the_energy_of_rest_on_top(ax, alpha):
    pendula.plot.phase_portrait(pendula.solve(1.0, 0.0, alpha=alpha), ax=ax)
    for branch in ax.lines[1:]:
        state = pendula.solve(*map(np.array, branch.get_data()), alpha=alpha, until=1e-3, every=1e-3, method="exact")
        assert np.allclose(state.energy[:, 0], 2 * alpha, rtol=1e-14)


def test_the_separatrix_is_left_out_with_friction_and_on_request(ax, oscillation):
    pendula.plot.phase_portrait(pendula.solve(1.0, 0.0, beta=0.1), ax=ax)
    pendula.plot.phase_portrait(oscillation, ax=ax, separatrix=False)
    assert len(ax.lines) == 2


def test_the_flow_points_to_where_the_pendulum_goes(ax, oscillation):
    pendula.plot.phase_portrait(oscillation, ax=ax, flow=True)
    (arrows,) = ax.collections
    x, y = arrows.XY.T
    moving, at_rest = np.abs(y) > 0.1, (np.abs(y) < 1e-9) & (np.abs(x) > 0.1)
    assert np.array_equal(np.sign(arrows.U[moving]), np.sign(y[moving]))  # θ' = ω
    assert np.array_equal(np.sign(arrows.V[at_rest]), -np.sign(x[at_rest]))  # back to the bottom


def test_the_angle_has_one_turn_with_ticks_at_its_quarters(ax, rotation):
    pendula.plot.phase_portrait(rotation, ax=ax, flow=True)
    assert ax.get_xlim() == (-np.pi, np.pi)
    assert [tick.get_text() for tick in ax.get_xticklabels()] == PI_TICKS


def test_lines_take_what_matplotlib_takes(ax, oscillation):
    pendula.plot.phase_portrait(oscillation, ax=ax, color="red", linewidth=3)
    assert (ax.lines[0].get_color(), ax.lines[0].get_linewidth()) == ("red", 3)


def test_a_section_is_dots_in_one_turn(ax):
    states = pendula.measure.section(0.2, 0.0, beta=0.5, drive_amplitude=1.2, drive_frequency=2 / 3, transient=0, periods=20)
    pendula.plot.section(states.theta, states.omega, ax=ax)
    assert ax.lines[0].get_linestyle() == "None"
    assert np.array_equal(ax.lines[0].get_xydata(), np.transpose([states.theta, states.omega]))
    assert ax.get_xlim() == (-np.pi, np.pi)


def test_a_bifurcation_has_each_parameters_points(ax):
    parameter, values = np.array([1.0, 2.0]), np.array([[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]])
    pendula.plot.bifurcation(parameter, values, ax=ax, names=("drive_amplitude", "theta"))
    assert np.array_equal(ax.lines[0].get_xydata(), [[1, 1], [1, 2], [1, 3], [2, 4], [2, 5], [2, 6]])
    assert (ax.get_xlabel(), ax.get_ylabel()) == ("$Γ$ [s⁻²]", "$θ$ [rad]")
    assert ax.get_ylim() == (-np.pi, np.pi)


def test_a_map_has_its_values_its_scale_and_its_labels(ax):
    values = np.arange(6.0).reshape(2, 3)
    pendula.plot.map([0, 1, 2], [5, 6], values, ax=ax, names=("torque", "beta", "mean_velocity"))
    (mesh,) = ax.collections
    assert np.array_equal(mesh.get_array().reshape(2, 3), values)
    assert (ax.get_xlabel(), ax.get_ylabel()) == ("$μ$ [s⁻²]", "$β$ [s⁻¹]")
    assert ax.figure.axes[1].get_ylabel() == "$⟨ω⟩$ [rad/s]"


def test_a_map_of_both_signs_parts_its_colours_at_0(ax):
    pendula.plot.map([0, 1], [0, 1], [[-1.0, 3.0], [np.nan, 0.5]], ax=ax)
    assert ax.collections[0].get_clim() == (-3, 3)


def test_a_map_of_whole_numbers_has_a_colour_for_each(ax):
    pendula.plot.map([0, 1], [0, 1], [[0, 1], [2, 1]], ax=ax)
    colours = ax.collections[0].to_rgba(np.array([0, 1, 2]))
    assert len({tuple(colour) for colour in colours}) == 3
    assert tuple(colours[0]) == (1, 1, 1, 1)


def test_a_map_of_another_shape_is_refused(ax):
    with pytest.raises(ValueError, match=r"values must have the shape \[y, x\], here \(2, 3\), got \(3, 2\)"):
        pendula.plot.map([0, 1, 2], [0, 1], np.zeros((3, 2)), ax=ax)


def test_labels_come_from_arrays_that_know_their_names(ax):
    xarray = pytest.importorskip("xarray")
    data = xarray.DataArray(
        [[1.0, 2.0]], dims=("beta", "torque"), coords={"beta": [0.1], "torque": [1, 2]}, name="mean_velocity"
    )
    pendula.plot.map(data.torque, data.beta, data, ax=ax)
    assert (ax.get_xlabel(), ax.get_ylabel()) == ("$μ$ [s⁻²]", "$β$ [s⁻¹]")


def test_figures_make_their_own_axes(oscillation):
    for draw in (pendula.plot.time_series, pendula.plot.phase_portrait, pendula.Solution.plot):
        axes = draw(oscillation)
        assert axes.lines
        pyplot.close(axes.figure)


def test_an_animation_has_a_frame_a_row_with_the_bob_where_the_pendulum_is(tmp_path):
    solution = pendula.solve(3.0, 0.0, until=1.0, every=0.25)
    film = pendula.plot.animate(solution)
    *_, bob, state, clock = film._func(2)  # type: ignore[attr-defined]
    assert np.allclose([*bob.get_data()], [[np.sin(solution.theta[2])], [-np.cos(solution.theta[2])]])
    assert np.array_equal([*state.get_data()], [[solution.theta[2]], [solution.omega[2]]])
    assert clock.get_text() == "$t$ = 0.50 s"
    film.save(tmp_path / "film.gif", writer="pillow", dpi=20)
    with pytest.importorskip("PIL.Image").open(tmp_path / "film.gif") as image:
        assert (image.n_frames, image.info["duration"]) == (5, 250)


@pytest.mark.parametrize(
    ("start", "speed", "reason"),
    [
        ({"theta0": [1.0, 2.0]}, 1, "animate takes one pendulum"),
        ({"theta0": 1.0, "until": 0.1, "every": 1.0}, 1, "animate takes one pendulum"),
        ({"theta0": 1.0}, 0, "speed must be positive"),
        ({"theta0": 1.0}, 1e-300, "a frame must not last longer"),
    ],
)
def test_what_cannot_be_animated_is_refused(start, speed, reason):
    with pytest.raises(ValueError, match=reason):
        pendula.plot.animate(pendula.solve(omega0=0.0, **start), speed=speed)


def test_colours_differ_in_grey():
    """So that they can be told apart in print: by a tenth of the way from black to white, or by their marks."""
    from matplotlib.colors import to_rgb
    from pendula.plot._style import BLUE, GREY, VERMILION

    greys = [np.dot(to_rgb(colour), [0.299, 0.587, 0.114]) for colour in (BLUE, VERMILION, GREY)]
    assert abs(greys[1] - greys[0]) > 0.1


def test_without_matplotlib_the_message_names_the_extra():
    code = "import sys; sys.modules['matplotlib'] = None; import pendula; pendula.solve(1.0, 0.0).plot()"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    assert (
        done.stderr.splitlines()[-1]
        == "ImportError: pendula.plot needs matplotlib; install it with: pip install 'pendula[plot]'"
    )


def test_all_names_of_plot_leave_those_of_python_alone():
    names: dict[str, object] = {}
    exec("from pendula.plot import *", names)
    assert {"animate", "bifurcation", "phase_portrait", "section", "time_series"} == names.keys() - {"__builtins__"}
    assert pendula.plot.map is not map


def test_importing_pendula_does_not_import_matplotlib():
    subprocess.run([sys.executable, "-c", "import pendula, sys; assert 'matplotlib' not in sys.modules"], check=True)
