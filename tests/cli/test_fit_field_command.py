"""The command for field maps, from images of stars to a table that a lens file reads."""

from __future__ import annotations

import json
import re

import numpy as np
import pytest
from astropy.io import fits

import lommel as lm
import simulated_fields as simulated
from lommel.lensfiles.lens_files import load_instrument

LENS = """
[lens]
wavelength = "550 nm"
focal_length = "800 mm"
f_number = 8.0
focus_distance = inf

[object]
distance = inf

[sensor]
pixel = "2.2 um"
shape = 21
"""
FIELD = """
[field]
sensor = ["484 um", "484 um"]
file = "field.csv"
unit = "waves"
"""


@pytest.fixture(scope="module")
def night(tmp_path_factory):
    """Return a folder with two exposures of 16 stars through a lens with coma, and the lens file."""
    folder = tmp_path_factory.mktemp("night")
    field = lm.FieldMap.from_seidel(350e-6, W131=0.8, W220=0.5, wavelength=550e-9, f_number=8.0)
    at = np.stack(np.meshgrid([30, 83, 136, 189], [30, 83, 136, 189]), axis=-1).reshape(-1, 2)
    stack = []
    for k, defocus in enumerate((-2.5, 2.5)):
        mean = np.full((220, 220), 20.0)
        pupil = (field + lm.Wavefront(defocus)).pupil(*((at[:, ::-1] - 109.5) * 2.2e-6).T)
        for (row, column), star in zip(at, lm.psf(pupil, 33, 2.2e-6).values, strict=True):
            mean[row - 16 : row + 17, column - 16 : column + 17] += 4e4 * star
        stack.append(lm.Noise(read=2.0).record(mean, seed=k).astype(np.float32))
    np.save(folder / "stars.npy", np.stack(stack))
    np.save(folder / "outside.npy", stack[0])
    np.save(folder / "clipped.npy", np.minimum(stack, np.float32(900.0)))
    bad = np.stack(stack)
    bad[:, 80:84, 86:90] = bad[:, 30:60, 100:] = bad[0, 138, 138] = np.nan
    np.save(folder / "holes.npy", bad)
    flaws = np.zeros((220, 220), dtype=bool)
    flaws[20:40, 20:30] = flaws[100, 100] = True
    np.save(folder / "flaws.npy", flaws)
    (folder / "lens.toml").write_text(LENS, encoding="utf-8")
    return folder


def test_images_become_a_table_that_the_lens_file_reads(night, call_lommel):
    fits.writeto(night / "stars.fits", np.load(night / "stars.npy"))
    foci = ("--defocus", -2.5, 2.5, "--read", 2, "--window", 25, "--degree", 2)
    call = ("fit-field", "stars.fits", "lens.toml", *foci)
    written = ("-o", "field.csv", "--plot", "field.png", "--spots", "spots.png")
    options = (*call, "--terms", 5, "--known-blur", 0, *written)
    text = call_lommel(*options, folder=night).stdout
    assert "converged: " in text
    assert "16 spots found; refused: none" in text
    assert "waves rms, top right corner" in text  # FITS files are shown with the first row at the bottom
    assert (night / "field.png").stat().st_size > 10_000
    (night / "fitted.toml").write_text(LENS + FIELD, encoding="utf-8")
    found = load_instrument(night / "fitted.toml").aberrations_of_field.pupil(150e-6, -100e-6).wavefront
    true = lm.FieldMap.from_seidel(350e-6, W131=0.8, W220=0.5, wavelength=550e-9, f_number=8.0)
    edge = true.pupil(150e-6, -100e-6).wavefront.edge_terms()
    for term in ((2, 0), (3, 1), (3, -1)):
        assert abs(found.edge_terms()[term] - edge[term]) < 0.1


def test_a_misfit_is_the_first_word_and_said_of_what_is_written_and_has_exit_code_3(night, call_lommel):
    options = ("--defocus", -2.5, 2.5, "--read", 2, "--window", 25, "--degree", 0, "--terms", 1, "--known-blur", 0)
    call = ("fit-field", "stars.npy", "lens.toml", *options, "-o", "wrong.csv")
    result = call_lommel(*call, folder=night)
    assert result.returncode == 3, result.stderr
    assert result.stdout.startswith("misfit: ")
    assert "wrote wrong.csv, of a fit that has not converged: misfit" in result.stdout
    assert (night / "wrong.csv").read_text(encoding="utf-8").startswith("# misfit: ")


FOCI = ("--defocus", -2.5, 2.5, "--read", 2, "--window", 25, "--degree", 2, "--terms", 5, "--known-blur", 0)


def test_pixels_that_are_masked_or_nan_are_left_out_and_counted(night, call_lommel):
    call = ("fit-field", "holes.npy", "lens.toml", *FOCI, "--mask", "flaws.npy")
    found = json.loads(call_lommel(*call, "--json", folder=night).stdout)
    assert found["converged"], found["message"]
    assert found["stars"] == 13
    assert [each["reason"] for each in found["refused"]] == ["masked"] * 3
    assert found["left_out"] == 2 * (200 + 1 + 16 + 30 * 120) + 1
    assert "33 of 16250 pixels left out" in found["message"]
    text = call_lommel(*call, folder=night).stdout
    assert "13 spots found; refused: 3 masked; 7635 pixels left out (masked or NaN)" in text
    assert "waves rms, bottom right corner" in text
    assert re.search(r"^ *29 +29 +masked$", text, re.MULTILINE)


def test_coma_and_focus_in_the_middle_are_within_their_errors(night, call_lommel):
    options = ("--defocus", -2, "--read", 2, "--window", 25, "--degree", 2, "--terms", 5, "--known-blur", 0)
    call = ("fit-field", "outside.npy", "lens.toml", *options, "--json")
    found = json.loads(call_lommel(*call, folder=night).stdout)
    focus, coma = found["focus"], found["coma"]
    shift = -2.5 * 8.0 * 550e-9 * 8.0**2 / np.pi
    assert abs(focus["shift"] - shift) < 4.0 * focus["error"] < 0.05 * abs(shift)
    assert coma["waves"] < 5.0 * coma["error"]


@pytest.fixture(scope="module")
def chart(tmp_path_factory):
    """Return a folder with a picture of a checkerboard by other code, and its lens file."""
    folder = tmp_path_factory.mktemp("chart")

    def waves(u, v):
        return np.stack([0.6 + 0.4 * u, 0.3 * v, -0.3 + 0.2 * u], axis=-1)

    options = {"pixel": 0.5, "sigma": 0.6, "pitch": 30.0, "vignetting": 0.4}
    draw = np.random.default_rng(5)
    image, _ = simulated.chart(draw, (110, 140), waves, simulated.Telescope(3, side=64), **options)
    np.save(folder / "chart.npy", image.astype(np.float32))
    np.save(folder / "blank.npy", np.full((110, 140), 900.0, np.float32))
    (folder / "lens.toml").write_text(LENS, encoding="utf-8")
    return folder


def test_a_picture_of_a_checkerboard_becomes_a_table(chart, call_lommel):
    options = ("--targets", "crossing", "--read", 2, "--degree", 1, "--terms", 3, "--saturation", 60000)
    written = ("--distortion", 1, "-o", "field.csv", "--twin", "twin.csv", "--spots", "spots.png", "--json")
    found = json.loads(call_lommel("fit-field", "chart.npy", "lens.toml", *options, *written, folder=chart).stdout)
    assert found["converged"], found["message"]
    assert "crossings, degree 1" in found["message"]
    assert found["stars"] >= 9
    bent = found["distortion"]
    assert abs(bent["spacing"] - 30.0) < 0.02
    assert abs(abs(bent["rotation"]) - 0.08) < 0.002
    for each in bent["pixels"].values():
        assert (np.abs(each["displacement"]) < 4.0 * np.array(each["errors"]) + 1e-9).all()
        assert max(each["errors"]) < 0.1
    text = (chart / "field.csv").read_text(encoding="utf-8")
    assert text.startswith("# converged, but in doubt: ")
    assert "x,y,Z2,Z3,Z4" in text
    assert (chart / "spots.png").stat().st_size > 5_000


def test_a_picture_of_pinholes_becomes_a_table(tmp_path, call_lommel):
    draw, scope, radius = np.random.default_rng(2), simulated.Telescope(3, side=64), 2.0
    image = np.full((110, 145), 20.0)

    def waves(u, v):
        return np.stack([0.9 + 0.4 * u, 0.4 * v, -0.3 + 0.2 * u], axis=-1)

    for row in (18, 55, 92):
        for column in (18, 72, 127):
            place = draw.uniform(-0.5, 0.5, 2)

            def hole(y, x, place=place):
                return 1.0 * (np.hypot(y - place[0], x - place[1]) < radius)

            u, v = 2.0 * (column + 0.5) / 145 - 1.0, 2.0 * (row + 0.5) / 110 - 1.0
            seen = simulated.extended(hole, scope, waves(u, v), 0.5, 33, 0.6, over=5, reach=9.0)
            image[row - 16 : row + 17, column - 16 : column + 17] += 2e4 * seen
    np.save(tmp_path / "holes.npy", (draw.poisson(image) + draw.normal(size=image.shape) * 2.0).astype(np.float32))
    (tmp_path / "lens.toml").write_text(LENS, encoding="utf-8")
    options = ("--targets", "pinhole", "--size", "8.8um", "--read", 2, "--degree", 1, "--terms", 3)
    written = ("--window", 29, "-o", "field.csv", "--twin", "twin.csv", "--json")
    call = ("fit-field", "holes.npy", "lens.toml", *options, *written)
    found = json.loads(call_lommel(*call, folder=tmp_path).stdout)
    assert found["converged"], found["message"]
    assert "of 9 pinholes, degree 1" in found["message"]
    assert abs(found["blur"][0][0]["sigma"] - 0.6 * 2.2e-6) < 5.0 * found["blur_errors"][0][0]
    true, off = {"middle": waves(0.0, 0.0), "corner": waves(1.0, 1.0)}, []
    for sign in (1.0, -1.0):
        apart = [sign * true[name] / (2.0 * np.pi) - of["coefficients"] for name, of in found["waves"].items()]
        off.append(np.max(np.abs(apart) / [of["errors"] for of in found["waves"].values()]))
    assert min(off) < 4.0 < max(off)
