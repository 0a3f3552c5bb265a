"""The reasons for which shots are invalid, as text."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hoopgen.core.parameters import ParameterValues, resolve
from hoopgen.core.start_contact import MAX_START_GAP
from hoopgen.core.validation import check_leaving, check_states
from hoopgen.engine.compiled_scene import CompiledScene
from hoopgen.scene.lookup import SceneLike
from hoopgen.simulation.lookup import engine_of

from .run import run
from .start_checks import StartCheck

if TYPE_CHECKING:
    from hoopgen.derive.scenes.scene import Parameter
    from hoopgen.derive.surfaces import Surface

RADII = {"ball_radius", "ring_radius", "wire_radius"}
"""Parameters of a hoop that limit each other: the ball must fit through the ring."""


def why_invalid(
    states: ArrayLike,
    parameters: ParameterValues | None = None,
    *,
    scene: SceneLike = None,
    leaving: ArrayLike | None = None,
) -> list[str]:
    """Return the reason why each shot is INVALID, as text.

    Parameters
    ----------
    states, parameters, scene, leaving
        As in `simulate`; SI units.

    Returns
    -------
    list of str
        One text for each shot, empty where the shot can be simulated.

    Raises
    ------
    TypeError, ValueError
        If an argument is not as described; the message says what is expected.

    Examples
    --------
    >>> import hoopgen
    >>> hoopgen.why_invalid([0, 0, 1, 1e20, 0, 0, 0, 0, 0])
    ['out of range: vx 1e+20; in a release at most 1.07374e+09']
    """
    releases = check_states(states)
    engine = engine_of(scene)
    left = check_leaving(leaving, len(releases), engine.surfaces)
    shots = run(engine, releases, parameters, leaving=leaving, max_contacts=1, fields=("outcome",))
    values = resolve(parameters, len(releases), engine.table)
    texts = [""] * len(releases)
    for row in np.flatnonzero(shots.outcome == engine.outcomes["INVALID"]):
        own = {
            name: np.float64(np.broadcast_to(value, len(releases))[row])
            for name, value in values.items()
        }
        last = -1 if left is None else int(left[row])
        texts[row] = reason(releases[row], own, engine, last)
    return texts


def reason(
    state: NDArray[np.float64],
    parameters: Mapping[str, float],
    scene: CompiledScene,
    leaving: int = -1,
) -> str:
    """Return the reason why an invalid shot is invalid.

    Parameters
    ----------
    state
        State of its release, (9,).
    parameters
        All parameters of the scene, one number each.
    scene
        The scene of the shot.
    leaving
        The body that the ball leaves at the start, -1 for none.
    """
    wrong = [
        name
        for name, value in parameters.items()
        if not np.isfinite(value) and not (name in scene.infinite and value == np.inf)
    ]
    if wrong:
        return f"not finite: {', '.join(wrong)}"
    if not allowed(scene, parameters):
        names = not_allowed(scene, parameters)
        together = names or _not_allowed_together(scene, parameters)
        named = ", ".join(f"{name} {parameters[name]:g}" for name in together)
        named += "" if names else ", together"
        return f"parameter not allowed: {named}{_why_not_allowed(scene, parameters, names)}"
    if sizes := out_of_range(scene, parameters):
        return f"out of range: {'; '.join(sizes)}"
    if not np.isfinite(state).all():
        return "not finite: the release"
    largest = scene.kernels.MAX_SIZE
    large = [
        f"{name} {value:g}"
        for name, value in zip(scene.kernels.STATE, state, strict=True)
        if abs(value) > largest
    ]
    if large:
        return f"out of range: {', '.join(large)}; in a release at most {largest:g}"
    if leaving >= 0 and (said := _no_contact(scene, state, parameters, leaving)):
        return said
    bodies = np.arange(len(scene.surfaces))
    # A ball that is inside one body alone could start by leaving that body.
    check = StartCheck(scene, scene.table.inputs(parameters), bodies.astype(np.int8), None)
    invalid = check.is_invalid(bodies, np.tile(state, (len(bodies), 1)), leaves=True)
    inside = [scene.surfaces[index] for index in np.flatnonzero(~invalid) if index != leaving]
    if len(inside) != 1:
        inside = _overlapped(scene, state, parameters)
    if leaving >= 0 and (others := [n for n in inside if n != scene.surfaces[leaving]]):
        own = StartCheck(scene, check.inputs, np.array([leaving], np.int8), None)
        if own.touches_others(state[None])[0]:
            return (
                f"leaving: the ball touches the {' and the '.join(others)} besides the "
                f"{scene.surfaces[leaving]}; expected in contact with one body"
            )
    return f"inside the {' and the '.join(inside)}" if inside else "inside several surfaces"


def _no_contact(
    scene: CompiledScene,
    state: NDArray[np.float64],
    parameters: Mapping[str, float],
    leaving: int,
) -> str:
    """Return the reason why a ball does not touch the body that it leaves, "" if it does."""
    check = StartCheck(scene, scene.table.inputs(parameters), np.array([leaving], np.int8), None)
    away, inside = check.start_contact(state[None])
    if not (away[0] or inside[0]):
        return ""
    name, where = scene.surfaces[leaving], "inside" if inside[0] else "away from"
    return (
        f"leaving: the ball is {where} the {name}; expected in contact, to "
        f"1/{1 / MAX_START_GAP:.0f} of its radius"
    )


def allowed(scene: CompiledScene, parameters: Mapping[str, float]) -> bool:
    """Return whether a scene allows these parameters: all of its own in order, one number each.

    Parameters
    ----------
    scene
        The scene.
    parameters
        The parameters, SI units.
    """
    found: bool = _evaluate(scene, "allowed", scene.table.inputs(parameters)) > 0
    return found


def not_allowed(scene: CompiledScene, parameters: Mapping[str, float]) -> list[str]:
    """Return the parameters that make the others allowed if their default replaces them.

    Parameters
    ----------
    scene
        The scene.
    parameters
        All of its parameters in order, one number each, SI units.
    """
    usual = scene.table.defaults
    return [n for n in parameters if allowed(scene, {**parameters, n: np.float64(usual[n])})]


def _not_allowed_together(scene: CompiledScene, parameters: Mapping[str, float]) -> list[str]:
    """Return parameters that are not allowed with the others, though none of them by itself.

    In order, each is taken if it is allowed with those taken before, and with the defaults of the
    rest.
    """
    usual = {name: np.float64(scene.table.defaults[name]) for name in parameters}
    found = []
    for name, value in parameters.items():
        if allowed(scene, usual | {name: value}):
            usual[name] = np.float64(value)
        else:
            found.append(name)
    return found


def _why_not_allowed(
    scene: CompiledScene, parameters: Mapping[str, float], names: Sequence[str]
) -> str:
    """Return the condition that parameters break, to be put after them.

    Parameters
    ----------
    scene
        The scene.
    parameters
        All of its parameters in order, one number each, SI units.
    names
        Those that are not allowed by themselves.
    """
    positive = {name for name in names if parameters[name] > 0}
    if scene.has_hoop and names and positive == set(names) <= RADII:
        return "; the ball is too big for the ring"
    try:
        derived = scene.scene
    except ModuleNotFoundError:  # a shipped scene runs without SymPy
        return ""
    values = dict(zip(derived.symbols, map(float, scene.table.inputs(parameters)), strict=True))
    for one in derived.parameters:
        if said := _broken_limit(one, values[one.symbol]):
            owner = "" if one.name in parameters else "the scene's "
            return f"; {owner}{one.name} has to be {said}"
    for requirement in derived.requirements:
        if not float(requirement.subs(values)) > 0.0:
            terms = requirement.as_ordered_terms()
            less = [-term for term in terms if term.could_extract_minus_sign()]
            more = [term for term in terms if not term.could_extract_minus_sign()]
            return f"; {sum(less)} has to be less than {sum(more)}"
    return ""


def _broken_limit(parameter: Parameter, value: float) -> str:
    """Return the range of a parameter that a number is out of, "" if it is within."""
    least, most = parameter.least, math.inf if parameter.upper is None else parameter.upper
    if math.isnan(value) and -least == most == math.inf:
        return "a number; a direction of length 0 and a formula without a value have none"
    positive = parameter.sign == "positive" and parameter.lower is None
    if least <= value <= most and not (positive and value == 0.0):
        return ""
    if most == math.inf:
        return f"above {least:g}" if positive else f"at least {least:g}"
    return f"above {least:g} and at most {most:g}" if positive else f"from {least:g} to {most:g}"


def _overlapped(
    scene: CompiledScene, state: NDArray[np.float64], parameters: Mapping[str, float]
) -> list[str]:
    """Return the bodies that the ball overlaps, by the formulas of their faces.

    A ball in a thin wall overlaps several faces of one body. Without SymPy none is named.
    """
    try:
        from hoopgen.derive.symbolic.conditionals import release
        from hoopgen.derive.symbolic.symbols import POSITION
    except ModuleNotFoundError:  # a shipped scene runs without SymPy
        return []
    derived = scene.scene
    numbers = [*state[:3].tolist(), *map(float, scene.table.inputs(parameters))]
    values = dict(zip((*POSITION, *derived.symbols), numbers, strict=True))

    def overlaps(face: Surface) -> bool:
        return all(float(release(e).subs(values)) < 0.0 for e in face.inside)

    return [body.name for body in derived.bodies if any(map(overlaps, body.faces))]


def out_of_range(scene: CompiledScene, parameters: Mapping[str, float]) -> list[str]:
    """Return the sizes with which arithmetic could over- or underflow, and the expected range.

    Parameters
    ----------
    scene
        The scene of the parameters.
    parameters
        All of its parameters, one finite number each, which are allowed.
    """
    inputs = scene.table.inputs(parameters)
    if _evaluate(scene, "parameters_in_range", inputs, allowed=1.0):
        return []
    said = []
    for (name, (least, most)), value in zip(scene.kernels.SIZE_LIMITS.items(), inputs, strict=True):
        if not least <= abs(value) <= most:
            expected = f"{least:g} to {most:g}" if least else f"at most {most:g}"
            own = f"{name} {value:g}"
            computed = f"{scene.kernels.PARAMETERS[name][2]} = {value:g}"
            which = own if name in parameters else computed
            said.append(f"{which}, expected a size of {expected}")
    return said or ["all coefficients of a surface's formula, which are too small"]


def _evaluate(scene: CompiledScene, kernel: str, inputs: Any, **more: Any) -> Any:
    """Return the first output of a kernel for the scene's inputs and further arguments."""
    given = dict(zip(scene.kernels.VARIABLES.values(), map(np.float64, inputs), strict=True)) | more
    with np.errstate(all="ignore"):
        outputs = getattr(scene.kernels, kernel)(
            *(given[name] for name in scene.kernels.ARGUMENTS[kernel])
        )
    return outputs[0]
