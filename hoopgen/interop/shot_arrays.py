"""`ShotArrays`: results of shots as a tree of JAX's arrays."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import jax
import jax.numpy as jnp

from hoopgen.simulation.engine import Engine


@jax.tree_util.register_pytree_with_keys_class
class ShotArrays:
    """Results of shots as attributes, JAX's arrays of shape (...) or (..., columns).

    Functions of JAX take and return it as a tree of its arrays. The results are those of
    `hoopgen.Shots`; one that was not requested raises AttributeError.

    Attributes
    ----------
    outcome, contacts, counts, first, time, state, uncertain, estimated, rolls, airless_rolls,
    slip_left
        As of `hoopgen.Shots`.
    """

    outcome: jax.Array
    contacts: jax.Array
    counts: jax.Array
    first: jax.Array
    time: jax.Array
    state: jax.Array
    uncertain: jax.Array
    estimated: jax.Array
    rolls: jax.Array
    airless_rolls: jax.Array
    slip_left: jax.Array

    def __init__(
        self, arrays: Mapping[str, Any], made: int | None, ends: int, can_roll: bool
    ) -> None:
        self._arrays = dict(arrays)
        self._made, self._ends, self._can_roll = made, ends, can_roll

    @classmethod
    def of(cls, engine: Engine, arrays: Mapping[str, jax.Array]) -> ShotArrays:
        """Return the results of shots in a scene.

        Parameters
        ----------
        engine
            The scene.
        arrays
            The results by name, in any order.
        """
        made = engine.outcomes.__members__.get("MADE")
        # JAX sorts names.
        ordered = {name: arrays[name] for name in engine.layout.results if name in arrays}
        ends = len(engine.kernels.ENDS)
        return cls(ordered, None if made is None else int(made), ends, engine.rolls)

    @property
    def made(self) -> jax.Array:
        """True where the outcome is MADE, in a scene that has this outcome.

        Raises
        ------
        AttributeError
            If it has not, or if "outcome" was not requested.
        """
        if self._made is None:
            raise AttributeError("made: the scene has no outcome MADE")
        return self.outcome == self._made

    @property
    def differentiable(self) -> jax.Array:
        """True where a shot has derivatives: it reaches an end, is certain, and never rolls.

        A shot with an exact graze, or a contact law at its limit, may have none all the same.

        Raises
        ------
        AttributeError
            If one of the results from which it is computed was not requested.
        """
        found = (self.outcome < self._ends) & ~self.uncertain
        return found & (self.rolls == 0) if self._can_roll else found

    def _array(self, name: str) -> jax.Array:
        """Return a result by its name; one that was not requested raises AttributeError."""
        arrays = self.__dict__.get("_arrays", {})
        if name in arrays:
            found: jax.Array = arrays[name]
            return found
        if name in ShotArrays.__annotations__:
            raise AttributeError(f"{name}: not among the results: {', '.join(arrays)}")
        raise AttributeError(f"ShotArrays has no attribute {name!r}")

    if not TYPE_CHECKING:  # else every misspelt name would be one of the results
        __getattr__ = _array

    def __dir__(self) -> list[str]:
        return sorted({*super().__dir__(), *self._arrays})

    def __repr__(self) -> str:
        shapes = ", ".join(
            f"{name} {jnp.shape(array)}" if hasattr(array, "shape") else name
            for name, array in self._arrays.items()
        )
        return f"ShotArrays({shapes})"

    def tree_flatten_with_keys(self) -> tuple[Any, Any]:
        """Return the arrays with their names, and all else; JAX calls it."""
        names = tuple(self._arrays)
        keys = [(jax.tree_util.GetAttrKey(name), self._arrays[name]) for name in names]
        return keys, (names, self._made, self._ends, self._can_roll)

    @classmethod
    def tree_unflatten(
        cls, form: tuple[tuple[str, ...], int | None, int, bool], arrays: Any
    ) -> Any:
        """Return the results with other arrays; JAX calls it.

        Parameters
        ----------
        form
            What `tree_flatten_with_keys` returned beside the arrays.
        arrays
            The arrays.
        """
        names, made, ends, can_roll = form
        return cls(dict(zip(names, arrays, strict=True)), made, ends, can_roll)
