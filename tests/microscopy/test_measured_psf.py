"""Measured PSFs against Gaussian beads, whose voxels are differences of error functions."""

from __future__ import annotations

import warnings

import numpy as np
import pytest
import tifffile
from scipy.special import erf

import lommel as lm
from lommel.microscopy.bead_average import measured_psf
from simulated_stacks import _intensity

PIXEL, STEP, WIDTHS = 0.1e-6, 0.2e-6, (0.4e-6, 0.2e-6, 0.2e-6)  # standard deviations along z, y and x


def gaussian(shape, place, pixel=PIXEL, step=STEP):
    """Return the light of a point, metres from the first voxel, in each: averages over pixels, samples along z."""
    planes = np.exp(-0.5 * ((np.arange(shape[0]) * step - place[0]) / WIDTHS[0]) ** 2)
    sides = []
    for side, at, sigma in zip(shape[1:], place[1:], WIDTHS[1:], strict=True):
        edges = ((np.arange(side + 1) - 0.5) * pixel - at) / (np.sqrt(2.0) * sigma)
        sides.append(0.5 * np.diff(erf(edges)))
    return planes[:, None, None] * sides[0][:, None] * sides[1]


def centred(shape, pixel=PIXEL, step=STEP):
    values = gaussian(
        shape, [side // 2 * size for side, size in zip(shape, (step, pixel, pixel), strict=True)], pixel, step
    )
    return values / values.sum()


def wrong(found, truth):
    """Return the light in wrong voxels."""
    return 0.5 * np.abs(found - truth).sum()


def field(photons=4e3, seed=3):
    """Return the stack of nine beads between voxels, and one at the edge."""
    rng, mean = np.random.default_rng(seed), np.full((15, 120, 120), 5.0)
    rows, columns = np.meshgrid([24, 60, 96], [24, 60, 96])
    for row, column in [*zip(rows.ravel(), columns.ravel(), strict=True), (42, 1)]:
        place = (np.array([7.0, row, column]) + rng.uniform(-0.5, 0.5, 3)) * (STEP, PIXEL, PIXEL)
        mean += photons * rng.uniform(0.7, 1.3) * gaussian(mean.shape, place)
    return rng.poisson(mean) + 100


def test_beads_are_found_and_averaged():
    found = lm.PSF.measured(field(), PIXEL, STEP)
    numbers = {finding.code: finding.numbers for finding in found.findings}
    assert found.beads == numbers["measured_psf"]["beads"] == 9
    assert numbers["left_out"] == {"edge": 1}
    assert found.values.sum() == pytest.approx(1.0)
    assert found.values.min() == 0.0
    assert wrong(found.values, centred(found.values.shape)) < 0.03
    assert 0.005 < numbers["measured_psf"]["noise"] < 0.05


def test_a_step_unlike_that_of_the_file_is_told(tmp_path):
    light = (1e5 * centred((9, 15, 15))).astype(np.float32)
    facts = {"spacing": 1e6 * STEP, "unit": "um", "axes": "ZYX"}
    tifffile.imwrite(
        tmp_path / "bead.tif", light, imagej=True, resolution=(1e-6 / PIXEL, 1e-6 / PIXEL), metadata=facts
    )
    with pytest.warns(UserWarning, match=r"images of the PSF state .* 200 nm.*, but 220 nm was used"):
        found = measured_psf(tmp_path / "bead.tif", PIXEL, 1.1 * STEP)
    assert found.step == 1.1 * STEP
    assert (found.findings[0].code, found.findings[0].severity) == ("contradiction", "doubt")
    assert "lengths of the PSF along z are 1.1 times as long" in found.findings[0].text
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert measured_psf(tmp_path / "bead.tif").step == pytest.approx(STEP)


def test_a_bead_unlike_the_others_is_left_out():
    stack = field(2e4)
    stack[:, 62:, 60:] += np.random.default_rng(0).poisson(2e4 * gaussian((15, 58, 60), (7 * STEP, 0.0, 0.0)))
    found = lm.PSF.measured(stack, PIXEL, STEP)
    assert found.beads == 8
    assert found.findings[1].numbers["unlike the others"] == 1


def test_a_psf_of_a_program_stays_as_it_is():
    """Without noise the filter passes all, and the point is moved to the middle voxel."""
    values = 3.0 * gaussian((11, 19, 20), (5.3 * STEP, 9.2 * PIXEL, 8.9 * PIXEL)) + 7.0
    found = lm.PSF.measured(values, PIXEL, STEP)
    assert (found.beads, found.values.shape) == (1, (11, 19, 19))
    assert wrong(found.values, centred(found.values.shape)) < 0.01
    assert "a single image" in str(found.findings[0])


def test_the_diameter_of_a_bead_is_removed():
    diameter, nodes = 0.25e-6, np.linspace(-1.0, 1.0, 13)
    inside = [p for p in np.stack(np.meshgrid(nodes, nodes, nodes), -1).reshape(-1, 3) if p @ p <= 1.0]
    middle = np.array([6 * STEP, 10 * PIXEL, 10 * PIXEL])
    bead = sum(gaussian((13, 21, 21), middle + 0.5 * diameter * np.array(p)) for p in inside)
    truth = centred((13, 21, 21))
    bare, removed, large = (
        lm.PSF.measured(bead, PIXEL, STEP, background=0.0, diameter=d) for d in (None, diameter, 2e-6)
    )
    assert wrong(bare.values, truth) > 5.0 * wrong(removed.values, truth)
    assert "not stated" in str(bare.findings[0])
    assert "250 nm was removed" in str(removed.findings[0])
    assert "too large" in str(large.findings[0])
    np.testing.assert_allclose(large.values, bare.values, atol=1e-12)


@pytest.mark.parametrize("ratios", [(1.3, 1.37), (0.7, 0.8)])
def test_voxels_of_the_recording(ratios):
    """Values of other pixels are averages over these."""
    found = lm.PSF.measured(centred((25, 33, 33)), PIXEL, STEP, background=0.0)
    pixel, step = ratios[1] * PIXEL, ratios[0] * STEP
    other = found.resampled(pixel, step)
    assert (other.pixel, other.step) == (pixel, step)
    assert wrong(other.values, centred(other.values.shape, pixel, step)) < 1e-3
    assert "resampled" in str(other.findings[-1])
    assert found.resampled(PIXEL, STEP) is found


def test_the_objective_tells_background_from_light_out_of_focus():
    """In a window that the cone of light fills, the outer pixels are no background."""
    objective = lm.Objective(NA=1.4, magnification=63, immersion=1.518, working_distance=0.19e-3, sample=1.33)
    microscope = lm.Microscope(objective, wavelength=520e-9, pixel=63 * PIXEL)
    radii = PIXEL * np.hypot(*(np.indices((21, 21)) - 10))
    light = np.array([_intensity(radii.ravel(), 0.0, z, 520e-9).reshape(21, 21) for z in (np.arange(11) - 5) * STEP])
    light *= 1e4 / light[5].sum()
    with_lens, without = (
        measured_psf(light + 40.0, PIXEL, STEP, microscope=one).values.sum(axis=(1, 2)) for one in (microscope, None)
    )
    expected = light.sum(axis=(1, 2)) / light.sum()
    assert np.abs(with_lens - expected).max() < 0.1 * expected.max()
    assert with_lens[0] > without[0]


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"pixel": None}, "pixel of the PSF must be stated"),
        ({"step": None}, "step of the PSF must be stated"),
        ({"array": np.ones((4, 9, 9))}, "5 voxels or more"),
        ({"array": np.ones((9, 9, 9))}, "array must show a bead in focus"),
        (
            {"array": np.random.default_rng(1).normal(3.0 * centred((9, 21, 21)) / 0.01)},
            "8 standard deviations above",
        ),
        ({"array": gaussian((9, 21, 21), (0.0, 10 * PIXEL, 10 * PIXEL))}, "in plane 0 of 9"),
        ({"array": centred((9, 13, 13)) + 4e-3, "background": 0.0}, "at most 20 %"),
        ({"diameter": -1.0}, "diameter must be"),
        ({"background": np.nan}, "background must be"),
        ({"array": np.ones((2, 9, 9, 9))}, "array must be one channel"),
    ],
)
def test_refused(changes, message):
    given = {"array": centred((9, 21, 21)), "pixel": PIXEL, "step": STEP} | changes
    with pytest.raises(ValueError, match=message):
        lm.PSF.measured(given.pop("array"), given.pop("pixel"), given.pop("step"), **given)


def test_of_another_type():
    with pytest.raises(TypeError, match="microscope must be a Microscope"):
        lm.PSF.measured(centred((9, 21, 21)), PIXEL, STEP, microscope=lm.Jitter(1e-6))


METHOD = {"noise": lm.Noise(read=1.0), "diagnosis": False, "method": lm.imaging.RichardsonLucy(steps=2, target=0.0)}
MEASURED = lm.PSF.measured(centred((11, 13, 13)), PIXEL, STEP, background=0.0)


def stack_of_a_point():
    return np.random.default_rng(0).poisson(1e4 * centred((11, 15, 15)) + 5.0)


def test_a_stack_without_voxels_has_those_of_the_psf():
    found = lm.microscopy.deconvolve(stack_of_a_point(), MEASURED, **METHOD)
    assert "The stack does not state its step: that of the PSF was used, 200 nm." in found.notes
    assert "measured_psf" in [finding.code for finding in found.findings]
    assert np.unravel_index(found.values.argmax(), found.values.shape) == (5, 7, 7)


def test_the_unit_of_a_restored_point_is_in_the_notes():
    """Planes of equal light, as of a wide-field microscope, or of light that falls off as `gaussian` along z."""
    y, x = np.mgrid[-6:7, -6:7]
    widths = np.hypot(1.5, 0.25 * (np.arange(11) - 5))[:, None, None]
    light = np.exp(-0.5 * (x**2 + y**2) / widths**2)
    psf = lm.PSF.measured(light / light.sum(axis=(1, 2), keepdims=True), PIXEL, STEP, background=0.0)
    falling = centred((11, 13, 13)).sum(axis=(1, 2))
    for given, value in (
        (psf, "each plane (if it fades, into their mean) has the value 11 F"),
        (
            MEASURED,
            f"the plane in focus has the value {falling.sum() / falling.max():.2f} F",
        ),
    ):
        notes = lm.microscopy.deconvolve(stack_of_a_point(), given, **METHOD).notes
        assert any(
            f"11 planes of 13 x 13 pixels of its PSF together: a point that sends F counts into {value}." in n
            for n in notes
        )


def test_a_psf_is_resampled_to_the_stack():
    found = lm.microscopy.deconvolve(stack_of_a_point(), MEASURED, step=1.5 * STEP, **METHOD)
    assert any("resampled" in str(finding) for finding in found.findings)


def test_each_channel_has_its_psf():
    stack = np.stack([stack_of_a_point()] * 2)
    assert len(lm.microscopy.deconvolve(stack, [MEASURED, MEASURED], **METHOD).channels) == 2
    with pytest.raises(ValueError, match="one PSF for each channel of the stack, channel 0, channel 1, got 1"):
        lm.microscopy.deconvolve(stack, MEASURED, **METHOD)
    with pytest.raises(ValueError, match="pixel needs the magnification"):
        lm.microscopy.deconvolve(stack_of_a_point(), MEASURED, pixel=6e-6, **METHOD)
    with pytest.raises(ValueError, match="depth must not be given with a PSF"):
        lm.microscopy.deconvolve(stack_of_a_point(), MEASURED, depth=1e-6, **METHOD)
    with pytest.raises(ValueError, match="direction needs an objective"):
        lm.microscopy.deconvolve(stack_of_a_point(), MEASURED, direction="down", **METHOD)


def test_noise_of_a_measured_psf_is_not_light():
    """Negative values that are set to 0 would leave the positive noise beside them."""
    draw = np.random.default_rng(3)
    y, x = np.mgrid[-20:21, -20:21]
    spot = np.exp(-0.5 * (x**2 + y**2) / 4.0)
    noisy = 4000.0 * spot + draw.normal(0.0, 100.0, spot.shape)
    values = lm.PSF.measured(noisy, 1e-6).values[0]
    inside = np.hypot(x, y) < 7.0
    assert values[inside].sum() > 0.95
    assert values.min() >= 0.0
