"""Pixels that average over their area, or lie off the symmetric grid: exact to the tolerance of the method."""

from __future__ import annotations

import math
from typing import Any, ClassVar, NamedTuple, Protocol, Self

import numpy as np
from numpy.typing import NDArray

from lommel.core.answers import Intensities, ToleranceError
from lommel.core.engine import Window, gauss_error, pixel_radii, pixel_values
from lommel.optics.base_pupil import BasePupil
from lommel.optics.grid import Grid
from lommel.special.legendre import gauss_legendre

_ROUNDOFF = 2.0**-53
_LEVELS = range(3, 16)  # errors of 10^-level that tables of the compiled core may have
_USUAL = 10
_SCAN = 512


class _Profiled(Protocol):
    """What is asked of a method here: :class:`lommel.methods.RadialMethod`, which stands above, has it."""

    @property
    def tol(self) -> float: ...

    keeps_tol: ClassVar[bool]

    def profile(self, pupil: Any, v: NDArray[np.float64]) -> Intensities: ...
    def stretch(self, pupil: Any) -> float: ...
    def tightened(self) -> Self: ...
    def unaberrated_peak(self, pupil: Any) -> float: ...


class _Values(NamedTuple):
    """Values of pixels, and the parts of the bound on their error; None where the method has none."""

    values: NDArray[np.float64]
    given: NDArray[np.float64] | None
    added: NDArray[np.float64]


def subpixel_intensity(
    method: _Profiled, pupil: Any, grid: Grid, threads: int, *, tol: float | None = None, window: bool = False
) -> Intensities:
    r"""Return I at, or averaged over, each pixel, shape ``(n, height, width)``, from profiles of a method.

    Every value is a weighted sum of I at few radii; the weights depend on the window only, and the core keeps
    them. I is band-limited (of exponential type 2 in v) and within half its largest value of a constant, which bounds
    what the sums are off by; see section 9 of docs/certificate.md.

    Parameters
    ----------
    method, pupil, grid, threads
    tol : float, optional
        What the bound should not exceed, by default the tolerance of the method.
    window : bool, default False
        Relate the error to the largest value in the window, not to the largest over the plane.

    Returns
    -------
    Intensities
        Its `peak` is what the largest value is at least.

    Raises
    ------
    ToleranceError
        If the bound cannot be brought below `tol`. A method whose tolerance is no contract is carried on without loss
        instead.
    """
    allowed, finer = method.tol if tol is None else tol, method
    level = _level(0.2 * allowed * _likely_value(pupil, grid) / (0.5 * method.unaberrated_peak(pupil)))
    if method.profile(pupil, np.zeros(1)).error is None:
        level = _USUAL  # whatever the stack
    elsewhere, looked = np.zeros(math.prod(pupil.shape)), window
    while True:
        made = _values(finer, pupil, grid, level, threads)
        top = made.values.max(axis=(1, 2))
        if made.given is None:
            return Intensities(made.values, None, top)
        error = made.given + made.added
        peak = np.maximum(top - error, elsewhere)
        if not looked and np.any(error > allowed * peak):
            elsewhere, looked = _peak_at_least(finer, pupil, grid, level, threads), True
            peak = np.maximum(peak, elsewhere)
        relative = np.divide(error, peak, out=np.full(peak.shape, np.inf), where=peak > 1e-300)
        worst = int(relative.argmax())
        room = 0.2 * allowed * max(float(top[worst]), float(elsewhere[worst]), 1e-3 * float(error[worst]))
        before = level, finer
        if made.added[worst] > room:
            level = max(level, min(_LEVELS[-1], level + math.ceil(math.log10(made.added[worst] / room))))
        if made.given[worst] > room:
            finer = _finer(finer, method)
        stuck = (level, finer) == before
        if relative[worst] <= allowed or (stuck and not method.keeps_tol):
            return Intensities(made.values, relative, peak)
        if stuck:
            raise ToleranceError(
                f"tol={method.tol:g} cannot be met: the error is bounded by {relative[worst]:.2g} of the "
                f"{'largest value in the window' if window else 'peak'}"
            )


def _values(method: _Profiled, pupil: Any, grid: Grid, level: int, threads: int) -> _Values:
    # What varies faster than I is I of a larger window.
    faster, ceiling = method.stretch(pupil), method.unaberrated_peak(pupil)
    window = Window(grid.shape, grid.axis, faster * grid.step(pupil))
    asked: dict[str, Any] = {"integrate": grid.integrate, "level": level, "threads": threads}
    v, error, of_nodes, of_grid, rounding = pixel_radii(window, **asked)
    profile = method.profile(pupil, v / faster)
    values, penalties = pixel_values(window, profile.values, **asked)
    # No average of an intensity is negative, and none less exact for it.
    np.maximum(values, 0.0, out=values)
    size = profile.values.max(axis=1)
    # |I'| = 2 |U| |U'|, and |U'| < 1/2; radii, places in a pixel and pixels are off by a few roundings each.
    slope = np.sqrt(of_nodes * size * max(1.0, ceiling))
    places = float(v[-1]) * slope * (3.0 * of_grid * of_nodes + 6.0 * of_grid + 4.0)
    added = 0.5 * ceiling * error + _ROUNDOFF * (rounding * size + penalties + places)
    if profile.error is None:
        return _Values(values, None, added)
    peak = size if profile.peak is None else profile.peak
    return _Values(values, of_grid * of_nodes * profile.error * peak, added)


def _likely_value(pupil: BasePupil, grid: Grid) -> float:
    """Return what the largest value may be: the peak of I or, of pixels that hold all light, its average."""
    side = grid.step(pupil) if grid.integrate else 0.0
    return 1.0 / (1.0 / pupil.likely_peak + side**2 / (4.0 * math.pi * pupil.transmission))


def _level(error: float) -> int:
    return min(max(math.ceil(-math.log10(error)), _LEVELS[0]), _LEVELS[-1])


def _finer(method: _Profiled, asked: _Profiled) -> _Profiled:
    """Return a method with about a tenth of the tolerance, or the same where there is none."""
    for _ in range(3):
        try:
            method = method.tightened()
        except ValueError:  # its least tolerance
            break
    return method if method.tol >= 1e-5 * asked.tol else asked


def _peak_at_least(method: _Profiled, pupil: Any, grid: Grid, level: int, threads: int) -> NDArray[np.float64]:
    """Return what the largest value over the plane is at least: a window may miss the peak.

    Looks at pixels on a line from the axis to where the last rays arrive.
    """
    blur = float(pupil.v(pupil.geometric_radius()).max()) + 4.0
    pixel = grid.side if grid.integrate else blur / _SCAN / grid.step(pupil) * grid.side
    count = min(_SCAN, math.ceil(blur / (grid.step(pupil) * pixel / grid.side))) + 1
    line = Grid((1, count), pixel, center=(0.0, 0.0), integrate=grid.integrate)
    made = _values(method, pupil, line, level, threads)
    assert made.given is not None
    return np.asarray(made.values.max(axis=(1, 2)) - made.given - made.added)


def gauss_pixel(width: float, error: float) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return offsets in v and weights that average I over a pixel of `width` in v along one axis, erring by `error`.

    The error is over ``sup|U|^2`` and holds for any pupil: U is of exponential type 1 along either axis.
    """
    x, w = gauss_legendre(pixel_nodes(width, error), -0.5, 0.5)
    return width * x, w


def pixel_error(width: float, nodes: int) -> float:
    """Bound the error of the q-point average over a pixel of `width` in v, along one axis, over sup|U|^2."""
    # The core bounds both axes, over half the range of I.
    return 0.25 * gauss_error(width, nodes)


def pixel_nodes(width: float, error: float) -> int:
    """Return the fewest nodes along an axis for which :func:`pixel_error` is at most `error`."""
    nodes = 1
    while pixel_error(width, nodes) > error:
        nodes += 1
    return nodes
