"""One table over field, distance and colour."""

from __future__ import annotations

import math

import h5py
import numpy as np
import pytest
from astropy.io import fits

import lommel as lm
from lommel.io import field_files, registry

WAVES = (450e-9, 550e-9, 650e-9)
COLOUR = lm.Colour(WAVES, [20e-6, 0.0, 15e-6], [4e-6, 0.0, -3e-6], 25e-3)
LENS = lm.Lens(focal_length=50e-3, f_number=4.0, focus_distance=2.0, wavelength=550e-9, colour=COLOUR)
FIELD = lm.FieldMap.from_seidel(25e-3, W131=0.5, W222=0.3, aperture=LENS.pupil(1.0).unaberrated())
WHERE = {"sensor": (16e-3, 24e-3), "shape": (9, 11), "pixel": 3e-6}
DEPTHS = [1.9, 2.1, math.inf]


@pytest.fixture(scope="module")
def table() -> lm.PSFGrid:
    return FIELD.grid(2, 3, **WHERE, channels=WAVES, depths=DEPTHS, lens=LENS)


def test_the_axes_are_field_distance_and_colour(table):
    assert table.values.shape == (2, 3, 3, 3, 9, 11)
    assert table.dims == ("field_y", "field_x", "depth", "channel", "y", "x")
    assert table.depths.tolist() == DEPTHS
    assert table[1, 2].values.shape == (3, 3, 9, 11)
    assert table[1, 2, 0]["450 nm"].values.shape == (9, 11)
    assert table.channel("450 nm").at_depth(-1).values.shape == (2, 3, 9, 11)
    assert len(table) == 2


def test_each_is_that_of_its_place_distance_and_wavelength(table):
    for (i, j), k, c in (((0, 0), 0, 0), ((1, 2), 1, 2), ((0, 1), 0, 1)):
        x, y, wavelength = table.x[j], table.y[i], WAVES[c]
        # By the lens of that colour, the aberrations at the place and the shift of the image, each on its own.
        field = lm.Wavefront.from_seidel(W131=0.5, W222=0.3, field=(x / 25e-3, y / 25e-3))
        lens = LENS.in_light(wavelength)
        away = COLOUR.lateral[0][c] / 25e-3
        tilt = math.pi / (wavelength * lens.working_f_number) * away
        shift = lm.Wavefront(nonradial={(1, 1): tilt * x, (1, -1): tilt * y})
        wavefront = lens.pupil(DEPTHS[k]).wavefront + 550e-9 / wavelength * field + shift
        pupil = lm.Pupil(wavefront, wavelength=wavelength, f_number=lens.working_f_number)
        exact = lm.psf(pupil, (9, 11), 3e-6, tol=1e-9, dtype=np.float64)
        found = table[i, j, k][c]
        assert np.abs(found.values - exact.values).max() <= found.error_bound * exact.values.max() * 1.1


SUFFIXES = [form.suffixes[0] for form in registry.formats("field") if field_files.DEPTHS_OR_CHANNELS in form.holds]


@pytest.mark.parametrize("suffix", SUFFIXES)
def test_files_keep_all_axes(tmp_path, table, suffix):
    pytest.importorskip("zarr")
    for name, grid in (("all", table), ("deep", table.channel(0)), ("coloured", table.at_depth(0))):
        path = tmp_path / f"{name}{suffix}"
        grid.save(path)
        again = lm.PSFGrid.load(path)
        assert np.array_equal(again.values, grid.values)
        assert again.dims == grid.dims
        assert (again.depths is None) == (grid.depths is None)
        assert grid.depths is None or np.array_equal(again.depths, grid.depths)
        assert again.psf.pupil == grid.psf.pupil
        if name != "deep":
            assert again.psf.channels == grid.psf.channels
        with pytest.raises(ValueError, match=r"must end in .zarr, .npy, .npz"):
            grid.save(tmp_path / "grid.tif")


def test_h5py_and_astropy_find_the_axes_by_their_names(tmp_path, table):
    for suffix in (".h5", ".mat", ".fits"):
        table.save(tmp_path / f"t{suffix}")
    with h5py.File(tmp_path / "t.h5") as file:
        values = file["values"]
        assert tuple(axis.label for axis in values.dims) == table.dims
        np.testing.assert_array_equal(values[...], table.values)
        assert values.dims[2][0][...].tolist() == DEPTHS
        assert [name.decode() for name in values.dims[3][0]] == list(table.psf.names)
        np.testing.assert_array_equal(values.attrs["weight"], np.eye(3))
    with h5py.File(tmp_path / "t.mat") as file:  # MATLAB reverses the axes
        np.testing.assert_array_equal(file["values"][...].T, np.moveaxis(table.values, (-2, -1), (0, 1)))
        assert file["depth"][:, 0].tolist() == DEPTHS
        said = file["channel"][:, 0].tobytes().decode("utf-16-le")
        assert said.splitlines() == list(table.psf.names)
    with fits.open(tmp_path / "t.fits") as file:
        header = file[0].header
        assert [header[f"CTYPE{k}"] for k in range(6, 0, -1)] == [name.upper() for name in table.dims]
        assert [header[f"CWAV{k}"] for k in range(3)] == pytest.approx(WAVES)
        assert header["CHAN0"] == "450 nm"
        np.testing.assert_array_equal(file[0].data, table.values)
    table.psf.part((0, 0, 0)).save(tmp_path / "one.mat")
    with h5py.File(tmp_path / "one.mat") as file:  # values(row, column, channel)
        np.testing.assert_array_equal(file["values"][...].T, np.moveaxis(table.values[0, 0, 0], 0, -1))


def test_zarr_is_named_as_others_read_it(tmp_path, table):
    zarr = pytest.importorskip("zarr")
    table.save(tmp_path / "t.zarr")
    group = zarr.open_group(tmp_path / "t.zarr", mode="r")
    assert group["values"].metadata.dimension_names == table.dims
    assert group["values"].chunks == (1, 1, 1, 1, 9, 11)
    assert group["depth"][...].tolist() == DEPTHS
    assert group["channel"].shape == (3,)


def test_an_aplanatic_lens_has_its_distances_in_a_grid():
    lens = lm.Lens(
        focal_length=50e-3, f_number=4.0, focus_distance=2.0, wavelength=550e-9, colour=COLOUR, model="aplanatic"
    )
    field = lm.FieldMap.from_seidel(25e-3, W131=0.5, aperture=lens.pupil(1.0).unaberrated())
    table = field.grid(1, 1, **WHERE, channels=WAVES, depths=[1.9, 2.2], lens=lens)
    for k, s in enumerate((1.9, 2.2)):
        exact = lm.psf(lens.in_light(450e-9).pupil(s), (9, 11), 3e-6, dtype=np.float64)
        assert lm.peak_error(table[0, 0, k][0], exact) < 2e-6
    with pytest.raises(ValueError, match="lens= and depths="):
        field.grid(1, 1, **WHERE, channels=WAVES)


def test_what_does_not_go_together_is_told(table):
    with pytest.raises(ValueError, match="lens is missing"):
        FIELD.grid(1, 1, **WHERE, depths=[1.0])
    with pytest.raises(ValueError, match="depths is missing"):
        FIELD.grid(1, 1, **WHERE, lens=LENS)
    with pytest.raises(ValueError, match="lens must have the working f-number of the map"):
        FIELD.grid(1, 1, **WHERE, lens=LENS.stopped(8.0), depths=[1.0])
    with pytest.raises(ValueError, match="got 400"):
        FIELD.grid(1, 1, **WHERE, channels=[400e-9])
    with pytest.raises(ValueError, match="index must be"):
        table.at_depth(3)
