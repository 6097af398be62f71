"""Restored photographs by tiles."""

from __future__ import annotations

from functools import partial

import numpy as np
import pytest

from lommel import Lens, Noise
from lommel.imaging import RichardsonLucy, TotalVariation, depth_of_field, restore

LENS = Lens(focal_length=50e-3, f_number=2.8, focus_distance=2.0, wavelength=550e-9)
PIXEL, NOISE = 12e-6, Noise(white=5000.0, read=3.0)
DEPTH = np.full((96, 112), 2.4)
DEPTH[30:70, 40:80] = 2.0
SCENE = np.random.default_rng(0).uniform(0.05, 0.8, (12, 14)).repeat(8, axis=0).repeat(8, axis=1)


LIGHT = depth_of_field(SCENE, DEPTH, LENS, PIXEL, encoding="linear", energy=0.995).values
PHOTO = NOISE.record(5000.0 * np.maximum(LIGHT, 0.0), seed=1).astype(np.float32)
GIVEN = {"encoding": "linear", "noise": NOISE}


@pytest.fixture
def by_tiles(monkeypatch):
    """Restore as a memory map is restored, in tiles of some side."""

    def restored(photo, depth, *arguments, side, **options):
        monkeypatch.setattr("lommel.imaging.restoration.TILE", side)
        return restore(photo, np.asarray(depth).view(np.memmap), *arguments, **options)

    return restored


@pytest.mark.parametrize(
    ("way", "name"), [(RichardsonLucy(), "steps"), (TotalVariation(), "strength")], ids=["likelihood", "variation"]
)
def test_tiles_are_those_of_the_whole_done_as_far(way, name, by_tiles):
    told: list[tuple[int, int]] = []
    found = by_tiles(PHOTO, DEPTH, LENS, PIXEL, method=way, side=48, progress=lambda *at: told.append(at), **GIVEN)
    assert told == [(k, 6) for k in range(1, 7)]
    fixed = (
        RichardsonLucy(steps=found.steps, target=0.0) if name == "steps" else TotalVariation(strength=found.strength)
    )
    whole = restore(PHOTO, DEPTH, LENS, PIXEL, method=fixed, **GIVEN)
    # A search passes other strengths, from which light of the same strength keeps a little.
    limit = 1e-3 if name == "steps" else 2e-3
    assert np.sqrt(np.mean((found.values - whole.values) ** 2)) < limit
    # No seams: the difference, small as it is, is not much larger where tiles meet.
    off = np.abs(found.values - whole.values)
    assert off[:, 46:50].mean() < 5.0 * off.mean()
    assert found.discrepancy == pytest.approx(whole.discrepancy, abs=0.1)
    assert found.stopped == "noise"
    assert found.light is None


@pytest.mark.parametrize("side", [None, 64])
def test_what_a_mask_hides_is_unknown_as_nan_is(side, by_tiles):
    restored = partial(by_tiles, side=side) if side else restore
    hidden = np.zeros(PHOTO.shape, dtype=bool)
    hidden[40:43, 60:70] = True
    given = GIVEN | {"method": RichardsonLucy(steps=3)}
    masked = restored(np.ma.masked_array(PHOTO, hidden), DEPTH, LENS, PIXEL, **given)
    unknown = restored(np.where(hidden, np.float32(np.nan), PHOTO), DEPTH, LENS, PIXEL, **given)
    np.testing.assert_array_equal(masked.values, unknown.values)
    assert masked.unknown == pytest.approx(hidden.mean())
    assert set(masked.to_dict()) >= {"status", "discrepancy", "findings"}
    assert "values" not in masked.to_dict()


def test_files_are_read_and_written_as_they_are(tmp_path, monkeypatch):
    monkeypatch.setattr("lommel.imaging.restoration.TILE", 64)
    srgb = np.clip(np.rint(255 * PHOTO[..., None].repeat(3, axis=2)), 0, 255).astype(np.uint8)
    stored = {name: tmp_path / f"{name}.npy" for name in ("photo", "depth", "out")}
    np.save(stored["photo"], srgb)
    np.save(stored["depth"], DEPTH)
    out = np.lib.format.open_memmap(stored["out"], "w+", srgb.dtype, srgb.shape)
    photo, depth = (np.load(stored[name], mmap_mode="r") for name in ("photo", "depth"))
    given = {"encoding": "srgb", "noise": NOISE}
    found = restore(photo, depth, LENS, PIXEL, out=out, **given)
    assert found.values is out
    whole = restore(srgb, np.array(depth), LENS, PIXEL, **given)
    assert np.abs(out.astype(int) - whole.values).mean() < 2.0


def test_each_pixel_keeps_its_own_noise(by_tiles):
    gains = np.random.default_rng(2).uniform(3000.0, 8000.0, DEPTH.shape)
    noise = Noise(white=gains, read=3.0)
    whole = restore(PHOTO, DEPTH, LENS, PIXEL, encoding="linear", noise=noise)
    found = by_tiles(PHOTO, DEPTH, LENS, PIXEL, encoding="linear", noise=noise, side=48)
    assert np.abs(found.values - whole.values).mean() < 0.02


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ({"out": PHOTO}, "share memory"),
        (
            {"depth": np.where(DEPTH == 2.0, np.nan, DEPTH)},
            "depth is NaN at some points; where the map is read, give missing=",
        ),
        (
            {"photo": np.where(np.arange(112) < 90, 1.0, PHOTO)},
            r"columns \d+ to \d+, photo must have pixels .*restored as a whole",
        ),
    ],
)
def test_bad_arguments_are_refused_by_name(changes, said, by_tiles):
    given = {"photo": PHOTO, "depth": DEPTH, "side": 16, **GIVEN} | changes
    with pytest.raises(ValueError, match=said):
        by_tiles(given.pop("photo"), given.pop("depth"), LENS, PIXEL, **given)


def test_the_whole_is_written_where_it_is_asked_for():
    given = GIVEN | {"method": RichardsonLucy(steps=2)}
    out = np.empty_like(PHOTO)
    found = restore(PHOTO, DEPTH, LENS, PIXEL, out=out, **given)
    assert found.values is out
    assert np.array_equal(out, restore(PHOTO, DEPTH, LENS, PIXEL, **given).values)
