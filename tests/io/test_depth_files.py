"""Maps of depth, written and read again."""

from __future__ import annotations

import numpy as np
import pytest

from lommel.imaging import read_depth, write_depth


@pytest.mark.parametrize("suffix", [".tif", ".tiff", ".npy", ".pfm"])
def test_what_is_written_is_read(tmp_path, suffix):
    depth = np.array([[1.5, np.nan, np.inf], [0.25, 2.0, 1e-3]])
    write_depth(tmp_path / f"depth{suffix}", depth)
    assert np.array_equal(read_depth(tmp_path / f"depth{suffix}"), depth.astype(np.float32), equal_nan=True)


def test_what_is_no_map_is_told(tmp_path):
    with pytest.raises(ValueError, match=r"must end in \.npy, \.pfm, \.tif, \.tiff"):
        write_depth(tmp_path / "depth.png", np.ones((2, 2)))
    for wrong in (np.ones(3), np.ones((2, 2, 2)), np.array([["a"]]), np.ones((0, 2))):
        with pytest.raises((TypeError, ValueError), match="depth must be numbers"):
            write_depth(tmp_path / "depth.npy", wrong)
    with pytest.raises(ValueError, match="depth must be >= 0 metres, got -1"):
        write_depth(tmp_path / "depth.npy", np.array([[1.0, -1.0]]))
    assert not list(tmp_path.iterdir())
