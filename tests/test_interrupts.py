"""Ctrl-C ends any call at once, and leaves all in order for the next."""

from __future__ import annotations

import subprocess
import sys

import pytest

BLUR = """
from lommel import _core
bank = np.ones((7, 101, 112), np.float32), np.full(6, 100), np.full(6, 4e4)
where, scene, wide = np.full((1200, 1200), 2.5), np.ones((1200, 1200), np.float32), np.ones((1400, 1424), np.float32)
"""

# Each takes many seconds: what comes before, and the call.
CALLS = {
    "stack": ("", "lm.psf(lm.Pupil(lm.Wavefront(np.linspace(1.0, 900.0, 200_000))), 33, 0.5, threads=2)"),
    "stack of one thread": (
        "",
        "lm.psf(lm.Pupil(lm.Wavefront(np.linspace(1.0, 900.0, 90_000))), 65, 0.5, threads=1)",
    ),
    "far window": ("", "lm.psf(lm.Pupil(lm.Wavefront(np.linspace(2000.0, 2001.0, 99))), (1, 16384), 9.0, threads=1)"),
    "averages": ("", "lm.psf(lm.Pupil(lm.Wavefront(50.0, 20.0)), 12_000, 0.5, tol=1e-9, integrate=True)"),
    "Zernike": ("", "lm.psf(lm.Pupil(lm.Wavefront(40.0, nonradial={(3, 1): 60.0})), 8192, 0.2, threads=1)"),
    "chordal": (
        "way = ChordalGauss(1e-10); coma = {(3, 1): np.linspace(1, 150, 20_000)}",
        "lm.psf(lm.Pupil(lm.Wavefront(0.0, nonradial=coma)), 33, 1.0, method=way, threads=2)",
    ),
    "nodes": (
        "Hankel().field(lm.Pupil(), [1.0])",
        "[Hankel().field(lm.Pupil(lm.Wavefront(9.0 + i)), [25_000.0 + i]) for i in range(99)]",
    ),
    "spread": (BLUR, "_core.spread(bank, where, scene, 2, wide)"),
    "collect": (BLUR, "_core.collect(bank, where, wide, 2, scene)"),
}

PROGRAM = """
import os, signal, sys, threading, time
import numpy as np
import lommel as lm
from lommel.methods import ChordalGauss, Hankel, NijboerZernike
{before}
sent = []

def interrupt():
    time.sleep(0.3)
    sent.append(time.process_time())  # not of what else the machine does
    os.kill(os.getpid(), signal.SIGINT)

threading.Thread(target=interrupt, daemon=True).start()
try:
    {call}
except KeyboardInterrupt:
    late = time.process_time() - sent[0]
else:
    sys.exit("the call ended by itself")
pupil = lm.Pupil(lm.Wavefront(9.0, nonradial={{(3, 1): 1.0}}))
after = lm.psf(pupil, 65, 0.5, dtype="float64", method=NijboerZernike())
again = lm.psf(pupil, 65, 0.5, dtype="float64", method=ChordalGauss())
assert lm.peak_error(after, again) <= after.error_bound + again.error_bound
print(late)
"""


@pytest.mark.parametrize("name", CALLS)
def test_ctrl_c_ends_a_call_within_half_a_second_of_work_and_the_next_is_right(name):
    before, call = CALLS[name]
    program = PROGRAM.format(before=before, call=call)
    done = subprocess.run([sys.executable, "-c", program], check=False, capture_output=True, text=True, timeout=120)
    assert done.returncode == 0, done.stderr
    assert float(done.stdout) < 0.5


def test_calls_of_other_threads_go_on():
    """Python runs handlers in its main thread alone; who computes in another is not disturbed."""
    program = PROGRAM.format(
        before="""
found = []
other = threading.Thread(target=lambda: found.append(
    lm.psf(lm.Pupil(lm.Wavefront(np.linspace(1.0, 90.0, 8_000))), 65, 0.5, threads=1).error_bound))
""",
        call="other.start(); time.sleep(60)",
    )
    program += "other.join(); assert found[0] <= 1e-6"
    done = subprocess.run([sys.executable, "-c", program], check=False, capture_output=True, text=True, timeout=120)
    assert done.returncode == 0, done.stderr
