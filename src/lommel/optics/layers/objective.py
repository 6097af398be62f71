"""A microscope objective, and the layers between it and what emits light."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lommel.base import validation
from lommel.base.arrays import Array, Numbers, numbers
from lommel.optics.layers import azimuthal_orders, best_focus, debye, quadrature_bounds
from lommel.optics.layers.emitter import Beam, Dipole, Scalar, emitter_of
from lommel.optics.layers.objective_pupil import ObjectivePupil
from lommel.optics.layers.stratified import (
    DEPTH_MOST,
    Amplitudes,
    Design,
    Layer,
    Layers,
    depths,
    film_stack,
    heights,
    length,
    refractive_index,
)
from lommel.optics.wavefront.wavefront import Wavefront


class Stage:
    """What :class:`lommel.Objective` knows of its layers: these are its attributes."""

    NA: float
    immersion: float
    working_distance: float | None
    coverslip: Layer | None
    sample: float
    films: tuple[Layer, ...]
    design: Design

    @property
    def _clearance(self) -> float:
        """How much immersion there is with the surface of the cover glass in focus, metres."""
        if self.working_distance is None:  # and no other layer that it depends on
            return DEPTH_MOST
        length = self.working_distance / self.design.immersion
        for glass, sign in ((self.design.coverslip, 1.0), (self.coverslip, -1.0)):
            length += sign * glass.thickness / glass.index if glass else 0.0
        return self.immersion * length

    def _layers(self, wavelength: Any) -> Layers:
        """Return the layers in light of a wavelength, checked."""
        metres = validation.wavelength(wavelength)
        used, meant = Design(self.immersion, self.coverslip), self.design
        paths = []
        for side, sign in ((used, 1.0), (meant, -1.0)) if used != meant else ():
            room = self._clearance if side is used else self.working_distance
            assert room is not None  # as there is with a design
            paths.append((side.immersion, sign * room))
            if side.coverslip:
                paths.append((side.coverslip.index, sign * side.coverslip.thickness))
        glass = self.coverslip.index if self.coverslip else self.immersion
        films = tuple((film.index, film.thickness) for film in self.films)
        return Layers(self.NA, self.immersion, glass, self.sample, films, tuple(paths), metres)

    def _paraxial(self, depth: Array) -> Array:
        """Return the paraxial focus of emitters, metres of the stage."""
        films = sum(film.thickness / film.index for film in self.films)
        return np.asarray(self.immersion * (depth / self.sample + films))

    def _planes(self, depth: Any, focus: Any) -> tuple[Array, Array, tuple[int, ...]]:
        """Return depths and positions of the stage as flat arrays, with their shape, checked."""
        f = validation.real_array("focus", focus)
        d, f = validation.broadcast("depth and focus", depths(depth), f)
        name = "focus, or where depth and z lead,"
        if f.size and f.max() > self._clearance:
            known = self.working_distance is not None
            where = ", where the objective touches the cover glass," if known else " without a working_distance,"
            raise ValueError(f"{name} must be at most {self._clearance:.4g} metres{where} got {f.max():g}")
        if f.size and f.min() < -DEPTH_MOST:
            raise ValueError(f"{name} is in metres and must be at least {-DEPTH_MOST:g}, got {f.min():g}")
        return d.ravel(), f.ravel(), d.shape

    def _require_clearance(self) -> None:
        """Raise ValueError where the cover glass would be in the objective."""
        if not self._clearance > 0.0:
            raise ValueError(
                f"working_distance must leave room for the cover glass, got {self.working_distance:g}: with this "
                f"glass, thicker than the design's, the objective would be {-self._clearance:.3g} m inside it"
            )

    def _start(self, origin: str, layers: Layers, depth: Array) -> Array:
        """Return where the stage is at z = 0, for each depth."""
        if origin == "coverslip":
            return np.zeros(())
        if origin == "paraxial":
            return self._paraxial(depth)
        each, place = np.unique(depth, return_inverse=True)
        best = np.array([best_focus.brightest(layers, float(one)).brightest for one in each])
        return np.asarray(best[place].reshape(depth.shape))

    def _rates(self, rho: Any, wavelength: Any) -> tuple[Any, Any, Any]:
        layers = self._layers(wavelength)
        return layers.rates(layers.cosine(heights(rho)))


@dataclass(frozen=True, eq=False)
class FocalField:
    """The vectorial field of a microscope, in three integrals that everything is made of.

    A fixed dipole p, with z towards the objective and phi the azimuth on the camera, has there
    ``Ex = p_x (K0 + K2 cos 2 phi) + p_y K2 sin 2 phi - 2i p_z K1 cos phi`` and
    ``Ey = p_x K2 sin 2 phi + p_y (K0 - K2 cos 2 phi) - 2i p_z K1 sin phi``; light that enters polarised along x has
    ``E = (K0 + K2 cos 2 phi, K2 sin 2 phi, -2i K1 cos phi)`` in the sample.

    Parameters
    ----------
    K0, K1, K2 : ndarray of complex, shape planes + radii
    error : float
        Of each of these: proven for the quadrature, with an allowance for rounding.
    """

    K0: NDArray[np.complex128]
    K1: NDArray[np.complex128]
    K2: NDArray[np.complex128]
    error: float

    @property
    def intensity(self) -> Array:
        """``abs(K0)^2 + 2 abs(K1)^2 + abs(K2)^2``: an emitter that turns freely, or light that is not polarised."""
        return np.asarray(np.abs(self.K0) ** 2 + 2.0 * np.abs(self.K1) ** 2 + np.abs(self.K2) ** 2)

    @property
    def intensity_error(self) -> Array:
        """How much `intensity` may be off: ``4 error sqrt(intensity) + 4 error^2`` each."""
        return np.asarray(4.0 * self.error * (np.sqrt(self.intensity) + self.error))


@dataclass(frozen=True, eq=False)
class ScalarField:
    """The field of the scalar model of Gibson and Lanni.

    Parameters
    ----------
    U : ndarray of complex, shape planes + radii
    error : float
        Of each: proven for the quadrature, with an allowance for rounding.
    """

    U: NDArray[np.complex128]
    error: float

    @property
    def intensity(self) -> Array:
        """``abs(U)^2``."""
        return np.asarray(np.abs(self.U) ** 2)

    @property
    def intensity_error(self) -> Array:
        """How much `intensity` may be off: ``2 error sqrt(intensity) + error^2`` each."""
        return np.asarray(self.error * (2.0 * np.abs(self.U) + self.error))


@dataclass(frozen=True, eq=False)
class Focus:
    """Where an emitter is in focus, one for each depth.

    Parameters
    ----------
    depth : float or ndarray
        Metres from the glass.
    paraxial, brightest : float or ndarray
        How far the objective has been driven towards the sample since the surface of the sample was in paraxial
        focus, metres: for paraxial rays, and where the light on the axis is brightest.
    peak : float or ndarray
        The intensity there. 1 is that of an aperture of the same light without layers or polarisation.
    axial_fwhm, lateral_fwhm : float or ndarray
        Full widths at half maximum through there, metres of the stage and metres in the sample.
    """

    depth: Numbers
    paraxial: Numbers
    brightest: Numbers
    peak: Numbers
    axial_fwhm: Numbers
    lateral_fwhm: Numbers

    @property
    def ratio(self) -> Numbers:
        """Depth over the position of the brightest focus, the factor for distances along the axis; NaN at depth 0."""
        with np.errstate(invalid="ignore", divide="ignore"):
            found: Numbers = np.where(np.asarray(self.depth) > 0.0, np.divide(self.depth, self.brightest), np.nan)[()]
        return found


@dataclass(frozen=True)
class Nyquist:
    """The coarsest sampling that keeps all of an image, metres.

    Parameters
    ----------
    lateral, axial : float
        In the sample, and of the stage.
    pixel : float
        `lateral` on the camera.
    """

    lateral: float
    axial: float
    pixel: float


_TURNING = emitter_of("isotropic").light.shares
_DISTANCE_MOST = 0.1
_VALUES_MOST = 2**26
_ORIGINS = ("coverslip", "paraxial", "brightest")


@dataclass(frozen=True, init=False)
class Objective(Stage):
    r"""A microscope objective with its immersion, cover glass and sample; metres everywhere.

    The layers are plane: sample | films | cover glass | immersion | objective. A ray has the same
    ``NA rho = n sin(theta)`` in each, rho from 0 to 1 across the pupil. An emitter is at `depth` metres from the
    glass (from the last film, if there are some). `focus` is how far the objective has been driven towards the sample
    since the surface of the cover glass was in paraxial focus: what the stage of a microscope records, not a distance
    in the sample.

    Parameters
    ----------
    NA : float
        Numerical aperture, below the indices of immersion and cover glass. Where it exceeds that of the sample, light
        beyond the critical angle counts, and fades with the depth.
    magnification : float, default 1
        From the sample to the camera. 1: pixels and lengths on the camera are those in the sample.
    immersion : float
        Refractive index of what is between objective and cover glass.
    working_distance : float, optional
        Metres from the objective to the cover glass, in focus on the surface of the glass and used as designed.
        Needed with a cover glass or a `design`: without these no light depends on it, and without it the stage moves
        up to 0.01 metres.
    coverslip : Layer, optional
        The cover glass; by default there is none, and the objective dips into the sample.
    sample : float, optional
        Refractive index of what the emitter is in. Needed with a cover glass; by default that of the immersion, so
        that all is one medium.
    films : sequence of Layer, default none
        Thin films between cover glass and sample, in this order: coherent, by characteristic matrices, each of at
        most 2 um. The glass is thick: what it reflects to and fro is not seen.
    design : Design, optional
        What the objective was corrected for, by default what it is used with.

    Raises
    ------
    TypeError, ValueError
        On anything that is missing, not finite or out of range, or through which light of this aperture cannot pass.

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

    NA: float
    magnification: float
    immersion: float
    working_distance: float | None
    coverslip: Layer | None
    sample: float
    films: tuple[Layer, ...]
    design: Design

    def __init__(
        self,
        *,
        NA: float,
        magnification: float = 1.0,
        immersion: float,
        working_distance: float | None = None,
        coverslip: Layer | None = None,
        sample: float | None = None,
        films: Any = (),
        design: Design | None = None,
    ) -> None:
        validation.optional("coverslip", coverslip, Layer)
        validation.optional("design", design, Design)
        n = refractive_index("immersion", immersion)
        aperture = validation.real("NA", NA, least=1e-3)
        used = design or Design(n, coverslip)
        media = {"immersion": n, "design.immersion": used.immersion}
        glasses = {"coverslip": coverslip, "design.coverslip": used.coverslip}
        media |= {name: glass.index for name, glass in glasses.items() if glass}
        for name, index in media.items():
            if not aperture < index:
                raise ValueError(f"NA must be below the index of {name}, {index:g}, got {aperture:g}")
        if sample is None and coverslip:
            raise ValueError("sample must be given with a coverslip: the refractive index of what the emitter is in")
        if working_distance is None and (coverslip or used != Design(n, coverslip)):
            raise ValueError("working_distance must be given, in metres, with a coverslip or a design")
        values = {
            "NA": aperture,
            "magnification": validation.real("magnification", magnification, least=1e-3, below=1e6),
            "immersion": n,
            "working_distance": working_distance
            if working_distance is None
            else length("working_distance", working_distance, _DISTANCE_MOST, positive=True),
            "coverslip": coverslip,
            "sample": n if sample is None else refractive_index("sample", sample),
            "films": film_stack(films),
            "design": used,
        }
        vars(self).update(values)
        self._require_clearance()

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
        """Return the pupil with an emitter at a depth and the stage at a position, for :func:`lommel.psf`.

        Parameters
        ----------
        depth, z : array_like
            Metres: of the emitter from the glass, and of the stage from the origin, positive towards the sample. They
            broadcast; arrays make a stack.
        wavelength : float
            Metres, in vacuum.
        origin : {"brightest", "paraxial", "coverslip"}, default "brightest"
            Where z is 0: where the emitter is brightest on the axis, its focus by paraxial rays (see :meth:`focus`),
            or where the surface of the cover glass is in paraxial focus.
        emitter : {"isotropic", "scalar"}, Dipole, Beam or Scalar, default "isotropic"
            An emitter that turns freely, the scalar model of Gibson and Lanni, a :class:`lommel.Dipole`, or the light
            of a :class:`lommel.Beam` that is focused into the sample.
        aberrations : Wavefront, optional
            A measured phase on top of that of the layers, its piston left out; a stack broadcasts with depth and z.
            `origin` does not regard it, nor how an emitter is turned.

        Returns
        -------
        ObjectivePupil

        Raises
        ------
        TypeError, ValueError
            On anything out of range, or at positions that the working distance does not reach.
        """
        layers, light = self._layers(wavelength), emitter_of(emitter)
        measured = azimuthal_orders.checked(aberrations)
        stack = np.empty(measured.shape if measured else ())
        given = depths(depth), validation.real_array("z", z), stack
        d, offset, _ = validation.broadcast("depth, z and aberrations", *given)
        if measured and measured.shape:
            measured = measured.broadcast(d.shape)
        if not d.size:
            raise ValueError(f"z must not be empty, got shape {offset.shape}")
        focus = self._start(validation.choice("origin", origin, _ORIGINS), layers, d) + offset
        self._planes(d, focus)
        return ObjectivePupil(layers, self.magnification, d, focus, offset, light, measured)

    @property
    def critical_angle(self) -> float | None:
        """The angle in the immersion beyond which light is evanescent in the sample, radians; None without one."""
        return math.asin(self.sample / self.immersion) if self.sample < self.NA else None

    def phase(self, rho: ArrayLike, *, depth: float, focus: float, wavelength: float) -> NDArray[np.complex128]:
        """Return psi, the phase of each plane wave from the emitter, in ``exp(i psi)`` with ``exp(-i omega t)``.

        ``psi = k (d n_s c_s + t_g n_g c_g - t_g0 n_g0 c_g0 + t_i n_i c_i - t_i0 n_i0 c_i0)``, with
        ``t_i = n_i (t_g0 / n_g0 + t_i0 / n_i0 - t_g / n_g) - f``; index 0 is the design. What films add is in
        :meth:`transmission`.

        Parameters
        ----------
        rho : array_like
            0 to 1.
        depth, focus : float
            Metres.
        wavelength : float
            Metres, in vacuum.

        Returns
        -------
        ndarray of complex
            Radians, with a positive imaginary part beyond the critical angle of the sample.

        Raises
        ------
        TypeError, ValueError
            On anything out of range.
        """
        d, f, _ = self._planes(depth, focus)
        if d.size != 1:
            raise ValueError(f"depth and focus must be one number each, got {d.size} planes")
        fixed, by_depth, by_focus = self._rates(rho, wavelength)
        return np.asarray(fixed + d[0] * by_depth + f[0] * by_focus)

    def phase_derivatives(self, rho: ArrayLike, *, wavelength: float) -> tuple[NDArray[np.complex128], Array]:
        """Return the derivatives of :meth:`phase` at `rho` by depth and by focus, radians per metre.

        ``k n_s c_s`` and ``-k n_i c_i``, which depend on neither: the phase is linear in both. `wavelength` is in
        metres.
        """
        _, by_depth, by_focus = self._rates(rho, wavelength)
        return np.asarray(by_depth), np.asarray(by_focus.real)

    def transmission(self, rho: ArrayLike, *, wavelength: float) -> tuple[NDArray[np.complex128], ...]:
        """Return the amplitudes ``(t_s, t_p)`` of plane waves that pass from immersion to sample.

        Fresnel's, and characteristic matrices of the films. Light of an emitter has the same: its amplitude of the
        other way, times ``n_i c_i / (n_s c_s)``, is that of this one, which is finite at the critical angle.

        Parameters
        ----------
        rho : array_like
            0 to 1.
        wavelength : float
            Metres, in vacuum.

        Returns
        -------
        t_s, t_p : ndarray of complex

        Raises
        ------
        TypeError, ValueError
            On anything out of range.
        """
        at, layers = heights(rho), self._layers(wavelength)
        found: Amplitudes = layers.amplitudes(layers.cosine(at), ((self.NA * at) ** 2).astype(np.complex128))
        return np.asarray(found.s), np.asarray(found.p)

    def fields(
        self,
        radius: ArrayLike,
        *,
        depth: ArrayLike,
        focus: ArrayLike,
        wavelength: float,
        tol: float = 1e-10,
    ) -> FocalField:
        """Return the vectorial field at radii from the axis, by quadrature over all angles: slow, and a reference.

        ``K_m = int a T_m exp(i psi) J_m(k NA r rho) rho d rho`` with ``a = c_i^(-1/2)`` and
        ``T_0 = t_s + t_p c_s, T_1 = t_p NA rho / n_s, T_2 = t_s - t_p c_s``. K0 is 1 in focus where NA is small and
        nothing is reflected. Excitation and emission have the same field.

        Parameters
        ----------
        radius : array_like
            Metres in the sample: on the camera, over the magnification.
        depth, focus : array_like
            Metres; they broadcast, to the planes.
        wavelength : float
            Metres, in vacuum.
        tol : float, default 1e-10
            Of each integral.

        Returns
        -------
        FocalField
            Values of the shape of the planes and that of `radius`.

        Raises
        ------
        TypeError, ValueError
            On anything out of range, or if it takes more than 20 000 angles.

        References
        ----------
        P. Torok et al., J. Opt. Soc. Am. A 12, 325 (1995), doi:10.1364/JOSAA.12.000325.
        """
        (K0, K1, K2), error = self._integrals(quadrature_bounds.Model(), radius, depth, focus, wavelength, tol)
        return FocalField(K0, K1, K2, error)

    def scalar(
        self,
        radius: ArrayLike,
        *,
        depth: ArrayLike,
        focus: ArrayLike,
        wavelength: float,
        apodization: str = "uniform",
        supercritical: bool = True,
        tol: float = 1e-10,
    ) -> ScalarField:
        """Return the scalar field of Gibson and Lanni, ``U = 2 int A exp(i psi) J0(k NA r rho) rho d rho``.

        Parameters
        ----------
        radius, depth, focus, wavelength, tol
            As of :meth:`fields`.
        apodization : {"uniform", "aplanatic"}, default "uniform"
            A = 1, as published, or ``c_i^(-1/2)``, of the sine condition.
        supercritical : bool, default True
            Whether light beyond the critical angle of the sample counts; the published model leaves it out.

        Returns
        -------
        ScalarField

        Raises
        ------
        TypeError, ValueError
            On anything out of range, or if it takes more than 20 000 angles.
        """
        model = Scalar(apodization, supercritical).light.model
        (U,), error = self._integrals(model, radius, depth, focus, wavelength, tol)
        return ScalarField(U, error)

    def focus(self, depth: ArrayLike, *, wavelength: float) -> Focus:
        """Return where an emitter is in focus: for paraxial rays, and where its light on the axis is brightest.

        Where there are several maxima the largest is meant: of steps of a sixteenth of the depth of focus, between
        the foci of all rays (up to 0.98 of the critical angle) and two depths of focus beyond, and from there by
        Newton's method. For light that is not polarised, or an emitter that turns freely.

        Parameters
        ----------
        depth : array_like
            Metres from the glass.
        wavelength : float
            Metres, in vacuum.

        Returns
        -------
        Focus
            Arrays of the shape of `depth`, numbers for one.

        Raises
        ------
        TypeError, ValueError
            On anything out of range, or at a depth that the working distance does not reach.
        """
        layers = self._layers(wavelength)
        d = depths(depth)
        paraxial = self._paraxial(d)
        self._planes(d, paraxial)
        found = [best_focus.brightest(layers, float(one)) for one in d.flat]
        self._planes(d, np.array([one.brightest for one in found]).reshape(d.shape))
        each = zip(d.flat, found, strict=True)
        wide = [best_focus.lateral_width(layers, float(one), light.brightest) for one, light in each]
        return Focus(*(numbers(column, d.shape) for column in (d, paraxial, *zip(*found, strict=True), wide)))

    def collected(self, depth: ArrayLike, *, wavelength: float) -> Numbers:
        """Return the light that an emitter at `depth` (metres) sends into the objective, over that of one far away.

        More than 1 near a glass that light beyond the critical angle enters; 1 at every depth where there is none.
        Of a dipole of constant moment that turns freely; `wavelength` is in metres, in vacuum.
        """
        d = depths(depth)
        layers = self._layers(wavelength)
        near, far = debye.power(layers, d.ravel())
        return numbers(near @ _TURNING / (far @ _TURNING), d.shape)

    def nyquist(self, *, wavelength: float) -> Nyquist:
        """Return the coarsest steps that keep all of an image in light of one `wavelength` (metres, in vacuum).

        ``lambda / (4 NA)`` sideways, ``lambda / (2 (n_i - sqrt(n_i^2 - NA^2)))`` of the stage.
        """
        layers = self._layers(wavelength)
        lateral = layers.wavelength / (4.0 * self.NA)
        return Nyquist(lateral, 0.5 * best_focus.depth_of_focus(layers), lateral * self.magnification)

    def _integrals(
        self, model: quadrature_bounds.Model, radius: Any, depth: Any, focus: Any, wavelength: Any, tol: Any
    ) -> tuple[list[NDArray[np.complex128]], float]:
        layers = self._layers(wavelength)
        r = validation.real_array("radius", radius, least=0.0)
        d, f, shape = self._planes(depth, focus)
        error = validation.real("tol", tol, least=1e-14, below=1.0)
        if not r.size or not d.size:
            raise ValueError(f"radius, depth and focus must not be empty, got shapes {r.shape} and {shape}")
        if r.size * d.size > _VALUES_MOST:
            raise ValueError(f"radius and planes must be at most {_VALUES_MOST} values, got {r.size} times {d.size}")
        v = layers.wavenumber * self.NA * r.ravel()
        validation.reach("radius", float(v.max()), math.pi / (layers.wavenumber * self.NA), "metres")
        rule = debye.rule(layers, model, d, f, float(v.max()), error)
        distinct, place = np.unique(v, return_inverse=True)  # of the pixels of an image, an eighth
        parts = debye.fields(rule, model, d, f, distinct)
        return [part[:, place.ravel()].reshape(shape + r.shape) for part in parts], rule.error
