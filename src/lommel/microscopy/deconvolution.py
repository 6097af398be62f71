"""Deconvolution of a stack of planes that a microscope recorded."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from numpy.typing import ArrayLike

from lommel.base import validation
from lommel.base.arrays import Array, Values
from lommel.estimation.noise import Noise
from lommel.imaging.deconvolution import MISFIT, TINY, Counts, Course, RichardsonLucy, Tell
from lommel.imaging.restoration import Restoration, shown
from lommel.microscopy.stack_blur import Part, Piece, TiledBlur, overlap
from lommel.psf import PSF

STACK_MISFIT = (
    "misfit: the PSF (wavelength, depth, direction of z, steps of z, pixels) or the noise is not that of the stack"
)
"""Why a method stopped that a stack does not follow."""

# Why a method stopped at once, at a discrepancy that is too small for the noise that was stated.
TOO_QUIET = "misfit: the stack is quieter than its noise; is the offset left out, or the read noise too large?"

_LEAST_PLANES = 8  # of the margin, where the PSF has so many
_MOST_CHANGE = 6e4  # that half precision holds
_EVERY = 2  # along each axis, of the voxels that say how far to extrapolate


def deconvolve(
    stack: ArrayLike,
    psf: PSF,
    noise: Noise,
    *,
    method: RichardsonLucy | None = None,
    margin: tuple[int, int] | None = None,
    progress: Tell | None = None,
) -> Restoration:
    """Deconvolve a stack of planes recorded by a microscope, with its PSF and noise (3-D deconvolution).

    Parameters
    ----------
    stack : array_like, shape (planes, height, width)
        Recorded stack, in the unit of `noise`: integers or floats; NaN marks unknown values.
    psf : PSF
        As of :class:`lommel.microscopy.StackBlur`, with the step, pixels and direction of z of the recording. Its
        planes and window must hold the cone of light: beyond them it is taken to be dark. Values are divided by their
        sum, so that light is conserved.
    noise : Noise
        Noise of the values of `stack`; maps per pixel apply to each plane.
    method : RichardsonLucy, optional
        By default ``lm.imaging.RichardsonLucy(target=1.0)``: a lower target, as for photographs, would amplify noise
        where the PSF is much wider than a voxel.
    margin : (int, int), optional
        Number of planes and pixels restored beyond each face of the recording, to account for light from outside; by
        default half of those of the PSF, and at most half as many planes as the stack has, or 8. Planes farther away
        are taken to be like the outermost one, pixels to be dark.
    progress : callable, optional
        As of :func:`lommel.imaging.restore_with`.

    Returns
    -------
    Restoration
        Its `values` are float32, of the shape and unit of the stack, without the offset of its noise, like its
        `light`; `by_channel` is the discrepancy of each plane. `stopped` states a misfit.

    Raises
    ------
    TypeError, ValueError
        If an argument is of another type or out of range; if `stack` is infinite, or NaN everywhere.

    Notes
    -----
    The steps of :class:`lommel.imaging.RichardsonLucy`. Memory besides the stack: about twice its size in float32,
    and 1.6 times that of the stack with its margin.
    """
    validation.optional("method", method, RichardsonLucy)
    recorded = validation.array("stack", stack)
    if recorded.dtype.kind not in "iuf" or recorded.ndim != 3:
        got = f"{recorded.dtype} of the shape {recorded.shape}"
        raise TypeError(f"stack must hold real numbers, of the shape (planes, height, width), got {got}")
    if 0 in recorded.shape:
        raise ValueError(f"stack must have planes, rows and columns, got the shape {recorded.shape}")
    validation.instance("psf", psf, PSF)
    validation.instance("noise", noise, Noise)
    usual = min(psf.shape[0] // 2, max(_LEAST_PLANES, recorded.shape[0] // 2)), max(psf.grid.shape) // 2
    asked = usual if margin is None else margin
    if not isinstance(asked, tuple | list) or len(asked) != 2:
        raise ValueError(f"margin must be (planes, pixels), got {validation.shown(margin)}")
    for name in ("offset", "read", "white"):
        given = np.shape(getattr(noise, name))
        if given not in ((), recorded.shape[1:]):
            raise ValueError(
                f"noise must have one {name}, or a map of the shape {recorded.shape[1:]}, got the shape {given}"
            )
    planes, pixels = (validation.integer("margin", side, least=0, most=validation.MAX_SIDE) for side in asked)
    counted = _Counted(recorded, noise)
    blur = TiledBlur(psf, (recorded.shape[0], recorded.shape[1], recorded.shape[2]), (planes, pixels))
    before = counted.mean(counted.discrepancies(blur.forward(counted.scene(planes, pixels))))
    walk = _Walk(blur, counted)
    with shown(progress) as tell:
        steps, stopped, each = walk.solve(method or RichardsonLucy(target=1.0), tell)
    values, found = walk.inside(planes, pixels), counted.mean(each)
    if stopped == MISFIT:
        stopped = STACK_MISFIT
    elif steps == 0 and counted.electrons >= 1.0 and found < 1.0 - 4.0 * counted.slack:
        stopped = TOO_QUIET
    unknown = 1.0 - float(counted.known.sum()) / recorded.size
    return Restoration(values, values, found, tuple(map(float, each)), before, steps, stopped, unknown=unknown)


class _Counted(Counts):
    """A stack as counts, in units of light as :class:`lommel.imaging.deconvolution.Observed`, by parts."""

    def __init__(self, recorded: Values, noise: Noise) -> None:
        side = recorded.shape[1:]
        self._recorded = recorded
        self._offset = np.broadcast_to(noise.offset, side)
        gain = np.broadcast_to(1.0 if noise.white is None else noise.white, side)
        self._added = np.asarray(noise.variance(np.zeros(side)) / gain)
        self.known = np.zeros(len(recorded), dtype=np.int64)  # how many voxels of each plane are
        total = weights = counts = 0.0
        for plane, values in enumerate(recorded):
            if np.isinf(values).any():
                raise ValueError("stack must be finite, or NaN where a value is unknown, got infinity")
            known = np.isfinite(values)
            seen = np.maximum(values[known] - self._offset[known] + self._added[known], 0.0)
            self.known[plane] = seen.size
            weights += float(gain[known].sum())
            counts += float((gain[known] * seen).sum())
            total += float((gain[known] * np.maximum(seen - self._added[known], 0.0)).sum())
        if not self.known.any():
            raise ValueError("stack must have voxels that are known, got NaN everywhere")
        self.white = weights / float(self.known.sum())
        self._weight = np.asarray(gain / self.white, dtype=np.float32)
        self.most_weight = float(self._weight.max())
        self.level = total / weights  # mean light
        # Mean count, with the variance of reading: below 1 the deviance of what is right is below 1, too.
        self.electrons = self.white * counts / weights
        self.smallest = 1e-6 * max(counts / weights, TINY)

    def part(self, plane: int, rows: slice, columns: slice) -> tuple[Values, Values]:
        """Return counts and weights; both are 0 where nothing is known."""
        values = self._recorded[plane, rows, columns] - self._offset[rows, columns]
        values += self._added[rows, columns]
        known = np.isfinite(values)
        counts = np.where(known, np.maximum(values, 0.0), 0.0).astype(np.float32)
        return counts, np.where(known, self._weight[rows, columns], np.float32(0.0))

    def scene(self, planes: int, pixels: int) -> Part:
        """Return the stack itself as a specimen, with these margins: as bright as its mean where nothing is known."""

        def part(plane: int, rows: slice, columns: slice) -> Values:
            out = np.full((rows.stop - rows.start, columns.stop - columns.start), self.level, dtype=np.float32)
            if 0 <= plane - planes < len(self._recorded):
                sides = zip((rows, columns), self._recorded.shape[1:], strict=True)
                (y, down), (x, across) = (overlap(at.start - pixels, at.stop - pixels, side) for at, side in sides)
                counts, weight = self.part(plane - planes, y, x)
                light = np.maximum(counts - self._added[y, x], 0.0)
                out[down, across] = np.where(weight > 0.0, light, self.level)
            return out

        return part

    def discrepancies(self, models: Iterable[Piece], misfit: Values | None = None) -> Array:
        """Return the Poisson deviance per voxel of each plane; `misfit` becomes the weighted ratio less 1."""
        sums = np.zeros(len(self.known))
        for plane, rows, columns, light in models:
            counts, weight = self.part(plane, rows, columns)
            model = np.maximum(light + self._added[rows, columns], TINY).astype(np.float32)
            ratio = counts / model
            if misfit is not None:
                misfit[plane, rows, columns] = weight * (ratio - 1.0)
            terms = ratio * np.log(np.maximum(ratio, TINY)) + (1.0 - ratio)
            sums[plane] += float((terms * model * weight).sum(dtype=np.float64))
        return self.per_pixel(sums)


class _Walk:
    """Steps of Richardson and Lucy, with no more memory than the specimen and half of it again."""

    def __init__(self, blur: TiledBlur, counted: _Counted) -> None:
        self._blur, self._counted = blur, counted
        self._light = np.full(blur.whole, counted.level, dtype=np.float32)
        self._change = np.zeros(blur.whole, dtype=np.float16)
        self._misfit = np.zeros(blur.shape, dtype=np.float32)
        self._pace = 0.0

    def solve(self, method: RichardsonLucy, tell: Tell) -> tuple[int, str, Array]:
        """Iterate until there is a reason to stop; return number of steps, reason and discrepancies of the planes."""
        course = Course(method, self._counted.slack, tell)
        earlier = np.zeros([-(-side // _EVERY) for side in self._blur.whole], dtype=np.float32)
        while True:
            self._pace = course.pace
            discrepancies = self._counted.discrepancies(self._blur.forward(self._guess), self._misfit)
            if stopped := course.judge(self._counted.mean(discrepancies)):
                return course.steps, stopped, discrepancies
            size = float(np.vdot(earlier, earlier))
            overlap = self._step(earlier)
            if method.accelerate and course.steps > 0:
                course.go_on(size, overlap)

    def _guess(self, plane: int, rows: slice, columns: slice) -> Values:
        """Return the light, extrapolated."""
        light = self._light[plane, rows, columns]
        if self._pace == 0.0:
            return light
        ahead = self._change[plane, rows, columns].astype(np.float32)
        ahead *= self._pace
        ahead += 1.0
        ahead *= light
        return np.maximum(ahead, self._counted.smallest, out=ahead)

    def _step(self, earlier: Values) -> float:
        """Take a step, replace some of the earlier change by its own, and return the product of the two."""
        overlap = 0.0
        for plane, rows, columns, back in self._blur.adjoint(lambda plane, *part: self._misfit[(plane, *part)]):
            guess = self._guess(plane, rows, columns)
            seen = self._counted.most_weight * self._blur.seen(plane, rows, columns)
            # What no voxel of the recording sees stays as it is.
            found = np.where(seen > 1e-6, back / np.maximum(seen, 1e-6), 0.0).astype(np.float32)
            found += 1.0
            found *= guess
            np.maximum(found, 0.0, out=found)
            if plane % _EVERY == 0:
                first = -rows.start % _EVERY, -columns.start % _EVERY
                moved = (found - guess)[first[0] :: _EVERY, first[1] :: _EVERY]
                at = (rows.start + first[0]) // _EVERY, (columns.start + first[1]) // _EVERY
                kept = earlier[plane // _EVERY, at[0] :, at[1] :][: moved.shape[0], : moved.shape[1]]
                overlap += float(np.vdot(moved, kept))
                kept[...] = moved
            light = self._light[plane, rows, columns]
            change = (found - light) / np.maximum(found, TINY)
            self._change[plane, rows, columns] = np.maximum(change, -_MOST_CHANGE)
            light[...] = found
        return overlap

    def inside(self, planes: int, pixels: int) -> Values:
        """Return the light within these margins; ends the walk."""
        rows, columns = (slice(pixels, side - pixels) for side in self._blur.whole[1:])
        del self._misfit
        return np.stack([self._guess(planes + plane, rows, columns) for plane in range(self._blur.shape[0])])
