"""The article's seven shots (Table 3, Figs. 5-7), compared with what its figures show.

Metres are rounded in print, so positions and velocities are in feet here. The note of a case names
misprints.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from hoopgen.core.backend_names import BackendName
from hoopgen.core.units import FOOT
from hoopgen.core.validation import MAX_CONTACTS
from hoopgen.hoop.presets import PAPER
from hoopgen.results.shots import SURFACES, Outcome, Shots
from hoopgen.results.trajectory import Trajectory

from .simulate import simulate

MIN_SWIRL_CONTACTS = 6
"""Smallest number of contacts of a swirl; the article gives no number."""


@dataclass(frozen=True)
class Shown:
    """The content of a figure of the article.

    Attributes
    ----------
    text
        A description for print.
    sequence
        The contacts in order, where the article gives them.
    touches
        The surfaces touched, in any order, where it does not.
    at_least
        Smallest number of contacts.
    ends
        Whether the figure shows the ball at the end plane.
    made
        Whether it goes in; None where the article does not say.
    near_top
        Whether the first contact is near the highest point of the flight to it.
    """

    text: str
    sequence: tuple[str, ...] | None = None
    touches: frozenset[str] = frozenset()
    at_least: int = 0
    ends: bool = True
    made: bool | None = None
    near_top: bool = False


@dataclass(frozen=True)
class Case:
    """One row of Table 3, and what the figure of that name shows.

    Attributes
    ----------
    figure
        The article's figure, ``"5a"``.
    title
        The shot in words.
    feet
        x, y, z in ft and vx, vy, vz in ft/s at release.
    shown
        What the figure shows.
    spin
        wx, wy, wz at release, in rad/s.
    variant
        Name of the variant where a figure has several cases, else empty.
    note
        Misprints and unclear points of the article.
    """

    figure: str
    title: str
    feet: tuple[float, float, float, float, float, float]
    shown: Shown
    spin: tuple[float, float, float] = (0.0, 0.0, 0.0)
    variant: str = ""
    note: str = ""

    @property
    def name(self) -> str:
        """The figure and the variant, ``"6b, wz = 2 rad/s"``."""
        return f"{self.figure}, {self.variant}" if self.variant else self.figure

    @property
    def slug(self) -> str:
        """The name as part of a file's name, ``"6b-wz2"``."""
        return "-".join([self.figure, *self.variant.replace(" = ", "").split()[:1]])

    @property
    def state(self) -> NDArray[np.float64]:
        """The state at release, shape (9,), SI."""
        return np.array([*(value * FOOT for value in self.feet), *self.spin])


@dataclass(frozen=True)
class ArticleResult:
    """One case, simulated.

    Attributes
    ----------
    case
        The case.
    outcome
        A `hoopgen.Outcome`.
    sequence
        Names of the surfaces touched, in order, without the end plane.
    events
        The shot's event log.
    uncertain
        Whether some decision of this shot lies within its rounding-error bound.
    trajectory
        The path.
    parameters
        Parameters of the scene.
    """

    case: Case
    outcome: Outcome
    sequence: tuple[str, ...]
    events: NDArray[np.void]
    uncertain: bool
    trajectory: Trajectory
    parameters: Mapping[str, float]

    @property
    def agrees(self) -> bool:
        """True if the simulation agrees with the article's figure."""
        return not self.differences

    @property
    def differences(self) -> tuple[str, ...]:
        """Differences between the simulation and the figure, as text."""
        shown = self.case.shown
        made = self.outcome == Outcome.MADE
        ended = made or self.outcome == Outcome.MISSED
        touched = frozenset(self.sequence)
        checks = [
            (shown.sequence is None or self.sequence == shown.sequence, "another sequence"),
            (not shown.touches or touched == shown.touches, "other surfaces"),
            (len(self.sequence) >= shown.at_least, f"fewer than {shown.at_least} contacts"),
            (ended or not shown.ends, "never at the end plane"),
            (shown.made is None or made == shown.made, "another outcome"),
            (not shown.near_top or self._first_contact_near_top(), "contact not near the top"),
        ]
        return tuple(what for holds, what in checks if not holds)

    def _first_contact_near_top(self) -> bool:
        """Return whether the ball meets its first surface within a radius of its highest point."""
        before = self.events["before"][0]
        rise = before[5] ** 2 / (2.0 * self.parameters["gravity"])
        return bool(rise < self.parameters["ball_radius"])


_SPIN_6B = (
    'the spin is unclear, "2" with no legible unit; so wz = 0 and wz = 2 rad/s are both here. '
    "Whether the ball goes in is not said, nor how many contacts are many "
    f"(here: {MIN_SWIRL_CONTACTS})."
)
_SWIRL = Shown(
    "swirls: many rapid contacts with the ring",
    touches=frozenset({"ring"}),
    at_least=MIN_SWIRL_CONTACTS,
    ends=False,
)
_LAYUP_6B = (0.75, -3.1, -2.0, -2.75, 7.0, 12.65)


def _floater(vx: float) -> tuple[float, float, float, float, float, float]:
    return (8.0, 0.0, -2.0, vx, 0.0, 16.0)


CASES: tuple[Case, ...] = (
    Case("5a", "Floater", _floater(-9.5), Shown("end (made)", sequence=(), made=True)),
    Case(
        "5b",
        "Floater off the ring",
        _floater(-10.13),
        Shown("ring, ring again, then end", sequence=("ring", "ring")),
        note="the sign of vx is lost in the column in m/s.",
    ),
    Case(
        "5c",
        "Floater off the backboard",
        _floater(-11.5),
        Shown("backboard, then end (made)", sequence=("backboard",), made=True),
        note="vx = -11.5 ft/s stands in the column in m/s.",
    ),
    Case(
        "5d",
        "Floater off ring, bridge and backboard",
        _floater(-8.879),
        Shown(
            "touches ring, bridge and backboard, then end",
            touches=frozenset({"ring", "bridge", "backboard"}),
        ),
    ),
    Case(
        "6a",
        "Proper layup",
        (0.75, -3.0, -2.0, -3.75, 4.75, 14.0),
        Shown(
            "backboard once, near the top of its flight, then end (made)",
            sequence=("backboard",),
            made=True,
            near_top=True,
        ),
    ),
    Case("6b", "Improper layup", _LAYUP_6B, _SWIRL, variant="wz = 0 rad/s", note=_SPIN_6B),
    Case(
        "6b",
        "Improper layup",
        _LAYUP_6B,
        _SWIRL,
        spin=(0.0, 0.0, 2.0),
        variant="wz = 2 rad/s",
        note=_SPIN_6B,
    ),
    Case(
        "7",
        "Missed free throw",
        (13.75, 0.0, -2.0, -14.763, 0.0, 18.297),
        Shown("ring, backboard, then end (missed)", sequence=("ring", "backboard"), made=False),
        spin=(0.0, 6.0 * math.pi, 0.0),
    ),
)
"""Table 3, in the article's order; Fig. 6b twice, for each reading of its spin."""


def release_states(cases: Iterable[Case] = CASES) -> NDArray[np.float64]:
    """Return the states at release, shape (n, 9), SI."""
    return np.array([case.state for case in cases])


def run(
    cases: Iterable[Case] = CASES,
    *,
    parameters: Mapping[str, float] | None = None,
    backend: BackendName = "auto",
) -> tuple[ArticleResult, ...]:
    """Simulate the article's shots, 40 contacts at most, as the article does.

    Parameters
    ----------
    cases
        Cases to simulate.
    parameters
        Parameters of the scene; `hoopgen.PAPER` by default.
    backend
        See `hoopgen.simulate`.

    Returns
    -------
    tuple of ArticleResult
        One for each case, in order.
    """
    chosen = tuple(cases)
    scene = PAPER if parameters is None else parameters
    shots = simulate(
        release_states(chosen),
        parameters=scene,
        max_contacts=MAX_CONTACTS,
        backend=backend,
        record=True,
    )
    return tuple(_result(case, shots, row, scene) for row, case in enumerate(chosen))


def _result(case: Case, shots: Shots, row: int, scene: Mapping[str, float]) -> ArticleResult:
    trajectory = shots.trajectory(row)
    events = trajectory.events
    contacts = events["surface"][events["surface"] < len(SURFACES)]
    return ArticleResult(
        case=case,
        outcome=Outcome(int(shots.outcome[row])),
        sequence=tuple(SURFACES[int(surface)] for surface in contacts),
        events=events,
        uncertain=bool(shots.uncertain[row]),
        trajectory=trajectory,
        parameters=scene,
    )
