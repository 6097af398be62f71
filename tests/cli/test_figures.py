"""Figures of ``lommel psf``: the lens, the light and the distances of the image that they show."""

from __future__ import annotations

import pytest
from matplotlib.colors import LogNorm, PowerNorm
from matplotlib.figure import Figure

from lommel.cli import psf_command
from lommel.cli.main import main


@pytest.fixture
def drawn(monkeypatch):
    figures: list[Figure] = []
    monkeypatch.setattr(psf_command, "save_figure", lambda figure, path: figures.append(figure))
    return figures


def draw(lens, tmp_path, *options):
    main(["psf", str(lens), "--shape", "9", "--plot", str(tmp_path / "a.png"), *options], standalone_mode=False)


@pytest.mark.parametrize(("stretch", "norm"), [("sqrt", PowerNorm), ("log", LogNorm)])
def test_the_stretch_is_that_of_the_figure_and_is_named(lenses, tmp_path, drawn, capsys, stretch, norm):
    draw(lenses["newtonian-off-axis"], tmp_path, "--stretch", stretch)
    assert isinstance(drawn[0].axes[0].images[0].norm, norm)
    named = {"sqrt": "square root of the values", "log": "logarithm of the values"}[stretch]
    shown = " ".join(capsys.readouterr().out.split())
    assert f"a.png: {named}" in shown or f"a.png {named}" in shown  # of a long path the words are in the next line
