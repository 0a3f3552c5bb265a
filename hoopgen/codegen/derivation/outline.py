"""The event loop as an outline: every node of its tree once, in words and links."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

from hoopgen.derive.follow.loop import Loop
from hoopgen.derive.ground.symbols import variable
from hoopgen.derive.ground.tree import Do, Each, Guard, Node

STAGES = {
    "permit": "once for the parameters",
    "admit": "once for a release",
    "reach": "to the next event; with `meet`, until the shot has an outcome",
    "meet": "what the event does to the ball",
}
"""When each stage is done."""


def outline(loop: Loop, shown: Callable[[str], str]) -> str:
    """Return the loop as nested lists in Markdown.

    Parameters
    ----------
    loop
        What is printed.
    shown
        How a kernel's name is shown, such as a link.
    """
    lines: list[str] = []
    for stage, nodes in loop.stages.items():
        lines += [f"- **{stage}**, {STAGES[stage]}", *_nodes(nodes, shown, "  ")]
    return "\n".join(lines)


def _nodes(nodes: Sequence[Node], shown: Callable[[str], str], indent: str) -> Iterator[str]:
    for node in nodes:
        if isinstance(node, Do):
            yield f"{indent}- {shown(node.kernel.name)}{_wiring(node)}"
            continue
        if isinstance(node, Guard):
            yield f"{indent}- where `{node.truth}`"
        elif isinstance(node, Each):
            names = ", ".join(f"`{name}`" for name in node.names)
            yield f"{indent}- for {names} of each row:"
            for row in node.rows:
                yield f"{indent}  - {', '.join(map(_value, row))}"
            yield f"{indent}- the following"
        else:
            yield f"{indent}- as long as `{node.truth}`, at most {node.limit} times"
        yield from _nodes(node.body, shown, f"{indent}  ")


def _wiring(node: Do) -> str:
    """Say which arguments and results are not the variables of their own names."""
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
