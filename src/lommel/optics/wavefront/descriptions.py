"""The wavefronts people have: Zernike coefficients in every order, Seidel coefficients, balanced aberrations."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from os import PathLike
from typing import TYPE_CHECKING, Any, Self

import numpy as np
from numpy.typing import ArrayLike

from lommel.base import display, validation
from lommel.base.arrays import Array
from lommel.optics.wavefront.terms import Terms, coefficients
from lommel.special import zernike

if TYPE_CHECKING:
    from matplotlib.axes import Axes

UNITS = ("radians", "waves", "metres")
NORMALIZATIONS = ("rms", "edge")


class Descriptions(display.Shown, Terms):
    """What :class:`lommel.Wavefront` is made from, and what it can be told in."""

    if TYPE_CHECKING:
        # Of Wavefront.
        def __init__(self, *parts: Any) -> None: ...

    @classmethod
    def zernike(
        cls,
        terms: Mapping[Any, ArrayLike] | Iterable[tuple[Any, ArrayLike]],
        *,
        order: str = "nm",
        unit: str = "radians",
        normalization: str = "rms",
        wavelength: float | None = None,
        error: float = 0.0,
    ) -> Self:
        """Build a wavefront from Zernike coefficients.

        Parameters
        ----------
        terms : mapping, or iterable of pairs
            Coefficients by index: pairs (n, m) for the order "nm", else integers. Arrays describe a stack. A
            constant term (piston) is allowed and left out, as everywhere. Terms end with n = 60.
        order : {"nm", "noll", "ansi", "fringe"}, default "nm"
            Noll counts from 1, ANSI (OSA) from 0, Fringe (University of Arizona) from 1 to 37. m > 0 is the cosine
            of m theta, m < 0 the sine.
        unit : {"radians", "waves", "metres"}, default "radians"
            Of the coefficients; metres of optical path need `wavelength`.
        normalization : {"rms", "edge"}, default "rms"
            "rms": a coefficient is the root mean square of its term over the pupil (Noll, ANSI). "edge": it is the
            largest value, that at the edge (usual with Fringe).
        wavelength : float, optional
            Metres.
        error : float, default 0
            Bound on what the terms leave out of the phase, radians; see :class:`lommel.Wavefront`.

        Returns
        -------
        Wavefront

        Raises
        ------
        TypeError, ValueError
            If there is no such term or a term comes twice; the message names the term.

        References
        ----------
        R. J. Noll, J. Opt. Soc. Am. 66, 207 (1976), doi:10.1364/JOSA.66.000207.

        Examples
        --------
        >>> Wavefront.zernike({7: 0.1}, order="noll", unit="waves").nonradial[3, -1]
        array(1.77715318)
        """
        scale = radians_per(unit, wavelength)
        validation.choice("normalization", normalization, NORMALIZATIONS)
        found: dict[tuple[int, int], Array] = {}
        for index, value in _pairs(terms):
            n, m = zernike.term(index, order)
            if (n, m) in found:
                raise ValueError(f"the Zernike term {index!r}, (n, m) = ({n}, {m}), comes twice")
            factor = scale * (zernike.rms_factor(n, m) if normalization == "rms" else 1.0)
            given = coefficients(f"the Zernike coefficient {index!r}", value)
            with np.errstate(over="ignore"):  # told, as all that is not finite
                found[n, m] = factor * given
        return cls.from_edge(found, validation.real("error", error, least=0.0))

    def to_zernike(
        self,
        *,
        order: str = "nm",
        unit: str = "radians",
        normalization: str = "rms",
        wavelength: float | None = None,
    ) -> dict[Any, Array]:
        """Return the Zernike coefficients, by index; the inverse of :meth:`zernike`.

        Every coefficient has the shape of the stack. Exact but for rounding. Without the constant term (piston),
        which a wavefront does not hold. Terms that are zero throughout a stack are left out.

        Parameters
        ----------
        order, unit, normalization, wavelength
            As of :meth:`zernike`.

        Returns
        -------
        dict of index to ndarray

        Raises
        ------
        ValueError
            If a term has no index in `order` (Fringe ends with 37).
        """
        scale = radians_per(unit, wavelength)
        validation.choice("normalization", normalization, NORMALIZATIONS)
        found = {}
        for (n, m), c in self.edge_terms().items():
            if np.any(c):
                factor = scale * (zernike.rms_factor(n, m) if normalization == "rms" else 1.0)
                found[zernike.index_of(n, m, order)] = np.broadcast_to(c / factor, self.shape)
        return found

    def save(self, path: str | PathLike[str], **how: Any) -> None:
        """Write the Zernike coefficients of a single wavefront to a `path` ending in .csv, .json or .toml.

        :func:`lommel.load_zernike` reads them. `how` may name the order ("noll" by default), the unit ("waves"), the
        normalization ("rms") and the wavelength; see :func:`lommel.save_zernike`.
        """
        display.save(self, path, **how)

    def plot(self, ax: Axes | None = None, *, unit: str = "waves") -> Any:
        """Draw the phase across the full disc on axes of matplotlib; a stack on one scale.

        See :func:`lommel.show.pupils.wavefront`.
        """
        return display.plot(self, ax, unit=unit)

    @classmethod
    def from_seidel(
        cls,
        W020: ArrayLike = 0.0,
        W040: ArrayLike = 0.0,
        W060: ArrayLike = 0.0,
        W080: ArrayLike = 0.0,
        *,
        W131: ArrayLike = 0.0,
        W222: ArrayLike = 0.0,
        W220: ArrayLike = 0.0,
        W311: ArrayLike = 0.0,
        field: tuple[ArrayLike, ArrayLike] = (1.0, 0.0),
    ) -> Self:
        """Build a wavefront from Seidel wavefront coefficients in waves at the edge of the pupil.

        ``W = W020 rho^2 + W040 rho^4 + W131 H rho^3 cos(phi) + W222 H^2 rho^2 cos^2(phi) + W220 H^2 rho^2
        + W311 H^3 rho cos(phi)``, with H the length of `field` and phi the angle from its direction.
        ``C_d = pi W020`` and ``C_s = 2 pi W040``: W020 waves of defocus are ``2 pi W020 rho^2`` radians.

        Parameters
        ----------
        W020, W040, W060, W080 : array_like
            Defocus and spherical aberration, waves.
        W131, W222, W220, W311 : array_like
            Coma, astigmatism, field curvature and distortion, waves at the edge of the field (H = 1).
        field : (array_like, array_like), default (1, 0)
            Position in the field as (x, y), columns and rows, over that of the edge. Arrays describe a stack.

        Returns
        -------
        Wavefront

        Raises
        ------
        TypeError, ValueError
            If a coefficient is not real and finite, or they do not broadcast.

        References
        ----------
        W. T. Welford, Aberrations of Optical Systems (1986), doi:10.1201/9780203755327, section 8.2.
        """
        waves = {"W020": W020, "W040": W040, "W060": W060, "W080": W080}
        waves |= {"W131": W131, "W222": W222, "W220": W220, "W311": W311}
        # A coefficient that is beyond the range in radians becomes infinite, which is told.
        with np.errstate(over="ignore"):
            radians = {name: 2 * math.pi * coefficients(name, value) for name, value in waves.items()}
        w = {name: validation.real_array(name, value) for name, value in radians.items()}
        if not isinstance(field, tuple | list) or len(field) != 2:
            raise TypeError(f"field must be a pair (x, y), got {validation.shown(field)}")
        x, y = validation.real_array("field[0]", field[0]), validation.real_array("field[1]", field[1])
        higher = [w["W060"], w["W080"]]
        while higher and not np.any(higher[-1]):
            higher.pop()
        try:
            shape = np.broadcast_shapes(x.shape, y.shape, *(c.shape for c in w.values()))
            square = x * x + y * y
            defocus = w["W020"] + (w["W220"] + 0.5 * w["W222"]) * square
            # rho^3 cos = (R_3^1 cos + 2 rho cos) / 3, and H^2 rho^2 cos^2 = H^2 rho^2 / 2 + H^2 rho^2 cos(2 phi) / 2.
            tilt = 2.0 / 3.0 * w["W131"] + w["W311"] * square
            terms = {
                (1, 1): tilt * x,
                (1, -1): tilt * y,
                (3, 1): w["W131"] / 3.0 * x,
                (3, -1): w["W131"] / 3.0 * y,
                (2, 2): 0.5 * w["W222"] * (x * x - y * y),
                (2, -2): w["W222"] * x * y,
            }
        except ValueError:
            shapes = {name: c.shape for name, c in (w | {"field[0]": x, "field[1]": y}).items() if c.shape}
            raise ValueError(f"the coefficients and field must broadcast, got shapes {shapes}") from None
        others = {term: c for term, c in terms.items() if np.any(c)}
        return cls(np.broadcast_to(0.5 * defocus, shape), w["W040"], higher, others)

    @classmethod
    def balanced_spherical(cls, rms: ArrayLike, obscuration: float = 0.0) -> Self:
        r"""Build primary spherical aberration of a given rms, balanced with the defocus of least variance.

        On the annulus ``eps <= rho <= 1`` this is the annular Zernike term
        ``C_s (rho^4 - (1 + eps^2) rho^2 + ...)`` with ``C_s = 6 sqrt(5) rms / (1 - eps^2)^2``.

        Parameters
        ----------
        rms : array_like
            Root mean square phase over the annulus, radians; its sign is that of C_s.
        obscuration : float
            eps, 0 to below 1.

        Returns
        -------
        Wavefront

        Raises
        ------
        TypeError, ValueError
            If an argument is out of range, or the coefficient overflows.

        References
        ----------
        V. N. Mahajan, "Zernike annular polynomials for imaging systems with annular pupils",
        J. Opt. Soc. Am. 71, 75 (1981), doi:10.1364/JOSA.71.000075.
        """
        eps = validation.real("obscuration", obscuration, least=0.0, below=1.0)
        with np.errstate(over="ignore"):
            spherical = 6 * math.sqrt(5) * validation.real_array("rms", rms) / (1 - eps**2) ** 2
        spherical = validation.real_array("6 sqrt(5) rms / (1 - eps^2)^2", spherical)
        return cls(-0.5 * (1 + eps**2) * spherical, spherical)


def radians_per(unit: str, wavelength: float | None) -> float:
    """Return the radians of phase of one `unit`: of phase, of waves, or of metres of optical path."""
    validation.choice("unit", unit, UNITS)
    if wavelength is not None:
        validation.wavelength(wavelength)
    if unit != "metres":
        return 1.0 if unit == "radians" else 2.0 * math.pi
    if wavelength is None:
        raise ValueError('unit="metres" needs the wavelength, in metres')
    return 2.0 * math.pi / validation.wavelength(wavelength)


def _pairs(terms: Any) -> list[tuple[Any, Any]]:
    """Return the pairs (index, coefficient) of a mapping or of an iterable of pairs."""
    try:
        return [(index, value) for index, value in (terms.items() if isinstance(terms, Mapping) else terms)]
    except (TypeError, ValueError):
        raise TypeError(
            f"terms must map indices to coefficients, or be pairs of them, got {validation.shown(terms)}"
        ) from None
