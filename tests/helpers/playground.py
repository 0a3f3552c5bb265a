"""The playground's scripts in Node: the engine as WebAssembly, and what they compute with it."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
from functools import cache
from typing import Any

import pytest

from hoopgen.viewer.playground_page import (
    GENERATED,
    SHARED,
    generated_script,
    own_file,
    page_spec,
)
from tests.helpers import ROOT

RUN = """
const { readFileSync } = require("fs");
const { source, folder, module, ...given } = JSON.parse(readFileSync(0, "utf8"));
const whole = new Function("page", "scene", "module", "bytes", "given", source);
whole(given.page, given.scene, module, readFileSync(`${folder}/${module.name}`), given.given).then(
  (found) => process.stdout.write(JSON.stringify(found)),
  (error) => { console.error(error); process.exit(1); },
);
"""


@cache
def spec() -> dict[str, Any]:
    """Return what the page's scripts know of hoopgen."""
    return page_spec("auto")


def computed(script: str, given: Any = None, lanes: int = 4, scene: str = "hoop") -> Any:
    """Return what a script, an expression, is: with `engine`, `study`, `spec` and `given`."""
    node = shutil.which("node")
    if node is None:
        if os.environ.get("CI"):
            pytest.fail("node is not on PATH")
        pytest.skip("needs node")
    source = "\n".join(
        [
            *(generated_script(name) for name in ("hoop.js", *GENERATED)),
            *(own_file(name) for name in SHARED if name != "worker.js"),
            "const spec = { ...Study.specOf(page, scene), modules: [module] };",
            "return Study.start(spec, { [module.name]: bytes }).then((study) => {",
            "const { engine } = study;",
            f"return {script.strip()};",
            "});",
        ]
    )
    (module,) = (one for one in spec()["scenes"][scene]["modules"] if one["lanes"] == lanes)
    told = {
        "source": source,
        "folder": str(ROOT / "generated" / "wasm"),
        "module": module,
        "page": spec(),
        "scene": scene,
        "given": given,
    }
    done = subprocess.run(
        [node, "-e", RUN], input=json.dumps(told), capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr[-2000:]
    return json.loads(done.stdout)
