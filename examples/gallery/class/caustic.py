"""
The caustic of spherical aberration
===================================

With spherical aberration rays envelop a surface, the caustic, on which the ray density is infinite and the
intensity is not.
"""

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import LogNorm

import lommel as lm

# %%
# :math:`C_s = 50` radians are 8 waves. The defocus moves the sensor through the focus: rays through the pupil radius
# :math:`\rho` cross the axis at :math:`C_d = -C_s \rho^2`, the middle of the pupil at 0 and the rim at -50.

spherical = 50.0
defocus = np.linspace(-75.0, 20.0, 421)
pupils = lm.Pupil(lm.Wavefront(defocus, spherical))
window = {"shape": (1, 401), "pixel": 0.2, "normalize": "strehl"}
rays = lm.psf(pupils, method="geometric", **window)
waves = lm.psf(pupils, **window)

figure, both = plt.subplots(2, 1, figsize=(9.5, 7), sharex=True, sharey=True, layout="constrained")
for axes, answer, title in zip(
    both,
    (rays, waves),
    ("Geometric(): density of rays, averaged over pixels", "NijboerZernike(): intensity of the light"),
    strict=True,
):
    mesh = axes.pcolormesh(
        defocus,
        answer.grid.x,
        np.maximum(answer.values[:, 0, :].T, 1e-12),
        cmap="inferno",
        norm=LogNorm(1e-5, 5e-2, clip=True),
        rasterized=True,
    )
    axes.set_title(title, fontsize=11)
    axes.set_ylabel("x (λN)")
    axes.set_ylim(-40, 40)
both[1].set_xlabel("defocus constant $C_d$ (rad)")
figure.colorbar(mesh, ax=both, label="intensity (1 = without aberration, on the axis)")

print(f"brightest: {rays.values.max():.3f} of the rays, {waves.values.max():.3f} of the light")
plt.show()

# %%
# The intensity oscillates inside the caustic and decays outside. Its averages over a few rings equal the ray
# density. On the axis, where rays from a whole ring of the pupil meet, the ray density is infinite too: the
# brightness of a pixel there depends on its size, and only wave optics predicts the peak.
