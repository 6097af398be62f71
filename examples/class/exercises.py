# The source of exercises.ipynb and exercises-solutions.ipynb, which ../notebooks.py writes. Cells tagged "exercise"
# or "solution" are in one of them only.

# %% [markdown] tags=["exercise"]
# # Exercises: PSF, Strehl ratio, MTF

# %% [markdown] tags=["solution"]
# # Solutions of the exercises: PSF, Strehl ratio, MTF

# %% [markdown]
# Six exercises on image formation, from the Airy pattern to the depth of focus, for about three hours. Needed: `pip
# install ".[plot]"` in a clone of lommel, and the optics of a first course (pupil, wavefront, interference).
#
# Wavefronts are given by Seidel's coefficients in waves at the edge of the pupil: $W = W_{020}\rho^2 +
# W_{040}\rho^4$, defocus and spherical aberration, $0 \le \rho \le 1$. Lengths on the sensor are in units of
# $\lambda N$, the wavelength times the f-number; spatial frequencies are in cycles per $\lambda N$, from 0 to the
# cutoff at 1.

# %% [markdown] tags=["exercise"]
# Replace every `...` by your own code. Each exercise names a result that you can derive on paper: compare.

# %% [markdown] tags=["solution"]
# **Solutions.** Each compares the computed number with the analytic result; an `assert` fails where they disagree.

# %%
import matplotlib.pyplot as plt
import numpy as np
from scipy import optimize, special

import lommel as lm


def lens(w020=0.0, w040=0.0, obscuration=0.0):
    """Return a pupil with W020 and W040 in waves, which may be arrays."""
    return lm.Pupil(lm.Wavefront.from_seidel(W020=w020, W040=w040), obscuration=obscuration)


# %% [markdown]
# ## 1. Count the rings of the Airy pattern
#
# The PSF of a lens without aberration is $I(r) = \left(2 J_1(\pi r) / (\pi r)\right)^2$ with $r$ in $\lambda N$
# (Airy, 1835).
#
# 1. Plot `profile` from the centre to $r = 5$ on a logarithmic axis. How many dark rings are there?
# 2. Find the radius of each dark ring. Are they evenly spaced?
# 3. Which share of the light is within each (`airy.encircled_energy(radius)`)? Lord Rayleigh (1881) found $1 -
#    J_0^2(\pi r) - J_1^2(\pi r)$.

# %%
airy = lm.psf(lens(), shape=257, pixel=0.04, normalize="strehl")
radius = np.linspace(0.0, 5.0, 2001)
profile = airy.profile(radius)[1]

# %% tags=["exercise"]
dark_rings = ...  # their radii in lambda*N
share_within = ...

# %% tags=["solution"]
minima = np.nonzero((profile[1:-1] < profile[:-2]) & (profile[1:-1] < profile[2:]))[0] + 1
dark_rings = radius[minima]
share_within = airy.encircled_energy(dark_rings)

figure, axes = plt.subplots(figsize=(7, 3.5), layout="constrained")
axes.semilogy(radius, np.maximum(profile, 1e-7))
for ring in dark_rings:
    axes.axvline(ring, color="0.7", linewidth=0.8)
axes.set_xlabel("radius (λN)")
axes.set_ylabel("intensity (1 = on the axis)")
for ring, share in zip(dark_rings, share_within, strict=True):
    print(f"dark ring at {ring:.2f} λN, {100 * share:.1f} % of the light within")

# %% [markdown] tags=["solution"]
# Four dark rings up to $r = 5$, at 1.22, 2.23, 3.24 and 4.24: the spacing approaches 1. The first encloses 83.8 %
# of the light.

# %% tags=["solution"]
assert np.allclose(dark_rings, special.jn_zeros(1, 4) / np.pi, atol=0.003)
v = np.pi * dark_rings
assert np.allclose(share_within, 1 - special.j0(v) ** 2 - special.j1(v) ** 2, atol=1e-5)

# %% [markdown]
# ## 2. Strehl ratio and Maréchal's approximation
#
# The Strehl ratio is the intensity on the axis relative to that of the perfect lens, `lm.strehl`. Maréchal's
# approximation estimates it from the rms wavefront error $\sigma$ (in waves) alone: $S \approx
# \exp\left(-(2\pi\sigma)^2\right)$, `lm.marechal`.
#
# 1. Plot both against defocus from 0 to 1.2 waves. On paper: $S = \left(\sin(\pi W_{020}) / (\pi W_{020})\right)^2$
#    and $\sigma = W_{020} / \sqrt{12}$.
# 2. What is the Strehl ratio at a quarter wave of defocus (Rayleigh's limit)?
# 3. Up to which defocus is the approximation within 10 % of the Strehl ratio?

# %%
defocus = np.linspace(0.0, 1.2, 121)  # waves

# %% tags=["exercise"]
strehl = ...
marechal = ...
quarter_wave = ...  # the Strehl ratio at 0.25 waves
valid_to = ...  # waves

# %% tags=["solution"]
strehl = lm.strehl(lens(defocus))
marechal = lm.marechal(lens(defocus))
quarter_wave = lm.strehl(lens(0.25))
valid_to = optimize.brentq(lambda w: lm.marechal(lens(w)) / lm.strehl(lens(w)) - 1.1, 0.2, 0.9)

figure, axes = plt.subplots(figsize=(7, 3.5), layout="constrained")
axes.plot(defocus, strehl, label="Strehl ratio")
axes.plot(defocus, marechal, "--", label="Maréchal's approximation")
axes.axvline(valid_to, color="0.7", linewidth=0.8)
axes.set_xlabel("defocus (waves)")
axes.set_ylabel("ratio")
axes.legend()
print(f"{quarter_wave:.3f} at a quarter wave; within 10 % up to {valid_to:.2f} waves")

# %% [markdown] tags=["solution"]
# $S(1/4) = 8/\pi^2 = 0.811$. The approximation is within 10 % down to $S \approx 0.4$; it never becomes zero, while
# the Strehl ratio does at one wave.

# %% tags=["solution"]
assert np.allclose(strehl, np.sinc(defocus) ** 2, atol=1e-12)
assert np.allclose(marechal, np.exp(-((2 * np.pi * defocus) ** 2) / 12), atol=1e-12)
assert np.isclose(quarter_wave, 8 / np.pi**2)
assert np.isclose(np.exp(-((2 * np.pi * valid_to) ** 2) / 12), 1.1 * np.sinc(valid_to) ** 2)
assert 0.35 < lm.strehl(lens(valid_to)) < 0.4

# %% [markdown]
# ## 3. Balance spherical aberration with defocus
#
# With $W_{040} = 1$ wave the Strehl ratio is 0.09 at the paraxial focus.
#
# 1. Find the defocus that maximises the Strehl ratio.
# 2. By which factor does it reduce the rms wavefront error (`lm.rms(..., unit="waves")`)?
# 3. On paper: minimise the variance of $W_{040}\rho^4 + W_{020}\rho^2$. With $t = \rho^2$, the mean over the pupil
#    is $\int_0^1 \dots \, dt$.

# %% tags=["exercise"]
best = ...  # waves
factor = ...

# %% tags=["solution"]
best = optimize.minimize_scalar(lambda w: -lm.strehl(lens(w, 1.0)), bounds=(-2, 0), method="bounded").x
factor = lm.rms(lens(0.0, 1.0)) / lm.rms(lens(best, 1.0))

through = np.linspace(-2.5, 0.5, 121)
figure, axes = plt.subplots(figsize=(7, 3.5), layout="constrained")
axes.plot(through, lm.strehl(lens(through, 1.0)))
axes.set_xlabel("defocus (waves)")
axes.set_ylabel("Strehl ratio")
print(f"best at {best:.3f} waves: Strehl ratio {lm.strehl(lens(best, 1.0)):.3f}, rms error smaller by {factor:.2f}")

# %% [markdown] tags=["solution"]
# $\sigma^2 = \frac{4}{45} W_{040}^2 + \frac{1}{6} W_{040} W_{020} + \frac{1}{12} W_{020}^2$ has its minimum at
# $W_{020} = -W_{040}$: $\sigma = W_{040}/(6\sqrt 5)$ instead of $2 W_{040}/(3\sqrt 5)$, four times smaller. The
# wavefront then stays within a quarter wave, and the Strehl ratio is 0.80: Rayleigh's rule once more.

# %% tags=["solution"]
assert np.isclose(best, -1.0, atol=1e-4)
assert np.isclose(factor, 4.0, atol=1e-4)
assert np.isclose(lm.rms(lens(-1.0, 1.0), unit="waves"), 1 / (6 * np.sqrt(5)))
assert np.isclose(lm.strehl(lens(best, 1.0)), 0.80, atol=0.005)

# %% [markdown]
# ## 4. The diffraction-limited MTF
#
# The modulation transfer function (MTF) is the contrast of the image of a line pattern. It is the modulus of the
# Fourier transform of the PSF, and of the autocorrelation of the pupil: for a circular pupil the overlap of two
# circles, $\frac{2}{\pi}\left(\arccos\nu - \nu\sqrt{1 - \nu^2}\right)$.
#
# 1. Plot `lm.mtf(lens(), frequency)` and the formula.
# 2. Obtain the MTF a second time, from the values of a PSF by `np.fft.fft2`. Why is there a difference, and what
#    reduces it?
# 3. Add obscurations of 0.3 and 0.6. At which frequencies does the contrast *rise*, and why?

# %%
frequency = np.linspace(0.0, 1.0, 101)
image = lm.psf(lens(), shape=64, pixel=0.25).values  # 16 lambda*N wide; the sum of all light is 1

# %% tags=["exercise"]
mtf = ...
formula = ...
mtf_of_image = ...  # at np.fft.rfftfreq(64, 0.25)

# %% tags=["solution"]
mtf = lm.mtf(lens(), frequency)
formula = 2 / np.pi * (np.arccos(frequency) - frequency * np.sqrt(1 - frequency**2))
mtf_of_image = np.abs(np.fft.fft2(image)[0, :33])
at = np.fft.rfftfreq(64, 0.25)

figure, axes = plt.subplots(figsize=(7, 4), layout="constrained")
axes.plot(frequency, mtf, label="circular pupil")
axes.plot(at, mtf_of_image, "k.", label="circular pupil, from the image")
for obscuration in (0.3, 0.6):
    axes.plot(frequency, lm.mtf(lens(obscuration=obscuration), frequency), label=f"obscuration {obscuration}")
axes.set_xlim(0, 1)
axes.set_xlabel("frequency (cycles per λN)")
axes.set_ylabel("contrast")
axes.legend()

# %% [markdown] tags=["solution"]
# The rings outside the window are missing: the sum of the image, which is its transform at frequency 0, is 0.977
# instead of 1. The missing light varies slowly in space, so that only the lowest frequencies are wrong. A larger
# window reduces the error slowly, since the light beyond a radius $r$ falls off as $1/r$. An obscuration removes
# short distances within the pupil and so raises the *relative* weight of the longest: contrast rises near the cutoff
# and falls at middle frequencies.

# %% tags=["solution"]
assert np.allclose(mtf, formula, atol=1e-9)
inside = at < 1
difference = np.abs(mtf_of_image[inside] - lm.mtf(lens(), at[inside]))
assert np.isclose(mtf_of_image[0], image.sum())
assert np.isclose(image.sum(), 0.977, atol=5e-4)
assert difference[1:].max() < 0.002
assert lm.mtf(lens(obscuration=0.6), 0.9) > lm.mtf(lens(), 0.9)
assert lm.mtf(lens(obscuration=0.6), 0.3) < lm.mtf(lens(), 0.3)

# %% [markdown]
# ## 5. MTF through focus, and contrast reversal
#
# 1. Draw the real part of the transfer function, `lm.otf`, over frequency and defocus from −3 to 3 waves.
# 2. At 2 waves of defocus, find the first frequency of which no contrast is left. What do black and white bars look
#    like beyond it?
# 3. Rays give $2 J_1(a)/a$ with $a = 8\pi W_{020}\nu$ (a uniform disk). How far off is their first zero at 1, 2, 5
#    and 10 waves?

# %%
defocus = np.linspace(-3.0, 3.0, 61)

# %% tags=["exercise"]
transfer = ...  # lm.otf(...).real, of shape (61, 101)
first_zero = ...  # at 2 waves, cycles per lambda*N

# %% tags=["solution"]
transfer = lm.otf(lens(defocus), frequency, tol=1e-6).real


def first_zero_at(waves):
    """Return the lowest frequency at which the transfer function vanishes."""
    scan = np.linspace(0.0, 0.5, 201)
    values = lm.otf(lens(waves), scan).real
    k = int(np.argmax(values < 0))
    return optimize.brentq(lambda f: lm.otf(lens(waves), f).real, scan[k - 1], scan[k])


first_zero = first_zero_at(2.0)
figure, axes = plt.subplots(figsize=(7, 4), layout="constrained")
shown = axes.pcolormesh(defocus, frequency, transfer.T, cmap="RdBu_r", vmin=-0.3, vmax=0.3)
axes.contour(defocus, frequency, transfer.T, levels=[0.0], colors="black", linewidths=0.7)
axes.set_xlabel("defocus (waves)")
axes.set_ylabel("frequency (cycles per λN)")
figure.colorbar(shown, label="transfer function, clipped")
ratios = []
for waves in (1, 2, 5, 10):
    rays, exact = special.jn_zeros(1, 1)[0] / (8 * np.pi * waves), first_zero_at(waves)
    ratios.append(rays / exact)
    print(f"{waves:2d} waves: rays {rays:.4f}, waves {exact:.4f}, ratio {rays / exact:.3f}")

# %% [markdown] tags=["solution"]
# At 2 waves the contrast is zero at 0.084 cycles per λN. Beyond, the transfer function is negative: black and white
# bars are exchanged (contrast reversal, spurious resolution). Rays are good to 2 % at 10 waves, and off by a fifth
# at one wave.

# %% tags=["solution"]
assert transfer.shape == (61, 101)
assert np.allclose(transfer, transfer[::-1], atol=1e-5)  # both sides of focus are alike
assert np.isclose(first_zero, 0.0840, atol=5e-4)
assert transfer[np.searchsorted(defocus, 1.999), 12] < 0
assert np.all(np.diff(ratios) > 0)
assert 0.75 < ratios[0] < 0.82
assert 0.97 < ratios[-1] < 1

# %% [markdown]
# ## 6. Depth of focus
#
# A camera lens, 50 mm at f/4 and 550 nm, is focused at infinity. Move the sensor out of focus by $\delta$.
#
# 1. Plot the Strehl ratio against $\delta$ from −80 to 80 µm.
# 2. How far may the sensor be off while the Strehl ratio stays above 0.81, Rayleigh's quarter wave? Compare with
#    $\pm 2\lambda N^2$.
# 3. How does the depth of focus change if the lens is stopped down to f/8?
# 4. A sensor has pixels of 4 µm. At which $\delta$ is the MTF at half its Nyquist frequency reduced to 0.5?
#    (`lm.mtf(..., pixel=4e-6)`.) Which criterion is stricter?

# %%
wavelength, focal_length = 550e-9, 0.05


def camera(shift, f_number=4.0):
    """Return the pupil of a star with the sensor `shift` metres behind the focus."""
    return lm.Lens(
        focal_length=focal_length, f_number=f_number, sensor_distance=focal_length + shift, wavelength=wavelength
    ).pupil(np.inf)


# %% tags=["exercise"]
depth = ...  # metres, one side
depth_at_f8 = ...
depth_by_mtf = ...

# %% tags=["solution"]
quarter = 8 / np.pi**2


def depth_of(f_number):
    """Return the shift in metres at which the Strehl ratio is that of a quarter wave."""
    return optimize.brentq(lambda s: lm.strehl(camera(s, f_number)) - quarter, 1e-6, 2e-4)


depth, depth_at_f8 = depth_of(4.0), depth_of(8.0)
half_nyquist = 1 / (4 * 4e-6)
depth_by_mtf = optimize.brentq(lambda s: lm.mtf(camera(s), half_nyquist, pixel=4e-6) - 0.5, 1e-6, 1e-4)

shifts = np.linspace(-80e-6, 80e-6, 161)
figure, axes = plt.subplots(figsize=(7, 3.5), layout="constrained")
for f_number in (4.0, 8.0):
    axes.plot(1e6 * shifts, [lm.strehl(camera(s, f_number)) for s in shifts], label=f"f/{f_number:g}")
axes.legend()
axes.axhline(quarter, color="0.7", linewidth=0.8)
axes.set_xlabel("shift of the sensor (µm)")
axes.set_ylabel("Strehl ratio")
print(f"Strehl ratio above 0.81: ±{1e6 * depth:.1f} µm at f/4, ±{1e6 * depth_at_f8:.1f} µm at f/8")
print(f"MTF of 0.5 at half the Nyquist frequency of 4 µm pixels: ±{1e6 * depth_by_mtf:.1f} µm at f/4")

# %% [markdown] tags=["solution"]
# $W_{020} = -\delta / (8 \lambda N^2)$ in waves, negative where the sensor lies behind the focus: a quarter wave is
# $\delta = \mp 2\lambda N^2 = \mp 17.6$ µm. Stopped down to f/8 the depth is four times larger, though the blur of
# rays only halves: diffraction sets the limit. The MTF at half of the Nyquist frequency allows about twice as much:
# such pixels do not resolve what Rayleigh's criterion protects.

# %% tags=["solution"]
assert np.isclose(depth, 2 * wavelength * 4.0**2, rtol=0.002)
assert np.isclose(depth_at_f8 / depth, 4.0, rtol=0.002)
assert 1.5 * depth < depth_by_mtf < 3 * depth
