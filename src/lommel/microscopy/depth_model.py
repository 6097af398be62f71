"""PSFs of a microscope at the depths of a stack, and the blur of the stack by these PSFs."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
import scipy

from lommel.base import validation
from lommel.base.arrays import Array, Values
from lommel.fit.findings import Finding
from lommel.measures.measured_psf import MeasuredPSF
from lommel.measures.spot import stage
from lommel.microscopy.modalities import confocal, light_sheet, two_photon
from lommel.microscopy.stack_blur import (
    PlaneBlur,
    RadialTransfer,
    TiledBlur,
    WideBlur,
    kernel_of,
    pitch_of,
    taper,
)
from lommel.optics.layers.emitter import Beam, Emitter, emitter_of
from lommel.optics.layers.modality import WIDEFIELD, Modality
from lommel.optics.layers.objective import Objective, from_focal_plane
from lommel.optics.layers.objective_pupil import ObjectivePupil
from lommel.optics.layers.stratified import DEPTH_MOST
from lommel.optics.wavefront.wavefront import Wavefront
from lommel.psf import PSF, psf

_ISOTROPIC = emitter_of("isotropic")
_TOL = 1e-4  # tolerance of PSFs, relative to their peaks
# Differences between PSFs as fractions of their light: _MAX_EQUAL, between both ends of a stack, below which
# one PSF is enough; _MAX_DEVIATION, of a PSF from the mean of its neighbours, for linear interpolation.
_MAX_EQUAL, _MAX_DEVIATION = 0.003, 0.03
_MAX_PSFS = 9
_FAR_DEPTHS = 9  # number of depths at which the tails of PSFs are computed
_MAX_MISFIT = 0.01  # largest rms deviation of a transfer function from rotational symmetry, relative to its rms
_MIN_HALF, _MAX_HALF_PLANES, _MAX_HALF_PIXELS = 8, 64, 48  # half widths of PSF windows, planes and pixels
_SAMPLES_PER_NODE, _MAX_HALF_NODES = 3, 48  # coarse grid, along an axis: samples per node, largest half width
_SHEET_END = 4.0  # distance from a light sheet, in thicknesses, beyond which its intensity is treated as constant
_FOCUS_TABLE = 11  # usual number of depths at which the best focus is computed
_SPLINE_DEGREES = (3, 2)  # degrees of B-splines, in the order tried
_BATCH = 2**21  # values of PSFs that are computed together
MAX_RIM = 0.02
"""Fraction of the light of a PSF on the rim of its window from which the light cone counts as cut off."""
_EQUAL_LIGHT = 0.9  # least ratio of the light of any two planes of a wide-field PSF
_MAX_NEGATIVE = 0.015  # largest sum of the negative values of a narrowed PSF, as a fraction of its light


class PSFs(NamedTuple):
    """Depths (m) at which PSFs are computed for a stack.

    A PSF is the sum of a window with all pixels and a tail on a coarse grid. `planes` are the depths in focus in each
    plane (with margin), `depths` the depths of the windows, and `nodes` the depths of the tails. With `radial` each
    plane has its own window. Tails, and windows without `radial`, are interpolated linearly between two depths.
    """

    planes: Array
    depths: Array
    nodes: Array
    radial: RadialTransfer | None


@dataclass(frozen=True, eq=False)
class DepthModel:
    """A microscope and the sampling of a stack, which determine its PSF at each depth.

    `pixel` is the pixel pitch on the camera and `step` the step of the stage, metres; `depth` is the depth in focus
    in plane ``planes // 2`` of the recording, whose planes run towards the cover glass if `is_reversed`.
    """

    objective: Objective
    wavelength: float
    pixel: float
    step: float
    depth: float
    planes: int
    window: tuple[int, int]  # planes and pixels of the PSF, odd
    modality: Modality = WIDEFIELD
    emitter: Emitter = _ISOTROPIC
    aberrations: Wavefront | None = None
    degrees: tuple[int, int] | None = None  # degrees of the B-splines along z and across; None: the highest possible
    foci: int = _FOCUS_TABLE  # number of depths at which the best focus is computed
    is_reversed: bool = False

    def changed(self, name: str, value: float) -> DepthModel:
        """Return the model with one parameter changed; ValueError if the result is out of range.

        "depth" (m) and "sample" (index) are set to `value`; "wavelength", "step" and "NA" are multiplied by it.
        """
        if name in ("wavelength", "step"):
            return replace(self, **{name: value * getattr(self, name)})
        if name == "depth":
            return replace(self, depth=validation.real("depth", value, least=0.0, most=DEPTH_MOST, unit="metres"))
        changed: dict[str, Any] = {name: value if name == "sample" else value * self.objective.NA}
        return replace(self, objective=replace(self.objective, **changed))

    def psf(self, depth: float | Array) -> PSF:
        """Return the PSF of an emitter at a depth (m): a stack over z, with z = 0 at its brightest focus.

        Of depths in an array (n, 1), the PSFs have the shape (n, planes, side, side).
        """
        side, modality = self.window[1], self.modality
        if modality.kind == "two-photon":
            return two_photon(self._laser(depth, self._z, "brightest"), side, self.pixel, tol=_TOL)
        emission = self._emission(depth)
        if modality.kind == "light sheet":
            assert modality.thickness is not None
            offset = modality.thickness * self._from_sheet(emission)
            return light_sheet(emission, modality.thickness, side, self.pixel, offset=offset, tol=_TOL)
        if modality.kind in ("confocal", "spinning disc"):
            # Excitation and detection share the objective: the same stage position relative to the cover glass.
            beam = self._laser(depth, emission.focus, "coverslip")
            return confocal(beam, emission, side, self.pixel, pinhole=modality.pinhole, tol=_TOL)
        return psf(emission, side, self.pixel, tol=_TOL)

    def point_image(self, depth: float = 0.0) -> Values:
        """Return the image of a point at a depth, by default at the cover glass, where it is sharpest."""
        return self.psf(depth).values

    @property
    def aspect(self) -> float:
        """Pixel size in the sample divided by the step: the factor of differences along z in the total variation."""
        return self.pixel / self.objective.magnification / self.step

    @property
    def keeps_light(self) -> bool:
        """Whether all planes of the PSF have equal light."""
        return self.modality.kind == "widefield"

    @property
    def spreads(self) -> bool:
        """Whether light out of focus is recorded, so that PSFs have tails beyond their window."""
        return self.modality.spreads

    def window_parts(self, depths: Array) -> Iterator[Array]:
        """Yield the fraction of an emitter's light in each voxel of the PSF window, for each depth.

        For modalities that record light out of focus, the window is tapered towards its edge, and values are
        fractions of the light that the objective collects in all planes of the window. Otherwise the sum is 1.
        """
        planes, side = self.window
        for some in _batches(depths, planes * side**2):
            for values in self.psf(some).values.astype(np.float64):
                if not self.spreads:
                    yield np.asarray(values / values.sum())
                else:
                    # The taper leaves a remainder without edges, which the coarse grid can represent.
                    yield np.asarray(values * taper(side, pitch_of(side)) / self._collected_light.sum())

    def window_part(self, depth: float) -> Array:
        """Return :meth:`window_parts` at a single depth."""
        return next(self.window_parts(np.array([depth])))

    def kernels(self, depths: Array) -> Iterator[Array]:
        """Yield :meth:`window_parts` for B-splines instead of points at the specimen's voxels: narrower kernels.

        B-splines with positive light have the same image as a point between the voxels. Points at the voxels could
        only form a wider image (Magain et al. 1998, doi:10.1086/305187).
        """
        return (narrowed(part, *self.splines) for part in self.window_parts(depths))

    @cached_property
    def splines(self) -> tuple[int, int]:
        """Degrees of the B-splines along z and across; 0 (points) where planes or pixels are too coarse."""
        if self.degrees is not None:
            return self.degrees
        return spline_degrees(self.window_part(self.depth))

    def tail_parts(self, depths: Array, half_width: int) -> Iterator[Array]:
        """Yield the tail of the PSF (all light but :meth:`window_parts`) at the nodes of the coarse grid, by depth.

        The shape is (planes, side, side) with ``side = 2 half_width + 1`` nodes, `pitch_of` pixels apart. Values are
        fractions of the light per pixel. Light beyond the outermost nodes is added to the nodes near the edge.
        """
        pitch, side = pitch_of(self.window[1]), 2 * half_width + 1
        plane_light = self._collected_light / self._collected_light.sum()
        samples = _SAMPLES_PER_NODE * side
        spacing = pitch / _SAMPLES_PER_NODE  # pixels
        sample_pixel = self.pixel * pitch / _SAMPLES_PER_NODE
        positions = np.asarray((np.arange(samples) - samples // 2) * spacing, np.float64)
        outside = 1.0 - taper(self.window[1], pitch, positions)
        is_rim = np.maximum(*np.abs(np.indices((side, side)) - half_width)) >= 0.8 * half_width
        sampled = (
            values
            for some in _batches(depths, self.window[0] * samples**2)
            for values in psf(self._emission(some), samples, sample_pixel, integrate=False, tol=_TOL).values
        )
        for tail, window in zip(sampled, self.window_parts(depths), strict=True):
            means = np.empty((len(tail), side, side))
            for plane, values in enumerate(tail):  # one by one: all of them are large
                light = values * outside * (_SAMPLES_PER_NODE / pitch) ** 2
                means[plane] = light.reshape(side, _SAMPLES_PER_NODE, side, _SAMPLES_PER_NODE).mean(axis=(1, 3))
            means *= plane_light[:, np.newaxis, np.newaxis]
            # In each plane, window and tail must contain the collected light: the difference is added to the rim.
            expected = np.maximum(plane_light - window.sum(axis=(1, 2)), 0.0) / pitch**2
            sums = np.maximum(means.sum(axis=(1, 2)), 1e-30)
            means *= np.minimum(expected / sums, 1.0)[:, np.newaxis, np.newaxis]
            missing = np.maximum(expected - sums, 0.0)[:, np.newaxis, np.newaxis]
            yield np.asarray(means + missing * is_rim / is_rim.sum())

    def tail_half_width(self, shape: tuple[int, int], margin: int) -> int:
        """Return the half width of tails in nodes: the cone of light, or the field of view."""
        pitch = pitch_of(self.window[1])
        field = (max(shape) + margin) / pitch
        cone = _cone(self.objective, self.wavelength, self.pixel, float(np.abs(self._z).max())) / pitch
        return max(math.ceil(margin / pitch), min(math.ceil(1.2 * cone), math.ceil(field), _MAX_HALF_NODES), 2)

    @property
    def _z(self) -> Array:
        """Stage positions of the planes of the window, metres from the middle plane."""
        return np.asarray((np.arange(self.window[0]) - self.window[0] // 2) * self.step)

    @property
    def _collected_light(self) -> Array:
        """Collected light in each plane of the window, relative to the plane in focus."""
        if self.modality.kind != "light sheet":
            return np.ones(self.window[0])
        assert self.modality.thickness is not None
        # Gaussian profile of a light sheet, whose thickness is the full width at half maximum.
        distance = self._from_sheet(self._emission(self.depth))
        return np.asarray(np.exp(-4.0 * math.log(2.0) * distance**2))

    def _from_sheet(self, emission: ObjectivePupil) -> Array:
        """Return the distance of the emitter from a light sheet in the plane in focus, in thicknesses."""
        assert self.modality.thickness is not None
        return np.clip(from_focal_plane(emission) / self.modality.thickness, -_SHEET_END, _SHEET_END)

    def _laser(self, depth: float | Array, z: Array, origin: str) -> ObjectivePupil:
        assert self.modality.excitation is not None
        return self.objective.pupil(
            z=z,
            wavelength=self.modality.excitation,
            emitter=Beam("circular"),
            depth=depth,
            origin=origin,
            aberrations=self.aberrations,
        )

    def _emission(self, depth: float | Array) -> ObjectivePupil:
        return self.objective.pupil(
            z=self._z,
            wavelength=self.wavelength,
            emitter=self.emitter,
            depth=depth,
            aberrations=self.aberrations,
        )

    def depths(self, margin: int = 0) -> Array:
        """Return the depth (m) in focus in each plane, with `margin` more planes on each side.

        The depth is 0 where the focus is in the cover glass.
        """
        # Plane n // 2 of n planes is plane (n - 1) // 2 from the other end.
        middle_plane = (self.planes - self.is_reversed) // 2
        offset = self.step * (np.arange(-margin, self.planes + margin) - middle_plane)
        # Without a mismatch of refractive indices the focus and the stage move by equal distances.
        if self.objective.coverslip is None and self.objective.sample == self.objective.immersion:
            return np.asarray(np.clip(self.depth + offset, 0.0, DEPTH_MOST))
        excitation = self.modality.excitation if self.modality.kind == "two-photon" else None
        wave = self.wavelength if excitation is None else excitation
        # Tabulate the best focus over depth, and invert the table by interpolation. Its range is 1.6 times the
        # paraxial range, which is the range of the stage multiplied by the ratio of the indices.
        span = float(np.abs(offset).max()) * self.objective.sample / self.objective.immersion
        table = np.linspace(max(0.0, self.depth - 1.6 * span), self.depth + 1.6 * span + 1e-9, self.foci)
        table = np.unique(np.append(table, self.depth))
        focus = self.objective.pupil(depth=table, wavelength=wave).focus
        # Interpolation needs ascending positions; at the glass the focus may jump back by nanometres.
        best_focus = np.maximum.accumulate(focus) + 1e-15 * np.arange(len(focus))
        middle = float(scipy.interpolate.pchip_interpolate(table, best_focus, self.depth))
        positions = np.clip(middle + offset, best_focus[0], best_focus[-1])
        return np.asarray(scipy.interpolate.pchip_interpolate(best_focus, table, positions))

    def psfs(self, margin: int, slabs: int | None = None) -> PSFs:
        """Return the depths of the PSFs for a stack with `margin` more planes on each side.

        One PSF is used if PSFs hardly differ over the stack. If they are rotationally symmetric, each plane has its
        own PSF. Otherwise their number is `slabs`, or as large as linear interpolation requires.
        """
        depths = self.depths(margin)
        low, high = float(depths[0]), float(depths[-1])
        single_psf = PSFs(depths, np.array([self.depth]), np.array([self.depth]), None)
        if slabs is not None:
            validation.integer("slabs", slabs, least=1, most=64)
        if slabs == 1 or high - low < 1e-9:
            return single_psf
        if slabs is not None:
            nodes = _nodes(low, high, slabs)
            return PSFs(depths, nodes, nodes, None)
        ends = list(self.window_parts(np.array([low, high])))
        if _relative_difference(*ends) < _MAX_EQUAL:
            return single_psf
        radial = self._radial(ends)
        if radial is not None:
            return PSFs(depths, depths, _nodes(low, high, _FAR_DEPTHS), radial)
        nodes = _nodes(low, high, self._slabs(low, high))
        return PSFs(depths, nodes, nodes, None)

    def blur(
        self, shape: tuple[int, int, int], margin: tuple[int, int], psfs: PSFs | None = None, *, threads: int = 0
    ) -> TiledBlur | WideBlur:
        """Return the blur of a stack of this shape, with a margin of planes and of pixels on each side."""
        depths = psfs or self.psfs(margin[0])
        weights = _weights(depths.planes, depths.nodes) if len(depths.nodes) > 1 else None
        kernels = self.kernels(depths.depths)
        windows: TiledBlur
        if depths.radial is None:
            windows = TiledBlur(kernels, shape, margin, weights=weights, threads=threads)
        else:
            windows = PlaneBlur(kernels, shape, margin, depths.radial, threads=threads)
        if not self.spreads:
            return windows
        half_width = self.tail_half_width((shape[1], shape[2]), margin[1])
        tails = self.tail_parts(depths.nodes, half_width)
        return WideBlur(windows, tails, pitch_of(self.window[1]), weights=weights, threads=threads)

    def _radial(self, windows: Sequence[Array]) -> RadialTransfer | None:
        """Return the table of transfer functions if these PSFs are rotationally symmetric, else None."""
        if self.aberrations is not None and any(order for _, order in self.aberrations.to_zernike(unit="waves")):
            return None
        transfer = RadialTransfer(self.window[1], pixels=self.spreads)
        if not all(transfer.misfit(window) < _MAX_MISFIT for window in windows):
            return None
        return RadialTransfer(self.window[1], pixels=self.spreads, spline=self.splines[1])

    def _slabs(self, low: float, high: float) -> int:
        """Return the number of PSFs between two depths for which linear interpolation is accurate enough."""
        computed: dict[float, Array] = {}

        def psf_at(position: float) -> Array:
            """Return the PSF at a position from 0 (depth `low`) to 1 (`high`)."""
            if position not in computed:
                root = (1.0 - position) * math.sqrt(low) + position * math.sqrt(high)
                computed[position] = self.window_part(root**2)
            return computed[position]

        intervals = 1
        while intervals < _MAX_PSFS - 1 and any(
            _relative_difference(psf_at((k + 0.5) / intervals), psf_at(k / intervals), psf_at((k + 1) / intervals))
            > _MAX_DEVIATION
            for k in range(intervals)
        ):
            # Doubling reuses the PSFs that are already computed.
            intervals *= 2
        return intervals + 1


class GivenPSF:
    """A PSF that is the same in all planes of a stack, with the attributes of :class:`DepthModel`."""

    spreads, depth, is_reversed = False, math.nan, False
    wavelength: float | None

    def __init__(self, psf: PSF | MeasuredPSF, planes: int) -> None:
        self._light, self._point = kernel_of(psf)
        self.findings: Sequence[Finding] = ()
        # Pixel in the sample and step, metres; the wavelength of a measured PSF is not known.
        if isinstance(psf, MeasuredPSF):
            self.pixel, self.step, self.wavelength, self.findings = psf.pixel, psf.step, None, psf.findings
        else:
            pupil: Any = psf.pupil
            self.pixel, self.step = psf.grid.side / pupil.magnification, float(abs(np.diff(stage(psf))[0]))
            self.wavelength = float(pupil.wavelength)
        self.aspect = self.pixel / self.step
        self.planes, self.window = planes, (self._light.shape[0], max(self._light.shape[1:]))
        self.rim = 1.0 - float(self._light[:, 1:-1, 1:-1].sum())  # fraction of the light on the rim of the window
        plane_light = self._light.sum(axis=(1, 2))
        self.keeps_light = bool(plane_light.min() > _EQUAL_LIGHT * plane_light.max())

    @property
    def is_contained(self) -> bool:
        """Whether the window contains the cone of light."""
        return self.rim < MAX_RIM

    def point_image(self, depth: float = 0.0) -> Array:
        """Return the image of a point, the same at all depths."""
        return self._light

    def psfs(self, margin: int, slabs: int | None = None) -> PSFs:
        """Return the depth of the PSF, which is not known."""
        planes = np.full(self.planes + 2 * margin, self.depth)
        return PSFs(planes, planes[:1], planes[:1], None)

    def blur(
        self, shape: tuple[int, int, int], margin: tuple[int, int], psfs: PSFs | None = None, *, threads: int = 0
    ) -> TiledBlur:
        """Return the blur of a stack of this shape, with a margin of planes and of pixels on each side."""
        # Points may lie between voxels: voxels are B-splines, as wide as the PSF allows. A PSF that is cut off at the
        # rim of its window has no such splines.
        light = narrowed(self._light, *spline_degrees(self._light)) if self.is_contained else self._light
        return TiledBlur([(light, self._point)], shape, margin, threads=threads)


def _batches(depths: Array, values: int) -> Iterator[Array]:
    """Yield depths (n, 1) whose PSFs, of so many `values` each, are computed together."""
    count = max(1, _BATCH // values)
    return (depths[first : first + count, np.newaxis] for first in range(0, len(depths), count))


def _nodes(low: float, high: float, count: int) -> Array:
    """Return depths evenly spaced in their square root: PSFs change fastest near the glass."""
    position = np.arange(count) / (count - 1)
    return np.asarray(((1.0 - position) * math.sqrt(low) + position * math.sqrt(high)) ** 2)


def spline_degrees(kernel: Array) -> tuple[int, int]:
    """Return the highest degrees of B-splines, along z and across, whose narrowed kernel is nearly positive, or 0."""

    def nearly_positive(*degrees: int) -> bool:
        narrow_kernel = narrowed(kernel, *degrees)
        return -float(np.minimum(narrow_kernel, 0.0).sum()) < _MAX_NEGATIVE * float(narrow_kernel.sum())

    z_degree = next((degree for degree in _SPLINE_DEGREES if nearly_positive(degree, 0)), 0)
    return z_degree, next((degree for degree in _SPLINE_DEGREES if nearly_positive(0, degree)), 0)


def narrowed(kernel: Array, z_degree: int, lateral_degree: int) -> Array:
    """Return the kernel whose convolution with B-splines of these degrees, along z and across, is `kernel`."""
    for axis, degree in enumerate((z_degree, lateral_degree, lateral_degree)):
        if degree:
            kernel = scipy.ndimage.spline_filter1d(kernel, degree, axis, mode="reflect")  # keeps the sum
    return kernel


def _weights(depths: Array, nodes: Array) -> Array:
    """Return the weights of linear interpolation between PSFs at depths `nodes`, shape (nodes, depths)."""
    position = np.interp(depths, nodes, np.arange(len(nodes)))
    # Hat functions around the nodes.
    return np.asarray(np.maximum(0.0, 1.0 - np.abs(position - np.arange(len(nodes))[:, np.newaxis])))


def _relative_difference(kernel: Array, *others: Array) -> float:
    """Return half of the sum of absolute differences of a PSF from the mean of other PSFs, divided by its light."""
    # Half, because displaced light counts twice: as missing at one place and as excess at the other.
    return float(np.abs(kernel - sum(others) / len(others)).sum() / kernel.sum()) / 2.0


def _cone(objective: Objective, wavelength: float, pixel: float, distance: float) -> float:
    """Return the radius of the cone of light at a distance (m) from the focus, in pixels."""
    pixel_in_sample = pixel / objective.magnification
    # The marginal ray has NA = n sin(alpha) and the slope tan(alpha). The spot in focus has a radius of about
    # 2 wavelength / NA.
    tangent = objective.NA / math.sqrt(objective.immersion**2 - objective.NA**2)
    return (distance * tangent + 2.0 * wavelength / objective.NA) / pixel_in_sample


def usual_window(
    objective: Objective, wavelength: float, pixel: float, step: float, shape: tuple[int, int, int]
) -> tuple[int, int]:
    """Return planes and pixels of the PSF window of a stack: twice its planes, and the diameter of the light cone.

    Both numbers are limited; light beyond the pixels is represented on a coarse grid.
    """
    planes = min(max(_MIN_HALF, shape[0] - 1), _MAX_HALF_PLANES)
    pixels = math.ceil(_cone(objective, wavelength, pixel, planes * step))
    return 2 * planes + 1, 2 * min(max(_MIN_HALF, pixels), _MAX_HALF_PIXELS) + 1
