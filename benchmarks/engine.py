"""The contenders from lommel: each through its public calls."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

import lommel as lm
from benchmarks.timing import Contender
from benchmarks.truth import Window, intensity


def engine(
    question: Window,
    *,
    name: str = "lommel",
    method: lm.Method | None = None,
    threads: int = 1,
    out: bool = False,
    dtype: Any = None,
    **options: Any,
) -> Contender:
    """Make one PSF by ``lm.psf``, each time of a new pupil; with `out`, into an array that is there already."""
    q = question
    if method is not None:
        options["method"] = method
    if q.center is not None:
        options["center"] = q.center
    if dtype is not None:
        options["dtype"] = dtype
    if out:
        options["out"] = np.zeros((q.n, q.n), dtype or np.float32)
        options.pop("dtype", None)

    def call(pupil: lm.Pupil) -> lm.PSF:
        return lm.psf(pupil, q.n, q.pixel, threads=threads, **options)

    return Contender(name, call, describe(method, threads, out, dtype), q.fresh, intensity)


def stack(
    fresh: Callable[[int], list[lm.Pupil]],
    n: int,
    pixel: float,
    *,
    name: str = "lommel",
    method: lm.Method | None = None,
    threads: int = 1,
    out: bool = False,
    dtype: Any = np.float64,
) -> Contender:
    """Make a stack of PSFs by one ``lm.psf``, each time of a new stack of pupils."""
    options: dict[str, Any] = {"dtype": dtype} if method is None else {"dtype": dtype, "method": method}
    if out:
        options["out"] = np.zeros((*fresh(1)[0].shape, n, n), dtype)

    def call(pupils: lm.Pupil) -> lm.PSF:
        return lm.psf(pupils, n, pixel, threads=threads, **options)

    return Contender(name, call, describe(method, threads, out, dtype), fresh, intensity)


def describe(method: lm.Method | None, threads: int, out: bool, dtype: Any) -> str:
    """Say in words what was asked for."""
    parts = ["lm.psf(...)", "default method, tol 1e-6" if method is None else repr(method)]
    parts += [] if dtype is None else [str(np.dtype(dtype))]
    parts += ["out= given"] if out else []
    return ", ".join([*parts, f"threads={threads}"])


def through_focus(reach: float, count: int, spherical: float = 0.0) -> Callable[[int], list[lm.Pupil]]:
    """Return a maker of stacks of pupils from ``C_d = -reach`` to ``reach``."""
    defocus = np.linspace(-reach, reach, count)

    def fresh(times: int) -> list[lm.Pupil]:
        return [lm.Pupil(lm.Wavefront(defocus * (1.0 - 1e-7 * k), spherical)) for k in range(times)]

    return fresh
