"""Depth from photographs of different focus or aperture, of continuous scenes with noise."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.ndimage import map_coordinates

import lommel as lm
from lommel.imaging import defocus_depth, focal_engine
from lommel.imaging.defocus_verdict import noise_finding
from lommel.imaging.pair_noise import residual_variance, without_rounding
from planes import CAMERA, LENS, NOISE, PAIR, PIXEL, pixels, shoot, texture
from scenes import averaged, hopkins


def errors(found, distance):
    """The errors of 1 / distance where depth is known, over their standard errors."""
    known = np.isfinite(found.errors)
    u = 1.0 / found.depth[known]
    return (u - 1.0 / distance) / (found.errors[known] * u**2)


def robust(z):
    return 1.4826 * np.median(np.abs(z - np.median(z)))


@pytest.fixture(scope="module")
def images():
    return shoot(texture(), 1.5, PAIR)


@pytest.fixture(scope="module")
def whole(images):
    return lm.imaging.depth_from_defocus(images, PAIR, PIXEL, **CAMERA)


@pytest.mark.quick
@pytest.mark.parametrize("distance", [1.4, 1.6])
def test_a_plane_is_found_as_well_as_can_be_with_the_deviation_told(distance):
    found = lm.imaging.depth_from_defocus(shoot(texture(seed=3), distance, PAIR, seed=30), PAIR, PIXEL, **CAMERA)
    assert np.isfinite(found.errors[10:-10, 10:-10]).mean() > 0.95
    z = errors(found, distance)
    assert abs(np.median(z)) < 0.6
    assert 0.75 < robust(z) < 1.25
    seen = averaged(texture(seed=3))
    contrast = float(seen.std() / seen.mean())  # of structures of two pixels and more
    bound = lm.depth_precision(PAIR, distance, PIXEL, noise=lm.Noise(white=5e3, read=NOISE.read), contrast=contrast)
    known = np.isfinite(found.errors)
    assert np.std(found.depth[known]) < 1.3 * bound
    assert np.median(found.errors[known]) == pytest.approx(bound, rel=0.3)


@pytest.mark.quick
def test_pixels_between_blocks_have_the_deviations_of_their_wider_windows(whole):
    block = np.exp(-0.5 * (np.arange(-3.0, 4.0) * 4.0) ** 2 / (4.0**2 - 4.0**2 / 12.0)) * (
        np.abs(np.arange(-3, 4)) < 3
    )
    squares = [(((1.0 - part) * block + part * np.roll(block, 1)) ** 2).sum() for part in (0.125, 0.375)]
    within, between = whole.errors[1::4, 1::4], whole.errors[::4, ::4]  # an eighth and three of a block from centres
    known = np.isfinite(within) & np.isfinite(between)
    assert np.median(between[known] / within[known]) == pytest.approx(squares[1] / squares[0], rel=0.01)


@pytest.fixture(scope="module")
def near_focus():
    """A plane at 2.4 m by 50 mm f/1.8 at 2.3 m and 3.6 m, and what depth of it is asked for."""
    from scenes import ThinLens, lommel_lens, plane, record
    from scenes import texture as points

    thin = [ThinLens(50e-3, 1.8, focus, 540e-9, 50.2e-6) for focus in (2.3, 3.6)]
    counts = record(plane(points("soft", 96, 7), thin, 2.4, 5000.0), seed=1)
    images = [(one.astype(float) - 100.0) / 1e4 for one in counts]
    more = {"encoding": "linear", "noise": lm.Noise(white=1e4, read=3.0), "between": (2.05, 5.0)}

    def found(lenses=(), **changed):
        return lm.imaging.depth_from_defocus(images, lenses or given, 50.2e-6, **more, **changed)

    given = [lommel_lens(one) for one in thin]
    return found, given


def test_errors_stated_of_lenses_are_what_lenses_that_are_wrong_do(near_focus):
    found, given = near_focus
    plain = found()

    def added(**errors):
        more = found(**errors)
        known = np.isfinite(plain.errors) & np.isfinite(more.errors)
        assert np.array_equal(more.depth[known], plain.depth[known])
        by = np.sqrt(more.errors[known] ** 2 - plain.errors[known] ** 2) / plain.depth[known] ** 2
        return float(np.median(by))

    def moved(lenses):
        return float(np.nanmedian(1.0 / found(lenses).depth - 1.0 / plain.depth))

    wider = [one.stopped(1.8 * 1.02) for one in given]
    assert added(f_number_error=0.02) == pytest.approx(abs(moved(wider)), rel=0.1)
    apart = [[one.focused(1.0 / (1.0 / one.focus_distance + 0.003 * (k == n))) for n, one in enumerate(given)]
             for k in range(2)]  # fmt: skip
    assert added(focus_error=0.003) == pytest.approx(np.hypot(*map(moved, apart)), rel=0.1)


def test_a_focus_scale_that_is_off_is_within_the_error_of_a_lens_that_was_not_measured(images, monkeypatch):
    monkeypatch.setattr("lommel.imaging.defocus_verdict._scale_minima", lambda *_: [])
    shown = [one.focused(1.02 * one.focus_distance) for one in PAIR]
    found = lm.imaging.depth_from_defocus(images, shown, PIXEL, **CAMERA)
    off = abs(float(np.nanmedian(found.depth)) - 1.5)
    assert off > 3.0 * float(np.median(found.errors[np.isfinite(found.errors)]))
    (near, error), (far, larger) = found.verdict.lens_error.values()
    assert 1.45 < near < far < 1.55
    assert error / 3.0 < off < 2.0 * error < 2.0 * larger
    assert f"{far:.3g} m, which all points at one distance share" in found.verdict.message
    assert "a lens that was not measured (f-number within 3 %, foci within 2 %) adds" in found.verdict.message
    assert repr(found).endswith("mm of noise>")
    stated = lm.imaging.depth_from_defocus(images, shown, PIXEL, focus_error=0.01, **CAMERA)
    assert repr(stated).endswith("mm of noise and lens>")
    assert "standard errors are of noise and of the lens as stated, " in stated.verdict.message


def breathing(scale, distance=1.5, side=144):
    """Two photographs of a plane, the second magnified and blurred on a sensor whose pixels have one size."""
    scene = texture(side)
    places = 0.5 * (len(scene) - 1) + (np.arange(len(scene)) - 0.5 * (len(scene) - 1)) / scale
    smaller = map_coordinates(scene, np.meshgrid(places, places, indexing="ij"), order=3, mode="grid-wrap")
    return [
        shoot(one, distance, [lens], seed)[0]
        for seed, (one, lens) in enumerate(zip((scene, smaller), PAIR, strict=True))
    ]


def test_the_blur_of_resampled_photographs_is_tested_although_their_border_is_unknown():
    pair = breathing(PAIR[1].sensor_distance / PAIR[0].sensor_distance)
    verdict = lm.imaging.depth_from_defocus(pair, PAIR, PIXEL, magnification="lens", **CAMERA).verdict
    assert verdict.agrees
    assert abs(verdict.scale - 1.0) < 2.0 * verdict.scale_error < 0.3


def test_a_magnification_that_explains_the_misfit_is_named_though_wide_blur_hides_it_in_the_phases(monkeypatch):
    monkeypatch.setattr("lommel.imaging.defocus_verdict._scale_minima", lambda *_: [])
    scale = PAIR[1].sensor_distance / PAIR[0].sensor_distance
    pair, wide = breathing(scale, side=240), CAMERA | {"between": (1.1, 2.4)}
    verdict = lm.imaging.depth_from_defocus(pair, PAIR, PIXEL, **wide).verdict
    found = verdict.findings.get("misfit")
    (_, named), (_, error) = found.numbers["magnifications"], found.numbers["errors"]
    assert abs(named - scale) < 3.0 * error < 0.003
    assert found.numbers["undone"] < 1.2 < verdict.misfit
    assert f"magnified {named:.4f} +- {error:.4f} times the first" in found.text
    assert "which explains the misfit (" in found.text
    # Where undoing it leaves the misfit, it is not the cause.
    monkeypatch.setattr("lommel.imaging.defocus_verdict._EXPLAINED", -1.0)
    assert "magnifi" not in lm.imaging.depth_from_defocus(pair, PAIR, PIXEL, **wide).verdict.message


def test_without_texture_there_is_no_depth():
    flat = np.full((144 * 8, 144 * 8), 0.5)
    found = lm.imaging.depth_from_defocus(shoot(flat, 1.5, PAIR), PAIR, PIXEL, **CAMERA)
    assert np.all(np.isinf(found.errors))
    assert np.all(np.isnan(found.depth))
    assert found.known == 0.0
    with pytest.raises(ValueError, match="no depth is known"):
        _ = found.sharp
    # And beside texture there is none where there is none.
    scene = texture()
    scene[pixels(np.s_[None:None], np.s_[56:None])] = 0.5
    found = lm.imaging.depth_from_defocus(shoot(scene, 1.5, PAIR), PAIR, PIXEL, **CAMERA)
    assert np.isfinite(found.errors[12:-12, 12:36]).mean() > 0.95
    assert np.isfinite(found.errors[:, 68:]).mean() < 0.02


def test_what_is_beyond_the_range_is_not_said_to_be_within(images):
    for between in ((1.6, 2.2), (1.0, 1.4)):
        found = lm.imaging.depth_from_defocus(images, PAIR, PIXEL, encoding="linear", noise=NOISE, between=between)
        assert found.known < 0.05


def test_dark_areas_beside_bright_texture_have_no_depth():
    fast = [lens.stopped(4.0) for lens in PAIR]
    scene = texture(side=176)
    scene[pixels(np.s_[None:None], np.s_[60:None])] = 0.1
    found = lm.imaging.depth_from_defocus(shoot(scene, 1.6, fast), fast, PIXEL, **CAMERA)
    assert np.isfinite(found.errors[:, 84:]).mean() < 0.03


def test_the_deviation_grows_with_the_misfit(images, whole):
    moved = lm.imaging.depth_from_defocus([images[0], np.roll(images[1], 1, axis=1)], PAIR, PIXEL, **CAMERA)
    inner = np.s_[12:-12, 12:-12]
    assert np.median(whole.misfit[inner]) == pytest.approx(1.0, abs=0.1)
    assert np.median(moved.misfit[inner]) > 3.0
    assert np.median(moved.errors[inner] / whole.errors[inner]) > 2.0


@pytest.mark.quick
def test_unknown_pixels_have_no_depth_and_spoil_none(images, whole):
    holed = [one.copy() for one in images]
    holed[0][30:50, 30:50] = np.nan
    full = np.ma.masked_array(holed[1], np.zeros(holed[1].shape, bool))
    full[10, 60] = np.ma.masked
    found = lm.imaging.depth_from_defocus([holed[0], full], PAIR, PIXEL, **CAMERA)
    assert np.all(np.isinf(found.errors[32:48, 32:48]))
    assert np.isnan(found.depth[40, 40])
    away = np.s_[68:-8, 8:-8]
    both = np.isfinite(found.errors[away]) & np.isfinite(whole.errors[away])
    assert both.mean() > 0.95
    assert (np.abs(found.depth - whole.depth)[away] / whole.errors[away])[both].max() < 0.5
    assert np.isfinite(found.sharp).all()
    assert np.abs(errors(found, 1.5)).max() < 8.0


def test_light_that_unknown_pixels_may_have_spread_is_left_out():
    fast = [lens.stopped(2.8) for lens in PAIR]
    scene = texture()
    scene[pixels(np.s_[56:60], np.s_[56:60])] = 6.0  # a lamp, which is clipped
    images = [np.ma.masked_greater_equal(one, 1.7) for one in shoot(scene, 1.6, fast)]
    found = lm.imaging.depth_from_defocus(images, fast, PIXEL, **CAMERA)
    # Without the pixels around the lamp the scenes are equally bright.
    assert found.exposures[1] == pytest.approx(1.0, abs=2e-3)
    z = errors(found, 1.6)
    assert 0.05 < found.known < 0.9
    assert robust(z) < 1.5


def test_three_photographs_of_three_foci_are_better_than_two(whole):
    lenses = [*PAIR, LENS.focused(1.55)]
    three = lm.imaging.depth_from_defocus(shoot(texture(), 1.5, lenses), lenses, PIXEL, **CAMERA)
    assert 0.7 < robust(errors(three, 1.5)) < 1.3
    assert np.median(three.errors) < np.median(whole.errors)


def test_two_apertures_tell_depth_and_exposures_are_measured():
    lenses = [LENS.stopped(5.6), LENS.stopped(16.0)]
    light = (1.0, (5.6 / 16.0) ** 2)
    noise = lm.Noise(white=5e4, read=3.0)
    images = shoot(texture(), 1.6, lenses, exposures=light, noise=noise)
    camera = CAMERA | {"noise": noise, "between": (1.4, 2.0)}  # nearer than the focus there is another answer
    found = lm.imaging.depth_from_defocus(images, lenses, PIXEL, **camera)
    assert found.exposures == pytest.approx(light, rel=5e-3)
    assert 0.6 < robust(errors(found, 1.6)) < 1.4
    assert np.nanmedian(found.errors) < 0.02


@pytest.mark.parametrize(("spherical", "ends", "sides"), [
    (0.0, (1.0, 2.0), "1.02 m and 2 m"), (0.0, (1.2, np.inf), "1.2 m and 1.54 m"), (0.0, (0.6, np.inf), "and inf m"),
    (0.005, (1.0, 2.0), "1.02 m and"), (0.0, (1.0, 1.35), ""), (0.0, (1.35, 2.0), ""), (1.0, (1.0, 2.0), ""),
])  # fmt: skip
def test_two_apertures_at_one_focus_need_a_range_on_one_side_unless_aberrations_differ(spherical, ends, sides):
    """At equal changes of 1 / distance on both sides of the focus, blur is equal without spherical aberration."""
    far, near = (hopkins(np.linspace(0.0, 0.9, 40), sign * 6.0, spherical) for sign in (-1.0, 1.0))
    assert np.abs(far - near).max() < 1e-2 or not sides
    lens = lm.Lens(focal_length=35e-3, f_number=5.6, focus_distance=1.35, wavelength=540e-9,
                   aberrations=lm.Wavefront.from_seidel(W040=spherical))  # fmt: skip
    lenses, images = [lens, lens.stopped(11.0)], [np.full((64, 64), 0.5)] * 2
    camera = {"noise": NOISE, "between": ends}
    makers = [
        lambda: lm.imaging.depth_from_defocus(images, lenses, PIXEL, encoding="linear", **camera),
        lambda: lm.imaging.LiveDepth(lenses, PIXEL, shape=(64, 64), light=5e3, **camera),
    ]
    for make in makers if sides else ():
        with pytest.raises(ValueError, match=rf"focus at 1\.35 m are in between=: .*{sides} .* state one side"):
            make()
    if not sides:
        assert focal_engine.checked_range(ends, lenses, PIXEL, 2001)[0] == ends


def test_colours_have_their_own_blur_and_one_depth(whole):
    scene = [texture(seed=k) for k in range(3)]
    waves = lm.imaging.RED_GREEN_BLUE
    images = [
        np.stack([shoot(one, 1.5, [lens], seed=10 * k + j, wavelength=wave)[0]
                  for k, (one, wave) in enumerate(zip(scene, waves, strict=True))], axis=2)
        for j, lens in enumerate(PAIR)
    ]  # fmt: skip
    found = lm.imaging.depth_from_defocus(images, PAIR, PIXEL, **CAMERA)
    assert 0.7 < robust(errors(found, 1.5)) < 1.3
    assert abs(np.median(errors(found, 1.5))) < 0.6
    known = np.isfinite(found.errors) & np.isfinite(whole.errors)
    assert np.median(found.errors[known]) == pytest.approx(np.median(whole.errors[known]) / np.sqrt(3.0), rel=0.25)
    assert found.sharp.shape == images[0].shape
    with pytest.raises(ValueError, match="drop the alpha"):
        lm.imaging.depth_from_defocus([np.dstack([one, one[..., :1]]) for one in images], PAIR, PIXEL, **CAMERA)


def test_the_sharp_image_is_nearer_to_the_scene_than_any_photograph(images, whole):
    truth = averaged(texture())[16:-16, 16:-16]
    inner = np.s_[8:-8, 8:-8]

    def off(image):
        return float((image - truth)[inner].std())

    assert off(whole.sharp) < 0.75 * min(off(image) for image in images)
    assert whole.sharp is whole.sharp
    assert whole.sharp.mean() == pytest.approx(np.mean(images), rel=1e-3)
    dim = lm.Noise(white=300.0, read=3.0)
    dark = shoot(texture(), 1.5, PAIR, noise=dim)
    noisy = lm.imaging.depth_from_defocus(dark, PAIR, PIXEL, **(CAMERA | {"noise": dim}))
    assert off(noisy.sharp) < min(off(image) for image in dark)


def test_integers_in_srgb_are_what_their_light_is():
    from lommel.base.encoding import from_light

    images = [np.clip(one, 0.0, 1.0) for one in shoot(texture(mean=0.3), 1.5, PAIR)]
    stored = [from_light(one, "srgb", np.uint16) for one in images]
    linear = lm.imaging.depth_from_defocus(images, PAIR, PIXEL, **CAMERA)
    found = lm.imaging.depth_from_defocus(stored, PAIR, PIXEL, **(CAMERA | {"encoding": "srgb"}))
    known = np.isfinite(linear.errors) & np.isfinite(found.errors)
    assert known[10:-10, 10:-10].mean() > 0.9
    assert np.median(np.abs(found.depth - linear.depth)[known]) < 1e-4
    assert found.sharp.dtype == np.uint16


def test_bands_tell_what_the_whole_does_and_progress_is_told(images, whole, monkeypatch, tmp_path):
    monkeypatch.setattr(defocus_depth, "_ROWS", 48)
    seen = []
    found = lm.imaging.depth_from_defocus(
        images, PAIR, PIXEL, progress=lambda done, bands: seen.append((done, bands)), **CAMERA
    )
    assert seen == [(1, 3), (2, 3), (3, 3)]
    np.testing.assert_allclose(found.depth, whole.depth, rtol=1e-4)
    np.testing.assert_allclose(found.sharp, whole.sharp, rtol=1e-3)
    found.save(tmp_path / "depth.npy")
    assert np.array_equal(
        lm.imaging.read_depth(tmp_path / "depth.npy"), found.depth.astype(np.float32), equal_nan=True
    )


def test_another_transfer_function_is_taken(images, whole):
    from lommel.estimation.focal_model import transfer_curve

    calls = []

    def same(lens, vergence, spectrum, pixel):
        calls.append(len(vergence))
        return transfer_curve(lens, vergence, spectrum, pixel)

    found = lm.imaging.depth_from_defocus(images, PAIR, PIXEL, transfer=same, **CAMERA)
    assert calls
    assert np.array_equal(found.depth, whole.depth, equal_nan=True)


def test_lenses_must_be_round_and_differ():
    images = [np.ones((40, 40))] * 2
    with pytest.raises(ValueError, match="lenses must differ in focus or aperture"):
        lm.imaging.depth_from_defocus(images, [PAIR[0], PAIR[0]], PIXEL, **CAMERA)
    comatic = lm.Lens(
        focal_length=35e-3, f_number=8.0, wavelength=540e-9, aberrations=lm.Wavefront(nonradial={(3, 1): 1.0})
    )
    with pytest.raises(ValueError, match=r"lenses\[1\] must .* symmetric .* got coma x: leave"):
        lm.imaging.depth_from_defocus(images, [LENS, comatic], PIXEL, **CAMERA)
    spiders = lm.Lens(focal_length=35e-3, f_number=8.0, wavelength=540e-9, spider=lm.Spider(0.02, angles=(0.0, 1.5)))
    with pytest.raises(ValueError, match=r"lenses\[0\] must have a round aperture"):
        lm.imaging.depth_from_defocus(images, [spiders, LENS], PIXEL, **CAMERA)


def test_a_slope_is_found_with_a_deviation_that_knows_of_it():
    import scipy.fft

    from scenes import ThinLens, averaged
    from scenes import texture as points

    thin = [ThinLens(35e-3, 2.8, focus, 540e-9, 4e-6) for focus in (1.35, 1.8)]
    scene, side = points("leaves", 128, 3), 128 * 8
    across = (np.arange(side) + 0.5) / side
    u = 1.0 / 1.4 + (1.0 / 1.7 - 1.0 / 1.4) * np.where(across < 0.5, 2.0 * across, 2.0 - 2.0 * across)
    steps = np.linspace(u.min(), u.max(), 32)
    place = (u - steps[0]) / (steps[1] - steps[0])
    light = [np.zeros((side, side // 2 + 1), dtype=complex) for _ in thin]
    for c, v in enumerate(steps):
        spectrum = scipy.fft.rfft2(scene * np.maximum(1.0 - np.abs(place - c), 0.0))
        for k, lens in enumerate(thin):
            light[k] += spectrum * lens.transfer(float(1.0 / v), side)
    images = [
        NOISE.record(5e3 * averaged(scipy.fft.irfft2(one, s=(side, side))), seed=k) for k, one in enumerate(light)
    ]
    fast = [lens.stopped(2.8) for lens in PAIR]
    found = lm.imaging.depth_from_defocus(images, fast, PIXEL, **CAMERA)
    truth = np.broadcast_to(1.0 / u.reshape(-1, 8).mean(axis=1), images[0].shape)
    ridge = np.abs(np.arange(128) - 63.5) > 8
    known = np.isfinite(found.errors) & ridge
    error = (found.depth - truth)[known]
    assert known[24:-24, 24:-24].mean() > 0.75
    assert 0.5 < 1.4826 * np.median(np.abs(error / found.errors[known])) < 1.4
    assert abs(np.median(error / found.errors[known])) < 0.5


def electrons(found, light):
    """Electrons whose photon noise is the noise that was estimated, photon and read noise, at a light below 1."""
    noise = found.verdict.findings.get("estimated_noise").numbers
    mean = light * noise["white"]
    return mean**2 / (mean + noise["read"] ** 2)


@pytest.mark.parametrize(("white", "read"), [(2e4, 12.0), (1500.0, 3.0)])
def test_the_noise_of_8_bit_photographs_is_estimated_and_errors_are_those_made(white, read):
    light = np.clip(shoot(texture(contrast=0.5, mean=0.35), 1.55, PAIR, noise=lm.Noise(white=white, read=read)), 0, 1)
    srgb = np.where(light <= 0.0031308, 12.92 * light, 1.055 * light ** (1 / 2.4) - 0.055)
    photos = np.round(255 * srgb).astype(np.uint8)
    found = lm.imaging.depth_from_defocus(photos, PAIR, PIXEL, encoding="srgb", between=(1.2, 2.0))
    z = errors(found, 1.55)
    assert found.known > 0.75
    assert abs(np.median(z)) < 0.6
    assert 0.7 < robust(z) < 1.3
    variance = np.mean(light / white + (read / white) ** 2)
    assert electrons(found, light.mean()) == pytest.approx(light.mean() ** 2 / variance, rel=0.15)
    numbers = found.verdict.findings.get("estimated_noise").numbers
    assert numbers["light"] == pytest.approx(light.mean(), rel=0.02)
    assert numbers["rms"] == pytest.approx(np.sqrt(variance), rel=0.075)
    text = f"{numbers['rms']:.2g} of white rms at the mean light, {numbers['light']:.2g}"
    assert text in found.verdict.findings.get("estimated_noise").text
    codes = {finding.code for finding in found.verdict.findings}
    assert (
        {"estimated_noise", "untested"}
        <= codes
        <= {"estimated_noise", "untested", "lens_scale", "stated", "undetermined"}
    )
    assert "registration and noise (" in " ".join(found.verdict.findings.get("untested").numbers["what"])
    assert "noise agree" not in found.verdict.summary
    assert ("rounding (" in found.verdict.findings.get("estimated_noise").text) == (white > 1e4)


@pytest.mark.parametrize("white", [2e4, 1e5, 1e6])
def test_rounding_is_taken_out_of_the_noise_of_8_bit_photographs_or_makes_it_a_bound(white):
    draw = np.random.default_rng(0)
    light = draw.uniform(0.05, 0.9, 100_000)
    noisy = light + np.sqrt(light / white) * draw.standard_normal(light.size)
    srgb = np.round(255 * (1.055 * noisy ** (1 / 2.4) - 0.055)) / 255
    variance = np.var(((srgb + 0.055) / 1.055) ** 2.4 - light)
    noise = lm.Noise(white=light.mean() / variance, read=0.0)
    estimated = without_rounding(noise, light, 256, "srgb")
    found, share, _ = estimated
    text = noise_finding(estimated).text
    if white < 1e6:
        assert found.white == pytest.approx(white, rel=0.05)
        assert share == pytest.approx(1 - noise.white / white, abs=0.02)
        assert "at least" not in text
    else:
        assert found.white == noise.white < white
        assert f"white at least {noise.white:.4g}" in text
    assert without_rounding(noise, light, 0, "srgb") == (noise, 0.0, light.mean())


def test_channels_of_different_noise_unknown_pixels_and_exposures_need_no_noise_stated():
    whites = [2000.0, 4000.0, 2500.0]  # white balance: a pixel of red has half the electrons of one of green
    channels = [
        shoot(texture(seed=5), 1.5, PAIR, 9 * c, (1.0, 0.7), lm.Noise(white=white, read=3.0))
        for c, white in enumerate(whites)
    ]
    photos = np.moveaxis(channels, 0, -1)
    photos[:, ::25, 40:] = np.nan
    found = lm.imaging.depth_from_defocus(photos, PAIR, PIXEL, encoding="linear", between=(1.2, 2.0))
    assert 0.7 < robust(errors(found, 1.5)) < 1.3
    assert found.exposures == pytest.approx((1.0, 0.7), rel=0.01)
    assert electrons(found, 0.5) == pytest.approx(0.5 * np.mean(whites), rel=0.15)
    assert np.nanmedian(found.sharp) == pytest.approx(0.5, rel=0.05)


def test_the_noise_is_that_of_all_blocks_where_few_have_a_depth():
    misfit, aliases = np.full(100, 9.0), np.full(100, np.nan)
    misfit[:4], aliases[:4] = 0.5, 0.0
    assert residual_variance(misfit, aliases) == 9.0
    misfit[:20], aliases[:20] = 0.5, 0.0
    assert residual_variance(misfit, aliases) == 0.5
