"""`lommel examples`: what there is to begin with, and copies of it."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2] / "examples"
KINDS = {
    "lenses": ("lens", ".toml"),
    "objectives": ("objective", ".toml"),
    "cameras": ("camera", ".toml"),
    "class": ("notebook", ".ipynb"),
    "notebooks": ("notebook", ".ipynb"),
}
THERE = {path.stem: path for kind, (_, end) in KINDS.items() for path in (ROOT / kind).glob(f"*{end}")}


def test_all_examples_are_listed_with_what_they_are(call_lommel, tmp_path):
    rows = json.loads(call_lommel("examples", "--json", folder=tmp_path).stdout)["examples"]
    assert {row["name"]: row["kind"] for row in rows} == {
        name: KINDS[path.parent.name][0] for name, path in THERE.items()
    }
    told = call_lommel("examples", folder=tmp_path).stdout
    assert all(row["name"] in told and row["what"][:20] in told for row in rows)
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("given", ["phone", "phone.toml"])
def test_a_copy_is_what_the_example_is_and_serves_the_next_command(call_lommel, tmp_path, given):
    assert call_lommel("examples", given, folder=tmp_path).stdout == "wrote phone.toml\n"
    assert (tmp_path / "phone.toml").read_bytes() == THERE["phone"].read_bytes()
    assert call_lommel("info", "phone.toml", folder=tmp_path).returncode == 0


def test_several_go_to_a_folder_that_is_made(call_lommel, tmp_path):
    told = json.loads(call_lommel("examples", *THERE, "-o", "a/b", "--json", folder=tmp_path).stdout)
    assert (
        {Path(name).stem for name in told["files"]}
        == {path.stem for path in (tmp_path / "a/b").iterdir()}
        == set(THERE)
    )


def test_nothing_is_written_over(call_lommel, tmp_path):
    (tmp_path / "phone.toml").write_text("mine")
    result = call_lommel("examples", "nifty-fifty", "phone", folder=tmp_path)
    assert (result.returncode, result.stderr) == (2, "Error: phone.toml: File exists and differs from the example\n")
    assert [path.name for path in tmp_path.iterdir()] == ["phone.toml"]
    assert (tmp_path / "phone.toml").read_text() == "mine"


def test_unchanged_copies_are_left_alone_and_the_missing_ones_written(call_lommel, tmp_path):
    call_lommel("examples", "nifty-fifty", folder=tmp_path)
    before = (tmp_path / "nifty-fifty.toml").stat().st_mtime_ns
    result = call_lommel("examples", "nifty-fifty", "camera-field", folder=tmp_path)
    told = "wrote camera-field.toml\nnifty-fifty.toml is already there, unchanged\n"
    assert (result.returncode, result.stdout) == (0, told)
    assert (tmp_path / "nifty-fifty.toml").stat().st_mtime_ns == before
    again = json.loads(call_lommel("examples", "nifty-fifty", "--json", folder=tmp_path).stdout)
    assert again == {"files": []}
