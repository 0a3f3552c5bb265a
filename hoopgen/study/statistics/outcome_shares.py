"""Shares of the outcomes of shots in a scene of one's own, with their intervals."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from math import nan
from typing import Any

import numpy as np

from hoopgen.engine.compiled_scene import CompiledScene
from hoopgen.report.provenance import describe_setting, footer
from hoopgen.report.quantities import STILL, for_json
from hoopgen.scene.lookup import outcomes_of
from hoopgen.study.models.release_model import is_still
from hoopgen.study.result import SharesOfShots
from hoopgen.text.numbers import format_interval, format_percent, format_uncertain, percent_decimals

from .intervals import wilson_interval
from .sample import Rows, SampleInterval
from .tally import Tally

INVALID = "invalid"
"""The outcome that is no trial."""


@dataclass(frozen=True, repr=False)
class Shares(SharesOfShots):
    """The shares of the outcomes of shots, in a scene without a hoop.

    An invalid shot is no trial: shares are of the others. Outcomes that are not the scene's ends,
    such as a capped shot, are trials too.

    Attributes
    ----------
    shares
        By outcome, the ends of the scene first; NaN if all shots are invalid.
    low, high
        Wilson's interval of each: that of the simulation alone. Without scatter every throw is the
        same, and both are the share.
    confidence
        Of the intervals.
    shots
        Drawn.
    counts
        By outcome, the invalid ones too.
    uncertain
        With a decision within its rounding-error bound.
    uncertain_capped
        Capped ones among those.
    seed
        Of the random numbers.
    setting
        Release model, parameters and what tells the scene from others.
    scene
        In which the shots were thrown.
    sample
        Of measured releases: by outcome the interval which contains the uncertainty of the sample.
    still
        Whether nothing scatters.
    """

    shares: Mapping[str, float]
    low: Mapping[str, float]
    high: Mapping[str, float]
    confidence: float
    shots: int
    counts: Mapping[str, int]
    uncertain: int
    uncertain_capped: int
    seed: int
    setting: Mapping[str, Any]
    scene: CompiledScene = field(compare=False)
    sample: Mapping[str, SampleInterval] = field(default_factory=dict)
    still: bool = False

    def share_of(self, by: str) -> float:
        """Return the share of the shots that end so."""
        return self.shares[by]

    def ends_of(self, by: str) -> tuple[float, float]:
        """Return the interval of the share of the shots that end so."""
        return self.low[by], self.high[by]

    def with_rows(self, rows: Rows | None) -> Shares:
        """Return this with the intervals of the sample whose rows they are; None: as it is."""
        if rows is None:
            return self
        codes = {name: code for code, name in enumerate(self.counts)}
        sample = {name: rows.share(codes[name], self.confidence) for name in self.shares}
        return replace(self, sample=sample)

    @property
    def half_width(self) -> float:
        """Half the width of the widest interval."""
        return max(0.5 * (self.high[name] - self.low[name]) for name in self.shares)

    def as_dict(self) -> dict[str, Any]:
        """Return everything, in types that JSON knows; None for what is not a number."""
        plain = dict(vars(self))
        plain["scene"] = describe_setting(self.setting, self.scene)["scene"]
        sample = {name: one.as_dict() for name, one in plain.pop("sample").items()}
        plain |= {"sample": sample} if sample else {}
        return {name: for_json(value) for name, value in plain.items()}

    def _share_line(self, name: str, digits: int) -> str:
        """Say a share with its intervals."""
        text = format_percent(self.shares[name], digits)
        if self.still:
            return text
        text = f"{text}, {format_interval(self.low[name], self.high[name], digits)}"
        if name in self.sample:
            one = self.sample[name]
            text = f"{text}; of the sample {format_interval(one.low, one.high)}"
        return text

    @property
    def _intervals(self) -> str:
        """The kind of the intervals."""
        if self.still:
            return STILL
        wilson = f"Wilson's {format_percent(self.confidence, None)} intervals"
        if not self.sample:
            return wilson
        of = next(iter(self.sample.values())).words
        return f"{wilson} of the simulation alone; those of the sample, {of}, contain both"

    def __str__(self) -> str:
        digits = percent_decimals(self.half_width)
        ends = self.scene.kernels.ENDS
        rows = [
            f"{name:{_width(self)}}  {self._share_line(name, digits)}"
            for name in self.shares
            if name in ends or self.counts[name]
        ]
        counts = [f"{count:,} {name}" for name, count in self.counts.items() if count]
        counts.append(format_uncertain(self.uncertain, self.uncertain_capped))
        provenance = describe_setting(self.setting, self.scene) | {"seed": str(self.seed)}
        return "\n".join(
            [
                *rows,
                f"{'':{_width(self)}}  ({self._intervals})",
                f"{'shots':{_width(self)}}  {self.shots:,}: {', '.join(counts)}",
                "",
                footer(_width(self) + 2, provenance),
            ]
        )


def _width(found: Shares) -> int:
    """Return the width of the column of names."""
    return max(7, *(len(name) for name in found.shares))


def shares_of(tally: Tally, setting: Any, level: float, seed: int) -> Shares:
    """Return the shares from the tally of a setting of `hoopgen.study.jobs.monte_carlo`.

    Parameters
    ----------
    tally
        The numbers of shots by outcome.
    setting
        The setting that they were thrown in.
    level
        The confidence of the intervals, from 0 to 1.
    seed
        The seed that they were drawn with.
    """
    scene: CompiledScene = setting.scene
    names = outcomes_of(scene)
    counts = {name: int(tally.ended(code)) for code, name in enumerate(names)}
    trials = {name: count for name, count in counts.items() if name != INVALID}
    valid = sum(trials.values())
    shares = {name: count / valid if valid else nan for name, count in trials.items()}
    ends = {name: wilson_interval(count, valid, level) for name, count in trials.items()}
    still = is_still(setting.model)
    if still and valid:
        ends = {name: (np.asarray(share), np.asarray(share)) for name, share in shares.items()}
    return Shares(
        shares=shares,
        low={name: float(low) for name, (low, _) in ends.items()},
        high={name: float(high) for name, (_, high) in ends.items()},
        confidence=level,
        shots=int(tally.shots),
        counts=counts,
        uncertain=int(tally.uncertain),
        uncertain_capped=int(tally.uncertain_capped),
        seed=seed,
        setting=setting.identity(),
        scene=scene,
        still=still,
    )
