"""`lommel examples`: what there is to begin with, and copies of it."""

from __future__ import annotations

import csv
import json
import shlex
from pathlib import Path

import numpy as np
import pytest
import tifffile

ROOT = Path(__file__).resolve().parents[2] / "examples"
KINDS = {
    "lenses": ("lens", ".toml"),
    "objectives": ("objective", ".toml"),
    "cameras": ("camera", ".toml"),
    "class": ("notebook", ".ipynb"),
    "notebooks": ("notebook", ".ipynb"),
}
DATA = {"chart", "focus-pair", "photo", "beads", "stack", "molecules", "donut", "stars"}
THERE = {path.stem: path for kind, (_, end) in KINDS.items() for path in (ROOT / kind).glob(f"*{end}")}


def test_all_examples_are_listed_with_what_they_are(call_lommel, tmp_path):
    rows = json.loads(call_lommel("examples", "--json", folder=tmp_path).stdout)["examples"]
    assert {row["name"]: row["kind"] for row in rows} == {
        name: KINDS[path.parent.name][0] for name, path in THERE.items()
    } | dict.fromkeys(DATA, "data")
    told = call_lommel("examples", folder=tmp_path).stdout
    assert all(row["name"] in told and row["what"][:20] in told for row in rows)
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("given", ["phone", "phone.toml"])
def test_a_copy_is_what_the_example_is_and_serves_the_next_command(call_lommel, tmp_path, given):
    assert call_lommel("examples", given, folder=tmp_path).stdout == "wrote phone.toml\n"
    assert (tmp_path / "phone.toml").read_bytes() == THERE["phone"].read_bytes()
    assert call_lommel("info", "phone.toml", folder=tmp_path).returncode == 0


def test_several_go_to_a_folder_that_is_made(call_lommel, tmp_path):
    told = json.loads(call_lommel("examples", *THERE, "-o", "a/b", "--json", folder=tmp_path).stdout)
    assert (
        {Path(name).stem for name in told["files"]}
        == {path.stem for path in (tmp_path / "a/b").iterdir()}
        == set(THERE)
    )


def test_nothing_is_written_over(call_lommel, tmp_path):
    (tmp_path / "phone.toml").write_text("mine")
    result = call_lommel("examples", "nifty-fifty", "phone", folder=tmp_path)
    assert (result.returncode, result.stderr) == (2, "Error: phone.toml: File exists and differs from the example\n")
    assert [path.name for path in tmp_path.iterdir()] == ["phone.toml"]
    assert (tmp_path / "phone.toml").read_text() == "mine"


def test_unchanged_copies_are_left_alone_and_the_missing_ones_written(call_lommel, tmp_path):
    call_lommel("examples", "nifty-fifty", folder=tmp_path)
    before = (tmp_path / "nifty-fifty.toml").stat().st_mtime_ns
    result = call_lommel("examples", "nifty-fifty", "camera-field", folder=tmp_path)
    told = "wrote camera-field.toml\nnifty-fifty.toml is already there, unchanged\n"
    assert (result.returncode, result.stdout) == (0, told)
    assert (tmp_path / "nifty-fifty.toml").stat().st_mtime_ns == before
    again = json.loads(call_lommel("examples", "nifty-fifty", "--json", folder=tmp_path).stdout)
    assert again == {"files": []}


@pytest.fixture
def made(call_lommel, tmp_path):
    """Make a data set, run its command number `which`, and return what that prints as JSON."""

    def run(name, which=0):
        told = json.loads(call_lommel("examples", name, "--json", folder=tmp_path).stdout)
        assert all((tmp_path / file).is_file() for file in told["files"])
        _, *words = shlex.split(told["data"][0]["commands"][which])
        result = call_lommel(*words, "--json", folder=tmp_path)
        assert result.returncode == 0, result.stdout + result.stderr
        return json.loads(result.stdout), told["data"][0]["truth"]

    return run


@pytest.mark.parametrize("name", sorted(DATA))
def test_a_set_is_the_same_each_time(call_lommel, tmp_path, name):
    result = call_lommel("examples", name, folder=tmp_path)
    lines = result.stdout.replace(" \\\n", "").splitlines()
    assert any(line.startswith("  lommel ") for line in lines)
    assert lines[-1].startswith(("true: ", "  "))
    again = call_lommel("examples", name, folder=tmp_path)
    assert "wrote" not in again.stdout
    assert again.stdout.count("is already there, unchanged") == result.stdout.count("wrote ")


def test_data_are_written_whole_or_not_at_all(call_lommel, tmp_path):
    (tmp_path / "star-2.tif").write_text("mine")
    result = call_lommel("examples", "stars", folder=tmp_path)
    assert (result.returncode, result.stderr) == (2, "Error: star-2.tif: File exists and differs from the example\n")
    assert [path.name for path in tmp_path.iterdir()] == ["star-2.tif"]


def test_the_chart_has_the_stated_mtf50(made):
    facts, truth = made("chart")
    assert truth.startswith("MTF50 0.267 cycles/pixel")
    assert len(facts["edges"]) == 8
    assert all(abs(edge["mtf50_px"] - 0.267) < 3.0 * edge["mtf50_px_error"] for edge in facts["edges"])


def test_the_pair_has_the_stated_distances(made, tmp_path):
    _, truth = made("focus-pair")
    assert truth == "1.45 m in the left half, 1.65 m in the right half"
    depth = tifffile.imread(tmp_path / "distances.tif")
    assert np.nanmedian(depth[:, :85]) == pytest.approx(1.45, abs=0.01)
    assert np.nanmedian(depth[:, 115:]) == pytest.approx(1.65, abs=0.01)


def test_the_photograph_is_restored_and_blurred_as_stated(made, tmp_path):
    facts, _ = made("photo")
    assert facts["discrepancy"] == pytest.approx(1.0, abs=0.2)
    made("photo", 1)
    scene, photo, sharp, blurred = (
        tifffile.imread(tmp_path / f"{name}.tif")[30:-30, 30:-30] for name in ("scene", "photo", "sharp", "blurred")
    )
    assert np.std(sharp - scene) < 0.7 * np.std(photo - scene)
    assert np.mean((photo - blurred) ** 2 / ((np.maximum(blurred, 0.0) * 1e4 + 9.0) / 1e8)) == pytest.approx(
        1.0, abs=0.05
    )


def test_the_bead_has_the_stated_aberrations_and_na(made):
    facts, truth = made("beads")
    assert "NA 1.4" in truth
    assert "0.377 rad" in truth
    assert "-0.251 rad" in truth
    for name, true in {"2,2": 0.377, "3,1": -0.251, "NA": 1.4, "sample": 1.33}.items():
        assert facts["coefficients"][name] == pytest.approx(true, abs=3.0 * facts["errors"][name])


def test_the_stack_has_the_stated_background_and_helix(made, tmp_path):
    facts, truth = made("stack")
    assert "background 5 electrons" in truth
    assert facts["channels"][0]["background"] == pytest.approx(5.0, abs=0.2)
    restored = tifffile.imread(tmp_path / "restored.ome.tif").astype(float).squeeze()
    z, y, x = np.indices(restored.shape)
    radius = (restored * np.hypot(y - 24.0, x - 24.0)).sum() / restored.sum() * 6.5 / 63.0
    assert radius == pytest.approx(1.24, abs=0.05)
    assert 4.0 < (restored * z).sum() / restored.sum() < 11.0


def test_the_molecules_are_on_the_stated_ring(made, tmp_path):
    facts, truth = made("molecules")
    assert truth.startswith("80 molecules of 2500 photons on a ring of radius 2 um about x = y = 3.302 um")
    assert facts["written"] == 80
    with (tmp_path / "molecules.csv").open(encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    x, y, z = (np.array([float(row[f"{axis} [nm]"]) for row in rows]) for axis in "xyz")
    assert np.median(np.hypot(x - 3302.0, y - 3302.0)) == pytest.approx(2000.0, abs=3.0)
    away = z - 300.0 * np.sin(3.0 * np.arctan2(y - 3302.0, x - 3302.0))
    assert np.median(away) == pytest.approx(0.0, abs=5.0)
    assert np.std(away) < 25.0


def test_the_donut_has_the_stated_coma(made):
    facts, truth = made("donut")
    assert truth.startswith("coma 0.200 waves rms towards 1 o'clock (53 degrees)")
    assert facts["coma"]["waves"] == pytest.approx(0.2, abs=3.0 * facts["coma"]["error"])
    assert facts["coma"]["degrees"] == pytest.approx(53.1, abs=3.0)


def test_the_stars_have_the_stated_aberrations(made):
    facts, truth = made("stars")
    assert truth == "astigmatism 0 (Noll 6) 0.600 rad, coma x (Noll 8) -0.400 rad, other terms 0"
    true = {"2,2": 0.6, "3,1": -0.4}
    for name in facts["coefficients"]:
        if "," in name:
            assert facts["coefficients"][name] == pytest.approx(true.get(name, 0.0), abs=3.0 * facts["errors"][name])
