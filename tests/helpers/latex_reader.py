"""Reads the LaTeX of the derivation back, and evaluates it: what a reader would compute from it."""

from __future__ import annotations

import re
from collections.abc import Mapping

from mpmath import mp, mpf

Value = mpf | bool

_END = re.compile(r"\\right|\\end|\\le(?![a-z])|\\wedge|\\vee|\\\\|[<=+,&})-]|$")
"""The tokens that end a product."""


class Reader:
    """A formula that is read from left to right.

    Parameters
    ----------
    text
        The right side of an equation.
    names
        What each name stands for, in LaTeX.
    """

    def __init__(self, text: str, names: Mapping[str, Value]) -> None:
        self._text, self._at, self._names = text, 0, names
        self._longest_first = sorted(names, key=len, reverse=True)

    def value(self) -> Value:
        """Return the value of the whole formula."""
        found = self._either()
        self._skip()
        assert self._at == len(self._text), f"unread: {self._text[self._at :]!r}"
        return found

    def _skip(self) -> None:
        while self._at < len(self._text) and self._text[self._at].isspace():
            self._at += 1

    def _next(self, *tokens: str) -> str | None:
        """Take one of the tokens, if one comes next."""
        self._skip()
        for token in tokens:
            if self._text.startswith(token, self._at):
                self._at += len(token)
                return token
        return None

    def _take(self, token: str) -> None:
        assert self._next(token), f"no {token} at {self._text[self._at :]!r}"

    def _either(self) -> Value:
        found = self._both()
        while self._next(r"\vee"):
            found = self._both() or found
        return found

    def _both(self) -> Value:
        found = self._comparison()
        while self._next(r"\wedge"):
            found = bool(self._comparison()) and found
        return found

    def _comparison(self) -> Value:
        if self._next(r"\neg"):
            return not self._comparison()
        left = self._sum()
        self._skip()
        if re.match(r"\\le(?![a-z])", self._text[self._at :]):
            self._take(r"\le")
            return bool(left <= self._sum())
        sign = self._next("<", "=")
        if sign is None:
            return left
        right = self._sum()
        return bool(left < right) if sign == "<" else bool(left == right)

    def _sum(self) -> Value:
        total = -self._product() if self._next("-") else self._product()
        while sign := self._next("+", "-"):
            term = self._product()
            total = total + term if sign == "+" else total - term
        return total

    def _product(self) -> Value:
        found = self._power()
        while True:
            self._next(r"\cdot", r"\,")
            self._skip()
            if _END.match(self._text, self._at):
                return found
            found = found * self._power()

    def _power(self) -> Value:
        base = self._primary()
        if not self._next("^"):
            return base
        exponent = self._braced()
        if base < 0 and exponent != int(exponent):
            return mp.nan
        return base**exponent

    def _braced(self) -> Value:
        self._take("{")
        found = self._either()
        self._take("}")
        return found

    def _degree(self) -> int:
        """Return the degree of a root: the number in square brackets, or 2."""
        if not self._next("["):
            return 2
        number = re.match(r"\d+", self._text[self._at :])
        assert number, f"no degree at {self._text[self._at :]!r}"
        self._at += number.end()
        self._take("]")
        return int(number[0])

    def _primary(self) -> Value:
        self._skip()
        for name in self._longest_first:
            if self._text.startswith(name, self._at):
                self._at += len(name)
                return self._names[name]
        number = re.compile(r"\d+(?:\.\d+)?").match(self._text, self._at)
        if number:
            self._at = number.end()
            return mpf(number[0])
        token = self._next(
            *(r"\infty", r"\dfrac", r"\frac", r"\sqrt", r"\max\left(", r"\min\left("),
            *(r"\left(", r"\left\lvert", r"\begin{cases}", r"\text{never}", "("),
        )
        assert token, f"what is {self._text[self._at :]!r}?"
        if token == r"\infty":
            return mp.inf
        if token == r"\text{never}":
            return False
        if token in (r"\dfrac", r"\frac"):
            above, below = self._braced(), self._braced()
            return above * (mp.inf if below == 0 else 1 / below)
        if token == r"\sqrt":
            degree = self._degree()
            inner = self._braced()
            return mp.root(inner, degree) if not inner < 0 else mp.nan
        if token == r"\begin{cases}":
            return self._cases()
        if token in (r"\max\left(", r"\min\left("):
            return self._extreme(token == r"\max\left(")
        inner = self._either()
        if token == r"\left\lvert":
            self._take(r"\right\rvert")
            return abs(inner)
        self._take(")" if token == "(" else r"\right)")
        return inner

    def _extreme(self, largest: bool) -> Value:
        """Read values; the first of them stays where another one is not a number."""
        found = self._either()
        while self._next(","):
            other = self._either()
            found = other if (found < other if largest else other < found) else found
        self._take(r"\right)")
        return found

    def _cases(self) -> Value:
        found: Value | None = None
        while not self._next(r"\end{cases}"):
            value = self._either()
            self._take("&")
            holds = True
            while not self._next(r"\text{else}"):
                holds = bool(self._either()) and holds
                if not self._next(",\\ "):
                    break
            found = value if found is None and holds else found
            self._next(r"\\")
        assert found is not None, self._text
        return found


def read(text: str, names: Mapping[str, Value]) -> Value:
    """Return the value of a formula."""
    return Reader(text, names).value()
