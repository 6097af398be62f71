"""The command line, run as a user runs it: what it prints, what it writes, and that all of it agrees."""

from __future__ import annotations

import dataclasses
import io
import json
import math
import re
import subprocess
import sys
from contextlib import redirect_stdout

import numpy as np
import pytest
from PIL import Image

import lommel as lm
from lommel.cli.main import main
from lommel.methods import METHODS, Hankel, NijboerZernike
from lommel.paper import AbramowitzErf, ClosedForm, Fraunhofer, Geometric, HuygensFresnel, LommelSeries, TableErf
from lommel.show.drawing import SAMPLING

SUFFIXES = (".tif", ".npy", ".npz", ".fits", ".h5", ".mat")
OPTIONS = [
    "--object-distance",
    "1.2 m",
    "--pixel",
    "2um",
    "--shape",
    "8x9",
    "--normalize",
    "peak",
    "--tol",
    "1e-7",
]


@pytest.fixture(scope="module")
def written(run_lommel, lenses, tmp_path_factory):
    """One run of `lommel psf` with every kind of file, and the folder it ran in."""
    folder = tmp_path_factory.mktemp("psf")
    outputs = [part for suffix in SUFFIXES for part in ("-o", f"a{suffix}")]
    result = run_lommel("psf", lenses["phone"], *OPTIONS, *outputs, "--plot", "a.pdf", folder=folder)
    assert result.returncode == 0, result.stderr
    return folder, result.stdout


@pytest.fixture(scope="module")
def printed(run_lommel, lenses, tmp_path_factory):
    """What the same run prints as JSON."""
    folder = tmp_path_factory.mktemp("json")
    result = run_lommel("psf", lenses["phone"], *OPTIONS, "-o", "b.npz", "--plot", "b.png", "--json", folder=folder)
    assert result.returncode == 0, result.stderr
    assert {path.name for path in folder.iterdir()} == {"b.npz", "b.png"}
    return json.loads(result.stdout)


@pytest.fixture(scope="module")
def compared(run_lommel, lenses, tmp_path_factory):
    """One run of `lommel compare` with a figure, and another as JSON in this process."""
    folder = tmp_path_factory.mktemp("compare")
    arguments = ("compare", str(lenses["hubble-1990"]), "--shape", "6x7")
    tables = run_lommel(*arguments, "--figure", "methods.png", folder=folder)
    assert tables.returncode == 0, tables.stderr
    data = io.StringIO()
    with redirect_stdout(data), pytest.raises(SystemExit) as ended:
        main([*arguments, "--json"])
    assert ended.value.code == 0
    return folder, tables.stdout, json.loads(data.getvalue())


def expected(lenses) -> lm.PSF:
    lens = lm.load_instrument(lenses["phone"]).lens
    return lm.psf(lens.pupil(1.2), (8, 9), 2e-6, normalize="peak", tol=1e-7)


def test_every_file_holds_what_python_computes(written, lenses):
    folder, _ = written
    psf = expected(lenses)
    assert {path.name for path in folder.iterdir()} == {f"a{suffix}" for suffix in (*SUFFIXES, ".pdf")}
    for suffix in SUFFIXES:
        loaded = lm.PSF.load(folder / f"a{suffix}")
        assert (loaded.pupil, loaded.method, loaded.normalize) == (psf.pupil, psf.method, "peak")
        np.testing.assert_allclose(loaded.values, psf.values, rtol=0, atol=1e-12)
    assert (folder / "a.pdf").read_bytes().startswith(b"%PDF")


def test_the_json_is_about_the_lens_and_the_psf_that_python_knows(printed, lenses):
    instrument, psf = lm.load_instrument(lenses["phone"]), expected(lenses)
    lens = instrument.lens
    assert (printed["name"], printed["source"]) == (instrument.name, instrument.source)
    assert printed["files"] == ["b.npz", "b.png"]
    assert printed["object_distance"] == 1.2
    assert printed["pixel"] == pytest.approx(2e-6)
    for key in ("focal_length", "aperture_diameter", "wavelength", "f_number", "working_f_number", "sensor_distance"):
        assert printed[key] == pytest.approx(getattr(lens, key))
    assert printed["focus_distance"] == pytest.approx(0.5)
    assert printed["psf"]["method"] == {"name": "NijboerZernike", "tol": 1e-7}
    assert (printed["psf"]["shape"], printed["psf"]["dtype"]) == ([8, 9], "float64")
    assert (printed["psf"]["normalize"], printed["psf"]["sampling"]) == ("peak", "pixel")
    assert printed["psf"]["peak"] == pytest.approx(1.0)
    assert printed["psf"]["energy"] == pytest.approx(psf.energy)
    assert printed["psf"]["error_bound"] == pytest.approx(psf.error_bound)


def test_compare_has_a_row_for_every_method(compared):
    folder, _, data = compared
    rows = {row["method"]: row for row in data["rows"]}
    assert list(rows) == [kind.__name__ for kind in METHODS.values()]
    assert data["reference"] == "Hankel"
    assert (rows["Hankel"]["mse"], rows["Hankel"]["peak_error"]) == (0.0, 0.0)
    assert rows["NijboerZernike"]["peak_error"] <= rows["NijboerZernike"]["error_bound"] < 1e-6
    for row in rows.values():
        assert (row["reason"] is None) == (row["mse"] is not None) == (row["seconds"] is not None)
    assert "supports defocus only" in rows["LommelSeries"]["reason"]
    assert [path.name for path in folder.iterdir()] == ["methods.png"]
    with Image.open(folder / "methods.png") as figure:
        assert min(figure.size) > 500


@pytest.mark.parametrize(
    ("arguments", "method"),
    [
        (["-m", "hankel", "--tol", "1e-10"], Hankel(tol=1e-10)),
        (["--tol", "1e-3"], NijboerZernike(tol=1e-3)),
        (["-m", "huygens-fresnel", "--set", "symmetry=false"], HuygensFresnel(symmetry=False)),
        (["-m", "closed-form", "--set", "tangent=200", "--set", "erf=abramowitz:30"],
         ClosedForm(tangent=200.0, erf=AbramowitzErf(30))),
        (["-m", "closed-form", "--set", "variant=printed", "--set", "erf=table"],
         ClosedForm(variant="printed", erf=TableErf())),
        (["-m", "fraunhofer", "--set", "samples=64", "--set", "edge=grey"], Fraunhofer(samples=64, edge="grey")),
        (["-m", "geometric", "--set", "rings=2"], Geometric(rings=2)),
        (["-m", "lommel-series"], LommelSeries()),
    ],
    ids=lambda value: " ".join(value) if isinstance(value, list) else "",
)  # fmt: skip
def test_methods_and_their_options_are_chosen_by_name(call_lommel, lenses, tmp_path, arguments, method):
    result = call_lommel("psf", lenses["phone"], "--shape", 5, "-o", "a.npy", *arguments, folder=tmp_path)
    assert result.returncode == 0, result.stderr
    assert lm.PSF.load(tmp_path / "a.npy").method == method
    name = next(name for name, kind in METHODS.items() if isinstance(method, kind))
    assert re.search(rf"^method +{name}\b", result.stdout, re.MULTILINE)


def test_the_version_is_that_of_the_package(run_lommel, tmp_path):
    result = run_lommel("--version", folder=tmp_path)
    assert result.stdout == f"{lm.__version__}\n"


@pytest.mark.usefixtures("described_once")
def test_zernike_terms_are_in_waves_rms(call_lommel, lenses, tmp_path):
    facts = json.loads(call_lommel("info", lenses["newtonian-off-axis"], "--json", folder=tmp_path).stdout)
    terms = {term["name"]: term["waves_rms"] for term in facts["zernike"]}
    # 3.099 waves of Seidel coma at the edge, six tenths of it along x: W131 / 3 / sqrt(8) waves rms.
    assert terms["coma x"] == pytest.approx(0.6 * 3.099 / 3 / math.sqrt(8))
    assert terms["trefoil y"] == pytest.approx(30 / 550)


@pytest.mark.usefixtures("described_once")
@pytest.mark.parametrize(("given", "rim"), [("0.5", math.exp(-0.5)), ('"aplanatic"', 1.0538)])
def test_info_tells_how_the_lens_is_lit(call_lommel, tmp_path, given, rim):
    sensor = '[sensor]\npixel = "2 um"\nshape = [33, 33]\n'
    lens = '[lens]\nfocal_length = "50 mm"\nf_number = 1.15\nwavelength = "550 nm"\nmodel = "aplanatic"\n'
    (tmp_path / "lit.toml").write_text(f"{lens}apodization = {given}\n{sensor}", encoding="utf-8")
    facts = json.loads(call_lommel("info", "lit.toml", "--json", folder=tmp_path).stdout)
    assert facts["rim_amplitude"] == pytest.approx(rim, abs=1e-4)
    assert facts["apodization"] == json.loads(given)
    # The other model is told too: with the same amplitude, but without the angles that it comes from.
    assert facts["other_model"]["reason"] is None


@pytest.mark.usefixtures("described_once")
def test_a_telescope_with_vanes_is_described(call_lommel, lenses, tmp_path):
    lens = lenses["newtonian-off-axis"]
    facts = json.loads(call_lommel("info", lens, "--json", folder=tmp_path).stdout)
    # Each vane covers 0.75 radii of 0.01: 0.03 of pi - pi / 16, less what bends at the ends.
    assert facts["clear_area"] == pytest.approx(1 - 0.25**2 - 0.03 / math.pi, abs=1e-5)
    assert facts["aperture"]["spider"]["width"] == pytest.approx(0.01)
    pupil = lm.load_instrument(lens).pupil()
    # The contrast is that with the vanes, which differs along x and y by the coma.
    for end, angle in (("", 0.0), ("_y", 0.5 * math.pi)):
        at = facts[f"nyquist{end}"] * np.array([math.cos(angle), math.sin(angle)])
        assert facts[f"mtf_at_nyquist{end}"] == pytest.approx(float(lm.mtf(pupil, *at)), abs=1e-9)
        half = facts[f"mtf50{end}"] * np.array([math.cos(angle), math.sin(angle)])
        assert lm.mtf(pupil, *half) == pytest.approx(0.5, abs=1e-6)
        clear = lm.mtf(dataclasses.replace(pupil, spider=None), *half)
        assert abs(clear - 0.5) > 1e-3


@pytest.mark.quick
@pytest.mark.usefixtures("described_once")
def test_an_mtf_that_takes_minutes_is_said_to_be_missing(call_lommel, tmp_path):
    lens = '[lens]\nfocal_length = "150 m"\naperture_diameter = "11 m"\nwavelength = "2 um"\n'
    (tmp_path / "lens.toml").write_text(
        f'{lens}[sensor]\npixel = "18 um"\n[aperture]\ntelescope = "keck"\n', encoding="utf-8"
    )
    facts = json.loads(call_lommel("info", "lens.toml", "--json", folder=tmp_path).stdout)
    assert facts["mtf50"] is None
    assert facts["mtf_at_nyquist"] is not None
    assert any(told.startswith("MTF50, which takes minutes for 36 segments") for told in facts["refused"])


@pytest.mark.usefixtures("described_once")
@pytest.mark.parametrize("field", ["", '[field]\nsensor = ["1 mm", "1 mm"]\nW131 = 0.2\n'])
@pytest.mark.parametrize("waves", [0.0, 30.0])
def test_of_a_mask_with_phases_is_shown_what_it_has(call_lommel, tmp_path, field, waves):
    # Of moduli that are 1 but for rounding.
    mask = np.exp(1j * np.linspace(0.0, 3.0, 4096).reshape(64, 64))
    assert np.abs(mask).max() > 1.0
    np.save(tmp_path / "mask.npy", mask)
    lens = '[lens]\nfocal_length = "50 mm"\nf_number = 8\nwavelength = "550 nm"\n[sensor]\npixel = "5 um"\n'
    aperture = f'[aberrations]\nW020 = {waves}\n[aperture]\nmask = {{ file = "mask.npy" }}\n'
    (tmp_path / "lens.toml").write_text(lens + aperture + field, encoding="utf-8")
    facts = json.loads(call_lommel("info", "lens.toml", "--json", folder=tmp_path).stdout)
    assert facts["strehl"] == pytest.approx(lm.strehl(lm.load_instrument(tmp_path / "lens.toml").pupil()))
    assert [facts[name] for name in ("marechal", "rms_waves", "rms_waves_without_tilt")] == [None] * 3
    reason = "mask must be real for measures of the wavefront"
    assert sum(told.startswith(reason) for told in facts["refused"]) == 1
    if field:
        assert facts["field"]["places"][0]["rms_waves"] is None
    # For so wide a blur the mask is too coarse.
    assert [facts[name] is None for name in ("fwhm", "diameter_80")] == [waves > 0.0] * 2


def test_compare_judges_vanes_by_the_finest_method_that_takes_them(call_lommel, lenses, tmp_path):
    arguments = ("compare", lenses["newtonian-off-axis"], "--shape", "24")
    shown = call_lommel(*arguments, "--figure", "a.png", folder=tmp_path)
    assert (shown.returncode, shown.stderr) == (0, "")
    assert f"24 x 24 pixels of 1.1 um, {SAMPLING['pixel']}; reference nonuniform-fft (tol=1e-09)" in shown.stdout
    data = json.loads(call_lommel(*arguments, "--json", folder=tmp_path).stdout)
    assert data["reference"] == "NonuniformFFT(tol=1e-09)"
    rows = {row["method"]: row for row in data["rows"]}
    assert {name for name, row in rows.items() if row["reason"] is None} == {
        "ChordalGauss", "NonuniformFFT", "MatrixFourier", "Fraunhofer"
    }  # fmt: skip
    assert 0 < rows["ChordalGauss"]["peak_error"] < 1e-6
    assert 0 < rows["NonuniformFFT"]["peak_error"] < 1e-6 < rows["MatrixFourier"]["peak_error"] < 0.01
    assert "circular and annular apertures only" in rows["Hankel"]["reason"]


def test_a_command_is_refused_without_what_others_need():
    said = (
        "import sys; import lommel.cli.main; "
        "print(*{'lommel.imaging', 'rich.console', 'lommel.estimation'} & {*sys.modules})"
    )
    run = subprocess.run([sys.executable, "-c", said], capture_output=True, encoding="utf-8", check=True)
    assert run.stdout.split() == []
