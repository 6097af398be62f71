"""The command for field maps, from images of stars to a table that a lens file reads."""

from __future__ import annotations

import json

import numpy as np
import pytest

import lommel as lm
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
    (folder / "lens.toml").write_text(LENS, encoding="utf-8")
    return folder


def test_images_become_a_table_that_the_lens_file_reads(night, call_lommel):
    call = ("fit-field", "stars.npy", "lens.toml", "--defocus", -2.5, 2.5, "--read", 2, "--window", 25, "--degree", 2)
    written = ("-o", "field.csv", "--plot", "field.png", "--spots", "spots.png")
    options = (*call, "--terms", 5, "--known-blur", 0, *written)
    text = call_lommel(*options, folder=night).stdout
    assert "converged: " in text
    assert "16 spots found; refused: none" in text
    assert (night / "field.png").stat().st_size > 10_000
    (night / "fitted.toml").write_text(LENS + FIELD, encoding="utf-8")
    found = load_instrument(night / "fitted.toml").aberrations_of_field.pupil(150e-6, -100e-6).wavefront
    true = lm.FieldMap.from_seidel(350e-6, W131=0.8, W220=0.5, wavelength=550e-9, f_number=8.0)
    edge = true.pupil(150e-6, -100e-6).wavefront.edge_terms()
    for term in ((2, 0), (3, 1), (3, -1)):
        assert abs(found.edge_terms()[term] - edge[term]) < 0.1


def test_what_the_command_cannot_do_is_told(night, call_lommel):
    def told(*options):
        result = call_lommel("fit-field", "stars.npy", "lens.toml", "--read", 2, *options, folder=night)
        return " ".join((result.stdout + result.stderr).split())

    assert "--defocus must be given for 2 exposures" in told()
    assert "--output must end in .csv" in told("-o", "field.txt")
    assert "images must show at least 4 isolated stars; 0 spots found" in told("--defocus", 0, 1, "--threshold", 900)


def test_a_misfit_has_exit_code_3(night, call_lommel):
    options = ("--defocus", -2.5, 2.5, "--read", 2, "--window", 25, "--degree", 0, "--terms", 1, "--known-blur", 0)
    result = call_lommel("fit-field", "stars.npy", "lens.toml", *options, folder=night)
    assert result.returncode == 3, result.stderr
    assert "misfit: " in result.stdout


def test_json_has_the_terms_and_the_stars(night, call_lommel):
    options = ("--defocus", -2.5, 2.5, "--read", 2, "--window", 25, "--degree", 1, "--terms", 3, "--known-blur", 0)
    found = json.loads(call_lommel("fit-field", "stars.npy", "lens.toml", *options, "--json", folder=night).stdout)
    assert found["stars"] == 16
    assert found["terms"][0] == "noll 4 defocus"
    assert len(found["waves"]["corner"]["deviation"]) == 3
