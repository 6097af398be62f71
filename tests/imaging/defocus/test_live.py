"""Live depth of frames that continuous scenes make, rendered without this package."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy.ndimage import binary_dilation, map_coordinates

import lommel as lm
from lommel.imaging import defocus_verdict
from scenes import ThinLens, averaged, before, blurred, lommel_lens, plane, record, texture

SIDE, LIGHT = 128, 5000.0
NOISE = lm.Noise(read=3.0, offset=100.0)


def thin(f_number: float, foci: tuple[float, ...] = (1.35, 1.8)) -> list[ThinLens]:
    return [ThinLens(35e-3, f_number, focus, 540e-9, 4e-6) for focus in foci]


MILD, FAST = thin(8.0), thin(2.8)


def made(lenses: list[ThinLens], **options: object) -> lm.imaging.LiveDepth:
    given = {"between": (1.2, 2.0), "noise": NOISE, "shape": (SIDE, SIDE), "light": LIGHT} | options
    return lm.imaging.LiveDepth([lommel_lens(lens) for lens in lenses], 4e-6, **given)


@pytest.fixture(scope="module")
def mild() -> lm.imaging.LiveDepth:
    return made(MILD, refocus=True)


@pytest.fixture(scope="module")
def fast() -> lm.imaging.LiveDepth:
    return made(FAST, sharp=True)


def frames(lenses: list[ThinLens], distance: float, kind: str = "leaves", light: float = LIGHT) -> list[np.ndarray]:
    return record(plane(texture(kind, SIDE, seed=7), lenses, distance, light), seed=int(1000 * distance))


def errors(found: object, distance: float) -> np.ndarray:
    known = np.isfinite(found.errors)
    u = 1.0 / found.depth[known].astype(np.float64)
    return (u - 1.0 / distance) / (found.errors[known] * u**2)


def test_the_lens_is_that_of_the_formulas():
    for lens in (*MILD, *FAST):
        own = lommel_lens(lens)
        np.testing.assert_allclose(own.defocus([1.2, 2.0]), [lens.defocus(1.2), lens.defocus(2.0)], rtol=1e-9)
        assert own.working_f_number == pytest.approx(lens.working())


@pytest.mark.quick
@pytest.mark.parametrize("kind", ["pink", "leaves", "text"])
@pytest.mark.parametrize("distance", [1.25, 1.45, 1.8])
def test_planes_are_where_they_are_and_as_far_off_as_is_told(mild, kind, distance):
    found = mild(*frames(MILD, distance, kind))
    z = errors(found, distance)
    inner = np.isfinite(found.errors[4:-4, 4:-4])
    assert inner.mean() > 0.9
    assert abs(np.median(z)) < 0.6
    assert 0.75 < 1.4826 * np.median(np.abs(z - np.median(z))) < 1.2
    assert np.mean(np.abs(z) > 3.0) < 0.03
    assert np.median(found.misfit[4:-4, 4:-4]) == pytest.approx(1.0, abs=0.1)


# Squares of one pixel near either end tell little, so that noise makes the least of the energy too sharp.
@pytest.mark.parametrize(("distance", "kind"), [(1.35, "leaves"), (1.57, "leaves"), (1.25, "text"), (1.92, "text")])
def test_a_fast_lens_is_as_true(fast, distance, kind):
    found = fast(*frames(FAST, distance, kind))
    z = errors(found, distance)
    assert np.isfinite(found.errors[8:-8, 8:-8]).mean() > 0.78
    assert abs(np.median(z)) < 0.6
    assert 0.5 < 1.4826 * np.median(np.abs(z - np.median(z))) < 1.2
    assert np.mean(np.abs(z) > 3.0) < 0.03


def test_where_a_frame_is_nearly_sharp_on_large_pixels_there_is_no_bias():
    lenses = [ThinLens(50e-3, 1.8, focus, 540e-9, 50.2e-6) for focus in (2.3, 3.6)]
    live = lm.imaging.LiveDepth(
        [lommel_lens(lens) for lens in lenses],
        50.2e-6,
        between=(2.05, 5.0),
        noise=NOISE,
        shape=(SIDE, SIDE),
        light=LIGHT,
    )
    for distance in (2.4, 3.3):
        z = errors(live(*frames(lenses, distance, "soft")), distance)
        assert abs(np.median(z)) < 0.5


def test_errors_contain_the_bias_of_the_filters(mild):
    engine, pair = mild._levels[0].engine, frames(MILD, 1.45)
    tables, step, found = engine.channels[0], engine.channels[0].step, []
    gains = np.eye(1, 6, dtype=np.float32).repeat(2, axis=0)
    try:
        for bias in (0.0, 2.0):
            engine.channels[0] = replace(tables, bias=np.full_like(tables.bias, bias))
            stream = engine.stream((SIDE, SIDE))
            stream.take([one.astype(np.float32) for one in pair], gains, 100.0, 65535.0, None)
            depth, errors, _ = np.empty((3, SIDE // 4, SIDE // 4), np.float32)
            stream.depths(depth, errors, np.empty_like(errors))
            found.append((depth[8:-8, 8:-8], errors[8:-8, 8:-8]))
    finally:
        engine.channels[0] = tables
    (depth, alone), (same, both) = found
    known = np.isfinite(both)
    assert known.mean() > 0.9
    np.testing.assert_array_equal(depth[known], same[known])
    np.testing.assert_allclose(both[known], np.hypot(alone, 2.0 * step * depth**2)[known], rtol=0.02)


def test_beside_an_edge_of_depth_errors_are_as_told_or_it_is_not_known(mild):
    points = SIDE * 8
    mask = np.zeros((points, points))
    mask[points // 4 : 3 * points // 4, points // 4 : 3 * points // 4] = 1.0
    electrons = before(texture("leaves", SIDE, seed=11), mask, 1.4, texture("pink", SIDE, seed=12), 1.75, MILD, LIGHT)
    found = mild(*record(electrons, seed=4))
    inside = averaged(mask).reshape(32, 4, 32, 4).mean(axis=(1, 3)) > 0.5
    truth = np.where(inside, 1.4, 1.75)
    edge = np.zeros_like(inside)
    for axis in (0, 1):
        for away in (-2, -1, 1, 2):
            edge |= np.roll(inside, away, axis=axis) != inside
    known = np.isfinite(found.errors) & edge
    assert known.sum() > 0.5 * edge.sum()
    u = 1.0 / found.depth[known]
    z = (u - 1.0 / truth[known]) / (found.errors[known] * u**2)
    assert 1.4826 * np.median(np.abs(z)) < 1.5


def test_a_flat_strip_does_not_take_the_depth_of_an_object_beside_it(mild):
    points, side = SIDE * 8, np.arange(SIDE * 8) // 8 - SIDE // 2
    mask = np.broadcast_to(side >= 0, (points, points)).astype(float)
    front, back = texture("pink", SIDE, seed=11), texture("pink", SIDE, seed=12)

    def wrong(strip: int, columns: slice) -> float:
        """Fraction of blocks of a strip of the wall, left of an object at 1.4 m, with a wrong depth."""
        wall = np.where(side < -strip, back, 1.0)
        found = mild(*record(before(front, mask, 1.4, wall, 1.75, MILD, LIGHT), seed=4))
        assert np.isfinite(found.errors[4:-4, 16:-4]).mean() > 0.95
        depth, error = found.depth[4:-4, columns], found.errors[4:-4, columns]
        return float(np.mean(np.abs(depth - 1.75) > 3.0 * error))

    assert wrong(24, slice(12, 16)) < 0.05
    assert wrong(64, slice(12, 15)) < 0.15
    # Where both are at one distance, the depth of the strip is known.
    wall = np.where(side < -24, back, 1.0)
    found = mild(*record(plane(np.where(mask > 0.0, front, wall), MILD, 1.4, LIGHT), seed=4))
    assert np.mean(found.errors[4:-4, 14:16] < 0.05) > 0.9


@pytest.mark.parametrize(("top", "wall"), [(12, 1.0), (11, 0.4)])
def test_a_plain_wall_has_no_depth_two_blocks_beside_an_object(mild, top, wall):
    object_ = np.zeros((32, 32), bool)
    object_[top:20, 12:20] = True
    mask = np.kron(object_, np.ones((32, 32)))
    back = np.full(mask.shape, wall)
    found = mild(*record(before(texture("leaves", SIDE, seed=11), mask, 1.4, back, 1.75, MILD, LIGHT), seed=4))
    known = np.isfinite(found.errors)
    assert known[object_].mean() > 0.8
    rim = binary_dilation(object_, np.ones((3, 3)), iterations=2)
    assert known[~rim].mean() < 0.03
    assert known[:9].sum() == 0


def test_a_plain_wall_between_two_objects_has_no_depth_four_blocks_beside_their_light():
    lenses = [ThinLens(16e-3, 2.8, focus, 540e-9, 4e-6) for focus in (0.8, 1.2)]
    live = made(lenses, between=(0.65, 1.5))
    objects = np.ones((32, 32), bool)
    objects[:, 10:21] = False
    mask = np.kron(objects, np.ones((32, 32)))
    for kind in ("leaves", "text", "pink"):  # at 0.9 m, with a blur radius of 3.2 pixels
        front = texture(kind, SIDE, seed=11, contrast=0.3)
        found = live(*record(before(front, mask, 0.9, np.full(mask.shape, 0.4), 1.4, lenses, LIGHT), seed=4))
        known = np.isfinite(found.errors)[6:-6]
        assert known[:, 15].sum() == 0
        assert known[:, 6:9].mean() > 0.95


@pytest.mark.parametrize("lens", ["mild", "fast"])
def test_the_sharp_image_is_as_good_as_a_filter_that_knows_the_scene(request, lens):
    live, lenses = request.getfixturevalue(lens), MILD if lens == "mild" else FAST
    scene = texture("leaves", SIDE, seed=7)
    pair = frames(lenses, 1.5)
    live(*pair)
    sharp, truth = live.sharp(), LIGHT * averaged(scene)
    inner = np.s_[16:-16, 16:-16]

    def off(image: np.ndarray) -> float:
        return float(np.sqrt(((image - truth)[inner] ** 2).mean()))

    # Wiener's filter with the spectrum of the scene itself, on pixels, of both frames.
    f = np.hypot(np.fft.fftfreq(SIDE)[:, None], np.fft.rfftfreq(SIDE))
    pixel = np.sinc(np.fft.fftfreq(SIDE))[:, None] * np.sinc(np.fft.rfftfreq(SIDE))
    h = [
        np.sinc(0.0) * np.interp(f, np.fft.rfftfreq(SIDE * 8, 1 / 8), one.transfer(1.5, SIDE * 8)[0]) * pixel
        for one in lenses
    ]
    power = np.abs(np.fft.rfft2(truth - truth.mean())) ** 2 / SIDE**2 / LIGHT / np.maximum(pixel, 0.1) ** 2
    total = 1.0 + power * (h[0] ** 2 + h[1] ** 2)
    best = sum(np.fft.rfft2(y - 100.0) * (pixel * power * one / total) for y, one in zip(pair, h, strict=True))
    best[0, 0] = np.fft.rfft2(0.5 * (pair[0] + pair[1].astype(float)) - 100.0)[0, 0]
    assert off(sharp) < min(off(y - 100.0) for y in pair)
    assert 20.0 * np.log10(off(sharp) / off(np.fft.irfft2(best, s=(SIDE, SIDE)))) < 1.5
    assert sharp.mean() == pytest.approx(truth.mean(), rel=1e-3)
    if lens == "mild":
        seen = plane(scene, [ThinLens(35e-3, 8.0, 1.45, 540e-9, 4e-6)], 1.5, LIGHT)[0]
        assert np.abs(live.refocus(1.45) - seen)[inner].std() < 0.02 * LIGHT


def test_more_frames_colours_and_small_types_are_taken(mild):
    pair = frames(MILD, 1.5)
    before_ = mild(*pair)
    depth, least = before_.depth.copy(), before_.errors.copy()
    assert mild(*(one.astype(np.float32) for one in pair)).depth == pytest.approx(depth, nan_ok=True)
    three = made(thin(8.0, (1.35, 1.8, 1.55)))
    found = three(*frames(thin(8.0, (1.35, 1.8, 1.55)), 1.5))
    assert np.nanmedian(found.errors) < np.nanmedian(least)
    assert abs(np.median(errors(found, 1.5))) < 0.6
    colour = made(MILD, shape=(SIDE, SIDE, 3), light=3 * LIGHT, sharp=True)
    thirds = [
        [record([e / 1.0], seed=s + k, read=3.0)[0] for k in range(3)]
        for s, e in zip((1, 5), plane(texture("leaves", SIDE, seed=7), MILD, 1.5, LIGHT), strict=True)
    ]
    found = colour(*(np.stack(one, axis=2) for one in thirds))
    assert abs(np.median(errors(found, 1.5))) < 0.6
    assert np.nanmedian(found.errors) < np.nanmedian(least)
    assert colour.sharp().shape == (SIDE, SIDE, 3)
    bytes_ = [np.clip((one.astype(float) - 100.0) / 40.0, 0, 254).astype(np.uint8) for one in pair]
    eight = made(MILD, noise=lm.Noise(white=40.0, read=12.0))
    assert abs(np.median(errors(eight(*bytes_), 1.5))) < 0.8


def test_what_is_full_or_masked_is_left_out(mild):
    pair = frames(MILD, 1.5)
    whole = mild(*pair)
    depth, errors = whole.depth.copy(), whole.errors.copy()
    clipped = [one.copy() for one in pair]
    clipped[1][60:68, 40:48] = 65535
    found = mild(*clipped)
    assert np.isinf(found.errors[15:17, 10:12]).all()
    away = np.s_[:, 22:]
    np.testing.assert_allclose(found.depth[away], depth[away], equal_nan=True, rtol=1e-5)
    mask = np.ones((SIDE, SIDE), dtype=bool)
    mask[60:68, 40:48] = False
    masked = mild(*pair, known=mask)
    assert np.isinf(masked.errors[15:17, 10:12]).all()
    nan = [one.astype(np.float32) for one in pair]
    nan[0][60:68, 40:48] = np.nan
    assert np.array_equal(np.isinf(mild(*nan).errors), np.isinf(masked.errors))
    assert np.isfinite(errors[15:17, 10:12]).all()


def test_the_answer_does_not_depend_on_threads_offsets_or_calls(mild, monkeypatch):
    pair = frames(MILD, 1.6)
    one = mild(*pair)
    kept = one.depth.copy(), one.errors.copy(), one.misfit.copy()
    again = mild(*pair)
    for a, b in zip(kept, (again.depth, again.errors, again.misfit), strict=True):
        assert np.array_equal(a, b, equal_nan=True)
    monkeypatch.setattr("lommel.imaging.live.processors", lambda: 3)
    many = made(MILD)(*pair)
    for a, b in zip(kept, (many.depth, many.errors, many.misfit), strict=True):
        assert np.array_equal(a, b, equal_nan=True)
    assert again.depth is one.depth
    # Black levels that are stated wrong by ten electrons change next to nothing.
    off = made(MILD, noise=lm.Noise(read=3.0, offset=90.0))(*pair)
    assert np.nanmedian(np.abs(off.depth - kept[0]) / kept[1]) < 0.1


def test_breathing_of_a_thin_lens_is_undone():
    lenses = [ThinLens(25e-3, 4.0, focus, 540e-9, 4e-6) for focus in (0.8, 1.15)]
    scene = texture("leaves", SIDE, seed=7)
    own = [lommel_lens(lens) for lens in lenses]
    scale = own[1].sensor_distance / own[0].sensor_distance
    places = 0.5 * (len(scene) - 1) + (np.arange(len(scene)) - 0.5 * (len(scene) - 1)) / scale
    # The image is magnified, and blurred on its sensor, whose pixels have one size.
    smaller = map_coordinates(scene, np.meshgrid(places, places, indexing="ij"), order=3, mode="grid-wrap")
    seen = [blurred(one, lens, 0.85) for one, lens in zip((scene, smaller), lenses, strict=True)]
    pair = record([LIGHT * averaged(one) for one in seen], seed=5)
    live = made(lenses, between=(0.7, 1.3), magnification="lens", sharp=True)
    found = live(*pair)
    z = errors(found, 0.85)
    assert z.size > 300
    assert abs(np.median(z)) < 0.25
    assert 0.75 < 1.4826 * np.median(np.abs(z - np.median(z))) < 1.2
    assert np.nanmedian(found.misfit) == pytest.approx(1.0, abs=0.15)
    inner = np.s_[16:-16, 16:-16]
    assert np.std((live.sharp() - LIGHT * averaged(scene))[inner]) < np.std(
        (pair[0] - LIGHT * averaged(scene))[inner]
    )


def test_vignetting_that_differs_is_measured():
    place = (np.arange(SIDE) - 63.5) / 64.0
    darker = 1.0 - 0.1 * (place[:, None] ** 2 + place**2) + 0.02 * place
    seen = plane(texture("leaves", SIDE, seed=7), MILD, 1.57, LIGHT)
    pair = record([seen[0], darker * seen[1]], seed=5)
    spread = []
    for exposures in ("uniform", "smooth"):
        z = errors(made(MILD, exposures=exposures)(*pair), 1.57)
        spread.append(1.4826 * np.median(np.abs(z)))
    assert spread[0] > 1.4
    assert spread[1] < 1.1


def test_levels_of_light_are_chosen_by_the_frames():
    live = made(MILD, light=(500.0, 5000.0))
    for light in (400.0, 6000.0):
        found = live(*frames(MILD, 1.5, light=light))
        z = errors(found, 1.5)
        assert found.light == pytest.approx(light, rel=0.02)
        assert np.isfinite(found.errors[4:-4, 4:-4]).mean() > 0.85
        assert 0.75 < 1.4826 * np.median(np.abs(z)) < 1.3


def test_shifted_frames_and_wrong_noise_show_in_the_misfit(mild):
    pair = frames(MILD, 1.5)
    assert np.median(mild(pair[0], np.roll(pair[1], 1, axis=1)).misfit[4:-4, 4:-4]) > 3.0
    loud = made(MILD, noise=lm.Noise(read=60.0, offset=100.0))
    assert np.median(loud(*pair).misfit[4:-4, 4:-4]) < 0.8


def test_aliases_of_binned_pixels_explain_the_misfit_of_fine_texture_but_not_of_a_shift():
    thin = [ThinLens(16e-3, 2.8, focus, 540e-9, 4e-6) for focus in (0.8, 1.2)]
    near, far = record(plane(texture("fine", 112, 5, contrast=0.4), thin, 0.9, 5000.0), seed=3)
    lenses = [lommel_lens(lens) for lens in thin]
    given = {"between": (0.65, 1.5), "shape": near.shape, "light": 5000}
    live = lm.imaging.LiveDepth(lenses, 4e-6, noise=lm.Noise(read=3.0, offset=100.0), **given)
    with pytest.raises(ValueError, match="no frames yet"):
        live.aliases()
    assert live.binning == (2,)
    for second, unfit, left in ((far, 0.25, 0.02), (np.roll(far, 1, axis=1), 0.99, 0.95)):
        found = live(near, second)
        known, explained = np.isfinite(found.errors), 1.0 + live.aliases()
        assert (found.misfit[known] > 2.0).mean() > unfit
        share = (found.misfit[known] > 2.0 * explained[known]).mean()
        assert share < left if second is far else share > left
        if second is far:
            assert np.median(explained[known]) == pytest.approx(np.median(found.misfit[known]), rel=0.1)
    assert np.array_equal(np.isnan(live.aliases()), np.isnan(found.depth))
    guess = lm.imaging.LiveDepth(lenses, 4e-6, **given)
    guess(*(one - np.float32(100.0) for one in (near, far)))
    assert guess.noise.white == pytest.approx(1.0, rel=0.3)  # aliases are not noise: 0.55 with them


def test_the_noise_of_the_first_frames_is_that_of_the_camera_and_depth_is_as_far_off_as_is_told(monkeypatch):
    counts = frames(MILD, 1.5, light=2000.0)
    stored = [0.25 * (one.astype(np.float32) - 100.0) for one in counts]  # 4 electrons a count
    live = made(MILD, noise=None)
    assert repr(live).endswith("noise from the first frames>")
    with pytest.raises(ValueError, match=r"with one noise \(noise=\)"):
        live.save("lens.lml")
    with pytest.raises(ValueError, match="noise must be stated: it cannot be estimated from images of one value"):
        live(*stored, known=np.arange(SIDE)[:, None] % 4 + np.zeros(SIDE) > 0)
    with pytest.raises(ValueError, match="must hold light"):
        live(stored[0], stored[1] - np.float32(500.0))
    assert live.noise is None
    found = live(*stored)
    z = errors(found, 1.5)
    assert 0.75 < 1.4826 * np.median(np.abs(z - np.median(z))) < 1.25
    assert 500.0 * live.noise.white / (1.0 + live.noise.read**2 / (500.0 * live.noise.white)) == pytest.approx(
        2000.0, rel=0.1
    )
    monkeypatch.setattr(defocus_verdict, "_scale_minima", lambda *_: [])  # the size of blur, which takes seconds
    assert live.verdict().findings.get("estimated_noise").numbers == live.noise.to_dict()
    noise = live.noise
    live(*(0.5 * one for one in stored))
    assert live.noise is noise


@pytest.mark.parametrize("noise", [NOISE, None])
def test_two_apertures_of_one_focus_are_as_good_as_two_foci_on_one_of_its_sides(noise):
    apertures = [ThinLens(35e-3, f_number, 1.2, 540e-9, 4e-6) for f_number in (4.0, 8.0)]
    live = made(apertures, between=(1.25, 2.0), noise=noise)
    for distance in (1.3, 1.6):
        counts = frames(apertures, distance, "pink")
        found = live(*counts if noise else [one - np.float32(100.0) for one in counts])
        z = errors(found, distance)
        assert len(z) > 0.6 * found.depth.size  # the rest is within the blur of the border
        assert abs(np.median(z)) < 0.6
        assert 0.7 < 1.4826 * np.median(np.abs(z - np.median(z))) < 1.3
