"""The best release that was found: what is known of it, its lead over another, and in words."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, field
from typing import TYPE_CHECKING, Any, Unpack
from warnings import warn

from hoopgen.hoop.variables import VARIABLES
from hoopgen.report.provenance import describe_release, describe_setting, footer, sentences
from hoopgen.report.quantities import for_json, format_bounds, format_launch, format_variable
from hoopgen.results.drawing import FanOptions
from hoopgen.simulation.engine import Engine
from hoopgen.simulation.hoop import HOOP
from hoopgen.simulation.simulate import simulate
from hoopgen.study.jobs.objective import Bounds, Player, paired
from hoopgen.study.models.resample import Resample
from hoopgen.study.models.scatter import Scatter
from hoopgen.study.result import Result
from hoopgen.study.statistics.sample import difference_of_rows, in_groups
from hoopgen.text.numbers import format_count, format_interval, format_percent, format_points
from hoopgen.text.tables import table

from .aim_points import on_board
from .held_out import HeldOut, folds_of, with_choice
from .margins import Margin

if TYPE_CHECKING:
    from hoopgen.results.drawing import Drawn

PLOTTED = 2_000
"""Shots whose shares are beside their paths."""


@dataclass(frozen=True, repr=False)
class Optimum(Result):
    """The release with the greatest probability of success.

    Attributes
    ----------
    release
        The variables that were searched over, at their best, and those that were given; SI.
    arguments
        The same as arguments of `hoopgen.release`.
    entry_angle, depth
        Of the shot without scatter or contact: its angle below the horizontal at the ring's plane,
        rad, and how far past the ring's centre it comes down, m.
    by
        What counts as success.
    probability, low, high
        Share of fresh shots, other than those of the search, that succeed; its Wilson interval.
        An invalid shot is no trial. Of measured releases the shots are the rows, each judged by a
        release that was searched without it (see `folds`). The interval then contains the
        uncertainty of the sample and of the search (see `hoopgen.study.questions.held_out`).
    made, shots, invalid
        How many of them succeed, were drawn, and could not be simulated.
    confidence
        Of the interval.
    seed
        Of the search; the fresh shots, and those of `flat` and `Margin.steady`, are those of the
        next one.
    tolerance
        What `flat` and `Margin.steady` let the probability fall by.
    flat
        By variable searched over: the range in which, the others chosen to suit, the probability
        was found to stay within the tolerance of the best. An estimate, no confidence interval.
    bounds
        The ranges that were searched.
    margins
        By variable.
    model
        The player: where the shots about it come from.
    parameters
        Of the scene, those in `release` among them.
    scene
        The scene itself. Without a hoop there are no arguments; measures at the ring are NaN.
    ways
        Shares of the valid shots that succeed without a touch ("swish"), with the ring or bridge
        first ("rim"), with the board first ("bank"). Their sum is the probability. Hoops only.
    folds
        Of measured releases: the values found without each fold of the rows. Their spread shows
        how far the sample determines the best.
    """

    release: Mapping[str, float]
    arguments: Mapping[str, float]
    entry_angle: float
    depth: float
    by: str
    probability: float
    low: float
    high: float
    made: int
    shots: int
    invalid: int
    confidence: float
    seed: int
    tolerance: float
    flat: Mapping[str, Bounds]
    bounds: Mapping[str, Bounds]
    margins: Mapping[str, Margin]
    model: Scatter | Resample
    parameters: Mapping[str, float]
    scene: Engine = field(default=HOOP, compare=False)
    ways: Mapping[str, float] = field(default_factory=dict)
    folds: Sequence[Mapping[str, float] | None] = ()

    @property
    def is_bank(self) -> bool:
        """True if most of the shots that go in touch the board first."""
        return 2.0 * self.ways.get("bank", 0.0) > sum(self.ways.values())

    @property
    def at_bounds(self) -> tuple[str, ...]:
        """Variables whose flat range reaches a bound, beyond which the best may lie."""
        return tuple(
            name
            for name, (low, high) in self.flat.items()
            if low <= self.bounds[name][0] or high >= self.bounds[name][1]
        )

    def lead(self, other: Optimum) -> tuple[float, float, float]:
        """Return the difference of this probability and another's, and its interval.

        Both have the same fresh shots: Newcombe's interval for paired data (1998). Pairs with an
        invalid shot do not count. Measured releases are compared row by row, each judged by the
        releases that were searched without it; the interval contains the sample's uncertainty.

        Parameters
        ----------
        other
            Of as many shots and the same seed.

        Raises
        ------
        ValueError
            If shots or seed differ, or measured releases or their groups.
        """
        if (self.shots, self.seed) != (other.shots, other.seed):
            raise ValueError("other: expected an optimum of as many shots and the same seed")
        measured = [isinstance(one.model, Resample) for one in (self, other)]
        if any(measured):
            return self._lead_of_rows(other)
        mine, others = (
            one._player().scored(one.point, one.shots, one.seed + 1) for one in (self, other)
        )
        return paired(mine, others, self.confidence)

    def _lead_of_rows(self, other: Optimum) -> tuple[float, float, float]:
        """Return the lead of measured releases over the same ones thrown another way."""
        mine, others = self.model, other.model
        if not isinstance(mine, Resample) or not isinstance(others, Resample):
            raise ValueError("other: expected an optimum of measured releases, as this is")
        if not mine.same_groups(others):
            raise ValueError("other: expected an optimum of the same groups of measured releases")
        both = [
            (HeldOut(tuple(one.folds), folds_of(model, one.seed)), model, one)
            for one, model in ((self, mine), (other, others))
        ]
        scored = [without.scored(model, one._player(), {}) for without, model, one in both]
        shares = [
            without.shares(model, one._player(), {}, one.point, one.seed)
            for without, model, one in both
        ]
        valid = scored[0].valid & scored[1].valid
        made, rival = scored[0].made, scored[1].made
        lead = difference_of_rows(made, rival, valid, mine.cluster, self.confidence)
        lead = with_choice(lead, shares[0] - shares[1], self.confidence, -1.0)
        return lead.value, lead.low, lead.high

    def plot(self, *, ax: Drawn | None = None, **options: Unpack[FanOptions]) -> Drawn:
        """Draw paths of its fresh shots; options, and what is returned, as for `plots.plot_fan`.

        The shares in the key are those of the first 2000 at most.
        """
        player, few = self._player(), min(self.shots, PLOTTED)
        noise = player.model.noise(0, few, self.seed + 1)
        shots = player.model.around(self.point, noise, self.parameters, few)
        options.setdefault("note", sentences(self._drawn()))
        simulated = simulate(shots.states, shots.parameters, scene=self.scene, record=True)
        return simulated.plot(ax=ax, **options)

    def describe(self) -> dict[str, str]:
        """Return the provenance: texts by "scene", "release", "scatter" and "seed"."""
        setting = {**self.model.identity(), "parameters": self.parameters}
        return {**describe_setting(setting, self.scene), "seed": str(self.seed)}

    def told(self) -> dict[str, str]:
        """Return `describe()`; deprecated."""
        warn("Optimum.told: use Optimum.describe", DeprecationWarning, stacklevel=2)
        return self.describe()

    def _drawn(self) -> dict[str, str]:
        """Return the provenance of its fresh shots."""
        description = self.describe()
        if isinstance(self.model, Scatter):
            release = describe_release(self.release, self.scene)
        else:
            moved = describe_release({name: self.release[name] for name in self.bounds}, self.scene)
            release = f"{description['release']}, their means at {moved}"
        return description | {"release": release, "seed": str(self.seed + 1)}

    @property
    def point(self) -> dict[str, float]:
        """The release about which its shots are thrown, but for what measured releases say."""
        fixed, _ = self.model.apart()
        return fixed | {name: self.release[name] for name in self.bounds}

    def _player(self) -> Player:
        return Player(self.model.apart()[1], self.parameters, self.by, scene=self.scene)

    def as_dict(self) -> dict[str, Any]:
        """Return everything in types that JSON knows; SI. What is not a number is None."""
        plain = dict(vars(self))
        plain["scene"] = self.describe()["scene"]
        plain["margins"] = {name: asdict(margin) for name, margin in self.margins.items()}
        plain["model"] = self.model.identity()
        plain["at_bounds"] = list(self.at_bounds)
        return {name: for_json(value) for name, value in plain.items()}

    def __str__(self) -> str:
        return advice(self)


# ------------------------------------------------------------------------------------ in words

_GO_IN = {
    "any": "go in",
    "direct": "go in, the board not touched first",
    "bank": "go in off the board",
}


_WAYS = {
    "swish": "without a touch",
    "rim": "off the ring first",
    "bank": "off the board first",
}


def advice(best: Optimum, rival: Optimum | None = None) -> str:
    """Describe a release, how often it goes in, its margins and its provenance.

    Parameters
    ----------
    rival
        The best of another way in, to which `best` is compared.
    """
    if rival is not None:
        _check_alike(best, rival)
    lines = [*_shot(best), *([_against(best, rival)] if rival is not None else [])]
    margins = list(best.margins.values())
    lines += ["", _margins(margins, best.tolerance)] if margins else []
    return "\n".join([*lines, "", footer(9, best.describe())])


def _check_alike(best: Optimum, rival: Optimum) -> None:
    """Refuse two whose difference is not that of the way in alone."""
    if best.model != rival.model:
        raise ValueError("rival: expected an optimum of the same release and scatter")
    searched = {*best.bounds, *rival.bounds}
    other = [
        name
        for name, value in best.parameters.items()
        if name not in searched and value != rival.parameters.get(name)
    ]
    if best.scene != rival.scene or other:
        raise ValueError(f"rival: expected one in the same scene; not so {', '.join(other)}")


def _shot(best: Optimum) -> list[str]:
    """Say the release, where the ball goes, and how often it goes in."""
    if not best.scene.has_hoop:
        return _of_a_state(best)
    given = best.arguments
    turning = [name for name in ("backspin", "sidespin") if given[name]]
    spins = [f"{name} {format_variable(name, given[name])}" for name in turning]
    ways = [f"{format_percent(best.ways[name])} {text}" for name, text in _WAYS.items()]
    off = ["off the board"] if best.is_bank else []
    return [
        f"shoot    {', '.join([format_launch(given), *off, towards(given['azimuth']), *spins])}",
        _where(best),
        f"success  {format_percent(best.probability)} {_GO_IN[best.by]} {_interval(best)}",
        f"ways     {', '.join(ways)}",
        *_ranges(best),
    ]


def _of_a_state(best: Optimum) -> list[str]:
    """Say the release, and how often it succeeds, where there is no hoop."""
    varied = {name: best.release[name] for name in best.bounds}
    parameters = [f"{name} {value:g}" for name, value in varied.items() if name in best.parameters]
    state = describe_release(best.release, best.scene)
    return [
        f"release  {', '.join([*filter(None, [state]), *parameters])}",
        f"success  {format_percent(best.probability)} {best.by} {_interval(best)}",
        *_ranges(best),
    ]


def _ranges(best: Optimum) -> list[str]:
    """Say which releases are as good, and which variables may be better beyond their bounds."""
    hoop, within = best.scene.has_hoop, f"within {format_count(100 * best.tolerance, 'point')}"
    label = {name: VARIABLES[name].label if hoop else name for name in best.bounds}
    flat = {name: format_bounds(name, *ends, at_hoop=hoop) for name, ends in best.flat.items()}
    lines = [f"as good  {label[name]} {text}, {within}" for name, text in flat.items()]
    for name in best.at_bounds:
        bounds = format_bounds(name, *best.bounds[name], at_hoop=hoop)
        lines.append(f"caution  the best {label[name]} may lie beyond {bounds}")
    return lines


def _interval(best: Optimum) -> str:
    """Say the interval of the probability, and of what it is."""
    level = format_percent(best.confidence, None)
    invalid = f", {best.invalid:,} of them invalid" * bool(best.invalid)
    text = f"{format_interval(best.low, best.high)} with {level} confidence"
    if not isinstance(best.model, Resample):
        return f"({text}; {format_count(best.shots, 'fresh shot')}{invalid}, seed {best.seed})"
    rows = f"{format_count(best.shots, 'measured release')}{in_groups(best.model.groups)}{invalid}"
    return f"({text} of the sample; {rows}, each held out of its search, seed {best.seed})"


def _where(best: Optimum) -> str:
    """Return the place that the ball is aimed at, on the board or in the ring, as text."""
    if best.is_bank or best.by == "bank":
        touch = on_board(best.arguments, best.parameters, best.scene)
        return f"flight   {touching(touch)}"
    inside = best.parameters["ring_radius"] - best.parameters["wire_radius"]
    return (
        f"flight   comes down at {format_variable('entry', best.entry_angle)}, "
        f"{format_variable('aim', abs(best.depth))} {'past' if best.depth >= 0 else 'short of'} "
        f"the centre: {format_variable('aim', inside + best.depth)} from the front of the ring"
    )


def touching(shot: Mapping[str, Any]) -> str:
    """Say where a bank shot touches the board: `touch_y`, `touch_z`, m; NaN if not at first."""
    y, z = float(shot["touch_y"]), float(shot["touch_z"])
    if math.isnan(y):
        return "without errors it does not touch the board first"
    return (
        f"touches the board {format_variable('aim', z)} above the ring, "
        f"{format_variable('aim', abs(y))} to the {'right' if y >= 0 else 'left'} of its middle"
    )


def towards(azimuth: float) -> str:
    """Say in which direction a shot goes."""
    text = format_variable("azimuth", abs(azimuth))
    if text == format_variable("azimuth", 0.0):
        return "straight at the ring"
    return f"{text} to the {'left' if azimuth > 0 else 'right'} of the ring's centre"


def _against(best: Optimum, rival: Optimum) -> str:
    difference, low, high = best.lead(rival)
    given = rival.arguments
    return (
        f"versus   {format_percent(rival.probability)} {_GO_IN[rival.by]}, from "
        f"{format_launch(given)}: "
        f"{format_points(difference)} points ({format_points(low)} to {format_points(high)})"
    )


def _margins(margins: Sequence[Margin], tolerance: float) -> str:
    rows = [
        [
            VARIABLES[margin.name].label,
            format_variable(margin.name, margin.value),
            margin.describe_range(margin.low, margin.high) + "*" * bool(margin.elsewhere),
            margin.describe_range(*margin.steady) if margin.steady else "",
        ]
        for margin in margins
    ]
    within = f"within {format_count(100 * tolerance, 'point')}"
    head = ["one of them off", "here", "goes in", within]
    groups = [(2, 2, "without scatter"), (3, 3, "with scatter")]
    notes = [
        f"* {VARIABLES[margin.name].label}, by another bounce: {_again(margin)}"
        for margin in margins
        if margin.elsewhere
    ]
    return "\n".join([table(head, rows, right=(1,), groups=groups), *notes])


def _again(margin: Margin) -> str:
    """Say the first interval further out, and how many more there are."""
    first, *more = margin.elsewhere
    said = margin.describe_range(*first)
    return f"{said}, and {format_count(len(more), 'further interval')}" if more else said
