"""The formulas of studies that need no scene, releases and intervals: in NumPy and JavaScript."""

from __future__ import annotations

from hoopgen.derive.scenes import SCENES
from hoopgen.derive.studies import SCENELESS, noise

from .elementary import ElementaryFunction
from .js import JsKernel
from .program import lower
from .stamp import shared_stamp_of

FILES = {"numpy/studies.py.j2": "numpy/studies.py", "js/studies.js.j2": "js/studies.js"}
"""By template, the file that it makes below generated/."""

_NOT_IN_PAGES = ("release_jacobian", *(one.name for one in noise.kernels()))


def studies_context(template: str) -> dict[str, object]:
    """Return the variables of a template of these formulas."""
    in_pages = template.startswith("js/")
    view, left_out = (JsKernel, _NOT_IN_PAGES) if in_pages else (ElementaryFunction, ())
    return {
        "kernels": [view(lower(one)) for one in SCENELESS if one.name not in left_out],
        "stamp": shared_stamp_of(template, SCENES[0]),
    }
