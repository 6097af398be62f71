"""Fields from exposures in several wavelengths, which share the wavefront in metres."""

from __future__ import annotations

import numpy as np
import pytest

import lommel as lm
import simulated_fields as simulated

NOISE = lm.Noise(read=2.0)
BLUE, RED, NUMBER, PIXEL = 450e-9, 600e-9, 5.0, 1.5e-6
SENSOR = (4000, 4000)


def waves(u, v):
    """Return defocus, astigmatism and coma, radians rms in red."""
    return np.stack([0.6 + 0.5 * u, 0.4 * v, -0.3 + 0.2 * u - 0.3 * v, 0.3 + 0.2 * v], axis=-1)


def night(draw, defocus, count=8):
    """Return places, images of stars in red and blue through a mirror, and wavefronts in red."""
    scope = simulated.Telescope(4, side=64)
    places = np.rint(draw.uniform(50, 3950, (count, 2)))
    v, u = ((places + 0.5) / 2000.0 - 1.0).T
    true, images = waves(u, v), np.zeros((count, 2, 21, 21))
    for k, i in np.ndindex(count, 2):
        light, factor = ((RED, 1.0), (BLUE, RED / BLUE))[i]
        at = draw.uniform(-0.5, 0.5, 2)  # lateral colour, too
        seen = scope.image(true[k] * factor, at, PIXEL / (light * NUMBER), 21, 0.5, defocus[i] * factor)
        images[k, i] = draw.poisson(2e4 * seen + 20.0) + draw.normal(size=(21, 21)) * 2.0
    return places, images, true


def fitted(images, places, **options):
    chosen = {"degree": 1, "terms": 4, "sensor": SENSOR, "pixel": PIXEL, "noise": NOISE, "wavelengths": [RED, BLUE]}
    pupil = lm.Pupil(wavelength=RED, f_number=NUMBER)
    return lm.fit_field(images, places, **({"pupil": pupil} | chosen | options))


@pytest.mark.parametrize("defocus", [(2.5, -1.5), (1.0, 1.0)])
def test_two_wavelengths_tell_one_wavefront_in_metres(defocus):
    places, images, true = night(np.random.default_rng(2), defocus)
    fit = fitted(images, places, defocus=defocus)
    assert fit.converged, fit.message
    x, y = ((places[:, k] - 1999.5) * PIXEL for k in (1, 0))
    values, errors = fit.at(x, y)
    assert 0.5 < np.sqrt((((values - true) / errors) ** 2).mean()) < 1.6
    np.testing.assert_allclose([jitter.sigma / PIXEL for (jitter,) in fit.blurs], 0.5, atol=0.05)
    # One sign is open for both wavelengths where both are at one focus.
    assert (fit.twin is None) is (defocus[0] != defocus[1])
    alone = fitted(images[:, :1], places, defocus=defocus[:1], wavelengths=None)
    assert (errors < alone.at(x, y)[1]).all()


def test_another_wavelength_than_that_of_the_images_is_a_misfit():
    places, images, _ = night(np.random.default_rng(2), (2.5, -1.5))
    assert fitted(images, places, defocus=(2.5, -1.5), wavelengths=[RED, RED]).message.startswith("misfit: ")


def test_the_axial_colour_of_the_lens_is_known():
    colour = lm.Colour([BLUE, RED], focus_shift=[60e-6, 0.0])
    lens = lm.Lens(focal_length=20e-3, f_number=NUMBER, focus_distance=5.0, wavelength=RED, colour=colour)
    pupil = lens.pupil(5.0)
    draw, bent = np.random.default_rng(3), lm.Wavefront.zernike({5: 0.3}, order="noll")
    seen = pupil.carrying(bent + pupil.wavefront, pupil.geometry)
    images = np.stack([lm.psf(seen.in_light(light), 21, PIXEL).values for light in (RED, BLUE)])
    stars = draw.poisson(2e4 * np.repeat(images[None], 5, axis=0) + 20.0) + 2.0 * draw.normal(size=(5, 2, 21, 21))
    places = np.array([[100, 100], [100, 3900], [3900, 100], [3900, 3900], [2000, 2000]])
    fit = fitted(stars, places, pupil=pupil, degree=0, terms=2, blur=False)
    assert fit.converged, fit.message
    values, errors = fit.at(0.0, 0.0)
    assert (np.abs(values - [pupil.wavefront.edge_terms()[2, 0] / np.sqrt(3.0), 0.3]) < 4.0 * errors).all()
    assert fit.twin is None


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"wavelengths": [RED]}, "wavelengths must be one for each of 2 exposures"),
        ({"pupil": lm.Pupil(), "pixel": 0.5}, "wavelengths need a pupil with wavelength and f_number"),
        ({"wavelengths": [RED, 4.0]}, "wavelength"),
    ],
)
def test_bad_wavelengths_are_told(change, message):
    windows = np.random.default_rng(1).poisson(100.0, (5, 2, 9, 9)).astype(float)
    with pytest.raises((TypeError, ValueError), match=message):
        fitted(windows, np.arange(10.0).reshape(5, 2) * 100.0, **change)
