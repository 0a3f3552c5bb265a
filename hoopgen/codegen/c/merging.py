"""Merging: the variants of the event loop as one text, which the preprocessor takes apart again.

What the same macro says of several variables stands in one line, and calls that differ by bounds on
errors alone are one call.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from difflib import SequenceMatcher
from itertools import groupby, product
from typing import NamedTuple

MACRO = "BOUNDED"
"""The macro that is 1 where errors are bounded, else 0."""

EACH, CALL, FIX = "EACH(", "CALL(", "FIX"
"""Beginnings of lines: of those with a macro of variables, with a kernel, with a result to keep."""

ZEROS = {"K(0.0)": "OR_ZERO", "K(INFINITY)": "OR_INFINITE"}
"""By what a kernel is given without bounds, the macro that is a variable with them."""

WIDTH = 100
"""Length of lines up to which variables are gathered in them."""

COMMON, BOUNDED, PLAIN = "", MACRO, f"!{MACRO}"
"""The variants that have a line: both, the one with bounds, the other."""


class Line(NamedTuple):
    """A line, and the variants that have it."""

    variant: str
    text: str

    @property
    def head(self) -> str:
        """All but the variable of a line that is gathered with others; "" of any other."""
        return self.text.rpartition(", ")[0] if self.text.lstrip().startswith(EACH) else ""

    @property
    def family(self) -> str:
        """All but the kinds and variables of lines of which each may come first."""
        what, _, of = self.head.partition(", ")
        what = what.removesuffix("_MASK").removesuffix("_SINGLE")
        return f"{what.replace('(SET', '(GET')}, {of}" if of or what else ""


def merge_variants(plain: str, bounded: str) -> str:
    """Return one text of two: lines that only one of them has are for that one alone.

    Parameters
    ----------
    plain, bounded
        The texts, neither with directives of the preprocessor.
    """
    aligned = _aligned(plain.splitlines(), bounded.splitlines())
    return "\n".join(_printed(list(_joined(_gathered(aligned)))))


def _aligned(plain: Sequence[str], bounded: Sequence[str]) -> Iterator[Line]:
    """Yield the lines of both variants, in the order of both."""
    matcher = SequenceMatcher(None, [*map(_key, plain)], [*map(_key, bounded)], autojunk=False)
    for tag, start, end, first, last in matcher.get_opcodes():
        if tag == "equal":
            for own, other in zip(plain[start:end], bounded[first:last], strict=True):
                both = own if own == other else _call(own, other)
                yield from (
                    [Line(COMMON, both)]
                    if own == other or both
                    else [Line(BOUNDED, other), Line(PLAIN, own)]
                )
        else:
            yield from (Line(BOUNDED, line) for line in bounded[first:last])
            yield from (Line(PLAIN, line) for line in plain[start:end])


def _key(line: str) -> str:
    """Return the common part of two variants of a line: of a call, all but its arguments."""
    return line.partition(")(")[0] if line.lstrip().startswith(CALL) else line


def _call(plain: str, bounded: str) -> str:
    """Return one line for two that differ by what is zero without bounds; "" if there is none."""
    pairs = list(zip(plain.split(", "), bounded.split(", "), strict=False))
    if plain.count(", ") != bounded.count(", "):
        return ""
    arguments = []
    for own, other in pairs:
        name = other.removesuffix(");")
        zero = own[: len(own) - len(other) + len(name)]
        if own == other:
            arguments.append(own)
        elif zero in ZEROS and name.isidentifier():
            arguments.append(f"{ZEROS[zero]}({name}){other.removeprefix(name)}")
        else:
            return ""
    return ", ".join(arguments)


def _gathered(lines: Iterable[Line]) -> Iterator[Line]:
    """Yield the lines, with adjacent lines of the same macro gathered in one."""
    for family, group in groupby(lines, lambda line: line.family):
        own = list(group)
        if not family:
            yield from own
            continue
        heads = dict.fromkeys(line.head for line in own)
        for variant, head in product((COMMON, BOUNDED, PLAIN), heads):
            names = [
                line.text[len(head) + 2 : -1]
                for line in own
                if line[0] == variant and line.head == head
            ]
            yield from (Line(variant, text) for text in _filled(head, names))


def _joined(lines: Iterable[Line]) -> Iterator[Line]:
    """Yield the lines with several results that are kept in one."""
    kept = Line(COMMON, "")
    for line in lines:
        bare = line.text.lstrip()
        alike = bare.startswith(FIX) and line.variant == kept.variant
        if alike and kept.text and len(f"{kept.text} {bare}") <= WIDTH:
            kept = Line(kept.variant, f"{kept.text} {bare}")
            continue
        if kept.text:
            yield kept
            kept = Line(COMMON, "")
        if bare.startswith(FIX):
            kept = line
        else:
            yield line
    if kept.text:
        yield kept


def _filled(head: str, names: Sequence[str]) -> Iterator[str]:
    """Yield lines that say what the macro says of all variables."""
    line = head
    for name in names:
        if line != head and len(f"{line}, {name})") > WIDTH:
            yield f"{line})"
            line = head
        line += f", {name}"
    if names:
        yield f"{line})"


def _printed(lines: Sequence[Line]) -> Iterator[str]:
    """Yield the text, with directives around what is not common to both variants."""
    runs = [(variant, list(run)) for variant, run in groupby(lines, lambda line: line.variant)]
    for k, (variant, run) in enumerate(runs):
        before = runs[k - 1][0] if k else COMMON
        after = runs[k + 1][0] if k + 1 < len(runs) else COMMON
        texts = [line.text for line in run]
        if variant == COMMON:
            yield from texts
        elif variant == BOUNDED and after == COMMON and all(line.head for line in run):
            for text in texts:
                bare = text.lstrip()
                yield f"{text.removesuffix(bare)}BOUNDS({bare})"
        else:
            yield "#else" if variant == PLAIN and before == BOUNDED else f"#if {variant}"
            yield from texts
            if not (variant == BOUNDED and after == PLAIN):
                yield "#endif"
