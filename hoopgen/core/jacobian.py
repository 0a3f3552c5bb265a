"""`Jacobian`: the derivatives of results by the components of releases and by parameters."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from .variables import STATE

END_ARRAYS = ("state_derivative", "time_derivative", "differentiable")
"""Names of the derivatives at the end of shots in datasets of xarray."""

EVENT_ARRAYS = ("event_time_derivative", "before_derivative", "after_derivative")
"""Names of the derivatives at events there."""

BY_VARIABLE = ("variable", "variable_unit")
"""Names there of the dimension of variables, and of the coordinate with their units."""

OF_EVENT = ("event", "event_shot", "event_time", "event_surface")
"""Names there of the dimension of events, and of its coordinates."""


class Jacobian(Mapping[str, NDArray[np.float64]]):
    """Derivatives, a matrix for each result.

    Attributes
    ----------
    names
        The variables of the columns, k of them.
    shot
        The shot of each matrix, (m,), where a shot has several, one for each event; else None.

    Parameters
    ----------
    matrices
        By the name of a result, (..., m, k): "state" has m = 9 rows, "time" has one.
    names
        The variables of the columns.
    shot
        As the attribute.
    """

    def __init__(
        self,
        matrices: Mapping[str, NDArray[np.float64]],
        names: Sequence[str],
        shot: NDArray[np.integer] | None = None,
    ) -> None:
        self._matrices = dict(matrices)
        self.names = tuple(names)
        self.shot = shot

    def __getitem__(self, result: str) -> NDArray[np.float64]:
        return self._matrices[result]

    def __iter__(self) -> Iterator[str]:
        return iter(self._matrices)

    def __len__(self) -> int:
        return len(self._matrices)

    def __repr__(self) -> str:
        shapes = ", ".join(f"{name} {matrix.shape}" for name, matrix in self.items())
        return f"Jacobian({shapes} by {', '.join(self.names)})"

    def chain(self, release: Jacobian, shots: int | None = None) -> Jacobian:
        """Return the derivatives by what the releases were made of, by the chain rule.

        Parameters
        ----------
        release
            Derivatives of the releases, as ``hoopgen.release(..., jacobian=True)`` returns them:
            "state" of shape (n, 9, j), or (9, j) for a single release.
        shots
            The number of releases that there may be; by default that of these derivatives.

        Returns
        -------
        Jacobian
            Its columns are the j variables of `release`, then the parameters among `names`.

        Raises
        ------
        TypeError
            If `release` is no Jacobian.
        ValueError
            If a component of the state that depends on them is not among `names`, or if the
            releases are not as many as the shots.
        """
        if not isinstance(release, Jacobian):
            kind = type(release).__name__
            raise TypeError(f"release: expected the Jacobian that release returns, got a {kind}")
        matrix = release["state"]
        own = matrix.reshape(-1, *matrix.shape[-2:])
        missing = [
            name
            for row, name in enumerate(STATE)
            if name not in self.names and np.any(own[:, row] != 0.0)
        ]
        if missing:
            raise ValueError(
                f"derivatives: {', '.join(missing)} missing, on which the releases depend; "
                "simulate with derivatives by them, too"
            )
        if shots is None:
            shots = len(next(iter(self.values()))) if self.shot is None else len(own)
        if len(own) not in (1, shots):
            raise ValueError(f"release: expected the Jacobian of {shots} releases, got {len(own)}")
        if self.shot is not None and len(own) > 1:
            if np.any(self.shot >= len(own)):
                raise ValueError(
                    f"release: expected the Jacobian of all shots, got that of {len(own)}"
                )
            own = own[self.shot]
        columns = [self.names.index(name) for name in STATE if name in self.names]
        rows = [row for row, name in enumerate(STATE) if name in self.names]
        others = [column for column, name in enumerate(self.names) if name not in STATE]
        chained = {}
        for result, changes in self.items():
            moved = changes[..., columns] @ own[:, rows]
            kept = np.broadcast_to(changes[..., others], (*moved.shape[:-1], len(others)))
            chained[result] = np.concatenate([moved, kept], axis=-1)
        return Jacobian(
            chained, (*release.names, *(self.names[column] for column in others)), self.shot
        )
