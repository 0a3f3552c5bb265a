"""The default player: how a player throws of whom nothing was measured, and how much it varies."""

from __future__ import annotations

from collections.abc import Mapping

from hoopgen.core.parameters import ParameterValues
from hoopgen.core.units import DEGREE, FOOT, INCH, TURN
from hoopgen.hoop.court_places import Place, find_place
from hoopgen.scene.lookup import SceneLike
from hoopgen.study.models.scatter import Scatter
from hoopgen.study.statistics.tally import check_share

from .solve import solve

HEIGHT, BACKSPIN, ELEVATION, AIM = 7.0 * FOOT, 3.0 * TURN, 52.0 * DEGREE, 2.0 * INCH

PLAYER: Mapping[str, float] = {
    "speed": 0.07,
    "elevation": 1.3 * DEGREE,
    "azimuth": 1.0 * DEGREE,
    "backspin": 0.3 * TURN,
}
"""Standard deviations of the default player, before all are scaled to a share of made shots."""

PROVENANCE = (
    "The default player: a release 7 ft up at 52 degrees with 180 rpm of backspin, through a point "
    "2 in past the ring's centre. The spreads are in the proportions 0.07 m/s, 1.3 degrees and 1.0 "
    "degree, within those that Slegers, Lee and Wong (2021) measured of free throws in speed and "
    "angle; left-right and the spin's 18 rpm are assumed. All are scaled alike to the share made."
)


def throws_of_default_player(where: Place) -> Scatter:
    """Return the default player's throws from a place, with the spread that `PLAYER` gives.

    Parameters
    ----------
    where
        The place.
    """
    release = {"height": HEIGHT, "backspin": BACKSPIN, "elevation": ELEVATION, "aim": AIM}
    return Scatter({**release, **where.variables}, PLAYER)


def default_player(
    makes: float,
    parameters: ParameterValues,
    *,
    scene: SceneLike = None,
    seed: int = 0,
    threads: int | None = None,
) -> Scatter:
    """Return the default player, whose spread is scaled to a share of free throws made.

    Parameters
    ----------
    makes
        The share of free throws that go in, from 0 to 1.
    parameters
        Parameters of the hoop by name, SI.
    seed
        The seed of the random numbers.
    threads
        The number of threads; None is one for each processor.
    """
    throws = throws_of_default_player(find_place("free throw", parameters))
    share = check_share("makes", makes)
    found = solve(throws, share, parameters, scene=scene, seed=seed, threads=threads)
    assert isinstance(found.model, Scatter)
    return found.model
