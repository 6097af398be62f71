"""Coefficients of wavefronts as they are given: numbers and arrays of NumPy, not of frameworks that differentiate."""

from __future__ import annotations

from numpy.typing import ArrayLike

from lommel.base import validation
from lommel.base.arrays import Array

_FRAMEWORKS = {"jax": "JAX", "jaxlib": "JAX", "torch": "PyTorch", "cupy": "CuPy"}


def coefficients(name: str, value: ArrayLike) -> Array:
    """Return a coefficient, or an array of them.

    Raises
    ------
    TypeError
        If it is a tensor, which a wavefront would silently take out of its framework, gradients and all.
    ValueError
        If it is not real and finite.
    """
    framework = _FRAMEWORKS.get(type(value).__module__.partition(".")[0])
    if framework is not None:
        raise TypeError(
            f"{name} must be numbers or an array of NumPy, got one of {framework}, whose gradients would end here: "
            "lommel.Plan(...).traced(pupils, xp) makes PSFs of it within that framework; np.asarray(...) leaves it"
        )
    return validation.real_array(name, value)
