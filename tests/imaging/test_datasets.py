"""Data sets: the same by any number of workers and after interruptions, with the ground truth of their making."""

from __future__ import annotations

import io
import json
import subprocess
import sys
import tarfile

import numpy as np
import pytest
from PIL import Image

import lommel as lm
from lommel.imaging import DepthBlur, LensRanges, Occlusion, datasets, render_dataset
from lommel.imaging.datasets import pair_files
from lommel.io import registry

LENSES = LensRanges(focal_length=(30e-3, 50e-3), f_number=(2.0, 8.0), focus_distance=(1.0, np.inf), pixel=30e-6)
SHAPE = (20, 26)


@pytest.fixture
def files(tmp_path):
    rng = np.random.default_rng(0)
    for name in ("photos", "depths"):
        (tmp_path / name).mkdir()
    for stem in ("a", "b"):
        lm.imaging.write_photo(tmp_path / "photos" / f"{stem}.png", rng.random((*SHAPE, 3)))
        depth = np.where(np.arange(SHAPE[1]) < 10, 1.0, 1.8) * np.ones(SHAPE)
        lm.imaging.write_depth(tmp_path / "depths" / f"{stem}.tif", depth)
    return tmp_path


def rendered(files, out="set", **given):
    given = {"seed": 3, "copies": 2, "psfs": 5} | given
    return list(render_dataset(files / "photos", files / "depths", files / out, LENSES, **given))


def contents(folder):
    return {path.name: path.read_bytes() for path in folder.iterdir()}


def _png(data):
    return registry.identify("photo", data).read(data)[0]


def assert_alike(one, other):
    """The same files; images may differ by rounding."""
    assert one.keys() == other.keys()
    for name, data in one.items():
        if name.endswith(".image.png"):
            first, second = (_png(each).astype(np.int64) for each in (data, other[name]))
            assert np.abs(first - second).max() <= 1
        elif not name.endswith(".npz"):
            assert data == other[name], name


def test_pictures_are_those_of_the_operator_with_the_lens_that_was_drawn(files):
    made = rendered(files, form="tif", energy=0.95, noise=lm.Noise(white=5000, read=3.0))
    clean = rendered(files, "clean", form="tif", energy=0.95)
    assert [(each.number, each.done, each.total) for each in made] == [(k, k + 1, 4) for k in range(4)]
    lenses = set()
    for each, other in zip(made, clean, strict=True):
        facts = json.loads((files / "set" / f"{each.number:06d}.json").read_text())
        distance = float(facts["focus_distance"]) if facts["focus_distance"] != "infinity" else np.inf
        lens = lm.Lens(
            focal_length=facts["focal_length"],
            f_number=facts["f_number"],
            focus_distance=distance,
            wavelength=540e-9,
        )
        lenses.add(lens.focal_length)
        depth = np.load(files / "set" / f"{each.number:06d}.depth.npy").astype(np.float64)
        sharp = lm.imaging.read_photo(other.files[1]).values
        blur = DepthBlur(depth, lens, facts["pixel"], channels=lm.imaging.RED_GREEN_BLUE, energy=0.95)
        seen = Occlusion(blur).forward(sharp)
        found = lm.imaging.read_photo(other.files[0]).values
        assert np.abs(found - seen).max() < 1e-5
        noisy = lm.imaging.read_photo(each.files[0]).values
        errors = np.sqrt(np.maximum(found, 0) * 5000 + 9.0) / 5000
        assert 0.8 < np.std((noisy - found) / errors) < 1.2
        # The PSF of a pixel by its index.
        index = np.asarray(Image.open(files / "set" / f"{each.number:06d}.index.png"))
        with np.load(files / "set" / f"{each.number:06d}.psfs.npz") as table:
            steps, psfs = table["defocus"], table["psfs"]
        assert np.abs(steps[index] - lens.defocus(depth)).max() <= (steps[1] - steps[0]) / 2 + 1e-5
        assert np.abs(psfs.sum(axis=(2, 3)) - 1.0).max() < 1e-5
        bank, half = blur.banks[1], psfs.shape[-1] // 2
        inside = slice(half - bank.half, half + bank.half + 1)
        assert np.abs(psfs[0, 1, inside, inside] - bank.window(steps[0])).max() < 1e-6
        exact = [bank.window(float(c)) for c in np.linspace(steps[0], steps[-1], 101)]
        nearest = [psfs[np.abs(steps - c).argmin(), 1, inside, inside] for c in np.linspace(steps[0], steps[-1], 101)]
        off = max(np.abs(a - b).max() / a.max() for a, b in zip(exact, nearest, strict=True))
        assert 0.2 * facts["psfs_error"] < off < 1.3 * facts["psfs_error"]
        assert [channel[0][0] for channel in facts["channels"]] == list(lm.imaging.RED_GREEN_BLUE)
    assert len(lenses) == 4


def test_workers_and_interruptions_change_nothing(files):
    rendered(files)
    wanted = contents(files / "set")
    some = render_dataset(files / "photos", files / "depths", files / "again", LENSES, seed=3, copies=2, psfs=5)
    next(some)
    some.close()
    (files / "again" / "000001.image.png").write_bytes(b"of a process that was killed")
    assert [each.number for each in rendered(files, "again", workers=2)] != [0]
    assert_alike(contents(files / "again"), wanted)
    assert rendered(files, "again") == []


def test_shards_hold_the_same_files(files):
    rendered(files)
    wanted = contents(files / "set")
    some = render_dataset(
        files / "photos", files / "depths", files / "tars", LENSES, seed=3, copies=2, psfs=5, shard=3
    )
    next(some), next(some)
    some.close()
    assert not list((files / "tars").glob("*.tar"))
    assert [each.number for each in rendered(files, "tars", shard=3)] == [2, 3]
    assert not list((files / "tars" / "parts").iterdir())
    found = {}
    for name in ("shard-000000.tar", "shard-000001.tar"):
        with tarfile.open(files / "tars" / name) as tar:
            found |= {member.name: tar.extractfile(member).read() for member in tar}
    assert_alike(found, {name: data for name, data in wanted.items() if name != "dataset.json"})
    assert np.load(io.BytesIO(found["000000.depth.npy"])).shape == SHAPE


def test_draws_are_uniform_in_what_they_say():
    rng = np.random.default_rng(0)
    drawn = [LENSES.draw(rng)[0] for _ in range(400)]
    for values in (
        [(lens.focal_length - 30e-3) / 20e-3 for lens in drawn],
        [np.log(lens.f_number / 2.0) / np.log(4.0) for lens in drawn],
        [1.0 / lens.focus_distance for lens in drawn],
    ):
        assert 0.0 <= min(values) < 0.02
        assert 0.98 < max(values) <= 1.0
        assert abs(np.mean(values) - 0.5) < 0.05


def test_what_does_not_fit_is_refused(files, tmp_path):
    with pytest.raises(ValueError, match=r"holds pictures of other arguments \(seed\); choose another folder"):
        rendered(files), rendered(files, seed=4)
    with pytest.raises(ValueError, match=r"must be a new or empty folder"):
        rendered(files, "photos")
    with pytest.raises(ValueError, match="noise must have a white"):
        rendered(files, "x", noise=lm.Noise(read=1.0))
    with pytest.raises(ValueError, match="psfs must be 0 with energy=1"):
        rendered(files, "x", energy=1.0)
    with pytest.raises(ValueError, match=r"^depth_scale must be >= 1e-12 and <= 1e\+12 metres per level, got 0"):
        rendered(files, "x", depth_scale=0.0)
    with pytest.raises(ValueError, match="give only one of `depth_scale`, `inverse_depth` and `disparity`"):
        rendered(files, "x", depth_scale=1.0, inverse_depth=(1.0, 2.0))
    with pytest.raises(ValueError, match="f_number must be a pair"):
        LensRanges(focal_length=50e-3, f_number=(4, 2), focus_distance=1.0, pixel=4e-6)
    with pytest.raises(ValueError, match="focus_distance must exceed the focal length"):
        LensRanges(focal_length=50e-3, f_number=4, focus_distance=0.04, pixel=4e-6)
    (files / "photos" / "c.png").write_bytes((files / "photos" / "a.png").read_bytes())
    with pytest.raises(ValueError, match=r"c\.png has no depth map of the same name$"):
        rendered(files, "x")
    Image.fromarray(np.full(SHAPE, 200, np.uint8)).save(files / "depths" / "c.png")
    assert len(pair_files(files / "photos", files / "depths")) == 3
    with pytest.raises(ValueError, match=r"c\.png is an integer image; give the scale"):
        rendered(files, "y")
    assert len(list((files / "y").glob("*.json"))) == 5  # those before it are kept
    np.save(files / "depths" / "c.npy", np.ones((4, 5)))
    (files / "depths" / "c.png").unlink()
    with pytest.raises(ValueError, match="must have the size of the upright photo, 26 x 20, got 5 x 4"):
        rendered(files, "z")


@pytest.mark.parametrize("count", [2, 9, 400])
def test_the_index_of_a_pixel_is_that_of_the_nearest_defocus(count):
    lens = lm.Lens(focal_length=35e-3, f_number=4.0, focus_distance=1.5, wavelength=540e-9)
    depth = np.linspace(1.4, 1.7, 60).reshape(6, 10)
    defocus, index, psfs = datasets._psfs(DepthBlur(depth, lens, 30e-6), count)
    assert len(defocus) == len(psfs) == count
    step = defocus[1] - defocus[0]
    assert np.abs(defocus[index] - lens.defocus(depth)).max() <= 0.5 * step + 1e-5
    assert len(np.unique(index)) >= min(count, 40)


def test_a_killed_command_goes_on(files):
    (files / "lenses.toml").write_text(
        '[lens]\nfocal_length = ["30 mm", "50 mm"]\nf_number = [2.0, 8.0]\nfocus_distance = ["1 m", "inf"]\n'
        '[sensor]\npixel = "30 um"\n'
    )
    command = ["blur", "--batch", "photos", "depths", "lenses.toml", "-o", "set", "--seed", "3", "--copies", "2"]
    run = [sys.executable, "-m", "lommel", *command, "--psfs", "5", "--json"]
    first = subprocess.run(run, cwd=files, capture_output=True, text=True, check=True)
    told = json.loads(first.stdout)
    assert told["rendered"] == 4
    depths = [np.load(path) for path in sorted((files / "set").glob("*.depth.npy"))]
    assert told["depth"] == pytest.approx([min(map(np.nanmin, depths)), max(map(np.nanmax, depths))], rel=1e-5)
    assert told["depth_unknown"] == 0.0
    rendered(files, "same")
    assert_alike(contents(files / "set"), contents(files / "same"))
    for name in ("000002.json", "000003.json"):
        (files / "set" / name).unlink()
    again = subprocess.run(run, cwd=files, capture_output=True, text=True, check=True)
    assert json.loads(again.stdout)["rendered"] == 2
    assert_alike(contents(files / "set"), contents(files / "same"))


def test_a_file_that_cannot_be_used_is_left_out_and_tried_again(files):
    rendered(files)
    good = (files / "photos" / "a.png").read_bytes()
    (files / "photos" / "a.png").write_bytes(good[:200])
    made = rendered(files, "again", on_error="skip", workers=2)
    left_out = sorted((each for each in made if each.failure), key=lambda each: each.number)
    assert [each.number for each in left_out] == [0, 1]
    assert all("a.png" in each.failure and each.files == () for each in left_out)
    assert left_out[0].facts == {"photo": "a.png", "depth": "a.tif"}
    assert sorted(each.number for each in made if not each.failure) == [2, 3]
    assert max(each.done for each in made) == 2
    (files / "photos" / "a.png").write_bytes(good)
    assert sorted(each.number for each in rendered(files, "again", on_error="skip")) == [0, 1]
    assert_alike(contents(files / "again"), contents(files / "set"))


def test_what_cannot_be_read_is_left_out_and_what_cannot_be_written_is_an_error(files, monkeypatch):
    (files / "photos" / "b.png").unlink()
    (files / "photos" / "b.png").symlink_to(files / "nowhere.png")
    photos = [files / "photos" / name for name in ("b.png", "a.png")]
    depths = [files / "depths" / name for name in ("b.tif", "a.tif")]
    made = list(render_dataset(photos, depths, files / "set", LENSES, seed=3, psfs=0, shard=2, on_error="skip"))
    assert made[0].failure.endswith("b.png: No such file or directory")
    assert made[1].failure is None
    assert [path.name for path in (files / "set" / "parts").iterdir()] == ["000001.tar"]

    def full(*_):
        raise OSError(28, "No space left on device", "set")

    (files / "photos" / "b.png").unlink()
    (files / "depths" / "b.tif").unlink()
    monkeypatch.setattr("lommel.imaging.datasets.atomic.whole_files", full)
    with pytest.raises(OSError, match="No space left"):
        rendered(files, "full", psfs=0, on_error="skip")


def test_maps_of_inverse_depth_and_half_the_size_are_rendered(files):
    for stem in ("a", "b"):
        (files / "depths" / f"{stem}.tif").unlink()
        Image.fromarray(np.full((10, 13), 51, np.uint8)).save(files / "depths" / f"{stem}.png")
    with pytest.raises(ValueError, match=r'26 x 20, got 13 x 10, of the same aspect ratio; resample="nearest"'):
        rendered(files, "refused", inverse_depth=(1.0, 4.0))
    with pytest.warns(UserWarning, match=r"[ab]\.png: all of the depth, 400 m, is beyond the hyperfocal"):
        rendered(files, "far", disparity=(51 * 400.0, 0.0), resample="nearest")
    made = rendered(files, inverse_depth=(1.0, 4.0), resample="nearest")
    metres = 1.0 / (0.2 / 1.0 + 0.8 / 4.0)  # a fifth of the way in dioptres
    for picture in made:
        np.testing.assert_allclose(np.load(picture.files[2]), np.full(SHAPE, metres), rtol=1e-6)
    assert json.loads((files / "set" / "dataset.json").read_text())["inverse_depth"] == [1.0, 4.0]
    with pytest.raises(ValueError, match=r"other arguments \(inverse_depth\)"):
        rendered(files, inverse_depth=(1.0, 5.0), resample="nearest")


def test_zarr_groups_hold_the_same_pictures(files):
    zarr = pytest.importorskip("zarr")
    made = rendered(files, "zarrs", form="zarr", copies=1)
    other = rendered(files, "tif", form="tif", copies=1)
    assert [file.name for file in made[0].files] == ["000000.zarr", "000000.json"]
    for one, two in zip(made, other, strict=True):
        group, key = zarr.open_group(one.files[0], mode="r"), f"{two.number:06d}"
        assert np.array_equal(group["image"][:], lm.imaging.read_photo(two.files[0]).values)
        assert np.array_equal(group["sharp"][3:9, 2:4], lm.imaging.read_photo(two.files[1]).values[3:9, 2:4])
        assert np.array_equal(group["depth"][:], np.load(files / "tif" / f"{key}.depth.npy"))
        assert np.array_equal(group["index"][:], np.asarray(Image.open(files / "tif" / f"{key}.index.png")))
        with np.load(files / "tif" / f"{key}.psfs.npz") as table:
            assert np.array_equal(group["psfs"][:], table["psfs"])
            assert np.allclose(group["defocus"][:], table["defocus"])
        assert dict(group.attrs) == one.facts
        assert group["psfs"].metadata.dimension_names == ("step", "channel", "row", "column")
    before = zarr.open_group(made[1].files[0], mode="r")["image"][:]
    (files / "zarrs" / "000001.json").unlink()
    (files / "zarrs" / "000001.zarr" / "image" / "zarr.json").write_text("of a process that was killed")
    assert [each.number for each in rendered(files, "zarrs", form="zarr", copies=1, workers=2)] == [1]
    assert np.abs(zarr.open_group(made[1].files[0], mode="r")["image"][:] - before).max() < 1e-6


def test_exr_files_hold_linear_light(files):
    exr = pytest.importorskip("OpenEXR")
    made = rendered(files, form="exr", copies=1)[0]
    other = rendered(files, "tif", form="tif", copies=1)[0]
    for one, two in zip(made.files[:2], other.files[:2], strict=True):
        with exr.File(str(one)) as file:
            values = file.channels()["RGB"].pixels
        assert np.array_equal(values, lm.imaging.read_photo(two).values)


@pytest.mark.parametrize("shard", [None, 3, 4])
@pytest.mark.parametrize("which", ["photos/b.png", "depths/b.tif"])
def test_other_files_of_the_same_names_are_refused(files, which, shard):
    some = render_dataset(
        files / "photos", files / "depths", files / "set", LENSES, seed=3, copies=2, psfs=0, shard=shard
    )
    for _ in range(3 if shard is None else 4):
        next(some)
    some.close()
    before = contents(files / "set") if shard is None else None
    if which.startswith("photos"):
        lm.imaging.write_photo(files / which, np.full((*SHAPE, 3), 0.8))
    else:
        lm.imaging.write_depth(files / which, np.full(SHAPE, 1.5))
    with pytest.raises(
        ValueError, match=rf"set holds pictures of another {which[7:]} \(\d+ bytes, crc32 .*; choose anot"
    ):
        rendered(files, psfs=0, shard=shard)
    assert shard or contents(files / "set") == before


@pytest.mark.parametrize("name", ["image.png", "depth.npy", "index.png", "psfs.npz", "json"])
@pytest.mark.parametrize("how", ["missing", "cut off", "zeros"])
def test_pictures_whose_files_are_missing_or_damaged_are_rendered_again(files, name, how):
    rendered(files)
    wanted = contents(files / "set")
    file = files / "set" / f"000002.{name}"
    good = file.read_bytes()
    file.unlink() if how == "missing" else file.write_bytes(good[:-9] if how == "cut off" else bytes(len(good)))
    assert [each.number for each in rendered(files)] == [2]
    assert_alike(contents(files / "set"), wanted)


def test_parts_of_a_zarr_that_are_missing_are_rendered_again(files):
    rendered(files, form="zarr", psfs=0)
    (files / "set" / "000001.zarr" / "depth" / "c" / "0" / "0").unlink()
    assert [each.number for each in rendered(files, form="zarr", psfs=0)] == [1]


def test_damaged_shards_and_records_are_named(files):
    rendered(files, shard=2, psfs=0)
    shard = files / "set" / "shard-000001.tar"
    good = shard.read_bytes()
    shard.write_bytes(good[: len(good) // 2])
    with pytest.raises(ValueError, match=r"shard-000001\.tar is damaged \(.*\); remove it, and call again"):
        rendered(files, shard=2, psfs=0)
    at = good.index(b"\x89PNG") + 50
    shard.write_bytes(good[:at] + bytes([good[at] ^ 1]) + good[at + 1 :])
    with pytest.raises(ValueError, match=r"shard-000001\.tar is damaged \(the files of picture 2 were changed after"):
        rendered(files, shard=2, psfs=0)
    shard.unlink()
    assert [each.number for each in rendered(files, shard=2, psfs=0)] == [2, 3]
    assert len(shard.read_bytes()) == len(good)
    for text in ("", "[1]"):
        (files / "set" / "dataset.json").write_text(text)
        with pytest.raises(ValueError, match=r"dataset\.json is damaged; remove .*set, or choose another folder"):
            rendered(files, shard=2, psfs=0)
