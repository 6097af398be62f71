"""Parts of movies: the frames that a worker reads, and files that it does not see."""

from __future__ import annotations

import os
import pickle

import numpy as np
import pytest
import tifffile

from lommel.recorded.frames import RecordingError, open_frames
from lommel.recorded.movie_parts import parts_of

MOVIE = np.random.default_rng(0).integers(0, 999, (23, 6, 5)).astype(np.uint16)


def read_by_workers(images, size=4):
    """Return the frames that workers read, and the lengths of the parts."""
    parts = [pickle.loads(pickle.dumps(part)) for part, _ in parts_of(images, size)]
    read = [part.read() for part in parts]
    return np.concatenate(read), [len(each) for each in read]


def test_files_are_opened_by_workers(tmp_path):
    tifffile.imwrite(tmp_path / "a.tif", MOVIE, photometric="minisblack")
    with open_frames(tmp_path / "a.tif") as frames:
        stack = frames.as_stack()
        data = [pickle.dumps(part) for part, _ in parts_of(stack, 4)]
    assert len(data[0]) < 1000
    read = np.concatenate([pickle.loads(each).read() for each in data])
    np.testing.assert_array_equal(read, MOVIE)
    assert read.dtype == MOVIE.dtype


def test_files_that_changed_or_are_not_seen_are_named(tmp_path):
    np.save(tmp_path / "a.npy", MOVIE)
    with open_frames(tmp_path / "a.npy") as frames:
        part, _ = next(parts_of(frames.as_stack(), 4))
    data = pickle.dumps(part)
    np.testing.assert_array_equal(pickle.loads(data).read(), MOVIE[:4])
    os.utime(tmp_path / "a.npy", (1.0, 1.0))
    with pytest.raises(RecordingError, match=r"a\.npy has changed since it was opened, or a worker sees another"):
        pickle.loads(data).read()
    (tmp_path / "a.npy").unlink()
    with pytest.raises(RecordingError, match=r"a worker does not see .*a\.npy: choose a folder"):
        pickle.loads(pickle.dumps(pickle.loads(data))).read()  # a scheduler passes it on


@pytest.mark.parametrize(("chunk", "lengths", "most"), [(3, [4] * 5 + [3], 2), (9, [12, 11], 2), (23, [23], 1)])
def test_chunks_of_dask_are_loaded_once_or_twice(chunk, lengths, most):
    dask = pytest.importorskip("dask.array")
    loads = dict.fromkeys(range(-(-23 // chunk)), 0)

    def load(block_info=None):
        first, last = block_info[None]["array-location"][0]
        loads[first // chunk] += 1
        return MOVIE[first:last]

    sizes = dask.core.normalize_chunks((chunk, 6, 5), MOVIE.shape)
    movie = dask.map_blocks(load, chunks=sizes, dtype=MOVIE.dtype, meta=np.empty((0, 0, 0), MOVIE.dtype))
    read = [part.read() for part, _ in parts_of(movie, 4)]
    np.testing.assert_array_equal(np.concatenate(read), MOVIE)
    assert [len(each) for each in read] == lengths
    assert max(loads.values()) <= most
    blocks = [block for _, blocks in parts_of(movie, 4) for block in blocks]
    assert [(block.start, block.stop) for block in blocks] == [(k, min(k + 4, 23)) for k in range(0, 23, 4)]


def test_workers_load_their_chunks_of_zarr_and_dask(tmp_path):
    zarr, dask = pytest.importorskip("zarr"), pytest.importorskip("dask.array")
    array = zarr.open(str(tmp_path / "a.zarr"), mode="w", shape=MOVIE.shape, chunks=(3, 6, 5), dtype=MOVIE.dtype)
    array[...] = MOVIE
    lazy = dask.from_zarr(array)
    for movie in (array, lazy, dask.from_array(MOVIE, chunks=(3, 6, 5))):
        np.testing.assert_array_equal(read_by_workers(movie)[0], MOVIE)
    sent = [pickle.dumps(next(parts_of(movie, 4))[0]) for movie in (array, lazy)]
    (tmp_path / "a.zarr").rename(tmp_path / "b.zarr")
    for data in sent:  # zarr would read 0
        with pytest.raises(RecordingError, match=r"a worker does not see .*a\.zarr"):
            pickle.loads(data).read()


def test_arrays_in_memory_are_sent_with_their_mask():
    hidden = np.ma.masked_array(MOVIE, MOVIE > 900)
    read = [pickle.loads(pickle.dumps(part)).read() for part, _ in parts_of(hidden, 4)]
    np.testing.assert_array_equal(np.ma.concatenate(read).mask, hidden.mask)
    assert [len(each) for each in read] == [4] * 5 + [3]


def test_damaged_chunks_are_named_with_their_images(tmp_path):
    zarr = pytest.importorskip("zarr")
    array = zarr.open(str(tmp_path / "a.zarr"), mode="w", shape=MOVIE.shape, chunks=(4, 6, 5), dtype=MOVIE.dtype)
    array[...] = MOVIE
    (chunk,) = [
        file for file in (tmp_path / "a.zarr").rglob("*") if file.name == "0" and file.parent.parent.name == "1"
    ]
    chunk.write_bytes(chunk.read_bytes()[:4] + b"damaged, damaged")
    parts = [pickle.loads(pickle.dumps(part)) for part, _ in parts_of(array, 4)]
    np.testing.assert_array_equal(parts[0].read(), MOVIE[:4])
    with pytest.raises(RecordingError, match=r"images 4 to 7 of .*a\.zarr.*: "):
        parts[1].read()
