"""The formulas of studies that need no scene: in NumPy, and those of intervals in JavaScript."""

from __future__ import annotations

from hoopgen.derive.scenes import SCENES
from hoopgen.derive.studies import INTERVALS, SCENELESS

from .elementary import ElementaryFunction
from .js import JsKernel
from .program import lower
from .stamp import shared_stamp_of

FILES = {"numpy/studies.py.j2": "numpy/studies.py", "js/studies.js.j2": "js/studies.js"}
"""By template, the file that it makes below generated/."""


def studies_context(template: str) -> dict[str, object]:
    """Return the variables of a template of these formulas."""
    in_pages = template.startswith("js/")
    view, kernels = (JsKernel, INTERVALS) if in_pages else (ElementaryFunction, SCENELESS)
    return {
        "kernels": [view(lower(one)) for one in kernels],
        "stamp": shared_stamp_of(template, SCENES[0]),
    }
