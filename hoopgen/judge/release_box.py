"""`certify_box`: a proof that all releases in a box end alike, by Taylor models and subdivision.

The state of a whole box of releases is a vector of Taylor models of order one (`taylor_model.py`),
through air of balls, and the judge flies it as it flies a single shot: what it proves holds for
every release in the box. A box that it cannot decide is split in two across its widest side, in
shares of the whole.
"""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np
from flint import arb, ctx
from numpy.typing import NDArray

from hoopgen.core.argument_types import check_arguments
from hoopgen.core.parameters import ParameterValues, resolve
from hoopgen.core.plotting import plotting_module
from hoopgen.core.validation import check_contacts, check_count, check_time_limit
from hoopgen.core.variables import STATE, check_names
from hoopgen.derive.scenes.scene import Scene
from hoopgen.engine.draws import states_in_numpy
from hoopgen.hoop.releases import RING_HEIGHT
from hoopgen.hoop.variables import ARGUMENTS, check_angles
from hoopgen.scene.definition import default_max_contacts, default_time_limit, definition, table_of
from hoopgen.scene.lookup import SceneLike
from hoopgen.text.numbers import format_count, format_percent
from hoopgen.text.shorten import brief

from .flight import fly
from .formulas import formulas
from .proof import UNDECIDED
from .roots import Undecided
from .taylor_model import Number, TaylorModel, as_model, ball

if TYPE_CHECKING:
    from hoopgen.results.drawing import Drawn

BOX_BITS = 64
"""Precision of a box: its width, not the precision, decides what can be proved."""

POINT_BITS = 128
"""Precision of the middle of a box, a single release."""

ROUNDINGS = arb(2) ** -44
"""Share by which each component of a state is widened, and at least so much: `release` in doubles
computes it from a few sums, products, sines and cosines, each off by a few times 2^-53."""

Ending: TypeAlias = tuple[int, tuple[int, ...]]
"""The outcome, and the bodies met in order, the end included."""

_REQUIRED = ("speed", "elevation", "height", "distance")


@dataclass(frozen=True)
class BoxProof:
    """The proof of a box of releases, as far as it goes.

    Attributes
    ----------
    proved
        Whether every release in the box ends alike: the same outcome after the same contacts.
    outcome
        The outcome of the release in the middle, by name; empty if it is not proved.
    sequence
        The bodies that it meets, in order.
    share
        The share of the box, by volume, that is proved to end like the middle.
    counterexample
        A release in the box that is proved to end otherwise, by variable; None if none was found.
    question
        Why a part of the box is not proved; empty if it is.
    variables
        The variables with a width, j of them.
    low, high
        The ends of each part of the box, (m, j), SI: together they are the box.
    outcomes
        The outcome of each part, uint8 (m,), `UNDECIDED` where none is proved for all of it.
    alike
        Whether all of a part is proved to end like the middle, bool (m,).
    names
        The names of the outcomes, by their number.
    """

    proved: bool
    outcome: str
    sequence: tuple[str, ...]
    share: float
    counterexample: Mapping[str, float] | None
    question: str
    variables: tuple[str, ...]
    low: NDArray[np.float64]
    high: NDArray[np.float64]
    outcomes: NDArray[np.uint8]
    alike: NDArray[np.bool_]
    names: tuple[str, ...]

    def __str__(self) -> str:
        parts = format_count(len(self.outcomes), "part")
        if self.proved:
            met = ", ".join(self.sequence) or "no contact"
            return f"Proved: every release in the box is {self.outcome}, {met} ({parts})."
        if not self.outcome:
            return f"Not proved: nor is it proved how the middle of the box ends: {self.question}."
        share = "less than all" if self.share > 0.9999 else format_percent(self.share, 2)
        text = f"Not proved: {share} of the box is proved to end like its middle ({parts})."
        if self.counterexample is not None:
            values = ", ".join(f"{name} {value:.9g}" for name, value in self.counterexample.items())
            return f"{text} Proved to end otherwise: {values}."
        return f"{text} Not decided in a part of it: {self.question}."

    def plot(self, *, ax: Drawn | None = None, title: str = "") -> Drawn:
        """Draw how each part of a box of two variables is proved to end.

        Parameters
        ----------
        ax, title
            As for `hoopgen.plots.plot_box`.

        Returns
        -------
        Figure or Axes
            As of `hoopgen.plots.plot_box`.

        Raises
        ------
        ImportError
            If matplotlib is missing.
        """
        drawn: Drawn = plotting_module().plot_box(self, ax=ax, title=title)
        return drawn


@check_arguments
def certify_box(
    release: Mapping[str, float],
    half_widths: Mapping[str, float],
    parameters: ParameterValues | None = None,
    *,
    scene: SceneLike = None,
    max_contacts: int | None = None,
    time_limit: float | None = None,
    max_parts: int = 2_000,
    survey: bool = False,
) -> BoxProof:
    """Prove that every release in a box ends alike: same outcome, same bodies in the same order.

    The proof holds for all real numbers in the box, and for the doubles that `hoopgen.release`
    makes of them. A box with a release that ends otherwise is never proved.

    Parameters
    ----------
    release
        The middle of the box: arguments of `hoopgen.release`, those without a value there have the
        value 0; or components of the state, those left out are 0. SI, one number each.
    half_widths
        Of some of these variables half the width of the box, from 0 up.
    parameters
        Parameters of the scene, one number each.
    scene, max_contacts, time_limit
        As for `hoopgen.certify`.
    max_parts
        The largest number of parts into which the box is split. The more contacts a shot has, the
        smaller must the parts be.
    survey
        Whether to go on after a release has been found that ends otherwise, and to prove of as much
        of the box as possible how it ends: a map of the box.

    Returns
    -------
    BoxProof
        Whether it is proved, how far if it is not, and the parts of the box.

    Raises
    ------
    TypeError, ValueError
        If an argument is not as described.
    """
    middle = _checked_release(release)
    widths = _checked_widths(half_widths, middle)
    derived = definition(scene)
    table = table_of(scene, derived)
    own = resolve(parameters, None, table)
    values = [float(np.ravel(value)[0]) for value in table.inputs(own)]
    most = default_max_contacts(derived) if max_contacts is None else check_contacts(max_contacts)
    limit = default_time_limit(derived) if time_limit is None else check_time_limit(time_limit)
    pilot = _Pilot(derived, values, most, limit, middle)
    parts = check_count("max_parts", max_parts)
    return _prove(pilot, widths, parts, survey)


def _checked_release(release: Mapping[str, float]) -> dict[str, float]:
    """Return all variables of the middle of a box, of one kind."""
    by_state = set(release) <= set(STATE)
    names = STATE if by_state else tuple(ARGUMENTS)
    check_names("release", tuple(release), names)
    missing = () if by_state else [name for name in _REQUIRED if name not in release]
    if missing:
        raise ValueError(f"release: {', '.join(missing)} missing")
    given = {name: _number(f"release[{name!r}]", value) for name, value in release.items()}
    if not by_state:
        check_angles("release", given)
    return dict.fromkeys(names, 0.0) | given


def _checked_widths(half_widths: Mapping[str, float], middle: Mapping[str, float]) -> Bounds:
    """Return the ends of the box of each variable with a width."""
    check_names("half_widths", tuple(half_widths), tuple(middle))
    widths = {name: _number(f"half_widths[{name!r}]", one) for name, one in half_widths.items()}
    if set(middle) != set(STATE):
        check_angles("half_widths", widths)
    found = {}
    for name, width in widths.items():
        if width < 0.0:
            raise ValueError(f"half_widths[{name!r}]: expected 0 or more, got {width}")
        if name in ("speed", "distance") and middle[name] - width < 0.0:
            raise ValueError(f"half_widths[{name!r}]: the {name} would be negative in the box")
        if width > 0.0:
            found[name] = (
                math.nextafter(middle[name] - width, -math.inf),
                math.nextafter(middle[name] + width, math.inf),
            )
    return found


def _number(name: str, value: object) -> float:
    if isinstance(value, bool) or not isinstance(value, int | float | np.number):
        raise TypeError(f"{name}: expected a number, got {brief(value)}")
    if not math.isfinite(float(value)):
        raise ValueError(f"{name}: expected a finite number, got {value}")
    return float(value)


Bounds: TypeAlias = dict[str, tuple[float, float]]
"""Lower and upper end by variable."""


@dataclass(frozen=True)
class _Pilot:
    """Flies boxes of releases.

    Attributes
    ----------
    scene, parameters, max_contacts, time_limit
        As for `flight.fly`.
    middle
        All variables of the release in the middle.
    """

    scene: Scene
    parameters: Sequence[float]
    max_contacts: int
    time_limit: float
    middle: Mapping[str, float]

    def ending(self, box: Bounds, bits: int) -> tuple[Ending | None, str]:
        """Return the common end of all releases in a box, or None and the reason for no proof."""
        with ctx.workprec(bits):
            own = formulas(self.scene)
            state = self._state(box, models=own.air is None)
            most, limit = self.max_contacts, self.time_limit
            try:
                flown = fly(own, state, self.parameters, most, time_limit=limit)
            except Undecided as undecided:
                return None, str(undecided.args[0])
        if flown.hops >= 0:
            return None, "the ball rolls, which the judge does not follow"
        return (flown.outcome, tuple(event.surface for event in flown.events)), ""

    def _state(self, box: Bounds, models: bool = False) -> list[Number]:
        """Return the state of all releases of a box, and of what doubles make of them.

        In models of the box's variables or in balls.
        """
        numbers: dict[str, Number] = {name: arb(value) for name, value in self.middle.items()}
        for index, (name, (low, high)) in enumerate(box.items()):
            ends = arb(low), arb(high)
            if models and low < high:
                numbers[name] = TaylorModel.variable(*ends, index)
            else:
                numbers[name] = ends[0].union(ends[1])
        if tuple(numbers) == STATE:
            return [numbers[name] for name in STATE]
        arrays = {name: np.array(number, object) for name, number in numbers.items()}
        state = states_in_numpy(arrays, (), RING_HEIGHT, _sine_cosine).tolist()
        sizes = (max(float(c.abs_upper()), 1.0) * (not c.is_zero()) for c in map(ball, state))
        widened = [
            component + arb(0, ROUNDINGS * size)
            for component, size in zip(state, sizes, strict=True)
        ]
        return [as_model(component) for component in widened] if models else widened


def _prove(pilot: _Pilot, box: Bounds, most: int, survey: bool) -> BoxProof:
    """Split a box until every part is proved, or there are too many."""
    middle, question = pilot.ending({}, POINT_BITS)
    names = tuple(pilot.scene.outcomes)
    waiting = deque([box])
    parts: list[tuple[Bounds, Ending | None]] = []
    counterexample = None
    while waiting:
        part = waiting.popleft()
        found, why_not = pilot.ending(part, BOX_BITS)
        point = {name: low + (high - low) / 2 for name, (low, high) in part.items()}
        at_middle = found
        if found is None:
            at_middle, _ = pilot.ending({n: (v, v) for n, v in point.items()}, POINT_BITS)
        if middle is not None and at_middle not in (None, middle) and counterexample is None:
            counterexample = dict(pilot.middle) | point
        stop = (counterexample is not None and not survey) or middle is None
        full = len(parts) + len(waiting) + 2 > most
        if found is None and not stop and not full and (halves := _halves(part, box)):
            waiting.extend(halves)
            continue
        question = question or why_not
        parts.append((part, found))
        if stop:
            parts += [(one, None) for one in waiting]
            break
    alike = np.array([middle is not None and found == middle for _, found in parts])
    shares = np.array([_share(part, box) for part, _ in parts])
    proved = bool(alike.all())
    bodies = [body.name for body in pilot.scene.bodies]
    return BoxProof(
        proved=proved,
        outcome=names[middle[0]] if middle is not None else "",
        sequence=tuple(bodies[k] for k in middle[1] if k < len(bodies)) if middle else (),
        share=1.0 if proved else float(shares[alike].sum()),
        counterexample=counterexample,
        question="" if proved else question,
        variables=tuple(box),
        low=np.array([[low for low, _ in part.values()] for part, _ in parts]),
        high=np.array([[high for _, high in part.values()] for part, _ in parts]),
        outcomes=np.array([UNDECIDED if f is None else f[0] for _, f in parts], np.uint8),
        alike=alike,
        names=names,
    )


def _halves(part: Bounds, box: Bounds) -> list[Bounds]:
    """Return a part of a box, split across the side that is the largest share of the box's.

    A side is not split that is no wider than the distance between doubles at the box's ends: around
    0 there would be a thousand smaller ones.
    """
    wide = [n for n in box if part[n][1] - part[n][0] > max(map(math.ulp, box[n]))]
    if not wide:
        return []
    name = max(wide, key=lambda n: (part[n][1] - part[n][0]) / (box[n][1] - box[n][0]))
    low, high = part[name]
    middle = low + (high - low) / 2
    if not low < middle < high:
        return []
    return [part | {name: (low, middle)}, part | {name: (middle, high)}]


def _share(part: Bounds, box: Bounds) -> float:
    """Return the share of the volume of a box that a part is."""
    sides = ((part[n][1] - part[n][0]) / (box[n][1] - box[n][0]) for n in box)
    return math.prod(sides)


def _sine_cosine(angle: NDArray[Any]) -> tuple[Any, Any]:
    """Return the sine and the cosine of an array of balls."""
    return np.sin(angle), np.cos(angle)
