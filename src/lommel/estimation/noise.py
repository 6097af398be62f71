"""What a sensor adds to light: electrons that are counted one by one, and the noise of reading them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from lommel.base import validation
from lommel.base.arrays import Array


@dataclass(frozen=True, eq=False, kw_only=True)
class Noise:
    """How a sensor turns electrons into the values of an image, and how uncertain these are.

    A pixel in which light frees mu electrons on average counts ``Poisson(mu)`` of them, to which reading adds
    Gaussian noise; the image holds ``offset + electrons / white``.

    Parameters
    ----------
    white : float or array_like, optional
        Electrons at the value 1.0 of an image: for photographs whose values end at 1, about the electrons that fill a
        pixel there (5000); for images in counts (ADU), the gain in electrons per count (0.46 e/ADU is
        ``white=0.46``; of a gain in counts per electron, its inverse). By default images are in electrons, as 1.0
        would say.
    read : float or array_like
        Noise of reading a pixel, rms electrons; 0 for none. Of an image of integers it may well contain the rounding,
        ``white / sqrt(12)``, as the square root of the sum of squares.
    offset : float or array_like, default 0
        Value of a pixel that counted none, in the image's own unit: black level, bias or pedestal (100 ADU). Light of
        the sky and dark current are none of it, for they are noisy: they are a background.

    Raises
    ------
    TypeError, ValueError
        If one of them is not real and finite, `white` is not above 0, or `read` is negative.

    Notes
    -----
    An array, of shape (height, width) as calibrations of sCMOS sensors give them, has a value for each pixel (Huang
    et al. 2013, doi:10.1038/nmeth.2488). Sums of many electrons that are read with noise of variance ``read**2`` are
    close to ``Poisson(mu + read**2) - read**2``, which has their mean and variance (Snyder et al. 1993,
    doi:10.1364/JOSAA.10.001014): the model of :func:`lommel.fisher`.

    Examples
    --------
    >>> noise = Noise(white=0.46, read=1.6, offset=100)
    >>> float(noise.electrons(300))
    92.0
    >>> float(noise.variance(92.0))
    94.56
    """

    white: float | Array | None = None
    read: float | Array
    offset: float | Array = 0.0

    def __post_init__(self) -> None:
        checked = {"read": _number("read", self.read, least=0.0), "offset": _number("offset", self.offset)}
        if self.white is not None:
            checked["white"] = white = _number("white", self.white)
            if not np.all(white > 0.0):
                raise ValueError(f"white must be > 0 electrons, got {np.min(white):g}")
        vars(self).update(checked)

    def electrons(self, image: ArrayLike) -> Array:
        """Return the electrons of an image.

        Parameters
        ----------
        image : array_like, shape ``(..., height, width)``
            Values as they were recorded, proportional to light but for the offset.

        Returns
        -------
        ndarray
            ``(image - offset) * white``; negative where reading made less of few. ValueError if not all is finite.
        """
        values = validation.real_array("image", image)
        white = 1.0 if self.white is None else self._for("white", values.shape)
        return np.asarray((values - self._for("offset", values.shape)) * white)

    def image(self, electrons: ArrayLike) -> Array:
        """Return the image of `electrons`, the inverse of :meth:`electrons`; ValueError if not all is finite."""
        values = validation.real_array("electrons", electrons)
        white = 1.0 if self.white is None else self._for("white", values.shape)
        return np.asarray(values / white + self._for("offset", values.shape))

    def variance(self, electrons: ArrayLike) -> Array:
        """Return the variance of pixels that count so many `electrons` on average.

        Parameters
        ----------
        electrons : array_like, shape ``(..., height, width)``

        Returns
        -------
        ndarray
            ``electrons + read**2``, electrons squared. ValueError if not all is finite.
        """
        values = validation.real_array("electrons", electrons)
        return np.asarray(values + self._for("read", values.shape) ** 2)

    def record(self, electrons: ArrayLike, seed: int | np.random.Generator) -> Array:
        """Return an image as a sensor would record it, with noise drawn at random.

        Parameters
        ----------
        electrons : array_like, shape ``(..., height, width)``
            Mean of each pixel.
        seed : int or Generator
            The same number draws the same noise.

        Returns
        -------
        ndarray
            In the image's own unit, not rounded. TypeError or ValueError if a mean is negative or not finite, or
            `seed` is none.
        """
        mean = validation.real_array("electrons", electrons, least=0.0)
        try:
            draw = np.random.default_rng(seed)
        except (TypeError, ValueError):  # which repeats all that was given
            raise TypeError(f"seed must be an integer >= 0 or a Generator, got {validation.shown(seed)}") from None
        return self.image(draw.poisson(mean) + draw.normal(0.0, 1.0, mean.shape) * self._for("read", mean.shape))

    def _for(self, name: str, shape: tuple[int, ...]) -> float | Array:
        """Return a parameter, each pixel's own for images of this shape."""
        value: float | Array = getattr(self, name)
        if isinstance(value, float) or value.shape == shape[-2:]:
            return value
        raise ValueError(f"{name}, of shape {value.shape}, must have a value for each pixel, got images of {shape}")

    def to_dict(self) -> dict[str, Any]:
        """Return everything in plain types; ``Noise(**plain)`` is the inverse."""
        return {name: v if v is None or isinstance(v, float) else v.tolist() for name, v in vars(self).items()}

    def __eq__(self, other: object) -> bool:
        """Two are equal if all their numbers are."""
        return self._content() == other._content() if isinstance(other, Noise) else NotImplemented

    def __hash__(self) -> int:
        """Return a hash that equals share."""
        return hash(self._content())

    def _content(self) -> tuple[Any, ...]:
        return tuple(v if v is None else (np.shape(v), np.asarray(v).tobytes()) for v in vars(self).values())


def _number(name: str, value: Any, least: float = -np.inf) -> float | Array:
    """Return a finite number, or an array (height, width) of them."""
    found = validation.real_array(name, value, least=least) + 0.0  # no -0
    if found.ndim not in (0, 2) or found.size == 0:
        raise ValueError(f"{name} must be a number or have the shape (height, width), got shape {found.shape}")
    if found.ndim == 0:
        return float(found)
    found.flags.writeable = False
    return found
