"""The other ways to fly a shot, all on the model that hoopgen flies, each on one thread."""

from collections.abc import Callable, Sequence
from importlib.util import find_spec

from benchmarks.peers.flown import Flown, Peer
from benchmarks.peers.native import adaptive_step, fixed_step, march_bisect
from benchmarks.peers.python import companion_matrix, solve_ivp_events
from benchmarks.peers.taylor import LANES, heyoka_events

EVERYBODY = (
    Peer(
        "march_bisect",
        "the article's method, C",
        "march 1e-3 s and bisect to 1e-10 s on the functions of Table 2",
        march_bisect,
    ),
    Peer(
        "adaptive_step",
        "adaptive time stepping, C",
        "step: time that the nearest surface cannot be reached in, 1e-4 s or more",
        adaptive_step,
    ),
    Peer(
        "fixed_step",
        "fixed time stepping, C",
        "step 1e-4 s, contact located inside the step by bisection",
        fixed_step,
    ),
    Peer(
        "companion_matrix",
        "companion matrix, NumPy",
        "polynomials in time, numpy.roots, flight by flight",
        companion_matrix,
    ),
    Peer(
        "solve_ivp_events",
        "solve_ivp events, SciPy",
        "RK45 with four terminal events, rtol 1e-9, atol 1e-12, steps up to 1e-2 s",
        solve_ivp_events,
    ),
    Peer(
        "heyoka_events",
        "Taylor series, heyoka.py",
        f"order 20, four terminal events, {LANES} shots side by side in batch mode",
        heyoka_events,
        "heyoka",
    ),
)


def taking_part(
    peers: Sequence[Peer], find: Callable[[str], object] = find_spec
) -> tuple[tuple[Peer, ...], tuple[str, ...]]:
    """Return the peers whose packages are installed, and a line on each of the others."""
    absent = [peer for peer in peers if peer.package and find(peer.package) is None]
    lines = (f"{peer.label}: left out, {peer.package} is not installed here" for peer in absent)
    return tuple(peer for peer in peers if peer not in absent), tuple(lines)


PEERS, LEFT_OUT = taking_part(EVERYBODY)

__all__ = ["EVERYBODY", "LEFT_OUT", "PEERS", "Flown", "Peer", "taking_part"]
