"""Derivatives that JAX does not differentiate again: hoopgen has those of first order alone."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import jax


def first_order(derivative: Callable[..., Any]) -> Callable[..., Any]:
    """Return a function whose own derivatives are refused.

    Parameters
    ----------
    derivative
        The function, of arrays.
    """

    def refuse(primals: tuple[Any, ...], tangents: tuple[Any, ...]) -> Any:
        raise NotImplementedError(
            "hoopgen.jax.simulate: hoopgen has first derivatives only, and JAX asks for second ones"
        )

    function = jax.custom_jvp(derivative)
    function.defjvp(refuse)
    return function
