"""The tables of docs/benchmarks.md: the cases of each table, and the goals for their ratios."""

from dataclasses import dataclass, field


@dataclass(frozen=True)
class Table:
    title: str
    note: str
    unit: str
    scale: float  # nanoseconds in the unit
    peers: dict  # peer in the names of cases: its name on the page
    rows: dict  # case: its description
    goals: dict = field(default_factory=dict)  # (case, peer): goal for the ratio


TABLES = [
    Table(
        "Characteristic time near the separatrix",
        "τ of figure 3.2, to 4 ulp, beside the assignment's series (3.6) with its cut (3.9) for 1e−7.",
        "µs",
        1e3,
        {"series": "series"},
        {"tau": "θ = 0, ω = 1.999999895801368"},
        {("tau", "series"): 10000},
    ),
    Table(
        "Exact samples",
        "θ and ω at 1,000 times of one oscillation, one core. The error is the largest of θ [rad] and ω [of its maximum] over the known "
        "answers with κ' from 1e−12 to 1e−2 and t up to 30 τ.",
        "ns",
        1,
        {"boost": "Boost `jacobi_elliptic`", "gsl": "GSL `gsl_sf_elljac_e`", "scipy": "SciPy `ellipj`"},
        {"samples": "amplitude 60°", "samples_near": "figure 3.2"},
        {
            (case, peer): least
            for case in ("samples", "samples_near")
            for peer, least in (("boost", 20), ("gsl", 6), ("scipy", 20))
        },
    ),
    Table(
        "Runge–Kutta, one trajectory",
        "A step.",
        "ns",
        1,
        {"formulas": "(3.10) with libm", "odeint": "Boost.Odeint `runge_kutta4`"},
        {
            "rk4_fine": "10,000 steps a period",
            "rk4_middle": "1,000",
            "rk4_coarse": "100",
            "rk4_driven": "friction and drive, 3,000",
            "rk4_driven_coarse": "friction and drive, 130",
        },
        {("rk4_fine", "formulas"): 1.5, ("rk4_fine", "odeint"): 1.5},
    ),
    Table(
        "Runge–Kutta, ensembles",
        "A step of one of 256 pendulums, one core. Odeint's state is all of them, Numba's inner loop is over them, with `fastmath`: their fastest "
        "forms. They take the drive's cosine once for all; pendula's members have each their own.",
        "ns",
        1,
        {"odeint": "Boost.Odeint", "numba": "Numba"},
        {
            "rk4_ensemble_fine": "10,000 steps a period",
            "rk4_ensemble_middle": "1,000",
            "rk4_ensemble_coarse": "100",
            "rk4_ensemble_driven": "friction and drive, 3,000",
            "rk4_ensemble_driven_coarse": "friction and drive, 130",
        },
        {("rk4_ensemble_fine", "odeint"): 10, ("rk4_ensemble_fine", "numba"): 14},
    ),
    Table(
        "Taylor, one trajectory",
        "A unit of time (1/√α) at a tolerance of 1e−15.",
        "ns",
        1,
        {"heyoka": "heyoka"},
        {"taylor_undamped": "undamped", "taylor_driven": "friction and drive"},
        {("taylor_undamped", "heyoka"): 1, ("taylor_driven", "heyoka"): 1},
    ),
    Table(
        "Taylor, ensembles",
        "A unit of time of one of 256 pendulums, one core, at a tolerance of 1e−15; heyoka in batches of the size that it recommends. The error "
        "is the largest against 50 digits, of twenty driven pendulums, half of them chaotic, up to t = 50.",
        "ns",
        1,
        {"heyoka": "heyoka"},
        {"taylor_ensemble_undamped": "undamped", "taylor_ensemble_driven": "friction and drive"},
        {("taylor_ensemble_undamped", "heyoka"): 2, ("taylor_ensemble_driven", "heyoka"): 2},
    ),
    Table(
        "Threads",
        "A step of one of 8,192 pendulums on two threads.",
        "ns",
        1,
        {"one": "one thread"},
        {"threads": "10,000 steps a period"},
        {("threads", "one"): 1.9},
    ),
    Table(
        "From Python",
        "A call with one value, beside a ufunc of numpy; a value of a million; a row of 501 over ten periods by `taylor` at 1e−15 (SciPy: DOP853 "
        "at 1e−13); a step of one of 256 pendulums by `rk4`, one thread.",
        "ns",
        1,
        {"ufunc": "NumPy `hypot`", "scipy": "SciPy `ellipj`, `solve_ivp`", "numba": "Numba", "heyoka": "heyoka"},
        {
            "python_call": "`exact`, one value",
            "python_exact": "`exact`, 10⁶ values",
            "python_rk4": "`solve`, 256 pendulums",
            "python_solve": "`solve`, one trajectory",
        },
    ),
    Table(
        "The whole program",
        "From the start of the process to its end, beside a plain student's (bench/student.cpp, `-O3 -march=native`).",
        "ms",
        1e6,
        {"student": "student's"},
        {f"program_{figure}": f"figure {figure}" for figure in ("3.1", "3.2", "3.3", "3.4")},
        {(f"program_{figure}", "student"): 50 if figure == "3.2" else 1 for figure in ("3.1", "3.2", "3.3", "3.4")},
    ),
]

KERNELS = {"rk4": "Runge–Kutta", "taylor": "Taylor"}


def ratio(best, case, peer, goals):
    if f"{case}/{peer}" not in best:
        return ""
    times = best[f"{case}/{peer}"] / best[f"{case}/pendula"]
    shown = f"{times:,.0f}" if times >= 100 else f"{times:.1f}" if times >= 10 else f"{times:.2f}"
    least = goals.get((case, peer))
    return f"**{shown} ×**" + ("" if least is None else f" (goal: {least:,})")


def error_of(facts, case, side):
    error = facts.get(f"{case}/{side}", {}).get("error")
    return "" if error is None else f"{error:.0e}"


def ratio_table(table, best, facts):
    lines = [
        f"## {table.title}",
        "",
        table.note,
        "",
        "| | pendula [" + table.unit + "] | " + " | ".join(table.peers.values()) + " |",
        "|---|" + "---:|" * (len(table.peers) + 1),
    ]
    for case, name in table.rows.items():
        if f"{case}/pendula" in best:
            cells = [
                f"{best[f'{case}/pendula'] / table.scale:.3g}",
                *(ratio(best, case, peer, table.goals) for peer in table.peers),
            ]
            lines.append(f"| {name} | " + " | ".join(cells) + " |")
    for case in table.rows:
        errors = [error_of(facts, case, side) for side in ("pendula", *table.peers)]
        if all(errors[:1]) and case == list(table.rows)[-1]:
            lines.append("| largest error | " + " | ".join(errors) + " |")
    return lines


def limit(best, operations):
    """The smallest time for these numbers of multiplications and additions, by the throughput measured in the same run."""
    products, sums = operations["multiplications"], operations["additions"]
    return max(products * best["pipes/multiplications"], sums * best["pipes/additions"], (products + sums) * best["pipes/both"])


def limits_table(best, facts):
    lines = [
        "## How near the limit",
        "",
        "Multiplications and additions that the results of a step go back to, counted in the kernels' own text, and the least time that this "
        "processor's pipes need for them: measured in the same run, with independent operations in the widest registers and nothing else. "
        f"Here they do {1 / best['pipes/both']:.3g} a nanosecond. One trajectory is bound by the latency of one operation after another.",
        "",
        "| | multiplications | additions | limit [ns] | reached [ns] | fraction |",
        "|---|---:|---:|---:|---:|---:|",
    ]
    for case, operations in facts.items():
        kind, ending = case.split("_")[0], case.split("/")[-1]
        if kind in KERNELS and "ensemble" in case and ending == "pendula":
            least, reached = limit(best, operations), best[case]
            name = next(row for table in TABLES for key, row in table.rows.items() if f"{key}/pendula" == case)
            lines.append(
                f"| {KERNELS[kind]}: {name} | {operations['multiplications']:.0f} | {operations['additions']:.0f} | {least:.2f} | {reached:.2f} | "
                f"{100 * least / reached:.0f} % |"
            )
    return lines


TOLERANCES = ("1e-15", "1e-12", "1e-10", "1e-9", "1e-8", "1e-6", "1e-4")


def tolerances_table(best, facts):
    runs = {"undamped": "undamped", "driven": "friction and drive"}
    cases = {
        f"{kind}{run}": f"{title}, {name}"
        for kind, title in (("", "one"), ("ensemble_", "of 256"))
        for run, name in runs.items()
    }
    lines = [
        "## Taylor, by tolerance",
        "",
        "A unit of time (1/√α) of one trajectory and of one of 256 pendulums [ns], one core, and its part of the time at 1e−15. The error is the "
        "largest against 50 digits, of twenty driven pendulums, half of them chaotic, up to t = 50.",
        "",
        "| tolerance | " + " | ".join(cases.values()) + " | largest error |",
        "|---|" + "---:|" * (len(cases) + 1),
    ]
    for tolerance in TOLERANCES:
        cells = []
        for case in cases:
            time, tightest = (best[f"tolerance_{each}_{case}/pendula"] for each in (tolerance, TOLERANCES[0]))
            cells.append(f"{time:.3g} ({100 * time / tightest:.0f} %)")
        cells.append(error_of(facts, f"tolerance_{tolerance}_undamped", "pendula"))
        lines.append(f"| {tolerance.replace('-', '−')} | " + " | ".join(cells) + " |")
    return lines
