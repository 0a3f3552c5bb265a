"""Counterfactuals: the smallest changes of a release with which a shot ends otherwise."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from hoopgen.core.argument_types import check_arguments
from hoopgen.core.extras import MissingExtra, command_for
from hoopgen.core.validation import as_number, check_index
from hoopgen.results.shots import Shots
from hoopgen.simulation.engine import Engine
from hoopgen.simulation.invalid_shots import why_invalid
from hoopgen.simulation.simulate import simulate
from hoopgen.study.jobs.monte_carlo import outcome_by

from .counterfactual_result import Change, Counterfactual
from .one_variable import OneShot, variables_of_shot

_FURTHER = (0.0, *np.geomspace(1e-7, 0.03, 12).tolist())
"""Distances from a change at which the judge is asked, as shares of the change: at its very edge
there may be so many contacts that a ball rolls, which the judge does not follow."""


@check_arguments
def counterfactual(
    shots: Shots,
    i: int = 0,
    vary: Sequence[str] | None = None,
    *,
    by: str | None = None,
    steady: float = 0.05,
    max_contacts: int | None = None,
    prove: bool = True,
) -> Counterfactual:
    """Find the smallest changes with which a shot ends otherwise: missed ones go in, made ones not.

    Each variable is changed alone. Thousands of values are tried, more of them where the contacts
    differ between neighbours; the nearest change of the result is then narrowed down to what
    doubles decide, and the judge proves how the shot ends on both of its sides.

    Parameters
    ----------
    shots
        Of `hoopgen.simulate`.
    i
        Which of them.
    vary
        Variables: arguments of `hoopgen.release` where there is a hoop, elsewhere components of the
        state; and parameters of the scene. By default speed, elevation and azimuth; without a hoop
        vx, vy and vz.
    by
        End that counts: made or missed; in a scene of your own one of its ends. By default the
        first.
    steady
        How much further than a change the other result must last, as a share of the change. Close
        to the edges between sequences of contacts there are intervals of made shots with a dozen
        contacts that are narrower than any player's skill; 0 counts them, too.
    max_contacts
        As the shots were simulated with.
    prove
        Whether the judge proves the results; it needs the extra ``certify``.

    Returns
    -------
    Counterfactual
        Of each variable the smallest change.

    Raises
    ------
    TypeError, ValueError
        If an argument is not as described; if the shot is invalid, or does not end as the shots
        say with these `max_contacts` and the time limit of the scene.
    IndexError
        If there is no such shot.
    ImportError
        If a proof is wanted, and what it needs is missing.
    """
    steady = as_number("steady", steady, "a number from 0 up")
    if not 0.0 <= steady < math.inf:
        raise ValueError(f"steady: expected a number from 0 up, got {steady}")
    scene = shots.scene
    if not isinstance(scene, Engine):
        raise TypeError("shots: expected the Shots of simulate, which know their engine")
    index = check_index("i", i, len(shots))
    one = OneShot(
        scene,
        np.array(shots.releases[index]),
        {
            name: float(np.broadcast_to(v, len(shots))[index])
            for name, v in shots.parameters.items()
        },
        outcome_by(scene, by),
        max_contacts,
    )
    names = variables_of_shot(vary, scene)
    itself = simulated_like(shots, index, one)
    outcome = scene.outcomes(int(itself.outcome[0]))
    if outcome == scene.outcomes["INVALID"]:
        (why,) = why_invalid(one.state, one.parameters, scene=scene)
        raise ValueError(f"shots: shot {i} is invalid: {why}")
    if prove:
        _require_judge()
    if int(np.asarray(shots.outcome)[index]) != outcome:
        raise ValueError(
            f"max_contacts: with {max_contacts}, and the time limit of the scene, shot {i} ends as "
            f"{outcome.name}, in the shots as {scene.outcomes(int(shots.outcome[index])).name}; "
            "give what they were simulated with"
        )
    succeeds = int(outcome) == one.end
    gaps = {name: _nearest(one, name, succeeds, steady) for name in names}
    proofs: dict[str, bool] = {}
    itself_proved = None
    if prove:
        itself_proved = bool(one.proved(names[0], np.array([one.value(names[0])]))[0] == outcome)
        for name, gap in gaps.items():
            if gap is not None:
                gaps[name], proofs[name] = _proved(one, name, succeeds, gap)
    found = {name: gap for name, gap in gaps.items() if gap is not None}
    recorded = _simulated(one, {name: gap[1] for name, gap in found.items()})
    changes = []
    for name, gap in gaps.items():
        row = 1 + [*found].index(name) if gap else 0
        changes.append(
            Change(
                name=name,
                value=one.value(name),
                unchanged=gap[0] if gap else math.nan,
                changed=gap[1] if gap else math.nan,
                outcome=scene.outcomes(int(recorded.outcome[row])).name.lower() if gap else "",
                contacts=int(recorded.contacts[row]) if gap else 0,
                searched=one.search_range(name),
                proved=proofs.get(name),
            )
        )
    return Counterfactual(
        outcome=outcome.name.lower(),
        end=scene.outcomes(one.end).name.lower(),
        succeeds=succeeds,
        contacts=int(itself.contacts[0]),
        proved=itself_proved,
        changes=tuple(changes),
        shots=recorded,
    )


def simulated_like(shots: Shots, index: int, one: OneShot) -> Shots:
    """Return a shot of some shots, simulated again; settled, if it was.

    Parameters
    ----------
    shots
        The results that the shot is one of.
    index
        The index of the shot.
    one
        The shot with its scene.
    """
    settle = False
    while True:
        itself = simulate(
            one.state,
            one.parameters,
            scene=one.scene,
            max_contacts=one.max_contacts,
            settle=settle,
        )
        known = hasattr(shots, "uncertain") and not shots.uncertain[index]
        if settle or not itself.uncertain[0] or not known:
            return itself
        settle = True


def _nearest(one: OneShot, name: str, succeeds: bool, steady: float) -> tuple[float, float] | None:
    """Return the nearer of the changes to both sides."""
    value = one.value(name)
    if not math.isfinite(value):
        raise ValueError(f"vary: {name} is {value:g} in this shot; expected a finite number")
    gaps = [one.nearest_change(name, succeeds, side, steady) for side in (1, -1)]
    found = [gap for gap in gaps if gap is not None]
    return min(found, key=lambda gap: abs(gap[1] - value), default=None)


def _require_judge() -> None:
    """Raise an error before any work if what the judge needs is missing."""
    try:
        import hoopgen.judge  # noqa: F401
    except ImportError as error:
        raise MissingExtra(
            "counterfactual proves its answers, which needs the extra certify: "
            f"{command_for('flint')}; or leave the proof out (prove=False, --no-prove)",
            name=error.name,
        ) from None


def _proved(
    one: OneShot, name: str, succeeds: bool, gap: tuple[float, float]
) -> tuple[tuple[float, float], bool]:
    """Return two values, close to a change, on either side of which it is proved; and if there are.

    Where it cannot be proved, they are those of the engine.
    """
    further = (gap[1] - one.value(name)) * np.array(_FURTHER)
    unchanged = _first_proved(one, name, succeeds, gap[0] - further)
    changed = _first_proved(one, name, not succeeds, gap[1] + further)
    if unchanged is None or changed is None:
        return gap, False
    return (unchanged, changed), True


def _first_proved(
    one: OneShot, name: str, succeeds: bool, values: NDArray[np.float64]
) -> float | None:
    """Return the first of some values at which the shot is proved to succeed, or to fail."""
    for value in values:
        outcome = one.proved(name, np.array([value]))[0]
        if outcome >= 0 and (outcome == one.end) == succeeds:
            return float(value)
    return None


def _simulated(one: OneShot, changed: Mapping[str, float]) -> Shots:
    """Return the shot itself and the changed ones, recorded."""
    states, parameters = [one.state], [dict(one.parameters)]
    for name, value in changed.items():
        (state,), own = one.with_values(name, np.array([value]))
        states.append(state)
        parameters.append({key: float(np.ravel(value)[0]) for key, value in own.items()})
    columns = {name: np.array([own[name] for own in parameters]) for name in one.parameters}
    return simulate(
        np.array(states),
        {name: _alike(values) for name, values in columns.items()},
        scene=one.scene,
        max_contacts=one.max_contacts,
        record=True,
    )


def _alike(values: NDArray[np.float64]) -> float | NDArray[np.float64]:
    """Return one number for numbers that are all the same."""
    return float(values[0]) if np.all(values == values[0]) else values
