"""Live sharpening: frames of known depth, or of one lens, in focus, by Wiener's filters in one pass."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lommel.base import validation
from lommel.estimation.focal_model import FocalLight, FocalModel
from lommel.imaging.focal_engine import BLOCK, CONTRAST, processors, ranged
from lommel.imaging.focal_frames import FrameForm
from lommel.imaging.focal_tables import SharpTables, Taps
from lommel.imaging.settings import spectra
from lommel.optics.lens import Lens
from lommel.optics.round_lenses import pixel_of
from lommel.recorded.noise import Noise

_MOST = 961  # candidates
_LIGHT = 5000.0  # electrons


class LiveSharpen:
    """Sharp images of single frames whose depth is known, in one pass.

    Parameters
    ----------
    lens : Lens
        At its focus distance and f-number; a circular or annular aperture and radially symmetric aberrations only.
    pixel : float
        Pixel pitch, metres.
    between : (float, float)
        Nearest and farthest distance, metres; the farthest may be infinite.
    noise : Noise
        Of the values of the frames, with numbers for `white`, `read` and `offset`.
    shape : (int, int) or (int, int, int)
        Height and width of the frames, pixels, 64 or more, and channels.
    light : float, optional
        Mean electrons of a pixel, by default 5000: less makes a smoother image.
    wavelengths : sequence of (float, float), optional
        Spectrum of the light: wavelengths, metres, and weights. By default the wavelength of the lens.
    saturation : float, optional
        Value from which on pixels are full, and filled from their neighbours, as is the largest of unsigned integers.
    threads : int, optional
        Number of threads; by default the number of processors. The result does not depend on it.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range or of another shape, or if the lens is not radially symmetric.

    Notes
    -----
    Wiener's filter of each distance, for textures of a spectrum that falls as the inverse square of the frequency, as
    a polynomial of one small filter (see :class:`lommel.imaging.LiveDepth`). It keeps the mean. Blur wider than the
    filters reach is undone in part.

    Examples
    --------
    >>> lens = lm.Lens(focal_length=35e-3, f_number=8.0, focus_distance=1.35, wavelength=540e-9)
    >>> sharpen = lm.imaging.LiveSharpen(lens, 4e-6, between=(1.2, 2.0), noise=lm.Noise(read=3), shape=(64, 96))
    >>> sharpen(np.full((64, 96), 1000, np.uint16), 1.7).round(3).max()
    np.float32(1000.0)
    """

    def __init__(
        self,
        lens: Lens,
        pixel: float,
        *,
        between: tuple[float, float],
        noise: Noise,
        shape: tuple[int, ...],
        light: float | None = None,
        wavelengths: Sequence[tuple[float, float]] | None = None,
        saturation: float | None = None,
        threads: int | None = None,
    ) -> None:
        pitch = pixel_of([lens], pixel)
        self._form = form = FrameForm(shape, noise, saturation, None)
        mean = _LIGHT if light is None else validation.real("light", light, least=1.0, below=1e9)
        count = validation.integer("threads", threads, least=1, most=1024) if threads is not None else processors()
        spectrum = spectra("wavelengths", [tuple(wavelengths)])[0] if wavelengths else ((lens.wavelength, 1.0),)
        self._between, self._vergence = ranged(between, [lens], pitch, None, _MOST)
        model = FocalModel.of([lens], self._vergence, spectrum, pitch, FocalLight(mean, form.read, (1.0,), CONTRAST))
        self._tables = tables = SharpTables(model, Taps.of(5), 12)
        self._factors = _single(tables.mixes(tables.pixel))
        self._stream = tables.stream(form.size, count)
        self._gains = _single([[form.white, 0.0, 0.0, 0.0, 0.0, 0.0]])

    def __repr__(self) -> str:
        near, far = self._between
        size = " x ".join(map(str, self._form.shape))
        return f"<LiveSharpen of frames of {size}, {near:g} to {far:g} m: {len(self._tables.basis)} images>"

    def __call__(
        self, frame: NDArray[Any], depth: float | ArrayLike, out: NDArray[np.float32] | None = None
    ) -> NDArray[np.float32]:
        """Return the sharp image of a frame, electrons.

        Parameters
        ----------
        frame : ndarray, shape (height, width) or (height, width, channels)
            Of uint8, uint16 or floats; NaN marks unknown pixels.
        depth : float or array_like, shape (height, width) or (height // 4, width // 4)
            Distance, metres, of all, of each pixel, or of blocks of 4 x 4 pixels, between whose middles it is taken
            to change linearly in 1 / distance.
        out : ndarray of float32, of the shape of a frame, optional
            To write to.

        Raises
        ------
        TypeError, ValueError
            If the frame or `out` is of another shape or type, or `depth` is of another shape, not finite or not above
            0.
        """
        stored = self._form.checked("frame", frame)
        places, side = self._places(depth)
        full = self._form.full(stored.dtype)
        made = self._form.image(out)
        if self._form.channels == 1:
            self._stream.take([stored], self._gains, self._form.offset, full, None)
            self._stream.mix(places, side, self._factors, made)
            return made
        one = np.empty(self._form.size, dtype=np.float32)
        for c in range(self._form.channels):
            plane = np.ascontiguousarray(stored[..., c])
            self._stream.take([plane], self._gains, self._form.offset, full, None)
            self._stream.mix(places, side, self._factors, one)
            made[..., c] = one
        return made

    def _places(self, depth: float | ArrayLike) -> tuple[NDArray[np.float32], int]:
        """Return positions of candidates, and of how many pixels a side each is the middle."""
        with np.errstate(over="ignore"):
            metres = np.asarray(depth, dtype=np.float32)
        height, width = self._form.size
        sides = {(): min(height, width), (height, width): 1, (height // BLOCK, width // BLOCK): BLOCK}
        if metres.shape not in sides:
            raise ValueError(
                f"depth must be a number, or have the shape {(height, width)} or "
                f"{(height // BLOCK, width // BLOCK)}, got {metres.shape}"
            )
        if not metres.min() > 0.0:  # NaN is not
            raise ValueError(f"depth must be > 0 metres everywhere, got {metres[~(metres > 0.0)].flat[0]}")
        first, step = (np.float32(each) for each in (self._vergence[0], self._vergence[1] - self._vergence[0]))
        # Maps of pixels take as long as their filters, unless they are turned into positions in one place.
        places = np.divide(np.float32(1.0) / step, np.atleast_2d(metres), order="C")
        places -= first / step
        return places, sides[metres.shape]


def _single(values: ArrayLike) -> NDArray[np.float32]:
    return np.ascontiguousarray(values, dtype=np.float32)
