"""Recordings and movies that are damaged: a sentence that names the file, never other images."""

from __future__ import annotations

import struct
import zlib

import numpy as np
import pytest
import tifffile
from PIL import Image

from lommel.recorded.frames import RecordingError, open_frames

PLANE = zlib.compress(bytes(64 * 64))


def ome(planes):
    return (
        '<?xml version="1.0"?><OME xmlns="http://www.openmicroscopy.org/Schemas/OME/2016-06" UUID="urn:uuid:a">'
        '<Image ID="Image:0"><Pixels ID="Pixels:0" DimensionOrder="XYZCT" Type="uint8" SizeX="64" SizeY="64" '
        f'SizeZ="{planes}" SizeC="1" SizeT="1"><TiffData IFD="0" PlaneCount="{planes}"/></Pixels></Image></OME>'
    )


def refused(path, message):
    """Both readers refuse it in one sentence."""
    for read in (lambda frames: frames.as_channels()[0], lambda frames: frames.as_stack()[...]):
        with pytest.raises(RecordingError, match=message) as caught, open_frames(path) as frames:
            read(frames)
        assert str(path) in str(caught.value)
        assert "\n" not in str(caught.value)


def test_more_images_than_there_are_pages_are_refused(tmp_path):
    text = "ImageJ=1.53\nimages=1000000\nslices=1000000\n"
    options = {"description": text, "metadata": None, "compression": "zlib"}
    tifffile.imwrite(tmp_path / "a.tif", np.zeros((8, 8), np.uint8), **options)
    refused(tmp_path / "a.tif", "its description states 1000000 images; it has 1 pages")


def test_planes_that_are_missing_are_told(tmp_path):
    tifffile.imwrite(tmp_path / "a.ome.tif", np.zeros((2, 64, 64), np.uint8), description=ome(3), metadata=None)
    refused(tmp_path / "a.ome.tif", "it is missing")


def test_a_page_of_another_size_is_refused(tmp_path):
    with tifffile.TiffWriter(tmp_path / "a.ome.tif") as file:
        file.write(np.zeros((64, 64), np.uint8), description=ome(2), metadata=None, compression="zlib")
        file.write(np.zeros((32, 64), np.uint8), metadata=None, compression="zlib")
    refused(tmp_path / "a.ome.tif", "page 1: ")


def frame_by_frame(path, frames, **options):
    with tifffile.TiffWriter(path) as file:
        for frame in frames:
            file.write(frame, contiguous=False, photometric="minisblack", **options)


def test_frames_written_one_by_one_are_a_stack(tmp_path):
    frames = np.arange(48, dtype=np.uint16).reshape(3, 4, 4)
    for options in ({}, {"metadata": None}, {"compression": "zlib"}, {"rowsperstrip": 2}):
        frame_by_frame(tmp_path / "a.tif", frames, **options)
        with open_frames(tmp_path / "a.tif") as images:
            np.testing.assert_array_equal(images[...], frames)


@pytest.mark.parametrize("small", [(2, 2), (3, 4)])
def test_of_frames_of_two_sizes_one_must_be_named(small, tmp_path):
    frame_by_frame(tmp_path / "a.tif", [*np.ones((3, 4, 4), np.uint16), *np.ones((3, *small), np.uint16)])
    message = rf"it holds 2 images, \[0\] of 3 x 4 x 4, \[1\] of 3 x {small[0]} x {small[1]}: name one"
    with pytest.raises(RecordingError, match=message):
        open_frames(tmp_path / "a.tif")
    with open_frames(f"{tmp_path / 'a.tif'}[1]") as images:
        assert images.shape == (3, *small)


@pytest.mark.parametrize("mark", [0, 1])
def test_a_smaller_image_is_left_out_where_it_is_marked_as_such(mark, tmp_path):
    with tifffile.TiffWriter(tmp_path / "a.tif") as file:
        for side, kind in ((8, 0), (4, mark)):
            file.write(np.zeros((side, side), np.uint16), photometric="minisblack", subfiletype=kind, metadata=None)
    if mark:
        assert open_frames(tmp_path / "a.tif").shape == (8, 8)
    else:
        with pytest.raises(RecordingError, match="it holds 2 images"):
            open_frames(tmp_path / "a.tif")


def test_strips_of_each_page_are_where_it_states(tmp_path):
    path, frames = tmp_path / "a.tif", np.arange(32, dtype=np.uint8).reshape(2, 4, 4)
    frame_by_frame(path, frames, rowsperstrip=2)
    with tifffile.TiffFile(path) as file:
        (first, second), place = file.pages[1].dataoffsets, file.pages[1].tags[273].valueoffset
        kind = {3: "<HH", 4: "<II"}[file.pages[1].tags[273].dtype]
    data = bytearray(path.read_bytes())
    struct.pack_into(kind, data, place, second, first)
    path.write_bytes(data)
    with open_frames(path) as images:
        np.testing.assert_array_equal(images[...], [frames[0], np.roll(frames[1], 2, axis=0)])


def test_a_page_that_states_fewer_bytes_than_its_values_take_is_refused(tmp_path):
    path = tmp_path / "a.tif"
    frame_by_frame(path, np.zeros((3, 4, 4), np.uint16))
    with tifffile.TiffFile(path) as file:
        entry = file.pages[1].tags[279].offset
    with path.open("r+b") as file:
        file.seek(entry + 8)
        file.write(struct.pack("<I", 31))
    with open_frames(path) as images, pytest.raises(RecordingError, match="take 32 bytes, got 31"):
        images[...]


def test_lzw_data_that_are_damaged_are_told(tmp_path):
    frames = [Image.fromarray(np.random.default_rng(k).integers(0, 9, (16, 16)).astype(np.uint8)) for k in range(3)]
    path = tmp_path / "a.tif"
    frames[0].save(path, save_all=True, append_images=frames[1:], compression="tiff_lzw")
    with tifffile.TiffFile(path) as file:
        place, held = file.pages[1].dataoffsets[0], file.pages[1].databytecounts[0]
    data = bytearray(path.read_bytes())
    data[place : place + held] = b"\xff" * held
    path.write_bytes(data)
    message = r"a\.tif: page 1: its LZW data cannot be unpacked"
    with open_frames(path) as images, pytest.raises(RecordingError, match=message):
        images[...]
