"""What a package is asked for, and how it was set up."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

import lommel as lm
from benchmarks.truth import exact, exact_stack


@dataclass(frozen=True)
class Setup:
    """One configuration of a package.

    Attributes
    ----------
    config : str
    call : callable
        Computes the image or the stack; the grids, masks and plans that do not depend on the aberrations are there.
    between : bool
        Whether the axis of the window lies between its middle pixels.
    averaged : bool
        Whether pixels average the intensity over their area.
    judged : bool
        Whether what `call` returns is an intensity that can be judged.
    """

    config: str
    call: Callable[[], Any]
    between: bool = False
    averaged: bool = False
    judged: bool = True


@dataclass(frozen=True)
class Focus:
    """A stack through focus of a scalar microscope, all refractive indices alike.

    The phase ``k z sqrt(n^2 - NA^2 rho^2)`` is no paraxial one: its series in rho^2 to rho^20, which at this NA is
    exact to 1e-5 rad, is what lommel is given.
    """

    n: int = 255
    planes: int = 64
    aperture: float = 0.8
    index: float = 1.5
    wavelength: float = 0.55
    pixels: float = 0.5
    reach: float = 20.0

    @property
    def pixel(self) -> float:
        """Pixel pitch in micrometres."""
        return self.pixels * self.wavelength / (2.0 * self.aperture)

    @property
    def z(self) -> NDArray[np.float64]:
        """Defocus in micrometres, C_d = `reach` at the ends; whole nanometres, as one of the packages needs them."""
        far = 2.0 * self.reach * self.index * self.wavelength / (np.pi * self.aperture**2)
        return np.linspace(-1.0, 1.0, self.planes) * round(1000.0 * far) / 1000.0

    def pupil(self, share: float = 1.0) -> lm.Pupil:
        """Return the stack of pupils."""
        phase = 2.0 * np.pi / self.wavelength * self.index * share * self.z
        square, term, series = (self.aperture / self.index) ** 2, 1.0, []
        for k in range(1, 11):
            term *= -square * (1.5 - k) / k
            series.append(phase * term)
        return lm.Pupil(lm.Wavefront(0.5 * series[0], series[1], series[2:]))

    def fresh(self, count: int) -> list[lm.Pupil]:
        """Return that many new stacks."""
        return [self.pupil(1.0 - 1e-7 * k) for k in range(count)]

    def exact(self, *, averaged: bool) -> NDArray[np.float64]:
        """Return the exact stack, of samples or of averages over pixels (25 points each)."""
        if not averaged:
            return exact_stack(self.pupil(), self.n, self.pixels)
        x, w = np.polynomial.legendre.leggauss(5)
        # A quadrant, from the axis outwards, is enough.
        half = self.n // 2
        at = np.arange(half + 1)[:, None] + 0.5 * x
        total = np.zeros((self.planes, half + 1, half + 1))
        for j in range(x.size):
            for i in range(x.size):
                part = exact(self.pupil(), at[:, j, None], at[:, i], np.pi * self.pixels)
                total += 0.25 * w[j] * w[i] * part
        mirror = np.abs(np.arange(self.n) - half)
        return total[:, mirror[:, None], mirror]
