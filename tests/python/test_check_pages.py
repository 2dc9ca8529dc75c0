"""The pages of the findings: complete, the same in both languages, and right in the numbers that they give."""

from __future__ import annotations

import math
import re
import tomllib
from importlib import resources
from string import Formatter

import pytest
from pendula import analyze
from pendula._command import BAD_USAGE, LANGUAGES, RefusedError
from pendula.check._pages import INDENT, WIDTH, Value, as_text, blocks, names, page, say

# All findings, by the parts of a program, and the names of the values that each has.
FINDINGS = """
# reading
other_header header words, no_header words, header_order header, mixed_separators line, comma_ambiguous line count,
no_mark_utf16, folded_records, brackets, latex, extra_text line, few_digits digits, ragged line count,
not_numbers line count, columns found, no_time, cartesian, swapped, extra_columns columns, table_missing,
table_spare line, tables_exchanged problem place
# start
theta0_in_degrees, omega0_in_degrees, both_in_degrees, theta0_as_degrees, omega0_as_degrees, both_as_degrees,
theta0_degrees_inverted, omega0_degrees_inverted, both_degrees_inverted, rough_pi pi, theta0_sign, omega0_sign,
start_exchanged, omega0_is_root_alpha, omega0_forgotten, theta0_forgotten, theta0_integer, omega0_integer,
single_constants
# alpha
alpha_root, alpha_square, alpha_inverse, alpha_unused, alpha_integer, alpha_gravity alpha, alpha_of_length g,
alpha_product g, alpha_factor alpha given
# period
period_doubled, period_halved, period_without_half, period_a formula, period_first_term, period_small,
period_modulus r, theta_max formula, period_alpha factor, series_cut relative, series_other formula,
series_without_first, series_not_squared, logarithm_base_10, limit_not_0999, limit_099, regime k, tau_off ratio,
tau every spacing
# stepper
euler, euler_cromer, euler_theta_first, verlet, midpoint, heun, runge_kutta_3, single_precision, own_slopes,
own_slopes_theta, own_slopes_omega, own_slopes_omega_first, own_slopes_h_missing, own_slopes_h_squared, own_index,
h_missing_stages, h_missing_d, h_twice, half_kept_d equation, halves_forgotten equation, half_forgotten_b equation,
half_forgotten_c equation, half_of_sum equation, estimate_left_out stage equation,
stage_repeated stage source equation, stages_accumulate, integer_half, theta_before_omega, omega_before_theta,
misprint_two_theta, misprint_theta_c_alone, misprint_theta_n, weights_unsorted equation, weights_sixth equation,
weights_two_missing stage equation, weights_equal equation, weights_other weights equation, weights_sum sum,
weights_third_missing, slope_left_out stage equation, integer_division, nothing_moves, estimates_of_theta_ignored,
estimates_of_omega_ignored, wrong_sign_in_stage stage
# equation
stage_without_alpha stage, linear, cosine, sine_cubic, sine_quintic, sine_of_degrees factor, upside_down, damping beta,
torque torque, drive amplitude frequency, length_in_force
# rows
step_late, step_early, step_late_but_first, step_early_but_first, omega_behind, omega_ahead, theta_behind, theta_ahead,
time_twice, row_late, row_early, late_start first, starts_at_step first, starts_at_interval first, first_row_twice,
every_step, step_missing, step_more, step_is_interval, seconds every spacing, interval_miscounted steps wanted,
interval_of_run every spacing, interval_rounded every spacing, times_in_periods, time_single, times_nominal, times_off,
uneven_rows row every, one_row expected, last_row_lost until, last_row_won until last,
early_end last until rows expected, late_end last until rows expected, not_judged t, wrong_cell count,
other_start theta omega angle velocity, unexplained order energy
# printing
angle_in_degrees, velocity_in_degrees, velocity_along g, not_normalised, wraps_one_side, wraps_fmod,
wraps_zero_to_two_pi, wraps_closed_above, theta_absolute, theta_negated, omega_negated, acceleration_printed,
omega_absolute, omega_difference over, omega_normalised
# sinusoid
sine_missing, sine_too_many, sine_not_numbers line, sine_other_sign, sine_no_phase, sine_from_rest, sine_phase_outside,
sine_quarter_turn, sine_initial_amplitude, sine_small_period, sine_harmonic, sine_double_period, sine_half_period,
sine_rate rate, sine_without_two_pi, sine_period_inverted, sine_without_period, sine_without_amplitude,
sine_in_degrees, sine_phase_degrees, sine_argument_degrees, sine_phase_theta0, sine_phase_is_theta0, sine_phase_scaled,
sine_by_acos, sine_negated, sine_step_late, sine_row_late, sine_is_the_angle, sine_not_wrapped, sine_unexplained
"""
VALUES = {
    name: tuple(values)
    for name, *values in (each.split() for each in re.sub("#.*\n", ",", FINDINGS).split(",") if each.strip())
}

# As long as they come; numbers with ten digits.
SAMPLES: dict[str, Value] = {
    **dict.fromkeys(("every", "spacing", "first", "until", "last", "t", "relative"), -0.0123456789012),
    **dict.fromkeys(("alpha", "given", "g", "factor", "pi", "beta", "torque", "amplitude", "frequency"), -0.0123456789012),
    **dict.fromkeys(("line", "count", "digits", "found", "problem", "place", "row", "rows", "expected", "k"), 10001),
    "header": "t [s] theta [rad] omega [rad/s] sine [rad]",
    "words": "t angulo velocidad funcionSinusoidal",
    "columns": "cinetica potencial total x y",
    "ratio": "11/12",
    "r": "sin(θM)/2",
    "formula": "arccos(cos θ0 + ω0²/(2α))",
    "rate": "ω0·t",
    "sum": "1.5",
    "over": "t_cout",
    "stage": "B, C, D",
    "weights": "1/8, 3/8, 3/8, 1/8",
    **dict.fromkeys(("steps", "wanted"), 10001),
    **dict.fromkeys(("theta", "omega", "angle", "velocity"), -0.0123456789012),
    "source": "A",
    "equation": "θ, ω",
    "order": 3,
    "energy": "kept",
}
FIELDS = ("title", "says", "looks", "why", "find")
LONGEST = 240  # characters: three lines on paper


def places(text):
    """The names of the places in a text."""
    return [name for _, name, _, _ in Formatter().parse(text) if name is not None]


@pytest.mark.parametrize("lang", LANGUAGES)
def test_there_is_a_page_for_each_finding_in_their_order(lang):
    assert names() == tuple(VALUES)
    text = resources.files("pendula.check").joinpath(f"findings.{lang}.toml").read_text("utf-8")
    assert tuple(tomllib.loads(text)) == tuple(VALUES)


@pytest.mark.parametrize("lang", LANGUAGES)
def test_no_part_of_a_page_is_empty_or_said_twice(lang):
    parts = [[getattr(page(name, lang), field).strip() for field in FIELDS] for name in VALUES]
    assert [name for name, texts in zip(VALUES, parts, strict=True) if "" in texts or len(set(texts)) < len(texts)] == []


@pytest.mark.parametrize("lang", LANGUAGES)
def test_what_a_finding_says_has_places_for_its_values_and_no_others(lang):
    assert {name: set(places(page(name, lang).says)) for name in VALUES} == {name: set(VALUES[name]) for name in VALUES}


@pytest.mark.parametrize("lang", LANGUAGES)
def test_braces_are_for_places_of_values_only(lang):
    def texts(name):
        shown = page(name, lang)
        return [re.sub(r"\{[a-z]+\}", "", shown.says), *(getattr(shown, field) for field in FIELDS if field != "says")]

    assert [name for name in VALUES if set("{}") & set("".join(texts(name)))] == []


@pytest.mark.parametrize("lang", LANGUAGES)
def test_what_a_finding_says_is_short(lang):
    lengths = {name: len(say(name, lang, {value: SAMPLES[value] for value in VALUES[name]}, 10)) for name in VALUES}
    assert {name: length for name, length in lengths.items() if length > LONGEST} == {}


@pytest.mark.parametrize("lang", LANGUAGES)
def test_titles_and_sentences_tell_findings_apart(lang):
    assert len({page(name, lang).title for name in VALUES}) == len(VALUES)
    assert len({page(name, lang).says for name in VALUES}) == len(VALUES)


def code(name, lang):
    """The lines of code of a page."""
    return [line for is_code, text in blocks(page(name, lang).find) if is_code for line in text.splitlines()]


def test_both_languages_show_the_same_code_each_with_its_own_words():
    english, spanish = ({name: code(name, lang) for name in VALUES} for lang in LANGUAGES)
    assert {name: len(lines) for name, lines in english.items()} == {name: len(lines) for name, lines in spanish.items()}
    assert [lines for lines in spanish.values() if re.search(r"\b(wrong|right|theta|print)\b", " ".join(lines))] == []
    assert [lines for lines in english.values() if re.search(r"// (mal|bien)\b", " ".join(lines))] == []


@pytest.mark.parametrize("lang", LANGUAGES)
def test_pages_fit_a_terminal(lang):
    assert {name: line for name in VALUES for line in as_text(page(name, lang)).splitlines() if len(line) > WIDTH} == {}


@pytest.mark.parametrize("lang", LANGUAGES)
def test_an_empty_line_is_between_code_and_paragraphs(lang):
    texts = [(name, getattr(page(name, lang), field)) for name in VALUES for field in ("looks", "why", "find")]
    mixed = [
        name
        for name, text in texts
        for block in text.split("\n\n")
        if len({line.startswith(INDENT) for line in block.strip("\n").splitlines()}) > 1
    ]
    assert mixed == []


def test_floats_have_as_many_digits_as_the_table_but_no_more_than_tell_something():
    assert say("late_start", "en", {"first": 1 / 3}, 3) == "The table starts at t = 0.333; the first row must be that of t = 0."
    assert say("late_start", "es", {"first": 1 / 3}, 17).startswith("La tabla empieza en t = 0.333333;")
    assert say("tau", "en", {"spacing": 0.1480001, "every": 0.1480002}, 3).startswith(
        "Rows are 0.1480001 s apart instead of 0.1480002:"
    )
    assert say("rough_pi", "en", {"pi": 3.14159}, 3).startswith("π was taken as 3.14159;")
    assert "(such lines: 10001)" in say("ragged", "en", {"line": 7, "count": 10001}, 3)


def test_words_among_the_values_are_in_the_language():
    values = {"order": 2, "energy": "kept"}
    assert "The energy is kept. The errors are as large as those of a method of order 2." in say("unexplained", "en", values, 6)
    assert "La energía se conserva. Los errores" in say("unexplained", "es", values, 6)


def test_an_order_that_is_not_known_is_not_told():
    values = {"order": "?", "energy": "grows"}
    assert say("unexplained", "en", values, 6).endswith("The energy grows.")
    assert say("unexplained", "es", values, 6).endswith("La energía crece.")


def test_a_page_for_the_terminal_has_all_parts():
    assert (
        as_text(page("omega_normalised", "en"))
        == """\
omega_normalised: The velocity is normalised

The velocity was normalised to [−π, π), which is for angles only.

WHAT IT LOOKS LIKE

Where |w| > π, w jumps by 2π. In the assignment's examples w is never larger
than 2.01, so that they cannot show it.

WHY

θ and θ + 2π are the same place. A velocity of w + 2π is another velocity: a
turn more per second, and another energy.

HOW TO FIND IT

Look for normaliza(w).
"""
    )


def test_an_unknown_name_brings_the_nearest():
    with pytest.raises(RefusedError) as refused:
        page("euler-cromer", "en")
    assert refused.value.status == BAD_USAGE
    assert str(refused.value) == "there is no finding 'euler-cromer'; is it 'euler_cromer'?"


def test_a_name_near_to_none_is_refused():
    with pytest.raises(RefusedError) as refused:
        page("zzz", "es")
    assert str(refused.value) == "there is no finding 'zzz'"


def tau(theta0, omega0):
    """For α = 1."""
    return float(analyze(theta0, omega0, alpha=1.0).tau)


def wrapped(theta):
    """In [-π, π)."""
    return theta - 2 * math.pi * math.floor((theta + math.pi) / (2 * math.pi))


def to_fraction(fraction):
    """The time (3.5) from the bottom to a fraction of π, for α = 1."""
    return math.log(math.tan(fraction * math.pi / 4 + math.pi / 4))


def of_modulus(r):
    """The period of the series (3.7) with another r, for α = 1."""
    return tau(2 * math.asin(r), 0)


QUARTER = math.pi / 2  # the first example: 90° at rest
NEAR_TOP = (0, 1.999999895801368)  # the second one
SECOND_ROW = 0.02 * tau(QUARTER, 0)  # its time in the first example
NUMBERS = [
    ("theta0_in_degrees", wrapped(90.0)),
    ("theta0_as_degrees", math.radians(QUARTER)),
    ("theta0_degrees_inverted", 90 * 180 / math.pi),
    ("theta0_degrees_inverted", -wrapped(90 * 180 / math.pi)),
    ("period_first_term", tau(0, 0)),
    ("period_first_term", round(tau(QUARTER, 0), 4)),
    ("period_small", 0.02 * tau(0, 0)),
    ("period_without_half", tau(0, 2 * 2.01)),
    ("period_without_half", tau(0, 2.01)),
    ("period_modulus", of_modulus(math.sin(1))),
    ("period_modulus", tau(1, 0)),
    ("period_modulus", of_modulus(math.sqrt(1 - NEAR_TOP[1] ** 2 / 4) * NEAR_TOP[1])),
    ("period_modulus", tau(*NEAR_TOP)),
    ("period_modulus", of_modulus(math.sin(QUARTER) / 2)),
    ("series_without_first", tau(QUARTER, 0) - tau(0, 0)),
    ("series_not_squared", tau(0, 0) / math.sqrt(1 - math.sin(QUARTER / 2))),
    ("series_not_squared", round(tau(0, 0) / math.sqrt(1 - NEAR_TOP[1] / 2), -2)),
    ("series_not_squared", round(100 * (1 / math.sqrt(1 - math.sin(math.radians(0.5))) - 1), 1)),
    ("logarithm_base_10", tau(0, -2) / math.log(10)),
    ("logarithm_base_10", tau(0, -2)),
    ("limit_not_0999", round(to_fraction(1), 1)),
    ("limit_099", to_fraction(0.99)),
    ("limit_099", 0.99 * math.pi),
    ("limit_099", 0.999 * math.pi),
    ("alpha_integer", round(100 * (math.sqrt(2.5 / 2) - 1))),
    ("alpha_integer", round(100 * (math.sqrt(9.81 / 9) - 1))),
    ("period_a", tau(0, math.sqrt(2.01**2 + 4))),
    ("period_a", tau(0, 2.01)),
    ("weights_two_missing", round(100 * (6 / 5 - 1))),
    ("weights_two_missing", round(100 * (math.sqrt(6 / 5) - 1), 1)),
    ("omega_behind", round(0.0001 * tau(QUARTER, 0), 4)),
    ("omega_difference", round(0.0001 * tau(QUARTER, 0) / 2, 4)),
    ("theta_behind", round(0.0001 * tau(QUARTER, 0) * math.sqrt(2), 3)),
    ("series_other", 2 * math.pi * (1 + QUARTER**2 / 16)),
    ("linear", tau(0, 0)),
    ("sine_from_rest", 2 * math.asin(NEAR_TOP[1] / 2)),
    ("sine_harmonic", QUARTER * math.cos(SECOND_ROW)),
    ("sine_argument_degrees", QUARTER * math.sin(90)),
    ("sine_phase_is_theta0", math.radians(30) * math.sin(math.radians(30))),
    ("sine_phase_scaled", -QUARTER * math.sin(2 * math.pi * QUARTER)),
    ("sine_small_period", round(tau(QUARTER, 0) / tau(0, 0) - 1, 2)),
    ("sine_phase_outside", QUARTER * math.sin(math.pi / 2) + QUARTER),
    ("sine_period_inverted", round(tau(QUARTER, 0) ** 2)),
    ("sine_period_inverted", QUARTER * math.sin(2 * math.pi * tau(QUARTER, 0) * SECOND_ROW + QUARTER)),
    ("sine_period_inverted", QUARTER * math.sin(2 * math.pi * 0.02 + QUARTER)),
    ("sine_without_period", round(tau(QUARTER, 0), 1)),
    ("sine_without_period", QUARTER * math.sin(2 * math.pi * SECOND_ROW + QUARTER)),
    ("sine_phase_theta0", math.radians(30) * math.sin(math.asin(math.radians(30)))),
    ("sine_phase_theta0", math.radians(30)),
    ("sine_phase_degrees", QUARTER * math.sin(90)),
    ("sine_phase_degrees", QUARTER * math.sin(math.radians(QUARTER))),
]


@pytest.mark.parametrize("lang", LANGUAGES)
@pytest.mark.parametrize(("name", "number"), NUMBERS)
def test_numbers_on_pages_are_right(name, number, lang):
    assert f"{number:.6g}" in page(name, lang).looks
