"""The event loop and the kernels as the templates of C see them."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

from hoopgen.derive.ir import event_tree as ir
from hoopgen.derive.ir.event_tree import Node, live_before, needed, writes
from hoopgen.derive.ir.kernel import Kind
from hoopgen.derive.loop.loop import REVIEW, Loop
from hoopgen.derive.state.fields import ResultField
from hoopgen.derive.symbolic.conditionals import Boolean
from hoopgen.derive.symbolic.symbols import STATE

from ..backend import KernelView, LoweredScene
from ..cost import describe_cost
from ..hoisting import PartialEvaluation
from ..identifiers import identifier
from ..program import Program
from ..rerolling import parameter_kernels, rerolled
from ..statements import (
    Apply,
    Column,
    Declare,
    Execute,
    Function,
    If,
    Infix,
    Member,
    Name,
    Statement,
)
from ..straight_line import PrintedBody, print_body, straight_line
from ..variants import Variant
from .compaction import CompactedLoop, Insertion
from .formatter import C_FORMATTER
from .hierarchy import GroupContext
from .hoisted import Hoisted
from .launch import LaunchLoop
from .masked_loop import MaskedLoop, Statements
from .options import Options
from .spelling import (
    LANES,
    SINGLES,
    TYPES,
    at,
    column_of,
    function,
    load,
    offset,
    parameter_of_row,
    store,
)

STATE_NAMES = tuple(symbol.name for symbol in STATE)


@dataclass(frozen=True)
class CKernel(KernelView):
    """A kernel in C.

    Attributes
    ----------
    evaluation
        Its loop invariant part and the rest, if it has one.
    numbers
        By name, the numbers of the scene's parameters, if it is given all as columns.
    """

    types = TYPES
    evaluation: PartialEvaluation | None
    numbers: Mapping[str, int] = field(default_factory=dict)

    @property
    def rest(self) -> Program:
        """The program that the kernel evaluates itself, without hoisted operations."""
        return self.evaluation.rest if self.evaluation else self.program

    @property
    def body(self) -> PrintedBody:
        """Its statements and results."""
        if self.numbers:
            return print_body(
                rerolled(self.program, self.numbers, LANES, parameter_of_row), C_FORMATTER
            )
        return print_body(straight_line(self.rest, SINGLES if self.single else LANES), C_FORMATTER)

    @property
    def cost(self) -> str:
        """Its operation count, as a sentence."""
        return describe_cost(self.rest)

    @property
    def parameters(self) -> list[str]:
        """Its parameters, each with its type."""
        arguments, number = self.program.kernel.arguments, "S" if self.single else "V"
        own, given = self.evaluation, range(0)
        if self.numbers:
            arguments = tuple(a for a in arguments if identifier(a) not in self.numbers)
        kept: Sequence[int] = range(len(arguments))
        if own is not None:
            kept, given = own.kept_arguments, range(len(own.loop_invariant))
        found = [
            f"{'M' if isinstance(a, Boolean) else number} {identifier(a)}"
            for a in (arguments[k] for k in kept)
        ]
        columns = ["const LANES(column) *p", "size_t row"] if self.numbers else []
        return columns + found + [f"{number} _c{k}" for k in given]


@dataclass(frozen=True)
class CVariant:
    """A variant of the event loop in C.

    Attributes
    ----------
    parts
        `validate`, and `permitted`, where it is asked; `fixed` and `once` for a job; of
        shots that touch nothing `launch`, and `launching` before it; `start`, and `follow`, what
        comes after that; `review` of those that have ended.
    columns
        The columns that those need beside the fields, and what each holds.
    parameter_lists
        The prefixes of the lists that have columns for parameters.
    functions
        What they do in functions of their own.
    reported
        Fields that only results need, by the C condition that one of these is requested.
    """

    variant: Variant
    parts: Mapping[str, Sequence[Statement]] = field(repr=False)
    columns: Mapping[str, Kind]
    parameter_lists: Sequence[str]
    functions: Sequence[Function] = field(repr=False)
    reported: Mapping[str, Sequence[str]] = field(default_factory=dict)

    @cached_property
    def lines(self) -> dict[str, list[str]]:
        """The lines of each part."""
        return {name: C_FORMATTER.lines(statements) for name, statements in self.parts.items()}

    def lines_of(self, own: Function) -> list[str]:
        """Return the lines of a function."""
        return C_FORMATTER.lines(own.body)

    @property
    def launched(self) -> int:
        """Number of components of a state, from the first on, that the launch reads."""
        read = {part.name for part in self.parts["launch"] if isinstance(part, Declare)}
        return 1 + max(k for k, name in enumerate(STATE_NAMES) if name in read)

    def column_groups(self, others: Collection[str]) -> Iterator[tuple[str, list[str]]]:
        """Yield types and names of the columns, those apart that another variant has, too."""
        for shared in (True, False):
            for single, kind in ((False, "column"), (True, "singles_column")):
                names = [
                    name
                    for name, held in self.columns.items()
                    if (name in others) == shared and (held == "single") == single
                ]
                if names:
                    yield kind, sorted(names)

    def __getattr__(self, name: str) -> Any:
        return getattr(self.variant, name)


def loop_view(
    lowered: LoweredScene,
    variant: Variant,
    options: Options,
    hoisted: Hoisted,
    *,
    apart: bool,
) -> CVariant:
    """Return a variant of the event loop in C; its loop invariant results join those `hoisted`.

    Parameters
    ----------
    lowered
        The scene with the operations of its kernels.
    variant
        The event loop with bounds on errors or without, and its stages.
    options
        The thresholds by which C chooses between ways of writing the same.
    hoisted
        The loop invariant results so far, of all variants; it is changed.
    apart
        Whether each pass of a flight may be a function of its own.

    Returns
    -------
    CVariant
        The statements of each stage, and the fields of the lists.
    """
    loop, stages = variant.loop, variant.stages
    common: dict[str, Any] = {
        "prefix": lowered.prefix,
        "costs": lowered.costs,
        "max_inline_cost": options.max_inline_cost,
    }
    permitting = needed(stages["validate"][0], {"permitted"})
    sizes: dict[str, Kind] = dict.fromkeys(loop.parameters, "double")
    by_columns = frozenset(parameter_kernels(loop))
    permit = MaskedLoop(**common, by_columns=by_columns).body(
        permitting, sizes, set(), "", {"permitted"}
    )
    reviewer = MaskedLoop(**common)
    launcher = LaunchLoop(**common, hoisted=hoisted)
    common |= {
        "hoisted": hoisted,
        "parameters": loop.parameters,
        "job": loop.job,
        "min_outlined_cost": options.min_outlined_cost,
    }
    measuring = [node for node in stages["validate"][0] if "measured" in writes([node])]
    admitting = CompactedLoop(**common, columns={"permitted": "double"})
    admitting.columns |= {"measured": "double"} if measuring else {}
    fresh = GroupContext("", dict(loop.kinds), Name("fresh"))
    fields = set(loop.kinds)
    admit = admitting.passes(stages["start"][0], fresh, fields, _permission(bool(measuring)))
    (reach, _), (meet, _) = stages["detect"], stages["resolve"]
    following = CompactedLoop(**common, used=admitting.used, once=admitting.once)
    following.beside = [_ahead(lowered)]
    record = _record(len(reach), loop)
    follow = following.passes((*reach, *meet), GroupContext("", dict(loop.kinds)), fields, record)
    # Tables that are made once for all passes belong to the function of these.
    if apart and not following.once:
        follow = following.apart(follow)
    beside: dict[str, Kind] = {"body": "double", **admitting.columns, **following.columns}
    written = [r for r in lowered.model.results if variant.bounds or not r.is_diagnostic]
    results = {name for r in written if not r.is_counted for name in r.columns}
    review: Statements = []
    if loop.tightens:
        nodes, after = stages[REVIEW]
        read = sorted(live_before(nodes, ()))
        review = [
            Declare(n, "V", load("double", at(column_of("", n), "i")), constant=True) for n in read
        ]
        known: dict[str, Kind] = dict.fromkeys(read, "double")
        review += reviewer.body(nodes, known, set(), "", after)
    launching, launch = launcher.launch(loop, stages, results)
    fixed = hoisted.all
    given = [
        Declare(p, "V", load("double", Column(column_of("", p))), constant=True)
        for p in hoisted.reads(fixed)
    ]
    parts = {
        "validate": permit,
        "permitted": _permitted(lowered.prefix, measuring),
        "fixed": [*given, *hoisted.statements(fixed)],
        "once": following.once,
        "launching": launching,
        "launch": launch,
        "start": admit,
        "follow": follow,
        "review": review,
    }
    return CVariant(
        variant,
        parts,
        {name: kind for name, kind in beside.items() if name not in loop.kinds},
        [p for p in {**admitting.parameter_lists, **following.parameter_lists} if p],
        [*admitting.functions, *following.functions],
        _reported(variant, written),
    )


def _reported(variant: Variant, results: Iterable[ResultField]) -> dict[str, list[str]]:
    """Return the kept fields that only results need, by the condition that one is requested."""
    influential, found = variant.loop.influential, dict[str, list[str]]()
    for name in variant.kept:
        of = [f"job->results->{r.name}" for r in results if name in r.columns and not r.is_counted]
        if of and name not in influential and name not in STATE_NAMES:
            found.setdefault(" || ".join(of), []).append(name)
    return found


def _ahead(lowered: LoweredScene) -> Statement:
    """Return the prefetch of the shots to come, for the row of lanes at hand.

    Where a shot has many pieces few rows are new in a turn, and only these prefetch.
    """
    pieces = not lowered.model.scene.flight.exact
    row = Infix("-", Name("i"), Name("fresh")) if pieces else Name("i")
    given = (Name("job"), Infix("+", Name("begun"), row), Name("streams"))
    ahead = Execute(Apply(function(f"{lowered.prefix}_ahead"), given))
    return If(Infix("<=", Name("fresh"), Name("i")), (ahead,)) if pieces else ahead


def _permission(measured: bool) -> Insertion:
    """Return the statement that loads the permissions of a row of lanes."""

    def loaded(name: str, kind: Kind) -> Declare:
        place = offset(Column(name), Infix("&", Name("i"), Name("varying")))
        return Declare(name, TYPES[kind], load(kind, place))

    kinds: dict[str, Kind] = {"permitted": "truth"}
    kinds |= {"measured": "double"} if measured else {}
    return Insertion(0, tuple(loaded(name, kind) for name, kind in kinds.items()), kinds)


def _record(index: int, loop: Loop) -> Insertion:
    """Return the statements that record the state before an event on request."""
    body = store("double", at("body", "i"), Name("body"))
    before = (store("double", at(f"{s}_before", "i"), Name(s)) for s in STATE_NAMES)
    if loop.counts_by_body:
        return Insertion(index, (body, If(Name("recording"), tuple(before))))
    return Insertion(index, (If(Name("recording"), (body, *before)),))


def _permitted(prefix: str, measuring: Iterable[Node]) -> Statements:
    """Return the statements that validate the parameters of a row of lanes, from `row` on."""
    given = (Column("parameters.columns"), Name("row"))
    permit = Apply(function(f"{prefix}_validate"), given)
    found = [store("truth", at("permitted", "row"), permit)]
    for node in measuring:
        assert isinstance(node, ir.Call)
        sizes = Apply(function(f"{prefix}_{node.kernel.name}"), given)
        found.append(store("double", at("measured", "row"), Member(sizes, "measured")))
    return found
