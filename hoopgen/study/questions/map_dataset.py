"""The dataset of a map: shares of shots over the cells, or what becomes of one in each."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from enum import IntEnum
from typing import Any, TypeAlias

import numpy as np
import xarray as xr
from numpy.typing import ArrayLike, NDArray

from hoopgen.core.extras import version
from hoopgen.core.variables import Variable
from hoopgen.hoop.kinds import Kind, hoop_outcomes
from hoopgen.hoop.variables import STANDS_FOR, change_variables
from hoopgen.report.provenance import (
    describe_hoop,
    describe_scene,
    describe_setting,
    model_attributes,
)
from hoopgen.report.quantities import for_json
from hoopgen.results.shots import Outcome
from hoopgen.scene.lookup import STATES, outcomes_of, variables_of
from hoopgen.simulation.engine import Engine
from hoopgen.study.models.requirements import alike, scene_by_row
from hoopgen.study.models.resample import Resample
from hoopgen.study.statistics.intervals import wilson_interval
from hoopgen.study.statistics.outcome_shares import INVALID
from hoopgen.study.statistics.tally import Tally
from hoopgen.text.numbers import format_percent

from .sweep import Sweep

ENDING = "ending"
"""The dimension of outcomes, in a scene of one's own."""

SIMULATION_ALONE = (
    "of the simulation alone: it does not contain the uncertainty of the sample, for which "
    "hoopgen.estimate has an interval"
)
"""Description of the intervals of a map of measured releases."""

_ENDING = {"long_name": "how a shot ends"}

Floats: TypeAlias = NDArray[np.float64]
Counts: TypeAlias = NDArray[np.int64]


def dataset(work: Sweep, numbers: Counts, level: float) -> xr.Dataset:
    """Return the dataset of a map.

    Parameters
    ----------
    numbers
        Of its cells, (cells, columns): rows of a `Tally` or, without scatter, outcome, kind and
        uncertainty.
    """
    numbers = numbers.reshape(*work.shape, -1)
    if not work.model.scatters:
        data = _outcomes(work, numbers)
    elif work.scene.has_hoop:
        data = _probabilities(work, numbers, level)
    else:
        data = _shares(work, numbers, level)
    return xr.Dataset(data, _coordinates(work), _attributes(work, level))


def _shares(work: Sweep, numbers: Counts, level: float) -> dict[str, xr.Variable]:
    """Return the variables of a map with scatter, of a scene of one's own."""
    tally = Tally.read(numbers, work.scene)
    count, dims = tally.table[..., 0, :], (*work.axes, ENDING)
    valid = tally.valid[..., None]
    # An invalid shot is no trial.
    trial = np.array(outcomes_of(work.scene)) != INVALID
    with np.errstate(invalid="ignore", divide="ignore"):
        share = np.where(trial, count / valid, np.nan)
    ends = wilson_interval(np.where(trial, count, 0), valid, level)
    ends = (share, share) if work.model.still else ends
    low, high = (np.where(trial, end, np.nan) for end in ends)
    text, labels = f"of its {_interval(work, level)}", number_labels(work.scene)
    shared = {
        "shots": tally.shots,
        **tally.counts,
        "uncertain": tally.uncertain,
        "uncertain_capped": tally.uncertain_capped,
    }
    return {
        "share": _variable(dims, share, "share of the shots that end so"),
        "low": _variable(dims, low, f"lower end {text}"),
        "high": _variable(dims, high, f"upper end {text}"),
        "count": _variable(dims, count, "shots that end so"),
        **{name: _variable(dims[:-1], n, labels[name]) for name, n in shared.items()},
    }


def _probabilities(work: Sweep, numbers: Counts, level: float) -> dict[str, xr.Variable]:
    """Return the variables of a map with scatter, where there is a hoop."""
    tally = Tally.read(numbers, work.scene)
    made, valid = tally.ended(Outcome.MADE), tally.valid
    low, high = wilson_interval(made, valid, level)
    with np.errstate(invalid="ignore"):
        probability = made / valid
        kinds = tally.of_kind()
        kinds[..., Kind.NONE] -= tally.shots - tally.valid
        share = kinds / valid[..., None]
    if work.model.still:  # every throw is the same, so there is nothing to be estimated
        low = high = probability
    dims, labels = tuple(work.axes), number_labels(work.scene)
    counts = {
        "shots": tally.shots,
        **{one: tally.ended(Outcome[one.upper()]) for one in _counted(work.scene)},
        **tally.counts,
        "uncertain": tally.uncertain,
        "uncertain_capped": tally.uncertain_capped,
    }
    return {
        "probability": _variable(dims, probability, "probability of a made shot"),
        "low": _variable(dims, low, f"lower end of its {_interval(work, level)}"),
        "high": _variable(dims, high, f"upper end of its {_interval(work, level)}"),
        "share": _variable((*dims, "kind"), share, "share of the valid shots that are of a kind"),
        **{name: _variable(dims, n, labels[name]) for name, n in counts.items()},
    }


def _interval(work: Sweep, level: float) -> str:
    """Return the meaning of the intervals as text; they leave out the uncertainty of a sample."""
    text = f"{format_percent(level, None)} interval (Wilson)"
    return f"{text} of the simulation alone" if isinstance(work.model, Resample) else text


def _counted(scene: Engine) -> tuple[str, ...]:
    """Return the outcomes of which a map has the numbers; the missed ones are the others."""
    return tuple(one.name.lower() for one in hoop_outcomes(scene.rolls) if one != Outcome.MISSED)


_LABELS = {
    "shots": "shots",
    "made": "shots made",
    "capped": "shots given up after so many contacts",
    "short": "shots that never come down through the end plane",
    "lodged": "shots that come to rest on the hoop",
    "endless": "shots still on their way at the time limit",
    "invalid": "shots that cannot be simulated, and are no trials",
    "uncertain": "shots with a decision within its rounding-error bound",
    "uncertain_capped": "those of them that were given up",
}


def number_labels(scene: Engine) -> dict[str, str]:
    """Return the meanings of the numbers of a map."""
    return _LABELS | {result.tally: result.tally_summary for result in scene.layout.counted_results}


def _outcomes(work: Sweep, numbers: Counts) -> dict[str, xr.Variable]:
    """Return the variables of a map of single shots."""
    outcome, kind, uncertain = np.moveaxis(numbers.astype(np.uint8), -1, 0)
    dims = tuple(work.axes)
    kinds = {"kind": _flags(dims, kind, "kind of shot", Kind)} if work.scene.has_hoop else {}
    return {
        "outcome": _flags(dims, outcome, "outcome", work.scene.outcomes),
        **kinds,
        "uncertain": xr.Variable(
            dims,
            uncertain.astype(np.bool_),
            {"long_name": "some decision is within its rounding-error bound"},
        ),
    }


def _variable(dims: tuple[str, ...], values: ArrayLike, label: str) -> xr.Variable:
    return xr.Variable(dims, values, {"units": "1", "long_name": label})


def _flags(
    dims: tuple[str, ...], values: NDArray[np.uint8], label: str, of: type[IntEnum]
) -> xr.Variable:
    """Return codes with their names, by the CF conventions."""
    attributes = {
        "long_name": label,
        "flag_values": np.array([one.value for one in of], np.uint8),
        "flag_meanings": " ".join(one.name.lower() for one in of),
    }
    return xr.Variable(dims, values, attributes)


def _coordinates(work: Sweep) -> dict[str, xr.Variable]:
    """Return the axes, and what is the same in all cells."""
    known = variables_of(work.scene)
    if work.model.is_state:
        known = {**known, **STATES}
    coordinates = {
        name: xr.Variable((name,), values, _units(known[name]))
        for name, values in work.axes.items()
    }
    for name, value in _same(work).items():
        coordinates[name] = xr.Variable((), value, _units(known[name]))
    if work.model.scatters and not work.scene.has_hoop:
        coordinates[ENDING] = xr.Variable(ENDING, list(outcomes_of(work.scene)), _ENDING)
    elif work.model.scatters:
        names = [kind.name.lower() for kind in Kind]
        coordinates["kind"] = xr.Variable("kind", names, {"long_name": "kind of shot"})
    return coordinates


def _same(work: Sweep) -> dict[str, float]:
    """Return the variables that are the same in all cells."""
    if work.model.is_state:
        return {n: v for n, v in alike(work.model).items() if n not in work.axes}
    gone = {*work.axes, *(other for name in work.axes for other in STANDS_FOR.get(name, ()))}
    same = change_variables(alike(work.model), dict.fromkeys(work.axes))
    return {name: value for name, value in same.items() if name not in gone}


def _units(variable: Variable) -> dict[str, str]:
    return {"units": variable.unit or "1", "long_name": variable.label}


def _attributes(work: Sweep, level: float) -> dict[str, Any]:
    """Return the provenance of the map; mappings as JSON, which every file format takes."""
    by_row = [name for name in scene_by_row(work.model, work.parameters) if name not in work.axes]
    others = {n: v for n, v in work.parameters.items() if n not in (*work.axes, *by_row)}
    scene = others | {n: v for n, v in alike(work.model).items() if n in others}
    return {
        "Conventions": "CF-1.11",
        "source": f"hoopgen {version()}",
        **_scene_attributes(work, scene, by_row),
        "parameters": json.dumps(for_json(scene)),
        "max_contacts": work.max_contacts,
        **(
            {}
            if not work.model.scatters
            else {
                **model_attributes(work.model.identity()),
                "seed": str(work.seed),
                "confidence": level,
                **({"interval": SIMULATION_ALONE} if isinstance(work.model, Resample) else {}),
            }
        ),
    }


def _scene_attributes(
    work: Sweep, scene: Mapping[str, float], by_row: Sequence[str]
) -> dict[str, str]:
    """Return the attributes of the scene; for a scene of your own also those no reader has."""
    if work.scene.is_hoop:
        return {"scene": describe_hoop(scene, by_row)}
    attributes = describe_setting(
        {**work.model.identity(), "parameters": work.parameters}, work.scene
    )
    names = ("release", "scatter") if work.model.scatters else ("release",)
    return {
        # What is mapped over is in the coordinates.
        "scene": describe_scene(work.scene, scene, by_row),
        "scene_sha256": work.scene.identity["sha256"],
        **{f"said_{name}": attributes[name] for name in names if attributes.get(name)},
    }


# ------------------------------------------------------------------------------------ in short


def shares_of_ends(dataset: xr.Dataset) -> dict[str, float] | None:
    """Return the shares of the outcomes of all cells together; None of a map of probabilities."""
    if "outcome" in dataset:
        names = dataset["outcome"].attrs["flag_meanings"].split()
        codes = dataset["outcome"].values
        return {name: float(np.mean(codes == code)) for code, name in enumerate(names)}
    if "count" not in dataset:
        return None
    counts = dataset["count"].sum([name for name in dataset["count"].dims if name != ENDING])
    ended = dict(zip(dataset[ENDING].values.tolist(), counts.values.tolist(), strict=True))
    valid = sum(count for name, count in ended.items() if name != "invalid")
    return {name: n / valid for name, n in ended.items() if valid and name != "invalid"}


def best_cell(dataset: xr.Dataset) -> dict[str, float] | None:
    """Return the variables of the cell with the greatest probability, and its interval.

    None if no cell can be simulated.
    """
    probability = dataset["probability"]
    if probability.isnull().all():
        return None
    best = dataset.isel(probability.argmax(...))
    names = (*map(str, probability.dims), "probability", "low", "high")
    return {name: best[name].item() for name in names}
