"""The other ways to fly a shot, all on the model that hoopgen flies, each on one thread."""

from benchmarks.peers.flown import Flown, Peer
from benchmarks.peers.native import adaptive_step, fixed_step, march_bisect
from benchmarks.peers.python import companion_matrix, solve_ivp_events

PEERS = (
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
)

__all__ = ["PEERS", "Flown", "Peer"]
