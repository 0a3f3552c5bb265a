"""Estimates of many players, each with few rows, shrunk towards what the players have in common.

Every player has an estimate of a number theta with a likelihood. The players' numbers are taken to
be normal about a common mean with a common standard deviation tau (of a spread, its logarithm, and
of a correlation, its atanh): the empirical Bayes of C. N. Morris (1983), Parametric empirical Bayes
inference, Journal of the American Statistical Association 78. Mean and tau are not plugged in but
averaged over, with flat priors (for tau, A. Gelman (2006), Prior distributions for variance
parameters in hierarchical models, Bayesian Analysis 1), so that the intervals contain their
uncertainty, too.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

PROBABILITIES: Floats = (np.arange(1_001) + 0.5) / 1_001
"""Probabilities at which the distribution of an uncertain number is kept, as its quantiles."""

MIN_PLAYERS = 4
"""Players from which on they say how different players are."""

_MEANS, _DEVIATIONS = 31, 20


def shrunk(log_likelihood: Floats, grid: Floats, centres: Floats) -> tuple[Floats, Floats]:
    """Return the distribution of each player's number, given all players.

    Parameters
    ----------
    log_likelihood
        Of each player at the points of the grid, (players, m).
    grid
        Increasing, (m,): it holds all of the likelihoods.
    centres
        Where each player's likelihood is largest, about, (players,), finite.

    Returns
    -------
    tuple of ndarray
        Means, (players,), and quantiles at `PROBABILITIES`, (players, 1001).
    """
    step = np.gradient(grid)
    likelihood = np.exp(log_likelihood - log_likelihood.max(axis=1, keepdims=True))
    mass = likelihood * step
    wide = float(np.std(centres)) + 1e-12 * (1.0 + float(np.max(np.abs(centres))))
    middle, reach = float(np.mean(centres)), 4.0 * wide / np.sqrt(len(centres)) + 1e-300
    own = _widths(mass, grid)
    reach += 3.0 * float(np.median(own)) / np.sqrt(len(centres))
    means = middle + reach * np.linspace(-1.0, 1.0, _MEANS)
    most = 4.0 * max(wide, float(np.median(own)))
    deviations = most * np.linspace(0.0, 1.0, _DEVIATIONS + 1)[1:] ** 2
    floor = float(np.median(step[np.argmax(mass, axis=1)]))
    log_weights, priors = [], []
    for deviation in np.maximum(deviations, floor):
        z = (grid - means[:, None]) / deviation
        prior = np.exp(-0.5 * z * z)
        prior /= np.maximum((prior * step).sum(axis=1, keepdims=True), 1e-300)
        priors.append(prior)
    prior = np.concatenate(priors)
    marginal = np.maximum(prior @ mass.T, 1e-300)
    # tau is spaced as the square of an even spacing: a flat prior weighs each by its own step.
    share = np.repeat(np.gradient(deviations), _MEANS)
    log_weights = np.log(marginal).sum(axis=1) + np.log(share)
    weights = np.exp(log_weights - log_weights.max())
    posterior = mass * ((weights[:, None] / marginal).T @ prior)
    posterior /= posterior.sum(axis=1, keepdims=True)
    found = posterior @ grid
    quantiles = np.empty((len(mass), len(PROBABILITIES)))
    for row, one in zip(quantiles, posterior, strict=True):
        below = np.cumsum(one) - 0.5 * one
        row[:] = np.interp(PROBABILITIES, below, grid)
    return found, quantiles


def _widths(mass: Floats, grid: Floats) -> Floats:
    """Return the standard deviation of each likelihood."""
    share = mass / mass.sum(axis=1, keepdims=True)
    mean = share @ grid
    return np.asarray(np.sqrt(np.maximum(share @ grid**2 - mean**2, 0.0)))


def fine_grid(centres: Floats, widths: Floats) -> Floats:
    """Return a grid that is fine about each player's estimate, and coarse between them.

    Parameters
    ----------
    centres
        The estimate of each player, (players,).
    widths
        The standard error of each, (players,).
    """
    near = centres[:, None] + widths[:, None] * np.linspace(-6.0, 6.0, 41)
    far = np.linspace(near.min(), near.max(), 400)
    return np.unique(np.concatenate([near.ravel(), far]))


def normal_log_likelihood(grid: Floats, centres: Floats, widths: Floats) -> Floats:
    """Return the log-likelihood of normal estimates, (players, m).

    Parameters
    ----------
    grid
        Values, (m,), at which it is wanted.
    centres, widths
        As for `fine_grid`.
    """
    return np.asarray(-0.5 * ((grid - centres[:, None]) / widths[:, None]) ** 2)
