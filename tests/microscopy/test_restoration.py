"""From a file to a restored stack: stacks written by tifffile, of which every point has the PSF of its own depth."""

from __future__ import annotations

import os
import re
import signal
from itertools import pairwise

import numpy as np
import pytest
import tifffile

import lommel as lm
from lommel.microscopy import chunks, held_out, refinement
from lommel.microscopy.depth_model import DepthModel
from lommel.microscopy.held_out import HeldOut
from lommel.microscopy.refinement import StackContext
from lommel.microscopy.restored_stack import INTERRUPTED
from lommel.recorded.camera_noise import measured_noise
from objectives import OIL_60X
from restored_stacks import deconvolved, scanning

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
        image += photons * psf[:, rows, columns] / WINDOW[0]
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
def few_trials(monkeypatch):
    """Tell the direction of the planes after a quarter of the steps, and try other depths alone."""
    monkeypatch.setattr(refinement, "_STEPS", refinement._STEPS // 4)
    monkeypatch.setattr(
        held_out, "_ALTERNATIVES", {name: held_out._ALTERNATIVES[name] for name in ("sample", "depth")}
    )


@pytest.fixture
def file(tmp_path, deep):
    return written(tmp_path / "her.ome.tif", deep)


def quick(stack, **options):
    way = lm.imaging.RichardsonLucy(steps=4, target=0.0)
    given = {"depth": 12e-6, "noise": CAMERA, "direction": "up", "method": way, "window": WINDOW}
    given |= {"background": 0.0, "diagnosis": False} | options
    return deconvolved(stack, given.pop("lens", OIL_60X), **given)


@pytest.mark.usefixtures("few_trials")
def test_a_file_is_restored_with_what_it_says(file):
    found = deconvolved(file, OIL_60X, depth=12e-6, window=WINDOW, diagnosis=False)
    (channel,) = found.channels
    assert found.recording.metadata["pixel"] == pytest.approx(0.1e-6)
    assert found.recording.metadata["step"] == pytest.approx(0.3e-6)
    assert found.recording.metadata["emission"] == (pytest.approx(WAVE),)
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


@pytest.mark.usefixtures("few_trials")
def test_planes_that_run_the_other_way_are_noticed_and_keep_their_order(tmp_path, deep):
    there = written(tmp_path / "turned.ome.tif", deep[::-1])
    upright = quick(deep, pixel=PIXEL, step=STEP, wavelength=WAVE)
    depths = upright.channels[0].depths
    # The depth is that of plane PLANES // 2 in the order of the file.
    found = quick(there, direction="auto", depth=depths[::-1][PLANES // 2])
    assert found.channels[0].direction == "down"
    told = re.search(
        r"the cover glass \(after \d+ steps a part of the stack has the discrepancy ([\d.]+), and ([\d.]+) for",
        " ".join(found.notes),
    )
    assert float(told[1]) < float(told[2])
    np.testing.assert_allclose(found.channels[0].depths[::-1], depths, atol=2e-8)
    np.testing.assert_allclose(found.values[::-1], upright.values, rtol=0.01, atol=1.0)


@pytest.mark.parametrize("direction", ["up", "down"])
def test_light_that_falls_along_a_wide_field_stack_is_named_in_the_order_of_its_planes(deep, direction):
    fading = np.linspace(1.9, 0.1, PLANES)[:, None, None] * (deep - 100.0) + 100.0
    planes = (fading - 100.0).mean(axis=(1, 2))
    slope = np.polyfit(np.linspace(-0.5, 0.5, PLANES), planes, 1)[0]
    given = {"pixel": PIXEL, "step": STEP, "wavelength": WAVE, "direction": direction}
    (channel,) = quick(fading, **given).channels
    told = channel.findings.get("plane_light")
    assert told.numbers["change"] == pytest.approx(slope / planes.mean(), rel=1e-3)
    assert told.severity == "note"
    disc = scanning(OIL_60X, "spinning disc", pinhole=1.0, excitation=488e-9)
    sections = quick(fading, lens=disc, **given)
    assert sections.channels[0].findings.get("plane_light") is None


def test_time_points_are_restored_as_each_alone_with_one_direction(tmp_path, deep, monkeypatch):
    tried = []
    monkeypatch.setattr(
        "lommel.microscopy.preparation.estimate_z_direction", lambda *_: tried.append(1) or ("down", "the last plane")
    )
    faint = (100 + (deep[:, ::-1].astype(float) - 100) / 2).astype(np.uint16)
    series = np.stack([np.stack([deep, faint]), np.stack([faint, deep])])
    channels = {"Channel": {"Name": ["a", "b"], "EmissionWavelength": [520, 520]}}
    file = written(tmp_path / "series.ome.tif", series, axes="TCZYX", **channels)
    found = quick(file, direction="auto")
    assert len(tried) == 2  # one for each channel
    assert found.values.shape == series.shape
    assert [channel.direction for channel in found.channels] == ["down"] * 4
    alone = {
        id(stack): quick(stack, direction="down", wavelength=WAVE, pixel=PIXEL, step=STEP) for stack in (deep, faint)
    }
    for place, stack in zip(np.ndindex(2, 2), (deep, faint, faint, deep), strict=True):
        np.testing.assert_array_equal(found.values[place], alone[id(stack)].values)
    assert found.message.splitlines()[0].count("2 time points, discrepancy") == 1
    assert "b: time 0 and 1 other: " in found.message
    entries = found.to_dict()["channels"]
    assert [(entry["time"], entry["name"]) for entry in entries] == [(0, "a"), (0, "b"), (1, "a"), (1, "b")]
    found.save(tmp_path / "out.ome.tif", tmp_path / "out.ome.zarr")
    quick(file, direction="auto", out=tmp_path / "chunks.ome.zarr")
    for name in ("out.ome.tif", "out.ome.zarr", "chunks.ome.zarr"):
        with lm.recorded.open_frames(tmp_path / name) as saved:
            assert saved.axes == "TCZYX"
            np.testing.assert_array_equal(saved[...], found.values)


def test_a_restored_stack_does_not_replace_its_recording(file):
    found = quick(file)
    with pytest.raises(ValueError, match="must not replace the recording"):
        found.save(file)


def blurred(model, truth):
    """Return the image of a specimen, with nothing outside of it."""
    blur = model.blur(truth.shape, (0, 0))
    blur.outside[...] = 0.0
    image = np.zeros(truth.shape)
    blur.forward(truth, lambda p, r, c, v: image.__setitem__((p, r, c), v))
    return np.maximum(image, 0.0)


def test_psfs_between_two_depths_are_like_the_mean_of_both():
    tilted = lm.Wavefront.zernike({(3, 1): 0.05}, unit="waves")  # coma: none has a radial transfer function
    model = DepthModel(OIL_60X, WAVE, PIXEL, STEP, 5e-6, 22, WINDOW, aberrations=tilted)
    nodes = model.psfs(0).depths
    assert 2 < len(nodes) < 9
    shares = [model.window_part(float(each)) for each in nodes]
    for (low, high), (one, other) in zip(pairwise(nodes), pairwise(shares), strict=True):
        between = model.window_part((0.5 * (low**0.5 + high**0.5)) ** 2)
        assert np.abs(between - 0.5 * (one + other)).sum() / between.sum() / 2.0 < 0.0301


@pytest.mark.parametrize("plane", [4, 11])
def test_each_plane_has_the_psf_of_its_own_depth_and_all_light_of_it(plane):
    model = DepthModel(OIL_60X, WAVE, PIXEL, STEP, 8e-6, 16, (31, 41), degrees=(0, 0))
    assert model.psfs(0).radial is not None
    truth = np.zeros((16, 60, 60), np.float32)
    truth[plane, 30, 28] = 31.0
    image = blurred(model, truth)
    z = (np.arange(16) - plane) * STEP
    depth = float(model.depths()[plane])
    known = lm.psf(OIL_60X.pupil(depth=depth, z=z, wavelength=WAVE), 129, PIXEL, tol=1e-5).values
    known = known[:, 64 - 30 : 124 - 30, 64 - 28 : 124 - 28]
    np.testing.assert_allclose(image.sum(axis=(1, 2)), known.sum(axis=(1, 2)), rtol=0.01)
    assert np.abs(image - known).sum() < 0.08 * known.sum()  # far from the point on a coarse grid
    assert np.abs(image - known).max() < 0.01 * known.max()


@pytest.mark.parametrize("slabs", [None, 1, 3])
def test_the_transpose_is_exact_and_a_flat_specimen_has_a_flat_recording(slabs):
    model = DepthModel(OIL_60X, WAVE, PIXEL, STEP, 6e-6, 9, (9, 21))
    blur = model.blur((9, 24, 20), (2, 10), model.psfs(2, slabs))
    rng = np.random.default_rng(3)
    specimen, recording, ones = rng.random(blur.whole), rng.random(blur.shape), np.ones(blur.whole)
    blur.outside = rng.random(blur.whole[0])
    made, back, flat, seen = (np.zeros(shape) for shape in (blur.shape, blur.whole, blur.shape, blur.whole))

    def into(out):
        return lambda plane, rows, columns, values: out.__setitem__((plane, rows, columns), values)

    blur.forward(specimen.astype(np.float32), into(made))
    blur.adjoint(recording.astype(np.float32), into(back))
    assert np.vdot(made, recording) == pytest.approx(
        np.vdot(specimen, back) + np.vdot(blur.outside, blur.outside_back), rel=1e-6
    )
    blur.adjoint(np.ones(blur.shape, np.float32), into(seen))
    found = [blur.seen(plane, slice(0, blur.whole[1]), slice(0, blur.whole[2])) for plane in range(blur.whole[0])]
    np.testing.assert_allclose(found, seen, atol=2e-4)
    np.testing.assert_allclose(blur.outside_seen, blur.outside_back, rtol=1e-5)
    blur.outside = np.ones(blur.whole[0])
    blur.forward(ones.astype(np.float32), into(flat))
    np.testing.assert_allclose(flat, 1.0, atol=3e-3)


def test_out_of_core_and_in_memory_are_the_same_to_the_last_bit(tmp_path, file, deep):
    import dask.array as da
    import zarr

    known = quick(file).values
    there = tmp_path / "out.ome.zarr"
    assert (np.asarray(quick(file, out=there))[0] == known).all()
    assert sorted(path.name for path in tmp_path.iterdir()) == ["her.ome.tif", "out.ome.zarr"]
    sizes = {"pixel": PIXEL, "step": STEP, "wavelength": WAVE}
    lazy = da.from_array(deep, chunks=(5, 17, 40))
    np.testing.assert_array_equal(quick(lazy, **sizes).values, known)
    chunked = zarr.create_array(str(tmp_path / "raw.zarr"), shape=deep.shape, chunks=(4, 32, 32), dtype=deep.dtype)
    chunked[...] = deep
    np.testing.assert_array_equal(quick(chunked, **sizes).values, known)
    again = lm.recorded.open_frames(there).as_channels()
    assert (again.metadata["pixel"], again.metadata["step"]) == (pytest.approx(0.1e-6), pytest.approx(0.3e-6))


def test_chunks_are_like_the_whole(deep):
    part = deep[4:13]
    wide = np.concatenate([part, part[:, ::-1], part], axis=2)
    options = {"pixel": PIXEL, "step": STEP, "wavelength": WAVE, "tile": 40}
    whole = quick(wide, **(options | {"tile": None})).values
    parts = quick(wide, **options).values
    assert np.abs(parts - whole).sum() < 0.1 * whole.sum()


@pytest.mark.parametrize("method", [lm.imaging.RichardsonLucy, lm.imaging.TotalVariation])
def test_chunks_that_hold_the_whole_have_its_background_to_the_last_bit(deep, method, monkeypatch):
    monkeypatch.setattr(chunks, "overlap_of", lambda model: SIDE)
    way = method(steps=8, **({"target": 0.0} if method is lm.imaging.RichardsonLucy else {"strength": 0.01}))
    options = {"pixel": PIXEL, "step": STEP, "wavelength": WAVE, "method": way, "background": "flat"}
    whole, parts = (quick(deep[5:12], tile=tile, **options) for tile in (None, SIDE // 2))
    (one,), (other,) = whole.channels, parts.channels
    assert one.background == other.background == pytest.approx(40.0, rel=0.4)
    assert f"A flat background of {one.background:.4g} counts per voxel was estimated" in " ".join(whole.notes)
    assert one.strength == other.strength == (None if method is lm.imaging.RichardsonLucy else 0.01)
    np.testing.assert_array_equal(parts.values, whole.values)


def test_ctrl_c_keeps_the_steps_that_are_done(deep):
    def stop(share, words):
        if words.startswith("step 3"):
            os.kill(os.getpid(), signal.SIGINT)

    way = lm.imaging.RichardsonLucy(steps=50, target=0.0)
    found = quick(deep, pixel=PIXEL, step=STEP, wavelength=WAVE, method=way, progress=stop)
    assert found.channels[0].stopped == INTERRUPTED
    assert 2 <= found.channels[0].steps < 50
    assert found.channels[0].discrepancy < found.channels[0].before
    assert (found.status, found.converged, found.message[:13]) == ("interrupted", False, "interrupted: ")


def test_a_known_background_is_taken_away_as_an_offset_with_its_own_noise():
    uneven = 30.0 * np.linspace(0.3, 1.7, SIDE) * np.ones((SIDE, 1))  # electrons
    points = {(9, 20, 20): 3e5}
    stack = recorded(12e-6, points, level=uneven)
    known = lm.Noise(white=0.5, read=np.hypot(1.5, np.sqrt(uneven)), offset=100.0 + uneven / 0.5)
    way = lm.imaging.RichardsonLucy(steps=40, target=0.0)
    found = 0.5 * quick(stack, noise=known, method=way, pixel=PIXEL, step=STEP, wavelength=WAVE).values
    around = found[6:13, 13:28, 13:28].sum()
    assert around == pytest.approx(3e5, rel=0.05)
    assert found.sum() - around < 0.2 * uneven.sum() * len(found)


def test_saturated_voxels_are_left_out_and_told(deep):
    full = np.minimum(deep.astype(int), 1023).astype(np.uint16)
    assert (full == 1023).sum() > 8
    found = quick(full, pixel=PIXEL, step=STEP, wavelength=WAVE)
    assert "have exactly the largest value, 1023, that of 10 bits: they were taken as saturated" in " ".join(
        found.notes
    )


def test_estimated_noise_is_that_of_the_camera_within_its_standard_error(deep):
    found, error = measured_noise(deep, 1.5)
    assert found == lm.microscopy.estimate_noise(deep, read=1.5)
    assert found.white == pytest.approx(0.5, rel=3.0 * error)
    assert error < 0.25
    ratios = []
    for seed in range(30):
        rng = np.random.default_rng(seed)
        light = 20.0 + 200.0 * np.sin(np.linspace(0.0, 3.0, 8))[:, None, None] ** 4 * np.linspace(0.0, 1.0, 40)
        counts = (rng.poisson(np.broadcast_to(light, (8, 40, 40))) + rng.normal(0.0, 1.6, (8, 40, 40))) / 0.46 + 100.0
        found, error = measured_noise(counts)
        ratios.append((0.46 / found.white - 1.0) / error)
    assert 0.7 < np.sqrt(np.mean(np.square(ratios))) < 1.4
    assert abs(np.mean(ratios)) < 0.6


def test_noise_that_is_not_to_be_known_is_refused():
    with pytest.raises(ValueError, match=r"does not clearly grow with the light.*such as white=0.46"):
        lm.microscopy.estimate_noise(np.random.default_rng(0).poisson(50.0, (4, 64, 64)))
    with pytest.raises(ValueError, match="must have the shape"):
        lm.microscopy.estimate_noise(np.ones((4, 4)))


@pytest.mark.quick
def test_a_noise_that_the_stack_contradicts_is_told(deep):
    sizes = {"pixel": PIXEL, "step": STEP, "wavelength": WAVE, "slabs": 1, "window": (5, 9)}
    way = lm.imaging.RichardsonLucy(steps=1, target=0.0)
    wrong = lm.Noise(white=0.25, read=1.5, offset=100.0)
    told = [
        " ".join(quick(deep[5:11, 4:24, 4:24], noise=noise, method=way, **sizes).notes) for noise in (CAMERA, wrong)
    ]
    assert ["The noise of the stack has 0.4" in notes for notes in told] == [False, True]


def test_planes_that_a_depth_puts_above_the_sample_are_told(deep):
    way = lm.imaging.RichardsonLucy(steps=1, target=0.0)
    sizes = {"pixel": PIXEL, "step": STEP, "wavelength": WAVE, "method": way}
    notes = " ".join(quick(deep, depth=1e-6, **sizes).notes)
    count = int((DepthModel(OIL_60X, WAVE, PIXEL, STEP, 1e-6, PLANES, WINDOW).depths() <= 0.0).sum())
    assert 3 < count < PLANES // 2
    assert f"{count} of {PLANES} planes are focused above the sample" in notes
    assert "at depths from 0 to " in notes
    assert "above the sample" not in " ".join(quick(deep, **sizes).notes)


@pytest.mark.parametrize("modality", ["confocal", "light sheet", "two-photon"])
def test_other_microscopes_have_psfs_of_their_own(modality):
    more = {"thickness": 1.5e-6, "excitation": 800e-9 if modality == "two-photon" else 488e-9}
    model = DepthModel(OIL_60X, WAVE, PIXEL, STEP, 8e-6, 7, (7, 9), lm.microscopy.Modality(modality, **more))
    nodes = model.psfs(2, 2).depths
    assert len(nodes) == 2
    assert nodes[0] < 8e-6 < nodes[1]
    assert model.window_part(8e-6).argmax() == model.window_part(8e-6).size // 2


def test_depths_in_focus_are_those_of_the_brightest_focus():
    model = DepthModel(OIL_60X, WAVE, PIXEL, STEP, 12e-6, 9, WINDOW)
    depths = model.depths()
    assert depths[4] == pytest.approx(12e-6, abs=1e-9)
    focus = OIL_60X.focus(depths, wavelength=WAVE).brightest
    np.testing.assert_allclose(np.diff(focus), STEP, rtol=0.02)
    shallow = DepthModel(OIL_60X, WAVE, PIXEL, STEP, 0.5e-6, 9, WINDOW).depths()
    assert shallow[0] == 0.0


@pytest.mark.parametrize("planes", [9, 10])
def test_the_middle_plane_is_the_same_in_both_directions(planes):
    for is_reversed in (False, True):
        model = DepthModel(OIL_60X, WAVE, PIXEL, STEP, 12e-6, planes, WINDOW, is_reversed=is_reversed)
        depths = model.depths()[::-1] if is_reversed else model.depths()  # in the order of the recording
        assert depths[planes // 2] == pytest.approx(12e-6, abs=1e-9)


@pytest.mark.parametrize(
    ("changes", "kind", "said"),
    [
        ({"wavelength": None}, ValueError, "emission wavelength of 'channel 0': give wavelength="),
        ({"microscope": scanning(OIL_60X, "confocal")}, ValueError, "excitation must be given"),
        ({"step": 200.0}, ValueError, "step must be a stage displacement"),
        ({"stack": lm.Counts.of(np.ones((4, 9, 9)), noise=CAMERA)}, TypeError, "noise must be omitted"),
    ],
)
def test_what_cannot_be_restored_is_refused_with_the_way_out(changes, kind, said):
    given = {"stack": np.ones((4, 9, 9)), "microscope": OIL_60X, "pixel": PIXEL, "step": STEP, "wavelength": WAVE}
    given |= {"noise": CAMERA} | changes
    with pytest.raises(kind, match=said):
        lm.microscopy.deconvolve(given.pop("stack"), given.pop("microscope"), **given)


def test_points_between_planes_follow_the_right_psf_better_than_others(monkeypatch):
    for module in ("held_out", "refinement"):
        monkeypatch.setattr(f"lommel.microscopy.{module}.NARROWEST", 21)
    monkeypatch.setattr(held_out, "_ALTERNATIVES", {"step": held_out._ALTERNATIVES["step"]})
    fine = DepthModel(OIL_60X, WAVE, PIXEL, STEP / 2, 3e-6, 16, (29, 21))
    truth = np.zeros((16, 24, 24), np.float32)
    truth[9, 12, 12] = 2e5
    stack = CAMERA.record(blurred(fine, truth)[::2] + 10.0, seed=3)
    right = DepthModel(OIL_60X, WAVE, PIXEL, STEP, 3e-6, 8, (15, 21))

    def better(values, model, turned):
        comparison = HeldOut(StackContext(values, model, CAMERA, np.inf, 1), lambda *_: None)
        return comparison.alternatives(lambda *_: None, try_reversed=turned)

    assert better(stack, right, False) == []
    (other,) = better(stack, right.changed("step", 1.08), False)
    assert other.startswith("a smaller step of z (about ")
    monkeypatch.setattr(held_out, "_ALTERNATIVES", {})
    assert better(stack[::-1], right, True) == ["planes in reverse order"]


@pytest.mark.parametrize("found", [[], ["a smaller depth"], ["a larger NA", "a smaller depth"]])
def test_a_misfit_is_one_of_the_psf_where_another_one_is_better(monkeypatch, deep, found):
    monkeypatch.setattr(HeldOut, "alternatives", lambda *_, **__: found)
    way = lm.imaging.RichardsonLucy(target=1.0)
    sizes = {"pixel": PIXEL, "step": STEP, "wavelength": WAVE}
    monkeypatch.setattr(HeldOut, "is_uniform", True)
    made = quick(deep, direction="down", method=way, diagnosis=True, **sizes)
    assert made.channels[0].stopped == "misfit"
    finding = made.findings.get("misfit")
    assert finding.text.endswith("measure the PSF with beads (--psf, lm.PSF.measured)")
    if not found:
        assert finding.severity == "doubt"
        assert made.converged
        assert "no other PSF fits better" in finding.text
    else:
        assert made.status == "misfit"
        assert finding.numbers["others"] == found
        assert ", ".join(found) in finding.text


def test_a_stack_without_voxel_sizes_takes_those_of_the_objective_file_and_says_so(deep):
    microscope = lm.load_microscope(lm.example_files()["zeiss-63x-1.4-oil"])
    given = {"noise": CAMERA, "direction": "up", "slabs": 1, "wavelength": WAVE, "window": (5, 9)}
    given["diagnosis"] = False
    way = lm.imaging.RichardsonLucy(steps=1, target=0.0)
    said = " ".join(deconvolved(deep[:5], microscope, method=way, **given).notes)
    pixel = 1e6 * microscope.pixel
    assert (
        f"does not state its pixel: the value of the objective file was used, {pixel:g} um on the camera; set pixel="
        in said
    )
    assert "does not state its step: the value of the objective file was used" in said
    sized = deconvolved(deep[:5], microscope, method=way, pixel=PIXEL, step=STEP, **given)
    assert "objective file" not in " ".join(sized.notes)
