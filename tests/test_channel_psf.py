"""PSFs in channels are sums of monochromatic ones, whatever else is asked."""

from __future__ import annotations

import numpy as np
import pytest

import lommel as lm
from lommel import channel_psf
from lommel.io import registry
from lommel.methods import Polychromatic

WAVES = (450e-9, 550e-9, 650e-9)
COLOUR = lm.Colour(WAVES, [40e-6, 0.0, 30e-6], [4e-6, 0.0, -3e-6], 20e-3)
LENS = lm.Lens(focal_length=50e-3, f_number=2.8, focus_distance=2.0, wavelength=550e-9, colour=COLOUR)
CHANNELS = lm.Channels(WAVES, [[0.0, 1.0, 3.0], [1.0, 4.0, 1.0], [1.0, 0.0, 0.0]])
COMA = lm.Wavefront(2.0, nonradial={(3, 1): 2.0})
SCALE = {"wavelength": 550e-9, "f_number": 4.0}
PUPILS = {
    "lens": LENS.pupil([1.9, 2.1]),
    "coma": lm.Pupil(COMA, obscuration=0.3, **SCALE),
    "spider": lm.Pupil(lm.Wavefront(2.0), spider=lm.Spider.equal(3, 0.05), **SCALE),
    "cut": lm.Pupil(COMA, vignetting=lm.CatEye((0.3, 0.0)), apodization=1.2, **SCALE),
    "mask": lm.Pupil(lm.Wavefront(1.0), mask=lm.Mask(np.full((48, 48), 0.5)), **SCALE),
    "field": lm.FieldMap.from_seidel(20e-3, W222=0.3, aperture=LENS.pupil().unaberrated()).pupil([8e-3, 0.0], 5e-3),
    "aside": lm.FieldMap.from_seidel(20e-3, W220=0.3, aperture=LENS.pupil().unaberrated()).pupil([8e-3, 0.0], 0.0),
}


@pytest.mark.parametrize("name", PUPILS)
@pytest.mark.parametrize(
    "options", [{}, {"integrate": False}, {"normalize": "peak"}, {"normalize": "strehl"}, {"center": (3.3, 8.0)}]
)
def test_a_channel_is_the_sum_of_what_each_wavelength_makes(name, options):
    pupil = PUPILS[name]
    answer = lm.colour_psf(pupil, (13, 16), 1.5e-6, CHANNELS, **options)
    assert answer.values.shape == (*pupil.shape, 3, 13, 16)
    strehl = options | {"normalize": "strehl" if options.get("normalize") else "energy"}
    ones = [lm.psf(pupil.in_light(w), (13, 16), 1.5e-6, tol=1e-9, dtype=np.float64, **strehl).values for w in WAVES]
    for c, (found, (_, pairs)) in enumerate(zip(answer, CHANNELS, strict=True)):
        # As much light is brighter, over the peak without aberration, where its spot is smaller.
        rates = {w: share * (w**-2.0 if options.get("normalize") else 1.0) for w, share in pairs}
        total = sum(rates.values())
        expected = sum(rates.get(w, 0.0) / total * one for w, one in zip(WAVES, ones, strict=True))
        if options.get("normalize") == "peak":
            expected = expected / expected.max(axis=(-2, -1), keepdims=True)
        assert np.array_equal(found.values, answer.values[..., c, :, :])
        off = np.abs(found.values - expected).max(axis=(-2, -1)) / expected.max(axis=(-2, -1))
        assert off.max() <= (1e-6 if found.error_bound is None else found.error_bound) <= 1e-6


def test_a_channel_is_an_answer_like_any_other():
    answer = lm.colour_psf(LENS.pupil(1.95), 33, 3e-6, CHANNELS)
    plain = lm.psf(LENS.pupil(1.95), 33, 3e-6, method=Polychromatic(WAVES, (1.0, 4.0, 1.0)))
    green = answer["green"]
    assert green is answer[1]
    assert lm.peak_error(green, plain) < 1e-6
    assert green.encircled_energy(20e-6) == pytest.approx(plain.encircled_energy(20e-6), abs=1e-6)
    assert green.strehl == pytest.approx(plain.strehl, rel=1e-5)
    assert [psf.values.shape for psf in answer] == [(33, 33)] * 3


@pytest.mark.parametrize("normalize", ["energy", "strehl", "peak"])
def test_each_channel_has_its_own_scale(normalize):
    pupil = LENS.pupil([1.9, 1.95])
    answer = lm.colour_psf(pupil, 13, 3e-6, CHANNELS, normalize=normalize)
    for found, (_, pairs) in zip(answer, CHANNELS, strict=True):
        one = Polychromatic([w for w, _ in pairs], [share for _, share in pairs])
        plain = lm.psf(found.pupil, 13, 3e-6, method=one, normalize=normalize)
        assert found.scale == pytest.approx(plain.scale, rel=2e-6)


def test_light_that_lateral_colour_moves_has_no_profile():
    pupil, method = PUPILS["aside"], Polychromatic(WAVES, (1.0, 4.0, 1.0))
    assert pupil.radial
    assert method.along_radius(pupil) is None
    assert method.along_radius(PUPILS["lens"]) is method
    found = lm.psf(pupil, 65, 1e-6, method=method).encircled_energy(8e-6)
    ones = [lm.psf(pupil.in_light(w), 65, 1e-6).encircled_energy(8e-6) for w in WAVES]
    assert found == pytest.approx(np.dot([1.0, 4.0, 1.0], ones) / 6.0, abs=2e-3)


# All that keep a PSF, of which the picture is for eyes only.
SUFFIXES = [form.suffixes[0] for form in registry.formats("psf") if form.suffixes != (".png",)]


def test_wavelengths_are_an_axis():
    answer = lm.colour_psf(LENS.pupil(1.95), 21, 3e-6, WAVES)
    assert answer.names == ("450 nm", "550 nm", "650 nm")
    for wavelength, found in zip(WAVES, answer, strict=True):
        exact = lm.psf(LENS.in_light(wavelength).pupil(1.95), 21, 3e-6, method="hankel", dtype=np.float64)
        assert lm.peak_error(found, exact) <= found.error_bound <= 1e-6


def test_the_exact_sum_over_the_aperture_agrees_at_every_wavelength():
    lens = lm.Lens(
        focal_length=50e-3, f_number=2.8, focus_distance=2.0, wavelength=550e-9, colour=COLOUR, model="aplanatic"
    )
    answer = lm.colour_psf(lens.pupil(1.9), 9, 4e-6, CHANNELS, integrate=False, tol=1e-9)
    exact = [
        lm.psf(lens.in_light(w).pupil(1.9), 9, 4e-6, method="huygens-fresnel", integrate=False, dtype=np.float64)
        for w in WAVES
    ]
    for found, row in zip(answer, CHANNELS.weights, strict=True):
        expected = sum(share * one.values for share, one in zip(row, exact, strict=True))
        assert lm.peak_error(found, expected) < 1e-8


def test_blocks_of_a_stack_are_those_of_the_whole(monkeypatch):
    pupil = LENS.pupil(np.linspace(1.8, 2.2, 6).reshape(2, 3))
    whole = lm.colour_psf(pupil, 9, 3e-6, CHANNELS, center=(np.array([3.0, 4.0, 5.0]), 4.0))
    counts, errors, together, bounded = [], [], channel_psf.sum_spectra, channel_psf.with_model_error

    def counted(sums, pupil, *rest, **more):
        counts.append(pupil.shape)
        return together(sums, pupil, *rest, **more)

    def known(*given, **more):
        images = bounded(*given, **more)
        errors.append(images.error.max())
        return images

    monkeypatch.setattr(channel_psf, "sum_spectra", counted)
    monkeypatch.setattr(channel_psf, "with_model_error", known)
    monkeypatch.setattr(channel_psf, "_BLOCK_VALUES", 200)
    parts = lm.colour_psf(pupil, 9, 3e-6, CHANNELS, center=(np.array([3.0, 4.0, 5.0]), 4.0))
    assert np.abs(whole.values - parts.values).max() <= 1e-6 * whole.values.max()
    assert counts == [(2,)] * 3  # of 81 values each
    assert [psf.error_bound for _, psf in parts] == [max(errors[c::3]) for c in range(3)]
    assert parts["red"].scale == pytest.approx(whole["red"].scale, rel=1e-15)
    assert whole.part((1, slice(None))).values == pytest.approx(whole.values[1], abs=0.0)
    assert whole.part((1, 2))["blue"].values.shape == (9, 9)


def test_derivatives_are_those_of_each_channel():
    answer = lm.colour_psf(LENS.pupil(1.98), 9, 3e-6, CHANNELS, derivatives=("defocus",))
    plain = lm.psf(LENS.pupil(1.98), 9, 3e-6, method=Polychromatic(WAVES, (1.0, 4.0, 1.0)), derivatives=("defocus",))
    assert np.array_equal(answer["green"].derivatives["defocus"], plain.derivatives["defocus"])
    with pytest.raises(ValueError, match="saved channel by channel"):
        answer.save("out.npz")


@pytest.mark.parametrize("suffix", SUFFIXES)
@pytest.mark.parametrize("distance", [1.9, (1.9, 2.1)])
def test_files_give_back_what_was_saved(tmp_path, suffix, distance):
    answer = lm.colour_psf(LENS.pupil(distance), 9, 3e-6, CHANNELS)
    answer.save(tmp_path / f"p{suffix}")
    again = lm.ColourPSF.load(tmp_path / f"p{suffix}")
    assert np.array_equal(again.values, answer.values)
    assert again.channels == answer.channels
    for one, other in zip(again, answer, strict=True):
        assert (one.pupil, one.method, one.error_bound) == (other.pupil, other.method, other.error_bound)
    data = (tmp_path / f"p{suffix}").read_bytes()
    (tmp_path / f"p{suffix}").write_bytes(data[: len(data) // 2])
    with pytest.raises(ValueError, match="is not a PSF in channels written by lommel"):
        lm.ColourPSF.load(tmp_path / f"p{suffix}")
    lm.psf(LENS.pupil(distance), 9, 3e-6).save(tmp_path / f"plain{suffix}")
    with pytest.raises(ValueError, match=r"it has no channels; PSF.load reads it"):
        lm.ColourPSF.load(tmp_path / f"plain{suffix}")


def test_a_picture_has_the_channels_as_red_green_and_blue(tmp_path):
    image = pytest.importorskip("PIL.Image")
    answer = lm.colour_psf(LENS.pupil(1.95), (9, 11), 3e-6, CHANNELS)
    answer.save(tmp_path / "p.png")
    found = np.asarray(image.open(tmp_path / "p.png")).astype(float)
    times = found.shape[1] // 11
    expected = np.sqrt(np.moveaxis(answer.values, 0, -1) / answer.values.max())
    assert np.abs(found[::times, ::times] / 255.0 - expected).max() < 0.51 / 255.0
    with pytest.raises(ValueError, match=r"a \.png holds a single PSF"):
        lm.colour_psf(LENS.pupil([1.9, 2.0]), 9, 3e-6).save(tmp_path / "s.png")
    with pytest.raises(ValueError, match="a picture needs one or three channels, got 2"):
        lm.colour_psf(LENS.pupil(1.9), 9, 3e-6, WAVES[:2]).save(tmp_path / "two.png")
    with pytest.raises(ValueError, match=r"path must end in .npy, .npz, .fits, .* for a PSF in channels"):
        answer.save(tmp_path / "p.gif")


def test_pixels_of_two_sides_and_what_spreads_the_light_are_those_of_each_channel():
    lens = lm.Lens(focal_length=50e-3, f_number=4.0, focus_distance=2.0, wavelength=550e-9)
    channels = lm.Channels.rgb()
    how = {"fill": 0.8, "blur": lm.Jitter(2e-6), "tol": 1e-5}
    made = lm.colour_psf(lens.pupil(1.99), 9, (3e-6, 4e-6), channels, **how)
    for one, (name, pairs) in zip(made, channels, strict=True):
        assert name in channels.names
        light = Polychromatic([w for w, _ in pairs], [share for _, share in pairs])
        wanted = lm.psf(lens.pupil(1.99), 9, (3e-6, 4e-6), method=light, **how)
        np.testing.assert_allclose(one.values, wanted.values, rtol=0, atol=2e-5 * wanted.values.max())
