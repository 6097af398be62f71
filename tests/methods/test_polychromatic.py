"""Spectra are weighted sums, whatever else is asked."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from scipy.special import j0, j1

import lommel as lm
from lommel.methods import ChordalGauss, Hankel, NijboerZernike, Polychromatic
from lommel.paper import Geometric, HuygensFresnel

WAVES, WEIGHTS = (450e-9, 550e-9, 650e-9), (1.0, 2.0, 1.0)


def lens(wavelength: float = 550e-9) -> lm.Lens:
    aberrations = (550e-9 / wavelength) * lm.Wavefront.from_seidel(W040=0.5)
    return lm.Lens(focal_length=20e-3, f_number=4.0, wavelength=wavelength, aberrations=aberrations)


def test_without_weights_all_wavelengths_count_alike():
    assert Polychromatic(WAVES) == Polychromatic(WAVES, (2.0, 2.0, 2.0))
    assert Polychromatic(WAVES, tol=1e-4).weights == pytest.approx((1 / 3, 1 / 3, 1 / 3))
    with pytest.raises(ValueError, match="wavelengths must not be empty"):
        Polychromatic(())


@pytest.mark.parametrize(
    ("reference", "waves", "pixel"),
    [
        (700e-9, (400e-9, 550e-9, 700e-9), 6.3 * 400e-9),
        (850e-9, (450e-9, 850e-9), 6.1 * 450e-9),
        (1000e-9, (400e-9,), 5.0 * 400e-9),
        (2000e-9, (400e-9,), 5.0 * 400e-9),
    ],
)
@pytest.mark.parametrize("center", [None, (3.3, 5.1)])
@pytest.mark.parametrize("integrate", [True, False])
def test_the_bound_holds_however_far_the_spectrum_is_from_the_reference(reference, waves, pixel, center, integrate):
    pupil = lm.Pupil(lm.Wavefront(2.0), wavelength=reference, f_number=2.0)
    asked = {"integrate": integrate, "center": center, "dtype": "float64"}
    answer = lm.psf(pupil, 9, 2.0 * pixel, method=Polychromatic(waves, [1] * len(waves)), **asked)
    exact = np.zeros((9, 9))
    for wave in waves:
        part = lm.Pupil(reference / wave * lm.Wavefront(2.0), wavelength=wave, f_number=2.0)
        exact += lm.psf(part, 9, 2.0 * pixel, method=Hankel(1e-11), **asked).values / len(waves)
    assert np.abs(answer.values - exact).max() / exact.max() <= answer.error_bound <= 1e-6 + 2.0**-53


def test_the_energy_of_white_light_within_any_radius_is_that_of_its_parts():
    pupil = lm.Pupil(wavelength=550e-9, f_number=2.8)
    waves = [400e-9, 550e-9, 700e-9]
    answer = lm.psf(pupil, 33, 1e-6, method=Polychromatic(waves, [1, 1, 1]))
    for radius in (20e-6, 200e-6, 1e-3):
        v = np.pi * radius / (np.array(waves) * 2.8)
        exact = np.mean(1.0 - j0(v) ** 2 - j1(v) ** 2)
        assert answer.encircled_energy(radius, of="optics") == pytest.approx(exact, abs=1e-7)
    far = lm.psf(lm.Pupil(wavelength=1e-6, f_number=2.8), 257, 1e-6, method=Polychromatic([400e-9], [1]))
    alone = lm.psf(lm.Pupil(wavelength=400e-9, f_number=2.8), 257, 1e-6)
    assert far.energy == pytest.approx(alone.energy, abs=1e-7)
    assert far.fwhm() == pytest.approx(alone.fwhm(), rel=1e-7)
    assert far.energy_diameter(0.9) == pytest.approx(alone.energy_diameter(0.9), rel=1e-6)


def test_a_sum_dimmer_than_its_parts_together_is_still_within_the_tolerance():
    # A ring for each colour, far from each other and from the window.
    pupil = lm.Pupil(lm.Wavefront(40.0), wavelength=1e-6, f_number=2.0)
    method = Polychromatic([400e-9, 1e-6, 5e-6], [1, 1, 1], NijboerZernike(1e-7))
    answer = lm.psf(pupil, 33, 2e-6, method=method, dtype="float64", center=(300.0, 200.0), integrate=False)
    assert answer.error_bound <= 1e-7 + 2.0**-53


APERTURES = {
    "disc": {},
    "annulus": {"obscuration": 0.33},
    "vanes": {"spider": lm.Spider.equal(3, width=0.15), "obscuration": 0.2},
    "cat's eye": {"vignetting": lm.CatEye((0.4, 0.1))},
    "ellipse": {"vignetting": lm.Ellipse(0.9, 0.6)},
    "mask": {"mask": lm.Mask(np.hypot(*np.mgrid[-1:1:96j, -0.9:1:96j]) < 0.8)},
}
WAVEFRONTS = {
    "defocus": lm.Wavefront(2.0, 0.7),
    "coma": lm.Wavefront(0.8, nonradial={(3, 1): 2.0}),
    "stack": lm.Wavefront([0.0, 3.0, 5.0], nonradial={(3, 1): 0.7, (2, -2): 0.5}),
    # The small window sees none of it, and the chordal rule proves nothing.
    "tilt": lm.Wavefront(0.8, nonradial={(1, 1): 60.0, (3, 1): 2.0}),
}


@cache
def each_alone(wavefront: str, aperture: str, integrate: bool, center: tuple[float, float] | None) -> np.ndarray:
    """Return the intensity of white light, 1 at the peak of the reference without aberration, light by light."""
    total = 0.0
    for wave, weight in zip(WAVES, WEIGHTS, strict=True):
        scale = 550e-9 / wave
        one = lm.Pupil(scale * WAVEFRONTS[wavefront], **APERTURES[aperture], wavelength=wave, f_number=4.0)
        # Of a window that light misses, circles tell less.
        circles = one.circular and wavefront != "tilt"
        way = lm.methods.NijboerZernike(1e-9) if circles else lm.methods.NonuniformFFT(1e-10)
        made = lm.psf(one, (7, 9), 1.3e-6, method=way, dtype="float64", integrate=integrate, center=center)
        total = total + 0.25 * weight * scale**2 * made.values / made.scale[..., None, None]
    return total


@pytest.mark.parametrize("wavefront", WAVEFRONTS)
@pytest.mark.parametrize("aperture", APERTURES)
@pytest.mark.parametrize("integrate", [True, False])
def test_white_light_of_every_pupil_is_within_the_tolerance_whatever_else_is_asked(aperture, wavefront, integrate):
    pupil = lm.Pupil(WAVEFRONTS[wavefront], **APERTURES[aperture], wavelength=550e-9, f_number=4.0)
    # Of what peaks elsewhere, the same in the middle of the window.
    middle = each_alone("coma" if wavefront == "tilt" else wavefront, aperture, True, None)
    white = Polychromatic(WAVES, WEIGHTS)
    places = list(enumerate((None, (2.0, 5.0), (2.3, 6.6))))
    # Where all are dear, one of them, another for each aperture, wavefront and kind of pixel beside it.
    one = (list(APERTURES).index(aperture) + list(WAVEFRONTS).index(wavefront) + integrate) % 3
    for turn, center in places if pupil.circular else places[one : one + 1]:
        exact = each_alone(wavefront, aperture, integrate, center)
        highest = exact.max(axis=(-2, -1))
        every = ("energy", "strehl", "peak")
        # All where they are cheap.
        for normalize in every if pupil.circular else every[turn : turn + 1]:
            # Double precision holds no more of what is 1e4 times dimmer than the peak beside the window.
            finest = 1e-7 if pupil.circular else 1e-6
            tol, dtype = ((1e-4, "float32"), (1e-6, "float32"), (finest, "float64"))[turn]
            asked = {"normalize": normalize, "method": white, "tol": tol, "dtype": dtype}
            answer = lm.psf(pupil, (7, 9), 1.3e-6, integrate=integrate, center=center, **asked)
            known = answer.scale if normalize != "peak" else 1.0 / highest
            error = np.abs(answer.values / known[..., None, None] - exact).max(axis=(-2, -1))
            peak = highest if normalize == "peak" else np.maximum(highest, middle.max(axis=(-2, -1)))
            assert np.all(error <= (answer.error_bound + 2e-9) * peak), (center, normalize)
            assert answer.error_bound <= tol
            shares = [(w / 4.0) * (550e-9 / wave) ** 2 for w, wave in zip(WEIGHTS, WAVES, strict=True)]
            light = {
                "energy": (np.pi * 1.3e-6 / pupil.scale) ** 2 / (4.0 * np.pi * pupil.transmission),
                "strehl": 1.0 / (pupil.amplitude**2 * sum(shares)),
                "peak": 1.0 / highest,
            }[normalize]
            np.testing.assert_allclose(answer.scale, np.broadcast_to(light, pupil.shape), rtol=2 * tol)


def test_a_window_that_the_light_misses_goes_to_the_series_at_each_wavelength():
    def tilted(by: float) -> lm.Pupil:
        wavefront = lm.Wavefront(0.8, nonradial={(1, 1): by, (3, 1): 2.0})
        return lm.Pupil(wavefront, wavelength=550e-9, f_number=4.0)

    assert lm.psf(tilted(2000.0), 17, 1e-6, method=Polychromatic(WAVES, WEIGHTS), integrate=False).error_bound <= 1e-6
    chords = Polychromatic(WAVES, WEIGHTS, ChordalGauss())
    with pytest.raises(ValueError, match="chords, more than the limit"):
        lm.psf(tilted(2000.0), 17, 1e-6, method=chords, integrate=False)
    with pytest.raises(lm.ToleranceError, match="cannot be met by a sum over wavelengths, whose images"):
        lm.psf(tilted(300.0), 5, 2.3e-6, method=chords)


def test_wavelets_of_each_colour_of_a_lens_add_up_to_its_white_light():
    """Huygens' superposition takes the distances of the lens, and no phase; at f/16 the two are close."""
    lens = {"focal_length": 50e-3, "f_number": 16.0, "focus_distance": 2.0}
    exact = 0.0
    for wave, weight in zip(WAVES, WEIGHTS, strict=True):
        one = lm.psf(lm.Lens(**lens, wavelength=wave).pupil(1.7), 9, 8e-6, method="huygens-fresnel", integrate=False)
        exact = exact + 0.25 * weight * one.values
    pupil = lm.Lens(**lens, wavelength=550e-9).pupil(1.7)
    for method, tolerance in ((None, 2e-3), (HuygensFresnel(), 1e-6)):
        white = Polychromatic(WAVES, WEIGHTS, method)
        answer = lm.psf(pupil, 9, 8e-6, method=white, integrate=False, dtype="float64")
        assert lm.peak_error(answer, exact) < tolerance


def test_the_tolerance_is_that_of_the_sum_however_it_is_named():
    for white in (
        Polychromatic(WAVES, WEIGHTS, tol=1e-8),
        Polychromatic(WAVES, WEIGHTS, NijboerZernike(1e-8)),
        Polychromatic(WAVES, WEIGHTS, NijboerZernike(1e-3), tol=1e-8),
        Polychromatic(WAVES, WEIGHTS, NijboerZernike(1e-3)).with_tol(1e-8),
    ):
        assert white.tol == 1e-8
        assert white.method is None or white.method.tol == 1e-8
        answer = lm.psf(lens().pupil(3.0), 21, 2e-6, method=white)
        assert answer.values.dtype == np.float64
        assert answer.error_bound <= 1e-8
    with pytest.raises(ValueError, match="tol=1e-08 must be left out for Geometric"):
        Polychromatic(WAVES, WEIGHTS, Geometric(), tol=1e-8)
    with pytest.raises(ValueError, match=r"tol must be >= 1e-12 and < 0\.1, got 1e-20"):
        Polychromatic(WAVES, WEIGHTS, tol=1e-20)


def test_a_method_whose_tolerance_is_no_contract_is_summed_as_it_is():
    white = Polychromatic(WAVES, WEIGHTS, Hankel())
    answer = lm.psf(lens().pupil(3.0), 21, 2e-6, method=white)
    certified = lm.psf(lens().pupil(3.0), 21, 2e-6, method=Polychromatic(WAVES, WEIGHTS), tol=1e-10)
    assert lm.peak_error(answer, certified) <= 1e-10
    assert Hankel().tol < answer.error_bound < 1e-11


def test_measures_of_white_light_are_those_of_its_parts():
    radial = lm.Pupil(lm.Wavefront(1.5), wavelength=550e-9, f_number=4.0)
    vanes = lm.Pupil(lm.Wavefront(1.5), wavelength=550e-9, f_number=4.0, spider=lm.Spider.equal(4, 0.1))
    white = Polychromatic(WAVES, WEIGHTS)
    for pupil in (radial, vanes):
        answer = lm.psf(pupil, 61, 1e-6, method=white, dtype="float64")
        parts = [lm.psf(part.pupil, 61, 1e-6, dtype="float64") for part in white.components(pupil)]
        shares = white.weights

        def mean(measure, shares=shares, parts=parts):
            return sum(share * measure(part) for share, part in zip(shares, parts, strict=True))

        assert answer.energy == pytest.approx(mean(lambda p: p.energy), rel=1e-6)
        assert answer.encircled_energy(9e-6) == pytest.approx(mean(lambda p: p.encircled_energy(9e-6)), rel=1e-6)
        assert answer.ensquared_energy(9e-6) == pytest.approx(mean(lambda p: p.ensquared_energy(9e-6)), rel=1e-6)
        assert answer.mtf(1e5) == pytest.approx(abs(mean(lambda p: p.otf(1e5))), rel=1e-6)
        weights = [part.weight for part in white.components(pupil)]
        strehl = np.average([p.strehl for p in parts], weights=weights)
        assert answer.strehl == pytest.approx(strehl, rel=1e-5)
        np.testing.assert_allclose(
            answer.profile()[1], mean(lambda p: p.profile()[1]), atol=2e-6 * answer.values.max()
        )
    radii = np.linspace(0.0, 2e-5, 7)
    expected = sum(
        share * lm.psf(part.pupil, 9, 1e-6).profile(radii)[1]
        for share, part in zip(white.weights, white.components(radial), strict=True)
    )
    np.testing.assert_allclose(lm.psf(radial, 9, 1e-6, method=white).profile(radii)[1], expected, rtol=1e-4)
