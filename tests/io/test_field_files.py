"""Grids of PSFs in files: nothing is lost, other programs read them, and what is no such file is told."""

from __future__ import annotations

import dataclasses
import json
import os
import shutil

import h5py
import numpy as np
import pytest
import tifffile
from astropy.io import fits

import lommel as lm
from lommel.io import field_files
from lommel.io.psf_files import FileError

zarr = pytest.importorskip("zarr")

SUFFIXES = (".tif", ".tiff", ".zarr", ".npy", ".npz", ".fits", ".fits.gz", ".h5", ".hdf5", ".mat")
METHOD = lm.paper.Fraunhofer(samples=64)


@pytest.fixture(scope="module")
def grid() -> lm.PSFGrid:
    field = lm.FieldMap.from_seidel(20e-3, W131=1.0, W222=0.5, wavelength=550e-9, f_number=4.0)
    return field.grid(2, 3, sensor=(20e-3, 30e-3), shape=(9, 8), pixel=2e-6, method=METHOD, dtype="float64")


@pytest.fixture(scope="module")
def bare() -> lm.PSFGrid:
    """A single one, in units of lambda*N."""
    field = lm.FieldMap.from_seidel(2.0, W131=1.0)
    return field.grid(1, 1, sensor=(1, 1), shape=5, pixel=0.5, method=METHOD, normalize="peak")


@pytest.mark.parametrize("suffix", SUFFIXES)
@pytest.mark.parametrize("name", ["grid", "bare"])
def test_a_grid_comes_back_as_it_was_saved(suffix, name, tmp_path, request):
    saved = request.getfixturevalue(name)
    path = tmp_path / f"field{suffix}"
    saved.save(str(path))
    loaded = lm.PSFGrid.load(path)
    for part in ("values", "x", "y"):
        one, other = getattr(loaded, part), getattr(saved, part)
        assert one.dtype == other.dtype
        np.testing.assert_array_equal(one, other)
    assert loaded.sensor == saved.sensor
    assert (loaded.psf.pupil, loaded.psf.grid, loaded.psf.method) == (saved.psf.pupil, saved.psf.grid, METHOD)
    assert (loaded.psf.normalize, loaded.unit) == (saved.psf.normalize, saved.unit)
    np.testing.assert_array_equal(loaded.psf.scale, saved.psf.scale)
    assert {file.stem for file in tmp_path.iterdir()} == {path.stem if suffix != ".fits.gz" else "field.fits"}


def test_a_grid_of_axes_of_their_own_is_kept_by_formats_that_have_a_place_for_them(tmp_path):
    field = lm.FieldMap.from_seidel(20e-3, W131=1.0, wavelength=550e-9, f_number=4.0)
    rows, columns = np.array([[3.75], [4.25]]), np.array([3.5, 4.0, 4.625])
    grid = field.grid(2, 3, sensor=(20e-3, 30e-3), shape=9, pixel=2e-6, center=(rows, columns))
    for suffix in (".tif", ".npz", ".fits", ".h5", ".mat"):
        grid.save(tmp_path / f"a{suffix}")
        loaded = lm.PSFGrid.load(tmp_path / f"a{suffix}")
        np.testing.assert_array_equal(loaded.values, grid.values)
        np.testing.assert_array_equal(loaded.psf.grid.center, grid.psf.grid.center)
    with pytest.raises(ValueError, match=r"path must not end in .zarr if each PSF has its own center"):
        grid.save(tmp_path / "a.zarr")
    assert not (tmp_path / "a.zarr").exists()


def test_h5py_and_astropy_find_where_each_psf_is(grid, tmp_path):
    for suffix in (".h5", ".mat", ".fits"):
        grid.save(tmp_path / f"a{suffix}")
    with h5py.File(tmp_path / "a.h5") as file:
        assert [dimension.label for dimension in file["values"].dims] == ["field_y", "field_x", "y", "x"]
        np.testing.assert_array_equal(file["values"].dims[1][0][...], grid.x)
        np.testing.assert_array_equal(file["values"][...], grid.values)
    with h5py.File(tmp_path / "a.mat") as file:
        np.testing.assert_array_equal(file["field_y"][:, 0], grid.y)
        np.testing.assert_array_equal(file["x"][:, 0], grid.psf.grid.x)
    header = fits.getheader(tmp_path / "a.fits")
    assert (header["CTYPE3"], header["CTYPE4"]) == ("FIELD_X", "FIELD_Y")
    places = (np.arange(1, 4) - header["CRPIX3"]) * header["CDELT3"]
    np.testing.assert_allclose(places, grid.x, atol=1e-12)


def test_tifffile_reads_a_page_for_each_psf_with_its_position(grid, tmp_path):
    grid.save(tmp_path / "a.tif")
    with tifffile.TiffFile(tmp_path / "a.tif") as file:
        assert len(file.pages) == 6
        assert file.series[0].axes == "RYX"
        np.testing.assert_array_equal(file.asarray(), grid.values.reshape(6, 9, 8))
        pixels = tifffile.xml2dict(file.ome_metadata)["OME"]["Image"]["Pixels"]
    assert pixels["PhysicalSizeX"] == pytest.approx(2.0)
    planes = pixels["Plane"]
    assert {plane["PositionXUnit"] for plane in planes} == {"µm"}
    for (i, j), plane in zip(np.ndindex(2, 3), planes, strict=True):
        assert plane["PositionX"] == pytest.approx(1e6 * grid.x[j])
        assert plane["PositionY"] == pytest.approx(1e6 * grid.y[i])


def test_zarr_reads_values_and_a_coordinate_for_each_dimension(grid, tmp_path):
    grid.save(tmp_path / "a.zarr")
    group = zarr.open_group(tmp_path / "a.zarr", mode="r")
    assert group.metadata.zarr_format == 3
    values = group["values"]
    assert values.metadata.dimension_names == ("field_y", "field_x", "y", "x")
    assert values.chunks == (1, 1, 9, 8)
    np.testing.assert_array_equal(values[1, 2], grid.values[1, 2])
    for name, expected in {"field_y": grid.y, "field_x": grid.x, "y": grid.psf.grid.y, "x": grid.psf.grid.x}.items():
        np.testing.assert_array_equal(group[name][...], expected)
        assert group[name].metadata.dimension_names == (name,)
        assert group[name].attrs["units"] == "m"
    assert group.attrs["lommel"]["method"]["name"] == "Fraunhofer"


@pytest.mark.parametrize("kind", ["file", "folder"])
def test_what_is_no_zarr_store_is_not_replaced_by_one(grid, kind, tmp_path):
    path = tmp_path / "a.zarr"
    if kind == "file":
        path.write_text("mine")
    else:
        path.mkdir()
        (path / "photo").write_text("mine")
    with pytest.raises(ValueError, match=r"must be new or a Zarr store, got .*a\.zarr"):
        grid.save(path)
    assert (path if kind == "file" else path / "photo").read_text() == "mine"


@pytest.mark.parametrize("suffix", [".tif", ".npz"])
def test_a_stack_without_positions_is_no_grid(grid, suffix, tmp_path):
    path = tmp_path / f"stack{suffix}"
    grid.psf.save(path)
    with pytest.raises(FileError, match="not a grid of PSFs: no positions"):
        lm.PSFGrid.load(path)


def damage(path, change) -> None:
    """Change the description in a .zarr."""
    file = path / "zarr.json"
    whole = json.loads(file.read_text())
    change(whole["attributes"]["lommel"])
    file.write_text(json.dumps(whole))


@pytest.mark.parametrize(
    "change",
    [
        lambda d: d["field"].update(x=[0.0, 1.0]),
        lambda d: d["field"].update(x=[0.0, 1.0, "a"]),
        lambda d: d["field"].update(sensor=[1.0]),
        lambda d: d["field"].update(sensor=[1.0, -1.0]),
        lambda d: d.update(field=5),
        lambda d: d.update(shape=[2, 3, 9, 9]),
        lambda d: d.pop("pupil"),
        lambda d: d.pop("field"),
    ],
)
def test_a_damaged_description_is_told_with_the_file(grid, change, tmp_path):
    grid.save(tmp_path / "a.zarr")
    damage(tmp_path / "a.zarr", change)
    with pytest.raises(FileError, match=r"a\.zarr is not a grid of PSFs"):
        lm.PSFGrid.load(tmp_path / "a.zarr")


@pytest.mark.parametrize("lost", ["zarr.json", "values"])
def test_a_zarr_store_that_lacks_a_part_is_told(grid, lost, tmp_path):
    grid.save(tmp_path / "a.zarr")
    part = tmp_path / "a.zarr" / lost
    shutil.rmtree(part) if part.is_dir() else part.unlink()
    with pytest.raises(FileError, match=r"a\.zarr is not a grid of PSFs"):
        lm.PSFGrid.load(tmp_path / "a.zarr")


def test_derivatives_go_into_npz_and_hdf5_only(grid, tmp_path):
    psf = dataclasses.replace(grid.psf, derivatives={(3, -1): 2.0 * grid.values})
    with_slopes = dataclasses.replace(grid, psf=psf)
    for suffix in (".tif", ".zarr"):
        with pytest.raises(ValueError, match=r"must end in \.npz, \.h5, \.hdf5 for a grid of PSFs with derivatives"):
            with_slopes.save(tmp_path / f"a{suffix}")
    with_slopes.save(tmp_path / "a.npz")
    loaded = lm.PSFGrid.load(tmp_path / "a.npz")
    np.testing.assert_array_equal(loaded.psf.derivatives[3, -1], 2.0 * grid.values)


def test_a_zarr_store_needs_no_zarr(grid, tmp_path, monkeypatch):
    monkeypatch.setitem(__import__("sys").modules, "zarr", None)
    field_files.save(grid, tmp_path / "a.zarr")
    np.testing.assert_array_equal(lm.PSFGrid.load(tmp_path / "a.zarr").values, grid.values)


@pytest.mark.parametrize("what", ["values", "positions", "pipe", "missing"])
def test_a_damaged_zarr_store_is_refused(what, tmp_path):
    grid = lm.FieldMap.from_seidel(1.0, W131=0.5).grid(2, 2, sensor=(1.0, 1.0), shape=5, pixel=0.5)
    store = tmp_path / "a.zarr"
    grid.save(store)
    np.testing.assert_array_equal(lm.PSFGrid.load(store).values, grid.values)
    chunk = next(path for path in (store / "values").glob("c.*"))
    if what == "values":
        data = bytearray(chunk.read_bytes())
        data[5] ^= 1
        chunk.write_bytes(data)
    elif what == "positions":
        meta = store / "zarr.json"
        meta.write_text(meta.read_text().replace('"sensor": [\n', '"sensor": [\n2.', 1))
    else:
        chunk.unlink()
        if what == "pipe":
            os.mkfifo(chunk)
    with pytest.raises(FileError, match=r"checksum|regular|bytes|grid of PSFs written by lommel"):
        lm.PSFGrid.load(store)
