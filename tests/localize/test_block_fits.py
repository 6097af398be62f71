"""Movies on executors: the localisations of this process bit by bit, and results that are kept."""

from __future__ import annotations

import pickle
import random
from concurrent.futures import Future, ThreadPoolExecutor

import numpy as np
import pytest
import tifffile

import lommel as lm
import simulated_movies as simulated
from lommel.base.executors import ExecutorError
from lommel.localize import LocalizeOptions, Table, block_fits, localize_movie
from lommel.localize.localizations import joined
from lommel.localize.movie_fits import movie_blocks

CAMERA = lm.Noise(white=0.46, read=1.6, offset=100.0)
FRAMES, SIDE = 12, 64


@pytest.fixture(scope="module")
def table() -> Table:
    return Table(simulated.pupil(), shape=11, pixel=simulated.PIXEL, z=(-0.4e-6, 0.4e-6), reach=1.0, tol=1e-3)


@pytest.fixture(scope="module")
def movie() -> np.ndarray:
    molecules = simulated.spread(FRAMES, SIDE, each=2, apart=20, seed=1, reach=0.3e-6)
    return simulated.recorded(simulated.light(molecules, FRAMES, SIDE, 8.0), CAMERA, 2)


def found(movie, table, block=3, saturation=None, **options):
    return joined(
        list(movie_blocks(movie, table, CAMERA, LocalizeOptions(**options), block=block, saturation=saturation))
    )


def assert_equal(one: lm.localize.Localizations, other: lm.localize.Localizations) -> None:
    """The same bits, counts and findings."""
    assert one.table.tobytes() == other.table.tobytes()
    assert (one.to_dict(), one.findings) == (other.to_dict(), other.findings)


class Pickling(ThreadPoolExecutor):
    """Executor whose tasks and results are pickled, as those of processes are, and counted."""

    def __init__(self, workers: int = 2) -> None:
        super().__init__(workers)
        self.results: list[object] = []
        self.size = 0

    def submit(self, function, *task) -> Future:
        data = pickle.dumps((function, task))
        self.size = max(self.size, len(data))
        return super().submit(self._run, data)

    def _run(self, data):
        function, task = pickle.loads(data)
        result = pickle.loads(pickle.dumps(function(*task)))
        self.results += result
        return result


@pytest.mark.parametrize("source", ["array", "file", "dask"])
def test_an_executor_gives_the_same_bits(source, movie, table, tmp_path):
    images: object = movie
    if source == "file":
        images = tmp_path / "movie.tif"
        tifffile.imwrite(images, movie, photometric="minisblack")
    elif source == "dask":
        images = pytest.importorskip("dask.array").from_array(movie, chunks=(5, 32, 64))
    told: list[tuple[int, int]] = []
    with Pickling() as client:
        made = found(images, table, client=client, progress=lambda *at: told.append(at))
    assert_equal(made, found(images, table))
    assert told == [(3, 12), (6, 12), (9, 12), (12, 12)]
    assert np.array_equal(made.table, found(movie, table).table)


def test_blocks_are_fitted_again_where_one_before_tilts_the_background(table):
    true = simulated.spread(40, 64, each=3, apart=18, seed=7, reach=0.3e-6)
    movie = CAMERA.record(simulated.light(true, 40, 64, 15.0) + 0.4 * (np.arange(64) - 31.5), 3)
    alone = found(movie, table, block=10)
    with Pickling() as client:
        assert_equal(found(movie, table, block=10, client=client), alone)
    assert alone.findings.get("tilted_background") is not None
    assert len(client.results) > 4


def test_a_saturation_that_one_block_assumes_holds_for_the_next(movie, table):
    top = np.minimum(np.round(movie), 4095.0).astype(np.uint16)
    top[0, 20:26, 30:36] = 4095
    with Pickling() as client:
        made = found(top, table, client=client)
    assert_equal(made, found(top, table))
    assert made.findings.get("saturation_assumed") is not None


@pytest.mark.parametrize("client", [None, Pickling()])
def test_results_are_kept_until_the_call_ends(client, movie, table, tmp_path, monkeypatch):
    def stop(count: int, _: int) -> None:
        if count == 6:
            raise KeyboardInterrupt

    keep, scratch = tmp_path / "found.csv", tmp_path / ".found.csv.unfinished"
    with pytest.raises(KeyboardInterrupt):
        found(movie, table, client=client, keep=keep, progress=stop)
    assert scratch.is_dir()
    fitted: list[int] = []
    told: list[int] = []
    fit = block_fits._recentred

    def count(values, spots, first, *more):
        fitted.append(first)
        return fit(values, spots, first, *more)

    monkeypatch.setattr(block_fits, "_recentred", count)
    changed = movie.copy()
    changed[4] = changed[7]
    made = found(changed, table, client=client, keep=keep, progress=lambda done, _: told.append(done))
    assert not scratch.exists()
    assert told[0] in (6, 9)  # as many as were kept
    assert told == sorted(told)
    assert told[-1] == FRAMES
    assert sorted(fitted) == [3, 6, 9]
    assert_equal(made, found(changed, table))


def test_what_was_kept_of_other_arguments_is_not_used(movie, table, tmp_path):
    blocks = movie_blocks(movie, table, CAMERA, LocalizeOptions(keep=tmp_path / "a.csv"), block=3)
    next(blocks)
    blocks.close()
    other = lm.Noise(white=0.5, read=1.6, offset=100.0)
    made = localize_movie(movie, table, noise=other, keep=tmp_path / "a.csv")
    assert_equal(made, localize_movie(movie, table, noise=other))


def test_two_calls_that_keep_beside_one_output_are_told(movie, table, tmp_path):
    blocks = movie_blocks(movie, table, CAMERA, LocalizeOptions(keep=tmp_path / "a.csv"), block=3)
    next(blocks)
    with pytest.raises(ValueError, match="is being written by another call"):
        found(movie, table, keep=tmp_path / "a.csv")
    blocks.close()


@pytest.mark.filterwarnings("ignore::lommel.base.executors.Waiting")  # workers begin anew
def test_workers_and_a_scheduler_that_are_killed_change_nothing(movie, table, tmp_path):
    distributed = pytest.importorskip("distributed")
    psutil = pytest.importorskip("psutil")
    long = np.concatenate([movie] * 8)
    tifffile.imwrite(tmp_path / "movie.tif", long, photometric="minisblack")
    draw, kills = random.Random(3), 0
    cluster = distributed.LocalCluster(n_workers=2, threads_per_worker=1, processes=True, dashboard_address=":0")
    with cluster, distributed.Client(cluster) as client:

        def kill(count: int, _: int) -> None:
            nonlocal kills
            if count % 15 == 0:
                client.wait_for_workers(2)  # one that is killed while it starts is not started again
                processes = psutil.Process().children(recursive=True)
                workers = [each for each in processes if "spawn_main" in " ".join(each.cmdline())]
                draw.choice(workers).kill()
                kills += 1

        made = found(tmp_path / "movie.tif", table, client=client, progress=kill)
        assert kills == 6
        assert_equal(made, found(tmp_path / "movie.tif", table))
        keep = tmp_path / "a.csv"
        with pytest.raises(ExecutorError, match="the client cancelled tasks"):
            found(tmp_path / "movie.tif", table, client=client, keep=keep, progress=lambda *_: cluster.close())
    assert (tmp_path / ".a.csv.unfinished").is_dir()
    assert_equal(found(tmp_path / "movie.tif", table, keep=keep), made)
