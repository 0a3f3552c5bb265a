"""The event loop as templates see it: printed for each target."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass

from hoopgen.derive.follow.fields import Field
from hoopgen.derive.follow.loop import Loop
from hoopgen.derive.ground.kernel import Kind
from hoopgen.derive.ground.symbols import STATE
from hoopgen.derive.ground.tree import Do, Node, live_before, needed, reads, writes

from .alone import Alone
from .apart import Apart
from .fixed import Fixed, Split
from .groups import Frame
from .lists import CLists
from .loop import CLoop, Note
from .numpy_loop import NumPyLoop, local
from .printers import NUMPY, C

STATE_NAMES = tuple(symbol.name for symbol in STATE)


@dataclass(frozen=True)
class LoopView:
    """What a template sees of the event loop.

    Attributes
    ----------
    name
        "bounded" where errors are bounded, else "plain".
    fields
        What a shot has.
    kinds
        What each of them is.
    kept
        Those that the next turn needs as this one left them; the others it assigns first.
    c
        The lines of C: `permit`, and `permitted`, where it is asked; `fixed` and `once` for a job,
        `admit`, and `follow`, what comes after those.
    c_fixed
        By array, how many rows there are of what kernels are given ready made.
    c_columns
        The columns that those need beside the fields, and what each holds.
    c_apart
        What they do in functions of their own.
    numpy
        The lines of each stage.
    columns
        By stage, the variables that NumPy reads, and those that it writes with their names.
    """

    name: str
    bounds: bool
    fields: tuple[Field, ...]
    kinds: dict[str, Kind]
    kept: tuple[str, ...]
    c: dict[str, list[str]]
    c_fixed: dict[str, int]
    c_columns: dict[str, Kind]
    c_apart: list[Apart]
    numpy: dict[str, list[str]]
    columns: dict[str, tuple[list[str], dict[str, str]]]


def loop_view(
    prefix: str,
    costs: Mapping[str, int],
    rows: Collection[str],
    alone: Alone,
    splits: Mapping[str, Split],
    loop: Loop,
    bounds: bool,
) -> LoopView:
    """Return the loop, printed.

    `rows` are the kernels that NumPy gives rows to write into; `alone` has its functions for one
    shot, and is given more; `splits` are the kernels that C gives what is ready made.
    """
    names = [field.name for field in loop.fields]
    available = {*names, *loop.parameters, *loop.job}
    stages = _after(loop, names)
    name = "bounded" if bounds else "plain"
    view = LoopView(
        name,
        bounds,
        loop.fields,
        loop.kinds,
        _kept(stages, names),
        *_in_c(prefix, name, costs, loop, stages, Fixed(splits)),
        {},
        {},
    )
    for stage, (nodes, after) in stages.items():
        short = {name for name, kind in loop.kinds.items() if kind == "single"}
        numpy = NumPyLoop(prefix, costs, NUMPY, rows=rows, alone=alone, short=short)
        touched = reads(nodes) | set(writes(nodes))
        read = sorted(live_before(nodes, after) & available & touched)
        names_after = numpy.stage(nodes, {name: local(name, 0) for name in read}, after)
        written = {n: names_after[n] for n in sorted(after & set(writes(nodes)) & set(names_after))}
        view.numpy[stage] = numpy.lines
        view.columns[stage] = (read, written)
        available |= set(written)
    return view


def _in_c(
    prefix: str,
    variant: str,
    costs: Mapping[str, int],
    loop: Loop,
    stages: Mapping[str, Stage],
    fixed: Fixed,
) -> tuple[dict[str, list[str]], dict[str, int], dict[str, Kind], list[Apart]]:
    """Return the lines of C, what they need beside the fields, and functions."""
    fields = loop.kinds
    permit = CLoop(prefix, costs, C)
    permitting = needed(stages["permit"][0], {"permitted"})
    permit.stage(permitting, dict.fromkeys(loop.parameters, "double"), "", {"permitted"})
    admit = CLists(
        prefix,
        costs,
        C,
        fixed=fixed,
        parameters=loop.parameters,
        job=loop.job,
        variant=variant,
        columns={"permitted": "double"},
    )
    measuring = [node for node in stages["permit"][0] if "measured" in writes([node])]
    permitted = Note(
        0,
        (
            "M permitted = lanes_less(K(0.0), lanes_load(lists->permitted + (i & varying)));",
            *(["V measured = lanes_load(lists->measured + (i & varying));"] if measuring else []),
        ),
        frozenset(),
        {"permitted": "truth", **({"measured": "double"} if measuring else {})},
    )
    admit.columns |= {"measured": "double"} if measuring else {}
    admit.passes(stages["admit"][0], Frame("", dict(fields), "fresh"), fields, permitted)
    (reach, _), (meet, _) = stages["reach"], stages["meet"]
    stored = "lanes_store(lists->body + i, body);"
    before = Note(
        len(reach),
        (
            *([stored] if loop.tallied else []),
            "if (recording) {",
            *([] if loop.tallied else [f"    {stored}"]),
            *(f"    lanes_store(lists->{s}_before + i, {s});" for s in STATE_NAMES),
            "}",
        ),
        frozenset((*STATE_NAMES, "body")),
    )
    follow = CLists(
        prefix,
        costs,
        C,
        counter=admit.counter,
        once=admit.once,
        fixed=fixed,
        parameters=loop.parameters,
        job=loop.job,
        variant=variant,
    )
    follow.beside = f"LANES({prefix}_ahead)(job, begun + i, streams);"
    follow.passes((*reach, *meet), Frame("", dict(fields)), set(fields), before)
    beside: dict[str, Kind] = {"body": "double", **admit.columns, **follow.columns}
    columns = {name: kind for name, kind in beside.items() if name not in fields}
    lines = {
        "permit": permit.lines,
        "permitted": _permitted(prefix, loop.parameters, measuring),
        "fixed": [
            *(f"const V {p} = lanes_load(lists->{p});" for p in fixed.reads(fixed.all)),
            *fixed.lines(fixed.all),
        ],
        "once": follow.once,
        "admit": admit.lines,
        "follow": follow.lines,
    }
    return lines, fixed.counts, columns, [*admit.apart, *follow.apart]


def _permitted(prefix: str, parameters: Iterable[str], measuring: Iterable[Node]) -> list[str]:
    """Return the lines that look at the parameters of a row of lanes, `row` being the first."""
    given = ", ".join(f"lanes_load(lists->{name} + row)" for name in parameters)
    permitted = f"lanes_select(LANES({prefix}_permit)({given}), K(1.0), K(0.0))"
    lines = [f"lanes_store(lists->permitted + row, {permitted});"]
    for node in measuring:
        assert isinstance(node, Do)
        sizes = ", ".join(f"lanes_load(lists->{value} + row)" for value in node.arguments)
        measured = f"LANES({prefix}_{node.kernel.name})({sizes}).measured"
        lines.append(f"lanes_store(lists->measured + row, {measured});")
    return lines


Stage = tuple[tuple[Node, ...], set[str]]
"""Its nodes, and the variables that are needed after it."""


def _kept(stages: Mapping[str, Stage], names: Sequence[str]) -> tuple[str, ...]:
    (reach, _), (meet, _) = stages["reach"], stages["meet"]
    needed_again = live_before((*reach, *meet), names)
    return tuple(name for name in names if name in needed_again)


def _after(loop: Loop, names: Sequence[str]) -> dict[str, Stage]:
    """Return each stage's nodes, and the variables that are needed after it."""
    wanted = {*names, "body"}
    found: dict[str, Stage] = {}
    for stage, nodes in reversed(list(loop.stages.items())):
        kept = needed(nodes, wanted)
        found[stage] = (kept, set(wanted))
        wanted = set(names) | live_before(kept, wanted)
    return dict(reversed(found.items()))
