"""The padded FFT of the sampled pupil, with which the paper compares its method."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
import scipy

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.core.answers import Intensities
from lommel.methods.matrix_fourier import MAX_SAMPLES, pupil_functions, require_samples
from lommel.methods.method import Method
from lommel.optics.grid import Grid
from lommel.optics.pupil import Pupil

_MAX_SIDE = 16384  # largest side of an FFT


@dataclass(frozen=True)
class Fraunhofer(Method[Pupil]):
    r"""Fast Fourier transform of the sampled pupil to an image grid that contains the requested pixel centres.

    Supports every pupil, if no light is aliased into the window. Sampling the aperture's edge causes an error of
    first order in the sample spacing, which is not bounded: typically 1e-3 to 1e-2 of the peak with 256 samples.

    Parameters
    ----------
    samples : int, default 256
        Smallest number of samples across the diameter of the aperture, 8 to 8192.
    padding : float, default 4
        Smallest ratio of the length of the FFT to `samples`, at least 1.
    edge : {"binary", "grey"}, default "binary"
        "binary": a sample is 1 if its centre is clear, else 0; "grey": it is the clear fraction of its cell.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range.

    Notes
    -----
    The FFT of M samples with the spacing delta in rho has the spacing ``2 pi / (M delta)`` in v. delta is chosen such
    that this spacing is the pixel pitch divided by an integer: the pixel centres need no interpolation. Light at v is
    aliased to ``v +- 2 pi / delta``; ValueError is raised if the aliased geometric blur would reach the window. Pixel
    averages are computed by multiplying the spectrum of the intensity by sincs.
    """

    apodized = nonradial = any_aperture = True
    samples: int = 256
    padding: float = 4.0
    edge: str = "binary"

    def __post_init__(self) -> None:
        object.__setattr__(self, "samples", validation.integer("samples", self.samples, least=8, most=MAX_SAMPLES))
        object.__setattr__(self, "padding", validation.real("padding", self.padding, least=1.0))
        validation.choice("edge", self.edge, ("binary", "grey"))

    def period(self, pupil: Pupil) -> float:
        """Return the period of the image in units of lambda*N, which is `samples` for any `pupil`."""
        return float(self.samples)

    def intensity(self, pupil: Pupil, grid: Grid, threads: int) -> Intensities:
        """Return I at pixel centres, or averaged over pixels, shape ``(n, height, width)``.

        Raises
        ------
        ValueError
            If light would be aliased into the window, or if the FFT would be larger than 16384 x 16384.
        """
        stride, side, spacing = self._layout(pupil, grid)
        count = math.ceil(1.0 / spacing + 0.5)
        x = spacing * np.arange(-count, count + 1, dtype=np.float64)
        # The FFT has the optical axis at pixel (height // 2, width // 2); a tilt of the pupil shifts the axis.
        shift = grid.step(pupil) * (np.array([grid.height // 2, grid.width // 2]) - grid.axis)
        tilt = np.exp(-1j * (shift[0] * x[:, None] + shift[1] * x))
        index = np.arange(-count, count + 1) % side
        rows = stride * (np.arange(grid.height) - grid.height // 2) % side
        columns = stride * (np.arange(grid.width) - grid.width // 2) % side
        images = np.empty((math.prod(pupil.shape), *grid.shape))
        for image, pupil_function in zip(images, pupil_functions(pupil, x, 0.5 * spacing, self.edge), strict=True):
            padded = np.zeros((side, side), dtype=np.complex128)
            # Sum, not assignment: without padding the first and the last sample have the same index.
            np.add.at(padded, np.ix_(index, index), pupil_function * tilt)
            field = scipy.fft.fft2(padded, overwrite_x=True)
            field = field if grid.integrate else field[np.ix_(rows, columns)]
            intensity = (spacing**2 / math.pi) ** 2 * (field.real**2 + field.imag**2)
            image[:] = _average_squares(intensity, stride)[np.ix_(rows, columns)] if grid.integrate else intensity
        return Intensities(images, None)

    def require_fit(self, pupil: Pupil, grid: Grid) -> None:
        """Raise ValueError if light would be aliased into the window, or the FFT would be too large.

        Parameters
        ----------
        pupil : Pupil
        grid : Grid

        Raises
        ------
        ValueError
        """
        self._layout(pupil, grid)

    def _layout(self, pupil: Pupil, grid: Grid) -> tuple[int, int, float]:
        """Return the number of FFT samples per pixel, the side of the FFT, and the sample spacing in rho."""
        step = grid.step(pupil)
        # The intensity has twice the bandwidth of the field: pixel averages need a padding of at least 2.
        padding = max(self.padding, 2.0) if grid.integrate else self.padding
        stride = max(1, math.ceil(padding * step / math.pi - 1e-9))
        per_diameter = stride * math.pi / step  # FFT length / `samples` at which the FFT spacing fits the pixels
        require_samples(self, self.samples, pupil, grid)
        length = max(self.samples * per_diameter, stride * max(grid.shape))
        if length > _MAX_SIDE:
            raise ValueError(
                f"Fraunhofer would need an FFT of {length:.0f}^2 for {self.samples} samples and pixels of "
                f"{grid.side / pupil.scale:.4g} lambda*N, more than the limit of {_MAX_SIDE}^2; use fewer samples "
                "or a smaller window"
            )
        side = int(scipy.fft.next_fast_len(math.ceil(length)))
        return stride, side, 2.0 * math.pi * stride / (side * step)


def _average_squares(intensity: Array, stride: int) -> Array:
    """Return averages over squares of `stride` x `stride` samples: the spectrum is multiplied by sincs."""
    side = len(intensity)
    sinc_x = np.sinc(stride / side * np.arange(side // 2 + 1))
    sinc_y = np.sinc(stride * np.fft.fftfreq(side))
    # Clamp to 0: averages of an intensity are not negative.
    averages: Array = scipy.fft.irfft2(scipy.fft.rfft2(intensity) * (sinc_y[:, None] * sinc_x), s=intensity.shape)
    return np.maximum(averages, 0.0)
