"""Deliberate faults in arcs of surfaces of revolution: each trips a test by name."""

from __future__ import annotations

import pytest
from hoopgen.derive.events.arc import ArcRootFinder
from hoopgen.derive.events.polynomial import PolynomialRootFinder
from hoopgen.derive.surfaces import RevolvedArc

pytest.importorskip("flint")

from hoopgen.scene.revolution_faces import _Faces
from tests.derive.events import test_arc_margins
from tests.helpers.checked_faults import OfEngine, OfFormulas, Planted, passing, tripping
from tests.helpers.mutants import in_text
from tests.scene import test_arcs
from tests.scene.test_arcs import SCENES

pytestmark = [pytest.mark.xdist_group("arc_mutations"), pytest.mark.slow]

margin = OfFormulas(
    test_arc_margins.test_the_margin_of_an_arc_contains_errors_of_places_and_roundings
)
roundings = OfFormulas(test_arc_margins.test_the_roundings_of_a_root_are_within_their_bound)
turn = OfFormulas(test_arcs.test_the_normal_of_an_arc_turns_no_faster_than_its_bound)
invalid = {
    which: OfEngine(test_arcs.check_invalid, given=((which,),), scene=SCENES[which])
    for which in test_arcs.INVALID
}
sides = {
    which: OfEngine(test_arcs.check_sides, given=((SCENES[which],),), scene=SCENES[which])
    for which in ("globe", "lemon")
}
integrator = {
    which: OfEngine(test_arcs.check_integrator, given=((SCENES[which],),), scene=SCENES[which])
    for which in ("bowl", "bottle", "lemon", "crescent")
}

FAULTS = (
    Planted(
        "the mirror image of an arc is a part of it",
        in_text(RevolvedArc, "images", "not self.meets_axis", "True"),
        integrator["lemon"],
    ),
    Planted(
        "a wall on the other side of its centre is not in its box",
        in_text(
            RevolvedArc, "half_sizes", "self.offset_sign * self.offset + self.radius", "self.radius"
        ),
        integrator["crescent"],
    ),
    Planted(
        "the box of a wall is no wider than it is long",
        in_text(RevolvedArc, "half_sizes", "abs(u) == 1", "True"),
        integrator["crescent"],
    ),
    Planted(
        "an arc of more than half a circle ends where either of its bounds does",
        in_text(_Faces, "_ends", "- barrier(absolute(", "+ barrier(absolute("),
        integrator["crescent"],
    ),
    Planted(
        "an arc ends where only one of its bounds does",
        in_text(_Faces, "_ends", "line.long", "True"),
        integrator["bottle"],
    ),
    Planted(
        "nothing is beyond the end of an arc",
        in_text(_Faces, "_beyond", "vertex == line.end", "0"),
        integrator["bottle"],
    ),
    Planted(
        "a sphere that reaches the axis has a bound there with the sign of the other end",
        in_text(_Faces, "_ends", "if not none", "if none"),
        integrator["bowl"],
    ),
    Planted(
        "a closed sphere is no thin wall",
        in_text(_Faces, "_ends", "return (-self._ball,)", "return ()"),
        sides["globe"],
    ),
    Planted(
        "behind the side of an arc there is no free space",
        in_text(_Faces, "_arc", "**sides,\n", '**(sides | {"reach": None}),\n'),
        sides["lemon"],
    ),
    Planted(
        "an arc has no hollow side",
        in_text(_Faces, "_arc", "2 if line.hollow else 1", "1"),
        integrator["crescent"],
    ),
    Planted(
        "an arc may bend to the other side",
        in_text(_Faces, "_arc_requirements", 'yield sizes["bend"]', "yield radius"),
        invalid["band"],
    ),
    Planted(
        "the centre of an arc may be on the other side of the axis",
        in_text(_Faces, "_arc_requirements", "arc.offset_sign * offset", "offset**2 / radius"),
        invalid["leaning"],
    ),
    Planted(
        "an arc may be longer or shorter than half a circle",
        in_text(_Faces, "_arc_requirements", "* ahead + slack", "* 0 + radius"),
        invalid["leaning"],
    ),
    Planted(
        "the normal of an arc does not turn around the axis",
        in_text(RevolvedArc, "curvature", "1 / self._rho + ", ""),
        turn,
    ),
    Planted(
        "the condition of an arc is smaller than it is",
        in_text(ArcRootFinder, "_gap_rounding", "6 * size", "size / 8"),
        margin,
    ),
    Planted(
        "a sum of squares has no error",
        in_text(ArcRootFinder, "_gap_rounding", "least)), error)", "least)), sp.Integer(0))"),
        margin,
    ),
    Planted(
        "a sum of squares has no roundings at a contact",
        in_text(
            PolynomialRootFinder, "_small", "barrier(rounding(own, sizes).error)", "sp.Integer(0)"
        ),
        roundings,
    ),
)

test_without_a_fault_every_check_passes = passing(FAULTS)
test_a_fault_trips_its_check = tripping(FAULTS)
