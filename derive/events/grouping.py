"""Groups of adjacent bodies, and groups of groups, by their boxes at the usual parameters.

Every grouping is correct: a flight that is apart from a group is apart from all of its members
(`bounding_boxes.py`). A good one has small boxes far from each other.
"""

from __future__ import annotations

from collections.abc import Sequence

from ..ir.event_tree import Group

MAX_GROUP_SIZE = 8
"""Largest number of bodies in the smallest groups, and of groups in a larger one."""

MIN_GROUPED_BODIES = 2 * MAX_GROUP_SIZE
"""Fewest bodies for which groups pay."""

Box = Sequence[tuple[float, float]]
"""Lower and upper end along each axis that bounds the body."""


def group_bodies(boxes: Sequence[Box]) -> tuple[list[int], tuple[Group, ...]]:
    """Return the bodies in the order of the groups' rows, and the groups."""
    order: list[int] = []
    groups: list[Group] = []
    for part in _parts(boxes, list(range(len(boxes)))):
        _add(boxes, part, order, groups)
    return order, tuple(groups)


def _add(boxes: Sequence[Box], own: list[int], order: list[int], groups: list[Group]) -> None:
    """Append a group and all its parts."""
    place, first = len(groups), len(order)
    groups.append(Group(0, 0, 0))
    if len(own) > MAX_GROUP_SIZE:
        for part in _parts(boxes, own):
            _add(boxes, part, order, groups)
    else:
        order += own
    groups[place] = Group(first, len(order), len(groups))


def _parts(boxes: Sequence[Box], own: list[int]) -> list[list[int]]:
    """Return bodies in a few parts, each in the order of the indices."""
    parts = [own]
    while len(parts) < MAX_GROUP_SIZE and len(largest := max(parts, key=len)) > MAX_GROUP_SIZE:
        parts.remove(largest)
        parts += _halves(boxes, largest)
    return sorted(map(sorted, parts))


def _halves(boxes: Sequence[Box], own: list[int]) -> tuple[list[int], list[int]]:
    """Return the two parts of the cheapest cut across an axis.

    The cost of a part is the sum of the edges of its box, to which the probability of a hit is
    about proportional, times the number of its bodies.
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
    """Return the sum of the edges of the box of the first body, of the first two, and so on."""
    ends = [list(side) for side in boxes[ranked[0]]]
    found = []
    for k in ranked:
        for side, (low, high) in zip(ends, boxes[k], strict=True):
            side[0], side[1] = min(side[0], low), max(side[1], high)
        found.append(sum(high - low for low, high in ends))
    return found
