"""The aperture, the wavefront across it, and the physical scale of the image."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field, fields, replace
from functools import lru_cache
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lommel.base import validation
from lommel.base.arrays import Array, Json
from lommel.base.cached import cached_property, changed
from lommel.base.units import format_length
from lommel.optics.aperture.apodization import Apodization, illumination
from lommel.optics.base_pupil import BasePupil, Geometry, OfEach, not_a_pupil
from lommel.optics.wavefront.wavefront import Wavefront, same_path
from lommel.special import zernike

if TYPE_CHECKING:  # most pupils are round, and need none of these
    from lommel.core.engine import RowRule
    from lommel.optics.aperture.mask import Mask
    from lommel.optics.aperture.opening import Opening, Rule
    from lommel.optics.aperture.shapes import CatEye, Ellipse, Segments, Shape, Spider
    from lommel.optics.colour.dispersion import PupilColour, TracedColour


@dataclass(frozen=True, repr=False)
class Pupil(BasePupil):
    """Pupil of a lens: aperture (by default circular or annular), wavefront and amplitude.

    Parameters
    ----------
    wavefront : Wavefront
        Phase; a stack of wavefronts gives a stack of pupils.
    obscuration : float, default 0
        Ratio of the radii of the central obscuration and the aperture, 0 to below 1.
    wavelength : float, optional
        Wavelength, metres. With `f_number`, lengths on the sensor are in metres; without both, in units of lambda*N.
    f_number : float, optional
        Working f-number N: sensor distance divided by aperture diameter.
    apodization : float or Apodization, default 0
        Amplitude across the aperture, for all pupils of a stack. A number g, 0 to 100, is a Gaussian
        ``exp(-g rho^2)``: a laser beam of 1/e amplitude radius w, truncated at the radius a, has ``g = (a / w)^2``.
        See :attr:`lommel.methods.Method.apodized` for the methods that support it.
    geometry : Geometry, optional
        Distances, set by :meth:`lommel.Lens.pupil`; needed by ``HuygensFresnel`` only.
    spider : Spider, optional
        Radial vanes of equal width. For other vanes subtract strips from a `stop`.
    vignetting : Ellipse or CatEye, optional
        Vignetting by a second edge.
    mask : Mask, optional
        Amplitude transmission and phase, sampled over the aperture; these samples then represent the pupil function.
    stop : Shape or Segments, optional
        Clear region within the unit disc, by default all of it: a shape, or segments with phases, whose path
        differences are independent of wavelength. See ``lommel.telescopes`` for the apertures of telescopes.
    colour : PupilColour or TracedColour, optional
        Change of wavefront and distances with the wavelength, set by a :class:`lommel.Lens` with colour, or by an
        adapter to the wavelengths at which it traced the lens.

    Attributes
    ----------
    illumination : Apodization
        The apodization; a Gaussian if it was given as a number.
    circular : bool
        True for a circular or annular aperture, without spider, vignetting, mask and stop.
    radial : bool
        True if phase and transmission depend on the distance from the axis only.
    aperture : tuple
        Obscuration, illumination, spider, vignetting, mask and stop.

    Raises
    ------
    TypeError, ValueError
        If an argument is not finite or out of range, only one of `wavelength` and `f_number` is given, or no light
        passes through the aperture.
    """

    wavefront: Wavefront = field(default_factory=Wavefront)
    obscuration: float = field(default=0.0, kw_only=True)
    wavelength: float | None = field(default=None, kw_only=True)
    f_number: float | None = field(default=None, kw_only=True)
    apodization: float | Apodization = field(default=0.0, kw_only=True)
    geometry: Geometry | None = field(default=None, kw_only=True)
    spider: Spider | None = field(default=None, kw_only=True)
    vignetting: Ellipse | CatEye | None = field(default=None, kw_only=True)
    mask: Mask | None = field(default=None, kw_only=True)
    stop: Shape | Segments | None = field(default=None, kw_only=True)
    colour: PupilColour | TracedColour | None = field(default=None, kw_only=True)
    illumination: Apodization = field(init=False, repr=False, compare=False)
    circular: bool = field(init=False, repr=False, compare=False)
    # Fields, not properties, for speed: a PSF takes microseconds and reads them several times.
    radial: bool = field(init=False, repr=False, compare=False)
    aperture: tuple[object, ...] = field(init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        validation.instance("wavefront", self.wavefront, Wavefront)
        validation.optional("geometry", self.geometry, Geometry)
        eps = validation.real("obscuration", self.obscuration, least=0.0, below=1.0)
        amplitude = illumination(self.apodization)
        parameters = amplitude if isinstance(self.apodization, Apodization) else amplitude.slope
        vars(self).update(obscuration=eps, illumination=amplitude, apodization=parameters)
        if (self.wavelength is None) != (self.f_number is None):
            raise ValueError(
                "wavelength and f_number must be given together (sensor in metres) or not at all "
                f"(sensor in lambda*N), got wavelength={self.wavelength!r}, f_number={self.f_number!r}"
            )
        if self.wavelength is not None:
            wavelength = validation.wavelength(self.wavelength)
            vars(self).update(wavelength=wavelength, f_number=validation.real("f_number", self.f_number, above=0.0))
        circular = all(part is None for part in (self.spider, self.vignetting, self.mask, self.stop))
        aperture = eps, amplitude, self.spider, self.vignetting, self.mask, self.stop
        vars(self).update(circular=circular, radial=circular and self.wavefront.radial, aperture=aperture)
        if circular:
            return
        from lommel.optics.aperture.mask import Mask

        validation.optional("mask", self.mask, Mask)  # Opening checks the other parts
        if self.area < 1e-12:
            parts = {name: part for name in _PARTS[:4] if (part := getattr(self, name)) is not None}
            listed = ", ".join(f"{name}={part!r}" for name, part in parts.items())
            raise ValueError(
                f"{', '.join(parts)} must leave part of the aperture clear, got {listed} with "
                f"obscuration={self.obscuration:g}"
            )

    @property
    def shape(self) -> tuple[int, ...]:
        """Shape of the stack; ``()`` for a single pupil."""
        return self.wavefront.shape

    def __repr__(self) -> str:
        parts = [f"{'x'.join(map(str, self.shape))} pupils"] if self.shape else []
        if self.wavelength is not None and self.f_number is not None:
            parts += [f"f/{self.f_number:.4g}", format_length(self.wavelength)]
        parts.append(self.wavefront.in_words())
        parts += [f"obscuration {self.obscuration:.4g}"] if self.obscuration else []
        parts += [] if self.illumination.uniform else [repr(self.illumination)]
        shapes = ("spider", "vignetting", "mask", "stop", "colour")
        parts += [name for name in shapes if getattr(self, name) is not None]
        return f"<{type(self).__name__} {', '.join(parts)}>"

    # Cached properties may depend on the aperture only: `carrying` copies them to pupils with other wavefronts.

    @property
    def within_disc(self) -> bool:
        """True without a mask: the modulus of the pupil function is then at most 1 on the unit disc and 0 outside."""
        return self.mask is None

    @cached_property
    def area(self) -> float:
        """Clear area relative to the unobscured aperture, weighted by the amplitude of a mask."""
        return self._integral(0.0)

    @cached_property
    def amplitude(self) -> float:
        """Field at the unaberrated peak, ``(1/pi) int A dx dy`` of the amplitude A, to about 1e-13."""
        return self._integral(1.0)

    @cached_property
    def transmission(self) -> float:
        """Transmitted light, ``(1/pi) int A^2 dx dy`` of the amplitude A, averaged over each cell of a mask."""
        return self._integral(2.0)

    @property
    def period(self) -> float:
        """Period of the image along x and y, in lambda*N: samples per side of a sampled mask, or infinity."""
        return math.inf if self.mask is None or self.mask.squares else float(self.mask.side)

    def _integral(self, power: float) -> float:
        if not self.circular:
            return _moment(self.opening, self.mask, self.illumination, power)
        return self.illumination.integral(self.obscuration, power)

    @property
    def segmented(self) -> bool:
        """True if segments of the aperture have different phases."""
        return self.stop is not None and bool(np.any(self.opening.phases))

    @property
    def phase_mask(self) -> bool:
        """True if there is a complex mask."""
        return self.mask is not None and self.mask.values.dtype.kind == "c"

    @cached_property
    def opening(self) -> Opening:
        """The clear region, without a mask."""
        from lommel.optics.aperture.opening import Opening

        return Opening(self.obscuration, self.spider, self.vignetting, self.stop)

    @property
    def strips(self) -> tuple[float, Array] | None:
        """Obscuration of an annulus and strips that vanes cut out of it, see `Opening.strips`; None of others."""
        none = self.circular or self.mask is not None or (self.spider is None and self.stop is None)
        return None if none else self.opening.strips

    def rule(self, degree: int) -> Rule:
        """Return nodes and weights of ``(1/pi) int dx dy`` over the clear aperture, for polynomials of a `degree`.

        See :meth:`lommel.optics.aperture.opening.Opening.rule`; nodes of a mask are its samples, weighted by
        amplitude.
        """
        return self.opening.rule(degree) if self.mask is None else _samples(self.opening, self.mask)

    @property
    def samples(self) -> tuple[RowRule, ...]:
        """Samples of the mask in the layout of the compiled core."""
        assert self.mask is not None
        return (_sampled_rows(self.opening, self.mask),)

    @property
    def likely_peak(self) -> float:
        """Estimate of the lowest peak: the field U is roughly inversely proportional to the phase over the pupil."""
        size = float(np.abs(self.radial_terms()).sum(axis=1).max())
        return (self.amplitude / (1.0 + 2.0 * size)) ** 2

    @property
    def likely_strehl(self) -> float:
        """Estimate of the lowest Strehl ratio, from the phase variance over the disc."""
        # Terms are orthogonal on the disc: variances add. The limit prevents overflow.
        edge = np.minimum(np.abs(self.wavefront.edge), 1e6)
        return float(1.0 / (1.0 + ((edge * edge) @ _variances(self.wavefront.terms)).max()))

    @property
    def left_out(self) -> tuple[float, float]:
        """Bounds on the truncation errors of phase (radians) and amplitude."""
        return self.wavefront.left_out, self.illumination.error

    def in_light(self, wavelength: float) -> Pupil:
        """Return the pupil at another `wavelength` (metres), with the same aperture, f-number and path differences.

        Lens colour changes the path differences, see :class:`lommel.Colour`. TypeError or ValueError if the
        wavelength is out of range, or the pupil has none.
        """
        wavelength = validation.wavelength(wavelength)
        if self.wavelength is None:
            raise ValueError("wavelength and f_number of the pupil must be given to change the wavelength, got None")
        if self.phase_mask and wavelength != self.wavelength:
            raise ValueError(
                "mask must be real to change the wavelength of the pupil: phases of a complex mask hold at one "
                "wavelength; add images of pupils with a mask for each wavelength"
            )
        wavefront, geometry = same_path(self.wavefront, self.wavelength, wavelength), self.geometry
        if self.colour is not None:
            change, geometry = self.colour.change(self, self.geometry, wavelength)
            wavefront = wavefront + change
        pupil = self.carrying(wavefront, geometry, wavelength)
        if not self.segmented:
            return pupil
        return replace(pupil, stop=self.stop.scaled(self.wavelength / wavelength))  # type: ignore[union-attr]

    def coefficients(self) -> NDArray[np.float64]:
        """Return the phase coefficients of t = rho^2 for the flattened stack, shape ``(n, terms)``."""
        c = self.wavefront.coefficients
        return c.reshape(-1, c.shape[-1])

    def radial_terms(self) -> NDArray[np.float64]:
        """Return the coefficients of R_2^0, R_4^0, ... for the flattened stack, shape ``(n, terms)``."""
        terms = self.wavefront.radial_terms
        return terms[None] if terms.ndim == 1 else terms.reshape(-1, terms.shape[-1])

    def radial_phase(self, t: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return the radial part of the phase at `t` = rho^2, shape ``(n, ...)``; TypeError or ValueError for NaN."""
        return zernike.legendre_sum(self.radial_terms(), 2.0 * validation.real_array("t", t) - 1.0)

    def values(self, x: ArrayLike, y: ArrayLike) -> NDArray[np.complex128]:
        """Return the pupil function ``A exp(i phase)``, 0 outside the clear aperture; masks are constant in cells.

        Parameters
        ----------
        x, y : array_like
            Pupil coordinates divided by the radius of the aperture; x increases with the columns of the image, y with
            the rows.

        Returns
        -------
        ndarray, shape ``(n, ...)``
            Values of the flattened stack at the points (x, y), which broadcast.

        Raises
        ------
        TypeError, ValueError
            If coordinates are not real and finite.
        """
        px, py = np.broadcast_arrays(validation.real_array("x", x), validation.real_array("y", y))
        rho = np.hypot(px, py)
        in_aperture = self.opening.margin(px, py) >= 0.0
        function = np.zeros((math.prod(self.shape), *rho.shape), dtype=np.complex128)
        radii = rho[in_aperture]
        phase = self.wavefront.phase(radii, np.arctan2(py[in_aperture], px[in_aperture])).reshape(len(function), -1)
        if self.segmented:
            phase = phase + self.opening.phase(px[in_aperture], py[in_aperture])
        function[:, in_aperture] = self.illumination.at(radii**2) * np.exp(1j * phase)
        if self.mask is not None:
            function *= self.mask.at(px, py)
        return function

    def geometric_radius(self) -> NDArray[np.float64]:
        """Return the largest distance of a ray from the axis on the sensor, from ``max abs(grad phase)``."""
        rho = np.linspace(self.obscuration, 1.0, 2049)
        if self.radial:
            blur = np.abs(ray_height(self.radial_terms(), rho)).max(axis=1)
        elif self.circular or self.strips is not None:  # vanes hide few rays: those of the annulus
            theta = np.linspace(0.0, 2.0 * math.pi, 128, endpoint=False)
            ring = rho[:: 2048 // 64]
            blur = self._longest_gradient(np.outer(ring, np.cos(theta)), np.outer(ring, np.sin(theta)))
        elif self.wavefront.flat and not self.segmented:
            blur = np.zeros(1)
        else:
            blur = self._longest_gradient(*self._raster())
        # From optical coordinates v to distances on the sensor: r = v lambda N / pi.
        return np.asarray(blur.reshape(self.shape) * (self.scale / math.pi))

    def _raster(self) -> NDArray[np.float64]:
        """Return a raster of points in the clear aperture, with the slopes of segments at the points."""
        raster = self.opening.raster()
        if self.mask is None:
            return raster
        open_points = np.abs(self.mask.at(*raster[:2])) > 0.0
        if open_points.any():
            return raster[:, open_points]
        # Narrow openings may lie between the points of the raster; nodes of a quadrature rule are always inside.
        x, y = self.rule(0)[:2]
        return np.stack([x, y, *self.opening.tilted(x, y)[1:]])

    def _longest_gradient(
        self, x: Array, y: Array, tip: float | Array = 0.0, tilt: float | Array = 0.0
    ) -> NDArray[np.float64]:
        """Return ``max abs(grad Phi)`` over points, (n,), by central differences, with the slopes of segments."""
        h = 1e-6

        def phase(dx: float, dy: float) -> NDArray[np.float64]:
            return self.wavefront.phase(np.hypot(x + dx, y + dy), np.arctan2(y + dy, x + dx)).reshape(-1, x.size)

        across, down = ((phase(*d) - phase(-d[0], -d[1])) / (2.0 * h) for d in ((h, 0.0), (0.0, h)))
        return np.asarray(np.hypot(across + tip, down + tilt).max(axis=1))

    def carrying(self, wavefront: Wavefront, geometry: Geometry | None, wavelength: float | None = None) -> Pupil:
        """Return a copy with other wavefront, geometry and wavelength; TypeError if `wavefront` is no Wavefront."""
        validation.instance("wavefront", wavefront, Wavefront)
        return changed(
            self,
            wavefront=wavefront,
            geometry=geometry,
            radial=self.circular and wavefront.radial,
            wavelength=wavelength or self.wavelength,
        )

    def unaberrated(self) -> Pupil:
        """Return the same aperture, in focus and without aberration."""
        pupil = self.carrying(Wavefront(), self.geometry and self.geometry.focused())
        if self.segmented:
            pupil = replace(pupil, stop=self.stop.scaled(0.0))  # type: ignore[union-attr]
        if self.phase_mask:
            mask = self.mask
            assert mask is not None
            # Moduli may exceed 1 by a rounding error.
            pupil = replace(pupil, mask=type(mask)(np.minimum(np.abs(mask.values), 1.0), mask.squares))
        return pupil

    def _each(self, of: OfEach) -> Pupil:
        wavefront, geometry, colour = of(self.wavefront), self.geometry, self.colour
        if geometry is not None:
            distances = of(np.reshape(geometry.distances, self.shape))
            geometry = replace(geometry, object_distance=tuple(np.ravel(distances).tolist()))
        return changed(self.carrying(wavefront, geometry), colour=colour and colour.each(self.shape, of))

    def to_dict(self) -> Json:
        """Return everything in plain types; :meth:`from_dict` is the inverse."""
        values = {item.name: getattr(self, item.name) for item in fields(self) if item.init}
        entries = {name: value for name, value in values.items() if value is not None or name not in _PARTS}
        return {name: value.to_dict() if hasattr(value, "to_dict") else value for name, value in entries.items()}

    @classmethod
    def from_dict(cls, description: Json) -> Pupil:
        """Rebuild a pupil from a `description` by :meth:`to_dict`."""
        from lommel.optics.aperture.mask import Mask
        from lommel.optics.aperture.shapes import shape_from_dict
        from lommel.optics.colour.dispersion import colour_from_dict

        parts = dict(description)
        builds = (shape_from_dict, shape_from_dict, Mask.from_dict, shape_from_dict, colour_from_dict)
        built: dict[str, Callable[[Json], object]] = dict(zip(_PARTS, builds, strict=True))
        built |= {"geometry": Geometry.from_dict, "apodization": Apodization.from_dict}
        for name, build in built.items():
            if isinstance(parts.get(name), dict):
                parts[name] = build(parts[name])
        return cls(Wavefront.from_dict(parts.pop("wavefront")), **parts)


_PARTS = ("spider", "vignetting", "mask", "stop", "colour")


@lru_cache(maxsize=64)
def _variances(terms: tuple[tuple[int, int], ...]) -> Array:
    """Return the variances over the disc of Zernike terms that are 1 at the edge."""
    return np.array([zernike.rms_factor(n, m) ** -2.0 for n, m in terms])


@lru_cache(maxsize=8)
def _samples(opening: Opening, mask: Mask) -> Rule:
    """Return the cells of a mask inside the aperture; weights are amplitude times covered area / pi."""
    from lommel.optics.aperture.mask import cell_centers
    from lommel.optics.aperture.opening import Rule

    centers = cell_centers(mask.side)
    covered = opening.coverage(centers[None, :], centers[:, None], 1.0 / mask.side)
    # Amplitude times covered area: certificate, section 18, "The light of a mask".
    weight = np.abs(mask.values) * np.where(covered > 1e-9, covered, 0.0)  # smaller fractions are rounding errors
    rows, columns = np.nonzero(weight)
    return Rule(centers[columns], centers[rows], weight[rows, columns] * (4.0 / (math.pi * mask.side**2)))


@lru_cache(maxsize=8)
def _sampled_rows(opening: Opening, mask: Mask) -> RowRule:
    from lommel.core.engine import row_samples

    x, y, weight = _samples(opening, mask)
    phase = opening.phase(x, y) + np.angle(mask.at(x, y))
    return row_samples(x, y, weight, phase if np.any(phase) else None)


@lru_cache(maxsize=64)
def _moment(opening: Opening, mask: Mask | None, apodization: Apodization, power: float) -> float:
    """Return ``(1/pi) int (T A)^power dx dy`` for amplitudes T (mask) and A (apodization); power 0: ``int T``."""
    if mask is None:
        from lommel.optics.aperture.opening import degree_needed

        # The rule is exact for a polynomial that approximates the amplitude to 1e-14.
        x, y, weight = opening.rule(degree_needed([], 0.0, apodization, 1e-14, power=power))
    else:
        x, y, weight = _samples(opening, mask)
        # The amplitude of a cell is that of the mask times the covered fraction; `power` applies to the product.
        weight = weight * (0.25 * math.pi * mask.side**2 * weight) ** (max(power, 1.0) - 1.0)
    return float(weight @ apodization.at(x * x + y * y, power))


def ray_height(terms: NDArray[np.float64], rho: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return ``dPhi/drho`` at `rho`, the signed ray height in v, from coefficients of R_2^0, R_4^0, ..."""
    return 4.0 * rho * zernike.legendre_slope(terms, 2.0 * rho * rho - 1.0)


def checked(pupil: object) -> Pupil:
    """Return `pupil` if it is the pupil of a lens; TypeError with a hint otherwise."""
    if isinstance(pupil, Pupil):
        return pupil
    raise not_a_pupil(pupil)


_SEVERAL_APERTURES = "pupil must have one aperture, got one for each position; index the stack"


@dataclass(frozen=True)
class FieldPupil(BasePupil):
    """Pupils with equal scale and different apertures, flattened in C order; `places` is the shape of the stack."""

    pupils: tuple[Pupil, ...]
    places: tuple[int, ...]
    wavelength: float | None = field(init=False, repr=False, compare=False)
    f_number: float | None = field(init=False, repr=False, compare=False)
    illumination: Apodization = field(init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        for pupil in self.pupils:
            validation.instance("pupils", pupil, Pupil)
        scales = {(pupil.shape, pupil.wavelength, pupil.f_number) for pupil in self.pupils}
        if len(self.pupils) != math.prod(self.places) or len(scales) != 1 or scales.pop()[0] != ():
            raise ValueError(f"pupils must be single pupils of one scale, one for each place of shape {self.places}")
        for name in ("wavelength", "f_number", "illumination"):
            object.__setattr__(self, name, getattr(self.pupils[0], name))

    @property
    def shape(self) -> tuple[int, ...]:
        """Shape of the stack."""
        return self.places

    radial = False
    one_aperture = False

    @property
    def circular(self) -> bool:
        """True if all apertures are circular or annular."""
        return all(pupil.circular for pupil in self.pupils)

    @property
    def aperture(self) -> tuple[object, ...]:
        """Raise ValueError: each pupil has its own aperture."""
        raise ValueError(_SEVERAL_APERTURES)

    @property
    def amplitude(self) -> float:
        """Raise ValueError: each pupil has its own amplitude."""
        raise ValueError(_SEVERAL_APERTURES)

    @property
    def transmission(self) -> Array:  # type: ignore[override]
        """Transmitted light of each pupil, an array with the shape of the stack."""
        return np.reshape([pupil.transmission for pupil in self.pupils], self.shape)

    @property
    def period(self) -> float:
        """Shortest period of the stack."""
        return min(pupil.period for pupil in self.pupils)

    @property
    def likely_peak(self) -> float:
        """Lowest estimate of the stack."""
        return min(pupil.likely_peak for pupil in self.pupils)

    def geometric_radius(self) -> NDArray[np.float64]:
        """Return the largest distance of a ray from the axis on the sensor, an array with the shape of the stack."""
        return np.reshape([float(pupil.geometric_radius()) for pupil in self.pupils], self.shape)

    def _each(self, of: OfEach) -> Any:
        indices = of(np.arange(len(self.pupils)).reshape(self.shape))
        if indices.ndim == 0:
            return self.pupils[int(indices)]
        return FieldPupil(tuple(self.pupils[k] for k in indices.ravel()), indices.shape)

    def in_light(self, wavelength: float) -> FieldPupil:
        """Return the pupils at another `wavelength`, metres."""
        return FieldPupil(tuple(pupil.in_light(wavelength) for pupil in self.pupils), self.shape)

    def to_dict(self) -> Json:
        """Return everything in plain types; :meth:`from_dict` is the inverse."""
        return {"shape": list(self.shape), "pupils": [pupil.to_dict() for pupil in self.pupils]}

    @classmethod
    def from_dict(cls, description: Json) -> FieldPupil:
        """Rebuild the pupils from a `description` by :meth:`to_dict`."""
        return cls(tuple(Pupil.from_dict(part) for part in description["pupils"]), tuple(description["shape"]))
