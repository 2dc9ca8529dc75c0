"""Tables are read however they are laid out, no row is lost in silence, and what is no table is refused in words."""

import itertools
import resource
import subprocess
import sys
from pathlib import Path

import fuzz_reader
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from pendula.check import UnreadableError, decoded, read_file, tables
from pendula.check._table import columns_at, placements, roles_of
from pendula.check._text import UNREADABLE

# Every layout holds these rows, or those of a rotation, or prose around them.
FOUR = [[0, 1.5708, 0, 1.5708], [0.148326, 1.5598, -0.148324, 1.55841], [0.296652, 1.5268, -0.296595, 1.52145]]
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
    "a prompt above": (f"Introduce el angulo y la velocidad inicial:\n{HEADER}\n{PLAIN}", ("extra_text",)),
    "a prompt above and no header": (f"Introduce angulo y velocidad inicial:\n{PLAIN}", ("extra_text",)),
    "k, θM and τ in lines of their own": (f"-1\n1.5708\n7.41630\n{HEADER}\n{PLAIN}", ("extra_text",)),
    "k, θM and τ in one line": (f"-1 1.5708 7.41630\n{HEADER}\n{PLAIN}", ("extra_text",)),
    "k, θM and τ in one line, no header": (f"-1 1.5708 7.41630\n{PLAIN}", ("extra_text",)),
    "k, θM and τ in a line of labels": (f"k = -1 thetaM = 1.5708 tau = 7.41630\n{HEADER}\n{PLAIN}", ("extra_text",)),
    "k, θM and τ in labelled lines": (f"k = -1\ntheta_M = 1.5708\ntau: 7.41630\n{HEADER}\n{PLAIN}", ("extra_text",)),
    "the problem repeated above": (f"0.0001 0.02 1 90 s 0 r 1\n{HEADER}\n{PLAIN}", ("extra_text",)),
    "spaces inside the header's names": (f"t  angulo (rad)  velocidad angular  funcion sinusoidal\n{PLAIN}", ()),
    "single spaces inside the names": (f"t (s) ángulo (rad) velocidad angular (rad/s) función sinusoidal\n{PLAIN}", ()),
    "a line of units": (f"{HEADER}\ns rad rad/s rad\n{PLAIN}", ("extra_text",)),
    "a line of units in brackets": (f"{HEADER}\n(s) (rad) (rad/s) (rad)\n{PLAIN}", ("extra_text",)),
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
    "two numbers to a line": (f"{HEADER}\n" + each_row("{0} {1}\n{2} {3}\n"), ("folded_records",)),
    "a number to a line": (f"{HEADER}\n" + each_row("{0}\n{1}\n{2}\n{3}\n"), ("folded_records",)),
    "Python's lists": (each_row("[{0}, {1}, {2}, {3}]\n"), ("brackets",)),
    "a list of lists": ("[" + each_row("[{0}, {1}, {2}, {3}], ")[:-2] + "]", ("brackets",)),
    "tuples": (each_row("({0}, {1}, {2}, {3})\n"), ("brackets",)),
    "a NumPy array": ("[[0. 1.5708 0. 1.5708]\n" + each_row(" [{0} {1} {2} {3}]\n", PLAIN.split("\n", 1)[1]) + "]", ("brackets",)),
    "a folded NumPy array": ("[" + each_row("[{0} {1} {2}\n {3}]\n "), ("brackets", "folded_records")),
    "NumPy's scalars": (each_row("(np.float64({0}), np.float64({1}), np.float64({2}), np.float64({3}))\n"), ("brackets",)),
    "Fortran's exponents": ("0.D0 15.708D-1 0.D0 1.5708D+00\n" + PLAIN.split("\n", 1)[1], ()),
    "units glued to the numbers": (each_row("{0}s {1}rad {2}rad/s {3}rad\n"), ()),
    "units behind the numbers": (each_row("{0} s, {1} rad, {2} rad/s, {3} rad\n"), ()),
    "labels": (each_row("t={0} theta={1} w={2} sin={3}\n"), ()),
    "labels with spaces": (each_row("t = {0}, theta = {1}, omega = {2}, theta_seno = {3}\n"), ()),
    "sentences": (each_row("En t = {0} s el angulo es {1}, la velocidad {2} y el seno {3}.\n"), ()),
    "dictionaries": (each_row("{{'t': {0}, 'theta': {1}, 'omega': {2}, 'sin': {3}}}\n"), ("brackets",)),
    "Markdown": (f"| {HEADER.replace(' ', ' | ')} |\n|---|:-:|---|---:|\n" + each_row("| {0} | {1} | {2} | {3} |\n"), ()),
    "comment marks": (f"# {HEADER}\n# RK4, h = 0.001\n" + PLAIN, ("extra_text",)),
    "comment marks before rows": (each_row("# {0} {1} {2} {3}\n"), ()),
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
