"""What the benchmarks ran on, without names of hosts, users or folders."""

from __future__ import annotations

import os
import platform
import sys
from importlib.metadata import version
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.baselines import copy, fft
from benchmarks.peers import peer_versions
from benchmarks.timing import race

ROOT = Path(__file__).resolve().parent.parent


def describe() -> dict[str, Any]:
    """Return processor, system, versions, and two yardsticks in microseconds."""
    build = np.show_config(mode="dicts")
    blas = build.get("Build Dependencies", {}).get("blas", {}) if isinstance(build, dict) else {}
    yards = race([fft(), copy((512, 512), np.float64)], 15, keep=False)
    return {
        "processor": processor(),
        "processors in use": _processors(),
        "memory": f"{_memory_gib():.0f} GiB",
        "system": f"{platform.system()}, {platform.machine()}",
        "versions": {
            "Python": platform.python_version(),
            "lommel": version("lommel"),
            "NumPy": np.__version__,
            "SciPy": version("scipy"),
            "BLAS": f"{blas.get('name', 'unknown')} {blas.get('version', '')}".strip(),
        }
        | peer_versions(),
        "yardsticks": {name: 1e6 * yards.median(name) for name in yards.seconds},
    }


def processor() -> str:
    """Return the name of the processor."""
    try:
        for line in Path("/proc/cpuinfo").read_text().splitlines():
            if line.startswith("model name"):
                return " ".join(line.split(":", 1)[1].split())
    except OSError:
        pass
    return platform.processor() or platform.machine()


def _processors() -> int:
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def _memory_gib() -> float:
    try:
        return os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE") / 2**30
    except (AttributeError, ValueError, OSError):
        return float("nan")


def clean(text: str) -> str:
    """Take the names of folders and of the host out of a text, wherever a message brought them in."""
    private = {str(ROOT): "…", sys.prefix: "…", str(Path.home()): "~", platform.node(): "host"}
    for name, instead in private.items():
        if len(name) > 3:
            text = text.replace(name, instead)
    return text
