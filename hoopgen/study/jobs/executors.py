"""Executors of chunks: threads of this process, or the workers of a Dask cluster."""

from __future__ import annotations

import asyncio
import contextlib
import logging
from collections.abc import Callable, Iterator, Mapping
from concurrent.futures import CancelledError, ThreadPoolExecutor
from dataclasses import dataclass
from importlib import metadata
from typing import Any

import pyarrow as pa

from hoopgen.core.extras import require, version
from hoopgen.core.validation import check_threads
from hoopgen.generated.numpy import elementary
from hoopgen.text.shorten import brief, cut

Task = Callable[[], pa.Table]
"""Computes one chunk; picklable."""

CONNECT = 5
"""Seconds in which a scheduler has to answer."""

PATIENCE = 5.0
"""Seconds until a note says that there are no workers."""

_EXAMPLE = "tcp://10.0.0.1:8786"


def versions() -> dict[str, str]:
    """Return the versions, by name, of all that the bits of a chunk depend on.

    Releases are drawn with hoopgen's own elementary functions; NumPy sums what is measured.
    """
    own = {"hoopgen": version(), "elementary functions": elementary.DERIVATION}
    return own | {"numpy": metadata.version("numpy")}


@dataclass(frozen=True)
class Workers:
    """The threads or the workers of a cluster that compute.

    Attributes
    ----------
    look
        Called while a chunk is waited for, every `patience` seconds; None: not at all.
    """

    number: int  # how many chunks they compute at once
    compute: Callable[[Task], pa.Table]  # has one computed, and waits for it
    stop: Callable[[], None] = lambda: None  # frees the threads that wait
    look: Callable[[], object] = lambda: None
    patience: float | None = None
    remote: bool = False


def check_workers(scheduler: str | None, threads: int | None) -> None:
    """Raise an error for impossible arguments before any work, without a connection.

    Parameters
    ----------
    scheduler
        The address of a Dask scheduler; None: threads of this process compute.
    threads
        The number of threads; None: all cores. With a scheduler it must be None.

    Raises
    ------
    ValueError
        If both are given, or either is not allowed.
    """
    if scheduler is None:
        check_threads(threads)
        return
    if threads is not None:
        raise ValueError("threads: with a scheduler its workers say how many they have; leave out")
    _check_address(scheduler)


def _check_address(address: str) -> None:
    require("distributed", "scheduler: a Dask scheduler")
    from distributed.comm import addressing, registry

    try:
        scheme, place = addressing.parse_address(address)
        registry.get_backend(scheme)
        if scheme == "inproc":  # within this process: it has no port
            return
        host, port = addressing.parse_host_port(place)
        if not host or not 0 < port < 2**16:
            raise ValueError(f"{place!r} is no host and port")
    except (TypeError, ValueError) as error:
        raise ValueError(
            f"scheduler: expected an address such as {_EXAMPLE}, got {brief(address)}: "
            f"{cut(str(error))}"
        ) from None
    _credentials(address, scheme)


def _credentials(address: str, scheme: str) -> dict[str, Any]:
    """Return the arguments of a connection."""
    import distributed

    security: Any = distributed.Security()  # type: ignore[no-untyped-call]
    try:
        arguments: dict[str, Any] = security.get_connection_args("client")
    except OSError as error:  # those of certificates are such too
        raise ValueError(f"scheduler: {address!r}: Dask's certificates: {error}") from None
    if scheme in ("tls", "wss") and arguments.get("ssl_context") is None:
        raise ValueError(
            f"scheduler: {address!r} needs certificates: distributed.comm.tls in Dask's "
            "configuration, ca-file, client.cert and client.key"
        )
    return arguments


def make_workers(
    scheduler: str | None, threads: int | None, report: Callable[[str], None]
) -> contextlib.AbstractContextManager[Workers]:
    """Return those who compute; arguments and errors as of `hoopgen.study.jobs.chunks.run`.

    Parameters
    ----------
    scheduler
        The address of a Dask scheduler, such as ``tcp://host:8786``; None for threads of this
        process.
    threads
        The number of threads; None for one per processor. It must be None with a scheduler.
    report
        A function that is called with each line that tells the user of the cluster's state.

    Returns
    -------
    context manager
        It yields the workers, and closes the connection to a cluster at its end.

    Raises
    ------
    ValueError
        If both are given, or one of them is not as described.
    """
    check_workers(scheduler, threads)
    if scheduler is None:
        return contextlib.nullcontext(Workers(check_threads(threads), lambda task: task()))
    return _cluster(scheduler, report)


# ---------------------------------------------------------------------------------- on a cluster


@contextlib.contextmanager
def _cluster(address: str, report: Callable[[str], None]) -> Iterator[Workers]:
    """Connect to a Dask scheduler; each waiting thread has one chunk on the cluster."""
    import distributed

    here = versions()
    futures: set[Any] = set()
    stopping = False

    def compute(task: Task) -> pa.Table:
        future = None
        try:
            # With its task the scheduler can have a chunk computed again when a worker is lost.
            future = client.submit(_on_worker, here, task, pure=False)
            futures.add(future)
            if stopping:
                future.cancel()
            table: pa.Table = future.result()
            attendance.told = False  # somebody was there
            return table
        except distributed.scheduler.KilledWorker as error:
            raise RuntimeError(
                f"scheduler: a chunk was given up after {error.allowed_failures + 1} workers "
                "were lost with it; is there memory enough?"
            ) from None
        except Exception as error:
            lost = isinstance(error, CancelledError | distributed.comm.core.CommClosedError)
            if stopping or not (lost or client.status != "running"):
                raise
            raise _gone(address) from error
        finally:
            futures.discard(future)

    def stop() -> None:
        nonlocal stopping
        stopping = True
        if client.status == "running":
            with contextlib.suppress(OSError):
                client.cancel(list(futures))

    with _silenced(), _connected(address) as client:
        attendance = _Attendance(client, address, report)
        try:
            attendance.await_one()
            _check_versions(client, here)
            number = max(1, sum(client.nthreads().values()))
        except OSError as error:
            raise _gone(address) from error
        yield Workers(number, compute, stop, attendance.look, PATIENCE, remote=True)


def _gone(address: str) -> ConnectionError:
    return ConnectionError(f"scheduler: {address!r} is gone")


@contextlib.contextmanager
def _silenced() -> Iterator[None]:
    """Keep distributed's log off the terminal; errors contain what matters of it, once."""

    def nothing(_: logging.LogRecord) -> bool:
        return False

    # Its own handlers alone; those that the caller has for the log go on.
    handlers = list(logging.getLogger("distributed").handlers)
    for handler in handlers:
        handler.addFilter(nothing)
    try:
        yield
    finally:
        for handler in handlers:
            handler.removeFilter(nothing)


def _connected(address: str) -> Any:
    """Return a client of the scheduler at an address."""
    import distributed

    try:
        # A client that cannot connect takes long to say so, and longer to give up.
        with ThreadPoolExecutor(1) as apart:  # the caller may have a loop of its own
            apart.submit(asyncio.run, _greet(address)).result()
        return distributed.Client(  # type: ignore[no-untyped-call]
            address, set_as_default=False, timeout=CONNECT
        )
    except OSError as error:  # one that it took too long, too
        raise ConnectionError(
            f"scheduler: no Dask scheduler answers at {address!r} within {CONNECT} s"
            f"{_reason(error)}"
        ) from None
    except Exception as error:  # whatever it comes to when something else answers
        text = f"{type(error).__name__}: {error}"
        raise ConnectionError(
            f"scheduler: what is at {address!r} cannot be talked to, or is no Dask scheduler "
            f"({text})"
        ) from error


async def _greet(address: str) -> None:
    """Shake hands with what is at an address, and part."""
    from distributed.comm.addressing import parse_address
    from distributed.comm.core import connect

    arguments = _credentials(address, parse_address(address)[0])
    greeted = connect(  # type: ignore[no-untyped-call]
        address, timeout=0.8 * CONNECT, **arguments
    )
    # What accepts, and then says nothing at all, is waited for without an end.
    comm = await asyncio.wait_for(greeted, CONNECT)
    await comm.close()


def _reason(error: BaseException) -> str:
    """Return the system's message, if there is one."""
    found: BaseException | None = error
    while found is not None:
        if isinstance(found, OSError) and found.strerror:
            return f" ({found.strerror})"
        found = found.__cause__
    return ""


@dataclass
class _Attendance:
    """Return whether there are workers."""

    client: Any
    address: str
    report: Callable[[str], None]
    told: bool = False

    def await_one(self) -> None:
        """Wait until there is one."""
        while True:
            try:
                self.client.wait_for_workers(1, timeout=PATIENCE)
                self.told = False
                return
            except TimeoutError:
                self.look()

    def look(self) -> None:
        """Say, once until there are some again, that there are no workers."""
        try:
            there = bool(self.client.nthreads())
        except OSError:
            return  # the scheduler is gone: those who wait for chunks say so
        if not there and not self.told:
            self.report(f"waiting for workers of {self.address}")
        self.told = not there


def _check_versions(client: Any, here: Mapping[str, str]) -> None:
    """Refuse workers that would compute something else, or nothing."""
    for name in ("hoopgen", "numpy"):  # each worker compares all again
        ours = here[name]
        # A function of Python's own: a worker without hoopgen has none of ours.
        for worker, there in client.run(metadata.version, name, on_error="return").items():
            if there != ours:
                text = there if isinstance(there, str) else "none"
                raise RuntimeError(
                    f"scheduler: the worker {worker} has {name} {text}, and here it is {ours}; "
                    "install the same"
                )


def _on_worker(wanted: Mapping[str, str], task: Task) -> pa.Table:
    """Compute a chunk, unless the worker, perhaps a late comer, has other versions."""
    there = versions()
    for name, ours in wanted.items():
        if there[name] != ours:
            raise RuntimeError(f"scheduler: a worker has {name} {there[name]}, not {ours}")
    return task()
