"""Stacks restored: what is flat stays flat, light is kept, and what comes in from outside is found there."""

from __future__ import annotations

import subprocess
import sys
from types import SimpleNamespace

import numpy as np
import pytest

import lommel as lm
from lommel.microscopy import depth_model
from lommel.microscopy.light_checks import plane_light_findings
from objectives import OIL_60X
from restored_stacks import deconvolved

STEP, PIXEL = 0.3e-6, 6e-6
NOISE = lm.Noise(read=1.5, offset=100.0)


def kernel(planes=11, side=17, depth=5e-6):
    z = (np.arange(planes) - planes // 2) * STEP
    return lm.psf(OIL_60X.pupil(depth=depth, z=z, wavelength=520e-9), side, PIXEL, tol=1e-4)


PSF = kernel()
AROUND = (6, 9, 9)  # voxels beyond the faces of the recording that light comes from


def restored(stack, psf=PSF, noise=NOISE, **given):
    """Return the result of a deconvolution with one PSF, with the attributes of its channel."""
    found = deconvolved(stack, psf, noise=noise, **given)
    (channel,) = found.channels
    verdict = {name: getattr(found, name) for name in ("values", "reliable", "message", "notes")}
    return SimpleNamespace(**(vars(channel) | verdict))


def record(specimen, seed=0, psf=PSF):
    """Return the recording of the middle of a specimen."""
    blur = lm.microscopy.StackBlur(psf, specimen.shape)
    light = np.moveaxis(blur.forward(np.moveaxis(specimen, 0, -1).astype(np.float32)), -1, 0)
    inside = tuple(slice(more, side - more) for more, side in zip(AROUND, light.shape, strict=True))
    return NOISE.record(np.maximum(light[inside], 0.0), seed=seed)


def level(shape, light):
    """Return a flat specimen that is a recording of this shape and what is around it."""
    return np.full([side + 2 * more for side, more in zip(shape, AROUND, strict=True)], float(light))


BEADS = {(5, 12, 13): 1e5, (2, 20, 7): 2e5, (8, 6, 19): 5e4}


def beads(light=20.0, shape=(11, 26, 26)):
    specimen = level(shape, light)
    for place, photons in BEADS.items():
        specimen[tuple(np.add(place, AROUND))] += photons
    return specimen


@pytest.mark.parametrize(("planes", "margin"), [(11, None), (11, (8, 12)), (5, None), (1, None), (4, (0, 8))])
def test_a_flat_stack_stays_flat(planes, margin):
    flat = np.random.default_rng(planes).poisson(200.0, (planes, 40, 40)) + 100.0
    found = restored(flat, PSF, NOISE, margin=margin)
    assert found.stopped == "noise"
    assert found.discrepancy == pytest.approx(1.0, abs=0.05)
    np.testing.assert_allclose(found.values.mean(axis=(1, 2)) + found.background, 200.0, rtol=0.01)
    assert found.background > 195.0


@pytest.mark.parametrize("light", [4.0, 10.0, 200.0])
def test_the_discrepancy_of_the_true_scene_is_one(light):
    flat = NOISE.record(np.full((9, 60, 60), light), seed=8)
    way = lm.imaging.RichardsonLucy(steps=1, target=0.0)
    found = restored(flat, PSF, NOISE, method=way, background=0.0)
    assert found.discrepancy == pytest.approx(1.0, abs=0.03)


@pytest.mark.parametrize("background", ["flat", 0.0, 150.0])
def test_steps_that_are_taken_in_spite_of_it_leave_it_flat(background):
    flat = np.full((7, 24, 24), 300.0)
    way = lm.imaging.RichardsonLucy(steps=30, target=0.0)
    found = restored(flat, PSF, NOISE, method=way, background=background)
    assert found.steps == 30
    np.testing.assert_allclose(found.values + found.background, 200.0, rtol=1e-3)


def test_beads_on_a_background_keep_their_photons_and_all_light():
    specimen = beads()
    found = restored(record(specimen), PSF, NOISE)
    assert found.stopped == "noise"
    inside = specimen[tuple(slice(more, -more) for more in AROUND)]
    assert 15.0 < found.background < 20.5
    assert found.values.sum(dtype=float) + found.background * inside.size == pytest.approx(inside.sum(), rel=0.02)
    for place, photons in BEADS.items():
        part = tuple(slice(k - 2, k + 3) for k in place)
        assert found.values[part].sum() == pytest.approx(photons, rel=0.025)


@pytest.mark.parametrize("seed", range(3))
def test_points_between_voxels_keep_their_light_and_the_background_is_found(seed):
    # Points anywhere, by a certified PSF of each: no lattice of voxels has their images.
    draw = np.random.default_rng(seed)
    oil = lm.Objective(NA=1.3, magnification=63, immersion=1.518)
    step, pixel, sides, photons = 0.25e-6, 6.5e-6, (17, 40, 40), draw.uniform(3e3, 9e3, 6)
    planes, wide = (np.arange(sides[0]) - 8) * step, 157
    mean = np.full(sides, 20.0)
    for light in photons:
        z, (row, column) = draw.uniform(-1.2e-6, 1.2e-6), draw.uniform(9, 30, 2)
        corner = np.rint([row, column]).astype(int) - wide // 2
        pupil = oil.pupil(depth=0.0, z=planes - z, wavelength=520e-9)
        image = lm.psf(pupil, wide, pixel, tol=1e-4, center=(row - corner[0], column - corner[1])).values
        mean += light * image[:, -corner[0] : sides[1] - corner[0], -corner[1] : sides[2] - corner[1]]
    stack = draw.poisson(mean) + draw.normal(0.0, 1.5, sides)
    psf = lm.psf(oil.pupil(depth=0.0, z=(np.arange(33) - 16) * step, wavelength=520e-9), 141, pixel, tol=1e-4)
    for diagnosis, light, level in ((True, 0.03, 0.02), (False, 0.1, 0.1)):
        found = restored(stack, psf, lm.Noise(read=1.5), diagnosis=diagnosis)
        assert found.reliable
        assert found.message.startswith(f"converged: discrepancy {found.discrepancy:.4g} after {found.steps} steps")
        # In so small a frame light crosses the edges.
        assert set(found.findings.codes) <= {"plane_light"}
        assert found.values.sum() / psf.values.sum() == pytest.approx(photons.sum(), rel=light)
        assert found.background == pytest.approx(20.0, rel=level)


def test_a_window_that_cuts_off_the_cone_of_light_is_said():
    found = restored(record(beads()), PSF, NOISE)
    told = found.findings.get("untested")
    rim = 1.0 - PSF.values[:, 1:-1, 1:-1].sum() / PSF.values.sum()
    assert (told.severity, told.numbers["rim"]) == ("note", pytest.approx(rim, rel=1e-4))
    side = max(PSF.values.shape[1:])
    assert f"the window of the PSF, {side} x {side} pixels (7 % on its rim): record a larger image" in told.text
    assert found.reliable


def spots(planes=21, side=48, at=(10.0, 20.0), spread=0.25, seed=3):
    """Return counts of Gaussian spots, in focus in the planes `at`, with all light in each plane, and a generator."""
    rng, (down, across) = np.random.default_rng(seed), np.indices((side, side))
    stack = np.full((planes, side, side), 115.0)  # 100 of the offset, 15 of the background
    for k in range(planes):
        for middle, place in zip(at, (0.4, 0.6), strict=True):
            width = 1.5 + spread * abs(k - middle)
            square = (down - place * side) ** 2 + (across - (1.0 - place) * side) ** 2
            stack[k] += 2e4 * np.exp(-0.5 * square / width**2) / (2.0 * np.pi * width**2)
    return stack, rng


def test_light_that_leaves_the_frame_far_from_focus_is_no_change_along_the_stack():
    stack, rng = spots(side=24, at=(9.0, 11.0), spread=0.6)
    light = (stack - 115.0).mean(axis=(1, 2))
    assert light.min() < 0.9 * light.max()
    assert plane_light_findings(rng.poisson(stack - 100.0) + 100.0, NOISE, 15.0) == []


def test_an_uneven_background_is_found_beside_beads():
    rising = np.linspace(15.0, 45.0, 44)  # electrons from one side to the other, of the specimen and around it
    stack = record(beads(0.0) + rising)
    flat = restored(stack, PSF, NOISE)
    doubt = flat.findings.get("uneven_background")
    assert doubt.severity == "doubt"
    assert doubt.numbers["share"] > 0.07
    assert 'background="uneven"' in doubt.text
    assert not flat.reliable
    assert restored(record(beads(20.0)), PSF, NOISE).reliable
    assert restored(stack, PSF, NOISE, background=0.0).findings.get("uneven_background") is None
    found = restored(stack, PSF, NOISE, background="uneven")
    assert found.findings.get("uneven_background") is None
    np.testing.assert_allclose(found.background.mean(axis=0), rising[9:35], rtol=0.25)
    assert found.background.shape == stack.shape[1:]
    errors = []
    for each in (found, restored(stack, PSF, NOISE)):
        parts = [each.values[tuple(slice(k - 2, k + 3) for k in place)].sum() for place in BEADS]
        errors.append(np.abs(np.array(parts) / list(BEADS.values()) - 1.0).max())
    assert errors[0] < 0.04
    assert errors[0] < errors[1]


def test_a_point_has_its_photons_in_the_window_of_the_psf():
    wide = kernel(side=51).values  # as fractions of the light of a plane
    stack = 20.0 + NOISE.offset + 5e4 * wide[:, 12:38, 12:38]
    found = restored(stack, PSF, NOISE, method=lm.imaging.RichardsonLucy(steps=40, target=0.0))
    photons = found.values[4:7, 11:16, 11:16].sum() - 3 * 5 * 5 * 20.0
    assert PSF.values.sum() < 0.9 * len(wide)
    assert photons == pytest.approx(5e4 * PSF.values.sum(), rel=0.05)


def test_a_larger_margin_changes_nothing_to_speak_of():
    stack = record(beads())
    usual, larger = (restored(stack, PSF, NOISE, margin=margin).values for margin in (None, (9, 14)))
    assert abs(larger - usual).sum() < 0.01 * usual.sum()


@pytest.mark.parametrize("away", [1, 3])
def test_light_from_planes_beyond_the_faces_is_found_in_these(away):
    specimen = level((14, 26, 26), 20.0)
    specimen[AROUND[0] + 3 - away, 22, 20] += 1e6
    stack = record(specimen)
    stack[:3] = np.nan  # so that the result shows the margin
    found = restored(stack, PSF, NOISE)
    assert found.stopped == "noise"
    assert found.values[3 - away, 12:15, 10:13].sum() == pytest.approx(1e6, rel=0.1)
    # Without these planes it stays outside, where a margin of none has no place for it.
    assert restored(stack[3:], PSF, NOISE).values.sum() < 1.2 * 20.0 * stack[3:].size
    assert restored(stack[3:], PSF, NOISE, margin=(0, 8)).stopped == "misfit"


@pytest.mark.parametrize("kind", [np.uint8, np.uint16, np.int16, np.int64, np.float32, np.float64])
def test_integers_of_a_camera_are_taken_as_floats_are(kind):
    counts = (np.random.default_rng(3).poisson(60.0, (5, 20, 20)) + 20).astype(np.uint8)
    noise, way = lm.Noise(read=1.0, offset=20.0), lm.imaging.RichardsonLucy(steps=4, target=0.0)
    plain, found = (restored(s, PSF, noise, method=way) for s in (counts * 1.0, counts.astype(kind)))
    assert found.values.dtype == np.float32
    np.testing.assert_array_equal(found.values, plain.values)
    assert found.discrepancy == plain.discrepancy


def test_it_is_the_iteration_of_richardson_and_lucy(monkeypatch):
    # Of light that is in voxels, not spread between them.
    # Against the operator of photographs, of a recording with so much of nothing around that no margin matters.
    monkeypatch.setattr(depth_model, "spline_degrees", lambda _: (0, 0))
    specimen = np.zeros((25, 50, 50))
    specimen[[11, 13], [22, 30], [25, 24]] = 3e5
    blur = lm.microscopy.StackBlur(PSF, specimen.shape, np.float64)
    light = np.moveaxis(blur.forward(np.moveaxis(specimen, 0, -1)), -1, 0)
    stack = NOISE.record(np.maximum(light, 0.0), seed=5)
    way = lm.imaging.RichardsonLucy(steps=8, target=0.0, accelerate=False)
    found = restored(stack, PSF, NOISE, method=way, margin=(0, 0), background=0.0)
    other = lm.imaging.restore(np.moveaxis(stack, 0, -1), None, blur, encoding="linear", noise=NOISE, method=way)
    near = (slice(7, 18), slice(12, 40), slice(12, 40))
    np.testing.assert_allclose(found.values[near].sum(), np.moveaxis(other.light, -1, 0)[near].sum(), rtol=0.01)
    np.testing.assert_allclose(found.before, other.before, rtol=0.1)  # over that of the true scene
    assert found.discrepancy / found.before == pytest.approx(other.discrepancy / other.before, rel=0.02)


def test_unknown_voxels_are_filled_from_the_light_of_the_others():
    stack = record(beads())
    hidden = stack.copy()
    hidden[4:7, 11:14, 12:14] = np.nan
    found = restored(hidden, PSF, NOISE)
    assert "18 voxels are NaN or infinite, and were left out." in found.notes
    assert found.stopped == "noise"
    assert found.values[4:7, 11:14, 12:15].sum() == pytest.approx(1e5, rel=0.1)


def test_pixels_may_have_gains_and_noise_of_their_own():
    rng = np.random.default_rng(7)
    maps = lm.Noise(white=rng.uniform(0.4, 2.0, (26, 26)), read=rng.uniform(1.0, 5.0, (26, 26)), offset=100.0)
    specimen = beads()
    stack = (record(specimen) - 100.0) / 1.0
    recorded = maps.image(stack * maps.white)  # as bright in light as with a gain of 1
    found = restored(recorded, PSF, maps, method=lm.imaging.RichardsonLucy(steps=40))
    for place, photons in BEADS.items():
        part = tuple(slice(k - 1, k + 2) for k in place)
        assert found.values[part].sum() == pytest.approx(photons, rel=0.15)


def test_a_stack_whose_z_runs_the_other_way_is_told():
    psf = kernel(depth=10e-6)
    stack = record(beads(), psf=psf)
    assert restored(stack, psf, NOISE).stopped == "noise"
    found = restored(stack[::-1], psf, NOISE)
    assert found.stopped == "misfit"
    assert "direction of z" in found.findings.get("misfit").text


_MEMORY = """
import numpy as np
import lommel as lm
def most():  # of this process alone, unlike ru_maxrss, which it has from its parent
    return next(int(line.split()[1]) for line in open("/proc/self/status") if line.startswith("VmHWM"))
z = (np.arange(32) - 16) * 0.2e-6
objective = lm.Objective(NA=1.3, magnification=60, immersion=1.515, working_distance=0.2e-3,
                         coverslip=lm.Layer(1.5255, 170e-6), sample=1.33)
psf = lm.psf(objective.pupil(depth=5e-6, z=z, wavelength=520e-9), 49, 6e-6, tol=1e-4)
stack = np.full((32, 256, 256), 120, np.uint16)
stack[16, 20::40, 20::40] = 5000
noise, way = lm.Noise(read=1.0, offset=100.0), lm.imaging.RichardsonLucy(steps=2, target=0.0)
lm.microscopy.deconvolve(stack[:4, :20, :20], psf, noise=noise, method=way)
before = most()
lm.microscopy.deconvolve(stack, psf, noise=noise, method=way)
print((most() - before) * 1024 / (4 * stack.size))
"""


@pytest.mark.skipif(sys.platform != "linux", reason="there is no /proc elsewhere")
def test_memory_is_at_most_thirteen_times_a_small_stack_in_float32():
    found = subprocess.run([sys.executable, "-c", _MEMORY], capture_output=True, text=True, check=True)
    assert 2.0 < float(found.stdout) < 13.0


@pytest.mark.parametrize(
    ("changes", "kind", "said"),
    [
        ({"depth": 1e-6}, ValueError, "depth must not be given with a PSF"),
        ({"noise": lm.Noise(read=np.ones((3, 3)))}, ValueError, r"read, of shape \(3, 3\), must have a value for"),
    ],
)
def test_bad_arguments_are_refused_by_name(changes, kind, said):
    given = {"stack": np.ones((4, 5, 5)), "psf": PSF, "noise": NOISE} | changes
    with pytest.raises(kind, match=said):
        lm.microscopy.deconvolve(given.pop("stack"), given.pop("psf"), **given)


def test_the_only_channel_of_a_recording_is_the_stack():
    stack = record(beads()).astype(np.float32)
    few = lm.imaging.RichardsonLucy(steps=2)
    expected = restored(stack, PSF, NOISE, method=few).values
    one, two = (lm.recorded.open_frames(np.stack([stack] * count)).as_channels() for count in (1, 2))
    np.testing.assert_array_equal(restored(one, PSF, NOISE, method=few).values, expected)
    with pytest.raises(ValueError, match="one PSF for each channel of the stack, channel 0, channel 1, got 1"):
        restored(two, PSF, NOISE)


def test_a_stack_that_is_quieter_than_its_noise_is_told():
    stack = np.random.default_rng(1).poisson(200.0, (8, 24, 24)) + 100.0
    # The offset is left out, so that 300 counts vary like 200.
    found = restored(stack, PSF, lm.Noise(read=1.6))
    assert found.findings.get("too_quiet").text.startswith("the stack is quieter than its noise")
    steps = lm.imaging.RichardsonLucy(steps=2, target=0.0)  # however many steps were asked for
    assert restored(stack, PSF, lm.Noise(read=1.6), method=steps).findings.get("too_quiet")
    assert restored(stack, PSF, lm.Noise(read=1.6, offset=100.0)).stopped == "noise"
