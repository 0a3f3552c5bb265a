"""The page docs/real-shots.md: numbers of `benchmarks.real_shots` with what they mean."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

import hoopgen
from hoopgen import COURT, HOOP, NBA, NBA_COURT
from hoopgen.core.units import DEGREE, INCH, TURN
from hoopgen.text.numbers import format_interval

from .real_shots import (
    BACKSPIN,
    DRAWS,
    ERRORS,
    RESTITUTIONS,
    Throws,
    always,
    interval,
    log_terms,
    logistic,
    profile,
    row,
    shares,
    states,
)

_HEAD = (
    "|  | right | predicted to be made | log-likelihood | Brier score |\n"
    "| --- | ---: | ---: | ---: | ---: |"
)

_FRICTIONS = np.arange(0.1, 1.01, 0.1)


def _moved(throws: Throws, by: float) -> Throws:
    """Return the throws with the places at the ring moved away from the board."""
    return replace(throws, landing=throws.landing + np.array([by, 0.0]))


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
    tables = {
        "first": [
            row("`COURT`, `NBA_COURT`", court, made),
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
throws it is between −{-quarter:.1f} and −{-three_quarters:.1f} m/s². So the frames are not those of
a flight, and `hoopgen.fit_release` has nothing to fit. The last frame in the hand gives the
place of the release. With it the place and the angle at the ring determine a parabola, without
air: its speed is extrapolated from the ring to the hand.

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
of {low} to {high}. The calibration of `COURT`, in bins with about as many throws each:

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

One parameter of `NBA_COURT` at a time, by the likelihood of the results, with its 95% interval.
A parameter without a bound on one side is only bounded on the other. The intervals hold if all
else is as assumed, which it is not exactly: they leave out the uncertainty of the backspin and
of the errors above.

| parameter | likeliest (95%) | in `NBA_COURT` |
| --- | ---: | ---: |
{parameters}

With the ring's restitution that is likeliest for the other throws, the log-likelihood of the
throws left out is −{-others:.1f}; with the preset it is −{-plain:.1f}.

## What would refute the model

- A number of made throws outside the interval for every plausible backspin. With {hertz:g} Hz,
  which the results prefer, {hits} is {verdict} the interval; with 3 Hz, as in the literature of
  the page on validation, it is {verdict3}. So the model with the assumptions above does not
  pass unscathed: it loses throws near the edge of the ring that went in. A net and a ring that
  yields, which it leaves out, may keep such balls in; an error of the assumed origin, or in the
  release, would change the number, too. A measured backspin would decide.
- A regression on the place at the ring that predicts much better than the model. It has no
  physics, and the model has no fitted number, so equal likelihoods are the least that the model
  must reach.
- A likeliest restitution of the ring far from the 0.5 to 0.65 that the presets guess from tests
  of rims.

One player with one hoop cannot test distances, bank shots or other balls. The throws do not say
the contacts, so restitutions and friction are known only through results, and several together
are not told apart.
"""
