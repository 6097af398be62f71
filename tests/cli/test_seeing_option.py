"""`lommel psf --seeing --jitter`: the images that Python has, said in the report."""

from __future__ import annotations

import math

import numpy as np
import pytest

import lommel as lm

ARCSEC = math.pi / 648000.0
TELESCOPE = """\
[lens]
focal_length = "8 m"
aperture_diameter = "1 m"
wavelength = "600 nm"
obscuration = 0.3

[sensor]
pixel = "9 um"
"""


@pytest.fixture
def asked(call_lommel, tmp_path):
    (tmp_path / "telescope.toml").write_text(TELESCOPE, encoding="utf-8")
    return lambda *options: call_lommel("psf", "telescope.toml", *options, folder=tmp_path)


def test_the_image_behind_seeing_and_jitter_is_that_of_python(asked, tmp_path):
    options = "--seeing", 1.2, "--outer-scale", "25m", "--jitter", 0.3, "--shape", 25, "--tol", 1e-4, "-o", "seen.npz"
    result = asked(*options)
    assert result.returncode == 0, result.stderr
    assert "seeing of 1.2 arcsec at 500 nm, outer scale 25 m and jitter of 0.3 arcsec rms" in result.stdout
    pupil = lm.load_instrument(tmp_path / "telescope.toml").pupil()
    air = lm.Seeing.from_fwhm(1.2 * ARCSEC, focal_length=8.0, outer_scale=25.0)
    blur = air, lm.Jitter(0.3 * ARCSEC * 8.0)
    expected = lm.psf(pupil, 25, 9e-6, blur=blur, tol=1e-4, integrate=True)
    np.testing.assert_array_equal(lm.PSF.load(tmp_path / "seen.npz").values, expected.values)


def test_the_window_holds_the_light_that_seeing_spreads(asked, tmp_path):
    assert asked("--seeing", 2.0, "--tol", 1e-4, "-o", "seen.npz").returncode == 0
    assert lm.PSF.load(tmp_path / "seen.npz").energy > 0.95


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (("--outer-scale", "25m"), "--outer-scale needs --seeing"),
        (("--seeing", 1.0, "--mtf"), "leave out --field, --colour and --mtf"),
        (("--jitter", 1.0, "--field", "3x3"), "leave out --field, --colour and --mtf"),
        (("--seeing", 0), "is not in the range"),
    ],
)
def test_what_has_no_such_blur_is_refused(asked, options, message):
    result = asked(*options)
    assert result.returncode != 0
    assert message in " ".join(result.stderr.split())
