"""The gallery: its scripts run without a warning, and their figures show something."""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator
from contextlib import nullcontext
from pathlib import Path
from typing import Any

import matplotlib.pyplot as plt
import numpy as np
import pytest
from matplotlib.figure import Figure
from PIL import Image

import thumbnails
from check import empty_axes
from frameworks import hasty_programs

ROOT = Path(__file__).resolve().parent.parent
GALLERY = sorted((ROOT / "examples" / "gallery").rglob("*.py"))
HALF = "left, disparity = (a[:240, 160:500] for a in stereo_motorcycle()[::2])"
# What takes seconds as the pages have it is run with less: fewer pixels, points, steps or methods.
LESS = {
    "apertures": [("512, 768, 1024])", "512])"), ("shape=201", "shape=101")],
    "checkerboard": [("165, 240, 33.0, 5", "120, 155, 33.0, 3"), ("(210e-6,", "(150e-6,")],
    "colour_fringes": [
        ("np.linspace(1.95, 2.05, 41)", "np.linspace(1.99, 2.01, 3)"),
        ("width=70e-9)", "width=70e-9, count=2)"),
    ],
    "contrast": [("12.0, 97)", "12.0, 25)")],
    "deblurring": [
        ("astronaut(),", "astronaut()[40:200, 130:290],"),
        ("(10, 20, 40)", "(2, 3)"),
        ("(np.s_[60:190, 140:270], np.s_[330:460, 300:430])", "(np.s_[20:80, 20:80], np.s_[60:120, 60:120])"),
    ],
    "deconvolution": [("steps=40", "steps=10"), ("counts = [5, 10, 20, 40]", "counts = [2, 3, 5, 10]")],
    "depth": [("3e-6, 161)", "3e-6, 41)"), ("100e-6, 97)", "100e-6, 5)")],
    "depth_from_defocus": [
        ("left, _, disparity = stereo_motorcycle()", HALF),
        ("np.s_[60:380, 180:620]", "np.s_[60:220, 20:240]"),
        ('"between": (1.9, 5.2)', '"between": (1.9, 4.0)'),
    ],
    "differentiable_psf": [
        ("steps = 80", "steps = 2"),
        ("(2.8, 4.0, 5.6, 8.0)", "(8.0,)"),
        ("count = 1000", "count = 9"),
    ],
    "depth_precision": [("2.6, 41)", "2.6, 5)"), ("16.0, 13)", "16.0, 4)"), ("2.5, 161)", "2.5, 9)")],
    "depth_of_field": [("45.0, 60)", "45.0, 9)")],
    "field_blur": [("iter_lim=30", "iter_lim=3")],
    "diffraction_spikes": [("321, 0.5", "161, 0.5"), ("(1, 1201)", "(1, 601)")],
    "fit_defocus": [("range(300)", "range(60)")],
    "hubble": [("shape=401", "shape=101"), ("2.0, 401)", "2.0, 21)")],
    "large_telescopes": [("shape=241", "shape=81"), ("(1, 961)", "(1, 481)")],
    "methods_compared": [('"shape": 129', '"shape": 33'), ("(96, 128, 256, 512, 1024)", "(96, 128)")],
    "restoration": [
        ("left, _, disparity = stereo_motorcycle()", HALF.replace("[:240, 160:500]", "[70:180, 200:330]")),
        ("np.s_[60:260, 230:450]", "np.s_[30:84, 30:94]"),
        ("[20:170, 60:210]", "[5:49, 5:59]"),
    ],
    "seeing": [("shape=101", "shape=51")],
    "star_field": [
        ("side, window, pixel, count = 900, 25, 0.5, 36", "side, window, pixel, count = 900, 25, 0.5, 16")
    ],
    "wrong_stack": [("steps=40, target=0.0)", "steps=3, target=0.0)")],
    "zernike_terms": [("range(1, 16)", "range(1, 6)"), ("subplots(6,", "subplots(2,")],
}
SCRIPT = pytest.mark.parametrize("path", GALLERY, ids=lambda path: path.stem)


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


@SCRIPT
def test_a_script_of_the_gallery_draws_figures_whose_axes_say_what_they_show(path, monkeypatch, tmp_path, capsys):
    # Scripts end by showing their figures, for which tests have no screen.
    monkeypatch.setattr(plt, "show", lambda: None)
    monkeypatch.setattr(sys, "argv", [str(path)])
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(thumbnails, "FOLDER", tmp_path / "thumbnails")
    count, text = 0, path.read_text(encoding="utf-8")
    for much, less in LESS.get(path.stem, ()):
        assert much in text
        text = text.replace(much, less)
    with hasty_programs() if "import jax" in text else nullcontext():
        for figure in run_block_by_block(text, path.name):
            count += 1
            assert not empty_axes(figure)
            figure.set_layout_engine("none")  # which that has laid out
            labels = [axes.get_xlabel() + axes.get_ylabel() for axes in figure.axes]
            # With a unit in brackets, unless all are counts and ratios.
            counted = any(re.search("steps|samples|over|ratio| / ", label) for label in labels)
            assert counted or any(re.search(r"\(.+\)", label) for label in labels), labels
            assert not any("(1)" in label for label in labels)
            thumbnails.keep(path.stem, count, figure)
    assert count
    if path.stem in thumbnails.PANELS:
        with Image.open(tmp_path / "thumbnails" / f"{path.stem}.png") as picture:
            assert picture.size == thumbnails.SIZE
            assert max(high - low for low, high in picture.getextrema()) > 60
    assert [each.name for each in tmp_path.iterdir()] in ([], ["thumbnails"])
    assert capsys.readouterr().out


def test_a_thumbnail_shows_the_panel_alone(monkeypatch, tmp_path):
    monkeypatch.setattr(thumbnails, "FOLDER", tmp_path)
    monkeypatch.setattr(thumbnails, "PANELS", {"dark": (1, 1)})
    figure, panels = plt.subplots(1, 3, figsize=(6, 2), sharey=True, layout="constrained")
    for panel in panels:
        panel.imshow(np.zeros((9, 9)), cmap="inferno", extent=(-20, 20, 20, -20))
        panel.set_title("of 0.5 λN", fontsize=10)
        panel.set_xlabel("x (λN)")
    panels[0].set_ylabel("y (λN)")
    layout = figure.get_layout_engine()
    thumbnails.keep("dark", 1, figure)
    plt.close(figure)
    with Image.open(tmp_path / "dark.png") as picture:
        columns = np.asarray(picture.convert("L")).min(axis=0)
    assert columns.max() < 128  # white between the panels
    assert figure.get_layout_engine() is layout
