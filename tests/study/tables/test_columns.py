"""Tables of releases: what columns say, and that reading them changes nothing and loses nothing."""

from __future__ import annotations

import decimal
import json
import math
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from hoopgen.core.units import UNITS, column_name, parse_quantity

pa = pytest.importorskip("pyarrow")
pq = pytest.importorskip("pyarrow.parquet")

from hoopgen.core.variables import STATE  # noqa: E402
from hoopgen.hoop.variables import VARIABLES  # noqa: E402
from hoopgen.simulation.hoop import HOOP  # noqa: E402
from hoopgen.study.measures.measures import MEASURES  # noqa: E402
from hoopgen.study.tables import columns  # noqa: E402
from hoopgen.study.tables import source as source_module  # noqa: E402
from hoopgen.study.tables.columns import NAMED, Column, columns_of, values  # noqa: E402
from hoopgen.study.tables.source import Source  # noqa: E402

FREE_THROW = ["speed", "elevation_deg", "height", "distance"]
RELEASE = ["speed", "elevation", "height", "distance"]


def csv(folder: Path, text: str) -> Source:
    """A file of CSV with this in it."""
    file = folder / "table.csv"
    file.write_bytes(text.encode())
    return Source(file)


def column(cells: Any, name: str = "speed", unit: float = 1.0) -> list[float]:
    """Numbers that cells are read as."""
    table = pa.table({name: cells})
    return list(values(table, {name: Column(name, unit)})[name])


# Columns


@pytest.mark.parametrize(
    ("name", "variable", "text"),
    [
        ("speed", "speed", "1m/s"),
        ("speed_m_s", "speed", "1m/s"),
        ("speed_ft_s", "speed", "1ft/s"),
        ("speed_km_h", "speed", "1km/h"),
        ("speed_mph", "speed", "1mph"),
        ("speed_kph", "speed", "1km/h"),
        ("speed_cm_s", "speed", "1cm/s"),
        ("speed_feet_per_second", "speed", "1ft/s"),
        ("elevation_rad", "elevation", "1rad"),
        ("elevation_degrees", "elevation", "1deg"),
        ("height_feet", "height", "1ft"),
        ("backspin_revolutions_per_minute", "backspin", "1rpm"),
        ("elevation_deg", "elevation", "1deg"),
        ("backspin_hz", "backspin", "1Hz"),
        ("backspin_rpm", "backspin", "1rpm"),
        ("sidespin_deg_s", "sidespin", "1deg/s"),
        ("height_ft", "height", "1ft"),
        ("ball_radius_in", "ball_radius", "1in"),
        ("gravity_ft_s2", "gravity", "1ft/s2"),
        ("restitution", "restitution", "1"),
        (" Distance_CM ", "distance", "1cm"),
    ],
)
def test_the_unit_is_in_the_name(name: str, variable: str, text: str) -> None:
    others = [other for other in FREE_THROW if not other.startswith(variable)]
    found = columns_of([*others, "player", name])
    kind = VARIABLES[variable].kind
    assert found[variable] == Column(name, parse_quantity(text, kind))
    assert sorted(found) == sorted({*RELEASE, variable})


@pytest.mark.parametrize("name", [*VARIABLES, *STATE])
def test_a_column_named_with_any_unit_is_read_in_that_unit(name: str) -> None:
    kind = columns._kinds(HOOP)[name]
    for unit, size in UNITS[kind].items():
        assert columns.variable_of(column_name(name, unit)) == (name, size)


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("elevation", "elevation_deg or elevation_rad"),
        (" Azimuth", "azimuth_deg or azimuth_rad"),
        ("entry", "entry_deg or entry_rad"),
        ("backspin", "backspin_hz, backspin_rpm, backspin_rad_s or backspin_deg_s"),
        ("wy", "wy_hz, wy_rpm, wy_rad_s or wy_deg_s"),
    ],
)
def test_a_bare_angle_or_spin_is_refused_with_its_readings(name: str, said: str) -> None:
    expected = f"column {name} has no unit: name it {said}. If it is a column of your own, list it"
    with pytest.raises(ValueError, match=re.escape(expected)):
        columns_of([name, *FREE_THROW])
    assert list(columns_of([*FREE_THROW, name], own=[name])) == RELEASE


def test_a_bare_angle_whose_name_cannot_change_is_read_as_the_message_says() -> None:
    names = ["speed", "elevation", "height", "distance"]
    with pytest.raises(ValueError, match="column elevation has no unit") as raised:
        columns_of(names)
    assert str(raised.value).endswith("say --column elevation_deg=elevation")
    found = columns_of(names, columns={"elevation_deg": "elevation"})
    assert found["elevation"] == Column("elevation", math.pi / 180)


def test_a_bare_column_of_what_is_given_elsewhere_is_not_read() -> None:
    found = columns_of([*FREE_THROW, "backspin"], given=["backspin"])
    assert list(found) == RELEASE


def test_bare_angles_are_radians_in_files_that_an_older_version_wrote() -> None:
    columns = pa.schema(
        [(name, pa.float64()) for name in ("speed", "elevation", "height", "distance")]
    )
    old = columns.with_metadata({"hoopgen": json.dumps({"version": "0.1.0", "release": {}})})
    assert columns_of(old)["elevation"] == Column("elevation", 1.0)
    new = columns.with_metadata({"hoopgen": json.dumps({"version": "0.1.0", NAMED: True})})
    for schema in (columns, new, columns.with_metadata({"hoopgen": "{"})):
        with pytest.raises(ValueError, match="column elevation has no unit"):
            columns_of(schema)


def test_states_have_units_too() -> None:
    names = ["x_ft", "y_ft", "z_ft", "vx_ft_s", "vy_ft_s", "vz_ft_s", "wx_rpm", "wy_rpm", "wz_rpm"]
    found = columns_of(names)
    assert [found[name].name for name in STATE] == names
    sizes = [0.3048] * 6 + [2 * math.pi / 60] * 3
    assert [found[name].unit for name in STATE] == sizes


@pytest.mark.parametrize("missing", [("wx", "wy", "wz"), ("wz",), ()])
def test_a_state_may_lack_spin(missing: tuple[str, ...]) -> None:
    names = [name for name in STATE if name not in missing]
    units = {"wx": "wx_rad_s", "wy": "wy_hz", "wz": "wz_rpm"}
    assert list(columns_of([units.get(name, name) for name in names])) == names


def test_x_and_y_are_a_place_unless_there_is_more_of_a_state() -> None:
    assert [*columns_of(["x", "y", "speed", "elevation_deg", "height"])][:2] == ["x", "y"]


@pytest.mark.parametrize(
    ("names", "said"),
    [
        ([*FREE_THROW, "backspin_knots"], "column backspin_knots: knots is no unit of backspin; "),
        ([*FREE_THROW, "backspin_m_s"], "expected backspin_rad_s, backspin_deg_s, "),
        ([*FREE_THROW, "restitution_pct"], "pct is no unit of restitution; expected restitution"),
        ([*FREE_THROW, "speed_mph"], "columns speed and speed_mph both say speed"),
        ([*FREE_THROW, "Speed"], "columns speed and Speed both say speed"),
        ([*FREE_THROW, "vx"], "vx say that the rows are states, and speed, elevation_deg, height"),
        (
            ["speed_mph", "elevation_deg"],
            r"missing height, distance. The columns are speed_mph, elev",
        ),
        (["x", "y", "z", "vx", "vy"], "a state needs vz too"),
        (["player", "made"], "no column says how a shot is released: player, made"),
        ([], "no column says how a shot is released: none"),
    ],
)
def test_columns_that_are_not_clear_are_refused(names: list[str], said: str) -> None:
    with pytest.raises(ValueError, match=said):
        columns_of(names)


def test_own_columns_are_let_alone_whatever_their_names() -> None:
    own = ["speed_knots", "vx", "Distance"]
    assert list(columns_of([*FREE_THROW, *own], own)) == RELEASE
    with pytest.raises(ValueError, match="own: no column vy; there are speed"):
        columns_of(FREE_THROW, ["vy"])


@pytest.mark.parametrize("measure", MEASURES)
@pytest.mark.parametrize("suffix", ["", "_deg", "_m_s"])
def test_what_is_measured_is_no_variable(measure: str, suffix: str) -> None:
    assert list(columns_of([*FREE_THROW, measure + suffix])) == RELEASE


NEARLY = {
    "azimut_deg": "azimuth",
    "back_spin_hz": "backspin",
    "Side Spin (rpm)": "sidespin",
    "hight_ft": "height",
    "azimuth [deg]": "azimuth",
    "restitutoin": "restitution",
    "ring_raduis_in": "ring_radius",
    "release_azimuth_deg": "azimuth",
    "v_x": "vx",
}


@pytest.mark.parametrize("name", NEARLY)
def test_a_column_that_nearly_names_a_variable_is_asked_about(name: str) -> None:
    variable = NEARLY[name]
    others = [other for other in FREE_THROW if not other.startswith(variable)]
    with pytest.raises(ValueError, match=r"nearly names \w+") as raised:
        columns_of([*others, name])
    said = str(raised.value)
    assert f"column {name} nearly names {variable}: " in said
    assert "--own " in said
    if variable not in RELEASE:
        assert list(columns_of([*FREE_THROW, name], own=[name])) == RELEASE


@pytest.mark.parametrize(
    "name",
    [
        "weight",
        "weight_lb",
        "player",
        "game_id",
        "shot_id",
        "made",
        "team",
        "time",
        "time_s",
        "date",
        "season",
        "quarter",
        "spin",
        "side",
        "defender_distance_ft",
        "shooter_height_in",
        "shot_distance_ft",
        "arc",
        "angel",
        "sp",
        "eed",
        "aims",
        "high",
        "low",
        "shots",
        "outcome",
        "first",
        "kind",
        "contacts",
        "end_x_m",
        "sd_speed_m_s",
        "correlation_speed_elevation",
        "seed",
        "source",
        "probability",
        "release_time_s",
        "release_id",
        "ball",
        "ring",
        "note",
        "entry_angle_rad",
    ],
)
def test_a_column_with_another_word_is_let_alone(name: str) -> None:
    assert list(columns_of([*FREE_THROW, name])) == RELEASE


def test_what_another_column_says_is_not_asked_about() -> None:
    assert list(columns_of([*FREE_THROW, "hight_ft", "speed (mph)"])) == RELEASE


def test_what_is_given_elsewhere_is_neither_read_nor_missed() -> None:
    found = columns_of(["speed", "elevation_deg", "height_ft"], given=["height", "distance"])
    assert list(found) == ["speed", "elevation"]


# Cells


def test_every_double_is_read_as_it_was_written(tmp_path: Path) -> None:
    random = np.random.default_rng(5)
    numbers = random.integers(0, 2**64, 2000, dtype=np.uint64).view(np.float64)
    numbers = numbers[np.isfinite(numbers)]
    source = csv(tmp_path, "speed\n" + "\n".join(map(repr, numbers.tolist())))
    (table,) = source.tables(5000)
    assert values(table, {"speed": Column("speed", 1.0)})["speed"].tolist() == numbers.tolist()


@pytest.mark.parametrize("unit", [1.0, 0.3048])
def test_a_cell_that_is_no_number_is_that_cell_alone(unit: float) -> None:
    cells = ["7", "", "seven", " 7.5 ", "7,5", "0x7", "inf", "nan", "1e400", "+.5e1", "7 m/s"]
    numbers = [7, None, None, 7.5, None, None, None, None, None, 5, None]
    read = column(cells, unit=unit)
    for cell, number, found in zip(cells, numbers, read, strict=True):
        assert math.isnan(found) if number is None else found == number * unit, cell


@pytest.mark.parametrize(
    ("cells", "numbers"),
    [
        (pa.array([1, None], pa.int8()), [1, math.nan]),
        (pa.array([2**53 + 1], pa.int64()), [2.0**53]),
        (pa.array([0.1], pa.float32()), [float(np.float32(0.1))]),
        (pa.array([None, None]), [math.nan, math.nan]),
        (pa.array([decimal.Decimal("1.5")]), [1.5]),
        (pa.array(["7", "x", "7"]).dictionary_encode(), [7, math.nan, 7]),
        (pa.array([7.0, 8.0, 7.0]).dictionary_encode(), [7, 8, 7]),
        (pa.array(["7", None], pa.large_string()), [7, math.nan]),
        (pa.array([], pa.string()), []),
    ],
)
def test_numbers_of_every_type(cells: Any, numbers: list[float]) -> None:
    np.testing.assert_array_equal(column(cells, "vx"), numbers)


@pytest.mark.parametrize("cells", [[True], [[1.0]], [{"a": 1.0}]])
def test_a_column_that_holds_no_numbers_is_refused(cells: Any) -> None:
    with pytest.raises(ValueError, match="column speed: expected numbers, got "):
        column(cells)


# Files

TABLE = pa.table(
    {
        "speed": [7.0 + k / 7 for k in range(50)],
        "id": [f"00{k}" for k in range(50)],
        "note": ['a "quoted" one,\nin two lines' if k % 3 else "" for k in range(50)],
    }
)


def _as_csv(file: Path, block: int) -> None:
    pa.csv.write_csv(TABLE, file)


def _as_parquet(file: Path, block: int) -> None:
    pq.write_table(TABLE, file, row_group_size=block)


def _as_arrow_file(file: Path, block: int) -> None:
    with pa.ipc.new_file(str(file), TABLE.schema) as writer:
        writer.write_table(TABLE, block)


def _as_arrow_stream(file: Path, block: int) -> None:
    with pa.ipc.new_stream(str(file), TABLE.schema) as writer:
        writer.write_table(TABLE, block)


FILES = {
    "table.csv": _as_csv,
    "table.parquet": _as_parquet,
    "table.feather": _as_arrow_file,
    "table.arrow": _as_arrow_stream,
}


@pytest.mark.parametrize("block", [1, 7, 50])
@pytest.mark.parametrize("rows", [1, 8, 25, 50, 60])
@pytest.mark.parametrize("name", FILES)
def test_tables_have_the_rows_asked_for_whatever_the_blocks_of_the_file(
    name: str, rows: int, block: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(source_module, "BLOCK", 100 + 10 * block)  # of CSV
    FILES[name](tmp_path / name, block)
    source = Source(tmp_path / name)
    read = list(source.tables(rows))
    assert [len(table) for table in read] == [len(TABLE[k : k + rows]) for k in range(0, 50, rows)]
    together = pa.concat_tables(read)
    assert together.schema == source.schema()
    assert together.select(["id", "note"]) == TABLE.select(["id", "note"])
    speed = values(together, {"speed": Column("speed", 1.0)})["speed"]
    assert speed.tolist() == TABLE["speed"].to_pylist()


@pytest.mark.parametrize("name", FILES)
def test_a_table_without_rows_is_one_table(name: str, tmp_path: Path) -> None:
    empty = TABLE.slice(0, 0)
    if name == "table.csv":
        (tmp_path / name).write_text("speed,id,note\n", encoding="utf-8")
    elif name == "table.parquet":
        pq.write_table(empty, tmp_path / name)
    else:
        new = pa.ipc.new_stream if name == "table.arrow" else pa.ipc.new_file
        new(str(tmp_path / name), empty.schema).close()
    (table,) = Source(tmp_path / name).tables(10)
    assert len(table) == 0
    assert table.column_names == ["speed", "id", "note"]


CELLS = {
    "whole": (["7", "-12", ""], pa.int64(), [7, -12, None]),
    "number": (["7", "-1.5", "1e-07"], pa.float64(), [7.0, -1.5, 1e-07]),
    "truth": (["True", "", "False"], pa.bool_(), [True, None, False]),
    "game": (["0022400001", "1", ""], pa.string(), ["0022400001", "1", ""]),
    "long": (["1234567890123456", "1", "2"], pa.string(), ["1234567890123456", "1", "2"]),
    "room": (["12E4", "12", "13"], pa.string(), ["12E4", "12", "13"]),
    "late": (["1", "2", "x"], pa.string(), ["1", "2", "x"]),
    "none": (["", "", ""], pa.string(), ["", "", ""]),
    "formula": (["=1+1", "2", "+3"], pa.string(), ["=1+1", "2", "+3"]),
}


@pytest.mark.parametrize("block", [40, 1 << 20])
@pytest.mark.parametrize("name", CELLS)
def test_columns_of_csv_have_the_type_of_all_their_cells(
    name: str, block: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(source_module, "BLOCK", block)
    cells, kind, read = CELLS[name]
    rows = zip(["7.0", "fast", ""], cells, strict=True)
    source = csv(tmp_path, f"speed,{name}\n" + "".join(f"{a},{b}\n" for a, b in rows))
    schema = source.typed({"speed": Column("speed", 1.0)})
    assert schema == pa.schema([("speed", pa.float64()), (name, kind)])
    whole = pa.concat_tables(source.cast(table, schema) for table in source.tables(2))
    assert whole.to_pydict() == {"speed": [7.0, None, None], name: read}


@pytest.mark.parametrize(
    ("text", "between"),
    [
        ("speed,note\n7.5,a;b;c\n", ","),
        ("speed;note\n7,5;a\n", ";"),
        ("speed\tnote\r\n7,5\ta\r\n", "\t"),
        ('\n"speed";"a,b,c"\n7,5;x\n', ";"),
        ("speed\n7.5\n", ","),
    ],
)
def test_delimiters_and_decimal_commas(text: str, between: str, tmp_path: Path) -> None:
    for source in (csv(tmp_path, text), Source(csv(tmp_path, text).path, delimiter=between)):
        assert source.between == between
        (table,) = source.tables(10)
        read = source.values(table, {"speed": Column(table.column_names[0], 2.0)})
        assert read["speed"].tolist() == [15.0]


def test_a_decimal_comma_is_one_only_where_commas_do_not_separate(tmp_path: Path) -> None:
    for text in ('speed,k\n"7,5",1\n', "speed;k\n1.234,5;1\n"):
        source = csv(tmp_path, text)
        (table,) = source.tables(10)
        assert math.isnan(source.values(table, {"speed": Column("speed", 1.0)})["speed"][0])


@pytest.mark.parametrize("delimiter", ["; ", "a", '"', ".", "é", "\n"])
def test_a_delimiter_that_is_none_is_refused(delimiter: str) -> None:
    with pytest.raises(ValueError, match="delimiter: expected one character such as ; or ,"):
        Source(Path("t.csv"), delimiter=delimiter)
    with pytest.raises(ValueError, match=r"delimiter: t\.parquet is parquet; only CSV has one"):
        Source(Path("t.parquet"), delimiter=";")


def test_csv_is_read_as_text(tmp_path: Path) -> None:
    (table,) = csv(tmp_path, "\ufeffid,made\n007,NA\n1e3,true\n").tables(10)
    assert table.to_pydict() == {"id": ["007", "1e3"], "made": ["NA", "true"]}


def test_a_file_is_read_as_far_as_is_asked(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(source_module, "BLOCK", 100)
    file = tmp_path / "table.csv"
    file.write_bytes(b"speed,id\n" + b"7.0,1\n" * 1000 + b"7.0,\xff\n")
    read = Source(file).tables(10)
    assert len(next(read)) == 10
    with pytest.raises(ValueError, match=r"table\.csv: is not in UTF-8"):
        list(read)


def test_a_damaged_file_is_named(tmp_path: Path) -> None:
    file = tmp_path / "table.parquet"
    _as_parquet(file, 10)
    content = bytearray(file.read_bytes())
    content[4:50] = bytes(46)
    file.write_bytes(content)
    with pytest.raises(ValueError, match=r"table\.parquet: "):
        list(Source(file).tables(10))


@pytest.mark.parametrize("name", FILES)
def test_a_digest_changes_with_any_byte_and_rows_are_counted(name: str, tmp_path: Path) -> None:
    file = tmp_path / name
    FILES[name](file, 7)
    source = Source(file)
    digest, rows = source.digest()
    if name == "table.csv":
        assert rows == file.read_text(encoding="utf-8").count("\n") - 1
    else:
        assert rows == (50 if name == "table.parquet" else None)
    assert source.digest()[0] == digest
    content = bytearray(file.read_bytes())
    content[30] ^= 1
    (tmp_path / "other").write_bytes(content)
    assert Source(tmp_path / "other", "csv").digest()[0] != digest


@pytest.mark.parametrize(
    ("name", "content", "said"),
    [
        ("t.csv", b"", r"t\.csv: Empty CSV file"),
        ("t.csv", b"a,a\n1,2\n", r"t\.csv: two columns are named a$"),
        ("t.csv", b"a\n\xff\n", r"t\.csv: is not in UTF-8 but, it seems, in Latin-1"),
        ("t.csv", "tempo_é;speed\n".encode("latin-1"), r"t\.csv: is not in UTF-8 but"),
        ("t.csv", "speed\n7\n".encode("utf-16"), r"t\.csv: is in UTF-16, it seems; save it as"),
        ("t.csv", "speed\n7\n".encode("utf-16-be"), r"t\.csv: is in UTF-16"),
        ("t.parquet", b"speed\n7\n", r"t\.parquet: .*not a parquet file"),
        ("t.arrow", b"speed\n7\n", r"t\.arrow: "),
        ("t.txt", b"", r"t\.txt: the suffix is none of \.csv, \.tsv, \.parquet"),
    ],
)
def test_what_is_no_table_is_refused_by_name(
    name: str, content: bytes, said: str, tmp_path: Path
) -> None:
    (tmp_path / name).write_bytes(content)
    with pytest.raises(ValueError, match=said):
        list(Source(tmp_path / name).tables(10))


def test_a_format_that_is_not_known_is_refused() -> None:
    with pytest.raises(
        ValueError, match="format: expected one of csv, parquet, arrow, xlsx, got 'xls'"
    ):
        Source(Path("table.csv"), "xls")


@pytest.mark.parametrize("name", FILES)
def test_a_file_that_is_not_there_is_named(name: str, tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError) as raised:
        Source(tmp_path / name).schema()
    assert raised.value.filename == str(tmp_path / name)


def test_a_column_of_degrees_that_says_radians_is_refused() -> None:
    table = pa.table({"elevation_rad": [52.0, 51.0, None]})
    with pytest.raises(ValueError, match=r"columns: elevation is in radians.*elevation_deg"):
        values(table, columns_of(table.column_names, given=("speed", "height", "distance")))


def test_a_junk_angle_in_one_row_refuses_no_other() -> None:
    table = pa.table({"elevation_rad": [0.9, 999.0, 0.8]})
    given = ("speed", "height", "distance")
    numbers = values(table, columns_of(table.column_names, given=given))
    np.testing.assert_array_equal(numbers["elevation"], [0.9, math.nan, 0.8])
    numbers = values(table, columns_of(table.column_names, given=given, implausible=True))
    assert numbers["elevation"].tolist() == [0.9, 999.0, 0.8]
