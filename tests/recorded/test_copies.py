"""Stacks in chunks: each chunk is read once, and planes are then those of the array, wherever the copy is."""

from __future__ import annotations

import errno
import pickle
from collections import Counter
from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import dask.array as da
import numpy as np
import pytest
import tifffile
import xarray
import zarr

from lommel.base.atomic import Unfinished
from lommel.recorded import copies
from lommel.recorded.frames import RecordingError, open_frames

VALUES = np.random.default_rng(0).integers(0, 60000, (2, 3, 9, 20, 26)).astype(np.uint16)  # T, C, Z, Y, X
LARGE = 2.0**20


class Counted:
    """An array of T, C, Z, Y, X in chunks, like Zarr's, which counts how often each chunk is read."""

    def __init__(self, chunks, values=VALUES):
        self.values, self.chunks, self.shape, self.dtype = values, chunks, values.shape, values.dtype
        self.loads, self.largest = Counter(), 0

    def __getitem__(self, index):
        part = self.values[index]
        self.largest = max(self.largest, part.nbytes)
        sides = [range(*one.indices(side)) for one, side in zip(index, self.shape, strict=True)]
        grid = [range(one.start // size, -(-one.stop // size)) for one, size in zip(sides, self.chunks, strict=True)]
        self.loads.update((t, c, z, y, x) for t in grid[0] for c in grid[1] for z in grid[2] for y in grid[3]
                          for x in grid[4])  # fmt: skip
        return part


def copied(source, place, memory=LARGE, **options):
    """Return all planes of the stacks of a source, and how these planes were read: whole, and in parts."""
    with (
        open_frames(source).as_channels(**options) as recording,
        copies.local_stacks(recording, place and Unfinished(place, place.parent, {}), memory) as stacks,
    ):
        whole = np.array([[stack[plane] for plane in range(len(stack))] for stack in stacks])
        for rows, columns in (
            (slice(0, 7), slice(3, 26)),
            (slice(5, 20), slice(0, 1)),
            (slice(12, 13), slice(12, 14)),
        ):
            for stack, expected in zip(stacks, whole, strict=True):
                assert (stack.shape, stack.dtype) == (expected.shape, expected.dtype)
                np.testing.assert_array_equal(stack[2, rows, columns], expected[2, rows, columns])
        return whole


@pytest.mark.parametrize("to_file", [False, True])
@pytest.mark.parametrize("memory", [1.0, 3000.0, LARGE])
@pytest.mark.parametrize("chunks", [(1, 1, 1, 20, 26), (1, 1, 4, 7, 8), (1, 1, 9, 20, 8), (2, 2, 4, 6, 26)])
def test_each_chunk_is_read_once_and_only_those_of_the_time_point(tmp_path, chunks, memory, to_file):
    array = Counted(chunks)
    found = copied(array, tmp_path / "out.zarr" if to_file else None, memory, time=1, axes="TCZYX")
    np.testing.assert_array_equal(found, VALUES[1])
    grid = [-(-side // size) for side, size in zip(VALUES.shape, chunks, strict=True)]
    assert set(array.loads.values()) == {1}
    assert {place[0] for place in array.loads} == {1 // chunks[0]}
    assert len(array.loads) == np.prod(grid[1:])
    chunk = 2 * np.prod([min(size, 1 if axis == 0 else size) for axis, size in enumerate(chunks)])
    assert array.largest <= max(memory, chunk)
    assert not list(tmp_path.iterdir())


def test_channels_that_are_left_out_are_not_read():
    array = Counted((1, 1, 4, 20, 26))
    with open_frames(array).as_channels(time=0, axes="TCZYX") as recording:
        frames = replace(recording, numbers=recording.numbers[1:2])
        with copies.local_stacks(frames, None, LARGE) as (stack,):
            np.testing.assert_array_equal(stack, VALUES[0, 1])
    assert {place[1] for place in array.loads} == {1}


def test_axes_in_another_order_are_read_in_the_order_of_the_stack():
    array = Counted((1, 4, 3, 20, 26), VALUES.transpose(0, 2, 1, 3, 4))
    np.testing.assert_array_equal(copied(array, None, time=1, axes="TZCYX"), VALUES[1])
    assert set(array.loads.values()) == {1}


def ome_zarr(path):
    group = zarr.create_group(str(path), zarr_format=2)
    axes = [{"name": name, "type": "space", "unit": "micrometer"} for name in "zyx"]
    scale = [{"type": "scale", "scale": [0.2, 0.1, 0.1]}]
    group.attrs["multiscales"] = [{"axes": axes, "datasets": [{"path": "0", "coordinateTransformations": scale}]}]
    group.create_array("0", data=VALUES[0, 0], chunks=(4, 16, 16))
    return path


def raw_zarr(path):
    zarr.create_array(str(path), data=VALUES[0, 0], chunks=(4, 16, 16), shards=(8, 32, 32))
    return zarr.open(str(path))


def tiff(path):
    tifffile.imwrite(path, VALUES[0, 0], compression="zlib", metadata={"axes": "ZYX"})
    return path


SOURCES = {
    "dask": lambda path: da.from_array(VALUES[0, 0], chunks=((2, 0, 7), 9, (1, 25))),
    "xarray of dask": lambda path: xarray.DataArray(da.from_array(VALUES[0, 0], chunks=(5, 9, 20)), dims=list("zyx")),
    "Zarr": raw_zarr,
    "OME-Zarr": ome_zarr,
    "compressed TIFF": tiff,
    "big-endian Zarr": lambda path: zarr.create_array(str(path), data=VALUES[0, 0].astype(">u2"), chunks=(4, 16, 16)),
}


@pytest.mark.parametrize("to_file", [False, True])
@pytest.mark.parametrize("source", SOURCES)
def test_planes_are_those_of_every_kind_of_array(tmp_path, source, to_file):
    given, place = SOURCES[source](tmp_path / "in"), tmp_path / "out.zarr" if to_file else None
    found = copied(given, place)
    assert found.dtype == np.dtype("=u2")
    np.testing.assert_array_equal(found, VALUES[0, :1])


def test_an_array_in_memory_is_not_copied_beyond_the_limit():
    values = VALUES[0, 0]
    limit = values.nbytes - 1
    with open_frames(values).as_channels() as recording, copies.local_stacks(recording, None, limit) as (stack,):
        assert np.shares_memory(stack[3], values)


@pytest.mark.parametrize("array", [VALUES, Counted((1, 1, 4, 20, 26))], ids=["in memory", "in chunks"])
def test_workers_read_a_file_that_they_see(tmp_path, array):
    unfinished = Unfinished(tmp_path / "out.zarr", tmp_path / "unfinished", {})
    unfinished.scratch.mkdir()
    with (
        open_frames(array).as_channels(time=0, axes="TCZYX") as recording,
        copies.local_stacks(recording, unfinished, LARGE, shared=True) as stacks,
    ):
        pickled = pickle.dumps(stacks[1])
        assert len(pickled) < VALUES[0, 1].nbytes
        np.testing.assert_array_equal(pickle.loads(pickled), VALUES[0, 1])
    with pytest.raises(RecordingError, match=f"a worker does not see {tmp_path}: choose a folder"):
        pickle.loads(pickled)


def test_a_full_disk_names_the_output(tmp_path, monkeypatch):
    class Full:
        tell = close = lambda self: 0

        def write(self, data):
            raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(Path, "open", lambda *_: Full())
    with pytest.raises(OSError, match=r"No space left on device: '.*out\.zarr'"):
        copied(da.from_array(VALUES[0, 0]), tmp_path / "out.zarr")


def test_blocks_join_chunks_that_follow_one_another_up_to_the_limit():
    axes = [[slice(k, k + 2) for k in range(0, 8, 2)], [slice(0, 3), slice(3, 6), slice(6, 7)]]
    planes, rows = copies._joined([list(axis) for axis in axes], 28)
    assert (planes, rows) == ([slice(0, 4), slice(4, 8)], [slice(0, 7)])
    assert copies._joined([list(axis) for axis in axes], 13) == [axes[0], [slice(0, 6), slice(6, 7)]]
    assert copies._joined([list(axis) for axis in axes], 1) == axes
    assert all(one.stop == two.start for one, two in pairwise(planes))


@pytest.mark.parametrize("opened", [zarr.open_array, da.from_zarr])
def test_a_damaged_chunk_is_named(tmp_path, opened):
    place = str(tmp_path / "stack.zarr")
    zarr.create_array(place, data=VALUES[0, 0], chunks=(1, 10, 26))
    (tmp_path / "stack.zarr" / "c" / "2" / "1" / "0").write_bytes(bytes(20))
    source = opened(place)
    with (
        open_frames(source).as_channels() as recording,
        pytest.raises(RecordingError, match=r"^\[2:3, 10:20, 0:26\] of .*(stack|from)-?.*: .*invalid"),
        copies.local_stacks(recording, None, 1.0),
    ):
        pass
