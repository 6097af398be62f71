"""Stacks that are read: every kind of pupil, by index and xarray, and what is damaged is told."""

from __future__ import annotations

import json
import shutil
import warnings
from pathlib import Path

import numpy as np
import pytest

import lommel as lm
from lommel.io.psf_files import FileError
from objectives import WATER_60X

pytest.importorskip("zarr")

LENS = lm.Lens(focal_length=50e-3, f_number=2.8, focus_distance=2.0, wavelength=550e-9)
FIELD = lm.FieldMap.from_seidel(20e-3, W131=1.0, W222=0.5, aperture=LENS.pupil(2.0).unaberrated())
X, Y, DISTANCES = np.linspace(-9e-3, 9e-3, 3), np.array([0.0, 6e-3]), np.array([1.8, 2.0, 2.5, np.inf])
OIL = WATER_60X


def table() -> list[lm.Pupil]:
    """A field at each distance."""
    return [(FIELD + LENS.pupil(float(s)).wavefront).pupil(X, Y[:, None]) for s in DISTANCES]


@pytest.fixture(scope="module")
def fields(tmp_path_factory) -> Path:
    """A store."""
    path = tmp_path_factory.mktemp("fields") / "a.zarr"
    axes = {"object_distance": DISTANCES, "field_y": Y, "field_x": X}
    lm.psf_to(path, table(), (7, 8), 3e-6, axes=axes, chunk=4)
    return path


def test_a_table_over_field_and_distance_is_that_of_single_calls(fields):
    stack = lm.open_stack(fields)
    assert stack.shape == (4, 2, 3, 7, 8)
    assert len(stack) == 4
    for index in ((0, 0, 0), (1, 1, 2), (3, 0, 1)):
        one, known = stack[index], table()[index[0]][index[1:]]
        assert one.pupil == known
        asked = lm.psf(known, (7, 8), 3e-6)
        assert lm.peak_error(one, asked) <= one.error_bound + asked.error_bound
        assert one.grid == asked.grid
        assert (one.sampling, one.energy) == ("pixel", pytest.approx(asked.energy))


@pytest.mark.parametrize(
    "index",
    [0, -1, slice(1, 3), (slice(None), 1), (2, slice(None), [0, 2]), (..., 0), np.array([3, 0]), ([0, 3], 1, [2, 0])],
)
def test_an_index_is_that_of_numpy(index, fields):
    stack = lm.open_stack(fields)
    whole = stack[:]
    part = stack[index]
    np.testing.assert_array_equal(part.values, whole[index].values)
    assert part.pupil == whole[index].pupil
    np.testing.assert_array_equal(part.scale, whole[index].scale)


def test_what_is_not_there_or_nothing_is_told(fields):
    stack = lm.open_stack(fields)
    with pytest.raises(IndexError):
        stack[4]
    with pytest.raises(ValueError, match="got 0 PSFs of"):
        stack[4:]


def test_xarray_sees_the_values_with_names_and_units(fields):
    xarray = pytest.importorskip("xarray")
    stack, data = lm.open_stack(fields), xarray.open_zarr(fields, consolidated=False)
    names = ("object_distance", "field_y", "field_x", "y", "x")
    assert data["values"].dims == names
    assert {name: data[name].attrs["units"] for name in names} == dict.fromkeys(names, "m")
    near = data["values"].sel(object_distance=2.1, field_y=0.0, method="nearest").isel(field_x=1)
    np.testing.assert_array_equal(near.values, stack[1, 0, 1].values)
    assert float(near.x[4]) == float(near.y[3]) == 0.0
    np.testing.assert_array_equal(data["error_bound"].values, stack.error_bound)


def test_colours_are_listed_and_taken_one_by_one(tmp_path):
    pupils = [LENS.pupil(DISTANCES[:3]).in_light(light) for light in (450e-9, 550e-9)]
    stack = lm.psf_to(
        tmp_path / "a.zarr", pupils, 7, 3e-6, axes={"wavelength": [450e-9, 550e-9], "object_distance": DISTANCES[:3]}
    )
    for k, pupil in enumerate(pupils):
        np.testing.assert_array_equal(stack[k].values, lm.psf(pupil, 7, 3e-6).values)
        assert stack[k].pupil == pupil
    with pytest.raises(
        ValueError, match=r"pupils of the first axis differ in more than phase; choose one by stack\[k\]"
    ):
        stack[:, 0]


def test_pupils_of_one_light_may_be_listed_one_by_one(tmp_path):
    listed = lm.psf_to(tmp_path / "a.zarr", [LENS.pupil(float(s)) for s in DISTANCES], 7, 3e-6)
    stack = lm.psf_to(tmp_path / "b.zarr", LENS.pupil(DISTANCES), 7, 3e-6)
    assert listed.done == (1, 1)
    assert list(listed.axes) == ["object_distance"]
    np.testing.assert_array_equal(listed[:].values, stack[:].values)
    assert listed[:].pupil == stack[:].pupil
    # And the second call takes what the first has made.
    assert lm.psf_to(tmp_path / "b.zarr", [LENS.pupil(float(s)) for s in DISTANCES], 7, 3e-6).done == (1, 1)


def test_listed_pupils_that_do_not_fit_are_told(tmp_path):
    blue = LENS.pupil(2.0).in_light(450e-9)
    with pytest.raises(ValueError, match="center must be one"):
        lm.psf_to(tmp_path / "a.zarr", [LENS.pupil(2.0), blue], 7, 3e-6, center=([3.0, 3.5], 3.0))
    with pytest.raises(
        ValueError, match=r"pupils must all have the same wavefront terms, got other terms for pupils\[1\]"
    ):
        lm.psf_to(tmp_path / "a.zarr", [lm.Pupil(), lm.Pupil(lm.Wavefront(nonradial={(3, 1): 1.0}))], 7, 0.5)
    with pytest.raises(ValueError, match=r"pupils must all have the unit of the first, m, got lambda\*N"):
        lm.psf_to(tmp_path / "a.zarr", [blue, lm.Pupil()], 7, 0.5)


@pytest.mark.parametrize("way", ["widefield", "confocal", "bead"])
def test_planes_of_a_microscope_know_their_depth_and_z(way, tmp_path):
    z, depth = np.linspace(-4e-7, 4e-7, 5), np.array([2e-6, 5e-6])
    pupil = OIL.pupil(depth=depth[:, None], z=z, wavelength=525e-9)
    method: lm.methods.Method | None = None
    if way == "confocal":
        laser = OIL.pupil(depth=2e-6, wavelength=488e-9, emitter=lm.Beam("circular"))
        method = lm.methods.Confocal(laser)
    elif way == "bead":
        method = lm.methods.Bead(2e-7)
    normalize = "strehl" if way == "confocal" else "energy"
    stack = lm.psf_to(tmp_path / "a.zarr", pupil, 9, 6e-6, method=method, normalize=normalize, chunk=5)
    assert list(stack.axes) == ["depth", "z"]
    np.testing.assert_array_equal(stack.axes["depth"], depth)
    np.testing.assert_allclose(stack.axes["z"], z, atol=1e-15)
    for k in range(2):
        asked = lm.psf(pupil[k], 9, 6e-6, method=method, normalize=normalize)
        np.testing.assert_array_equal(stack[k].values, asked.values)
        assert stack[k].pupil == pupil[k]
        np.testing.assert_array_equal(stack[k].z, asked.z)


def test_units_of_lambda_N_and_bounds_of_any_aperture(tmp_path):
    vanes = lm.Pupil(lm.Wavefront([0.0, 1.0, 2.0]), spider=lm.Spider(0.05, [0.0]))
    stack = lm.psf_to(tmp_path / "a.zarr", vanes, 9, 0.5, chunk=2)
    known = lm.psf(vanes, 9, 0.5)
    assert (stack[0].unit, stack[0].sampling) == ("lambda*N", "center")
    assert stack[0].error_bound == stack.error_bound[0]
    assert np.all(lm.peak_error(stack[:], known) <= stack.error_bound + known.error_bound)
    assert stack.error_bound.max() <= 1e-6


def test_chunks_of_other_methods_are_taken_apart(tmp_path):
    # The chords do not prove a tolerance for a window that the light misses.
    tilted = lm.Wavefront(nonradial={(1, 1): [0.1, 0.1, 400.0, 400.0], (3, 1): 0.1})
    stack = lm.psf_to(tmp_path / "a.zarr", lm.Pupil(tilted), 3, 0.5, chunk=2, tol=1e-9)
    assert [type(stack[k].method) for k in range(4)] == [lm.methods.ChordalGauss] * 2 + [
        lm.methods.NijboerZernike
    ] * 2
    for part in (slice(0, 2), slice(2, 4)):
        asked = lm.psf(lm.Pupil(tilted)[part], 3, 0.5, tol=1e-9)
        np.testing.assert_array_equal(stack[part].values, asked.values)
        assert stack[part].method == asked.method
    with pytest.raises(ValueError, match=r"these PSFs were computed by ChordalGauss and NijboerZernike; choose"):
        stack[:]


def damage_values(path: Path) -> None:
    file = path / "values" / "c.1.1.0.0.0"
    data = bytearray(file.read_bytes())
    data[7] ^= 1
    file.write_bytes(data)


def damage_pupil(path: Path) -> None:
    shutil.copy(path / "pupil" / "edge" / "c.0.0.0.0", path / "pupil" / "edge" / "c.1.1.0.0")


def damage_length(path: Path) -> None:
    file = path / "values" / "c.1.1.0.0.0"
    file.write_bytes(file.read_bytes()[:-4])


@pytest.mark.parametrize("damage", [damage_values, damage_pupil, damage_length])
def test_a_damaged_chunk_is_told_and_the_others_are_read(damage, fields, tmp_path):
    path = tmp_path / "a.zarr"
    shutil.copytree(fields, path)
    damage(path)
    stack = lm.open_stack(path)
    assert stack[0].values.max() > 0.0
    with pytest.raises(FileError, match=r"damaged .wrong checksum|is not a stack of PSFs"):
        stack[1]


def test_a_changed_description_is_told(fields, tmp_path):
    path = tmp_path / "a.zarr"
    shutil.copytree(fields, path)
    said = json.loads((path / "zarr.json").read_text())
    said["attributes"]["lommel"]["pixel"] = 2e-6
    (path / "zarr.json").write_text(json.dumps(said))
    with pytest.raises(FileError, match="its description was changed after it was written"):
        lm.open_stack(path)
    with pytest.raises(FileNotFoundError):
        lm.open_stack(tmp_path / "none.zarr")


def test_a_cluster_computes_the_same_bits(fields, tmp_path):
    distributed = pytest.importorskip("distributed")
    axes, calls = {"object_distance": DISTANCES, "field_y": Y, "field_x": X}, []
    options = {"axes": axes, "chunk": 4, "progress": lambda *said: calls.append(said)}
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of ports that are taken
        cluster = distributed.LocalCluster(n_workers=1, threads_per_worker=2, dashboard_address=":0", processes=True)
    with cluster, distributed.Client(cluster) as client:
        made = lm.psf_to(tmp_path / "a.zarr", table(), (7, 8), 3e-6, client=client, **options)
        assert calls == [(k, 8) for k in range(1, 9)]
        np.testing.assert_array_equal(made[:].values, lm.open_stack(fields)[:].values)
        # Bounds depend on the tables at hand, in their tenth digit.
        np.testing.assert_allclose(made.error_bound, lm.open_stack(fields).error_bound, rtol=1e-7)
        sent = client.submit(lambda one: one[3, 1, 2].values, made)
        np.testing.assert_array_equal(sent.result(), made[3, 1, 2].values)


def test_pixels_of_two_sides_and_what_spreads_the_light_come_back(tmp_path):
    pupils = lm.Pupil(lm.Wavefront([0.0, 2.0]), wavelength=550e-9, f_number=4.0)
    how = {"fill": 0.8, "blur": lm.Jitter(1e-6)}
    pixel = (3e-6, 4e-6)
    lm.psf_to(tmp_path / "s.zarr", pupils, 9, pixel, **how)
    found, wanted = lm.open_stack(tmp_path / "s.zarr")[1], lm.psf(pupils[1], 9, pixel, **how)
    assert (found.pixel, found.grid.fill, found.blur) == (pixel, wanted.grid.fill, wanted.blur)
    # What errs by less for one of two is computed as exactly as the other takes.
    np.testing.assert_allclose(found.values, wanted.values, rtol=0, atol=2e-6 * wanted.values.max())
    with pytest.raises(ValueError, match="blur"):
        lm.psf_to(tmp_path / "s.zarr", pupils, 9, pixel, fill=0.8)
