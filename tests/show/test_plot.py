"""Pictures of PSFs."""

from __future__ import annotations

import matplotlib.pyplot as plt
import numpy as np
import pytest

import lommel as lm
from lommel.show import drawing, plot

METRIC = {"wavelength": 500e-9, "f_number": 4.0}


@pytest.fixture
def image() -> lm.PSF:
    return lm.psf(lm.Pupil(lm.Wavefront(defocus=4.0), **METRIC), (6, 9), 2e-6)


def test_the_picture_shows_the_values_with_row_zero_at_the_top(image):
    axes = image.plot()
    picture = axes.get_images()[0]
    np.testing.assert_array_equal(picture.get_array(), image.values)
    left, right, bottom, top = picture.get_extent()
    # Edges of the outer pixels in micrometres: columns -4..4 and rows -3..2 of 2 um, and half a pixel around.
    assert (left, right, top, bottom) == pytest.approx((-9.0, 9.0, -7.0, 5.0))
    assert axes.get_ylim() == pytest.approx((bottom, top))


@pytest.mark.parametrize(("stretch", "grey"), [("linear", 1e-2), ("sqrt", 1e-1), ("log", 0.6)])
def test_a_hundredth_of_the_peak_is_as_grey_as_the_stretch_says(image, stretch, grey):
    norm = image.plot(stretch=stretch).get_images()[0].norm
    peak = float(image.values.max())
    assert norm(peak) == pytest.approx(1.0)
    assert norm(0.01 * peak) == pytest.approx(grey)
    assert norm(0.0) == pytest.approx(0.0)


@pytest.mark.parametrize(
    ("shape", "panels"), [((3,), (1, 3)), ((2, 4), (2, 4)), ((9,), (2, 5)), ((10,), (2, 5)), ((1,), (1, 1))]
)
def test_a_stack_is_drawn_side_by_side_on_one_scale(shape, panels):
    edge = np.linspace(0.0, 1.0, int(np.prod(shape)))
    stack = lm.psf(lm.Pupil(lm.Wavefront.from_seidel(W020=edge.reshape(shape))), 9, 0.5)
    drawn = stack.plot()
    told = np.array([f"W020 {c:.3g} {'wave' if c == 1.0 else 'waves'}" for c in edge]).reshape(shape)
    assert drawn.shape == shape
    for index in np.ndindex(shape):
        (picture,) = drawn[index].get_images()
        np.testing.assert_array_equal(picture.get_array(), stack.values[index])
        assert picture.norm.vmax == stack.values.max()
        assert drawn[index].get_title() == (told[index] if len(told.flat) > 1 else "0")
        place = drawn[index].get_subplotspec()
        assert place.get_gridspec().get_geometry() == panels
    drawn.flat[0].figure.canvas.draw()


def test_a_stack_takes_no_axes_and_a_large_one_is_to_be_indexed():
    stack = lm.psf(lm.Pupil(lm.Wavefront(np.arange(65.0))), 5, 0.5)
    with pytest.raises(ValueError, match=r"at most 64 pictures can be drawn, got a stack of shape \(65,\); index it"):
        stack.plot()
    with pytest.raises(ValueError, match="ax must be None for a stack"):
        stack[:2].plot(plt.subplots()[1])


@pytest.mark.parametrize("shape", [(21, 101), (65, 65), (101, 21)], ids=str)
def test_the_figure_of_an_image_has_its_aspect_ratio(shape):
    axes = lm.psf(lm.Pupil(), shape, 0.5).plot()
    axes.figure.canvas.draw()
    box = axes.get_window_extent()
    assert box.height / box.width == pytest.approx(shape[0] / shape[1], rel=1e-3)
    assert max(box.width / axes.figure.bbox.width, box.height / axes.figure.bbox.height) > 0.6


@pytest.fixture
def over_the_field() -> lm.PSFGrid:
    field = lm.FieldMap.from_seidel(20e-3, W131=1.0, wavelength=550e-9, f_number=4.0)
    return field.grid(2, 3, sensor=(20e-3, 30e-3), shape=(15, 11), pixel=1e-6, method=lm.paper.Fraunhofer(samples=64))


def test_a_grid_is_drawn_with_each_psf_in_its_place(over_the_field):
    axes = over_the_field.plot()
    axes.figure.canvas.draw()
    pictures = axes.get_images()
    assert len(pictures) == 6
    for (i, j), picture in zip(np.ndindex(2, 3), pictures, strict=True):
        np.testing.assert_array_equal(picture.get_array(), over_the_field.values[i, j])
        left, right, bottom, top = picture.get_extent()
        assert (0.5 * (left + right), 0.5 * (bottom + top)) == pytest.approx(
            (1e3 * over_the_field.x[j], 1e3 * over_the_field.y[i])
        )
        # As large as cells of 10 mm by 10 mm let 15 x 11 square pixels be.
        assert (bottom - top, right - left) == pytest.approx((10.0, 10.0 * 11 / 15))
    assert axes.get_xlim() == pytest.approx((-15.0, 15.0))
    assert axes.get_ylim() == pytest.approx((10.0, -10.0))
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("x on the sensor (mm)", "y on the sensor (mm)")
    assert [text.get_text() for text in axes.get_xticklabels()] == ["−10", "0", "10"]
    assert [text.get_text() for text in axes.get_yticklabels()] == ["−5", "5"]


@pytest.mark.parametrize("stretch", ["sqrt", "linear", "log"])
def test_each_psf_of_a_grid_is_scaled_to_its_own_peak(over_the_field, stretch):
    for picture, values in zip(
        over_the_field.plot(stretch=stretch).get_images(), over_the_field.values.reshape(6, 15, 11), strict=True
    ):
        assert picture.norm(float(values.max())) == pytest.approx(1.0)
        assert picture.norm(0.01 * float(values.max())) == pytest.approx(
            {"sqrt": 0.1, "linear": 0.01, "log": 0.6}[stretch]
        )


def test_a_comparison_shows_each_image_and_the_errors_over_the_peak_along_a_line_too():
    few = {m: lm.psf(lm.Pupil(lm.Wavefront(1.0), **METRIC), 5, 2e-6, method=m) for m in ("hankel", "nijboer-zernike")}
    first, second, bar, slices, errors = plot.compare(few, "hankel").axes
    assert [axes.get_title() for axes in (first, second)] == [
        "hankel, the reference\n(square root)",
        "nijboer-zernike",
    ]
    exact, other = (psf.values.astype(float) for psf in few.values())
    np.testing.assert_array_equal(first.get_images()[0].get_array(), exact)
    away = np.abs(other - exact) / exact.max()
    np.testing.assert_allclose(second.get_images()[0].get_array(), np.maximum(away, 1e-12), rtol=1e-6)
    for axes, expected in ((slices, exact[2, 2:] / exact.max()), (errors, np.maximum(away[2, 2:], 1e-17))):
        np.testing.assert_allclose(axes.get_lines()[0].get_xydata().T, [[0.0, 2.0, 4.0], expected], rtol=1e-6)
        assert (axes.get_xlim(), axes.get_xlabel()) == ((0.0, pytest.approx(4.0)), "distance from the centre (µm)")
    assert (errors.get_title(), errors.get_ylim()) == ("errors along the same line", (1e-17, 3.0))
    assert bar.get_ylabel() == errors.get_ylabel() == "error / peak of the reference"
    assert [text.get_text() for text in errors.get_legend().get_texts()] == ["nijboer-zernike"]
    alone = plot.compare({"hankel": few["hankel"]}, "hankel").axes
    assert (len(alone), alone[-1].get_legend()) == (3, None)


def test_pitches_that_differ_by_more_than_a_billionth_are_not_compared():
    first, near, far = (lm.psf(lm.Pupil(**METRIC), 3, 1e-6 * (1.0 + d)) for d in (0.0, 0.9e-9, 1.1e-9))
    assert lm.show.difference(near, first)
    with pytest.raises(ValueError, match="must have the pixel of b"):
        lm.show.difference(far, first)


@pytest.mark.parametrize("center", [(1, 4), (4, 1), (2, 2)])
def test_rays_beyond_the_window_are_counted_and_do_not_widen_it(center):
    psf = lm.psf(lm.Pupil(lm.Wavefront(9.0), **METRIC), (6, 7), 1e-6, center=center)
    axes, (x, y) = plot.spots(psf), 1e6 * plot.ray_positions(psf.pupil).T
    edges = (left, right), (bottom, top) = np.array([-0.5, 6.5]) - center[1], np.array([5.5, -0.5]) - center[0]
    np.testing.assert_allclose([axes.get_xlim(), axes.get_ylim()], edges, atol=1e-9)
    beyond = (x < left) | (x > right) | (y < top) | (y > bottom)
    assert f", {beyond.sum()} of them beyond the window;" in axes.get_title()


def test_what_is_bright_is_drawn_with_a_rim_of_its_share_as_far_as_there_are_pixels():
    levels = np.zeros((20, 10)), np.zeros((30, 10)), np.zeros((20, 30))
    levels[0][4:9, 0:6] = levels[1][3:12, 5] = levels[2][18, 29] = 1.0
    found = plot._limits((np.arange(10.0), np.arange(20.0), np.arange(30.0)), levels, "linear")
    np.testing.assert_allclose(found, [(-0.5, 5.5 + 0.15 * 6.0), (3.5 - 0.15 * 15.0, 19.5), (-0.5, 29.5)], rtol=1e-12)


def test_a_scale_bar_has_the_largest_round_length_that_fits():
    sizes = 0.999, 1.0, 1.99, 2.0, 4.99, 5.0, 3e-6, 9.99e-6, 2.0 * (1.0 - 0.9e-12), 2.0 * (1.0 - 1.1e-12)
    found = [drawing.round_length(size) for size in sizes]
    assert found == pytest.approx([0.5, 1.0, 1.0, 2.0, 2.0, 5.0, 2e-6, 5e-6, 2.0, 1.0], rel=1e-12)
