"""Restored stacks that are written chunk by chunk: what is taken up again, and what of the user's is left."""

from __future__ import annotations

import asyncio
import functools
import pickle
import threading
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from contextlib import nullcontext

import dask.array
import numpy as np
import pytest
import zarr

import lommel as lm
from lommel.base.executors import ExecutorError, Workers
from lommel.deconvolve.likelihood import PoissonLikelihood
from lommel.microscopy import chunks as restored_chunks
from lommel.microscopy import preparation
from lommel.microscopy.depth_model import DepthModel
from objectives import OIL_60X
from restored_stacks import deconvolved

SHAPE = (4, 16, 48)
ONE, OTHER = (np.random.default_rng(k).poisson(30.0 + 50.0 * k, (2, *SHAPE)).astype(np.uint16) for k in (0, 1))


GIVEN = {
    "pixel": 6e-6, "step": 0.5e-6, "wavelength": 520e-9, "depth": 3e-6, "tile": 16, "background": 0.0,
    "noise": lm.Noise(white=0.5, read=1.0), "direction": "up", "slabs": 1, "margin": (1, 2), "diagnosis": False,
    "window": (3, 5), "method": lm.imaging.RichardsonLucy(steps=2, target=0.0),
}  # fmt: skip


def restored(stack, out=None, *, chunks=None, at_first=lambda: None, lens=OIL_60X, **options):
    """Restore a stack in three chunks a channel, interrupted in that of the number; return which were computed."""
    counted = []

    def told(share, words):
        if "chunk" in words and "step 1," in words:
            if not counted:
                at_first()
            counted.append(words)
            if len(counted) == chunks:
                raise KeyboardInterrupt

    made = deconvolved(stack, lens, out=out, progress=told, **(GIVEN | options))
    return np.asarray(made).reshape(-1, *SHAPE), counted


def cut(stack, out, chunks, **options):
    with pytest.raises(KeyboardInterrupt):
        restored(stack, out, chunks=chunks, **options)


def test_chunks_of_the_same_stack_alone_are_taken_up(tmp_path):
    there = tmp_path / "a.zarr"
    cut(ONE[0], there, 3)
    found, done = restored(ONE[0], there)
    assert len(done) == 2  # the central one again, which all follow, and the one that lacked
    np.testing.assert_array_equal(found, restored(ONE[0])[0])


@pytest.mark.parametrize("what", ["values", "later channel", "time", "depth", "sample", "planes", "noise map"])
def test_other_input_is_never_mixed(tmp_path, what):
    there, first, then, options = tmp_path / "a.zarr", ONE[0], ONE[0], {}
    cuts = 3
    if what == "values":
        then = ONE[0].copy()
        then[2, 3, 4] += 1  # what changes a chunk, and all that see it
    elif what == "later channel":
        first, then, cuts = ONE, np.stack([ONE[0], OTHER[0]]), 6
    elif what == "time":
        for name, values in (("first", ONE[0]), ("then", OTHER[0])):
            zarr.create_array(str(tmp_path / name), data=values)
        first, then = (zarr.open(str(tmp_path / name)) for name in ("first", "then"))
    elif what == "depth":
        options = {"depth": 3.1e-6}
    elif what == "sample":
        given = {name: getattr(OIL_60X, name) for name in OIL_60X.__dataclass_fields__}
        options = {"lens": lm.Objective(**(given | {"sample": 1.4}))}
    elif what == "planes":
        then = ONE[0][:, :, ::-1]
    else:
        options = {"noise": lm.Noise(white=np.where(np.eye(16, 48), 0.6, 0.5), read=1.0)}
    cut(first, there, cuts)
    found, done = restored(then, there, **options)
    assert len(done) == (4 if what == "later channel" else 3)  # two of the first channel are the same
    np.testing.assert_array_equal(found, restored(then, **options)[0])


def test_a_chunk_that_is_missing_is_computed_again(tmp_path):
    there = tmp_path / "a.zarr"
    cut(ONE[0], there, 3)
    (chunk,) = (tmp_path / ".a.zarr.unfinished" / "new" / "0").glob("0/0/0/*")
    chunk.unlink()
    found, done = restored(ONE[0], there)
    assert len(done) == 3
    np.testing.assert_array_equal(found, restored(ONE[0])[0])


@pytest.mark.parametrize("name", ["0/.zarray", "0/0/0/0/0"])
def test_what_zarr_cannot_read_is_named(tmp_path, name):
    there, room = tmp_path / "a.zarr", tmp_path / ".a.zarr.unfinished"
    cut(ONE[0], there, 3)
    (room / "new" / name).write_bytes(b"{}")
    with pytest.raises(ValueError, match=r"\.a\.zarr\.unfinished is damaged \(.*\); remove it"):
        restored(ONE[0], there)


def test_zarr_has_chunks_in_a_single_thread(tmp_path, monkeypatch):
    """Each of several would keep the memory that it freed."""
    seen, begin = set(), asyncio.to_thread

    async def to_thread(function, *given, **options):
        def call():
            seen.add((begun_by, threading.current_thread().name))
            return function(*given, **options)

        begun_by = threading.current_thread().name
        return await begin(call)

    monkeypatch.setattr("asyncio.to_thread", to_thread)
    restored(ONE[0], tmp_path / "a.zarr")
    of_chunks = {names for names in seen if names[0] != "zarr_io"}  # metadata are read by zarr alone
    assert of_chunks
    assert all(loop == other for loop, other in of_chunks)


@pytest.mark.parametrize("error", [MemoryError(), RuntimeError("can't start new thread")])
def test_memory_that_is_short_is_not_called_damage(tmp_path, error, monkeypatch):
    def short(*_):
        raise error

    cut(ONE[0], tmp_path / "a.zarr", 3)
    monkeypatch.setattr("lommel.microscopy.store._open_group", short)
    with pytest.raises(type(error)) as told:
        restored(ONE[0], tmp_path / "a.zarr")
    assert told.value is error


@pytest.mark.parametrize("kind", ["raw", "other", "folder", "file"])
def test_what_is_no_restored_stack_is_not_replaced(tmp_path, kind):
    there = tmp_path / "a.zarr"
    if kind == "raw":
        zarr.create_array(str(there), data=np.ones(3), zarr_format=2)
    elif kind == "other":
        zarr.create_group(str(there), zarr_format=2).attrs["multiscales"] = []
    elif kind == "folder":
        there.mkdir()
    else:
        there.write_text("mine")
    with pytest.raises(FileExistsError, match="holds no restored stack, and is not replaced"):
        restored(ONE[0], there)
    assert [path.name for path in tmp_path.iterdir()] == ["a.zarr"]


# Light that varies, so that noise can be estimated.
DEEP = np.random.default_rng(2).poisson(np.broadcast_to(np.geomspace(5.0, 500.0, 32), (32, 16, 32))).astype(np.uint16)
COMMON = {"saturation": 60000.0}
DEFAULT = {"noise": None, "diagnosis": True, "direction": "auto", "saturation": None}


def lazy(values, chunks, loads):
    """Return an array of dask that counts how often each chunk is loaded."""

    def load(block_info=None):
        loads[tuple(block_info[None]["chunk-location"])] += 1
        return values[tuple(slice(*ends) for ends in block_info[None]["array-location"])]

    sizes = dask.array.core.normalize_chunks(chunks, values.shape)
    return dask.array.map_blocks(load, chunks=sizes, dtype=values.dtype, meta=np.empty((0,) * values.ndim, np.uint16))


@pytest.mark.parametrize(
    ("stack", "planes", "options"),
    [(DEEP, 1, COMMON), (DEEP, 8, COMMON), (DEEP, 32, COMMON), (DEEP[::4], 4, DEFAULT)],
    ids=["1 plane", "8 planes", "32 planes", "noise estimated"],
)
def test_chunks_are_loaded_once_and_once_more_to_go_on(tmp_path, stack, planes, options):
    there, loads = tmp_path / "a.zarr", Counter()

    def restored_deep(stack, out=None, cut_at=None):
        def told(share, words):
            if cut_at is not None and words.startswith(f"chunk {cut_at} of"):
                raise KeyboardInterrupt

        return deconvolved(stack, OIL_60X, out=out, progress=told, **(GIVEN | options))

    chunked = lazy(stack, (planes, 8, 16), loads)
    with pytest.raises(KeyboardInterrupt):
        restored_deep(chunked, there, cut_at=2)
    assert len(loads) == len(stack) // planes * 4
    assert set(loads.values()) == {1}
    found = np.asarray(restored_deep(chunked, there))[0]
    assert set(loads.values()) == {2}
    np.testing.assert_array_equal(found, restored_deep(stack))
    if options is COMMON:
        np.testing.assert_array_equal(found, restored_deep(chunked))
        assert set(loads.values()) == {3}


def test_given_steps_are_too_few_or_too_many_by_their_discrepancy():
    counts = np.random.default_rng(1).poisson(50.0, (4, 30, 30)).astype(np.float32)
    counted = PoissonLikelihood(counts, lm.Noise(read=0.0))
    severities = []
    for stopped, discrepancy in (("steps", 1.3), ("steps", 0.97), ("steps", 0.85), ("noise", 0.85)):
        finding = restored_chunks._finding(counted, stopped, 400, 5.0, discrepancy, ())
        severities.append(finding and (finding.code, finding.severity))
    assert severities == [("not_settled", "error"), None, ("not_settled", "doubt"), None]


class Pickling(ThreadPoolExecutor):
    """Executor whose tasks and results are pickled, as those of processes are."""

    tasks = 0

    def submit(self, function, *task):
        self.tasks += 1
        data = pickle.dumps((function, task))
        return super().submit(lambda: pickle.loads(pickle.dumps(_called(data))))


def _called(data):
    function, task = pickle.loads(data)
    return function(*task)


@pytest.mark.parametrize("is_lazy", [False, True])
def test_chunks_of_workers_are_those_of_this_process(tmp_path, is_lazy):
    loads = Counter()
    stack = lazy(ONE, (1, 2, 16, 48), loads) if is_lazy else ONE
    with Pickling(2) as client:
        found, _ = restored(stack, tmp_path / "a.zarr", client=client)
    # Of each channel: five of the whole stack, such as noise and PSFs, three chunks, and the blur for idle workers.
    assert client.tasks == 2 * (5 + 3 + Workers.of(client).at_once - 1)
    assert set(loads.values()) <= {1}
    np.testing.assert_array_equal(found, restored(ONE, tmp_path / "b.zarr")[0])
    assert sorted(path.name for path in tmp_path.iterdir()) == ["a.zarr", "b.zarr"]


@pytest.mark.parametrize("offset", [0.0, 20.0])
@pytest.mark.parametrize("kind", ["array", "folder"])
def test_missing_chunks_of_a_recording_are_a_doubt_unless_they_may_be_empty(tmp_path, kind, offset):
    group = zarr.create_group(str(tmp_path / "a.zarr"), zarr_format=3)
    axes = [{"name": name, "type": "space"} for name in "zyx"]
    group.attrs["ome"] = {"multiscales": [{"axes": axes, "datasets": [{"path": "0"}]}]}
    array = group.create_array("0", data=ONE[0], chunks=(2, 16, 16))
    (tmp_path / "a.zarr" / "0" / "c" / "1" / "0" / "2").unlink()
    given = GIVEN | {"noise": lm.Noise(white=0.5, read=1.0, offset=offset)}
    with nullcontext() if kind == "folder" else pytest.warns(UserWarning, match="1 of the 6 chunks"):
        found = deconvolved(array if kind == "array" else tmp_path / "a.zarr", OIL_60X, **given)
    (finding,) = [finding for finding in found.findings if finding.code == "missing_chunks"]
    assert (finding.severity, finding.numbers) == ("doubt" if offset else "note", {"missing": 1, "chunks": 6})
    assert "are missing and count as 0: c/1/0/2; " in finding.text
    assert not [note for note in found.notes if "below the offset" in note or "missing" in note]


def test_workers_need_an_output():
    with Pickling() as client, pytest.raises(ValueError, match="client needs out="):
        restored(ONE, client=client)


@pytest.mark.filterwarnings("ignore::lommel.base.executors.Waiting")  # workers begin anew
def test_workers_and_a_scheduler_that_are_killed_change_no_chunk(tmp_path):
    distributed = pytest.importorskip("distributed")
    psutil = pytest.importorskip("psutil")
    stack = np.random.default_rng(4).poisson(40.0, (4, 64, 64)).astype(np.uint16)
    alone = np.asarray(deconvolved(stack, OIL_60X, out=tmp_path / "alone.zarr", **GIVEN))
    kills = 0
    cluster = distributed.LocalCluster(n_workers=2, threads_per_worker=1, processes=True, dashboard_address=":0")
    with cluster, distributed.Client(cluster) as client:

        def kill(share, words):
            nonlocal kills
            if words in ("chunk 3 of 16", "chunk 8 of 16"):
                client.wait_for_workers(2)  # one that is killed while it starts is not started again
                processes = psutil.Process().children(recursive=True)
                [each for each in processes if "spawn_main" in " ".join(each.cmdline())][-1].kill()
                kills += 1

        made = deconvolved(stack, OIL_60X, out=tmp_path / "a.zarr", client=client, progress=kill, **GIVEN)
        assert kills == 2
        np.testing.assert_array_equal(np.asarray(made), alone)

        def close(share, words):
            if words == "chunk 5 of 16":
                cluster.close()

        with pytest.raises(ExecutorError):
            deconvolved(stack, OIL_60X, out=tmp_path / "b.zarr", client=client, progress=close, **GIVEN)
    again = deconvolved(stack, OIL_60X, out=tmp_path / "b.zarr", **GIVEN)
    np.testing.assert_array_equal(np.asarray(again), alone)


def test_noise_and_hot_pixels_are_of_a_worker(tmp_path, monkeypatch):
    here = threading.get_ident()
    mask = np.arange(48) < 3

    def elsewhere(function):
        @functools.wraps(function)
        def checked(*given, **options):
            assert threading.get_ident() != here
            return function(*given, **options)

        return checked

    counts = lm.Counts.of(ONE[0], noise=GIVEN["noise"], mask=np.broadcast_to(mask, SHAPE[1:]))
    options = {name: value for name, value in GIVEN.items() if name != "noise"}
    alone = deconvolved(counts, OIL_60X, out=tmp_path / "alone.zarr", **options)
    for name in ("contradiction", "hot_pixels", "hot_voxels"):
        monkeypatch.setattr(preparation, name, elsewhere(getattr(preparation, name)))
    monkeypatch.setattr(DepthModel, "psfs", elsewhere(DepthModel.psfs))
    with Pickling(1) as client:
        made = deconvolved(counts, OIL_60X, out=tmp_path / "a.zarr", client=client, **options)
    np.testing.assert_array_equal(np.asarray(made), np.asarray(alone))
    assert made.notes == alone.notes
    assert any("192 voxels (6.2 %) are masked" in note for note in made.notes)
