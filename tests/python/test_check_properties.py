"""No right table is ever wrong, and none that was marred is ever right.

PENDULA_EXAMPLES says how many right tables are tried; of each kind of marred ones it is a tenth.
"""

import os
from collections.abc import Sequence

import numpy as np
from check_layouts import LAYOUTS
from check_marking import told
from check_tables import Truth, cases, doubts, file_of, problems, rows, truth
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from pendula import _core, exact

EXAMPLES = int(os.environ.get("PENDULA_EXAMPLES", "300"))


@settings(max_examples=EXAMPLES)
@given(cases())
def test_no_right_table_is_ever_wrong(case):
    assert told(case.problem.text(), file_of(case)).errors == frozenset()


marred = settings(max_examples=max(1, EXAMPLES // 10))  # each is explained, or tried to be
# Runge-Kutta's error is below the digits printed, and rows are at the ends of steps, so that their times are known.
fine_problems = problems(longest=0.002, in_steps=True)
precisions = st.integers(6, 9)
places = st.floats(0, 1, exclude_max=True)


@marred
@given(fine_problems, precisions, places, st.integers(0, 3), st.sampled_from([3, -3, 5, -20, 1000]))
def test_a_table_with_a_wrong_cell_is_never_right(chosen, digits, place, column, units):
    known = judged(chosen)
    assume(column < len(known.columns))
    table = [np.array(values) for values in known.columns]
    row = int(place * table[0].size)
    value = table[column][row]
    # A number that is almost 0 has no digits of its own: roundings are those of the column.
    size = abs(value) if abs(value) > 1e-6 * np.abs(table[column]).max() else np.abs(table[column]).max()
    # A number just below a power of ten is printed as that.
    unit = 10.0 ** (np.floor(np.log10(size * (1 + 1e-4))) + 1 - digits)
    # 3 units beside 3 times what is nobody's fault.
    table[column][row] = value + units * unit + np.sign(units) * 3 * (doubts(known) + errors_of_method(known))[column][row]
    # A number of the first row with fewer digits may be the state as it was typed.
    assume(row > 0 or f"{table[column][row]:.{digits - 1}e}".partition("e")[0][-1] != "0")
    assert not told(chosen.text(), printed(table, digits)).is_right


@marred
@given(fine_problems, precisions, places)
def test_a_table_without_one_of_its_rows_is_never_right(chosen, digits, place):
    lines = printed(judged(chosen).columns, digits).splitlines(keepends=True)
    # The last one may be lost to rounding, and behind the header is the first.
    del lines[1 + int(place * (len(lines) - 2))]
    assert not told(chosen.text(), b"".join(lines)).is_right


@marred
@given(fine_problems, precisions, places, places)
def test_a_table_with_two_rows_exchanged_is_never_right(chosen, digits, one, other):
    lines = printed(judged(chosen).columns, digits).splitlines(keepends=True)
    first, second = (1 + int(place * (len(lines) - 1)) for place in (one, other))
    assume(lines[first] != lines[second])
    lines[first], lines[second] = lines[second], lines[first]
    assert not told(chosen.text(), b"".join(lines)).is_right


def judged(chosen):
    """What is known of a problem all of whose rows are judged."""
    known = truth(chosen.text())
    energy = known.omega0**2 / (4 * known.alpha) + np.sin(known.theta0 / 2) ** 2
    assume(abs(energy - 1) > 1e-2)  # nearer to the separatrix, rounding decides the later rows
    assume(known.theta_max > 1e-9)  # a pendulum at rest has no digits
    return known


def printed(columns: Sequence[np.ndarray], digits: int) -> bytes:
    return LAYOUTS["assignment"](rows(*columns), digits)


def errors_of_method(known: Truth) -> np.ndarray:
    """Twice Runge-Kutta's own, which none of a better method has."""
    t, theta, omega = known.columns[:3]
    exact_theta, exact_omega = exact(known.theta0, known.omega0, t, alpha=known.alpha)
    largest = [0, np.abs(_core.wrap(theta - exact_theta)).max(), np.abs(omega - exact_omega).max(), 0]
    return 2 * np.array(largest)[: len(known.columns), np.newaxis]
