"""`pendula check` tells right tables from wrong ones, and what is wrong, for programs of many styles and mistakes."""

import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from pendula import _command
from pendula.check import asked, decoded, judge, tables
from pendula.check._findings import FINDINGS

PROGRAMS = Path(__file__).with_name("check_programs")

QUARTER = "0.0001 0.02 1 90 s 0 r 1"
BACKWARDS = "0.0005 0.02 1 0.5 r -0.4 r 2.5"
SEPARATRIX = "0.0001 0.02 1 0 r -2 r 1"
ROTATION = "0.0001 0.02 1 0 r 2.01 r 1"
DEGREES = "0.0002 0.01 2 20 s -100 s 9.81"
NEAR = "0.0001 0.02 1 0 r 1.99 r 1"
ALL = (QUARTER, BACKWARDS, SEPARATRIX, ROTATION, DEGREES, NEAR)

# What estudiante.cpp does wrong, where it shows, and what is to be said of it.
MISTAKES = [
    ("grados_angulo", QUARTER, "theta0 in degrees"),
    ("grados_velocidad", DEGREES, "omega0 in degrees"),
    ("grados", DEGREES, "both in degrees"),
    ("como_grados_angulo", BACKWARDS, "theta0 as degrees"),
    ("como_grados_velocidad", SEPARATRIX, "omega0 as degrees"),
    ("como_grados", BACKWARDS, "both as degrees"),
    ("euler", QUARTER, "euler"),
    ("euler", SEPARATRIX, "euler"),
    ("euler_cromer", DEGREES, "euler cromer"),
    ("euler_cromer", SEPARATRIX, "euler cromer"),
    ("lineal", QUARTER, "straightened"),
    ("signo_velocidad", ROTATION, "other sign of omega0"),
    ("signo_angulo", BACKWARDS, "other sign of theta0"),
    ("signo_aceleracion", NEAR, "upside down"),
    ("raiz_alfa", DEGREES, "root of alpha"),
    ("alfa_cuadrado", BACKWARDS, "square of alpha"),
    ("sin_alfa", DEGREES, "alpha of 1"),
    ("un_paso_antes", QUARTER, "a step late"),
    ("un_paso_despues", ROTATION, "a step early"),
    ("una_fila_antes", QUARTER, "a row late"),
    ("una_fila_despues", SEPARATRIX, "a row early"),
    ("en_periodos", DEGREES, "times in periods"),
    ("tiempo_suelto", QUARTER, "times"),
    ("float", QUARTER, "single precision"),
    ("float", ROTATION, "single precision"),
    ("rozamiento", QUARTER, "unexplained"),
    ("una_fila", QUARTER, "one row"),
    ("desiguales", ROTATION, "uneven rows"),
    ("sin_primera", QUARTER, "late start"),
    ("sin_ultima", QUARTER, "last row lost"),
    ("una_de_mas", QUARTER, "last row won"),
    ("corta", SEPARATRIX, "early end"),
    ("larga", DEGREES, "late end"),
    ("periodo_doble", ROTATION, "period doubled"),
    ("medio_periodo", QUARTER, "period halved"),
    ("sin_serie", QUARTER, "series not begun"),
    ("sin_serie", ROTATION, "series not begun"),
    ("serie_corta", NEAR, "series cut"),
    ("serie_corta", DEGREES, "series cut"),  # short by 3e-6
    ("regimen", NEAR, "regime"),
    ("regimen", ROTATION, "regime"),
    ("segundos", QUARTER, "seconds"),
    ("cada_paso", DEGREES, "every step"),
    ("tau_diez", QUARTER, "tau"),
    ("sin_cabecera", QUARTER, "no header"),
    ("otra_cabecera", QUARTER, "other header"),
    ("dos_columnas", ROTATION, "columns"),
    ("hueco", QUARTER, "ragged"),
    ("nan", ROTATION, "not numbers"),
    ("sin_normalizar", ROTATION, "not normalised"),
    ("en_grados", NEAR, "angle in degrees"),
    ("velocidad_en_grados", QUARTER, "velocity in degrees"),
    ("pocas_cifras", QUARTER, "few digits"),
    ("cabecera_cambiada", BACKWARDS, "header order"),
    ("cambiadas", ROTATION, "swapped"),
    ("sin_seno", QUARTER, "sine missing"),
    ("seno_siempre", ROTATION, "sine too many"),
    ("fase_nan", QUARTER, "sine not numbers"),
    ("signo_fase", BACKWARDS, "sine other sign"),
    ("sin_fase", QUARTER, "sine no phase"),
    ("coseno", NEAR, "sine quarter turn"),
    ("amplitud_inicial", DEGREES, "sine initial amplitude"),
    ("seno_T0", QUARTER, "sine small period"),
    ("seno_doble", BACKWARDS, "sine double period"),
    ("seno_es_angulo", NEAR, "sine is the angle"),
    ("amplitud_mal", QUARTER, "sine unexplained"),
]
REMARKS = {"no header", "other header", "few digits", "last row lost", "last row won"}
COMPANIONS = {"cabecera_cambiada": {"other header"}, "cambiadas": {"no header"}, "dos_columnas": {"no header"}}


@pytest.fixture(scope="session")
def problems(tmp_path_factory):
    """Every problem as the program reads and solves it."""
    path = tmp_path_factory.mktemp("check") / "problems.txt"
    path.write_text("\n".join(ALL))
    with path.open() as file:
        return dict(zip(ALL, map(asked, _command.solve([], file)), strict=True))


@pytest.fixture(scope="session")
def compiled(tmp_path_factory):
    """The path of a program of check_programs, compiled once."""
    directory = tmp_path_factory.mktemp("programs")

    def build(source):
        compiler = shutil.which("g++" if source.endswith(".cpp") else "gcc")
        if compiler is None:
            pytest.skip("no compiler")
        target = directory / Path(source).stem
        if not target.exists():
            subprocess.run([compiler, "-O2", "-o", target, PROGRAMS / source, "-lm"], check=True, timeout=300)
        return target

    return build


@pytest.fixture(scope="session")
def written(compiled):
    """The tables that a program writes for some problems."""

    def run(source, *arguments, texts):
        command = [sys.executable, PROGRAMS / source] if source.endswith(".py") else [compiled(source)]
        given = "\n".join(texts).encode()
        done = subprocess.run([*command, *arguments], input=given, capture_output=True, check=True, timeout=300)
        return tables(decoded(done.stdout))

    return run


@pytest.mark.parametrize("source", ["estudiante.cpp", "bien.c", "bien_csv.py", "bien_hoja.py", "bien_fortran.py"])
def test_right_programs_of_all_styles_are_right(written, problems, source):
    found = written(source, texts=ALL)
    assert len(found) == len(ALL)
    for text, table in zip(ALL, found, strict=True):
        judgement = judge(problems[text], table)
        assert judgement.is_right, (text, judgement.findings)
        assert all(off.right == len(table.values) for off in judgement.deviations.values())


@pytest.mark.parametrize(("mistake", "problem", "name"), MISTAKES, ids=[f"{mistake}: {name}" for mistake, _, name in MISTAKES])
def test_a_mistake_is_told_and_no_other(written, problems, mistake, problem, name):
    (table,) = written("estudiante.cpp", mistake, texts=[problem])
    judgement = judge(problems[problem], table)
    assert {finding.name for finding in judgement.findings} == {name} | COMPANIONS.get(mistake, set())
    assert judgement.is_right == (name in REMARKS)


def test_every_diagnosis_has_a_program_that_makes_its_mistake():
    assert {name for _, _, name in MISTAKES} == FINDINGS.keys() - {"table missing"}


def test_mistakes_that_do_not_show_are_not_told(written, problems):
    for mistake, problem in [("periodo_doble", QUARTER), ("grados", ROTATION), ("signo_fase", QUARTER), ("raiz_alfa", NEAR)]:
        (table,) = written("estudiante.cpp", mistake, texts=[problem])
        assert judge(problems[problem], table).is_right, mistake


@pytest.mark.parametrize(
    ("mistakes", "problem", "names"),
    [
        ("euler+sin_cabecera", QUARTER, {"euler", "no header"}),
        ("euler+sin_normalizar", ROTATION, {"euler", "not normalised"}),
        ("grados+serie_corta", QUARTER, {"theta0 in degrees", "series cut"}),
        ("periodo_doble+sin_normalizar", ROTATION, {"period doubled", "not normalised"}),
        ("corta+signo_fase", BACKWARDS, {"early end", "sine other sign"}),
    ],
)
def test_two_mistakes_are_both_told(written, problems, mistakes, problem, names):
    (table,) = written("estudiante.cpp", mistakes, texts=[problem])
    assert {finding.name for finding in judge(problems[problem], table).findings} == names


@pytest.mark.parametrize("precision", [4, 6, 10, "full"])
def test_the_programs_own_tables_are_right_at_any_precision(program, problems, precision):
    for text, table in zip(ALL, tables(program("--precision", str(precision), text="\n".join(ALL))), strict=True):
        judgement = judge(problems[text], table)
        assert judgement.is_right, (text, judgement.findings)


def test_the_closed_form_is_as_right_as_runge_kutta_at_a_long_step(program, tmp_path):
    text = "0.05 0.1 3 2.5 r 0 r 1"
    (tmp_path / "problem").write_text(text)
    with (tmp_path / "problem").open() as file:
        problem = asked(_command.solve([], file)[0])
    for method in ("rk4", "exact"):
        judgement = judge(problem, tables(program("--method", method, text=text))[0])
        assert judgement.is_right, method
    # At this step Runge-Kutta is off by more than the table's digits: the report tells the two apart.
    assert judgement.deviations["theta"].from_rk4 > 1e-3 > judgement.deviations["theta"].from_exact


def test_one_digit_that_is_wrong_makes_a_table_wrong(program, problems):
    text = program(text=QUARTER).replace("1.5268", "1.5267")
    (finding,) = judge(problems[QUARTER], tables(text)[0]).findings
    assert (finding.name, finding.values["line"], finding.values["value"]) == ("unexplained", 4, 1.5267)
