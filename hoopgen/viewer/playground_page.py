"""The playground: a page that simulates shots itself, by the C engine as WebAssembly."""

from __future__ import annotations

import base64
import os
from collections.abc import Mapping
from functools import cache
from statistics import NormalDist
from typing import Any

from hoopgen.core.colours import MADE, MISSED, OTHER_OUTCOME_COLOURS
from hoopgen.core.files import PAGES, check_output, write
from hoopgen.core.units import DEGREE, DISPLAY_UNITS, FOOT, TURN, UNITS
from hoopgen.core.validation import BackendName
from hoopgen.engine import web_assembly
from hoopgen.engine.verification import first_primes
from hoopgen.generated.numpy import elementary
from hoopgen.hoop.kinds import Kind, kind_table
from hoopgen.hoop.presets import PRESETS
from hoopgen.hoop.releases import CATCHING_HEIGHT, RING_HEIGHT, release
from hoopgen.hoop.search_range import HALF_WIDTHS, LIMITS
from hoopgen.hoop.variables import VARIABLES
from hoopgen.simulation.fingerprint import MAX_CONTACTS, SHOTS, TIME_LIMIT, fingerprint
from hoopgen.simulation.hoop import HOOP, KINDS
from hoopgen.simulation.simulate import simulate

from .net_and_court import net_and_court
from .page import Extension, fill_page, json_element, page_data, read
from .page_file import Page

__all__ = ["CONFIDENCE", "SHARED", "THROWS", "own_file", "page_spec", "playground"]

THROWS = 10_000
"""Throws about a release."""

CONFIDENCE = 0.95
"""The confidence of the interval of the share."""

_PRESET = "nba"
_START = {
    "speed": 7.25,
    "elevation": 54 * DEGREE,
    "azimuth": 1.5 * DEGREE,
    "backspin": 3 * TURN,
    "sidespin": 0.0,
    "height": 7 * FOOT,
    "distance": 13.75 * FOOT,
    "angle": 0.0,
}
"""A free throw that bounces nine times on the ring, and misses."""

_DEVIATIONS = {"speed": 0.07, "elevation": 1.3 * DEGREE, "azimuth": 1.0 * DEGREE}

_RELEASE: Mapping[str, tuple[str, float, float]] = {
    "speed": ("Speed", 2.0, 15.0),
    "elevation": ("Elevation", 0.0, 85 * DEGREE),
    "azimuth": ("Aim left", -20 * DEGREE, 20 * DEGREE),
    "height": ("Height", 1.0, 3.4),
    "backspin": ("Backspin", -5 * TURN, 10 * TURN),
    "sidespin": ("Sidespin", -5 * TURN, 5 * TURN),
}
_PLACE: Mapping[str, tuple[str, float, float]] = {
    "distance": ("Distance", 0.0, 12.0),
    "angle": ("Angle", -180 * DEGREE, 180 * DEGREE),
}
_SCENE: Mapping[str, tuple[str, float, float]] = {
    "restitution": ("Restitution", 0.0, 1.0),
    "ball_radius": ("Ball radius", 0.09, 0.16),
    "gravity": ("Gravity", 1.0, 25.0),
}
"""Labels and ranges of sliders, SI; fields take any number."""

_SCRIPTS = ("charts.js", "plan.js", "controls.js", "results.js", "playground.js")
SHARED = ("engine.js", "fingerprint.js", "release.js", "nearest.js", "study.js", "worker.js")
"""Scripts that the page and its worker run."""
_TITLE = "Playground"
_ABOUT = "hoopgen’s engine runs in this page: every change is simulated at once"


def playground(
    path: str | os.PathLike[str] | None = None, *, backend: BackendName = "auto"
) -> Page:
    """Write a page on which shots are thrown, at the hoop of the article.

    It is one file of about 1.3 MB, needs no network, and runs hoopgen's C engine as WebAssembly,
    with the bits of every other backend. Sliders change the release, the place and the hoop; the
    shot is shown in motion as by `hoopgen.view`, with its contacts, 10,000 throws about it, a map
    of speed and elevation, and the smallest changes with which it ends otherwise. The address
    contains the shot.

    Parameters
    ----------
    path
        Where to; ends in .html. Without, no file is written.
    backend
        That computes the digest with which the page compares its own, as for `hoopgen.simulate`.

    Returns
    -------
    Page
        It stands for the file written wherever a path does.

    Raises
    ------
    ValueError
        If the path ends in something else.
    RuntimeError
        If the committed WebAssembly is of other C sources than those installed.
    OSError
        If the file cannot be written; what was there before stays.
    """
    target = None if path is None else check_output(path, PAGES)
    parameters = PRESETS[_PRESET]
    shots = simulate(release(**_START), parameters, record=True)
    data, colours = page_data(shots, parameters, title=_TITLE, about=_ABOUT)
    data["units"] = _units()
    data["about"] = f"{_ABOUT}."
    text = fill_page(data, colours, _extension(page_spec(backend)))
    if target is not None:
        write(target, text)
    return Page(target, text, data["about"])


def _extension(spec: Mapping[str, Any]) -> Extension:
    """Return the page's data besides those of the viewer."""
    modules = {name: web_assembly.module_bytes(name) for name in web_assembly.MODULES}
    elements = [f'<script type="application/json" id="spec">{json_element(spec)}</script>\n']
    elements += [
        f'<script type="text/plain" id="{name}">{base64.b64encode(module).decode()}</script>\n'
        for name, module in modules.items()
    ]
    return Extension(
        style=own_file("playground.css"),
        controls=own_file("controls.html"),
        below=own_file("study.html"),
        elements="".join(elements),
        shared=[own_file(name) for name in SHARED],
        scripts=[own_file(name) for name in _SCRIPTS],
        policy="; worker-src blob:",
        allowed=" 'wasm-unsafe-eval'",
    )


def page_spec(backend: BackendName) -> dict[str, Any]:
    """Return the data of the scripts: names, tables, presets, ranges."""
    layout = HOOP.layout
    state = len(HOOP.kernels.STATE)
    presets = {name: dict(preset) for name, preset in PRESETS.items()}
    start = {**_START, **{name: presets[_PRESET][name] for name in _SCENE}}
    start |= {f"sd_{name}": value for name, value in _DEVIATIONS.items()}
    scatter = {f"sd_{name}": (_RELEASE[name][0], 0.0, 5 * sd) for name, sd in _DEVIATIONS.items()}
    blank = simulate(release(**_START), PRESETS[_PRESET])
    return {
        "layout": {
            "functions": {name: results for name, (_, results) in elementary.FUNCTIONS.items()},
            "state": state,
            "parameters": list(HOOP.parameters),
            "results": [
                [name, result.dtype, len(result.columns) if result.row else 1]
                for name, result in layout.results.items()
            ],
        },
        # The widest first: a browser that cannot run it takes the next.
        "modules": [
            {"name": name, "lanes": lanes}
            for name, lanes in reversed([*web_assembly.MODULES.items()])
        ],
        "parameters": list(HOOP.parameters),
        "outcomes": [outcome.name.lower() for outcome in HOOP.outcomes],
        "kinds": {
            "names": [kind.name.lower() for kind in Kind],
            "table": kind_table(),
            "bodies": list(HOOP.surfaces),
        },
        "colours": {
            "made": dict(MADE),
            "missed": dict(MISSED),
            "other": OTHER_OUTCOME_COLOURS["short"],
        },
        "presets": presets,
        "courts": {name: net_and_court(blank, preset) for name, preset in presets.items()},
        "ring_height": RING_HEIGHT,
        "catching_height": CATCHING_HEIGHT,
        "most": HOOP.max_contacts,
        "throws": THROWS,
        "z": NormalDist().inv_cdf(0.5 + 0.5 * CONFIDENCE),
        "scattered": list(_DEVIATIONS),
        "vary": ["speed", "elevation", "azimuth", "backspin", "height", "distance", "restitution"],
        "ranges": {"away": dict(HALF_WIDTHS), "limits": dict(LIMITS)},
        "start": {**start, "preset": _PRESET, "seed": 0},
        "variables": {
            "release": _fields(_RELEASE),
            "place": _fields(_PLACE),
            "scene": _fields(_SCENE),
            "scatter": _fields(scatter),
        },
        "fixed": {
            "kinds": KINDS,
            "primes": first_primes(state),
            "each": SHOTS // len(KINDS),
            "most": MAX_CONTACTS,
            "limit": TIME_LIMIT,
            "preset": "paper",
            "sha256": fingerprint(HOOP, backend),
        },
    }


def _fields(variables: Mapping[str, tuple[str, float, float]]) -> list[dict[str, Any]]:
    """Return variables with what is measured, for sliders and fields."""
    return [
        {
            "name": name,
            "label": label,
            "kind": VARIABLES[name.removeprefix("sd_")].kind,
            "low": low,
            "high": high,
        }
        for name, (label, low, high) in variables.items()
    ]


def _units() -> dict[str, Any]:
    """Return the units shown: those of pages, but spins in turns a minute, as players say them."""
    spin = {"symbol": "rpm", "size": UNITS["spin"]["rpm"], "decimals": 0}
    return {
        system: {kind: vars(unit) for kind, unit in shown.items()} | {"spin": spin}
        for system, shown in DISPLAY_UNITS.items()
    }


@cache
def own_file(name: str) -> str:
    """Return a text file of the playground."""
    return read(f"playground/{name}")
