"""Every setting of a question is specified once: for Python, the command line and study files."""

from __future__ import annotations

import inspect
from dataclasses import MISSING, dataclass
from typing import Any, ClassVar

import click
import pytest
from click.testing import CliRunner

pytest.importorskip("pydantic")
pytest.importorskip("pyarrow")
pytest.importorskip("xarray")

from pydantic import ValidationError

import hoopgen
from hoopgen.cli import main
from hoopgen.cli.command import command
from hoopgen.cli.question_options import question_options
from hoopgen.study.jobs.objective import BY
from hoopgen.study.questions import measured_specification, specification
from hoopgen.study.questions.aim_table import aim_table
from hoopgen.study.questions.bank import bank_or_direct
from hoopgen.study.questions.settings import SUCCESSES, Sampling, arguments, setting, settings
from hoopgen.study.questions.specification import QUESTIONS
from hoopgen.study.questions.values import Choice, Whole
from hoopgen.study.recovery.calibrate_table import calibrate_table
from hoopgen.study.recovery.table import fit_table
from hoopgen.study.tables.limits import MEMORY
from hoopgen.study.tables.source import FORMATS
from hoopgen.studyfile.schema import KINDS, Question, table_of

FUNCTIONS = {
    specification.EstimateQuestion: hoopgen.estimate,
    specification.CompareQuestion: hoopgen.compare,
    specification.SolveQuestion: hoopgen.solve,
    specification.MapQuestion: hoopgen.map,
    specification.OptimumQuestion: hoopgen.optimum,
    specification.BankQuestion: bank_or_direct,
    specification.AimQuestion: aim_table,
    specification.BatchQuestion: hoopgen.batch,
    measured_specification.BestQuestion: hoopgen.best_shots,
    measured_specification.FitQuestion: fit_table,
    measured_specification.CalibrateQuestion: calibrate_table,
    specification.CounterfactualQuestion: hoopgen.counterfactual,
}

NOT_SETTINGS = {
    *("model", "first", "second", "parameters", "scene", "source", "out", "release", "places"),
    *("distances", "height", "angle", "backspin", "sidespin"),  # the release of a table of aim
    *("target", "moving"),  # the point that it is aimed at, and its place's velocity
    *("override", "rows", "progress", "report"),
    *("i", "errors", "player"),
}
"""Arguments of functions that are not settings: shots, their scene, and a program's own."""

RENAMED = {"distance": "distances"}


@pytest.mark.parametrize("question", FUNCTIONS, ids=lambda one: one.__name__)
def test_the_signature_of_a_function_is_its_specification(question: Any) -> None:
    """Same names and defaults, explicit and typed; nothing else but shots and their scene."""
    parameters = inspect.signature(FUNCTIONS[question]).parameters
    specified = {}
    for one in (question, *question.shared):
        for name, hint, found, default in settings(one):
            if found.argument:
                specified[RENAMED.get(name, name)] = hint, default
    given = {"shots"} if question is specification.CounterfactualQuestion else set()
    assert set(parameters) - NOT_SETTINGS - given <= set(specified)
    for name, (_, default) in specified.items():
        parameter = parameters[name]
        assert parameter.kind is not inspect.Parameter.VAR_KEYWORD
        assert parameter.default == (inspect.Parameter.empty if default is MISSING else default)
        assert parameter.annotation is not inspect.Parameter.empty


def test_every_question_of_a_study_file_has_a_command_and_a_table() -> None:
    assert set(KINDS) == set(QUESTIONS)
    together = {"compare": "estimate", "solve": "estimate"}
    for kind, question in QUESTIONS.items():
        options = {one.name for one in main.commands[together.get(kind, kind)].params}
        for name, _, found, _ in settings(question):
            assert name in KINDS[kind].model_fields
            assert found.option is None or name in options, (kind, name)


def test_words_that_are_said_elsewhere_too_are_the_same() -> None:
    """The specification imports nothing that needs more than NumPy, so it repeats these."""
    assert tuple(BY) == SUCCESSES
    (formats,) = (
        one.value for name, _, one, _ in settings(specification.BatchQuestion) if name == "format"
    )
    assert formats == Choice(tuple(FORMATS))
    (_, memory) = (default for *_, default in settings(specification.of.Parsing))
    assert memory == MEMORY


# ------------------------------------------------------------------------------- a toy question


@dataclass(frozen=True, kw_only=True)
class Toy:
    """Number of throws."""

    shared: ClassVar = (Sampling,)
    throws: int = setting("Number of throws.", Whole(high=99), 3)
    hand: str = setting("Hand that throws.", Choice(("left", "right")))


def toy(*, throws: int = 3, hand: str, seed: int = 0, confidence: float = 0.95) -> str:
    return f"{throws} by the {hand} hand, seed {seed}, {confidence}"


@command("toy")
@question_options(Toy)
def toy_command(**options: Any) -> None:
    """Throw."""
    click.echo(toy(**options))


def test_a_new_question_is_in_python_on_the_command_line_and_in_study_files() -> None:
    """Each from the one dataclass: options with types, defaults and help; keys; a call."""
    found = CliRunner().invoke(toy_command, ["--throws", "1e1", "--hand", "left"])
    assert found.output == "10 by the left hand, seed 0, 0.95\n"
    text = CliRunner().invoke(toy_command, ["--help"]).output
    assert "--throws COUNT" in text
    assert "Number of throws.  [default: 3]" in text
    assert "--hand [left|right]" in text
    refused = CliRunner().invoke(toy_command, ["--throws", "100", "--hand", "left"]).output
    assert "'100' is not a whole number from 1 to 99" in refused
    assert "missing --hand" in CliRunner().invoke(toy_command, []).output

    table = table_of(Question, Toy)
    read = table.model_validate({"kind": "toy", "name": "a", "throws": 4, "hand": "right"})
    assert isinstance(read, Toy)
    assert toy(**arguments(read, Toy), **arguments(Sampling(seed=7), Sampling)) == (
        "4 by the right hand, seed 7, 0.95"
    )
    with pytest.raises(ValidationError, match='expected "left" or "right"; got "foot"'):
        table.model_validate({"kind": "toy", "name": "a", "hand": "foot"})
    with pytest.raises(ValidationError, match="unknown key; is throws meant"):
        table.model_validate({"kind": "toy", "name": "a", "hand": "left", "trows": 2})
