"""What restores a photograph, for any linear blur: the seam for operators of one's own, and the answer."""

from __future__ import annotations

import math
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from lommel.base import validation
from lommel.estimation.noise import Noise
from lommel.imaging.linear import LinearBlur
from lommel.imaging.restoration.observed import Method, Observed, Tell
from lommel.imaging.restoration.richardson_lucy import RichardsonLucy
from lommel.imaging.restoration.total_variation import TotalVariation

Progress = Callable[[int, float, float], object]

_QUIET, _PAUSE = 1.5, 0.2  # seconds until a line is shown, and from one to the next


@dataclass(frozen=True, eq=False, repr=False)
class Restoration:
    """What :func:`lommel.imaging.restore` returns; an array where one is wanted.

    Attributes
    ----------
    values : ndarray
        Of the shape, type and encoding of the photograph, without the offset of its noise; of a stack float32.
    light : ndarray of float, or None
        The same in proportion to light; what is brighter than white is kept here. None of an image done by tiles.
    discrepancy : float
        Poisson deviance a pixel of what the blur makes of the result: about 1 for the scene itself, a little less for
        a good result, which follows some of the noise.
    by_channel : tuple of float
        That of each channel, or plane of a stack.
    before : float
        That of the photograph, were it the sharp scene.
    steps : int
        Taken in all; each applies the blur and its transpose once.
    stopped : str
        Why: "noise", when the result agrees with the photograph as well as its noise lets it; "steps", when there
        were as many as allowed before that; "misfit: ..." with what may not fit, when it will not: depth, lens or
        noise of a photograph, the PSF or the noise of a stack.
    strength : float or None
        Of the total variation.
    unknown : float
        Share of the values of the photograph that were NaN, of which nothing, or saturated, of which little is known.
    clipped : float
        Share of the values that are brighter than white, and are white now; 0 where the type holds them.
    """

    values: NDArray[Any]
    light: NDArray[Any] | None
    discrepancy: float
    by_channel: tuple[float, ...]
    before: float
    steps: int
    stopped: str
    strength: float | None = None
    unknown: float = 0.0
    clipped: float = 0.0

    def __array__(self, dtype: DTypeLike | None = None, copy: bool | None = None) -> NDArray[Any]:
        """Return the values."""
        return np.array(self.values, dtype=dtype, copy=copy)

    def __repr__(self) -> str:
        """Return what was reached, in one line."""
        size = " x ".join(map(str, self.values.shape))
        return (
            f"<Restoration, {size}: discrepancy {self.before:.3g} before, {self.discrepancy:.3g} after "
            f"{self.steps} steps, stopped by {self.stopped!r}>"
        )


def restore_with(
    light: ArrayLike,
    blur: LinearBlur,
    noise: Noise,
    *,
    method: Method | None = None,
    saturation: float = math.inf,
    progress: Progress | None = None,
) -> Restoration:
    """Restore light that any linear blur has spread.

    Parameters
    ----------
    light : array_like of float, shape (height, width) or (height, width, channels)
        As it was recorded, in proportion to light but for the offset. NaN where a pixel is unknown.
    blur : LinearBlur
        :class:`lommel.imaging.Occlusion`, :class:`lommel.imaging.DepthBlur`, or one of your own; no entry of its
        matrix may be negative.
    noise : Noise
        Of the values of `light`.
    method : RichardsonLucy or TotalVariation, optional
        By default ``RichardsonLucy()``.
    saturation : float, default infinity
        Values from here on are saturated: they tell that there was at least so much.
    progress : callable, optional
        Called as ``progress(step, discrepancy, seconds_left)`` at each step; what it raises ends the work. By default
        the same is written to standard error from the second second on, where that is a terminal.

    Returns
    -------
    Restoration
        Its `values` are its `light`, of the type of the sums of `blur`.

    Raises
    ------
    TypeError, ValueError
        If an argument is none of these; if `light` has not the shape of `blur`, is infinite, or NaN everywhere.

    Examples
    --------
    >>> lens = lm.Lens(focal_length=50e-3, f_number=4.0, focus_distance=2.0, wavelength=550e-9)
    >>> blur = lm.imaging.DepthBlur(np.full((40, 60), 2.3), lens, 8e-6)
    >>> scene = np.full((40, 60), 0.1)
    >>> scene[10:30, 20:40] = 0.7
    >>> noise = lm.Noise(white=5000, read=3.0)
    >>> photo = noise.record(5000 * blur.forward(scene), seed=0)
    >>> found = lm.imaging.restore_with(photo, blur, noise)
    >>> found.stopped, bool(abs(found.light - scene).mean() < 0.5 * abs(photo - scene).mean())
    ('noise', True)
    """
    validation.instance("blur", blur, LinearBlur)
    validation.instance("noise", noise, Noise)
    way = checked_method(method)
    checked_progress(progress)
    recorded = validation.array("light", light)
    if recorded.dtype.kind != "f":
        raise TypeError(f"light must hold floats in proportion to light, got {recorded.dtype}")
    if np.isinf(recorded).any():
        raise ValueError("light must be finite, or NaN where it is unknown, got infinity")
    wanted = (*blur.shape, blur.channels) if recorded.ndim == 3 or blur.channels > 1 else blur.shape
    if recorded.shape != wanted:
        raise ValueError(f"light must have the shape of the blur, {wanted}, got {recorded.shape}")
    limit = validation.real("saturation", saturation, infinite=True)
    observed = Observed.of(blur, recorded, noise, limit)
    with shown(progress) as tell:
        before = _discrepancies(observed, observed.image)
        found = way.solve(observed, tell)
    after = _discrepancies(observed, found.light)
    return Restoration(
        found.light,
        found.light,
        _mean(after, observed),
        tuple(map(float, after)),
        _mean(before, observed),
        found.steps,
        found.stopped,
        found.strength,
        1.0 - float(observed.known.sum()) / recorded.size,
    )


def checked_method(method: Any) -> RichardsonLucy | TotalVariation:
    """Return a method, the usual one for None; TypeError if it is none."""
    if method is None:
        return RichardsonLucy()
    if not isinstance(method, RichardsonLucy | TotalVariation):
        hint = "; write it with brackets" if isinstance(method, type) else ""
        raise TypeError(
            f"method must be RichardsonLucy(...) or TotalVariation(...), got {validation.shown(method)}{hint}"
        )
    return method


def checked_progress(progress: Any) -> None:
    """Raise TypeError unless `progress` can be called, or is None."""
    if progress is not None and not callable(progress):
        raise TypeError(f"progress must be callable, got {validation.shown(progress)}")


@contextmanager
def shown(progress: Progress | None) -> Iterator[Tell]:
    """Give what tells of each step: what was given, or else a line on standard error, where that is a terminal."""
    checked_progress(progress)
    if progress is not None or sys.stderr is None or not sys.stderr.isatty():
        yield progress or (lambda *_: None)
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


def _discrepancies(observed: Observed, light: NDArray[Any]) -> NDArray[np.float64]:
    model = observed.model(light)
    return observed.discrepancies(model, observed.ratio(model))


def _mean(each: NDArray[np.float64], observed: Observed) -> float:
    return float((each * observed.known).sum() / observed.known.sum())
