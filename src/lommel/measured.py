"""What is measured of an image, as methods: of one PSF, of each channel of a colour PSF, of each place of a grid."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lommel import measures
from lommel.base.arrays import Numbers
from lommel.measures.answer import Measurable


class Measured(Measurable):
    """Measures of the image that values are samples of: the light of the optics, spread by blur and pixels.

    They do not depend on the pixel pitch, but for the pixel as a part of the image, nor on the window: what they take
    is the transfer function. ``of="optics"`` leaves the pixel out. Arrays have the shape of the stack of pupils, with
    an axis of channels after it where there are some, and then that of the argument. Errors are stated where each
    links to.
    """

    @property
    def energy(self) -> Numbers:
        """Fraction of all light that falls inside the window, to the edges of its outer pixels."""
        return self._numbers(measures.energy.window_energy)

    @property
    def strehl(self) -> Numbers:
        """Intensity on the axis over that without aberration; :func:`lommel.strehl` is that of a pupil."""
        return self._numbers(measures.spot.axis_strehl)

    @property
    def peak_strehl(self) -> Numbers:
        """Largest value in the window over the peak of the same aperture without aberration, wherever it is."""
        return self._numbers(measures.spot.peak_strehl)

    @property
    def peak_position(self) -> NDArray[np.float64]:
        """Place (x, y) of the largest value, from the axis; see :func:`lommel.measures.spot.peak_position`."""
        return np.asarray(self.measured(measures.spot.peak_position))

    @property
    def centroid(self) -> NDArray[np.float64]:
        """Centroid (x, y) of all light, from the axis; see :func:`lommel.measures.energy.image_centroid`."""
        return np.asarray(self.measured(measures.energy.image_centroid))

    def encircled_energy(self, radius: ArrayLike, *, about: str = "axis", of: str = "image") -> Numbers:
        """Return the fraction of all light within `radius` (metres or lambda*N) of the axis, or `about` the centroid.

        Of the image, or `of` the "optics" without the pixel; also beyond the window. See
        :func:`lommel.measures.energy.encircled_energy`.
        """
        return self._numbers(lambda one: measures.energy.encircled_energy(one, radius, about=about, of=of))

    def ensquared_energy(self, half_width: ArrayLike, *, about: str = "axis", of: str = "image") -> Numbers:
        """Return the fraction of all light within a square of sides ``2 half_width``.

        `about` the axis or the centroid, `of` the image or the optics: see
        :func:`lommel.measures.energy.ensquared_energy`.
        """
        return self._numbers(lambda one: measures.energy.ensquared_energy(one, half_width, about=about, of=of))

    def energy_diameter(self, fraction: float, *, about: str = "axis", of: str = "image") -> Numbers:
        """Return the diameter of the circle that holds `fraction` of all light: 0.5 for D50, 0.8 for D80.

        `about` the axis or the centroid, `of` the image or the optics: see
        :func:`lommel.measures.spot.energy_diameter`.
        """
        return self._numbers(lambda one: measures.spot.energy_diameter(one, fraction, about=about, of=of))

    def fwhm(self, along: str = "mean", *, of: str = "image") -> Numbers:
        """Return the full width at half maximum along "x", "y" or their mean, of the image or `of` the optics.

        See :func:`lommel.measures.spot.fwhm`.
        """
        return self._numbers(lambda one: measures.spot.fwhm(one, along, of=of))

    def otf(self, fx: ArrayLike, fy: ArrayLike = 0.0, *, of: str = "image") -> NDArray[np.complex128] | np.complex128:
        """Return the optical transfer function of the image, or `of` the optics, at frequencies `fx`, `fy`.

        Of lenses from the wavefront, beyond the Nyquist frequency of the pixels, too: see :func:`lommel.otf`. The
        transform of the values themselves is :func:`lommel.measures.transfer.sampled_otf`.
        """
        found: NDArray[np.complex128] | np.complex128 = self.measured(
            lambda one: measures.transfer.image_otf(one, fx, fy, of=of)
        )
        return found

    def mtf(self, fx: ArrayLike, fy: ArrayLike = 0.0, *, of: str = "image") -> Numbers:
        """Return the modulation transfer function, the modulus of :meth:`otf`, at `fx`, `fy`, `of` the same."""
        return np.abs(self.otf(fx, fy, of=of))

    def _numbers(self, measure: Callable[[Any], Any]) -> Numbers:
        found: Numbers = self.measured(measure)
        return found
