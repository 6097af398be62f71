"""Several calls for one store at once: each returns what it asked for, or says that another was in its way."""

from __future__ import annotations

import shutil
import subprocess
import sys
import textwrap
import threading
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np
import pytest

import lommel as lm
from lommel.io.psf_files import FileError
from lommel.stacks import PSFStack, Store

OTHER = pytest.mark.parametrize("side", [9, 7], ids=["same shape", "another shape"])
ONE, TWO = np.linspace(2.0, 3.0, 8), np.linspace(0.0, 1.0, 8)


def ask(path: Path, defocus, side: int = 9, **options) -> PSFStack:
    return lm.psf_to(path, lm.Pupil(lm.Wavefront(defocus)), side, 0.3, chunk=2, **options)


def verify(stack: PSFStack, defocus, side: int = 9) -> None:
    """What is there is what was asked for, all of it."""
    assert stack.done == (4, 4)
    pupil = lm.Pupil(lm.Wavefront(defocus))
    for part in (slice(k, k + 2) for k in range(0, 8, 2)):
        found = stack[part]
        assert found.pupil == pupil[part]
        np.testing.assert_array_equal(found.values, lm.psf(pupil[part], side, 0.3).values)


class Busy(ThreadPoolExecutor):
    """A cluster that begins when it is let."""

    def __init__(self) -> None:
        super().__init__(1)
        self.free = threading.Event()
        self.asked = threading.Event()

    def submit(self, task, /, *args, **options):
        def later(*given, **more):
            assert self.free.wait(60)
            return task(*given, **more)

        self.asked.set()
        return super().submit(later, *args, **options)


@pytest.fixture
def first():
    """A call whose chunks wait until they are let."""
    with Busy() as busy, ThreadPoolExecutor(1) as pool:

        def begin(path: Path, **options):
            found = pool.submit(ask, path, ONE, client=busy, **options)
            assert busy.asked.wait(60)
            return found

        begin.go = busy.free.set
        try:
            yield begin
        finally:
            busy.free.set()


@OTHER
def test_a_store_that_is_computed_is_not_begun_anew(side, first, tmp_path):
    path = tmp_path / "a.zarr"
    one = first(path)
    with pytest.raises(ValueError, match=r"a\.zarr holds PSFs computed with other arguments .* or remove this one"):
        ask(path, TWO, side)
    first.go()
    verify(one.result(60), ONE)
    assert [file.name for file in tmp_path.iterdir()] == [path.name]


def test_the_same_request_may_be_computed_by_two_calls(first, tmp_path):
    path = tmp_path / "a.zarr"
    one = first(path)
    verify(ask(path, ONE), ONE)
    first.go()
    verify(one.result(60), ONE)


def test_other_programs_read_a_store_that_is_computed(first, tmp_path):
    zarr = pytest.importorskip("zarr")
    one = first(tmp_path / "a.zarr")
    group = zarr.open_group(tmp_path / "a.zarr", mode="r")
    assert np.all(group["chunks/checksum"][...] == -1)
    assert np.all(np.isnan(group["values"][...]))
    first.go()
    verify(one.result(60), ONE)
    stack = lm.open_stack(tmp_path / "a.zarr")
    np.testing.assert_array_equal(group["values"][...], stack[:].values)
    # Where chunks are written is an array without any, so that nobody who lists the group stumbles.
    assert {name for name, _ in group["chunks"].members()} == {"checksum", stack._store.description["identity"]}


@OTHER
def test_what_a_replaced_store_was_computed_for_is_written_nowhere(side, first, tmp_path):
    """Whoever removes a store asks nobody."""
    path = tmp_path / "a.zarr"
    one = first(path)
    shutil.rmtree(path)
    two = ask(path, TWO, side)
    first.go()
    with pytest.raises(FileError, match=r"was removed, or replaced by another call of psf_to, while .* call"):
        one.result(60)
    verify(two, TWO, side)
    verify(lm.open_stack(path), TWO, side)
    assert [file.name for file in tmp_path.iterdir()] == [path.name]
    shutil.rmtree(path)


@OTHER
@pytest.mark.parametrize("when", ["before", "after"])
def test_of_two_calls_that_begin_a_store_one_gives_way(side, when, tmp_path, monkeypatch):
    path, create, two = tmp_path / "a.zarr", Store.create, []

    def other() -> None:
        try:
            two.append(ask(path, TWO, side))
        except ValueError as error:
            two.append(error)

    def made(path, said, arrays):
        monkeypatch.undo()
        if when == "before":
            other()
        create(path, said, arrays)
        if when == "after":
            other()

    monkeypatch.setattr(Store, "create", made)
    try:
        one = ask(path, ONE)
    except ValueError as error:
        one = error
    answers = [(one, ONE, 9), (two[0], TWO, side)]
    good = [each for each in answers if isinstance(each[0], PSFStack)]
    assert len(good) == 1
    verify(*good[0])
    verify(lm.open_stack(path), *good[0][1:])
    (bad,) = (each[0] for each in answers if each[0] is not good[0][0])
    assert "other arguments" in str(bad)
    assert [file.name for file in tmp_path.iterdir()] == [path.name]


def test_a_chunk_of_another_store_of_the_same_request_is_damaged(tmp_path):
    made = [ask(tmp_path / f"{name}.zarr", ONE) for name in "ab"]
    parts = {name: made[0]._store.read(name, (1,)) for name in ("values", "error_bound", "scale", "method")}
    made[1]._store.put(parts | {"chunks/checksum": made[0]._store.read("chunks/checksum", (1,))}, (1,))
    with pytest.raises(FileError, match="wrong checksum"):
        lm.open_stack(tmp_path / "b.zarr")[2]
    assert made[1][0].pupil == made[0][0].pupil


def test_pupils_that_are_others_than_those_computed_are_damage(tmp_path, first):
    path = tmp_path / "a.zarr"
    one = first(path)
    store = lm.open_stack(path)._store
    store.put({"pupil/edge": store.read("pupil/edge", (0,)) + 1.0}, (0, 0))
    first.go()
    stack = one.result(60)
    with pytest.raises(FileError, match="wrong checksum"):
        stack[0]
    assert stack[2].values.max() > 0.0


PROCESS = """
    import sys, time
    from pathlib import Path
    sys.path.insert(0, sys.argv[1])
    import numpy as np
    import test_at_once as test

    folder, k, side, rounds = Path(sys.argv[2]), int(sys.argv[3]), int(sys.argv[4]), int(sys.argv[5])
    wanted, said, draw = (test.ONE, test.TWO)[k], [], np.random.default_rng(k)
    test.ask(folder / f"warm{k}.zarr", wanted, side)
    for n in range(rounds):
        path = folder / f"{n}.zarr"
        (folder / f"ready-{k}-{path.name}").touch()
        while not (folder / f"ready-{1 - k}-{path.name}").exists():
            time.sleep(0.0005)
        time.sleep(0.01 * draw.random() ** 3)
        try:
            test.verify(test.ask(path, wanted, side), wanted, side)
            said.append("good")
        except ValueError as error:
            assert "other arguments" in str(error), error
            said.append("gave way")
    print(*said, sep=",")
"""


@OTHER
def test_of_two_processes_each_has_what_it_asked_for_or_gives_way(side, tmp_path):
    rounds = 16
    command = [sys.executable, "-c", textwrap.dedent(PROCESS), str(Path(__file__).parent), str(tmp_path)]
    pair = [
        subprocess.Popen(
            [*command, str(k), str(s), str(rounds)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
        )
        for k, s in enumerate((9, side))
    ]
    ended = [one.communicate(timeout=300) for one in pair]
    assert [one.returncode for one in pair] == [0, 0], ended
    said = [out.strip().split(",") for out, _ in ended]
    for n, pair_said in enumerate(zip(*said, strict=True)):
        assert "good" in pair_said
        path = tmp_path / f"{n}.zarr"
        k = pair_said.index("good")
        if pair_said.count("good") == 1:
            verify(lm.open_stack(path), (ONE, TWO)[k], (9, side)[k])
    assert not list(tmp_path.glob(".lommel-*"))
