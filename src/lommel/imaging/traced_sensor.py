"""Noise, mosaic and demosaicking of a sensor as differentiable functions, for JAX, PyTorch and the array API."""

from __future__ import annotations

from lommel.base import validation
from lommel.recorded.noise import Noise
from lommel.traced.namespaces import ArrayFunctions, Operand

PATTERNS = ("RGGB", "BGGR", "GRBG", "GBRG")


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


def traced_mosaic(image: Operand, pattern: str = "RGGB") -> Operand:
    """Return the mosaic of a colour image: for each pixel, the value of its colour in the Bayer pattern.

    Parameters
    ----------
    image : array, shape (..., 3, height, width)
        Red, green and blue planes; height and width must be even.
    pattern : {"RGGB", "BGGR", "GRBG", "GBRG"}, default "RGGB"
        Colours of the first two rows and columns.

    Returns
    -------
    array, shape (..., height, width)

    Raises
    ------
    ValueError
        If the shape of `image`, or `pattern`, is another one.
    """
    colours = _colours(pattern)
    # The sides must be even: Bayer patterns have a period of two pixels.
    shape = tuple(getattr(image, "shape", ()))
    if len(shape) < 3 or shape[-3] != 3 or shape[-2] % 2 or shape[-1] % 2:
        raise ValueError(f"image must have the shape (..., 3, height, width) with even sides, got {shape}")
    total: Operand = 0.0
    for k in range(3):
        plane = image[..., k, :, :]
        total = total + plane * _sites(plane, colours, k)
    return total


def traced_demosaic(mosaic: Operand, pattern: str = "RGGB") -> Operand:
    """Return a colour image from a Bayer mosaic by bilinear interpolation; linear, and therefore differentiable.

    A missing value is the mean of the nearest two or four recorded values of the same colour. Beyond the edges the
    mosaic is mirrored about the outermost pixels, which continues the pattern.

    Parameters
    ----------
    mosaic : array, shape (..., height, width)
        Recorded values; height and width must be even and at least 4.
    pattern : {"RGGB", "BGGR", "GRBG", "GBRG"}, default "RGGB"
        Colours of the first two rows and columns.

    Returns
    -------
    array, shape (..., 3, height, width)

    Raises
    ------
    ValueError
        If `mosaic` has another shape, or `pattern` another value.
    """
    colours = _colours(pattern)
    shape = tuple(getattr(mosaic, "shape", ()))
    if len(shape) < 2 or min(shape[-2:]) < 4 or shape[-2] % 2 or shape[-1] % 2:
        raise ValueError(f"mosaic must have the shape (..., height, width) with even sides of 4 or more, got {shape}")
    xp = _namespace(mosaic)
    sites = _sites(mosaic, colours, 1)
    # One pixel in four is red (or blue); the others are set to 0. With weights 1/4, 1/2, 1/4 along both axes, 4 times
    # the weighted average is the mean of the nearest recorded values.
    red, blue = (4.0 * _smooth(xp, _smooth(xp, mosaic * _sites(mosaic, colours, k), -1), -2) for k in (0, 2))
    green = sites * mosaic + (1.0 - sites) * _cross(xp, mosaic * sites)
    return xp.stack([red, green, blue], axis=-3)


def _colours(pattern: str) -> tuple[int, ...]:
    validation.choice("pattern", pattern, PATTERNS)
    return tuple("RGB".index(colour) for colour in pattern)


def _namespace(x: Operand) -> Operand:
    """Return the array API namespace of an array."""
    if hasattr(x, "__array_namespace__"):
        return x.__array_namespace__()
    from lommel.traced.namespaces import Namespace

    return Namespace.of(type(x).__module__.partition(".")[0]).xp


def _sites(image: Operand, colours: tuple[int, ...], colour: int) -> Operand:
    """Return a mask of the height, width and dtype of `image`: 1 where the pattern has the colour, else 0."""
    xp, (height, width) = _namespace(image), image.shape[-2:]
    placement = (
        {"device": image.device} if type(image).__module__.partition(".")[0] in ("torch", "array_api_strict") else {}
    )
    row, column = (
        xp.reshape(xp.arange(side, **placement) % 2, shape) for side, shape in ((height, (-1, 1)), (width, (1, -1)))
    )
    index = 2 * row + column
    mask: Operand = index < 0
    for k, pattern_colour in enumerate(colours):
        if pattern_colour == colour:
            mask = mask | (index == k)
    return xp.astype(mask, image.dtype)


def _neighbour_sum(xp: ArrayFunctions, x: Operand, axis: int) -> Operand:
    """Return the sum of both neighbours along an axis, mirrored about the edge pixels."""
    count = x.shape[axis]

    def part(start: int, stop: int) -> Operand:
        index = [slice(None)] * len(x.shape)
        index[axis] = slice(start, stop)
        return x[tuple(index)]

    # The mirror image of a neighbour about the edge pixel has the colour of the continued pattern.
    before = xp.concat([part(1, 2), part(0, count - 1)], axis=axis)
    after = xp.concat([part(1, count), part(count - 2, count - 1)], axis=axis)
    return before + after


def _smooth(xp: ArrayFunctions, x: Operand, axis: int) -> Operand:
    return 0.5 * x + 0.25 * _neighbour_sum(xp, x, axis)


def _cross(xp: ArrayFunctions, x: Operand) -> Operand:
    return 0.25 * (_neighbour_sum(xp, x, -1) + _neighbour_sum(xp, x, -2))
