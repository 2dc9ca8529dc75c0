"""`pendula check` where right and wrong tables lie close together: late rows, the separatrix, few rows, few digits."""

import numpy as np
import pytest
from check_marking import told
from pendula import _core

QUARTER = "0.001 0.02 1 90 s 0 r 1"
STIFF = "0.001 0.02 0.3 30 s 0 r 9.81"
NEAR = "0.0005 0.02 3 0.0 r 3.1622776759797673 r 2.5"  # r differs from 1 by 2e-9
LONG_NEAR = "0.001 0.02 6 0 r 1.999999999999 r 1"
ONE_ROW = "0.001 0.5 0.3 1 r 0.3 r 1"


def numbers(text: str) -> np.ndarray:
    return np.array([line.split() for line in text.splitlines()[1:]], float)


def table(rows: np.ndarray, formats: str = "%.8g") -> bytes:
    return "".join(" ".join(formats % value for value in row) + "\n" for row in rows).encode()


def steps_of(program, text: str) -> np.ndarray:
    """A row for each step."""
    factors = text.split()
    return numbers(program("--precision", "17", text=" ".join([factors[0], factors[0], *factors[2:]])))


# Rows that are a step late.


@pytest.mark.parametrize("text", [QUARTER, STIFF])
@pytest.mark.parametrize("late", [[7], [7, 8, 12], [13, 14], list(range(3, 15))])
def test_rows_that_a_sum_of_steps_prints_a_step_late_are_right(program, text, late):
    rows = np.arange(0, len(steps_of(program, text)) - 1, 20)
    rows[late] += 1
    assert told(text, table(steps_of(program, text)[rows])).is_right


@pytest.mark.parametrize("late", [[7], [7, 8, 12], list(range(3, 16))])
def test_late_rows_whose_times_have_too_few_digits_to_show_it_are_right(program, late):
    text = "0.0001 0.02 1 90 s 0 r 1"
    rows = np.arange(0, 10001, 200)
    rows[late] += 1
    found = "".join(f"{row[0]:.2f} {row[1]:.6f} {row[2]:.6f} {row[3]:.6f}\n" for row in steps_of(program, text)[rows])
    assert told(text, found.encode()).is_right


def test_a_late_row_with_the_state_of_its_own_time_is_no_wrong_cell_but_with_another_it_is(program):
    steps = steps_of(program, QUARTER)
    rows = np.arange(0, 1001, 20)
    assert told(QUARTER, table(steps[rows])).is_right
    wrong = steps[rows]
    wrong[7, 0] = steps[141, 0]
    assert told(QUARTER, table(wrong)).errors == {"wrong_cell"}


def last_step_cut(text: str, rows: int) -> np.ndarray:
    """Runge-Kutta whose last step before a row is shorter, so that it ends there."""
    words = text.split()
    factor_dt, factor_every, theta, omega, alpha = (float(words[place]) for place in (0, 1, 3, 5, 7))
    tau = float(_core.analyze(np.array([theta]), np.array([omega]), np.array([alpha]))[2][0])
    state, found, t = np.array([theta, omega]), [], 0.0
    for row in range(rows):
        while t < row * factor_every * tau - 1e-12:
            h = min(factor_dt * tau, row * factor_every * tau - t)
            k = [np.zeros(2)]
            for part in (0, 0.5, 0.5, 1):
                x = state + part * h * k[-1]
                k.append(np.array([x[1], -alpha * np.sin(x[0])]))
            state = state + h / 6 * (k[1] + 2 * k[2] + 2 * k[3] + k[4])
            t += h
        found.append([t, *state])
    return np.array(found)


@pytest.mark.parametrize("text", ["0.0049 0.01 1 1.5 r 0.3 r 1", "0.004 0.03 1 1.747 r 1.284 r 1", "0.0035 0.01 1 1.5 r 0 r 1"])
def test_the_last_step_before_a_row_may_be_shorter(text):
    rows = last_step_cut(text, 30)
    assert told(text, table(rows, "%.15g")).errors <= {"early_end", "sine_missing"}


# Near the separatrix.


def test_one_wrong_cell_is_wrong_also_where_roundings_may_have_grown_to_more(program):
    rows = numbers(program("--precision", "6", text=NEAR))
    assert told(NEAR, table(rows, "%.6g")).is_right
    rows[129, 1] += 0.053
    assert told(NEAR, table(rows, "%.6g")).errors == {"wrong_cell"}


@pytest.mark.parametrize("term", [["--beta", "1e-6"], ["--torque", "1e-5"]])
def test_a_tail_that_loses_or_wins_energy_is_wrong(program, term):
    """The pendulum of the first rows is right; from where rounding decides, it has a friction or a torque."""
    rows = numbers(program("--precision", "6", text=LONG_NEAR))
    lines = program("solve", "--theta0", "0", "--omega0", "1.999999999999", "--alpha", "1", "--every", str(rows[1, 0]),
                    "--until", str(1.001 * rows[-1, 0]), "--dt", str(rows[1, 0] / 20), *term, "--precision", "6")  # fmt: skip
    other = numbers(lines)
    size = min(len(rows), len(other))
    right, wrong = rows[:size, :3], np.column_stack([rows[:size, 0], other[:size, 1:3]])
    assert told(LONG_NEAR, table(right, "%.6g")).errors <= {"early_end", "sine_missing"}
    assert not told(LONG_NEAR, table(wrong, "%.6g")).errors <= {"early_end", "sine_missing"}


def test_a_velocity_that_no_energy_allows_is_wrong_where_rows_are_not_judged(program):
    rows = numbers(program("--precision", "2", text=LONG_NEAR))
    rows[3:, 2] = 2.5
    assert not told(LONG_NEAR, table(rows, "%.2g")).is_right


# Few rows, few digits.


def test_times_that_stand_still_are_wrong(program):
    rows = numbers(program(text=QUARTER))
    rows[:, 0] = 0
    rows[1:, 1:] = rows[0, 1:]
    assert not told(QUARTER, table(rows)).is_right


@pytest.mark.parametrize(("t", "is_right"), [("0", True), ("0.0", True), ("99", False), ("-1", False), ("0.03", False)])
def test_the_only_row_is_that_of_the_start(t, is_right):
    sine = float(_core.sine(1.0, 0.3, 1.0, np.array([0.0]))[0])
    assert told(ONE_ROW, f"{t} 1 0.3 {sine:.6g}\n".encode()).is_right == is_right


def test_the_only_row_printed_twice_is_told():
    assert "first_row_twice" in told(ONE_ROW, b"0 1 0.3 1\n0 1 0.3 1\n").errors


def test_columns_of_whole_numbers_are_no_less_exact_than_those_beside_them():
    assert not told("0.001 3 3 1 r 0.5 r 1", b"t angulo velocidad funcionSinusoidal\n0 0 0.5 1\n20.5133 1 0.5 1\n").is_right
    still = b"0 1 2.5 0\n3.77012 1.00004 2.49989 0\n7.54024 1.00009 2.49978 0\n"
    assert "sine_no_phase" in told("0.001 1 2 1 r 2.5 r 4", still).errors


def test_rows_ten_years_apart_are_wrong_in_words():
    rows = b"0 1.5707963267949 -1.4142135623731\n337325942.61305 0.54638671875 -1424839.27915601\n"
    assert not told("0.0005 0.1 1 1.5707963267948966 r -1.4142135623730951 r 1", rows).is_right
