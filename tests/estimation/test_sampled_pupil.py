"""Images of a search from samples of the pupil: near to those that are certified, for any aperture."""

from __future__ import annotations

import numpy as np
import pytest

import lommel as lm
from lommel.estimation.sampled_pupil import SampledPupil
from lommel.optics.grid import Grid
from lommel.optics.wavefront.wavefront import Wavefront

TERMS = ((1, -1), (1, 1), (2, -2), (2, 0), (2, 2), (3, -1), (4, 0))
EDGE = np.array([[0.5, 0.3, 0.8, 0.4, 0.9, 0.5, 1.1], [-0.3, 0.2, -0.9, 0.1, -0.6, -0.5, 0.7]])
APERTURES = {
    "vanes": lm.Pupil(obscuration=0.35, spider=lm.Spider(0.03, (0.3, 1.9, 3.4))),
    "apodized": lm.Pupil(apodization=0.5, spider=lm.Spider(0.1, (0.3, 1.9))),
    "segments": lm.Pupil(
        stop=lm.Segments([lm.Polygon.strip((-0.9, y), (0.9, y), 0.7) for y in (-0.4, 0.4)], tip=[0.6, -0.4])
    ),
    "vignetted": lm.Pupil(vignetting=lm.CatEye((0.4, 0.0)), wavelength=500e-9, f_number=4.0),
}


@pytest.mark.parametrize("name", APERTURES)
def test_images_and_slopes_are_near_to_certified_ones(name):
    pupil = APERTURES[name]
    grid = Grid((41, 38), 0.45 * pupil.scale)
    images = SampledPupil(pupil, grid, TERMS).images(EDGE, range(1, 6))
    at = pupil.carrying(Wavefront.zernike(dict(zip(TERMS, EDGE.T, strict=True)), normalization="edge"), None)
    true = lm.psf(at, grid.shape, grid.pixel, tol=1e-5, normalize="energy", integrate=False, derivatives=TERMS[1:6])
    peak = true.values.max()
    assert np.abs(images[0] - true.values).max() < 5e-4 * peak
    for slope, term in zip(images[1:], TERMS[1:6], strict=True):
        assert np.abs(slope - true.derivatives[term]).max() < 1e-3 * peak


def test_slopes_alone_are_the_same():
    sampled = SampledPupil(APERTURES["vanes"], Grid(21, 0.45), TERMS)
    whole, alone = sampled.images(EDGE, [3]), sampled.images(EDGE, [3], values=False)
    assert len(alone) == 1
    np.testing.assert_array_equal(whole[1], alone[0])
