r"""
The first fifteen Zernike terms
===============================

Phase over the pupil, and PSF, for a fifth of a wave rms of each term.
"""

import matplotlib.pyplot as plt
import numpy as np

import lommel as lm
from lommel.special import zernike

# %%
# Terms that depend on the direction go by (n, m): the cosine of :math:`m\theta` where m > 0, the sine where m < 0. x
# rises to the right and y downwards, in the pupil as on the sensor. A ray meets the sensor at the gradient of the
# phase, hence a tilt that rises to the right (red) moves the image to the right, and the tail of such a coma points
# there.

terms = [zernike.term(j, "noll") for j in range(1, 16)]
columns = 5
figure, axes = plt.subplots(6, columns, figsize=(9.5, 12.5), layout="constrained")
for j, (n, m) in enumerate(terms):
    wavefront = lm.Wavefront.zernike({(n, m): 0.2}, unit="waves")
    phase = lm.opd_map(wavefront, 101, unit="waves")
    if (n, m) != (0, 0):
        phase -= np.nanmean(phase)
    image = lm.psf(lm.Pupil(wavefront), 49, 0.2, normalize="peak")
    above, below = axes[2 * (j // columns), j % columns], axes[2 * (j // columns) + 1, j % columns]
    shown = above.imshow(phase, cmap="RdBu_r", vmin=-0.6, vmax=0.6, extent=(-1, 1, 1, -1))
    above.set_title(f"Noll {j + 1}: ({n}, {m})\n{zernike.name(n, m)}", fontsize=7)
    above.set(xticks=[-1, 0, 1], yticks=[-1, 0, 1], xticklabels=[])
    half = 49 * 0.2 / 2
    below.imshow(np.sqrt(image.values), cmap="inferno", extent=(-half, half, half, -half))
    for one in (above, below):
        one.tick_params(labelsize=6)
    if j % columns == 0:
        above.set_ylabel("y (pupil radii)", fontsize=8)
        below.set_ylabel("y (λN)", fontsize=8)
for one in axes[-1]:
    one.set_xlabel("x (λN)", fontsize=8)
figure.colorbar(shown, ax=axes, label="phase (waves)", location="bottom", shrink=0.5, aspect=40)

coma = lm.psf(lm.Pupil(lm.Wavefront.from_seidel(W131=1.5)), 61, 0.25)
print(f"centroid of 1.5 waves of coma: {(coma.values * coma.grid.x).sum() / coma.values.sum():+.2f} lambda N in x")
plt.show()

# %%
# Any orders, units and normalisations become a wavefront, and come back. The page on
# :doc:`conventions </conventions>` lists them all.
