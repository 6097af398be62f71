"""
MTF of aberrations
==================

The modulation transfer function (MTF) is the contrast of a line pattern against its spatial frequency. It is the
modulus of the autocorrelation of the pupil function, computed from the wavefront without an image.
"""

import matplotlib.pyplot as plt
import numpy as np

import lommel as lm

# %%
# Four aberrations of a tenth of a wave rms, hence of about the same Strehl ratio. Spherical aberration affects
# lines of all directions alike, coma does not; balanced astigmatism treats the two axes alike, and diagonal lines
# differently.

names = {"defocus": (2, 0), "spherical aberration": (4, 0), "coma in x": (3, 1), "astigmatism": (2, 2)}
pupils = {name: lm.Pupil(lm.Wavefront.zernike({term: 0.1}, unit="waves")) for name, term in names.items()}
frequency = np.linspace(0.0, 1.0, 101)

figure, axes = plt.subplots(figsize=(8, 4.8), layout="constrained")
axes.plot(frequency, lm.mtf(lm.Pupil(), frequency), color="black", linewidth=1, label="no aberration")
for (name, pupil), color in zip(pupils.items(), ("C0", "C1", "C2", "C3"), strict=True):
    axes.plot(frequency, lm.mtf(pupil, frequency), color=color, label=name)
    if not pupil.radial:
        axes.plot(frequency, lm.mtf(pupil, 0.0, frequency), color=color, linestyle="--", label=f"{name}, along y")
        diagonal = frequency / np.sqrt(2.0)
        axes.plot(frequency, lm.mtf(pupil, diagonal, diagonal), color=color, linestyle=":", label=f"{name}, at 45°")
    print(f"{name}: Strehl ratio {lm.strehl(pupil):.3f}, Marechal's estimate {lm.marechal(pupil):.3f}")
axes.set_title("0.1 waves rms", fontsize=11)
axes.set_xlabel("frequency, along x if not said otherwise (cycles per λN)")
axes.set_ylabel("contrast")
axes.set_ylim(0, 1)
axes.legend(fontsize=8)

# %%
# Through focus the transfer function changes its sign repeatedly: where it is negative, contrast is reversed
# (spurious resolution).

defocus = np.linspace(-12.0, 12.0, 97)
through = lm.otf(lm.Pupil(lm.Wavefront(defocus)), frequency, tol=1e-6).real
figure, axes = plt.subplots(figsize=(8, 4.8), layout="constrained")
mesh = axes.pcolormesh(defocus, frequency, through.T, cmap="RdBu_r", vmin=-0.3, vmax=0.3, rasterized=True)
axes.contour(defocus, frequency, through.T, levels=[0.0], colors="black", linewidths=0.7)
half = lm.mtf_frequency(lm.Pupil(lm.Wavefront(defocus[::2])))
axes.plot(defocus[::2], half, color="black", linestyle="--", linewidth=1, label="contrast of one half")
axes.set_title("through focus", fontsize=11)
axes.set_xlabel("defocus constant $C_d$ (rad)")
axes.set_ylabel("frequency (cycles per λN)")
axes.legend(loc="upper right", fontsize=8)
figure.colorbar(mesh, ax=axes, label="transfer function (clipped at ±0.3)", extend="both")

plt.show()

# %%
# Red is positive contrast, blue is reversed, and the lines between them are zeros of the transfer function, which
# no deconvolution recovers.
