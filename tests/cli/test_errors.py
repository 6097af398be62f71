"""Bad input on the command line: exit code 2, one line that says what is wrong, and nothing written."""

from __future__ import annotations

import importlib.util
import json
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

NOLL = """\
name = "a"
[lens]
focal_length = "100 mm"
f_number = 4
wavelength = "500 nm"
[sensor]
pixel = "1 um"
shape = 16
[aberrations.zernike]
order = "noll"
unit = "waves"
normalization = "rms"
[aberrations.zernike.terms]
8 = 0.1
"""
LENS_FILES = {
    "faulty.toml": 'name = "a"\nsource = "b"\n[lens]\nfocal_lenght = 1\nwavelength = 550\n[sensor]\npixel = "1 kg"\n',
    "twice.toml": NOLL.replace("8 = 0.1", "8 = 0.1\n08 = 0.2"),
}
NAME = "50mm [fast] f/1.8 [red] [/b] :smile: \\\\"

# Arguments, {phone} and {hubble} standing for lens files, and a part of the error.
BAD = [
    ("paint {phone}", "Unknown command 'paint'; known are examples, info, psf"),
    ("deblur {phone}", "Unknown command 'deblur'; did you mean restore?"),
    ("psf nowhere.toml", "nowhere.toml: No such file or directory"),
    ("info twice.toml", "terms.08 (line 15): the term 08 was given before, aberrations.zernike.terms.8 (line 14)"),
    ("psf {phone} -m hankel --set tol=1e-9 --tol 1e-8", "tol is given twice, by --tol and by --set"),
    ("psf {phone} --set tangent=200", "--set needs --method, whose option it is, got --set tangent=200"),
    ("psf {phone} -o a.tif -o ./a.tif", "Error: --output must be another file than --output, got a.tif for both"),
    ("psf {phone} -o {phone}", "Error: --output must be another file than LENS, got "),
    ("psf {phone} -o a.tif --plot nowhere/a.png", "nowhere/a.png: No such file or directory"),
]  # fmt: skip


@pytest.fixture
def folder(tmp_path):
    for name, text in LENS_FILES.items():
        (tmp_path / name).write_text(text)
    return tmp_path


def fill(arguments: str, lenses) -> list[str]:
    places = {"{phone}": str(lenses["phone"]), "{hubble}": str(lenses["hubble-1990"])}
    return [places.get(part, part) for part in arguments.split()]


def refused(result: subprocess.CompletedProcess[str], error: str) -> None:
    assert result.stdout == ""
    *usage, last = [line for line in result.stderr.splitlines() if line]
    assert last.startswith("Error: ")
    assert error in last
    assert all(line.startswith(("Usage: lommel", "Try 'lommel")) for line in usage)


@pytest.mark.parametrize(("arguments", "error"), BAD, ids=[arguments for arguments, _ in BAD])
def test_bad_input_is_told_in_one_line_and_leaves_nothing_behind(call_lommel, lenses, folder, arguments, error):
    before = sorted(folder.rglob("*"))
    refused(call_lommel(*fill(arguments, lenses), folder=folder), error)
    assert sorted(folder.rglob("*")) == before


@pytest.mark.parametrize(
    "arguments", ["psf {phone} -o a.tif --plot a.png", "psf zeiss-63x-1.4-oil.toml --stack 3 -o a.ome.tif -o a.png"]
)
def test_nothing_is_computed_where_plots_cannot_be_drawn(call_lommel, lenses, folder, monkeypatch, arguments):
    assert call_lommel("examples", "zeiss-63x-1.4-oil", folder=folder).returncode == 0
    monkeypatch.setattr("lommel.cli.psf_command.compute", None)
    found = importlib.util.find_spec
    monkeypatch.setattr(importlib.util, "find_spec", lambda name: None if name == "matplotlib" else found(name))
    before = sorted(folder.rglob("*"))
    refused(
        call_lommel(*fill(arguments, lenses), folder=folder),
        "nothing was computed: the figure 'a.png' needs matplotlib: pip install matplotlib "
        '(the extra "plot" of lommel brings it; in a clone, make env)',
    )
    assert sorted(folder.rglob("*")) == before


def test_an_error_names_the_options_of_the_command_and_not_the_arguments_of_python(call_lommel, lenses, folder):
    y, x = np.mgrid[:20, :20]
    Image.fromarray(np.full((20, 20), 90, np.uint8)).save(folder / "photo.png")
    np.save(folder / "gaps.npy", np.where(x + y, 2.0, np.nan))
    np.save(folder / "near.npy", np.full((20, 20), 0.3))
    photo = ("blur", "photo.png", "gaps.npy", lenses["nifty-fifty"], "-o", "a.png")
    refused(call_lommel(*photo, folder=folder), 'give --missing "nearest" (')
    np.save(folder / "zeros.npy", np.pad(np.full((20, 19), 1.9), ((0, 0), (1, 0))))
    refused(call_lommel(*photo[:2], "zeros.npy", *photo[3:], folder=folder), "unknown, state it as --unknown")
    Image.fromarray(np.full((20, 20), 1900, np.uint16)).save(folder / "levels.png")
    refused(
        call_lommel(*photo[:2], "levels.png", *photo[3:], folder=folder),
        "give the scale, e.g. --depth-scale 0.001 for millimetres",
    )
    stars = ("retrieve", "photo.png", lenses["phone"], "--read", "2", "--terms", "size")
    refused(
        call_lommel(*stars, folder=folder),
        "must be one of 'defocus', 'spherical', 'rho^6', 'rho^8', or a Zernike term",
    )
    photo = (*photo[:2], "near.npy", *photo[3:])
    refused(
        call_lommel(*photo, folder=folder),
        "windows of more than 21 pixels a side to hold 0.98 of the light; stop down",
    )
    refused(call_lommel(*photo, "--focus", "10 mm", folder=folder), "--focus must exceed the focal length")
    field = ("psf", lenses["camera-field"], "--tol", "1e-9", "--set", "tol=1e-3")
    refused(call_lommel(*field, folder=folder), "got --set tol=1e-3")


@pytest.mark.parametrize("arguments", ["psf {phone}", "compare {phone} --shape 3", "psf {hubble} -m lommel-series"])
def test_no_trace_of_the_progress_bar_is_left_in_a_pipe(call_lommel, lenses, tmp_path, arguments):
    result = call_lommel(*fill(arguments, lenses), folder=tmp_path)
    if result.returncode == 0:
        assert result.stderr == ""
    else:
        assert result.stderr == "Error: LommelSeries supports defocus only; this pupil has spherical aberration\n"


@pytest.mark.parametrize("command", ["info", "psf", "compare"])
def test_a_name_is_shown_as_it_is_written(call_lommel, lenses, tmp_path, command):
    lines = lenses["phone"].read_text(encoding="utf-8").splitlines()
    text = "\n".join(f'name = "{NAME}"' if line.startswith("name") else line for line in lines)
    (tmp_path / "lens.toml").write_text(text, encoding="utf-8")
    result = call_lommel(command, "lens.toml", "--shape", 3, folder=tmp_path)
    assert result.returncode == 0
    assert result.stdout.splitlines()[0] == NAME.replace("\\\\", "\\")


@pytest.mark.parametrize("traced", [False, True])
def test_a_fault_of_the_program_is_one_line_that_asks_for_a_report(
    traced, call_lommel, lenses, tmp_path, monkeypatch
):
    from lommel.report import optics as reports

    def broken(*_):
        raise AttributeError("'int' object\nhas no attribute")

    monkeypatch.setattr(reports, "describe_lens", broken)
    monkeypatch.delenv("LOMMEL_TRACEBACK", raising=False)
    if traced:
        monkeypatch.setenv("LOMMEL_TRACEBACK", "1")
        with pytest.raises(AttributeError):
            call_lommel("info", lenses["phone"], folder=tmp_path)
        return
    result = call_lommel("info", lenses["phone"], folder=tmp_path)
    assert result.returncode == 1
    (line,) = result.stderr.splitlines()
    assert (
        "a bug in lommel, not in your input: AttributeError: 'int' object\\nhas no attribute; please report it"
        in line
    )
    assert "LOMMEL_TRACEBACK=1" in line


@pytest.mark.parametrize("unbuffered", ["", "1"])
@pytest.mark.parametrize(("target", "code"), [(">&-", 0), (">/dev/full", 2), ("| true", 0)])
def test_output_that_cannot_be_written_is_no_traceback(target, code, unbuffered, lenses, tmp_path):
    command = ["/bin/sh", "-c", f"{Path(sys.executable).with_name('lommel')} info {lenses['phone']} {target}"]
    environment = os.environ | {"PYTHONUNBUFFERED": unbuffered}
    result = subprocess.run(command, cwd=tmp_path, env=environment, capture_output=True, text=True, check=False)
    assert result.returncode == code
    assert len(result.stderr.splitlines()) == (code > 0)
    assert "Traceback" not in result.stderr


@pytest.mark.parametrize("flags", [[], ["--json"]])
def test_characters_that_a_console_cannot_encode_are_no_error(flags, folder):
    (folder / "wave.toml").write_text(NOLL.replace('"a"', '"λ/4"'), encoding="utf-8")
    command = [str(Path(sys.executable).with_name("lommel")), "info", "wave.toml", *flags]
    environment = os.environ | {"PYTHONIOENCODING": "cp1252"}
    result = subprocess.run(command, cwd=folder, env=environment, capture_output=True, encoding="cp1252", check=False)
    assert (result.returncode, result.stderr) == (0, "")
    name = json.loads(result.stdout)["name"] if flags else result.stdout.splitlines()[0].replace("\\u03bb", "λ")
    assert name == "λ/4"


def test_an_error_of_a_file_names_its_keys_and_not_options(call_lommel, folder):
    error = call_lommel("info", "faulty.toml", folder=folder).stderr
    assert "lens.focal_lenght (line 4): unknown key; did you mean focal_length?" in error
    assert "lens (line 3): give exactly one of f_number and aperture_diameter, got none" in error


@pytest.mark.parametrize("name", ["phone", "phone.toml", "lenses/phone.toml"])
def test_the_name_of_an_example_that_is_not_there_is_told_with_the_command_that_copies_it(
    name, call_lommel, tmp_path
):
    result = call_lommel("info", name, folder=tmp_path)
    assert (result.returncode, result.stdout) == (2, "")
    said = "`lommel examples phone` copies phone.toml to this folder"
    assert result.stderr == f"Error: {name}: No such file or directory; {said}\n"
    assert "examples" not in call_lommel("info", "mine.toml", folder=tmp_path).stderr
