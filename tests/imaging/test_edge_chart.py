"""Edges of charts that are drawn by integrals of a Gaussian: all are found, with the response of their place."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest
from scipy.ndimage import convolve1d

import lommel as lm
from lommel.imaging import edge_chart
from slanted_edges import TURN, across, gaussian, picture, squares

PLACES = [(-80.0, 0.0), (80.0, 0.0)]
NINE = [(right, down) for right in (-100.0, 0.0, 100.0) for down in (-100.0, 0.0, 100.0)]
CHART = squares((160, 320), PLACES, 70.0, 0.8)


def truth(f, sigma=0.8):
    return np.exp(-2.0 * (np.pi * f) ** 2 * (sigma**2 + 1.0 / 12.0))


def test_the_edges_of_squares_are_found_where_they_are():
    image = np.random.default_rng(1).poisson(CHART * 30000) / 30000
    found = lm.imaging.sfr_chart(image)
    assert len(found.edges) == 8
    assert not found.refused
    assert found.reliable
    expected = [
        (right + 35.0 * np.cos(TURN + k * np.pi / 2), down + 35.0 * np.sin(TURN + k * np.pi / 2), "ST"[k % 2 == 0])
        for right, down in PLACES
        for k in range(4)
    ]
    f = np.array([0.1, 0.2, 0.3])
    for x, y, direction in expected:
        edge = min(found.edges, key=lambda edge: np.hypot(edge.x - x, edge.y - y))
        assert np.hypot(edge.x - x, edge.y - y) < 2.0
        assert edge.direction == direction
        assert edge.response(f) == pytest.approx(truth(f), abs=0.03)


def test_coma_is_no_other_encoding():
    """A tail along the rows makes edges across the rows asymmetric, and those along the rows remain as they are."""
    tail = convolve1d(CHART, np.exp(-np.arange(9) / 2.0) / np.exp(-np.arange(9) / 2.0).sum(), axis=1, origin=-4)
    image = np.random.default_rng(1).poisson(tail * 10000) / 10000
    (asymmetric,) = [f for f in lm.imaging.sfr_chart(image).findings if f.code == "asymmetric"]
    assert asymmetric.severity == "doubt"
    assert asymmetric.numbers["edges"] == 4
    assert "coma" in asymmetric.text
    assert "encoding" not in asymmetric.numbers
    found = lm.imaging.sfr_chart(np.random.default_rng(1).poisson(CHART * 10000) / 10000, encoding="srgb")
    (wrong,) = [f for f in found.findings if f.code == "asymmetric"]
    assert wrong.numbers["encoding"] == "linear"


def test_areas_are_as_wide_as_a_wide_blur_asks_for():
    """Lines through areas that the edge reaches bend the response: by 0.004 in six sigmas on either side."""
    chart = squares((220, 220), [(0.0, 0.0)], 110.0, 4.0)
    for row in lm.imaging.sfr_chart(chart).rows([0.05]):
        assert row["at_0.05"] == pytest.approx(truth(0.05, 4.0), abs=2.5e-3)


def test_areas_beside_sharp_edges_are_no_wider_in_a_reduced_picture(monkeypatch):
    """Errors at 0.1 cycles/pixel are those of 24 pixels on both sides: in wider areas there is more noise."""
    chart = np.random.default_rng(1).poisson(squares((220, 220), [(0.0, 0.0)], 110.0, 0.8) * 10000) / 10000
    errors = []
    for factor in (1, 3):
        monkeypatch.setattr("lommel.imaging.edge_chart._REDUCED", chart.size / factor**2)
        errors.append(np.mean([row["error_0.1"] for row in lm.imaging.sfr_chart(chart).rows([0.1])]))
    assert errors[1] == pytest.approx(errors[0], rel=0.1)


def test_records_have_the_units_that_are_read():
    found = lm.imaging.sfr_chart(np.stack([CHART] * 3, axis=-1), 4e-6)
    records = found.rows([0.2])
    assert len(records) == 24
    one = records[1]
    assert one["channel"] == "green"
    assert one["x"] == pytest.approx(4e-6 * (one["column"] - 159.5))
    assert one["mtf50"] == pytest.approx(one["mtf50_px"] / 4e-6)
    assert one["lw_ph"] == pytest.approx(2 * 160 * one["mtf50_px"])
    assert one["at_0.2"] == pytest.approx(truth(0.2), abs=2e-3)
    data = found.to_dict()
    assert data["converged"]
    assert len(data["edges"]) == 24
    assert [axes.get_title() for axes in found.plot().axes[:2]] == [
        "MTF50, sagittal, green",
        "MTF50, tangential, green",
    ]


def test_one_crop_is_a_chart_of_one_edge():
    (edge,) = lm.imaging.sfr_chart(picture(8.0, 0.6, (90, 90), 8)).edges
    f = np.array([0.1, 0.2, 0.3, 0.4])
    assert edge.response(f) == pytest.approx(gaussian(f, edge.response.angle, 0.6), abs=2e-3)


def test_masked_edges_are_left_out():
    hidden = np.zeros(CHART.shape, bool)
    hidden[:, :160] = True
    found = lm.imaging.sfr_chart(np.ma.masked_array(CHART, hidden))
    assert all(edge.x > 0.0 for edge in found.edges)
    assert len(found.edges) == 4


def test_hot_pixels_hide_no_edge_and_are_no_overexposure():
    image = np.round(250.0 * np.random.default_rng(1).poisson(CHART * 30000) / 30000).astype(np.uint8)
    image.flat[np.random.default_rng(2).integers(0, image.size, image.size // 50)] = 255
    found = lm.imaging.sfr_chart(image)
    assert len(found.edges) == 8
    assert not found.refused
    for edge in found.edges:
        assert edge.response(0.2) == pytest.approx(truth(0.2), abs=0.04)


def test_edges_that_are_found_and_not_measured_are_counted_by_cause():
    y, x = np.ogrid[:160, :320]
    turn = np.arctan(1.0 / 3.0)
    d = (x - 240.0) * np.cos(turn) + (y - 80.0) * np.sin(turn)
    found = lm.imaging.sfr_chart(np.where(x < 160, CHART, 0.9 - 0.8 * across(d, 0.8)))
    finding = found.findings.get("left_out")
    assert finding.severity == "note"
    assert finding.numbers["edges"] == len(found.refused) > 0
    assert "slope is not a simple fraction" in finding.text


@pytest.mark.parametrize("length", [0.0, 1.5])
def test_motion_shows_in_the_centre_of_the_field(length):
    # Squares around the centre, and a motion along the rows by a mean of shifted pictures.
    shifts = np.linspace(-0.5, 0.5, 5) * length
    light = np.mean([squares((310, 310), [(x + s, y) for x, y in NINE], 60.0, 0.8) for s in shifts], axis=0)
    found = lm.imaging.sfr_chart(np.random.default_rng(0).poisson(light * 20000) / 20000)
    assert ("unlike_directions" in found.findings.codes) == (length > 0.0)
    if length:
        finding = found.findings.get("unlike_directions")
        assert 0.75 < finding.numbers["ratio"] < 0.97
        assert "motion, or astigmatism" in finding.text


def blurred(right, down, seed):
    """Return a noisy chart whose blur grows with the distance from the middle, and to the right or down."""
    y, x = np.mgrid[-1.0:1.0:310j, -1.0:1.0:310j]
    light = squares((310, 310), NINE, 60.0, 0.7 + 0.15 * (x**2 + y**2) + right * x + down * y)
    return lm.imaging.sfr_chart(np.random.default_rng(seed).poisson(light * 20000) / 20000)


@pytest.mark.parametrize(
    ("right", "down", "worse", "key"),
    [(0.15, 0.0, "right", "right_to_left"), (0.0, -0.15, "top", "bottom_to_top")],
)
def test_a_side_that_is_less_sharp_than_the_other_is_told(right, down, worse, key):
    found = blurred(right, down, 0)
    finding = found.findings.get("unlike_sides")
    assert found.reliable
    assert finding.severity == "note"
    assert finding.text.startswith(f"MTF50 at the {worse} is 0.8")
    assert finding.text.count(" is 0.") == 1
    # MTF50 of both blurs and the pixel, at the mean distance of edges from the middle line.
    widths = [0.7 + 0.15 * 0.8 + sign * 0.15 * 0.62 for sign in (1.0, -1.0)]
    mtf50 = [np.sqrt(np.log(2.0) / (2.0 * np.pi**2 * (width**2 + 1.0 / 12.0))) for width in widths]
    expected = (mtf50[0] / mtf50[1]) ** np.sign(right + down)
    assert finding.numbers[key] == pytest.approx(expected, abs=0.05)
    assert 0.003 < finding.numbers[f"{key}_error"] < 0.03
    other = {"right_to_left", "bottom_to_top"} - {key}
    assert finding.numbers[other.pop()] == pytest.approx(1.0, abs=0.03)


def test_sides_that_are_alike_are_not_told():
    for seed in range(3):
        found = blurred(0.0, 0.0, seed)
        assert "unlike_sides" not in found.findings.codes
        assert list(found.to_dict()["sides"]) == ["right_to_left", "bottom_to_top"]
        for ratio, error in found.sides.values():
            assert 0.001 < error < 0.03
            assert abs(ratio - 1.0) < 4.0 * error


@pytest.mark.parametrize("slope", [0.0, 1.0])
def test_sides_that_the_same_edges_make_are_not_told_apart(slope):
    places, angles = np.linspace(-1.0, 1.0, 24), np.tile([0.1, 0.1 + np.pi / 2.0], 12)
    mtf50 = 0.3 * np.exp(0.1 * places)
    edges = [
        SimpleNamespace(x=x, y=slope * x, response=SimpleNamespace(angle=angle, mtf50=(value, 0.001)))
        for x, angle, value in zip(places, angles, mtf50, strict=True)
    ]
    assert set(edge_chart._sides(edges)) == (set() if slope else {"right_to_left"})


def test_the_border_of_a_picture_that_was_turned_is_no_edge():
    y, x = np.ogrid[:160, :320]
    outside = (y - 0.1 * x < -10) | (x + 0.1 * y < 20)
    found = lm.imaging.sfr_chart(np.where(outside, 0.0, CHART))
    assert len(found.edges) == len(lm.imaging.sfr_chart(CHART).edges)


def test_a_tilted_checkerboard_has_an_edge_on_each_side_of_a_crossing():
    y, x = np.ogrid[:150, :150]
    x, y = x - 74.5, y - 74.5
    u, v = (
        2.0 * across(d, 0.7) - 1.0 for d in (x * np.cos(TURN) + y * np.sin(TURN), y * np.cos(TURN) - x * np.sin(TURN))
    )
    found = lm.imaging.sfr_chart(0.5 + 0.4 * u * v)
    assert len(found.edges) == 4
    for edge in found.edges:
        assert edge.response(0.2) == pytest.approx(truth(0.2, 0.7), abs=5e-3)


@pytest.mark.parametrize(
    ("image", "message"),
    [
        (np.full((60, 60), 0.5), "image must show slanted edges.*got none"),
        (np.random.default_rng(0).normal(0.5, 0.1, (60, 60)), "image must show slanted edges"),
        (
            np.minimum(400.0 * CHART, 255.0).round().astype(np.uint8),
            "^image must not be overexposed.*expose less .8 of 8 edges",
        ),
        (picture(0.5, shape=(90, 90)), "^image must have an edge at 2 to 45 degrees.*got 0.5"),
        (np.ones((2, 60, 60)), r"image must have the shape \(height, width\) or"),
    ],
)
def test_pictures_without_edges_are_refused(image, message):
    with pytest.raises(ValueError, match=message):
        lm.imaging.sfr_chart(image)


def test_maps_show_both_directions():
    figure = lm.imaging.sfr_chart(CHART).plot()
    assert [axes.get_title() for axes in figure.axes[:2]] == ["MTF50, sagittal", "MTF50, tangential"]


def test_maps_show_edges_above_the_nyquist_frequency_apart():
    figure = lm.imaging.sfr_chart(squares((120, 120), [(0.0, 0.0)], 70.0, 0.2)).plot()
    texts = [text.get_text() for axes in figure.axes[:2] for text in axes.texts]
    assert texts == ["> 0.5"] * 4
    assert figure.axes[2].get_ylabel() == "cycles/pixel (triangles: above Nyquist's, 0.5)"
