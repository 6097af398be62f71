"""Helper threads: fewer than processors, made once, at work where they may be, and what fails in one is told."""

from __future__ import annotations

import os
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest

import lommel as lm

TASKS = Path("/proc/self/task")
watched = pytest.mark.skipif(
    not Path("/proc/self/schedstat").exists(), reason="threads are watched where /proc has their names and times"
)


def helpers() -> dict[str, int]:
    """Return the nanoseconds that each helper thread has been at work."""
    named = [task for task in TASKS.iterdir() if (task / "comm").read_text().strip() == "lommel"]
    return {task.name: int((task / "schedstat").read_text().split()[0]) for task in named}


@pytest.mark.quick
@watched
def test_helpers_are_made_once_work_when_they_may_and_never_outnumber_the_processors():
    spare = len(os.sched_getaffinity(0)) - 1
    pupil = lm.Pupil(lm.Wavefront(np.linspace(20.0, 30.0, 60)), obscuration=0.1)
    lm.psf(pupil, 301, 0.5)
    made = helpers()
    assert len(made) == spare
    for asked in (1, 2, 64, None, 1):
        time.sleep(0.05)  # until they are asleep
        before, start = helpers(), time.process_time_ns()
        for _ in range(20):
            lm.psf(pupil, 301, 0.5, threads=asked)
        after, spent = helpers(), time.process_time_ns() - start
        assert after.keys() == made.keys()
        assert sum(after[k] > before[k] for k in after) == (0 if asked == 1 else min(spare, (asked or 64) - 1))
        # To wake and to find nothing to do takes microseconds.
        assert asked == 1 or spare == 0 or sum(after.values()) - sum(before.values()) > 0.1 * spent


BOUND = """
import os
os.sched_setaffinity(0, {min(os.sched_getaffinity(0))})
import lommel
lommel.psf(lommel.Pupil(lommel.Wavefront([20.0, 25.0] * 30), obscuration=0.1), 301, 0.5)
print(sum(open(f"/proc/self/task/{task}/comm").read() == "lommel\\n" for task in os.listdir("/proc/self/task")))
"""


@watched
def test_a_process_that_is_bound_to_one_processor_has_no_helpers():
    done = subprocess.run([sys.executable, "-c", BOUND], capture_output=True, text=True, check=True)
    assert int(done.stdout) == 0


@pytest.mark.parametrize("place", [0, 17, 39])
def test_what_fails_in_a_thread_is_told_by_the_call(place):
    defocus = np.full(40, 3.0)
    defocus[place] = 1e5
    with pytest.raises(ValueError, match="nodes, more than the limit"):
        lm.psf(lm.Pupil(lm.Wavefront(defocus), obscuration=0.1), 257, 0.5, threads=2)
    # And nothing stays behind of it.
    assert lm.psf(lm.Pupil(), 9, 0.5).values.max() > 0
