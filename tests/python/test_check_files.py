"""Whatever stands where `pendula check` wants a file, it neither waits for ever nor does what a name says, and says why."""

import csv
import json
import os
import sys
import threading
import unicodedata

import pytest
from check_marking import COMMAND
from processes import finished

PROBLEM = "0.001 0.02 1 90 s 0 r 1\n"
HEADER = "t angulo velocidad funcionSinusoidal"

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="Windows has neither such pipes nor such names")


@pytest.fixture(scope="module")
def right(program):
    return program(text=PROBLEM)


@pytest.fixture(autouse=True)
def folder(tmp_path, right, monkeypatch):
    """The current one, with a table, its problem, a pipe and another folder."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "problem").write_text(PROBLEM)
    (tmp_path / "right.txt").write_text(right)
    (tmp_path / "other").mkdir()
    os.mkfifo(tmp_path / "pipe")
    return tmp_path


def check(*arguments, text="", **options):
    done = finished([*COMMAND, *arguments, "--lang", "en"], text.encode(), seconds=30, **options)
    assert b"Traceback" not in done.stderr
    return done.returncode, done.stdout.decode(), done.stderr.decode()


def check_right(*arguments, **options):
    return check("right.txt", "--input", "problem", *arguments, **options)


# Pipes.


@pytest.mark.parametrize(
    "words",
    [("pipe", "--input", "problem"), ("right.txt", "--input", "pipe"), ("right.txt", "--input", "problem", "--scale", "pipe")],
)
def test_a_pipe_that_nobody_writes_to_is_refused(words):
    assert check(*words) == (2, "", "pendula check: nobody writes to 'pipe', which is no file\n")


def test_a_pipe_in_a_class_costs_nobody_else_the_mark():
    status, told, _ = check_right("pipe")
    assert status == 2
    assert told.splitlines()[-1] == "2 files: 1 right, 0 wrong, 1 unreadable."


def test_a_pipe_that_nobody_reads_takes_no_summary():
    status, _, error = check_right("--summary", "pipe")
    assert (status, error) == (3, "pendula check: 'pipe' is a pipe that nobody reads\n")


def test_a_pipe_whose_other_end_comes_late_is_read_to_its_end(right):
    """The writer comes after the reader, and stops in the middle for longer than the command waits for a writer."""
    in_between = threading.Event()

    def write():
        with open("pipe", "w") as pipe:
            pipe.write(right[:100])
            pipe.flush()
            in_between.wait(3)
            pipe.write(right[100:])

    writer = threading.Thread(target=write)
    writer.start()
    status, told, _ = check("pipe", "--input", "problem")
    writer.join()
    assert (status, told.splitlines()[-1]) == (0, "1 of 1 table right.")


def test_a_pipe_that_is_open_is_waited_for(right):
    """As where a shell puts a command in the place of a file, and the command takes its time."""
    reading, writing = os.pipe()

    def write():
        threading.Event().wait(3)
        with open(writing, "w") as pipe:
            pipe.write(right)

    writer = threading.Thread(target=write)
    writer.start()
    status, told, _ = check(f"/dev/fd/{reading}", "--input", "problem", pass_fds=(reading,))
    writer.join()
    os.close(reading)
    assert (status, told.splitlines()[-1]) == (0, "1 of 1 table right.")


def test_a_terminal_at_which_nobody_types_is_refused(folder):
    """A student's file may be a link to one."""
    master, terminal = os.openpty()
    (folder / "other" / "ana.txt").symlink_to(os.ttyname(terminal))
    status, told, _ = check("other", "--input", "problem")
    os.close(terminal)
    os.close(master)
    assert status == 2
    assert "nobody writes to 'other/ana.txt'" in told


def test_standard_input_that_is_closed_is_said_so():
    done = finished(["/bin/sh", "-c", 'exec "$@" <&-', "sh", *COMMAND, "-", "--input", "problem", "--lang", "en"], b"")
    assert (done.returncode, done.stderr) == (2, b"pendula check: standard input is closed\n")


# What is no file.


def test_an_empty_name_is_not_the_current_folder():
    assert check("", "--input", "problem") == (2, "", "pendula check: '' does not exist\n")
    status, told, _ = check("right.txt", "", "--input", "problem")
    assert (status, told.splitlines()[-1]) == (2, "2 files: 1 right, 0 wrong, 1 unreadable.")


@pytest.mark.parametrize("option", ["--input", "--scale"])
def test_a_folder_in_the_place_of_a_file_is_told_as_that(option):
    others = () if option == "--input" else ("--input", "problem")
    assert check("right.txt", *others, option, "other") == (2, "", "pendula check: 'other' is a folder, not a file\n")


def test_a_folder_takes_no_summary_and_says_so_before_marking():
    status, told, error = check_right("--summary", "other")
    assert (status, told) == (2, "")
    assert "'other' is there and is no summary" in error


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("1 " * 10_000, "line 1 is longer than"),
        ("1 " * 100, "line 1 has more than 64 numbers"),
        ("words\n", "there is no table"),
        ("0 1 2\n" * 200_000, "there are more than 110000 lines"),
    ],
)
def test_every_reason_names_its_file(folder, text, reason):
    (folder / "ana.txt").write_text(text)
    status, _, error = check("ana.txt", "--input", "problem")
    assert status == 2
    assert error.startswith(f"pendula check: 'ana.txt': {reason}")
    assert f"'ana.txt': {reason}" in check_right("ana.txt")[1]


def test_a_folder_s_links_to_nowhere_and_pipes_are_listed(folder):
    (folder / "other" / "right.txt").write_text((folder / "right.txt").read_text())
    (folder / "other" / "lost.txt").symlink_to("nowhere")
    (folder / "other" / "round.txt").symlink_to("round.txt")
    os.mkfifo(folder / "other" / "pipe.txt")
    for words in ("other", "other/*.txt"):
        status, told, _ = check(words, "--input", "problem")
        assert (status, told.splitlines()[-1]) == (2, "4 files: 1 right, 0 wrong, 3 unreadable.")


def test_problems_that_cannot_be_read_are_told_with_the_first_reason(folder):
    (folder / "problem").write_text(f"{PROBLEM}0.001 0.02 1 90 s 0 r -1\n")
    status, told, error = check_right()
    assert (status, told) == (2, "")
    first, second = error.splitlines()
    assert "problem 2, line 2" in first
    assert second == "pendula check: the problems of 'problem' could not be read"


def test_a_scale_may_begin_with_the_mark_of_some_editors(folder):
    (folder / "scale").write_text("points = 4\r\n", "utf-8-sig")
    assert "4 of 4 points." in check_right("--scale", "scale")[1]


def test_hidden_files_of_the_system_do_not_make_a_report_foreign(folder):
    check_right("--report", "report")
    for name in (".DS_Store", ".123.tmp"):
        (folder / "report" / name).write_text("")
    assert check_right("--report", "report")[0] == 0


@pytest.mark.parametrize("env", [{"LC_ALL": "C", "PYTHONUTF8": "0"}, {"PYTHONIOENCODING": "cp1252"}, {}])
def test_pages_have_their_names_in_any_environment(folder, env):
    (folder / "Núñez.txt").write_text((folder / "right.txt").read_text())
    status, _, error = check("Núñez.txt", "--input", "problem", "--report", "report", env=os.environ | env)
    assert (status, error) == (0, "")
    assert (folder / "report" / "Núñez.html").exists()


def test_a_current_folder_that_is_gone_is_no_reason_to_fail(folder):
    (folder / "gone").mkdir()
    script = 'cd gone && rmdir ../gone && exec "$@"'
    words = [*COMMAND, folder / "right.txt", folder / "right.txt", "--input", folder / "problem", "--lang", "en"]
    done = finished(["/bin/sh", "-c", script, "sh", *words], b"")
    assert b"Traceback" not in done.stderr
    assert done.stdout.splitlines()[-1] == b"1 file: 1 right, 0 wrong, 0 unreadable."


# Names, and words of a table, that mean ill.

NAMES = (
    "\x1b[31mred", "\u202etxt", "\x9b31m", "line\nend", "\u2028", "\udcff",
    "=1+1", " =1+1", "+1", "-1", "@SUM", "\uff1d1+1", 'a";=1+1;"', "a;=1+1;b", "<b>&", "Núñez θ",
)  # fmt: skip


def is_obeyed(letter):
    return unicodedata.category(letter) in ("Cc", "Cf", "Cs", "Zl", "Zp")


@pytest.fixture
def names(folder, right):
    for name in NAMES:
        (folder / "other" / f"{name}.txt").write_text(right.replace("velocidad", "velocidad\u202e", 1), "utf-8")
    return ("other", "--input", "problem")


def test_no_letter_of_a_name_or_a_table_is_obeyed(names, folder):
    outputs = [check(*names)[1], check(*names, "--json")[1], check(*names, "--json-lines")[1]]
    check(*names, "--summary", "class.csv", "--report", "report")
    files = [folder / "class.csv", *(folder / "report").iterdir()]
    outputs += [path.read_text("utf-8-sig") for path in files]
    assert len(files) == len(NAMES) + 2
    for output in outputs:
        assert {letter for letter in output if is_obeyed(letter)} <= {"\n", "\r"}
    assert "Núñez θ" in outputs[0]


def test_autograders_get_names_as_they_are(names):
    found = json.loads(check(*names, "--json")[1])["students"]
    assert {each["student"] for each in found} == {os.fsencode(name).decode(errors="replace") for name in NAMES}


@pytest.mark.parametrize("separator", [",", ";"])
def test_no_cell_of_a_summary_is_a_formula_wherever_a_spreadsheet_separates(names, folder, separator):
    check(*names, "--summary", "class.csv")
    with open(folder / "class.csv", encoding="utf-8-sig", newline="") as file:
        cells = [cell for row in csv.reader(file, delimiter=separator) for cell in row]
    words = [unicodedata.normalize("NFKC", cell).strip() for cell in cells]
    assert not [word for word in words if word.startswith(("=", "+", "-", "@"))]


def test_numbers_of_a_summary_are_numbers_for_spreadsheets(folder):
    check_right("--summary", "class.csv")
    assert (folder / "class.csv").read_text("utf-8-sig").splitlines()[1] == '"right",1,"right","","",10'
