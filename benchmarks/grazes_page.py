"""The tallies of grazes as Markdown and as JSON."""

import json
from collections.abc import Sequence
from dataclasses import asdict

from benchmarks.grazes import BANDS, KINDS, OURS, Tally
from benchmarks.machine import facts
from benchmarks.peers import LEFT_OUT
from benchmarks.report import table

MATTERS = ("processor", "system", "python", "hoopgen", "numpy", "scipy", "heyoka")
"""Facts of the machine that the page gives; it has no speeds."""

COUNTS = ("touching", "passing", "undecided", "missed", "invented", "uncertain", "wrong_uncertain")


def as_json(tallies: Sequence[Tally]) -> str:
    """Every number."""
    return json.dumps([asdict(tally) for tally in tallies], indent=1) + "\n"


def _summed(tallies: Sequence[Tally], **wanted: object) -> dict[str, int]:
    """Counts of those tallies that are as wanted, together."""
    chosen = [t for t in tallies if all(getattr(t, n) == value for n, value in wanted.items())]
    return {name: sum(getattr(tally, name) for tally in chosen) for name in COUNTS}


def _people(tallies: Sequence[Tally]) -> list[str]:
    return list(dict.fromkeys(tally.who for tally in tallies))


def _range(band: int) -> str:
    least, most = BANDS[band]
    return f"{most:.0e} to {least:.0e} m".replace("e-0", "e-")


def summary(tallies: Sequence[Tally]) -> list[str]:
    """Return the table of missed and invented contacts by band, which the README shows too."""
    people = _people(tallies)
    head, rows = ["gap"], [[who] for who in people]
    for band in range(len(BANDS)):
        all_ = _summed(tallies, who=people[0], band=band)
        head += [
            f"{_range(band)}: missed of {all_['touching']:,}",
            f"invented of {all_['passing']:,}",
            "uncertain",
        ]
        for row in rows:
            own = _summed(tallies, who=row[0], band=band)
            uncertain = f"{own['uncertain']:,}" if row[0] in OURS else "–"
            row += [f"{own['missed']:,}", f"{own['invented']:,}", uncertain]
    return table(head, rows)


def _by_kind(tallies: Sequence[Tally], band: int) -> list[str]:
    people = _people(tallies)
    shots = [_summed(tallies, who=people[0], band=band, kind=kind.key) for kind in KINDS]
    rows = [["*touch, pass*", *(f"*{s['touching']}, {s['passing']}*" for s in shots)]]
    for who in people:
        cells = []
        for kind in KINDS:
            own = _summed(tallies, who=who, band=band, kind=kind.key)
            cell = f"{own['missed']}, {own['invented']}"
            cells.append(
                f"{cell} ({own['uncertain']}, {own['wrong_uncertain']})"
                if own["uncertain"]
                else cell
            )
        rows.append([who, *cells])
    return [f"## By kind, {_range(band)}", "", *table(["", *(k.label for k in KINDS)], rows)]


def as_markdown(tallies: Sequence[Tally]) -> str:
    """Return the report."""
    shots = _summed(tallies, who=_people(tallies)[0])
    number = shots["touching"] + shots["passing"] + shots["undecided"]
    lines = [
        "# Grazes",
        "",
        f"`python -m benchmarks --only grazes` creates {number:,} shots whose first contact "
        "depends on a gap of at most 1e-9 m, positive or negative. Some pass along the ring's "
        "wire, over it, outside or inside. Some pass through the plane of the board, or down "
        "through that of the bridge, beside an edge. Others rise beside the bridge to a highest "
        "point near its plane. The judge proves the result of each shot in ball arithmetic, "
        f"from the same doubles; it could not decide {shots['undecided']:,} of them.",
        "",
        "A contact is *missed* if it is proved and the method does not find it within 5e-4 s of "
        "its time. It is *invented* if the method finds it and it is proved not to exist. "
        "*Uncertain* shots are flagged by hoopgen and count as neither; the other methods have "
        "no such flag. Below 1e-13 m the gap is comparable to the last bits of the release. "
        "[Benchmarks](benchmarks.md) describes the other methods.",
        "",
        *summary(tallies),
        *(f"{line}.\n" for line in LEFT_OUT),
        "The following tables give the numbers of missed and invented contacts. Parentheses "
        "contain the number of uncertain shots, and how many of those would have been wrong.",
        "",
        *(line for band in range(len(BANDS)) for line in _by_kind(tallies, band)),
        *(f"{what}: {value}  " for what, value in facts().items() if what in MATTERS),
    ]
    return "\n".join(lines).rstrip() + "\n"
