"""Deliberate faults: each must trip the wire, a short suite against proofs in ball arithmetic.

A fault changes derive/: the text of a formula, a decision, the event loop's tree, or the scene
(`mutants.py`). NumPy runs all of them; C, which prints the same tree, some.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cache, partial
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest
from hoopgen.derive.contact import frame, no_slip
from hoopgen.derive.errors import contact_frames, surface_frames
from hoopgen.derive.events import end_plane, event_polynomials, plane
from hoopgen.derive.events import predicates as searching
from hoopgen.derive.events.ring import double
from hoopgen.derive.events.ring.double import RingRootFinder
from hoopgen.derive.events.ring.single import MAX_STEPS, SinglePrecisionRing
from hoopgen.derive.ir.event_tree import If, While
from hoopgen.derive.loop import predicates as following
from hoopgen.derive.motion.parabola import Parabola
from hoopgen.derive.scenes.hoop import HOOP
from hoopgen.derive.scenes.scene import Scene
from hoopgen.derive.surfaces import Ring
from hoopgen.generated.numpy import hoop
from numpy.typing import NDArray

from benchmarks.families import FAMILIES
from benchmarks.workloads import TABLE_3, WORKLOADS
from hoopgen import PAPER, Outcome
from hoopgen.engine.result_arrays import ResultArrays
from hoopgen.judge import Certificate, Proof, certify
from hoopgen.simulation.hoop import HOOP as ENGINE
from tests.helpers.compiled import needs_compiler
from tests.helpers.mutants import (
    Fault,
    Run,
    c_engine,
    derived,
    in_decisions,
    in_text,
    in_text_for,
    in_tree,
    numpy_engine,
    numpy_module,
    with_limits,
)
from tests.helpers.past_ring import complaints
from tests.simulation.test_hard_shots import CASES, proof, spelled

# One worker: proofs are made once.
pytestmark = pytest.mark.xdist_group("mutations")

SWIRLING = 30
"""Contacts of the swirl that are certain; without deflation they are not."""

MOST = 12
"""Contacts of the shots that are proved here."""

HARD = {"edges": 400, "seam": 200, "target": 200, "grazing": 400}
"""Families that the bounds on errors are for, and how many of each."""

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

    raw: ResultArrays
    events: list[str]


def fly(run: Run, states: NDArray[np.float64], parameters: list[Any], most: int) -> Answer:
    room = ENGINE.layout.allocate_events(len(states), most)
    out = ENGINE.layout.allocate(len(states), FIELDS).joined(room)
    run(states, parameters, most, out)
    logs = list(zip(room.events, room.event_counts, strict=True))
    for row, (log, count) in enumerate(logs):
        times = np.concatenate([[0.0], log["time"][:count]])
        demand(bool(np.all(np.diff(times) >= 0.0)), f"events of shot {row} out of order")
    return Answer(out, [spelled(log["surface"][:count]) for log, count in logs])


@dataclass(frozen=True)
class Proved:
    """Shots with a parameter a column, what is proved of them, and which are ordinary."""

    states: NDArray[np.float64]
    columns: list[NDArray[np.float64]]
    proofs: Certificate
    usual: NDArray[np.bool_]


def at_the_end_plane(count: int) -> NDArray[np.float64]:
    """Return balls whose highest point is at the end plane within some roundings, (count, 9)."""
    random = np.random.default_rng(12)
    states = np.zeros((count, 9))
    below = random.uniform(0.1, 3.0, count)
    states[:, 0] = random.uniform(-1.0, 1.0, count)
    states[:, 2] = -PAPER["end_depth"] - below
    states[:, 5] = np.sqrt(2 * PAPER["gravity"] * below) * (
        1 + 2.0**-53 * random.integers(-8, 9, count)
    )
    return states


@cache
def proved() -> Proved:
    """Ordinary shots and hard ones, and what they do."""
    random = np.random.default_rng(11)
    around = np.zeros((150, 9))
    around[:, :3] = random.uniform((-0.35, -0.45, -0.2), (0.55, 0.45, 0.8), (150, 3))
    around[:, 3:6] = random.normal(0, 2, (150, 3))
    around[:, 6:] = random.normal(0, 15, (150, 3))
    batches = [(around, PAPER), *((w.make(40), PAPER) for w in WORKLOADS)]
    usual = sum(len(states) for states, _ in batches)
    batches += [f.make(HARD[f.key]) for f in FAMILIES if f.key in HARD]
    batches.append((at_the_end_plane(200), PAPER))
    states = np.concatenate([states for states, _ in batches])
    columns = [
        np.concatenate([np.broadcast_to(given[name], len(states)) for states, given in batches])
        for name in PAPER
    ]
    given = dict(zip(PAPER, columns, strict=True))
    proofs = certify(states, given, max_contacts=MOST, processes=1)
    return Proved(states, columns, proofs, np.arange(len(states)) < usual)


def trip(run: Run) -> None:
    """Raise `Tripped` at the first claim that does not hold."""
    given = list(PAPER.values())
    answer = fly(run, np.array(list(TABLE_3.values())), given, 40)
    demand(answer.events == [SEQUENCES[case] for case in TABLE_3], "Table 3")

    # The article's swirl with its spin: hops down to a microsecond.
    swirl = np.array([[*TABLE_3["6b"][:8], 2.0]])
    answer = fly(run, swirl, given, SWIRLING)
    demand(answer.events == ["R" * SWIRLING] and not answer.raw.uncertain[0], "the swirl")

    shots = proved()
    answer = fly(run, shots.states, shots.columns, MOST)
    demand(np.mean(answer.raw.uncertain[shots.usual]) < 0.1, "too much is uncertain")
    for row in np.flatnonzero(~answer.raw.uncertain):
        hold_against(answer, row, shots)
    cases(run)


def hold_against(answer: Answer, row: int, shots: Proved) -> None:
    """Compare a shot that is not uncertain with its proof."""
    found = shots.proofs[row]
    demand(found.decided, f"shot {row} is certain")
    demand(answer.events[row] == spelled(found.surfaces), f"events of shot {row}")
    demand(answer.raw.outcome[row] == found.outcome, f"outcome of shot {row}")
    near_enough(answer.raw, row, found, f"shot {row}")


def near_enough(raw: ResultArrays, row: int, found: Proof, name: str) -> None:
    """Hold time and state to what the shot claims of them."""
    if found.outcome == Outcome.INVALID:
        return
    late = abs(raw.time[row] - found.time)
    demand(late <= raw.time_error[row] + found.time_radius, f"time of {name}")
    away = np.abs(raw.state[row] - found.state)
    bound = np.repeat(raw.state_error[row], 3) + found.state_radii
    demand(bool(np.all(away <= bound)), f"state of {name}")


def cases(run: Run) -> None:
    """Check the saved cases."""
    known = [case for case in CASES if not case.known_errors]
    for most in sorted({case.max_contacts for case in known}):
        some = [case for case in known if case.max_contacts == most]
        columns = [np.array([case.parameters[name] for case in some]) for name in PAPER]
        answer = fly(run, np.array([case.state for case in some]), columns, most)
        for row, case in enumerate(some):
            if answer.raw.uncertain[row]:
                demand(not case.decided, f"{case.name} is uncertain")
                continue
            found = Outcome(answer.raw.outcome[row]).name, answer.events[row]
            demand(found == case.proved, case.name)
            if case.decided:
                near_enough(answer.raw, row, proof(CASES.index(case)), case.name)


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


@cache
def slow() -> tuple[NDArray[np.float64], Certificate]:
    """Shots that crawl on the rim, where errors are largest beside those carried along."""
    (states, given), *_ = (family.make(300) for family in FAMILIES if family.key == "rim")
    return states, certify(states, given, max_contacts=6, processes=1)


def share_of_bounds(kernels: ModuleType) -> float:
    """Return the largest error beside its bound, which decisions and claims use."""
    states, proofs = slow()
    raw = fly(numpy_engine(kernels), states, list(PAPER.values()), 6).raw
    away = (np.abs(raw.state - proofs.state) - proofs.state_radius).reshape(-1, 3, 3).max(axis=2)
    off = (away > 0.0) & ~raw.uncertain[:, None]  # not where there are no numbers
    return float(np.max(away[off] / raw.state_error[off]))


# --------------------------------------------------------------------------------------- mutation


def swapped(one: str, other: str, *plates: str) -> Callable[[Scene], Scene]:
    """Swap two parameters in the limits of plates."""
    symbols = {s.name: s for s in HOOP.symbols}
    swap = {symbols[one]: symbols[other], symbols[other]: symbols[one]}

    def change(scene: Scene) -> Scene:
        for plate in plates:
            scene = with_limits(scene, plate, lambda g: tuple(e.xreplace(swap) for e in g))
        return scene

    return change


def in_search(old: str, new: str) -> Any:
    return in_decisions(searching, old, new)


def no_guard(truth: str) -> Any:
    """Take the body of a guard away."""
    return in_tree(lambda node: () if isinstance(node, If) and node.truth == truth else (node,))


_GRIT = "barrier(stretch * barrier(outermost / innermost))"

FAULTS = (
    # The search and the loop: decisions, and the tree itself.
    Fault(
        "the ring is not deflated after a contact",
        in_search("Less(tilt * t, flat)", "false"),
        in_c=True,
    ),
    Fault(
        "the ring's exits count as arrivals",
        in_text(
            SinglePrecisionRing,
            "leap",
            'sure = Less(0, step_outputs["clearance"])',
            "sure = Less(0, rate**2)",
        ),
    ),
    Fault("roots are not refined", in_search("Choose(certain, refined, arrival)", "arrival")),
    Fault(
        "of two arrivals the last one looked at is taken",
        in_search("_sooner = all_of(arrives, Less(time, when))", "_sooner = arrives"),
        in_c=True,
    ),
    Fault("ties are decided", in_search("all_of(arrives, _tie)", "false")),
    Fault(
        "an arrival before the flight counts",
        in_search("all_of(_meets, AtMost(0, time), Less", "all_of(_meets, Less"),
    ),
    Fault(
        "an arrival is before the flight",
        in_search("Choose(Less(arrival, 0), 0, arrival)", "arrival"),
    ),
    Fault(
        "the search stops at once",
        in_tree(lambda n: (replace(n, limit=1) if isinstance(n, While) else n,)),
        in_c=True,
    ),
    Fault("only the first window is searched", no_guard("exhausted")),
    Fault(
        "one contact too many is allowed",
        in_text(following, "_of_scene", "AtMost(most_contacts, ", "Less(most_contacts, "),
    ),
    Fault(
        "made and missed are swapped",
        in_text(end_plane, "reached", "within(bounds)", "Not(within(bounds))"),
        in_c=True,
    ),
    Fault(
        "the target's edge is sure",
        in_text(end_plane, "edge", "nearly(bounds)", "false"),
    ),
    # Surfaces and their searches.
    Fault(
        "the end plane is met ascending",
        in_text_for("end", plane, "plane_arrival", "b + root", "b - root"),
    ),
    Fault(
        "the bridge is met from below",
        in_text_for("bridge", plane, "plane_arrival", "b + root", "b - root"),
    ),
    Fault(
        "board and bridge have each other's width",
        scene=swapped("board_half_width", "bridge_half_width", "backboard", "bridge"),
    ),
    Fault(
        "the board's upper and lower edges are swapped",
        scene=swapped("board_bottom", "board_top", "backboard"),
    ),
    Fault(
        "the bridge goes on behind the board",
        scene=partial(with_limits, plate="bridge", change=lambda g: (*g[:4], g[3])),
    ),
    Fault(
        "the bridge begins inside the ring",
        scene=partial(with_limits, plate="bridge", change=lambda g: (*g[:2], g[3], *g[3:])),
    ),
    Fault(
        "the curvature bound is a tenth",
        in_text(
            RingRootFinder,
            "curvature",
            "return fall + turn - energy2 + slack",
            "return (fall + turn) / 10 - energy2",
        ),
    ),
    Fault(
        "the ring's windows are a tenth too small",
        in_text(RingRootFinder, "reach", "* INFLATION_FACTOR", "* sp.Rational(9, 10)"),
    ),
    Fault(
        "every flight is taken to miss the ring",
        in_text(
            double,
            "clear",
            "verdict = IfLess(rises, 0, verdict, nearing)",
            "verdict = IfLess(0, 1, 1, 0)",
        ),
    ),
    # The ring's search in single precision.
    Fault(
        "the margin of the rate from F/t is left out",
        in_text(
            SinglePrecisionRing, "rate_allowed", "barrier(2 * _TILTED + _JERKED)", "sp.Integer(0)"
        ),
    ),
    Fault(
        "F' has no margin in single precision",
        in_text(
            SinglePrecisionRing, "grain", '"rate_margin": slope', '"rate_margin": sp.Integer(0)'
        ),
    ),
    Fault(
        "F has a margin of a 64th",
        in_text(SinglePrecisionRing, "grain", "5 * reach * place", "5 * reach * place / 64"),
    ),
    Fault(
        "F/t has no margin",
        in_text(SinglePrecisionRing, "grain", "ROUNDING_SLACK * barrier(tilting)", "sp.Integer(0)"),
    ),
    Fault(
        "F/t serves where the ball did not leave",
        in_text(SinglePrecisionRing, "grain", "barrier(tilting), sp.oo", "barrier(tilting), 0"),
    ),
    Fault(
        "what the deflated gap is bent by has no error",
        in_text(SinglePrecisionRing, "grain", _GRIT, "0"),
    ),
    Fault(
        "F' is as straight as F/t has it",
        in_text(
            SinglePrecisionRing,
            "grain",
            "* barrier(self.gravity * upright",
            "* 0 * barrier(self.gravity * upright",
        ),
    ),
    Fault(
        "the mean of the outward speed is forgotten",
        in_text(
            SinglePrecisionRing, "_mean_rate", "speed_squared - rho_rate * mean", "speed_squared"
        ),
    ),
    Fault(
        "in single precision no errors are allowed for",
        in_text(SinglePrecisionRing, "grain", "minimum(ERROR_BUDGET_LEVELS[0],", "minimum(0,"),
    ),
    Fault(
        "a free flight in single precision allows for no errors",
        in_text(SinglePrecisionRing, "grain", "finer, ERROR_BUDGET_LEVELS[0])", "finer, 0)"),
    ),
    Fault(
        "later windows are forgotten in single precision",
        in_text(SinglePrecisionRing, "leap", "enter(self._later(), end", "enter([], end"),
    ),
    Fault(
        "later windows are not drawn from where the first one opens",
        in_text(SinglePrecisionRing, "grain", "edge - t for window", "edge for window"),
    ),
    Fault(
        "the window ends as late as if it opened at the start",
        in_text(SinglePrecisionRing, "grain", '"end": end - t', '"end": end'),
    ),
    Fault(
        "the last window ends too early in single precision",
        in_text(
            SinglePrecisionRing, "opened", "1 + sp.Rational(1, 2**22)", "1 - sp.Rational(1, 2**10)"
        ),
    ),
    Fault(
        "Newton's method has hardly any headroom",
        in_text(
            SinglePrecisionRing,
            "headroom",
            "2 * barrier(low_gap + 2 * self.allowed)",
            "low_gap / 8",
        ),
    ),
    Fault(
        "F'' is not bounded from above where Newton's method goes",
        in_text(SinglePrecisionRing, "steepest", "maximum(curvature, upper)", "curvature"),
    ),
    # Contacts.
    Fault(
        "Eq. 7 takes the largest component",
        in_text(frame, "_of_smallest", ") -> sp.Expr:", "):\n    sizes = [-s for s in sizes]"),
    ),
    Fault(
        "the impact turns the spin the wrong way",
        in_text(no_slip, "impact", "tangential + spun", "tangential - spun"),
    ),
    Fault(
        "restitution is forgotten",
        in_text(no_slip, "impact", "restitution * approach", "approach"),
    ),
    Fault(
        "the spin about the normal is forgotten",
        in_text(no_slip, "impact", "+ barrier(spin.dot(normal)) * normal", ""),
    ),
    Fault(
        "the shell is a full ball",
        in_text(
            no_slip,
            "impact",
            "    spun =",
            "    ball = Ball(ball.radius, sp.Rational(2, 5))\n    spun =",
        ),
    ),
    Fault(
        "the ring's normal is not divided by R",
        in_text(Ring, "normal", "barrier(1 / self.reach)", "barrier(self.reach / self.reach)"),
    ),
    Fault("gravity is not halved", in_text(Parabola, "path", "/ 2", "")),
    # Bounds on errors.
    Fault(
        "bounds are a thousandth",
        in_text(contact_frames, "norms_after", "ROUNDING_SLACK * value", "value / 2**10"),
    ),
    Fault(
        "errors do not grow",
        in_text(contact_frames, "weighted_sum", "absolute(factor) * b", "0 * b"),
    ),
    Fault(
        "a root is on the surface",
        in_text(surface_frames, "_with_newton_residue", "        barrier(", "        0 * barrier("),
    ),
    Fault(
        "the ring's margins are zero",
        in_text(RingRootFinder, "margins", "ROUNDING_SLACK *", "sp.Rational(1, 2**60) *"),
    ),
    Fault(
        "planes have no margin",
        in_text(plane, "plane_margin", "2 * ROUNDING_SLACK *", "sp.Rational(1, 2**60) *"),
    ),
    Fault(
        "lengths at an arrival have no error",
        in_text(
            event_polynomials,
            "displacement",
            "return ROUNDING_SLACK",
            "return ROUNDING_SLACK / 2**60",
        ),
    ),
    Fault(
        "an edge is sure if the ball is inside",
        in_text(plane, "edges", "inside(patch)", "within(patch)"),
    ),
)


@pytest.fixture(scope="session", autouse=True)
def proofs() -> Proved:
    """Made before any fault is there."""
    slow()
    return proved()


def trip_numpy(files: dict[str, str], folder: Path) -> None:
    kernels = numpy_module(files, folder)
    trip(numpy_engine(kernels))
    frames(kernels)
    for said in complaints(kernels, MAX_STEPS):
        demand(False, f"flight {said}")
    demand(share_of_bounds(kernels) <= 1.0, "errors are beyond their bounds")


@pytest.mark.slow
def test_derived_anew_without_a_fault_nothing_trips(tmp_path: Path) -> None:
    trip_numpy(derived(Fault("none")), tmp_path)


@pytest.mark.slow
def test_bounds_hold_and_are_not_far_off() -> None:
    assert 0.03 < share_of_bounds(hoop) <= 1


@needs_compiler
@pytest.mark.slow
def test_without_a_fault_nothing_trips_in_c(tmp_path: Path) -> None:
    trip(c_engine(derived(Fault("none")), tmp_path))


@pytest.mark.parametrize("fault", FAULTS, ids=lambda fault: fault.name)
@pytest.mark.sampled(1)
def test_a_fault_trips(fault: Fault, tmp_path: Path) -> None:
    files = derived(fault)
    with pytest.raises(Tripped):
        trip_numpy(files, tmp_path)


@needs_compiler
@pytest.mark.slow
@pytest.mark.parametrize("fault", [f for f in FAULTS if f.in_c], ids=lambda fault: fault.name)
def test_a_fault_trips_in_c(fault: Fault, tmp_path: Path) -> None:
    with pytest.raises(Tripped):
        trip(c_engine(derived(fault), tmp_path))
