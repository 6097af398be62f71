"""Folders that are computed part by part: who may write, what is taken up again, and what is left as it is."""

from __future__ import annotations

import errno
from contextlib import suppress

import numpy as np
import pytest

from lommel.base import atomic
from small_disk import small_disk

VALUES = np.arange(6.0)


def fill(folder):
    folder.mkdir()
    (folder / "made").write_text("made")


def begun(place, request=1):
    return atomic.unfinished_folder(place, {"of": request}, fill)


def interrupted(place, request=1):
    with suppress(KeyboardInterrupt), begun(place, request) as there:
        there.record("0", "a", VALUES)
        raise KeyboardInterrupt
    return there


def names(folder):
    return sorted(path.name for path in folder.iterdir())


def test_a_part_is_done_if_its_values_and_what_they_are_of_are_the_same(tmp_path):
    there = interrupted(tmp_path / "a")
    assert names(tmp_path) == [".a.unfinished"]
    with begun(tmp_path / "a") as again:
        assert again == there
        assert again.is_complete("0", "a", VALUES)
        assert not again.is_complete("0", "b", VALUES)  # of another request
        assert not again.is_complete("0", "a", 0.0 * VALUES)  # missing, that is zeros
        assert not again.is_complete("1", "a", VALUES)
        again.finish()
    assert (names(tmp_path), names(tmp_path / "a")) == (["a"], ["made"])


def test_another_request_begins_anew_and_an_error_leaves_nothing(tmp_path):
    interrupted(tmp_path / "a")
    with suppress(KeyError), begun(tmp_path / "a", 2) as there:
        assert not there.is_complete("0", "a", VALUES)
        raise KeyError
    assert names(tmp_path) == []


def test_one_call_at_a_time_writes(tmp_path):
    with begun(tmp_path / "a") as there:
        for request in (1, 2):
            with pytest.raises(ValueError, match="a is being written by another call; wait until that has ended"):
                begun(tmp_path / "a", request).__enter__()
        there.record("0", "a", VALUES)
        there.finish()
    assert names(tmp_path) == ["a"]


def test_without_locks_what_another_may_write_is_left(tmp_path, monkeypatch):
    def no_locks(*_):
        raise OSError(errno.ENOLCK, "No locks available")

    monkeypatch.setattr(atomic.fcntl, "flock", no_locks)
    interrupted(tmp_path / "a")
    with pytest.raises(ValueError, match="may still be running"), begun(tmp_path / "a", 2):
        pass
    with begun(tmp_path / "a") as there:
        assert there.is_complete("0", "a", VALUES)


def test_what_was_removed_meanwhile_is_not_written_into(tmp_path):
    with begun(tmp_path / "a") as there:
        there.record("0", "a", VALUES)
        there.remove()
        with begun(tmp_path / "a"):
            for write in (lambda: there.record("1", "a", VALUES), there.finish):
                with pytest.raises(ValueError, match="was removed while it was written"):
                    write()


@pytest.mark.parametrize("what", ["folder", "file", "link", "inner", "damaged", "list", "changed"])
def test_what_is_not_ours_is_named_and_left(tmp_path, what):
    room, other = tmp_path / ".a.unfinished", tmp_path / "other"
    fill(other)
    if what in ("inner", "damaged", "list", "changed"):
        interrupted(tmp_path / "a")
        mark = room / "request.json"
        texts = {"damaged": "", "list": "[1]", "changed": mark.read_text().replace('"of": 1', '"of": 2')}
        mark.write_text(texts.get(what, mark.read_text()))
        if what == "inner":
            (room / "new").rename(tmp_path / "moved")
            (room / "new").symlink_to(other)
    elif what == "link":
        room.symlink_to(other)
    elif what == "folder":
        fill(room)
    else:
        room.write_text("mine")
    before = {path: path.lstat().st_mtime_ns for path in tmp_path.rglob("*")}
    reason = {"folder": "it lacks request.json", "list": "its request.json is damaged"}.get(what, ".*")
    with pytest.raises(ValueError, match=rf"\.a\.unfinished holds no unfinished result: {reason}; move or remove it"):
        begun(tmp_path / "a").__enter__()
    assert {path: path.lstat().st_mtime_ns for path in tmp_path.rglob("*")} == before


def test_a_process_killed_while_it_replaced_a_folder_has_left_the_old_one(tmp_path):
    fill(tmp_path / "a")
    there = interrupted(tmp_path / "a")
    (tmp_path / "a").rename(there.scratch / "old")
    with begun(tmp_path / "a", 2):
        assert names(tmp_path / "a") == ["made"]
    assert names(tmp_path) == ["a"]


def test_what_tells_whose_it_is_is_removed_last(tmp_path, monkeypatch):
    def killed(path):
        raise KeyboardInterrupt

    with monkeypatch.context() as patch, suppress(KeyboardInterrupt), begun(tmp_path / "a") as there:
        there.record("0", "a", VALUES)
        patch.setattr(atomic.shutil, "rmtree", killed)
        there.finish()
    assert names(tmp_path) == [".a.unfinished", "a"]
    with begun(tmp_path / "a") as again:
        assert not again.is_complete("0", "a", VALUES)
    assert (names(tmp_path), names(tmp_path / "a")) == (["a"], ["made"])


def test_a_disk_that_gets_full_is_told_by_the_name_of_the_place(tmp_path):
    with begun(tmp_path / "a") as there, small_disk(5), pytest.raises(OSError, match=r"File too large: '[^']*/a'$"):
        there.record("0", "a", VALUES)
    assert names(tmp_path) == []


def test_what_cannot_be_removed_hides_no_error_and_is_begun_anew(tmp_path, monkeypatch):
    def refused(path):
        raise OSError(errno.ENOTEMPTY, "Directory not empty", path)

    with monkeypatch.context() as patch, suppress(KeyError), begun(tmp_path / "a"):
        patch.setattr(atomic.shutil, "rmtree", refused)
        raise KeyError
    with begun(tmp_path / "a") as again:
        again.record("0", "a", VALUES)
        again.finish()
    assert (names(tmp_path), names(tmp_path / "a")) == (["a"], ["made"])
