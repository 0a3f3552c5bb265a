"""Derivatives of shots by their releases and parameters, along their recorded events.

The kernels are those of `hoopgen.derive.kernels.variation`: the exact derivatives of a flight, of
the time and the place of a contact, of the normal there, and of the contact law. Both engines
record the same events with the same bits, so the derivatives have the same bits, too.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from hoopgen.core.event_log import Event
from hoopgen.core.jacobian import Jacobian
from hoopgen.core.parameters import Value
from hoopgen.core.variables import STATE, check_names
from hoopgen.engine.compiled_scene import CompiledScene
from hoopgen.engine.flight_pieces import vary_in_pieces

Floats = NDArray[np.float64]

NEEDED = ("outcome", "uncertain")
"""Results that tell whether a shot has derivatives."""

SHOTS_AT_ONCE = 1 << 14
"""Shots whose derivatives are computed together, which bounds the memory that this takes."""

VARIATION = tuple(f"d{name}" for name in STATE)
_CHANGE = "change_"
_NORMAL = ("nx", "ny", "nz")
_RATES = "air_rates"


def check_derivatives(
    names: Iterable[str], scene: CompiledScene, argument: str = "derivatives"
) -> tuple[str, ...]:
    """Return the variables of derivatives as a tuple.

    Parameters
    ----------
    names
        Components of the state, or parameters of the scene.
    scene
        The scene.
    argument
        Which names them, for messages.

    Raises
    ------
    TypeError
        If they are one text.
    ValueError
        If a name is unknown, or there twice, or there is none.
    """
    found = check_names(argument, names, (*STATE, *scene.parameters))
    twice = sorted({name for name in found if found.count(name) > 1})
    if twice or not found:
        what = f"{', '.join(twice)} twice" if twice else "no name"
        raise ValueError(f"{argument}: {what}; expected each name once")
    return found


def derivatives(
    scene: CompiledScene,
    names: Sequence[str],
    parameters: Mapping[str, Value],
    releases: Floats,
    results: Mapping[str, NDArray[Any]],
    events: NDArray[np.void],
) -> tuple[Jacobian, NDArray[np.bool_]]:
    """Return the derivatives of the time and the state at the end of each shot.

    Parameters
    ----------
    scene
        The scene.
    names
        Variables of the derivatives, k of them (`check_derivatives`).
    parameters
        Parameters of the scene in calling order, one number each or (n,).
    releases
        States at the release, (n, 9).
    results
        Results of the shots, those of `NEEDED` among them.
    events
        Their event log.

    Returns
    -------
    tuple
        The Jacobian, "state" (n, 9, k) and "time" (n, 1, k), NaN where there are no derivatives;
        and whether there are, bool (n,). A shot has none if some decision of it is uncertain, if
        it does not reach an end, or if the ball stays in contact with a body for a while.
    """
    shots, ends = len(results["outcome"]), len(scene.kernels.ENDS)
    rolling = np.zeros(shots, np.bool_)
    stays = np.isin(events["kind"], (Event.ROLL, Event.LEAVE))
    rolling[events["shot"][stays]] = True
    differentiable = (results["outcome"] < ends) & ~results["uncertain"] & ~rolling
    state = np.full((shots, len(STATE), len(names)), np.nan)
    time = np.full((shots, 1, len(names)), np.nan)
    first = np.searchsorted(events["shot"], np.arange(shots))
    with np.errstate(all="ignore"):  # what a kernel does not choose may be divided by 0
        for start in range(0, shots, SHOTS_AT_ONCE):
            rows = start + np.flatnonzero(differentiable[start : start + SHOTS_AT_ONCE])
            own = {n: v if isinstance(v, float) else v[rows] for n, v in parameters.items()}
            path = VariedPath(scene, names, own, releases[rows])
            state[rows], time[rows] = path.follow(events, first[rows])
    # An exact graze, or a contact law at its limit, has no derivative.
    finite = np.isfinite(state).all(axis=(1, 2)) & np.isfinite(time).all(axis=(1, 2))
    differentiable &= finite
    state[~differentiable] = np.nan
    time[~differentiable] = np.nan
    return Jacobian({"state": state, "time": time}, names), differentiable


class Observer(Protocol):
    """An observer of the flights and events along which variations are carried."""

    def flight(
        self, rows: NDArray[np.intp], events: NDArray[np.void], duration: Floats, start: Floats
    ) -> None:
        """Note flights: their shots, their last events, their durations, and the variations.

        Parameters
        ----------
        rows
            The shots, (j,), by their number among those of the path.
        events
            The event at the end of each flight, (j,).
        duration
            s, (j,).
        start
            Variations at the start of the flight, at a fixed time, (9, k, j).
        """

    def event(
        self,
        face: str,
        rows: NDArray[np.intp],
        events: NDArray[np.void],
        found: dict[str, Any],
        arrival: Floats,
    ) -> None:
        """Note events at one face: what its kernels, and those of the contact law, return.

        Parameters
        ----------
        face
            The face.
        rows, events
            As of `flight`.
        found
            By name what the kernels were given and what they return: variations after the event.
        arrival
            Variations before it, at the event itself, (9, k, j).
        """


class VariedPath:
    """The variations of some shots along their events.

    Parameters
    ----------
    scene
        The scene.
    names
        Variables of the derivatives, k of them.
    parameters
        Parameters, one number each or (m,).
    releases
        The states at the release, (m, 9).

    Attributes
    ----------
    start
        The states at the start of the present flight of each shot, (m, 9).
    """

    def __init__(
        self,
        scene: CompiledScene,
        names: Sequence[str],
        parameters: Mapping[str, Value],
        releases: Floats,
    ) -> None:
        self.start = releases.copy()
        shots = len(releases)
        self._kernels = scene.kernels
        variables = tuple(self._kernels.VARIABLES.values())
        inputs = scene.table.inputs(parameters)
        self._inputs: dict[str, Any] = dict(zip(variables, inputs, strict=True))
        still = dict.fromkeys(
            (*VARIATION, *(f"{_CHANGE}{name}" for name in self._kernels.VARIABLES)), 0.0
        )
        self._parameters = self._inputs | still
        self._variation = np.zeros((len(STATE), len(names), shots))
        changes = np.zeros((len(variables), len(names), shots))
        for column, name in enumerate(names):
            if name in STATE:
                self._variation[STATE.index(name), column] = 1.0
            else:
                for row, change in enumerate(scene.table.changes(parameters, name)):
                    changes[row, column] = change
        for name, change in zip(self._kernels.VARIABLES, changes, strict=True):
            self._inputs[f"{_CHANGE}{name}"] = change

    def follow(
        self,
        events: NDArray[np.void],
        first: NDArray[np.intp],
        observer: Observer | None = None,
        last: NDArray[np.intp] | None = None,
    ) -> tuple[Floats, Floats]:
        """Return the derivatives of state and time at the end, (m, 9, k) and (m, 1, k).

        Parameters
        ----------
        events
            The event log of all shots.
        first
            The row of the first event of each of these, (m,).
        observer
            An object that is given each flight and each event.
        last
            The row of the last event of each that is followed, (m,); by default the end.
        """
        self._observer = observer
        shots = len(first)
        columns = self._variation.shape[1]
        time, end = np.zeros(shots), np.zeros((columns, shots))
        going = np.arange(shots)
        row = first.copy()
        while len(going):
            now = events[row[going]]
            duration = now["time"] - time[going]
            if observer is not None:
                observer.flight(going, now, duration, self._variation[:, :, going])
            self._store(going, self.fly(going, duration, self.given(going)))
            ended = now["kind"] == Event.END if last is None else row[going] >= last[going]
            for face, which in self._touched(now, going):
                end[:, going[which]] = self._meet(face, going[which], now[which])
            time[going] = now["time"]
            going, row = going[~ended], row + 1
        return np.moveaxis(self._variation, (0, 1), (1, 2)), end.T[:, np.newaxis]

    def given(self, rows: NDArray[np.intp], varied: bool = True) -> dict[str, Any]:
        """Return the arguments of all kernels for some shots.

        Parameters
        ----------
        rows
            The shots.
        varied
            Whether the variations are among the arguments.
        """
        own = self._inputs if varied else self._parameters
        given = {name: v[..., rows] if np.ndim(v) else v for name, v in own.items()}
        if not varied:
            return given
        return given | dict(zip(VARIATION, self._variation[:, :, rows], strict=True))

    def call(self, kernel: str, given: dict[str, Any], asked: Sequence[str] = ()) -> dict[str, Any]:
        """Evaluate a kernel; return its outputs by name.

        Parameters
        ----------
        kernel
            The name of the kernel.
        given
            Arguments by name, others too.
        asked
            The names of its arguments; by default its own.
        """
        names = asked or self._kernels.ARGUMENTS[kernel]
        found = getattr(self._kernels, kernel)(*(given[name] for name in names))
        return dict(zip(self._kernels.OUTPUTS[kernel], found, strict=True))

    def _store(self, rows: NDArray[np.intp], found: Mapping[str, Any]) -> None:
        """Store the variations of some shots."""
        for index, name in enumerate(VARIATION):
            if name in found:
                self._variation[index][:, rows] = found[name]

    def fly(
        self, rows: NDArray[np.intp], duration: Floats, given: Mapping[str, Any]
    ) -> dict[str, Any]:
        """Return the variations of position and velocity in flights from the shots' `start`.

        Parameters
        ----------
        rows
            The shots, (j,).
        duration
            s, (j,).
        given
            Their arguments as of `given`, with the variations at the start.
        """
        if self._kernels.PIECES:
            return dict(vary_in_pieces(self._kernels, duration, self.start[rows], given))
        return self.call("vary_flight", {**given, "t": duration})

    def forces(self, given: dict[str, Any]) -> dict[str, Any]:
        """Return the rates of the forces on balls in flight; none on a parabola.

        Parameters
        ----------
        given
            Arguments of the kernels, states among them.
        """
        return self.call(_RATES, given) if self._kernels.PIECES else {}

    def _touched(
        self, events: NDArray[np.void], rows: NDArray[np.intp]
    ) -> Iterator[tuple[str, NDArray[np.intp]]]:
        """Yield each surface that is met, and the indices of the events at which it is."""
        kernels = self._kernels
        for body, faces in enumerate((*kernels.FACES, kernels.END_PLANES)):
            which = np.flatnonzero(events["surface"] == body)
            if not len(which):
                continue
            nearest = np.zeros(len(which), np.intp)
            if len(faces) > 1:
                given = self._arriving(rows[which], events[which])
                given |= dict.fromkeys(_NORMAL, 0.0)
                gaps = [self.call(f"{face}_vary", given)["gap"] for face in faces]
                sizes = [np.abs(np.broadcast_to(gap, len(which))) for gap in gaps]
                nearest = np.argmin(sizes, axis=0)
            for index, face in enumerate(faces):
                if (nearest == index).any():
                    yield face, which[nearest == index]

    def _arriving(self, rows: NDArray[np.intp], events: NDArray[np.void]) -> dict[str, Any]:
        """Return the arguments of kernels at events, with the states before them."""
        given = self.given(rows) | dict(zip(STATE, events["before"].T, strict=True))
        return given | self.forces(given)

    def _meet(self, face: str, rows: NDArray[np.intp], events: NDArray[np.void]) -> Floats:
        """Carry variations through an event; return the variation of its time, (k, m)."""
        given = self._arriving(rows, events)
        given |= self.call(f"{face}_normal", given)
        found = self.call(f"{face}_vary", given)
        shape = (self._variation.shape[1], len(rows))
        delay = np.broadcast_to(found["contact_delay"], shape)
        self._store(rows, found)
        arrival = self._variation[:, :, rows]
        if face in self._kernels.END_PLANES:
            if self._observer is not None:
                self._observer.event(face, rows, events, given | found, arrival)
            return delay
        given |= found
        bodies = zip(self._kernels.BODIES, self._kernels.FACES, strict=True)
        body = next(name for name, faces in bodies if face in faces)
        law, asked = self._kernels.VARIED_LAWS[body]
        given |= self.call(law, given, asked)
        if self._observer is not None:
            self._observer.event(face, rows, events, given, arrival)
        given |= dict(zip(STATE, events["after"].T, strict=True))
        given |= self.forces(given)
        self._store(rows, given)
        self._store(rows, self.call("vary_departure", given))
        self.start[rows] = events["after"]
        return delay
