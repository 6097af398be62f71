"""What callers may want of the values of a method: their type, where they go, derivatives, axes."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, TypeVar

import numpy as np
from numpy.typing import DTypeLike, NDArray

from lommel.base import validation
from lommel.methods.method import Method
from lommel.optics.base_pupil import BasePupil

AnyPupil = TypeVar("AnyPupil", bound=BasePupil)


def names(derivatives: Sequence[str | tuple[int, int]]) -> tuple[str | tuple[int, int], ...]:
    """Return what `derivatives` are by; TypeError or ValueError if there are none such."""
    if isinstance(derivatives, tuple) and not derivatives:
        return ()
    from lommel.methods.derivatives import checked  # most answers have none

    return checked(derivatives)


def array(name: str, value: Any) -> NDArray[Any]:
    """Return `value` if it is an array; the TypeError says which argument is not."""
    if not isinstance(value, np.ndarray):
        raise TypeError(f"{name} must be a NumPy array, got {type(value).__name__}")
    return value


def place(out: NDArray[Any], shape: tuple[int, ...], dtype: np.dtype[Any]) -> NDArray[Any]:
    """Return `out` if values of this shape and type can be put there; TypeError or ValueError otherwise."""
    if array("out", out).shape != shape:
        raise ValueError(f"out must have the shape {shape}, got {out.shape}")
    if out.dtype != dtype:
        raise ValueError(f"out must be of {dtype}, got {out.dtype}")
    flags = out.flags
    if not (flags.c_contiguous and flags.writeable):
        raise ValueError("out must be C-contiguous and writable")
    return out


def output_type(dtype: DTypeLike | None, tol: float) -> np.dtype[Any]:
    """Return the type of values that are exact to `tol`; ValueError if the one that is named cannot hold it."""
    if dtype is None:
        return np.dtype(np.float32 if tol >= 1e-6 else np.float64)
    kind = validation.kind("dtype", dtype, np.float32, np.float64)
    if kind == np.float32 and tol < 2.0**-22:
        raise ValueError(f"dtype float32 cannot hold tol={tol:g}; use float64, or a tolerance of at least 2.4e-7")
    return kind


def for_axes(pupil: AnyPupil, places: tuple[int, ...]) -> AnyPupil:
    """Return a pupil for each axis, in the shape that the stack and the places of axes broadcast to."""
    try:
        return pupil.broadcast(np.broadcast_shapes(pupil.shape, places))
    except ValueError:
        raise ValueError(
            f"center must broadcast with the stack of pupils, got places of shape {places} for {pupil.shape}"
        ) from None


def way(method: Any, tol: float | None, integrate: Any) -> tuple[Method | None, float]:
    """Return the method, if one is named, and the tolerance; TypeError or ValueError if there are none such."""
    if method is not None and not isinstance(method, Method):
        raise TypeError(
            f"method must be a Method such as NijboerZernike(tol=1e-6) or None, got {validation.shown(method)}"
        )
    if not (integrate is None or isinstance(integrate, bool)):
        raise TypeError(f"integrate must be True, False or None, got {validation.shown(integrate)}")
    if integrate is False and method is not None and method.sampling == "pixel":
        raise ValueError(
            f"integrate must not be False for {type(method).__name__}, which has no point values; leave it out"
        )
    if tol is None:
        tol = (method or Method).tol
    elif method is None:
        tol = validation.real("tol", tol, least=Method.least_tol, below=1e-1)
    else:
        method = method.with_tol(tol)
    return method, tol
