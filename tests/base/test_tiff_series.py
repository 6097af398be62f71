"""Images of TIFF files: the same as tifffile finds, in a time that grows like the number of pages."""

from __future__ import annotations

import io
import random
import struct
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import tifffile

import hostile_files
from lommel.base import reading, tiff_series
from lommel.recorded.frames import RecordingError, open_frames

SHAPES = [(16, 16), (8, 8), (4, 4), (2, 2), (15, 16), (5, 5), (3, 16, 16), (2, 8, 8), (1, 8, 8), (8, 8, 3), (33, 32)]


def opened(source: Any) -> tiff_series.File:
    return tiff_series.File(source, reading.tiff_directories, reading.afford_pages)


def drawn(seed: int) -> bytes:
    """Return a file of a few pages of up to three kinds, in any order."""
    draw = random.Random(seed)
    described = draw.choice([1.0, 0.8, 0.0])
    kinds = [
        {
            "shape": draw.choice(SHAPES),
            "dtype": draw.choice(["u1", "u2", "f4"]),
            "compression": draw.choice([None, None, "zlib"]),
            "subfiletype": draw.choice([0, 0, 1]),
            "subifds": draw.choice([0, 0, 0, 1]),
            "layout": draw.choice([{}, {}, {"rowsperstrip": 2}, {"tile": (16, 16)}]),
            "extratags": [(65000, "s", 0, "words", True)] * draw.choice([0, 1]),
            "is_turned": draw.random() < 0.2,
            "has_axes": draw.random() < 0.2,
        }
        for _ in range(draw.randint(1, 3))
    ]
    buffer = io.BytesIO()
    with tifffile.TiffWriter(buffer, bigtiff=draw.random() < 0.3, byteorder=draw.choice("<>")) as file:
        for number in range(draw.randint(1, 12)):
            kind = draw.choice(kinds)
            values = np.arange(number, number + np.prod(kind["shape"])).reshape(kind["shape"]).astype(kind["dtype"])
            metadata: Any = {} if draw.random() < described else None
            if metadata is not None and kind["has_axes"]:
                metadata = {"axes": "QYX"[-values.ndim :], "name": f"image {number}"}
            turned = [(274, 3, 1, draw.randint(1, 3), True)] * kind["is_turned"]
            options: dict[str, Any] = {name: kind[name] for name in ("compression", "subfiletype", "subifds")}
            options |= {"metadata": metadata, "photometric": "rgb" if values.shape[-1] == 3 else "minisblack"}
            may_continue = not kind["compression"] and "tile" not in kind["layout"]
            options |= {"contiguous": may_continue and draw.random() < 0.2, "extratags": kind["extratags"] + turned}
            file.write(values, **options, **kind["layout"])
            if kind["subifds"]:
                half = values[::2, ::2] if values.shape[-1] == 3 else values[..., ::2, ::2]
                file.write(half, **options | {"subfiletype": 1, "subifds": 0})
    return buffer.getvalue()


def found(file: tifffile.TiffFile) -> list[tuple[object, ...]]:
    return [
        (
            *(series.axes, series.shape, series.dtype, series.kind, series.name, series.dataoffset, len(series)),
            [page and (page.index, page.offset, page.keyframe.hash) for page in series.pages],
            series.keyframe.tags.valueof(274),
            series.asarray(maxworkers=1).tobytes(),
        )
        for series in file.series
    ]


@pytest.mark.parametrize("seed", range(40))
def test_series_are_those_of_tifffile(seed):
    data = drawn(seed)
    expected, error = None, None
    with reading.quietly():
        try:
            with tifffile.TiffFile(io.BytesIO(data)) as file:
                expected = found(file)
        except Exception as raised:  # of many types
            error = type(raised)
        if error is None:
            with opened(io.BytesIO(data)) as file:
                assert found(file) == expected
        else:
            with pytest.raises(error), opened(io.BytesIO(data)) as file:
                found(file)


def frame_by_frame(path: Path, count: int, *, small: str = "", **options: Any) -> None:
    """Write frames one by one: all alike, or smaller ones at the end, or at every second place."""
    with tifffile.TiffWriter(path) as file:
        for number in range(count):
            is_small = number % 2 if small == "each" else small == "last" and number == count - 1
            frame = np.full((2, 2) if is_small else (4, 4), number, np.uint16)
            more = {"subfiletype": 1} if is_small and "metadata" not in options else {}
            file.write(frame, contiguous=False, photometric="minisblack", **options, **more)


def stack(path: Path, count: int, **options: Any) -> None:
    tifffile.imwrite(path, np.zeros((count, 4, 4), np.uint16), photometric="minisblack", **options)


def stacks(path: Path, count: int) -> None:
    with tifffile.TiffWriter(path) as file:
        for _ in range(count):
            file.write(np.zeros((2, 4, 4), np.uint16), contiguous=False, photometric="minisblack", metadata=None)


WRITERS = {
    "frames": frame_by_frame,
    "deflated": lambda path, count: frame_by_frame(path, count, compression="zlib"),
    "plain": lambda path, count: frame_by_frame(path, count, metadata=None),
    "one thumbnail": lambda path, count: frame_by_frame(path, count, small="last"),
    "thumbnails": lambda path, count: frame_by_frame(path, count, small="each"),
    "two sizes": lambda path, count: frame_by_frame(path, count, small="each", metadata=None),
    "last smaller": lambda path, count: frame_by_frame(path, count, small="last", metadata=None),
    "stacks": stacks,
    "stack": lambda path, count: stack(path, count, compression="zlib"),
    "imagej": lambda path, count: stack(path, count, imagej=True, metadata={"axes": "TYX"}),
    "ome": lambda path, count: stack(path, count, ome=True, metadata={"axes": "TYX"}, compression="zlib"),
}


def lines_run(path: Path) -> int:
    """Return the number of lines of Python that run while all images of a file are opened and read."""
    count = 0

    def trace(_frame: object, event: str, _argument: object) -> object:
        nonlocal count
        count += event == "line"
        return trace

    before = sys.gettrace()
    sys.settrace(trace)
    try:
        with open_frames(f"{path}[0]" if path.stem in ("two sizes", "last smaller") else path) as images:
            images[...]
    finally:
        sys.settrace(before)
    return count


@pytest.mark.parametrize("way", WRITERS)
def test_opening_and_reading_is_linear_in_the_number_of_pages(way, tmp_path):
    path, counts = tmp_path / f"{way}.tif", []
    for pages in (10, 10, 20, 40):  # the first fills caches
        WRITERS[way](path, pages)
        counts.append(lines_run(path))
    assert counts[3] - counts[2] <= 1.005 * 2.0 * (counts[2] - counts[1])


@pytest.mark.parametrize(("kind", "count"), [(0, 2), (1, 1)])
def test_smaller_images_are_levels_of_a_pyramid_where_they_are_marked_so(kind, count):
    buffer = io.BytesIO()
    with tifffile.TiffWriter(buffer) as file:
        for side, mark in ((8, 0), (4, kind)):
            file.write(np.zeros((side, side), np.uint16), photometric="minisblack", subfiletype=mark)
    with opened(io.BytesIO(buffer.getvalue())) as file:
        assert len(file.series) == count


def test_pages_that_are_alike_are_read_as_frames(tmp_path):
    frame_by_frame(tmp_path / "a.tif", 20)
    with opened(tmp_path / "a.tif") as file:
        pages = [page for series in file.series for page in series.pages]
    assert [isinstance(page, tifffile.TiffPage) for page in pages] == [True] + [False] * 19


def changed(path: Path, tag: int, values: bytes) -> None:
    """Change the inline value of a tag of the second page."""
    with tifffile.TiffFile(path) as file:
        entry = file.pages[1].tags[tag].offset
    with path.open("r+b") as file:
        file.seek(entry + 8)
        file.write(values)


def test_strips_of_each_page_are_where_it_states(tmp_path):
    path, frames = tmp_path / "a.tif", np.arange(32, dtype=np.uint8).reshape(2, 4, 4)
    with tifffile.TiffWriter(path) as file:
        for frame in frames:
            file.write(frame, contiguous=False, photometric="minisblack", rowsperstrip=2)
    with tifffile.TiffFile(path) as file:
        (first, second), place = file.pages[1].dataoffsets, file.pages[1].tags[273].valueoffset
        kind = {3: "<HH", 4: "<II"}[file.pages[1].tags[273].dtype]
    data = bytearray(path.read_bytes())
    struct.pack_into(kind, data, place, second, first)
    path.write_bytes(data)
    with open_frames(path) as images:
        np.testing.assert_array_equal(images[...], [frames[0], np.roll(frames[1], 2, axis=0)])


def test_a_page_that_states_fewer_bytes_than_its_values_take_is_refused(tmp_path):
    frame_by_frame(tmp_path / "a.tif", 3)
    changed(tmp_path / "a.tif", 279, struct.pack("<I", 31))
    with open_frames(tmp_path / "a.tif") as images, pytest.raises(RecordingError, match="take 32 bytes, got 31"):
        images[...]


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ('{"shape": [2, 1, 1]}', r"it holds 2500 images, some of several pages; the limit is 2048"),
        ('{"shape": [1, 1]' + " " * 999 + "}", r"its descriptions claim \d+ bytes of a file of \d+"),
    ],
)
def test_files_that_would_take_long_are_refused(text, message, tmp_path):
    (tmp_path / "a.tif").write_bytes(hostile_files.many_pages(5000, text))
    with pytest.raises(RecordingError, match=message):
        open_frames(tmp_path / "a.tif")
