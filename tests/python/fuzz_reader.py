"""Damages tables in every way and reads them: `python tests/python/fuzz_reader.py --seconds 60 [--seed 0]`.

The reader returns tables or raises UnreadableError, nothing else, and its tables are well formed.
"""

import argparse
import random
import time

import numpy as np
from pendula.check import UnreadableError, decoded, tables
from pendula.check._table import ROLES, columns_at, placements

SEEDS = [
    b"t angulo velocidad funcionSinusoidal\n0 1.5708 0 1.5708\n0.148326 1.5598 -0.148324 1.55841\n0.29 1.5268 -0.29 1.52\n",
    b"Introduce: t;angulo (rad);velocidad angular\r\n0;1,5708;0\r\n0,1;1,55;-0,14\r\n\r\n0;1,5708;0\r\n0,1;1,55;-0,14\r\n",
    b"[[0. 1.57 0.]\n [0.1 1.5\n -0.1]]\n(0, 1, 2), (1, 2, 3), (2, 3, 4)\n",
    "\\begin{tabular}{|c|}\n$t$ & $\\dot\\theta$ & θ̇ & θ \\\\ \\hline\n0 & 1{,}5 & 2 \\\\ 1 & 2 & 3 \\\\\n".encode(),
    b"0,1,5708,0,1,5708\n0,148326,1,5598,-0,148324,1,55841\n0,296652,1,5268,-0,296595,1,52145\n",
    b't=0.1 theta=1.57 w=0\nt=0.2 theta=1.5 w=-1\n"0,1","1,5",nan,****,1.0-101,1.D+00,#NUM!\n| a | b |\n|--|--|\n| 0 | 1 |\n',
    "t\tθ\tω\n0\t1e-300\t−1\n1\t1e999\tinf\n".encode("utf-16-le"),
]
PIECES = [
    *(bytes([byte]) for byte in b"0123456789.,;:|&\\+-eEdD \t\r\n\"'()[]{}#%/*=_tw\0\x1a\x1b\xff\x85"),
    *(
        b"nan",
        b"inf",
        b"****",
        b"1e999",
        b"1e-999",
        b"1e99999999",
        b"\\\\",
        b"\r\n",
        b"\n\n",
        b"{,}",
        b"...",
        b"1.#IND",
        b"0x1p3",
    ),
    *(
        word.encode()
        for word in (
            "−",
            "\N{NO-BREAK SPACE}",
            "θ̇",
            "٣",
            "\N{MATHEMATICAL BOLD DIGIT ONE}",
            "\u2028",
            "t angulo velocidad\n",
            "np.float64(",
        )
    ),
    *(b"theta", b"velocidad angular", b"Introduce datos: ", b"t=", b" rad", b"energia", b"9" * 400, b"1 " * 70),
]


def damaged(random_: random.Random) -> bytes:
    """A text with pieces cut, repeated, moved and put in, or one of pieces alone."""
    data = random_.choice(SEEDS) if random_.random() < 0.9 else b""
    for _ in range(random_.randint(0, 12)):
        start, stop = sorted(random_.randint(0, len(data)) for _ in range(2))
        stop = min(stop, start + random_.choice([1, 4, 40, 400]))
        piece = random_.choice(
            [b"", data[start:stop] * 2, random_.choice(PIECES), random_.choice(PIECES), random_.choice(SEEDS)]
        )
        data = data[:start] + piece + data[stop:]
    return data[:5000]


def check(data: bytes) -> bool:
    """Whether there are tables; all of them are well formed."""
    try:
        found = tables(*decoded(data))
    except UnreadableError as error:
        assert str(error) or error.name
        return False
    assert found
    last = 0
    for table in found:
        rows, columns = table.values.shape
        assert rows >= 1
        assert columns >= 2
        assert table.units.shape == table.values.shape
        assert table.digits.shape == (columns,)
        assert table.lines.shape == (rows,)
        assert last < table.lines[0] or (table.lines[0] == last > 0)
        assert np.all(np.diff(table.lines) >= 0)
        assert not np.any(np.isinf(table.values))
        assert np.all(table.units >= 0)
        assert not np.any(np.isnan(table.units))
        assert np.all((table.digits >= 0) & (table.digits <= 32))
        assert set(table.ragged) <= set(table.lines.tolist())
        assert all(isinstance(name, str) and isinstance(values, dict) for name, values in table.notes)
        last = int(table.lines[-1])
        for oscillates in (True, False):
            candidates = list(placements(table, oscillates))
            assert len(candidates) <= 12
            for _, places in candidates:
                assert set(ROLES[:3]) <= places.keys() <= set(ROLES)
                assert all(0 <= place < columns for place in places.values())
                assert len(set(places.values())) == len(places)
                columns_at(table, places)
    return True


def main() -> None:
    """Until the time is over."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--seconds", type=float, default=60)
    parser.add_argument("--seed", type=int, default=0)
    given = parser.parse_args()
    random_ = random.Random(given.seed)
    end = time.monotonic() + given.seconds
    count = read = 0
    slowest, slowest_data = 0.0, b""
    while time.monotonic() < end:
        data = damaged(random_)
        begin = time.process_time()
        try:
            read += check(data)
        except BaseException:
            print(repr(data))
            raise
        if (took := time.process_time() - begin) > slowest:
            slowest, slowest_data = took, data
        count += 1
    print(f"{count} texts, {read} with tables; the slowest took {slowest:.3f} s: {slowest_data[:200]!r}")


if __name__ == "__main__":
    main()
