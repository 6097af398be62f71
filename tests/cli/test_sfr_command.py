"""`lommel sfr`, run as a user runs it, on charts that are drawn by integrals of a Gaussian."""

from __future__ import annotations

import csv
import json
from types import SimpleNamespace

import numpy as np
import pytest
from PIL import Image

import lommel as lm
from lommel.cli import sfr_command
from slanted_edges import gaussian, picture, squares

LENS = """
name = "50 mm lens"
[lens]
focal_length = "50 mm"
f_number = 8.0
focus_distance = "2 m"
wavelength = "550 nm"
[sensor]
pixel = "4 um"
"""


@pytest.fixture
def folder(tmp_path):
    """A chart of one square, one edge in colour, and a lens file."""
    (tmp_path / "lens.toml").write_text(LENS, encoding="utf-8")
    light = squares((120, 120), [(0.0, 0.0)], 70.0, 0.8)
    encoded = 1.055 * np.random.default_rng(0).poisson(20000 * light) ** (1 / 2.4) / 20000 ** (1 / 2.4) - 0.055
    Image.fromarray((255.0 * encoded).round().astype(np.uint8)).save(tmp_path / "chart.png")
    colours = np.stack([picture(6.0, sigma, (90, 90), 4) for sigma in (0.7, 0.5, 0.6)], axis=-1)
    Image.fromarray((255.0 * colours).round().astype(np.uint8)).save(tmp_path / "edge.png")
    return tmp_path


def test_a_chart_is_told_and_written(folder, call_lommel):
    result = call_lommel(
        "sfr", "chart.png", "--pixel", "4um", "--frequency", 0.1, 0.2, "-o", "edges.csv", "-o", "edges.json", "-o",
        "map.png", "--plot", "curves.png", folder=folder,
    )  # fmt: skip
    assert result.returncode == 0, result.stderr
    lines = result.stdout.splitlines()
    assert lines[0] == "8-bit values, assumed sRGB; if they are linear, give --encoding linear"
    assert lines[1].startswith("converged: 4 edges measured, 0 refused")
    assert lines[-4:] == [f"wrote {name}" for name in ("edges.csv", "edges.json", "map.png", "curves.png")]
    data = json.loads((folder / "edges.json").read_text(encoding="utf-8"))
    with (folder / "edges.csv").open(encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    assert len(rows) == len(data["edges"]) == 4
    expected = np.exp(-2.0 * (0.1 * np.pi) ** 2 * (0.8**2 + 1 / 12))
    for row, record in zip(rows, data["edges"], strict=True):
        assert float(row["at_0.1"]) == record["at_0.1"] == pytest.approx(expected, abs=0.01)
        assert record["mtf50"] == pytest.approx(record["mtf50_px"] / 4e-6)
        assert record["direction"] == "T"
    assert data["zones"][0]["edges"] == 4
    assert "lw ph: line widths per picture height, 120 pixels as shown" in lines
    assert "> is the Nyquist frequency" not in result.stdout


def test_tables_that_are_wider_than_the_console_continue_below(folder, call_lommel, monkeypatch):
    monkeypatch.setenv("COLUMNS", "80")
    words = ["chart.png", "--lens", "lens.toml", "--frequency", 0.1, 0.2, 0.3, 0.4, 0.5]
    result = call_lommel("sfr", *words, folder=folder)
    assert max(map(len, result.stdout.splitlines())) <= 80
    assert "\u2026" not in result.stdout
    heads = [line for line in result.stdout.splitlines() if line.startswith("zone ")]
    assert len(heads) > 1
    for f in words[4:]:
        for name in ("at", "lens", "z"):
            assert sum(f"  {name} {f}" in line for line in heads) == 1


def test_edges_that_are_sharper_than_the_nyquist_frequency_count_above_all_others():
    values = [0.24, None, None, 0.2, 0.22]
    rows = [
        {
            "row": 5,
            "column": 5,
            "direction": "S",
            "mtf50_px": x,
            "mtf50_px_above": None if x else 0.25,
            "at_0.25": 0.5,
        }
        for x in values
    ]
    chart = SimpleNamespace(shape=(11, 11))
    (zone,) = sfr_command._zones(chart, rows)
    assert (zone["mtf50_px"], zone["mtf50_px_above"], zone["at_0.25"]) == (0.24, None, 0.5)
    (zone,) = sfr_command._zones(chart, rows[:3])
    assert (zone["mtf50_px"], zone["mtf50_px_above"]) == (None, 0.25)


def test_mtf50_above_the_nyquist_frequency_is_a_limit_in_tables_and_files(folder, call_lommel):
    light = squares((120, 120), [(0.0, 0.0)], 70.0, 0.2)
    Image.fromarray((255.0 * light).round().astype(np.uint8)).save(folder / "sharp.png")
    words = ["sharp.png", "--encoding", "linear", "--pixel", "4um", "-o", "edges.csv", "-o", "edges.json"]
    result = call_lommel("sfr", *words, folder=folder)
    assert " T              4  > 0.5     > 120  > 125 cycles/mm " in result.stdout
    assert "> is the Nyquist frequency" in result.stdout
    data = json.loads((folder / "edges.json").read_text(encoding="utf-8"))
    for record in (*data["edges"], *data["zones"]):
        assert record["mtf50_px"] is None
        assert record["mtf50_px_above"] == pytest.approx(0.5)
    with (folder / "edges.csv").open(encoding="utf-8") as file:
        assert {float(row["mtf50_px_above"]) for row in csv.DictReader(file)} == {0.5}


def test_one_crop_has_a_row_for_each_colour(folder, call_lommel):
    result = call_lommel("sfr", "edge.png", "--encoding", "linear", "--json", folder=folder)
    records = json.loads(result.stdout)["edges"]
    assert [record["channel"] for record in records] == ["red", "green", "blue"]
    for sigma, record in zip((0.7, 0.5, 0.6), records, strict=True):
        assert record["at_0.25"] == pytest.approx(gaussian(0.25, np.radians(6.0), sigma), abs=0.02)


def test_a_lens_file_is_compared_in_standard_errors(folder, call_lommel):
    result = call_lommel("sfr", "chart.png", "--lens", "lens.toml", "--json", folder=folder)
    pupil, f, turn = lm.load_instrument(folder / "lens.toml").pupil(), 0.25 / 4e-6, np.radians(6.0)
    for record in json.loads(result.stdout)["edges"]:
        computed = lm.mtf(pupil, f * np.cos(turn), f * np.sin(turn), pixel=4e-6)
        assert record["lens_0.25"] == pytest.approx(computed, abs=2e-3)
        other = lm.mtf(pupil, 1.03 * f) * computed / lm.mtf(pupil, f)  # an f-number in error by 3 %
        assert record["error_lens_0.25"] == pytest.approx(computed - other, rel=0.02)
        error = np.hypot(record["error_0.25"], record["error_lens_0.25"])
        assert record["z_0.25"] == pytest.approx((record["at_0.25"] - record["lens_0.25"]) / error)
        assert record["z_0.25"] < -4.0  # the picture is blurred more


def diffracted(f_number, degrees=6.0):
    """Return an edge by a lens without aberrations at 2 m, 50 mm, in pixels of 4 um: the integral of its MTF."""
    cutoff = 4e-6 / (550e-9 * f_number * (1.0 + 50.0 / 1950.0))  # cycles per pixel
    f = (np.arange(600) + 0.5) / 600 * cutoff
    turn = np.radians(degrees)
    mtf = 2.0 / np.pi * (np.arccos(f / cutoff) - f / cutoff * np.sqrt(1.0 - (f / cutoff) ** 2))
    mtf *= np.sinc(f * np.cos(turn)) * np.sinc(f * np.sin(turn))
    d = np.arange(-80.0, 80.0, 0.1)
    edge = 0.5 + np.sin(2.0 * np.pi * np.outer(d, f)) @ (mtf / (np.pi * f)) * (f[1] - f[0])
    y, x = np.ogrid[:90, :90]
    light = 0.5 + 0.7 * (np.interp((x - 44.5) * np.cos(turn) + (y - 44.5) * np.sin(turn), d, edge) - 0.5)
    return np.random.default_rng(1).poisson(20000 * light) / 20000


@pytest.mark.parametrize(
    ("options", "cause"),
    [
        ("", ""),
        ("--f-number 16 --frequency 0.1 0.25", "at 0.25 cycles/pixel (and at 0.1) the response is "),
        ("--f-number 16", "the f-number is not 16, or the picture was sharpened"),
        ("--f-number 4", "the picture is defocused, the f-number is not 4, or"),
        ("--pixel 1.4um", "the pixel is not 1.4 um, as given, but 4 um, as in the lens file; the f-number is not 8"),
        ("--object-distance 1.5m", "the lens has the object at 1.5 m and the focus at 2 m: give --object-distance"),
    ],
)
def test_a_lens_that_does_not_fit_is_a_doubt(folder, call_lommel, options, cause):
    Image.fromarray((60000.0 * diffracted(8.0)).round().astype(np.uint16)).save(folder / "lens.tif")
    words = ["lens.tif", "--encoding", "linear", "--lens", "lens.toml", *options.split()]
    result = call_lommel("sfr", *words, folder=folder)
    assert result.returncode == (4 if cause else 0), result.stdout
    assert ("misfit" in result.stdout) == bool(cause)
    assert cause in " ".join(result.stdout.split())


def test_colours_without_a_computed_mtf_have_empty_columns(folder, call_lommel):
    words = ["edge.png", "--encoding", "linear", "--lens", "lens.toml", "-o", "edges.csv"]
    call_lommel("sfr", *words, folder=folder)
    with (folder / "edges.csv").open(encoding="utf-8") as file:
        rows = {row["channel"]: row for row in csv.DictReader(file)}
    assert rows["red"]["lens_0.25"] == rows["blue"]["z_0.25"] == ""
    assert float(rows["green"]["lens_0.25"]) > 0.0


def test_pictures_in_doubt_end_with_exit_code_4(folder, call_lommel):
    result = call_lommel("sfr", "edge.png", "--encoding", "0.3", folder=folder)
    assert result.returncode == 4
    assert "not symmetric" in result.stdout


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["chart.png", "-o", "map.txt"], "--output must end in .csv, .json (table), .png, .pdf or .svg (map)"),
        (["chart.png", "--frequency", "0.7"], "--frequency must be"),
        (["chart.png", "--mosaic", "RGB"], "--mosaic must be RGGB, BGGR"),
    ],
)
def test_wrong_options_are_one_line(folder, call_lommel, words, message):
    result = call_lommel("sfr", *words, folder=folder)
    assert result.returncode == 2
    assert message in result.stderr
    assert len(result.stderr.splitlines()) == 1
