"""Faults that are planted one at a time, each with the test that must notice it.

The test is one of the ordinary suite. It is called with the kernels, or the engine, of the
derivation that has the fault.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Sequence
from contextlib import ExitStack
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import pytest
from hoopgen.derive import model
from hoopgen.derive.scenes.court import COURT

from hoopgen.scene import Scene
from tests.helpers.derived import DerivedKernels, engine_of
from tests.helpers.mutants import Patch

Prepared = Callable[[], None]


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

    def prepare(self, folder: Path, patch: ExitStack) -> Prepared:
        """Derive what the test needs, while the fault is there; return what runs it."""
        raise NotImplementedError


@dataclass(frozen=True)
class OfFormulas(Check):
    """A test that evaluates the derivation itself; the fault stays while it runs."""

    def prepare(self, folder: Path, patch: ExitStack) -> Prepared:
        """Return what runs the test."""
        return lambda: self._run(())

    def _run(self, first: tuple[Any, ...]) -> None:
        for arguments in self.given:
            self.test(*first, *arguments)


@dataclass(frozen=True)
class OfKernels(OfFormulas):
    """A test that calls the kernels of the court.

    Attributes
    ----------
    named
        The names of the generated module in the test's module, and in those that it uses.
    """

    named: tuple[tuple[str, str], ...] = ()

    def prepare(self, folder: Path, patch: ExitStack) -> Prepared:
        """Derive the court; return what runs the test with its kernels."""
        kernels = DerivedKernels.from_scene(COURT)
        patch.close()

        def run() -> None:
            with pytest.MonkeyPatch.context() as there:
                for module, name in self.named or ((self.test.__module__, "court"),):
                    there.setattr(sys.modules[module], name, kernels)
                self._run(())

        return run


@dataclass(frozen=True)
class WithKernels(OfFormulas):
    """A test whose first argument is the kernels of the court."""

    def prepare(self, folder: Path, patch: ExitStack) -> Prepared:
        """Derive the court; return what runs the test with its kernels."""
        kernels = DerivedKernels.from_scene(COURT)
        patch.close()
        return lambda: self._run((kernels,))


@dataclass(frozen=True, kw_only=True)
class OfEngine(OfFormulas):
    """A test whose first argument is the engine of a scene.

    Attributes
    ----------
    scene
        The scene.
    """

    scene: Scene | Any = field(repr=False)

    def prepare(self, folder: Path, patch: ExitStack) -> Prepared:
        """Derive and print the scene; return what runs the test with its engine."""
        engine = engine_of(self.scene, folder)
        patch.close()
        return lambda: self._run((engine,))


@dataclass(frozen=True)
class Planted:
    """A fault in the derivation, and the check that must notice it."""

    name: str
    patch: Patch
    check: Check


def noticed(planted: Planted, folder: Path) -> None:
    """Plant a fault, and demand that its check fails; what fails before that is an error."""
    with ExitStack() as stack:
        patch = stack.enter_context(pytest.MonkeyPatch.context())
        patch.setattr(model, "check", lambda _: None)  # what it refuses is to be noticed elsewhere
        planted.patch(patch)
        prepared = planted.check.prepare(folder, stack)
        with pytest.raises(AssertionError):
            prepared()


def passes(check: Check, folder: Path) -> None:
    """Run a check on the derivation as it is."""
    with ExitStack() as stack:
        check.prepare(folder, stack)()


def checks_of(faults: Sequence[Planted]) -> list[Check]:
    """Return the checks of some faults, each once."""
    return list({id(fault.check): fault.check for fault in faults}.values())


def cases(test: Callable[..., None]) -> tuple[tuple[Any, ...], ...]:
    """Return the arguments of each case of a test that is parametrized once."""
    (mark,) = (mark for mark in vars(test)["pytestmark"] if mark.name == "parametrize")
    return tuple(tuple(getattr(case, "values", case)) for case in mark.args[1])
