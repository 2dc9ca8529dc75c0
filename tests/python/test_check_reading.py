"""Tables are read however they are spelled, and what is no table is refused in words."""

import itertools

import numpy as np
import pytest
from pendula.check import UnreadableError, decoded, tables
from pendula.check._table import number, roles_of

ROWS = [[0.0, 1.5, -0.25], [0.5, 1.25, -2.0], [1.0, -3.0, 4e-5]]
STYLES = {
    "spaces": (" ", "."),
    "aligned": ("    ", "."),
    "tabs": ("\t", "."),
    "tabs, decimal commas": ("\t", ","),
    "spaces, decimal commas": ("  ", ","),
    "csv": (",", "."),
    "csv with spaces": (", ", "."),
    "semicolons": (";", "."),
    "semicolons, decimal commas": (" ; ", ","),
    "bars": (" | ", "."),
}


@pytest.mark.parametrize(("style", "end", "lead"), list(itertools.product(STYLES, ["\n", "\r\n", "\n\n", "\r"], ["", "  "])))
def test_all_spellings_are_one_table(style, end, lead):
    between, point = STYLES[style]
    lines = [lead + between.join(f"{value:g}" for value in row).replace(".", point) for row in ROWS]
    (table,) = tables(end.join(lines))
    assert np.array_equal(table.values, ROWS)


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("1.5", 1.5),
        ("-1,5", -1.5),
        (".5", 0.5),
        ("5.", 5),
        ("1e-3", 0.001),
        ("1.25D+02", 125),
        ("−2", -2),
        ("+7", 7),
        ("nan", np.nan),
        ("-nan(ind)", np.nan),
        ("1.#IND", np.nan),
        ("inf", np.nan),
        ("1e999", np.nan),
    ],
)
def test_a_number_is_read_as_it_is_spelled(text, value):
    assert np.array_equal(number(text).value, value, equal_nan=True)


@pytest.mark.parametrize("text", ["", ".", "-", "e5", "1e", "0x10", "1.2.3", "1_000", "٣", "t", "1 2", "--1"])
def test_what_is_no_number_is_none(text):
    assert number(text) is None


@pytest.mark.parametrize(
    ("header", "roles"),
    [
        ("t angulo velocidad funcionSinusoidal", "t theta omega sine"),
        ("tiempo;ángulo;velocidad angular;función sinusoidal", "t theta omega sine"),
        ("t,theta,omega,theta_seno", "t theta omega sine"),
        ("Time\tθ\tω\tsin", "t theta omega sine"),
        ("t θ θ̇", "t theta omega"),
        ("velocidad t angulo", "omega t theta"),
    ],
)
def test_words_of_a_header_tell_the_columns(header, roles):
    words = header.replace(";", "\t").replace(",", "\t").split("\t") if any(c in header for c in ";,\t") else header.split()
    assert roles_of(words) == {role: place for place, role in enumerate(roles.split())}


def test_a_new_table_begins_at_a_header_or_where_time_falls_back():
    with_header = tables("t angulo velocidad\n0 1 2\n1 1 2\nt angulo velocidad\n5 1 2\n")
    without = tables("0 1 2\n1 1 2\n\n0 1 2\n1 1 2\n")
    assert [len(table.values) for table in with_header] == [2, 1]
    assert [len(table.values) for table in without] == [2, 2]


def test_the_unit_of_the_last_digit_is_that_of_the_longest_number():
    (streams,) = tables("0 1.5708\n0.148326 1.5598\n1.48326 -0.00123457\n")
    assert np.allclose(streams.units[:, 0], [1e-6, 1e-6, 1e-5])
    assert np.allclose(streams.units[:, 1], [1e-5, 1e-5, 1e-8])
    (fixed,) = tables("0.00 1.5708\n0.15 -0.0012\n")
    assert np.allclose(fixed.units, [[1e-2, 1e-4]] * 2)


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16", "latin-1", "cp1252"])
def test_accents_survive_their_encoding(encoding):
    (table,) = tables(decoded("t ángulo velocidad\n0 1 2\n".encode(encoding)))
    assert roles_of(table.header) == {"t": 0, "theta": 1, "omega": 2}


@pytest.mark.parametrize(
    ("data", "reason"),
    [
        (b"", "empty"),
        (b" \n\t\r\n", "empty"),
        (b"\x7fELF\x02\x01\x00\x00 1 2 3", "binary"),
        (bytes(range(256)), "binary"),
        (b"hello", "no table"),
        (b"1\n2\n3\n", "no table"),
        (b"t angulo velocidad\n", "no table"),
        ("\N{SNOWMAN}".encode() * 1000, "no table"),
    ],
)
def test_what_is_no_table_is_refused_with_its_reason(data, reason):
    with pytest.raises(UnreadableError) as refused:
        tables(decoded(data))
    assert refused.value.name == reason


def test_ragged_rows_keep_their_lines():
    (table,) = tables("0 1 2\n1 1\n2 1 2 3\n3 1 2\n")
    assert table.ragged == (2, 3)
    assert table.values.shape == (4, 3)
    assert list(table.lines) == [1, 2, 3, 4]
