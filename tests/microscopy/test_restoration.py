"""From a file to a restored stack: stacks written by tifffile, of which every point has the PSF of its own depth."""

from __future__ import annotations

import os
import signal
from itertools import pairwise

import numpy as np
import pytest
import tifffile
from scipy.ndimage import gaussian_filter

import lommel as lm
from lommel.microscopy import refinement
from lommel.microscopy.depth_model import DepthModel
from lommel.microscopy.restoration import INTERRUPTED
from objectives import OIL_60X

WAVE, PIXEL, STEP, SIDE, PLANES = 520e-9, 6e-6, 0.3e-6, 40, 18
CAMERA = lm.Noise(white=0.5, read=1.5, offset=100.0)
WINDOW = (15, 25)
POINTS = {(4, 12, 14): 2e5, (9, 28, 20): 4e5, (14, 16, 30): 3e5}


def recorded(depth, points=POINTS, level=20.0, seed=0, step=STEP):
    """Return counts of points, each blurred by the PSF of its own depth; the middle plane is focused on `depth`."""
    table = np.linspace(0.0, 2.0 * depth + 10e-6, 60)
    focus = np.maximum.accumulate(np.asarray(OIL_60X.focus(table, wavelength=WAVE).brightest))
    middle = np.interp(depth, table, focus)
    image = np.full((PLANES, SIDE, SIDE), level)
    for (plane, row, column), photons in points.items():
        at = float(np.interp(middle + (plane - PLANES // 2) * step, focus, table))
        z = (np.arange(PLANES) - plane) * step
        psf = lm.psf(OIL_60X.pupil(depth=at, z=z, wavelength=WAVE), 2 * SIDE + 1, PIXEL, tol=1e-4).values
        rows, columns = (slice(SIDE - k, 2 * SIDE - k) for k in (row, column))
        image += photons * psf[:, rows, columns] / PLANES
    return np.clip(np.round(CAMERA.record(image, seed=seed)), 0, 65535).astype(np.uint16)


def written(path, stack, **more):
    fields = {
        "axes": "ZYX",
        "PhysicalSizeX": 0.1,
        "PhysicalSizeXUnit": "µm",
        "PhysicalSizeY": 0.1,
        "PhysicalSizeYUnit": "µm",
        "PhysicalSizeZ": 300,
        "PhysicalSizeZUnit": "nm",
        "Channel": {"Name": ["GFP"], "EmissionWavelength": [520], "EmissionWavelengthUnit": ["nm"]},
    }
    tifffile.imwrite(path, stack, ome=True, metadata=fields | more, photometric="minisblack")
    return path


@pytest.fixture(scope="module")
def deep():
    return recorded(12e-6)


@pytest.fixture
def file(tmp_path, deep):
    return written(tmp_path / "her.ome.tif", deep)


def quick(stack, **options):
    way = lm.imaging.RichardsonLucy(steps=6, target=0.0)
    given = {"depth": 12e-6, "noise": CAMERA, "direction": "up", "method": way, "psf_shape": WINDOW} | options
    return lm.microscopy.restore(stack, OIL_60X, **given)


def test_a_file_is_restored_with_what_it_says(file):
    found = lm.microscopy.restore(file, OIL_60X, depth=12e-6, psf_shape=WINDOW)
    (channel,) = found.channels
    assert found.recording.pixel == pytest.approx(0.1e-6)
    assert found.recording.step == pytest.approx(0.3e-6)
    assert found.recording.emission == (pytest.approx(WAVE),)
    assert channel.direction == "up"
    assert channel.discrepancy < 0.5 * channel.before
    assert len(channel.psf_depths) > 1
    said = " ".join(found.notes)
    assert "From the OME metadata of the file: 100 nm pixels, 300 nm planes apart." in said
    assert "from the cover glass into the sample" in said
    assert "noise was estimated from the stack" in said
    for plane, row, column in POINTS:
        near = found.values[plane - 1 : plane + 2, row - 2 : row + 3, column - 2 : column + 3]
        assert near.max() == found.values[:, row - 5 : row + 6, column - 5 : column + 6].max()


def test_planes_that_run_the_other_way_are_noticed_and_keep_their_order(tmp_path, deep):
    there = written(tmp_path / "turned.ome.tif", deep[::-1])
    found = quick(there, direction="auto")
    assert found.channels[0].direction == "down"
    assert "The planes run towards the cover glass" in " ".join(found.notes)
    np.testing.assert_array_equal(found.values[::-1], quick(deep, pixel=PIXEL, step=STEP, wavelength=WAVE).values)
    assert (np.diff(found.channels[0].depths) < 0.0).all()


def test_psfs_by_depth_are_better_than_one_where_every_point_has_its_own():
    points = {(2, 10, 14): 3e5, (7, 28, 20): 4e5, (11, 12, 30): 3e5, (15, 30, 9): 4e5}
    stack = recorded(10e-6, points, step=1e-6)
    model = DepthModel(OIL_60X, WAVE, PIXEL, 1e-6, 10e-6, PLANES, (31, 41))
    truth, depths = np.zeros(stack.shape), model.depths()
    for at, photons in points.items():  # light beyond the window of the PSF is not restored
        truth[at] = photons * model.psf(depths[at[0]]).values.sum() / PLANES
    errors = []
    for slabs in (None, 1):
        way = lm.imaging.RichardsonLucy(steps=60, target=0.0)
        given = {"pixel": PIXEL, "step": 1e-6, "wavelength": WAVE, "depth": 10e-6, "psf_shape": (31, 41)}
        found = quick(stack, slabs=slabs, method=way, **(given | {"margin": (1, 2)})).values * 0.5 - 20.0
        near, right = (gaussian_filter(values, (0.5, 1.0, 1.0)) for values in (found, truth))
        errors.append(np.linalg.norm(near - right))
    assert errors[0] < 0.6 * errors[1]


def test_psfs_between_two_depths_are_like_the_mean_of_both():
    model = DepthModel(OIL_60X, WAVE, PIXEL, STEP, 5e-6, 22, WINDOW)
    psfs, weights, nodes = model.operator(0)
    assert 2 < len(nodes) < 9
    np.testing.assert_allclose(weights.sum(axis=0), 1.0)
    shares = [each.values / each.values.sum() for each in psfs]
    for (low, high), (one, other) in zip(pairwise(nodes), pairwise(shares), strict=True):
        between = model.psf((0.5 * (low**0.5 + high**0.5)) ** 2).values
        assert np.abs(between / between.sum() - 0.5 * (one + other)).sum() / 2.0 < 0.0301


def test_out_of_core_and_in_memory_are_the_same_to_the_last_bit(tmp_path, file, deep):
    import dask.array as da
    import zarr

    known = quick(file).values
    there = tmp_path / "out.ome.zarr"
    assert (np.asarray(quick(file, out=there))[0] == known).all()
    assert not (tmp_path / "out.ome.zarr.partial").exists()
    sizes = {"pixel": PIXEL, "step": STEP, "wavelength": WAVE}
    lazy = da.from_array(deep, chunks=(5, 17, 40))
    np.testing.assert_array_equal(quick(lazy, **sizes).values, known)
    chunked = zarr.create_array(str(tmp_path / "raw.zarr"), shape=deep.shape, chunks=(4, 32, 32), dtype=deep.dtype)
    chunked[...] = deep
    np.testing.assert_array_equal(quick(chunked, **sizes).values, known)
    again = lm.microscopy.open_recording(there)
    assert (again.pixel, again.step) == (pytest.approx(0.1e-6), pytest.approx(0.3e-6))


def test_chunks_are_like_the_whole_and_go_on_where_they_were_interrupted(tmp_path, deep):
    wide = np.concatenate([deep, deep[:, ::-1], deep], axis=2)
    options = {"pixel": PIXEL, "step": STEP, "wavelength": WAVE, "tile": 40}
    whole = quick(wide, **(options | {"tile": None})).values
    parts = quick(wide, **options).values
    assert np.abs(parts - whole).sum() < 0.06 * whole.sum()
    there, told = tmp_path / "parts.zarr", []

    def stop(share, words):
        told.append(words)
        if "chunk 3 of 3" in words:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        quick(wide, out=there, progress=stop, **options)
    assert not there.exists()
    told.clear()
    found = quick(wide, out=there, progress=lambda share, words: told.append(words), **options)
    assert not [words for words in told if "chunk 2 of 3" in words]
    np.testing.assert_array_equal(np.asarray(found)[0], parts)


def test_ctrl_c_keeps_the_steps_that_are_done(deep):
    def stop(share, words):
        if words.startswith("step 3"):
            os.kill(os.getpid(), signal.SIGINT)

    way = lm.imaging.RichardsonLucy(steps=50, target=0.0)
    found = quick(deep, pixel=PIXEL, step=STEP, wavelength=WAVE, method=way, progress=stop)
    assert found.channels[0].stopped == INTERRUPTED
    assert 2 <= found.channels[0].steps < 50
    assert found.channels[0].discrepancy < found.channels[0].before


def test_a_flat_stack_and_the_photons_of_a_bead_are_kept():
    flat = np.random.default_rng(0).poisson(200.0, (10, 40, 40)) / 0.5 + 100.0
    sizes = {"pixel": PIXEL, "step": STEP, "wavelength": WAVE}
    way = lm.imaging.RichardsonLucy(steps=10, target=0.0)
    found = quick(flat, method=way, **sizes)
    np.testing.assert_allclose(found.values.mean(axis=(1, 2)), 400.0, rtol=0.01)
    model = DepthModel(OIL_60X, WAVE, PIXEL, STEP, 12e-6, 16, WINDOW)
    truth = np.full((16, SIDE, SIDE), 20.0, np.float32)
    truth[8, 20, 20] += 3e6
    psfs, weights, _ = model.operator(0)
    blur = lm.microscopy.stack_blur.TiledBlur(psfs, truth.shape, (0, 0), weights=weights)
    image = np.zeros(truth.shape)
    blur.forward(lambda *at: truth[at], lambda p, r, c, v: image.__setitem__((p, r, c), v))
    found = quick(CAMERA.record(np.maximum(image, 0.0), 1), method=lm.imaging.RichardsonLucy(steps=60), **sizes)
    around = found.values[5:12, 14:27, 14:27].sum() * 0.5 - 7 * 13 * 13 * 20.0
    assert around == pytest.approx(3e6, rel=0.01)


def test_saturated_voxels_are_left_out_and_told(deep):
    full = np.minimum(deep.astype(int), 1023).astype(np.uint16)
    assert (full == 1023).sum() > 8
    found = quick(full, pixel=PIXEL, step=STEP, wavelength=WAVE)
    assert "have the largest value, 1023: they were taken as saturated" in " ".join(found.notes)


def test_estimated_noise_is_that_of_the_camera(deep):
    found = lm.microscopy.estimate_noise(deep, read=1.5)
    assert found.white == pytest.approx(0.5, rel=0.25)
    assert found.offset == pytest.approx(100.0, abs=15.0)
    with pytest.raises(ValueError, match="as bright everywhere; give noise="):
        lm.microscopy.estimate_noise(np.random.default_rng(0).poisson(50.0, (4, 64, 64)))
    with pytest.raises(ValueError, match="must have the shape"):
        lm.microscopy.estimate_noise(np.ones((4, 4)))


@pytest.mark.parametrize("kind", [np.int16, np.float64])
def test_all_real_types_are_taken(deep, kind):
    way = lm.imaging.RichardsonLucy(steps=2, target=0.0)
    sizes = {"pixel": PIXEL, "step": STEP, "wavelength": WAVE, "method": way, "slabs": 1}
    np.testing.assert_array_equal(quick(deep.astype(kind), **sizes).values, quick(deep, **sizes).values)


@pytest.mark.parametrize("modality", ["confocal", "light sheet", "two-photon"])
def test_other_microscopes_have_psfs_of_their_own(modality):
    more = {"thickness": 1.5e-6, "excitation": 800e-9 if modality == "two-photon" else 488e-9}
    model = DepthModel(OIL_60X, WAVE, PIXEL, STEP, 8e-6, 7, (7, 9), modality, **more)
    psfs, weights, nodes = model.operator(2, 2)
    assert len(psfs) == 2
    assert weights.shape == (2, 11)
    assert nodes[0] < 8e-6 < nodes[1]
    assert psfs[0].values.argmax() == psfs[0].values.size // 2


def test_depths_in_focus_are_those_of_the_brightest_focus():
    model = DepthModel(OIL_60X, WAVE, PIXEL, STEP, 12e-6, 9, WINDOW)
    depths = model.depths()
    assert depths[4] == pytest.approx(12e-6, abs=1e-9)
    focus = OIL_60X.focus(depths, wavelength=WAVE).brightest
    np.testing.assert_allclose(np.diff(focus), STEP, rtol=0.02)
    shallow = DepthModel(OIL_60X, WAVE, PIXEL, STEP, 0.5e-6, 9, WINDOW).depths()
    assert shallow[0] == 0.0


@pytest.mark.parametrize(
    ("changes", "kind", "said"),
    [
        ({"pixel": None}, ValueError, r"does not say the voxel size: give pixel= \(on the camera\) and step="),
        ({"step": None}, ValueError, "does not say the voxel size"),
        ({"wavelength": None}, ValueError, "emission wavelength of 'channel 0': give wavelength="),
        ({"stack": np.ones((2, 9, 9))}, ValueError, "3 planes or more, got 2"),
        ({"stack": np.ones((9, 9))}, ValueError, r"must have the shape \(planes, height, width\)"),
        ({"stack": np.ones((3, 9, 9), complex)}, TypeError, "must hold real numbers"),
        ({"objective": "oil"}, TypeError, "objective must be an Objective, or a Microscope"),
        ({"modality": "confocal"}, ValueError, "excitation must be given"),
        ({"modality": "light sheet"}, ValueError, "thickness must be given"),
        ({"modality": "brightfield"}, ValueError, "modality"),
        ({"direction": "sideways"}, ValueError, "direction"),
        ({"refine": "depth"}, TypeError, "refine must be a sequence"),
        ({"refine": ("tilt",)}, ValueError, "refine"),
        ({"step": 200.0}, ValueError, "step must be of the stage, in metres"),
        ({"psf_shape": (4, 9)}, ValueError, r"psf_shape must be \(planes, pixels\), both odd"),
        ({"channel": 1}, ValueError, "channel"),
        ({"noise": 1.0}, TypeError, "noise"),
        ({"out": "restored.tif"}, ValueError, "out must end in .zarr"),
        ({"axes": "YX"}, ValueError, "axes"),
    ],
)
def test_what_cannot_be_restored_is_refused_with_the_way_out(changes, kind, said):
    given = {"stack": np.ones((4, 9, 9)), "objective": OIL_60X, "pixel": PIXEL, "step": STEP, "wavelength": WAVE}
    given |= {"noise": CAMERA} | changes
    with pytest.raises(kind, match=said):
        lm.microscopy.restore(given.pop("stack"), given.pop("objective"), **given)


def test_a_spherical_aberration_is_found_from_the_stack():
    model = DepthModel(OIL_60X, WAVE, PIXEL, STEP, 3e-6, 8, (15, 33))
    psfs, weights, _ = model.changed("spherical", 0.12).operator(0)
    truth = np.full((8, 24, 24), 10.0, np.float32)
    truth[4, 12, 12] += 1e6
    blur = lm.microscopy.stack_blur.TiledBlur(psfs, truth.shape, (0, 0), weights=weights)
    image = np.zeros(truth.shape)
    blur.forward(lambda *at: truth[at], lambda p, r, c, v: image.__setitem__((p, r, c), v))
    stack = CAMERA.record(np.maximum(image, 0.0), seed=3)
    crop = refinement.crop_of(stack, 17)
    _, found = refinement.refined(stack, crop, model, CAMERA, np.inf, ["spherical"], 1, lambda _: None)
    assert found["spherical"] == pytest.approx(0.12, abs=0.02)


def test_a_stack_without_voxel_sizes_takes_those_of_the_objective_file_and_says_so(deep):
    microscope = lm.load_microscope(lm.example_files()["zeiss-63x-1.4-oil"])
    given = {"noise": CAMERA, "direction": "up", "slabs": 1, "wavelength": WAVE, "psf_shape": (5, 9)}
    way = lm.imaging.RichardsonLucy(steps=1, target=0.0)
    said = " ".join(lm.microscopy.restore(deep[:5], microscope, method=way, **given).notes)
    pixel = 1e6 * microscope.pixel
    assert f"does not say its pixel: that of the objective file was taken, {pixel:g} um on the camera; pixel=" in said
    assert "does not say its step: that of the objective file was taken" in said
    sized = lm.microscopy.restore(deep[:5], microscope, method=way, pixel=PIXEL, step=STEP, **given)
    assert "objective file" not in " ".join(sized.notes)
