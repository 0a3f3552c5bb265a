"""The playground's scripts in Node: the engine as WebAssembly, and what they compute with it."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
from functools import cache
from typing import Any

import pytest

from hoopgen.viewer.playground_page import SHARED, own_file, page_spec
from tests.helpers import ROOT

RUN = """
const { readFileSync } = require("fs");
const { source, folder, module, given } = JSON.parse(readFileSync(0, "utf8"));
const whole = new Function("spec", "modules", "given", source);
const modules = [{ ...module, bytes: readFileSync(`${folder}/${module.name}`) }];
whole(given.spec, modules, given.given).then(
  (found) => process.stdout.write(JSON.stringify(found)),
  (error) => { console.error(error); process.exit(1); },
);
"""


@cache
def spec() -> dict[str, Any]:
    """Return what the page's scripts know of hoopgen."""
    return page_spec("auto")


def computed(script: str, given: Any = None, lanes: int = 4) -> Any:
    """Return what a script, an expression, is: with `engine`, `study`, `spec` and `given`."""
    node = shutil.which("node")
    if node is None:
        if os.environ.get("CI"):
            pytest.fail("node is not on PATH")
        pytest.skip("needs node")
    kernels = (ROOT / "generated" / "js" / "hoop.js").read_text(encoding="utf-8")
    source = "\n".join(
        [
            kernels,
            *(own_file(name) for name in SHARED if name != "worker.js"),
            "return Engine.start(modules, spec.layout).then((engine) => {",
            "const study = Study.of(engine, spec);",
            f"return {script.strip()};",
            "});",
        ]
    )
    (module,) = (one for one in spec()["modules"] if one["lanes"] == lanes)
    told = {
        "source": source,
        "folder": str(ROOT / "generated" / "wasm"),
        "module": module,
        "given": {"spec": spec(), "given": given},
    }
    done = subprocess.run(
        [node, "-e", RUN], input=json.dumps(told), capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr[-2000:]
    return json.loads(done.stdout)
