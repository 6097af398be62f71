"""One recording and one movie, read by 16 threads at once: each gets the planes that it asked for."""

from __future__ import annotations

import logging
import sys
import threading
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest
import tifffile
import zarr
from PIL import Image

from lommel.base import reading
from lommel.io import fits_images
from lommel.recorded.frames import open_frames
from lommel.recorded.stack_files import save_stack

STACK = np.random.default_rng(0).integers(0, 60000, (24, 64, 64)).astype(np.uint16)


def tiff(path, **options):
    tifffile.imwrite(path, STACK, ome=True, metadata={"axes": "ZYX"}, photometric="minisblack", **options)


def frames(path, **options):
    with tifffile.TiffWriter(path) as file:
        for frame in STACK:
            file.write(frame, contiguous=False, metadata=None, **options)


def several(path, **options):
    """Half of the planes in another file."""
    tifffile.imwrite(path, STACK, ome=True, metadata={"axes": "ZYX"}, photometric="minisblack")
    text = tifffile.tiffcomment(path)
    parts = "".join(
        f'<TiffData FirstZ="{12 * k}" IFD="0" PlaneCount="12"><UUID FileName="{name}">urn:uuid:{k}</UUID></TiffData>'
        for k, name in enumerate((path.name, "other.tif"))
    )
    start, end = text.index("<TiffData"), text.index("</Pixels>")
    whole = (text[:start] + parts + text[end:]).replace("<OME ", '<OME UUID="urn:uuid:0" ', 1)
    root = whole.index("UUID=", whole.index("UUID=") + 1)
    if root < whole.index("<Image"):  # tifffile wrote its own
        whole = whole[:root] + whole[whole.index('"', root + 6) + 1 :]
    tifffile.imwrite(path, STACK[:12], photometric="minisblack", description=whole, metadata=None, **options)
    tifffile.imwrite(path.with_name("other.tif"), STACK[12:], photometric="minisblack", metadata=None, **options)


def folder(path):
    with open_frames(STACK).as_channels() as first:
        save_stack(path, STACK[np.newaxis].astype(np.float32), first)


def chunked(path, **options):
    group = zarr.create_group(str(path), zarr_format=3)
    scales = [{"axes": [{"name": letter} for letter in "zyx"], "datasets": [{"path": "0"}]}]
    group.attrs["ome"] = {"version": "0.5", "multiscales": scales}
    group.create_array("0", data=STACK, **{"chunks": (4, 32, 32)} | options)


def pillow(path):
    """LZW, which tifffile alone cannot unpack."""
    first, *others = map(Image.fromarray, STACK)
    first.save(path, save_all=True, append_images=others, compression="tiff_lzw")


RECORDINGS = {
    "plain.ome.tif": tiff,
    "deflated.ome.tif": lambda path: tiff(path, compression="zlib"),
    "tiles.ome.tif": lambda path: tiff(path, compression="zlib", tile=(32, 32)),
    "several.ome.tif": several,
    "chunks.ome.zarr": folder,
}
MOVIES = {
    "plain.tif": frames,
    "deflated.tif": lambda path: frames(path, compression="zlib"),
    "mapped.tif": lambda path: tifffile.imwrite(path, STACK, photometric="minisblack"),
    "imagej.tif": lambda path: tifffile.imwrite(path, STACK, imagej=True, metadata={"axes": "TYX"}),
    "lzw.tif": pillow,
    "zstd.zarr": chunked,
    "blosc.zarr": lambda path: chunked(path, compressors=zarr.codecs.BloscCodec()),
    "plain.zarr": lambda path: chunked(path, compressors=None),
    "shards.zarr": lambda path: chunked(path, shards=(8, 64, 64)),
    "a.npy": lambda path: np.save(path, STACK),
    "a.fits": lambda path: path.write_bytes(fits_images.write([(STACK.astype(np.float32), {})])),
}
COSTLY = {name for name in MOVIES if name.endswith("zarr") or name == "lzw.tif"}


@pytest.fixture
def often():
    """Threads that change places as often as may be."""
    before = sys.getswitchinterval()
    sys.setswitchinterval(1e-6)
    yield
    sys.setswitchinterval(before)


def wrong(read, each=40):
    """Return how many of many reads by 16 threads are not what is stored."""
    start = threading.Barrier(16)

    def some(k):
        start.wait()
        return sum(not np.array_equal(read(j % 24), STACK[j % 24]) for j in range(7 * k, 7 * k + each))

    with ThreadPoolExecutor(16) as pool:
        return sum(pool.map(some, range(16)))


@pytest.mark.parametrize("name", RECORDINGS)
def test_a_recording_that_16_threads_read_has_no_wrong_plane(name, tmp_path, often):
    RECORDINGS[name](tmp_path / name)
    with open_frames(tmp_path / name).as_channels() as found:
        stack = found.one_of("C", 0)
        assert wrong(lambda k: stack[k]) == 0


@pytest.mark.parametrize("compression", [None, "zlib"])
def test_nothing_of_a_library_is_told_of_an_image_in_several_files(compression, tmp_path, capfd, caplog):
    several(tmp_path / "a.ome.tif", compression=compression)
    with open_frames(tmp_path / "a.ome.tif").as_channels() as found:
        np.testing.assert_array_equal(found[0], STACK)
        held = found.one_of("C", 0)
    np.testing.assert_array_equal(held[20], STACK[20])  # of files that are closed
    with open_frames(tmp_path / "a.ome.tif").as_stack() as movie:
        np.testing.assert_array_equal(movie[0:24], STACK)
    assert capfd.readouterr() == ("", "")
    assert not caplog.records


@pytest.mark.parametrize("name", MOVIES)
def test_a_movie_that_16_threads_read_has_no_wrong_frame(name, tmp_path, often):
    MOVIES[name](tmp_path / name)
    with open_frames(tmp_path / name).as_stack() as found:
        assert wrong(lambda k: found[k : k + 1][0], 5 if name in COSTLY else 40) == 0


def test_what_is_wrong_with_a_file_is_not_told_of_another_in_another_thread():
    log = logging.getLogger("tifffile")
    with ThreadPoolExecutor(1) as pool, reading.quietly() as errors:
        pool.submit(log.error, "of another file").result()
        log.error("of this file")
    assert errors == ["of this file"]


def test_a_part_of_a_stack_is_read_as_that_of_an_array(tmp_path):
    tiff(tmp_path / "a.ome.tif")
    with open_frames(tmp_path / "a.ome.tif").as_channels() as found:
        stack = found.one_of("C", 0)
        for at in (slice(2, 9, 3), (slice(None, None, -5), slice(3, 7), 2), (-1, slice(0, 5)), np.int64(3)):
            np.testing.assert_array_equal(stack[at], STACK[at])
        assert sum(1 for _ in stack) == 24
        for beyond in (24, -25):
            with pytest.raises(IndexError, match="out of bounds for axis 0 with size 24"):
                stack[beyond]
