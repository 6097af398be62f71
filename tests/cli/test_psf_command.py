"""`lommel psf` in colour, over the field, with contrast, seeing and figures, run as a user runs it."""

from __future__ import annotations

import json
import math
import re
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

import lommel as lm
from pupil_overlap import overlap

OPTIONS = ["--field", "3x4", "--shape", "21x17", "--normalize", "strehl"]


@pytest.fixture(scope="module")
def expected(lenses) -> lm.PSFGrid:
    instrument = lm.load_instrument(lenses["camera-field"])
    return instrument.field().grid(
        3,
        4,
        sensor=(24e-3, 36e-3),
        shape=(21, 17),
        pixel=0.5e-6,
        normalize="strehl",
    )


def test_the_json_is_what_python_knows(call_lommel, lenses, expected, tmp_path):
    result = call_lommel("psf", lenses["camera-field"], *OPTIONS, "--json", folder=tmp_path)
    data = json.loads(result.stdout)
    assert data["sensor"] == pytest.approx([0.024, 0.036])
    np.testing.assert_allclose(data["x"], expected.x)
    np.testing.assert_allclose(data["y"], expected.y)
    np.testing.assert_allclose(data["peak"], expected.values.max(axis=(2, 3)))
    assert data["shape"] == [3, 4, 21, 17]
    assert data["files"] == []


MEASURED = """
[lens]
focal_length = "50 mm"
f_number = 4
wavelength = "587.56 nm"
[sensor]
pixel = "1 um"
shape = 33
[field]
sensor = ["17.6 mm", "17.6 mm"]
direction = "y"
order = "fringe"
normalization = "edge"
columns = ["height", "Z4", "Z8", "Z9"]
rows = [["0 mm", 0.05, 0, 0.08], ["6.14 mm", 0.12, 0.11, 0.07], ["8.82 mm", -0.15, 0.18, 0.06]]
"""


def strehl_of(z4: float, z8: float, z9: float) -> float:
    """Return the Strehl ratio of three fringe terms, waves at the edge of the pupil, by sums over the pupil."""
    nodes, weights = np.polynomial.legendre.leggauss(40)
    rho, theta = np.meshgrid(0.5 * (nodes + 1.0), np.arange(64) * math.tau / 64, indexing="ij")
    waves = z4 * (2.0 * rho**2 - 1.0) + z8 * (3.0 * rho**3 - 2.0 * rho) * np.sin(theta)
    waves += z9 * (6.0 * rho**4 - 6.0 * rho**2 + 1.0)
    return float(abs((np.exp(2j * math.pi * waves) * rho * weights[:, None]).sum() / 64) ** 2)


@pytest.mark.parametrize(
    "command",
    [
        "info",
        "psf --normalize strehl",
        "psf --colour",
        "compare",
        "stack --between 1m inf --count 2 -o stack.zarr",
    ],
)
def test_a_measured_field_is_used_on_the_axis_which_is_named_with_the_range_over_the_field(
    call_lommel, tmp_path, command
):
    (tmp_path / "lens.toml").write_text(MEASURED)
    name, *options = command.split()
    result = call_lommel(name, "lens.toml", *options, "--json", folder=tmp_path)
    assert result.returncode == 0, result.stderr
    facts = json.loads(result.stdout)
    axis = strehl_of(0.05, 0.0, 0.08)
    assert facts["place"]["at"] == [0.0, 0.0]
    assert facts["place"]["strehl_at_peak"] == pytest.approx(axis, abs=1e-6)
    low, high = facts["place"]["strehl_over_field"]
    assert high == pytest.approx(axis, abs=1e-6)
    assert low == pytest.approx(strehl_of(-0.15, 0.18, 0.06), abs=0.02)  # a tilt shifts the peak: higher by little
    assert facts["place"]["to"] == pytest.approx(8.82e-3)
    if name == "info":
        assert facts["strehl"] == pytest.approx(axis, abs=1e-6)
    if "--normalize" in options:  # averaged over pixels of 0.43 lambda*N
        assert 0.85 * axis < facts["psf"]["peak"] < axis
    if name == "stack":
        infinity = lm.open_stack(tmp_path / "stack.zarr")[1].pupil
        assert lm.strehl(infinity) == pytest.approx(axis, abs=1e-6)


def test_the_report_is_on_the_place_that_is_stated(call_lommel, tmp_path):
    (tmp_path / "lens.toml").write_text(MEASURED)
    result = call_lommel("info", "lens.toml", "--at", "0mm", "8.82mm", folder=tmp_path)
    first = result.stdout.splitlines()[1]
    assert re.match(
        r"0 m and 8.82 mm from the middle of the sensor, Strehl ratio at the peak 0\.\d+; 0\.\d+ to 0\.\d+ over",
        first,
    )
    corner = strehl_of(-0.15, 0.18, 0.06)
    assert f"strehl                     {corner:.4g}\n" in result.stdout
    beyond = call_lommel("psf", "lens.toml", "--at", "0mm", "9mm", folder=tmp_path)
    assert beyond.returncode == 2
    assert "--at (0.0, 0.009) must lie in the map" in beyond.stderr


def test_a_place_beyond_the_sensor_is_named(call_lommel, tmp_path):
    (tmp_path / "lens.toml").write_text(MEASURED.replace('"17.6 mm", "17.6 mm"', '"10 mm", "14 mm"'))
    for place, beyond in ((("0mm", "5.5mm"), True), (("-7.2mm", "1mm"), True), (("5.5mm", "-5.01mm"), False)):
        result = call_lommel("psf", "lens.toml", "--at", *place, folder=tmp_path)
        assert result.returncode == 0, result.stderr
        assert ("beyond the sensor of 10 mm x 14 mm (height x width)" in result.stdout) == beyond


def test_the_psf_of_one_place_has_the_wavefront_and_the_blur_there(call_lommel, lenses, tmp_path):
    lens = lenses["camera-field"]
    options = ["--at", "15mm", "-10mm", "--jitter", "2", "--shape", "33", "-o", "corner.npz"]
    result = call_lommel("psf", lens, *options, folder=tmp_path)
    assert (result.returncode, result.stderr) == (0, "")
    assert "15 mm and -10 mm from the middle of the sensor" in result.stdout
    instrument = lm.load_instrument(lens)
    blur = lm.Jitter(2.0 * np.pi / 648000.0 * 35e-3)
    corner = lm.psf(
        instrument.field().pupil(15e-3, -10e-3), 33, instrument.pixel, blur=blur, **instrument.sensor_options
    )
    np.testing.assert_allclose(
        lm.PSF.load(tmp_path / "corner.npz").values, corner.values, atol=1e-6 * corner.values.max()
    )
    axis = lm.psf(instrument.pupil(), 33, instrument.pixel, blur=blur, **instrument.sensor_options)
    assert np.abs(axis.values - corner.values).max() > 0.1 * corner.values.max()


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (["--at", "15mm", "-10mm", "--field", "2x2"], "--at is for one place"),
        (
            ["--f-number", "4", "--wavelength", "450nm"],
            "--f-number, --wavelength cannot be combined with the section",
        ),
    ],
)
def test_a_place_that_has_no_psf_is_told(call_lommel, lenses, tmp_path, options, message):
    result = call_lommel("psf", lenses["camera-field"], *options, folder=tmp_path)
    assert result.returncode == 2
    assert re.search(message, result.stderr)
    assert result.stderr.count("\n") < 8


def test_files_and_tables_hold_what_python_computes(call_lommel, lenses, tmp_path):
    path = lenses["fast-portrait"]
    outputs = [part for name in ("a.npz", "a.tif", "a.png") for part in ("-o", name)]
    result = call_lommel("psf", path, "--colour", "--shape", "33", *outputs, "--plot", "p.png", folder=tmp_path)
    assert (result.returncode, result.stderr) == (0, "")
    instrument = lm.load_instrument(path)
    expected = lm.colour_psf(instrument.pupil(), 33, instrument.pixel, instrument.channels)
    for name in ("a.npz", "a.tif"):
        found = lm.ColourPSF.load(tmp_path / name)
        assert found.channels == instrument.channels
        assert np.abs(found.values - expected.values).max() <= 1e-7 * expected.values.max()
    with Image.open(tmp_path / "a.png") as picture:
        assert picture.mode == "RGB"
    assert "440 nm to 630 nm" in result.stdout
    assert result.stdout.split("wrote ")[1:] == ["a.npz\n", "a.tif\n", "a.png\n", "p.png\n"]


def test_a_field_is_in_colour(call_lommel, lenses, tmp_path):
    pytest.importorskip("zarr")
    options = ["--colour", "--field", "2x3", "--shape", "15", "-o", "f.zarr", "-o", "f.mat", "--plot", "f.png"]
    result = call_lommel("psf", lenses["camera-field"], *options, folder=tmp_path)
    assert (result.returncode, result.stderr) == (0, "")
    for name in ("f.zarr", "f.mat"):
        assert lm.PSFGrid.load(tmp_path / name).values.shape == (2, 3, 3, 15, 15)


LENS = """\
[lens]
focal_length = "4.3 mm"
f_number = 1.8
wavelength = "550 nm"

[sensor]
pixel = ["1.22 um", "2.44 um"]
shape = 9
"""


@pytest.fixture
def told(call_lommel, tmp_path):
    """Return what --mtf says as JSON, of a file or of a text."""

    def ask(lens: str | Path, *options: object) -> dict:
        if isinstance(lens, str):
            (tmp_path / "lens.toml").write_text(lens, encoding="utf-8")
        file = "lens.toml" if isinstance(lens, str) else lens
        result = call_lommel("psf", file, "--mtf", "--json", *options, folder=tmp_path)
        assert result.returncode == 0, result.stderr
        return json.loads(result.stdout)["mtf"]

    return ask


def perfect(frequency: float, cutoff: float) -> float:
    f = frequency / cutoff
    return 2.0 / math.pi * (math.acos(f) - f * math.sqrt(1.0 - f * f))


def test_a_perfect_lens_has_the_contrast_of_overlapping_discs_and_of_its_pixels(told):
    found, cutoff = told(LENS), 1.0 / (550e-9 * 1.8)
    down, across = 0.5 / 1.22e-6, 0.5 / 2.44e-6
    assert found["frequency"] == pytest.approx([across, down])
    (row,) = found["rows"]
    assert (row["x"], row["y"], row["channel"]) == (None, None, None)
    for name, share in (("nyquist", 1.0), ("half_nyquist", 0.5)):
        pixel = math.sin(0.5 * math.pi * share) / (0.5 * math.pi * share)
        expected = [pixel * perfect(share * frequency, cutoff) for frequency in (across, down)]
        assert row[name] == pytest.approx(expected, abs=1e-6)


def test_there_is_a_row_for_each_place_and_each_channel(told, lenses, call_lommel, tmp_path):
    file = lenses["camera-field"]
    found = told(file, "--field", "2x3", "--colour", "--shape", "5")
    instrument, channels = lm.load_instrument(file), lm.Channels.rgb()
    field, pixel = instrument.field(), instrument.pixel
    assert [row["channel"] for row in found["rows"]] == list(channels.names) * 6
    for row in found["rows"][3:9]:
        pairs = dict(channels)[row["channel"]]
        light = lm.methods.Polychromatic([w for w, _ in pairs], [share for _, share in pairs])
        expected = lm.mtf(field.pupil(row["x"], row["y"]), 0.0, 0.25 / pixel, pixel=pixel, spectrum=light)
        assert row["half_nyquist"][1] == pytest.approx(float(expected), abs=2e-6)
    shown = call_lommel("psf", file, "--mtf", "--field", "2x3", "--shape", "5", folder=tmp_path).stdout
    assert shown[shown.index("MTF, pixel") :].count("mm  ") >= 6


def overlap_at(height, frequency, tangential):
    """Return the MTF without pixels by the file's coefficients; the frequency is over the cutoff."""
    r = height / math.hypot(12e-3, 18e-3)

    def pupil(x, y):  # x along the radius
        square = x * x + y * y
        waves = 0.4 * square**2 - 0.4 * square + 2.0 * r * square * x + 1.6 * r**2 * x * x - 0.9 * r**2 * square
        return np.where(square <= 1.0, np.exp(2j * math.pi * waves), 0.0)

    return overlap(pupil, *((frequency, 0.0) if tangential else (0.0, frequency)))


def test_sagittal_and_tangential_mtf_are_those_of_radial_lines_and_of_lines_across_them(told, lenses):
    found = told(lenses["camera-field"], "--at", "9mm", "-12mm", "--pixel", "4um", "--shape", "5")
    (row,) = found["rows"]
    pupil = lm.load_instrument(lenses["camera-field"]).pupil()
    for name, across in (("sagittal", (0.8, 0.6)), ("tangential", (0.6, 0.8))):
        for value, share in zip(row[name], (1.0, 0.5), strict=True):
            pixel = math.prod(np.sinc(0.5 * share * part) for part in across)
            expected = pixel * overlap_at(15e-3, share * 125e3 / pupil.cutoff, name == "tangential")
            assert value == pytest.approx(expected, abs=3e-3), name
    assert row["sagittal"][0] > 1.05 * row["tangential"][0]


def test_options_restate_focus_f_number_and_wavelength(call_lommel, lenses, tmp_path):
    path, more = lenses["nifty-fifty"], ("--shape", "33", "-o", "a.npz")
    stated = lm.load_instrument(path)
    known = {name: getattr(stated.lens, name) for name in ("f_number", "wavelength", "focal_length")}
    options = {
        "f_number": ("--f-number", "5.6", 5.6),
        "wavelength": ("--wavelength", "450nm", 450e-9),
    }
    for name, (flag, text, value) in options.items():
        result = call_lommel("psf", path, flag, text, "--focus", "2.5m", *more, folder=tmp_path)
        assert result.returncode == 0, result.stderr
        lens = lm.Lens(**known | {name: value}, focus_distance=2.5)
        expected = lm.psf(lens.pupil(stated.object_distance), 33, stated.pixel, **stated.sensor_options).values
        found = lm.PSF.load(tmp_path / "a.npz").values
        np.testing.assert_allclose(found, expected, atol=2e-6 * expected.max(), err_msg=name)
    # An object in focus stays in focus; one that is stated elsewhere stays where it is.
    for file, seen in ((path, stated.object_distance), (lenses["camera-field"], 2.5)):
        facts = json.loads(call_lommel("info", file, "--focus", "2.5m", "--json", folder=tmp_path).stdout)
        assert facts["object_distance"] == pytest.approx(seen)
        assert facts["focus_distance"] == pytest.approx(2.5)


ARCSEC = math.pi / 648000.0
TELESCOPE = """\
[lens]
focal_length = "8 m"
aperture_diameter = "1 m"
wavelength = "600 nm"
obscuration = 0.3

[sensor]
pixel = "9 um"
"""


@pytest.fixture
def asked(call_lommel, tmp_path):
    (tmp_path / "telescope.toml").write_text(TELESCOPE, encoding="utf-8")
    return lambda *options: call_lommel("psf", "telescope.toml", *options, folder=tmp_path)


def test_the_image_behind_seeing_and_jitter_is_that_of_python(asked, tmp_path):
    options = "--seeing", 1.2, "--jitter", 0.3, "--shape", 25, "--tol", 1e-4, "-o", "seen.npz"
    result = asked(*options)
    assert result.returncode == 0, result.stderr
    assert "seeing of 1.2 arcsec\njitter of 0.3 arcsec\n" in result.stdout
    pupil = lm.load_instrument(tmp_path / "telescope.toml").pupil()
    air = lm.Seeing.from_fwhm(1.2 * ARCSEC, focal_length=8.0)
    blur = air, lm.Jitter(0.3 * ARCSEC * 8.0)
    expected = lm.psf(pupil, 25, 9e-6, blur=blur, tol=1e-4, integrate=True)
    np.testing.assert_array_equal(lm.PSF.load(tmp_path / "seen.npz").values, expected.values)


def test_the_window_holds_the_light_that_seeing_spreads(asked, tmp_path):
    assert asked("--seeing", 2.0, "--tol", 1e-4, "-o", "seen.npz").returncode == 0
    assert lm.PSF.load(tmp_path / "seen.npz").energy > 0.95
