"""Helper threads: there are some, no more than processors, again and again, and what fails in one is told."""

from __future__ import annotations

import os
import threading
import time
from pathlib import Path

import numpy as np
import pytest

import lommel as lm

TASKS = Path("/proc/self/task")
watched = pytest.mark.skipif(not TASKS.exists(), reason="threads are counted where /proc tells them")


def helpers(work) -> int:
    """Return the most threads that there are at once while `work` runs again and again, beyond those before."""
    time.sleep(0.05)  # the system may still count one that has ended
    before, done, most = len(list(TASKS.iterdir())), threading.Event(), 0

    def count() -> None:
        nonlocal most
        while not done.is_set():
            most = max(most, len(list(TASKS.iterdir())))
            time.sleep(2e-4)

    watcher = threading.Thread(target=count)
    watcher.start()
    start = time.monotonic()
    while time.monotonic() < start + 0.2:
        work()
    done.set()
    watcher.join()
    return most - before - 1


@watched
def test_helpers_are_given_back_call_after_call_and_never_outnumber_the_processors():
    spare = len(os.sched_getaffinity(0)) - 1
    pupil = lm.Pupil(lm.Wavefront(np.linspace(20.0, 30.0, 60)), obscuration=0.1)
    for asked in (None, 1, 2, 64, None):
        found = helpers(lambda asked=asked: lm.psf(pupil, 301, 0.5, threads=asked))
        wanted = spare if asked is None else min(spare, asked - 1)
        assert found == wanted


@pytest.mark.parametrize("place", [0, 17, 39])
def test_what_fails_in_a_thread_is_told_by_the_call(place):
    defocus = np.full(40, 3.0)
    defocus[place] = 1e5
    with pytest.raises(ValueError, match="nodes, more than the limit"):
        lm.psf(lm.Pupil(lm.Wavefront(defocus), obscuration=0.1), 257, 0.5, threads=2)
    # And nothing stays behind of it.
    assert lm.psf(lm.Pupil(), 9, 0.5).values.max() > 0
