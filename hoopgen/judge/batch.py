"""`certify`: precision is doubled until every decision of a shot is proved."""

from __future__ import annotations

import math
import multiprocessing
import os
import sys
import warnings
from collections.abc import Callable, Iterable, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from itertools import chain
from typing import Any, TypedDict

import numpy as np
from flint import arb, ctx
from numpy.typing import ArrayLike, NDArray

from hoopgen.core.argument_types import check_arguments
from hoopgen.core.parameters import ParameterValues, resolve
from hoopgen.core.validation import (
    check_contacts,
    check_count,
    check_leaving,
    check_states,
    check_time_limit,
)
from hoopgen.derive.scenes.scene import Scene
from hoopgen.scene.definition import default_max_contacts, default_time_limit, definition, table_of
from hoopgen.scene.lookup import SceneLike

from .batch_flight import WIDTH, is_supported
from .batch_proofs import MIN_BATCH, BatchTask
from .certificate import Certificate
from .flight import ProvedFlight, fly
from .formulas import formulas
from .proof import UNDECIDED, Proof, ProvedEvent, doubles, enclosure
from .proof_task import ProofTask
from .roots import Undecided
from .taylor_model import Number

FIRST_BITS = 128
MAX_BITS = 4096

SHOTS_PER_TASK = 64
"""Shots that a process takes at a time; fewer are not worth another process."""

_ROLLS_QUESTION = "from there the ball rolls, which the judge does not follow"

_FORKS = sys.platform == "linux"
"""True where new processes start as copies of this one, and no script runs again."""


class CertificationOptions(TypedDict, total=False):
    """Keywords of `certify`, but for the scene."""

    max_contacts: int | None
    max_bits: int
    record: bool
    leaving: ArrayLike | None
    time_limit: float | None
    processes: int | None


@check_arguments
def certify(
    states: ArrayLike,
    parameters: ParameterValues | None = None,
    *,
    scene: SceneLike = None,
    max_contacts: int | None = None,
    max_bits: int = MAX_BITS,
    record: bool = False,
    leaving: ArrayLike | None = None,
    time_limit: float | None = None,
    processes: int | None = None,
) -> Certificate:
    """Prove what shots do, in ball arithmetic, independent of the engines.

    Every shot is flown from its exact doubles, with twice as many bits each time, until every
    decision (is there an arrival, which is first, is it within the bounds, is it made) is proved,
    and the final time and state are known to more than a double's digits. An event that is proved
    to be the first is only located with more digits then. A true tie, an exact touch or an exact
    edge is undecidable at any precision and reported as such. In a scene where balls roll, impacts
    are proved until bounces accumulate: no outcome is proved of such a shot.

    Most shots of a batch of 128 or more are proved at once, with NumPy, on `HOOP` and other scenes
    of rings and planes without air, slip and rolling, if `record` is false and the ball starts on
    no body. Their `bits` are 106. Their final time is then known to 2^-55 of its size, and place,
    velocity and spin to 2^-55 of their largest component, beside the rounding to the nearest
    double; a component that is much smaller than the others may have fewer digits than a double.
    All others are proved one by one, as in smaller batches, where each component has all digits.

    Parameters
    ----------
    states, parameters, scene, max_contacts
        As in `simulate`. Of a scene, its definition is what counts: nothing is compiled for it.
    max_bits
        Where to give up; at least 128.
    record
        Whether to keep every event's time and states with all digits. Then no shots are proved at
        once.
    leaving, time_limit
        As in `simulate`.
    processes
        How many work; None for as many as the process may use on Linux, elsewhere one.

    Returns
    -------
    Certificate
        Outcomes, sequences, and times and states with radii, by shot, and how far each is proved.

    Raises
    ------
    TypeError, ValueError
        If an argument is not as described; the message says what is.
    """
    releases = check_states(states)
    derived = definition(scene)
    table = table_of(scene, derived)
    own = resolve(parameters, len(releases), table)
    values = table.inputs(own)
    left = check_leaving(leaving, len(releases), [body.name for body in derived.bodies])
    most = default_max_contacts(derived) if max_contacts is None else check_contacts(max_contacts)
    bits = check_count("max_bits", max_bits, least=FIRST_BITS)
    limit = default_time_limit(derived) if time_limit is None else check_time_limit(time_limit)
    return prove(derived, releases, values, left, most, bits, record, processes, limit)


def prove(
    scene: Scene,
    states: NDArray[np.float64],
    parameters: Sequence[NDArray[np.float64] | float],
    leaving: NDArray[np.int8] | None,
    max_contacts: int,
    max_bits: int = MAX_BITS,
    record: bool = False,
    processes: int | None = None,
    time_limit: float = math.inf,
) -> Certificate:
    """Prove what shots do in a scene; arguments as for `certify`, already checked.

    Parameters
    ----------
    scene
        Of derive/.
    parameters
        Each a number or (n,), in the scene's order.
    time_limit
        Infinite: none.
    """
    own = formulas(scene)  # compiled here, once for all processes that are forked
    workers = _processes(processes)
    columns = [np.broadcast_to(p, len(states)) for p in parameters]
    values = np.stack(columns, axis=-1)
    left = np.full(len(states), -1, np.int8) if leaving is None else leaving
    proofs: list[Proof | None] = [None] * len(states)
    rows = np.flatnonzero(left < 0)
    if len(rows) >= MIN_BATCH and not record and is_supported(own):
        parts = np.array_split(rows, max(1, min(workers, len(rows) // WIDTH)))
        batches = [(states[part], values[part]) for part in parts]
        _write(proofs, rows, _mapped(BatchTask(scene, max_contacts, time_limit), batches, workers))
    rows = np.array([k for k, proof in enumerate(proofs) if proof is None], np.int64)
    parts = [rows[k : k + SHOTS_PER_TASK] for k in range(0, len(rows), SHOTS_PER_TASK)]
    chunks = [(states[part], values[part], left[part]) for part in parts]
    single = _SingleTask(scene, max_contacts, time_limit, max_bits, record)
    _write(proofs, rows, _mapped(single, chunks, workers))
    found = [proof for proof in proofs if proof is not None]
    return Certificate(found, len(scene.bodies), states, values, scene.name)


def _write(
    proofs: list[Proof | None], rows: NDArray[np.int64], parts: Iterable[Sequence[Proof | None]]
) -> None:
    """Write the proofs of some shots in place."""
    for row, proof in zip(rows.tolist(), chain.from_iterable(parts), strict=True):
        proofs[row] = proof


def _mapped(
    task: Callable[[Any], Sequence[Proof | None]], chunks: Sequence[Any], workers: int
) -> list[Sequence[Proof | None]]:
    """Return the results of a task by chunk, from several processes if there are several chunks."""
    workers = min(workers, len(chunks))
    if workers < 2:
        return [task(chunk) for chunk in chunks]
    with warnings.catch_warnings(), ProcessPoolExecutor(workers, _context()) as pool:
        # Of other threads' locks held at the fork; what the forked processes do takes none.
        warnings.simplefilter("ignore", DeprecationWarning)
        return list(pool.map(task, chunks))


def _processes(processes: int | None) -> int:
    if processes is None:
        return len(os.sched_getaffinity(0)) if _FORKS else 1
    return check_count("processes", processes, expected="a whole number from 1, or None")


def _context() -> multiprocessing.context.BaseContext:
    return multiprocessing.get_context("fork" if _FORKS else None)


@dataclass(frozen=True)
class _SingleTask(ProofTask):
    max_bits: int
    record: bool

    def __call__(self, chunk: tuple[NDArray[Any], ...]) -> list[Proof]:
        """Prove the shots of a chunk."""
        return [self.prove(*row) for row in zip(*(c.tolist() for c in chunk), strict=True)]

    def prove(self, state: Sequence[float], parameters: Sequence[float], leaving: int) -> Proof:
        """Prove one shot with the fewest doublings of precision."""
        bits, own, most = FIRST_BITS, formulas(self.scene), self.max_contacts
        known: Sequence[tuple[int, Number]] = ()
        while True:
            with ctx.workprec(bits):
                question = ""
                try:
                    flown = fly(own, state, parameters, most, leaving, self.time_limit, known)
                except Undecided as undecided:
                    question, flown = undecided.args
                last = 2 * bits > self.max_bits
                if last or (not question and (self._invalid(flown) or _accurate(flown))):
                    return self._proof(flown, bits, question)
            bits, known = 2 * bits, flown.found

    def _invalid(self, flown: ProvedFlight) -> bool:
        return flown.outcome == self.scene.outcomes["invalid"]

    def _proof(self, flown: ProvedFlight, bits: int, question: str) -> Proof:
        times, radii = doubles([event.time for event in flown.events])
        final = [flown.time, *flown.state]
        values, away = doubles(final)
        if flown.hops >= 0:
            body = self.scene.bodies[flown.events[-1].surface].name
            question = f"the bounces on the {body} accumulate; {_ROLLS_QUESTION}"
        if question or self._invalid(flown):
            values = away = [math.nan] * len(final)
        events: tuple[ProvedEvent, ...] = ()
        if self.record:
            events = tuple(
                ProvedEvent(
                    event.surface,
                    enclosure(event.time),
                    tuple(map(enclosure, event.before)),
                    tuple(map(enclosure, event.after)),
                )
                for event in flown.events
            )
        return Proof(
            UNDECIDED if question else int(flown.outcome),
            bits,
            question,
            [event.surface for event in flown.events],
            times,
            radii,
            values[0],
            away[0],
            values[1:],
            away[1:],
            events,
            flown.hops,
        )


def _accurate(flown: ProvedFlight) -> bool:
    """Return whether the final time and state are known well enough to be rounded to doubles."""
    relative, absolute = arb(2) ** -64, arb(2) ** -100
    return all(
        ball.rad() <= abs(ball.mid()) * relative or ball.rad() <= absolute
        for ball in (flown.time, *flown.state)
    )
