"""What data tell about parameters at best, and which of these they do not tell."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Self

import numpy as np

from lommel.base.arrays import Array, Numbers, numbers
from lommel.base.units import format_length
from lommel.methods.derivatives import Name

_EPS = float(np.finfo(np.float64).eps)


@dataclass(frozen=True, eq=False, repr=False)
class Information:
    """How well parameters can be known from images: Fisher's information, and the Cramér-Rao bound drawn from it.

    No unbiased estimate from the same images scatters less than :attr:`deviation`; that of largest likelihood comes
    close to it where there is light enough. Rows and columns of the matrices are in the order of `names`.

    Attributes
    ----------
    names : tuple
        Of the parameters, as they were asked for; what each of several images has for itself is numbered:
        ``"photons[0]"``.
    units : dict of name to str
        "rad", "m", "pixels", "electrons", "electrons/pixel", or "" of what has none.
    matrix : ndarray, shape ``stack + (k, k)``
        Fisher's information of k parameters, for each of a stack of scenes.
    covariance : ndarray, shape ``stack + (k, k)``
        Its inverse, the bound on the covariance of estimates. Infinite in the diagonal for what cannot be known, and
        beside it for two of which no more than a combination can.
    correlation : ndarray, shape ``stack + (k, k)``
        The covariance over the deviations of both, its limit for what cannot be known.
    """

    names: tuple[Name, ...]
    units: dict[Name, str]
    matrix: Array
    covariance: Array
    correlation: Array

    @classmethod
    def of_root(cls, names: tuple[Name, ...], units: dict[Name, str], root: Array, error: Array) -> Self:
        """Build it from derivatives of data, and say what these leave unknown.

        Parameters
        ----------
        names, units
            As the attributes.
        root : ndarray, shape ``stack + (rows, k)``, rows >= k
            Derivatives of independent data by the parameters, over the deviation of each datum, or any other array
            whose product with itself is the matrix.
        error : ndarray, shape ``stack + (k,)``
            Bound on the error of each column: on the root of the sum of its squares.

        Returns
        -------
        Information

        Notes
        -----
        Columns are divided by their lengths, so that no unit matters, and errors with them: r. One that is no longer
        than its error may be zero, and is made so. Where parameters move by a singular vector v, data move by its
        singular value s; exact ones may not move at all if ``s <= sum(abs(v) r)``, and v counts as unknown. A vector
        n, of length 1, along which exact data do not move makes ``abs(root n) <= abs(r)``, so that no more than
        ``abs(r) / s`` of it lies in the directions that move data by s or more, the known ones. What is found unknown
        may lean by so much towards a parameter that is known, and all beyond it cannot be.
        """
        length = np.sqrt((root**2).sum(axis=-2))
        error = error + root.shape[-2] * root.shape[-1] * _EPS * length  # roundings of this very sum and of the next
        zero = length <= error
        unit = np.where(zero, 1.0, length)
        relative = error / unit
        _, size, direction = np.linalg.svd(
            np.where(zero, 0.0, 1.0)[..., None, :] * root / unit[..., None, :], full_matrices=False
        )
        lost = size <= (np.abs(direction) @ np.where(zero, 1.0, relative)[..., None])[..., 0]
        least = np.where(lost, math.inf, size)
        unknown, inverse = (
            np.swapaxes(direction, -1, -2) @ (weight[..., None] * direction) for weight in (1.0 * lost, least**-2.0)
        )
        lean = np.sqrt((np.where(zero, 0.0, relative) ** 2).sum(axis=-1)) / least.min(axis=-1)
        # Of any direction there is a parameter that it leans towards by more.
        lean = np.minimum(lean, 0.5 / math.sqrt(len(names)))[..., None, None]
        never = np.sqrt(np.diagonal(unknown, axis1=-2, axis2=-1)) > lean[..., 0]
        both, one = never[..., None] & never[..., None, :], never[..., None] | never[..., None, :]
        together = both & ((np.abs(unknown) > lean) | np.eye(len(names), dtype=bool))
        covariance = inverse / (unit[..., None] * unit[..., None, :])
        matrix = np.swapaxes(root, -1, -2) @ root
        return cls(
            names,
            units,
            0.5 * (matrix + np.swapaxes(matrix, -1, -2)),
            np.where(together, np.copysign(math.inf, unknown), covariance),
            np.where(both, _over_deviations(unknown), np.where(one, 0.0, _over_deviations(inverse))),
        )

    @property
    def deviation(self) -> dict[Name, Numbers]:
        """Least standard deviation of each parameter, in the shape of the stack: infinite if it cannot be known."""
        variance = np.diagonal(self.covariance, axis1=-2, axis2=-1)
        return {name: numbers(np.sqrt(variance[..., k]), variance.shape[:-1]) for k, name in enumerate(self.names)}

    @property
    def unidentifiable(self) -> tuple[Name, ...]:
        """Names of what cannot be known, by itself or together with the others; in any scene of a stack."""
        return tuple(name for name, deviation in self.deviation.items() if np.isinf(deviation).any())

    def to_dict(self) -> dict[str, Any]:
        """Return everything in plain types, a pair (n, m) as a list, an infinite number as None (JSON has none)."""
        deviation = [_plain(np.asarray(value)) for value in self.deviation.values()]
        return {
            "names": [list(name) if isinstance(name, tuple) else name for name in self.names],
            "units": [self.units[name] for name in self.names],
            "deviation": deviation,
            "matrix": self.matrix.tolist(),
            "covariance": _plain(self.covariance),
            "correlation": self.correlation.tolist(),
        }

    def __repr__(self) -> str:
        stack = self.matrix.shape[:-2]
        width = max(len(str(name)) for name in self.names)
        lines = [
            f"{name!s:{width}} {_shown(np.asarray(value), self.units[name])}"
            for name, value in self.deviation.items()
        ]
        return "\n  ".join([f"<{type(self).__name__}{f' of a stack of {stack}' if stack else ''}", *lines]) + ">"


def _over_deviations(covariance: Array) -> Array:
    """Return a covariance over the deviations of both, where these are not 0, and 1 in the diagonal."""
    deviation = np.sqrt(np.diagonal(covariance, axis1=-2, axis2=-1))
    deviation = np.where(deviation > 0.0, deviation, 1.0)
    found = np.clip(covariance / deviation[..., None] / deviation[..., None, :], -1.0, 1.0)
    return np.asarray(np.where(np.eye(found.shape[-1], dtype=bool), 1.0, found))


def _plain(values: Array) -> Any:
    return np.where(np.isfinite(values), values, None).tolist()  # type: ignore[call-overload]


def _shown(deviation: Array, unit: str) -> str:
    """Return deviations of a stack as a text: the least and the largest, and how many are infinite."""
    known = deviation[np.isfinite(deviation)]
    missing = deviation.size - known.size
    if not known.size:
        return "unidentifiable"
    least, most = float(known.min()), float(known.max())
    if unit == "m":
        low, high = (format_length(end, like=most, digits=3) for end in (least, most))
        low = low.partition(" ")[0]
    else:
        low, high = f"{least:.3g}", f"{most:.3g} {unit}".rstrip()
    text = high if least == most else f"{low} to {high}"
    return f"+- {text}" + (f", unidentifiable in {missing} of {deviation.size}" if missing else "")
