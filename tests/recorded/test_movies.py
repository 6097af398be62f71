"""Movies: TIFF files as cameras and programs write them, in blocks, and what is refused."""

from __future__ import annotations

import struct
import tracemalloc
from pathlib import Path

import numpy as np
import pytest
import tifffile

from lommel.recorded.frames import RecordingError, open_frames

COUNTS = np.random.default_rng(1).integers(0, 4000, (7, 5, 6))


def pages(path: Path, frames: np.ndarray, **options) -> None:
    """A page for each frame, with others between their pixels, as cameras write while they record."""
    with tifffile.TiffWriter(
        path, bigtiff=options.pop("bigtiff", False), byteorder=options.pop("byteorder", "<")
    ) as file:
        for frame in frames:
            file.write(frame, contiguous=False, metadata=None, **options)


WRITERS = {
    "pages": pages,
    "stack": lambda path, frames: tifffile.imwrite(path, frames, photometric="minisblack"),
    "ome": lambda path, frames: tifffile.imwrite(path, frames, ome=True, metadata={"axes": "TYX"}),
    "ome-z": lambda path, frames: tifffile.imwrite(path, frames, ome=True, metadata={"axes": "ZYX"}),
    "imagej": lambda path, frames: tifffile.imwrite(path, frames, imagej=True, metadata={"axes": "TYX"}),
    "big": lambda path, frames: pages(path, frames, bigtiff=True),
    "turned": lambda path, frames: pages(path, frames, byteorder=">"),
    "deflate": lambda path, frames: pages(path, frames, compression="zlib"),
    "strips": lambda path, frames: pages(path, frames, compression="zlib", rowsperstrip=2),
    "tiles": lambda path, frames: pages(path, frames, compression="zlib", tile=(16, 16)),
    "predictor": lambda path, frames: pages(path, frames, compression="zlib", predictor=True),
}


@pytest.mark.parametrize("way", WRITERS)
def test_every_way_to_write_a_movie_is_read_in_blocks(way, tmp_path):
    path, frames = tmp_path / "movie.tif", COUNTS.astype(np.uint16)
    WRITERS[way](path, frames)
    with open_frames(path).as_stack() as movie:
        assert (movie.shape, movie.dtype, len(movie)) == ((7, 5, 6), np.uint16, 7)
        blocks = list(movie.blocks(3))
        assert [len(block) for block in blocks] == [3, 3, 1]
        np.testing.assert_array_equal(np.concatenate(blocks), frames)
        np.testing.assert_array_equal(movie[2:4], frames[2:4])
        assert movie[7:7].shape == (0, 5, 6)
        (whole,) = movie.blocks()
        assert whole.dtype == movie.dtype
        whole[:] = 0  # its own copy


@pytest.mark.parametrize("kind", ["uint8", "uint16", "uint32", "uint64", "int16", "float16", "float32", "float64"])
@pytest.mark.parametrize("way", ["pages", "stack"])
def test_frames_hold_integers_or_floats_of_any_width(way, kind, tmp_path):
    frames = (COUNTS // 20).astype(kind)
    WRITERS[way](tmp_path / "movie.tif", frames)
    with open_frames(str(tmp_path / "movie.tif")).as_stack() as movie:
        (found,) = movie.blocks()
        assert found.dtype == movie.dtype == np.dtype(kind)
        np.testing.assert_array_equal(found, frames)


@pytest.mark.parametrize("way", ["pages", "stack"])
def test_a_movie_is_never_in_memory_as_a_whole(way, tmp_path):
    frames = np.zeros((200, 128, 128), np.uint16)
    WRITERS[way](tmp_path / "movie.tif", frames)
    tracemalloc.start()
    try:
        with open_frames(tmp_path / "movie.tif").as_stack() as movie:
            for _ in movie.blocks(10):
                pass
        _, most = tracemalloc.get_traced_memory()
    finally:
        tracemalloc.stop()
    assert most < 0.4 * frames.nbytes


def refused(path: Path) -> str:
    with pytest.raises(RecordingError) as caught, open_frames(path).as_stack() as movie:
        for _ in movie.blocks(2):
            pass
    assert str(path) in str(caught.value)
    assert "\n" not in str(caught.value)
    return str(caught.value)


def test_what_is_no_movie_is_told(tmp_path):
    path = tmp_path / "movie.tif"
    path.write_bytes(b"")
    assert "movie.tif is empty" in refused(path)
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + bytes(100))
    assert "movie.tif: " in refused(path)
    path.write_bytes(b"GIF89a" + bytes(100))
    assert "movie.tif is not a TIFF, FITS, NPY, PNG, ND2, CZI or LIF file, nor a folder of OME-Zarr" in refused(path)
    tifffile.imwrite(path, np.zeros((4, 8, 8, 3), np.uint8), photometric="rgb")
    assert "it holds colours (RGB), 4 x 8 x 8 x 3 along QYXS; save each channel in grey" in refused(path)
    tifffile.imwrite(path, np.zeros((2, 3, 8, 8), np.uint8), ome=True, metadata={"axes": "TZYX"})
    assert (
        "it holds 2 x 3 x 8 x 8 values along TZYX: save one stack of images, of one channel and time point"
        in refused(path)
    )
    tifffile.imwrite(path, np.zeros((4, 8, 8), np.complex64), photometric="minisblack")
    assert "must hold real numbers, got complex64" in refused(path)
    with tifffile.TiffWriter(path) as file:
        file.write(np.zeros((3, 8, 8), np.uint8), photometric="minisblack")
        file.write(np.zeros((3, 9, 9), np.uint8), photometric="minisblack")
    assert "it holds 2 images, [0] of 3 x 8 x 8, [1] of 3 x 9 x 9: name one, as in movie.tif[0]" in refused(path)
    with tifffile.TiffWriter(path) as file:
        for side in (*[8] * 10, 9, *[8] * 3):
            file.write(np.zeros((8, side), np.uint8), contiguous=False, photometric="minisblack")
    assert "it holds 2 images, [0] of 13 x 8 x 8, [1] of 8 x 9: name one, as in movie.tif[0]" in refused(path)
    with pytest.raises(FileNotFoundError, match="nowhere"):
        open_frames(tmp_path / "nowhere.tif").as_stack()
    with pytest.raises(RecordingError, match="no OME-Zarr"):
        open_frames(tmp_path).as_stack()
    with pytest.raises(ValueError, match="images must have images of one pixel or more"):
        open_frames(5)


@pytest.mark.parametrize("way", ["stack", "imagej", "ome", "pages", "deflate"])
def test_a_movie_that_was_cut_off_is_told(way, tmp_path):
    path = tmp_path / "movie.tif"
    WRITERS[way](path, np.random.default_rng(0).integers(0, 60000, (50, 40, 40)).astype(np.uint16))
    data = path.read_bytes()
    for kept in (40 * 40 * 2 * 20, 40 * 40 * 2 * 20 + 1500, len(data) // 2):
        path.write_bytes(data[:kept])
        refused(path)


def test_an_array_that_was_cut_off_is_told_with_its_bytes(tmp_path):
    path = tmp_path / "movie.npy"
    np.save(path, np.zeros((50, 40, 40), np.uint16))
    data = path.read_bytes()
    for kept in (len(data) - 1, 200):
        path.write_bytes(data[:kept])
        assert f"movie.npy: its header states more than its {kept} bytes: it is cut off" in refused(path)


@pytest.mark.parametrize("way", ["pages", "deflate"])
def test_damaged_frames_are_told_with_their_number(way, tmp_path):
    path = tmp_path / "movie.tif"
    noise = np.random.default_rng(0).integers(0, 60000, (5, 40, 40)).astype(np.uint16)
    WRITERS[way](path, noise)
    with tifffile.TiffFile(path) as file:
        place, size = file.pages[3].dataoffsets[0], file.pages[3].databytecounts[0]
        count = file.pages[3].tags["StripByteCounts"].valueoffset
    data = bytearray(path.read_bytes())
    if way == "deflate":
        data[place : place + size] = bytes(size)
    else:
        data[count : count + 4] = struct.pack("<I", size // 2)
    path.write_bytes(bytes(data))
    assert "movie.tif: page 3: " in refused(path)


def test_several_files_are_one_stack_with_names(tmp_path):
    paths = [tmp_path / f"{name}.tif" for name in "ab"]
    for path, frames in zip(paths, (COUNTS[:1], COUNTS[1:4]), strict=True):
        tifffile.imwrite(path, frames.astype(np.uint16), photometric="minisblack")
    found = open_frames(*paths)
    np.testing.assert_array_equal(found, COUNTS[:4])
    assert found.names == ("a.tif", "b.tif [0]", "b.tif [1]", "b.tif [2]")
    with open_frames(paths[1]) as alone:
        assert alone.names == found.names[1:]
    with pytest.raises(ValueError, match="paths must name a file or several, got none"):
        open_frames()
