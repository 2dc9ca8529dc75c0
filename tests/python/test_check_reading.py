"""Tables are read however they are laid out, no row is lost in silence, and what is no table is refused in words."""

import itertools
import random
import subprocess
import sys
from pathlib import Path

import fuzz_reader
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from pendula.check import UnreadableError, decoded, read_file, tables
from pendula.check._table import placements, roles_of
from pendula.check._text import UNREADABLE

# Every layout holds these rows, or those of a rotation, or prose around them.
FOUR = [[0, 1.5708, 0, 1.5708], [0.148326, 1.5598, -0.148324, 1.55841], [0.296652, 1.5268, -0.296595, 1.52145]]
PROGRAMS = Path(__file__).parent / "check_programs"
HEADER = "t angulo velocidad funcionSinusoidal"
PLAIN = "0 1.5708 0 1.5708\n0.148326 1.5598 -0.148324 1.55841\n0.296652 1.5268 -0.296595 1.52145\n"
COMMAS = PLAIN.replace(".", ",")


def each_row(pattern, text=PLAIN):
    """Every row in the pattern, whose {0} to {3} are its numbers."""
    return "".join(pattern.format(*row.split()) for row in text.splitlines())


LAYOUTS = {
    "as the assignment has it": (f"{HEADER}\n{PLAIN}", ()),
    "without a header": (PLAIN, ()),
    "a prompt on the header's line": (f"Introduce los datos: {HEADER}\n{PLAIN}", ("extra_text",)),
    "a prompt without a colon": (f"Introduce los datos {HEADER}\n{PLAIN}", ("extra_text",)),
    "several prompts": (f"factorDelta: factorCout: angulo y velocidad: {HEADER}\n{PLAIN}", ("extra_text",)),
    "a prompt on the first row's line": (f"Introduce los datos: {PLAIN}", ("extra_text",)),
    "a prompt above": (f"Introduce el angulo y la velocidad inicial:\n{HEADER}\n{PLAIN}", ()),
    "a prompt above and no header": (f"Introduce angulo y velocidad inicial:\n{PLAIN}", ()),
    "k, θM and τ in lines of their own": (f"-1\n1.5708\n7.41630\n{HEADER}\n{PLAIN}", ()),
    "k, θM and τ in one line": (f"-1 1.5708 7.41630\n{HEADER}\n{PLAIN}", ()),
    "k, θM and τ in one line, no header": (f"-1 1.5708 7.41630\n{PLAIN}", ()),
    "k, θM and τ in a line of labels": (f"k = -1 thetaM = 1.5708 tau = 7.41630\n{HEADER}\n{PLAIN}", ()),
    "k, θM and τ in labelled lines": (f"k = -1\ntheta_M = 1.5708\ntau: 7.41630\n{HEADER}\n{PLAIN}", ()),
    "the problem repeated above": (f"0.0001 0.02 1 90 s 0 r 1\n{HEADER}\n{PLAIN}", ()),
    "spaces inside the header's names": (f"t  angulo (rad)  velocidad angular  funcion sinusoidal\n{PLAIN}", ()),
    "single spaces inside the names": (f"t (s) ángulo (rad) velocidad angular (rad/s) función sinusoidal\n{PLAIN}", ()),
    "a line of units": (f"{HEADER}\ns rad rad/s rad\n{PLAIN}", ()),
    "a line of units in brackets": (f"{HEADER}\n(s) (rad) (rad/s) (rad)\n{PLAIN}", ()),
    "LaTeX": (each_row("{0} & {1} & {2} & {3} \\\\\n"), ("latex",)),
    "a LaTeX tabular": (
        "\\begin{tabular}{|c|c|c|c|}\n\\hline\n$t$ & $\\theta$ & $\\dot{\\theta}$ & $\\theta_{seno}$ \\\\ \\hline\n"
        + each_row("${0}$ & ${1}$ & ${2}$ & ${3}$ \\\\ \\hline\n")
        + "\\end{tabular}\n",
        ("latex",),
    ),
    "LaTeX in one line": (each_row("{0} & {1} & {2} & {3} \\\\ "), ("latex",)),
    "LaTeX with decimal commas": (each_row("{0} & {1} & {2} & {3} \\\\\n", PLAIN.replace(".", "{,}")), ("latex",)),
    "CSV with a byte order mark": (f"\ufefft,angulo,velocidad,funcionSinusoidal\n{PLAIN.replace(' ', ',')}", ()),
    "quoted CSV with decimal commas": (
        '0,"1,5708",0,"1,5708"\n"0,148326","1,5598","-0,148324","1,55841"\n"0,296652","1,5268","-0,296595","1,52145"\n',
        (),
    ),
    "quoted CSV": ('"t","angulo","velocidad","seno"\n' + each_row('"{0}","{1}","{2}","{3}"\n'), ()),
    "commas and spaces, decimal commas": (each_row("{0}, {1}, {2}, {3}\n", COMMAS), ()),
    "commas that are decimal and separate": (COMMAS.replace(" ", ","), ("comma_ambiguous",)),
    "commas that are decimal and separate, with a header": (
        f"{HEADER.replace(' ', ',')}\n{COMMAS.replace(' ', ',')}",
        ("comma_ambiguous",),
    ),
    "separators that change": (
        "0 1.5708 0 1.5708\n0.148326,1.5598,-0.148324,1.55841\n0.296652;1.5268;-0.296595;1.52145\n",
        ("mixed_separators",),
    ),
    "separators that change within a line": ("0, 1.5708 0;1.5708\n" + PLAIN.split("\n", 1)[1], ("mixed_separators",)),
    "text between rows": (PLAIN.replace("\n0.2", "\n--- Page 2 ---\n\n0.2"), ("extra_text",)),
    "text after the rows": (f"{HEADER}\n{PLAIN}Fin del programa. Tiempo: 0.12 s\n", ("extra_text",)),
    "three numbers to a line, as Fortran folds them": (each_row(" {0} {1} {2}\n {3}\n"), ("folded_records",)),
    "three numbers to a line below a header of four words": (
        f"  t         angulo      velocidad funcionSinusoidal\n{each_row(' {0} {1} {2}' + chr(10) + ' {3}' + chr(10))}",
        ("folded_records",),
    ),
    "two numbers to a line": (f"{HEADER}\n" + each_row("{0} {1}\n{2} {3}\n"), ("folded_records",)),
    "a number to a line": (f"{HEADER}\n" + each_row("{0}\n{1}\n{2}\n{3}\n"), ("folded_records",)),
    "Python's lists": (each_row("[{0}, {1}, {2}, {3}]\n"), ("brackets",)),
    "a list of lists": ("[" + each_row("[{0}, {1}, {2}, {3}], ")[:-2] + "]", ("brackets",)),
    "tuples": (each_row("({0}, {1}, {2}, {3})\n"), ("brackets",)),
    "a NumPy array": (
        "[[0. 1.5708 0. 1.5708]\n" + each_row(" [{0} {1} {2} {3}]\n", PLAIN.split("\n", 1)[1]) + "]",
        ("brackets",),
    ),
    "a folded NumPy array": ("[" + each_row("[{0} {1} {2}\n {3}]\n "), ("brackets", "folded_records")),
    "NumPy's scalars": (each_row("(np.float64({0}), np.float64({1}), np.float64({2}), np.float64({3}))\n"), ("brackets",)),
    "Fortran's exponents": ("0.D0 15.708D-1 0.D0 1.5708D+00\n" + PLAIN.split("\n", 1)[1], ()),
    "columns that touch": (PLAIN.replace(" -", "-"), ()),
    "units glued to the numbers": (each_row("{0}s {1}rad {2}rad/s {3}rad\n"), ()),
    "units behind the numbers": (each_row("{0} s, {1} rad, {2} rad/s, {3} rad\n"), ()),
    "labels": (each_row("t={0} theta={1} w={2} sin={3}\n"), ()),
    "labels with spaces": (each_row("t = {0}, theta = {1}, omega = {2}, theta_seno = {3}\n"), ()),
    "sentences": (each_row("En t = {0} s el angulo es {1}, la velocidad {2} y el seno {3}.\n"), ()),
    "dictionaries": (each_row("{{'t': {0}, 'theta': {1}, 'omega': {2}, 'sin': {3}}}\n"), ("brackets",)),
    "Markdown": (f"| {HEADER.replace(' ', ' | ')} |\n|---|:-:|---|---:|\n" + each_row("| {0} | {1} | {2} | {3} |\n"), ()),
    "comment marks": (f"# {HEADER}\n# RK4, h = 0.001\n" + PLAIN, ()),
    "comment marks before rows": (each_row("# {0} {1} {2} {3}\n"), ()),
    "a dash for a minus": (PLAIN.replace("-", "\N{EN DASH}"), ()),
    "a frame of lines": (
        f"┏━━━┳━━━┓\n┃ {HEADER.replace(' ', ' ┃ ')} ┃\n┡━━━╇━━━┩\n" + each_row("│ {0} │ {1} │ {2} │ {3} │\n") + "└───┴───┘\n",
        (),
    ),
    "a typographic minus": (PLAIN.replace("-", "\N{MINUS SIGN}"), ()),
    "spaces that do not break": (PLAIN.replace(" ", "\N{NO-BREAK SPACE}"), ()),
    "colours": (f"\x1b[1m{HEADER}\x1b[0m\n{PLAIN}", ()),
    "blank lines and rules": (f"=====\n{HEADER}\n-----\n\n" + PLAIN.replace("\n", "\n\n"), ()),
}


@pytest.mark.parametrize("layout", LAYOUTS)
def test_all_layouts_are_one_table(layout):
    text, notes = LAYOUTS[layout]
    (table,) = tables(text)
    assert np.array_equal(table.values, FOUR)
    assert not table.ragged
    assert {name for name, _ in table.notes} == set(notes)
    _, places = next(placements(table, oscillates=True))
    assert places == {"t": 0, "theta": 1, "omega": 2, "sine": 3}


def test_rows_are_folded_to_the_header_that_names_most_in_fewest_words():
    lines = "".join("\n".join(row.split()[:3]) + "\n" for row in PLAIN.splitlines() * 4)
    (table, *_) = tables("t  angulo medido  velocidad\n" + lines)
    assert np.array_equal(table.values, np.array(FOUR)[:, :3])


@pytest.mark.parametrize("end", ["\n", "\r\n", "\n\n", "\r"])
@pytest.mark.parametrize("lead", ["", "  ", "\t"])
@pytest.mark.parametrize(
    ("between", "point"),
    list(itertools.product([" ", "    ", "\t", " ; ", ";", " | ", ", "], [".", ","])),
)
def test_all_separators_and_line_ends_are_one_table(between, point, end, lead):
    lines = [lead + row.replace(".", point).replace(" ", between) for row in PLAIN.splitlines()]
    (table,) = tables(end.join(lines))
    assert np.array_equal(table.values, FOUR)


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("1.5", 1.5),
        ("-1,5", -1.5),
        (".5", 0.5),
        ("5.", 5),
        ("1e-3", 0.001),
        ("1.25D+02", 125),
        ("1.5-101", 1.5e-101),
        ("−2", -2),
        ("+7", 7),
        ("nan", np.nan),
        ("-nan(ind)", np.nan),
        ("1.#IND", np.nan),
        ("-1.#INF00", np.nan),
        ("inf", np.nan),
        ("1e999", np.nan),
        ("****", np.nan),
        ("#NUM!", np.nan),
        ("#¡DIV/0!", np.nan),
        ("None", np.nan),
    ],
)
def test_a_number_is_read_as_it_is_spelled(text, value):
    (table,) = tables(f"0 {text} 7\n1 2 3\n2 2 3\n")
    assert np.array_equal(table.values[0], [0, value, 7], equal_nan=True)
    assert not table.ragged


@pytest.mark.parametrize("text", [".", "-", "e5", "1e", "0x10", "1.2.3", "1_000", "٣", "t", "--1", "1-2", "1,2,3"])
def test_a_line_with_what_is_no_number_is_ragged_and_not_lost(text):
    (table,) = tables(f"0 1 2 3\n1 1 {text} 3\n2 1 2 3\n3 1 2 3\n")
    assert table.ragged == (2,)
    assert list(table.lines) == [1, 2, 3, 4]


def test_ragged_rows_keep_their_lines():
    (table,) = tables("0 1 2\n1 1\n2 1 2 3\n3 1 2\n4\n5 1 2\n")
    assert table.ragged == (2, 3, 5)
    assert table.values.shape == (6, 3)
    assert list(table.lines) == [1, 2, 3, 4, 5, 6]


def test_equal_numbers_that_fortran_counts_are_repeated():
    (table,) = tables(" 0.0 2*1.5 0.0\n 1.0 3*-2.5E+00\n 2.0 1.0 1.0 1.0\n")
    assert np.array_equal(table.values[:2], [[0, 1.5, 1.5, 0], [1, -2.5, -2.5, -2.5]])


def test_an_empty_cell_makes_its_line_ragged():
    (table,) = tables("0,1.5,2.5,3\n0.1,1.5,,3\n0.2,1.5,2.5\n0.3,1,2.5,3\n")
    assert table.ragged == (2, 3)


def test_text_with_numbers_among_the_rows_is_no_row():
    (table,) = tables(PLAIN.replace("\n0.29", "\nEnergia: 0.5 error 1e-9\n0.29"))
    assert (table.ragged, table.notes) == ((), (("extra_text", {"line": 3}),))


@pytest.mark.parametrize("header", ["", f"{HEADER}\n"])
@pytest.mark.parametrize("row", [0, 1, 2])
def test_a_damaged_row_is_ragged_wherever_it_is(header, row):
    lines = PLAIN.splitlines()
    lines[row] = lines[row].replace(" 1.", " l.", 1)
    (table,) = tables(header + "\n".join(lines))
    assert table.ragged == (row + 1 + bool(header),)
    assert len(table.values) == 3


def test_a_damaged_first_row_below_a_header_is_ragged():
    (table,) = tables(f"{HEADER}\nO 1.5708 0 1.5708\n" + PLAIN.split("\n", 1)[1])
    assert table.ragged == (2,)
    assert len(table.values) == 3


@pytest.mark.parametrize(
    ("header", "roles"),
    [
        ("t angulo velocidad funcionSinusoidal", "t theta omega sine"),
        ("tiempo;ángulo;velocidad angular;función sinusoidal", "t theta omega sine"),
        ("t,theta,omega,theta_seno", "t theta omega sine"),
        ("Time\tθ\tω\tsin", "t theta omega sine"),
        ("t θ θ̇", "t theta omega"),
        ("velocidad t angulo", "omega t theta"),
        ("time,angular velocity,angle,sine", "t omega theta sine"),
        ("time angular velocity angle sine function", "t omega theta sine"),
        ("t theta theta' Theta_sin", "t theta omega sine"),
        ("t theta dtheta/dt sin", "t theta omega sine"),
        ("t theta d(theta)/dt", "t theta omega"),
        ("t, θ, dθ/dt, θ_sen", "t theta omega sine"),
        ("t theta w seno", "t theta omega sine"),
        ("w theta t", "omega theta t"),
        ("Tiempo(s) Angulo(rad) Velocidad(rad/s) Seno", "t theta omega sine"),
        ("t [s]  theta [rad]  theta_dot [rad/s]", "t theta omega"),
        ("$t$ & $\\theta$ & $\\dot{\\theta}$ & $\\theta_{seno}$ \\\\", "t theta omega sine"),
        ("'t' 'theta' 'thetaPunto'", "t theta omega"),
        ("| t | ang | vel | f_sin |", "t theta omega sine"),
        ("# t angulo velAngular anguloSeno", "t theta omega sine"),
        ("n t angulo velocidad", "- t theta omega"),
        ("t angulo velocidad Ec Ep E", "t theta omega - - -"),
        ("t theta omega K U E sin", "t theta omega - - - sine"),
        ("t x y theta omega", "t - - theta omega"),
        ("t theta omega energia", "t theta omega -"),
        ("t theta omega alpha", "t theta omega -"),
        ("t theta omega theta''", "t theta omega -"),
        ("t theta omega kinetic energy potential energy", "t theta omega - -"),
        ("Introduce el angulo y la velocidad: t angulo velocidad", "t theta omega"),
        ("posicion angular;velocidad angular;tiempo", "theta omega t"),
    ],
)
def test_words_of_a_header_tell_the_columns(header, roles):
    wanted = {role: place for place, role in enumerate(roles.split()) if role != "-"}
    width = len(roles.split())
    (table,) = tables(header + "\n" + "".join(" ".join([f"{row}.5"] * width) + "\n" for row in range(3)))
    assert roles_of(table.header) == wanted


@pytest.mark.parametrize(
    ("text", "note"),
    [
        ("theta omega sin\n1 2 3\n2 3 4\n", ("no_time", {})),
        ("t x y\n0 1 2\n1 2 3\n", ("cartesian", {})),
        ("t angulo velocidad Ec Ep\n0 1 2 3 4\n1 2 3 4 5\n", ("extra_columns", {"columns": "Ec Ep"})),
        ("0 1 2\n1 1 2\n2;1;2\n3 1 2\n", ("mixed_separators", {"line": 3})),
        ("t angulo velocidad\n0 1 2\n1 1 2\nHola\n2 1 2\n", ("extra_text", {"line": 4})),
        ("0,1,5708,0,1,5708\n0,5,1,2512,-0,5,1,2512\n1,1,-0,7512,1\n", ("comma_ambiguous", {"line": 1, "count": 0})),
    ],
)
def test_the_reader_notes_what_it_sees(text, note):
    (table,) = tables(text)
    assert note in table.notes


UNITS = (
    "Tiempo /s Angulo /rad Velocidad /rad/s Sinusoidal /rad",
    "t [s] angulo [rad] velocidad [rad/s] seno [rad]",
    "t / s\tangulo / rad\tvelocidad / (rad/s)\tseno / rad",
    "t s angulo rad velocidad rad/s seno rad",
    "t en s  angulo en rad  velocidad en rad/s  seno en rad",
    "tiempo en segundos angulo en radianes velocidad en rad/s seno en rad",
    "t s;theta rad;w rad/s;sin rad",
    "t angulo(rad) velocidad(rad / s) seno",
    "[t [s], angulo [rad], velocidad [rad/s], seno [rad]]",
    "('t', 'angulo', 'velocidad', 'seno')",
)


@pytest.mark.parametrize("header", UNITS)
def test_units_are_no_columns_and_keep_their_brackets(header):
    (table,) = tables(f"{header}\n{PLAIN}")
    assert table.notes == ()
    assert roles_of(table.header) == {"t": 0, "theta": 1, "omega": 2, "sine": 3}
    assert all(word.count(one) == word.count(other) for word in table.header for one, other in ("[]", "()"))


def test_words_of_a_header_without_numbers_below_are_no_columns():
    (table,) = tables("t angulo velocidad Ec Ep\n0 1 2\n1 2 3\n")
    assert table.notes == ()


@pytest.mark.parametrize("above", ["# Ana, 2.1\n# h = 0.001\n", "Introduce los datos:\n", "-1 1.5708 7.4163\n"])
def test_what_stands_above_a_table_is_no_fault_and_what_stands_behind_is_told(above):
    first, second = tables(f"{above}{HEADER}\n{PLAIN}{above}{HEADER}\n{PLAIN}Fin\n")
    assert (first.notes, second.notes) == ((), (("extra_text", {"line": 2 * (above.count("\n") + 4) + 1}),))


BEHIND = ("-1 1.5708 7.4163", "0.1 4", "0.001 0.02 1 90 0 1", "Practica 3, 2024", "Energia 0.5 1.2", "Periodo: 7.4163 s", "[1]")


@pytest.mark.parametrize("line", BEHIND)
@pytest.mark.parametrize("width", [3, 4])
def test_numbers_behind_a_table_are_no_table_and_no_row_of_it(line, width):
    text = "".join(" ".join(row.split()[:width]) + "\n" for row in PLAIN.splitlines())
    (table,) = tables(text + line)
    assert np.array_equal(table.values, np.array(FOUR)[:, :width])
    assert (table.ragged, table.notes) == ((), (("extra_text", {"line": 4}),))


def test_lines_that_are_numbered_through_have_their_header_s_columns():
    rows = "".join(f"{place}: {row}\n" for place, row in enumerate(PLAIN.splitlines(), start=52))
    (table,) = tables(f"{HEADER}\n{rows}")
    assert table.header == ("", *HEADER.split())


def test_a_table_of_one_row_behind_another_is_a_table():
    assert [len(table.values) for table in tables(PLAIN + "0 0.5 2\n")] == [3, 1]


def test_two_columns_below_a_header_of_four_words_are_not_folded():
    (table,) = tables(f"{HEADER}\n" + "".join(f"{row}.5 0.25\n" for row in range(10)))
    assert (table.values.shape, table.notes) == ((10, 2), ())


def test_ambiguous_commas_are_paired_only_where_there_is_one_way():
    text = "0,148326,1,5598,-0,148324,1,55841\n0,296652,1,5268,-0,296595,1,52145\n0,5,2,1,3,4,1\n0,593304,1,39497,-0,591471,1,3765\n"
    (table,) = tables(text)
    assert np.array_equal(
        table.values[[0, 1, 3], :3],
        [[0.148326, 1.5598, -0.148324], [0.296652, 1.5268, -0.296595], [0.593304, 1.39497, -0.591471]],
    )
    assert table.ragged == (3,)
    assert ("comma_ambiguous", {"line": 1, "count": 1}) in table.notes


# Where tables begin.


def test_a_new_table_begins_at_a_header_or_where_time_falls_back():
    with_header = tables("t angulo velocidad\n0 1 2\n1 1 2\nt angulo velocidad\n5 1 2\n")
    without = tables("0 1 2\n1 1 2\n\n0 1 2\n1 1 2\n")
    assert [len(table.values) for table in with_header] == [2, 1]
    assert [len(table.values) for table in without] == [2, 2]


def test_tables_of_other_widths_are_apart_without_headers():
    first, second = tables(PLAIN + "0 0 2.01\n0.1 0.2 2.0\n0.2 0.4 1.9\n")
    assert (first.values.shape, second.values.shape) == ((3, 4), (3, 3))


def test_one_wrong_time_is_no_new_table():
    times = [0.1 * row for row in range(20)]
    for wrong in (0.05, 99, -1, float("nan")):
        given_ = [*times[:10], wrong, *times[11:]]
        (table,) = tables("".join(f"{time:.6g} {time / 3:.6g} 0.5\n" for time in given_))
        assert len(table.values) == 20


def test_what_is_printed_before_each_table_is_no_row():
    text = "".join(f"-1 1.5708 7.4163\n{HEADER}\n{PLAIN}" for _ in range(3))
    found = tables(text)
    assert [table.values.tolist() for table in found] == [FOUR] * 3
    assert all(table.notes == () for table in found)


@pytest.mark.parametrize("lead", ["", "1 0 1\n"])
def test_nothing_begins_anew_where_the_header_names_no_time(lead):
    rows = "".join("{:.6g} {:.6g} {:.6g}\n".format(*np.cos([0.3 * row, 0.3 * row + 1, 0.3 * row])) for row in range(60))
    (table,) = tables("angulo velocidad funcionSinusoidal\n" + lead + rows)
    assert table.values.shape == (60 + bool(lead), 3)
    assert table.notes == (("no_time", {}),)


def test_time_is_found_where_it_is_not_the_first_column():
    rows = [(np.sin(0.3 * row), 0.1 * row, np.cos(0.3 * row)) for row in range(60)]
    assert len(tables("".join("{:.6f} {:.6f} {:.6f}\n".format(*row) for row in rows * 2))) == 2


# Columns.


def table_of(width, header=""):
    return header + "".join(" ".join(f"{row + column / 10:.6f}" for column in range(width)) + "\n" for row in range(5))


def test_placements_begin_with_what_the_header_says():
    (table,) = tables(table_of(3, "velocidad t angulo\n"))
    found = list(placements(table, oscillates=False))
    assert found[0] == ("", {"omega": 0, "t": 1, "theta": 2})
    assert found[1] == ("header_order", {"t": 0, "theta": 1, "omega": 2})
    assert ("swapped", {"t": 0, "theta": 2, "omega": 1}) in found


def test_columns_beside_the_four_are_never_the_sinusoid():
    for words in ("Ec Ep E", "x y", "energia", "error", "alpha"):
        (table,) = tables(table_of(3 + len(words.split()), f"t angulo velocidad {words}\n"))
        assert "sine" not in next(placements(table, oscillates=True))[1]
    (table,) = tables(table_of(4, "t angulo velocidad aproximacion\n"))
    assert next(placements(table, oscillates=True))[1]["sine"] == 3


def test_a_column_before_the_sinusoid_is_not_offered_as_the_sinusoid():
    (table,) = tables(table_of(5, "t angulo velocidad energia funcionSinusoidal\n"))
    assert [(name, places["sine"]) for name, places in placements(table, oscillates=True)] == [("", 4), ("swapped", 4)]


def test_without_a_header_the_possible_placements_are_offered():
    (table,) = tables(table_of(5))
    found = [
        tuple(places.get(role) for role in ("t", "theta", "omega", "sine")) for _, places in placements(table, oscillates=True)
    ]
    assert found[0] == (0, 1, 2, 3)
    assert {(1, 2, 3, 4), (0, 1, 2, 4), (0, 3, 4, None), (0, 2, 4, None), (0, 2, 1, 3)} <= set(found)
    for width, oscillates in itertools.product(range(2, 64), (True, False)):
        (table,) = tables(table_of(width))
        assert (width > 2) <= len(list(placements(table, oscillates))) <= 12


def test_of_two_methods_runge_kuttas_columns_are_taken_first():
    (table,) = tables(table_of(5, "t theta_euler omega_euler theta_rk4 omega_rk4\n"))
    (_, first), (_, second), *_ = placements(table, oscillates=False)
    assert (first["theta"], first["omega"]) == (3, 4)
    assert (second["theta"], second["omega"]) == (1, 2)


def test_numbers_of_rows_need_no_word_above_them():
    text = "   t  theta  omega\n" + "".join(f"{row}  {row / 8:.6f}  1.{row}0000  -0.{row}00000\n" for row in range(4))
    (table,) = tables(text)
    assert roles_of(table.header) == {"t": 1, "theta": 2, "omega": 3}


# Digits.


def units(*numbers, others="1.23457"):
    """Powers of ten of the units of a column, beside one of six digits."""
    (table,) = tables("".join(f"{row} {number} {others}\n" for row, number in enumerate(numbers)))
    return np.rint(np.log10(table.units[:, 1])).astype(int).tolist()


def test_the_unit_of_the_last_digit_is_that_of_the_longest_number():
    assert units("0", "0.148326", "1.48326") == [-6, -6, -5]
    assert units("1.5708", "1.5598", "-0.00123457", "2.1") == [-5, -5, -8, -5]
    assert units("0.00", "0.15", "1.20") == [-2, -2, -2]
    assert units("1.50000e+00", "1.5e-03", "2.25000e-05") == [-5, -8, -10]
    assert units("0.0012", "1.5708", "0.1483", "12.3457") == [-4] * 4


def test_round_numbers_are_as_exact_as_those_beside_them():
    (table,) = tables("".join(f"{0.5 * row:g} {np.cos(0.5 * row):.6g} {-np.sin(0.5 * row):.6g}\n" for row in range(30)))
    assert table.units[:, 0].max() == 1e-4
    (fixed,) = tables("".join(f"{0.5 * row:.1f} {np.cos(0.5 * row):.6f} {-np.sin(0.5 * row):.6f}\n" for row in range(30)))
    assert np.all(fixed.units == np.broadcast_to([0.1, 1e-6, 1e-6], (30, 3)))


def test_one_number_with_more_digits_does_not_make_the_others_more_exact():
    values = [f"{np.cos(0.1 * row):.4f}" for row in range(30)]
    assert set(units("1.5707963268", *values)[1:]) == {-4}


def test_one_number_with_fewer_digits_does_not_make_the_others_less_exact():
    values = [f"{1 + row / 7:.6f}" for row in range(30)]
    found = units(*values[:10], "2.4", *values[10:])
    assert set(found) == {-6}
    assert units("1.5", *values)[0] == -1  # the initial state, as it was given


def test_times_that_are_even_but_for_the_first_are_as_exact_as_the_numbers_beside_them():
    lines = [f"{0.1 * row:.7g} {np.cos(0.1 * row):.7g} {-np.sin(0.1 * row):.7g}\n" for row in range(30)]
    (table,) = tables("".join(["3e-07 1 0\n", *lines[1:]]))
    assert np.rint(np.log10(table.units[:3, 0])).tolist() == [-13, -7, -7]


def test_numbers_of_fixed_decimals_are_no_more_exact_where_zeros_are_left_out():
    rounded, others = ["-1.2697665072", "-0.8841189072", "-0.6912951072"], ["0.1928238", "0.3856476", "1.1569428", "2.3138856"]
    assert units(*rounded, *others, others="1.3989019852") == [-10] * 7


def test_times_that_are_even_to_all_decimals_are_no_more_exact_than_printed():
    times = ["0.", "0.0559853535", "0.111970707", "0.1679560605", "0.223941414", "0.2799267675"]
    others = ["5.879932022", "4.603723189", "3.4234591461", "2.3663665355", "1.4178404891", "0.5426596153"]
    (table,) = tables("".join(f"{time} {other}\n" for time, other in zip(times, others, strict=True)))
    assert set(table.units[1:, 0]) == {1e-10}


def test_a_digit_more_in_numbers_with_an_exponent_is_no_digit_of_the_others():
    """As Intel's Fortran prints single precision."""
    (table,) = tables("0.0000000E+00 0.5000000\n0.1483260 0.4637110\n1.298652 -6.9888796E-03\n2.444978 -0.2275320\n")
    assert np.rint(np.log10(table.units[1:])).tolist() == [[-7, -7], [-6, -10], [-6, -7]]


def test_rows_with_exponents_among_those_without_are_told_apart():
    """As NumPy prints rows, to six decimals."""
    rows = np.array([[0.1 * row + 1 / 3, 30 * np.cos(0.1 * row), np.sin(0.1 * row - 0.5 - 1e-7)] for row in range(30)])
    with np.printoptions(precision=6):
        lines = [str(row) for row in rows]
    (table,) = tables("\n".join(lines))
    has_exponents = np.array(["e" in line for line in lines])
    assert has_exponents.sum() == 1
    powers = np.rint(np.log10(table.units)).astype(int)
    assert np.all(powers[~has_exponents] == -6)
    assert powers[has_exponents].tolist() == [[-7, -5, -13]]


def many_digits(seed, size):
    random_ = np.random.default_rng(seed)
    values = random_.uniform(-1, 1, size) * 10.0 ** random_.integers(-2, 3)
    values[random_.integers(size)] = random_.choice([0, 1, 0.5, 31.25])
    return values.tolist()


@settings(max_examples=200)
@given(
    # A table's numbers have many digits; a column of mostly round ones does not show how it was printed.
    st.builds(many_digits, st.integers(0, 2**32), st.integers(8, 60)),
    st.sampled_from([".4f", ".6f", ".10f", ".6g", ".10g", ".4e", ".16g", ""]),
)
def test_units_are_never_less_than_what_was_printed_nor_forgive_more_than_one_digit(values, style):
    text = "".join(f"{row} {format(value, style)}\n" for row, value in enumerate(values))
    (table,) = tables(text)
    column = table.units[:, 1]
    off = np.abs(table.values[:, 1] - values)
    off_zero = np.array(values) != 0
    # What is read back is rounded to a double, too.
    assert np.all(off <= 0.5 * column + 2e-16 * np.abs(values))
    if style[-1:] in ("g", "e") and table.digits[1] == int(style[1:-1]) + (style[-1] == "e"):
        first = np.floor(np.log10(np.abs(values), where=off_zero, out=np.zeros(len(values))))
        decimals = [len(number.partition("e")[0].partition(".")[2]) for number in map(f"{{:{style}}}".format, values)]
        # Fixed decimals may be it, too; one number alone that has more is taken to be printed in another way.
        fixed = 10.0 ** -sorted(decimals)[-2] if style[-1] == "g" else 0
        assert np.all((column <= np.maximum(11 * 10.0 ** (first + 1 - table.digits[1]), 1.001 * fixed))[off_zero])
    if style[-1:] == "f":
        assert np.all(column <= 1.001 * 10.0 ** -int(style[1:-1]))


# Files.


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16", "utf-16-le", "utf-16-be", "utf-32", "latin-1", "cp1252"])
def test_accents_survive_their_encoding(encoding, tmp_path):
    path = tmp_path / "table"
    path.write_bytes("t ángulo velocidad\n0 1 2\n".encode(encoding))
    (table,) = read_file(str(path))
    assert roles_of(table.header) == {"t": 0, "theta": 1, "omega": 2}
    assert table.notes == ((("no_mark_utf16", {}),) if encoding in ("utf-16-le", "utf-16-be") else ())


@pytest.mark.parametrize(
    ("data", "reason"),
    [
        (b"", "empty"),
        (b" \n\t\r\n", "empty"),
        (b"\x7fELF\x02\x01\x00\x00 1 2 3", "binary"),
        (bytes(range(256)), "binary"),
        (b"\0" * 100, "binary"),
        (b"hello", "no table"),
        (b"1\n2\n3\n", "no table"),
        (b"t angulo velocidad\n", "no table"),
        ("\N{SNOWMAN}".encode() * 1000, "no table"),
        (b"1 " * 65, "wide"),
        (b"1 " * 5000, "long line"),
        (b"1 2\n" * 110_001, "many lines"),
        (b"t angulo velocidad\n0 1 2\n" * 2001, "many tables"),
        (b"".join(b"%d a%xz b\n" % (row, row) for row in range(2001)), "many kinds"),
    ],
)
def test_what_is_no_table_is_refused_with_its_reason(data, reason):
    with pytest.raises(UnreadableError) as refused:
        tables(*decoded(data))
    assert refused.value.name == reason


SOURCES = {
    "C++": """\
#include <cmath>
#include <iostream>
using namespace std;
void rk4(double t, double& th, double& w, double h, double al) {
  double k1[2] = {0, 1}, k2[2] = {0.5, 0.5};
  double A = w * h, a = -al * sin(th) * h;
  double B = (w + a / 2) * h, b = -al * sin(th + A / 2) * h;
  th += A / 6 + B / 3;
  w += a / 6 + b / 3;
}
int main() {
  double t = 0, th = 1.5708, w = 0;
  double pesos[4] = {1, 2, 2, 1};
  double t0 = 0, th0 = 1.5, w0 = 2;
  cout << "t angulo velocidad funcionSinusoidal" << endl;
  for (int i = 0; i < 51; i++) {
    rk4(t, th, w, 0.001, 1);
    cout << t << " " << th << " " << w << endl;
  }
}
""",
    "Fortran": """\
program pendulo
  implicit none
  real(8) :: t = 0.d0, theta = 1.57d0, w = 0.d0
  real(8), dimension(4) :: c = (/ 0.d0, 0.5d0, 0.5d0, 1.d0 /)
  integer :: i
  write(*,*) 't angulo velocidad'
  do i = 1, 51
    k(1,2) = 1.d0/6
    k(2,3) = 2.d0/6
    k(3,4) = 2.d0/6
    write(*,'(3f10.5)') t, theta, w
  end do
end program
""",
    "README": "# El péndulo\n\n1. Compila con make.\n2. Ejecuta.\n\n| caso | k | τ |\n|---|---|---|\n| oscila | -1 | 7.4163 |\n"
    "| gira | 1 | 4.1 |\n" + "\nCon θ0 = 90 y α = 1 el periodo es 7.41630 s (figura 1).\n" * 5,
    "notebook": '{\n "cells": [\n  {\n   "cell_type": "code",\n   "execution_count": 3,\n   "source": [\n    "import numpy as np\\n",\n'
    '    "t, theta, w = 0, 1.57, 0\\n",\n    "k = [0, 0.5, 0.5, 1]\\n",\n    "for i in range(1, 51):\\n"\n   ]\n  }\n ],\n'
    ' "nbformat": 4,\n "nbformat_minor": 5\n}\n',
    "HTML": "<html>\n"
    + "".join(f"<p style='margin: 0 {place % 3} 1 2'>El péndulo {place}.</p>\n" for place in range(12))
    + "</html>\n",
    "LaTeX": "\\documentclass{article}\n\\begin{document}\n\\begin{tabular}{c|cccc}\n0 & & & & \\\\\n1/2 & 1/2 & & & \\\\\n"
    "1/2 & 0 & 1/2 & & \\\\\n1 & 0 & 0 & 1 & \\\\ \\hline\n & 1/6 & 1/3 & 1/3 & 1/6\n\\end{tabular}\n"
    + "El ángulo inicial es $\\theta_0 = 1.5708$, con $\\alpha = 1$.\n" * 12
    + "\\end{document}\n",
    "PDF": "%PDF-1.4\n1 0 obj\n<< /Type /Page /MediaBox [0 0 595 842] >>\nstream\nBT /F1 12 Tf 72 720 Td (El pendulo) Tj ET\n1 0 0 1 72 700 cm\n"
    + "".join(f"{place} 10.5 m {place} 20.5 l S\n" for place in (90, 80, 70, 60))
    + "endstream\nendobj\nxref\n0 5\n"
    + "".join(f"{place:010} 00000 n \n" for place in (9, 74, 120, 179, 364))
    + "trailer\nstartxref\n565\n%%EOF\n",
}


@pytest.mark.parametrize("source", SOURCES)
def test_a_source_a_report_or_a_page_without_a_table_is_refused(source):
    with pytest.raises(UnreadableError) as refused:
        tables(SOURCES[source])
    assert refused.value.name == "no table"


@pytest.mark.parametrize("program", sorted(PROGRAMS.rglob("*.*")), ids=lambda path: path.name)
def test_no_student_s_program_is_a_table(program):
    with pytest.raises(UnreadableError) as refused:
        read_file(str(program))
    assert refused.value.name == "no table"


@pytest.mark.parametrize("is_above", [True, False])
@pytest.mark.parametrize("source", SOURCES)
@pytest.mark.parametrize("rows", [1, 2, 3])
def test_a_short_table_above_or_below_much_text_is_read(rows, source, is_above):
    lines = "".join(PLAIN.splitlines(keepends=True)[:rows])
    table = f"{HEADER}\n{lines}"
    found = tables(f"{table}\n{SOURCES[source]}" if is_above else f"{SOURCES[source]}\n{table}")
    assert [each.values.tolist() for each in found] == [FOUR[:rows]]


def test_a_table_goes_on_behind_a_page_s_head_and_foot():
    first, rest = PLAIN.split("0.29", 1)
    between = "Página 1\nUniversidad\nPráctica 3\nPágina 2\n"
    (table,) = tables("Péndulo\n" * 20 + f"{HEADER}\n{first}{between}0.29{rest}")
    assert table.values.tolist() == FOUR


@pytest.mark.parametrize("rows", [5, 51, 200])
@pytest.mark.parametrize("source", SOURCES)
def test_a_table_below_its_source_is_the_only_one(source, rows):
    lines = "".join(f"{row / 8} 1.5 {-row} 0.25\n" for row in range(rows))
    (table,) = tables(f"{SOURCES[source]}\n{HEADER}\n{lines}")
    assert table.values.shape == (rows, 4)


def test_a_table_without_a_header_among_words_is_read():
    prose = "El péndulo parte de 90 grados, con alfa = 1.\n" * 30
    (table,) = tables(prose + PLAIN + prose)
    assert table.values.tolist() == FOUR
    (page,) = tables(f"<html>\n{prose}" + "".join(f"<td>{row / 8}</td><td>1.5</td><td>0</td>\n" for row in range(12)) + prose)
    assert page.values.shape == (12, 3)


def test_every_reason_has_texts_with_the_same_places():
    for english, spanish in UNREADABLE.values():
        assert {place for place in "012" if f"{{{place}" in english} == {place for place in "012" if f"{{{place}" in spanish}


MIB = 1 << 20
HOSTILE = {
    "one line": lambda: b"0.123456 " * (10 * MIB // 9),
    "rows": lambda: b"".join(b"%d 1.5 2.5 3.5\n" % row for row in range(109_990)),
    "long rows": lambda: b"".join(b"%.9e %.9e %.9e %.9e\n" % (row, row + 0.1, row + 0.2, row + 0.3) for row in range(109_990)),
    "a million rows": lambda: b"0 1 2\n" * 1_000_000,
    "wide rows": lambda: (b"1 " * 64 + b"\n") * 15_600,
    "a million tables": lambda: b"".join(b"%d 1 2\n" % (2_000_000 - row) for row in range(1_000_000)),
    "tables of two rows": lambda: b"0 1 2\n1 1 2\n" * 59_000,
    "tables of a row": lambda: b"".join(b"%d 1 2\n" % (200_000 - row) for row in range(109_990)),
    "rows among words": lambda: b"".join(b"%d 1 2\nword\n" % (200_000 - row) for row in range(54_900)),
    "brackets": lambda: b"[" * 8_000_000,
    "brackets in lines": lambda: (b"[" * 8_000 + b"1 2 3" + b"]" * 100 + b"\n") * 1000,
    "lists": lambda: b"[1, 2, 3], " * 700_000,
    "commas": lambda: b"," * 8_000_000,
    "commas in lines": lambda: (b"," * 8_000 + b"\n") * 1000,
    "decimal commas that separate": lambda: b"".join(b"%d,5,1,25,-0,5,1,25\n" % row for row in range(109_990)),
    "such commas, to be paired": lambda: (
        b"0,5,1,25,-0,5,1,25\n" * 100 + b"".join(b"%d,1,25,-0,5,1\n" % row for row in range(109_000))
    ),
    "quotes": lambda: b'"1,2"' * 1_600_000,
    "NULs": lambda: b"\0" * 16 * MIB,
    "line ends": lambda: b"\r\n" * 8_000_000,
    "line ends and a row": lambda: b"\r" * 8_000_000 + b"1 2",
    "spaces in lines": lambda: (b" " * 8_000 + b"1 2 x\n") * 1000,
    "points": lambda: (b"1." * 4_000 + b"\n") * 1000,
    "exponents": lambda: (b"1e" * 4_000 + b"\n") * 1000,
    "signs": lambda: (b"+-" * 4_000 + b"\n") * 1000,
    "escapes": lambda: (b"\x1b[" * 4_000 + b"\n") * 1000,
    "calls": lambda: (b"float(" * 1_300 + b"\n") * 1000,
    "words": lambda: b"".join(b"%x abc\n" % row for row in range(109_000)),
    "headers": lambda: (b"t angulo velocidad " * 20 + b"\n") * 20_000,
    "headers of other words": lambda: b"".join(b"t angulo velocidad angular (rad) %x\n" % row for row in range(109_000)),
    "digits": lambda: (b"9" * 8_000 + b"\n") * 1000,
    "letters outside the basic plane": lambda: ("0 1 2 3 \U0001f600\n" * 109_000).encode(),
    "too large": lambda: b"0 1 2\n" * (16 * MIB // 6),
}
MEASURED = """
import sys, time
from pendula.check import UnreadableError, read_file
begin = time.process_time()
try:
    read_file(sys.argv[1])
except UnreadableError:
    pass
took = time.process_time() - begin
with open("/proc/self/status") as status:
    print(took, next(line.split()[1] for line in status if line.startswith("VmHWM")))
"""


@pytest.mark.skipif(not Path("/proc/self/status").exists(), reason="memory is measured as Linux tells it")
@pytest.mark.parametrize("name", HOSTILE)
def test_any_file_is_read_or_refused_in_two_seconds_and_200_mb(name, tmp_path):
    path = tmp_path / "table"
    path.write_bytes(HOSTILE[name]())
    done = subprocess.run([sys.executable, "-c", MEASURED, path], capture_output=True, text=True, check=True, timeout=60)
    seconds, kilobytes = map(float, done.stdout.split())
    assert seconds < 2
    assert kilobytes < 200_000


def test_damaged_texts_are_read_or_refused():
    random_ = random.Random(10)
    read = sum(fuzz_reader.check(fuzz_reader.damaged(random_)) for _ in range(2_000))
    assert read > 500  # not everything is refused


@settings(max_examples=300)
@given(st.text(st.sampled_from("0123456789.,;|&\\ \t\n\r-+eEdD[](){}\"'$#%tθω=:nai*"), max_size=200))
def test_any_text_is_read_or_refused(text):
    fuzz_reader.check(text.encode())
