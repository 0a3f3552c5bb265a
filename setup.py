"""What pyproject.toml cannot say: three folders become sub-packages, and C is built for ctypes."""

import hashlib
import os
import shutil
import subprocess
import sysconfig
from itertools import takewhile
from pathlib import Path
from runpy import run_path

from setuptools import Extension, find_namespace_packages, setup
from setuptools.command.build_ext import build_ext

BUILD = run_path("hoopgen/engine/sources.py")
SOURCES = Path("generated/c")
SCENES = sorted(file.stem for file in SOURCES.glob("*.c"))
ROOMS = ("derive", "templates", "generated")

# Of long kernels in straight lines -O3 makes no faster code than -O1 does in half the time.
LEVEL = {"court": ["-O1"]}

MSVC_FLAGS = ["/O2", "/std:c11", "/fp:precise"]

# Libraries that were compiled in this checkout, by all that they depend on. An editable
# installation, a plain one and one with extras compile each of them once.
LIBRARIES = Path("build/libraries")


class BuildPlainLibrary(build_ext):
    """Build shared libraries that ctypes loads: no PyInit, no libpython."""

    def finalize_options(self) -> None:
        super().finalize_options()
        self.parallel = self.parallel or True  # as many compilers as there are processors

    def build_extension(self, ext: Extension) -> None:
        msvc = self.compiler.compiler_type == "msvc"
        scene = Path(ext.sources[0]).stem
        ext.extra_compile_args = MSVC_FLAGS if msvc else [*BUILD["FLAGS"], *LEVEL.get(scene, [])]
        # Linking with fast-math makes subnormals zero in every process that loads the library.
        ext.extra_link_args = [] if msvc else BUILD["FLAGS"]
        ext.define_macros = [(f"{scene.upper()}_SOURCES", BUILD["word"](SOURCES, scene))]
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
        super().build_extension(ext)
        compiled.parent.mkdir(parents=True, exist_ok=True)
        # Another installation may be reading: the file appears whole or not at all.
        partial = compiled.with_suffix(f".{os.getpid()}")
        shutil.copy2(library, partial)
        partial.replace(compiled)

    def _key(self, ext: Extension) -> str:
        """Return a digest of all that a library depends on: sources, compiler, flags, platform."""
        compiler = takewhile(lambda word: not word.startswith("-"), self.compiler.compiler_so)
        version = subprocess.run(
            [*compiler, "--version"],
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
            path = Path(*ext.name.split("."))
            path.with_name(path.name + sysconfig.get_config_var("EXT_SUFFIX")).unlink(True)
        super().copy_extensions_to_source()

    def get_export_symbols(self, ext: Extension) -> list[str]:
        return ext.export_symbols

    def get_libraries(self, ext: Extension) -> list[str]:
        return ext.libraries


def packages(folder: str) -> list[str]:
    # Namespace packages too: a folder that holds only data has no __init__.py.
    return find_namespace_packages(include=[folder, f"{folder}.*"], exclude=["*__pycache__*"])


setup(
    packages=packages("hoopgen") + [f"hoopgen.{name}" for room in ROOMS for name in packages(room)],
    package_dir={f"hoopgen.{room}": room for room in ROOMS},
    ext_modules=[
        Extension(
            f"hoopgen.engine._{scene}",
            sources=[f"generated/c/{scene}.c"],
            depends=[
                "setup.py",
                "hoopgen/engine/sources.py",
                *sorted(map(str, SOURCES.glob(f"{scene}*.h"))),
            ],
            optional=True,  # without a compiler NumPy serves
        )
        for scene in SCENES
    ],
    cmdclass={"build_ext": BuildPlainLibrary},
)
