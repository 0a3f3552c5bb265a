"""Films of shots: the ball is where the trajectory has it, at the time that is shown."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import hoopgen
from tests.helpers.commands import run, succeed

pytest.importorskip("matplotlib")

from matplotlib.colors import to_hex
from PIL import Image

from hoopgen.plots import save_film, style
from hoopgen.plots.animation import FRAME_RATE, Film, _speed
from hoopgen.plots.style import COLOURS

DROPPED = [0.22, 0.0, 0.35, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0]
"""Onto the front of the ring: a contact, and little to be drawn."""

STILL = [4.0, 0.0, -1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0]
"""Below the end plane: over as soon as it begins."""

ASIDE = [0.2, 0.05, 0.3, -0.3, 0.1, -1.0, 0.0, 3.0, 0.0]


def shot(state: list[float], scene: Any = None) -> Any:
    """A recorded shot, its parameters those of its scene."""
    parameters = None if scene is None else scene.parameters
    return hoopgen.simulate(np.array([state]), parameters, scene=scene, record=True).trajectory(0)


def film(path: Any, **options: Any) -> Film:
    with style():
        return Film(path, path.parameters, path.outcome, **options)


@pytest.mark.sampled(1)
@pytest.mark.parametrize("scene", [None, hoopgen.COURT], ids=["hoop", "court"])
@pytest.mark.parametrize("state", [DROPPED, ASIDE], ids=["in plane", "aside"])
def test_the_ball_is_where_the_trajectory_has_it(state: list[float], scene: Any) -> None:
    path = shot(state, scene)
    contact = float(path.events["time"][0])
    made = film(path)
    assert len(made._views) == (1 if state is DROPPED else 2)
    for time in (0.0, contact / 2, contact, np.nextafter(contact, 0.0), path.duration):
        made.show(float(time))
        x, y, z = path.at(time)[:3]
        for view, at in zip(made._views, [(x, z), (x, y)], strict=False):
            assert view.fill.get_center() == view.outline.get_center() == at
            assert view.fill.get_radius() == path.parameters["ball_radius"]
            # To scale: the axes show as many metres across as up, an inch.
            assert view.fill.axes.get_aspect() == 1.0


def test_frames_are_even_in_time_and_end_at_the_end() -> None:
    path = shot(DROPPED)
    for speed in (0.25, 1.0):
        times = film(path, speed=speed).times
        np.testing.assert_allclose(np.diff(times[:-1]), speed / FRAME_RATE, rtol=1e-12, atol=0)
        assert times[0] == 0.0
        assert times[-1] == path.duration
        assert 0.0 < times[-1] - times[-2] <= speed / FRAME_RATE


@pytest.mark.parametrize("duration", [0.0, 1.5, 1.7, 7.0, 60.0, 1e4])
def test_a_film_is_never_long_nor_faster_than_it_must_be(duration: float) -> None:
    speed = _speed(duration)
    assert duration * FRAME_RATE / speed <= 160.0 * (1 + 1e-12)
    assert speed == 0.25 or duration * FRAME_RATE / (speed / 2.5) > 160.0


def test_the_path_follows_the_ball_through_its_contacts() -> None:
    path = shot(DROPPED)
    made = film(path)
    contact = path.events["before"][0]
    for time, there in ((path.events["time"][0] - 0.01, False), (path.duration, True)):
        made.show(float(time))
        (view,) = made._views
        lines = [line.get_xydata() for _, _, line in view.pieces]
        points = np.concatenate([line for line in lines if len(line)])
        np.testing.assert_allclose(points[-1], path.at(time)[[0, 2]], rtol=0, atol=1e-12)
        away = np.linalg.norm(points - contact[[0, 2]], axis=1).min()
        assert (away < 1e-9) == there


def test_a_contact_is_seen_when_it_comes_and_stays_marked() -> None:
    path = shot(DROPPED)
    made = film(path)
    (view,) = made._views
    contact = float(path.events["time"][0])
    mark, artists = view.badges[0]
    assert (mark.label, mark.kind, mark.time) == ("1", "ring", contact)
    for time, seen, flash in (
        (contact - 1e-6, False, False),
        (contact, True, True),
        (path.duration - 1e-6, True, False),
    ):
        made.show(time)
        assert {artist.get_visible() for artist in artists} == {seen}
        lit = to_hex(view.outline.get_edgecolor(), keep_alpha=False) == COLOURS["ring"].lower()
        assert lit == flash
    assert made._clock.get_text() == f"{path.duration:.2f} s"


@pytest.mark.slow
def test_a_gif_shows_the_movement_in_its_time(tmp_path: Path) -> None:
    path = shot(DROPPED)
    file = save_film(path, path.parameters, tmp_path / "a.gif", outcome=path.outcome)
    assert file.stat().st_size < 300_000
    made = film(path)
    (view,) = made._views
    height = made.frame(0.0).shape[0]
    orange = np.array([int(COLOURS["ball"][k : k + 2], 16) for k in (1, 3, 5)])
    with Image.open(file) as image:
        assert image.n_frames == len(made.times)
        assert image.info["loop"] == 0
        for number in (0, 3, image.n_frames // 2, image.n_frames - 1):
            image.seek(number)
            assert image.info["duration"] == (1000 if number == image.n_frames - 1 else 40)
            pixels = np.asarray(image.convert("RGB")).astype(int)
            near = np.abs(pixels - (0.85 * orange + 0.15 * 255)).sum(axis=2) < 30
            rows, columns = np.nonzero(near)
            centre = np.array([columns.mean() + 0.5, height - rows.mean() - 0.5])
            wanted = view.fill.axes.transData.transform(path.at(made.times[number])[[0, 2]])
            # The path and its dots on the ball pull the mean of its pixels by a few.
            assert np.abs(centre - wanted).max() < 4.0
            # Nothing but the ball's colours moves the paper.
            assert pixels[0, 0].tolist() == [255, 255, 255]


@pytest.mark.slow
@pytest.mark.parametrize("state", [STILL, DROPPED])
def test_an_mp4_is_what_ffmpeg_makes_of_the_frames(
    state: list[float], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    if sys.platform == "win32":
        pytest.skip("a script is no program there")
    program = tmp_path / "ffmpeg"
    said = tmp_path / "said"
    program.write_text(
        f"#!{sys.executable}\n"
        "import sys, pathlib\n"
        f"pathlib.Path({str(said)!r}).write_text(' '.join(sys.argv))\n"
        "pathlib.Path(sys.argv[-1]).write_bytes(sys.stdin.buffer.read())\n"
    )
    program.chmod(0o755)
    monkeypatch.setenv("PATH", str(tmp_path))
    path = shot(state)
    file = save_film(path, path.parameters, tmp_path / "a.mp4", outcome=path.outcome, speed=1.0)
    made = film(path, speed=1.0)
    last = made.frame(path.duration)
    raw = np.frombuffer(file.read_bytes(), np.uint8).reshape(-1, *last.shape)
    assert len(raw) == len(made.times) + FRAME_RATE  # the end is shown for a second
    np.testing.assert_array_equal(raw[-1], last)
    early = min(3, len(made.times) - 1)
    np.testing.assert_array_equal(raw[early], made.frame(made.times[early]))
    words = said.read_text()
    assert f"-s {last.shape[1]}x{last.shape[0]} " in words
    assert last.shape[0] % 2 == last.shape[1] % 2 == 0  # as h264 needs them
    assert f" {FRAME_RATE} " in words


SHOT = ["shot", "--speed", "6", "--elevation", "51deg", "--distance", "2m", "--height", "7ft"]


def test_without_ffmpeg_a_line_says_so(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PATH", str(tmp_path))
    result = run(*SHOT, "--picture", str(tmp_path / "a.mp4"))
    assert result.exit_code == 2
    assert result.stderr == (
        "hoopgen: error: a.mp4: an MP4 needs the program ffmpeg, and there is none on the PATH; "
        "install it, or write a .gif\n"
    )
    assert not (tmp_path / "a.mp4").exists()


@pytest.mark.slow
def test_a_film_on_the_command_line(tmp_path: Path) -> None:
    out = tmp_path / "a.gif"
    succeed(*SHOT, "--picture", str(out))
    with Image.open(out) as image:
        assert image.n_frames > 20
    assert out.stat().st_size < 3_000_000


@pytest.mark.parametrize(
    ("name", "options", "message"),
    [
        ("a.avi", {}, "'a.avi' ends in none of .gif, .mp4"),
        ("a.gif", {"speed": 0.0}, "speed: expected a number above 0, got 0.0"),
        ("a.gif", {"speed": np.inf}, "speed: expected a number above 0, got inf"),
    ],
)
def test_what_cannot_be_filmed_is_refused(
    name: str, options: dict[str, Any], message: str, tmp_path: Path
) -> None:
    path = shot(DROPPED)
    with pytest.raises(ValueError, match=message.replace(".", r"\.")):
        save_film(path, path.parameters, tmp_path / name, **options)


def test_a_shot_that_meets_nothing_is_a_still() -> None:
    path = shot(STILL)
    assert path.duration == 0.0
    assert film(path).times.tolist() == [0.0]
