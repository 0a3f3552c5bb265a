"""Faults that are planted one at a time, each with the test that must notice it.

The test is one of the ordinary suite. It is called with the kernels, or the engine, of the
derivation that has the fault.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Hashable, Sequence
from contextlib import ExitStack
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import pytest
from hoopgen.derive import model
from hoopgen.derive.scenes.court import COURT
from hoopgen.derive.scenes.scene import Scene as Derived

from hoopgen.scene import Scene
from hoopgen.simulation.engine import Engine
from tests.helpers.derived import DerivedKernels, engine_of
from tests.helpers.mutants import Patch

Prepared = Callable[[], None]

_DERIVED: dict[Hashable, Any] = {}
"""The derivations that checks without a fault need, by their origin."""


@dataclass(frozen=True)
class Check:
    """A test that notices faults.

    Attributes
    ----------
    test
        A function of the test suite.
    given
        Its arguments, and those of further calls: all must pass.
    """

    test: Callable[..., None]
    given: tuple[tuple[Any, ...], ...] = ((),)

    @property
    def name(self) -> str:
        """The module and the name of the test."""
        return f"{self.test.__module__.removeprefix('tests.')}.{self.test.__name__}"

    @property
    def in_the_suite(self) -> bool:
        """Whether pytest runs the test with these very arguments, and with nothing derived anew."""
        return False

    @property
    def origin(self) -> Hashable:
        """The identity of the derivation that the test needs."""
        return None

    def derive(self, folder: Path) -> Any:
        """Derive what the test needs."""
        return None

    def run(self, derived: Any) -> None:
        """Run the test with what was derived."""
        raise NotImplementedError

    def prepare(self, folder: Path, patch: ExitStack) -> Prepared:
        """Derive what the test needs, while the fault is there; return what runs it without."""
        derived = self.derive(folder)
        patch.close()
        return lambda: self.run(derived)

    def _call(self, *first: Any) -> None:
        for arguments in self.given:
            self.test(*first, *arguments)


@dataclass(frozen=True)
class OfFormulas(Check):
    """A test that evaluates the derivation itself; the fault stays while it runs."""

    @property
    def in_the_suite(self) -> bool:
        """Whether pytest runs the test with these very arguments."""
        marks = [m for m in vars(self.test).get("pytestmark", ()) if m.name == "parametrize"]
        if len(marks) > 1 or not self.test.__name__.startswith("test_"):
            return False
        every = cases(self.test) if marks else ((),)
        return all(given in every for given in self.given)

    def run(self, derived: Any) -> None:
        """Run the test."""
        self._call()

    def prepare(self, folder: Path, patch: ExitStack) -> Prepared:
        """Return what runs the test."""
        return lambda: self.run(None)


@dataclass(frozen=True)
class WithKernels(Check):
    """A test whose first argument is the kernels of a scene.

    Attributes
    ----------
    scene
        The scene, by default the court.
    """

    scene: Derived = field(default=COURT, kw_only=True, repr=False)

    @property
    def origin(self) -> Hashable:
        """The scene's kernels."""
        return DerivedKernels, id(self.scene)

    def derive(self, folder: Path) -> DerivedKernels:
        """Derive the scene."""
        return DerivedKernels.from_scene(self.scene)

    def run(self, derived: Any) -> None:
        """Run the test with kernels of the scene."""
        self._call(derived)


@dataclass(frozen=True)
class OfKernels(WithKernels):
    """A test that calls the kernels of a scene in modules that it uses.

    Attributes
    ----------
    named
        The names of the generated module in the test's module, and in those that it uses.
    """

    named: tuple[tuple[str, str], ...] = ()

    def run(self, derived: Any) -> None:
        """Run the test with kernels of the scene in place of the generated ones."""
        with pytest.MonkeyPatch.context() as there:
            for module, name in self.named or ((self.test.__module__, "court"),):
                there.setattr(sys.modules[module], name, derived)
            self._call()


@dataclass(frozen=True, kw_only=True)
class OfEngine(Check):
    """A test whose first argument is the engine of a scene.

    Attributes
    ----------
    scene
        The scene.
    """

    scene: Scene | Any = field(repr=False)

    @property
    def origin(self) -> Hashable:
        """The scene."""
        return id(self.scene)

    def derive(self, folder: Path) -> Engine:
        """Derive and print the scene."""
        return engine_of(self.scene, folder)

    def run(self, derived: Any) -> None:
        """Run the test with the engine."""
        self._call(derived)


@dataclass(frozen=True)
class Planted:
    """A fault in the derivation, and the check that must notice it."""

    name: str
    patch: Patch
    check: Check


def tripping(faults: Sequence[Planted]) -> Callable[..., None]:
    """Return the test that each fault trips its check; what fails before the check is an error."""

    @pytest.mark.parametrize(
        "fault",
        [
            pytest.param(
                fault,
                id=f"{fault.name} ({fault.check.name})",
                marks=pytest.mark.slow if isinstance(fault.check, OfEngine) else (),
            )
            for fault in faults
        ],
    )
    @pytest.mark.sampled(1)
    def test(fault: Planted, tmp_path: Path) -> None:
        with ExitStack() as stack:
            patch = stack.enter_context(pytest.MonkeyPatch.context())
            # What it refuses is to be noticed elsewhere.
            patch.setattr(model, "check", lambda _: None)
            fault.patch(patch)
            prepared = fault.check.prepare(tmp_path, stack)
            with pytest.raises(AssertionError):
                prepared()

    return test


def passing(faults: Sequence[Planted]) -> Callable[..., None]:
    """Return the test that the checks of faults pass on the derivation as it is.

    It is made once for all checks that need it. Checks that pytest runs alike are left out.
    """
    checks = {id(fault.check): fault.check for fault in faults}.values()

    @pytest.mark.slow
    @pytest.mark.parametrize(
        "check",
        [check for check in checks if not check.in_the_suite],
        ids=lambda check: f"{check.name}",
    )
    def test(check: Check, tmp_path: Path) -> None:
        if check.origin not in _DERIVED:
            _DERIVED[check.origin] = check.derive(tmp_path)
        check.run(_DERIVED[check.origin])

    return test


def cases(test: Callable[..., None]) -> tuple[tuple[Any, ...], ...]:
    """Return the arguments of each case of a test that is parametrized once."""
    (mark,) = (mark for mark in vars(test)["pytestmark"] if mark.name == "parametrize")
    given = (getattr(case, "values", case) for case in mark.args[1])
    return tuple(case if isinstance(case, tuple) else (case,) for case in given)
