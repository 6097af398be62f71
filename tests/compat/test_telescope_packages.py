"""PSFs as models and arrays of photutils and GalSim, read back by these where they are there."""

from __future__ import annotations

import numpy as np
import pytest

import lommel as lm
from lommel.compat import galsim, photutils

pytestmark = pytest.mark.filterwarnings("ignore")

LENS = lm.Pupil(lm.Wavefront.zernike({(2, 2): 0.3, (3, 1): -0.2}), obscuration=0.3, wavelength=550e-9, f_number=8.0)
FIELD = lm.FieldMap.from_seidel(3e-3, W131=1.0, W222=0.5, W220=0.3, wavelength=550e-9, f_number=8.0)
SENSOR = {"sensor": (2e-3, 3e-3), "shape": 11, "pixel": 5e-6}


@pytest.mark.parametrize("times", [1, 3, 4])
def test_an_effective_psf_holds_the_averages_over_pixels_at_every_subpixel(times):
    epsf = photutils.effective_psf(LENS, 11, 5e-6, oversampling=times)
    assert epsf.shape == (10 * times + 1,) * 2
    middle = 5 * times
    for i, j in ((0, 0), (1, -2), (-times, times)):
        star = lm.psf(LENS, 11, 5e-6, center=(5 - i / times, 5 - j / times)).values
        assert epsf[middle + i, middle + j] == pytest.approx(star[5, 5], abs=2e-6 * float(epsf.max()))


def test_a_stack_and_seeing_are_taken():
    stack = lm.Pupil(lm.Wavefront(defocus=[0.0, 3.0]), wavelength=550e-9, f_number=8.0)
    both = photutils.effective_psf(stack, 9, 5e-6, oversampling=2, blur=lm.Jitter(2e-6))
    one = photutils.effective_psf(stack[1], 9, 5e-6, oversampling=2, blur=lm.Jitter(2e-6))
    np.testing.assert_allclose(both[1], one, rtol=0.0, atol=2e-6 * one.max())
    assert np.abs(both[0] - one).max() > 0.1 * one.max()


def test_a_stdpsf_file_holds_the_psfs_of_its_pixels(tmp_path):
    fits = pytest.importorskip("astropy.io.fits")
    photutils.save_stdpsf(tmp_path / "grid.fits", FIELD, 2, 3, **SENSOR)
    with fits.open(tmp_path / "grid.fits") as file:
        header, data = file[0].header, np.array(file[0].data)
    assert [header[name] for name in ("NAXIS3", "NYPSFS", "NXPSFS")] == [6, 2, 3]
    assert [header[f"IPSFX0{k}"] for k in (1, 2, 3)] == [1, 301, 600]
    assert [header[f"JPSFY0{k}"] for k in (1, 2)] == [1, 400]
    # The last of the first row: column 599 and row 0 from the middle of the first pixel.
    pupil = FIELD.pupil((599 - 299.5) * 5e-6, (0 - 199.5) * 5e-6)
    right = photutils.effective_psf(pupil, 11, 5e-6)
    np.testing.assert_allclose(data[2], right, rtol=0.0, atol=2e-6 * right.max())


def test_photutils_places_stars_where_lommel_does():
    pytest.importorskip("photutils")
    model = photutils.image_psf(LENS, 31, 5e-6, oversampling=8)
    y, x = np.mgrid[:31, :31]
    right = lm.psf(LENS, 31, 5e-6, center=(14.7, 15.4)).values
    np.testing.assert_allclose(model.evaluate(x, y, 1.0, 15.4, 14.7), right, rtol=0.0, atol=1e-3 * right.max())
    grid = photutils.gridded_psf_model(FIELD, 2, 3, **SENSOR | {"shape": 31}, oversampling=8)
    star = lm.psf(FIELD.pupil((300 - 299.5) * 5e-6, (399 - 199.5) * 5e-6), 31, 5e-6, center=(14.7, 15.4)).values
    found = grid.evaluate(x + 285, y + 384, 1.0, 300.0, 399.0 - 0.0)
    still = lm.psf(FIELD.pupil((300 - 299.5) * 5e-6, (399 - 199.5) * 5e-6), 31, 5e-6).values
    np.testing.assert_allclose(found, still, rtol=0.0, atol=1e-3 * star.max())


def test_photutils_reads_the_files(tmp_path):
    peer = pytest.importorskip("photutils.psf")
    photutils.save_stdpsf(tmp_path / "grid.fits", FIELD, 2, 3, **SENSOR)
    read = peer.GriddedPSFModel.read(tmp_path / "grid.fits", format="stdpsf")
    made = photutils.gridded_psf_model(FIELD, 2, 3, **SENSOR)
    np.testing.assert_array_equal(read.grid_xypos, made.grid_xypos)
    np.testing.assert_allclose(read.data, made.data, rtol=1e-6)


def test_galsim_draws_the_pixels_of_lommel():
    peer = pytest.importorskip("galsim")
    fine = lm.psf(LENS, 301, 1e-6, integrate=False)
    profile = galsim.interpolated_image(fine, focal_length=2.0)
    image = peer.Image(21, 21, scale=5e-6 / 2.0 * 206264.80624709636)
    profile.drawImage(image)
    right = lm.psf(LENS, 21, 5e-6).values
    np.testing.assert_allclose(image.array, right, rtol=0.0, atol=2e-3 * right.max())


@pytest.mark.parametrize(
    ("call", "said"),
    [
        (lambda: photutils.effective_psf(LENS, 10, 5e-6), "shape must be odd"),
        (lambda: photutils.effective_psf(LENS, 11, 5e-6, center=(5, 5)), "center must be left out"),
        (lambda: photutils.effective_psf(LENS, 11, 5e-6, oversampling=0), "oversampling must be"),
        (lambda: photutils.save_stdpsf("x.fits", FIELD, 1, 3, **SENSOR), "rows must be"),
        (lambda: photutils.save_stdpsf("x.fits", FIELD, 2, 3, **SENSOR | {"sensor": (9e-3, 9e-3)}), "outside of"),
    ],
)
def test_bad_arguments_are_named(call, said):
    with pytest.raises(ValueError, match=said):
        call()


def test_what_is_missing_is_said_with_the_package_that_brings_it(monkeypatch):
    monkeypatch.setitem(__import__("sys").modules, "galsim", None)
    with pytest.raises(ImportError, match="galsim: pip install galsim"):
        galsim.interpolated_image(lm.psf(LENS, 9, 5e-6), focal_length=1.0)
