"""Lowering of the event loop to statements: the part that all targets share."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from hoopgen.derive.ir import event_tree as ir
from hoopgen.derive.ir.event_tree import Node, live_in_body, walk, writes


@dataclass(frozen=True)
class Scope:
    """The variables that a guarded body shares with the statements around it.

    Attributes
    ----------
    takes
        The variables around it whose values it needs, in order of their names.
    gives
        Those that it assigns and that are needed after it.
    keeps
        Those that a repeated body needs again in its next turn.
    """

    takes: tuple[str, ...]
    gives: tuple[str, ...]
    keeps: tuple[str, ...]


def carried(node: ir.ForEach, after: Iterable[str]) -> set[str]:
    """Return the variables that are live where a body for each row ends: after it, or in the next.

    What it assigns of that is the same variable from row to row.

    Parameters
    ----------
    node
        The node that has the body.
    after
        The variables that are live after the node.
    """
    return set(after) | live_in_body(node, after)


def repeats(node: Node) -> bool:
    """Return whether a body iterates, or a part of it does, which lasts for few shots."""
    return any(isinstance(n, ir.While) for n in walk([node]))


def scope(node: ir.If | ir.While, after: Iterable[str]) -> Scope:
    """Return the scope of a guarded body, given the variables that are live after it.

    Parameters
    ----------
    node, after
        As for `carried`.
    """
    assigned = set(writes(node.body))
    gives = assigned & set(after)
    takes = live_in_body(node, gives)
    keeps: set[str] = set()
    if isinstance(node, ir.While):
        takes |= {node.truth}
        keeps = assigned & takes
    return Scope(*(tuple(sorted(names)) for names in (takes, gives, keeps)))


@dataclass
class Lowering:
    """The lowering of nodes that all targets share.

    Attributes
    ----------
    prefix
        The name of the scene.
    costs
        About how long each kernel takes, in additions.
    max_inline_cost
        A body that costs no more is done for all shots: to skip it would cost as much.
    """

    prefix: str
    costs: Mapping[str, int]
    max_inline_cost: int
    counter: int = 0

    def fresh(self, letter: str) -> str:
        """Return a name that is not in use."""
        self.counter += 1
        return f"_{letter}{self.counter}"

    def cheap(self, node: ir.If) -> bool:
        """Return whether executing a body for all shots costs less than skipping it for some."""
        if node.rare or not all(isinstance(n, ir.Call) for n in node.body):
            return False
        return self._cost(node) <= self.max_inline_cost

    def _cost(self, node: ir.If) -> int:
        return sum(self.costs[n.kernel.name] for n in node.body if isinstance(n, ir.Call))
