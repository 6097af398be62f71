"""Fresh processes (peak memory, the first call, the cold start), and builds limited to narrower vectors."""

from __future__ import annotations

import atexit
import json
import os
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import replace
from functools import cache, partial
from pathlib import Path
from typing import Any

import numpy as np

import lommel as lm
from benchmarks.contenders import engine, stack, through_focus
from benchmarks.depth import photograph
from benchmarks.microscopes import planes
from benchmarks.report import Table
from benchmarks.timing import Contender, Measured, Settings, Spread, race
from benchmarks.truth import RANDOM, Mixed, Question
from benchmarks.wavefronts import SIDE, random_zernikes
from lommel import _core

# Peak resident memory, in KiB, as the kernel counts it (VmHWM), hence with all that compiled code allocates.
# Writing 5 to clear_refs sets the peak back to what is resident now; where that is refused, the peak of the
# imports can only make the answer larger.
_MEMORY = """
import ctypes, gc, json, re, sys
import numpy as np
import lommel as lm

def status(name):
    with open("/proc/self/status") as lines:
        return int(re.search(name + r":\\s+(\\d+) kB", lines.read())[1])

n, defocus, spherical, threads = map(float, sys.argv[1:])
out = np.ones((int(n), int(n)), np.float32)
pupil = lm.Pupil(lm.Wavefront(defocus, spherical))
method = lm.methods.NijboerZernike()
gc.collect()
try:  # memory that was freed but is resident still would hide what is allocated now
    ctypes.CDLL(None).malloc_trim(0)
except (AttributeError, OSError):
    pass
try:
    with open("/proc/self/clear_refs", "w") as peak:
        peak.write("5")
except OSError:
    pass
plan = lm.Plan(int(n), 0.5, method=method, threads=int(threads))
before = status("VmRSS")
peaks = []
for repeat in range(3):
    plan(pupil, out=out)
    peaks.append((status("VmHWM") - before) / 1024)
print(json.dumps({"peak": peaks[-1], "kept": (status("VmRSS") - before) / 1024}))
"""


def memory(n: int, defocus: float, spherical: float, threads: int = 1) -> dict[str, float] | None:
    """Return MiB above the output at the peak, and kept after three calls; None where Linux does not tell."""
    if not Path("/proc/self/clear_refs").exists():
        return None
    arguments = [str(x) for x in (n, defocus, spherical, threads)]
    answer: dict[str, float] = json.loads(_run(_MEMORY, *arguments))
    return answer


@cache
def _environment() -> dict[str, str]:
    """Return variables with which modules are compiled once, as where they are installed, not by every process."""
    compiled = tempfile.mkdtemp(prefix="lommel-")
    atexit.register(shutil.rmtree, compiled, ignore_errors=True)
    kept = {name: value for name, value in os.environ.items() if name != "PYTHONDONTWRITEBYTECODE"}
    return kept | {"PYTHONPYCACHEPREFIX": compiled}


def process(code: str, _: object) -> None:
    """Run code in a process of its own."""
    subprocess.run([sys.executable, "-c", code], check=True, env=_environment())


def _run(code: str, *arguments: str) -> str:
    command = [sys.executable, "-c", code, *arguments]
    return subprocess.run(command, check=True, capture_output=True, text=True, env=_environment()).stdout


_FIRST = "lm.psf(lm.Pupil(lm.Wavefront(10.0, 3.0)), {n}, 0.5)"
_COLD = {
    "import numpy": ("import numpy", "the interpreter starts, NumPy is imported"),
    "the interpreter": ("pass", "starts and ends"),
    "import lommel": ("import lommel", "NumPy with it"),
    "first PSF of 33²": ("import lommel as lm; " + _FIRST.format(n=33), "import, tables and all"),
    "first PSF of 512²": ("import lommel as lm; " + _FIRST.format(n=512), "import, tables and all"),
    "first PSF of 512², scipy.fft": (
        "import numpy as np; from scipy.fft import fft2; x = np.linspace(-2, 2, 1024, endpoint=False); "
        "t = x[:, None] ** 2 + x ** 2; u = fft2(np.where(t < 1, np.exp(1j * (20 + 3 * t) * t), 0)); "
        "i = u.real ** 2 + u.imag ** 2",
        "pupil, FFT of 1024² complex128, intensity",
    ),
}


def cold(settings: Settings) -> Table:
    """Time whole processes, from the start of the interpreter to its end."""
    table = Table(
        "cold",
        "Cold start",
        "Whole processes, from the start of the interpreter to its end, the files warm in the page cache. "
        "The unit is a process that imports NumPy and ends.",
        {"process": "text", "does": "text", "over `import numpy`": "spread"},
    )
    contenders = [Contender(name, partial(process, code), does) for name, (code, does) in _COLD.items()]
    settings.tick("cold start")
    result = race(contenders, settings.rounds, budget=2.5 if settings.quick else 25.0, keep=False)
    for one in contenders[1:]:
        table.add(one.name, one.config, result.ratio(one.name, contenders[0].name))
    return table


_ONCE = """
import json
from time import perf_counter as now
import numpy as np
import lommel as lm
pupils = [lm.Pupil(lm.Wavefront(10.0 + k, 3.0)) for k in range(41)]
others, image, frame = np.zeros(2**24), np.ones((512, 512), np.float32), np.ones((512, 512), np.float32)

def taken(call, *before):
    for one in before:
        one()
    start = now()
    call()
    return now() - start

def empty():
    np.add(others, 1.0, out=others)

copied = taken(lambda: np.copyto(np.empty_like(image), image))
first = taken(lambda: lm.psf(pupils[0], 512, 0.5, threads=1))
plan = lm.Plan(512, 0.5, threads=1)
psfs = [taken(lambda: plan(pupil, out=frame), empty) for pupil in pupils]
copies = [taken(lambda: np.copyto(frame, image), empty) for _ in pupils]
print(json.dumps([first / copied, np.median(psfs) / np.median(copies)]))
"""


def once(settings: Settings) -> list[float]:
    """Return the first call, and the median of calls between others, over copies of such arrays."""
    settings.tick("first call")
    found: list[float] = json.loads(_run(_ONCE))
    return found


def importing(settings: Settings) -> Measured:
    """Measure a process that imports the package over one that imports NumPy."""
    both = [Contender(name, partial(process, f"import {name}"), "") for name in ("lommel", "numpy")]
    result = race(both, settings.rounds, budget=10.0, keep=False)
    return Measured(result.ratio("lommel", "numpy"), None, "whole processes, their modules compiled beforehand")


@cache
def _once(settings: Settings) -> list[list[float]]:
    return [once(settings) for _ in range(3 if settings.quick else 11)]


def first(settings: Settings) -> Measured:
    """Measure the first call of processes that have imported the package, over the first copy."""
    note = "memory that is new for both; modules that are loaded late, tables"
    return Measured(Spread.of(np.array(_once(settings))[:, 0]), None, note)


def between(settings: Settings) -> Measured:
    """Measure calls between others that empty the caches, over copies of such arrays there."""
    return Measured(Spread.of(np.array(_once(settings))[:, 1]), None, "into `out`; the others add 1 to 128 MiB")


_LEVELS = ("avx512", "avx2", "portable")


@contextmanager
def _limited(level: str) -> Iterator[None]:
    _core.limit_instructions(level)
    try:
        yield
    finally:
        _core.limit_instructions(_LEVELS[0])


def _works() -> list[tuple[str, Contender]]:
    radial, general = Question(10.0, 3.0), Mixed(directions=RANDOM[0])
    chords = stack(
        random_zernikes(each=True), SIDE, 0.5, method=lm.methods.ChordalGauss(1e-4), dtype=np.float32, out=True
    )
    spider = lm.Pupil(lm.Wavefront(3.0), obscuration=0.3, spider=lm.Spider.equal(4, 0.02))
    vanes = Contender("vanes", lambda _: lm.psf(spider, 128, 0.5, threads=1))
    frequencies = np.linspace(0.0, 1.0, 100)
    transfer = Contender("otf", lambda _: lm.otf(general.pupil(), frequencies))
    return [
        ("512², radially symmetric", engine(radial, out=True)),
        ("512², its pixels averaged", engine(radial, out=True, integrate=True)),
        ("1000 of 33², through focus, float64", stack(through_focus(10.0, 1000), 33, 0.5, out=True)),
        ("512², coma, astigmatism, trefoil and defocus of 10 rad each", engine(general, out=True)),
        ("1000 of 33², 15 Zernike terms of 1 rad rms each, tol 1e-4", chords),
        ("128², four vanes", vanes),
        ("transfer function of 10 rad each at 100 frequencies", transfer),
        ("64 planes of 64² of an immersion objective", planes()),
        ("500 × 741 RGB blurred by depth, 2 threads", photograph()),
    ]


def limited(settings: Settings) -> Table:
    """How many times as long each work takes with narrower vectors as with the widest."""
    table = Table(
        "instructions",
        "Instruction sets",
        "How many times as long the same build takes when it is limited to AVX2 with FMA, or to what every x86-64 "
        "processor has (SSE2), as with the widest vectors of this one. Pixels of 0.5 λN, tol 1e-6 and float32 unless "
        "the row says otherwise, one thread, into an array that is there already.",
        {"work": "text", "AVX2": "spread", "SSE2": "spread"},
    )
    table.notes.append(f"the widest here: {_core.instructions()}")
    for work, one in _works():
        settings.tick(work)

        def at(level: str, call: Callable[[Any], Any] = one.call) -> Callable[[Any], Any]:
            def limited_call(argument: Any) -> Any:
                with _limited(level):
                    return call(argument)

            return limited_call

        result = race(
            [replace(one, name=level, call=at(level)) for level in _LEVELS], settings.rounds, budget=3.0, keep=False
        )
        table.add(work, *(result.ratio(level, _LEVELS[0]) for level in _LEVELS[1:]))
    return table
