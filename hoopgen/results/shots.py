"""Results of a batch."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Unpack

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hoopgen.core.jacobian import Jacobian
from hoopgen.core.parameters import Value
from hoopgen.core.plotting import plotting_module
from hoopgen.core.validation import check_index
from hoopgen.engine.compiled_scene import CompiledScene
from hoopgen.generated.numpy.hoop import BODIES
from hoopgen.generated.numpy.hoop import Outcome as Outcome
from hoopgen.text.numbers import format_count

from . import frames
from .drawing import FanOptions
from .exports import Exports
from .proof import ProofPremises
from .trajectory import Trajectory
from .variations import Variations

if TYPE_CHECKING:
    from .drawing import Drawn

FieldArray = (
    NDArray[np.float64]
    | NDArray[np.bool_]
    | NDArray[np.uint8 | np.int8 | np.int16 | np.int32]
    | NDArray[np.void]
)
"""A field of `Shots`, by shot; the event log is the one with a structure."""

SURFACES: tuple[str, ...] = tuple(BODIES)
"""Bodies of the hoop as in ``Shots.counts``; the event log numbers the end plane after them."""


class Shots(Exports):
    """Results of a batch: arrays by shot. A field that was not requested raises AttributeError.

    Attributes
    ----------
    outcome
        uint8 (n,), an `Outcome`.
    made
        bool (n,), whether `outcome` is MADE.
    contacts
        int32 (n,), contacts before the end.
    counts
        int32 (n, k), contacts by surface, in the order of `surfaces`.
    first
        int8 (n,), first surface touched, -1 for none; int16 among more than 128 bodies.
    time
        float64 (n,), s: time at the end plane; of a capped or short shot, at the last contact, in
        air of a short one at the piece in which that is known. A ball that left a body without
        speed, as after restitution 0, flies up to 2^-7 s later: then that time.
    state
        float64 (n, 9), state at that time.
    rolls
        int32 (n,), where a ball may roll: the number of times that it began to roll.
    airless_rolls
        bool (n,), there, in air: whether it rolled, with no air along the surface.
    slip_left
        bool (n,), there: whether the bounces ended with slip that friction could not stop, or where
        it does not suffice for rolling. Such a shot is CAPPED, at its last contact.
    uncertain
        bool (n,), some decision of the shot lies within its rounding-error bound.
    estimated
        bool (n,), in scenes like `COURT`: that bound is estimated, not proved.
    time_error, state_error
        float64 (n,) and (n, 3), if requested by name: bounds on the errors of `time` and of each
        component of position, velocity and spin, of shots that are certain.
    grip_lost
        float64 (n,), s, if requested by name, where a ball may roll: when rolling first needed more
        friction than the body has; infinite if never. The ball rolls on.
    events
        With ``record=True``: the event log, by shot and time, with the ``kind`` of each row, an
        `Event`, and `time_error` and `state_error` if they are requested by name. Between a ROLL
        row and the next one of its shot the ball stays in contact.
    parameters
        Parameters of the scene, one number each or (n,).
    scene
        The scene of the simulation.
    """

    outcome: NDArray[np.uint8]
    made: NDArray[np.bool_]
    contacts: NDArray[np.int32]
    counts: NDArray[np.int32]
    first: NDArray[np.int8]
    time: NDArray[np.float64]
    state: NDArray[np.float64]
    rolls: NDArray[np.int32]
    airless_rolls: NDArray[np.bool_]
    slip_left: NDArray[np.bool_]
    uncertain: NDArray[np.bool_]
    estimated: NDArray[np.bool_]
    time_error: NDArray[np.float64]
    state_error: NDArray[np.float64]
    grip_lost: NDArray[np.float64]
    events: NDArray[np.void]
    _variations: Variations

    def __init__(
        self,
        fields: dict[str, FieldArray],
        states: NDArray[np.float64],
        parameters: Mapping[str, Value],
        scene: CompiledScene,
        premises: ProofPremises,
        variations: Variations | None = None,
    ) -> None:
        self._fields, self._premises = fields, premises
        if variations is not None:
            self._variations = variations
        self._states, self.parameters, self.scene = states, parameters, scene

    @property
    def releases(self) -> NDArray[np.float64]:
        """The states in which the balls are released, float64 (n, 9)."""
        return self._states

    @property
    def surfaces(self) -> tuple[str, ...]:
        """Names of the bodies, in the order of the columns of `counts`."""
        return self.scene.surfaces

    @property
    def proved(self) -> NDArray[np.bool_]:
        """The shots of which `uncertain`, `time_error` and `state_error` are proved, bool (n,).

        They are for balls released in flight among level rings, planes and boxes, of usual sizes,
        that rise to the end's plane freely and are not `estimated`; and if settled.
        """
        own = self.to_numpy()
        return self._premises.proved(self.scene, own._field, own.releases, own.parameters)

    @property
    def jacobian(self) -> Jacobian:
        """With ``derivatives=``: the derivatives of "state", (n, 9, k), and "time", (n, 1, k).

        NaN where a shot is not `differentiable`.

        Raises
        ------
        AttributeError
            If the shots were simulated without ``derivatives=``.
        """
        return self._variations.jacobian

    @property
    def differentiable(self) -> NDArray[np.bool_]:
        """With ``derivatives=``: whether the shot has derivatives, bool (n,).

        A shot has none if a decision of it is uncertain, such as a tie or a graze, if it does not
        reach an end, or if the ball stays in contact with a body, where it rolls.
        """
        return self._variations.differentiable

    @property
    def event_jacobian(self) -> Jacobian:
        """With ``derivatives=`` and ``record=True``: the derivatives at each event of the log.

        "time" (m, 1, k), "before" and "after" (m, 9, k) for the m rows of `events`: how the event
        itself changes, whose time varies too. They are computed at each access. They are NaN in a
        shot with an uncertain decision, and from the first event at which a ball stays in contact.
        A shot that does not reach an end has them, too.

        Raises
        ------
        AttributeError
            If the shots were simulated without ``derivatives=`` or without ``record=True``.
        """
        return self._variations.at_events(self.events)

    @property
    def decisions(self) -> tuple[str, ...]:
        """With ``derivatives=``: names of the columns of `change_distance`."""
        return self._variations.decisions

    def change_distance(
        self, covariance: ArrayLike | None = None, *, release: Jacobian | None = None
    ) -> NDArray[np.float64]:
        """Return the first-order distance of each shot from a change of each of its decisions.

        The shots are simulated with ``derivatives=`` and with ``record=True``. The distance is in
        the space of the variables of the derivatives, or of those of `release`.

        Parameters
        ----------
        covariance
            Of these variables, (j, j), or (n, j, j) one a shot: the distance is then in standard
            deviations. None: the variables count as they are, in SI units.
        release
            As ``hoopgen.release(..., jacobian=True)`` returns it: the variables are then speed,
            elevation, ..., and the parameters among the derivatives, as in `Jacobian.chain`.

        Returns
        -------
        ndarray
            (n, `decisions`): of a decision that a shot takes several times the smallest distance;
            infinite where it takes none, or where the decision does not depend on the variables;
            NaN where a shot is not `differentiable`. The columns are

            - ``ring_touch``, of each body: a contact with it just touches, or meets its edge. A
              contact so deep that the flight, continued, would pass through the core of the body
              has no such distance.
            - ``ring_miss``: the ball just touches the body where it did not, or before what it
              touched first.
            - ``ring_slip``: a contact with it is between grip and slip; where there is friction.
            - ``end_edge``: the end is on an edge, such as the rim between made and missed.
            - ``end_miss``: the shot ends before what it touched.

        Raises
        ------
        AttributeError
            If the shots were simulated without ``derivatives=`` or without ``record=True``.
        ValueError
            If the covariance is not as described, or is no covariance.
        """
        return self._variations.change_distance(self.events, covariance, release)

    def _field(self, name: str) -> FieldArray:
        """Return a field by its name; one that was not requested raises AttributeError."""
        fields = self.__dict__.get("_fields", {})
        scene = self.__dict__.get("scene")
        if name in fields:
            found: FieldArray = fields[name]
            return found
        if name == "made" and fields and "MADE" in self.scene.outcomes.__members__:
            made: NDArray[np.bool_] = self.outcome == self.scene.outcomes["MADE"]
            return made
        if name == "made" and scene is not None and "MADE" not in scene.outcomes.__members__:
            ends = ", ".join(scene.outcomes.__members__)
            raise AttributeError(f"made: the scene {scene.name} has no hoop; `outcome` has {ends}")
        if name in ("jacobian", "event_jacobian", "differentiable", "decisions", "_variations"):
            name = "change_distance" if name == "_variations" else name
            more = " and record=True" if name == "event_jacobian" else ""
            raise AttributeError(f'{name}: simulate with derivatives=("vx", ...){more} to have it')
        if name == "events":
            raise AttributeError("events: simulate with record=True to keep the event log")
        if scene is not None and name in scene.layout.absent:
            why = scene.layout.absent[name].absence
            raise AttributeError(f"{name}: in the scene {scene.name} {why}")
        if name == "proved":
            name = "contacts" if "contacts" not in fields else "estimated"
        if name in Shots.__annotations__ or (scene is not None and name in scene.layout.results):
            raise AttributeError(f"{name}: not among the fields asked for: {', '.join(fields)}")
        raise AttributeError(f"Shots has no attribute {name!r}")

    if not TYPE_CHECKING:  # else every misspelt name would be one of the fields
        __getattr__ = _field

    def __dir__(self) -> list[str]:
        optional = ("made", "jacobian", "differentiable", "decisions")
        lacking = {name for name in optional if not hasattr(self, name)}
        if "jacobian" in lacking or "events" not in self._fields:
            lacking.add("event_jacobian")
        return sorted({*super().__dir__(), *self._fields, *optional} - lacking)

    def __len__(self) -> int:
        return len(self._states)

    def __repr__(self) -> str:
        shots = format_count(len(self), "shot")
        if not isinstance(self._states, np.ndarray):
            named = ", ".join(self._fields)
            return f"Shots({shots} in the memory of a GPU: {named}; {frames.scene_of(self)})"
        what = frames.outcome_counts(self) if "outcome" in self._fields else ", ".join(self._fields)
        return f"Shots({shots}{': ' if what else ''}{what}; {frames.scene_of(self)})"

    def to_numpy(self) -> Shots:
        """Return the results as NumPy arrays: those in the memory of a GPU are copied from there.

        Methods that read them take this copy first.
        """
        if isinstance(self._states, np.ndarray):
            return self
        fields = {name: array.get() for name, array in self._fields.items()}
        return Shots(fields, self._states.get(), self.parameters, self.scene, self._premises)

    def plot(self, *, ax: Drawn | None = None, **options: Unpack[FanOptions]) -> Drawn:
        """Draw the paths; options, and what is returned and raised, as for `plots.plot_fan`."""
        drawn: Drawn = plotting_module().plot_fan(
            self.to_numpy(), self.parameters, ax=ax, **options
        )
        return drawn

    def trajectory(self, shot: int) -> Trajectory:
        """Return the path of one shot; needs ``record=True``.

        Raises
        ------
        TypeError, IndexError
            If it is no whole number, or there is no such shot.
        """
        index = check_index("shot", shot, len(self))
        low, high = np.searchsorted(self.events["shot"], [index, index + 1])
        own = {
            name: float(value if np.ndim(value) == 0 else np.asarray(value)[index])
            for name, value in self.parameters.items()
        }
        known = "outcome" in self._fields
        ended = self.scene.outcomes(int(self.outcome[index])) if known else None
        return Trajectory(self._states[index], self.events[low:high], own, self.scene, ended)
