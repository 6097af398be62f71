"""Photon and read noise of a sensor, and its gain."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from lommel.base import validation
from lommel.base.arrays import Array, Json
from lommel.base.cached import EqualByContent


def random_numbers(seed: int | np.random.Generator) -> np.random.Generator:
    """Return the random generator of a seed; TypeError if `seed` is not valid."""
    try:
        return np.random.default_rng(seed)
    except (TypeError, ValueError):  # NumPy's message repeats the whole argument
        raise TypeError(f"seed must be an integer >= 0 or a Generator, got {validation.shown(seed)}") from None


@dataclass(frozen=True, eq=False, kw_only=True)
class Noise(EqualByContent):
    """Gain, offset, photon noise and read noise of a sensor.

    A pixel with a mean of mu electrons records ``Poisson(mu)`` electrons plus Gaussian read noise. Its value is
    ``offset + electrons / white``. With electron multiplication the variance of the light is `excess` times as large.

    Parameters
    ----------
    white : float or array_like, optional
        Number of electrons for the value 1.0: for photographs with values up to 1, about the full well (5000); for
        images in counts (ADU), the gain in electrons per count (0.46 e/ADU is ``white=0.46``). The default is 1.0,
        for images in electrons.
    read : float or array_like
        Read noise, rms electrons; 0 for none. For an image of integers it may include the rounding,
        ``white / sqrt(12)``, added in quadrature.
    offset : float or array_like, default 0
        Value of a pixel without electrons, in the image's own unit: black level, bias or pedestal (100 ADU). Sky and
        dark current have their own photon noise: they are a background, not an offset.
    excess : float, default 1.0
        Excess noise factor F^2 of multiplication before the read noise, 1 to 100: about 2 for an electron-multiplying
        CCD (EMCCD) at a high gain. `white` and `read` then refer to electrons before multiplication: the gain
        and the read noise of the output amplifier, both divided by the EM gain.

    Raises
    ------
    TypeError, ValueError
        If an argument is not real and finite, or out of range.

    Notes
    -----
    An array of shape (height, width), as from the calibration of an sCMOS sensor, has a value for each pixel (Huang
    et al. 2013, doi:10.1038/nmeth.2488). ``Poisson(mu + read**2) - read**2`` has the mean and the variance of the
    electrons (Snyder et al. 1993, doi:10.1364/JOSAA.10.001014): the model of :func:`lommel.fisher`.

    The variance of a pixel is ``excess * mu + read**2`` (Robbins and Hadwen 2003, doi:10.1109/TED.2003.813462).
    Electrons divided by `excess` have the mean ``mu / excess`` and, without read noise, the same variance: fits
    assume a Poisson distribution for them, and multiply the estimated light by `excess`. At 0.2 to 10 electrons per
    pixel, images of an EMCCD contain 1.3 to 1.03 times the information of this model: standard errors are not too
    small.

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
    excess: float = 1.0

    def __post_init__(self) -> None:
        values = {
            "read": _number("read", self.read, "electrons", 0.0),
            "offset": _number("offset", self.offset, "levels of the camera"),
        }
        values["excess"] = validation.real("excess", self.excess, least=1.0, most=100.0)
        if self.white is not None:
            values["white"] = white = _number("white", self.white, "electrons per count")
            if not np.all(white > 0.0):
                raise ValueError(f"white must be > 0 electrons, got {np.min(white):g}")
        vars(self).update(values)

    def electrons(self, image: ArrayLike) -> Array:
        """Return the electrons of a recorded `image` (..., height, width), ``(image - offset) * white``.

        Values may be negative because of read noise. ValueError if a value is not finite.
        """
        values = validation.real_array("image", image, unit="counts")
        return np.asarray((values - self._for("offset", values.shape)) * self._for("white", values.shape))

    def image(self, electrons: ArrayLike) -> Array:
        """Return the image of `electrons`, the inverse of :meth:`electrons`; ValueError if a value is not finite."""
        values = validation.real_array("electrons", electrons, unit="electrons")
        return np.asarray(values / self._for("white", values.shape) + self._for("offset", values.shape))

    def variance(self, electrons: ArrayLike) -> Array:
        """Return the variance ``excess * electrons + read**2`` for mean `electrons`; ValueError if not finite."""
        values = validation.real_array("electrons", electrons, unit="electrons")
        return np.asarray(self.excess * values + self._for("read", values.shape) ** 2)

    @property
    def poisson(self) -> Noise:
        """Noise of the same images without excess, whose electrons are divided by `excess`."""
        if self.excess == 1.0:
            return self
        # For the excess F, electrons have the variance F mu. Divided by F they have the mean mu / F, and the same
        # variance.
        white = 1.0 if self.white is None else self.white
        return Noise(white=white / self.excess, read=self.read / self.excess, offset=self.offset)

    def record(self, electrons: ArrayLike, seed: int | np.random.Generator) -> Array:
        """Return a simulated image with random photon and read noise, in the unit of images, not rounded.

        `electrons` is the mean of each pixel, shape ``(..., height, width)``; an integer `seed` always returns the
        same image. TypeError or ValueError if a mean is negative or not finite, or `seed` is no seed. With `excess`
        each electron is multiplied by a random number of mean 1: exponentially distributed for an excess of 2, else
        gamma.
        """
        mean = validation.real_array("electrons", electrons, unit="electrons", least=0.0)
        random = random_numbers(seed)
        photons: Array = random.poisson(mean).astype(float)
        image = np.asarray(random.standard_normal(mean.shape))
        if self.excess > 1.0:
            # A sum of n gamma variates of shape k and scale 1/k; by Wald's identity the variance is mean (1 + 1/k),
            # and the excess is 1 + 1/k.
            shape = 1.0 / (self.excess - 1.0)
            photons = np.asarray(random.gamma(shape * photons)) / shape
        image *= self._for("read", mean.shape)
        image += photons
        image /= self._for("white", mean.shape)
        image += self._for("offset", mean.shape)
        return image

    def part(self, rows: slice, columns: slice) -> Noise:
        """Return the noise of a window of images, with the part of maps in the window.

        Parameters
        ----------
        rows, columns : slice

        Returns
        -------
        Noise
        """
        parts = {name: value if np.ndim(value) == 0 else value[rows, columns] for name, value in vars(self).items()}
        return Noise(**parts)

    def require_shape(self, shape: tuple[int, ...]) -> Noise:
        """Return this noise; ValueError if a map does not have the height and width of images.

        Parameters
        ----------
        shape : tuple of int
            Shape of images, height and width last.

        Returns
        -------
        Noise

        Raises
        ------
        ValueError
            If a map has another shape.
        """
        for name in ("white", "read", "offset"):
            if np.ndim(getattr(self, name)):
                self._for(name, shape)
        return self

    def _for(self, name: str, shape: tuple[int, ...]) -> float | Array:
        """Return a parameter: a number, or a map that has a value for each pixel of images of this shape."""
        value: float | Array | None = getattr(self, name)
        if value is None:
            return 1.0
        if isinstance(value, float) or value.shape == shape[-2:]:
            return value
        raise ValueError(f"{name}, of shape {value.shape}, must have a value for each pixel, got images of {shape}")

    def to_dict(self) -> Json:
        """Return the parameters as data that can be written as JSON; ``Noise(**data)`` is the inverse."""
        return {name: v if v is None or isinstance(v, float) else v.tolist() for name, v in vars(self).items()}

    def _content(self) -> tuple[object, ...]:
        return tuple(v if v is None else (np.shape(v), np.asarray(v).tobytes()) for v in vars(self).values())


def _number(name: str, value: ArrayLike, unit: str = "", least: float = -np.inf) -> float | Array:
    """Return a finite number, or an array (height, width) of finite numbers."""
    numbers = validation.real_array(name, value, least=least, unit=unit) + 0.0  # no -0
    if numbers.ndim not in (0, 2) or numbers.size == 0:
        raise ValueError(f"{name} must be a number or have the shape (height, width), got shape {numbers.shape}")
    if numbers.ndim == 0:
        return float(numbers)
    numbers.flags.writeable = False
    return numbers
