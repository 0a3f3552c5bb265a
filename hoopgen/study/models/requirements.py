"""Requirements of questions that vary a player's release."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from hoopgen.scene.lookup import HOOP_VARIABLES
from hoopgen.text.shorten import brief

from .resample import Resample
from .scatter import Scatter


def check_model(model: object, over: Iterable[str]) -> Scatter | Resample:
    """Return a model whose release is varied over some variables.

    Parameters
    ----------
    model
        The model that was given.
    over
        The variables whose means are varied.
    """
    if not isinstance(model, Scatter | Resample):
        raise TypeError(f"model: expected a Scatter or a Resample, got {brief(model)}")
    twice = [name for name in over if isinstance(model, Scatter) and name in model.release]
    if twice:
        raise ValueError(f"release: {', '.join(twice)} already in over; leave out of one")
    return model


def scaled(model: Scatter | Resample, factor: float) -> Scatter | Resample:
    """Return a model all of whose scatter is so many times as wide.

    Of a `Scatter` the standard deviations, of a `Resample` how far each row is from the means.

    Parameters
    ----------
    model
        The model, which stays as it is.
    factor
        How many times as wide the scatter is made.
    """
    if isinstance(model, Scatter):
        sd = {name: factor * deviation for name, deviation in model.sd.items()}
        return Scatter(model.release, sd, model.correlation)
    columns = {
        name: model.centre[name] + factor * (np.asarray(column) - model.centre[name])
        if np.ndim(column)
        else column
        for name, column in model.columns.items()
    }
    return Resample(columns, model.group)


def alike(model: Scatter | Resample) -> dict[str, float]:
    """Return the variables that are the same in all shots, be it for the scatter."""
    if isinstance(model, Scatter):
        return model.centre
    same = (name for name, column in model.columns.items() if not np.ndim(column))
    return {name: model.centre[name] for name in same if model.is_state or name in HOOP_VARIABLES}


def scene_by_row(model: Scatter | Resample, parameters: Iterable[str]) -> list[str]:
    """Return the parameters of the scene that were measured with each release.

    Parameters
    ----------
    model
        The model of the releases.
    parameters
        The names of the parameters of the scene.
    """
    columns = {} if isinstance(model, Scatter) else model.columns
    return [name for name in parameters if np.ndim(columns.get(name, 0.0))]
