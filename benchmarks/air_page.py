"""The measured flights in air as a page."""

from benchmarks.air import DISTANCES, METHODS, Results
from benchmarks.machine import facts
from benchmarks.report import number, short, table

MATTERS = ("processor", "cores used", "system", "python", "hoopgen", "numpy", "scipy", "heyoka")
"""Facts of the machine that the page gives."""

LABELS = {
    "hoopgen": "hoopgen C, 1 thread, all fields",
    "hoopgen_three": "hoopgen C, 1 thread, three fields",
    "airless": "hoopgen C, 1 thread, all fields, without air",
    **METHODS,
}


def _speeds(results: Results) -> list[str]:
    rows = []
    for key, rates in results.rates.items():
        times = results.times(key)
        ratio = f"{number(times.median)} ({number(times.lower)}–{number(times.upper)})"
        rows.append([LABELS[key], short(rates.spread.median), ratio])
    return table(["", "shots a second", "time of a shot, hoopgen = 1"], rows)


def _errors(results: Results) -> list[str]:
    rows = []
    for title, errors in (("proved", results.proved), ("certain", results.compared)):
        for key, one in errors.items():
            rows.append(
                [
                    f"{LABELS[key]}; {one.shots} {title}",
                    f"{round(one.wrong_outcome * one.shots)}",
                    f"{round(one.wrong_sequence * one.shots)}",
                    f"{one.time_median:.0e}",
                    f"{one.time_95:.0e}",
                ]
            )
    head = ["", "wrong outcome", "wrong sequence", "error in time (s), median", "95%"]
    return table(head, rows)


def _grazes(results: Results) -> list[str]:
    rows = [
        [LABELS[key], f"{one.missed}", f"{one.invented}", f"{one.uncertain}"]
        for key, one in results.grazes.items()
    ]
    return table(["", "missed", "invented", "uncertain"], rows)


def as_markdown(results: Results) -> str:
    """Return the page."""
    some = results.grazes["hoopgen"]
    in_air, without = results.contacts
    airless = results.times("airless").median
    lines = [
        "# Flights in air beside other programs",
        "",
        '`make bench ARGS="--only air"` writes this page; `benchmarks_air.json` contains the '
        "numbers. [Air](air.md) describes the scene, `AIR` with `PAPER_AIR`. All fly the same "
        "equations and the same contacts, of which the peers' code shares nothing with hoopgen. "
        "Peers that are not installed are left out.",
        "",
        *(f"{line}.\n" for line in results.absent),
        "## Speed",
        "",
        "The throws are the free throws (W2) of [Benchmarks](benchmarks.md), all of them faster by "
        "the share that takes the mean throw through the ring's centre again. In each round "
        "everybody has a turn, and the times are compared round by round: median and quartiles. "
        "The machine may have been shared, so compare the ratios. heyoka.py flies in C, but each "
        "of its events, which are terminal, returns to Python, where the contact is computed; all "
        "of SciPy is in Python. hoopgen's time includes the bounds on its errors.",
        "",
        *_speeds(results),
        "",
        f"In air a shot takes {number(1 / airless)} times as long as the same throw at its own "
        f"speed without air. A throw has {in_air:.2f} contacts in air and {without:.2f} without; "
        "no more than 40 of a throw are flown.",
        "",
        "## Errors",
        "",
        "Outcomes, sequences of surfaces and times at the end, first on throws whose answers are "
        "proved in ball arithmetic, then on more throws, for which hoopgen's answers that are not "
        "`uncertain` are taken as right. A missed contact is a wrong sequence.",
        "",
        *_errors(results),
        "",
        "## Grazes",
        "",
        f"{some.touching} throws touch the ring first, and {some.passing} others pass it, all "
        "proved in ball arithmetic; their speeds differ from the border between the two by a share "
        f"of {DISTANCES[0]:.0e} to {DISTANCES[1]:.0e}. A contact is missed if it is not found "
        "within 5e-4 s of its time, and invented if one is found where none is. Throws that "
        "hoopgen flags as `uncertain` count as neither; the peers have no such flag. solve_ivp "
        "looks for changes of sign between the ends of its steps, and such a touch is over sooner "
        "than a step.",
        "",
        *_grazes(results),
        "",
        *(f"{name}: {value}  " for name, value in facts().items() if name in MATTERS),
    ]
    return "\n".join(lines).rstrip() + "\n"
