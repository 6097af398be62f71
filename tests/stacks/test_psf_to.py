"""Stacks in stores: the same bits wherever they are computed, resumed after every way to end, never mixed up."""

from __future__ import annotations

import multiprocessing
import os
import shutil
import subprocess
import sys
import textwrap
from concurrent.futures import Executor, Future, ProcessPoolExecutor, ThreadPoolExecutor
from pathlib import Path
from typing import cast

import numpy as np
import pytest

import lommel as lm
from lommel import stacks
from lommel.base import executors
from lommel.io.psf_files import FileError
from lommel.stacks import PSFStack

pytest.importorskip("zarr")

LENS = lm.Lens(focal_length=50e-3, f_number=1.8, focus_distance=2.0, wavelength=550e-9)
DEPTHS = np.linspace(1.9, 2.1, 50)
SIDE, PIXEL = 9, 3e-6
CHUNK = 8  # 50 in even chunks of 8: seven of them, the last of 2


def run(path: Path, **options) -> PSFStack:
    return lm.psf_to(path, LENS.pupil(DEPTHS), SIDE, PIXEL, **({"chunk": CHUNK} | options))


def contents(stack: PSFStack) -> tuple[bytes, ...]:
    made = stack[:]
    return made.values.tobytes(), stack.error_bound.tobytes(), made.scale.tobytes()


@pytest.fixture(scope="module")
def known(tmp_path_factory) -> tuple[bytes, ...]:
    """What one thread computes without a break."""
    return contents(run(tmp_path_factory.mktemp("known") / "a.zarr", threads=1))


def test_a_chunk_holds_what_psf_answers_for_its_pupils(tmp_path, known):
    stack = run(tmp_path / "a.zarr")
    pupil = LENS.pupil(DEPTHS)
    assert stack.done == (7, 7)
    assert contents(stack) == known
    for first in range(0, 50, CHUNK):
        part = slice(first, min(first + CHUNK, 50))
        asked, read = lm.psf(pupil[part], SIDE, PIXEL), stack[part]
        np.testing.assert_array_equal(read.values, asked.values)
        np.testing.assert_array_equal(read.scale, asked.scale)
        assert (read.pupil, read.grid, read.method) == (asked.pupil, asked.grid, asked.method)
        assert (read.error_bound, read.normalize, read.unit) == (asked.error_bound, "energy", "m")


def test_what_a_store_holds_is_within_its_bound_of_quadrature(tmp_path):
    stack = run(tmp_path / "a.zarr", normalize="peak", integrate=False)[::7]
    exact = lm.psf(stack.pupil, SIDE, PIXEL, method="hankel", normalize="peak", integrate=False, dtype="float64")
    assert np.abs(stack.values - exact.values).max() <= stack.error_bound <= 1e-6


def test_other_chunks_make_other_values_within_the_bounds_of_both(tmp_path, known):
    one, other = run(tmp_path / "a.zarr")[:], run(tmp_path / "b.zarr", chunk=50)[:]
    peak = one.values.max(axis=(1, 2), keepdims=True)
    assert np.max(np.abs(one.values - other.values) / peak) <= one.error_bound + other.error_bound


def test_a_transform_gives_the_same_bits_however_many_threads_there_are(tmp_path):
    vanes = lm.Pupil(lm.Wavefront([30.0, 5.0, 1.0]), spider=lm.Spider(0.05, [0.0, 1.0]))
    made = [
        lm.psf_to(tmp_path / f"{n}.zarr", vanes[:n], 512, 0.4, dtype="float64", chunk=1, threads=2)[0].values
        for n in (1, 3)
    ]
    np.testing.assert_array_equal(*made)
    np.testing.assert_array_equal(made[0], lm.psf(vanes[:1], 512, 0.4, dtype="float64", threads=1).values[0])


@pytest.mark.parametrize("pool", ["threads", "processes"])
def test_a_pool_computes_the_same_bits(pool, tmp_path, known):
    if pool == "threads":
        executor = ThreadPoolExecutor(3)
    else:
        executor = ProcessPoolExecutor(1, mp_context=multiprocessing.get_context("spawn"))
    with executor:
        assert contents(run(tmp_path / "a.zarr", client=executor)) == known


def test_few_chunks_are_under_way_at_any_time(tmp_path, monkeypatch):
    class Counted(ThreadPoolExecutor):
        under_way = most = 0

        def submit(self, *args, **kwargs):
            self.under_way += 1
            self.most = max(self.most, self.under_way)
            return super().submit(*args, **kwargs)

    def count(*_: int) -> None:
        executor.under_way -= 1

    monkeypatch.setattr(stacks.os, "cpu_count", lambda: 2)
    with Counted(2) as executor:
        run(tmp_path / "a.zarr", chunk=1, client=executor, progress=count)
    assert executor.under_way == 0
    assert executor.most <= 5


class Cluster:
    """A client without workers until it is asked for them; `fate` is that of the third chunk."""

    def __init__(self, fate: str) -> None:
        self.fate, self.started, self.waiting = fate, 0, []

    def get_executor(self) -> Executor:
        return cast(Executor, self)

    def submit(self, function, *args) -> Future:
        future, self.started = Future(), self.started + 1
        if self.started != 3:
            future.set_result(function(*args))
        elif self.fate == "cancelled":
            future.cancel()
            future.set_running_or_notify_cancel()
        else:
            self.waiting.append(lambda: future.set_result(function(*args)))
        return future

    def nthreads(self) -> dict[str, int]:
        if self.started >= 3:
            self.waiting.pop()()
            if self.fate == "silent":
                raise OSError("no route")
        return {}


def test_chunks_that_a_cluster_cancels_are_computed_by_the_next_call(tmp_path, known):
    with pytest.raises(RuntimeError, match=r"the client cancelled tasks, .* repeat the call, which keeps"):
        run(tmp_path / "a.zarr", client=Cluster("cancelled"))
    assert lm.open_stack(tmp_path / "a.zarr").done[0] >= 2
    assert contents(run(tmp_path / "a.zarr")) == known


@pytest.mark.parametrize("fate", ["late", "silent"])
def test_a_cluster_without_workers_is_waited_for_with_a_warning(fate, tmp_path, known, monkeypatch):
    monkeypatch.setattr(executors, "_PATIENCE", 0.01)
    with pytest.warns(RuntimeWarning, match="no worker is connected to the cluster") as caught:
        stack = run(tmp_path / "a.zarr", client=Cluster(fate))
    assert contents(stack) == known
    assert [Path(warning.filename).name for warning in caught] == ["test_psf_to.py"]


def test_the_end_of_a_real_scheduler_is_told(tmp_path, known):
    distributed = pytest.importorskip("distributed")
    cluster = distributed.LocalCluster(n_workers=1, threads_per_worker=1, processes=False, dashboard_address=":0")
    cancelled = pytest.raises(RuntimeError, match="the client cancelled tasks")
    with cluster, distributed.Client(cluster) as client, cancelled:
        run(tmp_path / "a.zarr", client=client, progress=lambda *_: cluster.close())
    assert contents(run(tmp_path / "a.zarr")) == known


def test_an_error_leaves_what_was_computed_and_the_rest_is_computed_later(tmp_path, known):
    path, calls = tmp_path / "a.zarr", []

    def fail(done: int, total: int) -> None:
        calls.append((done, total))
        if done == 3:
            raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough"):
        run(path, progress=fail, threads=1)
    assert calls == [(1, 7), (2, 7), (3, 7)]
    there, total = lm.open_stack(path).done
    assert 3 <= there < total == 7
    calls.clear()
    stack = run(path, progress=lambda *said: calls.append(said))
    assert calls == [(k, 7) for k in range(there + 1, 8)]
    assert contents(stack) == known
    run(path, progress=fail)
    assert len(calls) == 7 - there


KILLED = """
    import os, signal, sys, warnings
    from pathlib import Path
    sys.path[:0] = sys.argv[2:]
    import test_psf_to as test
    from lommel import stacks

    def die(*_):
        os.kill(os.getpid(), signal.SIGKILL)

    def case(path, when):
        put, count = stacks.Store.put, [0]

        def dying(self, parts, index):
            mark = stacks.CHECKSUMS in parts
            count[0] += mark == (when == "before the mark")
            if when != "after a chunk" and count[0] == 3:
                if when == "within the values":
                    Path.replace = die  # when all is written, and nothing has its name
                    put(self, parts, index)
                die()
            put(self, parts, index)

        stacks.Store.put = dying
        test.run(path, threads=1, progress=lambda done, _: when == "after a chunk" and done == 2 and die())

    for when in test.WHEN:
        child = os.fork()
        if child == 0:
            case(Path(sys.argv[1]) / f"{when}.zarr", when)
            os._exit(1)
        assert os.waitpid(child, 0)[1] == signal.SIGKILL, when
"""
WHEN = ("after a chunk", "before the mark", "within the values")


@pytest.fixture(scope="module")
def killed(tmp_path_factory) -> Path:
    """A folder of stores whose writers were killed."""
    folder = tmp_path_factory.mktemp("killed")
    here = Path(__file__).parent
    command = [sys.executable, "-c", textwrap.dedent(KILLED), str(folder), str(here), str(here.parent / "shared")]
    ended = subprocess.run(command, timeout=300, check=False, capture_output=True, text=True)
    assert ended.returncode == 0, ended.stderr
    return folder


@pytest.mark.skipif(not hasattr(os, "fork"), reason="needs fork")
@pytest.mark.parametrize("when", WHEN)
def test_what_is_killed_goes_on_where_it_was(when, killed, known):
    path, calls = killed / f"{when}.zarr", []
    broken = lm.open_stack(path)
    there, total = broken.done
    # The others were not begun, but for those that the thread had before the signal came.
    assert there in ((2,) if when != "after a chunk" else (2, 3))
    with pytest.raises(ValueError, match=r"chunk \(6,\) of .* is not computed yet; call psf_to again"):
        broken[49]
    stack = run(path, progress=lambda *said: calls.append(said))
    assert calls == [(done, total) for done in range(there + 1, total + 1)]
    assert contents(stack) == known


def test_a_store_of_another_request_is_refused_and_stays(tmp_path, known):
    path = tmp_path / "a.zarr"
    run(path)
    for change, told in (
        ({"tol": 1e-7}, "methods: .*1e-06.* in the store, now .*1e-07"),
        ({"dtype": "float64"}, "dtype: 'float32' in the store, now 'float64'"),
        ({"normalize": "peak"}, "normalize: 'energy' in the store, now 'peak'"),
        ({"chunk": 9}, r"chunks: \[8\] in the store, now \[9\]"),
        ({"center": (4.5, 4.0)}, "center: "),
        ({"axes": {"depth": DEPTHS}}, "axes: "),
        ({"axes": {"object_distance": DEPTHS + 1e-9}}, "the coordinates differ"),
    ):
        with pytest.raises(ValueError, match=f"holds PSFs computed with other arguments .{told}"):
            run(path, **change)
    with pytest.raises(ValueError, match="the pupils differ"):
        lm.psf_to(path, LENS.stopped(2.0).pupil(DEPTHS), SIDE, PIXEL)
    # Chunks that are not named are those that there are.
    assert contents(run(path, chunk=None)) == known


def test_something_else_at_the_path_is_refused_and_stays(tmp_path):
    path = tmp_path / "a.zarr"
    path.write_bytes(b"mine")
    with pytest.raises((FileError, OSError)):
        run(path)
    assert path.read_bytes() == b"mine"
    folder = tmp_path / "b.zarr"
    folder.mkdir()
    with pytest.raises((FileError, OSError)):
        run(folder)
    field = tmp_path / "field.zarr"
    map_ = lm.FieldMap.from_seidel(20e-3, W131=1.0, wavelength=550e-9, f_number=4.0)
    map_.grid(1, 2, sensor=(20e-3, 30e-3), shape=5, pixel=2e-6).save(field)
    with pytest.raises(FileError, match="is not a stack of PSFs"):
        run(field)
    assert lm.PSFGrid.load(field).values.shape == (1, 2, 5, 5)


@pytest.fixture(scope="module")
def begun(tmp_path_factory) -> Path:
    """A store whose last chunks lack."""
    path = tmp_path_factory.mktemp("begun") / "a.zarr"

    def interrupted(done: int, total: int) -> None:
        if done == 4:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        run(path, progress=interrupted, threads=1)
    return path


@pytest.mark.parametrize(
    "name", ["values/c.1.0.0", "error_bound/c.1", "scale/c.1", "method/c.1", "chunks/checksum/c.1"]
)
def test_a_chunk_whose_file_is_missing_is_computed_again(name, begun, tmp_path, known):
    path, calls = tmp_path / "a.zarr", []
    shutil.copytree(begun, path)
    there = lm.open_stack(path).done[0]
    (path / name).unlink()
    assert lm.open_stack(path).done[0] == there - 1
    assert contents(run(path, progress=lambda *said: calls.append(said))) == known
    assert len(calls) == 7 - there + 1


@pytest.mark.parametrize("how", ["zeros", "cut off"])
def test_a_chunk_that_is_damaged_is_refused_until_it_is_removed(how, begun, tmp_path, known):
    path = tmp_path / "a.zarr"
    shutil.copytree(begun, path)
    file = path / "values" / "c.1.0.0"
    size = file.stat().st_size
    file.write_bytes(bytes(size if how == "zeros" else size - 4))
    fault = (
        r"to compute it again, remove chunks/checksum/c\.1 in this"
        if how == "zeros"
        else r"its chunk c\.1\.0\.0 takes"
    )
    with pytest.raises(FileError, match=fault):
        run(path)[:]
    (path / "chunks" / "checksum" / "c.1").unlink()
    assert contents(run(path)) == known


@pytest.mark.parametrize(
    ("options", "fault"),
    [
        ({"chunk": 0}, "chunk must be from 1 to"),
        ({"center": ([4.0, 4.5], 4.0)}, "center must be one"),
        ({"axes": {"y": DEPTHS}}, "axes must not be called"),
        ({"axes": {"d": DEPTHS[1:]}}, r"axes\['d'\] must be 50 numbers"),
        ({"axes": {"d": DEPTHS, "e": 1}}, "axes must name the 1 axes"),
        ({"threads": 2, "client": ThreadPoolExecutor(1)}, "threads must be left out with a client"),
    ],
)
def test_what_is_out_of_range_is_told_and_nothing_is_written(options, fault, tmp_path):
    with pytest.raises((TypeError, ValueError), match=fault):
        run(tmp_path / "a.zarr", **options)
    assert not list(tmp_path.iterdir())


def test_pupils_that_are_no_stack_and_other_suffixes_are_told(tmp_path):
    one = LENS.pupil(2.0)
    for path, pupils, fault in (
        ("a.zarr", one, "pupils must be a stack of 1 to 8 axes"),
        ("a.zarr", [], "pupils must not be an empty list"),
        ("a.zarr", [one, LENS.pupil([1.0, 2.0])], "pupils must all have the shape of the first"),
        ("a.zarr", LENS, "got a Lens; lens.pupil"),
        ("a.zip", LENS.pupil(DEPTHS), r"store must end in .zarr, got"),
    ):
        with pytest.raises((TypeError, ValueError), match=fault):
            lm.psf_to(tmp_path / path, pupils, SIDE, PIXEL)


def test_a_store_that_a_worker_does_not_see_is_told(tmp_path):
    class Elsewhere(ThreadPoolExecutor):
        def submit(self, *_):
            future = Future()
            future.set_exception(stacks.replaced_error(tmp_path / "a.zarr"))
            return future

    with Elsewhere(1) as client, pytest.raises(FileError, match=r"a worker does not see .*a\.zarr: choose a folder"):
        run(tmp_path / "a.zarr", client=client)
