"""The page on the cost of bodies: what it times is done."""

from __future__ import annotations

import pytest

for _library in ("flint", "matplotlib", "scipy", "sympy"):
    pytest.importorskip(_library)

from benchmarks import bodies  # noqa: E402
from hoopgen.scene import compilers  # noqa: E402

pytestmark = pytest.mark.skipif(compilers.compiler() is None, reason="no C compiler")


@pytest.mark.slow
def test_a_scene_is_derived_and_compiled() -> None:
    derived, compiled, size = bodies.making_costs(bodies.spheres(1))
    assert derived > 0
    assert compiled > 0
    assert size > 50


@pytest.mark.slow
def test_a_compiler_that_fails_costs_nothing_but_is_an_error(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setenv("CC", "false")
    with pytest.raises(RuntimeError, match="does not compile pins_1_0"):
        bodies.making_costs(bodies.spheres(1))
