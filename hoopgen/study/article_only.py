"""Studies of the article's hoop alone: of another scene they say so, in one line."""

from __future__ import annotations

import functools
from collections.abc import Callable
from typing import ParamSpec, TypeVar

from hoopgen.scene.lookup import check_article

Given = ParamSpec("Given")
Found = TypeVar("Found")


def of_hoop(study: Callable[Given, Found]) -> Callable[Given, Found]:
    """Make a study refuse ``scene=`` of another scene in a line, and take the article's."""

    @functools.wraps(study)
    def of_the_article(*arguments: Given.args, **options: Given.kwargs) -> Found:
        check_article(study.__name__, options.pop("scene", None))
        return study(*arguments, **options)

    return of_the_article
