"""Pictures of proved boxes: which part has which colour, and the key."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

pytest.importorskip("matplotlib")
pytest.importorskip("flint")
pytest.importorskip("sympy")

from matplotlib.collections import PolyCollection
from matplotlib.colors import to_hex
from matplotlib.figure import Figure

from hoopgen import Outcome
from hoopgen.judge import UNDECIDED, BoxProof
from hoopgen.plots.class_legend import outcome_classes
from hoopgen.plots.proved_box import plot_box
from hoopgen.plots.style import GRID

NAMES = tuple(one.name.lower() for one in Outcome)
ANGLE = float(np.radians(50))
PROOF = BoxProof(
    proved=False,
    outcome="made",
    sequence=(),
    share=0.5,
    counterexample=None,
    question="it is not decided",
    variables=("speed", "elevation"),
    low=np.array([[7.0, ANGLE], [7.2, ANGLE], [7.2, ANGLE + 0.1]]),
    high=np.array([[7.2, ANGLE + 0.2], [7.4, ANGLE + 0.1], [7.4, ANGLE + 0.2]]),
    outcomes=np.array([Outcome.MADE, Outcome.MISSED, UNDECIDED], np.uint8),
    alike=np.array([True, False, False]),
    names=NAMES,
)


def test_each_part_has_the_colour_of_its_outcome_in_the_units_shown() -> None:
    (axes,) = plot_box(PROOF).axes
    drawn = [one for one in axes.collections if isinstance(one, PolyCollection)]
    colours = [to_hex(one.get_facecolor()[0]) for one in drawn]
    made, missed = (one.colour.lower() for one in outcome_classes(NAMES)[:2])
    assert colours == [made, missed, GRID.lower()]
    for part, one in enumerate(drawn):
        (path,) = one.get_paths()
        ends = path.get_extents().get_points()
        low, high = PROOF.low[part], PROOF.high[part]
        want = [[low[0], np.degrees(low[1])], [high[0], np.degrees(high[1])]]
        np.testing.assert_allclose(ends, want, rtol=1e-12, atol=0)
    assert axes.get_xlabel().endswith("(m/s)")
    assert axes.get_ylabel().endswith("(°)")
    words = [text.get_text() for text in axes.get_legend().get_texts()]
    assert words == ["made, 50.0%", "missed, 25.0%", "not proved, 25.0%"]


def test_a_proof_draws_itself_on_given_axes() -> None:
    axes = Figure().add_subplot()
    assert PROOF.plot(ax=axes, title="Mine") is axes
    assert axes.get_title(loc="left") == "Mine"
    states = replace(PROOF, variables=("vx", "vz")).plot()
    assert states.axes[0].get_xlabel() == "vx (m/s)"


@pytest.mark.parametrize("names", [(), ("speed",), ("speed", "elevation", "azimuth")])
def test_a_box_of_other_than_two_variables_is_refused(names: tuple[str, ...]) -> None:
    proof = replace(PROOF, variables=names)
    with pytest.raises(ValueError, match="proof: expected a box of two variables with a width"):
        plot_box(proof)
