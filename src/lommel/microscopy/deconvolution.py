"""Deconvolution of a stack of planes that a microscope recorded."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike

from lommel.base import validation
from lommel.base.arrays import Array, Values
from lommel.estimation.noise import Noise
from lommel.imaging.deconvolution import MISFIT, STEPS, TINY, Counts, Course, RichardsonLucy, Tell
from lommel.imaging.restoration import Restoration, shown
from lommel.microscopy.stack_blur import Part, TiledBlur, overlap
from lommel.microscopy.wide_blur import WideBlur
from lommel.psf import PSF

STACK_MISFIT = (
    "misfit: the PSF (wavelength, depth, direction of z, steps of z, pixels) or the noise is not that of the stack"
)
"""Why a method stopped that a stack does not follow."""

# Why a method stopped at once, at a discrepancy that is too small for the noise that was stated.
TOO_QUIET = "misfit: the stack is quieter than its noise; is the offset left out, or the read noise too large?"

_LEAST_PLANES = 8  # of the margin, where the PSF has so many
_MANY = 3.0  # electrons, from which on the mean deviance is 1 and its first correction
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
        default half of those of the PSF, and at most a quarter as many planes as the stack has, or 8. Planes farther
        away are taken to be like the outermost one, pixels to be dark.
    progress : callable, optional
        As of :func:`lommel.imaging.restore_with`.

    Returns
    -------
    Restoration
        Its `values` are float32, of the shape and unit of the stack, without the offset of its noise, like its
        `light`; `by_channel` is the discrepancy of each plane. `stopped` states a misfit. A point that sends F
        photons into each plane has ``F * psf.values.sum()``, those in the window of the PSF. Where that does not
        hold all light it is less than F times the planes, which :func:`lommel.microscopy.restore` finds.

    Raises
    ------
    TypeError, ValueError
        If an argument is of another type or out of range; if `stack` is infinite, or NaN everywhere.

    Notes
    -----
    The steps of :class:`lommel.imaging.RichardsonLucy`, on as many threads as there are processors. Memory besides
    the stack: about three times that of the stack with its margin in float32, and once its own.
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
    usual = min(psf.shape[0] // 2, max(_LEAST_PLANES, recorded.shape[0] // 4)), max(psf.grid.shape) // 2
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
    counted = Counted(recorded, noise)
    blur = TiledBlur(psf, (recorded.shape[0], recorded.shape[1], recorded.shape[2]), (planes, pixels))
    before = counted.mean(counted.discrepancies(blur, counted.scene(planes, pixels)))
    walk = Walk(blur, counted)
    with shown(progress) as tell:
        steps, stopped, each = walk.solve(method or RichardsonLucy(target=1.0), tell)
    values, found = walk.inside(planes, pixels), counted.mean(each)
    stopped = counted.verdict(stopped, steps, found)
    unknown = 1.0 - float(counted.known.sum()) / recorded.size
    return Restoration(values, values, found, tuple(map(float, each)), before, steps, stopped, unknown=unknown)


class Counted(Counts):
    """A stack as counts, in units of light as :class:`lommel.imaging.deconvolution.Observed`, by parts."""

    def __init__(self, recorded: Values, noise: Noise, saturation: float = np.inf) -> None:
        side = recorded.shape[1:]
        self._recorded, self._saturation = recorded, saturation
        offset = np.asarray(noise.offset, dtype=np.float64)
        gain = np.asarray(1.0 if noise.white is None else noise.white)
        read = np.asarray(noise.read, dtype=np.float64)
        added = (read / gain) ** 2 * gain  # the variance of reading over the gain, in units of light
        self.known = np.zeros(len(recorded), dtype=np.int64)  # how many voxels of each plane are
        total = weights = counts = over = 0.0
        for plane in range(len(recorded)):
            values = np.asarray(recorded[plane])
            if np.isinf(values).any():
                raise ValueError("stack must be finite, or NaN where a value is unknown, got infinity")
            known = np.isfinite(values) & (values < saturation)
            seen = np.where(known, np.maximum(values - offset + added, 0.0), 0.0)
            each = np.where(known, gain, 0.0)
            self.known[plane] = int(known.sum())
            weights += float(each.sum())
            counts += float((each * seen).sum())
            total += float((each * np.maximum(seen - added, 0.0)).sum())
            over += float((known / (6.0 * (each * seen + 1.0))).sum())
        if not self.known.any():
            raise ValueError("stack must have voxels that are known, got NaN or saturated ones everywhere")
        self._all = bool((self.known == np.prod(side)).all())
        self.white = weights / float(self.known.sum())
        # Maps have the sides of a plane, so that parts of them can be taken.
        self._added, self._shift, self._weight = (
            np.asarray(each, dtype=np.float32) for each in (added, added - offset, gain / self.white)
        )
        self.most_weight = float(self._weight.max())
        self.level = total / weights  # mean light
        # Mean count, with the variance of reading: below 1 the deviance of what is right is below 1, too.
        self.electrons = self.white * counts / weights
        self.smallest = 1e-6 * max(counts / weights, TINY)
        # The deviance of the true scene is 1 + 1/(6 m) of m electrons, and 1/m the mean of 1/(1 + those counted).
        self._expected = 1.0 + over / float(self.known.sum()) if self.electrons > _MANY else 1.0

    def verdict(self, stopped: str, steps: int, discrepancy: float) -> str:
        """Return why a method stopped, in the words for stacks."""
        if stopped == MISFIT:
            return STACK_MISFIT
        quiet = steps == 0 and self.electrons >= 1.0 and discrepancy < 1.0 - 4.0 * self.slack
        return TOO_QUIET if quiet else stopped

    def per_pixel(self, sums: Array) -> Array:
        """Return the Poisson deviance per known voxel, over that of the true scene."""
        return super().per_pixel(sums) / self._expected

    def part(self, plane: int, rows: slice, columns: slice) -> tuple[Values, Values]:
        """Return counts and weights; both are 0 where nothing is known."""
        given = np.asarray(self._recorded[plane, rows, columns])
        shift, weight = (_at(each, rows, columns) for each in (self._shift, self._weight))
        if given.dtype.itemsize > 4:  # what is near an offset must not lose its digits
            counts = (given + shift.astype(np.float64)).astype(np.float32)
        else:
            counts = np.add(given, shift, dtype=np.float32)
        at_least(counts, 0.0)
        if self._all:
            return counts, weight
        known = np.isfinite(given) & (given < self._saturation)
        return np.where(known, counts, np.float32(0.0)), np.where(known, weight, np.float32(0.0))

    def residuals(self, plane: int, rows: slice, columns: slice, light: Values) -> tuple[Values, Values, Values]:
        """Return recorded light, its difference from a model over the noise, and 1 of known voxels; else 0."""
        counts, weight = self.part(plane, rows, columns)
        added = _at(self._added, rows, columns)
        model = np.maximum(light + added, TINY)
        known = np.broadcast_to(weight > 0.0, counts.shape)
        off = (counts - model) * np.sqrt(self.white * weight / model)
        return np.where(known, np.maximum(counts - added, 0.0), 0.0), off, known.astype(np.float32)

    def scene(self, planes: int, pixels: int) -> Part:
        """Return the stack itself as a specimen, with these margins: as bright as its mean where nothing is known."""

        def part(plane: int, rows: slice, columns: slice) -> Values:
            out = np.full((rows.stop - rows.start, columns.stop - columns.start), self.level, dtype=np.float32)
            if 0 <= plane - planes < len(self._recorded):
                sides = zip((rows, columns), self._recorded.shape[1:], strict=True)
                (y, down), (x, across) = (overlap(at.start - pixels, at.stop - pixels, side) for at, side in sides)
                counts, weight = self.part(plane - planes, y, x)
                light = np.maximum(counts - _at(self._added, y, x), 0.0)
                out[down, across] = np.where(weight > 0.0, light, self.level)
            return out

        return part

    def discrepancies(self, blur: TiledBlur | WideBlur, specimen: Part, misfit: Values | None = None) -> Array:
        """Return the Poisson deviance per voxel of each plane; `misfit` becomes the weighted ratio less 1."""

        def compared(plane: int, rows: slice, columns: slice, light: Values) -> tuple[int, float]:
            counts, weight = self.part(plane, rows, columns)
            # In place throughout: new memory costs more than what is done in it.
            model = np.add(light, _at(self._added, rows, columns), out=light)
            at_least(model, TINY)
            ratio = np.divide(counts, model, out=counts)
            terms = at_least(ratio.copy(), TINY)
            np.log(terms, out=terms)
            terms *= ratio
            ratio -= 1.0
            # m - y + y ln(y/m), by q = y/m: what cancels, 1 - q, is exact where q is near 1.
            terms -= ratio
            if weight.ndim or self.most_weight != 1.0:
                terms *= weight
                ratio *= weight
            if misfit is not None:
                misfit[plane, rows, columns] = ratio
            return plane, float(np.einsum("yx,yx->y", terms, model).sum(dtype=np.float64))

        sums = np.zeros(len(self.known))
        for plane, found in blur.forward(specimen, compared):
            sums[plane] += found
        return self.per_pixel(sums)


def at_least(values: Values, least: float) -> Values:
    """Raise values to the least, in place; a row of it is much faster than a number."""
    return np.maximum(values, np.full(values.shape[-1:], least, values.dtype), out=values)


def _at(each: Values, rows: slice, columns: slice) -> Values:
    """Return a part of a map, or the number that is the same everywhere."""
    return each[rows, columns] if each.ndim else each


class Walk:
    """Steps of Richardson and Lucy, with no more memory than twice the specimen and once the recording.

    A walk with `paces` takes as many steps as there are, each extrapolated as far as they say: that of another part
    of the same stack.
    """

    def __init__(self, blur: TiledBlur | WideBlur, counted: Counted, paces: Sequence[float] | None = None) -> None:
        self._blur, self._counted = blur, counted
        self._light = np.full(blur.whole, counted.level, dtype=np.float32)
        self._before: Values | None = None
        self._misfit = np.empty(blur.shape, dtype=np.float32)
        blur.weigh(counted.most_weight)
        # Of the specimen beyond its margin, if the blur has any.
        self._outside = None if blur.outside is None else np.full(blur.whole[0], counted.level, dtype=np.float32)
        self._outside_before = self._outside
        self._given = None if paces is None else list(paces)
        self._pace = 0.0
        self.paces: list[float] = []
        self.discrepancies = np.full(len(counted.known), np.inf)

    def solve(self, method: RichardsonLucy, tell: Tell) -> tuple[int, str, Array]:
        """Iterate until there is a reason to stop; return number of steps, reason and discrepancies of the planes."""
        if self._given is not None:
            method = replace(method, steps=max(len(self._given), 1), target=0.0)
        course = Course(method, self._counted.slack, tell)
        earlier = np.zeros([-(-side // _EVERY) for side in self._blur.whole], dtype=np.float32)
        while True:
            self._pace = course.pace
            if self._given:
                self._pace = self._given[min(course.steps + 1, len(self._given) - 1)]
            self._extrapolate()
            self.discrepancies = self._counted.discrepancies(self._blur, self._guess, self._misfit)
            self.paces.append(self._pace)
            stopped = course.judge(self._counted.mean(self.discrepancies))
            if stopped or (self._given is not None and course.steps == len(self._given) - 1):
                return course.steps, stopped or STEPS, self.discrepancies
            size = float(np.vdot(earlier, earlier))
            overlap = self._step(earlier)
            if method.accelerate and course.steps > 0:
                course.go_on(size, overlap)

    def _guess(self, plane: int, rows: slice, columns: slice) -> Values:
        """Return the light, extrapolated."""
        ahead = self._light if self._before is None else self._before
        return ahead[plane, rows, columns]

    def _extrapolate(self) -> None:
        """Replace the light of the step before by what is expected of the next one."""
        pace, least = self._pace, self._counted.smallest
        if self._outside is not None and self._outside_before is not None:
            self._blur.outside = np.maximum(self._outside + pace * (self._outside - self._outside_before), least)
        if self._before is None:
            return
        for light, before in zip(self._light, self._before, strict=True):
            if pace == 0.0:
                before[...] = light
                continue
            np.subtract(light, before, out=before)
            before *= pace
            before += light
            at_least(before, least)

    def _step(self, earlier: Values) -> float:
        """Take a step, replace some of the earlier change by its own, and return the product of the two."""
        following = np.empty_like(self._light) if self._before is None else self._before

        def stepped(plane: int, rows: slice, columns: slice, back: Values) -> float:
            guess = self._guess(plane, rows, columns)
            # What no voxel of the recording sees stays as it is.
            found = np.multiply(back, self._blur.per_seen(plane, rows, columns), out=back)
            found += 1.0
            found *= guess
            at_least(found, 0.0)
            overlap = 0.0
            if plane % _EVERY == 0:
                first = -rows.start % _EVERY, -columns.start % _EVERY
                here = np.s_[first[0] :: _EVERY, first[1] :: _EVERY]
                moved = found[here] - guess[here]
                at = (rows.start + first[0]) // _EVERY, (columns.start + first[1]) // _EVERY
                kept = earlier[plane // _EVERY, at[0] :, at[1] :][: moved.shape[0], : moved.shape[1]]
                overlap = float(np.vdot(moved, kept))
                kept[...] = moved
            following[plane, rows, columns] = found
            return overlap

        misfit = self._misfit
        overlap = sum(self._blur.adjoint(lambda plane, *part: misfit[(plane, *part)], stepped))
        self._before, self._light = self._light, following
        if isinstance(self._blur, WideBlur):
            guess = self._blur.outside
            found = guess * np.maximum(1.0 + self._blur.outside_back * self._blur.per_outside, 0.0)
            self._outside_before, self._outside = self._outside, found
        return overlap

    def inside(self, planes: int, pixels: int) -> Values:
        """Return the light within these margins; ends the walk."""
        self._misfit = np.empty((0, 0, 0), np.float32)
        self._blur.release()
        rows, columns = (slice(pixels, side - pixels) for side in self._blur.whole[1:])
        out = np.empty(self._blur.shape, np.float32)
        for plane, values in enumerate(out):
            values[...] = self._guess(planes + plane, rows, columns)
        return out
