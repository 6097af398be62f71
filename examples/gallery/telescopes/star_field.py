"""
The PSF between the stars of a field
====================================

An exposure of a field of stars gives the wavefront of a telescope everywhere: Zernike terms as polynomials of the
position, from all stars jointly. Averages of the stars of a region, in whose place the PSF changes, are wider and
noisier. The stars are made by a Fourier transform in NumPy.
"""

import matplotlib.pyplot as plt
import numpy as np

import lommel as lm

side, window, pixel, count = 900, 25, 0.5, 36  # pixels; the pitch is in units of lambda*N
telescope = lm.Pupil(wavelength=550e-9, f_number=8.0)
pitch = pixel * telescope.scale  # metres
camera = lm.Noise(read=3.0)
draw = np.random.default_rng(8)

# %%
# The telescope: a curved field, astigmatism that grows with the distance from the axis, coma, and a sensor that is
# tilted. Radians rms, of Noll 4 to 8, at positions from -1 to 1.


def truth(u, v):
    """Return coefficients at positions from -1 to 1."""
    return np.stack([0.4 + 0.8 * (u * u + v * v) + 0.4 * u, 0.8 * u * v, 0.4 * (u * u - v * v), 0.5 * v, 0.5 * u])


grid = (np.arange(96) + 0.5) / 48 - 1
x, y = np.meshgrid(grid, grid)
square, inside = x * x + y * y, x * x + y * y <= 1.0
zernike = [
    np.sqrt(3) * (2 * square - 1),
    np.sqrt(6) * 2 * x * y,
    np.sqrt(6) * (x * x - y * y),
    np.sqrt(8) * (3 * square - 2) * y,
    np.sqrt(8) * (3 * square - 2) * x,
]


def star(u, v, row=0.0, column=0.0):
    """Return the light in the pixels of a window: the mean of 3 x 3 points, the star off its middle."""
    wave = inside * np.exp(1j * np.tensordot(truth(u, v), zernike, 1))
    points = (np.arange(3 * window) - (3 * window - 1) / 2) / 3
    down, across = (np.exp(-1j * np.pi * pixel * np.outer(points - at, grid)) for at in (row, column))
    light = np.abs(down @ wave @ across.T) ** 2 * (pixel / 3) ** 2 / (inside.sum() * 48**2 * 4)
    return light.reshape(window, 3, window, 3).sum((1, 3))


sky = np.full((side, side), 30.0)
half, cell = window // 2, side // 6
for k in range(count):
    middle = cell * np.array(divmod(k, 6)) + draw.integers(half + 5, cell - half - 5, 2)
    u, v = 2 * (middle[1] + 0.5) / side - 1, 2 * (middle[0] + 0.5) / side - 1
    part = np.s_[middle[0] - half : middle[0] + half + 1, middle[1] - half : middle[1] + half + 1]
    sky[part] += np.exp(draw.uniform(np.log(8e3), np.log(1e5))) * star(u, v, *draw.uniform(-0.5, 0.5, 2))
image = camera.record(sky, seed=1885)

# %%
# Find the stars and fit the field. One focus leaves a common sign of defocus and astigmatism open: without a design
# the mean defocus is taken as positive, as it is here.

stars = lm.detection.find_spots(image, noise=camera, window=window)
print(stars.message)
fit = lm.fit_field(stars, telescope, pixel=pitch, terms=5, degree=2, blur=False)
print(fit.message)
fit.plot()

# %%
# The PSF in five places of the sensor: truth, the fit, and the average of the stars within a sixth of the sensor,
# each shifted to its centroid, on a square-root scale. Below are the differences from the truth, times five.


def average(u, v):
    """Return the mean of the stars around a position, without background."""
    away = np.hypot(*(2 * (stars.places[:, ::-1] + 0.5) / side - 1 - [u, v]).T)
    near = np.flatnonzero(away <= max(1 / 3, np.sort(away)[2]))  # three stars at least
    total = np.zeros((window, window))
    for k in near:
        row, column = stars.centers[k] - stars.places[k]
        f = np.fft.fftfreq(window)
        shift = np.exp(2j * np.pi * (f[:, None] * row + f[None] * column))
        total += np.fft.ifft2(np.fft.fft2(stars.windows[k] - 30.0) * shift).real
    return total / total.sum()


places = [(-0.8, -0.8), (0.0, -0.4), (0.0, 0.0), (0.5, 0.3), (0.8, 0.8)]
extent = (-half - 0.5, half + 0.5, half + 0.5, -half - 0.5)
figure, axes = plt.subplots(5, 5, figsize=(8.5, 8.8), sharex=True, sharey=True, layout="constrained")
for j, (u, v) in enumerate(places):
    exact = star(u, v)
    position = [at * side / 2 * pitch for at in (u, v)]
    fitted = fit.field.psf(*position, window, pitch).values
    mean = average(u, v)
    parts = [exact, fitted, mean, 5 * (fitted - exact), 5 * (mean - exact)]
    for i, (ax, part) in enumerate(zip(axes[:, j], parts, strict=True)):
        most = exact.max()
        style = {"cmap": "inferno", "vmin": 0.0, "vmax": 1.0} if i < 3 else {"cmap": "RdBu_r", "vmin": -1, "vmax": 1}
        ax.imshow(np.sign(part) * np.sqrt(np.abs(part) / most), extent=extent, **style)
    worst = [100 * np.abs(part - exact).max() / exact.max() for part in (fitted, mean)]
    axes[0, j].set_title(f"u = {u:+g}, v = {v:+g}".replace("-", "−"), fontsize=9)
    axes[3, j].set_title(f"{worst[0]:.1f} % of the peak", fontsize=9)
    axes[4, j].set_title(f"{worst[1]:.0f} % of the peak", fontsize=9)
    axes[4, j].set_xlabel("x (pixels)")
    print(
        f"at u = {u:+g}, v = {v:+g} the fit is off by {worst[0]:.2f} % of the peak, the average by {worst[1]:.0f} %"
    )
for ax, name in zip(axes[:, 0], ("truth", "fit", "average", "fit less truth", "average less truth"), strict=True):
    ax.set_ylabel(f"{name}\ny (pixels)")
assert fit.converged

plt.show()
