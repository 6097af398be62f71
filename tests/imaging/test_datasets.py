"""Data sets: the same by any number of workers and after interruptions, with the ground truth of their making."""

from __future__ import annotations

import json
import os
import random
import shutil
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace

import numpy as np
import pytest
from PIL import Image

import lommel as lm
from lommel.imaging import DepthBlur, DepthMapOptions, LensRanges, Occlusion, datasets, render_dataset
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
    given = {"seed": 3, "copies": 2} | given
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
    made = rendered(files, noise=lm.Noise(white=5000, read=3.0))
    clean = rendered(files, "clean")
    assert [(each.number, each.done, each.total) for each in made] == [(k, k + 1, 4) for k in range(4)]
    lenses = set()
    for each, other in zip(made, clean, strict=True):
        facts = json.loads((files / "set" / f"{each.number:06d}.json").read_text())
        distance = float(facts["focus_distance"]) if facts["focus_distance"] != "infinity" else np.inf
        lens = lm.Lens(
            focal_length=facts["focal_length"], f_number=facts["f_number"], focus_distance=distance, wavelength=540e-9
        )
        lenses.add(lens.focal_length)
        depth = np.load(files / "set" / f"{each.number:06d}.depth.npy").astype(np.float64)
        sharp = lm.imaging.read_photo(other.files[1]).light()
        blur = DepthBlur(depth, lens, facts["pixel"], channels=lm.imaging.RED_GREEN_BLUE)
        seen = Occlusion(blur).forward(sharp)
        found = lm.imaging.read_photo(other.files[0]).light()
        assert np.abs(found - np.clip(seen, 0.0, 1.0)).max() < 5e-5  # of 16 bits
        noisy = lm.imaging.read_photo(each.files[0]).light()
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
    some = render_dataset(files / "photos", files / "depths", files / "again", LENSES, seed=3, copies=2)
    next(some)
    some.close()
    (files / "again" / "000001.image.png").write_bytes(b"of a process that was killed")
    assert [each.number for each in rendered(files, "again", workers=2)] != [0]
    assert_alike(contents(files / "again"), wanted)
    assert rendered(files, "again") == []


def test_an_executor_renders_the_same_bits(files, monkeypatch):
    """As one thread of this process does."""
    monkeypatch.setattr("os.cpu_count", lambda: 1)
    rendered(files, noise=lm.Noise(white=5000, read=3.0))
    with ThreadPoolExecutor(2) as client:
        made = rendered(files, "other", client=client, noise=lm.Noise(white=5000, read=3.0))
        assert rendered(files, "other", client=client, noise=lm.Noise(white=5000, read=3.0)) == []
    assert contents(files / "other") == contents(files / "set")
    assert all(file.is_file() for each in made for file in each.files)


def test_folders_that_workers_do_not_see_or_that_were_replaced_are_told(files, monkeypatch):
    with ThreadPoolExecutor(1) as client:
        some = render_dataset(
            files / "photos", files / "depths", files / "set", LENSES, seed=3, copies=9, client=client
        )
        next(some)
        shutil.rmtree(files / "set")
        with pytest.raises(ValueError, match="set was removed or replaced while its pictures were rendered"):
            list(some)
        elsewhere = datasets.atomic.whole_files
        monkeypatch.setattr("lommel.imaging.datasets.atomic.whole_files", lambda _: elsewhere(files / "none"))
        with pytest.raises(ValueError, match=r"a worker does not see .*set: choose a folder that all workers reach"):
            rendered(files, client=client)
        hidden = FileNotFoundError(2, "No such file or directory", str(files / "photos" / "a.png"))
        monkeypatch.setattr(datasets, "_render", lambda *_: (_ for _ in ()).throw(hidden))
        monkeypatch.setattr(datasets.Path, "exists", lambda _: True)
        with pytest.raises(
            ValueError, match=r"a worker does not see .*photos: choose a folder that all workers reach"
        ):
            rendered(files, client=client)


def test_a_worker_that_outlives_its_call_writes_nothing(files):
    late = []

    class Late(ThreadPoolExecutor):
        def submit(self, function, *task):
            if task[0] == 2:
                late.append((function, task))
                raise KeyboardInterrupt
            return super().submit(function, *task)

    with Late(1) as client, pytest.raises(KeyboardInterrupt):
        rendered(files, client=client)
    before = contents(files / "set")
    ((function, task),) = late
    with pytest.raises(ValueError, match="was removed or replaced"):
        function(*task)
    assert contents(files / "set") == before


@pytest.mark.filterwarnings("ignore::lommel.base.executors.Waiting")  # workers begin anew
def test_workers_and_a_scheduler_that_are_killed_change_no_picture(files, monkeypatch):
    distributed, psutil = pytest.importorskip("distributed"), pytest.importorskip("psutil")
    draw = random.Random(5)
    monkeypatch.setattr(sys.modules[__name__], "LENSES", replace(LENSES, f_number=8.0))
    made = rendered(files, copies=30, workers=1 + (os.cpu_count() or 1))  # one thread for each picture
    cluster = distributed.LocalCluster(n_workers=2, threads_per_worker=1, processes=True, dashboard_address=":0")
    with cluster, distributed.Client(cluster) as client:
        pictures = render_dataset(
            files / "photos", files / "depths", files / "other", LENSES, seed=3, copies=30, client=client
        )
        for picture in pictures:
            if picture.done % 9 == 0:
                client.wait_for_workers(2)  # one that is killed while it starts is not started again
                processes = psutil.Process().children(recursive=True)
                draw.choice([each for each in processes if "spawn_main" in " ".join(each.cmdline())]).kill()
            if picture.done == 50:
                cluster.close()
                break
        with pytest.raises(RuntimeError, match="the client cancelled tasks"):
            list(pictures)
    rendered(files, "other", copies=30, workers=1 + (os.cpu_count() or 1))
    assert len(made) == 60
    assert contents(files / "other") == contents(files / "set")


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
    (files / "photos" / "c.png").write_bytes((files / "photos" / "a.png").read_bytes())
    with pytest.raises(ValueError, match=r"c\.png has no depth map of the same name$"):
        rendered(files, "x")
    Image.fromarray(np.full(SHAPE, 200, np.uint8)).save(files / "depths" / "c.png")
    assert len(pair_files(files / "photos", files / "depths")) == 3
    with pytest.raises(FileNotFoundError, match="nodepths"):
        pair_files(files / "photos", files / "nodepths")
    with pytest.raises(ValueError, match=r"c\.png is an integer image; give the scale"):
        rendered(files, "y")
    assert len(list((files / "y").glob("*.json"))) == 5  # those before it are kept


def test_a_killed_command_goes_on(files):
    (files / "lenses.toml").write_text(
        '[lens]\nfocal_length = ["30 mm", "50 mm"]\nf_number = [2.0, 8.0]\nfocus_distance = ["1 m", "inf"]\n'
        '[sensor]\npixel = "30 um"\n'
    )
    command = ["blur", "--batch", "photos", "depths", "lenses.toml", "-o", "set", "--seed", "3", "--copies", "2"]
    run = [sys.executable, "-m", "lommel", *command, "--json"]
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


def test_what_cannot_be_written_is_an_error(files, monkeypatch):
    def full(*_):
        raise OSError(28, "No space left on device", "set")

    monkeypatch.setattr("lommel.imaging.datasets.atomic.whole_files", full)
    with pytest.raises(OSError, match="No space left"):
        rendered(files, "full", on_error="skip")


def test_maps_of_inverse_depth_and_half_the_size_are_rendered(files):
    for stem in ("a", "b"):
        (files / "depths" / f"{stem}.tif").unlink()
        Image.fromarray(np.full((10, 13), 51, np.uint8)).save(files / "depths" / f"{stem}.png")
    with pytest.raises(ValueError, match=r'26 x 20, got 13 x 10, of the same aspect ratio; resample="nearest"'):
        rendered(files, "refused", depth_options=DepthMapOptions(inverse=(1.0, 4.0)))
    with pytest.warns(UserWarning, match=r"[ab]\.png: all of the depth, 400 m, is beyond the hyperfocal"):
        rendered(files, "far", depth_options=DepthMapOptions(disparity=(51 * 400.0, 0.0), resample="nearest"))
    made = rendered(files, depth_options=DepthMapOptions(inverse=(1.0, 4.0), resample="nearest"))
    metres = 1.0 / (0.2 / 1.0 + 0.8 / 4.0)  # a fifth of the way in dioptres
    for picture in made:
        np.testing.assert_allclose(np.load(picture.files[2]), np.full(SHAPE, metres), rtol=1e-6)
    assert json.loads((files / "set" / "dataset.json").read_text())["depth_options"]["inverse"] == [1.0, 4.0]
    with pytest.raises(ValueError, match=r"other arguments \(depth_options\)"):
        rendered(files, depth_options=DepthMapOptions(inverse=(1.0, 5.0), resample="nearest"))


def test_unknown_depth_is_filled_and_counted(files):
    for stem in ("a", "b"):
        lm.imaging.write_depth(
            files / "depths" / f"{stem}.tif", np.where(np.arange(26) < 13, np.nan, 1.5) * np.ones(SHAPE)
        )
    with pytest.raises(ValueError, match="depth is NaN at 260 of 520 points"):
        rendered(files, "refused")
    for picture in rendered(files, depth_options=DepthMapOptions(missing="nearest")):
        assert (picture.facts["depth_unknown"], picture.facts["depth_range"]) == (0.5, [1.5, 1.5])
        assert np.all(np.load(picture.files[2]) == 1.5)


@pytest.mark.parametrize("which", ["photos/b.png", "depths/b.tif"])
def test_other_files_of_the_same_names_are_refused(files, which):
    some = render_dataset(files / "photos", files / "depths", files / "set", LENSES, seed=3, copies=2)
    for _ in range(3):
        next(some)
    some.close()
    before = contents(files / "set")
    if which.startswith("photos"):
        lm.imaging.write_photo(files / which, np.full((*SHAPE, 3), 0.8))
    else:
        lm.imaging.write_depth(files / which, np.full(SHAPE, 1.5))
    with pytest.raises(
        ValueError, match=rf"set holds pictures of another {which[7:]} \(\d+ bytes, crc32 .*; choose anot"
    ):
        rendered(files)
    assert contents(files / "set") == before


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


def test_damaged_records_are_named(files):
    rendered(files)
    for text in ("", "[1]"):
        (files / "set" / "dataset.json").write_text(text)
        with pytest.raises(ValueError, match=r"dataset\.json is damaged; remove .*set, or choose another folder"):
            rendered(files)
