"""Which bodies stand together: groups of a few, and groups of groups, by where they usually are.

Any grouping serves: a flight that is apart from a group is apart from all that are in it
(`far.py`). A good one has small boxes far from each other.
"""

from __future__ import annotations

from collections.abc import Sequence

from ..ground.tree import Group

MOST = 8
"""Bodies of the smallest groups, and groups in one; at the most."""

FEWEST = 2 * MOST
"""So many bodies are worth groups."""

Box = Sequence[tuple[float, float]]
"""From where to where, along each axis along which it has ends."""


def grouped(boxes: Sequence[Box]) -> tuple[list[int], tuple[Group, ...]]:
    """Return bodies by groups: their indices in the order of the groups' rows, and the groups."""
    order: list[int] = []
    groups: list[Group] = []
    for part in _parts(boxes, list(range(len(boxes)))):
        _add(boxes, part, order, groups)
    return order, tuple(groups)


def _add(boxes: Sequence[Box], own: list[int], order: list[int], groups: list[Group]) -> None:
    """Append a group, with all that is in it."""
    place, first = len(groups), len(order)
    groups.append(Group(0, 0, 0))
    if len(own) > MOST:
        for part in _parts(boxes, own):
            _add(boxes, part, order, groups)
    else:
        order += own
    groups[place] = Group(first, len(order), len(groups))


def _parts(boxes: Sequence[Box], own: list[int]) -> list[list[int]]:
    """Return bodies in a few parts, each in the order of the indices."""
    parts = [own]
    while len(parts) < MOST and len(largest := max(parts, key=len)) > MOST:
        parts.remove(largest)
        parts += _halves(boxes, largest)
    return sorted(map(sorted, parts))


def _halves(boxes: Sequence[Box], own: list[int]) -> tuple[list[int], list[int]]:
    """Return two parts of bodies: of all cuts across an axis the one that leaves least to look at.

    That is the length of the edges of a part's box, which a flight is likely to meet in proportion,
    times the bodies in it.
    """
    cuts: list[tuple[float, int, int]] = []
    ranks = [sorted(own, key=lambda k: (sum(boxes[k][axis]), k)) for axis in range(len(boxes[0]))]
    for axis, ranked in enumerate(ranks):
        below, above = _edges(boxes, ranked), _edges(boxes, ranked[::-1])[::-1]
        for cut in range(1, len(own)):
            cost = below[cut - 1] * cut + above[cut] * (len(own) - cut)
            cuts.append((cost, abs(2 * cut - len(own)), axis * len(own) + cut))
    axis, cut = divmod(min(cuts)[2], len(own))
    return ranks[axis][:cut], ranks[axis][cut:]


def _edges(boxes: Sequence[Box], ranked: Sequence[int]) -> list[float]:
    """Return the edges' length of the box of the first body, of the first two, and so on."""
    ends = [list(side) for side in boxes[ranked[0]]]
    found = []
    for k in ranked:
        for side, (low, high) in zip(ends, boxes[k], strict=True):
            side[0], side[1] = min(side[0], low), max(side[1], high)
        found.append(sum(high - low for low, high in ends))
    return found
