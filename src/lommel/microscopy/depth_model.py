"""PSFs of a microscope at the depths of a stack, and the weights with which they blur its planes."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.microscopy.modalities import confocal, light_sheet, two_photon
from lommel.optics.layers.emitter import Beam, Emitter, emitter_of
from lommel.optics.layers.objective import Objective
from lommel.optics.layers.stratified import DEPTH_MOST
from lommel.optics.wavefront.wavefront import Wavefront
from lommel.psf import PSF, psf

MODALITIES = ("widefield", "confocal", "spinning disc", "light sheet", "two-photon")
_TURNING = emitter_of("isotropic")
_TOL = 1e-4
_LIKE = 0.03  # of the light of a PSF, by which those between two depths may be off their mean
_MOST = 9  # PSFs
_LEAST_REACH, _MOST_REACH = 8, 48  # planes and pixels of a PSF beside its middle
_TABLE = 33  # depths


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

    def changed(self, name: str, value: float) -> DepthModel:
        """Return the model with another "depth", "sample" index or "spherical" aberration (waves rms, added)."""
        if name == "depth":
            return replace(self, depth=value)
        if name == "sample":
            given = {key: getattr(self.objective, key) for key in self.objective.__dataclass_fields__}
            return replace(self, objective=Objective(**given | {"sample": value}))
        terms = {} if self.aberrations is None else dict(self.aberrations.to_zernike(unit="waves"))
        terms[(4, 0)] = float(terms.get((4, 0), 0.0)) + value
        return replace(self, aberrations=Wavefront.zernike(terms, unit="waves"))

    def psf(self, depth: float) -> PSF:
        """Return the PSF of an emitter at a depth, z from its brightest focus."""
        planes, side = self.window
        z = (np.arange(planes) - planes // 2) * self.step
        seen: dict[str, Any] = {"depth": depth, "aberrations": self.aberrations}
        if self.modality == "two-photon":
            assert self.excitation is not None
            beam = self.objective.pupil(z=z, wavelength=self.excitation, emitter=Beam("circular"), **seen)
            return two_photon(beam, side, self.pixel, tol=_TOL)
        emission = self.objective.pupil(z=z, wavelength=self.wavelength, emitter=self.emitter, **seen)
        if self.modality == "light sheet":
            assert self.thickness is not None
            offset = np.clip(z, -4.0 * self.thickness, 4.0 * self.thickness)
            return light_sheet(emission, self.thickness, side, self.pixel, offset=offset, tol=_TOL)
        if self.modality in ("confocal", "spinning disc"):
            assert self.excitation is not None
            laser = self.objective.pupil(
                z=emission.focus, origin="coverslip", wavelength=self.excitation, emitter=Beam("circular"), **seen
            )
            return confocal(laser, emission, side, self.pixel, pinhole=self.pinhole, tol=_TOL)
        return psf(emission, side, self.pixel, tol=_TOL)

    def depths(self, margin: int = 0) -> Array:
        """Return the depth in focus in each plane, with so many more on each side; 0 where that is in the glass."""
        if self.objective.coverslip is None and self.objective.sample == self.objective.immersion:
            ratio = 1.0
            found = self.depth + ratio * self.step * (np.arange(-margin, self.planes + margin) - self.planes // 2)
            return np.asarray(np.clip(found, 0.0, DEPTH_MOST))
        wave = self.wavelength if self.modality != "two-photon" else float(self.excitation or self.wavelength)
        away = self.step * (np.arange(-margin, self.planes + margin) - self.planes // 2)
        span = float(np.abs(away).max()) * self.objective.sample / self.objective.immersion
        table = np.linspace(max(0.0, self.depth - 1.6 * span), self.depth + 1.6 * span + 1e-9, _TABLE)
        table = np.unique(np.append(table, self.depth))
        focus = np.asarray(self.objective.focus(table, wavelength=wave).brightest)
        best = np.maximum.accumulate(focus)  # at the glass it may jump back by nanometres
        middle = float(np.interp(self.depth, table, best))
        return np.asarray(np.interp(middle + away, best + 1e-15 * np.arange(len(best)), table))

    def operator(self, margin: int, slabs: int | None = None) -> tuple[list[PSF], Array | None, Array]:
        """Return PSFs, their weights in each plane (with a margin on each side), and the depths of the PSFs.

        So many as are needed for those between to be like the means of their neighbours, or one where they hardly
        differ. They are evenly spaced in the square root of the depth: near the glass PSFs change fastest.
        """
        depths = self.depths(margin)
        low, high = float(depths[0]), float(depths[-1])
        if slabs == 1 or high - low < 1e-9:
            return [self.psf(self.depth)], None, np.array([self.depth])
        made: dict[float, PSF] = {}

        def at(share: float) -> PSF:
            if share not in made:
                made[share] = self.psf(((1.0 - share) * math.sqrt(low) + share * math.sqrt(high)) ** 2)
            return made[share]

        if slabs is None:
            if _apart(at(0.0), at(1.0)) < _LIKE:
                return [self.psf(self.depth)], None, np.array([self.depth])
            pieces = 1
            while pieces < _MOST - 1 and any(
                _apart(at((k + 0.5) / pieces), at(k / pieces), at((k + 1) / pieces)) > _LIKE for k in range(pieces)
            ):
                pieces *= 2
        else:
            pieces = validation.integer("slabs", slabs, least=1, most=64) - 1
        shares = np.arange(pieces + 1) / pieces
        nodes = ((1.0 - shares) * math.sqrt(low) + shares * math.sqrt(high)) ** 2
        place = np.interp(depths, nodes, np.arange(len(nodes)))
        weights = np.maximum(0.0, 1.0 - np.abs(place - np.arange(len(nodes))[:, np.newaxis]))
        return [at(float(share)) for share in shares], weights, nodes


def _apart(one: PSF, *others: PSF) -> float:
    """Return half of the light by which a PSF differs from the mean of others."""
    first, *rest = (each.values / each.values.sum(dtype=np.float64) for each in (one, *others))
    return float(np.abs(first - sum(rest) / len(rest)).sum()) / 2.0


def usual_window(
    objective: Objective, wavelength: float, pixel: float, step: float, shape: tuple[int, int, int]
) -> tuple[int, int]:
    """Return planes and pixels of the PSF of a stack: the cone of light over half of its planes, within limits."""
    planes = min(max(_LEAST_REACH, shape[0] // 2), _MOST_REACH)
    side = pixel / objective.magnification
    tangent = objective.NA / math.sqrt(objective.immersion**2 - objective.NA**2)
    cone = math.ceil(planes * step * tangent / side + 4.0 * wavelength / (2.0 * objective.NA) / side)
    pixels = min(max(_LEAST_REACH, cone), _MOST_REACH)
    return 2 * planes + 1, 2 * pixels + 1
