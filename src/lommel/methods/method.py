"""The face every method has: what it supports, and the intensity it computes."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable
from dataclasses import fields
from typing import Any, ClassVar, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lommel.grid import Grid
from lommel.pupil import Pupil
from lommel.special.bessel import _radii


class ToleranceError(ArithmeticError):
    """A method cannot meet the tolerance it was given."""


class Result(NamedTuple):
    """Values with the method's bound on their error.

    Attributes
    ----------
    values : ndarray
        First axis: the flattened stack of pupils.
    error : ndarray, shape (n,), or None
        For a field: bound on ``|U - U_exact|``. For an intensity: bound on ``max|I - I_exact| / max I``.
    """

    values: NDArray[Any]
    error: NDArray[np.float64] | None


class Method(ABC):
    """A way to evaluate the diffraction integral.

    The field is normalised so that the unaberrated, unobscured aperture gives U(0) = 1, and I = abs(U)^2.
    Subclasses are frozen dataclasses: their fields are their options.
    """

    sampling: ClassVar[str] = "center"
    """``"center"``: values sample the pixel centres; ``"pixel"``: they are averages over pixels."""

    tol: float = 1e-6

    @abstractmethod
    def unsupported(self, pupil: Pupil) -> str | None:
        """Return why `pupil` is not supported, or None if it is."""

    @abstractmethod
    def intensity(self, pupil: Pupil, grid: Grid) -> Result:
        """Return I on `grid` for the flattened stack.

        Shape ``(n, len(grid.radii))``, at the distinct radii, or ``(n, height, width)``.
        """

    def require(self, pupil: Pupil) -> None:
        """Raise ValueError if `pupil` is not supported."""
        if not isinstance(pupil, Pupil):
            raise TypeError(f"pupil must be a Pupil, got {pupil!r}")
        reason = self.unsupported(pupil)
        if reason is not None:
            raise ValueError(f"{type(self).__name__} {reason}")

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
    """A method whose answer depends on the distance from the centre only, and is known at any distance."""

    @abstractmethod
    def evaluate(self, pupil: Pupil, v: NDArray[np.float64]) -> Result:
        """Return U at rising v for the flattened stack, shape ``(n, len(v))``, with a bound on its error."""

    def field(self, pupil: Pupil, v: ArrayLike) -> NDArray[np.complex128]:
        """Return the complex field U at optical coordinates `v`, shape ``pupil.shape + v.shape``."""
        self.require(pupil)
        at = np.asarray(v, dtype=np.float64)
        values, where = np.unique(_radii(at.ravel()), return_inverse=True)
        return self.evaluate(pupil, values).values[:, where].reshape(pupil.shape + at.shape)

    def profile(self, pupil: Pupil, v: NDArray[np.float64]) -> Result:
        """Return I = abs(U)^2 at rising v with the bound on its error relative to the largest value."""
        values, error = self.evaluate(pupil, v)
        intensity = values.real**2 + values.imag**2
        return Result(intensity, None if error is None else relative_error(intensity, error))

    def intensity(self, pupil: Pupil, grid: Grid) -> Result:
        """Return I at the distinct radii of `grid`."""
        return self.profile(pupil, grid.v(pupil))


def relative_error(intensity: NDArray[np.float64], field_error: NDArray[np.float64]) -> NDArray[np.float64]:
    """Bound ``max|I - I_exact| / max I`` from a bound on abs(U - U_exact): ``(2 M e + e^2) / M^2``."""
    peak = np.sqrt(intensity.max(axis=1))
    # Where nothing but error is left (peak 0), no relative statement holds.
    with np.errstate(divide="ignore", over="ignore"):
        ratio = field_error / peak
        return np.asarray(ratio * (2.0 + ratio))


def annulus(
    disk: Callable[[NDArray[np.float64], NDArray[np.float64]], Result],
    pupil: Pupil,
    v: NDArray[np.float64],
) -> Result:
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
    return Result(outer.values - area * inner.values, error)
