"""The launch of a shot that touches nothing: its stages from the release to the end, once each."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace

from ..ir.event_tree import UNPROVED, Call, ForEach, If, Node, given_as
from ..ir.kernel import decision
from ..symbolic.conditionals import Not, false
from ..symbolic.symbols import STATE

SIZE = "state_size"
"""The variable that is at least as large as each component of the states of some shots."""

REFUSED = "refused"
"""The variable that is true for a shot that may touch something."""

_NEVER = frozenset({"in_contact", "hopped"})
"""Guards that no new shot passes: its ball is in flight, and has not left a surface."""

_REFUSAL = Call(decision(REFUSED, {REFUSED: Not(false)}, "Whether a shot may touch something."))
"""The body of the guards that a shot may pass only if it may touch something."""


def launched(nodes: Iterable[Node]) -> tuple[Node, ...]:
    """Return a stage for shots that touch nothing, in which the others are refused.

    A guarded body that decides anything itself, such as a search or a contact, is for shots that
    come near a surface: a shot that enters it is refused. So is one that is in contact. A state is
    in range if all of its components are small enough, so one number that is as large as each of
    them shows it.
    """
    return tuple(step for node in nodes for step in _shortened(_launched(node)))


def _shortened(node: Node) -> Iterator[Node]:
    """Take the shortcut of an evaluation first, and evaluate the kernel where it does not suffice.

    Of new shots, unlike others, nearly all take the shortcut.
    """
    if isinstance(node, Call) and node.shortcut:
        yield from node.shortcut
        node = If(UNPROVED, (node,), rare=True)
    yield node


def _launched(node: Node) -> Node:
    if isinstance(node, Call):
        if node.kernel.name != "state_in_range":
            return node
        return given_as(node, {symbol.name: SIZE for symbol in STATE})
    never = not isinstance(node, ForEach) and node.truth in _NEVER
    plain = not never and all(isinstance(inner, Call) for inner in node.body)
    return node if plain else replace(node, body=(_REFUSAL,))
