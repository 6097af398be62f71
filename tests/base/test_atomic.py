"""Files and folders written whole or not at all: links, permissions, long names, what killed processes leave.

Recordings are kept.
"""

from __future__ import annotations

import errno
import os
import stat
import subprocess
import sys
import time
from contextlib import suppress
from pathlib import Path

import numpy as np
import pytest

from lommel.base import atomic
from read_only import read_only
from small_disk import small_disk


def mode(path: Path) -> int:
    return stat.S_IMODE(path.stat().st_mode)


def test_a_link_is_followed_and_what_it_names_is_replaced(tmp_path):
    (tmp_path / "data").mkdir()
    target, link = tmp_path / "data" / "x.tif", tmp_path / "psf.tif"
    target.write_bytes(b"old")
    link.symlink_to("data/x.tif")
    atomic.write(link, b"new")
    assert link.is_symlink()
    assert target.read_bytes() == b"new"
    dangling = tmp_path / "next.tif"
    dangling.symlink_to("data/y.tif")
    atomic.write(dangling, b"made")
    assert (tmp_path / "data" / "y.tif").read_bytes() == b"made"
    assert sorted(path.name for path in tmp_path.rglob("*")) == ["data", "next.tif", "psf.tif", "x.tif", "y.tif"]


@pytest.mark.parametrize("permissions", [0o600, 0o644, 0o660, 0o444])
def test_the_permissions_of_what_was_there_are_kept(permissions, tmp_path):
    target = tmp_path / "a"
    target.touch()
    target.chmod(permissions)
    atomic.write(target, b"new")
    assert mode(target) == permissions
    assert target.read_bytes() == b"new"


def test_the_contents_of_a_private_file_are_private_at_every_moment(tmp_path, monkeypatch):
    target, seen = tmp_path / "a", []
    target.touch()
    target.chmod(0o600)
    opened = os.open

    def watched(path, flags, *rest):
        handle = opened(path, flags, *rest)
        if flags & os.O_CREAT:
            seen.append(stat.S_IMODE(os.fstat(handle).st_mode))
        return handle

    monkeypatch.setattr(os, "open", watched)
    atomic.write(target, b"secret")
    assert seen == [0o600]


def test_the_umask_of_the_process_is_never_touched(tmp_path, monkeypatch):
    def touched(*_):
        raise AssertionError

    monkeypatch.setattr(os, "umask", touched)
    atomic.write(tmp_path / "a", b"")
    atomic.write_folder(tmp_path / "b", lambda folder: folder.mkdir())
    assert sorted(path.name for path in tmp_path.iterdir()) == ["a", "b"]


@pytest.mark.parametrize("length", [246, 255])
def test_any_name_that_a_file_may_have_can_be_written(length, tmp_path):
    target = tmp_path / ("x" * length)
    atomic.write(target, b"1")
    atomic.write(target, b"2")
    assert target.read_bytes() == b"2"
    with pytest.raises(OSError, match="x" * 256):
        atomic.write(tmp_path / ("x" * 256), b"")


@pytest.mark.parametrize("make", [os.mkfifo, lambda path: path.symlink_to("/dev/null")])
def test_what_is_no_file_is_left_as_it_is(make, tmp_path):
    make(tmp_path / "a")
    with pytest.raises(OSError, match=r"no regular file: .*a'"):
        atomic.write(tmp_path / "a", b"")
    assert list(tmp_path.iterdir()) == [tmp_path / "a"]
    assert not (tmp_path / "a").is_file()


def test_of_several_files_none_is_written_if_one_cannot_be(tmp_path):
    (tmp_path / "first").write_bytes(b"old")
    (tmp_path / "third").mkdir()

    def write_all():
        with atomic.whole_files() as put:
            for name in ("first", "second", "third"):
                put(tmp_path / name, b"new")

    with pytest.raises(IsADirectoryError, match="third"):
        write_all()
    assert (tmp_path / "first").read_bytes() == b"old"
    assert sorted(path.name for path in tmp_path.iterdir()) == ["first", "third"]


def test_a_folder_is_replaced_whole_with_its_permissions_and_through_links(tmp_path):
    store, link = tmp_path / "store", tmp_path / "link"

    def fill(folder: Path) -> None:
        folder.mkdir()
        (folder / "part").write_bytes(b"new")
        (folder / "part").chmod(0o600)

    atomic.write_folder(store, fill)
    (tmp_path / "like").mkdir()
    assert mode(store) == mode(tmp_path / "like")
    assert mode(store / "part") == mode(store) & 0o666
    store.chmod(0o750)
    (store / "stale").touch()
    link.symlink_to("store")
    atomic.write_folder(link, fill)
    assert link.is_symlink()
    assert (mode(store), mode(store / "part")) == (0o750, 0o640)
    assert sorted(path.name for path in tmp_path.rglob("*")) == ["like", "link", "part", "store"]


def test_a_folder_that_cannot_be_made_leaves_the_old_one(tmp_path):
    def fill(folder: Path) -> None:
        folder.mkdir()
        raise ValueError("half way")

    (tmp_path / "store").mkdir()
    (tmp_path / "store" / "old").touch()
    with pytest.raises(ValueError, match="half way"):
        atomic.write_folder(tmp_path / "store", fill)
    assert sorted(path.name for path in tmp_path.rglob("*")) == ["old", "store"]


def test_what_a_killed_process_left_is_removed_a_day_later_but_never_the_only_copy(tmp_path):
    code = "import os, sys; from lommel.base import atomic\nwith atomic.whole_files() as put:\n"
    code += "    put(__import__('pathlib').Path(sys.argv[1]) / 'a', b'x'); os.kill(os.getpid(), 9)"
    subprocess.run([sys.executable, "-c", code, str(tmp_path)], check=False)
    (left,) = tmp_path.iterdir()
    assert left.name.startswith(".lommel-")
    fresh, store, only = (tmp_path / f".lommel-{name}" for name in ("fresh", "store", "only"))
    fresh.touch()
    (store / "new").mkdir(parents=True)
    (only / "old").mkdir(parents=True)
    (tmp_path / ".other").touch()
    before = time.time() - 2 * 86400
    for path in (left, store, only, tmp_path / ".other"):
        os.utime(path, (before, before))
    atomic._sweep.cache_clear()
    atomic.write(tmp_path / "a", b"")
    assert sorted(path.name for path in tmp_path.iterdir()) == [".lommel-fresh", ".lommel-only", ".other", "a"]


def test_an_interrupt_just_after_a_file_was_made_leaves_nothing(tmp_path, monkeypatch):
    opened = os.open

    def interrupted(*args):
        os.close(opened(*args))
        raise KeyboardInterrupt

    monkeypatch.setattr(os, "open", interrupted)
    with pytest.raises(KeyboardInterrupt):
        atomic.write(tmp_path / "a", b"data")
    assert not list(tmp_path.iterdir())


def filled(target: Path, fill) -> None:
    """Write a file by what fills a place for it."""
    with atomic.temporary_for(target) as place, atomic.as_path_error(target):
        fill(place)


def test_a_file_that_is_filled_appears_whole_or_not_at_all(tmp_path):
    target = tmp_path / "a"
    target.write_bytes(b"old")
    target.chmod(0o640)

    def fail(place: Path) -> None:
        place.write_bytes(b"half")
        raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough"):
        filled(target, fail)
    assert [path.name for path in tmp_path.iterdir()] == ["a"]
    assert target.read_bytes() == b"old"
    filled(target, lambda place: place.write_bytes(b"new"))
    assert (target.read_bytes(), mode(target)) == (b"new", 0o640)
    assert [path.name for path in tmp_path.iterdir()] == ["a"]
    with pytest.raises(OSError, match="none"):
        filled(tmp_path / "none" / "a", lambda place: place.write_bytes(b"new"))


def test_what_cannot_be_written_is_told_by_its_own_name(tmp_path):
    def fill(place: Path) -> None:
        np.zeros(1000).tofile(place)  # which says how much was written, but not why no more

    with small_disk(100), pytest.raises(OSError, match=r"\(1000 requested and 12 written\): '[^']*/a'$"):
        filled(tmp_path / "a", fill)
    ways = (
        lambda: atomic.write(tmp_path / "a", b"new"),
        lambda: filled(tmp_path / "a", fill),
        lambda: atomic.write_folder(tmp_path / "a", fill),
    )
    for write in ways:
        with read_only(), pytest.raises(OSError, match=r"Read-only file system: '[^']*/a'$"):
            write()
    assert not list(tmp_path.iterdir())


def test_errors_of_temporary_files_are_those_of_the_place_and_of_folders_only_those_of_a_full_disk(
    tmp_path, monkeypatch
):
    for error, kind, number in (
        (OSError(errno.ENOTEMPTY, "not empty", "tmp"), FileExistsError, errno.EEXIST),
        (OSError("12 of 1000 bytes"), OSError, errno.ENOSPC),
        (PermissionError(errno.EACCES, "no", "tmp"), PermissionError, errno.EACCES),
    ):
        with pytest.raises(kind) as caught, atomic.as_path_error(tmp_path / "a"):
            raise error
        assert (caught.value.errno, caught.value.filename) == (number, str(tmp_path / "a"))
    for number in (errno.EINVAL, errno.ENOSPC, errno.EIO):
        monkeypatch.setattr(atomic.os, "fsync", lambda _, number=number: (_ for _ in ()).throw(OSError(number, "no")))
        with suppress(OSError) if number == errno.EINVAL else pytest.raises(OSError, match="no"):
            atomic._synchronise(tmp_path)
            assert number == errno.EINVAL


@pytest.mark.parametrize("length", [5, 255])
def test_a_recording_gets_its_name_at_the_end_and_never_that_of_an_earlier_recording(length, tmp_path):
    target = tmp_path / ("x" * (length - 4) + ".csv")
    target.write_text("old")
    target.chmod(0o640)
    names = []
    with atomic.recording(target) as first, atomic.recording(target) as second:
        for file in (first, second):
            names.append(file.path.name)
            file.path.write_text("new")
            file.started = True
        assert target.read_text() == "old"
    assert names == [f"{'x' * min(length - 4, 255 - len(ending))}{ending}" for ending in UNFINISHED]
    assert [path.name for path in tmp_path.iterdir()] == [target.name]
    assert (target.read_text(), mode(target)) == ("new", 0o640)


UNFINISHED = (".unfinished.csv", ".unfinished-2.csv")


def test_an_error_keeps_a_recording_in_which_there_is_something(tmp_path):
    def record(text: str, *, added: bool) -> None:
        with atomic.recording(tmp_path / "a.csv") as file:
            file.path.write_text(text)
            if added:
                file.started = True
            raise RuntimeError("enough")

    for ending in UNFINISHED:
        with pytest.warns(UserWarning, match=f"a{ending} keeps what was recorded"), pytest.raises(RuntimeError):
            record(ending, added=True)
    with pytest.raises(RuntimeError, match="enough"):
        record("heading", added=False)
    kept = {path.name: path.read_text() for path in tmp_path.iterdir()}
    assert kept == {f"a{ending}": ending for ending in UNFINISHED}
