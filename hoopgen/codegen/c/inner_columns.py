"""The columns that guarded bodies of a pass store and load themselves, for C.

What one body alone has to do with is not loaded for the lanes of all shots.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence, Set

from hoopgen.derive.ir.event_tree import If, Node, reads, writes


def columns_within(
    nodes: Sequence[Node], columns: Set[str], shared: Set[str], cheap: Callable[[If], bool]
) -> dict[int, dict[str, bool]]:
    """Return the columns that each guarded body stores, by the identity of its node.

    The value of a column is True if the body loads it, too. A rare body within another stores and
    loads those that it alone has to do with.

    Parameters
    ----------
    nodes
        The nodes of a pass.
    columns
        The columns that the pass stores.
    shared
        Those that something else reads.
    cheap
        Function that returns whether a body is executed for all lanes: then it has no columns.
    """
    found: dict[int, dict[str, bool]] = {}
    for node in nodes:
        if not isinstance(node, If) or cheap(node):
            continue
        own = _written_within(node, nodes, columns, shared)
        for rare in node.body:
            if isinstance(rare, If) and rare.rare:
                loaded = {name for name, only in own.items() if only}
                within = _written_within(rare, node.body, loaded, shared)
                found[id(rare)] = {name: True for name, only in within.items() if only}
                own = {name: only for name, only in own.items() if name not in found[id(rare)]}
        found[id(node)] = own
    return found


def _written_within(
    node: If, nodes: Iterable[Node], columns: Set[str], shared: Set[str]
) -> dict[str, bool]:
    """Return the columns that one guarded body alone writes of those nodes.

    The value is True if nothing else reads the column and it is not `shared`.
    """
    others = [other for other in nodes if other is not node]
    own = columns & set(writes(node.body)) - set(writes(others))
    elsewhere = reads(others) | shared | {node.truth}
    return {name: name not in elsewhere for name in sorted(own)}


def read_within(
    nodes: Sequence[Node], columns: Set[str], cheap: Callable[[If], bool]
) -> dict[int, list[str]]:
    """Return the columns that each rare body loads and does not store, by its node's identity.

    Parameters
    ----------
    nodes
        The nodes of a pass.
    columns
        The columns that nothing else than these nodes reads, and that they do not write.
    cheap
        As for `columns_within`.
    """
    rare = [node for node in nodes if isinstance(node, If) and node.rare and not cheap(node)]
    others = [node for node in nodes if node not in rare]
    own = columns - reads(others) - {node.truth for node in rare}
    return {id(node): sorted(own & reads(node.body)) for node in rare}
