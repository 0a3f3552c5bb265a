"""The cost of a program, in words and in additions."""

from __future__ import annotations

from collections.abc import Mapping

from .program import Operations

COST_WORDS = {
    "add": "additions",
    "sub": "subtractions",
    "mul": "multiplications",
    "div": "divisions",
    "sqrt": "square roots",
    "neg": "negations",
    "abs": "absolute values",
    "less": "comparisons",
    "at_most": "comparisons",
    "equal": "comparisons",
    "both": "conjunctions",
    "either": "disjunctions",
    "not": "complements",
    "select": "selections",
}

ADDITIONS = {"div": 8, "sqrt": 8}
"""Operations that take longer than one addition, and about how many they are worth."""


def weighted(cost: Mapping[str, int]) -> int:
    """Return about how long a kernel takes, in additions."""
    return sum(count * ADDITIONS.get(name, 1) for name, count in cost.items())


def describe_cost(program: Operations) -> str:
    """Return the operation count of a program as a sentence."""
    words: dict[str, int] = {}
    for name, count in program.cost.items():
        words[COST_WORDS[name]] = words.get(COST_WORDS[name], 0) + count
    total = sum(words.values())
    if not total:
        return "No operations."
    ordered = [w for w in dict.fromkeys(COST_WORDS.values()) if w in words]
    parts = [f"{words[w]} {w if words[w] > 1 else w.removesuffix('s')}" for w in ordered]
    return f"{total} operation{'s' * (total > 1)}: {', '.join(parts)}."
