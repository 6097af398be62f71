"""The command ``lommel beads``: from stacks to a microscope file that other commands take."""

from __future__ import annotations

import json
import re

import numpy as np
import pytest
import tifffile

import lommel as lm
from command_lines import lommel
from lommel.estimation import beads
from lommel.report.bead_page import read_csv
from objectives import OIL, OIL_FILE

Z = (np.arange(9) - 4) * 200e-9


def run(*words):
    return lommel("beads", *words)


@pytest.fixture
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "objective.toml").write_text(OIL_FILE, encoding="utf-8")
    wave = lm.Wavefront.zernike({5: 0.4, 8: -0.3}, order="noll")
    pupil = OIL.pupil(depth=50e-9, z=Z, wavelength=600e-9, aberrations=wave)
    bead = lm.psf(pupil, 19, 6.5e-6, method=lm.methods.Bead(0.1e-6, 1e-4), integrate=True).values.astype(float)
    camera = lm.Noise(read=1.6, offset=100)
    field = np.full((9, 64, 90), 10.0)
    for row, column in ((15, 20), (45, 60)):
        field[:, row - 9 : row + 10, column - 9 : column + 10] += 1e4 * bead
    field[:, 6:25, 80:] += 1e4 * bead[:, :, :10]  # cut off by the edge
    for name, light in (("bead", 1e4 * bead + 10.0), ("field", field)):
        images = camera.record(light, seed=1).round().astype(np.uint16)
        tifffile.imwrite(f"{name}.tif", images, photometric="minisblack")
    return tmp_path


ASKED = ("objective.toml", "--step", "200nm", "--read", "1.6", "--offset", "100", "--terms", "7")


def test_a_fitted_microscope_is_written_and_read(folder):
    found = run("bead.tif", *ASKED, "-o", "fitted.toml", "--plot", "fit.png", "--json")
    assert found.returncode == 0, found.stderr
    facts = json.loads(found.stdout)
    assert facts["converged"], facts["message"]
    assert facts["coefficients"]["2,-2"] == pytest.approx(0.4, abs=5.0 * facts["errors"]["2,-2"])
    assert (folder / "fit.png").stat().st_size > 1000
    made = lm.load_microscope("fitted.toml")
    assert made.objective.sample == pytest.approx(facts["coefficients"]["sample"], rel=1e-9)
    assert made.pixel == pytest.approx(facts["coefficients"]["pixel"], rel=1e-9)
    terms = made.aberrations.to_zernike(order="noll", unit="radians")
    assert terms[8] == pytest.approx(facts["coefficients"]["3,1"], rel=1e-9)
    assert made.errors["noll 8"] == pytest.approx(facts["errors"]["3,1"] / (2.0 * np.pi), rel=1e-9)
    told = lommel("info", "fitted.toml", "--json")
    assert told.returncode == 0
    assert all(0.0 < error < 0.05 * width for width, error in facts["fwhm"].values())
    printed = " ".join(run("bead.tif", *ASKED).stdout.split())
    untested = next(found["numbers"] for found in facts["findings"] if found["code"] == "untested")
    held = [name for name, by in untested.items() if not by and name in facts["coefficients"]]
    assert held
    assert all(facts["errors"][name] is None for name in held)
    assert all(re.search(rf"{name} \(by its prior\) [\d.]+ - ", printed) for name in held)
    assert "depth (by its prior) nm" in printed or "depth" not in untested
    assert "not to be 2 um deep as the file says; --depth states it" in printed
    assert re.search(r"FWHM at the first bead, without bead and pixel value .* x [\d.]+ [\d.]+ nm y ", printed)


def test_planes_whose_unit_or_meaning_is_missing_are_refused_or_named(folder):
    stack = tifffile.imread("bead.tif")
    sizes = {"PhysicalSizeX": 0.1031746, "PhysicalSizeY": 0.2, "PhysicalSizeZ": 0.2}
    tifffile.imwrite("a.ome.tif", stack, metadata={"axes": "ZYX", **sizes, "PhysicalSizeZUnit": "pixel"})
    found = run("a.ome.tif", "objective.toml", *ASKED[3:])
    assert found.returncode == 2
    assert "--step must be given: the files state 0.2 pixel between planes, which is no length" in found.stderr
    tifffile.imwrite("a.ome.tif", stack, metadata={"axes": "TYX", **sizes})
    found = " ".join(run("a.ome.tif", *ASKED).stdout.split())
    said = "the images state pixels 200 nm high, but 103.2 nm was used, and lengths across are 0.516 times as long"
    assert f"{said}: correct the one that is wrong" in found
    assert "a.ome.tif states 9 time points, which were taken as planes along z" in found


def test_a_fitted_microscope_has_no_values_of_the_example(folder):
    text = OIL_FILE.replace("[objective]", '[stack]\nplanes = 41\nstep = "150 nm"\n\n[objective]')
    text = f'source = "Maker. Sample, depth, light and camera are examples."\n{text}'
    (folder / "objective.toml").write_text(text, encoding="utf-8")
    found = run("bead.tif", *ASKED, "--depth", "60nm", "-o", "fitted.toml", "--json")
    assert found.returncode == 0, found.stderr
    made = lm.load_microscope("fitted.toml")
    assert made.depth == pytest.approx(json.loads(found.stdout)["places"][0]["depth"], rel=1e-9)
    assert (made.planes, made.step, made.shape, made.origin) == (9, 200e-9, (19, 19), "brightest")
    assert made.source.startswith("Maker. Fitted to beads: converged: ")


def test_hot_pixels_are_left_out_and_counted(folder):
    images = tifffile.imread("field.tif")
    images[:, 15, 26] += 60  # in the window of a bead
    images[:, 30, 40] += 500  # looks like a spot
    tifffile.imwrite("hot.tif", images, photometric="minisblack")
    asked = (*ASKED, "--window", "19", "--json")
    clean, hot = (json.loads(run(file, *asked).stdout) for file in ("field.tif", "hot.tif"))
    assert "hot_pixels" not in [finding["code"] for finding in clean["findings"]]
    finding = next(finding for finding in hot["findings"] if finding["code"] == "hot_pixels")
    assert finding["text"] == (
        "2 pixels (0.035 %) exceed their neighbours in most planes, whatever is in focus: left out as hot"
    )
    assert hot["converged"], hot["message"]
    assert len(hot["places"]) == len(clean["places"]) == 2
    for term, value in clean["coefficients"].items():
        assert hot["coefficients"][term] == pytest.approx(value, abs=clean["errors"][term] or 1e-3 * value)


@pytest.mark.parametrize(("pixel", "severity"), [(0.106, "note"), (0.2, "doubt")])
def test_pixels_other_than_those_that_the_images_state_are_said_first(folder, pixel, severity):
    metadata = {"axes": "ZYX", "spacing": 0.2, "unit": "um"}
    resolution = (1.0 / pixel, 1.0 / pixel)
    tifffile.imwrite("bead.tif", tifffile.imread("bead.tif"), imagej=True, metadata=metadata, resolution=resolution)
    found = run("bead.tif", *ASKED, "--json")
    facts = json.loads(found.stdout)
    text = f"the images state pixels of {1e3 * pixel:g} nm in the sample, but 103.2 nm was used"
    assert facts["findings"][0]["code"] == "pixel_pitch"
    assert facts["findings"][0]["severity"] == severity
    assert text in facts["message"]
    assert found.returncode == {"note": 0, "doubt": 4}[severity]


def test_terms_of_the_amplitude_are_part_of_the_file_and_of_what_other_commands_compute(folder):
    found = run("bead.tif", *ASKED, "--apodization", "1", "-o", "fitted.toml", "--json")
    assert found.returncode == 0, found.stderr
    facts = json.loads(found.stdout)
    made = lm.load_microscope("fitted.toml")
    term = facts["coefficients"]["apodization_2"]
    assert made.objective.apodization.to_zernike() == {2: pytest.approx(term, rel=1e-9)}
    assert made.errors["apodization_2"] == pytest.approx(facts["errors"]["apodization_2"], rel=1e-9)
    told = lommel("info", "fitted.toml", "--json")
    rim = json.loads(told.stdout)["rim_amplitude"]
    assert rim == pytest.approx(made.objective.apodization.value(1.0))


def test_the_step_is_that_of_the_file_unless_it_is_stated(folder):
    planes = tifffile.imread("bead.tif")
    tifffile.imwrite("imagej.tif", planes, imagej=True, metadata={"axes": "ZYX", "spacing": 0.2, "unit": "um"})
    stated = run("bead.tif", *ASKED, "--json")
    found = run("imagej.tif", "objective.toml", *ASKED[3:], "--json")
    facts, other = json.loads(found.stdout), json.loads(stated.stdout)
    assert facts["coefficients"] == pytest.approx(other["coefficients"], rel=1e-9)
    assert any("step of 200 nm between planes is that of the files" in note for note in facts["notes"])


def test_a_result_that_does_not_fit_has_exit_code_3(folder):
    found = run("bead.tif", "objective.toml", "--step", "-200nm", *ASKED[3:])
    assert found.returncode == 3
    assert found.stdout.startswith("reversed z: ")


def test_beads_of_a_field_have_their_places_in_the_image_and_the_light_is_stated(folder):
    found = run("field.tif", *ASKED, "--window", "19", "--json")
    assert found.returncode == 0, found.stderr
    facts = json.loads(found.stdout)
    places = sorted((one["row"], one["column"]) for one in facts["places"])
    np.testing.assert_allclose(places, [(15, 20), (45, 60)], atol=0.1)
    assert any("field.tif: 2 spots found; refused: 1 edge. Beads need 19 " in note for note in facts["notes"])
    assert facts["wavelength"] == pytest.approx(600e-9)
    assert facts["noise"]["offset"] == {"value": 100.0, "source": "option"}


def test_a_report_grows_by_dates_and_channels(folder):
    (folder / "day").mkdir()
    field = tifffile.imread("field.tif")
    # The second date has another sign of coma: one fit of both would be a misfit.
    for name, images in (("day/2026-11-30.tif", field), ("day/20261201_b.tif", field[..., ::-1])):
        tifffile.imwrite(name, images, photometric="minisblack")
    asked = (*ASKED, "--window", "19", "--report", "psf", "--json")
    found = run("day/2026-11-30.tif", *asked)
    assert found.returncode == 0, found.stderr
    facts = json.loads(found.stdout)
    table = facts["report"]["table"]
    assert [row["date"] for row in table] == ["2026-11-30"] * 2
    assert facts["files"][-2:] == ["psf/table.csv", "psf/report.html"]
    for row, place in zip(table, facts["places"], strict=True):
        assert row["x"] / 103.1746e-9 == pytest.approx(place["column"], abs=0.3)
        assert row["height_error"] < 0.7 * row["z_error"]  # errors of the depth cancel
        assert 2e-7 < row["gauss_x"] < 4e-7
        assert 1.5e-7 < row["fwhm_x"] < row["gauss_x"]
    # All of the folder: rows of the same file are replaced.
    found = run("day", *asked)
    assert found.returncode == 0, found.stderr
    second = json.loads(found.stdout)
    assert second["coefficients"]["3,1"] == pytest.approx(-facts["coefficients"]["3,1"], abs=0.03)
    assert [row["date"] for row in second["report"]["table"]] == ["2026-11-30"] * 2 + ["2026-12-01"] * 2
    assert all(row["joint_fit"].startswith("converged: ") for row in second["report"]["table"])
    assert "Each date has its own fit, of which that of 2026-12-01 is told." in second["notes"]
    lines = (folder / "psf" / "table.csv").read_text(encoding="utf-8").splitlines()
    assert len(lines) == 1 + 4
    page = (folder / "psf" / "report.html").read_text(encoding="utf-8")
    assert "<h2>Trend</h2>" in page
    # Another channel of the first file: files of the newest date are those of all channels.
    tifffile.imwrite("day/20261201_c.tif", field[..., ::-1], photometric="minisblack")
    assert run("day/20261201_c.tif", *asked).returncode == 0
    page = (folder / "psf" / "report.html").read_text(encoding="utf-8")
    assert "20261201_b.tif, 20261201_c.tif</td>" in page
    assert "diameter of beads, estimated at 600 nm" in page
    printed = " ".join(run("field.tif", *ASKED, "--window", "19").stdout.split())
    assert re.search(r"column z nm height nm", printed)


def test_each_channel_of_a_file_has_its_fit_and_pairs_are_chromatic_shifts(folder):
    camera, stacks = lm.Noise(read=1.6, offset=100), []
    for wave, row in ((600e-9, 9.0), (680e-9, 9.5)):
        pupil = OIL.pupil(depth=50e-9, z=Z, wavelength=wave)
        method = lm.methods.Bead(0.1e-6, 1e-4)
        bead = lm.psf(pupil, 19, 6.5e-6, method=method, integrate=True, center=(row, 9.0)).values.astype(float)
        stacks.append(camera.record(1e4 * bead + 10.0, seed=2).round().astype(np.uint16))
    waves = {"EmissionWavelength": [600, 680], "EmissionWavelengthUnit": ["nm"] * 2}
    for name, stated in (("both.ome.tif", waves), ("silent.ome.tif", {})):
        channels = {"axes": "CZYX", "Channel": {"Name": ["green", "red"]} | stated}
        tifffile.imwrite(name, np.stack(stacks), metadata=channels, photometric="minisblack")
    asked = ("objective.toml", "--step", "200nm", "--read", "1.6", "--offset", "100", "--terms", "1")
    silent = run("silent.ome.tif", *asked)
    assert silent.returncode == 2
    told = "--wavelength must be given for each channel: silent.ome.tif has 2 channels, green, red, without their"
    assert told in " ".join(silent.stderr.split())
    once = " ".join(run("silent.ome.tif", *asked, "--wavelength", "600nm").stderr.split())
    assert "--wavelength must be one for each channel: silent.ome.tif has 2 channels, green, red, got 1" in once
    found = run("both.ome.tif", *asked, "--report", "psf", "-o", "fit.toml", "--json")
    assert found.returncode == 0, found.stderr
    facts = json.loads(found.stdout)
    assert facts["files"] == ["fit-680nm.toml", "fit-600nm.toml", "psf/table.csv", "psf/report.html"]
    assert [lm.load_microscope(name).wavelength for name in facts["files"][:2]] == pytest.approx([680e-9, 600e-9])
    assert [one["wavelength"] for one in facts["channels"]] == pytest.approx([600e-9, 680e-9])
    red, green = facts["report"]["table"]
    assert red["y_psf"] - green["y_psf"] == pytest.approx(0.5 * 6.5e-6 / OIL.magnification, abs=3e-9)
    assert "<h2>Chromatic shifts</h2>" in (folder / "psf" / "report.html").read_text(encoding="utf-8")


def test_a_misfit_of_another_channel_is_in_the_verdict(folder):
    bead = tifffile.imread("bead.tif")
    channels = {"axes": "CZYX", "Channel": {"Name": ["good", "noise"]}}
    noise = lm.Noise(read=1.6, offset=100).record(np.full(bead.shape, 10.0), seed=3).round().astype(np.uint16)
    tifffile.imwrite("pair.ome.tif", np.stack([bead, noise]), metadata=channels, photometric="minisblack")
    found = run("pair.ome.tif", *ASKED, "--wavelength", "600nm", "--wavelength", "680nm")
    assert found.returncode == 3
    assert "680 nm: the light of all planes is within the noise" in " ".join(found.stdout.split())
    assert " ".join(found.stdout.split()).startswith("no light: 600 nm: chi2 ")


def test_clipped_pixels_are_named_at_once_and_left_out(folder):
    field = tifffile.imread("field.tif")
    top = int(0.6 * field.max())
    tifffile.imwrite("clipped.tif", np.minimum(field, top), photometric="minisblack")
    found = run("clipped.tif", *ASKED, "--window", "19", "--json")
    facts = json.loads(found.stdout)
    assert f"pixels have exactly the largest value, {top}, taken as saturated" in " ".join(found.stderr.split())
    assert facts["converged"]
    assert facts["coefficients"]["2,-2"] == pytest.approx(0.4, abs=5.0 * facts["errors"]["2,-2"])
    assert "saturation_assumed" in [one["code"] for one in facts["findings"]]


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (("empty", "objective.toml"), "empty has no stacks: TIFF, NPY, FITS or OME-Zarr"),
        (("bead.tif", "objective.toml", "--report", "none/psf"), "No such file or directory"),
        (
            ("bead.tif", "objective.toml", "--report", "other"),
            "table.csv is no table of beads that this command wrote",
        ),
    ],
)
def test_a_folder_without_stacks_or_of_another_table_is_refused(folder, words, told):
    (folder / "empty").mkdir()
    (folder / "other").mkdir()
    (folder / "other" / "table.csv").write_text("a,b\n1,2\n")
    found = run(*words)
    assert found.returncode == 2
    assert told in " ".join(found.stderr.split())


def test_what_fails_for_one_file_is_named_and_the_rest_of_the_report_is_written(folder, monkeypatch):
    (folder / "day").mkdir()
    bead = tifffile.imread("bead.tif")
    for name in ("2026-11-29", "2026-11-30"):
        tifffile.imwrite(f"day/{name}.tif", bead, photometric="minisblack")
    wide = np.zeros((9, 19, 22))  # two beads, 310 nm apart
    wide[..., 3:] += bead - 110.0
    wide[..., :-3] += bead - 110.0
    pair = wide[..., 2:-1].clip(-20.0) + 110.0
    tifffile.imwrite("day/2026-12-01.tif", pair.round().astype(np.uint16), photometric="minisblack")
    dark = np.random.default_rng(1).normal(110.0, 3.0, (9, 64, 90)).round().astype(np.uint16)
    tifffile.imwrite("day/2026-12-02.tif", dark, photometric="minisblack")
    found = run("day", *ASKED, "--window", "19", "--report", "psf")
    assert found.returncode == 4, found.stderr
    for stream in (found.stdout, found.stderr):
        told = " ".join(stream.split())
        assert "2026-12-01.tif, 2026-12-01: stacks must show single beads" in told
        assert "2026-12-02.tif: no isolated bead" in told
    assert "wrote psf/report.html" in found.stdout
    assert found.stdout.startswith("converged, but in doubt: refused: 2026-12-0")
    rows = read_csv(folder / "psf" / "table.csv")
    assert [(row["file"], row["verdict"]) for row in rows] == [
        ("2026-11-29.tif", "converged"), ("2026-11-30.tif", "converged"),
        ("2026-12-02.tif", "refused"), ("2026-12-01.tif", "refused"),
    ]  # fmt: skip
    assert "no isolated bead" in (folder / "psf" / "report.html").read_text(encoding="utf-8")
    # Where nothing is measured, nothing is written.
    nothing = run("day/2026-12-01.tif", "day/2026-12-02.tif", *ASKED, "--window", "19", "--report", "none")
    assert nothing.returncode == 2
    assert not (folder / "none" / "table.csv").exists()


def test_a_bead_that_shows_two_in_its_own_fit_is_left_out_of_the_report(folder, monkeypatch):
    fit = beads.fit_beads

    def failing(stacks, *args, **options):
        if len(stacks.values) == 1 and stacks.values[0].max() == largest:
            raise ValueError("stacks must show single beads, and all 1 show two that touch")
        return fit(stacks, *args, **options)

    largest = tifffile.imread("field.tif")[:, 6:25, 11:30].max()
    monkeypatch.setattr(beads, "fit_beads", failing)
    found = run("field.tif", *ASKED, "--window", "19", "--report", "psf", "--json")
    assert found.returncode == 4, found.stderr
    verdicts = [row["verdict"] for row in json.loads(found.stdout)["report"]["table"]]
    assert sorted(verdicts) == ["converged", "left out"]
    assert re.search(r"field\.tif \[\d\], left out, though part .* two that touch", " ".join(found.stderr.split()))
