"""The provenance in a file of results: the scene of its shots, and all shared values.

It lies in the metadata of the Arrow schema, under "hoopgen", of Parquet and Arrow files; in CSV it
is a comment line before the header, ``# hoopgen: {…}``.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field, fields, replace
from typing import Any

from hoopgen.core.extras import version
from hoopgen.core.validation import check_contacts
from hoopgen.core.variables import check_names
from hoopgen.engine.compiled_scene import CompiledScene
from hoopgen.hoop.presets import nearest_preset
from hoopgen.hoop.variables import change_variables
from hoopgen.report.provenance import describe_scene
from hoopgen.report.quantities import for_json
from hoopgen.scene.errors import SceneError
from hoopgen.scene.files import parse_scene
from hoopgen.scene.lookup import variables_of
from hoopgen.simulation.engine import Engine
from hoopgen.simulation.hoop import HOOP
from hoopgen.simulation.lookup import BUILT_IN, engine_of
from hoopgen.study.statistics.tally import check_scene, contacts_of

from .columns import NAMED, variable_of
from .source import ABOUT, Source

_MADE_IN = "made_in"
"""The identity of a user's scene."""

_SCENE_TEXT = "scene_text"
"""The text of a user's scene, if it is known."""


@dataclass(frozen=True)
class Origin:
    """Values that all shots of a table share; SI units.

    Attributes
    ----------
    columns
        Names of columns by the variable that they are read as, whatever they are called.
    engine
        The scene itself, of which the file says what tells it from others, and its text.
    """

    parameters: Mapping[str, float]  # of the scene, where no column says otherwise
    release: Mapping[str, float]  # variables of the release, in place of columns
    max_contacts: int  # contacts after which a shot ends as capped
    own: tuple[str, ...] = ()  # columns that are not read, though they are named like variables
    columns: Mapping[str, str] = field(default_factory=dict)
    results: tuple[str, ...] = ()  # columns of a file of results that say what became of the shots
    engine: CompiledScene = HOOP

    @property
    def scene(self) -> str:
        """The preset or the scene's name in words, and what differs from it."""
        return describe_scene(self.engine, self.parameters)

    @property
    def passed(self) -> tuple[str, ...]:
        """Return the columns that are not read: those of the caller, and former results."""
        return (*self.own, *self.results)

    def metadata(self, scene: str, **more: Any) -> dict[bytes, bytes]:
        """Return the provenance for a schema, with the scene in words, and `more`."""
        made: dict[str, Any] = {_MADE_IN: self.engine.identity}
        if self.engine.is_hoop:
            made = {"preset": nearest_preset(self.parameters)[0]}
        elif text := getattr(self.engine.table.written, "text", ""):
            made[_SCENE_TEXT] = text
        said = {"version": version(), **made, "scene": scene, NAMED: True}
        shared = {one.name: getattr(self, one.name) for one in fields(self) if one.name != "engine"}
        return {ABOUT: json.dumps(for_json({**said, **shared, **more})).encode()}


class OtherScene(ValueError):
    """A file of results says that its shots were flown in another scene."""


def scene_in(table: Source) -> Engine:
    """Return the scene in which a file of results says that its shots were flown.

    The text of a scene of one's own is read as a scene file is. Where the file says none that is
    known here, it is the article's hoop.

    Raises
    ------
    SceneError
        If the text is no scene.
    ValueError
        If the file is not of its format.
    OSError
        If the file cannot be read.
    """
    try:
        said = json.loads((table.schema().metadata or {}).get(ABOUT, b"{}"))
        made, text = said.get(_MADE_IN), said.get(_SCENE_TEXT)
    except (AttributeError, RecursionError, ValueError):
        return HOOP  # `origin_of` says what is wrong
    if isinstance(text, str):
        try:
            return engine_of(parse_scene(text.encode()))
        except SceneError as error:
            raise SceneError(
                f"{table}: the scene in its metadata cannot be read: {error}; "
                "give it (scene=, --scene)"
            ) from None
    known = _built_in()
    name = made.get("name") if isinstance(made, Mapping) else None
    return known[name]() if name in known else HOOP


def origin_of(table: Source, scene: CompiledScene = HOOP) -> Origin | None:
    """Return the provenance in a file of results; None if it has none.

    Parameters
    ----------
    scene
        In which they are to be flown.

    Raises
    ------
    OtherScene
        If it says another.
    ValueError
        If it cannot be understood, or the file is not of its format.
    OSError
        If it cannot be read.
    """
    schema = table.schema()
    text = (schema.metadata or {}).get(ABOUT)
    if text is None:
        return None
    try:
        said = json.loads(text)
        _check_made_in(table, said, scene)
        names = set(schema.names)
        release = {name: float(value) for name, value in said["release"].items()}
        check_names("release", release, variables_of(scene))
        return Origin(
            check_scene({n: float(v) for n, v in said["parameters"].items()}, scene),
            release,
            check_contacts(said["max_contacts"]),
            tuple(name for name in said.get("own", ()) if name in names),
            {one: str(name) for one, name in said.get("columns", {}).items() if name in names},
            tuple(name for name in said.get("results", ()) if name in names),
            scene,
        )
    except OtherScene:
        raise
    except (AttributeError, KeyError, RecursionError, TypeError, ValueError) as error:
        reason = f"{error} is missing" if isinstance(error, KeyError) else error
        raise ValueError(
            f"{table}: its metadata hoopgen, which says the scene of the shots, cannot be "
            f"understood ({reason}); remove it from the file, and give the scene (scene=, --scene)"
        ) from None


def results_in(table: Source) -> tuple[str, ...]:
    """Return the columns that a file of results says are results, whichever its scene is.

    Parameters
    ----------
    table
        The table, of which only the schema is read.
    """
    schema = table.schema()
    try:
        said = json.loads((schema.metadata or {}).get(ABOUT, b"{}")).get("results", ())
        return tuple(name for name in schema.names if name in said)
    except (AttributeError, RecursionError, TypeError, ValueError):
        return ()  # `origin_of` says what is wrong


def _check_made_in(table: Source, said: Mapping[str, Any], scene: CompiledScene) -> None:
    made = said.get(_MADE_IN)
    if (made is None and scene is HOOP) or made == scene.identity:
        return
    there = "hoop" if made is None else str(made["name"])
    expected, given = f"{there}, the scene of the shots in {table}", scene.name
    if there == scene.name:
        expected, given = f"the {there} of the shots in {table}", "another scene of that name"
    elif scene is HOOP and there not in _built_in() and _SCENE_TEXT not in said:
        expected += ", which has not its text"
    raise OtherScene(
        f"scene: expected {expected}; got {given}; give that scene (scene=, --scene), or override "
        "what the file says (override=True, --override)"
    )


def _built_in() -> dict[str, Callable[[], Engine]]:
    """Return the scenes that come with hoopgen, by the names that files say."""
    return {name.replace("-", "_"): scene for name, scene in BUILT_IN.items()}


def names_hoop(table: Source, own: Iterable[str] = ()) -> bool:
    """Return whether the columns of a file say all of the article's scene.

    Parameters
    ----------
    table
        The table, of which only the schema is read.
    own
        Columns of the user's that are named like parameters and are not read as such.

    Returns
    -------
    bool
        True if no parameter is left to a preset.
    """
    left = set(own)
    said = {variable_of(name, HOOP)[0] for name in table.schema().names if name not in left}
    return said.issuperset(HOOP.table.defaults)


def resolve_origin(
    table: Source,
    parameters: Mapping[str, Any] | None = None,
    release: Mapping[str, float] | None = None,
    max_contacts: int | None = None,
    own: Iterable[str] = (),
    *,
    override: bool = False,
    scene: CompiledScene = HOOP,
    columns: Mapping[str, str] | None = None,
) -> Origin:
    """Return the settings of a table's simulation: those of the file, else those of the caller.

    Parameters
    ----------
    parameters, max_contacts
        Asked for; None for what the file says, and what is usual in the scene where it says
        nothing.
    release, own, columns
        Asked for besides what the file says.
    override
        Whether what is asked for may contradict the file.

    Raises
    ------
    ValueError
        If it does, and may not; or what the file says cannot be understood.
    """
    asked, own = dict(release or {}), tuple(own)
    try:
        said = origin_of(table, scene)
    except OtherScene:
        if not override:
            raise
        said = None
    if said is None:
        values = dict(scene.parameters if parameters is None else parameters)
        contacts = contacts_of(max_contacts, scene)
        return Origin(values, asked, contacts, own, dict(columns or {}), (), scene)
    wanted = Origin(
        said.parameters if parameters is None else dict(parameters),
        change_variables(said.release, asked) if scene.has_hoop else {**said.release, **asked},
        said.max_contacts if max_contacts is None else check_contacts(max_contacts),
        (*said.own, *(name for name in own if name not in said.own)),
        {**said.columns, **(columns or {})},
        said.results,
        scene,
    )
    if not override and replace(wanted, own=said.own, columns=said.columns) != said:
        raise ValueError(
            f"{table}: its shots have other values than are given: "
            f"{'; '.join(_differences(said, wanted))}; leave these out, or override what the file "
            "says (override=True, --override)"
        )
    return wanted


def _differences(said: Origin, wanted: Origin) -> list[str]:
    found = []
    if wanted.parameters != said.parameters:
        found.append(f"parameters (--preset, --set): expected {said.scene}, got {wanted.scene}")
    for name, value in wanted.release.items():
        if said.release.get(name) != value:
            there = said.release.get(name, "that of each row")
            found.append(f"{name}: expected {there}, got {value}")
    if wanted.max_contacts != said.max_contacts:
        found.append(f"max_contacts: expected {said.max_contacts}, got {wanted.max_contacts}")
    return found
