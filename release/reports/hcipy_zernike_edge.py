"""hcipy: a Zernike mode on a supersampled aperture, with and without the default radial_cutoff."""

import hcipy
import numpy as np

grid = hcipy.make_pupil_grid(256)
focal = hcipy.make_focal_grid(q=8, num_airy=8)
propagate = hcipy.FraunhoferPropagator(grid, focal)
aperture = hcipy.evaluate_supersampled(hcipy.make_circular_aperture(1), grid, 8)  # gray pixels at the edge
images = {}
for cutoff in (True, False):
    phase = 0.5 * hcipy.zernike_noll(4, 1, grid, radial_cutoff=cutoff)  # 0.5 rad rms of defocus
    images[cutoff] = propagate(hcipy.Wavefront(aperture * np.exp(1j * phase))).intensity
beyond = (grid.as_("polar").r >= 0.5) & (aperture > 0)
lit = int((aperture > 0).sum())
print(f"pixels with light whose centre is beyond the edge: {int(beyond.sum())} of {lit}")
print(
    "largest difference of the images over the peak:", abs(images[True] - images[False]).max() / images[False].max()
)
# On the axis: |int_0^1 exp(i 0.5 sqrt(3) (2 t - 1)) dt|^2
exact = np.sinc(0.5 * np.sqrt(3) / np.pi) ** 2
flat = propagate(hcipy.Wavefront(aperture)).intensity.max()
for cutoff, image in images.items():
    middle = image.reshape(focal.shape)[focal.shape[0] // 2, focal.shape[1] // 2]
    print(f"radial_cutoff={cutoff}: Strehl ratio {middle / flat:.6f}, exact {exact:.6f}")
