"""Pictures of depth."""

from __future__ import annotations

import math
import re

import numpy as np
import pytest

from lommel.show import estimates


def test_what_is_not_known_is_left_grey():
    depth = np.linspace(1.0, 2.0, 48).reshape(6, 8)
    depth[2, 3] = np.nan
    errors = np.where(np.isnan(depth), np.inf, 1e-3 * depth)
    figure = estimates.maps(depth, errors, np.ones((6, 8, 3)))
    pictures = [axes.images[0].get_array() for axes in figure.axes if axes.images]
    assert len(pictures) == 3
    assert np.ma.getmaskarray(np.ma.masked_invalid(pictures[0]))[2, 3]
    assert pictures[1][0, 0] == pytest.approx(1.0)  # mm
    assert "known at 97.9 %" in figure.axes[0].get_title()
    nothing = estimates.maps(np.full((4, 4), np.nan), np.full((4, 4), np.inf), None)
    assert "known at 0 %" in nothing.axes[0].get_title()
    nothing.canvas.draw()


def test_curves_of_precision_have_gaps_where_nothing_can_be_known():
    distance = np.linspace(1.0, 2.0, 5)
    curve = np.array([1e-3, 2e-3, np.inf, 2e-3, 1e-3])
    axes = estimates.precision(distance, {"near": curve, "far": 2.0 * curve}, "title")
    drawn = axes.lines[0].get_ydata()
    assert np.isnan(drawn[2])
    assert drawn[0] == pytest.approx(1.0)
    assert [text.get_text() for text in axes.get_legend().get_texts()] == ["near", "far"]
    axes.figure.canvas.draw()
    estimates.precision(distance, {"": np.full(5, np.inf)}, "nothing").figure.canvas.draw()


def test_numbers_of_standard_errors_have_no_powers_of_ten():
    errors = np.geomspace(0.8e-3, 5e-3, 48).reshape(6, 8)
    figure = estimates.maps(1000.0 * errors, errors, None)
    figure.canvas.draw()
    bar = figure.axes[-1]
    ticks = [*bar.yaxis.get_majorticklabels(), *bar.yaxis.get_minorticklabels()]
    texts = {tick.get_text() for tick in ticks if tick.get_text()}
    assert {"1", "2", "3", "5"} <= texts
    assert all(re.fullmatch(r"[\d.]+", text) for text in texts)
    assert bar.get_ylabel() == "standard error of depth (mm)\n(colours: logarithm)"


@pytest.mark.parametrize("shape", [(144, 256), (100, 100), (200, 100)], ids=str)
def test_depth_maps_fill_their_figure_and_their_labels_are_apart(shape):
    depth = np.linspace(1.0, 2.0, math.prod(shape)).reshape(shape)
    figure = estimates.maps(depth, 1e-3 * depth, depth)
    figure.canvas.draw()
    boxes = [axes.get_tightbbox() for axes in figure.axes]
    assert not any(a.overlaps(b) for k, a in enumerate(boxes) for b in boxes[k + 1 :])
    area = sum(box.width * box.height for box in boxes)
    assert area > 0.6 * figure.bbox.width * figure.bbox.height
