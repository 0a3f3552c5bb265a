"""Settings beyond pyproject.toml: three folders become sub-packages, and C is built for ctypes."""

import gzip
import hashlib
import json
import os
import shutil
import subprocess
import sys
import sysconfig
from itertools import takewhile
from pathlib import Path
from runpy import run_path

from setuptools import Extension, find_namespace_packages, setup
from setuptools.command.bdist_wheel import bdist_wheel
from setuptools.command.build_ext import build_ext

BUILD = run_path("hoopgen/engine/c_build.py")
SOURCES = Path("generated/c")
SCENES = sorted(file.stem for file in SOURCES.glob("*.c"))
ROOMS = ("derive", "templates", "generated")

# Of long kernels in straight lines -O3 makes no faster code than -O1 does in half the time.
LEVEL = {"court": ["-O1"], "air": ["-O1"], "court_air": ["-O1"]}

# Scenes whose loop with bounds on errors is slower if the compiler first orders its instructions.
UNORDERED = {"court"}

# HOOPGEN_WIDTHS=all compiles every vector width, for any processor, as wheels that are given away
# need. Else the one of this processor is compiled, and one lane, with which others can serve too.
ALL_WIDTHS = os.environ.get("HOOPGEN_WIDTHS", "native") == "all"
FEATURES = {16: ("AVX512F", "AVX512DQ", "AVX512VL"), 8: ("AVX2",), 4: ()}

# Scenes that `python -m hoopgen.simulation.printed_scenes` has printed for a wheel to bring along.
SHIPPED = sorted(Path("hoopgen/shipped").glob("*.json.gz")) if ALL_WIDTHS else []
SHIPPED_SOURCES = Path("build/shipped")

MSVC_FLAGS = ["/O2", "/std:c11", "/fp:precise"]

# Libraries that were compiled in this checkout, by all that they depend on. An editable
# installation, a plain one and one with extras compile each of them once.
LIBRARIES = Path("build/libraries")


class BuildPlainLibrary(build_ext):
    """Build shared libraries that ctypes loads: no PyInit, no libpython."""

    def finalize_options(self) -> None:
        super().finalize_options()
        self.parallel = self.parallel or True  # as many compilers as there are processors
        self.force = True  # a library in build/ may be of another compiler or of other widths

    def build_extension(self, ext: Extension) -> None:
        msvc = self.compiler.compiler_type == "msvc"
        source = Path(ext.sources[0])
        scene = source.stem
        ext.extra_compile_args = MSVC_FLAGS if msvc else [*BUILD["FLAGS"], *LEVEL.get(scene, [])]
        # Linking with fast-math makes subnormals zero in every process that loads the library.
        ext.extra_link_args = [] if msvc else BUILD["FLAGS"]
        ext.define_macros = [
            (f"{scene.upper()}_SOURCES", BUILD["source_digest"](source.parent, scene))
        ]
        if scene in LEVEL:
            ext.define_macros.append((f"{scene.upper()}_ONE_REGION", "1"))
        if scene in UNORDERED:
            ext.define_macros.append((f"{scene.upper()}_ORDERED_BOUNDS", "0"))
        width = 0 if msvc or ALL_WIDTHS else self._native_width()
        if width:
            ext.define_macros.append((f"{scene.upper()}_NATIVE", str(width)))
        # What flags of the user's own give is built anew each time.
        if msvc or any(os.environ.get(name) for name in ("CFLAGS", "CPPFLAGS", "LDFLAGS")):
            super().build_extension(ext)
            return
        library = Path(self.get_ext_fullpath(ext.name))
        compiled = LIBRARIES / f"{scene}-{self._key(ext)}{library.suffix}"
        if compiled.is_file():
            library.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(compiled, library)
            return
        widths = f"{width} lanes and one" if width else "all widths"
        place = f"{1 + self.extensions.index(ext)} of {len(self.extensions)}"
        print(f"compiling the C library {scene}, {place}: {widths}", file=sys.stderr, flush=True)
        super().build_extension(ext)
        compiled.parent.mkdir(parents=True, exist_ok=True)
        # Another installation may be reading: the file appears whole or not at all.
        partial = compiled.with_suffix(f".{os.getpid()}")
        shutil.copy2(library, partial)
        partial.replace(compiled)

    def _native_width(self) -> int:
        """Return the widest vector of this processor, in lanes; 0 if the compiler does not say."""
        defined = self._macros("-march=native")
        # For several processors at once, as some Pythons of macOS compile, none of them is it.
        if not defined or self.compiler.compiler_so.count("-arch") > 1:
            return 0
        has = (
            w for w, needed in FEATURES.items() if defined.issuperset(f"__{f}__" for f in needed)
        )
        return next(has)

    def _macros(self, *flags: str) -> set[str]:
        """Return the names of the macros that the compiler defines; none if it does not say."""
        macros = subprocess.run(
            [*self._command(), *flags, "-dM", "-E", "-x", "c", os.devnull],
            capture_output=True,
            text=True,
            check=False,
        )
        if macros.returncode:
            return set()
        return {line.split()[1] for line in macros.stdout.splitlines() if line.count(" ") > 1}

    def _command(self) -> list[str]:
        return list(takewhile(lambda word: not word.startswith("-"), self.compiler.compiler_so))

    def _key(self, ext: Extension) -> str:
        """Return a digest of all that a library depends on: sources, compiler, flags, platform."""
        version = subprocess.run(
            [*self._command(), "--version"],
            capture_output=True,
            text=True,
            check=False,
        ).stdout
        depends = [
            self.compiler.compiler_so,
            self.compiler.linker_so,
            version,
            ext.define_macros,  # with the digest of the sources
            ext.extra_compile_args,
            ext.extra_link_args,
            sysconfig.get_platform(),
        ]
        return hashlib.sha256(repr(depends).encode()).hexdigest()

    def copy_extensions_to_source(self) -> None:
        # Where the compiler fails, an editable install must not keep the library of older sources.
        for ext in self.extensions:
            Path(self.get_ext_filename(ext.name)).unlink(True)
        super().copy_extensions_to_source()

    def get_ext_filename(self, fullname: str) -> str:
        # Without the tag of an interpreter: any Python can load the library.
        return str(Path(*fullname.split("."))) + ".so"

    def get_export_symbols(self, ext: Extension) -> list[str]:
        return ext.export_symbols

    def get_libraries(self, ext: Extension) -> list[str]:
        return ext.libraries


class WheelForAnyPython(bdist_wheel):
    """Build a wheel for this platform and every Python 3: no code in it is linked with Python."""

    def get_tag(self) -> tuple[str, str, str]:
        return "py3", "none", super().get_tag()[2]


def packages(folder: str) -> list[str]:
    # Namespace packages too: a folder that holds only data has no __init__.py.
    return find_namespace_packages(include=[folder, f"{folder}.*"], exclude=["*__pycache__*"])


def library(package: str, source: Path) -> Extension:
    headers = BUILD["source_files"](source.parent, source.stem)
    return Extension(
        f"{package}._{source.stem}",
        sources=[source.as_posix()],
        depends=["setup.py", "hoopgen/engine/c_build.py", *(file.as_posix() for file in headers)],
        optional=True,  # without a compiler NumPy serves
    )


def unpacked(shipped: Path) -> Path:
    """Write the C files of a printed scene, and return the one to compile."""
    name = shipped.name.removesuffix(".json.gz")
    files = json.loads(gzip.decompress(shipped.read_bytes()))["files"]
    for path, text in files.items():
        if path.startswith("c/"):
            file = SHIPPED_SOURCES / name / path
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text, encoding="utf-8", newline="\n")
    return SHIPPED_SOURCES / name / "c" / f"{name}.c"


setup(
    packages=packages("hoopgen") + [f"hoopgen.{name}" for room in ROOMS for name in packages(room)],
    package_dir={f"hoopgen.{room}": room for room in ROOMS},
    ext_modules=[
        *(library("hoopgen.engine", SOURCES / f"{scene}.c") for scene in SCENES),
        *(library("hoopgen.shipped", unpacked(shipped)) for shipped in SHIPPED),
    ],
    cmdclass={"build_ext": BuildPlainLibrary, "bdist_wheel": WheelForAnyPython},
)
