"""Measured maps of optical path differences, in metres, with what else is known of them."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from lommel.base import validation
from lommel.base.arrays import Array


@dataclass(frozen=True, eq=False, repr=False)
class OPDMap:
    """A measured map of optical path differences, or a stack of maps; :func:`lommel.fit_opd` takes it as it is.

    ``2.0 * opd`` is the path of light that a measured surface reflects, ``-opd`` that of the other sign.

    Parameters
    ----------
    values : array_like, shape (..., height, width)
        Metres of optical path; x rises with the columns and y with the rows. NaN where there is no measurement; what
        a masked array hides becomes NaN.
    spacing : float, optional
        From pixel to pixel in the pupil, metres.
    wavelength : float, optional
        At which it was measured, metres.

    Attributes
    ----------
    mask : ndarray of bool, of the shape of the values
        True where there is a measurement.

    Raises
    ------
    TypeError, ValueError
        If the values are not real, hold an infinity or no number at all, or have another shape, or if the spacing or
        the wavelength is out of range.

    Examples
    --------
    >>> import lommel as lm
    >>> opd = OPDMap(550e-9 * lm.opd_map(lm.Wavefront(1.0), 24, unit="waves"), wavelength=550e-9)
    >>> round(float(lm.fit_opd(opd).wavefront.defocus), 6)
    1.0
    """

    values: Array
    spacing: float | None = None
    wavelength: float | None = None

    def __post_init__(self) -> None:
        given: Any = self.values
        if isinstance(given, np.ma.MaskedArray):
            given = np.ma.filled(given.astype(np.float64), np.nan)
        given = validation.array("values", given)
        if given.dtype.kind not in "iuf":
            raise TypeError(f"values must hold real numbers, got an array of {given.dtype}")
        if given.ndim < 2 or given.size == 0:
            raise ValueError(f"values must have the shape (..., height, width) and not be empty, got {given.shape}")
        values = given.astype(np.float64)
        if np.isinf(values).any() or np.isnan(values).all():
            raise ValueError(
                "values must be finite, or NaN where there is no measurement, and somewhere there must be one"
            )
        values.flags.writeable = False
        object.__setattr__(self, "values", values)
        if self.spacing is not None:
            object.__setattr__(self, "spacing", validation.real("spacing", self.spacing, above=0.0, unit="metres"))
        if self.wavelength is not None:
            object.__setattr__(self, "wavelength", validation.wavelength(self.wavelength))

    @property
    def mask(self) -> NDArray[np.bool_]:
        """True where there is a measurement."""
        return ~np.isnan(self.values)

    def __mul__(self, factor: float) -> Self:
        """Return the map times a number."""
        return replace(self, values=self.values * validation.real("factor", factor))

    __rmul__ = __mul__

    def __neg__(self) -> Self:
        """Return the map with the other sign."""
        return -1.0 * self

    def __array__(self, dtype: DTypeLike | None = None, copy: bool | None = None) -> NDArray[Any]:
        """Return `values`."""
        return np.array(self.values, dtype=dtype, copy=copy)

    def __repr__(self) -> str:
        known = [
            f"{name} {value:g} m" for name in ("spacing", "wavelength") if (value := getattr(self, name)) is not None
        ]
        size = "x".join(map(str, self.values.shape))
        return f"<OPDMap {', '.join([size, f'{self.mask.mean():.1%} measured', *known])}>"


def plain(opd: ArrayLike | OPDMap, unit: str | None, wavelength: float | None) -> tuple[ArrayLike, str, float | None]:
    """Return a map as an array, masked where there is no measurement, its unit and its wavelength."""
    if not isinstance(opd, OPDMap):
        if unit is None:
            raise TypeError("unit must be given, 'radians', 'waves' or 'metres', where opd is no OPDMap")
        return opd, unit, wavelength
    if unit not in (None, "metres"):
        raise ValueError(f"unit must be left out for an OPDMap, which is in metres, got {validation.shown(unit)}")
    return np.ma.masked_invalid(opd.values), "metres", opd.wavelength if wavelength is None else wavelength
