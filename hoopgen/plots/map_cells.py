"""The cells of a map, read from an xarray.Dataset, in display units."""

from __future__ import annotations

import json
from collections.abc import Hashable, Mapping
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from hoopgen.core.variables import STATE_UNITS, is_state
from hoopgen.hoop.presets import NAMES, PRESETS, nearest_preset
from hoopgen.report.provenance import describe_dataset
from hoopgen.report.quantities import Quantity, quantity
from hoopgen.text.numbers import format_count, format_interval, format_percent
from hoopgen.text.shorten import brief

from .class_legend import CLASSES, Class, classify, outcome_classes
from .floor_plan import on_floor

if TYPE_CHECKING:
    import xarray as xr

Numbers = NDArray[np.float64]

_REQUIRED_VARIABLES: Mapping[str, tuple[str, ...]] = {
    "probability": ("probability",),
    "kind": ("kind", "outcome"),
    "outcome": ("outcome",),
}
"""The quantities that a map can show, and the variables of the dataset that each needs."""

_OUTCOME_DIMENSION = "ending"
"""The dimension of outcomes, in maps of a scene of one's own."""

_MAX_PANELS = 12
"""Panels on a page, at most."""


@dataclass(frozen=True)
class Axis:
    """A dimension of a map.

    Attributes
    ----------
    name
        Of the variable.
    values
        Of the cells, in the unit shown, (n,).
    quantity
        How they are shown.
    """

    name: str
    values: Numbers
    quantity: Quantity

    def edges(self) -> Numbers:
        """Return the borders of the cells, halfway between the values, (n + 1,)."""
        if len(self.values) == 1:
            return np.asarray(self.values[0] + np.array([-0.5, 0.5]))
        middles = (self.values[1:] + self.values[:-1]) / 2.0
        first, last = 2.0 * self.values[0] - middles[0], 2.0 * self.values[-1] - middles[-1]
        return np.asarray(np.concatenate([[first], middles, [last]]))


@dataclass(frozen=True)
class Cells:
    """The values of a map that are drawn, in display units.

    Attributes
    ----------
    of
        ``"probability"``, ``"kind"`` or ``"outcome"``.
    axes
        The one drawn across, the one drawn up, the one with a panel for each value.
    values
        By axis: probabilities, or places in `classes`.
    interval
        Its ends, as `values`, if there is one.
    confidence
        Of the interval, if it is known.
    note
        What is the same in all cells.
    scene
        The scene alone, a sentence; empty if the dataset does not say it.
    label
        Of probabilities.
    classes
        What single shots can be; none of probabilities.
    hoop
        Parameters of the hoop of a map over places on the floor, x and y; of another None.
    measured
        Whether the shots were drawn from measured releases: then the interval is not the sample's.
    """

    of: str
    axes: tuple[Axis, ...]
    values: NDArray[Any]
    interval: tuple[Numbers, Numbers] | None
    confidence: float | None
    note: str
    scene: str
    label: str = "shots made (%)"
    classes: tuple[Class, ...] = ()
    hoop: Mapping[str, float] | None = None
    measured: bool = False

    @property
    def nowhere(self) -> NDArray[np.bool_]:
        """A mask of the cells that have no flight."""
        if not self.classes:
            return np.asarray(np.isnan(self.values))
        invalid = [one.outcome for one in self.classes].index("invalid")
        return np.asarray(self.values == invalid)

    @property
    def present(self) -> list[Class]:
        """The classes that the key names: hatched cells are none, and probabilities have none."""
        if not self.classes:
            return []
        return [self.classes[place] for place in np.unique(self.values[~self.nowhere])]

    def panels(self) -> list[Cells]:
        """Return the map for each value of the third variable, if there is one."""
        if len(self.axes) < 3:
            return [self]
        third = self.axes[2]
        return [
            replace(
                self,
                axes=self.axes[:2],
                values=self.values[..., i],
                interval=self.interval and (self.interval[0][..., i], self.interval[1][..., i]),
                note=f"{third.quantity.name} {third.quantity.format(value)}",
            )
            for i, value in enumerate(third.values)
        ]

    def flat(self) -> Cells:
        """Return the cells to draw: places on the floor from `on_floor`, all else unchanged."""
        if self.hoop is None:
            return self
        place = {axis.name: axis for axis in self.axes[:2]}
        x, y = (axis.values * axis.quantity.size for axis in (place["x"], place["y"]))
        across, up = on_floor(np.zeros_like(y), y)[:, 0], on_floor(x, np.zeros_like(x))[:, 1]
        turned = self.axes[0].name == "x"

        def seen(values: NDArray[Any]) -> NDArray[Any]:
            return values.swapaxes(0, 1) if turned else values

        return replace(
            self,
            axes=(
                Axis("y", across, Quantity("", "")),
                Axis("x", up, Quantity("", "")),
                *self.axes[2:],
            ),
            values=seen(self.values),
            interval=self.interval and (seen(self.interval[0]), seen(self.interval[1])),
            hoop=None,
        )

    def point(self, place: tuple[int, ...]) -> list[float]:
        """Return the place at which a cell is drawn."""
        turned = self.hoop is not None and self.axes[0].name == "x"
        return self.flat().at(place[::-1] if turned else place)

    def best(self) -> tuple[int, ...] | None:
        """Return the place of the greatest probability, if any is above 0."""
        if not np.nanmax(self.values, initial=0.0) > 0.0:
            return None
        return tuple(int(i) for i in np.unravel_index(np.nanargmax(self.values), self.values.shape))

    def at(self, place: tuple[int, ...]) -> list[float]:
        """Return the place of a cell."""
        return [float(axis.values[i]) for axis, i in zip(self.axes, place, strict=True)]

    def say(self, place: tuple[int, ...]) -> str:
        """Describe the probability and the place of a cell."""
        where = ", ".join(
            f"{axis.name} " * (self.hoop is not None) + axis.quantity.format(value)
            for axis, value in zip(self.axes, self.at(place), strict=True)
        )
        between = ""
        if self.interval is not None:
            low, high = (float(bound[place]) for bound in self.interval)
            between = f" ({format_interval(low, high)})"
        return f"{format_percent(float(self.values[place]))}{between} at {where}"


def read_cells(dataset: xr.Dataset, of: str | None = None) -> Cells:
    """Return the part of a map to draw; arguments and errors as of `plot_map`.

    Parameters
    ----------
    dataset
        The map.
    of
        The quantity that is drawn; None for the first.
    """
    label = Cells.label
    if _OUTCOME_DIMENSION in dataset.dims:
        dataset, end = _select_end(dataset, of)
        label, of = f"shots {end} (%)", None
    chosen = _choose(dataset, of)
    dims = dataset[chosen].dims
    if not 1 <= len(dims) <= 3 or (len(dims) == 3 and dataset.sizes[dims[2]] > _MAX_PANELS):
        sizes = ", ".join(f"{name} ({dataset.sizes[name]})" for name in dims) or "none"
        raise ValueError(
            f"dataset: expected one or two variables, and a third of up to {_MAX_PANELS} "
            "values; got "
            f"{sizes}. Select values of the others: dataset.sel(name=value, method='nearest')"
        )

    def values(name: str) -> NDArray[Any]:
        return np.asarray(dataset[name].transpose(*dims))

    classes: tuple[Class, ...] = ()
    if chosen == "kind":
        drawn, classes = classify(values("outcome"), values("kind")), CLASSES
    elif chosen == "outcome":
        classes = outcome_classes(_outcome_names(dataset["outcome"]))
        drawn = _outcome_codes(values("outcome"), len(classes))
    else:
        drawn = values(chosen).astype(np.float64)
    bounds = ("low", "high")
    confidence = dataset.attrs.get("confidence")
    return Cells(
        of=chosen,
        hoop=_hoop(dataset) if {"x", "y"} == set(dims[:2]) else None,
        axes=tuple(_axis(dataset, name) for name in dims),
        values=drawn,
        interval=(values("low"), values("high"))
        if all(name in dataset for name in bounds)
        else None,
        confidence=None if confidence is None else float(confidence),
        note=_note(dataset),
        scene=_scene(dataset),
        label=label,
        classes=classes,
        measured="columns" in dataset.attrs,
    )


def _outcome_names(outcome: xr.DataArray) -> list[str]:
    """Return the names of outcomes, by their codes."""
    names = str(outcome.attrs.get("flag_meanings", "")).split()
    if "invalid" not in names:
        raise ValueError(
            "dataset: expected the names of its outcomes in their flag_meanings, as hoopgen.map "
            f"gives them; got {', '.join(names) or 'none'}"
        )
    return names


def _outcome_codes(codes: NDArray[Any], count: int) -> NDArray[Any]:
    """Return codes of so many outcomes, if they are that."""
    if codes.size and not 0 <= codes.min() <= codes.max() < count:
        raise ValueError(f"outcome: expected codes from 0 to {count - 1}")
    return codes


def _hoop(dataset: xr.Dataset) -> Mapping[str, float] | None:
    """Return the parameters of a dataset's hoop; None if it has none, or does not say so."""
    parameters = json.loads(dataset.attrs.get("parameters", "{}"))
    parameters |= {
        str(name): float(column.mean()) for name, column in dataset.coords.items() if name in NAMES
    }
    given = {name: float(parameters[name]) for name in NAMES if name in parameters}
    if not {"ring_radius", "board_distance"} <= given.keys():
        return None
    return {**PRESETS[nearest_preset(given)[0]], **given}


def _select_end(dataset: xr.Dataset, of: str | None) -> tuple[xr.Dataset, str]:
    """Return a map of a scene of one's own as that of one of its ends, by default the first."""
    ends = [str(name) for name in dataset[_OUTCOME_DIMENSION].values]
    if of is not None and of not in ends:
        raise ValueError(f"of: expected {' or '.join(ends)} for this dataset, got {brief(of)}")
    end = of or ends[0]
    return dataset.sel({_OUTCOME_DIMENSION: end}).rename(share="probability"), end


def _choose(dataset: xr.Dataset, of: str | None) -> str:
    possible = [
        name for name, needs in _REQUIRED_VARIABLES.items() if all(one in dataset for one in needs)
    ]
    if not possible:
        raise ValueError(
            "dataset: expected the variable probability, or outcome, as hoopgen.map gives "
            f"them; got {', '.join(map(str, dataset.data_vars)) or 'none'}"
        )
    if of is not None and of not in possible:
        raise ValueError(f"of: expected {' or '.join(possible)} for this dataset, got {brief(of)}")
    return of or possible[0]


def _axis(dataset: xr.Dataset, name: Hashable) -> Axis:
    column = dataset[name]
    values = np.asarray(column)
    ordered = np.issubdtype(values.dtype, np.number) and bool(np.isfinite(values).all())
    steps = np.diff(values) if ordered else np.zeros(1)
    if not (np.all(steps > 0) or np.all(steps < 0)):
        raise ValueError(
            f"dataset: coordinate {name}: expected numbers in order, got {brief(values)}"
        )
    quantity_ = _quantity(dataset, str(name), column.attrs)
    return Axis(str(name), quantity_.convert(values), quantity_)


def _note(dataset: xr.Dataset) -> str:
    """Describe what is the same in all cells, and the provenance of the probabilities."""
    attributes = dataset.attrs
    scene = _scene(dataset)
    same = [
        _format(_quantity(dataset, str(name), column.attrs), float(column))
        for name, column in dataset.coords.items()
        if column.ndim == 0 and np.issubdtype(column.dtype, np.number)
        if not (scene and name in NAMES)  # those are the scene's
    ]
    scatter = [
        _format(_quantity(dataset, name), sd)
        for name, sd in json.loads(attributes.get("sd", "{}")).items()
    ]
    scatter += [
        f"correlation of {one} and {other} {Quantity('', '').format(value)}"
        for one, other, value in json.loads(attributes.get("correlation", "[]"))
        if value
    ]
    shots = set(np.unique(dataset["shots"]).tolist()) if "shots" in dataset else set()
    rest = [f"{format_count(number, 'shot')} a cell" for number in shots if len(shots) == 1]
    rest += [f"seed {attributes['seed']}"] if "seed" in attributes else []
    spread = f"standard deviations: {', '.join(scatter)}" if scatter else ""
    if "columns" in attributes:
        spread = f"measured releases: {', '.join(json.loads(attributes['columns']))}"
    sentences = (", ".join(same), spread, ", ".join(rest))
    notes = [f"{_capitalise(said)}." for said in sentences if said]
    return " ".join([scene, *notes]).strip()


def _capitalise(sentence: str) -> str:
    """Return it with a capital letter, if it does not begin with a component of a state."""
    begins = sentence.split(maxsplit=1)[0] in STATE_UNITS
    return sentence if begins else f"{sentence[0].upper()}{sentence[1:]}"


def _scene(dataset: xr.Dataset) -> str:
    scene = describe_dataset(dataset).get("scene", "")
    return f"Scene: {scene}." if scene else ""


def _quantity(
    dataset: xr.Dataset, name: str, attributes: Mapping[Any, Any] | None = None
) -> Quantity:
    """Return the display of a variable of a map: components of a state, x and y too, unchanged."""
    if name in STATE_UNITS and is_state(map(str, dataset.coords)):
        return Quantity(name, STATE_UNITS[name])
    return quantity(name, attributes)


def _format(quantity: Quantity, value: float) -> str:
    """Return a variable's name, without the remark on its sign, and its value."""
    return f"{_strip_remark(quantity.name)} {quantity.format(float(quantity.convert(value)))}"


def _strip_remark(name: str) -> str:
    """Return a name without what follows a comma, but for that which is the name: x and y."""
    first, _, rest = name.partition(", ")
    return name if rest in ("x", "y") else first
