"""Chunks of OME-Zarr that are damaged, missing or made to harm: told with the name of the folder."""

from __future__ import annotations

import gzip
import os
import struct
import tracemalloc

import numcodecs
import numpy as np
import pytest
import zarr

from lommel.io import zarr_folders
from lommel.recorded.frames import RecordingError, open_frames

STACK = np.random.default_rng(0).integers(1, 60000, (4, 16, 20)).astype(np.uint16)
PACKERS = {
    "none": None, "zstd": zarr.codecs.ZstdCodec(), "blosc": zarr.codecs.BloscCodec(), "gzip": zarr.codecs.GzipCodec(),
}  # fmt: skip
BOMB = bytes(2**23)


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


def test_compressions_whose_size_is_not_known_are_refused(tmp_path):
    refused(made(tmp_path / "a.zarr", 2, compressors=numcodecs.BZ2()), "compressed by bz2; save it with one of blosc")


def test_chunks_that_are_missing_are_counted(tmp_path):
    path = made(tmp_path / "a.zarr")
    for chunk in chunks(path)[:3]:
        chunk.unlink()
    found = open_frames(path).as_channels()
    assert found.notes[0].startswith("3 of the 4 chunks of the folder are missing and count as 0: ")
    assert not found[0][:2].any()


@pytest.mark.parametrize("packer", PACKERS)
def test_a_chunk_that_is_cut_names_the_folder(packer, tmp_path):
    path = made(tmp_path / "a.zarr", compressors=PACKERS[packer])
    for share in (0.0, 0.1, 0.5, 0.9):
        for chunk in chunks(path):
            chunk.write_bytes(chunk.read_bytes()[: int(share * chunk.stat().st_size)])
        refused(path, r"a\.zarr")


def frames_of_zstd(data):
    """The frame of a stream, which does not state its size."""
    blocks = [data[k : k + 2**17] for k in range(0, len(data), 2**17)]
    body = b"".join(
        struct.pack("<I", (len(each) << 3) | 2 | (k == len(blocks) - 1))[:3] + each[:1]
        for k, each in enumerate(blocks)
    )
    return b"\x28\xb5\x2f\xfd\x00\x58" + body


@pytest.mark.parametrize(
    ("packer", "bomb"),
    [("zstd", numcodecs.Zstd().encode(BOMB)), ("zstd", frames_of_zstd(BOMB)),
     ("blosc", numcodecs.Blosc().encode(BOMB)), ("gzip", gzip.compress(BOMB))],
    ids=["zstd", "zstd stream", "blosc", "gzip"],
)  # fmt: skip
def test_a_chunk_that_unpacks_to_more_than_it_should_is_refused(packer, bomb, tmp_path):
    path = made(tmp_path / "a.zarr", compressors=PACKERS[packer])
    chunks(path)[0].write_bytes(bytes(bomb))
    found = open_frames(path).as_channels()
    tracemalloc.start()
    try:
        with pytest.raises(RecordingError, match="unpacks to more than its 1024 bytes"):
            found[0, 0]
        assert tracemalloc.get_traced_memory()[1] < 5e6
    finally:
        tracemalloc.stop()


def test_a_stream_of_zstd_unpacks_to_what_its_blocks_hold():
    part = bytes(range(256)) * 2000
    assert zarr_folders._decompressed_size("zstd", bytes(numcodecs.Zstd().encode(part)), 10**6) == len(part)
    plain = frames_of_zstd(BOMB)
    assert zarr_folders._decompressed_size("zstd", plain, 10**6) == len(BOMB)
    assert zarr_folders._decompressed_size("zstd", plain[:-2], 10**6) >= 0


def test_a_chunk_in_a_shard_that_unpacks_to_more_is_refused(tmp_path):
    path = made(tmp_path / "a.zarr", compressors=PACKERS["gzip"], shards=(4, 16, 32))
    (shard,) = chunks(path)
    data, bomb = shard.read_bytes(), gzip.compress(BOMB)
    index = struct.pack("<QQ", 0, len(bomb)) + data[-68 + 16 : -4]
    shard.write_bytes(bomb + data[len(bomb) : -68] + index + data[-4:])
    refused(path, "unpacks to more than its 1024 bytes")


def test_links_and_pipes_are_not_followed(tmp_path):
    secret = tmp_path / "secret"
    secret.write_bytes(bytes(1024))
    for change, message in (
        (lambda one: one.symlink_to(secret), "is a link, which is not followed"),
        (os.mkfifo, "is no regular file"),
    ):
        path = made(tmp_path / f"{len(list(tmp_path.iterdir()))}.zarr", compressors=None)
        chunk = chunks(path)[0]
        chunk.unlink()
        change(chunk)
        refused(path, message)
        path = made(tmp_path / f"{len(list(tmp_path.iterdir()))}.zarr", compressors=None)
        (path / "0" / "zarr.json").unlink()
        change(path / "0" / "zarr.json")
        refused(path, message)
        path = made(tmp_path / f"{len(list(tmp_path.iterdir()))}.zarr", compressors=None)
        found = open_frames(path).as_channels()  # what is changed after it was opened
        chunk = chunks(path)[0]
        chunk.unlink()
        change(chunk)
        with pytest.raises(RecordingError, match=message):
            found[0, 0]


def test_an_array_outside_of_the_folder_is_not_read(tmp_path):
    made(tmp_path / "b.zarr", 2)
    path = made(tmp_path / "a.zarr", 2)
    text = (path / ".zattrs").read_text().replace('"path": "0"', '"path": "../b.zarr/0"')
    (path / ".zattrs").write_text(text)
    refused(path, "leads out of the folder")


@pytest.mark.parametrize("version", [2, 3])
def test_sizes_far_beyond_the_files_are_refused(version, tmp_path):
    path = made(tmp_path / "a.zarr", version)
    group = zarr.open_group(str(path))
    options = {"dtype": "u2", "overwrite": True}
    group.create_array("0", shape=(10**5, 10**5, 10**5), chunks=(64, 256, 256), **options)
    refused(path, "100000 x 100000 pixels; the limit is")
    array = group.create_array("0", shape=(4096, 512, 512), chunks=(4096, 512, 512), **options)
    with pytest.raises(RecordingError, match="it lacks all of its 1 chunks: copy the whole folder"):
        open_frames(path).as_channels()
    key = array.metadata.encode_chunk_key((0, 0, 0))
    (path / "0" / key).parent.mkdir(parents=True, exist_ok=True)
    (path / "0" / key).write_bytes(bytes(1000))
    refused(path, "bytes of memory; the limit for a file of 1000 bytes")


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
