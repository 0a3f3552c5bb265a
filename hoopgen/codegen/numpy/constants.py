"""The numbers in a module's kernels, each made once: to make one costs as much as its use."""

from __future__ import annotations

from ..program import Operations
from ..statements import Apply, Assign, Expression, Name, Number
from .formatter import ROWS_FORMATTER


class Constants:
    """The numbers of a module.

    What meets rows is an array of no dimension, which NumPy need not turn into one; what meets
    numbers alone is a number, with which NumPy is quickest.
    """

    def __init__(self) -> None:
        self._names: dict[Expression, str] = {}

    def number(self, program: Operations, value: float, meets_rows: bool) -> Expression:
        """Return a number of a program.

        Parameters
        ----------
        program
            The program, in single or double precision.
        value
            The number.
        meets_rows
            True if an operation with rows to write into takes it, for which NumPy needs an array.

        Returns
        -------
        Expression
            The name of a constant of the module.
        """
        single = [number_type(program.single)] if program.single else []
        return self.name(value, *["_scalar"] * meets_rows, *single)

    def name(self, value: float, *makers: str) -> Expression:
        """Return the name of the composition of some functions at a number, the last one first."""
        made: Expression = Number(value)
        if not makers:
            return made
        for maker in reversed(makers):
            made = Apply(maker, (made,))
        return Name(self._names.setdefault(made, f"_k{len(self._names)}"))

    @property
    def lines(self) -> list[str]:
        """The lines that make them."""
        return ROWS_FORMATTER.lines(Assign(Name(n), made) for made, n in self._names.items())


def number_type(single: bool) -> str:
    """Return the constructor of a NumPy number, in single or double precision."""
    return "_float32" if single else "_float64"
