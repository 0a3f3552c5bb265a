"""A sample of a player's shots, for ``hoopgen fan`` and ``landings``: its shares and intervals."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from types import SimpleNamespace
from typing import TYPE_CHECKING, Any

import hoopgen
from hoopgen.hoop.releases import CATCHING_HEIGHT
from hoopgen.report.provenance import describe_setting, footer, sentences
from hoopgen.report.quantities import STILL
from hoopgen.text.numbers import format_count, format_interval, format_percent, format_uncertain

from .invalid_warnings import warn_invalid_shots
from .release_options import Releasing

if TYPE_CHECKING:
    from hoopgen.core.variables import Releases
    from hoopgen.study.statistics.outcome_shares import Shares
    from hoopgen.study.statistics.sample import Rows

CONFIDENCE = 0.95
"""Confidence of intervals, as of `hoopgen estimate`."""

NAMES = 9
"""Width of the column of names, in letters."""


@dataclass(frozen=True)
class ShotSample:
    """A sample of a player's shots, their results and the shares of their outcomes.

    Attributes
    ----------
    setting
        Release model and parameters.
    released, shots
        The releases and their results.
    shares
        Of the outcomes, with the intervals of the simulation and of measured releases.
    rows
        Of measured releases, each thrown once with its measures; None of other models.
    """

    setting: Any
    released: Releases
    shots: hoopgen.Shots
    shares: Shares
    rows: Rows | None

    @cached_property
    def provenance(self) -> dict[str, str]:
        """The provenance of the shots, in words."""
        description = describe_setting(self.setting.identity(), self.shots.scene)
        return description | {"seed": str(self.shares.seed)}

    @property
    def line(self) -> str:
        """The shares of the outcomes with their intervals, in words, line by line."""
        shares, level = self.shares, format_percent(CONFIDENCE, None)
        said = [f"{format_percent(shares.shares[name])} {name}" for name in self._there]
        if invalid := shares.counts["invalid"]:
            said.append(f"{invalid:,} invalid")
        if shares.uncertain:
            said.append(format_uncertain(shares.uncertain, shares.uncertain_capped))
        lines = [f"{'shots':{NAMES}}{shares.shots:,}: {', '.join(said)}"]
        if shares.still:
            return f"{lines[0]} ({STILL})"
        if not self._there:
            return lines[0]
        alone = " of the simulation alone" if shares.sample else ""
        lines.append(f"{'interval':{NAMES}}{self._ends} (Wilson's {level} intervals{alone})")
        if shares.sample:
            of = f"({level} intervals of the sample, {self._measured})"
            lines.append(f"{'sample':{NAMES}}{self._sample_ends} {of}")
        return "\n".join(lines)

    @property
    def note(self) -> str:
        """The intervals and the provenance as sentences, for a picture."""
        shares, level = self.shares, format_percent(CONFIDENCE, None)
        said = f"{level} intervals: {self._ends}."
        if shares.sample:
            said = (
                f"{level} intervals of the simulation alone: {self._ends}; of the sample, "
                f"{self._measured}: {self._sample_ends}."
            )
        parts = [] if shares.still or not self._there else [said]
        if invalid := shares.counts["invalid"]:
            parts.insert(0, f"{invalid:,} of {format_count(shares.shots, 'shot')} invalid.")
        return " ".join([*parts, sentences(self.provenance)])

    @property
    def footer(self) -> str:
        """The provenance, line by line."""
        return footer(NAMES, self.provenance)

    @property
    def _there(self) -> list[str]:
        """The outcomes of which there are shots, the invalid ones apart."""
        return [name for name in self.shares.shares if self.shares.counts[name]]

    @property
    def _ends(self) -> str:
        ends = {name: self.shares.ends_of(name) for name in self._there}
        return ", ".join(f"{name} {format_interval(*one)}" for name, one in ends.items())

    @property
    def _sample_ends(self) -> str:
        sample = self.shares.sample
        found = {name: sample[name] for name in self._there if name in sample}
        found = found or dict(sample)
        return ", ".join(f"{n} {format_interval(one.low, one.high)}" for n, one in found.items())

    @property
    def _measured(self) -> str:
        return next(iter(self.shares.sample.values())).words


def sample_shots(
    releasing: Releasing,
    count: int,
    *,
    seed: int,
    record: bool = False,
    measures: Sequence[str] = (),
    catching_height: float = CATCHING_HEIGHT,
    **options: Any,
) -> ShotSample:
    """Sample a player's shots and simulate them.

    Parameters
    ----------
    releasing
        The releases that the options of the command describe.
    count
        The number of shots.
    seed
        The seed of the random numbers.
    record
        True if the paths are wanted, too.
    measures, catching_height
        What is measured of each measured release, as for `hoopgen.measure`.
    **options
        `max_contacts`, `backend` and `threads`, as for `hoopgen.simulate`.
    """
    from hoopgen.study.jobs.monte_carlo import setting_of
    from hoopgen.study.models.resample import Resample
    from hoopgen.study.statistics.outcome_shares import shares_of
    from hoopgen.study.statistics.sample import sampled_rows
    from hoopgen.study.statistics.tally import Tally, contacts_of

    setting = setting_of(*releasing.model(), releasing.engine)
    scene, model = setting.scene, setting.model
    released = model.draw(0, count, seed, setting.parameters)
    shots = hoopgen.simulate(
        released.states, released.parameters, scene=scene, record=record, **options
    )
    tally = Tally.read(Tally.from_shots(shots, 1).row()[0], scene)
    shares, rows = shares_of(tally, setting, CONFIDENCE, seed), None
    options["max_contacts"] = contacts_of(options.get("max_contacts"), scene)
    if isinstance(model, Resample):
        rows = sampled_rows(setting, measures=measures, catching_height=catching_height, **options)
        shares = shares.with_rows(rows)
    elif releasing.fitted and scene.has_hoop:
        shares = replace(shares, sample=_of_fit(releasing, setting, shares, options))
    sample = ShotSample(setting, released, shots, shares, rows)
    warn_invalid_shots(model, released, shots, shares.counts["invalid"], count)
    return sample


def _of_fit(
    releasing: Releasing, setting: Any, shares: Shares, options: Mapping[str, Any]
) -> dict[str, Any]:
    """Return the interval of the share made that contains the uncertainty of a fitted scatter."""
    from hoopgen.study.statistics.fitted_sample import sample_of_fit

    low, high = shares.ends_of("made")
    found = SimpleNamespace(
        probability=shares.share_of("made"),
        low=low,
        high=high,
        confidence=CONFIDENCE,
        seed=shares.seed,
    )
    fitted: Any = releasing.fit()
    return {"made": sample_of_fit(fitted, setting, found, **options)}
