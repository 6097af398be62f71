"""Pictures of depth maps of blocks."""

from __future__ import annotations

import numpy as np
import pytest

pytest.importorskip("matplotlib", reason="colours need matplotlib")

from matplotlib import colormaps

from lommel.show.estimates import DepthColours


def test_colours_are_even_in_one_over_distance_and_grey_where_not_known():
    draw = DepthColours((1.0, np.inf), (8, 18), 4, beside=False)
    depth = np.array([[1.0, 2.0, np.inf, np.nan], [4.0, 0.5, 1e9, np.nan]], np.float32)
    picture = draw(depth)
    assert picture.shape == (8 + 24, 18, 3)
    expected = 255.0 * colormaps["viridis_r"](np.array([0.0, 0.5, 1.0]))[:, :3]
    assert np.abs(picture[0, :8:4] - expected[:2]).max() <= 1.5
    assert np.abs(picture[4, [4, 8]] - expected[[0, 2]]).max() <= 1.5  # beyond the range: its ends
    assert (picture[:8, 12:] == 128).all()
    assert (draw(np.full((2, 4), np.nan, np.float32))[:8] == 128).all()


def test_an_image_stands_beside_and_is_forgotten_where_there_is_none():
    draw = DepthColours((1.0, 2.0), (16, 16), 4, beside=True)
    image = np.arange(256, dtype=np.uint8).reshape(16, 16)
    depth = np.full((4, 4), 1.0, np.float32)
    assert np.array_equal(draw(depth, image)[:16, 16:], np.repeat(image[..., None], 3, axis=2))
    assert (draw(depth)[:16, 16:] == 128).all()
