r"""
The pyramid of Zernike aberrations
==================================

PSFs of one radian rms of each Zernike term up to degree 6: a row for each degree n, with azimuthal order m across,
sines on the left and cosines on the right.
"""

import matplotlib.pyplot as plt
import numpy as np

import lommel as lm
from lommel.special import zernike

# %%
# A stack of wavefronts makes a stack of images in one call. All have the same rms, and about the same Strehl ratio,
# but not the same shape: of :math:`\cos m\theta` the image looks the same after :math:`1/m` of a turn where m is
# odd, and after :math:`1/2m` where it is even.

degrees = 7
terms = [(n, m) for n in range(degrees) for m in range(-n, n + 1, 2)]
amounts = np.eye(len(terms))
stack = lm.Pupil(lm.Wavefront.zernike({term: amounts[j] for j, term in enumerate(terms)}))
images = lm.psf(stack, shape=61, pixel=0.2, normalize="peak")

figure = plt.figure(figsize=(11, 12.4))
margins = {"left": 0.05, "right": 0.99, "bottom": 0.045, "top": 0.97}
places = figure.add_gridspec(degrees, 2 * degrees, **margins, wspace=0.5, hspace=0.3)
half = 0.5 * 61 * 0.2
for j, (n, m) in enumerate(terms):
    place = figure.add_subplot(places[n, degrees - 1 + m : degrees + 1 + m])
    place.imshow(np.sqrt(images.values[j]), cmap="inferno", extent=(-half, half, half, -half))
    name = zernike.name(n, m)
    place.set_title(f"({n}, {m})\n{zernike.name(n, m)}", fontsize=8)
    place.set_xticks([-5, 0, 5] if n == degrees - 1 else [])
    place.set_yticks([-5, 0, 5] if m == -n else [])
    place.tick_params(labelsize=7)
    if n == degrees - 1:
        place.set_xlabel("x (λN)", fontsize=8)
    if m == -n:
        place.set_ylabel("y (λN)", fontsize=8)
ratios = np.asarray(lm.strehl(stack))[1:]
print(f"{images.method!r}: error bound {images.error_bound:.1e} of each peak")
print(f"Strehl ratios: {ratios.min():.3f} to {ratios.max():.3f}; exp(-1) = {np.exp(-1):.3f}")
plt.show()

# %%
# Brightness is the square root of the intensity over the largest of each image. y points downwards, as it does in
# every picture here: the tail of a positive coma in y, :math:`(3, -1)`, hangs down.
