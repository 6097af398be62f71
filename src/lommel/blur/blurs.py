r"""Blurs as factors of the transfer function: seeing, jitter (also charge diffusion), motion.

A blur is a probability density b(r) of image shifts r. The blurred image is the convolution ``I * b``
(convolution.py). The transfer function T of the blur, which multiplies the OTF, is the Fourier transform of b(r).
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import asdict, dataclass
from typing import ClassVar

import numpy as np
import scipy
from numpy.typing import ArrayLike

from lommel.base import validation
from lommel.base.arrays import Array, Json, Numbers, numbers
from lommel.base.validation import EITHER
from lommel.optics.base_pupil import BasePupil

KOLMOGOROV = (4.8 * math.gamma(1.2)) ** (5.0 / 6.0)
"""Constant 3.441939 of Kolmogorov's transfer function ``exp(-KOLMOGOROV q^(5/3))``, q = f / coherence frequency.

It is half of Fried's constant, ``2 (24/5 Gamma(6/5))^(5/6) = 6.883877``.
"""
FWHM = 0.9758634299
"""Full width at half maximum of a star through Kolmogorov's turbulence, in units of wavelength / r0.

It is 2 x for the x at which ``int exp(-KOLMOGOROV q^(5/3)) J0(2 pi x q) q dq`` is half of its value at x = 0. A test
computes it by mpmath, to 25 digits, with the substitution q = s^3, which makes the integrand analytic.
"""
_NU = 5.0 / 6.0  # order of the Bessel function of von Karman's structure function, half of the exponent 5/3


def frequencies(fx: ArrayLike, fy: ArrayLike, unit: str = "") -> tuple[Array, Array]:
    """Return validated spatial frequencies along x (columns) and y (rows), broadcast; `unit` is that of a length."""
    per = "1/metres" if unit == "m" else ""
    x, y = (validation.real_array(name, f, unit=per) for name, f in (("fx", fx), ("fy", fy)))
    x, y = validation.broadcast("fx and fy", x, y)
    return x, y


class Blur:
    """Blur described by its transfer function; lengths in metres, or in lambda*N for pupils without wavelength.

    Subclasses define `covariance` and `streak`, from which `transfer`, PSFs and error bounds are computed; only
    :class:`Seeing` overrides `transfer`. `length_names` lists the parameters that are lengths on the sensor.
    """

    metric: ClassVar[bool | None] = None  # whether the pupil must have a wavelength; None for either
    length_names: ClassVar[tuple[str, ...]]

    def __init_subclass__(cls) -> None:
        if "transfer" in vars(cls) and cls.__module__ != __name__:
            raise TypeError(
                f"{cls.__name__} must define covariance and streak, not transfer: PSFs are computed from covariance "
                "and streak"
            )
        if "length_names" not in vars(cls):
            raise TypeError(
                f"{cls.__name__} must define length_names, the names of its parameters that are lengths on the sensor"
            )

    def transfer(self, fx: ArrayLike, fy: ArrayLike = 0.0, *, wavelength: float | None = None) -> Numbers:
        """Return the transfer function at frequencies along columns and rows.

        Parameters
        ----------
        fx, fy : array_like
            Spatial frequencies, cycles per metre or per lambda*N, of broadcastable shapes.
        wavelength : float, optional
            Wavelength of the light, metres; only :class:`lommel.Seeing` depends on it.

        Returns
        -------
        float or ndarray
            Real, 1 at frequency 0: ``exp(-2 pi^2 f.C f) sinc(f.d)`` with the covariance C and the streak d.

        Raises
        ------
        TypeError, ValueError
            If the frequencies are not finite, or do not broadcast.
        """
        x, y = frequencies(fx, fy)
        (xx, xy), (_, yy) = self.covariance
        dx, dy = self.streak
        # The Gaussian and the uniform streak are independent: T is the product of their characteristic functions.
        result = np.ones(x.shape)
        if xx or yy:
            result = result * np.exp(-2.0 * math.pi**2 * (xx * x * x + 2.0 * xy * x * y + yy * y * y))
        if dx or dy:
            result = result * np.sinc(x * dx + y * dy)
        return numbers(result, x.shape)

    @property
    def covariance(self) -> Array:
        """Covariance matrix of the Gaussian part, in (x, y)."""
        return np.zeros((2, 2))

    @property
    def streak(self) -> tuple[float, float]:
        """Vector (x, y) from one end of a uniform linear streak to the other."""
        return 0.0, 0.0

    @property
    def isotropic(self) -> bool:
        """Whether the blur is the same in all directions."""
        (xx, xy), (_, yy) = self.covariance
        # Because of rounding in a rotation, xy of a round Gaussian may be about 1e-16 times the variance.
        return self.streak == (0.0, 0.0) and bool(abs(xy) <= 1e-15 * xx and abs(xx - yy) <= 1e-15 * xx)

    @property
    def lengths(self) -> tuple[float, ...]:
        """Values of the parameters that are lengths on the sensor; `require_unit` checks their unit."""
        return tuple(vars(self)[name] for name in self.length_names)

    def to_dict(self) -> Json:
        """Return the name and the parameters of the blur in plain types."""
        return {"name": type(self).__name__} | asdict(self)  # type: ignore[call-overload, no-any-return]


@dataclass(frozen=True)
class Seeing(Blur):
    r"""Long-exposure seeing of a turbulent atmosphere (Kolmogorov or von Karman).

    The transfer function is ``T = exp(-D / 2)``, where D is the phase structure function at the separation
    ``s = wavelength * focal_length * f`` in the aperture. Without an outer scale, ``D / 2 = 3.441939 (s / r0)^(5/3)``
    (Kolmogorov, Fried); the constant ``(24/5 Gamma(6/5))^(5/6)`` is half of the 6.88 of textbooks. With an outer
    scale, D is the structure function of von Karman's spectrum.

    Parameters
    ----------
    r0 : float
        Fried parameter at `wavelength`, metres at the entrance pupil. For pupils without a wavelength, the Fried
        parameter divided by the diameter of the aperture.
    focal_length : float, optional
        Focal length in metres, for pupils with a wavelength; must be given together with `wavelength`.
    wavelength : float, optional
        Wavelength at which `r0` is stated, metres. At another wavelength r0 is multiplied by
        ``(other / wavelength)^(6/5)``.
    outer_scale : float, optional
        Outer scale, in the unit of `r0`; by default infinite (Kolmogorov).

    Raises
    ------
    TypeError, ValueError
        If a number is not above 0, or only one of `focal_length` and `wavelength` is given.

    References
    ----------
    D. L. Fried, J. Opt. Soc. Am. 56, 1372 (1966), doi:10.1364/JOSA.56.001372. A. Tokovinin, Publ. Astron. Soc. Pac.
    114, 1156 (2002), doi:10.1086/342683, for the outer scale.

    Examples
    --------
    >>> import lommel as lm
    >>> air = lm.Seeing.from_fwhm(4.85e-6, focal_length=8.0, wavelength=500e-9)  # 1 arcsec
    >>> round(air.r0, 4)
    0.1006
    """

    length_names: ClassVar = ()  # r0 is a length at the pupil
    r0: float
    focal_length: float | None = None
    wavelength: float | None = None
    outer_scale: float | None = None

    def __post_init__(self) -> None:
        # The dataclass is frozen: converted values are written to the dictionary of the instance.
        vars(self)["r0"] = validation.real("r0", self.r0, above=0.0, unit="metres")
        if self.outer_scale is not None:
            outer = validation.real("outer_scale", self.outer_scale, above=0.0, infinite=True, unit="metres")
            vars(self)["outer_scale"] = None if math.isinf(outer) else outer
        # With only one of the two, the unit of r0 would be ambiguous: metres, or diameters of the aperture.
        if (self.focal_length is None) != (self.wavelength is None):
            raise ValueError(
                "focal_length and wavelength must be given together (r0 in metres) or not at all (r0 divided by the "
                f"diameter), got focal_length={self.focal_length!r}, wavelength={self.wavelength!r}"
            )
        if self.wavelength is not None:
            vars(self)["wavelength"] = validation.wavelength(self.wavelength)
            vars(self)["focal_length"] = validation.real("focal_length", self.focal_length, above=0.0, unit="metres")

    @classmethod
    def from_fwhm(
        cls, fwhm: float, focal_length: float, wavelength: float = 500e-9, outer_scale: float | None = None
    ) -> Seeing:
        """Return the seeing of a given full width at half maximum, ``0.9758634299 wavelength / r0``.

        Parameters
        ----------
        fwhm : float
            Seeing FWHM in radians (1 arcsec is 4.848e-6), for a large telescope and an infinite outer scale.
        focal_length, wavelength, outer_scale : float
            See :class:`lommel.Seeing`.

        Returns
        -------
        Seeing

        Raises
        ------
        TypeError, ValueError
            If a number is out of range.
        """
        width = validation.real("fwhm", fwhm, above=0.0, below=0.1, unit="radians")
        return cls(FWHM * validation.wavelength(wavelength) / width, focal_length, wavelength, outer_scale)

    @property
    def metric(self) -> bool:  # type: ignore[override]
        """Whether the pupil must have a wavelength (True) or must not (False)."""
        return self.wavelength is not None

    def coherence(self, wavelength: float | None = None) -> float:
        """Return the coherence frequency ``r0 / (wavelength focal_length)``, cycles per metre, or per lambda*N."""
        if self.wavelength is None or self.focal_length is None:
            return self.r0
        # r0 is proportional to wavelength^(6/5) (Fried), and r0 / wavelength to wavelength^(1/5).
        colour = 1.0 if wavelength is None else wavelength / self.wavelength
        return float(self.r0 * colour**0.2 / (self.wavelength * self.focal_length))

    def transfer(self, fx: ArrayLike, fy: ArrayLike = 0.0, *, wavelength: float | None = None) -> Numbers:
        """Return the transfer function at `fx`, `fy` and a `wavelength`; see :class:`~lommel.blur.blurs.Blur`.

        Raise TypeError or ValueError if numbers are not finite, or the shapes of `fx` and `fy` are not broadcastable.
        """
        x, y = frequencies(fx, fy)
        metres = None if wavelength is None else validation.wavelength(wavelength)
        q = np.hypot(x, y) / self.coherence(metres)
        if self.outer_scale is None:
            return numbers(np.exp(-KOLMOGOROV * q ** (5.0 / 3.0)), x.shape)
        factor, rate = karman(self, metres)
        return numbers(np.exp(-_von_karman(rate * q, factor)), x.shape)


def karman(air: Seeing, wavelength: float | None) -> tuple[float, float]:
    """Return (s, a) of half of von Karman's structure function, ``s (limit - z^nu K_nu(z))``, z = a q, nu = 5/6.

    q is the frequency divided by the coherence frequency; limit is the value of z^nu K_nu(z) at z = 0.
    """
    assert air.outer_scale is not None
    # r0 is proportional to wavelength^(6/5); the outer scale does not depend on the wavelength.
    colour = 1.0 if wavelength is None or air.wavelength is None else (wavelength / air.wavelength) ** 1.2
    ratio = air.outer_scale / (air.r0 * colour)
    # Normalised such that for small z the result approaches Kolmogorov's law, KOLMOGOROV q^(5/3).
    factor = 0.5 * KOLMOGOROV * ratio ** (5.0 / 3.0) * 2.0 ** (1.0 / 6.0)
    return factor * math.gamma(11.0 / 6.0) / math.pi ** (8 / 3), 2.0 * math.pi / ratio


def _von_karman(argument: Array, factor: float) -> Array:
    """Return ``factor (limit - z^nu K_nu(z))`` at z, half of the structure function; see :func:`karman`."""
    z = np.atleast_1d(argument)
    # lim z^nu K_nu(z) = 2^(nu - 1) Gamma(nu) for z -> 0, nu - 1 = -1/6.
    limit = math.gamma(_NU) / 2.0 ** (1.0 / 6.0)
    # z is limited to 700, where K_nu has not underflowed, and the structure function equals its limit to all digits.
    large_z = np.minimum(np.maximum(z, 1.0), 700.0)
    bessel = np.where(z > 1.0, limit - large_z**_NU * scipy.special.kv(_NU, large_z), 0.0)
    # For small z the difference would lose digits: K_nu is replaced by two series in z^2 / 4 (DLMF 10.27.4, 10.25.2),
    # without the first term of the even series, which cancels the limit. 14 terms yield all digits for z <= 1.
    k, small_z = np.arange(14)[:, None], np.minimum(z, 1.0).ravel()
    powers = (0.25 * small_z * small_z) ** k / scipy.special.gamma(k + 1.0)
    fractional = (powers / scipy.special.gamma(k + 1.0 + _NU)).sum(axis=0) * small_z ** (2.0 * _NU) * 2.0**-_NU
    even = (powers[1:] / scipy.special.gamma(k[1:] + 1.0 - _NU)).sum(axis=0) * 2.0**_NU
    series = 0.5 * math.pi / math.sin(math.pi * _NU) * (fractional - even)
    return np.asarray(factor * np.where(z > 1.0, bessel, series.reshape(z.shape))).reshape(argument.shape)


@dataclass(frozen=True)
class Jitter(Blur):
    """A round or elliptical Gaussian: telescope jitter or hand shake during a long exposure, charge diffusion.

    Parameters
    ----------
    sigma : float
        Standard deviation of the image position in the direction `angle`: metres on the sensor, or units of lambda*N
        for a pupil without a wavelength. For an angular jitter: standard deviation in radians times the focal length.
    across : float, optional
        Standard deviation at right angles to `angle`, in the same unit; by default `sigma`.
    angle : float, default 0
        Direction of `sigma` in radians, from the x axis (along a row) towards the y axis (down a column).

    Raises
    ------
    TypeError, ValueError
        If a number is not finite, or a standard deviation is negative.
    """

    length_names: ClassVar = ("sigma", "across")
    sigma: float
    across: float | None = None
    angle: float = 0.0

    def __post_init__(self) -> None:
        # By default the Gaussian is round.
        across = self.sigma if self.across is None else self.across
        vars(self)["sigma"] = validation.real("sigma", self.sigma, least=0.0, unit=EITHER)
        vars(self)["across"] = validation.real("across", across, least=0.0, unit=EITHER)
        vars(self)["angle"] = validation.angle("angle", self.angle)

    @property
    def covariance(self) -> Array:
        """Covariance matrix of the position (x, y)."""
        along, across = self.lengths
        c, s = math.cos(self.angle), math.sin(self.angle)
        # C = R diag(along^2, across^2) R^T, where R is the rotation from the axes of the ellipse to (x, y).
        turn = np.array([[c, -s], [s, c]])
        return np.asarray(turn @ np.diag([along**2, across**2]) @ turn.T)


@dataclass(frozen=True)
class Motion(Blur):
    """Uniform linear motion during the exposure (motion blur).

    Parameters
    ----------
    length : float
        Length of the path, centred on the unblurred image: metres on the sensor, or units of lambda*N for a pupil
        without a wavelength.
    angle : float, default 0
        Direction of the motion in radians, from the x axis (along a row) towards the y axis (down a column).

    Raises
    ------
    TypeError, ValueError
        If a number is not finite, or the length is negative.
    """

    length_names: ClassVar = ("length",)
    length: float
    angle: float = 0.0

    def __post_init__(self) -> None:
        vars(self)["length"] = validation.real("length", self.length, least=0.0, unit=EITHER)
        vars(self)["angle"] = validation.angle("angle", self.angle)

    @property
    def streak(self) -> tuple[float, float]:
        """Vector (x, y) from one end of the path to the other."""
        return self.length * math.cos(self.angle), self.length * math.sin(self.angle)


KINDS: dict[str, type[Blur]] = {kind.__name__: kind for kind in (Seeing, Jitter, Motion)}


def blurs(value: object) -> tuple[Blur, ...]:
    """Return one or several blurs as a tuple, empty for None; TypeError for other values."""
    if value is None:
        return ()
    items = (value,) if isinstance(value, Blur) else value
    # A string is iterable, but the message must show the whole string, not its first letter.
    if not isinstance(items, Iterable) or isinstance(items, str | bytes):
        raise TypeError(f"blur must be one or several of {', '.join(KINDS)}, got {validation.shown(value)}")
    checked = tuple(items)
    for blur in checked:
        if type(blur) not in KINDS.values():
            raise TypeError(f"blur must be made of {', '.join(KINDS)}, got {validation.shown(blur)}")
    return checked


def blurs_from_dicts(descriptions: Iterable[Json]) -> tuple[Blur, ...]:
    """Rebuild blurs from the dictionaries of :meth:`Blur.to_dict`; TypeError or ValueError if one is not valid."""
    rebuilt = []
    for description in descriptions:
        parameters = dict(description)
        rebuilt.append(KINDS[validation.choice("name", parameters.pop("name"), KINDS)](**parameters))
    return tuple(rebuilt)


def require_unit(blurs: tuple[Blur, ...], pupil: BasePupil) -> None:
    """Raise ValueError if a blur is in metres and a pupil in units of lambda*N, or the other way round."""
    metric = pupil.wavelength is not None
    for blur in blurs:
        if blur.metric is not None and blur.metric != metric:
            advice = (
                "focal_length and wavelength"
                if metric
                else "only r0 divided by the diameter, as the pupil has no wavelength"
            )
            raise ValueError(f"blur must fit the unit of the pupil, {pupil.unit}: give Seeing {advice}, got {blur!r}")
        for length in blur.lengths:
            # Ratios beyond these limits indicate a wrong unit, such as metres for lambda*N or millimetres.
            ratio = length / pupil.scale
            if length and (not ratio <= 1e4 or (not metric and ratio < 1e-4)):
                raise ValueError(
                    f"blur must be at most 1e4 lambda*N wide, and lengths are in {pupil.unit} here, got {blur!r}, "
                    f"that is {ratio:.3g} lambda*N; check its unit"
                )
