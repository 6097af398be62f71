"""Blend of filters for one distance, of continuous scenes that are rendered without this package."""

from __future__ import annotations

from functools import lru_cache

import numpy as np
import pytest
import scipy

from lommel import Noise
from lommel.core import engine
from lommel.deconvolve.likelihood import PhotographLikelihood
from lommel.imaging import Blend, DepthBlur, RichardsonLucy, restore
from lommel.imaging.blended import TiledBlur, UniformBlur, _core, _frame, _taps, tiles_of
from lommel.imaging.blur_spectrum import FREQUENCIES, BlurSpectrum
from scenes import ThinLens, averaged, lommel_lens, plane, texture

SIDE, READ = 96, 3.0
LENS = ThinLens(35e-3, 2.8, 1.35, 540e-9, 4e-6)
DISTANCE = 1.41  # a blur of 4.5 pixels


@lru_cache
def photograph(kind: str, light: float = 2000.0, distance: float = DISTANCE) -> tuple[np.ndarray, np.ndarray]:
    """Return a photograph of a plane, white being three times its mean, and its scene averaged by the pixels."""
    scene = texture(kind, SIDE, 7)
    draw = np.random.default_rng(11)
    seen = plane(scene, [LENS], distance, light)[0]
    photo = (draw.poisson(seen) + draw.normal(0.0, READ, seen.shape)) / (3.0 * light)
    return photo, averaged(scene) / 3.0


def restored(photo: np.ndarray, light: float = 2000.0, depth=DISTANCE, **options):
    noise = Noise(white=3.0 * light, read=READ)
    return restore(photo, depth, lommel_lens(LENS), LENS.pixel, encoding="linear", noise=noise, **options)


def decibels(light: np.ndarray, truth: np.ndarray) -> float:
    return float(-10.0 * np.log10(np.mean(np.square(light - truth)[12:-12, 12:-12])))


@pytest.mark.parametrize(("kind", "gain"), [("leaves", 2.5), ("pink", 0.8), ("text", 0.8)])
def test_default_for_one_distance_is_better_than_richardson_lucy(kind, gain):
    photo, truth = photograph(kind)
    found, steps = (restored(photo, method=method) for method in (None, RichardsonLucy()))
    assert found.stopped == "one pass"
    assert found.reliable
    assert decibels(found.light, truth) > decibels(photo, truth) + gain
    assert decibels(found.light, truth) > decibels(steps.light, truth) - 0.05
    assert found.light.mean() == pytest.approx(photo.mean(), rel=2e-3)
    np.testing.assert_array_equal(restored(photo, depth=np.full(photo.shape, DISTANCE)).values, found.values)


def test_a_blend_that_rings_in_the_dark_is_doubtful_and_no_default():
    scene = texture("leaves", SIDE, 7)
    scene = np.where(scene > 1.2 * scene.mean(), scene, 0.01 * scene)
    seen, draw = plane(scene, [LENS], DISTANCE, 1e4)[0], np.random.default_rng(11)
    photo = (draw.poisson(seen) + draw.normal(0.0, READ, seen.shape)) / 3e4
    found, blended = (restored(photo, 1e4, method=method) for method in (None, Blend()))
    assert blended.discrepancy > 6.0
    assert blended.findings.get("misfit").severity == "doubt"
    assert found.discrepancy < 2.0
    assert found.reliable
    # Where it rings, Richardson-Lucy takes its place; elsewhere the blend stays.
    truth, other = averaged(scene) / 3.0, restored(photo, 1e4, method=RichardsonLucy())
    dark, bright = truth < 0.02, truth > 0.3
    errors = [np.sqrt(each.light) - np.sqrt(truth) for each in (found, blended, other)]
    assert np.std(errors[0][dark]) < 0.7 * np.std(errors[1][dark])
    assert np.std(errors[0][bright]) < 0.8 * np.std(errors[2][bright])


def test_depth_maps_have_no_blend():
    photo, _ = photograph("leaves")
    depth = np.full(photo.shape, DISTANCE)
    depth[:, 40:] = 1.38
    with pytest.raises(ValueError, match=r"Blend\(\) needs one distance .* varies by .* pixels; use RichardsonLucy"):
        restored(photo, depth=depth, method=Blend())
    blur = DepthBlur(depth, lommel_lens(LENS), LENS.pixel)
    with pytest.raises(ValueError, match=r"needs a lens and one distance .* DepthBlur"):
        Blend().solve(PhotographLikelihood(blur, photo, Noise(white=6000.0, read=READ)), print)
    with pytest.raises(ValueError, match=r"radius of .* pixels, more than half"):
        restored(photo, depth=0.4)


def test_saturated_and_unknown_pixels_are_filled():
    photo, truth = photograph("dots")
    full = float(np.quantile(photo, 0.95))
    clipped = np.minimum(photo, full)
    clipped[40:44, 30:34] = np.nan
    found = restored(clipped, saturation=full)
    assert found.unknown == pytest.approx(np.mean(~(clipped < full)))
    believed = restored(np.where(np.isnan(clipped), photo, clipped), saturation=np.inf)
    assert np.isfinite(found.light).all()
    assert decibels(found.light, truth) > decibels(believed.light, truth) + 0.2
    assert found.light.max() > 1.02 * full
    assert not found.findings.get("blur_doubtful")


def test_colours_share_their_edges_and_types():
    photo, truth = photograph("leaves")
    linear = np.clip(np.stack([photo, 0.8 * photo, 0.5 * photo], axis=2), 0.0, 1.0)
    encoded = np.rint(255.0 * np.where(linear < 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055))
    noise = Noise(white=6000.0, read=READ)
    lens = lommel_lens(LENS)
    found = restore(encoded.astype(np.uint8), DISTANCE, lens, LENS.pixel, encoding="srgb", noise=noise)
    assert found.values.dtype == np.uint8
    assert found.stopped == "one pass"
    assert decibels(found.light[..., 1] / 0.8, truth) > decibels(photo, truth) + 2.0


def test_risk_of_weak_blur_is_that_of_the_photograph():
    photo, truth = photograph("pink", 50.0, 1.352)
    found = restored(photo, 50.0, depth=1.352)
    assert 0.0 < found.photograph < 1.0
    assert decibels(found.light, truth) > decibels(photo, truth)


def test_uniform_blur_is_its_own_transpose_and_mirrors():
    blur = UniformBlur((24, 32), lambda f: np.exp(-np.square(9.0 * f))[None], 3.0)
    a, b = np.random.default_rng(0).random((2, 24, 32)).astype(np.float32)
    assert np.vdot(blur.forward(a), b) == pytest.approx(np.vdot(a, blur.adjoint(b)), rel=1e-5)
    # A Gaussian of this transfer function, applied to the mirrored image by convolution.
    rms = 9.0 * np.sqrt(2.0) / (2.0 * np.pi)
    expected = scipy.ndimage.gaussian_filter(a.astype(float), rms, mode="reflect", truncate=8.0)
    np.testing.assert_allclose(blur.forward(a), expected, atol=2e-4)


@pytest.mark.parametrize("periodic", [False, True])
def test_gradients_of_all_channels_are_shrunk_together(periodic):
    draw = np.random.default_rng(3)
    light, dual = draw.normal(size=(2, 7, 19)).astype(np.float32), draw.normal(size=(2, 2, 7, 19)).astype(np.float32)
    identity = np.eye(light[0].size).reshape(-1, 7, 19)
    steps = [np.roll(identity, -1, axis) - identity for axis in (1, 2)]
    if not periodic:
        for each in (steps, dual):  # as a dual of gradients alone has it
            each[0][:, -1], each[1][:, :, -1] = 0.0, 0.0
    matrix = np.concatenate([each.reshape(len(identity), -1) for each in steps], axis=1).T  # of the gradient
    gradient = (light.reshape(2, -1).astype(float) @ matrix.T).reshape(2, 2, 7, 19).swapaxes(0, 1)
    assert engine.gradient_sum(light, periodic) == pytest.approx(np.sqrt(np.square(gradient).sum((0, 1))).sum())
    moved = 0.6 * dual + gradient
    length = np.sqrt(np.square(moved).sum((0, 1)))
    kept = moved * (2.5 / np.maximum(length, 2.5))
    assert 0.2 < np.mean(length > 2.5) < 0.9
    result = engine.shrink_gradient(light, dual, 0.6, 2.5, periodic)
    expected = (moved - 2.0 * kept).swapaxes(0, 1).reshape(2, -1) @ matrix
    np.testing.assert_allclose(dual, kept, atol=1e-6)
    np.testing.assert_allclose(result.reshape(2, -1), expected, atol=1e-5)


@pytest.mark.parametrize(("rms", "shape"), [(1.2, (3, 9, 21)), (2.4, (2, 4, 5))])
def test_coefficients_are_shrunk_by_the_energy_around_them(rms, shape):
    values, seen, sharp = np.random.default_rng(5).normal(size=(3, *shape)).astype(np.float32)
    relative = np.random.default_rng(6).uniform(0.5, 1.5, shape[1:]).astype(np.float32)
    noise = np.linspace(0.6, 0.9, shape[0]).astype(np.float32)
    stated = noise[:, None, None] * relative

    def mean(planes):
        return scipy.ndimage.gaussian_filter(planes.astype(float), (0.0, rms, rms), mode="reflect", truncate=2.5)

    energy, shrunk = mean(np.square(values)), values.copy()
    engine.shrink_bands(shrunk, relative, noise, _taps(rms))
    np.testing.assert_allclose(shrunk, values * np.maximum(energy - stated, 0.0) / energy, atol=2e-6)
    assert 0.05 < np.mean(shrunk == 0.0) < 0.95
    expected = values * mean(seen * sharp) / (mean(np.square(seen)) + stated)
    engine.shrink_bands(values, relative, noise, _taps(rms), seen, sharp)
    np.testing.assert_allclose(values, expected, atol=2e-6)


def test_frame_is_tight_and_tiles_sum_to_one():
    bands, low = _frame((40, 56))
    squares = np.square(low, dtype=float)
    for band in bands:
        squares[band.part] += np.square(band.gain).sum(axis=0)
    np.testing.assert_allclose(squares, 1.0, atol=1e-6)
    total = np.zeros((1500, 700))
    for rows, columns, share, *_ in tiles_of(total.shape, 512, 128):
        total[rows, columns] += share
    np.testing.assert_allclose(total, 1.0, atol=1e-5)
    assert len(tiles_of((1500, 700), 512, 128)) == 2


def test_tiles_agree_with_the_whole(monkeypatch):
    photo, truth = photograph("pink")
    whole = restored(photo)
    monkeypatch.setattr("lommel.imaging.blended._TILE", 48)
    monkeypatch.setattr("lommel.imaging.blended._OVERLAP", 24)
    tiled = restored(photo)
    assert decibels(tiled.light, truth) == pytest.approx(decibels(whole.light, truth), abs=0.3)
    assert not np.array_equal(tiled.light, whole.light)
    # The middle of a large tile chooses weights, and the share of the photograph.
    monkeypatch.undo()
    monkeypatch.setattr("lommel.imaging.blended._CORE", 48)
    middle = restored(photo)
    assert decibels(middle.light, truth) == pytest.approx(decibels(whole.light, truth), abs=0.1)
    assert middle.photograph == pytest.approx(whole.photograph, abs=0.02)


def test_weights_of_a_large_tile_are_chosen_by_its_middle():
    assert _core(tiles_of((383, 900), 900, 128)[0]) is None
    tile = tiles_of((1500, 1100), 512, 128)[3]
    middle = _core(tile)
    assert np.subtract(middle.last, middle.first).tolist() == [192, 192]
    np.testing.assert_allclose(np.add(middle.first, middle.last), np.add(tile.first, tile.last), atol=1)
    assert [s.stop - s.start for s in (middle.rows, middle.columns)] == [160, 160]
    assert middle.rows.start == middle.first[0] + 16


def test_blurs_of_tiles_are_added_by_their_shares():
    shape, widths = (20, 48), (3.0, 0.0)
    tiles = tiles_of(shape, 24, 16)
    blurs = [
        UniformBlur(tile.share.shape, lambda f, w=w: np.exp(-np.square(w * f))[None], 1.0)
        for tile, w in zip(tiles, widths, strict=True)
    ]
    blur = TiledBlur(shape, [*zip(tiles, blurs, strict=True)])
    a, b = np.random.default_rng(0).random((2, *shape)).astype(np.float32)
    assert np.vdot(blur.forward(a), b) == pytest.approx(np.vdot(a, blur.adjoint(b)), rel=1e-5)
    np.testing.assert_allclose(blur.forward(a)[:, 33:], a[:, 33:], atol=1e-5)
    whole = UniformBlur(shape, lambda f: np.exp(-np.square(3.0 * f))[None], 1.0).forward(a)
    np.testing.assert_allclose(blur.forward(a)[:, :14], whole[:, :14], atol=2e-3)


@pytest.mark.parametrize("slope", [1.5, 2.5])
def test_texture_and_noise_follow_from_the_spectrum(slope):
    draw, side = np.random.default_rng(5), 192
    f = np.hypot(np.arange(side)[:, None], np.arange(side)) / (2.0 * side)
    transfer = np.exp(-np.square(4.0 * f))
    power = 3.0 * np.maximum(f, 0.5 / side) ** -slope * np.square(transfer)
    coefficients = draw.standard_normal(f.shape) * np.sqrt(power + 0.5)
    plane = scipy.fft.idctn(coefficients, norm="ortho")
    spectrum = BlurSpectrum.cosine(plane[None], np.ones(1))
    found = spectrum.texture(np.exp(-np.square(4.0 * FREQUENCIES)), 0)
    assert found.slope == pytest.approx(slope, abs=0.25)
    assert found.noise == pytest.approx(0.5, rel=0.13)  # the noise was stated as 1
