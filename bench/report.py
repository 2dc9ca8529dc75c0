"""Runs every case and its peers, in rounds, and writes docs/benchmarks.md.

    python bench/report.py BUILD OUT [--rounds N]

A round runs each case once: first pendula_bench, with the cases of pendula and the peers in C++, then the peers in Python, then
whole programs. The result is the smallest time of all rounds: processor time, or wall time for programs and threads.
A module of peers has `cases()`, which yields a name "case/peer", a call, and the number of items that a call computes.
"""

import argparse
import datetime
import importlib
import json
import os
import platform
import subprocess
import time
from pathlib import Path

import programs
from tables import TABLES, limits_table, ratio_table, tolerances_table

PEERS = ("peers", "peers_taylor", "python_bench")


def importable(names):
    """Yields the modules of peers that can be imported."""
    for name in names:
        try:
            yield importlib.import_module(name)
        except ModuleNotFoundError as error:
            print(f"left out: {name} ({error})", flush=True)


def native_round(build, least, facts):
    """Runs pendula_bench once: yields nanoseconds per item, and stores the other values that its cases report in `facts`."""
    done = subprocess.run(
        [build / "bench/pendula_bench", "--benchmark_format=json", f"--benchmark_min_time={least}"],
        check=True,
        capture_output=True,
        text=True,
    )
    report = json.loads(done.stdout)
    facts["context"] = report["context"]
    for case in report["benchmarks"]:
        name = "/".join(case["name"].split("/")[:2])
        facts[name] = {key: case[key] for key in ("error", "multiplications", "additions") if key in case}
        yield name, 1e9 / case["items_per_second"]


def python_round(cases, least):
    """Runs each case repeatedly for `least` seconds, and yields the smallest time per item."""
    for name, call, items in cases:
        start, best = time.thread_time(), float("inf")
        while best == float("inf") or time.thread_time() - start < least:
            before = time.thread_time_ns()
            call()
            best = min(best, time.thread_time_ns() - before)
        yield name, best / items


def program_round(cases, repetitions):
    for name, call in cases:
        often = 1 if name == "program_3.2/student" else repetitions  # takes seconds
        yield name, 1e9 * min(call() for _ in range(often))


def measure(build, rounds, least):
    modules = list(importable(PEERS))
    cases = [case for module in modules for case in module.cases()]
    facts = {"versions": {key: value for module in modules for key, value in module.VERSIONS.items()}}
    for _, call, _ in cases:
        call()  # compiles
    whole = list(programs.cases(build))
    best: dict[str, float] = {}
    for number in range(rounds):
        print(f"round {number + 1} of {rounds}", flush=True)
        for results in (
            native_round(build, least, facts),
            python_round(cases, least),
            program_round(whole, 10 if least else 1),
        ):
            for name, value in results:
                best[name] = min(value, best.get(name, value))
    for module in modules:
        for name, error in module.errors().items():
            facts[name] = {"error": error}
    return best, facts


def processor():
    info = Path("/proc/cpuinfo")
    names = (
        [line.split(":")[1].strip() for line in info.read_text().splitlines() if line.startswith("model name")]
        if info.exists()
        else []
    )
    return f"{len(names)} × {names[0]}" if names else platform.processor()


def page(best, facts, rounds):
    context = facts["context"]
    versions = (
        {name: context[name] for name in ("pendula", "Compiler", "Boost", "GSL")}
        | {"Python": platform.python_version()}
        | facts["versions"]
    )
    lines = [
        "# Benchmarks",
        "",
        "Made by `make bench`; do not edit. Ratios are what matters: how many times longer the peer takes. "
        f"Least of {rounds} rounds, in each of which every case and every peer runs once; processor time, wall time for programs and threads. "
        "C++ peers are compiled with `-O3 -march=native`; pendula is not, and chooses its kernels at run time, here "
        f"{context['kernels']}.",
        "",
        f"{processor()}, {platform.system()} {platform.machine()}, {datetime.date.today()}. "
        + ", ".join(f"{name} {version}" for name, version in versions.items())
        + ".",
    ]
    for table in TABLES:
        lines += ["", *ratio_table(table, best, facts)]
    lines += ["", *tolerances_table(best, facts)]
    lines += ["", *limits_table(best, facts)]
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("build", type=Path)
    parser.add_argument("out", type=Path)
    parser.add_argument("--rounds", type=int, default=20)
    parser.add_argument("--smoke", action="store_true", help="one round, of one call each")
    options = parser.parse_args()
    os.environ.pop("PENDULA_ISA", None)
    rounds, least = (1, 0) if options.smoke else (options.rounds, 0.03)
    best, facts = measure(options.build.resolve(), rounds, least)
    options.out.write_text(page(best, facts, rounds), encoding="utf-8")


if __name__ == "__main__":
    main()
