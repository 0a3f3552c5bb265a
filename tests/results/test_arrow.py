"""Shots as a stream of Arrow: what pyarrow, Polars and DuckDB read, and what is not copied."""

from __future__ import annotations

import gc
from typing import Any

import numpy as np
import pytest

import hoopgen
from hoopgen.simulation.engine import Engine

pa = pytest.importorskip("pyarrow", reason="the extra study is missing")


def shots(scene: Engine = hoopgen.HOOP, count: int = 300) -> hoopgen.Shots:
    random = np.random.default_rng(5)
    speed = random.normal(7.17, 0.15, count)
    states = hoopgen.release(speed, 0.9, backspin=18, height=2.13, distance=4.19)
    states[3, 0] = np.nan
    return scene.simulate(states, time_limit=2.0)


@pytest.mark.parametrize("scene", [hoopgen.HOOP, hoopgen.COURT], ids=["hoop", "court"])
def test_the_table_has_what_to_pandas_has(scene: Engine) -> None:
    pd = pytest.importorskip("pandas")
    found = shots(scene)
    table = pa.table(found)
    assert table.schema.metadata[b"scene"].decode() == found.to_pandas().attrs["scene"]
    read = table.to_pandas().set_index("shot")
    pd.testing.assert_frame_equal(read, found.to_pandas(), check_index_type=False, check_exact=True)
    assert table["first"].null_count == (found.first < 0).sum() > 0


def test_columns_of_one_number_a_shot_are_not_copied() -> None:
    found = shots()
    table = found.to_arrow()
    for name, column in (("time_s", found.time), ("contacts", found.contacts)):
        _, buffer = table[name].chunk(0).buffers()
        assert buffer.address == column.ctypes.data
    (indices,) = {table["outcome"].chunk(0).indices.buffers()[1].address}
    assert indices == found.outcome.ctypes.data


@pytest.mark.slow
def test_a_table_keeps_its_numbers_when_the_shots_are_gone() -> None:
    found = shots(count=40_000)  # whose memory is taken again
    table, time = found.to_arrow(), found.time.copy()
    del found
    gc.collect()
    others = [shots(count=40_000).time for _ in range(4)]
    assert all(other.tobytes() == time.tobytes() for other in others)
    for other in others:
        other[:] = 0.0
    assert table["time_s"].to_numpy().tobytes() == time.tobytes()


def test_only_the_results_asked_for_are_columns() -> None:
    state = hoopgen.release(7.17, 0.9, height=2.13, distance=4.19)
    found = hoopgen.simulate(state, fields=("time", "state_error"))
    names = found.to_arrow().column_names
    assert names[:2] == ["shot", "time_s"]
    assert len(names) == 5


def test_polars_reads_shots() -> None:
    polars = pytest.importorskip("polars")
    found = shots()
    frame: Any = polars.DataFrame(found)
    assert np.array_equal(frame["time_s"].to_numpy(), found.time, equal_nan=True)
    made = frame.filter(polars.col("outcome") == "made").height
    assert made == found.made.sum()


def test_duckdb_reads_shots() -> None:
    duckdb = pytest.importorskip("duckdb")
    found = shots()
    query = "select count(*) from found where outcome = 'made'"
    ((made,),) = duckdb.sql(query).fetchall()
    assert made == found.made.sum()
