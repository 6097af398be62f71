"""The gallery and the first page of the documentation: their code runs without a warning."""

from __future__ import annotations

import re
import runpy
import sys
from pathlib import Path
from typing import Any

import matplotlib.pyplot as plt
import numpy as np
import pytest

import lommel as lm

ROOT = Path(__file__).resolve().parent.parent
GALLERY = sorted((ROOT / "examples" / "gallery").glob("*.py"))
SCRIPT = pytest.mark.parametrize("path", GALLERY, ids=lambda path: path.stem)


def test_there_are_scripts_in_the_gallery():
    assert len(GALLERY) >= 6


@SCRIPT
def test_a_script_of_the_gallery_draws_figures_whose_axes_say_what_they_show(path, monkeypatch, tmp_path, capsys):
    # Scripts end by showing their figures, for which tests have no screen.
    monkeypatch.setattr(plt, "show", lambda: None)
    monkeypatch.setattr(sys, "argv", [str(path)])
    monkeypatch.chdir(tmp_path)
    runpy.run_path(str(path), run_name="__main__")
    figures = [plt.figure(number) for number in plt.get_fignums()]
    assert figures
    for figure in figures:
        figure.canvas.draw()
        labels = [axes.get_xlabel() + axes.get_ylabel() for axes in figure.axes]
        assert any(re.search(r"\(.+\)", label) for label in labels), labels
    assert not list(tmp_path.iterdir())
    assert capsys.readouterr().out


@SCRIPT
def test_a_script_of_the_gallery_begins_with_an_underlined_title_and_ends_by_showing_its_figures(path):
    text = path.read_text(encoding="utf-8")
    first, title, rule = text.splitlines()[:3]
    assert first in ('"""', 'r"""')
    assert rule == "=" * len(title)
    assert "plt.show()" in text


def test_the_code_of_the_first_page_runs_from_top_to_bottom(monkeypatch, tmp_path):
    text = (ROOT / "docs" / "start.md").read_text(encoding="utf-8")
    blocks = re.findall(r"^```python\n(.*?)^```", text, flags=re.MULTILINE | re.DOTALL)
    assert len(blocks) >= 5
    monkeypatch.chdir(tmp_path)
    exec(compile("".join(blocks), "start.md", "exec"), {})
    assert [path.name for path in tmp_path.iterdir()] == ["psf.tif"]


def test_the_code_of_the_page_about_imaging_works():
    text = (ROOT / "docs" / "imaging.md").read_text(encoding="utf-8")
    (block,) = re.findall(r"^```python\n(.*?)^```", text, flags=re.MULTILINE | re.DOTALL)
    names: dict[str, Any] = {}
    exec(compile(block, "imaging.md", "exec"), names)
    taken = names["photograph"].values
    assert taken.dtype == np.uint8
    # The object in focus is as it was, and the stripes behind it are gone.
    assert np.abs(taken[25:55, 45:75].astype(int) - (40, 120, 60)).max() <= 1
    assert np.ptp(taken[30, :30]) < 10 < np.ptp(names["image"][:, 0])


def test_the_code_and_the_lens_file_of_the_page_about_the_field_work(monkeypatch, tmp_path, lenses):
    text = (ROOT / "docs" / "field.md").read_text(encoding="utf-8")
    blocks = re.findall(r"^```python\n(.*?)^```", text, flags=re.MULTILINE | re.DOTALL)
    # The last is about lenses of other packages.
    assert ["adapters" in block for block in blocks] == [False, False, True]
    monkeypatch.chdir(tmp_path)
    exec(compile("".join(blocks[:2]), "field.md", "exec"), {})
    assert [path.name for path in tmp_path.iterdir()] == ["field.tif"]
    sections = re.findall(r"^```toml\n(.*?)^```", text, flags=re.MULTILINE | re.DOTALL)
    assert len(sections) == 2
    before = lenses["camera-field"].read_text(encoding="utf-8").partition("[field]")[0]
    for section in sections:
        (tmp_path / "lens.toml").write_text(before + section, encoding="utf-8")
        assert lm.load_instrument(tmp_path / "lens.toml").field().reach > 0.02
