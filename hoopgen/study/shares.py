"""How shots end in a scene of one's own: the share of each outcome, with its interval."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, fields
from math import nan
from typing import Any

from hoopgen.engines import Engine
from hoopgen.phrases import decimals, doubtful, interval, percent
from hoopgen.scenes import outcomes_of
from hoopgen.told import footer, told_setting
from hoopgen.words import for_json

from .intervals import wilson
from .said import SharesOfShots
from .tallies import Tally

__all__ = ["Shares", "shares_of"]

INVALID = "invalid"
"""The outcome that is no trial."""


@dataclass(frozen=True, repr=False)
class Shares(SharesOfShots):
    """How shots end, in a scene without a hoop.

    An invalid shot is no trial: shares are of the others. Outcomes that are not the scene's ends,
    such as a capped shot, are trials too.

    Attributes
    ----------
    shares
        By outcome, the ends of the scene first; NaN if all shots are invalid.
    low, high
        Wilson's interval of each.
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
    scene: Engine = field(compare=False)

    def share_of(self, by: str) -> float:
        """Return the share of the shots that end so."""
        return self.shares[by]

    @property
    def half_width(self) -> float:
        """Half the width of the widest interval."""
        return max(0.5 * (self.high[name] - self.low[name]) for name in self.shares)

    def as_dict(self) -> dict[str, Any]:
        """Return everything, in types that JSON knows; None for what is not a number."""
        plain = {one.name: getattr(self, one.name) for one in fields(self)}
        plain["scene"] = told_setting(self.setting, self.scene)["scene"]
        return {name: for_json(value) for name, value in plain.items()}

    def __str__(self) -> str:
        digits = decimals(self.half_width)
        ends = self.scene.kernels.ENDS
        rows = [
            f"{name:{_width(self)}}  {percent(share, digits)}, "
            f"{interval(self.low[name], self.high[name], digits)}"
            for name, share in self.shares.items()
            if name in ends or self.counts[name]
        ]
        counts = [f"{count:,} {name}" for name, count in self.counts.items() if count]
        counts.append(doubtful(self.uncertain, self.uncertain_capped))
        told = told_setting(self.setting, self.scene) | {"seed": str(self.seed)}
        return "\n".join(
            [
                *rows,
                f"{'':{_width(self)}}  (Wilson's {percent(self.confidence, None)} intervals)",
                f"{'shots':{_width(self)}}  {self.shots:,}: {', '.join(counts)}",
                "",
                footer(_width(self) + 2, told),
            ]
        )


def _width(found: Shares) -> int:
    """Return how wide the column of names is."""
    return max(7, *(len(name) for name in found.shares))


def shares_of(tally: Tally, setting: Any, level: float, seed: int) -> Shares:
    """Return what a tally says of a setting of `hoopgen.study.throws`."""
    scene: Engine = setting.scene
    names = outcomes_of(scene)
    counts = {name: int(tally.ended(code)) for code, name in enumerate(names)}
    trials = {name: count for name, count in counts.items() if name != INVALID}
    valid = sum(trials.values())
    ends = {name: wilson(count, valid, level) for name, count in trials.items()}
    return Shares(
        shares={name: count / valid if valid else nan for name, count in trials.items()},
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
    )
