"""Images of radially symmetric pupils as the core itself returns them, with all that goes with them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from lommel import _core


class Rendered(NamedTuple):
    unmet: float
    images: np.ndarray
    scales: np.ndarray
    bounds: np.ndarray
    peaks: np.ndarray
    slopes: np.ndarray
    slope_bounds: np.ndarray


def grouped(given: dict[str, Any]) -> dict[str, Any]:
    """Return arguments of the core with those of pupils, window and request in tuples, as the core takes them."""
    rest = dict(given)
    kind = ("coefficients",) if "coefficients" in rest else ("terms", "edge")
    found: dict[str, Any] = {}
    if kind[0] in rest:
        found["stack"] = tuple(rest.pop(name) for name in (*kind, "obscuration", "amplitude"))
    pixels = rest.get("images", rest.get("weights"))
    shape = pixels.shape[-2:] if pixels is not None else (rest.pop("height"), rest.pop("width"))
    center = rest.pop("centers") if "centers" in rest else (rest.pop("center_y"), rest.pop("center_x"))
    found["window"] = shape, center, rest.pop("step")
    if "scale" in rest:
        found["request"] = tuple(rest.pop(name) for name in ("tol", "threads", "scale"))
    return found | rest


def rendered(
    pupils: Any,
    obscuration: float,
    light: Any,
    shape: tuple[int, int],
    step: float,
    tol: float,
    *,
    center: tuple[float, float] | None = None,
    integrate: bool = False,
    divided: bool = False,
    powers: Sequence[int] = (),
    dtype: Any = np.float64,
    threads: int = 1,
) -> Rendered:
    """Return what is rendered on an image of this shape, around its middle unless a center is named."""
    coefficients = np.array(pupils, np.float64)
    count, which = len(coefficients), np.array(powers, np.int64)
    images, numbers = np.empty((count, *shape), dtype), np.empty((3, count))
    slopes, slope_bounds = np.empty((len(which), *images.shape), dtype), np.empty((len(which), count))
    stack = coefficients, obscuration, np.array(light, np.float64)
    window = shape, center or (shape[0] // 2, shape[1] // 2), step
    request = tol, threads, 0.0 if divided else 1.0
    unmet = _core.render(stack, window, integrate, request, images, numbers, which, slopes, slope_bounds)
    return Rendered(unmet, images, *numbers, slopes, slope_bounds)
