"""Macros that stand for statements, and the merging of the variants of the event loop."""

from __future__ import annotations

import re
import subprocess
from collections import Counter
from pathlib import Path

import pytest

from hoopgen.codegen.c.columns import MACROS, PAIRS, alike
from hoopgen.codegen.c.merging import WIDTH, merge_variants
from hoopgen.codegen.statements import Assign, Declare, Name, Number
from tests.helpers import ROOT
from tests.helpers.compiled import COMPILER, needs_compiler


def given(macro: str) -> str | tuple[str, str]:
    """Return what a macro is given once."""
    return ("one_", "two_") if macro in PAIRS else "list_"


def preprocessed(text: str, folder: Path) -> str:
    """Return a text after the preprocessor."""
    (folder / "text.h").write_text(text, encoding="utf-8")
    command = [*COMPILER, "-E", "-P", str(folder / "text.h")]
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout


def test_every_macro_is_used_in_a_scene_of_hoopgen() -> None:
    texts = [file.read_text("utf-8") for file in (ROOT / "generated" / "c").glob("*_loop.h")]
    used = set(re.findall(r"EACH\((\w+),", "".join(texts)))
    assert set(MACROS) <= used


def test_only_a_statement_that_a_macro_stands_for_is_one() -> None:
    for macro, make in MACROS.items():
        statement = make(given(macro), "vx")
        found = alike(statement)
        assert found is not None
        assert MACROS[found[0]](given(macro), found[2]) == statement
    assert alike(Declare("x", "V", Number(1.0))) is None
    assert alike(Declare("x", "V", Number(0.0), constant=True)) is None
    assert alike(Assign(Name("x"), Name("y"))) is None


PLAIN = """{
    EACH(LOAD, , x)
    EACH(LOAD_MASK, , sure)
    EACH(LOAD, , y)
    CALL(f, _f_1)(x, K(0.0), K(INFINITY));
    CALL(g, _g_1)(x, y);

    V z = _f_1.w;
}"""
BOUND = """{
    EACH(LOAD, , uncertain)
    EACH(LOAD, , x)
    EACH(LOAD_MASK, , sure)
    EACH(LOAD, , y)
    CALL(f, _f_1)(x, error, uncertain);
    CALL(g, _g_1)(x, error);

    EACH(GET, _f_1, error)
    CALL(h, _h_1)(error);
    V z = _f_1.w;
}"""
MERGED = """{
    EACH(LOAD, , x, y)
    EACH(LOAD_MASK, , sure)
    BOUNDS(EACH(LOAD, , uncertain))
    CALL(f, _f_1)(x, OR_ZERO(error), OR_INFINITE(uncertain));
#if BOUNDED
    CALL(g, _g_1)(x, error);
#else
    CALL(g, _g_1)(x, y);
#endif

#if BOUNDED
    EACH(GET, _f_1, error)
    CALL(h, _h_1)(error);
#endif
    V z = _f_1.w;
}"""
WITH_BOUNDS = """#define BOUNDED 1
#define BOUNDS(...) __VA_ARGS__
#define OR_ZERO(name) name
#define OR_INFINITE(name) name
"""
WITHOUT = """#define BOUNDED 0
#define BOUNDS(...)
#define OR_ZERO(name) K(0.0)
#define OR_INFINITE(name) K(INFINITY)
"""


def test_two_variants_are_one_text() -> None:
    assert merge_variants(PLAIN, BOUND) == MERGED
    assert merge_variants(PLAIN, PLAIN).count("EACH(LOAD, , x, y)") == 1


def test_variables_are_gathered_in_lines_of_limited_length() -> None:
    names = [f"variable_{k}" for k in range(40)]
    text = merge_variants(*2 * ["\n".join(f"    EACH(STORE, list_, {name})" for name in names)])
    lines = text.splitlines()
    assert max(map(len, lines)) <= WIDTH
    assert len(lines) < 10
    assert re.findall(r"variable_\d+", text) == names


def statements(text: str) -> Counter[str]:
    """Return the statements of a text, one for each variable of which something is said."""
    found: Counter[str] = Counter()
    gathered = re.compile(r"EACH\((\w+), (\w*), ([^()]*)\)")
    for what, of, names in gathered.findall(text):
        found.update(f"{what} {of} {name}" for name in names.split(", "))
    found.update("".join(part.split()) for part in gathered.sub("", text).split(";"))
    return found


@needs_compiler
@pytest.mark.parametrize(("definitions", "own"), [(WITH_BOUNDS, BOUND), (WITHOUT, PLAIN)])
def test_the_preprocessor_takes_the_variants_apart(
    definitions: str, own: str, tmp_path: Path
) -> None:
    assert statements(preprocessed(definitions + MERGED, tmp_path)) == statements(own)
