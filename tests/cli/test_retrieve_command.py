"""`lommel retrieve`, run as a user runs it."""

from __future__ import annotations

import json

import numpy as np
import pytest
import tifffile

import lommel as lm

LENS = """
[lens]
focal_length = "20 mm"
f_number = 4.0
wavelength = "550 nm"
[sensor]
pixel = "1.1 um"
shape = 33
"""
NOISE = ["--read", "2", "--gain", "0.5", "--offset", "100"]


@pytest.fixture
def folder(tmp_path):
    """A lens file and three images of a star, in files and as pages of one."""
    (tmp_path / "lens.toml").write_text(LENS, encoding="utf-8")
    light = lm.Pupil(lm.Wavefront([-4.0, 0.0, 4.0], nonradial={(3, 1): 0.6}), wavelength=550e-9, f_number=4.0)
    mean = 5e4 * lm.psf(light, 33, 1.1e-6).values + 5.0
    images = np.round(lm.Noise(white=0.5, read=2.0, offset=100.0).record(mean, seed=1)).astype(np.uint16)
    for k, image in enumerate(images):
        tifffile.imwrite(tmp_path / f"star-{k}.tif", image)
    tifffile.imwrite(tmp_path / "pages.tif", images, photometric="minisblack")
    return tmp_path


def test_terms_come_with_deviations_after_the_verdict(folder, call_lommel):
    result = call_lommel("retrieve", "star-*.tif", "lens.toml", "--defocus", -4, 0, 4, *NOISE, "--terms", 6,
                         "-o", "wave.json", "--plot", "fit.png", folder=folder)  # fmt: skip
    assert result.returncode == 0, result.stderr
    lines = result.stdout.splitlines()
    (coma,) = [line.split() for line in lines if "noll 8 coma x" in line]
    true = 0.6 / np.sqrt(8.0)
    value, error, unit = coma[-3:]
    assert float(value) == pytest.approx(true, abs=5 * float(error))
    assert unit == "rad"
    assert lines[0].startswith("converged: chi2 ")
    assert lines[-2:] == ["wrote wave.json", "wrote fit.png: square roots of images and model"]
    assert (folder / "fit.png").stat().st_size > 10_000
    # A lens file reads it back, and what it makes has the coma.
    (folder / "again.toml").write_text(LENS + '[aberrations.zernike]\nfile = "wave.json"\n', encoding="utf-8")
    assert call_lommel("psf", "again.toml", "-o", "psf.npz", folder=folder).returncode == 0
    saved = json.loads((folder / "wave.json").read_text(encoding="utf-8"))
    assert list(saved["terms"]) == list(saved["standard_errors"]) == [str(j) for j in range(4, 10)]
    assert saved["standard_errors"]["8"] == pytest.approx(float(error) / (2 * np.pi), rel=0.1)
    kept = lm.PSF.load(folder / "psf.npz").pupil.wavefront.to_zernike(order="noll")
    assert float(kept[8]) == pytest.approx(true, abs=0.02)


def test_doubtful_standard_errors_are_said_in_the_verdict(folder, call_lommel):
    light = lm.Pupil(lm.Wavefront([-4.0, 0.0, 4.0], nonradial={(3, 1): 0.6}), wavelength=550e-9, f_number=4.0)
    mean = 1000.0 * lm.psf(light, 25, 1.1e-6).values + 20.0
    np.save(folder / "dim.npy", lm.Noise(read=2.0).record(mean, seed=4))
    options = ["dim.npy", "lens.toml", "--defocus", -4, 0, 4, "--read", 2]
    shown = " ".join(call_lommel("retrieve", *options, folder=folder).stdout.split())
    said = "converged, but in doubt: chi2"
    assert said in shown
    found = json.loads(call_lommel("retrieve", *options, "--json", folder=folder).stdout)
    assert found["converged"]
    assert not found["reliable"]
    assert found["message"].startswith(said)
    assert [each["code"] for each in found["findings"]] == ["too_dim", "untested"]
    assert "too dim: " in shown


def test_what_images_do_not_tell_is_null(folder, call_lommel):
    options = [*NOISE, "--terms", "spherical", "--also", "f_number, wavelength", "--json"]
    found = json.loads(call_lommel("retrieve", "star-2.tif", "lens.toml", *options, folder=folder).stdout)
    assert found["errors"]["wavelength"] is None


def test_terms_are_taken_by_the_names_that_are_printed(folder, call_lommel):
    options = ["pages.tif", "lens.toml", "--defocus", -4, 0, 4, *NOISE, "--json", "--terms"]
    by_index = json.loads(call_lommel("retrieve", *options, "noll 4, noll 8, noll 11", folder=folder).stdout)
    printed = "noll 4 defocus, coma x, noll 11 spherical"
    assert json.loads(call_lommel("retrieve", *options, printed, folder=folder).stdout) == by_index
    # These two alone are coefficients of powers, not of Zernike terms.
    plain = json.loads(call_lommel("retrieve", *options, "defocus, spherical", folder=folder).stdout)
    assert list(plain["coefficients"]) == ["defocus", "spherical", "noll 8"]  # coma of the stars is estimated besides


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["pages.tif", "lens.toml", "--read", "2", "--defocus", "-4", "0"], "one for each of 3 images"),
        (
            ["star-0.tif", "lens.toml", "--read", "2", "--blur", "--also", "f_number"],
            "fitted with center alone",
        ),
    ],
)
def test_what_would_fit_something_else_is_refused(words, said, folder, call_lommel):
    result = call_lommel("retrieve", *words, folder=folder)
    assert result.returncode == 2
    assert said in result.stderr


def test_a_star_of_large_images_is_cut_out(folder, call_lommel):
    corners = ((10, 70), (55, 3), (40, 40))
    for k, (row, column) in enumerate(corners):
        sky = np.full((90, 120), 110, np.uint16)
        sky[row : row + 33, column : column + 33] = tifffile.imread(folder / f"star-{k}.tif")
        tifffile.imwrite(folder / f"large-{k}.tif", sky)
    options = ["lens.toml", "--defocus", -4, 0, 4, *NOISE, "--terms", "coma x", "--json"]
    small, large = (
        json.loads(call_lommel("retrieve", *files, *options, folder=folder).stdout)
        for files in (["star-*.tif"], ["large-*.tif", "--window", 31])
    )
    (coma,), (same,) = (facts["coefficients"].values() for facts in (large, small))
    assert coma == pytest.approx(same, abs=0.02)
    assert np.array(large["center"]) == pytest.approx(np.add(small["center"], corners), abs=0.1)
    assert any("Windows of 31 x 31 pixels" in note for note in large["notes"])
    unstated = json.loads(call_lommel("retrieve", "large-*.tif", *options, folder=folder).stdout)
    assert any("Windows of 47 x 47 pixels" in note for note in unstated["notes"])
    assert not any("Windows" in note for note in small["notes"])
