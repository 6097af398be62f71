"""Spectra of sensors, filters and light from CSV files."""

from __future__ import annotations

import numpy as np
import pytest

import lommel as lm
from lommel.base.units import LENGTHS
from lommel.lensfiles import tables

WAVES = np.arange(400, 701, 20)


def bell(center: float, width: float = 35.0, waves: np.ndarray = WAVES) -> np.ndarray:
    return np.exp(-0.5 * ((waves - center) / width) ** 2)


def write(path, head, *columns, separator=",", comma="."):
    rows = [separator.join(f"{value:.6g}".replace(".", comma) for value in row) for row in zip(*columns, strict=True)]
    path.write_text("\n".join([head, "# measured", "", *rows]) + "\n")
    return path


@pytest.fixture
def sensor(tmp_path):
    return write(tmp_path / "sensor.csv", "wavelength (nm),red,green,blue", WAVES, bell(600), bell(540), bell(460))


def test_a_table_is_read_as_it_is(sensor):
    found = lm.load_channels(sensor)
    expected = lm.Channels.from_curves(WAVES * 1e-9, [bell(c) for c in (600, 540, 460)])
    assert found.names == ("red", "green", "blue")
    assert found.wavelengths == pytest.approx(expected.wavelengths, rel=1e-5)
    assert np.array(found.weights) == pytest.approx(np.array(expected.weights), abs=1e-4)
    assert found.light == pytest.approx(expected.light, rel=1e-4)


@pytest.mark.parametrize(
    ("head", "unit"),
    [
        ("wavelength (nm)", "nm"),
        ("Lambda_um", "um"),
        ("nm", "nm"),
        ("λ [µm]", "µm"),
        ("wavelength nm", "nm"),
        ("wl(NM)", "nm"),
    ],
)
def test_the_unit_is_what_the_header_says(tmp_path, sensor, head, unit):
    waves = WAVES * 1e-9 / LENGTHS[unit]
    path = write(tmp_path / "other.csv", f"{head},red,green,blue", waves, bell(600), bell(540), bell(460))
    assert lm.load_channels(path).wavelengths == pytest.approx(lm.load_channels(sensor).wavelengths, rel=1e-5)


def test_per_cent_semicolons_tabs_and_any_order_are_read(tmp_path, sensor):
    turned = [column[::-1] for column in (WAVES, 100.0 * bell(600), bell(540), 100.0 * bell(460))]
    expected = lm.load_channels(sensor)
    for separator, comma in ((";", ","), ("\t", ".")):
        head = separator.join(["wavelength (nm)", "red (%)", "green", "blue [%]"])
        found = lm.load_channels(write(tmp_path / "c.csv", head, *turned, separator=separator, comma=comma))
        assert found.names == expected.names
        assert found.light == pytest.approx(expected.light, rel=1e-4)


def test_filters_and_light_multiply(tmp_path, sensor):
    fine = np.arange(380, 651, 5)
    cut = write(tmp_path / "cut.csv", "wavelength (nm),ir", fine, np.clip((620 - fine) / 40.0, 0.0, 1.0))
    lamp = write(tmp_path / "lamp.csv", "wavelength (um),light", np.array([0.35, 0.9]), np.array([1.0, 6.5]))
    found = lm.load_channels(sensor, filters=cut, illuminant=lamp)
    dense = np.linspace(400, 650, 20001)
    product = np.interp(dense, fine, np.clip((620 - fine) / 40.0, 0.0, 1.0)) * (1.0 + 5.5 * (dense - 350) / 550)
    for center, (_, pairs), light in zip((600, 540, 460), found, found.light, strict=True):
        curve = product * np.interp(dense, WAVES, bell(center))
        waves, weights = np.array(pairs).T
        assert weights @ waves == pytest.approx(1e-9 * (curve @ dense) / curve.sum(), rel=1e-3)
        assert light == pytest.approx(curve.sum() / max(
            (product * np.interp(dense, WAVES, bell(c))).sum() for c in (600, 540, 460)), rel=2e-3)  # fmt: skip
    assert lm.load_channels(sensor, filters=[cut, cut]).light[0] < lm.load_channels(sensor, filters=[cut]).light[0]


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("wavelength,red\n400,1\n500,1", "line 1: the first column must be the wavelength with its unit"),
        ("wavelength (furlong),red\n400,1\n500,1", "with its unit"),
        ("nm,red,red\n400,1,1\n500,1,1", "line 1: columns must have different names"),
        ("nm,red\n400,1\n500,1,2\n600", "line 3 must have 2 cells, .* got 3; line 4 must have 2 cells, .* got 1"),
        ("nm,red\n400,1\n400,2", "wavelength 400 nm occurs twice"),
        ("nm,red\n400,1\n500,-1", "red must be >= 0, got -1"),
        ("nm,red\n99,1\n500,1", "wavelengths must be from 100 nm to 20 um, got 99 nm"),
        ("nm,red\n100,1\n20000,1", "tol=0.001 takes more than 256 wavelengths|weights of .* are not found"),
    ],
)
def test_damaged_files_are_told_in_one_line(tmp_path, text, message):
    path = tmp_path / "bad.csv"
    path.write_text(text)
    with pytest.raises(ValueError, match=message) as told:
        lm.load_channels(path)
    assert "\n" not in str(told.value)
    assert "bad.csv" in str(told.value)


def test_tables_that_do_not_meet_are_told(tmp_path, sensor):
    far = write(tmp_path / "far.csv", "nm,t", np.array([800.0, 900.0]), np.ones(2))
    with pytest.raises(ValueError, match="wavelengths in common, got 400 to 700 nm, 800 to 900 nm"):
        lm.load_channels(sensor, filters=far)
    with pytest.raises(ValueError, match=r"sensor.csv must have one column besides the wavelength"):
        lm.load_channels(sensor, illuminant=sensor)


def star(tmp_path, waves: np.ndarray):
    """Write a passband in blanks and angstrom, and a spectrum as a FITS table."""
    band = tmp_path / "V.dat"
    rows = zip(waves * 1e10, bell(545e-9, 30e-9, waves), strict=True)
    band.write_text("# throughput\n" + "\n".join(f"{at:.3f}   {value:.9f}" for at, value in rows))
    fits = pytest.importorskip("astropy.io.fits")
    flux = (waves / 500e-9) ** -2.0
    columns = [
        fits.Column("WAVELENGTH", "D", unit="ANGSTROMS", array=waves * 1e10),
        fits.Column("NOTE", "3A", array=np.full(waves.size, "ok")),
        fits.Column("FLUX", "D", unit="FLAM", array=flux),
    ]
    fits.HDUList([fits.PrimaryHDU(), fits.BinTableHDU.from_columns(columns)]).writeto(tmp_path / "star.fits")
    return band, tmp_path / "star.fits"


@pytest.mark.parametrize(
    ("light", "detector", "power"),
    [("photons", "photons", 0), ("energy", "photons", 1), ("frequency", "photons", -1), ("energy", "energy", 0)],
)
def test_a_star_through_a_passband_is_weighted_by_what_is_counted(tmp_path, light, detector, power):
    waves = np.linspace(450e-9, 650e-9, 101)
    band, spectrum = star(tmp_path, waves)
    found = lm.load_channels(
        band, illuminant=spectrum, light=light, detector=detector, unit="angstrom", tol=1e-4, paths=3e-6
    )
    assert found.names == ("V",)
    assert found.error <= 1e-4
    dense = np.linspace(450e-9, 650e-9, 40_001)
    counted = np.interp(dense, waves, bell(545e-9, 30e-9, waves)) * np.interp(dense, waves, (waves / 5e-7) ** -2.0)
    counted *= dense**power
    mean = np.average(found.wavelengths, weights=found.weights[0])
    assert mean == pytest.approx(float(np.trapezoid(counted * dense, dense) / np.trapezoid(counted, dense)), rel=1e-4)
    # The sum over wavelengths differs from the integral by no more than is stated, for every path difference.
    path = np.linspace(0.0, 3e-6, 301)
    bright = counted / dense**2
    exact = np.exp(2j * np.pi * np.multiply.outer(path, 1.0 / dense)) @ (bright / bright.sum())
    at, share = np.array(found.wavelengths), np.array(found.weights[0])
    total = float(bright.sum() / counted.sum())
    sums = np.exp(2j * np.pi * np.multiply.outer(path, 1.0 / at)) @ (share / at**2 / total)
    assert np.abs(sums - exact).max() <= found.error + 1e-6


def test_the_image_of_a_star_through_a_passband_is_within_the_error(tmp_path):
    band, spectrum = star(tmp_path, np.linspace(500e-9, 600e-9, 51))
    options = {"illuminant": spectrum, "light": "energy", "unit": "angstrom", "paths": 1e-6}
    few, many = (lm.load_channels(band, tol=tol, **options) for tol in (1e-3, 1e-6))
    assert len(few.wavelengths) < len(many.wavelengths)
    telescope = lm.Pupil(lm.Wavefront(0.5), wavelength=550e-9, f_number=10.0)
    air = lm.Seeing(0.1, focal_length=4.0, wavelength=500e-9)
    images = [
        lm.psf(
            telescope,
            9,
            5e-6,
            method=lm.methods.Polychromatic(each.wavelengths, each.weights[0]),
            blur=air,
            normalize="strehl",
            dtype="float64",
            tol=1e-8,
        ).values
        for each in (few, many)
    ]
    assert np.abs(images[0] - images[1]).max() <= few.error + many.error


@pytest.mark.parametrize(
    ("content", "options", "message"),
    [
        (b"5000 0.1\n6000 0.2\n", {}, "states no unit of wavelengths"),
        (b"5000 0.1\n6000 0.2 3\n", {"unit": "angstrom"}, "must have 2 cells"),
        (b"SIMPLE  = nothing", {}, "channels.dat"),
    ],
)
def test_what_is_wrong_with_a_table_of_numbers_is_said(tmp_path, content, options, message):
    path = tmp_path / "channels.dat"
    path.write_bytes(content)
    with pytest.raises(ValueError, match=message):
        lm.load_channels(path, **options)


@pytest.mark.parametrize("limit", [0.999, 1.001])
def test_lines_between_points_are_finer_until_twice_their_error_is_small(limit):
    def parabolas(waves):
        return np.stack([waves**2, 3.0 + 0.0 * waves])

    points = np.array([0.0, 0.25, 1.0])
    found = {}
    for waves in (points, np.array([0.0, 0.125, 0.25, 0.625, 1.0])):
        light, step = np.trapezoid(waves**2, waves), np.diff(waves)
        # Half way a parabola is below its chord by a quarter of the square of the step.
        found[waves.size] = 2.0 * np.sum(step**3 / 4.0) / light
    waves, values, error = tables._refined(parabolas, points, limit * found[3])
    assert waves.size == (5 if limit < 1.0 else 3)
    assert error == pytest.approx(found[waves.size], rel=1e-12)
    np.testing.assert_array_equal(values, parabolas(waves))
    assert tables._refined(lambda waves: 0.0 * parabolas(waves), points, 0.1)[2] == 0.0


def test_the_error_of_lines_is_part_of_the_tolerance(tmp_path, sensor, monkeypatch):
    (tmp_path / "filter.csv").write_text("nm,t\n400,1\n700,1\n")
    share, limits = [0.0], []

    def lines(product_at, points, most):
        limits.append(most)
        return points, product_at(points), share[0]

    monkeypatch.setattr(tables, "_refined", lines)
    options = {"filters": tmp_path / "filter.csv", "tol": 1e-2, "paths": 1e-6}
    plain = lm.load_channels(sensor, **options)
    assert plain.error == lm.load_channels(sensor, tol=1e-2, paths=1e-6).error > 1e-4
    share[0] = 4e-3
    assert lm.load_channels(sensor, **options).error == pytest.approx(
        lm.load_channels(sensor, tol=6e-3, paths=1e-6).error + 4e-3, rel=1e-9
    )
    assert limits == pytest.approx([1e-3, 1e-3])
    share[0] = 1e-2
    with pytest.raises(ValueError, match=r"tol=0\.01 is too small for products of these tables; give 0\.02"):
        lm.load_channels(sensor, **options)
    with pytest.raises(ValueError, match="tol must be"):
        lm.load_channels(tmp_path / "none.csv", tol=0.9)
    assert lm.load_channels(sensor, paths=1e-6) == lm.load_channels(sensor, tol=1e-3, paths=1e-6)
