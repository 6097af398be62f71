"""Segments: phases, centres, what is taken from them, other light, and measures of segmented pupils."""

from __future__ import annotations

import math

import numpy as np
import pytest

import lommel as lm

RNG = np.random.default_rng(5)
SIX = lm.Segments.hexagonal(1, 0.02)
PISTONS, TIPS, TILTS = RNG.normal(size=(3, 6))
PHASED = SIX.phased(PISTONS, TIPS, TILTS)
VANE = lm.Polygon.strip((0.0, 0.0), (2.0, 0.3), 0.02)


def test_what_is_taken_away_leaves_the_other_segments_as_they_are():
    cut = PHASED - VANE
    whole = [a is b for a, b in zip(cut.shapes, SIX.shapes, strict=True)]
    assert 0 < sum(whole) < 6
    assert (cut.piston, cut.tip, cut.tilt) == (PHASED.piston, PHASED.tip, PHASED.tilt)
    np.testing.assert_array_equal(cut.centers, PHASED.centers)
    at = np.linspace(-1, 1, 81)
    expected = (SIX.margin(at, at[:, None]) > 0) & (VANE.margin(at, at[:, None]) < 0)
    np.testing.assert_array_equal(cut.margin(at, at[:, None]) > 0, expected)


def test_segments_of_which_nothing_is_left_go_with_their_phases():
    # The segments 0 and 1 have their centres at the left.
    gone = [i for i, (x, _) in enumerate(PHASED.centers) if x < -0.1]
    left = PHASED & lm.Polygon(((-0.05, -2.0), (2.0, -2.0), (2.0, 2.0), (-0.05, 2.0)))
    kept = [i for i in range(6) if i not in gone]
    assert left.piston == tuple(PISTONS[i] for i in kept)
    assert lm.Pupil(stop=left).area < lm.Pupil(stop=PHASED).area
    covered = PHASED - lm.Disc(0.5, tuple(PHASED.centers[2]))
    assert len(covered.shapes) == 5
    # Also where only the exact area shows that nothing is left, or all of it.
    hexagon = lm.Polygon.regular(6, 0.39, tuple(PHASED.centers[2]))
    assert (PHASED - hexagon).piston == covered.piston
    assert lm.Pupil(stop=PHASED - hexagon).area == pytest.approx(lm.Pupil(stop=SIX).area * 5 / 6, rel=1e-12)
    with pytest.raises(ValueError, match="other must leave some area of the segments"):
        PHASED - lm.Disc(1.5)
    with pytest.raises(TypeError, match="other must be a shape"):
        PHASED - SIX  # type: ignore[operator]


def test_in_other_light_paths_stay():
    pupil = lm.Pupil(stop=PHASED, wavelength=1e-6, f_number=20.0)
    there = pupil.in_light(2e-6)
    np.testing.assert_allclose(there.stop.piston, np.array(PISTONS) / 2)
    assert there == lm.Pupil(stop=PHASED.scaled(0.5), wavelength=2e-6, f_number=20.0)
    lens = lm.Lens(focal_length=2.0, aperture_diameter=0.1, wavelength=1e-6, stop=PHASED)
    assert lens.in_light(2e-6).pupil().stop == there.stop
    both = lm.psf(pupil, 9, 5e-6, method=lm.methods.Polychromatic([1e-6, 2e-6]), dtype="float64")
    mean = np.mean([lm.psf(one, 9, 5e-6, dtype="float64").values for one in (pupil, there)], axis=0)
    np.testing.assert_allclose(both.values, mean, atol=2e-6 * mean.max())


def test_strehl_rms_and_centroid_are_of_wavefront_and_segments():
    pupil = lm.Pupil(lm.Wavefront(nonradial={(3, 1): 0.4}), stop=PHASED)
    psf = lm.psf(pupil, 1, 0.1, normalize="strehl", dtype="float64")
    assert lm.strehl(pupil) == pytest.approx(float(psf.values[0, 0]), abs=2e-6)
    # Equal segments: the variance of pistons, and of slopes with the second moment of a hexagon, 5 a^2 / 24.
    side = math.dist(*SIX.shapes[0].corners[:2])
    slopes = np.array(TIPS) ** 2 + np.array(TILTS) ** 2
    variance = np.var(PISTONS) + slopes.mean() * 5 * side**2 / 24
    assert lm.rms(lm.Pupil(stop=PHASED)) == pytest.approx(math.sqrt(variance), rel=1e-10)
    assert lm.centroid(lm.Pupil(stop=PHASED)) == pytest.approx(np.array([TIPS.mean(), TILTS.mean()]) / math.pi)
    spread = math.sqrt(np.var(TIPS) + np.var(TILTS)) / math.pi
    assert lm.spot_radius(lm.Pupil(stop=PHASED)) == pytest.approx(spread)
    farthest = math.sqrt(slopes.max()) / math.pi
    assert lm.Pupil(stop=PHASED).geometric_radius() == pytest.approx(farthest)


@pytest.mark.parametrize("method", [lm.methods.MatrixFourier(samples=600), lm.paper.Fraunhofer()])
def test_sampled_pupils_have_the_phases(method):
    pupil = lm.Pupil(stop=PHASED)
    exact = lm.psf(pupil, 33, 0.5)
    assert lm.peak_error(lm.psf(pupil, 33, 0.5, method=method), exact) < 0.02
    assert lm.peak_error(lm.psf(lm.Pupil(stop=SIX), 33, 0.5), exact) > 0.2


@pytest.mark.parametrize("suffix", [".npz", ".npy", ".tif", ".fits", ".h5", ".mat"])
@pytest.mark.parametrize(
    "stop", [PHASED - VANE, lm.telescopes.vlt(), lm.Disc() & lm.Ellipse(0.9, 0.5, 0.3, (0.1, 0.0))]
)
def test_files_keep_the_stop(suffix, stop, tmp_path):
    psf = lm.psf(lm.Pupil(stop=stop, wavelength=1e-6, f_number=20.0), 9, 5e-6)
    psf.save(tmp_path / f"star{suffix}")
    again = lm.PSF.load(tmp_path / f"star{suffix}")
    assert again.pupil == psf.pupil
    np.testing.assert_allclose(again.values, psf.values, atol=2e-5 * psf.values.max())  # of the 16 bits of a picture
