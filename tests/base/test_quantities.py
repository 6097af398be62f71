"""Units of astropy, pint, unyt and xarray, and labelled axes, of what is given as a number or an array."""

from __future__ import annotations

import numpy as np
import pytest

import lommel as lm
from lommel.base.quantities import in_unit

LENS = lm.Lens(focal_length=50e-3, f_number=1.8, focus_distance=2.0, wavelength=550e-9)
SQUARE = np.arange(12.0).reshape(3, 4)


def refused(unit: str, value: object, words: str) -> None:
    with pytest.raises(ValueError, match=rf"^side must {words}"):
        in_unit("side", value, unit)


def test_quantities_of_astropy_are_in_the_unit_of_the_argument():
    u = pytest.importorskip("astropy.units")
    assert np.array_equal(in_unit("side", [1.5, 2.0] * u.mm, "metres"), [1.5e-3, 2.0e-3])
    assert in_unit("side", 50 / u.mm, "1/metres") == pytest.approx(5e4)
    assert in_unit("side", 90 * u.deg, "radians") == pytest.approx(np.pi / 2)
    assert in_unit("side", 3 * u.mm, "nm") == pytest.approx(3e6)
    assert in_unit("side", [1 * u.mm, 2.0 * u.m], "metres") == pytest.approx([1e-3, 2.0])
    assert in_unit("side", 25 * u.percent, "") == pytest.approx(0.25)
    for value, got in ((1 * u.s, "s"), (2 * u.one, "none"), (3 * u.percent, "%"), (1 / u.m, "1 / m")):
        refused("metres", value, f"be in metres, got the unit {got}$")
    refused("lambda*N", 3 * u.um, r"be in lambda\*N, got the unit um")
    refused("electrons per count", 3 * u.electron, "be in electrons per count, got the unit electron$")
    assert lm.Noise(white=1.2 * u.electron / u.adu, read=3 * u.electron).white == pytest.approx(1.2)
    refused("counts", 3 * u.electron / u.s, "be in counts .*, got the unit electron / s")
    assert in_unit("side", 50 * u.cycle / u.mm, "1/metres") == pytest.approx(5e4)
    gain = lm.Noise(white=0.5, read=3.0)
    with pytest.raises(ValueError, match=r"^images must be in counts with a noise that states white, got electrons"):
        lm.retrieve(SQUARE * u.electron, lm.Pupil(), pixel=0.5, noise=gain, defocus=1.0)
    with pytest.raises(ValueError, match=r"^offset must be in levels of the camera .*, got the unit electron"):
        lm.Noise(read=3.0, offset=100 * u.electron)


def test_columns_and_images_of_astropy_keep_their_mask_in_another_unit():
    nddata, table = pytest.importorskip("astropy.nddata"), pytest.importorskip("astropy.table")
    image = nddata.CCDData(SQUARE, unit="nm", mask=SQUARE > 10.0)
    values = lm.OPDMap(image, spacing=1e-3).values
    assert values[0] == pytest.approx(1e-9 * SQUARE[0])
    assert np.isnan(values[2, 3])
    assert np.array_equal(in_unit("side", table.Column([1.0, 2.0], unit="mm"), "metres"), [1e-3, 2e-3])
    hidden = in_unit("side", table.MaskedColumn([1.0, 2.0], mask=[0, 1], unit="mm"), "metres")
    assert hidden.mask.tolist() == [False, True]


@pytest.mark.parametrize("name", ["pint", "unyt"])
def test_quantities_of_pint_and_unyt_are_in_the_unit_of_the_argument(name):
    library = pytest.importorskip(name)
    unit = library.UnitRegistry() if name == "pint" else library
    assert np.array_equal(in_unit("side", [1.5, 2.0] * unit.mm, "metres"), [1.5e-3, 2.0e-3])
    assert in_unit("side", 50 / unit.mm, "1/metres") == pytest.approx(5e4)
    if name == "pint":  # to which a cycle is 2 pi
        assert in_unit("side", 50 * unit.cycle / unit.mm, "1/metres") == pytest.approx(5e4)
    assert in_unit("side", 90 * unit.degree, "radians") == pytest.approx(np.pi / 2)
    refused("metres", 1 * unit.s, "be in metres, got the unit s")
    refused("metres", 20 * unit.degC, "be in metres, got the unit") if name == "unyt" else None


def test_rows_and_columns_of_labelled_arrays_are_put_in_order():
    xr = pytest.importorskip("xarray")
    image = xr.DataArray(SQUARE, dims=("y", "x"))
    stack = xr.DataArray(SQUARE.reshape(1, 3, 4), dims=("z", "row", "column"))
    for given, right in ((image, SQUARE), (image.T, SQUARE), (stack.transpose("column", "z", "row"), SQUARE[None])):
        assert np.array_equal(in_unit("side", given), right)
    movie = xr.DataArray(np.arange(24.0).reshape(2, 3, 1, 4), dims=("z", "channel", "y", "x"))
    assert np.array_equal(in_unit("side", movie), movie.values.swapaxes(0, 1))  # channels before planes
    assert np.array_equal(in_unit("side", xr.DataArray(SQUARE)), SQUARE)  # names by default
    refused("", xr.DataArray(SQUARE, dims=("z", "x")), "have one axis of rows and one of columns, got the axes z, x")
    refused("", xr.DataArray(SQUARE, dims=("a", "b")), "have axes named y and x")
    lines = xr.DataArray([550.0, 600.0], dims="line", attrs={"units": "nanometers"})
    assert in_unit("side", lines, "metres") == pytest.approx([550e-9, 600e-9])
    refused("metres", xr.DataArray(1.0, attrs={"units": "furlong"}), "be in metres, got the unit furlong")


def test_columns_with_names_are_no_axes():
    pandas = pytest.importorskip("pandas")
    with pytest.raises(ValueError, match=r"^places has columns named x, y"):
        in_unit("places", pandas.DataFrame({"x": [1.0], "y": [2.0]}))
    assert in_unit("places", pandas.DataFrame([[1.0, 2.0]])).shape == (1, 2)


def test_lengths_frequencies_and_maps_with_units_are_those_in_metres():
    u = pytest.importorskip("astropy.units")
    right = LENS.pupil([1.0, 1.5]).wavefront.defocus
    assert LENS.pupil([1000.0, 1500.0] * u.mm).wavefront.defocus == pytest.approx(right)
    assert lm.mtf(LENS.pupil(1.9), 50 / u.mm) == pytest.approx(lm.mtf(LENS.pupil(1.9), 5e4))
    sampled = lm.psf(LENS.pupil(1.9), 5, 3.45 * u.um)
    assert sampled.values == pytest.approx(lm.psf(LENS.pupil(1.9), 5, 3.45e-6).values)
    assert lm.mtf(LENS.pupil(1.9), 5e4, pixel=3 * u.um) == pytest.approx(lm.mtf(LENS.pupil(1.9), 5e4, pixel=3e-6))
    with pytest.raises(ValueError, match=r"^pixel must be in lambda\*N, got the unit um"):
        lm.psf(lm.Pupil(), 5, 3.45 * u.um)
    term = lm.Wavefront.zernike({4: 100.0 * u.nm}, order="noll", unit="um", wavelength=5e-7)
    assert term.to_zernike(order="noll", unit="waves")[4] == pytest.approx(0.2)
    chart = lm.opd_map(lm.Wavefront(1.0), 24, unit="radians")
    found = lm.fit_opd(chart * u.um, unit="nm", wavelength=550e-9, degree=3)
    assert found.wavefront.defocus == pytest.approx(2e-6 * np.pi / 550e-9)


def test_a_map_with_a_unit_is_fitted_without_another_statement_of_it():
    u = pytest.importorskip("astropy.units")
    xr = pytest.importorskip("xarray")
    chart = lm.opd_map(lm.Wavefront(1.0), 24)
    for path in (chart * u.nm, [chart * u.nm], xr.DataArray(chart, dims=("y", "x"), attrs={"units": "nm"})):
        found = lm.fit_opd(path, wavelength=550e-9, degree=3)
        assert found.unit == "metres"
        assert found.wavefront.defocus == pytest.approx(2e-9 * np.pi / 550e-9)
    found = lm.fit_opd(np.rad2deg(chart) * u.deg, degree=3)
    assert (found.unit, found.wavefront.defocus) == ("radians", pytest.approx(1.0))
    for other, error, words in (
        (chart, TypeError, "unless opd is"),
        (chart * u.s, ValueError, "^opd must be in metres"),
    ):
        with pytest.raises(error, match=words):
            lm.fit_opd(other, wavelength=550e-9, degree=3)


def test_sizes_in_pixels_are_integers():
    u = pytest.importorskip("astropy.units")
    for shape, right in ((5 * u.pix, (5, 5)), ((3 * u.pix, 5), (3, 5)), ([3, 5] * u.pix, (3, 5))):
        assert lm.psf(lm.Pupil(), shape, 0.5).values.shape == right
    for shape in (5.5 * u.pix, 5 * u.mm, np.inf * u.pix):
        with pytest.raises((TypeError, ValueError), match=r"^shape must be"):
            lm.psf(lm.Pupil(), shape, 0.5)
