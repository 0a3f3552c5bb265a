"""Types of click that older releases do not know as generic."""

from __future__ import annotations

from typing import TYPE_CHECKING, Generic, TypeVar

import click

__all__ = ["Choice", "Type", "Value"]

Value = TypeVar("Value")

if TYPE_CHECKING:

    class Type(click.ParamType[Value]):
        """The type of an option whose text becomes a value of one kind."""

    Choice = click.Choice[str]

else:

    class Type(click.ParamType, Generic[Value]):
        """The type of an option whose text becomes a value of one kind."""

    Choice = click.Choice
