"""Tori with bounds in air, and bodies with bounds that hostile values make absurd."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

pytest.importorskip("flint")

import hoopgen
from hoopgen.scene import Parameter, Revolution
from tests.helpers.derived import engine_of
from tests.helpers.effort import exceptions, occurrences, trials
from tests.scene.test_contact_bounds import CLAIMS, CUT, SCENES, named, shots_for

pytestmark = [pytest.mark.slow, pytest.mark.xdist_group("bounded_bodies")]


@pytest.mark.parametrize("which", ["ring"])
def test_shots_in_air_are_as_proved(which: str, tmp_path: Path) -> None:
    engine = engine_of(replace(SCENES[which], name=f"{which}_in_air", air=True), tmp_path)
    count = trials(200, at_least=60)
    states, values = shots_for(count, 1)
    values = {name: value for name, value in values.items() if name in engine.parameters}
    shots = engine.simulate(states, values, max_contacts=3, record=True, fields=CLAIMS)
    proofs = hoopgen.certify(states, values, scene=engine, max_contacts=3, processes=1)
    assert proofs.agrees(shots).all()
    assert proofs.decided.mean() > 0.9
    valid = shots.outcome != engine.outcomes["INVALID"]
    assert np.sum(shots.uncertain & valid) < exceptions(0.02, count) + 2
    assert shots.counts[valid].sum() > occurrences(count // 20)


@pytest.mark.parametrize("which", ["hoop"])
@pytest.mark.filterwarnings("ignore::RuntimeWarning")
def test_absurd_values_harm_their_own_rows_alone(which: str, tmp_path: Path) -> None:
    engine, count = engine_of(SCENES[which], tmp_path), 200
    states, values = shots_for(count, 4)
    usual = engine.simulate(states, values, max_contacts=3, fields=CLAIMS)
    absurd = [np.nan, np.inf, -np.inf, 0.0, 1e300, -1e300, 1e-300, 5e-324, 1e18]
    bent = {name: value.copy() for name, value in values.items()}
    chance, rows = np.random.default_rng(5), np.arange(0, count, 2)
    for row in rows:
        for name in chance.choice(sorted(bent), 2, replace=False):
            bent[name][row] = chance.choice(absurd)
    # No direction at all, and bounds without a slope.
    for name in (*named("way"), *named("turn", 4)):
        bent[name][0] = 0.0
    for name in named("cut"):
        bent[name][2] = 0.0
    found = engine.simulate(states, bent, max_contacts=3, fields=CLAIMS)
    for name in CLAIMS:
        own, other = (np.asarray(getattr(shots, name))[1::2] for shots in (usual, found))
        assert own.tobytes() == other.tobytes(), name
    assert found.outcome[0] == engine.outcomes["INVALID"]
    proofs = hoopgen.certify(states[rows], {n: v[rows] for n, v in bent.items()}, scene=engine)
    wide = engine.simulate(states[rows], {n: v[rows] for n, v in bent.items()}, record=True)
    assert proofs.agrees(wide).all()


def test_the_reason_for_an_invalid_shot_names_bodies_and_parameters(tmp_path: Path) -> None:
    """A ball in a thin wall is in several of its faces, which are one body."""
    glass = Revolution("glass", profile=[(0, -0.3), ("open", -0.3), ("neck", 0), (0.2, 0.3)])
    sizes = [Parameter("open", 0.2), Parameter("neck", 0.1)]
    plain = SCENES["crate"]
    made = replace(
        plain, parameters=[*plain.parameters, *sizes], bodies=[replace(glass, within=CUT)]
    )
    engine = engine_of(replace(made, name="glasses"), tmp_path)

    def reasons(place: tuple[float, ...], **values: float) -> list[str]:
        given = {"cut_1": 0.0, "cut_2": 0.0, "cut_3": 0.0, "wide": 9.0, **values}
        return hoopgen.why_invalid([*place, *[0.0] * 6], given, scene=engine)

    slope = "the scene's glass_piece_2_slope has to be above 0"
    assert reasons((0, 0, 1), neck=0.25) == [f"parameter not allowed: neck 0.25; {slope}"]
    said = [f"parameter not allowed: open 0.09, neck 0.3, together; {slope}"]
    assert reasons((0, 0, 1), open=0.09, neck=0.3) == said
    assert reasons((0.15, 0, -0.3)) == ["inside the glass"]
    assert reasons((0.15, 0, -0.3), cut_1=1.0) == [""]
