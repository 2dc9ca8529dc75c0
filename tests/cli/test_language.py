"""The language of messages, and that numbers know only one."""

import shutil
import subprocess
from pathlib import Path

import pytest
from conftest import GOOD

BAD = "1 1 1 1 x 0 r 1"
ENGLISH = 'pendula: problem 1, line 1: the unit of θ0 "x": it must be r (radians) or s (sexagesimal degrees)\n'
SPANISH = 'pendula: problema 1, línea 1: la unidad de θ0 "x": debe ser r (radianes) o s (grados sexagesimales)\n'


@pytest.mark.parametrize(
    "environment, is_spanish",
    [
        ({}, False),
        ({"LANG": "es_ES.UTF-8"}, True),
        ({"LANG": "es"}, True),
        ({"LANG": "C"}, False),
        ({"LANG": "es_ES.UTF-8", "LC_MESSAGES": "C"}, False),
        ({"LANG": "en_GB.UTF-8", "LC_MESSAGES": "es_AR"}, True),
        ({"LANG": "es_ES.UTF-8", "LC_MESSAGES": "es_ES.UTF-8", "LC_ALL": "C"}, False),
        ({"LANG": "C", "LC_MESSAGES": "C", "LC_ALL": "es_ES.UTF-8"}, True),
        ({"LANG": "es_ES.UTF-8", "LC_MESSAGES": "", "LC_ALL": ""}, True),
        ({"LC_NUMERIC": "es_ES.UTF-8"}, False),
    ],
)
def test_the_language_follows_the_environment(pendula, environment, is_spanish):
    assert pendula(text=BAD, env=environment).stderr.decode() == (SPANISH if is_spanish else ENGLISH)


def test_the_option_goes_before_the_environment(pendula):
    assert pendula("--lang", "es", text=BAD, env={"LC_ALL": "C"}).stderr.decode() == SPANISH
    assert pendula("--lang=en", text=BAD, env={"LC_ALL": "es_ES.UTF-8"}).stderr.decode() == ENGLISH


def test_the_option_may_stand_before_a_command(pendula):
    assert "falta --theta0" in pendula("--lang", "es", "solve").stderr.decode()
    assert "falta --theta0" in pendula("--lang=es", "solve").stderr.decode()
    assert "falta --theta0" in pendula("solve", "--lang", "es").stderr.decode()


def test_the_manual_names_every_option_in_both_languages(pendula):
    names = "theta0 omega0 alpha gravity length beta torque drive-amplitude pivot-amplitude drive-frequency drive-phase tau transient periods budget steps strobe-phase plane level direction match orbit-period carry locate shares details threads tolerance dt-factor dt every-factor every until-factor until method epsilon columns format precision output lang help version"
    for arguments in (["--help"], ["-h"], ["solve", "--help"], ["analyze", "-h"]):
        english, spanish = pendula(*arguments), pendula(*arguments, "--lang", "es")
        assert english.returncode == spanish.returncode == 0
        assert english.stdout != spanish.stdout
        for name in names.split():
            assert f"--{name}".encode() in english.stdout and f"--{name}".encode() in spanish.stdout
        assert max(len(line) for page in (english, spanish) for line in page.stdout.decode().splitlines()) <= 90


def test_the_version_is_one_line(pendula):
    done = pendula("--version")
    assert done.returncode == 0 and done.stdout.startswith(b"pendula ") and done.stdout.count(b"\n") == 1


@pytest.fixture(scope="session")
def decimal_commas(tmp_path_factory):
    """Environments of locales with decimal commas."""
    if not shutil.which("localedef") or not Path("/usr/share/i18n/locales/es_ES").exists():
        pytest.skip("not installed: localedef, the sources of locales")
    folder = tmp_path_factory.mktemp("locales")
    for name in ("es_ES", "de_DE"):
        subprocess.run(["localedef", "-i", name, "-f", "UTF-8", str(folder / f"{name}.UTF-8")], capture_output=True, check=True)
    return [{"LOCPATH": str(folder), "LC_ALL": name} for name in ("es_ES.UTF-8", "de_DE.UTF-8")]


def test_numbers_are_those_of_the_c_locale_everywhere(pendula, decimal_commas):
    for environment in decimal_commas:
        done = pendula(text=GOOD, env=environment)
        assert (done.returncode, done.stdout) == (0, pendula(text=GOOD).stdout)
        refused = pendula(text="0,5 0.5 1 1 r 0 r 1", env=environment)
        assert refused.returncode == 1 and b'"0.5"' in refused.stderr
        again = pendula("solve", "--theta0", "0.5", "--omega0", "1.5deg/s", env=environment)
        assert again.stdout == pendula("solve", "--theta0", "0.5", "--omega0", "1.5deg/s").stdout
