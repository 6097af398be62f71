"""From a photograph, its depth and its lens to the sharp scene."""

from __future__ import annotations

import numpy as np
import pytest

from lommel import FieldMap, Lens, Noise
from lommel.imaging import (
    Blend,
    DepthBlur,
    FieldBlur,
    Occlusion,
    RichardsonLucy,
    TotalVariation,
    depth_of_field,
    restore,
)
from lommel.imaging.restoration import full_light, recorded

LENS = Lens(focal_length=50e-3, f_number=2.8, focus_distance=2.0, wavelength=550e-9)
PIXEL = 8e-6
DEPTH = np.full((48, 64), 2.5)
DEPTH[:, 28:] = 2.1
NOISE = Noise(white=5000.0, read=3.0)


def _scene(*channels: int) -> np.ndarray:
    """Return light with edges."""
    levels = np.random.default_rng(0).uniform(0.05, 0.8, (6, 8, *channels))
    return levels.repeat(8, axis=0).repeat(8, axis=1)


def _photo(scene: np.ndarray, seed: int = 1, noise: Noise = NOISE) -> np.ndarray:
    """Return what a sensor records of it, linear, made of windows with more of their light."""
    light = depth_of_field(scene, DEPTH, LENS, PIXEL, encoding="linear", energy=0.995).values
    electrons = np.moveaxis(np.atleast_3d(5000.0 * np.maximum(light, 0.0)), 2, 0)
    return np.moveaxis(noise.record(electrons, seed), 0, 2).reshape(scene.shape)


def _error(light: np.ndarray, scene: np.ndarray) -> float:
    """Return the rms error away from the edges."""
    return float(np.sqrt(np.mean((light - scene)[6:-6, 6:-6] ** 2)))


@pytest.mark.parametrize(("method", "gain"), [(RichardsonLucy(), 0.85), (TotalVariation(), 0.6)])
@pytest.mark.parametrize("channels", [(), (3,)])
def test_a_photograph_comes_nearer_to_its_scene(method, gain, channels):
    scene = _scene(*channels)
    photo = _photo(scene)
    found = restore(photo, DEPTH, LENS, PIXEL, encoding="linear", noise=NOISE, method=method)
    assert found.stopped == "noise"
    assert found.reliable
    assert 0.8 < found.discrepancy < 1.05 < found.before
    assert _error(found.values, scene) < gain * _error(photo, scene)


def test_points_that_hide_others_must_be_known_to():
    scene = _scene()
    photo = _photo(scene)
    seen = restore(photo, DEPTH, LENS, PIXEL, encoding="linear", noise=NOISE)
    added = restore(photo, None, DepthBlur(DEPTH, LENS, PIXEL), encoding="linear", noise=NOISE)
    near = np.s_[6:-6, 22:34]  # the edge of what is near
    assert np.abs(seen.values - scene)[near].mean() < 0.8 * np.abs(added.values - scene)[near].mean()


def test_it_is_the_operator_of_photographs_with_the_noise_that_is_named():
    photo = _photo(_scene())
    options = {"energy": 0.95}
    found = restore(photo, DEPTH, LENS, PIXEL, encoding="linear", noise=NOISE, saturation=np.inf, **options)
    blur = Occlusion(DepthBlur(DEPTH, LENS, PIXEL, **options))
    same = restore(photo, None, blur, encoding="linear", noise=NOISE)
    np.testing.assert_array_equal(found.values, same.values)
    assert found.values.dtype == np.float64


def test_what_a_mask_hides_is_unknown_as_nan_is():
    photo, hidden = _photo(_scene()), np.zeros(DEPTH.shape, dtype=bool)
    hidden[20:23, 30:40] = True
    given = {"encoding": "linear", "noise": NOISE, "method": RichardsonLucy(steps=3)}
    masked = restore(np.ma.masked_array(photo, hidden), DEPTH, LENS, PIXEL, **given)
    unknown = restore(np.where(hidden, np.nan, photo), DEPTH, LENS, PIXEL, **given)
    np.testing.assert_array_equal(masked.values, unknown.values)
    assert masked.unknown == pytest.approx(hidden.mean())
    assert set(masked.to_dict()) >= {"status", "discrepancy", "findings"}
    assert "values" not in masked.to_dict()


@pytest.mark.parametrize("dtype", [np.uint8, np.uint16, np.float32])
def test_the_result_is_stored_as_the_photograph_is(dtype):
    scene = _scene(3)
    stored = depth_of_field(scene.astype(np.float32), DEPTH, LENS, PIXEL, encoding="linear").values
    srgb = 1.055 * np.maximum(stored, 0.0) ** (1 / 2.4) - 0.055
    photo = np.rint(srgb * np.iinfo(dtype).max).astype(dtype) if np.dtype(dtype).kind == "u" else srgb.astype(dtype)
    found = restore(
        photo, DEPTH, LENS, PIXEL, encoding="srgb", noise=NOISE, method=RichardsonLucy(steps=20, target=0.3)
    )
    assert found.values.dtype == dtype
    values = found.values / np.iinfo(dtype).max if np.dtype(dtype).kind == "u" else found.values
    light = np.where(values <= 0.04045, values / 12.92, ((values + 0.055) / 1.055) ** 2.4)
    np.testing.assert_allclose(
        light, np.clip(found.light, 0.0, 1.0 if np.dtype(dtype).kind == "u" else None), atol=5e-3
    )
    assert _error(found.light, scene) < 0.8 * _error(stored, scene)


def test_the_pedestal_of_a_sensor_is_taken_off():
    noise = Noise(white=5000.0, read=3.0, offset=0.1)
    scene = 0.8 * _scene()
    plain = restore(_photo(scene), DEPTH, LENS, PIXEL, encoding="linear", noise=NOISE)
    raised = restore(_photo(scene, noise=noise), DEPTH, LENS, PIXEL, encoding="linear", noise=noise)
    np.testing.assert_allclose(raised.values, plain.values, atol=1e-4)


@pytest.mark.parametrize("method", [RichardsonLucy(), TotalVariation()])
def test_what_is_saturated_was_at_least_so_bright(method):
    scene = _scene()
    scene[18:26, 8:20] = 6.0  # a lamp
    photo = np.minimum(_photo(scene), 1.0)
    photo[40:42, 40:50] = np.nan
    found = restore(photo, DEPTH, LENS, PIXEL, encoding="linear", noise=NOISE, method=method)
    assert found.unknown == pytest.approx(np.mean(~(photo < 1.0)))
    assert np.isfinite(found.values).all()
    assert found.stopped == "noise"
    # What surrounds the lamp says that it is brighter than white, and its middle, of which nothing is seen, is.
    assert found.light[18:26, 8:20].mean() > 1.5
    assert found.light[18:26, 8:20].min() > 0.9
    # Believing what the sensor could not hold never fits.
    believed = np.nan_to_num(photo, nan=0.3)
    trusted = restore(believed, DEPTH, LENS, PIXEL, encoding="linear", noise=NOISE, method=method, saturation=np.inf)
    assert trusted.discrepancy > 1.2 > 1.0 > found.discrepancy


@pytest.mark.parametrize("method", [RichardsonLucy(), TotalVariation()])
@pytest.mark.parametrize("dtype", [np.uint8, np.float32])
@pytest.mark.parametrize("read", [0.0, 3.0])
def test_darkness_stays_dark(method, dtype, read):
    found = restore(
        np.zeros((48, 64, 3), dtype),
        DEPTH,
        LENS,
        PIXEL,
        encoding="srgb",
        noise=Noise(white=5000.0, read=read),
        method=method,
    )
    assert not found.values.any()
    assert np.isfinite([found.discrepancy, found.before]).all()
    assert found.stopped == "noise"


@pytest.mark.filterwarnings("ignore:there is light of 40 times white")
@pytest.mark.parametrize("method", [RichardsonLucy(), TotalVariation()])
def test_one_bright_point_in_the_dark_is_gathered(method):
    scene = np.zeros((48, 64))
    scene[24, 14] = 40.0
    found = restore(_photo(scene), DEPTH, LENS, PIXEL, encoding="linear", noise=NOISE, method=method)
    assert np.isfinite(found.values).all()
    assert np.unravel_index(np.argmax(found.light), scene.shape) == (24, 14)
    assert found.light.max() > 2.0 * _photo(scene).max()


@pytest.mark.parametrize("method", [RichardsonLucy(), TotalVariation()])
def test_depth_that_is_wrong_is_told(method):
    noise = Noise(white=40000.0, read=3.0)
    scene = _scene()
    light = depth_of_field(scene, DEPTH, LENS, PIXEL, encoding="linear", energy=0.995).values
    photo = noise.record(40000.0 * light, seed=3)
    found = restore(photo, 1.05 * DEPTH, LENS, PIXEL, encoding="linear", noise=noise, method=method)
    assert found.stopped == "misfit: depth, lens or noise do not fit"
    assert found.findings.codes == ("misfit",)
    assert not found.converged
    assert found.discrepancy > 1.5


def test_light_is_known_below_white():
    photo = np.array([[0, 128, 255]], np.uint8)
    for given, limit in ((None, 1.0), (0.6, 0.6), (2.0, 1.0), (np.inf, 1.0)):
        assert full_light(photo, "linear", given) == limit
    np.testing.assert_allclose(recorded(photo, "linear", 1.0), [[0.0, 128 / 255, 1.0]])
    clipped = np.minimum(np.arange(9000).reshape(90, 100), 4095).astype(np.uint16)  # of 12 bits
    assert full_light(clipped, "linear", None) == 4095 / 65535
    floats = np.array([[0.2, 1.0, 3.0, np.nan]])
    assert full_light(floats.astype(np.float32), "linear", 0.95) == float(np.float32(0.95)) < 0.95
    for given, limit in ((None, 1.0), (2.0, 2.0), (np.inf, np.inf)):
        assert full_light(floats, "linear", given) == limit
        np.testing.assert_array_equal(recorded(floats, "linear", limit), floats)


class TestOverTheField:
    """Photographs by a lens whose PSF varies over its field, all at one distance."""

    FIELD = FieldMap.from_seidel(1e-3, W131=1.5, W020=0.5, wavelength=550e-9, f_number=4.0)

    def test_every_place_is_undone_by_its_own_psf(self) -> None:
        scene = _scene()
        photo = NOISE.record(5000.0 * FieldBlur(self.FIELD, scene.shape, 4e-6, energy=0.995).forward(scene), 2)
        blur = FieldBlur(self.FIELD, scene.shape, 4e-6)
        found = restore(photo, None, blur, encoding="linear", noise=NOISE, saturation=1.0)
        assert found.stopped == "one pass"
        assert _error(found.values, scene) < 0.9 * _error(photo, scene)

    def test_psfs_that_vary_within_tiles_are_no_misfit(self) -> None:
        field = FieldMap.from_seidel(2e-4, W220=6.0, wavelength=550e-9, f_number=4.0)
        scene = _scene()
        photo = NOISE.record(5000.0 * FieldBlur(field, scene.shape, 4e-6, energy=0.995).forward(scene), 2)
        blur = FieldBlur(field, scene.shape, 4e-6)
        found = restore(photo, None, blur, encoding="linear", noise=NOISE, saturation=1.0)
        assert found.stopped == "noise"
        blended = restore(photo, None, blur, encoding="linear", noise=NOISE, saturation=1.0, method=Blend())
        assert blended.stopped.startswith("misfit")

    def test_windows_of_colours_may_differ(self) -> None:
        scene = _scene(3)
        blur = FieldBlur(self.FIELD, scene.shape[:2], 4e-6, channels=[450e-9, 550e-9, 650e-9])
        photo = np.moveaxis(NOISE.record(5000.0 * np.moveaxis(blur.forward(scene), 2, 0), 2), 0, 2)
        found = restore(photo, None, blur, encoding="linear", noise=NOISE, saturation=1.0)
        assert len({bank.half for bank in blur.banks}) > 1
        assert found.stopped == "one pass"
        assert _error(found.values, scene) < 0.95 * _error(photo, scene)
