"""Configuration of the site that `make docs` builds; pages.py runs its pages."""

import logging
import os
import re
import shutil
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
EXAMPLES = HERE.parent / "examples"
sys.path.insert(0, str(HERE))
# For the commands on the pages; the kernels inherit it. Without a compiler `make docs` brings one.
os.environ["PATH"] = os.pathsep.join([str(Path(sys.executable).parent), os.environ["PATH"]])
if shutil.which("cc") is None:
    compiler = HERE / "_build" / "bin" / "cc"
    compiler.parent.mkdir(parents=True, exist_ok=True)
    compiler.write_text(f'#!/bin/sh\nexec "{sys.executable}" -m ziglang cc -mcpu=baseline "$@"\n')
    compiler.chmod(0o755)
    os.environ["PATH"] += os.pathsep + str(compiler.parent)

# Kernels without a reader's own start-up files, which warn of nothing that is no page's.
profile = HERE / "_build" / "ipython" / "profile_default"
profile.mkdir(parents=True, exist_ok=True)
(profile / "ipython_kernel_config.py").write_text("c.IPKernelApp.log_level = 40\n")
os.environ["IPYTHONDIR"] = str(profile.parent)
logging.getLogger("traitlets").setLevel(logging.WARNING)

import pages  # noqa: E402
from docutils import nodes  # noqa: E402

import hoopgen  # noqa: E402
from hoopgen.viewer.playground_page import playground  # noqa: E402

project = "hoopgen"
author = copyright = "hoopgen contributors"
version = release = hoopgen.__version__

extensions = [
    "myst_nb",
    "sphinx.ext.autodoc",
    "sphinx.ext.autosummary",
    "sphinx.ext.napoleon",
    "sphinx.ext.mathjax",
    "sphinx.ext.viewcode",
    "sphinx-mathjax-offline",  # the site needs nothing from a network
    "sphinx_gallery.gen_gallery",
]
exclude_patterns = ["_build", "gallery/*.ipynb", "gallery/*.py"]

# Notebooks stand in examples/, where readers open them, and are pages too.
shutil.rmtree(HERE / "notebooks", ignore_errors=True)
shutil.copytree(
    EXAMPLES,
    HERE / "notebooks",
    ignore=lambda at, names: [name for name in names if not name.endswith(".ipynb")],
)

# ------------------------------------------------------------------------------------ what is run

nb_custom_formats = {".md": ["pages.read", {}, False]}
nb_execution_mode = "force"
nb_execution_in_temp = True
nb_execution_timeout = 600
nb_execution_show_tb = True
nb_execution_excludepatterns = [  # no kernel is started where there is nothing to run
    str(page) for page in HERE.rglob("*.md") if not pages.runs(page.read_text("utf-8"))
]
# Where C was not built, hoopgen says once a process that NumPy serves.
nb_output_stderr = "remove-warn" if hoopgen.HOOP.backend == "c" else "remove"
nb_merge_streams = True

sphinx_gallery_conf = {
    "examples_dirs": str(EXAMPLES / "gallery"),
    "gallery_dirs": "gallery",
    "filename_pattern": r"\.py$",  # all are run, also where they have not changed: hoopgen may have
    "run_stale_examples": True,
    "within_subsection_order": "FileNameSortKey",
    "image_scrapers": ("pictures.scrape",),
    "capture_repr": ("_repr_html_", "__str__"),
    "ignore_repr_types": r"Picture",
    "reset_modules": (),
    "show_memory": False,
    "show_signature": False,
    "write_computation_times": False,
    "min_reported_time": 1e9,
    "thumbnail_size": (400, 280),
}

# ----------------------------------------------------------------------------------- what is said

myst_enable_extensions = ["attrs_inline", "dollarmath"]
myst_heading_anchors = 4  # the derivation's pages link to kernels
default_role = "py:obj"
autodoc_member_order = "bysource"
autodoc_typehints = "description"
autodoc_typehints_description_target = "documented"
autodoc_typehints_format = "short"
autodoc_preserve_defaults = True
autosummary_generate = False
autodoc_type_aliases = {
    name: name for name in ("ArrayLike", "BackendName", "Bounds", "By", "Value")
} | {"Drawn": "Axes"}  # by which a picture's own type is told
napoleon_google_docstring = False
napoleon_attr_annotations = False  # docstrings say types and shapes where they matter
viewcode_line_numbers = True

html_theme = "furo"
html_title = "hoopgen"
html_static_path = ["_static"]
html_css_files = ["site.css"]

# The playground is a page of its own, beside the start page, which links it first.
extra = HERE / "_build" / "extra"
extra.mkdir(parents=True, exist_ok=True)
playground(extra / "playground.html")
html_extra_path = [str(extra)]
html_copy_source = False
html_show_sourcelink = False


def name_types(app, domain, kind, content):
    """Say a type's name where Sphinx says how it stands for one: TypeAliasForwardRef('By')."""
    for text in [each for each in content.findall(nodes.Text) if "AliasForwardRef" in each]:
        said = re.sub(r"TypeAliasForwardRef\('(\w+)'\)", r"\1", text)
        text.parent.replace(text, nodes.Text(said))


def setup(app):
    """Join what is said here to Sphinx."""
    app.connect("object-description-transform", name_types, priority=900)
    # This extension only copies files after the build, but does not declare that pages may be read
    # in parallel.
    app.extensions["sphinx-mathjax-offline"].parallel_read_safe = True
    return {"parallel_read_safe": True}
