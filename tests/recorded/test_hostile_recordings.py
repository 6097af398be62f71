"""Recordings and movies that are damaged or made to harm: a sentence that names the file, and little memory."""

from __future__ import annotations

import os
import struct
import zlib

import numpy as np
import pytest
import tifffile
from PIL import Image

from lommel.recorded.frames import RecordingError, open_frames

BOMB = zlib.compress(bytes(2**23), 9)
PLANE = zlib.compress(bytes(64 * 64))


def pages(path, count, description=b"", *, side=64, following=0, second=None):
    """Write pages of zeros that share their pixels, one after the other or the last before the page `following`."""
    second = second or (side, PLANE)
    data = bytearray(b"II*\0" + struct.pack("<I", 0)) + PLANE + second[1] + description + b"\0"
    data += bytes(len(data) % 2)
    place = {0: 8, 1: 8 + len(PLANE)}
    text = 8 + len(PLANE) + len(second[1])
    at = []
    for k in range(count):
        one = k == 1
        width, part = (second[0], second[1]) if one else (side, PLANE)
        tags = [(256, 4, 1, width), (257, 4, 1, width), (258, 3, 1, 8), (259, 3, 1, 8), (262, 3, 1, 1)]
        tags += [(270, 2, len(description) + 1, text)] if k == 0 and description else []
        tags += [(273, 4, 1, place[one]), (277, 3, 1, 1), (278, 4, 1, width), (279, 4, 1, len(part))]
        struct.pack_into("<I", data, at[-1] if at else 4, len(data))
        data += struct.pack("<H", len(tags)) + b"".join(struct.pack("<HHII", *tag) for tag in tags) + bytes(4)
        at.append(len(data) - 4)
    if following:
        first = struct.unpack_from("<I", data, 4)[0]
        struct.pack_into("<I", data, at[-1], first if following == 1 else struct.unpack_from("<I", data, at[0])[0])
    path.write_bytes(bytes(data))
    return path


def ome(width=64, planes=3, inside=""):
    inside = inside or f'<TiffData IFD="0" PlaneCount="{planes}"/>'
    return (
        '<?xml version="1.0"?><OME xmlns="http://www.openmicroscopy.org/Schemas/OME/2016-06" UUID="urn:uuid:a">'
        f'<Image ID="Image:0"><Pixels ID="Pixels:0" DimensionOrder="XYZCT" Type="uint8" SizeX="{width}" '
        f'SizeY="{width}" SizeZ="{planes}" SizeC="1" SizeT="1">{inside}</Pixels></Image></OME>'
    ).encode()


def all_planes(path):
    with open_frames(path).as_channels() as found:
        return [found[0, k] for k in range(found.shape[1])]


def all_frames(path):
    with open_frames(path).as_stack() as movie:
        return list(movie.blocks(1))


READERS = [(all_planes, RecordingError), (all_frames, RecordingError)]


def refused(path, message):
    """Both readers refuse it in one sentence."""
    for read, kind in READERS:
        with pytest.raises(kind, match=message) as caught:
            read(path)
        assert str(path) in str(caught.value)
        assert "\n" not in str(caught.value)


@pytest.mark.parametrize("following", [1, 2], ids=["the first", "the second"])
def test_pages_that_run_in_a_circle_are_refused(following, tmp_path):
    refused(pages(tmp_path / "a.ome.tif", 150, ome(), following=following), "its chain of pages is circular")


@pytest.mark.parametrize(
    ("text", "claim"), [(ome(width=10**6), r"7\.32e\+08"), (ome(planes=10**9), r"1e\+09"),
                        (ome(inside='<TiffData IFD="0" PlaneCount="1000000000"/>'), r"1e\+09")],
    ids=["width", "planes", "count"],
)  # fmt: skip
def test_sizes_that_are_stated_are_checked_against_pages(text, claim, tmp_path):
    refused(pages(tmp_path / "a.ome.tif", 3, text), f"OME metadata state {claim} planes .* more than its 3 pages")


@pytest.mark.parametrize("second", [(64, BOMB), (4000, BOMB)], ids=["strip", "page"])
def test_a_page_that_takes_more_than_a_plane_is_refused(second, tmp_path):
    path = pages(tmp_path / "a.ome.tif", 3, ome(), second=second)
    refused(path, "inflates to more than 4096 bytes|it has 4000 x 4000 values")


def test_more_images_than_there_are_pages_are_refused(tmp_path):
    path = pages(tmp_path / "a.tif", 1, b"ImageJ=1.53\nimages=1000000\nslices=1000000\n")
    refused(path, "its description states 1000000 images; it has 1 pages")


def test_planes_that_are_missing_are_told(tmp_path):
    refused(pages(tmp_path / "a.ome.tif", 2, ome()), "it is missing")


def beside(name, uuid="urn:uuid:b"):
    return ome(
        planes=2,
        inside='<TiffData IFD="0" FirstZ="0" PlaneCount="1"><UUID FileName="a.ome.tif">urn:uuid:a</UUID></TiffData>'
        f'<TiffData IFD="0" FirstZ="1" PlaneCount="1"><UUID FileName="{name}">{uuid}</UUID></TiffData>',
    )


def test_files_that_ome_metadata_name_are_read_beside_the_first_alone(tmp_path):
    room = tmp_path / "room"
    room.mkdir()
    other = np.full((64, 64), 77, np.uint8)
    for place in (tmp_path / "b.tif", room / "b.tif"):
        tifffile.imwrite(place, other, photometric="minisblack", compression="zlib")
    path = pages(room / "a.ome.tif", 1, beside("b.tif"))
    for found in (all_planes(path), [block[0] for block in all_frames(path)]):
        np.testing.assert_array_equal(found, [np.zeros((64, 64)), other])
    for name in ("../b.tif", str(tmp_path / "b.tif")):
        refused(pages(path, 1, beside(name)), "its metadata name .*b.tif'; only files beside it are read")
    (room / "link.tif").symlink_to(tmp_path / "b.tif")
    os.mkfifo(room / "pipe.tif")
    for name in ("link.tif", "pipe.tif"):
        refused(pages(path, 1, beside(name)), f"name '{name}', which is no regular file")
    pages(room / "circle.tif", 120, following=1)
    refused(pages(path, 1, beside("circle.tif")), "its chain of pages is circular")
    # A file that was given another name since; its own is not looked for.
    moved = pages(
        room / "moved.ome.tif",
        1,
        ome(planes=1, inside='<TiffData><UUID FileName="/x/y.tif">urn:uuid:a</UUID></TiffData>'),
    )
    assert len(all_planes(moved)) == 1
    refused(pages(path, 1, beside("nowhere.tif")), "it is missing")


def test_files_of_micro_manager_are_read_beside_the_first_alone(tmp_path):
    room = tmp_path / "room"
    room.mkdir()
    (tmp_path / "b.tif").write_bytes(b"")
    path, tag = room / "a_MMStack.tif", (51123, 2, 0, '{"MajorVersion": 2}', True)
    tifffile.imwrite(path, np.zeros((8, 8), np.uint8), photometric="minisblack", metadata=None, extratags=[tag])

    def index(name, place):
        axes = b'{"z": %d}' % place
        parts = (struct.pack("<I", len(part)) + part for part in (axes, name.encode()))
        (room / "NDTiff.index").write_bytes(b"".join(parts) + struct.pack("<8I", 8, 8, 8, 0, 0, 0, 0, 0))

    index("../b.tif", 0)
    refused(path, r"its metadata name '\.\./b\.tif'; only files beside it are read")
    index("a_MMStack.tif", 10**9)
    refused(path, r"its NDTiff\.index states 1e\+09 images")
    (room / "NDTiff.index").unlink()
    assert len(all_frames(path)) == 1
    os.mkfifo(room / "a_MMStack_1.tif")
    refused(path, r"its metadata name 'a_MMStack_1\.tif', which is no regular file")


def test_places_beyond_what_python_counts_are_refused(tmp_path):
    path = tmp_path / "a.tif"
    pixels = np.zeros((8, 8), np.uint8)
    tifffile.imwrite(path, pixels, photometric="minisblack", bigtiff=True, description="a longer text")
    data = bytearray(path.read_bytes())
    (first,) = struct.unpack_from("<Q", data, 8)
    place = next(at for at in range(first + 8, len(data), 20) if struct.unpack_from("<H", data, at)[0] == 270)
    struct.pack_into("<Q", data, place + 12, 2**64 - 2)
    path.write_bytes(data)
    refused(path, "its tag 270 claims")
    struct.pack_into("<Q", data, 8, 2**64 - 2)
    path.write_bytes(data)
    refused(path, "its pages go beyond its end")


def test_libtiff_prints_nothing_of_damage(tmp_path, capfd):
    frames = [Image.fromarray(np.random.default_rng(k).integers(0, 9, (16, 16)).astype(np.uint8)) for k in range(3)]
    path = tmp_path / "a.tif"
    frames[0].save(path, save_all=True, append_images=frames[1:], compression="tiff_lzw")
    with tifffile.TiffFile(path) as file:
        place, held = file.pages[1].dataoffsets[0], file.pages[1].databytecounts[0]
    data = bytearray(path.read_bytes())
    data[place : place + held] = b"\xff" * held
    path.write_bytes(data)
    with pytest.raises(RecordingError, match=r"a\.tif: page 1: its LZW data cannot be unpacked"):
        all_frames(path)
    os.write(2, b"what comes next")
    assert capfd.readouterr() == ("", "what comes next")
