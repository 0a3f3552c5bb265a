"""`simulate`: shots in any scene."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Literal

from numpy.typing import ArrayLike

from hoopgen.core.backend_names import BackendName
from hoopgen.core.parameters import ParameterValues
from hoopgen.results.shots import Shots
from hoopgen.scene.lookup import SceneLike

from .lookup import engine_of
from .run import run


def simulate(
    states: ArrayLike,
    parameters: ParameterValues | None = None,
    *,
    scene: SceneLike = None,
    max_contacts: int | None = None,
    backend: BackendName = "auto",
    threads: int | None = None,
    fields: Literal["all"] | Iterable[str] = "all",
    record: bool = False,
    leaving: ArrayLike | None = None,
    settle: bool = False,
    time_limit: float | None = None,
    derivatives: Iterable[str] | None = None,
) -> Shots:
    """Simulate shots from contact to contact until they end.

    Parameters
    ----------
    states
        Releases, (n, 9) or (9,): x y z (m), vx vy vz (m/s), wx wy wz (rad/s); origin at the ring's
        centre, z up, backboard at negative x. Or a table with columns of these names in any order,
        such as a DataFrame; a mapping of these names to numbers is one release. Here and below,
        entries that are masked count as NaN. Arrays are not copied: leave them as they are as long
        as you use the shots, whose trajectories and parameters read them.
    parameters
        Name to value, one for all shots or (n,); those left out have the scene's usual values. For
        the hoop `PAPER`, its usual ones, `NBA` and `FIBA`; for `COURT` `PAPER_COURT`, `NBA_COURT`
        and `FIBA_COURT`. They merge with ``|``.
    scene
        None for `HOOP`, the article's; `COURT`, the whole hoop with friction; or what `compile`
        takes or has returned.
    max_contacts
        A shot with so many contacts ends as capped; at least 1. None: 40 in the hoop, as in the
        article, elsewhere 1000.
    backend
        "auto" is "c" where it was built, else "numpy". The results are the same bits. "cuda" is a
        GPU, by name only: one thread a shot. There the results of states in the GPU's memory, as
        of CuPy, stay in that memory.
    threads
        How many work; None for one on each processor that the process may use. More than four on
        each are not started, nor more than have some thousands of shots each: they would be in
        each other's way. "cuda" uses none.
    fields
        "all", or the names of the results that are wanted; by name also those that `Shots` has
        only if requested, such as the bounds on the errors of time and state. Without these and
        "uncertain" no errors are bounded, which saves a fifth or more; the path is the same.
    record
        Whether to keep the event log, which `Shots.trajectory` needs.
    leaving
        The surface that each shot touches at the start, whatever the last digits of its position
        say: a name in `Shots.surfaces`, its index, or -1 for none; one for all or (n,). To begin
        on a body, where the ball rolls at once if it can, or to go on from recorded `after` states.
        Where a ball can roll it is put onto the surface; elsewhere a shot is uncertain if the ball
        is off the surface by more than roundings. A shot is INVALID if it is off by more than
        1/1024 of the ball's radius, or the ball is inside another surface that it touches, too.
    settle
        Whether to let `certify` decide the uncertain shots, which then are not; needs the extra
        "certify". A true tie, an exact touch or an exact edge stays uncertain.
    time_limit
        s since the release, of flight and contact: a shot that has not ended then ends as ENDLESS,
        with its state at that time; so does one that is certain to roll for ever, as soon as that
        is. At most 2^40. None: no limit in the hoop, elsewhere 60. A shot that can never
        reach the end plane is SHORT all the same, unless the limit comes before its last contact.
    derivatives
        Names of components of the state, ``"vx"``, or of parameters of the scene: the shots then
        have the derivatives of their time and state at the end by each of them, in
        `Shots.jacobian`, and `Shots.differentiable`. The event log is kept while they are computed.

    Returns
    -------
    Shots
        By shot, whatever the backend and the number of threads. A shot that cannot be simulated
        is INVALID, with NaN results, and does not disturb the others; `why_invalid` says why.

    Raises
    ------
    TypeError, ValueError
        If an argument is not as described; the message says what is.
    RuntimeError
        If backend "c" is asked for and was not built, or cannot be trusted; if "cuda" is and there
        is no GPU, or its results are not NumPy's; or if there is no C engine, and this thread
        rounds otherwise than to the nearest double, or takes subnormals for zero.
    ImportError
        If shots are to be settled, or "cuda" is asked for, and the extra is missing.
    MemoryError
        If the GPU has no memory for a shot, or for the results that stay there.
    """
    return run(
        engine_of(scene),
        states,
        parameters,
        max_contacts=max_contacts,
        backend=backend,
        threads=threads,
        fields=fields,
        record=record,
        leaving=leaving,
        settle=settle,
        time_limit=time_limit,
        derivatives=derivatives,
    )
