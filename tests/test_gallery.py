"""The gallery and the first page of the documentation: their code runs without a warning."""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import matplotlib.pyplot as plt
import numpy as np
import pytest
from matplotlib.figure import Figure

import lommel as lm

ROOT = Path(__file__).resolve().parent.parent
GALLERY = sorted((ROOT / "examples" / "gallery").glob("*.py"))
SCRIPT = pytest.mark.parametrize("path", GALLERY, ids=lambda path: path.stem)


def test_there_are_scripts_in_the_gallery():
    assert len(GALLERY) >= 6


def blocks(text: str) -> list[str]:
    """Return the parts of a script that sphinx-gallery runs one after the other, each on its own line numbers."""
    parts, before = re.split(r"^(?=# %%)", text, flags=re.MULTILINE), 0
    for k, part in enumerate(parts):
        parts[k], before = "\n" * before + part, before + part.count("\n")
    return parts


def run_block_by_block(text: str, name: str) -> Iterator[Figure]:
    """Run a script as sphinx-gallery does, which takes the figures after each block, and closes them."""
    names: dict[str, Any] = {"__name__": "__main__"}
    for block in blocks(text):
        exec(compile(block, name, "exec"), names)
        yield from map(plt.figure, plt.get_fignums())
        plt.close("all")


def empty_axes(figure: Figure) -> list[str]:
    """Return what is written on axes in which nothing is to be seen: without artists, or of a single colour."""
    figure.canvas.draw()
    picture = np.asarray(figure.canvas.buffer_rgba())
    found = []
    for axes in figure.axes:
        left, low, right, high = (round(side) for side in axes.get_window_extent().extents)
        inside = picture[picture.shape[0] - high + 3 : picture.shape[0] - low - 3, left + 3 : right - 3]
        seen = np.ptp(inside.reshape(-1, 4).astype(int), axis=0).any()
        if axes.get_visible() and not (axes.has_data() and seen):
            found.append(f"{axes.get_title()!r}, x {axes.get_xlabel()!r}")
    return found


@SCRIPT
def test_a_script_of_the_gallery_draws_figures_whose_axes_say_what_they_show(path, monkeypatch, tmp_path, capsys):
    # Scripts end by showing their figures, for which tests have no screen.
    monkeypatch.setattr(plt, "show", lambda: None)
    monkeypatch.setattr(sys, "argv", [str(path)])
    monkeypatch.chdir(tmp_path)
    count = 0
    for figure in run_block_by_block(path.read_text(encoding="utf-8"), path.name):
        count += 1
        assert not empty_axes(figure)
        labels = [axes.get_xlabel() + axes.get_ylabel() for axes in figure.axes]
        assert any(re.search(r"\(.+\)", label) for label in labels), labels
    assert count
    assert not list(tmp_path.iterdir())
    assert capsys.readouterr().out


@pytest.mark.parametrize(
    ("script", "empty"),
    [
        ("left.plot([0, 1])\n# %%\n# Text.\n\nright.plot([1, 0])\n", 1),  # after the figure was taken
        ("left.plot([0, 1])\nright.plot([1, 0])\n# %%\n", 0),
        ("left.plot([0, 1])\nright.plot([np.nan, np.nan])\n", 1),
        ("left.imshow(np.eye(3))\nright.set_visible(False)\n", 0),
    ],
)
def test_axes_that_are_drawn_on_after_their_block_or_show_nothing_are_found(script, empty):
    head = "import matplotlib.pyplot as plt\nimport numpy as np\n\nfigure, (left, right) = plt.subplots(1, 2)\n"
    assert [len(empty_axes(figure)) for figure in run_block_by_block(head + script, "script")] == [empty]


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
