"""`pendula check` of a class: a line a student, summaries, points, pages, and all of that whole or not at all."""

import base64
import csv
import json
import math
import os
import pty
import re
import resource
import signal
import subprocess
import sys
import time
import xml.etree.ElementTree as ET
from functools import partial

import numpy as np
import pytest
from conftest import PROGRAM
from pendula.check import _main
from pendula.check._class import Task, mark_file
from pendula.check._page import page_names
from pendula.check._picture import _canvas

PROBLEMS = "0.001 0.02 1 90 s 0 r 1\n0.001 0.02 1 0 r 2.1 r 1\n"
CLEAN = {name: value for name, value in os.environ.items() if name not in ("LC_ALL", "LC_MESSAGES", "LANG")}


@pytest.fixture(scope="session")
def tables(program):
    """Tables of both problems: all right, the first of them wrong, and none."""
    right = program(text=PROBLEMS)
    return {"right": right, "wrong": right.replace("1.5598", "1.6598", 1), "none": ""}


@pytest.fixture(autouse=True)
def group(tmp_path, tables, monkeypatch):
    """A folder with a class of three and their problems, which is the current one."""
    monkeypatch.chdir(tmp_path)
    folder = tmp_path / "group"
    folder.mkdir()
    (folder / "problems").write_text(PROBLEMS)
    for student, kind in (("ana", "right"), ("berta", "wrong"), ("carlos", "none")):
        (folder / f"{student}.txt").write_text(tables[kind])
    return folder


def start(*arguments, env=None, **options):
    streams = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "encoding": "utf-8"}
    command = [PROGRAM, "check", *arguments, *(() if "--input" in arguments else ("--input", "group/problems"))]
    return subprocess.Popen(command, env=CLEAN | (env or {}), **(streams | options))


def check(*arguments, **options):
    process = start(*arguments, **options)
    stdout, stderr = process.communicate(timeout=120)
    return subprocess.CompletedProcess(arguments, process.returncode, stdout, stderr)


def rows(path):
    with open(path, encoding="utf-8-sig", newline="") as file:
        return [tuple(row.values()) for row in csv.DictReader(file)]


# Which files.


def test_a_class_has_a_line_for_each_student_below_one_that_names_what_is_in_it():
    done = check("group")
    assert (done.returncode, done.stderr) == (2, "")
    heads, ana, berta, carlos, count = done.stdout.splitlines()
    assert re.split("  +", heads) == ["student", "tables right", "verdict", "findings"]
    assert len({heads.index("verdict"), ana.index("right"), berta.index("wrong"), carlos.index("unreadable")}) == 1
    assert re.fullmatch(r"ana +2/2 +right", ana)
    assert re.match(r"berta +1/2 +wrong +\S.*\(table 1\)", berta)
    assert re.fullmatch(r"carlos +- +unreadable +'.*carlos.txt' is empty", carlos)
    assert count == "3 files: 1 right, 1 wrong, 1 unreadable."
    told = check("group", "--lang", "es", "--points", "6").stdout
    assert re.match("estudiante  tablas bien  resultado  puntos  qué se ha visto\n", told)
    assert re.search(r"^carlos +- +ilegible +0 +'", told, re.MULTILINE)


def test_the_status_is_that_of_the_worst_file(group):
    ana, berta, carlos = (f"group/{name}.txt" for name in ("ana", "berta", "carlos"))
    (group / "again.txt").write_text((group / "ana.txt").read_text())
    assert check(ana, "group/again.txt").returncode == 0
    assert check(ana, berta).returncode == 1
    assert check(carlos, ana, berta).returncode == check(ana, "group/nobody.txt").returncode == 2


def test_a_folder_holds_what_is_neither_hidden_nor_a_folder_nor_part_of_the_command(group):
    (group / ".hidden").write_text("0 1 2\n")
    (group / "deeper").mkdir()
    (group / "scale.toml").write_text("remark = 0.5\n")
    options = ("--json-lines", "--summary", "group/class.csv", "--scale", "group/scale.toml")
    for _ in range(2):  # the second time, there is a summary
        marked = [json.loads(line)["student"] for line in check("group", *options).stdout.splitlines()]
        assert marked == ["ana", "berta", "carlos"]


def test_a_pattern_that_the_shell_has_left_alone_is_a_class(group):
    (group / "[1].txt").write_text((group / "ana.txt").read_text())
    assert check("group/[ab]*.txt").stdout.splitlines()[-1] == "2 files: 1 right, 1 wrong, 0 unreadable."
    assert check("group/[1].txt").stdout.startswith("Table 1: right\n")  # a file's own name is no pattern
    assert "'group/z*' does not exist" in check("group/z*").stdout


def test_a_file_given_twice_is_marked_once_and_namesakes_are_told_apart(group):
    (group / "ana.csv").write_text((group / "ana.txt").read_text())
    other = group / "other"
    other.mkdir()
    (other / "berta.txt").write_text((group / "ana.txt").read_text())
    done = check("group", "group/ana.txt", "group/other/berta.txt", "--json-lines")
    marked = [json.loads(line)["student"] for line in done.stdout.splitlines()]
    assert marked == ["ana.csv", "ana.txt", "group/berta.txt", "carlos", "group/other/berta.txt"]


def test_files_are_in_the_order_of_their_numbers_and_letters_without_regard_to_case_and_accents(group):
    names = ["Álvaro", "alumno1", "alumno2", "Alumno9", "alumno10", "alumno10b", "alumno²", "Bea", "NUÑO 2", "ñandú 1"]
    expected = ["alumno1", "alumno2", "Alumno9", "alumno10", "alumno10b", "alumno²", "Álvaro", "Bea", "NUÑO 2", "ñandú 1"]
    folder = group / "other"
    folder.mkdir()
    for name in names:
        (folder / f"{name}.txt").write_text("")
    words = [f"group/other/{name}.txt" for name in sorted(names)]  # as a shell gives them
    for given in (["group/other"], ["group/other/*"], words):
        marked = [json.loads(line)["student"] for line in check(*given, "--json-lines").stdout.splitlines()]
        assert marked == expected


def test_one_is_told_in_the_singular_and_all_else_in_the_plural(group):
    (group / "one").write_text("0.001 0.02 1 90 s 0 r 1\n")
    (group / "none").write_text("0.001 2 1 90 s 0 r 1\n")  # a row and no more
    row = "\n".join((group / "ana.txt").read_text().splitlines()[:2]) + "\n"
    (group / "row.txt").write_text(row)
    told = {
        lang: check("group/row.txt", "--input", "group/none", "--points", "1", "--lang", lang).stdout for lang in ("en", "es")
    }
    assert "  1 of 1 row\n  angulo: 1 of 1 row right; " in told["en"]
    assert told["en"].endswith("1 of 1 table right.\n1 of 1 point.\n")
    assert "  1 de 1 fila\n  angulo: 1 de 1 fila bien; " in told["es"]
    assert told["es"].endswith("1 de 1 tabla bien.\n1 de 1 punto.\n")
    assert "  1 of 51 rows\n" in check("group/row.txt", "--input", "group/one").stdout
    assert check("group/row*").stdout.endswith("1 file: 0 right, 1 wrong, 0 unreadable.\n")
    assert check("group/row*", "--lang", "es").stdout.endswith("1 fichero: 0 bien, 1 mal, 0 ilegibles.\n")
    assert check("group/[ac]*.txt", "--lang", "es").stdout.endswith("2 ficheros: 1 bien, 0 mal, 1 ilegible.\n")


def test_names_cannot_command_the_terminal(group):
    (group / "\x1b[31m.txt").write_text("")
    done = check("group")
    assert done.returncode == 2
    assert "\x1b" not in done.stdout


# For machines.


def test_a_summary_has_a_row_for_each_problem():
    check("group", "--summary", "class.csv")
    found = rows("class.csv")
    assert [row[:3] for row in found] == [
        ("ana", "1", "right"),
        ("ana", "2", "right"),
        ("berta", "1", "wrong"),
        ("berta", "2", "right"),
        ("carlos", "", "unreadable"),
    ]
    assert [row[3] != "" for row in found] == [False, False, True, False, True]
    assert [row[4] for row in found] == ["", "", "3", "", ""]
    assert [row[5] for row in found] == ["5", "5", "0", "5", "0"]


@pytest.mark.parametrize("problems", [1, 3, 6, 7])
def test_points_in_a_summary_add_up_to_those_of_the_file(group, program, problems):
    text = "0.001 0.02 1 90 s 0 r 1\n" * problems
    (group / "many").write_text(text)
    (group / "all.txt").write_text(program(text=text))
    check("group/all.txt", "--input", "group/many", "--summary", "class.csv")
    points = [float(row[5]) for row in rows("class.csv")]
    assert (len(points), math.fsum(points)) == (problems, 10)


def test_points_in_a_summary_have_no_digits_of_rounding(group):
    (group / "scale").write_text("points = 0.6\nremark = 0.1\n")  # as doubles, 0.6/2 − 0.1 is 0.19999999999999998
    (group / "ana.txt").write_text((group / "ana.txt").read_text().replace("t angulo velocidad funcionSinusoidal\n", "", 1))
    check("group/ana.txt", "--scale", "group/scale", "--summary", "class.csv")
    assert [row[5] for row in rows("class.csv")] == ["0.2", "0.3"]


def test_no_name_is_a_formula_in_a_summary(group):
    (group / "=1+1.txt").write_text("")
    check("group", "--summary", "class.csv")
    assert rows("class.csv")[0][0] == "'=1+1"


def test_autograders_get_one_document_or_a_line_each():
    document = json.loads(check("group", "--json").stdout, parse_constant=pytest.fail)
    assert (document["verdict"], document["status"], document["right"]) == ("unreadable", 2, 1)
    lines = [json.loads(line, parse_constant=pytest.fail) for line in check("group", "--json-lines").stdout.splitlines()]
    assert lines == document["students"]
    assert [(each["verdict"], each["status"], each["points"]) for each in lines] == [
        ("right", 0, 10),
        ("wrong", 1, 5),
        ("unreadable", 2, 0),
    ]
    (finding,) = lines[1]["marks"][0]["findings"]
    assert finding["where"]["line"] == 3
    assert (finding["where"]["value"], finding["where"]["column"]) == (1.6598, "angulo")
    assert f"{finding['where']['wanted']:.5g}" == "1.5598"
    (alone,) = check("group/berta.txt", "--json-lines").stdout.splitlines()
    assert json.loads(alone) == lines[1]


def test_a_summary_is_not_written_over_a_student_s_file(group):
    before = (group / "ana.txt").read_bytes()
    done = check("group/berta.txt", "--summary", "group/ana.txt")  # as where the shell puts *.txt behind --summary
    assert (done.returncode, done.stdout) == (2, "")
    assert "'group/ana.txt' is there and is no summary" in done.stderr
    assert (group / "ana.txt").read_bytes() == before
    for _ in range(2):
        assert check("group/ana.txt", "--summary", "class.csv").returncode == 0


# Points.


@pytest.mark.parametrize(
    ("options", "scale", "points"),
    [
        ((), None, [10, 5]),
        (("--points", "4"), None, [4, 2]),
        ((), "error = 2", [10, 8]),
        ((), "points = 6\nerror = 1", [6, 5]),
        (("--points", "8"), "points = 6\nerror = 1", [8, 7]),
        ((), "error = 100", [10, 5]),  # no less than nothing
        ((), "error = 3\n[findings]\nwrong_cell = 0.5\nunexplained = 0.5", [10, 9.5]),
    ],
)
def test_points_follow_the_scale(group, options, scale, points):
    if scale is not None:
        (group / "scale").write_text(scale)
        options = (*options, "--scale", "group/scale")
    lines = check("group/ana.txt", "group/berta.txt", "--json-lines", *options).stdout.splitlines()
    assert [json.loads(line)["points"] for line in lines] == points


def test_remarks_cost_what_the_scale_says_and_the_strict_count_them_as_mistakes(group):
    (group / "scale").write_text("error = 3\nremark = 0.25\n")
    headless = (group / "ana.txt").read_text().replace("t angulo velocidad funcionSinusoidal\n", "", 1)
    (group / "ana.txt").write_text(headless)
    found = [
        json.loads(check("group/ana.txt", "--scale", "group/scale", "--json", *options).stdout)
        for options in ((), ("--strict",))
    ]
    assert [(each["points"], each["verdict"]) for each in found] == [(9.75, "right"), (7, "wrong")]


@pytest.mark.parametrize(
    ("scale", "words"),
    [
        ("points = ", "is no scale"),
        ("\xff", "is no scale"),
        ("eror = 1", "there is no 'eror' in a scale"),
        ("error = -1", "error must be a number"),
        ("error = nan", "error must be a number"),
        ("error = true", "error must be a number"),
        ("findings = 1", "findings must be a table"),
        ("[findings]\neuler = 'all'", "euler must be a number"),
        ("[findings]\neulr = 1", "there is no finding 'eulr'; is it 'euler'?"),
    ],
)
def test_a_scale_that_is_none_is_refused_with_the_reason(group, scale, words):
    (group / "scale").write_bytes(scale.encode("latin-1"))
    done = check("group", "--scale", "group/scale")
    assert (done.returncode, done.stdout) == (2, "")
    assert words in done.stderr


# Pages.


def pictures(page):
    found = re.findall(r'src="data:image/svg\+xml;base64,([^"]+)"', page)
    return [ET.fromstring(base64.b64decode(each)) for each in found]


def test_a_report_is_a_page_for_each_student_and_one_for_the_class(tmp_path):
    done = check("group", "--report", "report", "--lang", "es")
    assert (done.returncode, done.stderr) == (2, "")
    pages = {path.name: path.read_text("utf-8") for path in (tmp_path / "report").iterdir()}
    assert pages.keys() == {"index.html", "ana.html", "berta.html", "carlos.html"}
    for page in pages.values():
        assert '<html lang="es">' in page
        assert not re.search(r"https?://|<script|<link|src=\"(?!data:)", page)  # all that it needs is in it
    assert [len(pictures(pages[f"{name}.html"])) for name in ("ana", "berta", "carlos")] == [2, 2, 0]
    drawn = ["".join(picture.itertext()) for picture in pictures(pages["berta.html"])]
    assert ["primera fila mal" in text for text in drawn] == [True, False]
    assert "Cómo encontrarlo" in pages["berta.html"]
    assert "está vacío" in pages["carlos.html"]
    assert all(f'href="{name}.html"' in pages["index.html"] for name in ("ana", "berta", "carlos"))


def test_whatever_a_file_is_called_its_page_is_in_the_folder_and_its_name_is_text(group, tmp_path):
    for name in ("<b>.txt", "a..&.txt", "index.txt", "CON.txt", "x" * 250 + ".txt", "a\nb.txt", "ANA.txt"):
        (group / name).write_text("")
    check("group", "--report", "report")
    assert len(list((tmp_path / "report").iterdir())) == 11
    assert {path.name for path in tmp_path.iterdir()} == {"group", "report"}
    index = (tmp_path / "report/index.html").read_text("utf-8")
    assert "&lt;b&gt;" in index
    assert "<b>" not in index


def test_names_of_pages_are_different_also_where_capitals_are_not():
    names = page_names(["ana", "Ana", "a/na", "a na", "../..", "", "nul", "Núñez", "x" * 300, "x" * 301, "index"])
    assert len({name.casefold() for name in names}) == len(names)
    assert not {"index.html", "nul.html"} & set(names)
    assert all(re.fullmatch(r"[\w-]{1,70}\.html", name) for name in names)


def test_where_the_sinusoid_is_wrong_it_is_drawn_over_the_right_one(group):
    right = (group / "ana.txt").read_text().splitlines()[1:52]
    t, _, _, sine = np.loadtxt(right).T
    halved = "".join(f"{' '.join(line.split()[:3])} {0.5 * float(line.split()[3]):.6g}\n" for line in right)
    (group / "half.txt").write_text(halved)
    (group / "one").write_text(PROBLEMS.splitlines()[0])
    task = Task(_main._problems("group/one", "en"), strict=False, draws=True, lang="en")
    (mark,) = mark_file(task, "half", "group/half.txt").marks
    assert [finding.name for finding in mark.findings if finding.name.startswith("sine_")] != []
    assert "funcionSinusoidal" in mark.picture
    assert "first wrong row" in mark.picture
    drawn = _canvas().sine
    assert drawn.table.get_xydata().tolist() == [[x, float(f"{0.5 * y:.6g}")] for x, y in zip(t, sine, strict=True)]
    assert drawn.wrong.get_xydata().tolist() == [[0, 0.7854]]
    # Straight lines between 120 points a period are off by less than (π/120)²/2 of the amplitude, π/2; and so are six digits.
    off = np.interp(t, *drawn.right.get_data()) - sine
    assert np.abs(off).max() < np.pi / 2 * (np.pi / 120) ** 2 / 2 + 1e-5
    for name in ("ana", "berta"):
        assert "funcionSinusoidal" not in mark_file(task, name, f"group/{name}.txt").marks[0].picture


def test_the_page_of_a_class_has_a_plain_word_above_each_column(group):
    for lang, words in (
        ("en", ["student", "table 1", "table 2", "verdict", "points", "findings"]),
        ("es", ["estudiante", "tabla 1", "tabla 2", "resultado", "puntos", "qué se ha visto"]),
    ):
        check("group", "--report", "report", "--points", "10", "--lang", lang)
        assert re.findall("<th>(.*?)</th>", (group.parent / "report/index.html").read_text("utf-8")) == words


def test_a_report_may_be_written_again_but_never_over_what_is_foreign(tmp_path):
    assert check("group", "--report", "report").returncode == 2
    assert check("group/ana.txt", "--report", "report").returncode == 0
    foreign = tmp_path / "report/ana.html"
    foreign.write_text("mine")
    done = check("group/ana.txt", "--report", "report")
    assert (done.returncode, done.stdout) == (2, "")
    assert "holds 'ana.html', which this command has not made" in done.stderr
    assert foreign.read_text() == "mine"
    elsewhere = (tmp_path / "report/index.html").rename(tmp_path / "index.html")
    foreign.unlink()
    foreign.symlink_to(elsewhere)
    assert check("group/ana.txt", "--report", "report").returncode == 2


def test_a_picture_does_not_depend_on_the_one_before():
    task = Task(_main._problems("group/problems", "en"), strict=False, draws=True, lang="en")
    alone = [mark.picture for mark in mark_file(task, "ana", "group/ana.txt").marks]
    mark_file(task, "berta", "group/berta.txt")
    assert [mark.picture for mark in mark_file(task, "ana", "group/ana.txt").marks] == alone


def test_pictures_need_matplotlib_and_say_so(monkeypatch, capfd):
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    words = ["group/ana.txt", "--input", "group/problems", "--lang", "en", "--report", "report"]
    monkeypatch.setattr(sys, "argv", ["pendula-check", *words])
    assert _main.main() == 2
    assert "matplotlib is missing; install it with: pip install 'pendula[plot]'" in capfd.readouterr().err
    assert not os.path.exists("report")


# What is not written, and who has had enough.


@pytest.mark.parametrize("option", ["--summary", "--report"])
def test_what_cannot_be_written_has_status_3_and_leaves_nothing_half_written(tmp_path, option):
    target = {"--summary": "class.csv", "--report": "report"}[option]
    check("group", option, target)
    path = tmp_path / target
    before = {each.name: each.read_bytes() for each in (path.iterdir() if path.is_dir() else [path])}
    # A limit to the size of files stands for a disk that is full.
    small = partial(resource.setrlimit, resource.RLIMIT_FSIZE, (100, 100))
    done = check("group", option, target, preexec_fn=small)
    assert done.returncode == 3
    assert re.fullmatch(r"pendula check: '.*' could not be written: File too large\n", done.stderr)
    after = {each.name: each.read_bytes() for each in (path.iterdir() if path.is_dir() else [path])}
    assert after == before


@pytest.mark.parametrize("options", [("--summary", "/dev/full"), ("--summary", "no/where"), ("--report", "/dev/full")])
def test_a_place_that_takes_nothing_has_status_3(options):
    done = check("group", *options)
    assert done.returncode == 3
    assert f"'{options[1]}' could not be written: " in done.stderr


def test_a_class_is_told_in_utf_8_whatever_the_locale(group):
    (group / "Núñez θ.txt").write_text((group / "ana.txt").read_text())
    done = check(
        "group", "--summary", "class.csv", env={"PYTHONIOENCODING": "cp1252", "PYTHONUTF8": "0", "LC_ALL": "es_ES.UTF-8"}
    )
    assert (done.returncode, done.stderr) == (2, "")
    assert re.search(r"^Núñez θ +2/2 +bien$", done.stdout, re.MULTILINE)
    assert rows("class.csv")[-1][0] == "Núñez θ"


def test_a_reader_of_a_class_who_has_had_enough_changes_no_status():
    reading, writing = os.pipe()
    os.close(reading)
    try:
        done = check("group", stdout=writing)
    finally:
        os.close(writing)
    assert (done.returncode, done.stderr) == (2, "")


def test_progress_is_for_terminals_only():
    master, terminal = pty.openpty()
    try:
        done = check("group", stderr=terminal)
        told = os.read(master, 1000).decode()
    finally:
        os.close(terminal)
        os.close(master)
    assert done.returncode == 2
    assert "1/3" in told
    assert told.endswith("\r   \r")  # and leaves no trace


def is_there(process_group):
    try:
        os.killpg(process_group, 0)
    except ProcessLookupError:
        return False
    return True


def test_ctrl_c_ends_a_class_and_its_processes(group):
    pipe = group / "pipe"
    os.mkfifo(pipe)
    words = [f"group/{number}.txt" for number in range(10)]
    for word in words:
        (group.parent / word).write_text((group / "ana.txt").read_text())
    process = start(
        pipe,
        *words,
        "--report",
        "report",
        encoding=None,
        start_new_session=True,
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),  # a script in the background ignores it
    )
    deadline = time.monotonic() + 60
    while True:
        try:
            writing = os.open(pipe, os.O_WRONLY | os.O_NONBLOCK)
            break
        except OSError:  # nobody reads it yet
            assert time.monotonic() < deadline
            time.sleep(0.1)
    try:
        os.killpg(process.pid, signal.SIGINT)
        assert process.communicate(timeout=60) == (b"", b"")
        assert process.returncode == 130
        while is_there(process.pid):  # the last ones end when they see that the first is gone
            assert time.monotonic() < deadline
            time.sleep(0.1)
    finally:
        os.close(writing)
    assert not list((group.parent / "report").iterdir())


# Explanations.


@pytest.mark.parametrize(("lang", "words"), [("en", "HOW TO FIND IT"), ("es", "CÓMO ENCONTRARLO")])
def test_a_finding_is_explained_and_all_are_listed(lang, words):
    page, listed = check("--explain", "euler", "--lang", lang), check("--list", "--lang", lang)
    assert (page.returncode, listed.returncode) == (0, 0)
    assert words in page.stdout
    title = re.match(r"euler: (.+)", page.stdout)[1]
    assert re.search(rf"^euler +{re.escape(title)}$", listed.stdout, re.MULTILINE)
