"""A camera that is none of lommel's: photons to counts, with what sensors do beside."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np


@dataclass(frozen=True, eq=False)
class Camera:
    """From mean electrons to what is recorded.

    Attributes
    ----------
    gain, offset, read : float or map
        Electrons a count, counts, electrons rms. A gain of 0 records electrons as floats.
    full : float
        Electrons that a pixel holds; `bloom` is the share of what is above that goes to both neighbours in a column.
    register : float
        Mean gain of an electron-multiplying register; 0 for none. `gain` and `read` are those before it.
    bend : float
        Share that is lost at `full` electrons, growing with the square of the light.
    rows : float
        Noise of whole rows, electrons rms.
    stripes : float
        Amplitude of pick-up, electrons: waves of 12.6 pixels along rows, of another phase in each image.
    warm : map or None
        Dark electrons of each pixel, as of hot pixels. dead : map of bool, pixels that do not respond.
    rays : float
        Mean number of cosmic rays in an image: tracks of up to 8 pixels of 300 to 6000 electrons.
    """

    gain: float | np.ndarray = 0.46
    offset: float | np.ndarray = 100.0
    read: float | np.ndarray = 1.6
    full: float = np.inf
    bloom: float = 0.0
    register: float = 0.0
    bend: float = 0.0
    rows: float = 0.0
    stripes: float = 0.0
    warm: np.ndarray | None = None
    dead: np.ndarray | None = None
    rays: float = 0.0
    bits: int = 16

    def record(self, mean: np.ndarray, seed: int) -> np.ndarray:
        """Return what it records of images (..., rows, columns)."""
        draw = np.random.default_rng(seed)
        mean = np.maximum(mean, 0.0) + (0.0 if self.warm is None else self.warm)
        electrons = draw.poisson(mean).astype(float)
        if self.dead is not None:
            electrons *= ~self.dead
        for image in electrons.reshape(-1, *electrons.shape[-2:]):  # views
            for _ in range(draw.poisson(self.rays)):
                _ray(image, draw)
        if np.isfinite(self.full):
            above = np.maximum(electrons - self.full, 0.0)
            electrons -= above
            electrons[..., 1:, :] += 0.5 * self.bloom * above[..., :-1, :]
            electrons[..., :-1, :] += 0.5 * self.bloom * above[..., 1:, :]
            electrons = np.minimum(electrons, self.full) * (1 - self.bend * electrons / self.full)
        if self.register:
            shape = np.maximum(electrons, 1e-12)
            electrons = np.where(electrons > 0, draw.gamma(shape, self.register), 0.0) / self.register
        electrons += draw.normal(size=electrons.shape) * self.read
        electrons += draw.normal(size=electrons.shape[:-1])[..., None] * self.rows
        if self.stripes:
            phase = draw.uniform(0, 2 * np.pi, (*electrons.shape[:-2], 1, 1))
            electrons += self.stripes * np.sin(np.arange(electrons.shape[-1]) / 2 + phase)
        if np.ndim(self.gain) == 0 and self.gain == 0:
            return electrons
        counts = np.rint(electrons / self.gain + self.offset)
        return np.clip(counts, 0, 2**self.bits - 1).astype(np.uint16)

    def but(self, **other: object) -> Camera:
        """Return one that differs in something."""
        return replace(self, **other)  # type: ignore[arg-type]


def trailed(mean: np.ndarray, share: float, length: float = 2.0) -> np.ndarray:
    """Return light of which a share arrives late along columns: charge that its transfer leaves behind."""
    rows = np.arange(mean.shape[-2])
    late = np.where(rows[:, None] > rows, np.exp((rows - rows[:, None] + 1.0) / length), 0.0)
    return mean + share * (np.tensordot(mean, late * (1 - np.exp(-1 / length)), (-2, 1)).swapaxes(-1, -2) - mean)


def scientific(shape: tuple[int, int], seed: int) -> Camera:
    """Return an sCMOS camera: maps of gain, offset and read noise with some noisy pixels."""
    draw = np.random.default_rng(seed)
    read = 1.1 * np.exp(np.abs(draw.normal(0, 0.35, shape)))
    noisy = draw.random(shape) < 3e-3
    read[noisy] = draw.uniform(5, 20, noisy.sum())
    return Camera(0.46 * (1 + draw.normal(0, 0.01, shape)), 100 + draw.normal(0, 1.0, shape), read)


def hot(shape: tuple[int, int], share: float, seed: int, least: float = 200.0, most: float = 4000.0) -> np.ndarray:
    """Return the dark electrons of hot pixels, a share of all, spread evenly in the logarithm."""
    draw = np.random.default_rng(seed)
    size = np.exp(draw.uniform(np.log(least), np.log(most), shape))
    return np.where(draw.random(shape) < share, size, 0.0)


def _ray(image: np.ndarray, draw: np.random.Generator) -> None:
    angle, length = draw.uniform(0, np.pi), draw.integers(1, 9)
    start = draw.uniform(0, image.shape)
    for step in range(length):
        row, column = (start + step * np.array([np.sin(angle), np.cos(angle)])).astype(int)
        if 0 <= row < image.shape[0] and 0 <= column < image.shape[1]:
            image[row, column] += draw.uniform(300, 6000)
