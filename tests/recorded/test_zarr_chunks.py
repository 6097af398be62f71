"""Chunks of OME-Zarr that are damaged or missing: told with the name of the folder."""

from __future__ import annotations

import asyncio
import os
import struct

import dask.array
import numcodecs
import numpy as np
import pytest
import zarr

import lommel as lm
from lommel.localize.movie_fits import _open_images
from lommel.recorded.frames import RecordingError, open_frames

STACK = np.random.default_rng(0).integers(1, 60000, (4, 16, 20)).astype(np.uint16)
PACKERS = {
    "none": None, "zstd": zarr.codecs.ZstdCodec(), "blosc": zarr.codecs.BloscCodec(), "gzip": zarr.codecs.GzipCodec(),
}  # fmt: skip


def made(path, version=3, values=STACK, **options):
    group = zarr.create_group(str(path), zarr_format=version)
    axes = [{"name": name, "type": "space", "unit": "micrometer"} for name in "zyx"]
    scale = [{"type": "scale", "scale": [0.2, 0.1, 0.1]}]
    scales = [{"axes": axes, "datasets": [{"path": "0", "coordinateTransformations": scale}]}]
    group.attrs.update({"ome": {"multiscales": scales}} if version == 3 else {"multiscales": scales})
    group.create_array("0", data=values, **{"chunks": (2, 16, 16)} | options)
    return path


def chunks(path):
    found = [one for one in (path / "0").rglob("*") if one.is_file() and one.name[0] in "0123456789c"]
    return sorted(found)


def refused(path, message):
    with pytest.raises(RecordingError, match=message) as caught:
        open_frames(path).as_channels()[0]
    assert str(path) in str(caught.value)


@pytest.mark.parametrize("packer", PACKERS)
@pytest.mark.parametrize("shards", [None, (4, 16, 32)])
def test_chunks_of_every_kind_are_read(packer, shards, tmp_path):
    path = made(tmp_path / "a.zarr", compressors=PACKERS[packer], shards=shards)
    found = open_frames(path).as_channels()
    np.testing.assert_array_equal(found[0], STACK)
    assert len(found.notes) == 1


@pytest.mark.parametrize("packer", [numcodecs.Zstd(), numcodecs.Blosc(), numcodecs.GZip(), numcodecs.Zlib(),
                                    numcodecs.LZ4()], ids=str)  # fmt: skip
def test_chunks_of_version_two_are_read(packer, tmp_path):
    path = made(tmp_path / "a.zarr", 2, compressors=packer)
    np.testing.assert_array_equal(open_frames(path).as_channels()[0], STACK)


def test_chunks_that_are_missing_are_counted(tmp_path):
    path = made(tmp_path / "a.zarr")
    for chunk in chunks(path)[:3]:
        chunk.unlink()
    found = open_frames(path).as_channels()
    assert found.notes[0].startswith(
        "3 of the 4 chunks of the folder are missing and count as 0: c/0/0/0, c/0/0/1, c/1/0/0; "
    )
    assert not found[0][:2].any()


@pytest.mark.parametrize("form", ["array", "counts", "from_zarr", "from_array"])
def test_chunks_that_are_missing_are_told(form, tmp_path):
    path = made(tmp_path / "a.zarr", 2, shards=None)
    chunks(path)[1].unlink()
    images = zarr.open(str(path))["0"]
    if form == "from_zarr":
        images = dask.array.from_zarr(str(path), "0")
    elif form == "from_array":
        images = dask.array.from_array(images).astype(float)
    if form == "counts":
        with pytest.warns(UserWarning, match="1 of the 4 chunks of the folder are missing and count as 0"):
            lm.Counts.of(images, noise=lm.Noise(read=1.0))
    else:
        with pytest.warns(UserWarning, match="movie: 1 of the 4 chunks"), _open_images(images) as (shape, *_):
            assert shape == STACK.shape
    for chunk in chunks(path):
        chunk.unlink()
    with pytest.raises(ValueError, match=r"array: it lacks all of its 4 chunks: copy the whole folder"):
        lm.Counts.of(zarr.open(str(path))["0"], noise=lm.Noise(read=1.0))


@pytest.mark.parametrize("packer", PACKERS)
def test_a_chunk_that_is_cut_names_the_folder(packer, tmp_path):
    path = made(tmp_path / "a.zarr", compressors=PACKERS[packer])
    for share in (0.0, 0.1, 0.5, 0.9):
        for chunk in chunks(path):
            chunk.write_bytes(chunk.read_bytes()[: int(share * chunk.stat().st_size)])
        refused(path, r"a\.zarr")


@pytest.mark.parametrize("packer", PACKERS)
def test_a_chunk_of_an_array_that_is_cut_is_named_and_ends_the_reading(packer, tmp_path):
    """The loop of zarr would go on with the other chunks, which it tells at the end of the process."""
    values = np.random.default_rng(1).integers(0, 99, (4, 128, 128)).astype(np.uint16)
    array = zarr.create_array(str(tmp_path / "a.zarr"), data=values, chunks=(1, 16, 16), compressors=PACKERS[packer])
    chunk = tmp_path / "a.zarr" / "c" / "0" / "0" / "1"
    chunk.write_bytes(chunk.read_bytes()[:20])
    with pytest.raises(RecordingError, match=r"\[0\] of <Array file:.*a\.zarr"):
        open_frames(array)[...]
    assert not asyncio.all_tasks(zarr.core.sync.loop[0])


def test_pipes_are_not_read(tmp_path):
    for name in ("0/zarr.json", "0/c/0/0/0"):
        path = made(tmp_path / f"{len(list(tmp_path.iterdir()))}.zarr", compressors=None)
        (path / name).unlink()
        os.mkfifo(path / name)
        with pytest.raises((OSError, RecordingError), match="is no regular file"):
            open_frames(path)


@pytest.mark.parametrize("version", [2, 3])
def test_a_folder_without_any_chunk_is_refused(version, tmp_path):
    path = made(tmp_path / "a.zarr", version)
    for chunk in chunks(path):
        chunk.unlink()
    refused(path, "it lacks all of its 4 chunks: copy the whole folder")


@pytest.mark.parametrize("version", [2, 3])
@pytest.mark.parametrize("stated", [10**7, None], ids=["too long", "no header"])
def test_a_chunk_of_blosc_that_ends_before_it_says_is_refused(version, stated, tmp_path):
    packer = numcodecs.Blosc() if version == 2 else zarr.codecs.BloscCodec()
    path = made(tmp_path / "a.zarr", version, compressors=packer)
    data = bytearray(chunks(path)[0].read_bytes())
    if stated is not None:
        struct.pack_into("<I", data, 12, stated)  # of which Blosc would read all
    chunks(path)[0].write_bytes(data if stated is not None else data[:12])
    refused(path, "its chunk .*0.0.0 is truncated: its header states more bytes")
