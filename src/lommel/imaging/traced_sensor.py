"""Noise of a sensor as a differentiable function, for JAX, PyTorch and the array API."""

from __future__ import annotations

from lommel.base import validation
from lommel.recorded.noise import Noise
from lommel.traced.namespaces import Operand


def traced_noise(image: Operand, noise: Noise, normal: Operand) -> Operand:
    """Add the photon and read noise of a sensor to an image, differentiably.

    The result is ``image + sqrt(variance) * normal / white``, with ``variance = excess * max(electrons, 0) + read^2``
    of :class:`lommel.Noise`: the normal approximation of Poisson noise. The gradient includes the change of the noise
    with the light (reparametrisation). The approximation is good above about ten electrons per pixel. For fewer
    electrons, or for Poisson counts without gradients, see :meth:`lommel.Noise.record`.

    Parameters
    ----------
    image : array
        Expected image in the unit of `noise`: linear light; if ``noise.white`` is given, the value 1 means this
        number of electrons.
    noise : Noise
        Noise with numbers (not maps) for `white`, `read` and `offset`.
    normal : array
        Standard normal values of the shape of `image`, such as ``torch.randn_like(image)`` or
        ``jax.random.normal(key, image.shape)``.

    Returns
    -------
    array
        Image with noise, neither clipped nor rounded.

    Raises
    ------
    TypeError, ValueError
        If `noise` is not a Noise or contains maps, or the shapes differ.
    """
    validation.instance("noise", noise, Noise)
    white = 1.0 if noise.white is None else noise.white
    if any(getattr(value, "shape", ()) != () for value in (white, noise.read, noise.offset)):
        raise ValueError("noise must have a single white, read and offset, got values for each pixel; use medians")
    if not hasattr(image, "shape") or tuple(image.shape) != tuple(getattr(normal, "shape", ())):
        raise ValueError(
            f"normal must have the shape of the image, {tuple(getattr(image, 'shape', ()))}, got "
            f"{tuple(getattr(normal, 'shape', ()))}"
        )
    white, read = float(white), float(noise.read)
    # Adding 1e-6 electrons^2 keeps the derivative of the square root finite for a dark pixel without read noise.
    electrons = (image - float(noise.offset)) * white
    # (x + abs(x)) / 2 is max(x, 0), written with operations that every framework has.
    light = 0.5 * noise.excess * (electrons + abs(electrons))
    return image + (light + (read**2 + 1e-6)) ** 0.5 * normal * (1.0 / white)
