"""The results as Markdown and as JSON."""

import json
import math
from collections.abc import Iterable, Sequence
from dataclasses import asdict

from benchmarks.contenders import CORES, contenders
from benchmarks.machine import BYTES_A_SHOT
from benchmarks.peers import LEFT_OUT, PEERS
from benchmarks.run import Results
from benchmarks.timing import Spread
from benchmarks.workloads import WORKLOADS
from hoopgen.text.numbers import format_percent

_RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")

ARTICLE = {"event-driven": (0.0001, 0.0027), "time stepping": (0.0109, 0.0285)}
"""The article's Table 4, swish and bouncing (s)."""


def as_json(results: Results) -> str:
    """Every number, with the rounds behind it."""
    return json.dumps(asdict(results), indent=1) + "\n"


def table(head: Sequence[str], rows: Iterable[Sequence[str]]) -> list[str]:
    """Return a Markdown table, its first column to the left and the others to the right."""
    rule = ["---"] + ["---:"] * (len(head) - 1)
    return [f"| {' | '.join(row)} |" for row in (head, rule, *rows)] + [""]


def section_of(page: str, heading: str) -> list[str]:
    """Return the lines of a section of a page."""
    return [heading, *page.split(f"{heading}\n")[1].partition("\n## ")[0].split("\n")]


def with_section(page: str, lines: Sequence[str]) -> str:
    """Return a page with other lines of a section, the first of which is its heading."""
    before, rest = page.split(f"{lines[0]}\n")
    after = rest.partition("\n## ")[2]
    return before + "\n".join(lines) + f"\n## {after}"


def number(value: float) -> str:
    """Three significant digits, thousands apart, no exponent at 1 or above."""
    if not 0.1 <= abs(value) < float("inf"):
        return f"{value:.3g}"
    if abs(value) < 1:
        return f"{value:.3f}"
    decimals = max(0, 3 - len(f"{abs(value):.0f}"))
    return f"{value:,.{decimals}f}"


def _unit(rate: float) -> tuple[float, str]:
    for unit, name in ((1e6, " M"), (1e3, " k")):
        if rate >= unit:
            return unit, name
    return 1.0, ""


def short(rate: float) -> str:
    """Three digits and k or M."""
    unit, name = _unit(rate)
    return number(rate / unit) + name


def power(value: float) -> str:
    """Format a power of ten; the house's pictures have no other formulas."""
    return f"10{f'{round(math.log10(value))}'.translate(_RAISED)}"


def _rate(spread: Spread) -> str:
    """Format shots per second with the quartiles."""
    unit, _ = _unit(spread.median)
    return f"{short(spread.median)} ({number(spread.lower / unit)}–{number(spread.upper / unit)})"


def _ratio(spread: Spread) -> str:
    return f"{number(spread.median)} ({number(spread.lower)}–{number(spread.upper)})"


def _time(seconds: float) -> str:
    for unit, name in ((1.0, "s"), (1e-3, "ms"), (1e-6, "µs"), (1e-9, "ns")):
        if seconds >= unit:
            return f"{number(seconds / unit)} {name}"
    return f"{seconds:.1e} s"


def _times(spread: Spread) -> str:
    return f"{_time(spread.median)} ({_time(spread.lower)}–{_time(spread.upper)})"


def _speed(results: Results) -> list[str]:
    head = ["", *(f"{w.key} {w.label}" for w in WORKLOADS)]
    rates = results.rates
    rows = [
        [one.label, *(_rate(rates[w.key][one.key].spread) for w in WORKLOADS)]
        for one in contenders()
    ]
    ours = {w.key: rates[w.key]["c_one"] for w in WORKLOADS}
    ratios = [
        [one.label, *(_ratio(ours[w.key].over(rates[w.key][one.key])) for w in WORKLOADS)]
        for one in contenders()
        if one.family != "hoopgen" or one.key in ("numpy", "court")
    ]
    pairs = [("c_many", "c_one", "three results"), ("c_many_all", "c_one_all", "all fields")]
    threads = [
        [label, *(_ratio(rates[w.key][many].over(rates[w.key][one])) for w in WORKLOADS)]
        for many, one, label in pairs
    ]
    shots = [
        ["contacts a shot", *(number(results.work[w.key].contacts) for w in WORKLOADS)],
        [
            "uncertain shots of hoopgen",
            *(format_percent(results.work[w.key].uncertain, 2) for w in WORKLOADS),
        ],
        *(
            [f"shots a turn, {one.label}", *(f"{rates[w.key][one.key].shots:,}" for w in WORKLOADS)]
            for one in contenders()
        ),
    ]
    return [
        "## Shots a second",
        "",
        "Median and quartiles over the rounds; each method is timed once per round. hoopgen "
        "returns outcome, contacts and time, as the other methods do, and computes no error "
        "bounds; or it returns all fields, including `uncertain`, which needs the error bounds.",
        "",
        *table(head, rows),
        "## How many times as fast hoopgen C is, on one thread",
        "",
        "Both sides use one thread. The ratios are those of the same round.",
        "",
        *table(head, ratios),
        f"## {CORES} threads over one",
        "",
        *table(head, threads),
        "## The work",
        "",
        *table(head, shots),
    ]


def _errors(results: Results) -> list[str]:
    def row(label: str, key: str, workload: str) -> list[str]:
        error = results.errors[workload][key]
        return [
            f"{workload} {label}",
            f"{error.shots:,}",
            format_percent(error.wrong_outcome, 2),
            format_percent(error.wrong_sequence, 2),
            f"{error.time_median:.1e}",
            f"{error.time_95:.1e}",
        ]

    judged = {"hoopgen": "hoopgen", **{peer.key: peer.label for peer in PEERS}}
    return [
        "## Errors",
        "",
        f"The reference is {results.judge}. The error in time covers shots whose outcome and "
        "sequence of surfaces are right.",
        "",
        *table(
            ["", "shots", "wrong outcome", "wrong sequence", "time, median (s)", "time, 95% (s)"],
            [row(label, key, w.key) for w in WORKLOADS for key, label in judged.items()],
        ),
    ]


def _calls(results: Results) -> list[str]:
    sizes = list(next(iter(results.flatness.values())))
    return [
        "## Cost of a shot by their number, W2",
        "",
        *table(
            [
                "shots",
                *(
                    f"{threads} threads" if threads > 1 else "1 thread"
                    for threads in results.flatness
                ),
            ],
            [
                [f"{size:,}", *(_times(costs[size]) for costs in results.flatness.values())]
                for size in sizes
            ],
        ),
        "## Zeno accumulation and rolls",
        "",
        "`COURT` follows the free throws to their end that `HOOP` caps after 40 contacts. On "
        f"one thread such a free throw takes {_times(results.settled)}, and a million of them "
        f"{_time(1e6 * results.settled.median)}.",
        "",
        "## One shot",
        "",
        "The first table gives the time of a call through the Python interface, with all "
        "fields, in a warm process. The second gives the time of the first shot in a new "
        "process.",
        "",
        *table(["", "a call"], [[name, _times(cost)] for name, cost in results.single.items()]),
        *table(["new process", ""], [[name, _times(cost)] for name, cost in results.first.items()]),
    ]


def _table_4(results: Results) -> list[str]:
    rows = [
        [f"article, {method}, MATLAB", _time(swish), "", _time(bouncing), ""]
        for method, (swish, bouncing) in ARTICLE.items()
    ]
    for method, shots in results.table_4.items():
        cells = [method]
        for shot in ("swish", "bouncing"):
            timed = shots[shot]
            cells.append(f"{_time(timed.mean)} ± {_time(timed.deviation)}")
            cells.append(f"{_time(timed.mean_of_many)} ({timed.count:,})")
        rows.append(cells)
    head = ["", "swish", "more runs", "bouncing", "more runs"]
    return [
        "## The article's Table 4",
        "",
        "The times are those of one shot per call from Python, timed run by run: mean ± "
        "standard deviation of 100 runs, as in the article, and the mean of more runs. Machine "
        "and language differ from the article's.",
        "",
        *table(head, rows),
    ]


def _limits(results: Results) -> list[str]:
    limits = results.limits
    machine = [
        [
            f"{threads} threads" if threads > 1 else "1 thread",
            f"{number(limits.bandwidth[threads] / 1e9)} GB/s",
            f"{number(limits.operations[threads] / 1e9)} GFlop/s",
            f"{number(limits.fused[threads] / 1e9)} GFlop/s",
            f"{number(limits.divisions[threads] / 1e9)} G/s",
            f"{number(limits.roots[threads] / 1e9)} G/s",
        ]
        for threads in limits.bandwidth
    ]
    rows = []
    for workload in WORKLOADS:
        rate = results.rates[workload.key]["c_many"].spread.median
        moved = rate * BYTES_A_SHOT
        cells = [
            f"{workload.key} {workload.label}",
            _time(1 / rate),
            f"{BYTES_A_SHOT}",
            f"{number(moved / 1e9)} GB/s",
            format_percent(moved / limits.bandwidth[CORES]),
        ]
        counts = results.work[workload.key].counts
        if counts is None:
            cells += ["not counted"] * 4
        else:
            arithmetic = rate * counts.operations / limits.operations[CORES]
            divider = rate * (
                counts.divisions / limits.divisions[CORES] + counts.roots / limits.roots[CORES]
            )
            slow = counts.divisions + counts.roots
            cells += [number(counts.operations), format_percent(arithmetic)]
            cells += [number(slow), format_percent(divider)]
        rows.append(cells)
    head = ["", "a shot", "bytes", "moved", "of the bandwidth", "operations", "of the peak"]
    head += ["divisions, roots", "of the divider"]
    return [
        "## The limits",
        "",
        "The memory bandwidth is that of STREAM's triad. The rates of arithmetic are those of "
        "multiplications and additions in registers, separate and fused.",
        "",
        *table(["", "memory", "apart", "fused", "divisions", "roots"], machine),
        f"The table is for hoopgen C with {CORES} threads and the fields outcome, contacts and "
        "time. *Bytes* are the state read and the results written. *Operations* are the + - * / "
        "and square roots of the kernels for a single shot; the table does not count operations "
        "that lanes execute only because other lanes need them. *Of the peak* is relative to "
        "separate multiplications and additions. *Of the divider* is the share of the time that "
        "the divisions and square roots alone would take if all were in double precision.",
        "",
        *table(head, rows),
        "The last table describes the search on the ring: the number of evaluations of its "
        "condition, and the share of busy lanes of the widest vector after the first "
        "evaluation, in which all lanes take part.",
        "",
        *table(["", "evaluations a shot", "a contact", "lanes busy"], _searches(results)),
    ]


def _searches(results: Results) -> list[list[str]]:
    rows = []
    for workload in WORKLOADS:
        work = results.work[workload.key]
        if work.counts is None:
            cells = ["not counted"] * 3
        else:
            each = work.counts.evaluations
            a_contact = number(each / work.contacts) if work.contacts else "none"
            busy = format_percent(work.counts.busy) if each else "none"
            cells = [number(each), a_contact, busy]
        rows.append([f"{workload.key} {workload.label}", *cells])
    return rows


def as_markdown(results: Results) -> str:
    """Tables for readers."""
    lines = [
        "# Benchmarks",
        "",
        "`python -m benchmarks` writes this page; `benchmarks.json` contains the numbers of "
        "every round. [Grazes](grazes.md) compares the methods on shots that graze.",
        "",
        "![Shots a second](benchmarks.svg)",
        "",
        *table(["", ""], [[name, f"`{value}`"] for name, value in results.facts.items()]),
        *_speed(results),
        *_errors(results),
        "The other methods (peers) simulate the same model and the same shots:",
        "",
        *(f"- {peer.label}: {peer.what}" for peer in PEERS),
        *(f"- {line}" for line in LEFT_OUT),
        "",
        *_table_4(results),
        *_calls(results),
        *_limits(results),
    ]
    return "\n".join(lines).rstrip("\n") + "\n"
