"""Wavefront, the phase across the pupil, and the phase of defocus of a lens that obeys the sine condition.

The second part of the module expands the phase of defocus in radial Zernike terms. A spherical wave of curvature
a + delta and a reference sphere of curvature a pass through the vertex of the pupil; their centres lie on the axis.
At the height h from the axis, the reference sphere is displaced by ``a p`` from the plane of the vertex. The path
difference W between the wave and the reference sphere is, by geometry,

``W(h) = 2 p delta / (1 + sqrt(1 + 2 p (a + delta) delta)), p = h^2 / (1 + sqrt(1 - a^2 h^2)) .``

The sine condition makes h proportional to the pupil radius rho. As a function of t = rho^2, W is analytic except at
branch points. The farther these points lie from [0, 1], the faster its Chebyshev series converges. The truncated
series is converted to Legendre polynomials of 2t - 1, which are the radially symmetric Zernike terms.

References
----------
M. Born and E. Wolf, *Principles of Optics*, 7th ed., sections 4.5 (the conditions of Abbe and Herschel) and 5.1 (the
aberration function).
L. N. Trefethen, *Approximation Theory and Approximation Practice* (SIAM, 2013), Theorems 8.1 and 8.2.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import lru_cache
from os import PathLike
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, Self, TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lommel.base import display, validation
from lommel.base.arrays import Array, Index, Json
from lommel.base.cached import EqualByContent, cached_property, made
from lommel.base.quantities import LENGTHS
from lommel.special import zernike

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_MAX_RHO = 1e3  # largest rho for which the phase is evaluated; powers of rho overflow beyond
MAX_HIGHER = 8
"""Largest number of coefficients of powers above rho^4."""
UNITS = ("radians", "waves", "metres", "meters", *LENGTHS)
NORMALIZATIONS = ("rms", "edge")
Term = tuple[int, int]
"""n and m of a Zernike polynomial; m > 0 is the cosine of m theta, m < 0 the sine."""
_FRAMEWORKS = {"jax": "JAX", "jaxlib": "JAX", "torch": "PyTorch", "cupy": "CuPy"}


def _coefficients(name: str, value: ArrayLike, unit: str = "radians") -> Array:
    """Return coefficients as an array; TypeError for a tensor, whose gradients would be lost silently."""
    framework = _FRAMEWORKS.get(type(value).__module__.partition(".")[0])
    if framework is not None:
        raise TypeError(
            f"{name} must be numbers or a NumPy array, got a {framework} array, whose gradients would be lost: use "
            f"lommel.Plan(...).traced(pupils, xp) for PSFs in {framework}, or convert it by np.asarray(...)"
        )
    return validation.real_array(name, value, unit=unit)


def radians_per(unit: str, wavelength: float | None) -> float:
    """Return the factor that converts a phase in `unit` (radians, waves, a length of optical path) to radians."""
    validation.choice("unit", unit, UNITS)
    if wavelength is not None:
        wavelength = validation.wavelength(wavelength)
    if unit in ("radians", "waves"):
        return 1.0 if unit == "radians" else 2.0 * math.pi
    if wavelength is None:
        raise ValueError(f'unit="{unit}" needs the wavelength, in metres')
    return 2.0 * math.pi * LENGTHS.get(unit, 1.0) / wavelength


_Key = TypeVar("_Key")


def common_shape(label: str, parts: Mapping[_Key, Array | Wavefront]) -> tuple[int, ...]:
    """Return the shape to which arrays and stacks broadcast; else raise ValueError with each name and shape."""
    try:
        return np.broadcast_shapes(*[part.shape for part in parts.values()])
    except ValueError:
        shapes = {name: part.shape for name, part in parts.items() if part.shape}
        raise ValueError(f"{label} must broadcast, got shapes {shapes}") from None


def _columns(parts: Collection[ArrayLike], shape: tuple[int, ...]) -> Array:
    """Return arrays broadcast to a shape and stacked along a new last axis."""
    columns = np.empty((*shape, len(parts)))
    for k, part in enumerate(parts):
        columns[..., k] = part
    return columns


@lru_cache(maxsize=64)
def _indices(terms: tuple[Term, ...]) -> NDArray[np.int32]:
    indices = np.array(terms, dtype=np.int32)
    indices.flags.writeable = False
    return indices


@lru_cache(maxsize=64)
def symmetric_terms(count: int) -> tuple[Term, ...]:
    """Return the first `count` of the terms (2, 0), (4, 0), ..."""
    return tuple((2 * k, 0) for k in range(1, count + 1))


_PARABOLA = symmetric_terms(2)


@dataclass(frozen=True, eq=False, init=False, repr=False)
class Wavefront(EqualByContent, display.Shown):
    r"""Wavefront: phase across the pupil in radians, ``2 C_d rho^2 + C_s rho^4 + c_6 rho^6 + ...`` and Zernike terms.

    rho is the normalised pupil radius, 0 to 1; theta the angle from x (increasing columns) to y (increasing rows).
    For a positive `defocus` the sensor lies between the lens and its focus. For a positive `spherical` marginal rays
    focus beyond paraxial rays. The pupil function is ``exp(+i phase)``. The ray displacement on the sensor is
    proportional to the gradient of the phase: a positive tilt in x moves the image to higher columns, and the tail of
    positive coma in x points to higher columns. Piston is omitted, since no intensity depends on it. Wavefronts can
    be added, and multiplied by a number.

    Parameters
    ----------
    defocus : array_like, default 0
        C_d of Eq. (2) in Wei et al. (module ``lommel.paper``), radians. An array describes a stack of wavefronts.
    spherical : array_like, default 0
        C_s of Eq. (15), radians.
    higher : sequence of array_like, default ()
        Coefficients of rho^6, rho^8, ..., radians; at most eight.
    nonradial : mapping of (n, m) to array_like, default {}
        Coefficients, radians at the edge, of ``R_n^m(rho) cos(m theta)`` for m > 0 and of
        ``R_n^|m|(rho) sin(|m| theta)`` for m < 0, with ``R(1) = 1``. m must not be 0. :meth:`zernike` accepts other
        orders, units and normalizations.
    error : float, default 0
        Bound on the phase that the terms do not represent, radians; one bound for a whole stack. It increases the
        `error_bound` of a PSF.

    Attributes
    ----------
    shape : tuple of int
        Shape of the stack; ``()`` for a single wavefront.
    terms : tuple of (n, m)
        Zernike terms: first (2, 0), (4, 0), ... without gaps, then the terms that depend on theta, sorted.
    edge : ndarray, shape ``shape + (len(terms),)``
        Coefficients of `terms`, radians at the edge; read-only.

    Raises
    ------
    TypeError, ValueError
        If a coefficient is not real and finite, if (n, m) is no Zernike term, or if the arrays do not broadcast.

    Examples
    --------
    >>> Wavefront(defocus=10.0) + Wavefront.from_seidel(W040=0.5)
    Wavefront(defocus=10.0, spherical=3.141592653589793)
    >>> Wavefront(defocus=1.0, nonradial={(3, 1): 2.0})
    Wavefront(defocus=1.0, spherical=0.0, nonradial={(3, 1): 2.0})
    """

    pupil_hint = "a Wavefront; Pupil(wavefront) has a circular aperture"  # in errors where a Pupil is expected

    terms: tuple[Term, ...]
    edge: Array
    error: float
    shape: tuple[int, ...]
    # Coefficients of rho^2, rho^4, ... if the caller passed these powers: the attributes return them without
    # rounding.
    _powers: Array | None = field(repr=False)

    def __init__(
        self,
        defocus: ArrayLike = 0.0,
        spherical: ArrayLike = 0.0,
        higher: Sequence[ArrayLike] = (),
        nonradial: Mapping[Term, ArrayLike] | None = None,
        error: float = 0.0,
    ) -> None:
        if not isinstance(higher, Sequence) or isinstance(higher, str | bytes):
            raise TypeError(f"higher must be a sequence of coefficients, got {validation.shown(higher)}")
        if len(higher) > MAX_HIGHER:
            raise ValueError(f"higher must hold at most {MAX_HIGHER} coefficients, got {len(higher)}")
        if nonradial is not None and not isinstance(nonradial, Mapping):
            raise TypeError(f"nonradial must map (n, m) to coefficients, got {validation.shown(nonradial)}")
        with np.errstate(over="ignore"):  # _set() rejects an infinite result
            # The public coefficient is C_d, and the coefficient of rho^2 is 2 C_d (paper, Eq. 3).
            columns: dict[str, Array] = {"defocus": np.asarray(2.0 * _coefficients("defocus", defocus))}
        columns["spherical"] = _coefficients("spherical", spherical)
        for i, c in enumerate(higher):
            columns[f"higher[{i}]"] = _coefficients(f"higher[{i}]", c)
        angular_terms: dict[Term, Array] = {}
        for key, c in (nonradial or {}).items():
            n, m = zernike.term(key, "nm")
            if m == 0:
                raise ValueError(f"nonradial must hold terms with m != 0, got {(n, m)}; use Wavefront.zernike")
            angular_terms[n, m] = _coefficients(f"nonradial[{n}, {m}]", c)
        parts = columns | dict(sorted(angular_terms.items()))
        edge = _columns(parts.values(), common_shape("defocus, spherical, higher and nonradial", parts))
        powers, error = edge[..., : len(columns)].copy(), validation.real("error", error, least=0.0)
        self._set((*symmetric_terms(len(columns)), *sorted(angular_terms)), edge, error, powers)

    def _set(self, terms: tuple[Term, ...], edge: Array, error: float, powers: Array | None) -> None:
        """Set the attributes from checked arrays.

        Unless `powers` (coefficients of rho^2, rho^4, ...) is None, compute the radial terms in `edge` from it.
        """
        if powers is not None:
            with np.errstate(over="ignore", invalid="ignore"):  # a result that is not finite is rejected below
                # Methods use Zernike terms, which do not cancel; the powers are kept for exact output.
                edge[..., : powers.shape[-1]] = zernike.edge_of_powers(powers)
        if edge.size == 0:
            subject = "the coefficients of a wavefront (defocus, spherical and others)"
            raise ValueError(f"{subject} must not be empty, got shape {edge.shape[:-1]}")
        if not np.isfinite(edge).all():
            raise ValueError("the coefficients of a wavefront must be finite, also after scaling and addition")
        edge.flags.writeable = False
        if powers is not None:
            powers.flags.writeable = False
        # A frozen dataclass rejects assignments; its __dict__ accepts them.
        vars(self).update(terms=terms, edge=edge, error=error, _powers=powers, shape=edge.shape[:-1])

    @classmethod
    def trusted(cls, terms: tuple[Term, ...], edge: Array, error: float = 0.0, powers: Array | None = None) -> Self:
        """Build a wavefront from checked attributes and coefficients `powers` of rho^2, rho^4, ...; copy nothing."""
        instance = cls.__new__(cls)
        instance._set(terms, edge, error, powers)
        return instance

    @classmethod
    def from_edge(cls, coefficients: Mapping[Term, Array], error: float = 0.0) -> Self:
        """Build a wavefront with this `error` from a mapping of (n, m) to coefficients, radians at the edge.

        Raises ValueError if the coefficients do not broadcast.
        """
        # Piston also contributes to the shape: a stack of pistons only would otherwise lose its axes.
        shape = common_shape("the coefficients of the terms (n, m)", coefficients)
        radial = [n // 2 for (n, m), c in coefficients.items() if m == 0 and n > 0 and np.any(c)]
        count = max([2, *radial])
        terms = (*symmetric_terms(count), *sorted(term for term in coefficients if term[1]))
        edge = _columns([coefficients.get(term, 0.0) for term in terms], shape)
        return cls.trusted(terms, edge, error, None if radial else np.zeros((*shape, count)))

    @classmethod
    def of_defocus(cls, defocus: float | Array) -> Self:
        """Build a wavefront from defocus coefficients C_d that the caller has checked, radians."""
        if isinstance(defocus, float) and math.isfinite(2.0 * defocus):
            # Half the time of the general case below, with the same result: most pupils have only one defocus.
            powers, edge = np.zeros(2), np.zeros(2)
            powers[0], edge[0] = 2.0 * defocus, defocus + 0.0
            powers.setflags(write=False)
            edge.setflags(write=False)
            parts = {"terms": _PARABOLA, "edge": edge, "error": 0.0, "_powers": powers, "shape": (), "symmetric": 2}
            return made(cls, parts)
        defocus = np.asarray(defocus)
        powers = np.zeros((*defocus.shape, 2))
        with np.errstate(over="ignore"):  # _set() rejects an infinite result
            powers[..., 0] = 2.0 * defocus
        return cls.trusted(symmetric_terms(2), np.empty_like(powers), 0.0, powers)

    @classmethod
    def zernike(
        cls,
        terms: Mapping[Any, ArrayLike] | Iterable[tuple[Any, ArrayLike]],
        *,
        order: str = "nm",
        unit: str = "radians",
        normalization: str | None = None,
        wavelength: float | None = None,
        error: float = 0.0,
        obscuration: float = 0.0,
    ) -> Self:
        r"""Build a wavefront from Zernike coefficients.

        Parameters
        ----------
        terms : mapping, or iterable of pairs
            Coefficients by index. The index is a pair (n, m) for the order "nm", else an integer; n is at most 60.
            Arrays of coefficients describe a stack. Piston is accepted and ignored.
        order : {"nm", "noll", "ansi", "fringe"}, default "nm"
            Noll counts from 1, ANSI (OSA) from 0, Fringe (University of Arizona) from 1 to 37. m > 0 is the cosine
            of m theta, m < 0 the sine.
        unit : str, default "radians"
            Unit of the coefficients: "radians", "waves", "metres" or another length such as "nm". Lengths of optical
            path need `wavelength`.
        normalization : {"rms", "edge"}, default "rms", required for Fringe
            "rms": a coefficient is the root mean square of its term over the pupil (Noll, ANSI). "edge": a
            coefficient is the largest value of its term at the edge of the pupil (usual with Fringe, as in listings
            of lens design programs).
        wavelength : float, optional
            Wavelength, metres.
        error : float, default 0
            Bound on the phase that the terms do not represent, radians; see :class:`lommel.Wavefront`.
        obscuration : float, default 0
            Radius eps of the central obscuration, 0 to below 1. Above 0 the terms are annular Zernike terms, which
            are orthogonal over ``eps <= rho <= 1``, and "rms" is the root mean square over this annulus. The
            wavefront is converted to terms over the disc and does not block light: set the obscuration of the
            :class:`lommel.Pupil` as well.

        Raises
        ------
        TypeError, ValueError
            If a term does not exist or occurs twice, if the order is "fringe" and no normalization is given, or if n
            is too high to convert annular terms to terms over the
            disc with nine correct digits.

        References
        ----------
        R. J. Noll, J. Opt. Soc. Am. 66, 207 (1976), doi:10.1364/JOSA.66.000207. Annular terms: V. N. Mahajan,
        J. Opt. Soc. Am. 71, 75 (1981), doi:10.1364/JOSA.71.000075.

        Examples
        --------
        >>> Wavefront.zernike({7: 0.1}, order="noll", unit="waves").nonradial[3, -1]
        array(1.77715318)
        """
        scale = radians_per(unit, wavelength)
        normalization = _normalization_of(order, normalization)
        eps = validation.real("obscuration", obscuration, least=0.0, below=1.0)
        try:
            # Keep pairs: a dictionary would hide that a term occurs twice.
            pairs = [(index, value) for index, value in (terms.items() if isinstance(terms, Mapping) else terms)]
        except (TypeError, ValueError):
            raise TypeError(
                "terms must be a mapping of indices to coefficients or pairs (index, coefficient), such as "
                f"zip(range(4, 16), coefficients), got {validation.shown(terms)}"
            ) from None
        edge: dict[Term, Array] = {}
        for index, value in pairs:
            n, m = zernike.term(index, order)
            if (n, m) in edge:
                raise ValueError(f"the Zernike term {index!r}, (n, m) = ({n}, {m}), occurs twice")
            coefficient = _coefficients(f"the Zernike coefficient {index!r}", value, unit)
            with np.errstate(over="ignore"):  # from_edge() rejects an infinite result
                edge[n, m] = scale * _edge_factor((n, m), normalization) * coefficient
        if eps > 0.0:
            with np.errstate(over="ignore", invalid="ignore"):
                edge = _edge_from_annular(edge, normalization, eps)
        return cls.from_edge(edge, validation.real("error", error, least=0.0))

    def to_zernike(
        self,
        *,
        order: str = "nm",
        unit: str = "radians",
        normalization: str | None = None,
        wavelength: float | None = None,
        obscuration: float = 0.0,
    ) -> dict[Any, Array]:
        """Return the Zernike coefficients by index; the inverse of :meth:`zernike`, with the same options.

        Each coefficient has the shape of the stack. Piston is omitted, and so are terms that are zero throughout the
        stack. Raises ValueError if a term has no index in the `order`: Fringe ends with 37.
        """
        scale = radians_per(unit, wavelength)
        normalization = _normalization_of(order, normalization)
        eps = validation.real("obscuration", obscuration, least=0.0, below=1.0)
        terms = self.edge_terms()
        if eps > 0.0:
            terms = _annular_from_edge(terms, normalization, eps)
        coefficients = {}
        for (n, m), c in terms.items():
            if np.any(c):
                factor = scale * _edge_factor((n, m), normalization)
                coefficients[zernike.index_of(n, m, order)] = np.broadcast_to(c / factor, self.shape)
        return coefficients

    def save(self, path: str | PathLike[str], **options: object) -> None:
        """Write the Zernike coefficients of a single wavefront to a .csv, .json or .toml file.

        `options` are those of :func:`lommel.save_zernike`. :func:`lommel.load_zernike` reads the file.
        """
        display.save(self, path, **options)

    def plot(self, ax: Axes | None = None, *, unit: str = "waves") -> Axes | NDArray[np.object_]:
        """Draw the phase across the full disc on matplotlib axes; all panels of a stack share one colour scale.

        See :func:`lommel.show.pupils.wavefront`.
        """
        axes: Axes | NDArray[np.object_] = display.plot(self, ax, unit=unit)
        return axes

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
            Field position (x, y) along columns and rows, relative to the edge of the field. Arrays describe a stack.

        Raises
        ------
        TypeError, ValueError
            If a coefficient is not real and finite, or if the arrays do not broadcast.

        References
        ----------
        W. T. Welford, Aberrations of Optical Systems (1986), doi:10.1201/9780203755327, section 8.2.
        """
        waves = {"W020": W020, "W040": W040, "W060": W060, "W080": W080}
        waves |= {"W131": W131, "W222": W222, "W220": W220, "W311": W311}
        with np.errstate(over="ignore"):  # real_array() below rejects an infinite result
            radians = {name: 2 * math.pi * _coefficients(name, value, "waves") for name, value in waves.items()}
        w = {name: validation.real_array(name, value) for name, value in radians.items()}
        if not isinstance(field, tuple | list) or len(field) != 2:
            raise TypeError(f"field must be a pair (x, y), got {validation.shown(field)}")
        x, y = validation.real_array("field[0]", field[0]), validation.real_array("field[1]", field[1])
        shape = common_shape("the coefficients and field", w | {"field[0]": x, "field[1]": y})
        higher = [w["W060"], w["W080"]]
        # Trailing zeros would make equal wavefronts differ in their number of terms.
        while higher and not np.any(higher[-1]):
            higher.pop()
        square = x * x + y * y
        defocus = w["W020"] + (w["W220"] + 0.5 * w["W222"]) * square
        # rho^3 cos = (R_3^1 cos + 2 rho cos) / 3, and H^2 rho^2 cos^2 = H^2 rho^2 (1 + cos 2 phi) / 2.
        tilt = 2.0 / 3.0 * w["W131"] + w["W311"] * square
        angular_terms = {
            (1, 1): tilt * x,
            (1, -1): tilt * y,
            (3, 1): w["W131"] / 3.0 * x,
            (3, -1): w["W131"] / 3.0 * y,
            (2, 2): 0.5 * w["W222"] * (x * x - y * y),
            (2, -2): w["W222"] * x * y,
        }
        nonradial = {term: c for term, c in angular_terms.items() if np.any(c)}
        return cls(np.broadcast_to(0.5 * defocus, shape), w["W040"], higher, nonradial)

    @classmethod
    def balanced_spherical(cls, rms: ArrayLike, obscuration: float = 0.0) -> Self:
        r"""Build primary spherical aberration with a prescribed rms, balanced by the defocus that minimises the rms.

        On the annulus ``eps <= rho <= 1`` this is the annular Zernike term
        ``C_s (rho^4 - (1 + eps^2) rho^2 + ...)`` with ``C_s = 6 sqrt(5) rms / (1 - eps^2)^2``.

        Parameters
        ----------
        rms : array_like
            Root mean square phase over the annulus, radians; its sign is that of C_s.
        obscuration : float
            Radius eps of the central obscuration, 0 to below 1.

        Raises
        ------
        TypeError, ValueError
            If an argument is out of range, or if C_s is not finite.

        References
        ----------
        V. N. Mahajan, "Zernike annular polynomials for imaging systems with annular pupils",
        J. Opt. Soc. Am. 71, 75 (1981), doi:10.1364/JOSA.71.000075.
        """
        eps = validation.real("obscuration", obscuration, least=0.0, below=1.0)
        with np.errstate(over="ignore"):
            # Variance of rho^4 - (1 + eps^2) rho^2 over the annulus is (1 - eps^2)^4 / 180, and sqrt 180 = 6 sqrt 5.
            spherical = 6 * math.sqrt(5) * validation.real_array("rms", rms, unit="radians") / (1 - eps**2) ** 2
        spherical = validation.real_array("6 sqrt(5) rms / (1 - eps^2)^2", spherical)
        return cls(-0.5 * (1 + eps**2) * spherical, spherical)

    @cached_property
    def defocus(self) -> Array:
        """Defocus coefficient C_d, radians."""
        value = np.asarray(0.5 * self.coefficients[..., 0])
        value.flags.writeable = False
        return value

    @property
    def spherical(self) -> Array:
        """Coefficient C_s of rho^4, radians."""
        return np.asarray(self.coefficients[..., 1])

    @property
    def higher(self) -> tuple[Array, ...]:
        """Coefficients of rho^6, rho^8, ..., radians."""
        return tuple(np.moveaxis(self.coefficients[..., 2:], -1, 0))

    @cached_property
    def nonradial(self) -> Mapping[Term, Array]:
        """Coefficients of the terms that depend on theta, radians at the edge, by (n, m)."""
        indexed_terms = enumerate(self.terms[self.symmetric :], self.symmetric)
        return MappingProxyType({term: np.asarray(self.edge[..., j]) for j, term in indexed_terms})

    @cached_property
    def symmetric(self) -> int:
        """Number of radially symmetric terms n = 2, 4, ..., which come first."""
        return [m for _, m in self.terms].count(0)

    @property
    def radial(self) -> bool:
        """True if the phase depends on rho only."""
        return self.symmetric == len(self.terms) or not self.edge[..., self.symmetric :].any()

    @property
    def waves(self) -> dict[str, Array]:
        """Seidel coefficients W020, W040, W060, ... of the radially symmetric part, waves."""
        names = [f"W0{2 * k}0" for k in range(1, 1 + self.coefficients.shape[-1])]
        return {name: self.coefficients[..., k] / (2 * math.pi) for k, name in enumerate(names)}

    @property
    def radial_terms(self) -> Array:
        """Coefficients of R_2^0, R_4^0, ..., shape ``shape + (terms,)``."""
        return self.edge if self.symmetric == len(self.terms) else self.edge[..., : self.symmetric].copy()

    @property
    def indices(self) -> NDArray[np.int32]:
        """The n and m of each term, shape ``(terms, 2)``."""
        return _indices(self.terms)

    @cached_property
    def coefficients(self) -> Array:
        """Coefficients of rho^2, rho^4, ... of the radially symmetric part, radians."""
        if self._powers is not None:
            return self._powers
        powers = zernike.powers_of_edge(self.radial_terms)
        powers.flags.writeable = False
        return powers

    def edge_terms(self) -> dict[Term, Array]:
        """Return all Zernike coefficients, radians at the edge, by (n, m), without the constant."""
        return dict(zip(self.terms, np.moveaxis(self.edge, -1, 0), strict=True))

    def amplitudes(self) -> dict[Term, float]:
        """Return amplitudes ``sqrt(cosine^2 + sine^2)`` of nonzero terms by (n, abs(m)); the largest in a stack."""
        return {term: float(size.max()) for term, size in self.each_amplitude().items() if size.any()}

    def each_amplitude(self) -> dict[Term, Array]:
        """Return :meth:`amplitudes` of each wavefront of a stack, those of terms that are zero included."""
        sizes: dict[Term, Array] = {}
        for (n, m), c in self.edge_terms().items():
            # a cos(m theta) + b sin(m theta) has the amplitude sqrt(a^2 + b^2).
            sizes[n, abs(m)] = np.hypot(sizes.get((n, abs(m)), 0.0), c)
        return sizes

    @cached_property
    def flat(self) -> bool:
        """True for a single wavefront whose phase and `error` are zero."""
        return not (self.edge.any() or self.error or self.shape)

    @property
    def left_out(self) -> float:
        """Bound on the phase that the terms do not represent, radians: `error` plus rounding of converted powers."""
        return self.error + (0.0 if self._powers is None or self.symmetric <= 2 else self._conversion_error)

    @cached_property
    def _conversion_error(self) -> float:
        """Bound on the rounding errors of converting powers of rho to Zernike terms, radians."""
        errors = zernike.conversion_error(self.coefficients)
        # Section 4 of docs/certificate.md already includes errors up to one rounding of the terms.
        rounding = 2.0**-53 * np.abs(self.radial_terms).sum(axis=-1)
        return float(errors.max()) if np.any(errors > rounding) else 0.0

    def __len__(self) -> int:
        """Return the length of the first axis of a stack."""
        if self.shape == ():
            raise TypeError("a single wavefront has no length")
        return self.shape[0]

    def __bool__(self) -> bool:
        """Return True; Python would otherwise call `__len__`, which raises TypeError for a single wavefront."""
        return True

    def __getitem__(self, index: Index) -> Self:
        """Return part of a stack, indexed like an array of shape `shape`."""
        if self.shape == ():
            raise TypeError("a single wavefront cannot be indexed")

        def part(columns: Array) -> Array:
            return np.stack([column[index] for column in np.moveaxis(columns, -1, 0)], axis=-1)

        return self._map_coefficients(part)

    def broadcast(self, shape: tuple[int, ...]) -> Self:
        """Return the stack broadcast to `shape`; TypeError or ValueError if impossible or above 2^28 wavefronts."""
        stack = validation.stack_shape(shape, self.shape)
        return self._map_coefficients(lambda c: np.broadcast_to(c, (*stack, c.shape[-1])).copy())

    def _map_coefficients(self, change: Callable[[Array], Array], growth: float = 1.0) -> Self:
        """Apply the linear map `change` to coefficient arrays (..., terms), and multiply `error` by `growth`."""
        powers = None if self._powers is None else change(self._powers)
        return self.trusted(self.terms, change(self.edge), growth * self.error, powers)

    def flattened(self) -> Self:
        """Return the same stack with the shape ``(n,)``; a single wavefront becomes a stack of one."""
        if self.edge.ndim == 2:
            return self
        return self._map_coefficients(lambda c: c.reshape(-1, c.shape[-1]).copy())

    def __add__(self, other: object) -> Self:
        """Return the sum of two wavefronts."""
        if not isinstance(other, Wavefront):
            return NotImplemented
        shape = common_shape("wavefronts to add", {"first": self, "second": other})
        terms = self.terms
        if other.terms != terms:
            # A canonical order of the terms: radial terms without gaps, then the others, sorted.
            angular_terms = {*terms[self.symmetric :], *other.terms[other.symmetric :]}
            terms = (*symmetric_terms(max(self.symmetric, other.symmetric)), *sorted(angular_terms))
        edge = np.zeros((*shape, len(terms)))
        powers = None
        if self._powers is not None and other._powers is not None:
            powers = np.zeros((*shape, max(self.symmetric, other.symmetric)))
        with np.errstate(over="ignore", invalid="ignore"):
            for summand in (self, other):
                if summand.terms == terms:
                    edge += summand.edge
                else:
                    edge[..., [terms.index(term) for term in summand.terms]] += summand.edge
                if powers is not None and summand._powers is not None:
                    powers[..., : summand.symmetric] += summand._powers
        return self.trusted(terms, edge, self.error + other.error, powers)

    def __mul__(self, factor: float) -> Self:
        """Return the wavefront times a number."""
        f = validation.real("factor", factor)
        with np.errstate(over="ignore"):  # trusted() rejects an infinite result
            return self._map_coefficients(lambda c: f * c, abs(f))

    __rmul__ = __mul__
    # NumPy would otherwise multiply each element of an array by the wavefront instead of calling __rmul__.
    __array_ufunc__ = None

    def __truediv__(self, divisor: float) -> Self:
        """Return the wavefront divided by a number."""
        d = validation.real("divisor", divisor)
        if d == 0 or math.isinf(1.0 / d):
            raise ValueError(f"divisor must not be 0 or so small that 1 / divisor overflows, got {d:g}")
        return self * (1.0 / d)

    def __neg__(self) -> Self:
        """Return the conjugate wavefront."""
        return -1.0 * self

    def __sub__(self, other: object) -> Self:
        """Return the difference of two wavefronts."""
        if not isinstance(other, Wavefront):
            return NotImplemented
        return self + -other

    def _content(self) -> tuple[object, ...]:
        return self._terms_and_edges

    @cached_property
    def _terms_and_edges(self) -> tuple[object, ...]:
        """Shape, error, and the coefficients of terms that are not zero throughout the stack, with -0 as 0."""
        return self.shape, self.error, *((t, (c + 0.0).tobytes()) for t, c in self.edge_terms().items() if np.any(c))

    def __reduce__(self) -> tuple[object, ...]:
        # Cached properties are left out: the read-only mapping of `nonradial` cannot be pickled.
        powers = None if self._powers is None else self._powers.copy()
        return type(self).trusted, (self.terms, self.edge.copy(), self.error, powers)

    def phase(self, rho: ArrayLike, theta: ArrayLike = 0.0) -> Array:
        """Return the phase at points of the pupil, radians, 0 on the axis.

        Parameters
        ----------
        rho : array_like
            Pupil radius, 0 to 1.
        theta : array_like, default 0
            Pupil angle, radians from x towards y.

        Returns
        -------
        ndarray, shape ``shape + s``
            s is the common shape of `rho` and `theta` after broadcasting.

        Raises
        ------
        TypeError, ValueError
            If `rho` or `theta` is not real and finite, if they do not broadcast, or if a radius is negative or above
            1000.
        """
        r = validation.real_array("rho", rho, least=0.0, most=_MAX_RHO)
        angle = validation.real_array("theta", theta, unit="radians")
        r, angle = validation.broadcast("rho and theta", r, angle)
        point_axes = (1,) * r.ndim
        total = zernike.legendre_sum(self.radial_terms, 2.0 * r * r - 1.0)
        for (n, m), c in self.nonradial.items():
            total += c.reshape(self.shape + point_axes) * zernike.polynomial(n, m, r, angle)
        return total

    def rotated(self, angle: ArrayLike) -> Self:
        """Return the wavefront rotated by an `angle`, radians from x towards y: clockwise if y points down.

        ``rotated.phase(rho, theta) = phase(rho, theta - angle)``, exact up to rounding; the image rotates by the same
        angle. Angles broadcast with the stack. Raises TypeError or ValueError if an angle is not finite or if the
        shapes do not broadcast.
        """
        angles = validation.angles("angle", angle)
        shape = common_shape("angle and the stack", {"angle": angles, "the stack": self})
        stack = self if shape == self.shape else self.broadcast(shape)
        nonradial = zernike.rotated(dict(self.nonradial), angles)
        terms = (*self.terms[: self.symmetric], *sorted(nonradial))
        edge = _columns([nonradial[term] if term[1] else stack.edge[..., j] for j, term in enumerate(terms)], shape)
        return self.trusted(terms, edge, self.error, stack._powers)

    def flipped(self, axis: str) -> Self:
        """Return the mirror image, without rounding: "x" exchanges left and right, "y" exchanges top and bottom."""
        validation.choice("axis", axis, ("x", "y"))
        # "y": theta -> -theta reverses sines. "x": theta -> pi - theta reverses odd cosines and even sines.
        signs = np.array([(-1.0 if m < 0 else 1.0) * (-1.0 if axis == "x" and m % 2 else 1.0) for _, m in self.terms])
        return self.trusted(self.terms, signs * self.edge, self.error, self._powers)

    def scaled(self, radius: ArrayLike) -> Self:
        """Return the wavefront across a smaller concentric pupil; `radius`, in (0, 1], is relative to this pupil's.

        ``scaled.phase(rho, theta) = phase(radius * rho, theta)``, exact up to piston and rounding. Radii broadcast
        with the stack. Raises TypeError or ValueError if a radius is out of range or if the shapes do not broadcast.

        References
        ----------
        A. J. E. M. Janssen and P. Dirksen, "A concise formula for the Zernike coefficients of scaled pupils",
        J. Microlith. Microfab. Microsyst. 5, 030501 (2006).
        """
        eps = validation.real_array("radius", radius)
        if not np.all((eps > 0.0) & (eps <= 1.0)):
            invalid = eps[~((eps > 0.0) & (eps <= 1.0))].flat[0]
            raise ValueError(f"radius must be > 0 and <= 1, got {invalid:g}")
        shape = common_shape("radius and the stack", {"radius": eps, "the stack": self})
        scaled = zernike.scaled(self.edge_terms(), np.broadcast_to(eps, shape))
        terms = (*symmetric_terms(self.symmetric), *sorted(term for term in scaled if term[1]))
        edge = _columns([scaled[term] for term in terms], shape)
        powers = None
        if self._powers is not None:
            # The coefficient of rho^(2 k) is multiplied by radius^(2 k).
            powers = self._powers * eps[..., None] ** (2.0 * np.arange(1, 1 + self.symmetric))
        return self.trusted(terms, edge, self.error, powers)

    def __repr__(self) -> str:
        if self._powers is None:
            terms = {t: c for t, c in self.edge_terms().items() if np.any(c)}
            error = f", error={self.error:.3g}" if self.error else ""
            return f'Wavefront.zernike({_terms_text(terms)}, normalization="edge"{error})'
        arguments = [f"defocus={_number_text(self.defocus, shape=True)}", f"spherical={_number_text(self.spherical)}"]
        if self.higher:
            arguments.append(f"higher=({', '.join(_number_text(c) for c in self.higher)},)")
        if self.nonradial:
            arguments.append(f"nonradial={_terms_text(self.nonradial)}")
        if self.error:
            arguments.append(f"error={self.error:.3g}")
        return f"Wavefront({', '.join(arguments)})"

    def in_words(self) -> str:
        """Describe the three largest terms, radians at the edge of the pupil, and the number of other terms."""
        terms = {term: c for term, c in self.edge_terms().items() if c.any()}

        def values(c: Array, digits: int) -> str:
            return " to ".join(dict.fromkeys(f"{end:.{digits}g}" for end in (c.min(), c.max())))

        if terms.keys() <= {(2, 0)}:
            return f"C_d {values(self.defocus, 4)} rad" if terms else "no aberration"
        largest = sorted(terms, key=lambda term: -np.abs(terms[term]).max())[:3]
        listed = ", ".join(f"({n}, {m}) {values(terms[n, m], 3)}" for n, m in largest)
        others = f" and {len(terms) - 3} more" if len(terms) > 3 else ""
        return f"Zernike terms {listed}{others}, rad at the edge"

    def to_dict(self) -> Json:
        """Return the coefficients as plain lists and numbers; :meth:`from_dict` is the inverse."""
        if self._powers is None:
            description: Json = {"terms": [[n, m, c.tolist()] for (n, m), c in self.edge_terms().items()]}
        else:
            # A coefficient that is constant over the stack becomes one number; the defocus keeps the stack's shape.
            description = {
                "defocus": self.defocus.tolist(),
                "spherical": _constant_or_list(self.spherical),
                "higher": [_constant_or_list(c) for c in self.higher],
            }
            if self.nonradial:
                description["nonradial"] = [[n, m, _constant_or_list(c)] for (n, m), c in self.nonradial.items()]
        if self.error:
            description["error"] = self.error
        return description

    @classmethod
    def from_dict(cls, description: Json) -> Self:
        """Rebuild a wavefront from the result of :meth:`to_dict`; TypeError or ValueError for other dictionaries."""
        parts = dict(description)
        if "terms" in parts:
            pairs = [((n, m), c) for n, m, c in parts.pop("terms")]
            return cls.zernike(pairs, normalization="edge", **parts)
        listed = parts.pop("nonradial", [])
        nonradial = {(n, m): c for n, m, c in listed}
        if len(nonradial) < len(listed):
            raise ValueError(f"nonradial must hold each term (n, m) once, got {[(n, m) for n, m, _ in listed]}")
        return cls(**parts, nonradial=nonradial)


def _constant_or_list(value: Array) -> object:
    return float(value.flat[0]) if value.min() == value.max() else value.tolist()


def _normalization_of(order: str, normalization: str | None) -> str:
    """Return the normalization, by default "rms"; ValueError for the order "fringe" without one."""
    if normalization is None and order == "fringe":
        raise ValueError(
            'normalization must be given for the order "fringe": "edge", as most lens design programs list them, or '
            '"rms"'
        )
    return validation.choice("normalization", normalization or "rms", NORMALIZATIONS)


def _edge_factor(term: Term, normalization: str) -> float:
    """Return the value at the edge of a Zernike term over the disc with the coefficient 1 in this normalization."""
    return zernike.rms_factor(*term) if normalization == "rms" else 1.0


def _edge_from_annular(terms: Mapping[Term, Array], normalization: str, eps: float) -> dict[Term, Array]:
    """Return edge coefficients of terms over the disc; `terms` are annular coefficients times _edge_factor()."""
    # An annular term is a sum of terms over the disc with the same m and at most the same n.
    rms = {(n, m): c / _annular_factor((n, m), normalization, eps) for (n, m), c in terms.items()}
    return {term: zernike.rms_factor(*term) * c for term, c in zernike.over_disc(rms, eps).items()}


def _annular_from_edge(terms: Mapping[Term, Array], normalization: str, eps: float) -> dict[Term, Array]:
    """Return the inverse of :func:`_edge_from_annular`, without piston and without coefficients of rounding size."""
    rms = zernike.over_annulus({term: c / zernike.rms_factor(*term) for term, c in terms.items()}, eps)
    threshold = 1e-14 * max((float(np.abs(c).max()) for c in rms.values()), default=0.0)
    nonzero = {term: c for term, c in rms.items() if term != (0, 0) and np.abs(c).max() > threshold}
    return {term: c * _annular_factor(term, normalization, eps) for term, c in nonzero.items()}


def _annular_factor(term: Term, normalization: str, eps: float) -> float:
    """Return the coefficient, times _edge_factor(), of an annular term with an rms of 1."""
    return zernike.rms_factor(*term) if normalization == "rms" else zernike.annular_edge(*term, eps)


def _terms_text(terms: Mapping[Term, Array]) -> str:
    return f"{{{', '.join(f'{t}: {_number_text(c)}' for t, c in terms.items())}}}"


def _number_text(value: Array, *, shape: bool = False) -> str:
    if value.ndim == 0 or (not shape and value.min() == value.max()):
        return repr(float(value.flat[0]))
    return f"<array {value.shape} from {value.min():g} to {value.max():g}>"


def same_path(wavefront: Wavefront, reference: float, wavelength: float) -> Wavefront:
    """Convert a wavefront from the wavelength `reference` to `wavelength`, metres, with equal path differences."""
    return reference / wavelength * wavefront


_DEGREE = 80  # degree of the Chebyshev series of the phase of defocus before truncation
_MIN_TERMS, _MAX_TERMS = 2, zernike.MAX_DEGREE // 2  # number of radial terms after truncation
_ROUNDING = 2.0**-47  # bound on rounding errors relative to the sum of absolute coefficients


@lru_cache(maxsize=4)
def _chebyshev_to_legendre(degree: int) -> Array:
    """Return the coefficient [k, j] of the Legendre polynomial P_j in the Chebyshev polynomial T_k, 0 to `degree`."""
    # B. K. Alpert and V. Rokhlin, SIAM J. Sci. Stat. Comput. 12, 158 (1991), Eq. 2.20, doi:10.1137/0912009.
    ratio = [math.sqrt(math.pi), 2.0 / math.sqrt(math.pi)]  # Gamma(z + 1/2) / Gamma(z + 1) at z = 0, 1/2, ...
    for i in range(2, 2 * degree + 1):
        ratio.append(ratio[i - 2] * (i - 1) / i)
    matrix = np.zeros((degree + 1, degree + 1))
    matrix[0, 0] = 1.0
    for k in range(1, degree + 1):
        matrix[k, k] = 0.5 * math.sqrt(math.pi) / ratio[2 * k]
        for j in range(k - 2, -1, -2):
            matrix[k, j] = -k * (j + 0.5) * ratio[k - j - 2] / (k - j) * ratio[k + j - 1] / (k + j + 1)
    return matrix


def path(t: Array, radius: float, sphere: float, vergence: Array) -> Array:
    """Return the path difference W of the module docstring at ``rho^2 = t``, metres.

    Parameters
    ----------
    t : ndarray, shape (points,)
        Squares of the pupil radius, 0 to 1.
    radius : float
        Radius of the pupil, metres.
    sphere : float
        Curvature a of the reference sphere, 1/metres: positive if light diverges from its centre.
    vergence : ndarray, shape (n,)
        Curvature of the wave minus curvature of the reference sphere, delta, 1/metres.

    Returns
    -------
    ndarray, shape (n, points)
        Path difference, metres.
    """
    # The formula avoids differences of nearly equal numbers; docs/theory.md derives it.
    square = radius**2 * t
    p = square / (1.0 + np.sqrt(1.0 - sphere**2 * square))
    delta = vergence[:, None]
    return np.asarray(2.0 * p * delta / (1.0 + np.sqrt(1.0 + 2.0 * p * (sphere + delta) * delta)))


def growth(radius: float, sphere: float, vergence: float) -> float:
    """Return a bound on (range of Im W across the pupil) / Im delta, metres^2, for ``abs(delta) <= vergence``."""
    # With ``w = 2 p (a + delta) delta`` and ``g(w) = 2 / (1 + sqrt(1 + w))``, ``W = p delta g(w)``. The series of g
    # alternates, so that for ``|w| <= q < 1`` the moduli ``|g - 1|`` and ``|g'|`` are largest at ``w = -q``.
    p = radius**2 / (1.0 + math.sqrt(1.0 - (sphere * radius) ** 2))
    q = 2.0 * p * (abs(sphere) + vergence) * vergence
    if not q < 1.0:
        return math.inf
    root = math.sqrt(1.0 - q)
    slope = 2.0 * p * (abs(sphere) + 2.0 * vergence) / (root * (1.0 + root) ** 2)
    e = 2.0 / (1.0 + root) - 1.0 + vergence * slope
    return p * max(1.0 + e, 2.0 * e)


def expansion(radius: float, sphere: float, vergence: Array, wavelength: float) -> tuple[Array, float]:
    """Return coefficients of ``2 pi W / wavelength`` in R_2^0, R_4^0, ..., and a bound on the error of the phase.

    At most thirty terms of a Chebyshev series of degree 80 are kept. The error bound includes the omitted terms, the
    error of the series itself and rounding; piston is ignored.

    Parameters
    ----------
    radius, sphere, vergence
        As of :func:`lommel.optics.wavefront.wavefront.path`.
    wavelength : float
        Wavelength, metres.

    Returns
    -------
    coefficients : ndarray, shape (n, k)
        Values at the edge of the pupil, radians.
    error : float
        Bound on the error of the phase, radians; the largest of the stack.

    Raises
    ------
    ValueError
        If the sine of the marginal ray's angle would be 1 or more, or if the object is so close that the phase has no
        convergent expansion.
    """
    wavenumber = 2.0 * math.pi / wavelength
    max_vergence = float(np.abs(vergence).max())
    with np.errstate(over="ignore"):  # an infinite value is rejected below
        quadratic = 2.0 * float(np.abs((sphere + vergence) * vergence).max())
    inverse_radius = radius**2 * max(sphere**2, quadratic)  # W is analytic for abs(t) < 1 / inverse_radius
    if inverse_radius >= 1.0:
        if radius * abs(sphere) >= 1.0:
            reason = f"the sine of the angle of the marginal ray would be {radius * abs(sphere):.4g}"
        else:
            reason = "the object is so close that the phase has no expansion in powers of rho^2"
        raise ValueError(f"model 'aplanatic' is not possible: {reason}")
    angle = (np.arange(_DEGREE + 1, dtype=np.float64) + 0.5) * (math.pi / (_DEGREE + 1))
    # Chebyshev interpolation in t on [0, 1]; docs/certificate.md, "An aplanatic phase", proves the error bound.
    values = wavenumber * path(0.5 + 0.5 * np.cos(angle), radius, sphere, vergence)
    series = values @ np.cos(np.outer(angle, np.arange(_DEGREE + 1))) * (2.0 / (_DEGREE + 1))
    series[:, 0] *= 0.5
    # Inside the Bernstein ellipse through t_max both square roots of W have a positive real part, which implies |W|
    # <= 2 R^2 |t| |delta|; `ellipse` is the sum of the ellipse's semiaxes on the interval [-1, 1].
    t_max = 1.0 / max(inverse_radius, 1e-6)
    ellipse = 2.0 * t_max - 1.0 + 2.0 * math.sqrt(t_max * (t_max - 1.0))
    series_error = 8.0 * wavenumber * radius**2 * t_max * max_vergence * ellipse**-_DEGREE / (ellipse - 1.0)
    total = np.abs(series).sum(axis=1).max()
    tails = np.abs(series[:, ::-1]).cumsum(axis=1)[:, ::-1].max(axis=0)  # tails[k]: sum of abs(terms) from k on
    threshold = 4.0 * _ROUNDING * total  # above the rounding errors of the series
    degree = next((k for k in range(_MIN_TERMS, _MAX_TERMS) if tails[k + 1] <= threshold), _MAX_TERMS)
    terms = series[:, : degree + 1] @ _chebyshev_to_legendre(degree)
    rounding = _ROUNDING * (total + np.abs(terms).sum(axis=1).max())
    return terms[:, 1:], float(tails[degree + 1] + series_error + rounding) if max_vergence else 0.0


def wavefront(radius: float, sphere: float, vergence: Array, wavelength: float) -> Wavefront:
    """Return the phase ``2 pi W / wavelength`` as a stack of the shape of `vergence`; see :func:`expansion`."""
    edge, error = expansion(radius, sphere, vergence.ravel(), wavelength)
    return Wavefront.trusted(symmetric_terms(edge.shape[-1]), edge.reshape(*vergence.shape, -1), error)
