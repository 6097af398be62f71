"""Bad input on the command line: exit code 2, one line that says what is wrong, and nothing written."""

from __future__ import annotations

import importlib.util
import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

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
    "twice.toml": NOLL.replace("8 = 0.1", "8 = 0.1\n08 = 0.2"),
}
NAME = "50mm [fast] f/1.8 [red] [/b] :smile: \\\\"

# Arguments, {phone} and {hubble} standing for lens files, and a part of the error.
BAD = [
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


@pytest.mark.parametrize("command", ["info", "psf", "compare"])
def test_a_name_is_shown_as_it_is_written(call_lommel, lenses, tmp_path, command):
    lines = lenses["phone"].read_text(encoding="utf-8").splitlines()
    text = "\n".join(f'name = "{NAME}"' if line.startswith("name") else line for line in lines)
    (tmp_path / "lens.toml").write_text(text, encoding="utf-8")
    result = call_lommel(command, "lens.toml", "--shape", 3, folder=tmp_path)
    assert result.returncode == 0
    assert result.stdout.splitlines()[0] == NAME.replace("\\\\", "\\")


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
