"""Grazes are as near as they are said to be, and hoopgen misses and invents no contact of them."""

import json
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from tests.helpers import ROOT

for _library in ("flint", "matplotlib", "scipy"):
    pytest.importorskip(_library)

from benchmarks import __main__ as command  # noqa: E402
from benchmarks import grazes, grazes_page  # noqa: E402
from benchmarks.grazes import BANDS, KINDS, Grazes, Kind, Seen, Tally  # noqa: E402
from hoopgen import PAPER  # noqa: E402

pytestmark = pytest.mark.sampled(1)


each_kind = pytest.mark.parametrize("kind", KINDS, ids=lambda kind: kind.key)


def some(kind: Kind, band: int, n: int = 40) -> Grazes:
    """The first n of a kind in a band."""
    made = grazes.graze(kind, 4 * n)
    least, most = BANDS[band]
    chosen = np.flatnonzero((np.abs(made.gap) >= least) & (np.abs(made.gap) < most))[:n]
    assert len(chosen) == n
    return Grazes(made.states[chosen], made.gap[chosen], made.time[chosen])


@each_kind
@pytest.mark.parametrize("part", [0.0, 0.95, 1.05])
def test_the_least_distance_is_the_gap(kind: Kind, part: float) -> None:
    """A surface moved by more than the gap changes the proof, so the gap is right to a twentieth.

    It moves towards the ball, or away from it where the part is negative.
    """
    made = some(kind, 0)
    moved = PAPER[kind.parameter] + kind.towards * part * made.gap
    proved = grazes.judged(kind, made, {**PAPER, kind.parameter: moved})
    assert not proved.uncertain.any()
    assert (proved.touches == ((made.gap < 0) == (part < 1))).all()


@each_kind
def test_nothing_is_met_before_the_graze(kind: Kind) -> None:
    made = some(kind, 0)
    proved = grazes.certify(made.states, PAPER, max_contacts=1)
    assert proved.decided.all()
    assert (proved.outcome != grazes.hoopgen.Outcome.INVALID).all()
    ends = proved.contacts + (proved.outcome < grazes.hoopgen.Outcome.CAPPED) > 0
    assert (proved.time[ends] > made.time[ends] - grazes.WINDOW).all()


@each_kind
def test_grazes_are_of_either_sign_and_the_same_each_time(kind: Kind) -> None:
    made, again = grazes.graze(kind, 60), grazes.graze(kind, 60)
    assert len(made) == 60
    assert (made.states == again.states).all()
    assert 15 < (made.gap < 0).sum() < 45
    assert np.abs(made.gap).min() >= BANDS[-1][0]
    assert np.abs(made.gap).max() <= BANDS[0][1]


def test_hoopgen_misses_no_graze_and_invents_none() -> None:
    found = grazes.tallies(150, grazes.OURS)
    assert {(t.who, t.kind, t.band) for t in found} == {
        (who, kind.key, band) for who in grazes.OURS for kind in KINDS for band in (0, 1)
    }
    assert all(t.missed == t.invented == 0 for t in found)
    assert all(t.undecided == 0 and t.touching > 15 and t.passing > 15 for t in found)
    # Not by calling everything uncertain: down to 1e-13 m doubles decide nearly all.
    nearer = [t for t in found if t.band == 0]
    assert sum(t.uncertain for t in nearer) < 0.02 * sum(t.touching + t.passing for t in nearer)


def test_misses_inventions_and_flags_are_counted() -> None:
    def says(touches: bool, uncertain: bool) -> grazes.Look:
        return lambda kind, made: Seen(np.full(len(made), touches), np.full(len(made), uncertain))

    field = {"blind": says(False, False), "touchy": says(True, False), "shy": says(True, True)}
    for tally in grazes.tallies(30, field):
        wrong = (tally.missed, tally.invented, tally.uncertain, tally.wrong_uncertain)
        number = tally.touching + tally.passing
        assert number
        assert (
            wrong
            == {
                "blind": (tally.touching, 0, 0, 0),
                "touchy": (0, tally.passing, 0, 0),
                "shy": (0, 0, number, tally.passing),
            }[tally.who]
        )


def test_what_the_judge_cannot_decide_is_nobodys_mistake(monkeypatch: pytest.MonkeyPatch) -> None:
    judged = grazes.judged
    monkeypatch.setattr(
        grazes,
        "judged",
        lambda kind, made: replace(judged(kind, made), uncertain=np.ones(len(made), np.bool_)),
    )
    blind = {"blind": lambda _, made: Seen(*np.zeros((2, len(made)), np.bool_))}
    found = grazes.tallies(20, blind)
    assert sum(tally.undecided for tally in found) == 20 * len(KINDS)
    assert not any(t.touching or t.passing or t.missed or t.invented for t in found)


def test_the_readme_shows_the_table_that_the_command_wrote() -> None:
    tallies = [
        Tally(**row)
        for row in json.loads((ROOT / "docs" / "grazes.json").read_text(encoding="utf-8"))
    ]
    table = "\n".join(grazes_page.summary(tallies))
    assert table in (ROOT / "docs" / "grazes.md").read_text(encoding="utf-8")
    assert table in (ROOT / "README.md").read_text(encoding="utf-8")
    ours = [tally for tally in tallies if tally.who in grazes.OURS]
    assert ours
    assert all(tally.missed == tally.invented == 0 for tally in ours)


def test_the_command_writes_grazes_alone(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    tallies = grazes.tallies
    monkeypatch.setattr(grazes, "tallies", lambda n: tallies(n // 10, grazes.OURS))
    arguments = ["--only", "grazes", "--quick", "--out", str(tmp_path)]
    monkeypatch.setattr(sys, "argv", ["benchmarks", *arguments])
    command.main()
    assert sorted(path.name for path in tmp_path.iterdir()) == ["grazes.json", "grazes.md"]
    assert (tmp_path / "grazes.md").read_text(encoding="utf-8") in capsys.readouterr().out


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        (["--only", "speed"], "--only speed is a part of the comparison that --base REF makes"),
        (["--only", "grazes", "--base", "HEAD"], "--base compares equality and speed"),
    ],
)
def test_a_part_of_another_command_is_refused(
    arguments: list[str],
    says: str,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.setattr(sys, "argv", ["benchmarks", *arguments])
    with pytest.raises(SystemExit):
        command.main()
    assert says in capsys.readouterr().err
