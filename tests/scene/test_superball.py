"""A ball that loses nothing bounces between two parallel plates: energy and a closed form.

The velocity of the point of contact is turned about, as that of a superball (Garwin, *Kinematics
of an ultraelastic rough ball*, American Journal of Physics 37, 88, 1969). Parameters turn the
plates in every shot.
"""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

import hoopgen
from hoopgen import Event
from hoopgen.scene import Parameter, Plane, Scene
from hoopgen.simulation.engine import Engine
from tests.helpers.effort import trials

pytestmark = [pytest.mark.xdist_group("superball")]

Floats = NDArray[np.float64]

BALL, HALF, GRAVITY, MOST = 0.05, 0.3, 9.81, 12
WAY = ("way_1", "way_2", "way_3")

PLATES = Scene(
    "plates",
    parameters=[
        *(
            Parameter(name, value, "1", sign="any")
            for name, value in zip(WAY, (1, 2, 2), strict=True)
        ),
        Parameter("pull", GRAVITY, "m/s²", sign="nonnegative"),
        Parameter("kappa", 2 / 3, "1"),
    ],
    bodies=[
        Plane("left", normal=WAY, at=-HALF),
        Plane("right", normal=("-way_1", "-way_2", "-way_3"), at=-HALF),
    ],
    ball_radius=BALL,
    gravity="pull",
    inertia="kappa",
    restitution=1,
    tangential=1,
)


@pytest.fixture(scope="module")
def plates() -> Engine:
    return hoopgen.compile(PLATES)


def thrown(count: int, seed: int) -> tuple[Floats, Floats, Floats]:
    """Return balls between the plates, the plates' normals, and moments of inertia."""
    chance = np.random.default_rng(seed)
    normals = chance.normal(0, 1, (count, 3))
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    states = np.zeros((count, 9))
    states[:, :3] = chance.uniform(-0.1, 0.1, (count, 3))
    states[:, 3:6] = chance.normal(0, 1, (count, 3)) + 3 * normals
    states[:, 6:] = chance.normal(0, 20, (count, 3))
    return states, normals, chance.choice([2 / 5, 2 / 3, 1.0], count)


@pytest.mark.slow
@pytest.mark.parametrize("pull", [0.0, GRAVITY])
def test_a_ball_that_loses_nothing_keeps_its_energy(plates: Engine, pull: float) -> None:
    """v²/2 + kappa R² w²/2 + g z, after each of twelve contacts, to the roundings of these."""
    states, normals, kappa = thrown(trials(300, at_least=60), 1)
    values = dict(zip(WAY, normals.T, strict=True)) | {"kappa": kappa, "pull": pull}
    shots = plates.simulate(states, values, max_contacts=MOST, record=True)
    assert (shots.contacts > 3).mean() > 0.9
    events = shots.events[shots.events["kind"] == Event.IMPACT]

    def energy(at: Floats, own: Floats) -> Floats:
        spin = own * BALL**2 * np.sum(at[:, 6:] ** 2, axis=1)
        return np.asarray((np.sum(at[:, 3:6] ** 2, axis=1) + spin) / 2 + pull * at[:, 2])

    begun = energy(states, kappa)[events["shot"]]
    after = energy(events["after"], kappa[events["shot"]])
    size = begun + pull * np.abs(events["after"][:, 2])
    assert np.abs(after - begun).max() < 1e-12 * size.max()


@pytest.mark.slow
def test_without_gravity_its_spin_turns_as_the_closed_form_says(plates: Engine) -> None:
    """The velocity u along the plates and s = R n × w change by a linear map at each plate.

    On the left plate an impact turns the slip u + s about and keeps u - kappa s, the angular
    momentum about the point of contact; on the right one s has the other sign.
    """
    states, normals, kappa = thrown(trials(300, at_least=60), 2)
    values = dict(zip(WAY, normals.T, strict=True)) | {"kappa": kappa, "pull": 0.0}
    shots = plates.simulate(states, values, max_contacts=MOST, record=True)
    for row in range(len(states)):
        log = shots.events[(shots.events["shot"] == row) & (shots.events["kind"] == Event.IMPACT)]
        n, own = normals[row], kappa[row]
        v, w = states[row, 3:6], states[row, 6:]
        u, s = v - (v @ n) * n, BALL * np.cross(n, w)
        for event in log:
            side = 1 if event["surface"] == 0 else -1
            slip = u + side * s
            u, s = u - 2 * own / (1 + own) * slip, s - 2 * side / (1 + own) * slip
            after = event["after"]
            across = after[3:6] - (after[3:6] @ n) * n
            np.testing.assert_allclose(across, u, rtol=0, atol=1e-12)
            np.testing.assert_allclose(BALL * np.cross(n, after[6:]), s, rtol=0, atol=1e-12)
        assert len(log) == MOST
