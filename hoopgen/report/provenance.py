"""Provenance in words: the scene, the release, the scatter and the seed of a result.

Every page, picture, table and printed result describes its scene by `describe_scene`.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from hoopgen.core.variables import STATE, STATE_UNITS, is_state
from hoopgen.engine.compiled_scene import CompiledScene
from hoopgen.hoop.presets import NAMES, PRESETS, nearest_preset
from hoopgen.hoop.variables import VARIABLES
from hoopgen.scene.lookup import variables_of

from .quantities import Quantity, quantity

if TYPE_CHECKING:
    import xarray as xr

_MIN_DIGITS = 6
"""Significant digits; more are written if a value would otherwise look like the preset's."""

_ARTICLE = " (the article's)"


def describe_hoop(parameters: Mapping[str, Any], by_row: Iterable[str] = ()) -> str:
    """Describe the article's scene: the nearest preset and the differences from it.

    Parameters
    ----------
    parameters
        Some or all of the scene's parameters, each a number or of shape (n,); of an array its
        lowest and highest values are written.
    by_row
        The parameters whose values differ from row to row, in columns of a table.

    Returns
    -------
    str
        A text such as "NBA, restitution 0.75".
    """
    differing = [name for name in NAMES if name in set(by_row)]
    if len(differing) == len(NAMES):
        return "each row's own"
    name, differences = nearest_preset({n: v for n, v in parameters.items() if n not in differing})
    preset = f"{name.upper()}{_ARTICLE if name == 'paper' else ''}"
    changed = [
        _describe_difference(one, value, PRESETS[name][one]) for one, value in differences.items()
    ]
    return ", ".join([preset, *changed, *(f"{quantity(n).name} by row" for n in differing)])


def describe_scene(
    scene: CompiledScene, parameters: Mapping[str, Any], by_row: Iterable[str] = ()
) -> str:
    """Describe any scene by its name, its nearest preset and the differences from it.

    Parameters
    ----------
    scene
        The scene; the article's is described by `describe_hoop`.
    parameters, by_row
        As for `describe_hoop`.

    Returns
    -------
    str
        A text such as "court, NBA, ring_restitution 0.5".
    """
    if scene.is_hoop:
        return describe_hoop(parameters, by_row)
    parts, differing = [scene.name], set(by_row)
    presets, base = scene.presets, scene.parameters
    if presets:
        shared = {n: v for n, v in parameters.items() if n not in differing}
        preset, _ = nearest_preset(shared, presets)
        parts, base = [f"{scene.name}, {preset.upper()}"], presets[preset]
    for name, default in base.items():
        value = np.asarray(parameters.get(name, default))
        if name in differing:
            parts.append(f"{name} by row")
        elif not np.all(value == default):
            # At a hoop parameters have the display units; in any other scene they are bare SI.
            unit = quantity(name) if scene.has_hoop else Quantity(name, "")
            column = unit.convert(value)
            low, high = (f"{end(column):.{_MIN_DIGITS}g}" for end in (np.min, np.max))
            ends = low if low == high else f"{low} to {high}"
            parts.append(f"{name} {ends} {unit.unit}".rstrip())
    return ", ".join(parts)


def _describe_difference(name: str, value: Any, default: float) -> str:
    """Format a parameter with as many digits as tell it from the preset's value."""
    unit = quantity(name)
    column = unit.convert(value)
    low, high = (float(ends.reduce(column.ravel())) for ends in (np.fmin, np.fmax))
    digits = _MIN_DIGITS
    preset = default / unit.size
    while digits < 17 and low == high and f"{low:.{digits}g}" == f"{preset:.{digits}g}":
        digits += 1
    text = unit.format(high, digits)
    if low != high:
        text = f"{unit.format(low, digits).removesuffix(unit.unit).rstrip()} to {text}"
    return f"{unit.name} {text}"


def _quantities(names: Iterable[str], scene: CompiledScene | None) -> dict[str, Quantity]:
    """Return the display units of variables by name, in the order of the scene's variables.

    Variables of a scene without a hoop, and the components of states, are in SI units.
    """
    given = set(names)
    known = VARIABLES if scene is None else variables_of(scene)
    if (scene is None or scene.has_hoop) and not is_state(given):
        return {name: quantity(name) for name in known if name in given}
    plain = {
        **STATE_UNITS,
        **{n: one.unit for n, one in known.items() if n not in STATE},
    }
    return {name: Quantity(name, unit) for name, unit in plain.items() if name in given}


def describe_release(values: Mapping[str, float], scene: CompiledScene | None = None) -> str:
    """Describe the variables of a release.

    Parameters
    ----------
    values
        SI values by name; parameters of the scene among them are left out.
    scene
        The scene, whose variables give the order and the units; None for the article's.

    Returns
    -------
    str
        A text such as "elevation 52°, height 2.1336 m".
    """
    return ", ".join(
        f"{name} {_format(unit, values[name])}"
        for name, unit in _quantities(values, scene).items()
        if name not in (NAMES if scene is None else scene.table.defaults)
    )


def describe_scatter(
    sd: Mapping[str, float],
    correlation: Iterable[tuple[tuple[str, str], float]] = (),
    scene: CompiledScene | None = None,
) -> str:
    """Describe standard deviations and correlations.

    Parameters
    ----------
    sd
        Standard deviations by name, SI units; those that are 0 are left out.
    correlation
        Pairs of names with their correlation; zero ones are left out.
    scene
        The scene, whose variables give the order and the units.

    Returns
    -------
    str
        A text such as "speed 0.07 m/s, elevation 1.3°"; "none" if nothing scatters.
    """
    units = _quantities((name for name, value in sd.items() if value), scene)
    spread = ", ".join(f"{name} {_format(unit, sd[name])}" for name, unit in units.items())
    pairs = [
        f"correlation of {one} and {other} {_format(Quantity('', ''), value)}"
        for (one, other), value in correlation
        if value and sd.get(one) and sd.get(other)
    ]
    return "; ".join([spread or "none", *pairs])


def _format(unit: Quantity, value: float) -> str:
    return unit.format(float(unit.convert(value)), _MIN_DIGITS)


def describe_setting(setting: Mapping[str, Any], scene: CompiledScene) -> dict[str, str]:
    """Describe a release model and its scene.

    Parameters
    ----------
    setting
        The identity of the model, and the ``parameters`` of the scene.
    scene
        The scene itself.

    Returns
    -------
    dict of str to str
        Texts by "scene", "release" and, of a `Scatter`, "scatter".
    """
    model = setting.get("model")
    mean = setting["release"] if model == "scatter" else {}
    own = {name: value for name, value in mean.items() if name in scene.table.defaults}
    by_row = setting["columns"] if model == "resample" else ()
    description = {"scene": describe_scene(scene, {**setting["parameters"], **own}, by_row)}
    if model == "scatter":
        pairs = [((one, other), value) for one, other, value in setting["correlation"]]
        scatter = describe_scatter(setting["sd"], pairs, scene)
        return description | {"release": describe_release(mean, scene), "scatter": scatter}
    if model == "resample":
        return description | {"release": _describe_measured(setting["columns"], setting["sha256"])}
    release = f"of the model {model}" if model else "of a model of one's own"
    return description | {"release": release}


def _describe_measured(columns: Iterable[str], sha256: str) -> str:
    return f"measured: {', '.join(columns)} (data {sha256[:6]})"


_MODEL_KEYS = ("sd", "correlation", "columns", "sha256")


def model_attributes(identity: Mapping[str, Any]) -> dict[str, str]:
    """Return the attributes, as JSON, by which a dataset describes its release model."""
    return {name: json.dumps(identity[name]) for name in _MODEL_KEYS if name in identity}


def describe_dataset(dataset: xr.Dataset) -> dict[str, str]:
    """Describe a dataset of `hoopgen.map` or `bank_or_direct` by its attributes.

    Returns
    -------
    dict of str to str
        Texts by "scene", "release", "scatter" and "seed", as far as the dataset has them.
    """
    attributes = dataset.attrs
    description: dict[str, str] = {}
    columns = json.loads(attributes.get("columns", "[]"))
    if "scene_sha256" in attributes:  # a user's scene: the attributes are the description
        return _describe_own_scene(attributes)
    if "parameters" in attributes:
        parameters = {n: float(v) for n, v in json.loads(attributes["parameters"]).items()}
        by_row = [name for name in columns if name not in (*parameters, *dataset.coords)]
        description["scene"] = describe_hoop(parameters, by_row)
    same = {
        str(name): float(column)
        for name, column in dataset.coords.items()
        if column.ndim == 0 and np.issubdtype(column.dtype, np.number)
    }
    same |= json.loads(attributes.get("release", "{}"))
    releases = [_describe_measured(columns, json.loads(attributes["sha256"]))] if columns else []
    if releases := [*releases, *filter(None, [describe_release(same)])]:
        description["release"] = "; ".join(releases)
    if "sd" in attributes:
        pairs = json.loads(attributes.get("correlation", "[]"))
        correlation = [((one, other), value) for one, other, value in pairs]
        description["scatter"] = describe_scatter(json.loads(attributes["sd"]), correlation)
    if "seed" in attributes:
        description["seed"] = str(attributes["seed"])
    return description


def _describe_own_scene(attributes: Mapping[str, Any]) -> dict[str, str]:
    """Return the description that the attributes of a dataset of a user's scene contain."""
    keys = {"scene": "scene", "release": "said_release", "scatter": "said_scatter"}
    description = {name: str(attributes[key]) for name, key in keys.items() if attributes.get(key)}
    return description | ({"seed": str(attributes["seed"])} if "seed" in attributes else {})


def sentences(description: Mapping[str, str], *, scene: bool = False) -> str:
    """Return a description as sentences, for the note of a picture.

    Parameters
    ----------
    description
        Texts by name, as `describe_setting` returns them.
    scene
        True if the sentences include that of the scene; most pictures name it themselves.
    """
    included = {name: text for name, text in description.items() if scene or name != "scene"}
    return " ".join(f"{name.capitalize()}: {text}." for name, text in included.items())


def footer(width: int, first: Mapping[str, str], second: Mapping[str, str] | None = None) -> str:
    """Return one description, or two, as lines; equal texts are written once.

    Parameters
    ----------
    width
        Characters of the column of names.
    first, second
        Texts by name, as `describe_setting` returns them.
    """
    lines = []
    other = first if second is None else second
    for name in {**first, **other}:
        one, two = first.get(name, "none"), other.get(name, "none")
        texts = [one] if one == two else [f"first: {one}", f"second: {two}"]
        lines += [f"{'' if place else name:{width}}{text}" for place, text in enumerate(texts)]
    return "\n".join(lines)
