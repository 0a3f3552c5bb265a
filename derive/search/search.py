"""What a search is: kernels of a surface along a flight, and what the event loop does with them."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterator, Mapping
from dataclasses import dataclass

import sympy as sp

from ..ground.kernel import Kernel
from ..ground.symbols import variable
from ..ground.tree import Do, Node
from ..surfaces import Surface
from .decisions import KERNELS

Parts = Mapping[str, Kernel]

Formula = tuple[Mapping[str, sp.Basic], str, str]
"""The outputs of a kernel, its summary, and the equation it implements."""


@dataclass(frozen=True)
class Search(ABC):
    """How the arrivals on a surface are found; times since the last contact."""

    surface: Surface
    gravity: sp.Expr

    @property
    @abstractmethod
    def formulas(self) -> dict[str, Formula]:
        """The kernels that it needs of the surface, by part."""

    @property
    def decisions(self) -> dict[str, Kernel]:
        """The decisions that it needs of the surface, by part."""
        return {}

    @property
    def constants(self) -> tuple[sp.Symbol, ...]:
        """Symbols of its own that its kernels pass to each other."""
        return ()

    @property
    def closed(self) -> bool:
        """True if its only arrival is a closed form: such surfaces are looked at first."""
        return False

    @abstractmethod
    def nodes(self, common: Parts, own: Parts, index: int) -> Iterator[Node]:
        """Propose the first arrival on the surface of that index."""


def proposed(index: int) -> Iterator[Node]:
    """Take an arrival that is earlier than those found so far."""
    yield Do(KERNELS["tied"])
    yield Do(KERNELS["sooner"], {"index": index})


def given(kernel: Kernel, **inputs: str | float) -> Do:
    """Return the evaluation of a kernel, given those of the inputs that it takes."""
    names = set(map(variable, kernel.arguments))
    return Do(kernel, {name: value for name, value in inputs.items() if name in names})
