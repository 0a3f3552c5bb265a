"""Deliberate faults: each must trip the wire, a short suite against proofs in ball arithmetic.

A fault replaces a piece of derive/ or of the NumPy event loop by its text; the kernels that it
touches are derived and printed again. What it would replace must be there: a fault that no longer
applies fails.
"""

from __future__ import annotations

import inspect
import sys
import textwrap
from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest
from compiled import load_module
from hoopgen.derive import model
from hoopgen.derive.contact import frame
from hoopgen.derive.errors import tangent as sensitivity
from hoopgen.derive.ground.kernel import Kernel
from hoopgen.derive.scenes.hoop import HOOP
from hoopgen.derive.scenes.scene import Scene
from hoopgen.derive.search import ring
from hoopgen.derive.surfaces import Surface
from hoopgen.generated.numpy import hoop
from numpy.typing import NDArray
from test_codegen import printed
from test_diabolical import CASES, spelled

from benchmarks.workloads import TABLE_3, WORKLOADS
from hoopgen import PAPER, Outcome
from hoopgen.engine import numpy_backend
from hoopgen.engine.raw import Raw, allocate, allocate_events
from hoopgen.judge import Certificate, certify

# One worker: proofs are made once.
pytestmark = pytest.mark.xdist_group("mutations")

SURFACE = {surface.name: surface for surface in HOOP.surfaces}
SWIRLING = 30
"""Contacts of the swirl that are certain; without deflation they are not."""

FIELDS = ("outcome", "contacts", "time", "state", "uncertain", "time_error", "state_error")
SEQUENCES = {"5a": "E", "5b": "RRE", "5c": "BE", "5d": "RBPE", "6a": "BE", "6b": "R" * 9 + "E"}
SEQUENCES["7"] = "RBE"


# ---------------------------------------------------------------------------------- the trip wire


class Tripped(Exception):
    """The suite has seen a fault; the message says where."""


def demand(held: bool, where: str) -> None:
    if not held:
        raise Tripped(where)


@dataclass(frozen=True)
class Answer:
    """Results and, by shot, the events' surfaces."""

    raw: Raw
    events: list[str]


def fly(
    kernels: ModuleType,
    loop: ModuleType,
    states: NDArray[np.float64],
    parameters: list[Any],
    most: int,
) -> Answer:
    out = allocate(len(states), 3, FIELDS)
    room = allocate_events(len(states), most)
    out = replace(out, events=room.events, event_counts=room.event_counts)
    loop.run(kernels, states, parameters, None, most, out)
    logs = zip(room.events["surface"], room.event_counts, strict=True)
    return Answer(out, [spelled(surfaces[:count]) for surfaces, count in logs])


@cache
def usual() -> tuple[NDArray[np.float64], Certificate]:
    """Ordinary shots, and what they do."""
    random = np.random.default_rng(11)
    around = np.zeros((150, 9))
    around[:, :3] = random.uniform((-0.35, -0.45, -0.2), (0.55, 0.45, 0.8), (150, 3))
    around[:, 3:6] = random.normal(0, 2, (150, 3))
    around[:, 6:] = random.normal(0, 15, (150, 3))
    states = np.concatenate([around, *(w.make(40) for w in WORKLOADS)])
    return states, certify(states, max_contacts=12, processes=1)


def trip(kernels: ModuleType, loop: ModuleType) -> None:
    """Raise `Tripped` at the first claim that does not hold."""
    given = list(PAPER.values())
    answer = fly(kernels, loop, np.array(list(TABLE_3.values())), given, 40)
    demand(answer.events == [SEQUENCES[case] for case in TABLE_3], "Table 3")

    # The article's swirl with its spin: hops down to a microsecond.
    swirl = np.array([[*TABLE_3["6b"][:8], 2.0]])
    answer = fly(kernels, loop, swirl, given, SWIRLING)
    demand(answer.events == ["R" * SWIRLING] and not answer.raw.uncertain[0], "the swirl")

    states, proofs = usual()
    answer = fly(kernels, loop, states, given, 12)
    raw = answer.raw
    demand(np.mean(raw.uncertain) < 0.1, "too much is uncertain")
    for row in np.flatnonzero(~raw.uncertain):
        proof = proofs[row]
        demand(answer.events[row] == spelled(proof.surfaces), f"events of shot {row}")
        demand(raw.outcome[row] == proof.outcome, f"outcome of shot {row}")
        if proof.outcome == Outcome.INVALID:
            continue
        late = abs(raw.time[row] - proof.time)
        demand(late <= raw.time_error[row] + proof.time_radius, f"time of shot {row}")
        away = np.abs(raw.state[row] - proof.state)
        bound = np.repeat(raw.state_error[row], 3) + proof.state_radii
        demand(bool(np.all(away <= bound)), f"state of shot {row}")

    cases = [case for case in CASES if not case.known_errors]
    for most in sorted({case.max_contacts for case in cases}):
        some = [case for case in cases if case.max_contacts == most]
        columns = [np.array([case.parameters[name] for case in some]) for name in PAPER]
        answer = fly(kernels, loop, np.array([case.state for case in some]), columns, most)
        for row, case in enumerate(some):
            if answer.raw.uncertain[row]:
                demand(not case.decided, f"{case.name} is uncertain")
            else:
                found = Outcome(answer.raw.outcome[row]).name, answer.events[row]
                demand(found == case.proved, case.name)
    frames(kernels)


def frames(kernels: ModuleType) -> None:
    """Check Eqs. 7-10 on normals of all directions, the axes too, and that the frame cancels."""
    random = np.random.default_rng(2)
    normal = random.normal(size=(3, 60))
    normal[:, :6] = np.hstack([np.eye(3), -np.eye(3)])
    normal /= np.linalg.norm(normal, axis=0)
    with np.errstate(all="ignore"):  # every frame is evaluated, also those that are not chosen
        rows = np.broadcast_arrays(*kernels.contact_frame(*normal), normal[0])[:9]
    made = np.array(rows).reshape(3, 3, -1)
    product = np.einsum("kin,kjn->ijn", made, made) - np.eye(3)[:, :, None]
    # A dozen roundings.
    demand(bool(np.all(np.abs(product) < 1e-14)), "the frame is not orthonormal")
    right = np.cross(made[:, 0], made[:, 1], axis=0) - made[:, 2]
    demand(bool(np.all(np.abs(right) < 1e-14)), "the frame is not right-handed")
    motion, flat = random.normal(size=(6, 60)), made.reshape(9, -1)
    through = kernels.impact_through_frame(*motion, *flat, 0.12, 0.7)
    plain = kernels.impact(*motion, *normal, 0.12, 0.7)
    # Spins are divided by the ball's radius.
    demand(bool(np.all(np.abs(np.array(through) - plain) < 1e-12)), "the frame does not cancel")


# --------------------------------------------------------------------------------------- mutation


def changed(function: Any, old: str, new: str) -> Any:
    """Return the function with `old` replaced in its text."""
    inner = function.fget if isinstance(function, property) else function
    source = textwrap.dedent(inspect.getsource(inner))
    assert old in source, f"{inner.__name__} has no {old!r}"
    namespace = dict(inner.__globals__)
    exec("from __future__ import annotations\n" + source.replace(old, new), namespace)
    return namespace[inner.__name__]


def patched(owner: Any, name: str, old: str, new: str) -> Callable[[pytest.MonkeyPatch], None]:
    """Replace text of a function where it is looked up."""
    return lambda patch: patch.setattr(owner, name, changed(getattr(owner, name), old, new))


def of_surface(surface: Surface, *parts: str, scene: Scene = HOOP) -> list[Kernel]:
    made = model._surface_kernels(surface, scene, model._order(scene)).kernels
    return [made[part] for part in parts]


def common(*names: str) -> list[Kernel]:
    return [k for k in model._common(HOOP, model._order(HOOP)) if k.name in names]


def limits(name: str, change: Callable[[tuple[Any, ...]], tuple[Any, ...]]) -> list[Kernel]:
    """Return the bounds of a plate that has other limits."""
    plate = SURFACE[name]
    return of_surface(replace(plate, limits=change(plate.limits)), "bounds")


@dataclass(frozen=True)
class Fault:
    """What is replaced in derive/ and which kernels it touches, or what in the event loop."""

    name: str
    kernels: Callable[[], list[Kernel]] = list
    derive: Callable[[pytest.MonkeyPatch], None] = lambda patch: None
    loop: tuple[str, str] = ("", "")


def ring_kernels(*parts: str) -> Callable[[], list[Kernel]]:
    return lambda: of_surface(SURFACE["ring"], *parts)


def swapped_parameters(surface: str, one: str, other: str) -> list[Kernel]:
    symbols = {s.name: s for s in HOOP.symbols}
    swap = {symbols[one]: symbols[other], symbols[other]: symbols[one]}
    return limits(surface, lambda g: tuple(e.xreplace(swap) for e in g))


FAULTS = (
    Fault(
        "the ring is not deflated after a contact",
        loop=("nearby = gone & (tilted < flat)", "nearby = np.zeros(len(t), np.bool_)"),
    ),
    Fault(
        "the ring's exits count as arrivals",
        loop=("falling = (rate < 0.0) |", "falling = (rate != 0.0) |"),
    ),
    Fault(
        "the end plane is met ascending",
        lambda: of_surface(HOOP.finish, "arrival"),
        patched(model.events, "plane_arrival", "b + root", "b - root"),
    ),
    Fault(
        "the bridge is met from below",
        lambda: of_surface(SURFACE["bridge"], "arrival"),
        patched(model.events, "plane_arrival", "b + root", "b - root"),
    ),
    Fault(
        "board and bridge have each other's width",
        lambda: (
            swapped_parameters("backboard", "board_half_width", "bridge_half_width")
            + swapped_parameters("bridge", "board_half_width", "bridge_half_width")
        ),
    ),
    Fault(
        "the board's upper and lower edges are swapped",
        lambda: swapped_parameters("backboard", "board_bottom", "board_top"),
    ),
    Fault(
        "the bridge goes on behind the board",
        lambda: limits("bridge", lambda g: (*g[:4], g[3])),
    ),
    Fault(
        "the bridge begins inside the ring",
        lambda: limits("bridge", lambda g: (*g[:2], g[3], *g[3:])),
    ),
    Fault(
        "the curvature bound is a tenth",
        ring_kernels("advance"),
        patched(ring.RingApproach, "curvature", "return fall + turn", "return (fall + turn) / 10"),
    ),
    Fault(
        "the ring's windows are a tenth too small",
        ring_kernels("prepare"),
        patched(ring.RingApproach, "_reach", "* WIDER", "* sp.Rational(9, 10)"),
    ),
    Fault(
        "every flight is taken to miss the ring",
        ring_kernels("clear"),
        patched(
            ring.RingApproach,
            "clear",
            "verdict = IfLess(rises, 0, verdict, nearing)",
            "verdict = IfLess(0, 1, 1, 0)",
        ),
    ),
    Fault(
        "Eq. 7 takes the largest component",
        lambda: common("contact_frame"),
        patched(frame, "_of_smallest", ") -> sp.Expr:", "):\n    sizes = [-s for s in sizes]"),
    ),
    Fault(
        "the impact turns the spin the wrong way",
        lambda: common("impact"),
        patched(model, "impact", "+ 2 * ball_radius * across", "- 2 * ball_radius * across"),
    ),
    Fault(
        "restitution is forgotten",
        lambda: common("impact"),
        patched(model, "impact", "restitution * approach", "approach"),
    ),
    Fault(
        "the spin about the normal is forgotten",
        lambda: common("impact"),
        patched(model, "impact", "+ hold(spin.dot(normal)) * normal", ""),
    ),
    Fault(
        "the shell is a full ball",
        lambda: common("impact"),
        patched(
            model,
            "impact",
            "(3 * tangential + 2 * ball_radius * across) / 5",
            "(5 * tangential + 2 * ball_radius * across) / 7",
        ),
    ),
    Fault(
        "the ring's normal is not divided by R",
        ring_kernels("normal"),
        patched(ring.Ring, "normal", "hold(1 / self.reach)", "hold(self.reach / self.reach)"),
    ),
    Fault(
        "gravity is not halved",
        lambda: common("flight"),
        patched(model, "flight", "/ 2", ""),
    ),
    Fault(
        "bounds carry no guard",
        lambda: common("claimed_errors"),
        patched(sensitivity, "bounds", "times * s", "s / 2**10"),
    ),
    Fault(
        "the ring's margins are zero",
        ring_kernels("margins"),
        patched(ring.RingApproach, "margins", "SAFETY *", "sp.Rational(1, 2**60) *"),
    ),
    Fault(
        "planes have no margin",
        lambda: [k for s in SURFACE.values() if s.name != "ring" for k in of_surface(s, "margin")],
        patched(model.events, "plane_margin", "2 * SAFETY *", "0 *"),
    ),
    Fault(
        "lengths at an arrival have no error",
        lambda: common("displacement"),
        patched(model.events, "displacement", "return ", "return 0 * "),
    ),
    Fault(
        "roots are not refined",
        loop=("arrival = np.where(certain, refined, arrival)", "pass"),
    ),
    Fault(
        "of two arrivals the last one looked at is taken",
        loop=("earlier = arrives & (time < self.when)", "earlier = arrives"),
    ),
    Fault(
        "ties are not in doubt",
        loop=("self.question(tie,", "self.question(tie & False,"),
    ),
    Fault(
        "the search stops at once",
        loop=("range(kernels.STEP_LIMIT + 1)", "range(2)"),
    ),
    Fault(
        "only the first window is searched",
        loop=("& (low >= after)", "& (low >= after) & (after == 0.0)"),
    ),
    Fault(
        "one contact too many is allowed",
        loop=(">= max_contacts", "> max_contacts"),
    ),
    Fault(
        "made and missed are swapped",
        loop=("miss <= 0.0, MADE, MISSED", "miss <= 0.0, MISSED, MADE"),
    ),
)


@pytest.fixture(scope="session")
def proofs() -> Certificate:
    """Made before any fault is there."""
    return usual()[1]


def mutated_loop(fault: Fault, patch: pytest.MonkeyPatch) -> ModuleType:
    """Return the event loop with the fault in it."""
    source = inspect.getsource(numpy_backend)
    old, new = fault.loop
    assert old in source, f"the event loop has no {old!r}"
    module = ModuleType("hoopgen.engine.mutated")
    module.__package__ = "hoopgen.engine"
    patch.setitem(sys.modules, module.__name__, module)  # dataclasses look there
    exec(compile(source.replace(old, new), "mutated", "exec"), module.__dict__)
    return module


def with_kernels(functions: Iterable[Kernel], folder: Path) -> ModuleType:
    """Return the generated module with some kernels printed anew."""
    made = list(functions)
    module = ModuleType("mutated_hoop")
    module.__dict__.update(vars(hoop))
    if made:
        source = folder / "mutated.py"
        source.write_text(printed("numpy/kernels.py.j2", made), encoding="utf-8")
        fresh = load_module(source)
        module.__dict__.update({k.name: getattr(fresh, k.name) for k in made})
    return module


def test_without_a_fault_nothing_trips(proofs: Certificate) -> None:
    trip(hoop, numpy_backend)


def test_derived_anew_without_a_fault_nothing_trips(proofs: Certificate, tmp_path: Path) -> None:
    """All kernels that faults touch, printed as the faulty ones are."""
    kernels = {k.name: k for fault in FAULTS for k in fault.kernels()}
    plain = [k for k in model.build(HOOP).kernels if k.name in kernels]
    assert len(plain) == len(kernels)
    trip(with_kernels(plain, tmp_path), numpy_backend)


@pytest.mark.parametrize("fault", FAULTS, ids=lambda fault: fault.name)
def test_a_fault_trips(
    proofs: Certificate, fault: Fault, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    fault.derive(monkeypatch)
    kernels = with_kernels(fault.kernels(), tmp_path)
    loop = mutated_loop(fault, monkeypatch) if any(fault.loop) else numpy_backend
    with pytest.raises(Tripped):
        trip(kernels, loop)
