"""The objects that the core is linked from: no vector kernel calls code of the baseline."""

from __future__ import annotations

import platform
import re
import shutil
import subprocess
import sys
from functools import cache
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
BUILD = ROOT / "build" / str(sys.implementation.cache_tag) / "CMakeFiles"
KERNEL = re.compile(r"_ZN6lommel\d+run_(avx512|avx2|portable)I")
CALL = re.compile(r"R_X86_64_(?:PLT32\s+|PC32\s+\.text\.)(_Z\w+)")
# What kernels call that computes nothing: memory, errors, interrupts, and kernels themselves.
NOT_ARITHMETIC = re.compile(
    r"_Zd[al]|_Zn[aw]|_ZS|_ZNS|_Z.*D[012]Ev$|_ZN6lommel(?:\d+run_|13LimitExceeded|5Watch4look)"
)
# What computes little beside the kernels that call it: Bessel functions where no table serves, a table that is made
# once, the coefficients of a ring from those of its piece, pixels of frames that are not known, blocks beside plain
# walls.
FEW = re.compile(
    r"_ZN6lommel(?:5Field3sum|15bessel_sequence)E|_ZN6lommel5BendsC|_ZN6lommel8resampleI"
    r"|_ZNK6lommel11Focal(?:Reader|Stream8borrowed)"
)


@cache
def objects() -> tuple[Path, ...]:
    """Return the objects that the core of the build in this tree is linked from."""
    rules = BUILD.with_name("build.ninja")
    links = rules.read_text(encoding="utf-8") if rules.exists() else ""
    names = re.findall(r"CMakeFiles/(?:lommel_compiled|_core)\.dir/\S+\.o\b", links)
    return tuple(path for name in sorted(set(names)) if (path := BUILD.parent / name).exists())


@pytest.fixture(autouse=True)
def tools() -> None:
    if sys.platform != "linux" or platform.machine() != "x86_64":
        pytest.skip("kernels are compiled for several instruction sets on x86-64 alone; objects are read on Linux")
    if missing := [name for name in ("nm", "objdump") if shutil.which(name) is None]:
        pytest.skip(f"needs {' and '.join(missing)} of the binutils")
    if not objects():
        pytest.skip(f"no objects in {BUILD}: the core was compiled elsewhere")


def output(*command: str | Path) -> str:
    return subprocess.run(command, capture_output=True, check=True, encoding="utf-8").stdout


def test_no_vector_kernel_calls_a_function_of_the_core():
    """A function that was not inlined keeps the baseline instructions, and is slower by far."""
    called, seen = set(), 0
    for path in objects():
        kernel = ""
        for line in output("objdump", "--disassemble", "--reloc", "--no-show-raw-insn", path).splitlines():
            if start := re.match(r"[0-9a-f]+ <(.+)>:$", line):
                name = KERNEL.match(start[1])
                kernel = start[1] if name and name[1] != "portable" else ""
                seen += bool(kernel)
            elif kernel and (target := CALL.search(line)):
                called.add(target[1])
    assert seen > 150
    computing = {target for target in called if not NOT_ARITHMETIC.match(target)}
    assert [target for target in computing if not FEW.match(target)] == []
