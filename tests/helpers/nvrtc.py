"""NVIDIA's compiler of CUDA, which needs no GPU."""

from __future__ import annotations

import ctypes
from concurrent.futures import ThreadPoolExecutor
from functools import cache
from importlib.util import find_spec
from pathlib import Path

import pytest


@cache
def _library() -> Path | None:
    """Return NVRTC as its wheels of CUDA 12 and 13 bring it, if one is installed."""
    spec = find_spec("nvidia")
    folders = [] if spec is None else list(spec.submodule_search_locations or ())
    found = (p for folder in folders for p in Path(folder).glob("*/lib/libnvrtc.so.1[23]"))
    return next(found, None)


needs_nvrtc = pytest.mark.skipif(
    _library() is None, reason="nvidia-cuda-nvrtc-cu12 has no wheel for this system"
)


def compile_to_ptx(source: str, *flags: str) -> str:
    """Return what NVRTC makes of a source, in PTX.

    It runs in a thread of its own, to which it leaves another locale.
    """
    with ThreadPoolExecutor(max_workers=1) as thread:
        return thread.submit(compile_to_ptx_here, source, *flags).result()


def compile_to_ptx_here(source: str, *flags: str) -> str:
    """Return what NVRTC makes of a source, in PTX; this thread has the locale "C" afterwards."""
    nvrtc = ctypes.CDLL(str(_library()))
    program, size = ctypes.c_void_p(), ctypes.c_size_t()
    assert not nvrtc.nvrtcCreateProgram(
        ctypes.byref(program), source.encode(), b"scene.cu", 0, None, None
    )
    given = [flag.encode() for flag in ("-w", "-arch=compute_80", *flags)]
    failed = nvrtc.nvrtcCompileProgram(program, len(given), (ctypes.c_char_p * len(given))(*given))
    part = "ProgramLog" if failed else "PTX"
    getattr(nvrtc, f"nvrtcGet{part}Size")(program, ctypes.byref(size))
    text = ctypes.create_string_buffer(size.value)
    getattr(nvrtc, f"nvrtcGet{part}")(program, text)
    nvrtc.nvrtcDestroyProgram(ctypes.byref(program))
    assert not failed, text.value.decode()
    return text.value.decode()
