"""Pupil of a microscope objective, for one or several depths of the emitter and positions of the stage."""

from __future__ import annotations

import math
from dataclasses import asdict, dataclass, replace
from functools import lru_cache
from typing import ClassVar

import numpy as np

from lommel.base import validation
from lommel.base.arrays import Array, Json
from lommel.base.cached import cached_property
from lommel.optics.base_pupil import BasePupil, OfEach
from lommel.optics.layers import debye
from lommel.optics.layers.emitter import Beam, Dipole, Emitter, Light, Scalar, light_of
from lommel.optics.layers.stratified import Layers
from lommel.optics.wavefront.wavefront import Wavefront, same_path


@dataclass(frozen=True, eq=False)
class ObjectivePupil(BasePupil):
    """Pupil of a microscope objective, as built by :meth:`lommel.Objective.pupil`.

    The unit of intensity in each plane is the peak of a uniform, unaberrated scalar pupil whose power is the power
    collected in this plane.

    Parameters
    ----------
    layers : Layers
        Refractive indices and thicknesses, with NA and wavelength.
    magnification : float
        Lateral magnification M.
    depth, focus, z : ndarray, all of the shape of the stack
        Depth of the emitter below the glass, stage position relative to the paraxial focus on the cover glass, and
        stage position relative to the origin that the caller chose, metres.
    emitter : Dipole, Beam or Scalar
        Emitter or excitation beam.
    aberrations : Wavefront, optional
        Aberrations added to the phase of the layers: one wavefront, or a stack with the shape of `depth`.
    """

    pupil_hint = "the pupil of an Objective, which has no single wavefront; pass it to lommel.psf and measure the PSF"

    layered: ClassVar[bool] = True
    layers: Layers
    magnification: float
    depth: Array
    focus: Array
    z: Array
    emitter: Emitter
    aberrations: Wavefront | None = None

    circular = True
    amplitude = transmission = 1.0
    likely_peak = 0.1

    @property
    def shape(self) -> tuple[int, ...]:
        """Shape of the stack; ``()`` for a single plane."""
        return self.focus.shape

    @property
    def wavelength(self) -> float:
        """Wavelength, metres in vacuum."""
        return self.layers.wavelength

    @property
    def f_number(self) -> float:
        """Working f-number on the camera, ``M / (2 NA)``."""
        return self.magnification / (2.0 * self.layers.NA)

    @cached_property
    def light(self) -> Light:
        """Diffraction integrals of the emitter, and the quadratic forms that convert them to intensities."""
        return light_of(self.emitter)

    @property
    def radial(self) -> bool:
        """True if the PSF is rotationally symmetric."""
        return self.light.radial and not self.aberrated

    @property
    def aberrated(self) -> bool:
        """True if aberrations are added to the phase of the layers."""
        return self.aberrations is not None

    @property
    def left_out(self) -> tuple[float, float]:
        """Bounds on the errors of the phase (radians) and of the amplitude due to truncated expansions."""
        return 0.0 if self.aberrations is None else self.aberrations.left_out, 0.0

    @cached_property
    def aperture(self) -> tuple[object, ...]:
        """Hashable key of all parameters but `focus`, `z` and the coefficients of the aberrations."""
        return self.layers, self.magnification, self.emitter, self.depth.tobytes(), self.aberrated

    @cached_property
    def power(self) -> Array:
        """Power collected in each plane of the flattened stack, unit ``4 pi / (k NA)^2``, k = 2 pi / wavelength."""
        # Parameter searches evaluate the same single plane repeatedly: cache its power.
        if self.depth.size == 1:
            return _power_at_one(self.layers, self.emitter, self.depth.item()).copy()
        return power_at(self.layers, self.emitter, self.depth)

    @property
    def collected(self) -> Array:
        """Ratio of :attr:`power` to the power of the same emitter far from the glass, shape `shape`."""
        # The power far from the glass does not depend on depth, so that no depths are passed.
        _, far_power = debye.power(self.layers, np.zeros(0), self.light.model)
        return np.asarray(self.power / (far_power @ self.light.shares)).reshape(self.shape)

    def geometric_radius(self) -> Array:
        """Return the largest distance from the axis, metres on the camera, of rays within 0.98 of the pupil."""
        # The usable radius extends to the pupil's edge or to the critical angle, where the phase slope diverges.
        rho = np.linspace(0.0, 0.98, 65) * min(1.0, self.layers.sample / self.layers.NA)
        rates = self.layers.rates(self.layers.cosine(rho))
        phase0, by_depth, by_focus = (np.gradient(rate.real, rho) for rate in rates)
        # The distance of a ray from the axis is proportional to the slope of the phase.
        height = phase0 + self.depth[..., None] * by_depth + self.focus[..., None] * by_focus
        return np.asarray(np.abs(height).max(axis=-1) * (self.scale / math.pi))

    def _each(self, of: OfEach) -> ObjectivePupil:
        depth, focus, z = (np.asarray(of(getattr(self, name))) for name in PLANES)
        aberrations = of(self.aberrations) if self.aberrations and self.aberrations.shape else self.aberrations
        return replace(self, depth=depth, focus=focus, z=z, aberrations=aberrations)

    def in_light(self, wavelength: float) -> ObjectivePupil:
        """Return the pupil at a `wavelength`, metres, with the same indices and path differences."""
        layers = replace(self.layers, wavelength=validation.wavelength(wavelength))
        aberrations = self.aberrations and same_path(self.aberrations, self.wavelength, layers.wavelength)
        return replace(self, layers=layers, aberrations=aberrations)

    def to_dict(self) -> Json:
        """Return all parameters as plain data; :meth:`from_dict` is the inverse."""
        planes = {name: getattr(self, name).tolist() for name in PLANES}
        emitter = asdict(self.emitter) | {"kind": type(self.emitter).__name__}
        if isinstance(jones := emitter.get("polarization"), tuple):
            emitter["polarization"] = [[part.real, part.imag] for part in jones]
        return {
            "layers": asdict(self.layers),
            "magnification": self.magnification,
            "emitter": emitter,
            "aberrations": self.aberrations and self.aberrations.to_dict(),
        } | planes

    @classmethod
    def from_dict(cls, description: Json) -> ObjectivePupil:
        """Rebuild a pupil from the result of :meth:`to_dict`; TypeError or ValueError for invalid data."""
        parameters = dict(description["emitter"])
        kind = {option.__name__: option for option in (Dipole, Beam, Scalar)}[parameters.pop("kind")]
        if isinstance(jones := parameters.get("polarization"), list):
            parameters["polarization"] = tuple(complex(*part) for part in jones)
        layers = description["layers"]
        numbers: Json = {name: validation.real(name, layers[name]) for name in _NUMBERS}
        films, paths = (tuple((float(n), float(t)) for n, t in layers[name]) for name in ("films", "paths"))
        exponent = tuple(validation.real_array("exponent", layers.get("exponent", ())).tolist())
        depth, focus, z = (validation.real_array(name, description[name]) for name in PLANES)
        magnification = validation.real("magnification", description["magnification"], above=0.0)
        wavefront = description.get("aberrations")
        aberrations = wavefront and Wavefront.from_dict(wavefront)
        stack = Layers(**numbers, films=films, paths=paths, exponent=exponent)
        return cls(stack, magnification, depth, focus, z, kind(**parameters), aberrations)

    def __eq__(self, other: object) -> bool:
        """Return True if all parameters are equal."""
        return self.to_dict() == other.to_dict() if isinstance(other, ObjectivePupil) else NotImplemented

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        planes = "one plane" if not self.shape else f"{'x'.join(map(str, self.shape))} planes"
        aberrations = f", {self.aberrations!r}" if self.aberrations else ""
        objective = f"NA {self.layers.NA:g}, {1e9 * self.wavelength:g} nm"
        return f"<ObjectivePupil {objective}, {planes}, {self.emitter!r}{aberrations}>"


def power_at(layers: Layers, emitter: Emitter, depth: Array) -> Array:
    """Return the power collected at each depth, flattened; see :attr:`ObjectivePupil.power`."""
    light, (depths, index) = light_of(emitter), np.unique(depth.ravel(), return_inverse=True)
    powers, _ = debye.power(layers, depths, light.model)
    return np.asarray((powers @ light.shares)[index.ravel()])


@lru_cache(maxsize=256)
def _power_at_one(layers: Layers, emitter: Emitter, depth: float) -> Array:
    return power_at(layers, emitter, np.array([depth]))


PLANES = ("depth", "focus", "z")
_NUMBERS = ("NA", "immersion", "glass", "sample", "wavelength")
