"""The playground: a page that simulates shots itself, by the C engine as WebAssembly."""

from __future__ import annotations

import base64
import gzip
import math
import os
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from importlib.resources import files
from statistics import NormalDist
from typing import Any

from hoopgen.core.backend_names import BackendName
from hoopgen.core.colours import MADE, MISSED, OTHER_OUTCOME_COLOURS
from hoopgen.core.event_log import Event
from hoopgen.core.files import PAGES, check_output, write
from hoopgen.core.units import DEGREE, DISPLAY_UNITS, FOOT, TURN, UNITS
from hoopgen.engine import web_assembly
from hoopgen.engine.draws import ARGUMENTS
from hoopgen.engine.verification import first_primes
from hoopgen.hoop.kinds import Kind, kind_table
from hoopgen.hoop.presets import PRESETS
from hoopgen.hoop.releases import CATCHING_HEIGHT, FROM_ZERO, RING_HEIGHT, release
from hoopgen.hoop.search_range import HALF_WIDTHS, LIMITS
from hoopgen.hoop.variables import VARIABLES
from hoopgen.simulation.court import COURT
from hoopgen.simulation.engine import Engine
from hoopgen.simulation.fingerprint import MAX_CONTACTS, SHOTS, TIME_LIMIT, fingerprint
from hoopgen.simulation.hoop import HOOP, KINDS
from hoopgen.simulation.simulate import simulate

from .net_and_court import net_and_court
from .page import Extension, fill_page, json_element, page_data, read
from .page_file import Page
from .scenery import ROLL_PIECE_DURATION

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
_VARIED = ("speed", "elevation", "azimuth", "backspin", "height", "distance")
"""Arguments of the release of which the smallest change is looked for."""

_PLACE: Mapping[str, tuple[str, float, float]] = {
    "distance": ("Distance", 0.0, 12.0),
    "angle": ("Angle", -180 * DEGREE, 180 * DEGREE),
}
"""Labels and ranges of sliders, SI; fields take any number."""

_BALL: Mapping[str, tuple[str, float, float]] = {
    "ball_radius": ("Ball radius", 0.09, 0.16),
    "gravity": ("Gravity", 1.0, 25.0),
}


@dataclass(frozen=True)
class _PageScene:
    """A scene of the page.

    Attributes
    ----------
    engine
        The scene.
    label
        What the page calls it.
    suffix
        The end of the names of its presets in Python.
    fields
        Labels and ranges of sliders of its parameters.
    vary
        Parameters of which the smallest change is looked for, beside arguments of the release.
    """

    engine: Engine
    label: str
    suffix: str
    fields: Mapping[str, tuple[str, float, float]]
    vary: tuple[str, ...]


_SCENES = (
    _PageScene(
        HOOP,
        "The article’s hoop",
        "",
        {"restitution": ("Restitution", 0.0, 1.0), **_BALL},
        ("restitution",),
    ),
    _PageScene(
        COURT,
        "The real ball",
        "_COURT",
        {
            **_BALL,
            **{
                f"{body}_{name}": (f"{title} {name}", 0.0, most)
                for name, most in (("restitution", 1.0), ("friction", 1.5))
                for body, title in (("ring", "Ring"), ("backboard", "Board"), ("bridge", "Bridge"))
            },
        },
        ("ring_restitution", "backboard_restitution"),
    ),
)
"""The scenes of the page; links without one are of the first."""

_SCRIPTS = ("charts.js", "plan.js", "controls.js", "results.js", "playground.js")
SHARED = ("engine.js", "fingerprint.js", "release.js", "nearest.js", "study.js", "worker.js")
GENERATED = ("court.js", "studies.js")
"""Scripts that the page and its worker run: its own, and generated ones beside hoop.js."""
_TITLE = "Playground"
_ABOUT = "hoopgen’s engine runs in this page: every change is simulated at once"


def playground(
    path: str | os.PathLike[str] | None = None, *, backend: BackendName = "auto"
) -> Page:
    """Write a page on which shots are thrown, at the hoop of the article or with a real ball.

    It is one file of about 1.5 MB, needs no network, and runs hoopgen's C engines as WebAssembly,
    with the bits of every other backend. Sliders change the release, the place and the hoop; the
    shot is shown in motion as by `hoopgen.view`, with its contacts, 10,000 throws about it, a map
    of speed and elevation, and the smallest changes with which it ends otherwise. The address
    contains the shot.

    Parameters
    ----------
    path
        Where to; ends in .html. Without, no file is written.
    backend
        That computes the digests with which the page compares its own, as for `hoopgen.simulate`.

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
    elements = [f'<script type="application/json" id="spec">{json_element(spec)}</script>\n']
    for name in web_assembly.MODULES:
        packed = gzip.compress(web_assembly.module_bytes(name), mtime=0)
        text = base64.b64encode(packed).decode()
        elements.append(f'<script type="text/plain" id="{name}">{text}</script>\n')
    return Extension(
        style=own_file("playground.css"),
        controls=own_file("controls.html"),
        below=own_file("study.html"),
        elements="".join(elements),
        shared=[*map(generated_script, GENERATED), *map(own_file, SHARED)],
        scripts=[own_file(name) for name in _SCRIPTS],
        policy="; worker-src blob:",
        allowed=" 'wasm-unsafe-eval'",
    )


def page_spec(backend: BackendName) -> dict[str, Any]:
    """Return the data of the scripts: names, tables, ranges, and what each scene has."""
    presets = HOOP.presets
    start = _START | {f"sd_{name}": value for name, value in _DEVIATIONS.items()}
    scatter = {f"sd_{name}": (_RELEASE[name][0], 0.0, 5 * sd) for name, sd in _DEVIATIONS.items()}
    blank = simulate(release(**_START), presets[_PRESET])
    return {
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
        # The hoops of a preset have the same sizes in all scenes.
        "courts": {name: net_and_court(blank, preset) for name, preset in presets.items()},
        "ring_height": RING_HEIGHT,
        "catching_height": CATCHING_HEIGHT,
        "from_zero": list(FROM_ZERO),
        "throws": THROWS,
        "z": NormalDist().inv_cdf(0.5 + 0.5 * CONFIDENCE),
        "scattered": list(_DEVIATIONS),
        "ranges": {"away": dict(HALF_WIDTHS), "limits": dict(LIMITS)},
        "start": {**start, "scene": HOOP.name, "preset": _PRESET, "seed": 0},
        "variables": {
            "release": _fields(_RELEASE),
            "place": _fields(_PLACE),
            "scatter": _fields(scatter),
        },
        "scenes": {one.engine.name: _scene_spec(one, backend) for one in _SCENES},
    }


def _scene_spec(scene: _PageScene, backend: BackendName) -> dict[str, Any]:
    """Return a scene's data; None stands for infinity, of which JSON has no number."""
    engine = scene.engine
    layout, state = engine.layout, len(engine.kernels.STATE)
    modules = {
        name: lanes for name, (own, lanes) in web_assembly.MODULES.items() if own == engine.name
    }
    return {
        "label": scene.label,
        "suffix": scene.suffix,
        "layout": {
            "scene": engine.name,
            "arguments": list(ARGUMENTS),
            "state": state,
            "log_rows": layout.rows,
            "events": [event.name.lower() for event in Event],
            "parameters": list(engine.parameters),
            "results": [
                [name, result.dtype, len(result.columns) if result.row else 1]
                for name, result in layout.results.items()
            ],
        },
        # The widest first: a browser that cannot run it takes the next.
        "modules": [{"name": name, "lanes": modules[name]} for name in reversed(modules)],
        "parameters": list(engine.parameters),
        "normals": {body: _normal_arguments(engine, body) for body in engine.surfaces},
        "outcomes": [outcome.name.lower() for outcome in engine.outcomes],
        "presets": {name: _finite(preset) for name, preset in engine.presets.items()},
        "most": engine.max_contacts,
        "limit": _or_none(engine.time_limit),
        "roll_piece": ROLL_PIECE_DURATION,
        "fields": _fields(scene.fields, engine),
        "vary": [*_VARIED, *scene.vary],
        "fixed": {
            "kinds": KINDS,
            "primes": first_primes(state),
            "each": SHOTS // len(KINDS),
            "most": MAX_CONTACTS,
            "limit": TIME_LIMIT,
            "preset": "paper",
            "sha256": fingerprint(engine, backend),
        },
    }


def _normal_arguments(engine: Engine, body: str) -> list[str]:
    """Return the arguments of a body's normal: coordinates, and parameters by their names."""
    names = {variable: name for name, variable in engine.kernels.VARIABLES.items()}
    return [names.get(one, one) for one in engine.kernels.ARGUMENTS[f"{body}_normal"]]


def _finite(values: Mapping[str, float]) -> dict[str, float | None]:
    return {name: _or_none(value) for name, value in values.items()}


def _or_none(value: float) -> float | None:
    return None if math.isinf(value) else value


def _fields(
    variables: Mapping[str, tuple[str, float, float]], engine: Engine | None = None
) -> list[dict[str, Any]]:
    """Return variables with what is measured, for sliders and fields.

    Those of the bodies of a scene are grouped; what is infinite in a preset may be so.
    """
    bodies = () if engine is None else engine.surfaces
    presets = {} if engine is None else engine.presets
    return [
        {
            "name": name,
            "label": label,
            "kind": _kind(name.removeprefix("sd_")),
            "low": low,
            "high": high,
            "group": label.split()[1].capitalize() if name.split("_")[0] in bodies else "",
            "infinite": any(math.isinf(preset[name]) for preset in presets.values()),
        }
        for name, (label, low, high) in variables.items()
    ]


def _kind(name: str) -> str:
    return VARIABLES[name].kind if name in VARIABLES else "number"


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


@cache
def generated_script(name: str) -> str:
    """Return a script of generated/js."""
    return files("hoopgen.generated").joinpath(f"js/{name}").read_text(encoding="utf-8")
