"""The page docs/real-shots.md: `python -m benchmarks.real_shots FOLDER [--write]`.

FOLDER is a copy of SPL-Open-Data; see `benchmarks.real_throws`.
"""

from __future__ import annotations

import argparse
from dataclasses import replace
from pathlib import Path

import numpy as np

import hoopgen
from hoopgen import COURT, COURT_AIR, HOOP, NBA, NBA_COURT, NBA_COURT_AIR
from hoopgen.core.units import DEGREE, INCH, TURN
from hoopgen.text.numbers import format_interval

from .real_throws import (
    BACKSPIN,
    DRAWS,
    ERRORS,
    RESTITUTIONS,
    Throws,
    always,
    fitted,
    interval,
    log_terms,
    logistic,
    profile,
    read,
    row,
    shares,
    states,
)

PAGE = Path(__file__).parents[1] / "docs" / "real-shots.md"

_HEAD = (
    "|  | right | predicted to be made | log-likelihood | Brier score |\n"
    "| --- | ---: | ---: | ---: | ---: |"
)

_FRICTIONS = np.arange(0.1, 1.01, 0.1)


def _moved(throws: Throws, by: float) -> Throws:
    """Return the throws with the places at the ring moved away from the board."""
    return replace(throws, landing=throws.landing + np.array([by, 0.0]))


_SPINS = np.arange(0.0, 5.01, 0.5)
_JOINT = np.arange(0.40, 0.851, 0.05)
_BOTH = 3.0
"""Half the 95% quantile of the chi-square distribution with two degrees of freedom."""


def _by_hand(throws: Throws) -> list[str]:
    """Return right predictions of single shots without errors, by the origin and the height."""
    rows = []
    for label, by in (("outer edge", 1.0), ("middle", 0.0), ("inner edge", -1.0)):
        moved = _moved(throws, by * NBA["wire_radius"])
        level = np.array(moved.release)
        level[:, 2] = 2.2 - 3.048
        cells = []
        for one in (moved, replace(moved, release=level)):
            start = states(one, 1, BACKSPIN, 0.0)[:, 0]
            for values, scene in ((NBA_COURT, COURT), (NBA, HOOP)):
                made = hoopgen.simulate(start, values, scene=scene).made
                cells.append(f"{int((made == throws.made).sum())}")
        rows.append(f"| {label} | {' | '.join(cells)} |")
    return rows


def _joint(throws: Throws) -> str:
    """Return in words the likeliest backspin and restitution of the ring, together."""
    found, made = [], []
    for hertz in _SPINS:
        released = states(throws, DRAWS, hertz * TURN)
        for value in _JOINT:
            own = {"ring_restitution": float(value), "bridge_restitution": float(value)}
            p = shares(released, NBA_COURT | own, COURT)
            found.append(float(log_terms(p, throws.made).sum()))
            made.append(float(p.sum()))
    whole, count = np.array(found), len(_JOINT)
    best = int(np.argmax(whole))
    near = np.flatnonzero(whole >= whole[best] - _BOTH)
    spins, values = _SPINS[near // count], _JOINT[near % count]
    some = np.array(made)[near]
    return (
        f"Together the likeliest are {_SPINS[best // count]:g} Hz and a restitution of the ring of "
        f"{_JOINT[best % count]:.2g}, with {made[best]:.1f} made throws and a log-likelihood of "
        f"−{-whole[best]:.1f}. The pairs in the 95% region, on a grid of 0.5 Hz and 0.05, go from "
        f"{spins.min():g} to {spins.max():g} Hz and from {values.min():.2g} to {values.max():.2g}: "
        "more backspin makes up for a livelier ring. They predict "
        f"{some.min():.1f} to {some.max():.1f} made throws."
    )


def page(throws: Throws) -> str:
    """Return the page, Markdown."""
    made, count = throws.made, len(throws.made)
    released = states(throws, DRAWS, BACKSPIN)
    court = shares(released, NBA_COURT, COURT)
    rings, terms = profile(throws, "ring_restitution", RESTITUTIONS, released)
    boards, _ = profile(throws, "backboard_restitution", RESTITUTIONS, released)
    grips, _ = profile(throws, "ring_friction", _FRICTIONS, released)
    # For each throw the restitution that is likeliest for the others.
    held_out = np.array(
        [terms[int(np.argmax(terms.sum(axis=1) - terms[:, out])), out] for out in range(count)]
    )
    in_air = shares(states(throws, DRAWS, BACKSPIN, air=True), NBA_COURT_AIR, COURT_AIR)
    tables = {
        "first": [
            row("`COURT`, `NBA_COURT`", court, made),
            row("`COURT_AIR`, `NBA_COURT_AIR`", in_air, made),
            row("`HOOP`, `NBA`", shares(released, NBA, HOOP), made),
            row("logistic regression, leave-one-out", logistic(throws), made),
            row("the same share for all, leave-one-out", always(throws), made),
        ],
        "spin": [
            row(f"{hertz} Hz", shares(states(throws, DRAWS, hertz * TURN), NBA_COURT, COURT), made)
            for hertz in (0, 1, 2, 3, 4)
        ],
        "errors": [
            row(
                f"{size:g} times",
                shares(states(throws, DRAWS, BACKSPIN, size), NBA_COURT, COURT),
                made,
            )
            for size in (0.5, 1.0, 2.0)
        ],
        "origin": [
            row(
                label,
                shares(
                    states(_moved(throws, by * NBA["wire_radius"]), DRAWS, BACKSPIN),
                    NBA_COURT,
                    COURT,
                ),
                made,
            )
            for label, by in (("outer edge", 1.0), ("middle", 0.0), ("inner edge", -1.0))
        ],
    }
    found = hoopgen.assess(court, made)
    bins = "\n".join(
        f"| {one.predicted / one.shots:.2f} | {one.shots} | {one.predicted:.1f} "
        f"({one.low}–{one.high}) | {one.made} | "
        f"{format_interval(one.share_low, one.share_high, 0)} |"
        for one in found.bins
    )
    three = hoopgen.assess(shares(states(throws, DRAWS, 3.0 * TURN), NBA_COURT, COURT), made)
    verdict, verdict3 = ("within" if one.total.agrees else "outside" for one in (found, three))
    predicted, low, high = found.total.predicted, found.total.low, found.total.high
    plain, others = float(log_terms(court, made).sum()), float(held_out.sum())
    first, spin, errors, origin = (f"{_HEAD}\n" + "\n".join(rows) for rows in tables.values())
    parameters = "\n".join(
        f"| {name} | {interval(grid, likelihood)} | {NBA_COURT[key]:g} |"
        for name, key, grid, likelihood in (
            ("ring restitution (and the bridge's)", "ring_restitution", RESTITUTIONS, rings),
            ("backboard restitution", "backboard_restitution", RESTITUTIONS, boards),
            ("ring friction", "ring_friction", _FRICTIONS, grips),
        )
    )
    hits, hertz = int(made.sum()), BACKSPIN / TURN
    landing, release, entry = (
        ERRORS[name] / size
        for name, size in (("landing", INCH), ("release", INCH), ("entry", DEGREE))
    )
    quarter, three_quarters = np.nanpercentile(throws.fall, [25.0, 75.0])
    credible, down, near, off, speed = fitted(throws)
    needed = float(np.median(np.linalg.norm(states(throws, 1, BACKSPIN, 0.0)[:, 0, 3:6], axis=1)))
    flown = hoopgen.assess(in_air, made).total
    flown_verdict = "within" if flown.agrees else "outside"
    by_hand = "\n".join(_by_hand(throws))
    return f"""# Real shots

This page compares hoopgen with {count} free throws of one player, of which {hits} were made.
The data are [SPL-Open-Data](https://github.com/mlsedigital/SPL-Open-Data) of Maple Leaf Sports
& Entertainment, licensed CC BY-NC-SA 4.0. They are not part of hoopgen. To compute the numbers
anew, get a copy and give its folder:

```text
git clone https://github.com/mlsedigital/SPL-Open-Data.git
python -m benchmarks.real_shots SPL-Open-Data --write
```

## What the data say, and what is assumed

For each throw the data give the place and the angle at which the ball comes down through the
plane of the ring, and the result. The track of the ball ends shortly after the hand, and the
authors call it noisy there. Its vertical acceleration should be −9.81 m/s²; in half of the
throws it is between −{-quarter:.1f} and −{-three_quarters:.1f} m/s². `hoopgen.fit_release` with
`release_time="detect"` calls {credible} of the {count} tracks credible flights, but they are not
these throws: {down} of the {credible} come up to the ring's height,
{near} of them come down within 4 in of the measured place, and in the median
they miss it by {off:.1f} m. Their median speed is {speed:.1f} m/s, where {needed:.1f} m/s are
needed. A short piece of a smoothed track may look like a parabola of the wrong speed, which only
something other than the track can show. So the tracks are not used. The last frame in the hand
gives the place of the release. With it the place and the angle at the ring determine the flight,
without air a parabola: its speed is extrapolated from the ring to the hand.

Some things are not in the data, and are **assumed**:

- the errors of the measurement: {landing:g} in for the place at the ring, {entry:g}° for the
  angle, {release:g} in for the release;
- the backspin, {hertz:g} Hz;
- the origin of the place at the ring, "the front of the hoop", as the middle of the wire;
- the hoop: sizes of the NBA, and the restitutions and the friction of the presets, which were
  not chosen by these throws.

Each throw is simulated {DRAWS} times with the assumed errors. The share made is the probability
of the throw. No number of the model was fitted to these throws in the first table.

## Predictions

*Right* counts throws whose result was predicted with more than half. The predicted number of
made throws has the 95% interval of a sum of independent throws. A larger log-likelihood is
better, a smaller Brier score is better. The logistic regression has four coefficients, of the
place at the ring, and is fitted to the other {count - 1} throws each time.

{first}

`COURT` predicts {predicted:.1f} made throws; {hits} were made, which is {verdict} its interval
of {low} to {high}. In air (`COURT_AIR`) the flight with the same place and angle at the ring is
slower there, and more throws go in: {flown.predicted:.1f} ({flown.low} to {flown.high});
{hits} is {flown_verdict} that interval. The likelihood of the single throws is about the same.
The calibration of `COURT`, in bins with about as many throws each:

| mean probability | throws | predicted to be made | made | 95% interval of the share made |
| ---: | ---: | ---: | ---: | ---: |
{bins}

## What the result depends on

The backspin, with `COURT`:

{spin}

The errors of the measurement, as multiples of those assumed:

{errors}

The origin of the place at the ring, moved from the middle of the wire by the radius of the
wire:

{origin}

Each throw as a single shot without errors, as one would try by hand, with {hertz:g} Hz: the number
of right predictions, with the measured release and with all from 2.2 m above the floor.

| origin | `COURT` | `HOOP` | `COURT`, 2.2 m | `HOOP`, 2.2 m |
| --- | ---: | ---: | ---: | ---: |
{by_hand}

Which origin is meant matters as much as errors and height together. The inner edge is the
likeliest of the three; the middle is kept above because the results did not choose it.

One parameter of `NBA_COURT` at a time, by the likelihood of the results, with its 95% interval.
A parameter without a bound on one side is only bounded on the other. The intervals hold if all
else is as assumed, which it is not exactly: they leave out the uncertainty of the backspin and
of the errors above.

| parameter | likeliest (95%) | in `NBA_COURT` |
| --- | ---: | ---: |
{parameters}

The backspin and the restitution of the ring do not have the same effect, but partly make up for
each other. {_joint(throws)}

With the ring's restitution that is likeliest for the other throws, the log-likelihood of the
throws left out is −{-others:.1f}; with the preset it is −{-plain:.1f}.

## What would refute the model

- A number of made throws outside the interval for every plausible backspin. With {hertz:g} Hz,
  which the results prefer, {hits} is {verdict} the interval; with 3 Hz, as in the literature of
  the page on validation, it is {verdict3}. So the model with the assumptions above does not
  pass unscathed: it loses throws near the edge of the ring that went in. With air, which there
  is in any gym, {hits} is {flown_verdict} the interval. A net and a ring that yields, which both
  leave out, may keep such balls in, too; an error of the assumed origin, or in the
  release, would change the number. A measured backspin would decide.
- A regression on the place at the ring that predicts much better than the model. The
  regression has no physics and the model no fitted number, so the model must reach at least the
  same likelihood.
- A likeliest restitution of the ring far from the 0.5 to 0.65 that the presets guess from tests
  of rims.

One player with one hoop cannot test distances, bank shots or other balls. The throws do not say
the contacts, so restitutions and friction are known only through results.
"""


def main() -> None:
    """Print the numbers, or write the page."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--write", action="store_true", help=f"write {PAGE.name}")
    options = parser.parse_args()
    text = page(read(options.folder))
    if options.write:
        PAGE.write_text(text, encoding="utf-8")
    else:
        print(text)


if __name__ == "__main__":
    main()
