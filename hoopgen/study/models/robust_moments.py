"""Mean and covariance of a player's releases, measured with known errors, robust to outliers.

A row is x = mu + e + m, with the player's own deviation e of covariance V, and the error m of the
measurement, of known covariance C, which may differ from row to row: S = V + C. With the squared
distance d = (x - mu)' S^-1 (x - mu) and the weight w(d) of a Student t with `NU` degrees of freedom
the estimate solves, p being the number of variables,

    sum of w S^-1 (x - mu) = 0,     sum of S^-1 (a w (x - mu)(x - mu)' - S) S^-1 = 0.

These are M-estimators (R. A. Maronna (1976), Robust M-estimators of multivariate location and
scatter, The Annals of Statistics 4). The constant a makes E[a w d] = p for d of chi-square with p
degrees of freedom, so that without outliers the estimate tends to V, whatever C. The iteration is
that of expectation and maximization: V becomes the mean of V - B V + a w (B r)(B r)' + B U B', with
B = V S^-1, r = x - mu and U the covariance of mu, which takes the place of the degree of freedom
that the mean costs. It keeps V positive semidefinite, and V tends to a boundary where the errors
of the measurement explain the whole spread.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cache

import numpy as np
from numpy.typing import NDArray
from scipy.integrate import quad
from scipy.special import betaincinv, chdtri, gammaln

Floats = NDArray[np.float64]

NU = 5.0
"""Degrees of freedom of the t distribution whose weights are used, as in the fit of a track."""

OUTLIER = 1e-4
"""Share of good rows that are counted as outliers by chance."""

_STEPS = 2_000
_ROUNDS = 10
_TOLERANCE = 1e-7


@dataclass(frozen=True)
class Efficiency:
    """Constants of the estimate for normal data in p variables.

    Attributes
    ----------
    factor
        a, by which the covariance is unbiased.
    mean
        Efficiency of the mean: its covariance is that of the ordinary mean divided by this.
    shape, size
        sigma_1 and sigma_2 of D. E. Tyler (1982), Radial estimates and the test for sphericity,
        Biometrika 69: n times the covariance of elements (ij) and (kl) of the estimated V is
        sigma_1 (V_ik V_jl + V_il V_jk) + sigma_2 V_ij V_kl. With equal weights 1 and 0.
    """

    factor: float
    mean: float
    shape: float
    size: float


@cache
def efficiency(p: int) -> Efficiency:
    """Return the constants for p variables, by integrals over the chi-square distribution."""

    def expected(values: Callable[[float], float]) -> float:
        log = 0.5 * p * np.log(2.0) + gammaln(0.5 * p)

        def integrand(r: float) -> float:  # over r = sqrt(d), which is smooth at 0 for p = 1, too
            d = r * r
            density = 2.0 * r ** (p - 1) * np.exp(-0.5 * d - log)
            return float(values(d) * density)

        return float(quad(integrand, 0.0, 40.0, limit=200, epsabs=1e-12)[0])

    nu = NU
    plain = expected(lambda d: (nu + p) / (nu + d) * d)
    a = p / plain
    square = expected(lambda d: ((nu + p) / (nu + d)) ** 2 * d) / p
    slope = expected(lambda d: (nu + p) / (nu + d) - 2.0 / p * d * (nu + p) / (nu + d) ** 2)
    psi1 = expected(lambda d: (a * (nu + p) / (nu + d) * d) ** 2) / (p * (p + 2.0))
    psi2 = expected(lambda d: d * a * (nu + p) * nu / (nu + d) ** 2) / p
    shape = (p + 2.0) ** 2 * psi1 / (2.0 * psi2 + p) ** 2
    size = (
        (psi1 - 1.0) - 2.0 * psi1 * (psi2 - 1.0) * (p + (p + 4.0) * psi2) / (2.0 * psi2 + p) ** 2
    ) / psi2**2
    return Efficiency(a, slope**2 / square, shape, size)


@dataclass(frozen=True)
class Moments:
    """Mean and covariance of releases in p variables, and how uncertain they are.

    Attributes
    ----------
    mean, mean_covariance
        (p,) and (p, p).
    covariance
        (p, p), of the player alone: the measuring errors are not in it.
    total
        Variances with the measuring errors of a typical row, (p,).
    degrees
        Degrees of freedom of each of those, (p,): they are about chi-square.
    correlation_error
        Standard errors of atanh of the correlations, (p, p); infinite where a spread is 0.
    distances
        Squared distances of the rows from the mean, (n,).
    """

    mean: Floats
    mean_covariance: Floats
    covariance: Floats
    total: Floats
    degrees: Floats
    correlation_error: Floats
    distances: Floats

    @property
    def noise(self) -> Floats:
        """Variances of the measuring errors of a typical row, (p,)."""
        return self.total - np.diag(self.covariance)

    @property
    def correlation(self) -> Floats:
        """Correlations, (p, p); 0 where a spread is 0."""
        return correlations(self.covariance)


def correlations(covariance: Floats) -> Floats:
    """Return the correlation matrix of a covariance; 0 where a variance is 0."""
    root = np.sqrt(np.maximum(np.diag(covariance), 0.0))
    size = np.outer(root, root)
    found = np.divide(covariance, size, out=np.zeros_like(covariance), where=size > 0.0)
    np.fill_diagonal(found, 1.0)
    return np.asarray(np.clip(found, -1.0, 1.0))


def moments(
    values: Floats, noise: Floats, prior: Floats | None = None, prior_rows: float = 0.0
) -> Moments:
    """Return the robust moments of rows.

    Rows that are outliers are left out and the others fitted again, until the rows are the same: a
    weight alone bounds the influence of an outlier, and does not end it.

    Parameters
    ----------
    values
        (n, p), finite; n from 2.
    noise
        Covariance of the measuring errors, (n, p, p).
    prior, prior_rows
        A covariance, (p, p), and the number of rows that it is worth where rows are weighted. The
        moments themselves are those of the rows: it only stabilizes the weights of few rows.
    """
    p = values.shape[1]
    kept = np.ones(len(values), np.bool_)
    for _ in range(_ROUNDS):
        found = _moments(values[kept], noise[kept], prior, prior_rows)
        around = found.covariance
        if prior is not None:
            around = (prior_rows * prior + kept.sum() * around) / (prior_rows + kept.sum())
        r = values - found.mean
        # The floor is of rounding: a column may be equal in all rows but for the last digits.
        floor = 1e-12 * np.diag(_spread(values) ** 2)
        inverse = np.linalg.inv(around + noise + floor)
        distances = np.einsum("ni,nij,nj->n", r, inverse, r)
        near = distances <= chdtri(p, OUTLIER)
        if np.array_equal(near, kept) or near.sum() < max(p + 2, 0.5 * len(values)):
            break
        kept = near
    return replace(found, distances=distances)


def _moments(values: Floats, noise: Floats, prior: Floats | None, prior_rows: float) -> Moments:
    """Return the moments of rows, each with its weight."""
    n, p = values.shape
    # In units of a robust spread, so that the steps of all variables are comparable.
    unit = _spread(values)
    x, c = values / unit, noise / np.outer(unit, unit)
    own = None if prior is None else prior / np.outer(unit, unit)
    constants = efficiency(p)
    factor = _factor(p, n + (prior_rows if own is not None else 0.0))

    def step(mu: Floats, v: Floats) -> tuple[Floats, Floats]:
        """Return the next mean and covariance."""
        inverse = np.linalg.inv(v + c)
        around = inverse
        if own is not None:
            around = np.linalg.inv((prior_rows * own + n * v) / (prior_rows + n) + c)
        r = x - mu
        distances = np.einsum("ni,nij,nj->n", r, around, r)
        w = (NU + p) / (NU + distances)
        weighted = w[:, None, None] * inverse
        mean = np.linalg.solve(weighted.sum(axis=0), np.einsum("nij,nj->i", weighted, x))
        b = v @ inverse
        br = np.einsum("nij,nj->ni", b, x - mean) * np.sqrt(factor * w)[:, None]
        u = np.linalg.inv(inverse.sum(axis=0))
        after = v - b.mean(axis=0) @ v + br.T @ br / n
        after += np.einsum("nij,jk,nlk->il", b, u, b) / n
        return np.asarray(mean), 0.5 * (after + after.T) + 1e-14 * np.eye(p)

    mu, v = np.median(x, axis=0), np.diag(np.maximum(_spread(x) ** 2, 1e-12))
    scale = np.sqrt(np.diag(v + c.mean(axis=0)))
    size = np.outer(scale, scale)
    for _ in range(_STEPS):
        one = step(mu, v)
        two = step(*one)
        # Two steps tell how the rest goes on: R. Varadhan and C. Roland (2008), Simple and
        # globally convergent methods for accelerating the convergence of any EM algorithm,
        # Scandinavian Journal of Statistics 35.
        first = np.concatenate([(one[0] - mu) / scale, ((one[1] - v) / size).ravel()])
        then = np.concatenate([(two[0] - one[0]) / scale, ((two[1] - one[1]) / size).ravel()])
        if max(np.max(np.abs(first)), np.max(np.abs(then))) < _TOLERANCE:
            mu, v = two
            break
        bend = then - first
        shorter = max(float(np.linalg.norm(bend)), 1e-300)
        length = max(1.0, float(np.linalg.norm(first)) / shorter)
        ahead = 2.0 * length * first + length**2 * bend
        far = v + ahead[p:].reshape(p, p) * size
        if length > 1.0 and np.linalg.eigvalsh(far)[0] > 0.0:
            mu, v = mu + ahead[:p] * scale, far
        else:
            mu, v = two
    return _with_errors(mu, v, c, constants, unit)


@cache
def _factor(p: int, rows: float) -> float:
    """Return a for so many rows.

    Distances from the rows' own mean, by their own covariance, are no chi-square but bounded: for n
    normal rows d n / (n - 1)^2 has the beta distribution with p/2 and (n - p - 1)/2.
    """
    free = 0.5 * (rows - p - 1.0)
    if free < 0.5 or rows > 2_000.0:
        return efficiency(p).factor
    most = (rows - 1.0) ** 2 / rows
    # Quantiles of the distribution, evenly spaced in probability.
    d = most * betaincinv(0.5 * p, free, (np.arange(4_000) + 0.5) / 4_000)
    return float(np.mean(d) / np.mean((NU + p) / (NU + d) * d))


def _with_errors(mu: Floats, v: Floats, c: Floats, constants: Efficiency, unit: Floats) -> Moments:
    """Return the moments with their uncertainty, from the information of normal rows."""
    n, p = c.shape[:2]
    s = v + c
    inverse = np.linalg.inv(s)
    u = np.linalg.inv(inverse.sum(axis=0)) / constants.mean
    first, second = np.triu_indices(p)
    # d(S) / d(V_ij) has two elements off the diagonal, and one on it.
    basis = np.zeros((len(first), p, p))
    basis[np.arange(len(first)), first, second] = 1.0
    basis[np.arange(len(first)), second, first] = 1.0
    both = np.einsum("nij,kjl->nkil", inverse, basis)
    information = 0.5 * np.einsum("nkil,nmli->km", both, both) * (n - 1.0) / n
    typical = np.linalg.inv(inverse.mean(axis=0))
    flat = typical[first, second]
    errors = constants.shape * np.linalg.inv(information)
    errors += constants.size / (n - 1.0) * np.outer(flat, flat)
    pairs = zip(first.tolist(), second.tolist(), strict=True)
    places: dict[tuple[int, int], int] = {pair: k for k, pair in enumerate(pairs)}
    degrees, total = np.empty(p), np.empty(p)
    for j in range(p):
        weight = 1.0 / s[:, j, j] ** 2
        total[j] = v[j, j] + np.sum(weight * c[:, j, j]) / np.sum(weight)
        degrees[j] = 2.0 * total[j] ** 2 / errors[places[j, j], places[j, j]]
    rho = correlations(v)
    spread = np.full((p, p), np.inf)
    for i in range(p):
        for j in range(i + 1, p):
            size = v[i, i] * v[j, j]
            if not size > 1e-12:
                continue
            slope = np.zeros(len(first))
            slope[places[i, j]] = 1.0 / np.sqrt(size)
            slope[places[i, i]] = -0.5 * rho[i, j] / v[i, i]
            slope[places[j, j]] = -0.5 * rho[i, j] / v[j, j]
            variance = float(slope @ errors @ slope)
            bend = max(1.0 - rho[i, j] ** 2, 1e-6)
            spread[i, j] = spread[j, i] = np.sqrt(max(variance, 0.0)) / bend
    two = np.outer(unit, unit)
    return Moments(mu * unit, u * two, v * two, total * unit**2, degrees, spread, np.zeros(n))


def _spread(values: Floats) -> Floats:
    """Return a robust standard deviation of each column, above 0."""
    middle = np.median(values, axis=0)
    off = 1.4826 * np.median(np.abs(values - middle), axis=0)
    plain = np.std(values, axis=0)
    found = np.where(off > 1e-3 * plain, off, plain)
    return np.where(found > 0.0, found, 1.0)
