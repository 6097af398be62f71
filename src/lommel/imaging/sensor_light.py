"""The light of a point on the pixels of a sensor, at any defocus."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, Self

import numpy as np
from numpy.typing import NDArray

from lommel.base.arrays import Array
from lommel.estimation.pixel_transfer import transfer_of_windows
from lommel.imaging.defocus_nodes import Parabola
from lommel.methods.choice import of_profiles
from lommel.methods.pixels.rule import pixel_rule, quarters, sums_of_windows
from lommel.optics.lens import Lens
from lommel.optics.pupil import Pupil
from lommel.optics.wavefront.wavefront import Wavefront

_METHOD = of_profiles(1e-7)


@dataclass(frozen=True)
class SensorLight:
    """The light of a point on the pixels of a sensor, at any defocus.

    Attributes
    ----------
    pupil : Pupil
        In focus, with the aberrations of the lens, at its wavelength; radially symmetric.
    phase : callable
        Makes wavefronts of defocus, as :meth:`lommel.Lens.phase`.
    spectrum : sequence of (wavelength, weight)
        Of the channel; weights sum to 1.
    pixel : float
        Metres.
    threads : int
        At most so many, 0 for as many as there are processors. The result does not depend on it.
    rate : callable, optional
        As :meth:`lommel.Lens.phase_rate`, of `phase`; by default that of a paraxial lens.
    """

    pupil: Pupil
    phase: Callable[[NDArray[np.float64]], Wavefront]
    spectrum: Sequence[tuple[float, float]]
    pixel: float
    threads: int = 0
    rate: Callable[[float], float] | None = None

    @classmethod
    def of(cls, lens: Lens, spectrum: Sequence[tuple[float, float]], pixel: float, threads: int = 0) -> Self:
        """Return the light that a lens of radially symmetric aberrations makes of one channel.

        Parameters
        ----------
        lens : Lens
        spectrum, pixel, threads
            As above.

        Returns
        -------
        SensorLight
        """
        pupil = Pupil(
            lens.aberrations,
            obscuration=lens.obscuration,
            wavelength=lens.wavelength,
            f_number=lens.working_f_number,
            apodization=lens.illumination,
            colour=lens.pupil_colour,
        )
        return cls(pupil, lens.phase, spectrum, pixel, threads, lens.phase_rate)

    def defocused(self, defocus: NDArray[np.float64]) -> Pupil:
        """Return the pupil at each defocus.

        Parameters
        ----------
        defocus : ndarray, shape (n,)
            C_d, radians at the wavelength of the pupil.

        Returns
        -------
        Pupil
        """
        return self.pupil.carrying(self.phase(defocus) + self.pupil.wavefront, None)

    def shares(self, pupil: Pupil, half: int) -> NDArray[np.float64]:
        """Return the share of the light of a point in each pixel of the octant, shape ``(n, cells)``.

        Parameters
        ----------
        pupil : Pupil
            A stack of shape (n,), from :meth:`defocused`.
        half : int
            Pixels from the middle one to the edge.

        Returns
        -------
        ndarray
        """
        total: Any = 0.0
        for wavelength, weight in self.spectrum:
            there = pupil.in_light(wavelength)
            step = math.pi * self.pixel / there.scale
            rule = pixel_rule(half, step)
            share = weight * step**2 / (4.0 * math.pi * there.transmission)
            total += share * _METHOD.means(there, step * rule.radii, rule.matrix, self.threads)
        return np.asarray(total)

    def enough(self, defocus: tuple[float, float], energy: float, largest: int) -> tuple[int, Parabola]:
        """Return half of a window that holds `energy` of the light at both ends of the range and in its middle.

        Parameters
        ----------
        defocus : (float, float)
            Range of C_d, radians.
        energy : float
            Share of the light.
        largest : int
            What half may be at most.

        Returns
        -------
        half : int
        parabola : Parabola
            Nearly 1 over the peaks.

        Raises
        ------
        ValueError
            If half would be more than `largest`.
        """
        ends = np.linspace(*defocus, 3)
        pupil = self.defocused(ends)
        half = math.ceil(float(pupil.geometric_radius().max()) / self.pixel) + 1
        while True:
            if half > largest:
                raise ValueError(
                    f"the blur takes windows of more than {2 * largest + 1} pixels a side to hold {energy:g} of "
                    f"the light; stop down, allow larger windows (largest={half} or more), or ask for less of it "
                    "(energy=)"
                )
            shares = self.shares(pupil, half)
            sums = sums_of_windows(shares, half)
            if sums[:, -1].min() >= energy:
                half = int((sums >= energy).argmax(axis=1).max()) + 1
                return half, Parabola.through(ends, shares.max(axis=1))
            half = math.ceil(1.3 * half) + 1


def sensor_transfer(
    lens: Lens,
    distances: Array,
    spectrum: Sequence[tuple[float, float]],
    pixel: float,
    shape: tuple[int, int],
    half: int,
) -> NDArray[np.float32]:
    """Do as :func:`lommel.estimation.pixel_transfer.pixel_transfer`, at no more cost for pixels of many lambda*N.

    Parameters
    ----------
    lens, distances, spectrum, pixel, shape, half
        As there.

    Returns
    -------
    ndarray, shape (count, height // 2 + 1, width // 2 + 1)
    """
    light = SensorLight.of(lens, spectrum, pixel)
    octants = light.shares(light.defocused(lens.defocus(distances)), half)
    return transfer_of_windows(np.asarray(quarters(octants, half)), shape)
