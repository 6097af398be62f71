"""Photon and read noise of a sensor, and its gain."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from lommel.base import validation
from lommel.base.arrays import Array, Json
from lommel.base.cached import EqualByContent


def random_numbers(seed: int | np.random.Generator) -> np.random.Generator:
    """Return the random generator of a seed; TypeError if it is not one."""
    try:
        return np.random.default_rng(seed)
    except (TypeError, ValueError):  # NumPy's message repeats the whole argument
        raise TypeError(f"seed must be an integer >= 0 or a Generator, got {validation.shown(seed)}") from None


@dataclass(frozen=True, eq=False, kw_only=True)
class Noise(EqualByContent):
    """Gain, offset, photon noise and read noise of a sensor.

    A pixel with a mean of mu electrons records ``Poisson(mu)`` of them plus Gaussian read noise; the image holds
    ``offset + electrons / white``. With electron multiplication the variance of the light is `excess` times as large.

    Parameters
    ----------
    white : float or array_like, optional
        Electrons at the value 1.0 of an image: for photographs whose values end at 1, about the full well (5000);
        for images in counts (ADU), the gain in electrons per count (0.46 e/ADU is ``white=0.46``). By default images
        are in electrons, as with 1.0.
    read : float or array_like
        Read noise, rms electrons; 0 for none. For an image of integers it may include the rounding,
        ``white / sqrt(12)``, as the root of the sum of squares.
    offset : float or array_like, default 0
        Value of a pixel without electrons, in the image's own unit: black level, bias or pedestal (100 ADU). Sky and
        dark current are noisy, and not part of it: they are a background.
    excess : float, default 1.0
        Excess noise factor F^2 of multiplication before the read noise, 1 to 100: about 2 for an electron-multiplying
        CCD (EMCCD) at a high gain. `white` and `read` are then those of electrons before multiplication: the gain
        and the read noise of the output amplifier, each over the EM gain.

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
    Electrons over `excess` have the mean ``mu / excess`` and, but for the read noise, a variance equal to it: fits
    take them as Poisson's, and multiply the light that they find by `excess`. The register of an EMCCD holds 1.3 to
    1.03 times as much information as this at 0.2 to 10 electrons a pixel, so that standard errors are not too small.

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
        checked = {"read": _number("read", self.read, least=0.0), "offset": _number("offset", self.offset)}
        checked["excess"] = validation.real("excess", self.excess, least=1.0, most=100.0)
        if self.white is not None:
            checked["white"] = white = _number("white", self.white)
            if not np.all(white > 0.0):
                raise ValueError(f"white must be > 0 electrons, got {np.min(white):g}")
        vars(self).update(checked)

    def electrons(self, image: ArrayLike) -> Array:
        """Return the electrons of a recorded `image` (..., height, width), ``(image - offset) * white``.

        They may be negative, by read noise. ValueError if a value is not finite.
        """
        values = validation.real_array("image", image)
        return np.asarray((values - self._for("offset", values.shape)) * self._for("white", values.shape))

    def image(self, electrons: ArrayLike) -> Array:
        """Return the image of `electrons`, the inverse of :meth:`electrons`; ValueError if one is not finite."""
        values = validation.real_array("electrons", electrons)
        return np.asarray(values / self._for("white", values.shape) + self._for("offset", values.shape))

    def variance(self, electrons: ArrayLike) -> Array:
        """Return the variance ``excess * electrons + read**2`` for mean `electrons`; ValueError if not finite."""
        values = validation.real_array("electrons", electrons)
        return np.asarray(self.excess * values + self._for("read", values.shape) ** 2)

    @property
    def poisson(self) -> Noise:
        """The noise without excess of the same images, whose electrons are those of the light over `excess`."""
        if self.excess == 1.0:
            return self
        # Signal and read noise over the excess F: electrons / F of a Poisson variable have the variance of F
        # electrons.
        white = 1.0 if self.white is None else self.white
        return Noise(white=white / self.excess, read=self.read / self.excess, offset=self.offset)

    def record(self, electrons: ArrayLike, seed: int | np.random.Generator) -> Array:
        """Return a simulated image with random photon and read noise, in its own unit, not rounded.

        `electrons` is the mean of each pixel, shape ``(..., height, width)``; one `seed` makes one image. TypeError
        or ValueError if a mean is negative or not finite, or there is no such seed. With `excess` each electron
        becomes many, their number of an exponential distribution (gamma, for an excess other than 2) of mean 1.
        """
        mean = validation.real_array("electrons", electrons, least=0.0)
        draw = random_numbers(seed)
        photons: Array = draw.poisson(mean).astype(float)
        made = np.asarray(draw.standard_normal(mean.shape))
        if self.excess > 1.0:
            # A sum of n gamma variates of shape k and scale 1/k; by Wald's identity the variance is mean (1 + 1/k).
            # Excess 1 + 1 / k.
            shape = 1.0 / (self.excess - 1.0)
            photons = np.asarray(draw.gamma(shape * photons)) / shape
        made *= self._for("read", mean.shape)
        made += photons
        made /= self._for("white", mean.shape)
        made += self._for("offset", mean.shape)
        return made

    def part(self, rows: slice, columns: slice) -> Noise:
        """Return the noise of a window of images, for which maps are cut.

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
        """Return it; ValueError if a map has not the height and width of images.

        Parameters
        ----------
        shape : tuple of int
            Of images, height and width last.

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
        """Return a number, or the value of each pixel if images have this shape."""
        value: float | Array | None = getattr(self, name)
        if value is None:
            return 1.0
        if isinstance(value, float) or value.shape == shape[-2:]:
            return value
        raise ValueError(f"{name}, of shape {value.shape}, must have a value for each pixel, got images of {shape}")

    def to_dict(self) -> Json:
        """Return everything in plain types; ``Noise(**plain)`` is the inverse."""
        return {name: v if v is None or isinstance(v, float) else v.tolist() for name, v in vars(self).items()}

    def _content(self) -> tuple[object, ...]:
        return tuple(v if v is None else (np.shape(v), np.asarray(v).tobytes()) for v in vars(self).values())


def _number(name: str, value: ArrayLike, least: float = -np.inf) -> float | Array:
    """Return a finite number, or an array (height, width) of them."""
    found = validation.real_array(name, value, least=least) + 0.0  # no -0
    if found.ndim not in (0, 2) or found.size == 0:
        raise ValueError(f"{name} must be a number or have the shape (height, width), got shape {found.shape}")
    if found.ndim == 0:
        return float(found)
    found.flags.writeable = False
    return found
