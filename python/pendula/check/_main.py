"""`pendula check`: marks the tables of a file."""

from __future__ import annotations

import argparse
import sys
from itertools import zip_longest

from pendula import _program
from pendula._language import LANGUAGES, language
from pendula.check._asked import asked
from pendula.check._judge import judge
from pendula.check._reading import UnreadableError, opened, read_file
from pendula.check._report import UNREADABLE, Mark, Marks, as_json, as_text, unreadable_as_json
from pendula.check._texts import OPTIONS
from pendula.check._texts import UNREADABLE as REASONS

INTERRUPTED = 130


def main() -> int:
    """The console script."""
    place = LANGUAGES.index(language(sys.argv[1:]))
    options = _parser(place).parse_args()
    try:
        marks = _marks(options.table, options.input, options.strict)
    except UnreadableError as unreadable:
        text = REASONS[unreadable.name][place].format(*unreadable.values)
    except _program.FailedError:  # it has said why
        text = REASONS["no problems"][place].format(options.input)
    except FileNotFoundError as missing:  # the program
        text = str(missing)
    except KeyboardInterrupt:
        return INTERRUPTED
    else:
        print((as_json if options.json else as_text)(marks, LANGUAGES[place]))
        return marks.status
    if options.json:
        print(unreadable_as_json(text))
    print(f"pendula check: {text}", file=sys.stderr)
    return UNREADABLE


def _marks(path: str, problems: str, strict: bool) -> Marks:
    found = read_file(path)
    with opened(problems) as file:
        solved = _program.solve([], file)
    if not solved:
        raise UnreadableError("no problems", problems)
    marks = []
    for each, table in zip_longest(solved, found[: len(solved)]):
        problem = asked(each)
        marks.append(Mark(problem, table, judge(problem, table) if table else None))
    return Marks(marks, len(found), strict)


def _parser(place: int) -> argparse.ArgumentParser:
    def text(name: str) -> str:
        return OPTIONS[name][place]

    parser = argparse.ArgumentParser("pendula check", description=text("about"), allow_abbrev=False, add_help=False)
    parser.add_argument("table", metavar="SALIDA", help=text("table"))
    parser.add_argument("--input", required=True, metavar="PROBLEM", help=text("input"))
    parser.add_argument("--json", action="store_true", help=text("json"))
    parser.add_argument("--strict", action="store_true", help=text("strict"))
    parser.add_argument("--lang", choices=LANGUAGES, help=text("lang"))
    parser.add_argument("--help", action="help", help=text("help"))
    return parser
