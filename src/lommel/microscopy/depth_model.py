"""PSFs of a microscope at the depths of a stack, and the weights with which they blur its planes."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import cached_property
from typing import NamedTuple

import numpy as np

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.microscopy.modalities import confocal, light_sheet, two_photon
from lommel.microscopy.stack_blur import PlaneBlur, RadialTransfer, TiledBlur, WideBlur, pitch_of, taper
from lommel.optics.layers.emitter import Beam, Emitter, emitter_of
from lommel.optics.layers.objective import Objective
from lommel.optics.layers.objective_pupil import ObjectivePupil
from lommel.optics.layers.stratified import DEPTH_MOST
from lommel.optics.wavefront.wavefront import Wavefront
from lommel.psf import PSF, psf

MODALITIES = ("widefield", "confocal", "spinning disc", "light sheet", "two-photon")
SPREADING = ("widefield", "light sheet")
"""Modalities that record light out of focus."""
_TURNING = emitter_of("isotropic")
_TOL = 1e-4
_LIKE = 0.003  # of the light: largest difference of PSFs over the stack for which one PSF is enough
_ALIKE = 0.03  # of the light: largest difference of a PSF from the mean of its neighbours
_MOST = 9  # largest number of PSFs
_FAR = 9  # depths of light far from its emitter, which changes slowly
_RADIAL = 0.01  # of the rms transfer function: largest deviation from rotational symmetry
_LEAST_REACH, _MOST_PLANES, _MOST_REACH = 8, 64, 48  # planes and pixels of a PSF on a side of its middle
_PARTS, _MOST_NODES = 3, 48  # of the coarse grid: values a node, and nodes on a side of the middle
_DARK = 4.0  # thicknesses of a light sheet beyond which it counts as constant
_TABLE = 33  # depths of the table of foci
_SPLINES = (3, 2)  # degrees that are tried
_NEGATIVE = 0.015  # of the light of a PSF: largest negative part


class PSFs(NamedTuple):
    """The depths in focus in each plane, and of PSFs: of those near their emitters, and of the light far from them.

    Metres. With `radial` there is one for each plane, else weights between neighbours are linear.
    """

    planes: Array
    depths: Array
    nodes: Array
    radial: RadialTransfer | None


@dataclass(frozen=True, eq=False)
class DepthModel:
    """A microscope and the sampling of a stack, from which its PSF at each depth follows.

    `pixel` is on the camera and `step` of the stage, metres; `depth` is that in focus in plane ``planes // 2``.
    """

    objective: Objective
    wavelength: float
    pixel: float
    step: float
    depth: float
    planes: int
    window: tuple[int, int]  # planes and pixels of the PSF, odd
    modality: str = "widefield"
    excitation: float | None = None
    pinhole: float = 1.0
    thickness: float | None = None
    emitter: Emitter = _TURNING
    aberrations: Wavefront | None = None
    degrees: tuple[int, int] | None = None  # of the B-splines along z and across; by default as high as they may be

    def changed(self, name: str, value: float) -> DepthModel:
        """Return the model with another value.

        Of "depth" or "sample" index; with "spherical" aberration (waves rms) added; "wavelength", "step" or "NA"
        times it. ValueError where it is out of range.
        """
        if name in ("wavelength", "step"):
            return replace(self, **{name: value * getattr(self, name)})
        if name == "depth":
            return replace(self, depth=validation.real("depth", value, least=0.0, most=DEPTH_MOST))
        if name in ("sample", "NA"):
            given = {key: getattr(self.objective, key) for key in self.objective.__dataclass_fields__}
            given[name] = value if name == "sample" else value * self.objective.NA
            return replace(self, objective=Objective(**given))
        terms = {} if self.aberrations is None else dict(self.aberrations.to_zernike(unit="waves"))
        terms[(4, 0)] = float(terms.get((4, 0), 0.0)) + value
        return replace(self, aberrations=Wavefront.zernike(terms, unit="waves"))

    def psf(self, depth: float) -> PSF:
        """Return the PSF of an emitter at a depth, with z from its brightest focus."""
        side = self.window[1]
        if self.modality == "two-photon":
            return two_photon(self._laser(depth, self._z, "brightest"), side, self.pixel, tol=_TOL)
        emission = self._emission(depth)
        if self.modality == "light sheet":
            assert self.thickness is not None
            offset = np.clip(self._z, -_DARK * self.thickness, _DARK * self.thickness)
            return light_sheet(emission, self.thickness, side, self.pixel, offset=offset, tol=_TOL)
        if self.modality in ("confocal", "spinning disc"):
            # The laser is focused where the emission is: both with the same focus over the cover glass.
            beam = self._laser(depth, emission.focus, "coverslip")
            return confocal(beam, emission, side, self.pixel, pinhole=self.pinhole, tol=_TOL)
        return psf(emission, side, self.pixel, tol=_TOL)

    @property
    def spreads(self) -> bool:
        """Whether light out of focus is recorded and counts in full; otherwise only that in the window."""
        return self.modality in SPREADING

    def near(self, depth: float) -> Array:
        """Return the share of the light of an emitter in each voxel of the window, which fades towards its edge.

        All light is that which the objective collects in as many planes as the window has; where none is recorded
        out of focus, that in the window.
        """
        values = self.psf(depth).values.astype(np.float64)
        if not self.spreads:
            return np.asarray(values / values.sum())
        # A taper, so that what the coarse grid takes over has no edge.
        return np.asarray(values * taper(self.window[1], pitch_of(self.window[1])) / self._collected_light.sum())

    def kernel(self, depth: float) -> Array:
        """Return the light of an emitter that is spread over the nearest voxels as a B-spline, as :meth:`near`.

        Wherever a point lies between the voxels, its image is then that of nearby voxels with positive light
        (Magain et al. 1998, doi:10.1086/305187): that of voxels which are points would be wider.
        """
        return narrowed(self.near(depth), *self.splines)

    @cached_property
    def splines(self) -> tuple[int, int]:
        """Degrees of the B-splines along z and across, 0 where planes or pixels are too wide for any."""
        if self.degrees is not None:
            return self.degrees
        return spline_degrees(self.near(self.depth))

    def far(self, depth: float, reach: int) -> Array:
        """Return what is not :meth:`near`, at every `pitch_of` th pixel up to so many of these, share a pixel.

        What lies beyond these is on the outermost ones.
        """
        pitch, side = pitch_of(self.window[1]), 2 * reach + 1
        lit = self._collected_light / self._collected_light.sum()
        made = psf(self._emission(depth), _PARTS * side, self.pixel * pitch / _PARTS, integrate=False, tol=_TOL)
        at = np.asarray((np.arange(_PARTS * side) - _PARTS * side // 2) * (pitch / _PARTS), np.float64)
        values = made.values * (1.0 - taper(self.window[1], pitch, at)) * (_PARTS / pitch) ** 2
        means = values.reshape(-1, side, _PARTS, side, _PARTS).mean(axis=(2, 4)) * lit[:, np.newaxis, np.newaxis]
        rim = np.maximum(*np.abs(np.indices((side, side)) - reach)) >= 0.8 * reach
        # Light that neither the window nor the coarse grid holds goes to the rim: the sum is that collected.
        asked = np.maximum(lit - self.near(depth).sum(axis=(1, 2)), 0.0) / pitch**2
        found = np.maximum(means.sum(axis=(1, 2)), 1e-30)
        means *= np.minimum(asked / found, 1.0)[:, np.newaxis, np.newaxis]
        return np.asarray(means + np.maximum(asked - found, 0.0)[:, np.newaxis, np.newaxis] * rim / rim.sum())

    def reach(self, shape: tuple[int, int], margin: int) -> int:
        """Return the nodes of the coarse grid that PSFs reach: over the cone of light, or the whole field."""
        pitch = pitch_of(self.window[1])
        field = (max(shape) + margin) / pitch
        cone = _cone(self.objective, self.wavelength, self.pixel, float(np.abs(self._z).max())) / pitch
        return max(math.ceil(margin / pitch), min(math.ceil(1.2 * cone), math.ceil(field), _MOST_NODES), 2)

    @property
    def _z(self) -> Array:
        return np.asarray((np.arange(self.window[0]) - self.window[0] // 2) * self.step)

    @property
    def _collected_light(self) -> Array:
        """Collected light in each plane of the window, over that in focus."""
        if self.modality != "light sheet":
            return np.ones(self.window[0])
        assert self.thickness is not None
        # A Gaussian of this full width at half maximum.
        return np.asarray(np.exp(-4.0 * math.log(2.0) * np.clip(self._z / self.thickness, -_DARK, _DARK) ** 2))

    def _laser(self, depth: float, z: Array, origin: str) -> ObjectivePupil:
        assert self.excitation is not None
        return self.objective.pupil(
            z=z,
            wavelength=self.excitation,
            emitter=Beam("circular"),
            depth=depth,
            origin=origin,
            aberrations=self.aberrations,
        )

    def _emission(self, depth: float) -> ObjectivePupil:
        return self.objective.pupil(
            z=self._z,
            wavelength=self.wavelength,
            emitter=self.emitter,
            depth=depth,
            aberrations=self.aberrations,
        )

    def depths(self, margin: int = 0) -> Array:
        """Return the depth in focus in each plane, with `margin` more on each side; 0 where that is in the glass."""
        # Without a mismatch of indices the focus moves as the stage does.
        if self.objective.coverslip is None and self.objective.sample == self.objective.immersion:
            ratio = 1.0
            found = self.depth + ratio * self.step * (np.arange(-margin, self.planes + margin) - self.planes // 2)
            return np.asarray(np.clip(found, 0.0, DEPTH_MOST))
        wave = self.wavelength if self.modality != "two-photon" else float(self.excitation or self.wavelength)
        away = self.step * (np.arange(-margin, self.planes + margin) - self.planes // 2)
        span = float(np.abs(away).max()) * self.objective.sample / self.objective.immersion
        # The paraxial focus in the sample moves by the ratio of the indices; the table reaches farther.
        table = np.linspace(max(0.0, self.depth - 1.6 * span), self.depth + 1.6 * span + 1e-9, _TABLE)
        table = np.unique(np.append(table, self.depth))
        focus = self.objective.pupil(depth=table, wavelength=wave).focus
        # np.interp needs positions that increase.
        best = np.maximum.accumulate(focus)  # at the glass it may jump back by nanometres
        middle = float(np.interp(self.depth, table, best))
        return np.asarray(np.interp(middle + away, best + 1e-15 * np.arange(len(best)), table))

    def psfs(self, margin: int, slabs: int | None = None) -> PSFs:
        """Return which PSFs blur a stack with so many planes more on each side.

        Each plane has a PSF of its own where these are rotationally symmetric, or all have one where PSFs hardly
        differ. Else so many as are needed for those between to be like the means of their neighbours.
        """
        depths = self.depths(margin)
        low, high = float(depths[0]), float(depths[-1])
        alone = PSFs(depths, np.array([self.depth]), np.array([self.depth]), None)
        if slabs is not None:
            validation.integer("slabs", slabs, least=1, most=64)
        if slabs == 1 or high - low < 1e-9:
            return alone
        if slabs is not None:
            nodes = _nodes(low, high, slabs)
            return PSFs(depths, nodes, nodes, None)
        if _relative_difference(self.near(low), self.near(high)) < _LIKE:
            return alone
        radial = self._radial(low, high)
        if radial is not None:
            return PSFs(depths, depths, _nodes(low, high, _FAR), radial)
        nodes = _nodes(low, high, self._slabs(low, high))
        return PSFs(depths, nodes, nodes, None)

    def blur(
        self, shape: tuple[int, int, int], margin: tuple[int, int], psfs: PSFs | None = None, *, threads: int = 0
    ) -> TiledBlur | WideBlur:
        """Return the blur of a stack, with a margin on each side."""
        used = psfs or self.psfs(margin[0])
        weights = _weights(used.planes, used.nodes) if len(used.nodes) > 1 else None
        kernels = (self.kernel(float(each)) for each in used.depths)
        near: TiledBlur
        if used.radial is None:
            near = TiledBlur(kernels, shape, margin, weights=weights, threads=threads)
        else:
            near = PlaneBlur(kernels, shape, margin, used.radial, threads=threads)
        if not self.spreads:
            return near
        reach = self.reach((shape[1], shape[2]), margin[1])
        far = (self.far(float(each), reach) for each in used.nodes)
        return WideBlur(near, far, pitch_of(self.window[1]), weights=weights, threads=threads)

    def _radial(self, *depths: float) -> RadialTransfer | None:
        """Return the lateral transfer functions over the magnitude of frequencies, if they follow from that."""
        if self.aberrations is not None and any(order for _, order in self.aberrations.to_zernike(unit="waves")):
            return None
        found = RadialTransfer(self.window[1], pixels=self.spreads)
        if not all(found.misfit(self.near(each)) < _RADIAL for each in depths):
            return None
        return RadialTransfer(self.window[1], pixels=self.spreads, spline=self.splines[1])

    def _slabs(self, low: float, high: float) -> int:
        """Return the number of PSFs for which those between two are like the means of these."""
        made: dict[float, Array] = {}

        def at(share: float) -> Array:
            if share not in made:
                made[share] = self.near(((1.0 - share) * math.sqrt(low) + share * math.sqrt(high)) ** 2)
            return made[share]

        pieces = 1
        while pieces < _MOST - 1 and any(
            _relative_difference(at((k + 0.5) / pieces), at(k / pieces), at((k + 1) / pieces)) > _ALIKE
            for k in range(pieces)
        ):
            # Doubling keeps the PSFs that are already computed.
            pieces *= 2
        return pieces + 1


def _nodes(low: float, high: float, count: int) -> Array:
    """Return depths evenly spaced in their square root: near the glass PSFs change fastest."""
    shares = np.arange(count) / (count - 1)
    return np.asarray(((1.0 - shares) * math.sqrt(low) + shares * math.sqrt(high)) ** 2)


def spline_degrees(kernel: Array) -> tuple[int, int]:
    """Return the highest degrees of B-splines along z and across for which a narrowed kernel is positive, or 0."""

    def fits(*degrees: int) -> bool:
        made = narrowed(kernel, *degrees)
        return -float(np.minimum(made, 0.0).sum()) < _NEGATIVE * float(made.sum())

    along = next((degree for degree in _SPLINES if fits(degree, 0)), 0)
    return along, next((degree for degree in _SPLINES if fits(0, degree)), 0)


def narrowed(kernel: Array, along: int, across: int) -> Array:
    """Return the kernel whose convolution with B-splines, of these degrees along z and across, is a kernel."""
    from scipy.ndimage import spline_filter1d

    for axis, degree in enumerate((along, across, across)):
        if degree:
            kernel = spline_filter1d(kernel, degree, axis, mode="reflect")  # which keeps the light
    return kernel


def _weights(depths: Array, nodes: Array) -> Array:
    """Return the weights of PSFs at each depth, linear between two."""
    place = np.interp(depths, nodes, np.arange(len(nodes)))
    # Hat functions around the nodes.
    return np.asarray(np.maximum(0.0, 1.0 - np.abs(place - np.arange(len(nodes))[:, np.newaxis])))


def _relative_difference(one: Array, *others: Array) -> float:
    """Return half of the absolute difference of a PSF from the mean of others, over its light."""
    # Half: light that is missing in one place is too much in another.
    return float(np.abs(one - sum(others) / len(others)).sum() / one.sum()) / 2.0


def _cone(objective: Objective, wavelength: float, pixel: float, away: float) -> float:
    """Return the radius of the cone of light at a distance from the focus, pixels."""
    side = pixel / objective.magnification
    # NA = n sin(alpha): the marginal ray's tan(alpha); two wavelengths over NA for the spot itself.
    tangent = objective.NA / math.sqrt(objective.immersion**2 - objective.NA**2)
    return (away * tangent + 2.0 * wavelength / objective.NA) / side


def usual_window(
    objective: Objective, wavelength: float, pixel: float, step: float, shape: tuple[int, int, int]
) -> tuple[int, int]:
    """Return planes and pixels of the PSF of a stack: as far as it goes, and the cone of light, within limits.

    Light beyond the pixels is on a coarse grid.
    """
    planes = min(max(_LEAST_REACH, shape[0] - 1), _MOST_PLANES)
    pixels = math.ceil(_cone(objective, wavelength, pixel, planes * step))
    return 2 * planes + 1, 2 * min(max(_LEAST_REACH, pixels), _MOST_REACH) + 1
