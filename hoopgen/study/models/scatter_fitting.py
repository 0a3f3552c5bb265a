"""The fit of players' scatter to columns of measured releases.

`robust_moments` has the estimate for one player, `shrinkage` what many players say of each.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.special import chdtri, ndtri, stdtrit

from hoopgen.text.shorten import brief

from .fitted_scatter import (
    LARGEST_CORRELATION,
    FittedScatter,
    FittedScatters,
    Make,
    Model,
    Uncertain,
    consistent,
)
from .robust_moments import OUTLIER, Moments, moments
from .shrinkage import MIN_PLAYERS, PROBABILITIES, fine_grid, normal_log_likelihood, shrunk

Floats = NDArray[np.float64]


def fit_columns(
    columns: Mapping[str, Floats],
    noise: Mapping[tuple[str, str], Floats],
    group: Iterable[str] | None,
    make: Make[Model],
) -> FittedScatter[Model] | FittedScatters[Model]:
    """Return the scatter of measured releases; by group if there is one.

    Parameters
    ----------
    columns
        Variables, (n,) each or one number for all; rows that are not finite are left out.
    noise
        Covariances of the measuring errors by pairs of names, each pair once, (n,) or one number.
    group
        The player of each row, (n,).
    make
        Makes a model of release, standard deviations and correlations.
    """
    rows = max(np.size(one) for one in columns.values())
    full = {name: np.broadcast_to(one, rows) for name, one in columns.items()}
    errors = {pair: np.broadcast_to(one, rows) for pair, one in noise.items()}
    good = np.all([np.isfinite(one) for one in (*full.values(), *errors.values())], axis=0)
    labels = None if group is None else np.asarray(list(group), dtype=object)
    if labels is not None and len(labels) != rows:
        raise ValueError(f"group: expected a label for each of {rows} rows, got {len(labels)}")
    names = [n for n, one in full.items() if good.any() and np.ptp(one[good]) > 0.0]
    fixed = {n: float(one[good][0]) for n, one in full.items() if n not in names and good.any()}
    least = len(names) + 2
    if good.sum() < max(least, 2) or not names:
        raise ValueError(
            f"table: expected at least {least} releases that are not all alike, all numbers of "
            f"each finite, for a scatter in {len(names)} variables; got {int(good.sum())}"
        )
    values = np.stack([full[n][good] for n in names], axis=1)
    covariance = np.zeros((len(values), len(names), len(names)))
    for (a, b), one in errors.items():
        if a in names and b in names:
            i, j = names.index(a), names.index(b)
            covariance[:, i, j] = covariance[:, j, i] = one[good]
    if labels is None:
        found = moments(values, covariance)
        return _fitted(found, names, fixed, None, make)
    return _players(values, covariance, labels[good], names, fixed, make)


def _players(
    values: Floats,
    noise: Floats,
    labels: NDArray[Any],
    names: list[str],
    fixed: Mapping[str, float],
    make: Make[Model],
) -> FittedScatters[Model]:
    """Return the scatter of each player, shrunk if there are enough of them."""
    p, least = len(names), 3
    players = list(dict.fromkeys(map(str, labels)))
    where = {one: np.flatnonzero(labels.astype(str) == one) for one in players}
    few = {one: len(rows) for one, rows in where.items() if len(rows) < least}
    players = [one for one in players if one not in few]
    alone = [one for one in players if len(where[one]) < p + 2]
    if not players or (alone and len(players) < MIN_PLAYERS):
        counts = ", ".join(f"{name} {len(rows)}" for name, rows in where.items())
        raise ValueError(
            f"group: expected at least {p + 2} releases of a player, or {least} of each of "
            f"{MIN_PLAYERS} players or more; got {brief(counts)}"
        )
    own = np.concatenate([where[one] for one in players])
    middle = np.concatenate(
        [values[where[one]] - np.median(values[where[one]], axis=0) for one in players]
    )
    pooled = None
    if len(players) > 1 and len(own) - len(players) >= p + 2:
        pooled = moments(middle, noise[own]).covariance * len(own) / (len(own) - len(players))
    found = [moments(values[where[one]], noise[where[one]], pooled, p + 2.0) for one in players]
    together = _shrunk(found, p) if len(players) >= MIN_PLAYERS else [None] * len(players)
    fitted = {
        one: _fitted(each, names, fixed, more, make)
        for one, each, more in zip(players, found, together, strict=True)
    }
    return FittedScatters(fitted, few)


_Posterior = tuple[list[Uncertain], list[Uncertain], dict[tuple[int, int], Uncertain]]


def _fitted(
    found: Moments,
    names: list[str],
    fixed: Mapping[str, float],
    posterior: _Posterior | None,
    make: Make[Model],
) -> FittedScatter[Model]:
    means, spreads, rhos = posterior or _alone(found)
    mean = dict(zip(names, means, strict=True))
    sd = dict(zip(names, spreads, strict=True))
    rho = {(names[i], names[j]): one for (i, j), one in rhos.items()}
    values = {name: one.value for name, one in sd.items()}
    model = make(
        {**fixed, **{name: one.value for name, one in mean.items()}},
        values,
        consistent(values, {pair: one.value for pair, one in rho.items()}),
    )
    far = found.distances > chdtri(len(names), OUTLIER)
    return FittedScatter(
        model,
        len(found.distances),
        int(far.sum()),
        mean,
        sd,
        rho,
        dict(zip(names, np.sqrt(found.total).tolist(), strict=True)),
        fixed,
        posterior is not None,
        make,
    )


def _alone(found: Moments) -> _Posterior:
    """Return the estimate from a player's rows alone."""
    p = len(found.mean)
    width = np.sqrt(np.diag(found.mean_covariance))
    means = [
        Uncertain(
            float(found.mean[j]),
            found.mean[j] + width[j] * stdtrit(max(found.degrees[j], 1.0), PROBABILITIES),
        )
        for j in range(p)
    ]
    spreads = []
    for j in range(p):
        free = max(found.degrees[j], 1.0)
        variance = found.total[j] * free / chdtri(free, PROBABILITIES) - found.noise[j]
        spreads.append(
            Uncertain(
                float(np.sqrt(max(found.covariance[j, j], 0.0))),
                np.sqrt(np.maximum(variance, 0.0)),
            )
        )
    rhos = {}
    for i in range(p):
        for j in range(i + 1, p):
            at, error = _atanh(found, i, j)
            rhos[i, j] = Uncertain(float(np.tanh(at)), np.tanh(at + error * ndtri(PROBABILITIES)))
    return means, spreads, rhos


def _atanh(found: Moments, i: int, j: int) -> tuple[float, float]:
    """Return atanh of a correlation, and its standard error; 3 where nothing is known."""
    rho = float(np.clip(found.correlation[i, j], -LARGEST_CORRELATION, LARGEST_CORRELATION))
    return float(np.arctanh(rho)), float(min(found.correlation_error[i, j], 3.0))


def _shrunk(found: list[Moments], p: int) -> list[_Posterior]:
    """Return the estimate of each player from all players."""
    means, spreads = [], []
    for j in range(p):
        centres = np.array([one.mean[j] for one in found])
        widths = np.array([np.sqrt(one.mean_covariance[j, j]) for one in found])
        # Quantiles of t are wider than the normal ones: the likelihood is made as wide.
        widths *= [stdtrit(max(one.degrees[j], 2.0), 0.975) / 1.96 for one in found]
        grid = fine_grid(centres, widths)
        means.append(shrunk(normal_log_likelihood(grid, centres, widths), grid, centres))
        spreads.append(_shrunk_spreads(found, j))
    rhos = {}
    for i in range(p):
        for j in range(i + 1, p):
            at = np.array([_atanh(one, i, j) for one in found])
            grid = fine_grid(at[:, 0], at[:, 1])
            middle, quantiles = shrunk(normal_log_likelihood(grid, *at.T), grid, at[:, 0])
            rhos[i, j] = np.tanh(middle), np.tanh(quantiles)
    return [
        (
            [Uncertain(float(m[k]), q[k]) for m, q in means],
            [Uncertain(float(m[k]), q[k]) for m, q in spreads],
            {pair: Uncertain(float(m[k]), q[k]) for pair, (m, q) in rhos.items()},
        )
        for k in range(len(found))
    ]


def _shrunk_spreads(found: list[Moments], j: int) -> tuple[Floats, Floats]:
    """Return the standard deviations of a variable and their quantiles, by player.

    The estimated variance with the measuring errors, times its degrees of freedom and divided by
    its true value, is chi-square.
    """
    total = np.array([one.total[j] for one in found])
    free = np.array([max(one.degrees[j], 1.0) for one in found])
    noise = np.array([one.noise[j] for one in found])
    least = 0.02 * float(np.sqrt(np.median(total)))  # what is smaller, no shot shows
    centres = np.log(np.maximum(np.sqrt(np.maximum(total - noise, 0.0)), least))
    widths = np.minimum(np.sqrt(0.5 / free) * total / np.maximum(total - noise, least**2), 3.0)
    grid = fine_grid(centres, widths)
    true = np.exp(2.0 * grid) + noise[:, None]
    likelihood = -0.5 * free[:, None] * (np.log(true) + total[:, None] / true)
    middle, quantiles = shrunk(likelihood, grid, centres)
    return np.exp(middle), np.exp(quantiles)
