"""The result of a deconvolution, and its progress on a terminal."""

from __future__ import annotations

import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import DTypeLike, NDArray

from lommel.base import validation
from lommel.base.arrays import Array, Json, Values, fields_of, plain
from lommel.deconvolve.algorithms import ProgressCallback, silent
from lommel.fit.findings import Findings, Judged

Pixels = NDArray[np.generic]  # stored values, unsigned integers or floats

_QUIET, _PAUSE = 1.5, 0.2  # seconds before the first progress line, and between lines


@dataclass(frozen=True, eq=False, repr=False)
class Restoration(Judged):
    """Result of :func:`lommel.imaging.restore`; converts to an array of its values.

    Attributes
    ----------
    values : ndarray
        Restored image, of the shape, type and encoding of the photograph, without the offset of its noise; float32
        for a stack.
    light : ndarray of float, or None
        The same in linear light, not clipped at white. None for results of tiles.
    discrepancy : float
        Poisson deviance per pixel between the photograph and the blurred result: about 1 for the scene itself, a
        little less for a good result, which follows some of the noise.
    by_channel : tuple of float
        Discrepancy of each channel, or of each plane of a stack.
    before : float
        Discrepancy of the photograph itself, taken as the result.
    steps : int
        Number of steps in all; each applies the blur and its transpose once.
    stopped : str
        Why it stopped: "noise" where the result agrees with the photograph within its noise, "steps" at the maximum
        number of steps, "one pass", "misfit: ..." where depth, lens or noise of a photograph (PSF or noise of a
        stack) do not fit.
    strength : float or None
        Weight of the total variation.
    unknown : float
        Fraction of the values of the photograph that were NaN or saturated.
    clipped : float
        Fraction of the values that were clipped at white; 0 for floats.
    background : float or ndarray
        Light of each voxel of a stack, or of each pixel of its planes, that is no part of the values; 0 for
        photographs.
    photograph : float
        Share of the photograph itself in the result, 0 to 1: 1 where the method's own would be farther from the
        scene, because depth, lens or noise do not fit; between where blur is hardly larger than noise.
    findings : Findings
        What does not fit: the codes "misfit", "too_quiet" and, where more steps would fit better, "not_settled".
    """

    values: Pixels
    light: Values | None
    discrepancy: float
    by_channel: tuple[float, ...]
    before: float
    steps: int
    stopped: str
    strength: float | None = None
    unknown: float = 0.0
    clipped: float = 0.0
    background: float | Array = 0.0
    photograph: float = 0.0
    findings: Findings = field(default_factory=Findings)

    @property
    def message(self) -> str:
        """Status, discrepancy, number of steps, and the texts of all findings."""
        return self._message(f"discrepancy {self.discrepancy:.3g} after {self.steps} step{'s' * (self.steps != 1)}")

    def to_dict(self) -> Json:
        """Return the result as plain data, as JSON has it, without images.

        Returns
        -------
        dict
            Status, converged, reliable, and the attributes but for arrays; None where these are not finite.
        """
        verdict = {name: getattr(self, name) for name in ("status", "converged", "reliable")}
        numbers = {name: each for name, each in fields_of(self).items() if not isinstance(each, np.ndarray)}
        numbers.pop("light", None)  # None of tiles
        found: Json = plain(verdict | numbers)
        return found

    def __array__(self, dtype: DTypeLike | None = None, copy: bool | None = None) -> Pixels:
        """Return the values."""
        return np.array(self.values, dtype=dtype, copy=copy)

    def __repr__(self) -> str:
        """Return the result in one line."""
        size = " x ".join(map(str, self.values.shape))
        return (
            f"<Restoration, {size}: discrepancy {self.before:.3g} before, {self.discrepancy:.3g} after "
            f"{self.steps} steps, stopped by {self.stopped!r}>"
        )


@contextmanager
def shown(progress: ProgressCallback | None) -> Iterator[ProgressCallback]:
    """Yield the function called at each step: `progress`, or a line on standard error if it is a terminal."""
    validation.function("progress", progress, required=False)
    if progress is not None or sys.stderr is None or not sys.stderr.isatty():
        yield progress or silent
        return
    line, due = sys.stderr, time.monotonic() + _QUIET

    def write(step: int, discrepancy: float, left: float) -> None:
        nonlocal due
        if (now := time.monotonic()) >= due:
            line.write(f"\rstep {step}, discrepancy {discrepancy:.3g}, about {left:.0f} s left\x1b[K")
            line.flush()
            due = now + _PAUSE

    start = due
    try:
        yield write
    finally:
        if due > start:
            line.write("\r\x1b[K")
            line.flush()
