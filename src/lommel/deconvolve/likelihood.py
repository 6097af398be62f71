"""Recorded planes as Poisson counts, and the discrepancy between counts and the blurred image of a scene."""

from __future__ import annotations

import copy
import math
from functools import cached_property
from types import EllipsisType
from typing import Self

import numpy as np
from numpy.typing import NDArray

from lommel.base.arrays import Array, Values
from lommel.deconvolve.algorithms import MISFIT
from lommel.deconvolve.linear import ImagePlanes, LinearBlur, PlaneOperator
from lommel.fit.findings import Finding
from lommel.recorded.counts import plane_of
from lommel.recorded.noise import Noise

SINGLE: np.dtype[np.floating] = np.dtype(np.float32)
TINY = 1e-30  # smallest denominator: the ratio of a count of 0 to a model of 0 is then 0
_MIN_ELECTRONS = 3.0  # mean electrons above which the expected deviance of the true scene is set to 1 + 1 / (6 m)
MAX_RATIO = 1e3  # largest ratio of counts to model
_BLOCK, _DARKEST = 8, 10.0  # side of blocks in pixels, and percentile of their means from which a background starts


class PoissonLikelihood:
    r"""Recorded planes as counts of a Poisson distribution, in units of light.

    For a gain of g electrons per unit of light, ``g y + read^2`` of the recorded light y is distributed approximately
    as ``Poisson(g (A x) + read^2)`` (Snyder et al. 1993, doi:10.1364/JOSAA.10.001014). Counts, in units of light, are
    ``y + read^2 / g``; the term ``read^2 / g`` is called `added`.

    Parameters
    ----------
    recorded : ndarray, shape (planes, height, width)
        Recorded light; NaN where unknown.
    noise : Noise
    saturation : float
        Smallest value of ignored pixels.
    dtype : float32 or float64
        Type of the computation.
    full : ndarray of bool, optional
        Saturated pixels, whose values are lower limits of the light.
    """

    weakest = 1.0 / 512.0  # smallest strength of the total variation in a search, relative to the usual strength
    judges_specimen = True  # whether `of_specimen` is computed, which a prescribed number of steps does not need
    settles = True  # whether steps with a prescribed strength end at convergence, even before their largest number

    def __init__(
        self,
        recorded: Values,
        noise: Noise,
        saturation: float = np.inf,
        *,
        dtype: np.dtype[np.floating] = SINGLE,
        full: NDArray[np.bool_] | None = None,
    ) -> None:
        noise = noise.require_shape(recorded.shape).poisson
        self._recorded, self._saturation, self._full = recorded, saturation, full
        self.dtype = dtype
        offset = np.asarray(noise.offset, dtype=np.float64)
        gain = np.asarray(1.0 if noise.white is None else noise.white)
        read = np.asarray(noise.read, dtype=np.float64)
        # read^2 electrons in units of light: if these are added to its mean, a Poisson variable has the variance of
        # shot and read noise together.
        added = (read / gain) ** 2 * gain
        planes = len(recorded)
        self.known = np.zeros(planes, dtype=np.int64)  # pixels of each plane that are neither unknown nor saturated
        self._light, self._weights = [0.0] * planes, [0.0] * planes  # sums over each plane
        counts = excess = known_count = 0.0
        for plane in range(planes):
            values = plane_of(recorded, plane)
            known = np.isfinite(values) & (values < saturation)
            gains = np.where(known, gain, 0.0)
            light = np.where(known, np.maximum(values - offset + added, 0.0), 0.0)
            self._weights[plane] = float(gains.sum())
            self._light[plane] = float((gains * np.maximum(light - added, 0.0)).sum())
            counts += float((gains * light).sum())
            known_count += float(known.sum())
            known = known if full is None else known & ~full[plane]
            excess += float((known / (6.0 * (gains * light + 1.0))).sum())
            self.known[plane] = int(known.sum())
        if not self.known.any():
            raise ValueError("stack must have voxels that are known and below the saturation, got none")
        weights = sum(self._weights)
        self._all_known = known_count == float(np.prod(recorded.shape))
        self.background: float | Values = 0.0  # light of each voxel, or of each pixel, that is not of the specimen
        self.of_specimen = 1.0, np.inf  # discrepancy of the voxels lit by the specimen, and its slack
        self.white = weights / known_count  # mean gain, electrons per unit of light
        # Scalars, or maps over the pixels of a plane.
        self._added, self._shift, self._weight = (
            np.asarray(values, dtype=self.dtype) for values in (added, added - offset, gain / self.white)
        )
        self.most_weight = float(self._weight.max())
        self.level = sum(self._light) / weights  # mean light
        # Mean count in electrons, including the read variance. Below 1, the deviance of the true scene is
        # also below 1.
        self.electrons = self.white * counts / weights
        self.smallest = 1e-6 * max(counts / weights, TINY)
        # The expected deviance of the true scene is 1 + 1/(6 m) for m electrons; 1/m is estimated by the mean of
        # 1 / (1 + counted electrons).
        self.expected = 1.0 + excess / float(self.known.sum()) if self.electrons > _MIN_ELECTRONS else 1.0

    @property
    def start(self) -> Array:
        """Light of each plane of a uniform scene, in a shape that broadcasts to the shape of the scene."""
        return np.asarray(self.level)

    @property
    def estimate(self) -> Values | None:
        """Initial light for total variation; None for a uniform scene, as for stacks, which have a background."""
        return None

    @property
    def slack(self) -> float:
        """Three standard deviations of the discrepancy of the true scene, which may exceed 1 by this amount."""
        # A term of the deviance is about chi-squared with one degree of freedom: its variance is 2, and the variance
        # of a mean of n terms is 2 / n.
        return 3.0 * math.sqrt(2.0 / float(self.known.sum()))

    def mean(self, discrepancies: Array) -> float:
        """Return the discrepancy of all planes together."""
        return float((discrepancies * self.known).sum() / self.known.sum())

    def reversed(self) -> Self:
        """Return the counts with the planes in reverse order."""
        reverse = copy.copy(self)
        reverse.known, reverse._recorded = self.known[::-1], self._recorded[::-1]
        return reverse

    def finding(self, stopped: str, before: float, discrepancy: float) -> Finding | None:
        """Return the finding for a stack, given the reason to stop of a method; None if there is no problem.

        `before` is the discrepancy of a flat scene, which, unlike later steps, does not fit the noise.
        """
        numbers = {"discrepancy": discrepancy, "most": 1.0 + self.slack}
        if stopped == MISFIT:
            parts = "aberrations, wavelength, depth, direction of z, steps of z, pixels"
            return Finding(
                "misfit", "error", f"the PSF ({parts}) or the noise does not agree with the stack", numbers
            )
        # Below one electron the deviance of the true scene is itself below 1, and does not test the noise.
        if self.electrons >= 1.0 and before < 1.0 - 4.0 * self.slack:
            text = "the stack is quieter than its noise; the offset may be missing, or the read noise too large"
            return Finding("too_quiet", "error", text, numbers)
        return None

    def per_pixel(self, sums: Array) -> Array:
        """Return the discrepancy of each plane: deviance per known pixel, divided by its value for the true scene.

        `sums` are the sums of ``w (m - y + y ln(y / m))`` over each plane. Bertero et al. 2010,
        doi:10.1088/0266-5611/26/10/105004.
        """
        # The deviance is twice the logarithm of a ratio of likelihoods.
        return np.asarray(2.0 * self.white * sums / np.maximum(self.known, 1)) / self.expected

    def part(self, plane: int, rows: slice, columns: slice) -> tuple[Values, Values]:
        """Return the counts and weights of a part of a plane; both are 0 in unknown pixels."""
        recorded = np.asarray(self._recorded[plane, rows, columns])
        shift, weight = (_map_part(values, rows, columns) for values in (self._shift, self._weight))
        if recorded.dtype.itemsize > 4:  # in double precision, as values near a large offset would lose their digits
            counts = (recorded + shift.astype(np.float64)).astype(self.dtype)
        else:
            counts = np.add(recorded, shift, dtype=self.dtype)
        at_least(counts, 0.0)
        if self._all_known:
            return counts, weight
        known = np.isfinite(recorded) & (recorded < self._saturation)
        zero = self.dtype.type(0.0)
        return np.where(known, counts, zero), np.where(known, weight, zero)

    def added_at(self, rows: slice, columns: slice) -> Values:
        """Return `added`, the read variance in units of light, of a part of a plane."""
        return _map_part(self._added, rows, columns)

    def whitened(self, plane: int, rows: slice, columns: slice, light: Values) -> tuple[Values, Values, Values]:
        """Return recorded light, its difference from the model divided by the noise, and 1 / noise (0 if unknown).

        `light` is the image of the specimen in this part of a plane.
        """
        counts, weight = self.part(plane, rows, columns)
        added = _map_part(self._added, rows, columns)
        model = np.maximum(light + added + _map_part(np.asarray(self.background, np.float32), rows, columns), TINY)
        # Divided by the standard deviation of a Poisson count, the square root of its mean in electrons.
        scale = np.sqrt(self.white * weight / model)
        return np.where(scale > 0.0, np.maximum(counts - added, 0.0), 0.0), (counts - model) * scale, scale

    def scene(self, planes: int, pixels: int) -> Values:
        """Return the recorded light as a specimen with a margin of `planes` planes and `pixels` pixels.

        Margins and unknown voxels have the mean light.
        """
        count, *sides = self._recorded.shape
        rows, columns = (slice(0, side) for side in sides)
        scene = np.full((count + 2 * planes, *(side + 2 * pixels for side in sides)), self.level, self.dtype)
        for plane in range(count):
            counts, weight = self.part(plane, rows, columns)
            light = np.maximum(counts - self._added, 0.0)
            scene[planes + plane, pixels : pixels + sides[0], pixels : pixels + sides[1]] = np.where(
                weight > 0.0, light, self.level
            )
        return scene

    def set_background(self, levels: Array) -> None:
        """Set the background from its levels (points, points) on a grid over the field, interpolated linearly."""
        rows, columns = (_interpolation_weights(side, len(levels)) for side in self._recorded.shape[1:])
        self.background = float(levels[0, 0]) if levels.size == 1 else (rows @ levels @ columns.T).astype(np.float32)

    def means(self, misfit: Values, count: int) -> Array:
        """Return the weighted mean of a misfit around each point of a grid of `count` by `count` points.

        `misfit` (planes, height, width) is the weighted ratio of counts to model less 1.
        """
        rows, columns = (_interpolation_weights(side, count) for side in self._recorded.shape[1:])
        sums = rows.T @ misfit.sum(axis=0, dtype=np.float64) @ columns
        return np.asarray(sums / np.maximum(rows.T @ self._pixel_weights @ columns, TINY))

    @cached_property
    def _pixel_weights(self) -> Array:
        """Sum over the planes of the weights of each pixel."""
        sides = self._recorded.shape[1:]
        weights = np.zeros(sides)
        for plane in range(len(self.known)):
            weights += self.part(plane, slice(0, sides[0]), slice(0, sides[1]))[1]
        return weights

    def darkest(self) -> float:
        """Return the light of the darkest blocks, which contain background and little else."""
        means = [self.level]
        n_rows, n_columns = (max(side // _BLOCK, 1) for side in self._recorded.shape[1:])
        for plane in range(len(self.known)):
            counts, weight = self.part(plane, slice(None), slice(None))
            known = np.broadcast_to(weight > 0.0, counts.shape)
            light = np.where(known, counts - self._added, 0.0)
            for rows in zip(np.array_split(light, n_rows), np.array_split(known, n_rows), strict=True):
                blocks = (np.array_split(values, n_columns, axis=1) for values in rows)
                # Blocks with unknown pixels are ignored.
                means += [
                    float(block.sum() / count.sum()) for block, count in zip(*blocks, strict=True) if count.all()
                ]
        # A percentile, because the smallest of many means is below the background by noise.
        return max(float(np.percentile(means, _DARKEST)), 0.0)

    def flat(self) -> float:
        """Return the discrepancy of a uniform scene."""
        sides = self._recorded.shape[1:]
        sums = np.zeros(len(self.known))
        for plane in range(len(sums)):
            light = np.full(sides, self.level - self.background, np.float32)
            sums[plane] = self._deviance_sums(plane, slice(0, sides[0]), slice(0, sides[1]), light, None)[0]
        return self.mean(self.per_pixel(sums))

    def discrepancies(self, blur: PlaneOperator, specimen: Values, misfit: Values | None = None) -> Array:
        """Return the discrepancy of each plane of the blurred specimen, and set `of_specimen`.

        If given, `misfit` (planes, height, width) is overwritten by the weighted ratio of counts to model less 1.
        """

        def compare(plane: int, rows: slice, columns: slice, light: Values) -> tuple[int, Array]:
            return plane, self._deviance_sums(plane, rows, columns, light, misfit)

        sums, of_specimen = np.zeros(len(self.known)), np.zeros(3)
        for plane, part_sums in blur.forward(specimen, compare):
            sums[plane] += part_sums[0]
            of_specimen += part_sums[1:]
        return self.judged(sums, of_specimen)

    def judged(self, sums: Array, of_specimen: Array) -> Array:
        """Return the discrepancy of each plane, and set `of_specimen`, by the sums of `_deviance_sums`."""
        if self.judges_specimen and np.any(self.background):
            deviance, weights, squares = of_specimen
            # A term of the deviance has the variance 2. The mean of terms with weights w has the variance
            # 2 sum(w^2) / sum(w)^2, and the slack is three standard deviations.
            total = max(weights, TINY)
            self.of_specimen = 2.0 * self.white * deviance / total, 3.0 * np.sqrt(2.0 * squares) / total
        return self.per_pixel(sums)

    def _deviance_sums(self, plane: int, rows: slice, columns: slice, light: Values, misfit: Values | None) -> Array:
        """Return four sums over a part of a plane; its image `light` is overwritten by the model of the counts.

        The first is the sum of ``w (m - y + y ln(y / m))``. The others are for `of_specimen`, where the weight of a
        voxel is the square of the specimen's fraction of the model: sums of the weighted terms, of the weights and of
        their squares.
        """
        counts, weight = self.part(plane, rows, columns)
        background = _map_part(np.asarray(self.background, self.dtype), rows, columns)
        offset = _map_part(self._added, rows, columns) + background
        # All in place, because allocating memory would take longer than the operations.
        at_least(light, TINY)  # narrowed kernels have negative values, which may prevail beside very bright voxels
        squares = light.copy() if self.judges_specimen and np.any(background) else None
        model = np.add(light, offset, out=light)
        ratio = np.divide(counts, model, out=counts)
        np.minimum(ratio, np.full(ratio.shape[-1:], MAX_RATIO, ratio.dtype), out=ratio)
        if self._full is not None:  # the model may exceed the counts of a saturated pixel
            np.maximum(ratio, 1.0, out=ratio, where=self._full[plane, rows, columns])
        terms = at_least(ratio.copy(), TINY)
        np.log(terms, out=terms)
        terms *= ratio
        ratio -= 1.0
        # m - y + y ln(y/m) = m (q ln q - (q - 1)) with q = y/m: the difference q - 1 is exact where q is near 1.
        terms -= ratio
        if weight.ndim or self.most_weight != 1.0:
            terms *= weight
            ratio *= weight
        if misfit is not None:
            misfit[plane, rows, columns] = ratio
        # Rows are summed in the type of the values, and their sums in float64.
        row_sums = [np.einsum("yx,yx->y", terms, model)]
        if squares is not None:
            squares /= model
            squares *= squares
            terms *= model
            if weight.ndim:
                squares *= weight > 0.0
            row_sums += [np.einsum("yx,yx->y", values, squares) for values in (terms, np.ones_like(squares), squares)]
        sums = [float(row.sum(dtype=np.float64)) for row in row_sums]
        return np.array(sums + [0.0] * (4 - len(sums)))


def _interpolation_weights(side: int, count: int) -> Array:
    """Return the weights of linear interpolation from `count` evenly spaced points to pixels, shape (side, count)."""
    # Hat functions around the points; a single point has the weight 1 everywhere.
    position = np.linspace(0.0, count - 1.0, side)
    return np.asarray(np.maximum(1.0 - np.abs(position[:, np.newaxis] - np.arange(count)), 0.0 if count > 1 else 1.0))


def at_least(values: Values, least: float) -> Values:
    """Raise values to at least `least`, in place."""
    # numpy's maximum of an array and a row is much faster than of an array and a number.
    return np.maximum(values, np.full(values.shape[-1:], least, values.dtype), out=values)


def _map_part(values: Values, rows: slice, columns: slice) -> Values:
    """Return a part of a map, or the scalar that applies to all pixels."""
    return values[rows, columns] if values.ndim else values


class PhotographLikelihood(PoissonLikelihood):
    """Counts of a photograph in memory, with the blur of its scene; channels are planes.

    Parameters
    ----------
    blur : LinearBlur
    light : ndarray of float, shape (height, width) or (height, width, channels)
        Recorded light, NaN where unknown.
    noise : Noise
    saturation : float
        Smallest light of saturated pixels, whose values are lower limits.
    full : ndarray of bool, optional
        Saturated pixels, if these cannot be derived from `light`.

    Raises
    ------
    ValueError
        If no pixel is known.
    """

    weakest = 1.0 / 8.0  # with correct depths the strength is 0.5 to 2 times the usual strength
    settles = False

    def __init__(
        self,
        blur: LinearBlur,
        light: Values,
        noise: Noise,
        saturation: float = np.inf,
        full: NDArray[np.bool_] | None = None,
    ) -> None:
        self.blur, self.noise, self.light = blur, noise, np.minimum(light, saturation)
        self._saturated = light >= saturation if full is None else full
        if not (np.isfinite(light) & ~self._saturated).any():
            raise ValueError("no pixel of the photograph is known: all are NaN or saturated")
        self.full = self._saturated if self._saturated.any() else None
        planes = [np.moveaxis(values.reshape(*blur.shape, -1), 2, 0) for values in (self.light, self._saturated)]
        super().__init__(planes[0], noise, dtype=blur.dtype, full=None if self.full is None else planes[1])
        self._blurred: list[tuple[Values, Values]] = []
        self.added = self._added[..., None] if self._added.ndim and light.ndim == 3 else self._added

    def replaced(self, light: Values) -> PhotographLikelihood:
        """Return the counts of other light with the same saturated pixels."""
        return PhotographLikelihood(self.blur, light, self.noise, full=self._saturated)

    @cached_property
    def operator(self) -> ImagePlanes:
        """Blur of the planes, with the weights of the pixels."""
        return ImagePlanes(self.blur, self.weight)

    @property
    def estimate(self) -> Values:
        """The photograph as planes of light."""
        return np.array(self.operator.planes(self.image), self.dtype, order="C")

    @property
    def start(self) -> Array:
        """Mean light of each channel, (channels, 1, 1); an unknown channel has the mean light of all channels.

        A start of 0 would stay 0, since steps multiply the light.
        """
        pairs = zip(self._light, self._weights, strict=True)
        levels = [light / weight if weight else self.level for light, weight in pairs]
        return np.array(levels)[:, np.newaxis, np.newaxis]

    def flat(self) -> float:
        """Return the discrepancy of a uniform scene."""
        return self.mean(self.discrepancies_of(self._flat))

    @cached_property
    def counts(self) -> Values:
        """Counts of all pixels, 0 where unknown."""
        return self._image(0)

    @cached_property
    def weight(self) -> Values:
        """Gain of each pixel relative to the mean gain, 0 where unknown."""
        return self._image(1)

    @property
    def certain(self) -> NDArray[np.bool_]:
        """True for pixels that are known and not saturated."""
        known = self.weight > 0.0
        return known if self.full is None else known & ~self.full

    @cached_property
    def tested(self) -> NDArray[np.bool_] | EllipsisType:
        """Index of the certain pixels."""
        certain = self.certain
        return ... if certain.all() else certain

    @cached_property
    def image(self) -> Values:
        """The photograph as light; unknown pixels have the mean light."""
        return np.where(self.weight > 0.0, np.maximum(self.counts - self.added, 0.0), self._flat)

    def blurred(self, light: Values) -> Values:
        """Return the image of a scene `light`; it is kept for the last two, which must not change."""
        image = next((image for scene, image in self._blurred if scene is light), None)
        if image is None:
            image = np.array(self.blur.forward(light))
        self._blurred = [(light, image), *(pair for pair in self._blurred if pair[0] is not light)][:2]
        return image

    def model(self, light: Values) -> Values:
        """Return the expected counts of a scene `light`."""
        model = self.blurred(light) + self.added
        np.maximum(model, TINY, out=model)
        return model

    def discrepancies_of(self, light: Values) -> Array:
        """Return the discrepancy of each channel for a scene `light`."""
        image = self.blurred(light).reshape(*self.blur.shape, -1)
        everywhere = slice(None)
        sums = [
            self._deviance_sums(c, everywhere, everywhere, image[..., c].copy(), None)[0]
            for c in range(self.blur.channels)
        ]
        return self.per_pixel(np.array(sums))

    @cached_property
    def before(self) -> float:
        """Discrepancy of the photograph as a scene."""
        return self.mean(self.discrepancies_of(self.image))

    @property
    def _flat(self) -> Values:
        planes = np.broadcast_to(self.start, (self.blur.channels, *self.blur.shape))
        return np.moveaxis(planes, 0, 2).reshape(self.light.shape).astype(self.dtype)

    def _image(self, index: int) -> Values:
        """Return counts or weights of all parts as an image."""
        shape = self.light.shape
        values = np.empty((*self.blur.shape, self.blur.channels), self.dtype)
        for plane in range(self.blur.channels):
            values[..., plane] = self.part(plane, slice(None), slice(None))[index]
        return values.reshape(shape)
