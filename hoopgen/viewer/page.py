"""HTML pages of shots: pieces of parabolas in JSON, and the scripts that draw them."""

from __future__ import annotations

import base64
import hashlib
import html
import json
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from importlib.resources import files
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hoopgen.core.colours import outcome_colours
from hoopgen.core.event_log import Event, number_contacts
from hoopgen.core.extras import version
from hoopgen.core.files import write
from hoopgen.core.parameters import Value, resolve
from hoopgen.core.units import DISPLAY_UNITS, display_system
from hoopgen.hoop.kinds import Kind, kinds
from hoopgen.hoop.releases import RING_HEIGHT
from hoopgen.report.provenance import describe_scene
from hoopgen.results.shots import Shots
from hoopgen.results.trajectory import Trajectory
from hoopgen.text.escape import printable
from hoopgen.text.numbers import format_count
from hoopgen.text.shorten import brief

from .net_and_court import net_and_court
from .page_file import Page
from .palette import palette
from .scenery import ROLL_PIECE_DURATION, ball_radius, flight_parameters, scenery, turn_vectors

MAX_SHOTS = 2000
"""Shots on a page; with more, browsers are slow and paths cannot be told apart."""

_SCRIPTS = (
    "flight.js",
    "stops.js",
    "scene.js",
    "others.js",
    "camera.js",
    "badges.js",
    "picture.js",
    "words.js",
    "page.js",
)
_SLOT = re.compile(r"\{\{(\w+)\}\}")


@dataclass(frozen=True)
class Extension:
    """The parts that another page adds to the viewer's own.

    Attributes
    ----------
    style
        CSS after the viewer's.
    controls, below, elements
        HTML beside the picture, below it, and before the scripts.
    shared
        Scripts between the kernels and the viewer's, which its workers run too.
    scripts
        Scripts after the viewer's.
    policy
        Directives of the content security policy beside the viewer's.
    allowed
        Sources of scripts beside their digests.
    """

    style: str = ""
    controls: str = ""
    below: str = ""
    elements: str = ""
    shared: Sequence[str] = ()
    scripts: Sequence[str] = ()
    policy: str = ""
    allowed: str = ""


def write_page(
    shots: Shots,
    parameters: Mapping[str, Any],
    target: Path | None,
    *,
    title: str = "",
    about: str = "",
    labels: Sequence[str] | None = None,
) -> Page:
    """Return the page of shots, written to a file if one is given; see `hoopgen.view`.

    Parameters
    ----------
    shots, parameters
        As for `page`.
    target
        The file; None for none.
    title, about, labels
        As for `hoopgen.view`.
    """
    text = page(shots, parameters, title=title, about=about, labels=labels)
    if target is not None:
        write(target, text)
    return Page(target, text, _about(about, shots, parameters))


def page(
    shots: Shots,
    parameters: Mapping[str, Any],
    *,
    title: str = "",
    about: str = "",
    labels: Sequence[str] | None = None,
) -> str:
    """Return the HTML that `view` writes.

    Parameters
    ----------
    shots
        The recorded shots.
    parameters
        The scene's parameters.
    title, about, labels
        As for `hoopgen.view`.
    """
    return fill_page(*page_data(shots, parameters, title=title, about=about, labels=labels))


def page_data(
    shots: Shots,
    parameters: Mapping[str, Any],
    *,
    title: str = "",
    about: str = "",
    labels: Sequence[str] | None = None,
) -> tuple[dict[str, Any], str]:
    """Return the data of a page, and the style sheet of its colours.

    Parameters
    ----------
    shots, parameters, title, about, labels
        As for `page`.
    """
    table, hoop = shots.scene.table, shots.scene.is_hoop
    values = resolve(parameters, len(shots), table)
    names = _labels(labels, len(shots))
    valid = np.flatnonzero(shots.outcome != shots.scene.outcomes["INVALID"])
    if not 1 <= len(valid) <= MAX_SHOTS:
        raise ValueError(f"shots: expected 1 to {MAX_SHOTS} valid ones, got {len(valid)}")
    touched = _contact_points(shots, values)
    # One each, for all that is drawn of it: to follow a ball that rolls for long takes seconds.
    paths = {int(row): shots.trajectory(int(row)) for row in valid}
    words = ["none"] * len(shots)
    if hoop:
        found = kinds(shots.outcome, shots.counts, shots.first)
        words = [Kind(kind).name.lower() for kind in found]
    data = {
        "title": printable(title) or _title(shots, valid),
        "about": _about(about, shots, parameters),
        "ring_height": RING_HEIGHT,
        "units": {
            system: {kind: vars(unit) for kind, unit in shown.items()}
            for system, shown in DISPLAY_UNITS.items()
        },
        "system": display_system(),
        "ghost": net_and_court(shots, values),
        "surfaces": shots.surfaces,
        "outcomes": [outcome.name.lower() for outcome in shots.scene.outcomes],
        "kinds": [kind.name.lower() for kind in Kind],
        "parameters": {name: v for name, v in values.items() if isinstance(v, float)},
        "shots": [
            _shot(shots, row, path, values, touched, label=names[row], kind=words[row])
            for row, path in paths.items()
        ],
    }
    colours = _outcome_colours(shots)
    if not hoop:
        drawn, bodies = scenery(shots, values, paths.values())
        data |= {"kinds": [], "parameters": {}, "scenery": drawn}
        colours |= bodies
    return data, palette(colours)


def _outcome_colours(shots: Shots) -> dict[str, str]:
    """Return the colours of outcomes as ink-0, ink-1, ..., since authors choose the names."""
    scene = shots.scene
    found = outcome_colours(scene.outcomes.__members__, len(scene.kernels.ENDS))
    return {f"ink-{k}": colour for k, colour in enumerate(found.values())}


def _about(about: str, shots: Shots, parameters: Mapping[str, Any]) -> str:
    return (
        f"{printable(about)}{'; s' if about else 'S'}cene {describe_scene(shots.scene, parameters)}"
    )


def _title(shots: Shots, valid: NDArray[np.intp]) -> str:
    if len(valid) > 1:
        return format_count(len(valid), "shot")
    return shots.scene.outcomes(int(shots.outcome[valid[0]])).name.capitalize()


def _labels(labels: Sequence[str] | None, shots: int) -> list[str]:
    if labels is None:
        return [f"Shot {number}" for number in range(1, shots + 1)]
    names = list(labels)
    if isinstance(labels, str) or len(names) != shots:
        raise ValueError(f"labels: expected {shots}, one a shot, got {brief(labels)}")
    return [printable(str(label)) for label in names]


def _shot(
    shots: Shots,
    row: int,
    trajectory: Trajectory,
    values: Mapping[str, Value],
    touched: NDArray[np.float64],
    *,
    label: str,
    kind: str,
) -> dict[str, Any]:
    """Return a shot's data: flights (start, state there), rolls (first flight, end), and events."""
    events = trajectory.events
    low = int(np.searchsorted(shots.events["shot"], row))
    starts, states, rolling = trajectory.pieces(ROLL_PIECE_DURATION)
    surfaces = (*shots.surfaces, "end")
    own = {n: float(v[row]) for n, v in values.items() if not isinstance(v, float)}
    if not shots.scene.is_hoop:
        # No name of a scene's author is a class of the page's style.
        surfaces = (*(f"body-{k}" for k in range(len(shots.surfaces))), "end")
        own = flight_parameters(shots, values, row)
    fall = _fall(shots, row, trajectory)
    airless = "airless_rolls" in shots.scene.layout.results and bool(shots.airless_rolls[row])
    return {
        "label": label,
        "outcome": shots.scene.outcomes(int(shots.outcome[row])).name.lower(),
        "kind": kind,
        "uncertain": bool(shots.uncertain[row]),
        "parameters": own,
        "flights": np.column_stack([starts, turn_vectors(shots, values, states)]).tolist(),
        "rolls": np.flatnonzero(np.diff(rolling, prepend=False)).reshape(-1, 2).tolist(),
        **({} if fall is None else {"floor_time": fall}),
        **({"airless": True} if airless else {}),
        "events": [
            {
                "number": number or 0,
                "kind": Event(int(event["kind"])).name.lower(),
                "surface": surfaces[event["surface"]],
                "time": float(event["time"]),
                "at": at.tolist(),
            }
            for (number, event), at in zip(
                number_contacts(events), touched[low : low + len(events)], strict=True
            )
        ],
    }


def _fall(shots: Shots, row: int, trajectory: Trajectory) -> float | None:
    """Return the time of arrival on the floor, s, if the ball touched nothing after the end.

    None where there is no hoop, and so no floor, and of a shot that does not end in flight.
    """
    scene = shots.scene
    name = scene.outcomes(int(shots.outcome[row])).name
    if not scene.has_hoop or name not in ("MADE", "MISSED", "SHORT"):
        return None
    events, parameters = trajectory.events, trajectory.parameters
    last = events["after"][-1] if len(events) else trajectory.release
    time, _ = scene.fall(last, parameters["ball_radius"] - RING_HEIGHT, parameters)
    return trajectory.duration + float(time) if np.isfinite(time) else None


def _contact_points(shots: Shots, values: Mapping[str, Value]) -> NDArray[np.float64]:
    """Return the point of contact at each event, (m, 3); at the end, the ball's centre."""
    events, scene = shots.events, shots.scene
    centres = np.array(events["before"][:, :3])
    for index in range(len(scene.surfaces)):
        rows = np.flatnonzero(events["surface"] == index)
        shot = events["shot"][rows]
        inputs = scene.table.inputs(values)
        variables = scene.kernels.VARIABLES.values()
        columns = {
            n: v if isinstance(v, float) else v[shot]
            for n, v in zip(variables, inputs, strict=True)
        }
        columns |= dict(zip("xyz", centres[rows].T, strict=True))
        ball = np.broadcast_to(_ball(shots, values, shot), len(rows))
        faces = scene.kernels.FACES[index]
        touched = _touched(scene.kernels, faces, columns, len(rows))
        for number, face in enumerate(faces):
            kernel, wanted = (getattr(scene.kernels, f"{face}_normal"), touched == number)
            normal = kernel(*[columns[n] for n in scene.kernels.ARGUMENTS[f"{face}_normal"]])
            for axis, component in enumerate(normal):
                centres[rows[wanted], axis] -= (ball * component)[wanted]
    return turn_vectors(shots, values, centres)


def _touched(
    kernels: Any, faces: tuple[str, ...], columns: Mapping[str, Any], count: int
) -> NDArray[np.intp]:
    """Return which of a body's faces the ball touches at each of so many places, (count,)."""
    gaps = []
    for face in faces if len(faces) > 1 else ():
        given = [np.float64(columns.get(n, 0.0)) for n in kernels.ARGUMENTS[f"{face}_vary"]]
        with np.errstate(divide="ignore", invalid="ignore"):
            found = getattr(kernels, f"{face}_vary")(*given)
        gap = np.abs(found[kernels.OUTPUTS[f"{face}_vary"].index("gap")])
        gaps.append(np.broadcast_to(gap, count))
    return np.argmin(np.nan_to_num(gaps, nan=np.inf), 0) if gaps else np.zeros(count, np.intp)


def _ball(shots: Shots, values: Mapping[str, Value], rows: NDArray[np.intp]) -> Any:
    """Return the ball's radius, one or by row."""
    if shots.scene.is_hoop:
        found = values["ball_radius"]
    else:
        found = ball_radius(shots, values)
    return found if isinstance(found, float) else found[rows]


def fill_page(data: Mapping[str, Any], colours: str, extension: Extension | None = None) -> str:
    """Fill the page with style, scripts and data, and a policy that lets nothing else run.

    Parameters
    ----------
    data, colours
        As `page_data` returns them.
    extension
        What the page has beside that.
    """
    extension = extension or Extension()
    style, three = colours + read("page.css") + extension.style, read("three/three.js")
    shared = [_kernel_source(), *extension.shared]
    first, scripts = read("theme.js"), [*(read(name) for name in _SCRIPTS), *extension.scripts]
    allowed = " ".join(_digest(text) for text in (first, three, *shared, *scripts))
    policy = (
        f"default-src 'none'; img-src data:; script-src {allowed}{extension.allowed}; "
        f"style-src {_digest(style)}{extension.policy}"
    )
    slots = {
        "policy": policy,
        "version": html.escape(version()),
        "title": html.escape(data["title"]),
        "style": style,
        "theme": first,
        "controls": extension.controls,
        "below": extension.below,
        "elements": extension.elements,
        "data": json_element(data),
        "licence": read("three/LICENSE"),
        "three": three,
        "scripts": "\n".join(
            [
                *(f"<script data-worker>{text}</script>" for text in shared),
                *(f"<script>{text}</script>" for text in scripts),
            ]
        ),
    }
    return _SLOT.sub(lambda slot: slots[slot[1]], read("page.html"))


def json_element(data: Mapping[str, Any]) -> str:
    """Return JSON that can neither end its element nor open a comment."""
    text = json.dumps(data, allow_nan=False, separators=(",", ":"))
    return text.replace("<", "\\u003c")


def _digest(text: str) -> str:
    digest = hashlib.sha256(text.encode()).digest()
    return f"'sha256-{base64.b64encode(digest).decode()}'"


def _kernel_source() -> str:
    return files("hoopgen.generated").joinpath("js/hoop.js").read_text(encoding="utf-8")


@cache
def read(name: str) -> str:
    """Return a text file of the viewer."""
    return files("hoopgen.viewer").joinpath(name).read_text(encoding="utf-8")
