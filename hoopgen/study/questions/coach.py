"""`coach`: which part of a player's release is worth practising most, in words for players.

The player's spread is divided into its parts: speed (short or long), arc, left-right and spin. Each
is halved alone, and each habit, such as the arc, is changed a little; the same random numbers are
thrown before and after. The speed that goes with an arc or an aim is that through the same point.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import replace
from functools import partial
from math import hypot, isnan
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hoopgen.core.argument_types import check_arguments
from hoopgen.core.parameters import ParameterValues
from hoopgen.core.units import DEGREE, INCH, UNITS
from hoopgen.hoop.aiming import flown_distance
from hoopgen.hoop.court_places import find_place
from hoopgen.scene.lookup import SceneLike, check_hoop
from hoopgen.simulation.lookup import engine_of
from hoopgen.study.jobs.chunks import Progress
from hoopgen.study.jobs.monte_carlo import ResolvedSetting, setting_of
from hoopgen.study.models.fitted_scatter import FittedScatter
from hoopgen.study.models.scatter import Scatter
from hoopgen.study.statistics.fitted_sample import made_shares
from hoopgen.study.statistics.tally import check_share, contacts_of
from hoopgen.text.shorten import brief

from .coach_result import PARTS, Advice, Coaching
from .compare import Comparison, compare
from .default_player import PROVENANCE, throws_of_default_player
from .solve import solve

Floats = NDArray[np.float64]

_MODELS, _TOGETHER = 100, 25
"""Scatters that a fitted one allows, of which each change is tried."""

_RPM = UNITS["spin"]["rpm"]


@check_arguments
def coach(
    player: Scatter | FittedScatter[Scatter] | None = None,
    *,
    makes: float | None = None,
    place: str | None = None,
    parameters: ParameterValues | None = None,
    scene: SceneLike = None,
    shots: int = 100_000,
    seed: int = 0,
    confidence: float = 0.95,
    threads: int | None = None,
    progress: Progress | None = None,
) -> Coaching:
    """Say which part of a player's release is worth practising most.

    Parameters
    ----------
    player
        What `Scatter.fit` returned for a player, or a `Scatter`, of speed and elevation. None: a
        default player whose provenance the result says.
    makes
        Share of shots made: all of the player's spread is scaled until it is that. By default 0.7
        of the default player; as it is of a player who is given.
    place
        A named place, such as "free throw", for the default player; by default that.
    parameters, scene
        As for `hoopgen.estimate`; the scene has a hoop.
    shots
        Number of shots before and after each change.
    seed, confidence, threads
        As for `hoopgen.estimate`.
    progress
        Called with what is done and its total: first, where a player is scaled to `makes`, with a
        total of None; then from 0 for the changes.

    Returns
    -------
    Coaching
        The gain of each change with its interval, in the units of players when printed. Intervals
        are those of the simulation; of a fitted player they contain the uncertainty of the sample.

    Raises
    ------
    TypeError, ValueError
        If an argument is not as described.
    """
    level = check_share("confidence", confidence)
    if player is not None and place is not None:
        raise ValueError("place: it is of the default player; measured releases have their own")
    if isinstance(player, FittedScatter) and makes is not None:
        raise ValueError("makes: it is of a player who was not measured; leave one out")
    check_hoop("scene", engine_of(scene))
    setting = setting_of(Scatter({}), parameters, scene)
    where, provenance = None, "The player is as measured."
    fitted = player if isinstance(player, FittedScatter) else None
    given = player.model if isinstance(player, FittedScatter) else player
    if given is None:
        where = find_place("free throw" if place is None else place, setting.parameters)
        given, provenance = throws_of_default_player(where), PROVENANCE
        makes = 0.7 if makes is None else makes
    elif not isinstance(given, Scatter):
        raise TypeError(f"player: expected a Scatter or what Scatter.fit gives, got {brief(given)}")
    about = _aimed(given, setting.parameters)
    options: dict[str, Any] = {"seed": seed, "confidence": level, "threads": threads}
    if makes is not None:
        share = check_share("makes", makes)
        scaled = solve(
            about, share, setting.parameters, scene=scene, shots=shots, progress=progress, **options
        ).model
        assert isinstance(scaled, Scatter)
        about = scaled
    options |= {"scene": scene, "shots": shots}
    changes = {**_spreads(about), **_habits(about)}
    models = [] if fitted is None else fitted.models(_MODELS, seed)
    drawn = [_aimed(one, setting.parameters) for one in models]
    counted = _Parts(progress, len(changes) + (len(changes) + 1) * -(-len(drawn) // _TOGETHER))
    shares = partial(_shares, setting=setting, seed=seed, threads=threads, counted=counted)
    base = shares(drawn) if drawn else np.zeros(0)
    found: dict[str, Advice] = {}
    first: Any = None
    for name, (variable, change) in changes.items():
        after = change(about)
        with counted.part() as options["progress"]:
            result = compare((about, setting.parameters), (after, setting.parameters), **options)
        first = result.first
        low, high = result.low, result.high
        if drawn:
            off = shares([change(one) for one in drawn]) - base
            low, high = _widened(result, off - np.median(off), level)
        found[name] = Advice(
            name=PARTS.get(name, name),
            variable=variable,
            before=_value(about, name, variable),
            after=_value(after, name, variable),
            gain=result.difference,
            low=low,
            high=high,
            made=float(result.second.share_of("made")),
        )
    if first is None:
        raise ValueError("player: it needs a speed or an aim, and an elevation")
    made, low, high = first.probability, first.low, first.high
    if drawn:
        down, up = _quantiles(base - np.median(base), level)
        low, high = (
            max(0.0, made - hypot(down, made - low)),
            min(1.0, made + hypot(up, high - made)),
        )
    parts = [one for name, one in found.items() if name in PARTS]
    habits = [one for name, one in found.items() if name not in PARTS]
    return Coaching(
        made,
        low,
        high,
        about,
        where,
        tuple(sorted(parts, key=lambda one: -one.gain)),
        tuple(sorted(habits, key=lambda one: -one.gain)),
        level,
        provenance,
        setting.parameters,
        scene,
        shots,
        seed,
    )


Change = Callable[[Scatter], Scatter]


def _spreads(player: Scatter) -> dict[str, tuple[str, Change]]:
    """Return the change that halves each part of the spread."""

    def halved(name: str) -> Change:
        return lambda one: replace(one, sd={**one.sd, name: 0.5 * one.sd[name]})

    return {name: (name, halved(name)) for name in PARTS if player.sd.get(name)}


_HABITS: Mapping[str, tuple[str, float]] = {
    "a higher arc": ("elevation", 2.0 * DEGREE),
    "a lower arc": ("elevation", -2.0 * DEGREE),
    "aim deeper": ("aim", 2.0 * INCH),
    "aim shorter": ("aim", -2.0 * INCH),
    "more backspin": ("backspin", 60.0 * _RPM),
    "less backspin": ("backspin", -60.0 * _RPM),
}


def _habits(player: Scatter) -> dict[str, tuple[str, Change]]:
    """Return the change of each habit."""

    def moved(name: str, by: float) -> Change:
        return lambda one: replace(
            one, release={**one.release, name: one.release.get(name, 0.0) + by}
        )

    def straight(one: Scatter) -> Scatter:
        return replace(one, release={**one.release, "azimuth": 0.0})

    found = {
        name: (variable, moved(variable, by))
        for name, (variable, by) in _HABITS.items()
        if variable in player.release or variable == "backspin"
    }
    if player.release.get("azimuth"):
        found["straight at the centre"] = ("azimuth", straight)
    return found


def _value(player: Scatter, name: str, variable: str) -> float:
    values = player.sd if name in PARTS else player.release
    return float(values.get(variable, 0.0))


def _aimed(player: Scatter, parameters: Mapping[str, Any]) -> Scatter:
    """Return the player with the point aimed at in place of the speed."""
    release = dict(player.release)
    if "speed" not in release or "elevation" not in release or "height" not in release:
        return player
    if "distance" not in release:
        return player
    reach = flown_distance(release, parameters)
    if isnan(reach):
        return player
    del release["speed"]
    return replace(player, release={**release, "aim": reach - float(release["distance"])})


class _Parts:
    """The progress of work in equal parts."""

    def __init__(self, progress: Progress | None, count: int) -> None:
        self.progress, self.count, self.done = progress, count, 0

    @contextmanager
    def part(self) -> Iterator[Progress]:
        """Give the function of progress of the next part, which is done in the end."""

        def show(done: int, total: int | None) -> None:
            if self.progress is not None:
                within = _STEPS * done // total if total else 0
                self.progress(_STEPS * self.done + within, _STEPS * self.count)

        yield show
        self.done += 1
        show(0, None)


_STEPS = 100
"""Steps of progress in a part."""


def _shares(
    models: list[Scatter],
    setting: ResolvedSetting,
    seed: int,
    threads: int | None,
    counted: _Parts,
) -> Floats:
    contacts, found = contacts_of(None, setting.scene), []
    for k in range(0, len(models), _TOGETHER):
        with counted.part():
            some = models[k : k + _TOGETHER]
            found.append(made_shares(some, setting, seed, contacts, "auto", threads))
    return np.concatenate(found)


def _widened(found: Comparison, off: Floats, level: float) -> tuple[float, float]:
    """Return the interval of a gain with the uncertainty of the sample."""
    below, above = _quantiles(off, level)
    low = found.difference - hypot(below, found.difference - found.low)
    return low, found.difference + hypot(above, found.high - found.difference)


def _quantiles(values: Floats, level: float) -> tuple[float, float]:
    """Return the ends between which the middle share of values lies."""
    tail = 0.5 - 0.5 * level
    low, high = np.nanquantile(values, [tail, 1.0 - tail])
    return float(low), float(high)
