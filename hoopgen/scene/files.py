"""Scene files: TOML with the arguments of `Scene`. Nothing in one is run or names a path."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from dataclasses import fields
from os import PathLike
from pathlib import Path
from typing import Any

from hoopgen.core.argument_types import check_arguments
from hoopgen.core.regular_files import FileSizeError, read_regular
from hoopgen.text.escape import printable
from hoopgen.text.shorten import brief, cut, join_names

from . import pieces
from .errors import SceneError, wrong
from .limits import Limits, check_limits, current, use_limits
from .scene import Scene

KINDS = {kind.__name__.lower(): kind for kind in pieces.BODIES}
"""Bodies, by what files call them."""


@check_arguments
def load_scene(
    file: str | PathLike[str], *, limits: Limits | Mapping[str, int] | None = None
) -> Scene:
    """Return the scene of a TOML file.

    Its tables are ``[parameters]``, ``[bodies.<name>]``, each with its ``kind``, and
    ``[ends.<name>]``; their keys are the arguments of the pieces in `hoopgen.scene`. A formula is
    read by a parser of its own: nothing in the file is run.

    Parameters
    ----------
    file
        A regular file.
    limits
        How large the scene may be, as for `Scene`.

    Raises
    ------
    OSError
        If the file cannot be read, or is a pipe, a device or a folder.
    SceneError
        If it is not TOML, or not a scene; names the file, the body and the argument.
    """
    path = Path(file)
    with use_limits(check_limits(limits)):
        try:
            return parse_scene(read_regular(path, current().file_size))
        except FileSizeError as error:
            said = current().excess("file_size", error.size)
            raise SceneError(printable(f"{path}: {said}")) from None
        except SceneError as error:
            raise SceneError(printable(f"{path}: {error}")) from None


def parse_scene(content: bytes) -> Scene:
    """Return the scene of the bytes of a file.

    Raises
    ------
    SceneError
        As of `load_scene`, without the file's name.
    """
    if excess := current().excess("file_size", len(content)):
        raise SceneError(excess)
    try:
        text = content.decode("utf-8-sig")
        document = tomllib.loads(text)
    except UnicodeDecodeError as error:
        raise SceneError(
            f"expected text in UTF-8; got the byte {content[error.start]:#x}"
        ) from None
    except tomllib.TOMLDecodeError as error:
        raise SceneError(f"this is not TOML: {error}") from None
    except (RecursionError, ValueError):  # nested too deep; a whole number of too many digits
        raise SceneError("this is not TOML that can be read") from None
    given_name = document.get("name", "")
    own = given_name if isinstance(given_name, str) else brief(given_name)
    given: dict[str, Any] = dict(document)
    given["parameters"] = [
        _build_piece(own, pieces.Parameter, f"parameter {name}", table, name)
        for name, table in _table(own, "parameters", document).items()
    ]
    given["bodies"] = [
        _body(own, name, table) for name, table in _table(own, "bodies", document).items()
    ]
    given["ends"] = {
        name: _build_piece(own, pieces.End, f"end {name}", table)
        for name, table in _table(own, "ends", document).items()
    }
    made: Scene = _build_piece(own, Scene, "", given)
    object.__setattr__(made, "text", text)
    return made


def _table(scene: str, argument: str, document: Mapping[str, Any]) -> Mapping[str, Any]:
    found = document.get(argument, {})
    if not isinstance(found, Mapping):
        raise wrong(scene, "", argument, f"expected tables by name, got {brief(found)}")
    return found


def _body(scene: str, name: str, table: object) -> pieces.Body:
    owner = f"body {name}"
    if not isinstance(table, Mapping):
        raise wrong(scene, owner, "", f"expected a table, got {brief(table)}")
    kind = table.get("kind")
    if not isinstance(kind, str) or kind not in KINDS:
        raise wrong(scene, owner, "kind", f"expected one of {join_names(KINDS)}; got {brief(kind)}")
    rest = {argument: value for argument, value in table.items() if argument != "kind"}
    made: pieces.Body = _build_piece(scene, KINDS[kind], owner, rest, name)
    return made


def _build_piece(scene: str, kind: type, owner: str, table: object, name: str | None = None) -> Any:
    """Return a piece from the keys of a table; a number alone is a parameter's default."""
    if kind is pieces.Parameter and not isinstance(table, Mapping):
        table = {"default": table}
    if not isinstance(table, Mapping):
        raise wrong(scene, owner, "", f"expected a table, got {brief(table)}")
    arguments = dict(table)
    if kind in (pieces.Cylinder, pieces.Cone) and isinstance(arguments.get("span"), list):
        # TOML has no null: an end that is not there is "".
        arguments["span"] = [None if end == "" else end for end in arguments["span"]]
    hidden = ("limits", "name" if name else "")  # no file raises the limits that hold for it
    allowed = [f.name for f in fields(kind) if f.init and f.name not in hidden]
    strange = [argument for argument in arguments if argument not in allowed]
    if strange:
        a_table = not owner and len(strange) == 1 and isinstance(arguments[strange[0]], Mapping)
        what = f"table [{cut(strange[0])}]" if a_table else join_names(strange)
        said = f"unknown {what}. There are {join_names(allowed)}"
        raise wrong(scene, owner, "", said)
    if name is not None:
        arguments["name"] = name
    try:
        return kind(**arguments)
    except TypeError as error:
        missing = str(error).rpartition(": ")[2]
        raise wrong(scene, owner, missing.strip("'"), "missing") from None
