"""Checks of the options of a simulation that depend on its scene."""

from __future__ import annotations

import math
from collections.abc import Iterable

from hoopgen.core.argument_types import is_names
from hoopgen.core.backend_names import BACKEND_NAMES, BackendName
from hoopgen.core.validation import check_time_limit
from hoopgen.engine.compiled_scene import CompiledScene
from hoopgen.text.shorten import brief, join_alternatives, join_names


def check_backend(backend: str) -> BackendName:
    """Return the name of a backend.

    Raises
    ------
    ValueError
        If it is none.
    """
    for name in BACKEND_NAMES:
        if isinstance(backend, str) and backend == name:
            return name
    names = join_alternatives(map(repr, BACKEND_NAMES))
    raise ValueError(f"backend: expected {names}, got {brief(backend)}")


def check_fields(fields: str | Iterable[str], scene: CompiledScene) -> tuple[str, ...]:
    """Return the names of the results that are wanted.

    Parameters
    ----------
    fields
        "all", or one or several names.
    scene
        The scene.

    Raises
    ------
    TypeError, ValueError
        If they are not names of results of the scene.
    """
    if isinstance(fields, str):
        if fields == "all":
            return scene.layout.fields
        fields = (fields,)
    if not is_names(fields):
        raise TypeError(f"fields: expected 'all' or names, got {brief(fields)}")
    wanted = tuple(fields)  # once: they may be an iterator
    unknown = [name for name in wanted if name not in scene.layout.results]
    if unknown:
        names = ", ".join(scene.layout.fields + scene.layout.bounds)
        raise ValueError(f"fields: unknown {join_names(unknown)}. 'all', or some of {names}")
    return wanted


def check_limit(time_limit: float | None, engine: CompiledScene) -> float:
    """Return the time limit of shots in a scene, s; infinity for none.

    Parameters
    ----------
    time_limit
        The caller's limit, s; None: the scene's default.
    engine
        The scene.

    Raises
    ------
    TypeError, ValueError
        If it is not one, or if there is none where a ball may roll for ever.
    """
    limit = engine.time_limit if time_limit is None else check_time_limit(time_limit)
    if engine.rolls and not math.isfinite(limit):
        raise ValueError(
            f"time_limit: expected a finite time in the scene {engine.name}, where a ball may roll "
            f"for ever; got {brief(time_limit)}"
        )
    return limit
