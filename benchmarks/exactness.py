"""`python -m benchmarks.exactness`: the engine's results held against the judge's proofs.

Writes exactness.md and exactness.json. Exit status 1 if a shot that the engine did not flag is not
as the judge proves it to be, or is further from it than the engine claims.
"""

import argparse
import json
import sys
import time
from collections.abc import Mapping, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import asdict, dataclass, field
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
from flint import arb, ctx
from numpy.typing import NDArray

import hoopgen
from benchmarks.contact_errors import KINDS, ContactErrors
from benchmarks.court_exactness import (
    CHOSEN,
    PRESETS,
    CourtShares,
    CourtTally,
    court_section,
    court_shares,
    court_tally,
)
from benchmarks.decisions import HEAD, Decisions, together
from benchmarks.families import FAMILIES, Family
from benchmarks.machine import facts
from benchmarks.penetration import deepest
from benchmarks.report import number, section_of, table
from benchmarks.workloads import WORKLOADS
from hoopgen.core.files import write
from hoopgen.judge import Certificate, Proof, certify
from hoopgen.simulation.hoop import HOOP

ERRORS = ("time", "position", "velocity", "spin")
MAX_CONTACTS = 40
EXAMPLES = 5
HEADING = "## What is proved of the bounds"
"""A section of the page that is written by hand, and kept."""

CHUNK = 4096

Bools = NDArray[np.bool_]
Floats = NDArray[np.float64]


@dataclass
class Tally(Decisions):
    """The results of one family's shots; flags count of those that are not capped.

    `errors`: largest difference from the judge over the shots that are right and not flagged (s, m,
    m/s, rad/s); `ratios`: largest ratio of such a difference to the bound that the engine claims
    for it. `contact_errors`: the same after each contact, over the shots that are not flagged.
    `depths`: bounds on the deepest point inside ring, backboard, bridge (m), over
    `flights`.
    """

    errors: list[float] = field(default_factory=lambda: [0.0] * len(ERRORS))
    ratios: list[float] = field(default_factory=lambda: [0.0] * len(ERRORS))
    contact_errors: ContactErrors = field(default_factory=ContactErrors)
    flights: int = 0
    depths: list[float] = field(default_factory=lambda: [0.0] * len(hoopgen.SURFACES))
    seconds: float = 0.0
    examples: list[dict[str, Any]] = field(default_factory=list)


def tally(family: Family, shots: int, audited: int) -> Tally:
    """Fly and judge a family, chunk by chunk."""
    result = Tally(family.label)
    states, parameters = family.make(shots)
    started = time.perf_counter()
    for low in range(0, shots, CHUNK):
        rows = slice(low, min(low + CHUNK, shots))
        own = {name: value[rows] if np.ndim(value) else value for name, value in parameters.items()}
        _add(result, states[rows], own, max(0, min(audited - low, CHUNK)))
    result.seconds = time.perf_counter() - started
    return result


def _add(result: Tally, states: Floats, parameters: Mapping[str, Any], audited: int) -> None:
    flown = hoopgen.simulate(
        states,
        parameters,
        max_contacts=MAX_CONTACTS,
        fields=tuple(HOOP.layout.results),
        record=True,
    )
    proved = certify(states, parameters, max_contacts=MAX_CONTACTS, record=True)
    sure, same = ~flown.uncertain, _same(flown, proved) & proved.decided
    result.add(flown, proved, same, flown.outcome != hoopgen.Outcome.CAPPED)
    _differ(result, states, parameters, flown, proved, sure & same)
    for shot in np.flatnonzero(sure & ~same)[:EXAMPLES].tolist():
        text = proved[shot].question or "another sequence or outcome"
        _remember(result, text, states, parameters, shot)
    largest = result.contact_errors.add(flown, proved)
    for shot in np.flatnonzero(sure & same & (largest > 1))[:EXAMPLES].tolist():
        _remember(result, "bound broken at a contact", states, parameters, shot)
    _audit(result, flown, parameters, np.flatnonzero(sure[:audited]))


def _same(flown: hoopgen.Shots, proved: Certificate) -> Bools:
    """Return a mask of the shots whose outcome and sequence of surfaces agree."""
    starts = np.searchsorted(flown.events["shot"], np.arange(len(flown) + 1))
    surfaces = flown.events["surface"].tolist()
    sequences = (surfaces[a:b] for a, b in pairwise(starts.tolist()))
    return np.array(
        [
            int(outcome) == proof.outcome and sequence == proof.surfaces
            for outcome, sequence, proof in zip(
                flown.outcome.tolist(), sequences, proved.proofs, strict=True
            )
        ],
        np.bool_,
    )


def _differ(
    result: Tally,
    states: Floats,
    parameters: Mapping[str, Any],
    flown: hoopgen.Shots,
    proved: Certificate,
    which: Bools,
) -> None:
    """Compare times and states, and their differences with the bounds claimed for them."""
    which = which & (flown.outcome != hoopgen.Outcome.INVALID)
    off = np.abs(flown.state - proved.state) + np.nextafter(proved.state_radius, 0)
    late = np.abs(flown.time - proved.time) + np.nextafter(proved.time_radius, 0)
    errors = np.column_stack([late, off.reshape(-1, 3, 3).max(axis=2)])
    claimed = np.column_stack([flown.time_error, flown.state_error])
    # So far an error counts with the rounding of the proved value to a double; where that could
    # make the difference, the proved value is taken with all its digits.
    for shot in np.flatnonzero(which & (errors > claimed).any(axis=1)).tolist():
        errors[shot] = _errors(proved[shot], flown.time[shot], flown.state[shot])
    with np.errstate(divide="ignore", invalid="ignore"):
        ratios = np.where(errors > 0, errors / claimed, 0.0)
    for greatest, values in ((result.errors, errors), (result.ratios, ratios)):
        greatest[:] = np.maximum(greatest, values[which].max(axis=0, initial=0.0)).tolist()
    broken = np.flatnonzero(which & (ratios > 1).any(axis=1))
    for shot in broken[np.argsort(-ratios[broken].max(axis=1))][:EXAMPLES].tolist():
        names = [name for name, ratio in zip(ERRORS, ratios[shot], strict=True) if ratio > 1]
        _remember(result, f"bound broken: {', '.join(names)}", states, parameters, shot)


def _errors(proof: Proof, time: float, state: Floats) -> list[float]:
    """Return the errors of a computed time and state; without an event the state is the release."""
    if not proof.events:
        return [0.0] * len(ERRORS)
    last = proof.events[-1]
    with ctx.workprec(4 * proof.bits):
        balls = [part.ball for part in (last.time, *last.after)]
        off = [ball - arb(got) for ball, got in zip(balls, [time, *state.tolist()], strict=True)]
        away = [float(difference.abs_upper()) for difference in off]
    return [away[0], *(max(away[k : k + 3]) for k in (1, 4, 7))]


def _remember(
    result: Tally, text: str, states: Floats, parameters: Mapping[str, Any], shot: int
) -> None:
    """Keep a shot with all its digits."""
    if sum(example["what"] == text for example in result.examples) >= EXAMPLES:
        return
    own = {n: float(np.broadcast_to(v, len(states))[shot]).hex() for n, v in parameters.items()}
    state = [component.hex() for component in states[shot].tolist()]
    result.examples.append({"what": text, "state": state, "parameters": own})


def _audit(
    result: Tally, flown: hoopgen.Shots, parameters: Mapping[str, Any], shots: NDArray[np.int64]
) -> None:
    """Bound how deep the recorded flights go."""
    columns = np.stack([np.broadcast_to(parameters[n], len(flown)) for n in hoopgen.PAPER], axis=1)
    flights: list[tuple[list[float], float, list[float], int]] = []
    for shot in shots.tolist():
        path = flown.trajectory(shot)
        starts = np.concatenate([path.release[None], path.events["after"][:-1]])
        times = np.diff(path.events["time"], prepend=0.0)
        left = [-1, *path.events["surface"][:-1].tolist()]
        # A ball at rest starts anew at the same time; that is no flight.
        flights += [
            (start, duration, columns[shot].tolist(), surface)
            for start, duration, surface in zip(starts.tolist(), times.tolist(), left, strict=False)
            if duration > 0
        ]
    if flights:
        with ProcessPoolExecutor() as pool:
            depths = list(pool.map(deepest, *zip(*flights, strict=True), chunksize=64))
        result.depths = np.maximum(result.depths, np.max(depths, axis=0)).tolist()
        result.flights += len(flights)


def _small(value: float) -> str:
    return f"{value:.1e}" if value else "0"


def _decisions(tallies: Sequence[Tally]) -> list[str]:
    total = together("**together**", tallies)
    rows = [one.cells(one.shots - one.capped) for one in tallies]
    return table(HEAD, [*rows, total.cells(total.shots - total.capped, "**")])


def _numbers(tallies: Sequence[Tally]) -> list[str]:
    units = ("s", "m", "m/s", "rad/s")
    head = ["largest error, and its share of the claimed bound"]
    for name, unit in zip(ERRORS, units, strict=True):
        head += [f"{name} ({unit})", "of bound"]
    rows = []
    for t in tallies:
        row = [t.label]
        for error, ratio in zip(t.errors, t.ratios, strict=True):
            row += [_small(error), number(ratio) if ratio else "0"]
        rows.append(row)
    return table(head, rows)


def _at_contacts(tallies: Sequence[Tally]) -> list[str]:
    head = ["largest share of the bound after a contact", "contacts", "not proved", *KINDS]
    rows = []
    for t in tallies:
        at = t.contact_errors
        shares = (number(share) if share else "0" for share in at.shares)
        rows.append([t.label, f"{at.contacts:,}", f"{at.open:,}", *shares])
    return table(head, rows)


def _depths(tallies: Sequence[Tally]) -> list[str]:
    head = ["deepest (m), at most", "flights", *hoopgen.SURFACES]
    rows = [[t.label, f"{t.flights:,}", *map(_small, t.depths)] for t in tallies]
    return table(head, rows)


def as_markdown(
    tallies: Sequence[Tally],
    before: str = "",
    court: Sequence[CourtTally] = (),
    shares: Sequence[CourtShares] = (),
) -> str:
    """Return the report; of the page as it was before, the section written by hand is kept."""
    by_hand = section_of(before, HEADING) if f"{HEADING}\n" in before else []
    shots, wrong = sum(t.shots for t in tallies), sum(t.wrong for t in tallies)
    seconds = sum(t.seconds for t in tallies) + sum(t.seconds for t in court)
    lines = [
        "# Exactness",
        "",
        f"`make exactness` simulates {shots:,} shots twice. The engine uses doubles and flags "
        "shots with a contact that it cannot decide. The judge (`hoopgen.certify`) starts from "
        "the same doubles and uses ball arithmetic until every decision is proved: with 128 "
        "bits, and with more and more for the shots that these do not prove. The judge and the "
        "engine share the formulas in `derive/` and no numerical code. Among the shots that the "
        f"engine did not flag, **{wrong}** have a wrong result. Shots that break a promise are "
        "stored in `exactness.json`, with all digits.",
        "",
        "## Decisions",
        "",
        "A shot is *wrong* if its outcome or its sequence of surfaces differs from the proof. "
        "*Flagged* is the share of `uncertain` shots among those that are not capped at "
        f"{MAX_CONTACTS} contacts, and *flagged, wrong* the share that is flagged and would have "
        "been wrong. A shot is *undecidable* if 4,096 bits do not suffice for its proof: two "
        "contacts at the same time, an exact touch, or an exact edge. *Most bits* is the "
        "precision that the hardest shot needed.",
        "",
        *_decisions(tallies),
        "## Times and states",
        "",
        "The table gives the largest difference between the final times and states of the "
        "engine and of the judge, over the shots that the engine did not flag. The engine "
        "reports an error bound for each (`time_error`, `state_error`). A share of the bound "
        "above 1 would break this promise.",
        "",
        *_numbers(tallies),
        "The next table compares the times of all contacts, and the states after them, with the "
        "bounds that the event log has for them. Decisions about the next flight use the same "
        "bounds. "
        "Not proved are contacts after which a shot goes on otherwise than in the proof, or of "
        "which 4,096 bits prove nothing.",
        "",
        *_at_contacts(tallies),
        *court_section(court, shares),
        *by_hand,
        "## The ball never enters a surface",
        "",
        "The table covers recorded flights of shots that are not flagged, from each recorded "
        "state to the next event. The judge bounds the deepest point of every flight, also "
        "between its ends; nothing is sampled. The remaining depth is the rounding of the "
        "recorded states. Backboard and bridge are faces in this scene, so only a passage "
        "through a face counts, not a path around an edge.",
        "",
        *_depths(tallies),
        *(f"{what}: {value}  " for what, value in facts().items() if "peers" not in what),
        f"took: {seconds:.0f} s",
    ]
    return "\n".join(lines) + "\n"


def main() -> None:
    """Judge all families and write the report."""
    parser = argparse.ArgumentParser(
        prog="python -m benchmarks.exactness",
        description="The engine's results held against proofs in ball arithmetic.",
    )
    parser.add_argument("--shots", type=int, default=200_000, help="in all, default 200,000")
    parser.add_argument("--quick", action="store_true", help="5,000 shots, half a minute")
    parser.add_argument("--audited", type=int, default=500, help="shots a family, default 500")
    parser.add_argument("--families", nargs="+", choices=[f.key for f in FAMILIES])
    parser.add_argument("--out", type=Path, default=Path("docs"), help="folder, default docs")
    arguments = parser.parse_args()
    arguments.out.mkdir(parents=True, exist_ok=True)  # before the work, should it fail
    families = [f for f in FAMILIES if not arguments.families or f.key in arguments.families]
    shots = 5_000 if arguments.quick else arguments.shots
    audited = 50 if arguments.quick else arguments.audited
    # Workloads weigh as much as everything else together, as far as there is anything else.
    weights = [5 if f.workload else 1 for f in families]
    tallies = []
    for family, weight in zip(families, weights, strict=True):
        tallies.append(tally(family, -(-shots * weight // sum(weights)), audited))
        last = tallies[-1]
        print(f"{last.label}: {last.shots} shots, {last.wrong} wrong, {last.seconds:.0f} s")
    court = []
    for family in CHOSEN:
        court.append(court_tally(family, max(20, shots // 200)))
        print(f"{family.label}, the whole hoop: {court[-1].wrong} wrong")
    shares = [court_shares(w, preset, shots) for preset in PRESETS for w in WORKLOADS[1:]]
    numbers = json.dumps(
        [*map(asdict, tallies), *map(asdict, court), *map(asdict, shares)], indent=1
    )
    write(arguments.out / "exactness.json", numbers + "\n")
    page = arguments.out / "exactness.md"
    before = page.read_text("utf-8") if page.exists() else ""
    write(page, as_markdown(tallies, before, court, shares))
    broken = [t.wrong or t.unseen or max(*t.ratios, *t.contact_errors.shares) > 1 for t in tallies]
    sys.exit(any(broken) or not all(t.holds for t in court))


if __name__ == "__main__":
    main()
