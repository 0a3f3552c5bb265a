"""The interval of a probability that contains the uncertainty of a fitted scatter.

Scatters that the measured releases allow are drawn, and the same random numbers are thrown with
each and with the fitted one. The differences of their shares are the error of the sample; that of
the simulation is added as an independent one.
"""

from __future__ import annotations

from math import hypot
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from hoopgen.core.backend_names import BackendName
from hoopgen.results.shots import Outcome
from hoopgen.simulation.simulate import simulate
from hoopgen.study.models.fitted_scatter import FittedScatter
from hoopgen.study.models.scatter import Scatter

from .sample import SampleInterval

MODELS, SHOTS = 400, 2_000
"""Scatters that are drawn, and shots with each."""

_TOGETHER = 50
"""Scatters whose shots are simulated together."""


class _Estimated(Protocol):
    """The result of a simulation: a share with its interval."""

    @property
    def probability(self) -> float: ...

    @property
    def low(self) -> float: ...

    @property
    def high(self) -> float: ...

    @property
    def confidence(self) -> float: ...

    @property
    def seed(self) -> int: ...


def sample_of_fit(
    fitted: FittedScatter[Scatter],
    setting: Any,
    found: _Estimated,
    max_contacts: int,
    backend: BackendName,
    threads: int | None,
) -> SampleInterval:
    """Return the interval of the share made, with the uncertainty of a fitted scatter.

    Parameters
    ----------
    fitted
        What `Scatter.fit` returned.
    setting
        Its scene: a setting of `hoopgen.study.jobs.monte_carlo`.
    found
        The estimate with the fitted scatter.
    max_contacts, backend, threads
        As for `hoopgen.simulate`.
    """
    models = [fitted.model, *fitted.models(MODELS, found.seed)]
    options = setting, found.seed, max_contacts, backend, threads
    parts = range(0, len(models), _TOGETHER)
    shares = np.concatenate([made_shares(models[k : k + _TOGETHER], *options) for k in parts])
    off = shares[1:] - shares[0]
    tail = 0.5 - 0.5 * found.confidence
    below, above = np.nanquantile(off, [tail, 1.0 - tail])
    down = hypot(min(float(below), 0.0), found.probability - found.low)
    up = hypot(max(float(above), 0.0), found.high - found.probability)
    low, high = max(0.0, found.probability - down), min(1.0, found.probability + up)
    return SampleInterval(found.probability, low, high, fitted.rows, None)


def made_shares(
    models: list[Scatter],
    setting: Any,
    seed: int,
    max_contacts: int,
    backend: BackendName,
    threads: int | None,
) -> NDArray[np.float64]:
    """Return the share of the valid shots of each model that are made.

    Parameters
    ----------
    models
        The models, which differ in their numbers alone.
    setting
        The setting: its scene and the parameters of that.
    seed
        The seed, the same for all models.
    max_contacts
        The number of contacts at which a shot ends as capped.
    backend
        What simulates the shots.
    threads
        The number of threads; None is one for each processor.
    """
    drawn = [model.draw(0, SHOTS, seed, setting.parameters) for model in models]
    first = drawn[0].parameters
    parameters = {
        name: np.concatenate([np.broadcast_to(one.parameters[name], SHOTS) for one in drawn])
        if any(np.ndim(one.parameters[name]) for one in drawn)
        else value
        for name, value in first.items()
    }
    shots = simulate(
        np.concatenate([one.states for one in drawn]),
        parameters,
        scene=setting.scene,
        max_contacts=max_contacts,
        backend=backend,
        threads=threads,
        fields=("outcome",),
    )
    ended = shots.outcome.reshape(len(models), SHOTS)
    valid = (ended != setting.scene.outcomes["INVALID"]).sum(axis=1)
    with np.errstate(invalid="ignore"):
        share: NDArray[np.float64] = (ended == Outcome.MADE).sum(axis=1) / valid
    return share
