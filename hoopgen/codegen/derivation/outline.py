"""The event loop as an outline: every node of its tree once, in words and links."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from hoopgen.derive.ir.event_tree import Call, ForEach, If, Node
from hoopgen.derive.loop.loop import Loop
from hoopgen.derive.symbolic.symbols import variable

STAGES = {
    "validate": "once for the parameters",
    "start": "once for a release",
    "detect": "to the next event; with `resolve`, until the shot has an outcome",
    "resolve": "what the event does to the ball",
    "review": "once for a shot that has ended",
}
"""Time at which each stage is executed."""


def outline(loop: Loop, links: Mapping[str, str]) -> str:
    """Return the loop as nested lists in Markdown.

    Parameters
    ----------
    loop
        The event loop.
    links
        By a kernel's name, its text, such as a link.
    """
    lines: list[str] = []
    for stage, nodes in loop.stages.items():
        lines += [f"- **{stage}**, {STAGES[stage]}", *_nodes(nodes, links, "  ")]
    return "\n".join(lines)


def _nodes(nodes: Sequence[Node], links: Mapping[str, str], indent: str) -> Iterator[str]:
    for node in nodes:
        if isinstance(node, Call):
            yield f"{indent}- {links[node.kernel.name]}{_wiring(node)}"
            continue
        if isinstance(node, If):
            yield f"{indent}- where `{node.truth}`"
        elif isinstance(node, ForEach):
            names = ", ".join(f"`{name}`" for name in node.names)
            yield f"{indent}- for {names} of each row:"
            for row in node.rows:
                yield f"{indent}  - {', '.join(map(_value, row))}"
            yield f"{indent}- the following"
        else:
            yield f"{indent}- as long as `{node.truth}`, at most {node.limit} times"
        yield from _nodes(node.body, links, f"{indent}  ")


def _wiring(node: Call) -> str:
    """Return the arguments and results that are not the variables of their own names."""
    names = [variable(argument) for argument in node.kernel.arguments]
    given = [
        f"`{name}` = {_value(value)}"
        for name, value in zip(names, node.arguments, strict=True)
        if value != name
    ]
    taken = [f"`{own}` → `{name}`" for own, name in node.assigned.items() if own != name]
    parts = (["with " + ", ".join(given)] if given else []) + ([", ".join(taken)] if taken else [])
    return f": {'; '.join(parts)}" if parts else ""


def _value(value: str | float) -> str:
    return f"`{value}`" if isinstance(value, str) else f"{value:g}"
