"""Base classes of the methods: supported pupils, intensities, and images with error bounds."""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from collections.abc import Callable
from dataclasses import fields, replace
from typing import TYPE_CHECKING, Any, ClassVar, Generic, Self, cast

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from lommel.base import validation
from lommel.base.arrays import Array, Json
from lommel.core.answers import Declined, FieldValues, Intensities, Pixels, Samples, ToleranceError, Wanted, not_met
from lommel.core.engine import Window, pixel_radii, pixel_values
from lommel.optics.base_pupil import BasePupil, imaged
from lommel.optics.grid import Grid
from lommel.special.bessel import _radii

if TYPE_CHECKING:
    from typing_extensions import TypeVar

    from lommel.optics.colour.spectrum import Component
    from lommel.optics.pupil import Pupil

    P = TypeVar("P", bound=BasePupil, default=Any)
else:
    from typing import TypeVar

    P = TypeVar("P", bound=BasePupil)

Shortcut = Callable[[Any, Pixels], tuple[Array, float] | None]
"""Signature: pupil, array for the values -> scale of the values, and the largest error bound; or None."""

# Article and noun of the kind of pupil, for messages.
_NOUN = {"lens": "a lens", "objective": "an objective"}
# Accuracy levels l of tables in the compiled core, errors about 10^-l: section 9, "Requested accuracy".
_LEVELS = range(3, 16)
_DEFAULT_LEVEL = 10  # level for profiles without an error bound
# Number of steps from the axis to the outermost ray, on which the peak is searched: section 9, "Relative to what".
_LINE_STEPS = 512


class Method(ABC, Generic[P]):
    """A method of evaluating the diffraction integral for pupils of the type `P`.

    The field is normalised so that the unaberrated, unobscured aperture has U(0) = 1, and I = abs(U)^2.
    Subclasses are frozen dataclasses: their fields are their options.
    """

    pupils: ClassVar[str] = "lens"
    """Kind of supported pupils: of a ``"lens"``, of an ``"objective"``, or ``"any"``."""

    sampling: ClassVar[str] = "center"
    """``"center"``: values sample the pixel centres; ``"pixel"``: they are averages over pixels."""

    apodized: ClassVar[bool] = False
    """True if pupils with an apodization are supported."""

    nonradial: ClassVar[bool] = False
    """True if pupils whose phase or transmission depends on the direction are supported."""

    any_aperture: ClassVar[bool] = False
    """True if apertures with a spider, vignetting or a mask are supported."""

    cut_aperture: ClassVar[bool] = False
    """True if annular apertures with straight vanes are supported, where `Pupil.strips` are."""

    keeps_tol: ClassVar[bool] = True
    """True if error bounds, where available, include all errors (also of storing) and never exceed `tol`."""

    least_tol: ClassVar[float] = 1e-12
    """Smallest tolerance, of methods that have a tolerance."""

    most_tol: ClassVar[float] = 1e-1
    """Exclusive upper limit of the tolerance."""

    tol: float = 1e-6

    def __post_init__(self) -> None:
        if self._has_tol:
            tol = validation.real("tol", self.tol, least=self.least_tol, below=self.most_tol)
            object.__setattr__(self, "tol", tol)

    def unsupported(self, pupil: P) -> str | None:
        """Return the reason why `pupil` is not supported, or None; by default every pupil is supported."""
        return None

    @abstractmethod
    def intensity(self, pupil: P, grid: Grid, threads: int) -> Intensities:
        """Return I on `grid` for the flattened stack of `pupil`, with at most `threads` threads.

        The shape is ``(n, len(grid.radii))`` for values at the distinct radii, else ``(n, height, width)``.
        """

    def unaberrated_peak(self, pupil: P) -> float:
        """Return the peak of the aperture of `pupil` without aberration, the reference of "strehl"."""
        return float(pupil.amplitude**2)

    def stretch(self, pupil: P) -> float:
        """Return the exponential type (bandwidth) of U in v, divided by its value at the wavelength of `pupil`."""
        return 1.0

    def period(self, pupil: P) -> float:
        """Return the period of the image along x and y, in lambda*N: infinite unless images are sums of samples."""
        return pupil.period

    @property
    def reported(self) -> Method[P]:
        """Method named in results: this one, without the conditions under which it was chosen."""
        return self

    def with_tol(self, tol: float) -> Self:
        """Return the same method with another `tol`; TypeError or ValueError if it does not accept it."""
        if not self._has_tol:
            raise ValueError(
                f"tol={validation.shown(tol)} must be left out for {type(self).__name__}, which has no tolerance; "
                "name another method"
            )
        changed: Self = replace(self, tol=tol)  # type: ignore[type-var]
        return changed

    def tightened(self, tol: float | None = None) -> Self:
        """Return the method with half its tolerance, or with `tol`; unchanged without `tol` or `keeps_tol`."""
        if not (self._has_tol and self.keeps_tol):
            return self
        return self.with_tol(max(0.5 * self.tol if tol is None else tol, self.least_tol))

    @property
    def _has_tol(self) -> bool:
        return "tol" in getattr(self, "__dataclass_fields__", ())

    def components(self, pupil: P) -> list[Component]:
        """Return components with intensities that add up to the image of `pupil`: one, unless the method is a sum."""
        from lommel.optics.colour.spectrum import Component

        return [Component(1.0, 1.0, pupil)]

    def along_radius(self, pupil: P) -> RadialMethod[P] | None:
        """Return the method if a radial profile describes the whole PSF of `pupil`, else None."""
        return None

    def images(self, pupil: P, grid: Grid, wanted: Wanted) -> Samples:
        """Return the images of the flattened stack of `pupil` on `grid`, as specified by `wanted`.

        Raises ValueError for unavailable derivatives, ToleranceError if the tolerance cannot be met.
        """
        if wanted.powers or wanted.terms:
            raise ValueError(
                f"derivatives are not available from {type(self).__name__}; leave method out to use one that has them"
            )
        method = self
        result = method.intensity(pupil, grid, wanted.threads)
        while (
            self.keeps_tol and (error := with_storage_rounding(result, wanted)) is not None and error.max() > self.tol
        ):
            # Division of values by their largest value doubles the error: tol is then divided by 4, else by 2.
            tighter = method.tightened() if wanted.scale is not None else method.tightened().tightened()
            if tighter == method:
                raise not_met(self.tol, float(error.max()), "the peak")
            method = tighter
            result = method.intensity(pupil, grid, wanted.threads)
        return to_images(result, grid, wanted)

    def plan(self, pupil: P, grid: Grid, wanted: Wanted) -> Shortcut | None:
        """Return a prepared computation on `grid` for pupils that differ from `pupil` in their wavefronts only.

        `wanted` has neither `out` nor derivatives. The arguments of the returned function are a pupil and an array
        for the values. The function returns the scale of the values, of the shape of the pupil, and the largest error
        bound, or None if :meth:`images` must be called instead; it raises the exceptions of :meth:`images`. By
        default None is returned instead of a function.
        """
        return None

    def require(self, pupil: P) -> None:
        """Raise Declined, a ValueError, if `pupil` is not supported."""
        if self.pupils not in (kind := "objective" if imaged(pupil).layered else "lens", "any"):
            raise Declined(
                f"{type(self).__name__} supports the pupils of {_NOUN[self.pupils]} only, got the pupil of "
                f"{_NOUN[kind]}; leave method out for a method that supports it"
            )
        reason = self.unsupported(pupil)
        if reason is None and not (pupil.circular or self.any_aperture):
            if not self.cut_aperture:
                reason = "supports circular and annular apertures only; leave method out for other apertures"
            elif cast("Pupil", pupil).strips is None:
                reason = (
                    "supports circular and annular apertures only; vanes must part within the obscuration or, "
                    "without one, begin at the axis: leave method out for other apertures"
                )
        if reason is None and not (self.nonradial or pupil.radial):
            reason = "supports radially symmetric pupils only; this one has terms that depend on the direction"
        if reason is None and not (self.apodized or cast("Pupil", pupil).illumination.uniform):
            reason = "supports uniform illumination only; this pupil is apodized"
        if reason is not None:
            raise Declined(f"{type(self).__name__} {reason}")

    def to_dict(self) -> Json:
        """Return the method's name and options in plain types."""
        return to_plain_types(self)


def require_period(period: float, pupil: BasePupil, grid: Grid, *, edges: bool) -> None:
    """Raise ValueError if the window, up to pixel centres or (`edges`) pixel edges, exceeds the image's period."""
    if period == math.inf:
        return
    for pitch, side, positions in zip(grid.pitch, grid.shape, (grid.y, grid.x), strict=True):
        width = pitch * (side - (not edges)) / pupil.scale
        farthest = (float(np.abs(positions).max()) + (0.5 * pitch if edges else 0.0)) / pupil.scale
        # Windows of even sides extend half a pixel farther to one side than to the other.
        limit = 0.5 * (period + pitch / pupil.scale * (side % 2 == 0))
        if not (width <= period * (1.0 + 1e-9) and farthest <= limit * (1.0 + 1e-9)):
            raise beyond_period("the window", farthest, period)


def beyond_period(name: str, reach: float, period: float) -> ValueError:
    """Return the exception for the object `name` at `reach` lambda*N, beyond half the period of the image."""
    return ValueError(
        f"{name} reaches {reach:.4g} lambda*N from the axis, but the image of a sampled pupil repeats every "
        f"{period:.4g} lambda*N; stay within half of this, or use finer samples (or a Mask with squares=True)"
    )


def to_plain_types(instance: Any) -> Json:
    """Return the name and fields of a dataclass, including nested dataclasses, in plain types."""
    options = {item.name: getattr(instance, item.name) for item in fields(instance)}
    for name, value in options.items():
        if hasattr(value, "__dataclass_fields__"):
            options[name] = value.to_dict() if hasattr(value, "to_dict") else to_plain_types(value)
    return {"name": type(instance).__name__} | options


class RadialMethod(Method[P]):
    """A method for radially symmetric PSFs, which can be evaluated at any distance from the axis."""

    @abstractmethod
    def profile(self, pupil: P, v: Array) -> Intensities:
        """Return I at rising `v` for the flattened stack of `pupil`, shape ``(n, len(v))``.

        Raises ValueError or ToleranceError if the method cannot meet its contract.
        """

    def along_radius(self, pupil: P) -> RadialMethod[P] | None:
        """Return the method itself for a radial pupil, else None."""
        return self if pupil.radial else None

    def _ceiling(self, pupil: P) -> float:
        """Return an upper bound on the intensity of `pupil`."""
        return self.unaberrated_peak(pupil)

    def _likely_peak(self, pupil: P) -> float:
        """Estimate the lowest peak of the pupils of a stack."""
        return pupil.likely_peak

    def intensity(self, pupil: P, grid: Grid, threads: int) -> Intensities:
        """Return I at the distinct radii of `grid` or, if the grid is not symmetric, on its pixels."""
        if not grid.symmetric:
            return self.on_pixels(pupil, grid, threads)
        return self._threaded_profile(pupil, grid.v(pupil), threads)

    def _threaded_profile(self, pupil: P, v: Array, threads: int) -> Intensities:
        """Return :meth:`profile` with at most `threads` threads; most methods use one thread."""
        return self.profile(pupil, v)

    def images(self, pupil: P, grid: Grid, wanted: Wanted) -> Samples:
        """Return the images of the flattened stack; see :meth:`Method.images`."""
        if grid.symmetric or wanted.scale is not None or wanted.powers or self.along_radius(pupil) is None:
            return super().images(pupil, grid, wanted)
        # Division of values by their own largest value doubles their relative error.
        target = 0.48 * (self.tol - 1.1 * storing(wanted.dtype))
        return to_images(self.on_pixels(pupil, grid, wanted.threads, tol=target, window=True), grid, wanted)

    def on_pixels(
        self, pupil: P, grid: Grid, threads: int, *, tol: float | None = None, window: bool = False
    ) -> Intensities:
        """Return I at pixel centres of `grid`, or averaged over pixels, from the profile of `pupil`.

        `tol` bounds the error relative to the peak or, if `window`, to the largest value in the window; by default it
        is the tolerance of the method. Raises ToleranceError if the bound cannot be met. Profiles without an error
        bound are interpolated with an error of about 1e-10.
        """
        # I is band-limited (exponential type 2 in v) and differs from a constant by at most half its largest value.
        # Both properties bound the error of weighted sums of the profile: docs/certificate.md, section 9.
        allowed, method = self.tol if tol is None else tol, self
        # The largest value is about the peak of I or, for pixels that contain all light, the mean over such a pixel.
        side = grid.step(pupil) if grid.integrate else 0.0
        peak_estimate = 1.0 / (1.0 / self._likely_peak(pupil) + side**2 / (4.0 * math.pi * pupil.transmission))
        # Interpolation may use a fifth of the tolerance; its errors are relative to half the range of I.
        digits = math.ceil(-math.log10(0.2 * allowed * peak_estimate / (0.5 * self._ceiling(pupil))))
        level = min(max(digits, _LEVELS[0]), _LEVELS[-1])
        # The tolerance determines the level, except for profiles without an error bound.
        if self.profile(pupil, np.zeros(1)).error is None:
            level = _DEFAULT_LEVEL
        plane_peak, has_peak = np.zeros(math.prod(pupil.shape)), window
        while True:
            values, profile_error, sum_error = _pixel_sums(method, pupil, grid, level, threads)
            tops = values.max(axis=(1, 2))
            if profile_error is None:
                return Intensities(values, None, tops)
            error = profile_error + sum_error
            peak = np.maximum(tops - error, plane_peak)
            if not has_peak and np.any(error > allowed * peak):
                plane_peak, has_peak = _peak_at_least(method, pupil, grid, level, threads), True
                peak = np.maximum(peak, plane_peak)
            relative = np.divide(error, peak, out=np.full(peak.shape, np.inf), where=peak > 1e-300)
            k = int(relative.argmax())
            # A part of the error above a fifth of the tolerance is reduced: section 9, "Requested accuracy".
            part_limit = 0.2 * allowed * max(float(tops[k]), float(plane_peak[k]), 1e-3 * float(error[k]))
            settings = level, method
            if sum_error[k] > part_limit:
                level = max(level, min(_LEVELS[-1], level + math.ceil(math.log10(sum_error[k] / part_limit))))
            if profile_error[k] > part_limit:
                candidate = method.tightened().tightened().tightened()  # an eighth of the tolerance
                method = candidate if candidate.tol >= 1e-5 * self.tol else method
            unchanged = (level, method) == settings
            if relative[k] <= allowed or (unchanged and not self.keeps_tol):
                return Intensities(values, relative, peak)
            if unchanged:
                raise ToleranceError(
                    f"tol={self.tol:g} cannot be met: the error is bounded by {relative[k]:.2g} of the "
                    f"{'largest value in the window' if window else 'peak'}"
                )


def _pixel_sums(
    method: RadialMethod[P], pupil: P, grid: Grid, level: int, threads: int
) -> tuple[Array, Array | None, Array]:
    """Return values of pixels, and two parts of their error bound: due to the profile, and due to the sums."""
    # I of bandwidth ``2 stretch`` equals an intensity of bandwidth 2 on a window that is `stretch` times as large.
    # `stretch` and `ceiling` (range of I) are the units of all bounds of section 9.
    stretch, ceiling = method.stretch(pupil), method._ceiling(pupil)
    window = Window(grid.shape, grid.axis, stretch * grid.step(pupil))
    v, error, of_nodes, of_grid, rounding = pixel_radii(window, grid.integrate, level, threads)
    profile = method.profile(pupil, v / stretch)
    values, penalties = pixel_values(window, profile.values, grid.integrate, level, threads)
    # Clamp to 0: averages of an intensity are not negative, and clamping does not increase the error.
    np.maximum(values, 0.0, out=values)
    size = profile.values.max(axis=1)
    # |I'| = 2 |U| |U'|, and |U'| < 1/2; a few roundings displace radii, positions in a pixel, and pixels.
    slope = np.sqrt(of_nodes * size * max(1.0, ceiling))
    position_error = float(v[-1]) * slope * (3.0 * of_grid * of_nodes + 6.0 * of_grid + 4.0)
    sum_error = 0.5 * ceiling * error + 2.0**-53 * (rounding * size + penalties + position_error)
    if profile.error is None:
        return values, None, sum_error
    peak = size if profile.peak is None else profile.peak
    return values, of_grid * of_nodes * profile.error * peak, sum_error


def _peak_at_least(method: RadialMethod[P], pupil: P, grid: Grid, level: int, threads: int) -> Array:
    """Return a lower bound on the largest value in the plane, from a line between the axis and the outermost ray."""
    # The outermost ray arrives at the largest slope of the phase; diffraction moves the peak by a few units of v.
    blur = float(pupil.v(pupil.geometric_radius()).max()) + 4.0
    pixel = grid.side if grid.integrate else blur / _LINE_STEPS / grid.step(pupil) * grid.side
    count = min(_LINE_STEPS, math.ceil(blur / (grid.step(pupil) * pixel / grid.side))) + 1
    line = Grid((1, count), pixel, center=(0.0, 0.0), integrate=grid.integrate)
    values, profile_error, sum_error = _pixel_sums(method, pupil, line, level, threads)
    assert profile_error is not None
    return np.asarray(values.max(axis=(1, 2)) - profile_error - sum_error)


class FieldMethod(RadialMethod[P]):
    """A radial method that computes the complex field."""

    @abstractmethod
    def evaluate(self, pupil: P, v: Array) -> FieldValues:
        """Return U at rising `v` for the flattened `pupil`, shape ``(n, len(v))``, with a bound on its error.

        Raises ValueError or ToleranceError if the method cannot meet its contract.
        """

    def field(self, pupil: P, v: ArrayLike) -> NDArray[np.complex128]:
        """Return the complex field U of a `pupil` at optical coordinates `v`, shape ``pupil.shape + v.shape``.

        Raises TypeError or ValueError unless the coordinates are finite numbers >= 0.
        """
        self.require(pupil)
        points = validation.real_array("v", v, least=0.0) + 0.0  # no -0
        values, index = np.unique(_radii(points.ravel()), return_inverse=True)
        return self.evaluate(pupil, values).values[:, index].reshape(pupil.shape + points.shape)

    def profile(self, pupil: P, v: Array) -> Intensities:
        """Return I = abs(U)^2 at rising v with the bound on its error relative to the largest value."""
        return squared(self.evaluate(pupil, v))


def squared(field: FieldValues) -> Intensities:
    """Return I = abs(U)^2 with the bound on its error relative to the largest value."""
    intensity = field.values.real**2 + field.values.imag**2
    relative = None if field.error is None else relative_error(intensity, field.error)
    return Intensities(intensity, relative, intensity.max(axis=1))


def relative_error(intensity: Array, field_error: Array) -> Array:
    """Bound ``max abs(I - I_exact) / max I_exact`` from a bound e on abs(U - U_exact)."""
    # (2 M e + e^2) / (M - e)^2, with M the largest computed abs(U); the largest exact one is >= M - e: certificate,
    # section 6.
    peak = np.sqrt(intensity.max(axis=1))
    exact = peak - field_error
    error = field_error * (2.0 * peak + field_error)
    return np.asarray(np.divide(error, exact**2, out=np.full(peak.shape, np.inf), where=exact > 1e-150))


def storing(dtype: DTypeLike) -> float:
    """Bound the error, relative to the peak, of scaling and storing values in the compiled core."""
    # Six roundings: two squares and their sum, the scale and the product with it (certificate, section 6, "Storing").
    return 6.0 * 2.0**-53 + (2.0**-24 if np.dtype(dtype) == np.float32 else 0.0)


def stored(relative: Array, dtype: DTypeLike) -> Array:
    """Bound the error of stored values from their error `relative` before storing; units of the peak."""
    return np.asarray(relative + (1.0 + relative) * storing(dtype))


def with_storage_rounding(result: Intensities, wanted: Wanted) -> Array | None:
    """Bound the error of images after scaling (a scale of None makes the largest value 1) and storing."""
    if result.error is None:
        return None
    return stored(normalized_error(result.error) if wanted.scale is None else result.error, wanted.dtype)


def to_images(result: Intensities, grid: Grid, wanted: Wanted) -> Samples:
    """Return intensities, at the radii of `grid` or on its pixels, as images; see :meth:`Method.images`."""
    largest = result.values.reshape(len(result.values), -1).max(axis=1)
    if wanted.scale is None and not np.all(largest > 0):
        raise ValueError('normalize="peak" is impossible: no light falls into the window')
    scales = np.broadcast_to(wanted.scale, largest.shape) if wanted.scale is not None else 1.0 / largest
    values = np.empty((len(largest), *grid.shape), wanted.dtype) if wanted.out is None else wanted.out
    grid.paint(result.values, scales, values, wanted.threads)
    return Samples(values, scales, with_storage_rounding(result, wanted), None, result.peak)


def normalized_error(relative: Array) -> Array:
    """Bound the error of values divided by their largest value, from their error `relative` before division."""
    # 2 r / (1 - r): a value and the largest value that divides it both have errors of at most r.
    clipped = np.minimum(relative, 1.0 - 1e-9)
    return np.asarray(np.where(relative < 1.0 - 1e-9, 2.0 * clipped / (1.0 - clipped), np.inf))


def with_model_error(result: Samples, pupil: BasePupil, method: Method, *, normalized: bool) -> Samples:
    """Return images whose bounds include the truncation errors of the terms of wavefront and apodization."""
    # Certificate, "Model error of a wavefront": a phase error e changes U, and its derivatives, by at most e int A
    # dx dy / pi. At the shorter wavelengths of a spectrum both e and U are larger. An amplitude error e A has the
    # same effect, and counts twice: it also changes the peak or the light by which values are divided.
    phase_error, light_error = pupil.left_out
    if not (phase_error or light_error) or result.error is None:
        return result
    stretch = max(1.0, method.stretch(pupil))
    omitted = np.asarray((phase_error * stretch + 2.0 * light_error) * pupil.amplitude * stretch)
    brightest = result.values.reshape(len(result.values), -1).max(axis=1).astype(np.float64) / result.scale
    relative = relative_error(brightest[:, None], omitted)
    error = result.error + (normalized_error(relative) if normalized else relative)
    if method.keeps_tol and error.max() > method.tol >= result.error.max():
        raise ToleranceError(
            f"tol={method.tol:g} cannot be met: the terms of the wavefront leave up to {phase_error:.2g} rad of the "
            f"phase out, the terms of the apodization {light_error:.2g} of the amplitude, so that the error bound is "
            f"{error.max():.2g} of the peak; use a larger tol"
        )
    if result.slopes is None:
        return result._replace(error=error)
    slope_error = 4.0 * omitted * pupil.amplitude / brightest
    return result._replace(error=error, slopes=result.slopes._replace(error=result.slopes.error + slope_error))


def powers_cancel(pupil: Pupil) -> str | None:
    """Return the reason why powers of rho would lose too many digits of the phase, else None."""
    from lommel.optics.wavefront.wavefront import MAX_HIGHER  # imported on use

    if pupil.wavefront.symmetric <= 2 + MAX_HIGHER:
        return None
    return (
        f"expands the phase in powers of rho up to {2 * (2 + MAX_HIGHER)}, which cancel for radially symmetric terms "
        "of higher degree; use NijboerZernike"
    )


def annulus(disk: Callable[[Array, Array], FieldValues], pupil: Pupil, v: Array) -> FieldValues:
    """Return the field of an obscured aperture from fields of disks, ``U(v) = U_disk(v) - eps^2 U_inner(eps v)``."""
    # The inner disk has the phase of rho < eps, coefficients c_k eps^(2k): certificate, section 5.
    coefficients = pupil.coefficients()
    outer = disk(coefficients, v)
    if pupil.obscuration == 0.0:
        return outer
    area = pupil.obscuration**2
    powers = area ** np.arange(1, 1 + coefficients.shape[1])
    inner = disk(coefficients * powers, pupil.obscuration * v)
    error = None if outer.error is None or inner.error is None else outer.error + area * inner.error
    return FieldValues(outer.values - area * inner.values, error)
