"""Escapes that make foreign text safe on terminals, in pictures and on pages."""

from __future__ import annotations

import re

_UNPRINTABLE = re.compile(
    "["
    "\x00-\x08\x0b-\x1f\x7f-\x9f"  # control characters, but for the tab and the end of a line
    "\u2028-\u202e\u2066-\u2069"  # ends of lines of another kind, and turns of the direction
    "\ud800-\udfff\ufffe\uffff"  # no characters: XML has none of them, nor has UTF-8
    "]"
)


def printable(text: str) -> str:
    r"""Return a text with every control character and the like replaced by its number.

    >>> print(printable("\x1b[31mred"))
    \x1b[31mred
    """
    return _UNPRINTABLE.sub(lambda found: _number(ord(found[0])), text)


def _number(code: int) -> str:
    return f"\\x{code:02x}" if code < 0x100 else f"\\u{code:04x}"
