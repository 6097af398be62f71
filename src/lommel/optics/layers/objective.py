"""Microscope objectives: pupils, focal fields, best focus and sampling."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import NamedTuple

import numpy as np
import scipy
from numpy.typing import ArrayLike, NDArray

from lommel.base import validation
from lommel.base.arrays import Array, Numbers, numbers
from lommel.base.units import format_length
from lommel.optics.aperture.apodization import Apodization, illumination
from lommel.optics.layers import debye, projection
from lommel.optics.layers.debye import Model
from lommel.optics.layers.emitter import Beam, Dipole, Scalar, emitter_of
from lommel.optics.layers.objective_pupil import ObjectivePupil
from lommel.optics.layers.stratified import (
    DEPTH_MOST,
    Design,
    Layer,
    Layers,
    cosines,
    depths,
    film_stack,
    length,
    refractive_index,
)
from lommel.optics.wavefront.wavefront import Wavefront
from lommel.special import zernike

SURFACE = ("x", "y", "xx", "xy", "yy")
"""Terms of a focal surface."""


@dataclass(frozen=True)
class FocalSurface:
    """Focal surface over the frame of a camera: z of beads on a flat glass, a polynomial of the second degree.

    With x along columns and y along rows, -1 to 1 between the outer edges of the frame, z from the middle is
    the sum of the terms, each a coefficient times its products of x and y.

    Parameters
    ----------
    frame : (int, int)
        Rows and columns of the frame.
    terms : mapping
        Coefficients by name, "x", "y", "xx", "xy" and "yy", metres of the stage; by default 0.

    Raises
    ------
    TypeError, ValueError
        If `frame` is not a pair of positive integers, or a term not one of these or not finite.
    """

    frame: tuple[int, int]
    terms: Mapping[str, float]

    def __post_init__(self) -> None:
        terms = {
            validation.choice("terms", name, SURFACE): validation.real(name, z) for name, z in self.terms.items()
        }
        vars(self).update(frame=validation.image_shape(self.frame, "frame"), terms=terms)

    def z(self, row: Array, column: Array) -> Array:
        """Return the surface at pixels, metres; 0 is the middle of the first pixel."""
        y, x = ((2.0 * place + 1.0) / side - 1.0 for place, side in zip((row, column), self.frame, strict=True))
        return np.asarray(sum(z * x ** name.count("x") * y ** name.count("y") for name, z in self.terms.items()))


@dataclass(frozen=True, eq=False)
class FocalField:
    """Vectorial field of a microscope, expressed by three integrals K0, K1, K2.

    A fixed dipole p, with z towards the objective and phi the azimuth on the camera, has the field
    ``Ex = p_x (K0 + K2 cos 2 phi) + p_y K2 sin 2 phi - 2i p_z K1 cos phi`` and
    ``Ey = p_x K2 sin 2 phi + p_y (K0 - K2 cos 2 phi) - 2i p_z K1 sin phi``; a beam polarized along x has
    ``E = (K0 + K2 cos 2 phi, K2 sin 2 phi, -2i K1 cos phi)`` in the sample.

    Parameters
    ----------
    K0, K1, K2 : ndarray of complex, shape planes + radii
        Integrals with Bessel functions of order 0, 1 and 2.
    error : float
        Bound on the error of each value: proven for the quadrature, with an allowance for rounding.
    """

    K0: NDArray[np.complex128]
    K1: NDArray[np.complex128]
    K2: NDArray[np.complex128]
    error: float

    @property
    def intensity(self) -> Array:
        """Intensity of a freely rotating dipole or of unpolarized light, abs(K0)^2 + 2 abs(K1)^2 + abs(K2)^2."""
        return np.asarray(np.abs(self.K0) ** 2 + 2.0 * np.abs(self.K1) ** 2 + np.abs(self.K2) ** 2)

    @property
    def intensity_error(self) -> Array:
        """Bound on the error of each `intensity`, ``4 error sqrt(intensity) + 4 error^2``."""
        return np.asarray(4.0 * self.error * (np.sqrt(self.intensity) + self.error))


@dataclass(frozen=True, eq=False)
class Focus:
    """Focus of an emitter at one or several depths.

    Parameters
    ----------
    depth : float or ndarray
        Distance of the emitter from the glass, metres.
    paraxial, brightest : float or ndarray
        Stage positions of the paraxial focus and of the maximum intensity on the axis, metres towards the sample,
        relative to the paraxial focus on the surface of the glass.
    peak : float or ndarray
        Intensity at the brightest focus, for unpolarized light of uniform amplitude in the aperture, relative to
        scalar theory without surfaces: ``abs(K0)^2`` of :meth:`Objective.fields`. By reciprocity, the images of a
        freely rotating dipole of constant moment have peaks of the same ratios.
    axial_fwhm, lateral_fwhm : float or ndarray
        Full widths at half maximum at the brightest focus, metres of stage travel and metres in the sample.
    """

    depth: Numbers
    paraxial: Numbers
    brightest: Numbers
    peak: Numbers
    axial_fwhm: Numbers
    lateral_fwhm: Numbers

    @property
    def ratio(self) -> Numbers:
        """Axial scaling factor, depth / (stage position of the brightest focus); NaN at depth 0."""
        with np.errstate(invalid="ignore", divide="ignore"):
            ratio: Numbers = np.where(np.asarray(self.depth) > 0.0, np.divide(self.depth, self.brightest), np.nan)[()]
        return ratio


@dataclass(frozen=True)
class Nyquist:
    """Nyquist sampling intervals, metres.

    Parameters
    ----------
    lateral, axial : float
        Largest pixel in the sample, and largest step of the stage.
    pixel : float
        Largest pixel on the camera, `lateral` times the magnification.
    """

    lateral: float
    axial: float
    pixel: float


_TOL = 1e-11  # tolerance of field integrals in searches of the focus
_RATE_STEP = 0.5e-6  # metres of depth over which the travel of the focus is averaged, on both sides
_STEPS = 16  # steps of a search per depth of focus, see _depth_of_focus(), or laterally per 2 pi in v
_RADII = 64  # number of radii at which a wavefront is averaged over the pupil
_DOUBLINGS = 6  # number of ranges that a search tries, each with a margin twice as large
_ISOTROPIC_WEIGHTS = emitter_of("isotropic").light.shares  # weights of K0, K1, K2 for a freely rotating dipole
_DISTANCE_MOST = 0.1  # largest working distance, metres
_VALUES_MOST = 2**26  # largest product of the numbers of radii and planes
_ORIGINS = ("coverslip", "paraxial", "brightest")


@dataclass(frozen=True, init=False)
class Objective:
    r"""Microscope objective with its immersion, cover glass and sample; all lengths are in metres.

    The plane layers are sample | films | cover glass | immersion | objective. Every ray has the same ``NA rho = n
    sin(theta)`` in all layers, with rho from 0 to 1 across the pupil. In methods, `depth` is the distance of an
    emitter from the glass (or from the last film). `focus` is the stage position: the travel of the objective towards
    the sample, relative to the paraxial focus on the cover glass.

    Parameters
    ----------
    NA : float
        Numerical aperture, below the indices of immersion and cover glass. If it exceeds the index of the sample, the
        PSF includes supercritical light, which decays with the depth.
    magnification : float, default 1
        Lateral magnification from the sample to the camera. With 1, pixel sizes refer to the sample.
    immersion : float
        Refractive index of the immersion medium.
    working_distance : float, optional
        Distance from the objective to the cover glass for design conditions and a focus on the surface of the glass.
        Required with a cover glass or a `design`; without it the stage travel is limited to 0.01 metres.
    coverslip : Layer, optional
        Cover glass; by default none (dipping objective).
    sample : float, optional
        Refractive index of the sample. Required with a cover glass; by default the index of the immersion.
    films : sequence of Layer, default none
        Coherent thin films from the cover glass to the sample, each of at most 2 um. Multiple reflections in the
        thick glass are ignored.
    design : Design, optional
        Media that the objective was corrected for; by default the actual immersion and cover glass.
    apodization : float or Apodization, default 0
        Amplitude transmission of the objective at the pupil radius rho, in addition to the effects of surfaces, films
        and the sine condition. A number g means ``exp(-g rho^2)``. A constant factor has no effect, because
        intensities are relative to the collected light.

    Raises
    ------
    TypeError, ValueError
        If an argument is missing, not finite or out of range.

    References
    ----------
    S. F. Gibson and F. Lanni, J. Opt. Soc. Am. A 9, 154 (1992), doi:10.1364/JOSAA.9.000154.

    Examples
    --------
    >>> objective = Objective(
    ...     NA=1.4,
    ...     magnification=63,
    ...     immersion=1.518,
    ...     working_distance=0.19e-3,
    ...     coverslip=Layer(1.5255, 170e-6),
    ...     sample=1.33,
    ... )
    >>> round(1e6 * float(objective.focus(2e-6, wavelength=520e-9).brightest), 2)
    2.65

    One medium, with pixels in the sample:

    >>> oil = Objective(NA=1.4, immersion=1.518)
    >>> oil.sample, oil.magnification
    (1.518, 1.0)
    """

    pupil_hint = "an Objective; objective.pupil(depth=..., wavelength=...) is its pupil"

    NA: float
    magnification: float
    immersion: float
    working_distance: float | None
    coverslip: Layer | None
    sample: float
    films: tuple[Layer, ...]
    design: Design
    apodization: float | Apodization

    def __init__(
        self,
        *,
        NA: float,
        magnification: float = 1.0,
        immersion: float,
        working_distance: float | None = None,
        coverslip: Layer | None = None,
        sample: float | None = None,
        films: Iterable[Layer] = (),
        design: Design | None = None,
        apodization: float | Apodization = 0.0,
    ) -> None:
        validation.optional("coverslip", coverslip, Layer)
        validation.optional("design", design, Design)
        n = refractive_index("immersion", immersion)
        aperture = validation.real("NA", NA, least=1e-3)
        design_media = design or Design(n, coverslip)
        media = {"immersion": n, "design.immersion": design_media.immersion}
        glasses = {"coverslip": coverslip, "design.coverslip": design_media.coverslip}
        media |= {name: glass.index for name, glass in glasses.items() if glass}
        for name, index in media.items():
            if not aperture < index:
                raise ValueError(f"NA must be below the index of {name}, {index:g}, got {aperture:g}")
        if sample is None and coverslip:
            raise ValueError("sample must be given with a coverslip: the refractive index around the emitter")
        if working_distance is None and (coverslip or design_media != Design(n, coverslip)):
            raise ValueError("working_distance must be given, in metres, with a coverslip or a design")
        if working_distance is not None:
            working_distance = length("working_distance", working_distance, _DISTANCE_MOST, positive=True)
        transmission = illumination(apodization)
        if transmission.error:
            raise ValueError("apodization must be exact, a sum of powers of rho^2, got a truncated series")
        values = {
            "NA": aperture,
            "magnification": validation.real("magnification", magnification, least=1e-3, below=1e6),
            "immersion": n,
            "working_distance": working_distance,
            "coverslip": coverslip,
            "sample": n if sample is None else refractive_index("sample", sample),
            "films": film_stack(films),
            "design": design_media,
            "apodization": transmission if isinstance(apodization, Apodization) else transmission.slope,
        }
        vars(self).update(values)
        if not self._clearance > 0.0:
            raise ValueError(
                f"working_distance must leave room for the cover glass, got {self.working_distance:g}: with this "
                f"glass, thicker than the design's, the objective would be {-self._clearance:.3g} m inside it"
            )

    @property
    def _clearance(self) -> float:
        """Thickness of the immersion for a paraxial focus on the surface of the cover glass, metres."""
        if self.working_distance is None:  # there is neither a cover glass nor a design
            return DEPTH_MOST
        # In paraxial optics the sum of thickness / index is the same for the design and for the layers in use.
        length = self.working_distance / self.design.immersion
        for glass, sign in ((self.design.coverslip, 1.0), (self.coverslip, -1.0)):
            length += sign * glass.thickness / glass.index if glass else 0.0
        return self.immersion * length

    def _layers(self, wavelength: float) -> Layers:
        """Return the layers at a wavelength, with paths of the layers in use minus paths of the design."""
        return layers_of(self, validation.wavelength(wavelength))

    def _paraxial(self, depth: Array) -> Array:
        """Return the stage positions of the paraxial focus for emitters at these depths, metres."""
        films = sum(film.thickness / film.index for film in self.films)
        return np.asarray(self.immersion * (depth / self.sample + films))

    def _planes(self, depth: ArrayLike, focus: ArrayLike) -> tuple[Array, Array, tuple[int, ...]]:
        """Validate depths and stage positions; return both as flat arrays, and their common shape."""
        f = validation.real_array("focus", focus, unit="metres")
        d, f = validation.broadcast("depth and focus", depths(depth), f)
        # The caller passed either `focus`, or `depth` and `z`, from which the stage position follows.
        name = "the stage position, set by focus or by depth and z,"
        if f.size and f.max() > self._clearance:
            by_glass = self.working_distance is not None
            reason = ", where the objective touches the cover glass," if by_glass else " without a working_distance,"
            limit, largest = format_length(self._clearance), format_length(float(f.max()))
            raise ValueError(f"{name} must be at most {limit}{reason} got {largest}")
        if f.size and f.min() < -DEPTH_MOST:
            raise ValueError(
                f"{name} must be at least {format_length(-DEPTH_MOST)}, got {format_length(float(f.min()))}"
            )
        return d.ravel(), f.ravel(), d.shape

    def pupil(
        self,
        *,
        depth: ArrayLike,
        z: ArrayLike = 0.0,
        wavelength: float,
        origin: str = "brightest",
        emitter: str | Dipole | Beam | Scalar = "isotropic",
        aberrations: Wavefront | None = None,
    ) -> ObjectivePupil:
        """Return the pupil for an emitter at a depth and a stage position z, for :func:`lommel.psf`.

        Parameters
        ----------
        depth, z : array_like
            Depth of the emitter below the glass, and stage position relative to `origin`, positive towards the
            sample, metres. The arrays broadcast and describe a stack.
        wavelength : float
            Wavelength in vacuum, metres.
        origin : {"brightest", "paraxial", "coverslip"}, default "brightest"
            Stage position with z = 0: the brightest or the paraxial focus of the emitter (see :meth:`focus`), or the
            paraxial focus on the surface of the cover glass.
        emitter : {"isotropic", "scalar"}, Dipole, Beam or Scalar, default "isotropic"
            A freely rotating dipole, the scalar model of Gibson and Lanni, a :class:`lommel.Dipole`, or the
            excitation by a :class:`lommel.Beam`.
        aberrations : Wavefront, optional
            Aberrations added to the phase of the layers, without piston; a stack broadcasts with depth and z. The
            origin depends neither on aberrations nor on the orientation of a dipole.

        Returns
        -------
        ObjectivePupil
            One pupil, or a stack of the common shape of `depth`, `z` and `aberrations`.

        Raises
        ------
        TypeError, ValueError
            If an argument is out of range, or if a stage position is beyond the working distance.
        """
        # The origin is computed for a freely rotating dipole, so that all emitters have the same stage positions.
        layers, source = self._layers(wavelength), emitter_of(emitter)
        wavefront = projection.checked(aberrations)
        stack = np.empty(wavefront.shape if wavefront else ())
        arrays = depths(depth), validation.real_array("z", z, unit="metres"), stack
        d, offset, _ = validation.broadcast("depth, z and aberrations", *arrays)
        if wavefront and wavefront.shape:
            wavefront = wavefront.broadcast(d.shape)
        if not d.size:
            raise ValueError(f"z must not be empty, got shape {offset.shape}")
        start = np.zeros(())
        if validation.choice("origin", origin, _ORIGINS) == "paraxial":
            start = self._paraxial(d)
        elif origin == "brightest":
            start = best_foci(layers, d)
        focus = start + offset
        self._planes(d, focus)
        return ObjectivePupil(layers, self.magnification, d, focus, offset, source, wavefront)

    @property
    def critical_angle(self) -> float | None:
        """Critical angle of the sample in the immersion, radians; None if all light propagates in the sample."""
        return math.asin(self.sample / self.immersion) if self.sample < self.NA else None

    def fields(
        self, radius: ArrayLike, *, depth: ArrayLike, focus: ArrayLike, wavelength: float, tol: float = 1e-10
    ) -> FocalField:
        """Return the vectorial field at radii from the axis by quadrature over the pupil: a slow reference method.

        ``K_m = int a T_m exp(i psi) J_m(k NA r rho) rho d rho`` with ``a = c_i^(-1/2)`` times the `apodization` and
        ``T_0 = t_s + t_p c_s, T_1 = t_p NA rho / n_s, T_2 = t_s - t_p c_s``. K0 is 1 in focus for a small NA without
        reflection and apodization. The same integrals describe excitation and emission.

        Parameters
        ----------
        radius : array_like
            Distance from the axis in the sample, metres: the distance on the camera divided by the magnification.
        depth, focus : array_like
            Depth of the emitter and stage position, metres. The arrays broadcast to the shape of the planes.
        wavelength : float
            Wavelength in vacuum, metres.
        tol : float, default 1e-10
            Absolute tolerance of each integral.

        Returns
        -------
        FocalField
            Integrals, with the shape of the planes followed by the shape of `radius`.

        Raises
        ------
        TypeError, ValueError
            If an argument is out of range, or if no number of quadrature nodes is proven to suffice.

        References
        ----------
        P. Torok et al., J. Opt. Soc. Am. A 12, 325 (1995), doi:10.1364/JOSAA.12.000325.
        """
        (K0, K1, K2), error = self._integrals(radius, depth, focus, wavelength, tol)
        return FocalField(K0, K1, K2, error)

    def focus(self, depth: ArrayLike, *, wavelength: float) -> Focus:
        """Return the paraxial and the brightest focus at a depth, for a freely rotating dipole or unpolarized light.

        The search for the brightest focus evaluates the intensity on the axis in steps of a sixteenth of the depth of
        focus. It covers the foci of all rays (up to 0.98 of the pupil radius or of the critical angle) and at least
        two depths of focus beyond them at both ends. Newton's method refines the maximum.

        Parameters
        ----------
        depth : array_like
            Distance of the emitter from the glass, metres.
        wavelength : float
            Wavelength in vacuum, metres.

        Returns
        -------
        Focus
            Arrays of the shape of `depth`, or numbers for a single depth.

        Raises
        ------
        TypeError, ValueError
            If an argument is out of range, or if a focus is beyond the working distance.
        """
        layers = self._layers(wavelength)
        d = depths(depth)
        paraxial = self._paraxial(d)
        self._planes(d, paraxial)
        maxima = [brightest(layers, float(value)) for value in d.flat]
        self._planes(d, np.array([maximum.brightest for maximum in maxima]).reshape(d.shape))
        pairs = zip(d.flat, maxima, strict=True)
        widths = [_lateral_width(layers, float(value), maximum.brightest) for value, maximum in pairs]
        return Focus(*(numbers(column, d.shape) for column in (d, paraxial, *zip(*maxima, strict=True), widths)))

    def collected(self, depth: ArrayLike, *, wavelength: float) -> Numbers:
        """Return the light collected from an emitter at `depth` divided by the light from one far from the glass.

        The ratio exceeds 1 near the glass if the objective collects supercritical light, else it is 1. The emitter is
        a freely rotating dipole of constant moment. `depth` and the vacuum `wavelength` are in metres.
        """
        d = depths(depth)
        layers = self._layers(wavelength)
        power, power_far = debye.power(layers, d.ravel())
        return numbers(power @ _ISOTROPIC_WEIGHTS / (power_far @ _ISOTROPIC_WEIGHTS), d.shape)

    def nyquist(self, *, wavelength: float) -> Nyquist:
        """Return the Nyquist sampling intervals at a `wavelength` (metres, in vacuum).

        They are ``lambda / (4 NA)`` laterally and ``lambda / (2 (n_i - sqrt(n_i^2 - NA^2)))`` in stage travel.
        """
        layers = self._layers(wavelength)
        # The highest frequency of the field is NA / lambda, and that of the intensity is twice as high.
        lateral = layers.wavelength / (4.0 * self.NA)
        return Nyquist(lateral, 0.5 * _depth_of_focus(layers), lateral * self.magnification)

    def _integrals(
        self, radius: ArrayLike, depth: ArrayLike, focus: ArrayLike, wavelength: float, tol: float
    ) -> tuple[list[NDArray[np.complex128]], float]:
        layers = self._layers(wavelength)
        r = validation.real_array("radius", radius, least=0.0, unit="metres")
        d, f, shape = self._planes(depth, focus)
        error = validation.real("tol", tol, least=1e-14, below=1.0)
        if not r.size or not d.size:
            raise ValueError(f"radius, depth and focus must not be empty, got shapes {r.shape} and {shape}")
        if r.size * d.size > _VALUES_MOST:
            raise ValueError(
                f"radii times planes must be at most {_VALUES_MOST}, got {r.size} radii and {d.size} planes"
            )
        v = layers.wavenumber * self.NA * r.ravel()
        validation.reach("radius", float(v.max()), math.pi / (layers.wavenumber * self.NA), "metres")
        rule = debye.rule(layers, Model(), d, f, float(v.max()), error)
        distinct, place = np.unique(v, return_inverse=True)  # an image has about an eighth as many radii as pixels
        parts = debye.fields(rule, Model(), d, f, distinct)
        return [part[:, place.ravel()].reshape(shape + r.shape) for part in parts], rule.error


class _Axial(NamedTuple):
    """Largest maximum on the axis: stage position (metres), intensity, full width at half maximum (metres)."""

    brightest: float
    intensity: float
    fwhm: float


class _Axis:
    """Field on the axis for stage positions in a range, at one depth; if `flat`, depth and paths add no phase."""

    def __init__(self, layers: Layers, depth: float, low: float, high: float, *, flat: bool = False) -> None:
        self.depth, self.flat = np.array([depth]), flat
        ends = np.array([low, high])
        self.rule = debye.rule(layers, Model(), np.full(2, depth), ends, 0.0, _TOL)

    def intensities(self, low: float, step: float, count: int) -> Array:
        """Return the intensity at `count` stage positions, `step` metres apart, from `low` on."""
        block = math.isqrt(count - 1) + 1
        within, blocks = step * np.arange(block), low + step * block * np.arange(-(-count // block))
        amplitudes, rate = self._waves
        # exp(i (a + b) r) = exp(i a r) exp(i b r): all sums of two offsets by one product of matrices.
        field = (amplitudes * np.exp(np.outer(blocks, rate))) @ np.exp(np.outer(rate, within))
        return np.asarray(np.abs(field.ravel()[:count]) ** 2)

    @cached_property
    def _waves(self) -> tuple[NDArray[np.complex128], NDArray[np.complex128]]:
        """Amplitudes of the waves at the focus 0, and i times the change of their phase by the focus."""
        constant, by_depth, by_focus = self.rule.rates
        phase = constant + self.depth * by_depth
        # Without the phase, what remains of the depth is the decay of supercritical light.
        return self.rule.parts[0] * np.exp(-phase.imag if self.flat else 1j * phase), 1j * by_focus

    def derivatives(self, focus: float) -> tuple[float, float, float]:
        """Return the intensity and its first two derivatives by the focus, at one stage position."""
        amplitudes, rate = self._waves
        waves = amplitudes * np.exp(focus * rate)
        field, first, second = (complex(each) for each in (waves.sum(), waves @ rate, waves @ rate**2))
        # abs(E)^2, 2 Re(conj(E) E') and 2 (abs(E')^2 + Re(conj(E) E'')).
        conjugate = field.conjugate()
        return abs(field) ** 2, 2.0 * (conjugate * first).real, 2.0 * (abs(first) ** 2 + (conjugate * second).real)

    def at(self, focus: float) -> float:
        """Return the intensity at one stage position."""
        return self.derivatives(focus)[0]


def _depth_of_focus(layers: Layers) -> float:
    """Return the distance from an unaberrated focus to the first zero on the axis, metres of stage travel."""
    # lambda / (n (1 - cos theta)), with 1 - cos theta = sin^2 / (1 + cos) to avoid cancellation.
    n, sine = layers.immersion, layers.NA / layers.immersion
    return layers.wavelength / (n * sine**2 / (1.0 + math.sqrt((1.0 - sine) * (1.0 + sine))))


@lru_cache(maxsize=4096)
def brightest(layers: Layers, depth: float) -> _Axial:
    """Return the largest maximum on the axis; see :meth:`Objective.focus`.

    The range of the search is enlarged until the intensity falls to half of the maximum on both sides.
    """
    # Stage positions at which rays cross the axis, from paraxial rays up to 0.98 of the edge or the critical angle.
    rho = np.linspace(0.0, 0.98, 50) * min(1.0, layers.sample / layers.NA)
    length = np.zeros(rho.shape)
    for index, thickness in (*layers.paths, (layers.sample, depth)):
        length += thickness / (index * cosines(layers.NA, rho, index).real)
    rays = layers.immersion * cosines(layers.NA, rho, layers.immersion).real * length
    # The largest maximum lies within about a depth of focus of a point at which some rays cross the axis.
    scale = _depth_of_focus(layers)
    margin = 2.0 * scale + 4.0 * sum(thickness for _, thickness in layers.films)
    for doubling in range(_DOUBLINGS):
        low, high = rays.min() - margin * 2**doubling, rays.max() + margin * 2**doubling
        axis = _Axis(layers, depth, low, high)
        focus, step = np.linspace(low, high, math.ceil((high - low) / scale * _STEPS) + 1, retstep=True)
        values = axis.intensities(low, float(step), len(focus))
        brightest_index = int(values.argmax())
        below_half = np.flatnonzero(values < 0.5 * values[brightest_index])
        before, after = below_half[below_half < brightest_index], below_half[below_half > brightest_index]
        if before.size and after.size:
            break
    else:
        raise ValueError(
            f"depth must be small enough for a focus that falls to half of its maximum on the axis, got {depth:g} m"
        )
    position = _maximum(axis, focus[brightest_index], float(step))
    peak = axis.at(position)
    low, high = (
        scipy.optimize.brentq(
            lambda f: axis.at(f) - 0.5 * peak, focus[k], focus[brightest_index], xtol=1e-16, rtol=1e-12
        )
        for k in (before[-1], after[0])
    )
    return _Axial(position, peak, float(high) - float(low))


def media_strehl(layers: Layers, depth: float) -> float:
    """Return the peak through focus of a freely rotating dipole over that of the same pupil with a flat phase.

    The phases of the depth and of all differences from the design are left out of the latter. Amplitudes are in both,
    and so are the phases of surfaces and films.
    """
    margin = _depth_of_focus(layers) + 4.0 * sum(thickness for _, thickness in layers.films)
    axis = _Axis(layers, depth, -margin, margin, flat=True)
    count = math.ceil(2.0 * margin / _depth_of_focus(layers) * _STEPS) + 1
    focus, step = np.linspace(-margin, margin, count, retstep=True)
    start = focus[int(axis.intensities(-margin, float(step), count).argmax())]
    return brightest(layers, depth).intensity / axis.at(_maximum(axis, start, float(step)))


def aberration(layers: Layers, depth: float, terms: Mapping[tuple[int, int], float]) -> Array:
    """Return a vector whose norm is the rms over the pupil of the whole wavefront in the best focus, radians.

    The wavefront consists of Zernike `terms` (radians rms) and of the phases of the depth and of all differences from
    the design; tilts and what a travel of the stage removes are left out. The vector is linear in the terms. Radii of
    supercritical light have the weights of the light that the depth leaves.
    """
    nodes, weights = np.polynomial.legendre.leggauss(_RADII)
    rho = np.sqrt(0.5 * (nodes + 1.0))
    constant, by_depth, by_focus = layers.rates(layers.cosine(rho))
    left = weights * np.exp(-2.0 * depth * by_depth.imag)
    root, phase = np.sqrt(left / left.sum()), (constant + depth * by_depth).real
    for (n, m), value in terms.items():
        if m == 0:
            phase = phase + value * zernike.rms_factor(n, 0) * zernike.radial(n, 0, rho)
    refocused = np.stack([np.ones_like(rho), by_focus.real / layers.wavenumber], axis=1)
    basis, _ = np.linalg.qr(root[:, None] * refocused)
    radial = root * phase
    others = [value for (n, m), value in terms.items() if m != 0 and n > 1]
    return np.concatenate([radial - basis @ (basis.T @ radial), others])


def best_foci(layers: Layers, depth: Array) -> Array:
    """Return the stage position of the brightest focus at each depth: z = 0 of the origin "brightest"."""
    distinct, index = np.unique(depth, return_inverse=True)
    # One search for each distinct depth; brightest() caches the results.
    foci = np.array([brightest(layers, float(value)).brightest for value in distinct])
    return np.asarray(foci[index].reshape(depth.shape))


def out_of_focus(pupil: ObjectivePupil) -> Array:
    """Return the stage position relative to the brightest focus: z, whatever the origin of the pupil."""
    return np.asarray(pupil.focus - best_foci(pupil.layers, pupil.depth))


def from_focal_plane(pupil: ObjectivePupil) -> Array:
    """Return the distance in the sample of the emitters from the plane in focus, of opposite sign to z."""
    start = np.maximum(pupil.depth - _RATE_STEP, 0.0)
    end = pupil.depth + _RATE_STEP
    # Stage travel per depth in focus.
    rate = (best_foci(pupil.layers, end) - best_foci(pupil.layers, start)) / (end - start)
    return np.asarray(-out_of_focus(pupil) / rate)


def _maximum(axis: _Axis, start: float, step: float) -> float:
    """Return the position of the maximum within a step of `start`, by Newton's method for negative curvature."""
    position = start
    for _ in range(20):
        _, slope, curvature = axis.derivatives(position)
        correction = -slope / curvature if curvature < 0.0 else math.copysign(0.1 * step, slope)
        previous, position = position, min(max(position + correction, start - step), start + step)
        if abs(position - previous) <= 1e-9 * step:
            break
    return position


@lru_cache(maxsize=4096)
def _lateral_width(layers: Layers, depth: float, focus: float) -> float:
    """Return the lateral full width at the first half maximum of a freely rotating dipole, metres in the sample."""
    model, single = Model(), np.ones(1)
    unit = 2.0 * math.pi / _STEPS  # step of v = k NA r
    for count in (32, 256, 2048):
        v = np.asarray(np.arange(count + 1) * unit)
        rule = debye.rule(layers, model, single * depth, single * focus, float(v[-1]), _TOL)

        def excess(points: Array, rule: debye.Rule = rule) -> Array:
            """Return the intensity minus half of the intensity on the axis."""
            parts = debye.fields(rule, model, single * depth, single * focus, np.append(0.0, points))
            first, second, third = (np.abs(part[0]) ** 2 for part in parts)
            values = first + 2.0 * second + third
            return np.asarray(values[1:] - 0.5 * values[0])

        below_half = np.flatnonzero(excess(v) < 0.0)
        if below_half.size:
            end = scipy.optimize.brentq(
                lambda x: float(excess(single * x)[0]), v[below_half[0] - 1], v[below_half[0]], xtol=1e-13
            )
            return float(2.0 * end / (layers.wavenumber * layers.NA))
    raise ValueError(
        f"depth must be small enough for a focus that falls to half of its maximum laterally, got {depth:g} m"
    )


@lru_cache(maxsize=64)
def layers_of(objective: Objective, wavelength: float) -> Layers:
    """Return the layers of an objective, with paths of the layers in use minus paths of the design, cached."""
    actual, design = Design(objective.immersion, objective.coverslip), objective.design
    paths = []
    for media, thickness, sign in ((actual, objective._clearance, 1.0), (design, objective.working_distance, -1.0)):
        if actual != design and thickness is not None:
            paths.append((media.immersion, sign * thickness))
            paths += [(media.coverslip.index, sign * media.coverslip.thickness)] if media.coverslip else []
    glass = objective.coverslip.index if objective.coverslip else objective.immersion
    films = tuple((film.index, film.thickness) for film in objective.films)
    transmission = illumination(objective.apodization)
    exponent = () if transmission.uniform else tuple(transmission.exponent.tolist())
    return Layers(
        objective.NA, objective.immersion, glass, objective.sample, films, tuple(paths), wavelength, exponent
    )
