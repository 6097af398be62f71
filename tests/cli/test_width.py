"""Help and output at 80 columns: no line is longer, and no word is broken or cut."""

from __future__ import annotations

import re
import shutil

import numpy as np
import pytest
import tifffile

from lommel.cli.main import COMMANDS

LENSES = ["phone", "hubble-1990", "microscope-20x", "newtonian-off-axis", "camera-field", "fast-portrait"]
OBJECTIVES = ["zeiss-63x-1.4-oil", "zeiss-100x-1.4-oil"]
RUNS = [
    *(f"info {name}.toml" for name in (*LENSES, *OBJECTIVES)),
    "psf phone.toml --mtf --shape 5 --sample -o a.png -o a.npz --plot a.pdf",
    "psf camera-field.toml --field 3x5 --shape 9 --mtf -o f.npz",
    "psf fast-portrait.toml --colour --shape 9 --mtf -o c.png",
    "psf zeiss-63x-1.4-oil.toml --stack 3 --shape 9 -o s.ome.tif -o s.png",
    "compare phone.toml --shape 5 --figure compare.png",
    "compare newtonian-off-axis.toml --shape 5",
    "methods",
    "examples",
    "stack phone.toml --between 1m 3m --count 3 --shape 5 -o stack.zarr",
    "precision phone.toml --focus 1.5m --pair 0.1 --photons 1e4",
    "blur photo.tif depth.tif phone.toml --focus 0.6m --missing nearest -o blurred.tif",
    "restore photo.tif depth.tif phone.toml --focus 0.6m --white 5000 --read 3 --steps 2 -o restored.tif",
    "depth photo.tif photo.tif phone.toml --focus 0.5m --focus 0.7m --between 0.4m 1m --white 500 --read 3 -o d.tif",
    "paper out --figure 3",
]


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """The example files, a photograph and its depth map."""
    from lommel.lensfiles.example_files import example_files

    place = tmp_path_factory.mktemp("width")
    for name in (*LENSES, *OBJECTIVES):
        (place / f"{name}.toml").write_bytes(example_files()[name].read_bytes())
    light = np.random.default_rng(0).random((40, 48)).astype(np.float32)
    tifffile.imwrite(place / "photo.tif", light)
    tifffile.imwrite(place / "depth.tif", np.full((40, 48), 0.55, np.float32))
    return place


def words(text: str) -> set[str]:
    # Times differ from run to run.
    return set(re.sub(r"[\d.]+ (m?s)\b", "0 s", text).split())


@pytest.mark.usefixtures("described_once")
@pytest.mark.parametrize("run", RUNS)
def test_output_fits_80_columns_without_a_broken_word(run, call_lommel, folder, monkeypatch):
    monkeypatch.setattr("matplotlib.figure.Figure.savefig", lambda *_, **__: None)  # is not looked at
    shown = {}
    for width in (300, 80):
        shutil.rmtree(folder / "stack.zarr", ignore_errors=True)
        monkeypatch.setenv("COLUMNS", str(width))
        result = call_lommel(*run.split(), folder=folder)
        # One photograph twice is no pair.
        expected = 3 if run.startswith("depth ") else 0
        assert (result.returncode, result.stderr) == (expected, "")
        shown[width] = result.stdout
    assert max(map(len, shown[80].splitlines())) <= 80
    assert words(shown[80]) <= words(shown[300])
    assert "\u2026" not in shown[80]


@pytest.mark.parametrize("name", ["", *COMMANDS])
def test_help_fits_80_columns_without_a_broken_word(name, call_lommel, tmp_path, monkeypatch):
    shown = {}
    for width in (100, 80):
        monkeypatch.setenv("COLUMNS", str(width))
        shown[width] = call_lommel(*name.split(), "--help", folder=tmp_path).stdout
    assert max(map(len, shown[80].splitlines())) <= 80
    # Words with a hyphen may go on behind it, but not the names of options.
    assert set(re.split(r"[\s-]+", shown[80])) <= set(re.split(r"[\s-]+", shown[100]))
    assert not re.search(r"--[a-z-]*-$", shown[80], re.MULTILINE)
    summaries = shown[80].partition("Commands:")[2]
    assert "..." not in summaries
