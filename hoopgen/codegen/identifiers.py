"""Names and texts in generated code: what could mean something there never reaches it as it is.

Three kinds of names meet in a printed function, and no two kinds share one: a parameter begins
with ``p_`` (`symbols.variable`); what a printer makes up, such as a temporary, begins with an
underscore; all others are those of derive/, and begin with a small letter.
"""

from __future__ import annotations

import json
import keyword
import re

import sympy as sp

from hoopgen.derive.symbolic.symbols import ParameterSymbol, variable

OWN = re.compile(r"(?!p_)[a-z][a-z0-9_]*", re.ASCII)
"""The pattern of names in derive/."""

_C = """
    auto break case char const continue default do double else enum extern float for goto if
    inline int long register restrict return short signed sizeof static struct switch typedef
    union unsigned void volatile while
"""
_JS = """
    arguments await boolean byte catch class debugger delete eval export extends finally
    function implements import in instanceof interface let native new null package private
    protected public super synchronized this throw throws transient try typeof undefined var
    with yield
"""
WORDS = frozenset((*keyword.kwlist, *_C.split(), *_JS.split()))
"""Words of the targets' languages: Python, C, JavaScript."""


def identifier(symbol: sp.Symbol) -> str:
    """Return the name of a symbol in generated code.

    Raises
    ------
    ValueError
        If it is one of derive/ that a parameter, a printer or a language could use too.
    """
    name = variable(symbol)
    if not isinstance(symbol, ParameterSymbol) and not is_own(name):
        raise ValueError(
            f"symbol {name!r}: expected a name that fits {OWN.pattern}, and no keyword"
        )
    return name


def is_own(name: str) -> bool:
    """Return whether a name can be one of derive/ in every target."""
    return OWN.fullmatch(name) is not None and name not in WORDS


def in_line(text: str) -> str:
    """Return a text in one line, what cannot be seen (and could turn what can) by its number."""
    words = " ".join(text.split())
    return "".join(c if c.isprintable() else f"<U+{ord(c):04X}>" for c in words)


def python_string(text: str) -> str:
    """Return a text as a Python literal."""
    quoted = json.dumps(text, ensure_ascii=False)
    return "".join(c if c.isprintable() else _escape(c) for c in quoted)


def _escape(character: str) -> str:
    code = ord(character)
    return f"\\u{code:04x}" if code < 0x10000 else f"\\U{code:08x}"


def docstring(text: str) -> str:
    """Return a text for the inside of a Python docstring."""
    return in_line(text).replace("\\", r"\\").replace('"', r"\"")


def comment(text: str) -> str:
    """Return a text for the inside of a comment of C or of a script in a page.

    No comment begins or ends in it, no trigraph or backslash joins lines, no tag ends the script.
    """
    plain = in_line(text).replace("\\", "<U+005C>").replace("??/", "? ?/")
    return re.sub(r"(?<=[*/<])(?=[*/!])", " ", plain)


def markdown(text: str) -> str:
    """Return a text for a paragraph or a table's cell in Markdown, with nothing marked up."""
    return re.sub(r"([\\`*_{}\[\]<>#|~$&])", r"\\\1", in_line(text))


FILTERS = {
    "python_string": python_string,
    "docstring": docstring,
    "comment": comment,
    "markdown": markdown,
}
"""Filters of the templates, by name."""
