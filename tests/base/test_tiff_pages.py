"""Pages of long TIFF files, which are found here and told to tifffile: as it finds them itself, in less time."""

from __future__ import annotations

import re
import struct
import sys
from pathlib import Path

import numpy as np
import pytest
import tifffile

from lommel.base import reading
from lommel.recorded.frames import RecordingError, open_frames

STACK = np.random.default_rng(0).integers(0, 60000, (70, 6, 5)).astype(np.uint16)
OME = {"axes": "ZYX"}


def pages(path, frames, *, big=False, order="<", **options):
    with tifffile.TiffWriter(path, bigtiff=big, byteorder=order) as file:
        for k, frame in enumerate(frames):
            said = {name: value[k] if isinstance(value, list) else value for name, value in options.items()}
            file.write(frame, contiguous=False, metadata=None, photometric="minisblack", **said)


def one(k, usual, other):
    """Options of which page k has another."""
    return [other if j == k else usual for j in range(70)]


IMAGE = (
    '<Image ID="Image:{0}"><Pixels ID="Pixels:{0}" DimensionOrder="XYZCT" Type="uint16" SizeX="5" SizeY="6" '
    'SizeZ="35" SizeC="1" SizeT="1"><TiffData IFD="{1}" PlaneCount="35"/></Pixels></Image>'
)
TWO = f"<OME>{IMAGE.format(0, 0)}{IMAGE.format(1, 35)}</OME>"


WRITERS = {
    "ome": lambda path: tifffile.imwrite(path, STACK, ome=True, metadata=OME, photometric="minisblack"),
    "ome, deflated": lambda path: tifffile.imwrite(path, STACK, ome=True, metadata=OME, compression="zlib"),
    "ome, big": lambda path: tifffile.imwrite(path, STACK, ome=True, metadata=OME, bigtiff=True),
    "ome, two images": lambda path: pages(path, STACK, description=one(0, None, TWO)),
    "pages": lambda path: pages(path, STACK),
    "big": lambda path: pages(path, STACK, big=True),
    "turned": lambda path: pages(path, STACK, order=">"),
    "big, turned": lambda path: pages(path, STACK, big=True, order=">"),
    "deflated": lambda path: pages(path, STACK, compression="zlib"),
    "imagej": lambda path: pages(path, STACK, description=one(0, None, "ImageJ=1.53t\nimages=70\nframes=70\n")),
}
# Pages that are not alike are found by tifffile alone.
OTHERS = {
    "strips": lambda path: pages(path, STACK, compression="zlib", rowsperstrip=2),
    "tiles": lambda path: pages(path, STACK, compression="zlib", tile=(16, 16)),
    "dates": lambda path: pages(path, STACK, datetime=one(40, None, "2020:01:01 00:00:00")),
    "descriptions": lambda path: pages(path, STACK, description=[str(k) for k in range(70)]),
    "one of deflate": lambda path: pages(path, STACK, compression=one(40, None, "zlib")),
    "one of other width": lambda path: pages(path, [*STACK[:40], np.zeros((6, 4), np.uint16), *STACK[:29]]),
    "one of other height": lambda path: pages(path, [*STACK[:40], np.zeros((5, 5), np.uint16), *STACK[:29]]),
    "one of other type": lambda path: pages(path, [*STACK[:40], np.zeros((6, 5), np.int16), *STACK[:29]]),
    "the first of other height": lambda path: pages(path, [np.zeros((5, 5), np.uint16), *STACK[:69]]),
    "the first in strips": lambda path: pages(path, STACK, compression="zlib", rowsperstrip=one(0, 6, 3)),
}


def answer(path, image=None):
    """Return what is found of a file: axes and values, or what is wrong with it; and where its pages are."""
    try:
        with open_frames(path, image=image) as found:
            places = [
                (page.index, page.offset, page.dataoffsets, page.databytecounts)
                for page in getattr(found.planes, "_pages", ())
            ]
            return found.axes, found.shape, found[...].tobytes(), places
    except RecordingError as error:
        return str(error)


@pytest.mark.parametrize("way", [*WRITERS, *OTHERS])
def test_pages_are_found_as_tifffile_finds_them(way, tmp_path, monkeypatch):
    path = tmp_path / "a.tif"
    (WRITERS | OTHERS)[way](path)
    read, tags = tifffile.TiffTag.fromfile, []
    monkeypatch.setattr(tifffile.TiffTag, "fromfile", lambda *given, **said: tags.append(0) or read(*given, **said))
    image = 1 if "two" in way else None
    found = answer(path, image)
    quick = len(tags)
    monkeypatch.setattr(reading, "_MANY", 1000)
    assert answer(path, image) == found
    if way in WRITERS:
        assert found[2] == STACK[35 if image else 0 :].tobytes()
        with tifffile.TiffFile(path) as file:
            told = hasattr(file.pages, "_loaded")  # not of older releases
        assert quick < 100 < len(tags) - quick or not told  # those of the first and the last
    else:
        assert quick == len(tags) - quick


def sparse(path: Path, count: int, apart: int) -> None:
    """Write pages that lie far apart, and nothing between them."""
    tags = [(256, 4, 1, 16), (257, 4, 1, 16), (258, 3, 1, 8), (259, 3, 1, 1), (262, 3, 1, 1), (273, 4, 1, 0)]
    tags += [(277, 3, 1, 1), (278, 4, 1, 16), (279, 4, 1, 256)]
    with path.open("wb") as file:
        file.write(b"II*\0" + struct.pack("<I", apart))
        for k in range(1, count + 1):
            file.seek(k * apart)
            own = [(*tag[:3], k * apart + 512) if tag[0] == 273 else tag for tag in tags]
            file.write(struct.pack("<H", len(own)) + b"".join(struct.pack("<HHII", *tag) for tag in own))
            file.write(struct.pack("<I", (k + 1) * apart if k < count else 0))
        file.truncate((count + 1) * apart)


@pytest.mark.skipif(sys.platform != "linux", reason="Linux tells the most memory since it was asked to forget")
def test_a_long_file_takes_little_memory_to_open(tmp_path):
    def bytes_of(name):
        return 1024 * int(re.search(rf"{name}:\s*(\d+)", Path("/proc/self/status").read_text())[1])

    sparse(tmp_path / "a.tif", 1500, 2**16)
    open_frames(tmp_path / "a.tif").close()  # libraries are there
    Path("/proc/self/clear_refs").write_text("5")
    before = bytes_of("VmRSS")
    with open_frames(tmp_path / "a.tif") as found:
        assert found.shape == (1500, 16, 16)
        assert not found[700].any()
    assert bytes_of("VmHWM") - before < 2**24  # 94 MB lie around its pages


def test_a_page_of_too_many_tags_is_refused(tmp_path):
    sparse(tmp_path / "a.tif", 3, 2**16)
    with (tmp_path / "a.tif").open("r+b") as file:
        file.seek(2 * 2**16)
        file.write(struct.pack("<H", 5000))
    with pytest.raises(RecordingError, match=r"a\.tif: it has a page of 5000 tags; the limit is 4096"):
        open_frames(tmp_path / "a.tif")
