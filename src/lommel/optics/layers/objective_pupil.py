"""The pupil of a microscope objective: an emitter at a depth, the stage at a position; or a stack."""

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
    """The pupil of a microscope objective, made by :meth:`lommel.Objective.pupil`.

    Intensities are relative to the light collected in each plane: 1 is the peak of a uniform, scalar, unaberrated
    aperture that passes as much light.

    Parameters
    ----------
    layers : Layers
    magnification : float
    depth, focus, z : ndarray, all of the shape of the stack
        Metres: depth of the emitter below the glass; stage position from paraxial focus on the cover glass; stage
        position from the chosen origin.
    emitter : Dipole, Beam or Scalar
    aberrations : Wavefront, optional
        Aberrations added to the phase of the layers: one wavefront, or a stack of the shape of the planes.
    """

    pupil_hint = "that of an Objective, which has no single wavefront; lommel.psf takes it, and measures its PSF"

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
        """Integrals and forms of the intensity."""
        return light_of(self.emitter)

    @property
    def radial(self) -> bool:
        """Whether the PSF is rotationally symmetric."""
        return self.light.radial and not self.aberrated

    @property
    def aberrated(self) -> bool:
        """Whether a measured wavefront is added to the phase of the layers."""
        return self.aberrations is not None

    @property
    def left_out(self) -> tuple[float, float]:
        """Bounds on what the expansions of phase (radians) and amplitude leave out."""
        return 0.0 if self.aberrations is None else self.aberrations.left_out, 0.0

    @cached_property
    def aperture(self) -> tuple[object, ...]:
        """Everything that limits or weights the light, and whether wavefronts are added."""
        return self.layers, self.magnification, self.emitter, self.depth.tobytes(), self.aberrated

    @cached_property
    def power(self) -> Array:
        """Light collected in each plane of the flattened stack, over ``4 pi / (k NA)^2``."""
        # One plane is common in searches, and its light is kept.
        if self.depth.size == 1:
            return _power_at(self.layers, self.emitter, self.depth.item()).copy()
        depth, place = np.unique(self.depth.ravel(), return_inverse=True)
        near, _ = debye.power(self.layers, depth, self.light.model)
        return np.asarray((near @ self.light.shares)[place.ravel()])

    @property
    def collected(self) -> Array:
        """:attr:`power` over that of the same emitter far from the glass, of the shape of the stack."""
        # Without a depth near the glass: what an emitter far from it sends into the objective.
        _, far = debye.power(self.layers, np.zeros(0), self.light.model)
        return np.asarray(self.power / (far @ self.light.shares)).reshape(self.shape)

    def geometric_radius(self) -> Array:
        """Return the largest ray distance from the axis on the camera, metres, within 0.98 of the critical angle."""
        # Slopes of the phase have no bound at the critical angle.
        rho = np.linspace(0.0, 0.98, 65) * min(1.0, self.layers.sample / self.layers.NA)
        rates = self.layers.rates(self.layers.cosine(rho))
        fixed, by_depth, by_focus = (np.gradient(rate.real, rho) for rate in rates)
        # Heights of rays are slopes of the phase.
        height = fixed + self.depth[..., None] * by_depth + self.focus[..., None] * by_focus
        return np.asarray(np.abs(height).max(axis=-1) * (self.scale / math.pi))

    def _each(self, of: OfEach) -> ObjectivePupil:
        depth, focus, z = (np.asarray(of(getattr(self, name))) for name in PLANES)
        measured = of(self.aberrations) if self.aberrations and self.aberrations.shape else self.aberrations
        return replace(self, depth=depth, focus=focus, z=z, aberrations=measured)

    def in_light(self, wavelength: float) -> ObjectivePupil:
        """Return the pupil at another `wavelength`, metres: same indices and path differences; or a ValueError."""
        layers = replace(self.layers, wavelength=validation.wavelength(wavelength))
        measured = self.aberrations and same_path(self.aberrations, self.wavelength, layers.wavelength)
        return replace(self, layers=layers, aberrations=measured)

    def to_dict(self) -> Json:
        """Return everything in plain types; :meth:`from_dict` is the inverse."""
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
        """Rebuild a pupil from a `description` by :meth:`to_dict`; TypeError or ValueError if it is none."""
        plain = dict(description["emitter"])
        kind = {each.__name__: each for each in (Dipole, Beam, Scalar)}[plain.pop("kind")]
        if isinstance(jones := plain.get("polarization"), list):
            plain["polarization"] = tuple(complex(*part) for part in jones)
        layers = description["layers"]
        numbers: Json = {name: validation.real(name, layers[name]) for name in _NUMBERS}
        films, paths = (tuple((float(n), float(t)) for n, t in layers[name]) for name in ("films", "paths"))
        exponent = tuple(validation.real_array("exponent", layers.get("exponent", ())).tolist())
        depth, focus, z = (validation.real_array(name, description[name]) for name in PLANES)
        magnification = validation.real("magnification", description["magnification"], above=0.0)
        measured = description.get("aberrations")
        aberrations = measured and Wavefront.from_dict(measured)
        of = Layers(**numbers, films=films, paths=paths, exponent=exponent)
        return cls(of, magnification, depth, focus, z, kind(**plain), aberrations)

    def __eq__(self, other: object) -> bool:
        """Return whether two pupils are the same."""
        return self.to_dict() == other.to_dict() if isinstance(other, ObjectivePupil) else NotImplemented

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        planes = "one plane" if not self.shape else f"{'x'.join(map(str, self.shape))} planes"
        ends = {
            name: (1e6 * float(at.min()), 1e6 * float(at.max()))
            for name, at in (("depth", self.depth), ("z", self.z))
        }
        spans = ", ".join(
            f"{name} {low:.4g} um" if low == high else f"{name} {low:.4g} to {high:.4g} um"
            for name, (low, high) in ends.items()
        )
        of = f"NA {self.layers.NA:g}, {1e9 * self.wavelength:g} nm"
        measured = f", {self.aberrations!r}" if self.aberrations else ""
        return f"<ObjectivePupil {of}, {planes}: {spans}, {self.emitter!r}{measured}>"


@lru_cache(maxsize=256)
def _power_at(layers: Layers, emitter: Emitter, depth: float) -> Array:
    light = light_of(emitter)
    return np.asarray(debye.power(layers, np.array([depth]), light.model)[0] @ light.shares)


PLANES = ("depth", "focus", "z")
_NUMBERS = ("NA", "immersion", "glass", "sample", "wavelength")
