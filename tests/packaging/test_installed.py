"""The installed package: what `import hoopgen` gives anywhere, and hints that work there."""

from __future__ import annotations

import shlex
import shutil
import subprocess
import sys
import sysconfig
from importlib.metadata import Distribution, requires
from pathlib import Path
from typing import Any

import pytest

import hoopgen
from hoopgen.core import extras
from tests.helpers import ROOT

ROOMS = ("hoopgen", "derive", "generated", "templates")
SITE = sysconfig.get_paths()["purelib"]


def python(code: str, *arguments: str | Path, cwd: Path = ROOT) -> str:
    """Run code without site-packages, so without the finder of an editable installation."""
    done = subprocess.run(
        [sys.executable, "-S", "-c", code, *arguments],
        cwd=cwd,
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    return done.stdout


@pytest.fixture(scope="module")
def checkout(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Sources with no compiled library and no installation that knows of them."""
    root = tmp_path_factory.mktemp("checkout")
    for room in ROOMS:
        ignored = shutil.ignore_patterns("__pycache__", "_hoop.*", "_court.*")
        shutil.copytree(ROOT / room, root / room, ignore=ignored)
    shutil.copy(ROOT / "pyproject.toml", root)
    return root


# --------------------------------------------------------------------------------- in a checkout

# After ``-S`` other packages are found, hoopgen's own installation is not: no .pth file is read.
_IN_CHECKOUT = f"""
import sys
sys.path[:0] = [sys.argv[1]]
sys.path.append({SITE!r})
"""


@pytest.mark.slow
def test_hoopgen_is_imported_in_a_checkout_that_shadows_an_installation(checkout: Path) -> None:
    code = f"""{_IN_CHECKOUT}
import hoopgen, hoopgen.derive, hoopgen.generated, hoopgen.templates
print(hoopgen.__file__, hoopgen.generated.__file__)
print(hoopgen.simulate(hoopgen.release(7.17, 0.89, height=2.13, distance=4.19)).outcome[0])
"""
    where, outcome = python(code, checkout).splitlines()
    assert where.split() == [str(checkout / room / "__init__.py") for room in ("hoopgen", ROOMS[2])]
    assert outcome == "0"


def test_a_checkout_that_is_not_installed_knows_its_version(checkout: Path) -> None:
    code = f"""{_IN_CHECKOUT}
from importlib import metadata
from hoopgen.core import extras
def nothing(name):
    raise metadata.PackageNotFoundError(name)
extras.distribution = nothing
import hoopgen
print(hoopgen.__version__)
"""
    assert python(code, checkout) == f"{hoopgen.__version__}\n"


# ------------------------------------------------------------------------------------ what is shown


def test_tab_completion_shows_the_interface_and_nothing_else() -> None:
    shown = {name for name in dir(hoopgen) if not name.startswith("__")}
    assert shown == {
        *("simulate", "certify", "release", "Outcome", "SURFACES", "Shots", "Trajectory"),
        *("COURT_AIR", "PAPER_COURT_AIR", "NBA_COURT_AIR", "FIBA_COURT_AIR"),
        *("AIR", "PAPER_AIR", "NBA_AIR", "FIBA_AIR"),
        *("PAPER", "NBA", "FIBA", "Scatter", "Resample", "Grid", "estimate", "compare", "map"),
        *("solve", "optimum", "margins", "bank_or_direct", "aim", "measure", "batch", "run_study"),
        *("fit_release", "counterfactual", "place", "coach", "assess", "calibrate"),
        "best_shots",
        "certify_box",
        *("view", "plots", "HOOP", "Scene", "compile", "load_scene", "scene"),
        *("why_invalid", "COURT", "Event", "PAPER_COURT", "NBA_COURT", "FIBA_COURT"),
        *("jvp", "vjp", "jax"),
    }
    assert {"__version__", "__doc__", "__path__"} <= set(dir(hoopgen))


@pytest.mark.slow
def test_all_that_is_shown_is_there() -> None:
    for extra in ("matplotlib", "xarray", "scipy", "pyarrow", "pydantic", "flint", "sympy"):
        pytest.importorskip(extra)
    for name in dir(hoopgen):
        assert getattr(hoopgen, name) is not None


@pytest.mark.slow
def test_plots_are_there_after_import_and_nothing_is_loaded_before() -> None:
    pytest.importorskip("matplotlib")
    code = """
import sys, hoopgen
from hoopgen.core.validation import as_doubles  # modules that are not shown are still there
assert not {"matplotlib", "sympy", "hoopgen.plots"} & set(sys.modules)
print(hoopgen.plots.plot_fan.__name__)
"""
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout == "plot_fan\n"


def test_what_there_is_not_is_an_attribute_error() -> None:
    with pytest.raises(AttributeError, match="module 'hoopgen' has no attribute 'estimates'"):
        _ = hoopgen.estimates


# ------------------------------------------------------------------------------------------- hints


class Away(Distribution):
    """An installation that is no checkout's."""

    requires = requires("hoopgen")
    url: str | None = None

    def read_text(self, filename: str) -> str | None:
        return self.url

    def locate_file(self, path: object) -> Any:
        raise NotImplementedError


class Editable(Away):
    """An editable one."""

    url = '{"url": "file:///home/ann/hoopgen", "dir_info": {"editable": true}}'


def hint(missing: str, root: str | None, installed: Distribution) -> list[str]:
    """Return the command of the hint, as a shell takes it."""
    place = root and Path(root)
    command = extras.install_command(missing, extras.EXTRAS[missing], place or None, installed)
    return shlex.split(command)


@pytest.mark.parametrize("missing", extras.EXTRAS)
def test_away_from_a_checkout_the_packages_themselves_are_named(missing: str) -> None:
    pip, install, *packages = hint(missing, None, Away())
    assert (pip, install) == ("pip", "install")
    assert packages
    others = {"flint": "python-flint", "distributed": "dask", "markdown_it": "markdown-it-py"}
    others |= {"jaxlib": "jax"}
    package = others.get(missing, missing)
    assert any(one.startswith(package) for one in packages)
    assert not any("hoopgen" in one or ";" in one for one in packages)


def test_in_a_checkout_its_folder_is_named_with_the_extra() -> None:
    command = ["pip", "install", "/my work/hoopgen[study]"]
    assert hint("pyarrow", "/my work/hoopgen", Away()) == command
    assert hint("pandas", "/my work/hoopgen", Away()) == ["pip", "install", "pandas"]


def test_an_editable_installation_stays_one() -> None:
    command = ["pip", "install", "-e", "/home/ann/hoopgen[certify]"]
    assert hint("flint", "/home/ann/hoopgen", Editable()) == command


def test_the_error_names_what_needs_the_module_and_the_command() -> None:
    error = extras.explain_import_error(ModuleNotFoundError(name="flint"), "a picture")
    assert str(error).startswith("a picture needs flint: pip install ")


def test_other_import_errors_stay_as_they_are() -> None:
    error = ImportError("no", name="hoopgen.nothing")
    assert extras.explain_import_error(error) is error


@pytest.mark.sampled(1)
@pytest.mark.parametrize(
    ("name", "missing"),
    [("plots", "matplotlib"), ("estimate", "pyarrow"), ("map", "xarray"), ("certify", "flint")],
)
def test_what_lacks_something_says_how_to_get_it(name: str, missing: str) -> None:
    code = f"""
import sys
sys.modules[{missing!r}] = None
import hoopgen
try:
    hoopgen.{name}
except ImportError as error:
    print(error)
"""
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert f"{name} needs {missing}: pip install " in done.stdout


@pytest.mark.slow
def test_aiming_needs_no_extra() -> None:
    code = """
import sys
for missing in ("matplotlib", "pandas", "pyarrow", "pydantic", "scipy", "xarray"):
    sys.modules[missing] = None
import hoopgen
print(hoopgen.aim(height=2.0, distance=4.0)._repr_html_().count("<tr>"))
"""
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout == "2\n"


def test_no_hint_names_an_index_that_has_no_hoopgen() -> None:
    for path in (*ROOT.glob("*.md"), *ROOT.glob("docs/*.md"), *ROOT.glob("hoopgen/**/*.py")):
        assert "install 'hoopgen[" not in path.read_text(encoding="utf-8"), path
