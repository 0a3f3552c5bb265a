"""Studies whose question is a hoop's: of another scene they say so, in one line."""

from __future__ import annotations

import functools
from collections.abc import Callable
from typing import Any, ParamSpec, TypeVar

from hoopgen.brief import brief
from hoopgen.engines import HOOP

__all__ = ["check_hoop", "of_hoop"]

Given = ParamSpec("Given")
Found = TypeVar("Found")


def check_hoop(what: str, scene: Any) -> None:
    """Refuse a scene that is not the hoop.

    Raises
    ------
    ValueError
        If it is none; says what asks for it, and what a scene of one's own has.
    """
    if scene is None or scene is HOOP:
        return
    name = getattr(scene, "name", None)
    said = f"the scene {name}" if isinstance(name, str) else brief(scene)
    raise ValueError(
        f"{what}: its question is a hoop's, and {said} has none; simulate, certify, plot and view "
        "take any scene"
    )


def of_hoop(study: Callable[Given, Found]) -> Callable[Given, Found]:
    """Make a study refuse ``scene=`` of another scene in a line, and take the hoop's."""

    @functools.wraps(study)
    def asked(*arguments: Given.args, **options: Given.kwargs) -> Found:
        check_hoop(study.__name__, options.pop("scene", None))
        return study(*arguments, **options)

    return asked
