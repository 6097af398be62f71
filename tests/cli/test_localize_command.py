"""`lommel localize`, run as a user runs it."""

from __future__ import annotations

import json
import re
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager, nullcontext
from pathlib import Path

import h5py
import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import pytest
import tifffile
from PIL import Image

import lommel as lm
import simulated_movies as simulated

ROOT = Path(__file__).resolve().parents[2]
EXAMPLE = ROOT / "examples" / "objectives" / "zeiss-63x-astigmatic.toml"
CAMERA = lm.Noise(white=0.46, read=1.6, offset=100.0)
NOISE = ["--gain", 0.46, "--read", 1.6, "--offset", 100]
FRAMES, SIDE = 8, 72
MOLECULES = simulated.spread(FRAMES, SIDE, each=3, apart=20, seed=5)


@pytest.fixture(scope="module")
def made(tmp_path_factory) -> Path:
    """A folder with an objective and a movie."""
    folder = tmp_path_factory.mktemp("movie")
    counts = simulated.recorded(simulated.light(MOLECULES, FRAMES, SIDE, 6.0), CAMERA, 6)
    tifffile.imwrite(folder / "movie.tif", counts, photometric="minisblack")
    (folder / "objective.toml").write_text(EXAMPLE.read_text(encoding="utf-8"), encoding="utf-8")
    return folder


@pytest.fixture
def folder(made, tmp_path) -> Path:
    for path in made.iterdir():
        (tmp_path / path.name).symlink_to(path)
    yield tmp_path
    plt.close("all")


def test_a_movie_becomes_a_table_and_a_picture(folder, call_lommel):
    """It is what Python finds with the same defaults."""
    outputs = ["-o", "a.csv", "-o", "a.hdf5", "--plot", "a.png", "--json"]
    result = call_lommel("localize", "movie.tif", "objective.toml", *NOISE, *outputs, folder=folder)
    assert (result.returncode, result.stderr) == (0, "")
    facts = json.loads(result.stdout)
    table = lm.localize.Table(simulated.pupil(), shape=15, pixel=6.5e-6, z=(-0.7e-6, 0.7e-6), reach=3.0)
    found = lm.localize.localize_movie(folder / "movie.tif", table, noise=CAMERA)
    found.save(folder / "b.csv")
    ours, theirs = (pd.read_csv(folder / name) for name in ("b.csv", "a.csv"))
    assert len(theirs) == 24
    np.testing.assert_allclose(theirs, ours, rtol=1e-3, atol=0.02)
    assert (facts["frames"], facts["spots"], facts["written"]) == (8, found.spots, int(found.kept.sum()))
    assert facts["states"] == found.counts
    assert facts["medians"]["z_error"] == pytest.approx(float(np.median(found.table["z_error"])), rel=1e-3)
    assert facts["table_error_bound"] <= 1e-4
    assert facts["files"] == ["a.csv", "a.hdf5", "a.yaml", "a.png"]
    assert facts["findings"] == found.to_dict()["findings"]
    assert facts["z"] == [-7e-7, 7e-7]
    with Image.open(folder / "a.png") as picture:
        assert min(picture.size) > 400
    with h5py.File(folder / "a.hdf5") as file:
        np.testing.assert_allclose(file["locs"]["z"], theirs["z [nm]"], atol=1e-3)


def test_maps_of_the_camera_and_other_options(folder, call_lommel):
    shape = (SIDE, SIDE)
    np.save(folder / "gain.npy", np.full(shape, 0.46))
    tifffile.imwrite(folder / "offset.tif", np.full(shape, 100, np.uint16))
    options = ["--gain", "gain.npy", "--offset", "offset.tif", "--read", 1.6, "--z", "-600nm", "600nm"]
    options += ["--reach", 2.5, "--depth", "1.1um"]
    result = call_lommel("localize", "movie.tif", "objective.toml", *options, "-o", "a.csv", "--json", folder=folder)
    assert result.returncode == 0, result.stderr
    facts = json.loads(result.stdout)
    assert facts["z"] == pytest.approx([-6e-7, 6e-7])
    assert facts["written"] >= 20
    depths = call_lommel("localize", "movie.tif", "objective.toml", *NOISE, "--along", "depth", "--z", "0.2um", "2um",
                         "-o", "b.csv", folder=folder)  # fmt: skip
    assert depths.returncode == 0, depths.stderr
    assert re.search(r"^z +200 nm, 2 um$", depths.stdout, re.MULTILINE)


def test_fits_at_the_range_of_z_and_beyond_the_reach_are_counted_apart(folder, call_lommel):
    """A narrow range of z, and a narrow reach: what is not written is told with the option that does it."""
    options = ["--z", "-300nm", "300nm", "--reach", 0.5, "-o", "a.csv"]
    result = call_lommel("localize", "movie.tif", "objective.toml", *NOISE, *options, "--json", folder=folder)
    facts = json.loads(result.stdout)
    table = lm.localize.Table(simulated.pupil(), shape=15, pixel=6.5e-6, z=(-300e-9, 300e-9), reach=0.5)
    found = lm.localize.localize_movie(folder / "movie.tif", table, noise=CAMERA).table
    ended = found["z"][found["state"] == 1]
    count = int((abs(ended) > 299.99e-9).sum())
    assert facts["border_fits"] == {"z": count, "reach": len(ended) - count}
    assert min(facts["border_fits"].values()) > 0


def test_a_mask_and_a_stated_background(folder, call_lommel):
    out = np.zeros((SIDE, SIDE), np.uint8)
    out[::9, ::9] = 1
    tifffile.imwrite(folder / "mask.tif", out)
    arguments = ["movie.tif", "objective.toml", *NOISE, "--mask", "mask.tif", "--background", "tilted", "-o", "a.csv"]
    facts = json.loads(call_lommel("localize", *arguments, "--json", folder=folder).stdout)
    table = lm.localize.Table(simulated.pupil(), shape=15, pixel=6.5e-6, z=(-0.7e-6, 0.7e-6), reach=3.0)
    found = lm.localize.localize_movie(
        lm.Counts.of(tifffile.imread(folder / "movie.tif"), noise=CAMERA, mask=out > 0), table, background="tilted"
    )
    assert (facts["written"], facts["left_out"]) == (int(found.kept.sum()), found.left_out)
    assert found.left_out > 0


def test_a_movie_without_spots_is_told(folder, call_lommel):
    tifffile.imwrite(folder / "dark.tif", np.full((3, 40, 40), 100, np.uint16), photometric="minisblack")
    result = call_lommel("localize", "dark.tif", "objective.toml", *NOISE, "-o", "a.csv", folder=folder)
    assert result.returncode == 3
    assert "no spot is six standard deviations above the noise: check --offset, --gain and --read" in " ".join(
        result.stdout.split()
    )


def test_a_cluster_gives_the_same_table(folder, monkeypatch, call_lommel):
    pytest.importorskip("distributed")

    @contextmanager
    def connected(address):
        with nullcontext() if address is None else ThreadPoolExecutor(2) as client:
            yield client

    monkeypatch.setattr("lommel.cli.localize_command.connected", connected)
    words = ["localize", "movie.tif", "objective.toml", *NOISE]
    for more in (["-o", "a.csv"], ["-o", "b.csv", "--client", "tcp://scheduler:8786"]):
        result = call_lommel(*words, *more, folder=folder)
        assert (result.returncode, result.stderr) == (0, "")
    assert (folder / "a.csv").read_bytes() == (folder / "b.csv").read_bytes()
    assert not list(folder.glob(".*"))
