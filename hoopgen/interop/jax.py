"""`hoopgen.jax`: shots as a function of JAX's arrays, under jit, vmap, jvp and grad.

XLA calls the C engine directly. Derivatives are those of `hoopgen.simulate(..., derivatives=)`:
JAX multiplies the Jacobian of each shot by tangents or by cotangents.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from functools import lru_cache
from typing import Any, Literal, get_args

import jax
import jax.numpy as jnp
import numpy as np
from numpy.typing import NDArray

from hoopgen.core.backend_names import BackendName
from hoopgen.core.memory import check_room
from hoopgen.core.parameters import complete
from hoopgen.core.validation import check_contacts, check_threads
from hoopgen.core.variables import STATE
from hoopgen.scene.lookup import SceneLike
from hoopgen.simulation.checks import check_backend, check_fields, check_limit
from hoopgen.simulation.engine import Engine
from hoopgen.simulation.lookup import engine_of
from hoopgen.simulation.run import MAX_CONTACTS_WITHOUT_THREADS, run
from hoopgen.text.shorten import brief

from .first_order import first_order
from .shot_arrays import ShotArrays
from .xla_handler import target_of

__all__ = ["ShotArrays", "simulate"]

Undefined = Literal["nan", "zero"]

DIFFERENTIABLE = ("state", "time")
"""Results that have derivatives, in the order of the rows of a Jacobian."""

MAX_SIMULATORS = 128
"""Largest number of functions that are kept, one for each scene and its options."""


def simulate(
    states: jax.typing.ArrayLike,
    parameters: Mapping[str, jax.typing.ArrayLike] | None = None,
    *,
    scene: SceneLike = None,
    max_contacts: int | None = None,
    backend: BackendName = "auto",
    threads: int | None = None,
    fields: Literal["all"] | Iterable[str] = "all",
    time_limit: float | None = None,
    undefined: Undefined = "nan",
) -> ShotArrays:
    """Simulate shots in JAX: the same bits as `hoopgen.simulate`, under jit, vmap, jvp and grad.

    Only "time" and "state" have derivatives, by the states and by the parameters, of first order:
    a second derivative, such as ``jax.hessian``, raises NotImplementedError.

    Parameters
    ----------
    states
        Releases (..., 9), float64 or what float64 holds exactly; units as for `hoopgen.simulate`.
    parameters
        Name to value, one for all shots or of the shape (...) of the shots; those left out have the
        scene's usual values. A parameter that is infinite has the derivative 0.
    scene, max_contacts, time_limit
        As for `hoopgen.simulate`. They, and all below, are constants of a compiled function.
    backend
        "c": XLA calls the C engine, by a function that is compiled at first use. "numpy": it calls
        Python, where NumPy simulates. "auto": the first, or where that is not possible the second
        with the engine that there is; the bits are the same. On a GPU the arrays are copied to
        the host and back.
    threads
        How many of XLA's threads work at most; None for one on each processor.
    fields
        "all", or the names of the results that are wanted: those that `hoopgen.simulate` has
        without their being named.
    undefined
        Derivatives of a shot that has none, such as one that rolls or is uncertain: "nan", or
        "zero", with which it adds nothing to a gradient, as behind a mask.

    Returns
    -------
    ShotArrays
        A tree of JAX's arrays, results by name; each has the leading shape (...) of the states. A
        shot that cannot be simulated is INVALID, also by parameters for which `hoopgen.simulate`
        raises an error.

    Raises
    ------
    TypeError, ValueError
        If an argument is not as described; or if JAX computes in single precision.
    RuntimeError
        If backend "c" is asked for and cannot be had; the message says why.
    """
    if jax.dtypes.canonicalize_dtype(np.float64) != np.float64:
        raise ValueError(
            "hoopgen.jax computes in double precision, and JAX rounds to single: call "
            "jax.config.update('jax_enable_x64', True) before arrays are made"
        )
    engine = engine_of(scene)
    if undefined not in get_args(Undefined):
        raise ValueError(f"undefined: expected 'nan' or 'zero', got {brief(undefined)}")
    simulator = _simulator(
        engine,
        _Options(
            _wanted(fields, engine),
            engine.max_contacts if max_contacts is None else check_contacts(max_contacts),
            check_limit(time_limit, engine),
            check_backend(backend),
            check_threads(threads),
            undefined == "zero",
        ),
    )
    releases = _doubles("states", states)
    if releases.ndim < 1 or releases.shape[-1] != len(STATE):
        raise ValueError(
            f"states: expected shape (..., 9), got {releases.shape}; "
            "the last axis is x y z vx vy vz wx wy wz"
        )
    lead = releases.shape[:-1]
    values = []
    for name, given in complete(parameters, engine.table).items():
        value = _doubles(f"parameters[{name!r}]", given)
        if value.shape not in ((), lead):
            raise ValueError(
                f"parameters[{name!r}]: expected one number or the shape {lead} of the shots, "
                f"got shape {value.shape}"
            )
        values.append(value)
    return ShotArrays.of(engine, simulator(releases, *values))


def _wanted(fields: Literal["all"] | Iterable[str], engine: Engine) -> tuple[str, ...]:
    """Return the names of the results that are wanted."""
    wanted = check_fields(fields, engine)
    on_request = [name for name in wanted if name in engine.layout.bounds]
    if on_request:
        raise ValueError(
            f"fields: {', '.join(on_request)} cannot be had in JAX; hoopgen.simulate has them"
        )
    return tuple(dict.fromkeys(wanted))


def _doubles(name: str, given: Any) -> jax.Array:
    """Return an array of float64, or raise an error that names it."""
    try:
        array = jnp.asarray(given)
    except (TypeError, ValueError):
        raise TypeError(f"{name}: expected numbers, got {brief(given)}") from None
    if array.dtype.kind not in "biuf" and not jnp.issubdtype(array.dtype, jnp.floating):
        raise TypeError(f"{name}: expected real numbers, got {array.dtype}")
    return array.astype(np.float64)


@dataclass(frozen=True)
class _Options:
    """The constants for which a simulator is compiled.

    Attributes
    ----------
    fields
        Names of the results.
    max_contacts, time_limit, backend, threads
        As for `hoopgen.simulate`.
    zero
        Whether derivatives that there are not are 0, instead of NaN.
    """

    fields: tuple[str, ...]
    max_contacts: int
    time_limit: float
    backend: BackendName
    threads: int
    zero: bool


Arrays = tuple[Any, ...]


@lru_cache(maxsize=MAX_SIMULATORS)
def _simulator(engine: Engine, options: _Options) -> Callable[..., dict[str, jax.Array]]:
    """Return a function of states and all parameters, in order, that has derivatives."""
    simulator = _Simulator(engine, options, _target(engine, options.backend))
    function = jax.custom_jvp(jax.jit(simulator.results))
    function.defjvp(simulator.tangents, symbolic_zeros=True)
    simulator.function = function
    return function


def _target(engine: Engine, backend: BackendName) -> str:
    """Return the name of the function that XLA calls; "" if it calls Python."""
    if backend == "numpy":
        return ""
    try:
        return target_of(engine)
    except RuntimeError as error:
        if backend == "c":
            raise RuntimeError(f"backend: 'c' is not possible in JAX: {error}") from None
        return ""


class _Simulator:
    """The shots of a scene as functions of JAX's arrays.

    Parameters
    ----------
    engine
        The scene.
    options
        The options.
    target
        The name of the function that XLA calls; "" if it calls Python.
    """

    function: Callable[..., dict[str, jax.Array]]

    def __init__(self, engine: Engine, options: _Options, target: str) -> None:
        self._engine, self._options, self._target = engine, options, target
        self._names = tuple(engine.parameters)

    def results(self, states: jax.Array, *values: jax.Array) -> dict[str, jax.Array]:
        """Return the results by name.

        Parameters
        ----------
        states
            (..., 9).
        values
            The parameters, in order, each () or (...).
        """
        lead, fields = states.shape[:-1], self._options.fields
        rows = (self._engine.layout.row(name) for name in fields)
        types = tuple(_array_type((*lead, *shape), dtype) for shape, dtype in rows)
        in_python = self._in_python(types)
        if not self._target:
            found = in_python(states, *values)
        else:  # XLA's CPU has the function; any other device calls Python on the host
            found = jax.lax.platform_dependent(
                states, *values, cpu=self._in_c(types), default=in_python
            )
        return dict(zip(fields, found, strict=True))

    def _in_c(self, types: Arrays) -> Callable[..., Arrays]:
        """Return a function that calls the C engine."""
        options, library = self._options, self._engine.library
        assert library is not None  # else there is no target
        call = jax.ffi.ffi_call(self._target, types, vmap_method="broadcast_all")
        slots = np.array([library.results.index(name) for name in options.fields], np.int64)
        attributes = {
            "slots": slots,
            "places": np.int64(len(library.results)),
            "max_contacts": np.int64(options.max_contacts),
            "time_limit": np.float64(options.time_limit),
            "helpers": np.int64(options.threads - 1),
            "contacts": np.int64(MAX_CONTACTS_WITHOUT_THREADS),
        }

        def simulate(states: jax.Array, *values: jax.Array) -> Arrays:
            return tuple(call(states, *self._inputs(states, values), **attributes))

        return simulate

    def _inputs(self, states: jax.Array, values: Arrays) -> Arrays:
        """Return the kernels' inputs, which some scenes compute from the parameters."""
        table = self._engine.table
        if table.written is None:
            return values
        lead = states.shape[:-1] if any(value.ndim for value in values) else ()
        count = len(self._engine.kernels.VARIABLES)

        def compute(*values: Any) -> Arrays:
            shape = max((np.shape(value) for value in values), key=len, default=())
            rows = [_expanded(value, shape) for value in values]
            with self._engine.exact_arithmetic():
                inputs = table.inputs(dict(zip(self._names, rows, strict=True)))
            return tuple(np.broadcast_to(one, math.prod(shape)).reshape(shape) for one in inputs)

        types = (_array_type(lead),) * count
        return tuple(jax.pure_callback(compute, types, *values, vmap_method="broadcast_all"))

    def _in_python(self, types: Arrays) -> Callable[..., Arrays]:
        """Return a function that calls Python."""

        def on_host(states: Any, *values: Any) -> Arrays:
            lead = np.shape(states)[:-1]
            shots = self._run(states, values, fields=self._options.fields)
            found = (getattr(shots, name) for name in self._options.fields)
            return tuple(array.reshape(*lead, *array.shape[1:]) for array in found)

        def simulate(states: jax.Array, *values: jax.Array) -> Arrays:
            called = jax.pure_callback(on_host, types, states, *values, vmap_method="broadcast_all")
            return tuple(called)

        return simulate

    def _run(self, states: Any, values: Arrays, **asked: Any) -> Any:
        """Simulate arrays of the host; each parameter has one value a shot."""
        options, lead = self._options, np.shape(states)[:-1]
        rows = [_expanded(value, lead) for value in values]
        return run(
            self._engine,
            np.asarray(states).reshape(-1, len(STATE)),
            dict(zip(self._names, rows, strict=True)),
            max_contacts=options.max_contacts,
            time_limit=options.time_limit,
            backend=options.backend,
            threads=options.threads,
            **asked,
        )

    def tangents(self, primals: Arrays, tangents: Arrays) -> tuple[Any, Any]:
        """Return the results and their changes, as a rule of `jax.custom_jvp`.

        Parameters
        ----------
        primals, tangents
            States and parameters, in order, and their changes; those that do not change are marked.
        """
        states, *values = primals
        results = self.function(*primals)
        lead = states.shape[:-1]
        is_zero = [type(one) is jax.custom_derivatives.SymbolicZero for one in tangents]
        names = () if is_zero[0] else STATE
        moving = [k for k, still in enumerate(is_zero[1:]) if not still]
        names = (*names, *(self._names[k] for k in moving))
        wanted = [name for name in DIFFERENTIABLE if name in results]
        changes: dict[str, Any] = {
            name: np.zeros(one.shape, jax.dtypes.float0) for name, one in results.items()
        }
        if not wanted or not names:
            changes |= {name: jnp.zeros_like(results[name]) for name in wanted}
            return results, changes
        shape = (*lead, len(STATE) + 1, len(names))
        check_room("states", math.prod(shape), "derivatives", 8)
        jacobian = first_order(
            lambda *primals: jax.pure_callback(
                lambda states, *values: self._jacobian(names, states, values),
                _array_type(shape),
                *primals,
                vmap_method="broadcast_all",
            )
        )(states, *values)
        columns = [] if is_zero[0] else [tangents[0]]
        columns += [jnp.broadcast_to(tangents[1 + k], lead)[..., None] for k in moving]
        product = jnp.einsum("...rk,...k->...r", jacobian, jnp.concatenate(columns, axis=-1))
        parts = {"state": product[..., : len(STATE)], "time": product[..., len(STATE)]}
        return results, changes | {name: parts[name] for name in wanted}

    def _jacobian(self, names: tuple[str, ...], states: Any, values: Arrays) -> NDArray[np.float64]:
        """Return the derivatives of state and time, (..., 10, k), on the host.

        Parameters
        ----------
        names
            The k variables.
        states, values
            States and parameters.
        """
        lead = np.shape(states)[:-1]
        given = dict(zip(self._names, values, strict=True))
        finite = [name for name in names if name in STATE or np.isfinite(given[name]).all()]
        found = np.zeros((math.prod(lead), len(STATE) + 1, len(names)))
        if finite and len(found):
            shots = self._run(states, values, fields=("outcome",), derivatives=finite)
            columns = [names.index(name) for name in finite]
            rows = [shots.jacobian[name] for name in DIFFERENTIABLE]
            found[..., columns] = np.concatenate(rows, axis=1)
            if self._options.zero:
                found[~shots.differentiable] = 0.0
        return found.reshape(*lead, *found.shape[1:])


def _expanded(value: Any, lead: tuple[int, ...]) -> NDArray[np.float64]:
    """Return a parameter with one value a shot, (n,).

    Parameters
    ----------
    value
        Its values, of a shape that `lead` begins with.
    lead
        The shape of the shots.
    """
    array = np.asarray(value, np.float64)
    spread = array.reshape((*array.shape, *(1,) * (len(lead) - array.ndim)))
    return np.broadcast_to(spread, lead).reshape(-1)


def _array_type(shape: tuple[int, ...], dtype: Any = np.float64) -> Any:
    """Return the description of an array's shape and type for JAX."""
    return jax.ShapeDtypeStruct(shape, dtype)  # type: ignore[no-untyped-call]
