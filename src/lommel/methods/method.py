"""The face every method has: what it supports, and the intensity it computes."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable
from dataclasses import fields, replace
from typing import TYPE_CHECKING, Any, ClassVar, Self, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from lommel.base import validation
from lommel.core.answers import Declined, FieldValues, Images, Intensities, ToleranceError, Wanted, not_met
from lommel.optics.base_pupil import imaged
from lommel.optics.grid import Grid
from lommel.special.bessel import _radii

if TYPE_CHECKING:
    from lommel.optics.colour.spectrum import Component

AnyPupil: TypeAlias = Any
"""A :class:`lommel.optics.base_pupil.BasePupil`: each method narrows it to those that it supports."""

Shortcut = Callable[[Any, NDArray[Any]], tuple[NDArray[np.float64], float] | None]
"""From a pupil and an array for its values to what these were multiplied by, and the largest bound; or None."""


class Method(ABC):
    """A way to evaluate the diffraction integral.

    The field is normalised so that the unaberrated, unobscured aperture gives U(0) = 1, and I = abs(U)^2.
    Subclasses are frozen dataclasses: their fields are their options.
    """

    sampling: ClassVar[str] = "center"
    """``"center"``: values sample the pixel centres; ``"pixel"``: they are averages over pixels."""

    apodized: ClassVar[bool] = False
    """Whether pupils with an apodization are supported."""

    nonradial: ClassVar[bool] = False
    """Whether pupils whose phase or transmission depends on the direction are supported."""

    any_aperture: ClassVar[bool] = False
    """Whether apertures with a spider, vignetting or a mask are supported."""

    layered: ClassVar[bool | None] = False
    """Whether it is pupils of a microscope's objective that are supported, or, where None, both kinds."""

    keeps_tol: ClassVar[bool] = True
    """Whether a bound, where there is one, counts everything, storing included, and never exceeds `tol`."""

    least_tol: ClassVar[float] = 1e-12
    """The least tolerance that a method with one takes."""

    tol: float = 1e-6

    def unsupported(self, pupil: AnyPupil) -> str | None:
        """Return why `pupil` is not supported, or None if it is: here, that every one is."""
        return None

    @abstractmethod
    def intensity(self, pupil: AnyPupil, grid: Grid, threads: int = 0) -> Intensities:
        """Return I on `grid` for the flattened stack of `pupil`, by at most so many `threads`.

        Shape ``(n, len(grid.radii))``, at the distinct radii, or ``(n, height, width)``.
        """

    def unaberrated_peak(self, pupil: AnyPupil) -> float:
        """Return the peak of the aperture of `pupil` without aberration, to which "strehl" relates."""
        return float(pupil.amplitude**2)

    def stretch(self, pupil: AnyPupil) -> float:
        """Return the exponential type of U in v: how much faster than at the wavelength of `pupil` it varies."""
        return 1.0

    def with_tol(self, tol: float) -> Self:
        """Return the same method with another tolerance.

        Parameters
        ----------
        tol : float
            As the method itself takes it.

        Returns
        -------
        Method

        Raises
        ------
        TypeError, ValueError
            If it has none, or takes none such.
        """
        if not self._has_tol:
            raise ValueError(
                f"tol={validation.shown(tol)} must be left out for {type(self).__name__}, which has no tolerance; "
                "name another method"
            )
        changed: Self = replace(self, tol=tol)  # type: ignore[type-var]
        return changed

    def tightened(self, tol: float | None = None) -> Self:
        """Return the same method with half the tolerance, or with another.

        Parameters
        ----------
        tol : float, optional
            The least there is where it is below that.

        Returns
        -------
        Method
            The method itself where no tolerance is kept.
        """
        if not (self._has_tol and self.keeps_tol):
            return self
        return self.with_tol(max(0.5 * self.tol if tol is None else tol, self.least_tol))

    @property
    def _has_tol(self) -> bool:
        return "tol" in getattr(self, "__dataclass_fields__", ())

    def components(self, pupil: AnyPupil) -> list[Component]:
        """Return the parts whose intensities add up to that of `pupil`: one, unless the method sums several.

        Parameters
        ----------
        pupil : Pupil

        Returns
        -------
        list of Component
        """
        from lommel.optics.colour.spectrum import Component

        return [Component(1.0, 1.0, pupil)]

    def along_radius(self, pupil: AnyPupil) -> RadialMethod | None:
        """Return the method where a profile along the radius describes the whole PSF of `pupil`, else None."""
        return None

    def images(self, pupil: AnyPupil, grid: Grid, wanted: Wanted) -> Images:
        """Return the images of the flattened stack.

        Parameters
        ----------
        pupil, grid
        wanted : Wanted

        Returns
        -------
        Images

        Raises
        ------
        ValueError
            If derivatives are wanted of a method, or of a pupil, that has none.
        ToleranceError
            If the tolerance of the method cannot be met.
        """
        if wanted.powers or wanted.terms:
            raise ValueError(
                f"derivatives are not available from {type(self).__name__}; use NijboerZernike or ChordalGauss"
            )
        way = self
        made = way.intensity(pupil, grid, wanted.threads)
        while self.keeps_tol and (error := once_stored(made, wanted)) is not None and error.max() > self.tol:
            # Values divided by their own largest one are off by twice as much.
            finer = way.tightened() if wanted.scale is not None else way.tightened().tightened()
            if finer == way:
                raise not_met(self.tol, float(error.max()), "the peak")
            way = finer
            made = way.intensity(pupil, grid, wanted.threads)
        return painted(made, grid, wanted)

    def plan(self, pupil: AnyPupil, grid: Grid, wanted: Wanted) -> Shortcut | None:
        """Return a shorter way to the images of further pupils, where there is one; here, there is none.

        Parameters
        ----------
        pupil, grid
            One that is supported; further ones differ from it in their wavefronts alone, of one shape.
        wanted : Wanted
            Without `out` and `powers`.

        Returns
        -------
        callable or None
            Given such a pupil and an array for the values, returns what these were multiplied by, of the shape of the
            pupil, and the largest bound on errors; or None where :meth:`images` has to be asked. Raises as that does.
        """
        return None

    def require(self, pupil: AnyPupil) -> None:
        """Raise ValueError if `pupil` is not supported."""
        if self.layered is not None and imaged(pupil).layered != self.layered:
            fault = (
                "supports the pupils of an Objective only; for a lens use NijboerZernike"
                if self.layered
                else "supports no pupils of an Objective, behind layers; use Stratified or DebyeWolf"
            )
            raise Declined(f"{type(self).__name__} {fault}")
        reason = self.unsupported(pupil)
        if reason is None and not (pupil.circular or self.any_aperture):
            reason = (
                "supports plain discs and annuli only; for a spider, vignetting or a mask use NonuniformFFT, "
                "MatrixFourier or Fraunhofer"
            )
        if reason is None and not (self.nonradial or pupil.radial):
            reason = "supports radially symmetric pupils only; this one has terms that depend on the direction"
        if reason is None and not (self.apodized or pupil.illumination.uniform):
            reason = "supports uniform illumination only; this pupil is apodized"
        if reason is not None:
            raise Declined(f"{type(self).__name__} {reason}")

    def to_dict(self) -> dict[str, Any]:
        """Return the method's name and options in plain types."""
        return {"name": type(self).__name__} | describe_options(self)


def describe_options(thing: Any) -> dict[str, Any]:
    """Return the fields of a dataclass as plain types; nested dataclasses carry their ``"name"``."""
    options: dict[str, Any] = {}
    for item in fields(thing):
        value = getattr(thing, item.name)
        nested = hasattr(value, "__dataclass_fields__")
        options[item.name] = {"name": type(value).__name__} | describe_options(value) if nested else value
    return options


class RadialMethod(Method):
    """A method whose answer depends on the distance from the axis only, and is known at any distance."""

    @abstractmethod
    def profile(self, pupil: AnyPupil, v: NDArray[np.float64]) -> Intensities:
        """Return I at rising `v` for the flattened stack of `pupil`, shape ``(n, len(v))``.

        ValueError or ToleranceError where the method cannot answer as it promises.
        """

    def along_radius(self, pupil: AnyPupil) -> RadialMethod | None:
        """Return the method itself for a radial pupil, else None."""
        return self if pupil.radial else None

    def intensity(self, pupil: AnyPupil, grid: Grid, threads: int = 0) -> Intensities:
        """Return I at the distinct radii of `grid`, or on its pixels where these share none."""
        if not grid.symmetric:
            from lommel.methods.pixels.subpixel import subpixel_intensity

            return subpixel_intensity(self, pupil, grid, threads)
        return self.profile(pupil, grid.v(pupil))

    def images(self, pupil: AnyPupil, grid: Grid, wanted: Wanted) -> Images:
        """Return the images of the flattened stack; see ``Method.images``."""
        if grid.symmetric or wanted.scale is not None or wanted.powers or self.along_radius(pupil) is None:
            return super().images(pupil, grid, wanted)
        from lommel.methods.pixels.subpixel import subpixel_intensity

        # Values divided by their own largest one are off by twice as much, and by nothing over the peak elsewhere.
        aim = 0.48 * (self.tol - 1.1 * storing(wanted.dtype))
        made = subpixel_intensity(self, pupil, grid, wanted.threads, tol=aim, window=True)
        return painted(made, grid, wanted)


class FieldMethod(RadialMethod):
    """A radial method that knows the complex field."""

    @abstractmethod
    def evaluate(self, pupil: AnyPupil, v: NDArray[np.float64]) -> FieldValues:
        """Return U at rising `v` for the flattened `pupil`, shape ``(n, len(v))``, with a bound on its error.

        ValueError or ToleranceError where the method cannot answer as it promises.
        """

    def field(self, pupil: AnyPupil, v: ArrayLike) -> NDArray[np.complex128]:
        """Return the complex field U of a `pupil` at optical coordinates `v`, shape ``pupil.shape + v.shape``.

        TypeError or ValueError unless these are numbers, finite and >= 0.
        """
        self.require(pupil)
        at = validation.real_array("v", v, least=0.0) + 0.0  # no -0
        values, where = np.unique(_radii(at.ravel()), return_inverse=True)
        return self.evaluate(pupil, values).values[:, where].reshape(pupil.shape + at.shape)

    def profile(self, pupil: AnyPupil, v: NDArray[np.float64]) -> Intensities:
        """Return I = abs(U)^2 at rising v with the bound on its error relative to the largest value."""
        values, error = self.evaluate(pupil, v)
        intensity = values.real**2 + values.imag**2
        relative = None if error is None else relative_error(intensity, error)
        return Intensities(intensity, relative, intensity.max(axis=1))


def relative_error(intensity: NDArray[np.float64], field_error: NDArray[np.float64]) -> NDArray[np.float64]:
    """Bound ``max|I - I_exact| / max I_exact`` from a bound e on abs(U - U_exact): ``(2 M e + e^2) / (M - e)^2``.

    M is the largest abs(U) computed; the exact one may be smaller by e.
    """
    peak = np.sqrt(intensity.max(axis=1))
    exact = peak - field_error
    error = field_error * (2.0 * peak + field_error)
    return np.asarray(np.divide(error, exact**2, out=np.full(peak.shape, np.inf), where=exact > 1e-150))


def storing(dtype: DTypeLike) -> float:
    """Bound what it adds to errors over the peak that values are scaled and stored, as the compiled core does."""
    return 6.0 * 2.0**-53 + (2.0**-24 if np.dtype(dtype) == np.float32 else 0.0)


def stored(relative: NDArray[np.float64], dtype: DTypeLike) -> NDArray[np.float64]:
    """Bound the error of values that are off by `relative` of the peak before they are stored."""
    return np.asarray(relative + (1.0 + relative) * storing(dtype))


def once_stored(made: Intensities, wanted: Wanted) -> NDArray[np.float64] | None:
    """Bound what images of intensities are off by once they are scaled, where by None to a peak of 1, and stored."""
    if made.error is None:
        return None
    return stored(normalized_error(made.error) if wanted.scale is None else made.error, wanted.dtype)


def painted(made: Intensities, grid: Grid, wanted: Wanted) -> Images:
    """Return intensities, at the radii of `grid` or on its pixels, as images; see :meth:`Method.images`."""
    largest = made.values.reshape(len(made.values), -1).max(axis=1)
    if wanted.scale is None and not np.all(largest > 0):
        raise ValueError('normalize="peak" is impossible: no light falls into the window')
    scales = np.broadcast_to(wanted.scale, largest.shape) if wanted.scale is not None else 1.0 / largest
    values = np.empty((len(largest), *grid.shape), wanted.dtype) if wanted.out is None else wanted.out
    grid.paint(made.values, scales, values)
    return Images(values, scales, once_stored(made, wanted), None, made.peak)


def normalized_error(relative: NDArray[np.float64]) -> NDArray[np.float64]:
    """Bound the error of values divided by their own largest one, itself in error by `relative`."""
    safe = np.minimum(relative, 1.0 - 1e-9)
    return np.asarray(np.where(relative < 1.0 - 1e-9, 2.0 * safe / (1.0 - safe), np.inf))


def widened(made: Images, pupil: AnyPupil, method: Method, *, normalized: bool) -> Images:
    """Return images whose bounds count what the terms of the wavefront and the powers of the apodization leave out.

    A phase in error by e changes U by at most ``e int A dx dy / pi``, and a derivative of U by as much. At another
    wavelength of a spectrum both e and U grow as it falls. An amplitude A that is off by e A does the same, and
    counts twice: what values are divided by, the peak without aberration or all light, is made of it too.

    Raises
    ------
    ToleranceError
        If the tolerance is not met any more.
    """
    of_phase, of_light = pupil.left_out
    if not (of_phase or of_light) or made.error is None:
        return made
    stretch = max(1.0, method.stretch(pupil))
    left = np.asarray((of_phase * stretch + 2.0 * of_light) * pupil.amplitude * stretch)
    brightest = made.values.reshape(len(made.values), -1).max(axis=1).astype(np.float64) / made.scale
    more = relative_error(brightest[:, None], left)
    error = made.error + (normalized_error(more) if normalized else more)
    if method.keeps_tol and error.max() > method.tol >= made.error.max():
        raise ToleranceError(
            f"tol={method.tol:g} cannot be met: the terms of the wavefront leave up to {of_phase:.2g} rad of the "
            f"phase out, those of the apodization {of_light:.2g} of the amplitude; with both the error is bounded by "
            f"{error.max():.2g} of the peak; ask for a larger tol"
        )
    if made.slopes is None:
        return made._replace(error=error)
    further = 4.0 * left * pupil.amplitude / brightest
    return made._replace(error=error, slopes=made.slopes._replace(error=made.slopes.error + further))


def powers_cancel(pupil: AnyPupil) -> str | None:
    """Return why the phase is not to be taken as powers of rho, or None where it may be."""
    from lommel.optics.wavefront.wavefront import MAX_HIGHER  # loaded with what has one

    if pupil.wavefront.symmetric <= 2 + MAX_HIGHER:
        return None
    return (
        f"takes powers of rho up to {2 * (2 + MAX_HIGHER)}, and those of radially symmetric terms of higher degree "
        "cancel: use NijboerZernike"
    )


def annulus(
    disk: Callable[[NDArray[np.float64], NDArray[np.float64]], FieldValues],
    pupil: AnyPupil,
    v: NDArray[np.float64],
) -> FieldValues:
    """Build the field of an obscured aperture from that of full ones.

    ``U(v) = U_disk(v) - eps^2 U_inner(eps v)``, where the inner disk carries the phase of rho < eps, that is
    coefficients ``c_k eps^(2k)``. `disk` maps coefficients and v to a field.
    """
    coefficients = pupil.coefficients()
    outer = disk(coefficients, v)
    if pupil.obscuration == 0.0:
        return outer
    area = pupil.obscuration**2
    powers = area ** np.arange(1, 1 + coefficients.shape[1])
    inner = disk(coefficients * powers, pupil.obscuration * v)
    error = None if outer.error is None or inner.error is None else outer.error + area * inner.error
    return FieldValues(outer.values - area * inner.values, error)
