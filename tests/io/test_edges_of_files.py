"""Photographs and frames at the edge of what is taken."""

from __future__ import annotations

import io

import numpy as np
import pytest
from PIL import Image

from lommel.io import photos


def jpeg(path, exif: bytes) -> None:
    buffer = io.BytesIO()
    Image.fromarray(np.full((8, 8), 90, np.uint8)).save(buffer, format="jpeg", exif=exif)
    path.write_bytes(buffer.getvalue())


@pytest.mark.parametrize("orientation", [0, 9, 255])
def test_an_orientation_that_has_no_meaning_is_refused(tmp_path, orientation):
    exif = Image.Exif()
    exif[0x0112] = orientation
    jpeg(tmp_path / "turned.jpg", exif.tobytes())
    with pytest.raises(photos.PhotoError, match=f"orientation {orientation}; 1 to 8"):
        photos.read_photo(tmp_path / "turned.jpg")
    exif[0x0112] = 8
    jpeg(tmp_path / "good.jpg", exif.tobytes())
    assert photos.read_photo(tmp_path / "good.jpg").values.shape == (8, 8)


def test_a_folder_in_the_way_of_one_frame_keeps_all_from_being_written(tmp_path):
    (tmp_path / "f2.png").mkdir()
    made = [np.full((4, 4), 10 * k, np.uint8) for k in range(3)]
    with pytest.raises(IsADirectoryError, match=r"is a directory: .*f2\.png"):
        photos.write_frames(tmp_path / "f%d.png", made)
    assert [path.name for path in tmp_path.iterdir()] == ["f2.png"]
    (tmp_path / "f2.png").rmdir()
    assert len(photos.write_frames(tmp_path / "f%d.png", made)) == 3
