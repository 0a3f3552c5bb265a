"""`Scatter`: a player's scatter about a mean release."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from hashlib import sha256
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hoopgen.core.argument_types import check_mapping
from hoopgen.core.parameters import ParameterValues
from hoopgen.core.validation import as_doubles
from hoopgen.core.variables import STATE, Releases, check_names, is_state
from hoopgen.engine.draws import Noise
from hoopgen.hoop.presets import NAMES, PAPER
from hoopgen.hoop.releases import states_of
from hoopgen.hoop.variables import (
    ALTERNATIVE_VARIABLES,
    ARGUMENTS,
    make_releases,
    release_arguments,
)
from hoopgen.scene.lookup import HOOP_VARIABLES
from hoopgen.text.shorten import brief

from .fitted_scatter import FittedScatter, FittedScatters
from .measured_columns import Measured, measured_columns, measured_groups, measuring_noise
from .random import check_seed, factor
from .release_model import (
    Floats,
    Given,
    Scene,
    as_states,
    check_drawn,
    check_known,
    check_spread,
    check_turns,
    spread,
)

SCATTERED = (*ARGUMENTS, *NAMES)
"""Variables that may scatter about a release at a hoop; the index of each is the stream of its
random numbers."""

_STATES = 1 << 8
"""Streams of the components of a state begin here; a parameter of another scene has one by its
name, so that it draws the same whatever else a scene has."""


def _stream(name: str) -> int:
    if name in SCATTERED:
        return SCATTERED.index(name)
    if name in STATE:
        return _STATES + STATE.index(name)
    return 1 << 63 | int.from_bytes(sha256(name.encode()).digest()[:7])


@dataclass(frozen=True)
class Scatter:
    """A player's scatter: normal about a mean release.

    Attributes
    ----------
    release
        Variables of the release aimed at, one number each; m, m/s, rad, rad/s. See `VARIABLES`.
        Or, in any scene, components of a state, x y z vx vy vz and spins, which are 0 where they
        are not given; and parameters of the scene.
    sd
        Standard deviations of arguments of `hoopgen.release`, or of components of a state, and of
        parameters of the scene. The noise is added to that release, where `aim` and `entry` have
        become speed and elevation.
    correlation
        Of pairs of names in `sd`; 0 where none is given.

    Raises
    ------
    ValueError
        If a name is unknown, a deviation is negative or not finite, an angle is in degrees (by its
        size; a deviation of elevation or azimuth, if it is 0.5 or more), or the
        correlations are not within -1 and 1, given twice, or no distribution has all of them.
    """

    release: Mapping[str, float]
    sd: Mapping[str, float] = field(default_factory=dict)
    correlation: Mapping[tuple[str, str], float] = field(default_factory=dict)

    def __post_init__(self) -> None:
        for argument in ("release", "sd", "correlation"):
            check_mapping(argument, getattr(self, argument))
        check_known("release", self.release, self._names)
        # Of a scatter alone it is not known what it is about: perhaps a state.
        hooped = self.release or any(
            name in HOOP_VARIABLES and name not in STATE for name in self.sd
        )
        plain = (name in HOOP_VARIABLES and name not in ALTERNATIVE_VARIABLES for name in self.sd)
        if hooped and not self.is_state and not all(plain):
            check_names(
                "sd",
                self.sd,
                [name for name in HOOP_VARIABLES if name not in ALTERNATIVE_VARIABLES],
            )
        for name, value in self.release.items():
            if as_doubles(f"release[{name!r}]", value).ndim:
                raise ValueError(f"release[{name!r}]: expected one number, got {brief(value)}")
        check_turns("release", self.release, self._names)
        for name, value in self.sd.items():
            deviation = as_doubles(f"sd[{name!r}]", value)
            if deviation.ndim or not 0.0 <= deviation < np.inf:
                raise ValueError(f"sd[{name!r}]: expected a number from 0, got {brief(value)}")
        check_spread("sd", self.sd, self._names)
        self._mix()

    def noise(self, start: int, stop: int, seed: int = 0) -> dict[str, NDArray[np.float64]]:
        """Return the random deviations of shots `start` to `stop` - 1, by name, (n,) each.

        Parameters
        ----------
        start, stop, seed
            As for `draw`.
        """
        check_drawn(start, stop)
        names = self._scattered()
        streams = tuple(_stream(name) for name in names)
        deviations = np.array([self.sd[name] for name in names], np.float64)
        noise = Noise(streams, self._mix(), deviations).draw(check_seed(seed), start, stop)
        return dict(zip(names, noise, strict=True))

    def draw(
        self, start: int, stop: int, seed: int = 0, parameters: ParameterValues = PAPER
    ) -> Releases:
        """Return shots `start` to `stop` - 1.

        Parameters
        ----------
        start, stop
            Indices of shots.
        seed
            From 0 to 2^64 - 1.
        parameters
            Of the scene, for those that neither `release` nor `sd` names.
        """
        columns, scene = self._about(self.release, self.noise(start, stop, seed), parameters)
        if is_state(columns):
            states = np.broadcast_to(as_states(columns), (stop - start, len(STATE)))
            return Releases(states, scene, {})
        return make_releases(columns, scene, stop - start)

    @classmethod
    def fit(
        cls,
        table: Measured,
        group: Iterable[object] | str | None = None,
        measurement_covariance: Mapping[str | tuple[str, str], ArrayLike] | None = None,
    ) -> FittedScatter[Scatter] | FittedScatters[Scatter]:
        """Fit mean, spread and correlation to measured releases, without the measuring errors.

        Outliers have little weight: `hoopgen.study.models.robust_moments` derives the estimate. It
        assumes that the other releases are normal, and independent of each other. With a group it
        is a scatter for each player. From four players on each is shrunk towards what they have in
        common, the more the fewer rows it has: `hoopgen.study.models.shrinkage`.

        Parameters
        ----------
        table
            Measured releases: what `hoopgen.fit_release` returned, of which the credible ones count
            and the covariances are taken out; a `Resample`; or columns by name, (n,) each or one
            number for all, SI, as of `Resample`. Rows that are not finite are left out. x and y
            become distance and angle. A column of equal numbers does not scatter.
        group
            The player of each row, (n,); or the name of a column of the table.
        measurement_covariance
            Of the errors of the measurement: a name with the variance, a pair of names with the
            covariance, each one number or (n,), in the square of the unit. Pairs that are not given
            have 0. None: that of `hoopgen.fit_release`; of other tables none.

        Returns
        -------
        FittedScatter or FittedScatters
            The scatter as `model`, and its uncertainty; with a group, by the player's label.

        Raises
        ------
        TypeError, ValueError
            If an argument is not as described, or the rows are too few: two more than there are
            variables that scatter, or from four players on, three of each.
        """
        columns, labels = measured_columns(table, group)
        noise = measuring_noise(table, columns, measurement_covariance)
        from .scatter_fitting import fit_columns  # needs SciPy, which nothing else here does

        return fit_columns(columns, noise, measured_groups(labels), cls)

    @property
    def _names(self) -> tuple[str, ...]:
        return (*self.release, *self.sd)

    @property
    def is_state(self) -> bool:
        """True if the release is a state, and no speed and angles at a hoop."""
        return is_state(self._names)

    @property
    def scatters(self) -> bool:
        """True if there are deviations, be they 0."""
        return bool(self.sd)

    @property
    def still(self) -> bool:
        """True if no deviation is above 0."""
        return not any(self.sd.values())

    @property
    def mixing(self) -> dict[str, NDArray[np.float64]]:
        """The rows of the factor of the correlations, by the name of each variable that scatters.

        The noise of a variable is its deviation times its row times standard normal numbers.
        """
        rows = enumerate(self._mix(), 1)
        return {name: row[:own] for name, (own, row) in zip(self._scattered(), rows, strict=True)}

    @property
    def centre(self) -> dict[str, float]:
        """Variables of the release aimed at."""
        return {name: float(value) for name, value in self.release.items()}

    def apart(self) -> tuple[dict[str, float], Scatter]:
        """Return the release aimed at, and the scatter alone."""
        return self.centre, Scatter({}, self.sd, self.correlation)

    def around(self, values: Given, noise: Given, parameters: Scene, shots: int = 1) -> Releases:
        """Return shots about other releases, the scatter as it is.

        Parameters
        ----------
        values
            Variables, one number or (m, 1).
        noise
            What `noise` gave, (shots,) each.
        parameters
            Of the scene, for those that are not among the values.
        shots
            Of each of the m releases; one comes after the other.
        """
        columns, scene = self._about({**self.release, **values}, noise, parameters)
        states = as_states(columns) if is_state(columns) else states_of(columns)
        return spread(states, scene, shots)

    def _about(
        self, values: Given, noise: Given, parameters: Scene
    ) -> tuple[dict[str, Floats], dict[str, Any]]:
        """Return arguments of `hoopgen.release`, or a state, and the scene; the noise added."""
        names = (*values, *noise)
        check_known("release", values, names, parameters)
        check_known("sd", noise, names, parameters)
        scene = dict(parameters) | {name: v for name, v in values.items() if name in parameters}
        means = {name: as_doubles(name, v) for name, v in values.items() if name not in scene}
        if is_state(names):
            spins = dict.fromkeys(STATE[6:], np.zeros(()))
            added: dict[str, Any] = {**scene, **spins, **means}
            as_states({name: added[name] for name in STATE if name in added})  # all are there
        else:
            added = {**scene, **release_arguments(means, scene)}
        for name, one in noise.items():
            added[name] = added[name] + one
        scene = {name: added.pop(name) for name in scene}
        return added, scene

    def identity(self) -> dict[str, object]:
        """Return the identity of the model, in types that JSON knows."""
        return {
            "model": "scatter",
            "release": self.centre,
            "sd": {name: float(value) for name, value in self.sd.items()},
            "correlation": [[a, b, float(value)] for (a, b), value in self.correlation.items()],
        }

    def _scattered(self) -> list[str]:
        known = [*SCATTERED, *STATE]
        others = sorted(name for name in self.sd if name not in known)
        return [name for name in (*known, *others) if self.sd.get(name)]

    def _mix(self) -> NDArray[np.float64]:
        """Return the lower triangular factor of the correlation matrix."""
        names = self._scattered()
        matrix = np.eye(len(names))
        for pair_of, value in self.correlation.items():
            if not isinstance(pair_of, tuple) or len(pair_of) != 2:
                raise TypeError(f"correlation: expected pairs of names, got {brief(pair_of)}")
            a, b = pair_of
            if a == b or a not in self.sd or b not in self.sd:
                known = ", ".join(self.sd) or "none"
                raise ValueError(f"correlation: ({brief(a)}, {brief(b)}) is no pair of {known}")
            if (b, a) in self.correlation:
                raise ValueError(f"correlation: {a} and {b} are given twice")
            pair = f"correlation: {a} and {b}"
            if not -1.0 < as_doubles(pair, value) < 1.0:
                raise ValueError(f"{pair}: expected a number within -1 and 1, got {brief(value)}")
            if a in names and b in names:
                i, j = names.index(a), names.index(b)
                matrix[i, j] = matrix[j, i] = value
        try:
            return factor(matrix)
        except np.linalg.LinAlgError:
            raise ValueError(
                f"correlation: no distribution has all of these: {brief(dict(self.correlation))}"
            ) from None
