"""`pendula plot` as a program, and the scripts of the gallery."""

import os
import subprocess
import sys
from pathlib import Path

import pytest
from conftest import PROGRAM

pytest.importorskip("matplotlib")

PROBLEM = "0.001 0.02 1 90 s 0 r 1\n"
HIDDEN = ("DISPLAY", "WAYLAND_DISPLAY", "LC_ALL", "LC_MESSAGES", "LANG")
CLEAN = {name: value for name, value in os.environ.items() if name not in HIDDEN}
GALLERY = Path(__file__).parents[2] / "examples" / "gallery"
PICTURES = Path(__file__).parents[2] / "docs" / "gallery"
MAGIC = {".png": b"\x89PNG", ".svg": b"<?xml", ".pdf": b"%PDF", ".gif": b"GIF8"}


@pytest.fixture
def plot():
    def run(*arguments, text="", before=()):
        command = [PROGRAM, *before, "plot", *map(str, arguments)]
        return subprocess.run(command, input=text, capture_output=True, text=True, env=CLEAN, timeout=300)

    return run


@pytest.mark.parametrize("suffix", [".png", ".svg", ".pdf"])
def test_problems_from_standard_input_become_a_picture(plot, tmp_path, suffix):
    picture = tmp_path / f"picture{suffix}"
    done = plot("--output", picture, text=PROBLEM * 2)
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")
    assert picture.read_bytes().startswith(MAGIC[suffix])


def test_a_problem_from_options_becomes_a_picture(plot, tmp_path):
    picture = tmp_path / "picture.svg"
    done = plot("--theta0", "170deg", "--omega0", "-1", "--alpha", "2", "--flow", "--output", picture)
    assert (done.returncode, done.stderr) == (0, "")
    assert picture.stat().st_size > 10000


@pytest.mark.parametrize("method", ["rk4", "euler", "verlet", "taylor", "exact"])
def test_a_solution_by_any_method_becomes_a_picture(plot, tmp_path, method):
    picture = tmp_path / "picture.png"
    done = plot("--theta0", "1", "--every-factor", "0.1", "--method", method, "--output", picture)
    assert (done.returncode, done.stderr) == (0, "")
    assert picture.read_bytes().startswith(MAGIC[".png"])


def test_the_file_of_the_problems_is_never_the_picture(tmp_path):
    problems = tmp_path / "problems.png"
    problems.write_text(PROBLEM)
    (tmp_path / "link.png").symlink_to(problems)
    for name in (problems, tmp_path / "link.png"):
        with problems.open() as opened:
            command = [PROGRAM, "plot", "--output", name]
            done = subprocess.run(command, stdin=opened, capture_output=True, text=True, env=CLEAN, timeout=300)
        assert done.returncode == 2
        assert "standard input" in done.stderr
        assert problems.read_text() == PROBLEM


def test_an_animation_becomes_a_film(plot, tmp_path):
    film = tmp_path / "film.gif"
    assert plot("--theta0", "1", "--every-factor", "0.2", "--animate", "--dpi", "20", "--output", film).returncode == 0
    assert film.read_bytes().startswith(MAGIC[".gif"])


@pytest.mark.parametrize(
    ("arguments", "text", "status", "words"),
    [
        (["--theta0", "1", "--alpha", "-1", "--output", "a.png"], "", 2, "--alpha"),
        (["--output", "a.png"], "1 2 3\n", 1, "line 1"),
        (["--output", "a.bmp"], PROBLEM, 2, ".png, .svg, .pdf"),
        (["--output", "a.png", "--animate"], PROBLEM, 2, ".gif, .mp4"),
        (["--output", "a.gif", "--animate"], PROBLEM * 2, 1, "one problem"),
        (["--output", "a.png"], PROBLEM * 41, 1, "at most 40"),
        (["--output", "a.png", "--dpi", "0"], PROBLEM, 2, "--dpi"),
        (["--output", "a.gif", "--animate", "--speed", "x"], PROBLEM, 2, "--speed"),
        (["--output", "/nowhere/a.png"], PROBLEM, 3, "/nowhere/a.png"),
        ([], PROBLEM, 2, "--output"),
        (["--nonsense", "--output", "a.png"], PROBLEM, 2, "--nonsense"),
        (["--output", "a.png"], "", 1, "no problem"),
        (["--output", "a.png", "plot"], PROBLEM, 2, '"plot"'),  # a word is no command of the program
        (["--output", "a.png", "--format", "csv"], PROBLEM, 2, "--format"),
        (["--output", "a.png", "--dpi", "1e5"], PROBLEM, 2, "1e+06 pixels"),
        (["--output", "a.gif", "--animate", "--speed", "1e-300"], PROBLEM, 2, "longer than a minute"),
    ],
)
def test_what_cannot_be_drawn_has_its_status_and_a_reason(plot, arguments, text, status, words):
    done = plot(*arguments, text=text)
    assert (done.returncode, done.stdout) == (status, "")
    assert words in done.stderr
    assert "Traceback" not in done.stderr


@pytest.mark.parametrize("suffix", [".png", ".svg", ".pdf", ".gif"])
def test_a_full_disk_has_status_3(plot, tmp_path, suffix):
    full = tmp_path / f"full{suffix}"
    full.symlink_to("/dev/full")
    done = plot("--output", full, "--dpi", "20", *(["--animate"] if suffix == ".gif" else []), text=PROBLEM)
    assert (done.returncode, done.stdout) == (3, "")
    assert done.stderr == f"pendula plot: '{full}' could not be written: No space left on device\n"


def test_without_matplotlib_it_says_what_to_install():
    code = "import sys; sys.modules['matplotlib'] = None; from pendula.plot._main import main; sys.exit(main())"
    command = [sys.executable, "-c", code, "--output", "a.png", "--lang", "es"]
    done = subprocess.run(command, capture_output=True, text=True, env=CLEAN)
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr == "pendula plot: falta matplotlib; instálalo con: pip install 'pendula[plot]'\n"


def test_it_speaks_spanish(plot):
    assert "no hay pantalla" in plot("--lang", "es", text=PROBLEM).stderr
    assert "no hay pantalla" in plot(text=PROBLEM, before=("--lang", "es")).stderr


@pytest.mark.parametrize("script", ["actividad3.py", "portraits.py", "rk4_error.py"])
def test_scripts_of_the_gallery_draw_the_pictures_they_are_named_for(script, tmp_path):
    environment = CLEAN | {"MATPLOTLIBRC": str(GALLERY), "SOURCE_DATE_EPOCH": "0"}
    subprocess.run([sys.executable, GALLERY / script, tmp_path], env=environment, check=True, timeout=300)
    drawn = {path.name for path in tmp_path.iterdir()}
    assert drawn
    assert drawn <= {path.name for path in PICTURES.iterdir()}


def test_every_picture_of_the_gallery_is_shown_beside_its_script():
    page = (PICTURES / "README.md").read_text(encoding="utf-8")
    for path in [*GALLERY.glob("*.py"), *PICTURES.glob("*.[sgp]*")]:
        assert f"{path.name})" in page, path.name
