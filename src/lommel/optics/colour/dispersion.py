"""Axial and lateral colour of a lens: focal length and image size as functions of the wavelength."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass, replace

import numpy as np
import scipy
from numpy.typing import ArrayLike

from lommel.base import validation
from lommel.base.arrays import Array, Json
from lommel.optics.base_pupil import BasePupil, Geometry
from lommel.optics.wavefront import wavefront
from lommel.optics.wavefront.wavefront import Wavefront


@dataclass(frozen=True, init=False)
class Colour:
    """Axial and lateral colour: focal length and image size of a lens, interpolated between known wavelengths.

    Parameters
    ----------
    wavelengths : sequence of float, shape (n,)
        Wavelengths, metres, rising, at least two. Interpolation is by cubic splines (not-a-knot), without
        extrapolation.
    focus_shift : sequence of float, shape (n,), optional
        Axial colour, metres: change of the focal length at each wavelength. Only the difference from the value at the
        wavelength of the lens matters.
    lateral : array_like, shape (n,) or (heights, n), optional
        Lateral colour, metres: radial shift of the image, away from the axis, at each wavelength. Only the difference
        from the value at the wavelength of the pupil matters.
    heights : float or sequence of float, optional
        Image heights of `lateral`, metres, rising from above 0. With one height the shift is proportional to the
        height, with several it is an odd cubic spline.

    Raises
    ------
    TypeError, ValueError
        If arguments are not numbers, do not rise, or differ in length.

    Notes
    -----
    The lens remains thin; sensor, stop and path differences of the aberrations do not change (no spherochromatism).

    Examples
    --------
    >>> import lommel as lm
    >>> colour = lm.Colour([450e-9, 550e-9, 650e-9], focus_shift=[60e-6, 0.0, 40e-6])
    >>> lens = lm.Lens(focal_length=50e-3, f_number=1.4, focus_distance=2.0, wavelength=550e-9, colour=colour)
    >>> round(lens.in_light(450e-9).focal_length * 1e3, 3)
    50.06
    """

    wavelengths: tuple[float, ...]
    focus_shift: tuple[float, ...]
    lateral: tuple[tuple[float, ...], ...]
    heights: tuple[float, ...]

    def __init__(
        self,
        wavelengths: ArrayLike,
        focus_shift: ArrayLike | None = None,
        lateral: ArrayLike | None = None,
        heights: ArrayLike | None = None,
    ) -> None:
        waves = validation.rising("wavelengths", wavelengths, count=2, unit="metres")
        for wave in waves:
            validation.wavelength(float(wave))
        shift = validation.real_array(
            "focus_shift", np.zeros(waves.size) if focus_shift is None else focus_shift, unit="m"
        )
        if shift.shape != waves.shape:
            raise ValueError(f"focus_shift must be one for each of {waves.size} wavelengths, got shape {shift.shape}")
        if (lateral is None) != (heights is None):
            raise ValueError("lateral and heights must be given together or not at all")
        shifts = np.zeros((0, waves.size)) if lateral is None else validation.real_array("lateral", lateral, unit="m")
        radii = np.zeros(0) if heights is None else validation.rising("heights", heights, unit="metres")
        if radii.size and not radii[0] > 0.0:
            raise ValueError(f"heights must be above 0, where there is no lateral colour, got {radii[0]:g}")
        shifts = np.atleast_2d(shifts)
        if shifts.shape != (radii.size, waves.size):
            raise ValueError(
                f"lateral must be of shape (heights, wavelengths), {(radii.size, waves.size)}, got {shifts.shape}"
            )
        vars(self).update(
            wavelengths=tuple(waves.tolist()),
            focus_shift=tuple(shift.tolist()),
            lateral=tuple(tuple(row) for row in shifts.tolist()),
            heights=tuple(radii.tolist()),
        )

    def shift(self, wavelength: float) -> float:
        """Return the change of focal length at a `wavelength`, metres; TypeError or ValueError outside the table."""
        return float(_interpolate(self._check_wavelength(wavelength), self.wavelengths, self.focus_shift))

    def shift_across(self, height: ArrayLike, wavelength: float) -> Array:
        """Return the radial shift of the image at distances `height` from the axis, at a `wavelength`, all in metres.

        TypeError or ValueError outside the table.
        """
        h, wave = validation.real_array("height", height, least=0.0, unit="m"), self._check_wavelength(wavelength)
        if not self.heights:
            return np.zeros(h.shape)
        if h.size and h.max() > self.heights[-1] * (1.0 + 1e-9):
            raise ValueError(
                f"lateral colour is known up to {self.heights[-1]:g} m from the axis, got {h.max():g} m; give "
                "larger heights"
            )
        shifts = [float(_interpolate(wave, self.wavelengths, row)) for row in self.lateral]
        radii = np.array(self.heights)
        # The shift is odd in the height: an odd spline has no kink on the axis.
        positions = np.concatenate([-radii[::-1], [0.0], radii])
        return np.asarray(_interpolate(h, positions, [-d for d in reversed(shifts)] + [0.0, *shifts]))

    def _check_wavelength(self, wavelength: float) -> float:
        wave, (first, *_, last) = validation.wavelength(wavelength), self.wavelengths
        if not first * (1.0 - 1e-9) <= wave <= last * (1.0 + 1e-9):
            raise ValueError(
                f"colour of the lens is known from {first * 1e9:g} to {last * 1e9:g} nm, got {wave * 1e9:g}; "
                "give more wavelengths"
            )
        return wave

    def to_dict(self) -> Json:
        """Return everything in plain types."""
        return asdict(self)

    @classmethod
    def from_dict(cls, description: Json) -> Colour:
        """Rebuild the object from a `description` by :meth:`to_dict`."""
        parts = dict(description)
        if not parts["heights"]:
            del parts["heights"], parts["lateral"]
        return cls(**parts)


@dataclass(frozen=True)
class PupilColour:
    """Change of a pupil with the wavelength: colour table, focal length minus shift, radius and model of the lens.

    x and y (metres on the sensor) are empty on the axis; otherwise each pupil of the flattened stack has a position.
    """

    table: Colour
    focal_length: float
    radius: float
    model: str = "paraxial"
    x: tuple[float, ...] = ()
    y: tuple[float, ...] = ()

    def at(self, x: Array, y: Array) -> PupilColour:
        """Return the colour of pupils at positions on the sensor."""
        if not self.table.heights:
            return self
        return replace(self, x=tuple(x.ravel().tolist()), y=tuple(y.ravel().tolist()))

    def each(self, shape: tuple[int, ...], of: Callable[[Array], Array]) -> PupilColour:
        """Return the colour with the function `of` applied to the positions of a stack of a `shape`."""
        if not self.x:
            return self
        return self.at(*(np.asarray(of(np.reshape(p, shape))) for p in (self.x, self.y)))

    def change(
        self, pupil: BasePupil, geometry: Geometry | None, wavelength: float
    ) -> tuple[Wavefront, Geometry | None]:
        """Return the change of the wavefront, besides constant path differences, and distances at a wavelength."""
        reference, shape = pupil.wavelength, pupil.shape
        assert reference is not None
        # Most images are at the wavelength of the pupil.
        if wavelength == reference:
            return Wavefront(), geometry
        # Only differences of focus shifts matter: the zero of the table is arbitrary.
        before, after = (self.focal_length + self.table.shift(w) for w in (reference, wavelength))
        new_geometry = geometry and replace(geometry, focal_length=geometry.focal_length + (after - before))
        chromatic = Wavefront()
        if after != before:
            # Change of C_d due to the focal length at the other wavelength.
            vergence = 1.0 / before - 1.0 / after
            if self.model == "paraxial":
                chromatic = Wavefront.of_defocus(0.5 * math.pi / wavelength * vergence * self.radius**2)
            elif geometry is None or new_geometry is None:
                raise ValueError(
                    "colour of an aplanatic lens needs its distances, which this pupil does not have; use pupils of "
                    'Lens.pupil, or of a grid with lens= and depths=, or a lens with model="paraxial"'
                )
            else:
                spheres = [(g.sphere, np.reshape(g.vergence, shape)) for g in (geometry, new_geometry)]
                phase_before, phase_after = (wavefront.wavefront(self.radius, a, v, wavelength) for a, v in spheres)
                chromatic = phase_after - phase_before
        if self.x:
            x, y = (np.reshape(p, shape) for p in (self.x, self.y))
            h = np.hypot(x, y)
            tilt = self.table.shift_across(h, wavelength) - self.table.shift_across(h, reference)
            # A shift of the image by r is a tilt of pi r / (lambda N) at the edge.
            tilt *= np.divide(math.pi / (pupil.scale * wavelength / reference), h, out=np.zeros(shape), where=h > 0.0)
            chromatic = chromatic + Wavefront(np.zeros(shape), nonradial={(1, 1): tilt * x, (1, -1): tilt * y})
        return chromatic, new_geometry

    def to_dict(self) -> Json:
        """Return everything in plain types."""
        return asdict(self)

    @classmethod
    def from_dict(cls, description: Json) -> PupilColour:
        """Rebuild the object from a `description` by :meth:`to_dict`."""
        parts = dict(description)
        x, y = (tuple(float(p) for p in parts.pop(name)) for name in ("x", "y"))
        return cls(Colour.from_dict(parts.pop("table")), x=x, y=y, **parts)


@dataclass(frozen=True)
class TracedColour:
    """Change of the pupil of a traced lens with the wavelength, interpolated between traced wavelengths.

    `paths` are path differences at the edge of the pupil, metres: a row for each wavelength (metres, rising), and a
    column for each Zernike term. With one wavelength, the pupil is known at this wavelength only.
    """

    wavelengths: tuple[float, ...]
    terms: tuple[tuple[int, int], ...] = ()
    paths: tuple[tuple[float, ...], ...] = ()

    def at(self, x: Array, y: Array) -> TracedColour:
        """Return the colour itself, which has no position."""
        return self

    def each(self, shape: tuple[int, ...], of: Callable[[Array], Array]) -> TracedColour:
        """Return the colour itself, which is common to all pupils of a stack."""
        return self

    def change(
        self, pupil: BasePupil, geometry: Geometry | None, wavelength: float
    ) -> tuple[Wavefront, Geometry | None]:
        """Return the change of the wavefront, besides constant path differences, and distances at a wavelength."""
        reference = pupil.wavelength
        assert reference is not None
        if wavelength == reference:
            return Wavefront(), geometry
        first, last = self.wavelengths[0], self.wavelengths[-1]
        if len(self.wavelengths) < 2:
            raise ValueError(
                f"the pupil of this traced lens is known at {first * 1e9:g} nm, not at {wavelength * 1e9:g} nm; pass "
                "band=(shortest, longest wavelength) to pupil() of the adapter, or compute a map for each wavelength"
            )
        if not first * (1.0 - 1e-9) <= wavelength <= last * (1.0 + 1e-9):
            raise ValueError(
                f"the pupil of this traced lens is known from {first * 1e9:g} to {last * 1e9:g} nm, got "
                f"{wavelength * 1e9:g}; pass a wider band"
            )
        after, before = _interpolate(np.array([wavelength, reference]), self.wavelengths, self.paths)
        radians = 2.0 * math.pi / wavelength * (after - before)
        return Wavefront.zernike(dict(zip(self.terms, radians, strict=True)), normalization="edge"), geometry

    def to_dict(self) -> Json:
        """Return everything in plain types."""
        return asdict(self)

    @classmethod
    def from_dict(cls, description: Json) -> TracedColour:
        """Rebuild the object from a `description` by :meth:`to_dict`."""
        terms = tuple((int(n), int(m)) for n, m in description["terms"])
        paths = tuple(tuple(float(path) for path in row) for row in description["paths"])
        return cls(tuple(float(wave) for wave in description["wavelengths"]), terms, paths)


def colour_from_dict(description: Json) -> PupilColour | TracedColour:
    """Rebuild the colour of a pupil from a `description` by its method ``to_dict``."""
    return (PupilColour if "table" in description else TracedColour).from_dict(description)


def _interpolate(x: float | Array, points: Sequence[float] | Array, values: ArrayLike) -> Array:
    """Return a spline through `values` at `points`: cubic, or a line or parabola through two or three values."""
    size = points[-1] - points[0]
    spline: Array = scipy.interpolate.CubicSpline((np.asarray(points) - points[0]) / size, values)(
        (np.asarray(x) - points[0]) / size
    )
    return spline
