"""`estimate`: how probably a shot is made.

Every share is of shots that were drawn by index, so that a result can be had again.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, fields, replace
from math import nan
from os import PathLike
from typing import Any, TypedDict, Unpack, overload

import numpy as np
from numpy.typing import NDArray

from hoopgen.engines import HOOP, Engine
from hoopgen.hoop.kinds import Kind, ended_in
from hoopgen.inputs import Backend
from hoopgen.phrases import decimals, doubtful, interval, percent
from hoopgen.results import Outcome
from hoopgen.scenes import check_hoop
from hoopgen.told import footer, told_setting
from hoopgen.variables import check_names
from hoopgen.words import for_json

from .draws import check_seed
from .intervals import wilson
from .measures import MEASURES, measures_of
from .models import ReleaseModel, is_still
from .rebounds import CATCHING_HEIGHT, check_height
from .said import SharesOfShots
from .sample import Rows, SampleInterval, say_sample
from .shares import Shares, shares_of
from .spread import Spread, spread_lines, spreads, spreads_of_sample, width_of
from .tallies import Tally, check_share, contacts_of
from .throws import Progress, Until, Work, most_shots, setting_of, tally_of

__all__ = [
    "NAMES",
    "Estimate",
    "estimate",
    "estimated",
    "told",
]

STILL = "no scatter: every throw is the same"
"""What is said in place of an interval where nothing is random."""

NAMES = 9
"""Letters of the column of names in what is printed."""


@dataclass(frozen=True, repr=False)
class Estimate(SharesOfShots):
    """How probably a shot is made.

    An invalid shot is no trial: `probability` is of the others. A capped one is a trial and not
    made, since the model does not decide it; `with_capped` is the probability if all had gone in.

    Attributes
    ----------
    probability
        made / (shots - invalid); NaN if all are invalid.
    low, high
        Wilson's interval of it: that of the simulation alone, which shrinks with the shots. Without
        scatter every throw is the same, and both are the probability.
    confidence
        Of the intervals.
    shots
        Drawn.
    made, missed, capped, short, invalid
        Of them, by outcome.
    uncertain
        With a decision within its rounding-error bound.
    uncertain_capped
        Capped ones among those.
    kinds, kinds_made
        Shots by the name of their `Kind`, all and made.
    seed
        Of the random numbers.
    setting
        Release model and parameters.
    scene
        In which the shots were thrown.
    lodged, endless
        Shots at rest on the hoop, and those still on their way at the time limit: none where no
        ball rolls.
    measured
        How measures are spread, by their names: those that were asked for.
    rolled
        Shots that rolled, whatever became of them.
    slip_left
        Capped ones whose bounces ended with slip left, which friction could not stop.
    sample
        Of measured releases: the interval of the probability which contains the uncertainty of the
        sample. None of other models.
    still
        Whether nothing scatters, so that there is nothing to be estimated.
    """

    probability: float
    low: float
    high: float
    confidence: float
    shots: int
    made: int
    missed: int
    capped: int
    short: int
    invalid: int
    uncertain: int
    uncertain_capped: int
    kinds: Mapping[str, int]
    kinds_made: Mapping[str, int]
    seed: int
    setting: Mapping[str, Any]
    scene: Engine = field(default=HOOP, compare=False)
    lodged: int = 0
    endless: int = 0
    measured: Mapping[str, Spread] = field(default_factory=dict)
    rolled: int = 0
    slip_left: int = 0
    sample: SampleInterval | None = None
    still: bool = False

    @property
    def shares(self) -> dict[str, float]:
        """Shares of the kinds among all shots."""
        return {name: count / self.shots for name, count in self.kinds.items()}

    def share_of(self, by: str) -> float:
        """Return the share of the shots that end so: of those made, the probability."""
        valid = self.shots - self.invalid
        return int(getattr(self, by)) / valid if valid else nan

    def ends_of(self, by: str) -> tuple[float, float]:
        """Return the interval of the share of the shots that end so: of those made, its own."""
        if self.still:
            return self.share_of(by), self.share_of(by)
        low, high = wilson(getattr(self, by), self.shots - self.invalid, self.confidence)
        return float(low), float(high)

    def with_rows(self, rows: Rows | None) -> Estimate:
        """Return this with the intervals of the sample whose rows they are; None: as it is."""
        if rows is None:
            return self
        sample = rows.share(Outcome.MADE, self.confidence)
        return replace(self, sample=sample, measured=spreads_of_sample(self.measured, rows))

    @property
    def with_capped(self) -> float:
        """Probability if all capped shots had been made."""
        valid = self.shots - self.invalid
        return (self.made + self.capped) / valid if valid else nan

    @property
    def half_width(self) -> float:
        """Half the width of the interval."""
        return 0.5 * (self.high - self.low)

    @property
    def rolled_share(self) -> float:
        """Share of the shots that rolled; the invalid ones are no trials."""
        valid = self.shots - self.invalid
        return self.rolled / valid if valid else nan

    def _rolled(self) -> str:
        return f"{percent(self.rolled_share, 2)}: {self.rolled:,} of the shots"

    def _made(self, digits: int) -> list[str]:
        """Say the probability with its intervals."""
        said = f"made     {percent(self.probability, digits)}"
        if self.still:
            return [f"{said} ({STILL})"]
        level = percent(self.confidence, None)
        alone = "" if self.sample is None else " of the simulation alone"
        ends = interval(self.low, self.high, digits)
        lines = [f"{said}, {ends} (Wilson's {level} interval{alone})"]
        if self.sample is not None:
            lines.append(f"sample   {say_sample(self.sample, self.confidence)}")
        return lines

    def _capped(self, digits: int) -> str:
        slipping = f"; {self.slip_left:,} of them with slip left" if self.slip_left else ""
        return f"{percent(self.with_capped, digits)} if made{slipping}"

    def as_dict(self) -> dict[str, Any]:
        """Return everything, in types that JSON knows; None for what is not a number."""
        more: dict[str, Any] = {"with_capped": self.with_capped, "shares": self.shares}
        plain = {one.name: getattr(self, one.name) for one in fields(self)}
        more["scene"] = told_setting(self.setting, self.scene)["scene"]
        measured = {name: one.as_dict() for name, one in plain.pop("measured").items()}
        more |= {"measured": measured} if measured else {}
        sample = plain.pop("sample")
        more |= {"sample": sample.as_dict()} if sample is not None else {}
        return {name: for_json(value) for name, value in (plain | more).items()}

    def __str__(self) -> str:
        digits = decimals(self.half_width)
        ended = (outcome.name.lower() for outcome in ended_in(self.scene.rolls))
        counts = [f"{getattr(self, name):,} {name}" for name in ended]
        counts.append(doubtful(self.uncertain, self.uncertain_capped))
        lines = [
            *self._made(digits),
            f"shots    {self.shots:,}: {', '.join(counts)}",
            *([f"rolled   {self._rolled()}"] if self.scene.rolls else []),
            *([f"capped   {self._capped(digits)}"] if self.capped else []),
            "",
            "kind         share  of it made",
        ]
        lines += [
            f"{name.replace('_', ', '):10}  {percent(self.shares[name]):>6}"
            f"  {percent(self.kinds_made[name] / count):>10}"
            for name, count in self.kinds.items()
            if count
        ]
        lines += spread_lines(self.measured)
        return "\n".join([*lines, "", footer(NAMES, told(self))])


class _Options(TypedDict, total=False):
    shots: int | None
    precision: float | None
    measures: Iterable[str]
    catching_height: float
    confidence: float
    seed: int
    max_contacts: int | None
    backend: Backend
    threads: int | None
    folder: str | PathLike[str] | None
    scheduler: str | None
    progress: Progress | None


@overload
def estimate(
    model: ReleaseModel,
    parameters: Mapping[str, Any] | None = None,
    *,
    scene: None = None,
    **options: Unpack[_Options],
) -> Estimate: ...


@overload
def estimate(
    model: ReleaseModel,
    parameters: Mapping[str, Any] | None = None,
    *,
    scene: Any,
    **options: Unpack[_Options],
) -> Estimate | Shares: ...


def estimate(
    model: ReleaseModel,
    parameters: Mapping[str, Any] | None = None,
    *,
    scene: Any = None,
    shots: int | None = None,
    precision: float | None = None,
    measures: Iterable[str] = (),
    catching_height: float = CATCHING_HEIGHT,
    confidence: float = 0.95,
    seed: int = 0,
    max_contacts: int | None = None,
    backend: Backend = "auto",
    threads: int | None = None,
    folder: str | PathLike[str] | None = None,
    scheduler: str | None = None,
    progress: Progress | None = None,
) -> Estimate | Shares:
    """Estimate how probably a shot is made; in a scene of one's own, how it ends.

    Parameters
    ----------
    model
        Where the shots come from: `Scatter`, `Resample`, or one of your own. Where there is no
        hoop, of states.
    parameters
        Of the scene, one number each; those left out have its usual values.
    scene
        As for `hoopgen.simulate`.
    shots
        How many; with a precision, at most. By default 100,000; with a precision 10^9.
    precision
        Stop as soon as half the interval, the widest of several, is no wider; looked at after
        every `CHUNK` shots.
    measures
        Names of `hoopgen.study.measures.MEASURES`: how each is spread is in `Estimate.measured`;
        of rebound_angle, how many rebounds go where. Only where there is a hoop.
    catching_height
        Of rebounds, as for `hoopgen.measure`.
    confidence
        Of the interval, within 0 and 1.
    seed
        From 0 to 2^64 - 1. One seed gives one result, whatever computes it.
    max_contacts, backend
        As for `hoopgen.simulate`.
    threads, folder, scheduler
        Who computes, and where finished chunks are kept and gone on from; see `chunks.run`. A
        folder may be asked for more shots, fewer, or another precision: what it has not is thrown,
        and the result is that of an estimate which asked for as much from the start.
    progress
        Called with the chunks that are done and their number, as far as that is known.

    Returns
    -------
    Estimate or Shares
        Where there is a hoop, the probability of a made shot with its interval, and shots by
        outcome and kind; else the share of each outcome with its interval.

    Raises
    ------
    TypeError, ValueError
        If an argument is not as described.
    """
    setting = setting_of(model, parameters, scene)
    level = check_share("confidence", confidence)
    contacts = contacts_of(max_contacts, setting.scene)
    most = most_shots(shots, precision, level)
    names = _measured(measures, setting.scene)
    height = check_height(catching_height)
    work = Work(
        (setting,),
        most,
        check_seed(seed),
        contacts,
        backend,
        measures=names,
        catching_height=height,
    )
    until = Until(precision, lambda total: estimated(work, total, 0, level).half_width, progress)
    total = until.total(work, folder, scheduler, threads)
    return estimated(work, total, 0, level).with_rows(work.rows(0, threads))


def _measured(measures: Iterable[str], scene: Engine) -> tuple[str, ...]:
    """Return the names of measures, each once; refuse those that there are not."""
    names = tuple(dict.fromkeys(check_names("measures", measures, MEASURES)))
    if names:
        check_hoop("measures", scene)
        check_names("measures", names, measures_of(scene))
    return names


def estimated(work: Work, total: NDArray[np.int64], which: int, level: float) -> Estimate | Shares:
    """Return what the numbers say of one setting."""
    tally = tally_of(total, which, work.scene)
    if not work.scene.has_hoop:
        return shares_of(tally, work.settings[which], level, work.seed)
    return _estimated(work, total, tally, which, level)


def _estimated(
    work: Work, total: NDArray[np.int64], tally: Tally, which: int, level: float
) -> Estimate:
    ended = {
        outcome.name.lower(): int(tally.ended(outcome)) for outcome in ended_in(work.scene.rolls)
    }
    valid = int(tally.valid)
    still = is_still(work.settings[which].model)
    share = ended["made"] / valid if valid else nan
    low, high = (share, share) if still and valid else wilson(ended["made"], valid, level)
    names = [kind.name.lower() for kind in Kind]
    counts = total[len(total) - width_of(work.measures) :]
    return Estimate(
        probability=share,
        low=float(low),
        high=float(high),
        confidence=level,
        shots=int(tally.shots),
        made=ended["made"],
        missed=ended["missed"],
        capped=ended["capped"],
        short=ended["short"],
        invalid=ended["invalid"],
        lodged=ended.get("lodged", 0),
        endless=ended.get("endless", 0),
        uncertain=int(tally.uncertain),
        uncertain_capped=int(tally.uncertain_capped),
        rolled=int(tally.rolled),
        slip_left=int(tally.slip_left),
        kinds=dict(zip(names, tally.of_kind().tolist(), strict=True)),
        kinds_made=dict(zip(names, tally.table[:, Outcome.MADE].tolist(), strict=True)),
        seed=work.seed,
        setting=work.settings[which].identity(),
        scene=work.scene,
        measured=spreads(counts, work.measures, level, work.catching_height),
        still=still,
    )


def told(found: Estimate | Shares) -> dict[str, str]:
    """Say what an estimate rests on."""
    return told_setting(found.setting, found.scene) | {"seed": str(found.seed)}
