"""Images as sensors record them, by any method: a lattice is asked for what the tolerance needs."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from lommel.base.arrays import Array, largest
from lommel.core.answers import Images, Wanted, not_met
from lommel.methods.asked import wanted_on
from lommel.methods.choice import candidates
from lommel.methods.method import Method, normalized_error, stored, storing
from lommel.methods.wanted import place
from lommel.optics.grid import Grid
from lommel.sensor.blurs import Blur, require_unit
from lommel.sensor.halo import Gate
from lommel.sensor.lattice import STEP, Asked, Made, summed
from lommel.sensor.spread import Short, halo_of

_TRIES = 7


def recorded_images(
    method: Method | None, tol: float, pupil: Any, grid: Grid, several: tuple[Blur, ...], wanted: Wanted
) -> tuple[Method, Images]:
    """Return the method that sampled, and finished images of a stack on `grid`, spread by what is named.

    Parameters
    ----------
    method : Method or None
        That is to sample; None for what serves the pupil.
    tol : float
        Over the largest value in the window or around the axis; of values divided by their own, over that.
    pupil, grid
    several : tuple of Blur
    wanted : Wanted
        Without derivatives.

    Returns
    -------
    method : Method
    images : Images

    Raises
    ------
    ToleranceError
        If the bound stays above `tol`.
    ValueError
        If the method does not support the pupil, or has no point values.
    """
    if method is not None and method.sampling == "pixel":
        raise ValueError(
            f"method must have point values for blur, fill and pixels that are not square, got "
            f"{type(method).__name__}, which has none; leave it out"
        )
    dtype, peaked = wanted.dtype, wanted.scale is None
    aim = (0.45 if peaked else 0.9) * (tol - 1.1 * storing(dtype))
    asked = _first(method, pupil, grid, several, aim, wanted.threads)
    elsewhere = 0.0 if peaked else _on_axis(asked, pupil, grid, several)
    for _ in range(_TRIES):
        made = summed(asked, pupil, grid, several)
        tops = np.maximum(made.values.max(axis=(1, 2)), elsewhere)
        if not tops.min() > 0:
            raise ValueError("no light falls into the window that is brighter than the errors there")
        if made.given is None:
            # Nothing is known of the samples: what is added is kept below the tolerance on its own.
            relative, unknown = (made.response + made.missing) / tops, True
        else:
            relative, unknown = (made.given + made.response + made.missing) / tops, False
        relative = np.where(relative < 0.5, relative / (1.0 - np.minimum(relative, 0.5)), np.inf)
        bounds = stored(normalized_error(relative) if peaked else relative, dtype)
        if bounds.max() <= tol or (method is not None and not method.keeps_tol and not unknown):
            return _finished(made, bounds if not unknown else None, wanted)
        asked = _again(asked, made, aim * tops)
    raise not_met(tol, float(bounds.max()), "the largest value in the window")


def _on_axis(asked: Asked, pupil: Any, grid: Grid, several: tuple[Blur, ...]) -> Any:
    """Return what pixels around the axis record at least, for windows beside it: errors are over that too."""
    rows, columns = np.broadcast_arrays(*grid.center)
    if np.all((rows > -0.5) & (rows < grid.height - 0.5) & (columns > -0.5) & (columns < grid.width - 0.5)):
        return 0.0
    there = Grid(3, grid.pixel, integrate=grid.integrate, fill=grid.fill)
    made = summed(asked._replace(tol=max(asked.tol, 1e-6), error=max(asked.error, 1e-9)), pupil, there, several)
    off = made.response + made.missing + (0.0 if made.given is None else made.given)
    return np.maximum(made.values.max(axis=(1, 2)) - off, 0.0)


def _first(
    method: Method | None, pupil: Any, grid: Grid, several: tuple[Blur, ...], aim: float, threads: int
) -> Asked:
    """Return what is likely to be enough, from how wide things are."""
    to_v = math.pi / pupil.scale
    short = Short.of(several, pupil.scale)
    halo = halo_of(several, pupil.scale, pupil.wavelength, Gate.of(STEP, 1e-6))
    spot = 4.0 * math.pi * pupil.transmission / pupil.likely_peak
    sides = 2.0 * math.pi * np.diag(short.covariance) + (short.streaks**2).sum(axis=0)
    sides = sides + np.array([(to_v * a) ** 2 for a in grid.active[::-1]])
    area = math.sqrt(float(np.prod(spot + sides)))
    margin = 0.0
    if halo.several:
        core = float(halo.at(np.zeros(1))[0])
        area += 1.0 / core
        width = 1.5 / math.sqrt(core)
        blur = float(pupil.v(pupil.geometric_radius()).max())
        # Airy's light beyond R is 2 / (pi R) of all, and a halo falls as R^(-11/3).
        margin = blur + 60.0 + width * (1.0 / (aim * max(width, 1.0))) ** (3.0 / 14.0)
    bright = 4.0 * math.pi * pupil.transmission / area
    tol = max(0.3 * aim * spot / area, 1e-13)  # over the peak of the samples
    return Asked(method, threads, tol, max(0.02 * aim * bright / pupil.amplitude**2, 1e-15), margin)


def _again(asked: Asked, made: Made, allowed: Array) -> Asked:
    """Return what is asked next, by what was off too much."""

    def factor(part: Array | None, share: float) -> float:
        worst = 0.0 if part is None else float((part / (share * allowed)).max())
        return max(worst, 0.0)

    tol, error, margin = asked.tol, asked.error, asked.margin
    if (much := factor(made.given, 0.5)) > 1.0:
        tol *= max(0.5 / much, 1e-4)
    if (much := factor(made.response, 0.2)) > 1.0:
        error *= max(0.5 / much, 1e-6)
    if (much := factor(made.missing, 0.3)) > 1.0:
        margin *= min(1.1 * much ** (3.0 / 14.0), 3.0)
        # How much light is missing is told by the sum of the samples.
        tol *= 0.5
    return asked._replace(tol=tol, error=max(error, 1e-15), margin=margin)


def _finished(made: Made, bounds: Array | None, wanted: Wanted) -> tuple[Method, Images]:
    tops = made.values.max(axis=(1, 2))
    scales = 1.0 / tops if wanted.scale is None else np.broadcast_to(np.asarray(wanted.scale), tops.shape)
    values = np.empty(made.values.shape, wanted.dtype) if wanted.out is None else wanted.out
    # Nothing is negative that is an average of light.
    np.multiply(np.maximum(made.values, 0.0), scales[:, None, None], out=values, casting="same_kind")
    return made.method, Images(values, scales, bounds)


def recorded(
    pupil: Any,
    grid: Grid,
    several: tuple[Blur, ...],
    asked: tuple[Method | None, float, str, Any, int],
    out: Any = None,
) -> dict[str, Any]:
    """Return the parts of the answer for `pupil` on `grid`, as :class:`lommel.Plan` puts them together.

    Parameters
    ----------
    pupil, grid
    several : tuple of Blur
    asked : tuple
        Method or None, tolerance, normalisation, type of the values and threads.
    out : ndarray, optional
        Where the values go.

    Returns
    -------
    dict

    Raises
    ------
    TypeError, ValueError, ToleranceError
        As :func:`recorded_images`; also if a blur is in another unit than the pupil, or `out` does not fit.
    """
    method, tol, normalize, dtype, threads = asked
    if grid.stack:
        grid = grid.broadcast(pupil.shape)
    require_unit(several, pupil)
    if pupil.layered:
        raise ValueError(
            "blur, fill and pixels that are not square are for lenses, got the pupil of an Objective: ask for finer "
            "square pixels, and sum blocks of them"
        )
    way = method or candidates(pupil, Grid(grid.shape, min(grid.pitch)), tol)[0]
    wanted = wanted_on(grid, pupil, way, normalize, dtype, threads)
    shape = pupil.shape + grid.shape
    values = np.empty(shape, dtype) if out is None else place(out, shape, dtype)
    question = wanted._replace(out=values.reshape(-1, *grid.shape))
    used, made = recorded_images(method, tol, pupil, grid, several, question)
    # Samples are asked for more than what is recorded.
    used = method or used.with_tol(tol)
    return {
        "values": values,
        "grid": grid,
        "pupil": pupil,
        "method": used,
        "normalize": normalize,
        "error_bound": None if made.error is None else largest(made.error),
        "scale": np.asarray(made.scale).reshape(pupil.shape),
        "derivatives": {},
        "derivative_bounds": {},
        "blur": several,
    }
