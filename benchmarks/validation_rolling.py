"""Bounces that accumulate, rolling, and what becomes of shots that the hoop gives up."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from matplotlib.figure import Figure
from matplotlib.ticker import NullLocator

import hoopgen
from benchmarks.free_throw import LINE
from benchmarks.report import power, table
from benchmarks.rolling import NAMES, NBA, Bounce, Found, bounces, settled
from benchmarks.workloads import SEED, States, free_throw
from hoopgen import COURT, HOOP, Outcome
from hoopgen.plots.style import COLOURS, PAGE, style
from hoopgen.text.numbers import format_percent

THROWS = {0.3: 1 << 10, 0.5: 1 << 11, 0.7: 1 << 13}
"""Free throws whose bounces are looked at, by restitution."""
SPEEDS = (1e-4, 3e-4, 1e-3, 3e-3, 1e-2, 3e-2, 1e-1)
"""Between which bounces are taken together, m/s."""
DRAWN = 100
"""Bounces of a restitution in the picture, at most."""
SHOTS = 200_000
"""Free throws that are flown in both scenes; a hundredth as many settled ones are rolled again."""


def players(n: int) -> States:
    """Return free throws of a player who makes 70%: 7.17 ± 0.07 m/s, 52° ± 1.3°, ± 1° aside."""
    gauss = np.random.Generator(np.random.Philox(SEED)).standard_normal((n, 3))
    return hoopgen.release(
        speed=7.17 + 0.07 * gauss[:, 0],
        elevation=np.radians(52 + 1.3 * gauss[:, 1]),
        azimuth=np.radians(gauss[:, 2]),
        **LINE,
    )


@dataclass(frozen=True)
class GivenUp:
    """Free throws: how many HOOP caps, how those end in COURT, and who makes how many in all."""

    shots: int
    capped: int
    ends: dict[str, int]
    hoop: int
    court: int

    @property
    def share(self) -> float:
        """Made ones among those that end made or missed."""
        return self.ends["MADE"] / (self.ends["MADE"] + self.ends["MISSED"])


def given_up(states: States) -> GivenUp:
    """Fly shots with the NBA's sizes, grip and restitution 0.7 in both scenes."""
    sizes = hoopgen.NBA | {"restitution": NBA["ring_restitution"]}
    hoop = hoopgen.simulate(states, sizes, scene=HOOP)
    court = hoopgen.simulate(states, NBA, scene=COURT)
    capped = hoop.outcome == Outcome.CAPPED
    counts = np.bincount(court.outcome[capped], minlength=len(COURT.outcomes))
    ends = {one.name: int(counts[one]) for one in COURT.outcomes}
    return GivenUp(
        len(states), int(capped.sum()), ends, int(hoop.made.sum()), int(court.made.sum())
    )


def sequences() -> dict[float, list[Bounce]]:
    """Return the bounces of sequences that settle, by restitution."""
    return {e: list(bounces(free_throw(n), e)) for e, n in THROWS.items()}


def section(found: dict[float, list[Bounce]], shots: int = SHOTS) -> list[str]:
    """Return the section of the page."""
    return [
        "## Zeno accumulation and rolling",
        "",
        *_accumulating(found),
        *_again(settled(shots // 100)),
        *_ended({"W2": given_up(free_throw(shots)), "a 70% player": given_up(players(shots))}),
    ]


def _accumulating(found: dict[float, list[Bounce]]) -> list[str]:
    rows = [
        [f"{low:g} to {high:g} m/s", *(_ratios(own, low, high) for own in found.values())]
        for low, high in reversed([*pairwise(SPEEDS)])
    ]
    return [
        "A ball whose bounces become ever smaller finally rolls, as the article says. This "
        "section measures how soon rolling describes the bouncing ball. From each recorded "
        "bounce of shots that settle on the ring, with the normal speed V, a second ball starts "
        "to roll, and its place is compared with the place where the sequence of bounces ends. "
        "In the limit the distance is 2 F V²/(N² (1 − e²)), with the normal force N and the "
        "friction F of rolling, per unit mass. The table gives the measured distance divided by "
        "this limit: its median and, in parentheses, the 5% and 95% quantiles and the number of "
        "bounces. The distance divided by V² tends to a constant of each sequence.",
        "",
        *table(["V", *(f"e = {e:g}" for e in found)], rows),
        "The picture shows the same distances against V, up to a hundred for each restitution. "
        "The line is the limit for the median of F/N² of these bounces, about which the "
        "distances scatter:",
        "",
        "![The distance between rolling and bouncing, against the speed of the bounce: a line "
        "of slope 2 on logarithmic axes](validation-bounces.svg)",
        "",
    ]


def picture(found: dict[float, list[Bounce]]) -> Figure:
    """Draw how far a ball that rolls from a bounce is from where the bounces end, against V."""
    with style():
        figure = Figure(figsize=(PAGE, 2.7), layout="constrained")
        for axes, (restitution, own) in zip(
            figure.subplots(1, len(found), sharex=True, sharey=True), found.items(), strict=True
        ):
            speed = np.array([one.speed for one in own])
            off = np.array([one.by_square for one in own]) * speed**2
            # What the law gives for each bounce differs by its F/N²: the median of them.
            law = np.median([one.by_square / one.by_limit for one in own])
            ends = np.array([SPEEDS[0], SPEEDS[-1]])
            some = slice(None, None, -(-len(own) // DRAWN))
            axes.loglog(speed[some], off[some], ".", color=COLOURS["path"], markersize=2)
            axes.loglog(ends, law * ends**2, color=COLOURS["ring"], linewidth=0.8)
            axes.set_title(f"e = {restitution:g}")
            for axis in (axes.xaxis, axes.yaxis):
                axis.set_major_formatter(lambda value, _: power(value))
                axis.set_minor_locator(NullLocator())
            axes.set_xlabel("V (m/s)")
            axes.grid(color="#DDDDDD", linewidth=0.5)
            axes.set_axisbelow(True)
            axes.spines[["top", "right"]].set_visible(False)
        figure.axes[0].set_ylabel("off by (m)")
    return figure


def _ratios(found: Sequence[Bounce], low: float, high: float) -> str:
    ratios = [one.by_limit for one in found if low <= one.speed < high]
    least, middle, most = np.percentile(ratios, [5, 50, 95])
    return f"{middle:.4f} ({least:.3f}–{most:.3f}; {len(ratios)})"


def _again(found: Found) -> list[str]:
    ends = ", ".join(f"{NAMES[what]} {found.ends.get(NAMES[what], 0):,}" for what in NAMES)
    errors = ", ".join(
        f"{value:.0e} {unit}"
        for value, unit in zip(found.errors, ("s", "m", "m/s", "rad/s"), strict=True)
    )
    off, share, most = found.bounced()
    later = found.flagged - found.lodged - found.bouncing - found.rolling
    return [
        f"For {found.shots:,} free throws that settled on the ring (e = 0.7, 0.5, 0.3), a second "
        "program computed the rolling again, in the ring's own coordinates, with series of "
        f"order 24 and 110 bits (`python -m benchmarks.rolling`). Their contact ends by: {ends}. "
        f"{found.flagged:,} of them are flagged. {found.lodged:,} end LODGED, which is always "
        "flagged: if two bodies hold a ball that grips, the forces are not determined. Of the "
        f"others, {found.bouncing} are flagged while they still bounce, because the errors have "
        f"grown so large that a later bounce is uncertain; {found.rolling} are flagged in "
        f"contact, because the event that ends the contact is uncertain; {later} are flagged "
        f"afterwards. Of the shots that are not flagged, {len(found.wrong)} end otherwise or "
        f"have a larger error than their bound. The largest differences are {errors}, at most "
        f"{found.ratios.max():.0e} of the bound, and {found.leaving:.0e} s in the time at which "
        f"contact ends. Of the flagged shots, {found.flagged_wrong} differ. The program also "
        "computed the bounces before the roll again, with 400 bits. At the last bounce half of "
        f"the positions have an error of less than {off:.0e} m, half have less than "
        f"{format_percent(share)} of the bound, and none has more than "
        f"{format_percent(most, 0)} of it. The engine estimates the "
        "remainder of the series of a roll from its last terms and does "
        "not bound it; this comparison takes the place of a bound.",
        "",
    ]


def _ended(found: dict[str, GivenUp]) -> list[str]:
    names = ("MADE", "MISSED", "LODGED", "ENDLESS", "CAPPED")
    rows = [
        ["capped in `HOOP`", *(f"{one.capped:,}" for one in found.values())],
        *(
            [f"of these in `COURT`: {name}", *(f"{one.ends[name]:,}" for one in found.values())]
            for name in names
        ),
        ["made, of made and missed", *(format_percent(one.share) for one in found.values())],
        [
            "made in all, `HOOP`",
            *(format_percent(one.hoop / one.shots, 2) for one in found.values()),
        ],
        [
            "made in all, `COURT`",
            *(format_percent(one.court / one.shots, 2) for one in found.values()),
        ],
    ]
    shots = max(one.shots for one in found.values())
    return [
        "`COURT` follows the shots to their end that `HOOP` caps after 40 contacts. The table "
        f"counts {shots:,} free throws with the NBA's sizes, perfect grip and a restitution of "
        "0.7, once with the scatter of the workload W2 of the benchmarks and once with that of "
        "a player who makes 70%:",
        "",
        *table(["", *found], rows),
    ]
