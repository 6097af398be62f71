"""
The field map of a camera from a checkerboard
=============================================

One picture of a checkerboard gives the wavefront of a lens all over the sensor: each crossing, where four squares
meet, is worth a star. The picture is made by a Fourier transform in NumPy, with vignetting and noise; the lens has
coma, a curved field and a tilted sensor.
"""

import matplotlib.pyplot as plt
import numpy as np
from scipy.signal import fftconvolve

import lommel as lm

wavelength, f_number, pixel = 550e-9, 2.8, 1.4e-6
rows, columns, square, over = 165, 240, 33.0, 5
camera = lm.Noise(white=0.6, read=2.5, offset=64.0)  # electrons per count, rms electrons, counts

# %%
# The wavefront at positions from -1 to 1 over the sensor, radians rms: defocus, astigmatism and coma. Its PSF is the
# square of the Fourier transform of the pupil, on 5 points a pixel.


def truth(u, v):
    """Return coefficients of Noll 4 to 8 at positions from -1 to 1."""
    return [0.2 + 0.5 * (u * u + v * v) + 0.3 * u, 0.4 * u * v, 0.2 * (u * u - v * v), 0.35 * v, 0.35 * u]


grid = (np.arange(96) + 0.5) / 48 - 1
x, y = np.meshgrid(grid, grid)
square_radius, inside = x * x + y * y, x * x + y * y <= 1.0
zernike = [
    np.sqrt(3) * (2 * square_radius - 1),
    np.sqrt(6) * 2 * x * y,
    np.sqrt(6) * (x * x - y * y),
    np.sqrt(8) * (3 * square_radius - 2) * y,
    np.sqrt(8) * (3 * square_radius - 2) * x,
]
step = pixel / (wavelength * f_number) / over
wave = np.exp(-1j * np.pi * step * np.outer(np.arange(-80, 81), grid))


def psf(u, v):
    """Return the PSF at a position."""
    phase = sum(c * z for c, z in zip(truth(u, v), zernike, strict=True))
    values = np.abs(wave @ (inside * np.exp(1j * phase)) @ wave.T) ** 2
    return values / values.sum()


# %%
# Squares are convolved tile by tile, each with the PSF of its crossing.

turn, half = 0.06, 25
light = np.zeros((rows, columns))
row, column = np.mgrid[:rows, :columns]
for i in range(-6, 7):
    for j in range(-6, 7):
        middle = (rows - 1) / 2 + square * (i * np.cos(turn) + j * np.sin(turn))
        across = (columns - 1) / 2 + square * (j * np.cos(turn) - i * np.sin(turn))
        tile = np.s_[max(round(middle) - half, 0) : max(round(middle) + half + 1, 0),
                     max(round(across) - half, 0) : max(round(across) + half + 1, 0)]  # fmt: skip
        if light[tile].size == 0:
            continue
        fine = (np.arange(-(half + 16) * over, (half + 17) * over) + 0.5) / over - 0.5
        dy, dx = fine[:, None] + round(middle) - middle, fine + round(across) - across
        down, along = dy * np.cos(turn) - dx * np.sin(turn), dx * np.cos(turn) + dy * np.sin(turn)
        # Points that a line crosses are partly white.
        lines = [np.clip(np.sin(np.pi * d / square) * square / np.pi * over, -0.5, 0.5) for d in (down, along)]
        board = 0.5 + 2.0 * lines[0] * lines[1] * (-1) ** (i + j)
        u, v = 2 * (across + 0.5) / columns - 1, 2 * (middle + 0.5) / rows - 1
        seen = fftconvolve(board, psf(np.clip(u, -1, 1), np.clip(v, -1, 1)), mode="same")
        seen = seen[16 * over : -16 * over, 16 * over : -16 * over].reshape(51, over, 51, over).mean((1, 3))
        y0, x0 = row[tile] - round(middle) + half, column[tile] - round(across) + half
        dy, dx = row[tile] - middle, column[tile] - across
        near = np.maximum(
            np.abs(dy * np.cos(turn) - dx * np.sin(turn)), np.abs(dx * np.cos(turn) + dy * np.sin(turn))
        )
        light[tile] = np.where(near <= square / 2, seen[y0, x0], light[tile])
vignetting = 1.0 - 0.3 * (((column / columns - 0.5) ** 2 + (row / rows - 0.5) ** 2) / 0.5)
chart = np.round(camera.record(vignetting * (500.0 + 8500.0 * light), seed=1885))

crossings = lm.detection.find_crossings(chart, noise=camera)
print(crossings.message)
crossings.plot()
plt.gca().set(xlabel="column (pixels)", ylabel="row (pixels)")

# %%
# All crossings are fitted jointly. One picture leaves the common sign of defocus and astigmatism open: it is that
# of a rough design, of a field that is curved the right way.

design = lm.FieldMap.from_seidel(210e-6, W220=0.5, wavelength=wavelength, f_number=f_number)
fit = lm.fit_field(crossings, design, pixel=pixel, terms=5, degree=2, blur=False)
print(fit.message)

# %%
# The map beside the truth: the lens was known to a hundredth of a wave or better everywhere.

(left, right), (top, bottom) = fit.extent
a, b = np.meshgrid(np.linspace(left, right, 61), np.linspace(top, bottom, 41))
values, errors = fit.at(a, b)
true = np.stack(truth(2 * (a - left) / (right - left) - 1, 2 * (b - top) / (bottom - top) - 1), axis=-1)
names = ["defocus", "oblique astigmatism", "vertical astigmatism", "coma y", "coma x"]
figure, axes = plt.subplots(2, 5, figsize=(11.5, 3.1), sharex=True, sharey=True, layout="constrained")
for j, name in enumerate(names):
    most = max(np.abs(true[..., j]).max(), 0.2) / (2 * np.pi)
    for ax, part in zip(axes[:, j], (true, values), strict=True):
        extent = (1e6 * left, 1e6 * right, 1e6 * bottom, 1e6 * top)
        shown = ax.imshow(part[..., j] / (2 * np.pi), extent=extent, cmap="RdBu_r", vmin=-most, vmax=most)
    axes[0, j].set_title(f"{name}\ntrue", fontsize=9)
    axes[1, j].set_title(f"fitted, ± {errors[..., j].mean() / (2 * np.pi):.4f}", fontsize=9)
    axes[1, j].set_xlabel("x (µm)")
    figure.colorbar(shown, ax=axes[:, j], label="waves rms" if j == 4 else None, aspect=30)
for ax in axes[:, 0]:
    ax.set_ylabel("y (µm)")
off = np.sqrt((((values - true) / errors) ** 2).mean())
print(f"errors: {off:.2f} times the standard errors, {np.abs(values - true).max() / (2 * np.pi):.4f} waves at most")
assert fit.converged
assert off < 2.0

plt.show()
