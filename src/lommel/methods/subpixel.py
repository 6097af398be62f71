"""Pixels that average over their area, or lie off the symmetric grid: exact to the tolerance of the method."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from lommel import _core
from lommel.grid import Grid
from lommel.pupil import Pupil
from lommel.special.legendre import gauss_legendre

if TYPE_CHECKING:
    from lommel.methods.method import Intensities, RadialMethod

_MAX_SAMPLES = 2**26
_MAX_WORK = 10**11


def subpixel_intensity(method: RadialMethod, pupil: Pupil, grid: Grid, threads: int) -> Intensities:
    r"""Return I at, or averaged over, each pixel, shape ``(n, height, width)``.

    Averages are Gauss-Legendre sums. The profile is evaluated at each point, or tabulated at a uniform step h and
    interpolated by cubics where that takes fewer evaluations. I is
    band-limited (of exponential type 2 in v, and U of type 1 with ``|U| <= 1 - eps^2``), so
    ``|I^(k)| <= 2^(k-1) (1 - eps^2)^2`` (Bernstein): the cubic errs by ``3 h^4 / 16`` of that square, the q-point
    average over a pixel of width a by ``a^(2q) (q!)^4 2^(2q-1) / ((2q+1) ((2q)!)^3)`` of it along each axis.
    """
    from lommel.methods.method import Intensities

    finer = method.tightened()
    step = grid.step(pupil)
    # A centred image is four times its quadrant, whose first pixel has the axis in its middle.
    shape = (grid.height // 2 + 1, grid.width // 2 + 1) if grid.centered else grid.shape
    center = (0.0, 0.0) if grid.centered else grid.center
    half = 0.5 if grid.integrate else 0.0
    far = math.hypot(*(max(abs(c), abs(side - 1 - c)) + half for c, side in zip(center, shape, strict=True)))
    images, errors = [], []
    for one in [pupil] if pupil.shape == () else [pupil[index] for index in np.ndindex(pupil.shape)]:
        image, error = _one(method, finer, one, step, shape, center, far, grid.integrate, threads)
        images.append(grid.unfold(image) if grid.centered else image)
        errors.append(error)
    bounds = None if any(e is None for e in errors) else np.array(errors, dtype=np.float64)
    return Intensities(np.stack(images), bounds)


def _one(
    method: RadialMethod,
    finer: RadialMethod,
    pupil: Pupil,
    step: float,
    shape: tuple[int, int],
    center: tuple[float, float],
    far: float,
    integrate: bool,
    threads: int,
) -> tuple[NDArray[np.float64], float | None]:
    from lommel.methods.method import ToleranceError

    ceiling = pupil.area**2
    # A first look at how bright the window is; the answer is checked against what it turns out to be.
    look = finer.profile(pupil, np.linspace(0.0, far * step, 257)).values[0]
    bright = float(look.mean() if integrate else look.max())
    for _ in range(8):
        budget = 0.1 * method.tol * bright / ceiling
        spacing = (16.0 / 3.0 * budget) ** 0.25
        nodes = pixel_nodes(step, budget) if integrate else 1
        x, w = gauss_legendre(nodes, -0.5, 0.5) if integrate else (np.zeros(1), np.ones(1))
        count = math.ceil(far * step / spacing) + 6
        work = shape[0] * shape[1] * nodes**2
        image = np.empty(shape)
        tabulated = count < work
        if min(count, work) > _MAX_SAMPLES or work > _MAX_WORK:
            raise ValueError(
                f"pixels of v = {step:.3g} to {method.tol:g} take {min(count, work):.2g} radii and {work:.2g} "
                f"interpolations, more than the limits of {_MAX_SAMPLES} and {_MAX_WORK:.0g}"
            )
        if tabulated:
            profile = finer.profile(pupil, spacing * np.arange(count))
            samples = np.concatenate([profile.values[0, 1:2], profile.values[0]])
            _core.paint_subpixel(samples, step / spacing, *center, x, w, threads, image)
        else:
            y_at = (np.arange(shape[0]) - center[0])[:, None] + x
            x_at = (np.arange(shape[1]) - center[1])[:, None] + x
            radii = np.hypot(y_at[:, None, :, None], x_at[None, :, None, :])
            v, where = np.unique(step * radii.ravel(), return_inverse=True)
            profile = finer.profile(pupil, v)
            image[:] = np.einsum("yxab,a,b->yx", profile.values[0][where].reshape(radii.shape), w, w)
        if profile.error is None:
            return image, None
        top = float(profile.values.max() if profile.peak is None else profile.peak[0])
        # Cubic interpolation magnifies the errors of the samples by 1.25 at most.
        given = float(profile.error[0]) * top * (1.25 if tabulated else 1.0)
        added = 3.0 / 16.0 * spacing**4 * ceiling if tabulated else 0.0
        added += 2.0 * pixel_error(step, nodes) * ceiling if integrate else 0.0
        bound = (given + added) / float(image.max())
        # A method whose tolerance is no contract on the intensity is carried on without loss.
        if bound <= method.tol or (not method.keeps_tol and added <= given):
            return image, bound
        bright *= 0.1
        finer = finer.tightened().tightened().tightened()
    raise ToleranceError(f"tol={method.tol:g} cannot be met: the bound on the error stays at {bound:.2g} of the peak")


def gauss_pixel(width: float, error: float) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return offsets in v and weights that average I over a pixel of `width` in v along one axis, erring by `error`.

    The error is over ``sup|U|^2`` and holds for any pupil: U is of exponential type 1 along either axis.
    """
    x, w = gauss_legendre(pixel_nodes(width, error), -0.5, 0.5)
    return width * x, w


def pixel_error(width: float, nodes: int) -> float:
    """Bound the error of the q-point average over a pixel of `width` in v, along one axis, over sup|U|^2."""
    q = nodes
    logarithm = (
        2 * q * math.log(width)
        + 4 * math.lgamma(q + 1)
        + (2 * q - 1) * math.log(2.0)
        - math.log(2 * q + 1)
        - 3 * math.lgamma(2 * q + 1)
    )
    return math.exp(min(logarithm, 700.0))


def pixel_nodes(width: float, error: float) -> int:
    """Return the fewest nodes along an axis for which :func:`pixel_error` is at most `error`."""
    nodes = 1
    while pixel_error(width, nodes) > error:
        nodes += 1
    return nodes
