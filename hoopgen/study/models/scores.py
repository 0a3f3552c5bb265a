"""Scores of a `Scatter`: derivatives of the logarithm of its density, by means and deviations.

With the deviations s, the correlations R and the noise x, u = x / s is normal with covariance R.
For a = R^-1 u the score of a mean is a / s, and that of a deviation is (u a - 1) / s. The
derivative of a probability is the covariance of the score with what happens (Glynn, 1990,
*Likelihood ratio gradient estimation for stochastic systems*).

Sums are of whole numbers: the scores times s, in units of 2^-16. So they do not depend on the
order of shots, and a sum over 10^9 shots has room for a mean square of 10^5.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from hoopgen.text.shorten import brief, join_names

from .scatter import Scatter

MEAN, SD = "mean", "sd"
"""Parameters of a normal variable: the names before the point of ``mean.speed``."""

SUMS = 4
"""Sums of each score: of valid shots, of those made, and of the squares of both."""

UNIT = 2.0**16

MAX_SQUARE = 1e4
"""Largest mean square of a score, which close correlations make large: so no sum overflows."""


def split(name: str) -> tuple[str, str]:
    """Return "mean" or "sd" and the variable of a name; "" and the name if it has no point."""
    kind, point, variable = name.partition(".")
    return (kind, variable) if point else ("", name)


def check_scored(model: object, names: Sequence[str]) -> None:
    """Refuse what has no score.

    Parameters
    ----------
    model
        The model that was given.
    names
        The variables by whose means or deviations there shall be derivatives.

    Raises
    ------
    TypeError
        If the model is no Scatter.
    ValueError
        If a variable does not scatter, or correlations are too close to 1 or -1.
    """
    if not names:
        return
    if not isinstance(model, Scatter):
        raise TypeError(
            f"gradient: {names[0]} is a derivative by a Scatter, which this model is not"
        )
    rows = model.mixing
    for name in names:
        kind, variable = split(name)
        if kind not in (MEAN, SD) or variable not in rows:
            known = join_names([f"{MEAN}.{one}, {SD}.{one}" for one in rows]) or "none"
            raise ValueError(
                f"gradient: {brief(name)} is nothing that scatters; expected one of {known}, or a "
                "parameter of the scene"
            )
    for row, name in enumerate(rows):
        unit = np.zeros((len(rows), 1))
        unit[row] = 1.0
        if not 3.0 * _inverse(model, unit)[row, 0] ** 2 < MAX_SQUARE:
            raise ValueError(
                f"gradient: the correlations of {name} are too close to 1 or -1 for a score"
            )


def _inverse(model: Scatter, u: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return R^-1 u, of columns: two triangular systems, in a fixed order."""
    rows = list(model.mixing.values())
    z = np.empty_like(u)
    for i, row in enumerate(rows):
        rest = u[i]
        for k in range(i):
            rest = rest - row[k] * z[k]
        z[i] = rest / row[i]
    for i in range(len(rows) - 1, -1, -1):
        for k in range(i + 1, len(rows)):
            z[i] = z[i] - rows[k][i] * z[k]
        z[i] = z[i] / rows[i][i]
    return z


def score_sums(
    model: Scatter,
    names: Sequence[str],
    shots: tuple[int, int],
    seed: int,
    valid: NDArray[np.bool_],
    made: NDArray[np.bool_],
) -> NDArray[np.int64]:
    """Return the sums of the scores of some shots, (names * `SUMS`,).

    Parameters
    ----------
    model
        Of the shots.
    names
        "mean.speed", "sd.elevation", ...
    shots
        The first shot, and the one after the last.
    seed
        Of the shots.
    valid, made
        Of the shots, (n,).
    """
    scattered = list(model.mixing)
    noise = model.noise(*shots, seed)
    u = np.array([noise[name] / model.sd[name] for name in scattered])
    a = _inverse(model, u)
    sums: list[np.int64] = []
    for name in names:
        kind, variable = split(name)
        row = scattered.index(variable)
        score = a[row] if kind == MEAN else u[row] * a[row] - 1.0
        for power in (score, score * score):
            whole = np.rint(power * UNIT).astype(np.int64)
            sums += [whole[valid].sum(), whole[made].sum()]
    return np.array(sums, np.int64)
