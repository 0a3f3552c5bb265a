"""Chunks on a Dask cluster of two worker processes: the bits of one machine, whoever is lost."""

from __future__ import annotations

import contextlib
import os
import signal
import socket
import subprocess
import sys
import threading
import time
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import pytest

pa = pytest.importorskip("pyarrow")
pytest.importorskip("pyarrow.parquet")
distributed = pytest.importorskip("distributed")

import hoopgen  # noqa: E402
from hoopgen.study.jobs import chunks, executors  # noqa: E402
from hoopgen.study.models import scatter  # noqa: E402
from hoopgen.study.questions.aim_table import aim_table  # noqa: E402
from tests.helpers import ROOT, contents  # noqa: E402

pytestmark = [pytest.mark.sampled(1), pytest.mark.xdist_group("cluster")]


@dataclass(frozen=True)
class Free:
    """A job as studies have them: free throws, drawn by index and simulated."""

    chunks: int | None = 24
    pause: float = 0.0  # s

    def compute(self, chunk: int) -> Any:
        time.sleep(self.pause)
        mean = {"speed": 7.17, "elevation": 0.9, "height": 2.13, "distance": 4.19}
        model = scatter.Scatter(mean, {"speed": 0.07, "azimuth": 0.02, "restitution": 0.02})
        shots = model.draw(200 * chunk, 200 * (chunk + 1), 5)
        results = hoopgen.simulate(shots.states, shots.parameters, threads=1)
        return pa.table({"time": results.time, "x": results.state[:, 0], "n": results.contacts})

    def identity(self) -> Mapping[str, Any]:
        return {"job": "free throws"}


@pytest.fixture(scope="module")
def cluster() -> Iterator[Any]:
    """Two workers, each a process; one that is killed is started anew."""
    with distributed.LocalCluster(
        n_workers=2,
        threads_per_worker=1,
        processes=True,
        host="127.0.0.1",
        scheduler_port=0,
        dashboard_address="127.0.0.1:0",
    ) as cluster:
        yield cluster


def processes(cluster: Any) -> list[int]:
    """The process of each worker."""
    with distributed.Client(cluster.scheduler_address, set_as_default=False) as client:
        client.wait_for_workers(2, timeout=60)
        return list(client.run(os.getpid).values())


def test_a_worker_killed_in_the_middle_changes_no_bit(cluster: Any, tmp_path: Path) -> None:
    here = list(chunks.run(Free(), tmp_path / "here"))
    there = []
    for table in chunks.run(
        Free(pause=0.05), tmp_path / "there", scheduler=cluster.scheduler_address
    ):
        if len(there) == 6:
            os.kill(processes(cluster)[0], signal.SIGKILL)
        there.append(table)
    assert there == here
    assert contents(tmp_path / "there") == contents(tmp_path / "here")
    assert len({*processes(cluster)}) == 2


def test_a_cluster_goes_on_where_one_machine_stopped(cluster: Any, tmp_path: Path) -> None:
    here = list(chunks.run(Free(), tmp_path / "here"))
    some = chunks.run(Free(), tmp_path / "there", threads=1)
    next(some)
    some.close()
    assert len(contents(tmp_path / "there")) < len(contents(tmp_path / "here"))
    assert list(chunks.run(Free(), tmp_path / "there", scheduler=cluster.scheduler_address)) == here
    assert contents(tmp_path / "there") == contents(tmp_path / "here")


def test_a_table_is_simulated_to_the_same_bytes(cluster: Any, tmp_path: Path) -> None:
    random = np.random.default_rng(3)
    numbers = {
        "speed": random.normal(7.1, 0.2, 300),
        "elevation_rad": random.normal(0.9, 0.05, 300),
    }
    text = pa.array([f"throw {k}" for k in range(300)]).dictionary_encode()
    pa.parquet.write_table(pa.table({**numbers, "name": text}), tmp_path / "throws.parquet")
    options = {"release": {"height": 2.1, "distance": 4.2}, "measures": ["depth"], "rows": 40}
    hoopgen.batch(tmp_path / "throws.parquet", tmp_path / "here.parquet", **options)
    hoopgen.batch(
        *(tmp_path / "throws.parquet", tmp_path / "there.parquet"),
        scheduler=cluster.scheduler_address,
        **options,
    )
    assert (tmp_path / "there.parquet").read_bytes() == (tmp_path / "here.parquet").read_bytes()


def test_a_search_and_an_aim_find_the_same(cluster: Any, tmp_path: Path) -> None:
    address = cluster.scheduler_address
    place = {"height": 2.13, "distance": 4.19, "elevation": 0.9}
    player, over = hoopgen.Scatter(place, {"speed": 0.07, "azimuth": 0.02}), {"aim": (0.0, 0.1)}
    options: dict[str, Any] = {"shots": 40_000, "margins": []}
    here = hoopgen.optimum(player, over, **options, folder=tmp_path / "here")
    there = hoopgen.optimum(player, over, **options, folder=tmp_path / "there", scheduler=address)
    assert there == here
    assert contents(tmp_path / "there") == contents(tmp_path / "here")
    rows = np.linspace(3.0, 5.0, 20)
    table = aim_table(rows, height=2.1, scheduler=address)
    for name, column in aim_table(rows, height=2.1).items():
        np.testing.assert_array_equal(table[name], column)


def test_an_error_of_the_job_comes_from_the_worker(cluster: Any) -> None:
    class Fails(Free):
        def compute(self, chunk: int) -> Any:
            raise ArithmeticError(f"chunk {chunk}")

    with pytest.raises(ArithmeticError, match="chunk 0"):
        next(chunks.run(Fails(), scheduler=cluster.scheduler_address))


PACKAGES = ["hoopgen", "numpy"]


@pytest.mark.parametrize("package", PACKAGES)
def test_workers_with_other_versions_are_refused(
    package: str, cluster: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    others = {**executors.versions(), package: "9.9"}
    monkeypatch.setattr(executors, "versions", lambda: others)
    with pytest.raises(
        RuntimeError, match=rf"the worker tcp://.* has {package} .*, and here it is 9\.9; install"
    ):
        next(chunks.run(Free(), scheduler=cluster.scheduler_address))


@pytest.mark.parametrize("package", PACKAGES)
def test_a_late_worker_with_other_versions_computes_nothing(package: str) -> None:
    with pytest.raises(RuntimeError, match=rf"a worker has {package} .*, not 9\.9"):
        executors._on_worker({**executors.versions(), package: "9.9"}, lambda: pa.table({}))


# Who is not there

BAD = {
    "10.0.0.1": "missing port",
    "tcp://10.0.0.1": "missing port",
    "tcp://10.0.0.1:port": "'port'",
    "tcp://10.0.0.1:99999": "no host and port",
    "tcp://:8786": "no host and port",
    "http://10.0.0.1:8786": "'http'",
    "": "missing port",
}


@pytest.mark.parametrize("address", BAD)
def test_an_address_is_looked_at_before_a_folder_is_made(address: str, tmp_path: Path) -> None:
    said = rf"scheduler: expected an address such as tcp://10\.0\.0\.1:8786, got .*{BAD[address]}"
    with pytest.raises(ValueError, match=said):
        next(chunks.run(Free(), tmp_path / "folder", scheduler=address))
    table, out = tmp_path / "throws.csv", tmp_path / "out.parquet"
    table.write_text("speed,elevation,height,distance\n7,0.9,2,4\n")
    with pytest.raises(ValueError, match=said):
        hoopgen.batch(table, out, scheduler=address)
    assert [*tmp_path.iterdir()] == [table]


def test_where_no_scheduler_answers_it_is_said_and_no_folder_stays(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(executors, "CONNECT", 1)
    said = "no Dask scheduler answers at 'tcp://127.0.0.1:1' within 1 s"
    with pytest.raises(ConnectionError, match=said):
        next(chunks.run(Free(), tmp_path / "folder", scheduler="tcp://127.0.0.1:1"))
    assert [*tmp_path.iterdir()] == []


def test_what_the_system_says_of_a_connection_is_said(monkeypatch: pytest.MonkeyPatch) -> None:
    # The last of several tries may be cut short by the clock instead, and then says nothing.
    async def refused(*_: object, **__: object) -> None:
        raise OSError("Timed out") from ConnectionRefusedError(111, "Connection refused")

    monkeypatch.setattr("distributed.comm.core.connect", refused)
    said = r"no Dask scheduler answers at 'tcp://127.0.0.1:1' within 5 s \(Connection refused\)"
    with pytest.raises(ConnectionError, match=said):
        executors._connected("tcp://127.0.0.1:1")


@pytest.mark.parametrize(
    ("greeting", "said"),
    [
        (b"", "no Dask scheduler answers at 'tcp://.*' within 0.1 s"),
        (b"SSH-2.0-OpenSSH_9.2p1\r\n", "what is at 'tcp://.*' .* is no Dask scheduler"),
    ],
)
def test_what_is_no_scheduler_is_not_waited_for(
    greeting: bytes, said: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(executors, "CONNECT", 0.1 if not greeting else 60)
    with socket.create_server(("127.0.0.1", 0)) as server:

        def greet() -> None:
            with contextlib.suppress(OSError), contextlib.ExitStack() as stack:
                while True:
                    stack.enter_context(server.accept()[0]).sendall(greeting)

        threading.Thread(target=greet, daemon=True).start()
        address = f"tcp://127.0.0.1:{server.getsockname()[1]}"
        with pytest.raises(ConnectionError, match=said):
            next(chunks.run(Free(), scheduler=address))
        server.shutdown(socket.SHUT_RDWR)


@pytest.mark.parametrize("certificate", ["", "none.pem"])
def test_an_address_with_certificates_says_which_are_missing(certificate: str) -> None:
    names = ("ca-file", "client.cert", "client.key")
    keys = {f"distributed.comm.tls.{name}": certificate or None for name in names}
    import dask

    said = "Dask's certificates: " if certificate else "needs certificates: distributed.comm.tls"
    with dask.config.set(keys), pytest.raises(ValueError, match=f"^scheduler: 'tls://.*{said}"):
        next(chunks.run(Free(), scheduler="tls://127.0.0.1:1"))


def test_workers_are_waited_for_and_it_is_said_once_each_time(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """None at first; and then the only one goes."""
    monkeypatch.setattr(executors, "PATIENCE", 0.1)
    said: list[str] = []
    with distributed.LocalCluster(
        n_workers=0,
        threads_per_worker=1,
        processes=False,
        protocol="tcp",
        host="127.0.0.1",
        dashboard_address=None,
    ) as cluster:

        def report(line: str) -> None:
            said.append(line)
            cluster.scale(1)

        tables = chunks.run(Free(), scheduler=cluster.scheduler_address, report=report)
        there = [next(tables)]
        line = f"waiting for workers of {cluster.scheduler_address}"
        assert said == [line]
        cluster.scale(0)
        cluster.sync(cluster._correct_state)
        there.extend(tables)
    assert there == list(chunks.run(Free()))
    assert said == [line, line]


CLUSTER = """
import os, distributed
with distributed.LocalCluster(
    n_workers=1, threads_per_worker=1, processes=False, protocol="tcp", host="127.0.0.1",
    dashboard_address=None,
) as cluster:
    print(cluster.scheduler_address, flush=True)
    sys.stdin.read()
"""

GONE = """
tables = chunks.run(Free(pause=0.01), sys.argv[2], scheduler=sys.argv[1])
try:
    next(tables)
    os.kill(int(sys.argv[3]), int(sys.argv[4]))
    list(tables)
except ConnectionError as error:
    print(error)
"""


def script(body: str, *arguments: str) -> list[str]:
    """Return a command that runs a text of Python with this module at hand."""
    head = f"import sys; sys.path.append({str(ROOT)!r})\n"
    head += "from tests.study.jobs.test_cluster import *\n"
    return [sys.executable, "-c", head + body, *arguments]


@pytest.mark.parametrize("how", [signal.SIGKILL, signal.SIGTERM])
def test_a_scheduler_that_is_gone_is_one_line_and_finished_chunks_stay(
    how: signal.Signals, tmp_path: Path
) -> None:
    with subprocess.Popen(
        script(CLUSTER), stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    ) as cluster:
        assert cluster.stdout is not None
        address = cluster.stdout.readline().strip()
        command = script(GONE, address, str(tmp_path), str(cluster.pid), str(int(how)))
        gone = subprocess.run(command, capture_output=True, text=True, check=False)
        cluster.kill()
    assert gone.stderr == ""
    assert gone.stdout == (
        f"scheduler: {address!r} is gone; finished chunks are kept, and the same call goes on from "
        "there\n"
    )
    assert gone.stderr == ""
    there = contents(tmp_path)
    assert "chunk-000000000.arrow" in there
    assert list(chunks.run(Free(), tmp_path)) == list(chunks.run(Free()))
    assert there.items() <= contents(tmp_path).items()
