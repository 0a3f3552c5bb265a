"""What a result rests on, in words: the scene, the release, the scatter, the seed.

Every page, picture, table and printed result says its scene by `say_scene`.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from .engines import HOOP, Engine
from .hoop.presets import NAMES, PRESETS, nearest_preset
from .scenes import presets_of, variables_of
from .variables import STATE, STATE_UNITS, is_state
from .words import Quantity, quantity

if TYPE_CHECKING:
    import xarray as xr

__all__ = [
    "footer",
    "in_a_note",
    "model_told",
    "say_of",
    "say_release",
    "say_scatter",
    "say_scene",
    "told_by",
    "told_of",
    "told_setting",
]

_DIGITS = 6
"""Significant, at the least; as many more as it takes to tell a value from the preset's."""

_ARTICLE = " (the article's)"


def say_scene(parameters: Mapping[str, Any], by_row: Iterable[str] = ()) -> str:
    """Say a scene: the preset that it is nearest to, and what differs; "NBA, restitution 0.75".

    Parameters
    ----------
    parameters
        Of the scene, one number each or (n,), of which the ends are said; not all need be there.
    by_row
        Those that are each row's own, in columns of a table.
    """
    apart = [name for name in NAMES if name in set(by_row)]
    if len(apart) == len(NAMES):
        return "each row's own"
    name, differences = nearest_preset({n: v for n, v in parameters.items() if n not in apart})
    preset = f"{name.upper()}{_ARTICLE if name == 'paper' else ''}"
    changed = [_apart(one, value, PRESETS[name][one]) for one, value in differences.items()]
    return ", ".join([preset, *changed, *(f"{quantity(n).name} by row" for n in apart)])


def say_of(scene: Engine, parameters: Mapping[str, Any], by_row: Iterable[str] = ()) -> str:
    """Say any scene: the hoop as `say_scene` does, another by name, preset and what differs.

    Parameters
    ----------
    scene
        Whose.
    parameters
        Of it, one number each or (n,), of which the ends are said.
    by_row
        Those that are each row's own, in columns of a table.
    """
    if scene.is_hoop:
        return say_scene(parameters, by_row)
    said, apart = [scene.name], set(by_row)
    presets, base = presets_of(scene), scene.parameters
    if presets:
        named, _ = nearest_preset({n: v for n, v in parameters.items() if n not in apart}, presets)
        said, base = [f"{scene.name}, {named.upper()}"], presets[named]
    for name, usual in base.items():
        value = np.asarray(parameters.get(name, usual))
        if name in apart:
            said.append(f"{name} by row")
        elif not np.all(value == usual):
            low, high = (f"{end(value):.{_DIGITS}g}" for end in (np.min, np.max))
            said.append(f"{name} {low if low == high else f'{low} to {high}'}")
    return ", ".join(said)


def _apart(name: str, value: Any, usual: float) -> str:
    """Say a parameter that is not that of the preset, so that the difference is seen."""
    shown = quantity(name)
    column = shown.shown(value)
    low, high = (float(ends.reduce(column.ravel())) for ends in (np.fmin, np.fmax))
    digits = _DIGITS
    while digits < 17 and f"{low:.{digits}g}" == f"{usual / shown.size:.{digits}g}" and low == high:
        digits += 1
    said = shown.say(high, digits)
    if low != high:
        said = f"{shown.say(low, digits).removesuffix(shown.unit).rstrip()} to {said}"
    return f"{shown.name} {said}"


def _quantities(names: Iterable[str], scene: Engine) -> dict[str, Quantity]:
    """Return how variables are shown, by name, in the order of those of their scene.

    What has no hoop, and states, are shown in SI.
    """
    given = set(names)
    if scene.has_hoop and not is_state(given):
        known = variables_of(scene)
        return {name: quantity(name) for name in known if name in given}
    plain = {
        **STATE_UNITS,
        **{n: one.unit for n, one in variables_of(scene).items() if n not in STATE},
    }
    return {name: Quantity(name, unit) for name, unit in plain.items() if name in given}


def say_release(values: Mapping[str, float], scene: Engine = HOOP) -> str:
    """Say variables of a release, without parameters of the scene."""
    return ", ".join(
        f"{name} {_value(shown, values[name])}"
        for name, shown in _quantities(values, scene).items()
        if name not in scene.table.defaults
    )


def say_scatter(
    sd: Mapping[str, float],
    correlation: Iterable[tuple[tuple[str, str], float]] = (),
    scene: Engine = HOOP,
) -> str:
    """Say standard deviations and correlations; what does not scatter is left out."""
    shown = _quantities((name for name, value in sd.items() if value), scene)
    spread = ", ".join(f"{name} {_value(one, sd[name])}" for name, one in shown.items())
    pairs = [
        f"correlation of {one} and {other} {_value(Quantity('', ''), value)}"
        for (one, other), value in correlation
        if value and sd.get(one) and sd.get(other)
    ]
    return "; ".join([spread or "none", *pairs])


def _value(shown: Quantity, value: float) -> str:
    return shown.say(float(shown.shown(value)), _DIGITS)


def told_setting(setting: Mapping[str, Any], scene: Engine = HOOP) -> dict[str, str]:
    """Return what is said of a release model and its scene, by what it is.

    Parameters
    ----------
    setting
        The identity of the model, and the ``parameters`` of the scene.
    scene
        The scene itself.
    """
    model = setting.get("model")
    mean = setting["release"] if model == "scatter" else {}
    own = {name: value for name, value in mean.items() if name in scene.table.defaults}
    by_row = setting["columns"] if model == "resample" else ()
    told = {"scene": say_of(scene, {**setting["parameters"], **own}, by_row)}
    if model == "scatter":
        pairs = [((one, other), value) for one, other, value in setting["correlation"]]
        scatter = say_scatter(setting["sd"], pairs, scene)
        return told | {"release": say_release(mean, scene), "scatter": scatter}
    if model == "resample":
        return told | {"release": _measured(setting["columns"], setting["sha256"])}
    return told | {"release": f"of the model {model}" if model else "of a model of one's own"}


def _measured(columns: Iterable[str], sha256: str) -> str:
    return f"measured: {', '.join(columns)} (data {sha256[:6]})"


_OF_A_MODEL = ("sd", "correlation", "columns", "sha256")


def model_told(identity: Mapping[str, Any]) -> dict[str, str]:
    """Return what the attributes of a dataset say of a release model, as JSON; see `told_by`."""
    return {name: json.dumps(identity[name]) for name in _OF_A_MODEL if name in identity}


def told_of(
    parameters: Mapping[str, Any],
    sd: Mapping[str, float],
    correlation: Mapping[tuple[str, str], float],
    seed: int,
    release: Mapping[str, float] | None = None,
) -> dict[str, str]:
    """Return what is said of a scene, a scatter and a seed, and of a release where it is given."""
    return {
        "scene": say_scene(parameters),
        **({} if release is None else {"release": say_release(release)}),
        "scatter": say_scatter(sd, correlation.items()),
        "seed": str(seed),
    }


def told_by(dataset: xr.Dataset) -> dict[str, str]:
    """Return what is said of a dataset of `hoopgen.map` or `bank_or_direct`, by its attributes."""
    attributes = dataset.attrs
    told: dict[str, str] = {}
    columns = json.loads(attributes.get("columns", "[]"))
    if "scene_sha256" in attributes:  # of one's own: what is said of it stands there
        return told | _told_own(attributes)
    if "parameters" in attributes:
        parameters = {n: float(v) for n, v in json.loads(attributes["parameters"]).items()}
        by_row = [name for name in columns if name not in (*parameters, *dataset.coords)]
        told["scene"] = say_scene(parameters, by_row)
    same = {
        str(name): float(column)
        for name, column in dataset.coords.items()
        if column.ndim == 0 and np.issubdtype(column.dtype, np.number)
    }
    same |= json.loads(attributes.get("release", "{}"))
    releases = [_measured(columns, json.loads(attributes["sha256"]))] if columns else []
    if releases := [*releases, *filter(None, [say_release(same)])]:
        told["release"] = "; ".join(releases)
    if "sd" in attributes:
        pairs = json.loads(attributes.get("correlation", "[]"))
        correlation = [((one, other), value) for one, other, value in pairs]
        told["scatter"] = say_scatter(json.loads(attributes["sd"]), correlation)
    if "seed" in attributes:
        told["seed"] = str(attributes["seed"])
    return told


def _told_own(attributes: Mapping[str, Any]) -> dict[str, str]:
    """Return what is said of a dataset of a scene of one's own, which says it itself."""
    return {
        name: str(attributes[key])
        for name, key in (
            ("scene", "scene"),
            ("release", "said_release"),
            ("scatter", "said_scatter"),
        )
        if attributes.get(key)
    } | ({"seed": str(attributes["seed"])} if "seed" in attributes else {})


def in_a_note(told: Mapping[str, str], *, scene: bool = False) -> str:
    """Return sentences for a picture, the scene's only if it is not said by the picture itself."""
    kept = {name: text for name, text in told.items() if scene or name != "scene"}
    return " ".join(f"{name.capitalize()}: {text}." for name, text in kept.items())


def footer(width: int, told: Mapping[str, str], other: Mapping[str, str] | None = None) -> str:
    """Return the lines that say a setting, or two: what they share is said once.

    Parameters
    ----------
    width
        Of the column of names.
    told, other
        By name.
    """
    lines = []
    for name in {**told, **(other or {})}:
        first, second = told.get(name, "none"), (told if other is None else other).get(name, "none")
        said = [first] if first == second else [f"first: {first}", f"second: {second}"]
        lines += [f"{'' if place else name:{width}}{text}" for place, text in enumerate(said)]
    return "\n".join(lines)
