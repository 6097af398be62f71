"""Derivatives of apertures of any shape are central differences, within their bounds."""

from dataclasses import replace

import numpy as np
import pytest

import lommel as lm

FRONT = lm.Wavefront.zernike({(2, 0): 0.6, (2, 2): 0.4, (3, 1): 0.5, (4, 0): 0.3})
SEGMENTS = lm.Segments.hexagonal(rings=2, gap=0.01)
APERTURES = {
    "vanes": {"obscuration": 0.3, "spider": lm.Spider.equal(4, 0.03, 0.2)},
    "cat's eye": {"vignetting": lm.CatEye((0.5, 0.2)), "apodization": 1.2},
    "pentagon": {"stop": lm.Polygon.regular(5, 1.0)},
    "segments": {"stop": SEGMENTS.phased(np.linspace(-1.0, 1.0, 18), 0.3)},
    "mask": {"mask": lm.Mask.sample(lambda x, y: 0.5 + 0.5 * x + 0.0 * y, side=200)},
}
NAMES = ("defocus", "spherical", (3, 1), (2, -2), "row", "column", "f_number", "wavelength")
PIXEL = 1.1e-6


def difference(of, h):
    """The derivative at 0, by two central differences."""
    wide, near = ((of(step) - of(-step)) / (2.0 * step) for step in (h, 0.5 * h))
    return (4.0 * near - wide) / 3.0


@pytest.mark.parametrize("integrate", [False, True])
@pytest.mark.parametrize("aperture", APERTURES)
def test_derivatives_are_differences_within_their_bounds(aperture, integrate):
    pupil = lm.Pupil(FRONT, wavelength=550e-9, f_number=4.0, **APERTURES[aperture])
    names = tuple(name for name in NAMES if aperture != "segments" or name != "wavelength")
    psf = lm.psf(pupil, 15, PIXEL, derivatives=names, integrate=integrate, dtype="float64")

    def values(pupil, center=(7.0, 7.0)):
        return lm.psf(pupil, 15, PIXEL, center=center, integrate=integrate, tol=1e-10).values

    def added(front):
        return values(replace(pupil, wavefront=FRONT + front))

    ways = {
        "defocus": lambda: difference(lambda h: added(lm.Wavefront(h)), 1e-2),
        "spherical": lambda: difference(lambda h: added(lm.Wavefront(0.0, h)), 1e-2),
        (3, 1): lambda: difference(lambda h: added(lm.Wavefront(nonradial={(3, 1): h})), 1e-2),
        (2, -2): lambda: difference(lambda h: added(lm.Wavefront(nonradial={(2, -2): h})), 1e-2),
        "row": lambda: difference(lambda h: values(pupil, (7.0 + h, 7.0)), 1e-2),
        "column": lambda: difference(lambda h: values(pupil, (7.0, 7.0 + h)), 1e-2),
        "f_number": lambda: difference(lambda h: values(replace(pupil, f_number=4.0 * (1.0 + h))), 1e-3) / 4.0,
        "wavelength": lambda: difference(lambda h: values(pupil.in_light(550e-9 * (1.0 + h))), 1e-3) / 550e-9,
    }
    for name in names:
        expected, peak = ways[name](), psf.values.max()
        off = np.abs(psf.derivatives[name] - expected).max() / peak
        bound = float(psf.derivative_bounds[name])
        size = np.abs(expected).max() / peak
        assert off <= bound + 1e-8 * size, name
        assert bound < 2e-5 * max(1.0, size), name


def test_a_polychromatic_image_has_them():
    light = lm.methods.Polychromatic([500e-9, 600e-9], [1.0, 2.0])
    pupil = lm.Pupil(FRONT, wavelength=550e-9, f_number=4.0, **APERTURES["vanes"])
    psf = lm.psf(pupil, 11, PIXEL, derivatives=((3, 1), "column"), method=light, dtype="float64")

    def moved(h):
        front = FRONT + lm.Wavefront(nonradial={(3, 1): h})
        return lm.psf(replace(pupil, wavefront=front), 11, PIXEL, method=light, tol=1e-9).values

    off = np.abs(psf.derivatives[3, 1] - difference(moved, 1e-2)).max() / psf.values.max()
    assert off <= float(psf.derivative_bounds[3, 1]) < 1e-4


def test_the_pullback_is_the_sum_over_derivatives():
    pupil = lm.Pupil(FRONT, **APERTURES["vanes"])
    names = ((3, 1), (2, 0), "row")
    psf = lm.psf(pupil, 11, 0.4, derivatives=names, dtype="float64")
    weights = np.random.default_rng(2).normal(size=psf.shape)
    found = psf.pullback(weights)
    for name in names:
        assert float(found[name]) == pytest.approx(float((weights * psf.derivatives[name]).sum()), rel=1e-9)
