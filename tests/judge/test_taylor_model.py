"""Taylor models of boxes of releases, against the judge's exact flights of releases in them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
import pytest

import hoopgen
from hoopgen.simulation.engine import Engine
from tests.helpers.effort import trials

pytest.importorskip("flint")
pytest.importorskip("sympy")

from flint import arb, ctx

from hoopgen.judge import flight, roots
from hoopgen.judge.flight import ProvedFlight, fly
from hoopgen.judge.formulas import formulas
from hoopgen.judge.roots import Undecided
from hoopgen.judge.taylor_model import TaylorModel, as_model
from tests.judge.test_release_box import THROW

VARIABLES = (1, 3, 5, 7)
"""The components y, vx, vz and wy have a width."""

NARROW, WIDE = 2e-5, 5e-4
"""Half the width of each, in its unit; the wider, the more does a missing term of second order
show."""


def in_bits(bits: int, engine: Engine, state: Sequence[Any]) -> ProvedFlight:
    """Return the proved part of a flight."""
    values = [float(v) for v in engine.table.inputs(dict(engine.parameters))]
    with ctx.workprec(bits):
        try:
            return fly(formulas(engine.scene), state, values, 40)
        except Undecided as undecided:
            flown: ProvedFlight = undecided.args[1]
            return flown


def models_of(state: Sequence[float], width: float) -> list[Any]:
    """Return a state of which some components are variables of a box."""
    found: list[Any] = [arb(component) for component in state]
    for index, k in enumerate(VARIABLES):
        ends = (arb(state[k]) + side * arb(width) for side in (-1, 1))
        found[k] = TaylorModel.variable(*ends, index)
    return found


def holds(number: Any, place: Sequence[float], exact: arb) -> bool:
    """Return whether an exact value is in a model at a place of its box."""
    model = as_model(number)
    value = model.centre
    for k, slope in enumerate(model.slopes):
        # The error set may be anywhere; a release has one place.
        value += slope * (arb(place[k]) if k < len(place) else arb(0, 1))
    return bool(value.overlaps(exact)) and bool(model.range.overlaps(exact))


def contacts_enclosed(engine: Engine, speeds: Sequence[float], width: float, seed: int = 5) -> int:
    """Return the number of contacts at which all exact states lie in their models.

    Raises
    ------
    AssertionError
        If one lies outside, or if a release meets other bodies than its box.
    """
    random = np.random.default_rng(seed)
    found = 0
    for speed in speeds:
        azimuth = random.uniform(-0.01, 0.01)
        state = hoopgen.release(**THROW | {"speed": speed, "azimuth": azimuth}).tolist()
        models = models_of(state, width)
        box = in_bits(64, engine, models)
        for corner in (False, False, True, True):
            place = np.round(random.uniform(-1, 1, len(VARIABLES)) * 64) / 64
            if corner:
                place = np.where(place < 0, -1.0, 1.0)
            own: list[Any] = [arb(component) for component in state]
            with ctx.workprec(256):
                for index, k in enumerate(VARIABLES):
                    own[k] = models[k].centre + models[k].slopes[index] * arb(place[index])
            exact = in_bits(256, engine, own)
            assert len(exact.events) >= len(box.events)
            for event, true in zip(box.events, exact.events, strict=False):
                assert event.surface == true.surface
                pairs = zip([*event.before, *event.after], [*true.before, *true.after], strict=True)
                assert all(holds(number, place.tolist(), value) for number, value in pairs)
                found += 1
    return found


@pytest.mark.slow
@pytest.mark.parametrize("engine", [hoopgen.HOOP, hoopgen.COURT], ids=["hoop", "court"])
def test_exact_states_lie_in_the_model_at_every_contact(engine: Engine) -> None:
    speeds = np.random.default_rng(2).uniform(6.9, 7.5, trials(30)).tolist()
    # On average more than one contact of each of the four releases is followed.
    assert contacts_enclosed(engine, speeds, NARROW) > 4 * len(speeds)
    assert contacts_enclosed(engine, speeds, WIDE) > len(speeds)


def drop_products(monkeypatch: pytest.MonkeyPatch) -> None:
    """Leave out the product of the linear parts, the remainder of a product."""
    right = TaylorModel.__mul__

    def wrong(self: TaylorModel, other: Any) -> TaylorModel:
        product = right(self, other)
        if isinstance(other, TaylorModel):
            product.centre = self.centre * other.centre
        return product

    monkeypatch.setattr(TaylorModel, "__mul__", wrong)


def drop_curvature(monkeypatch: pytest.MonkeyPatch) -> None:
    """Leave out Lagrange's remainder of a quotient or a root."""
    right = TaylorModel._smooth
    monkeypatch.setattr(
        TaylorModel,
        "_smooth",
        lambda self, value, slope, _, plain: right(self, value, slope, arb(0), plain),
    )


def drop_times_derivative(monkeypatch: pytest.MonkeyPatch) -> None:
    """Take the time of a contact as that of the middle of the box."""
    right = roots._newton

    def wrong(*arguments: Any) -> TaylorModel | None:
        found = right(*arguments)
        return None if found is None else TaylorModel(found.centre, (), found.range)

    monkeypatch.setattr(roots, "_newton", wrong)


def drop_errors(monkeypatch: pytest.MonkeyPatch) -> None:
    """Forget the error set after each contact."""
    right = flight.condensed

    def wrong(state: Sequence[Any], variables: int) -> list[Any]:
        found = map(as_model, right(state, variables))
        return [TaylorModel(m.centre, m.slopes[:variables], m.range) for m in found]

    monkeypatch.setattr(flight, "condensed", wrong)


@pytest.mark.parametrize(
    "fault", [drop_products, drop_curvature, drop_times_derivative, drop_errors]
)
def test_a_model_without_one_of_its_terms_is_found_out(
    fault: Callable[[pytest.MonkeyPatch], None], monkeypatch: pytest.MonkeyPatch
) -> None:
    speeds = np.random.default_rng(2).uniform(6.9, 7.5, 30).tolist()
    fault(monkeypatch)
    with pytest.raises((AssertionError, ValueError)):  # flint: an intersection that is empty
        contacts_enclosed(hoopgen.HOOP, speeds, WIDE)


@pytest.mark.parametrize(
    "function",
    [
        lambda x, y: x * y - y,
        lambda x, y: x * x + 3 * x,
        lambda x, y: x / y,
        lambda x, y: 1 / (x + y),
        lambda x, y: (x * x + y).sqrt(),
        lambda x, y: x.sin() * y.cos(),
        lambda x, y: abs(x) + abs(x - 2),
        lambda x, y: (x * y).hull(2 * y) if isinstance(x, TaylorModel) else x * y,
        lambda x, y: (x * y).hull(2 * y) if isinstance(x, TaylorModel) else 2 * y,
    ],
)
@pytest.mark.parametrize("width", [1e-9, 1e-3, 0.5])
def test_a_model_encloses_its_function(function: Callable[[Any, Any], Any], width: float) -> None:
    random = np.random.default_rng(1)
    middles = (arb(1.3), arb(2.2))
    x, y = (TaylorModel.variable(m - arb(width), m + arb(width), k) for k, m in enumerate(middles))
    model = function(x, y)
    for _ in range(200):
        place = np.round(random.uniform(-1, 1, 2) * 64) / 64
        with ctx.workprec(200):
            own = [m.centre + m.slopes[k] * arb(place[k]) for k, m in enumerate((x, y))]
            assert holds(model, place.tolist(), function(*own))


def test_a_model_is_off_by_the_square_of_the_width_alone() -> None:
    def left(width: float) -> float:
        x, y = (TaylorModel.variable(arb(1 - width), arb(1 + width), k) for k in range(2))
        model = (x * y).sqrt() / (x + y)
        return float(model.centre.rad() + sum((s.rad() for s in model.slopes), arb(0)))

    assert left(1e-2) < 1e-3
    assert left(1e-4) < left(1e-2) * 2e-4
