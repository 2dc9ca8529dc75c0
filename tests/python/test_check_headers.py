"""Headers name their columns in any words, with units in any spelling and between any separators."""

import itertools

import pytest
from pendula.check import tables
from pendula.check._table import placements

ROWS = "0 1.5708 0 1.5708\n0.148326 1.5598 -0.148324 1.55841\n0.296652 1.5268 -0.296595 1.52145\n"
NAMES = (
    "t angulo velocidad funcionSinusoidal",
    "tiempo ángulo velocidad~angular función~sinusoidal",
    "t θ ω sin",
    "$t$ $\\theta$ $\\omega$ $\\theta_s$",
    "Time Angle Angular~velocity Sine",
    "t theta w seno",
    "t theta theta' sin",
    "t th dth/dt lin",
    "TIEMPO ANGULO VELOCIDAD SENO",
    "t ang vel fsin",
    "t phi phi_dot sinus",
    "t posicion~angular rapidez~angular oscilador~armonico",
)
UNITS = (
    ("", "", "", ""),
    (" (s)", " (rad)", " (rad/s)", " (rad)"),
    ("(s)", "(rad)", "(rad / s)", "(rad)"),
    (" [s]", " [rad]", " [rad/s]", " [rad]"),
    ("/s", "/rad", "/(rad/s)", "/rad"),
    (" /s", " /rad", " /rad/s", " /rad"),
    (" / s", " / rad", " / (rad/s)", " / rad"),
    (" en s", " en rad", " en rad/s", " en rad"),
    (" (s)", " (º)", " (º/s)", " (º)"),
    (" (s)", " (rad)", " (rad·s⁻¹)", " (rad)"),
    (" ($s$)", " ($rad$)", " ($rad/s$)", " ($rad$)"),
)
SEPARATORS = (" ", "   ", "\t", ";", ",", ", ", " | ", " & ")


@pytest.mark.parametrize("names", NAMES)
@pytest.mark.parametrize("units", UNITS, ids=range(len(UNITS)))
def test_columns_are_found_whatever_units_are_called(names, units):
    words = [name.replace("~", " ") + unit for name, unit in zip(names.split(), units, strict=True)]
    for separator, end in itertools.product(SEPARATORS, ("\n", "\r\n")):
        (table,) = tables(separator.join(words) + end + ROWS)
        assert next(placements(table, oscillates=True)) == ("", {"t": 0, "theta": 1, "omega": 2, "sine": 3})
        assert table.notes == ()
