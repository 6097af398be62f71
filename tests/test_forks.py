"""A child that is forked while other threads compute computes as its parent does."""

from __future__ import annotations

import os
import subprocess
import sys

import pytest

PROGRAM = """
import os, signal, threading, time
import numpy as np
import lommel as lm

def ask(i):
    one = lm.Pupil(lm.Wavefront(3.0 + i % 7))
    stack = lm.Pupil(lm.Wavefront(np.linspace(1.0, 9.0, 8) + i % 5))
    coma = lm.Pupil(lm.Wavefront(0.1 * (i % 9), nonradial={(3, 1): 0.5}))
    return [
        lm.psf(one, 31, 0.3 + 0.001 * i).values,
        lm.psf(stack, 9 + i % 11, 0.31).values,
        lm.psf(coma, 9, 0.3 + 0.01 * (i % 50), method=lm.methods.NijboerZernike(1e-4)).values,
        lm.psf(coma, 5 + i % 11, 0.3, method=lm.methods.ChordalGauss(1e-4)).values,
    ]

def busy(seed):
    turns = np.random.default_rng(seed)
    while True:
        ask(int(turns.integers(1000, 4000)))

for seed in range(2):
    threading.Thread(target=busy, args=(seed,), daemon=True).start()
expected = [ask(i) for i in range(100)]
for i in range(100):
    child = os.fork()
    if child == 0:
        signal.alarm(20)
        good = all(np.array_equal(a, b) for a, b in zip(expected[i], ask(i)))
        os._exit(0 if good else 3)
    assert os.waitpid(child, 0)[1] == 0, i
os._exit(0)  # without waiting for those who are busy
"""


@pytest.mark.skipif(not hasattr(os, "fork"), reason="needs fork")
def test_a_hundred_children_of_a_busy_parent_answer_as_it_does():
    done = subprocess.run([sys.executable, "-c", PROGRAM], check=False, capture_output=True, text=True, timeout=300)
    assert done.returncode == 0, done.stderr


FIRST_CALLS = """
import os, signal, sys, threading, time
from importlib import _bootstrap
import lommel as lm
from lommel.base import imports

assert imports._locks is _bootstrap._module_locks

def ask():
    return float(lm.psf(lm.Pupil(lm.Wavefront([1.0, 4.0], spherical=2.0)), 9, 0.31).values.sum())

for _ in range(2):
    threading.Thread(target=ask, daemon=True).start()
children = []
for _ in range(8):
    child = os.fork()
    if child == 0:
        signal.alarm(20)
        os._exit(0 if ask() > 0.0 else 3)
    children.append(child)
    time.sleep(0.006)
print([child for child in children if os.waitpid(child, 0)[1] != 0], flush=True)
os._exit(0)
"""


@pytest.mark.skipif(not hasattr(os, "fork"), reason="needs fork")
def test_children_that_are_forked_during_the_first_call_answer_too():
    command = [sys.executable, "-c", FIRST_CALLS]
    for _ in range(3):  # without what forks wait for, most of these children hang
        done = subprocess.run(command, check=False, capture_output=True, text=True, timeout=300)
        assert (done.returncode, done.stdout) == (0, "[]\n"), done.stderr


IMPORTS = """
import os, sys, threading, time
sys.path.insert(0, sys.argv[1])
import lommel
from lommel.base import imports

begun, go_on = threading.Event(), threading.Event()  # of the import of slow

def fork():
    child = os.fork()
    if child == 0:
        go_on.set()
        sys.stdout.flush()
        import slow
        os._exit(0 if slow.done else 3)
    return child

way = sys.argv[2]
if way == "waits":
    threading.Thread(target=__import__, args=("slow",)).start()
    begun.wait()
    threading.Timer(0.3, go_on.set).start()
    child = fork()
    assert sys.modules["slow"].done
elif way == "patience":  # one that ends too late, which the child begins anew
    imports.PATIENCE = 0.1
    threading.Thread(target=__import__, args=("slow",)).start()
    begun.wait()
    child = fork()
    assert not hasattr(sys.modules["slow"], "done")
    go_on.set()
else:  # one that needs the one that forks
    imports.PATIENCE = 1e9
    threading.Thread(target=lambda: (time.sleep(0.1), __import__("needs"))).start()
    import forking
    child = forking.child
print(os.waitpid(child, 0)[1])
"""
SLOW = "from __main__ import begun, go_on\nbegun.set()\ngo_on.wait()\ndone = True\n"
FORKING = """
import os, sys, time
time.sleep(0.3)
child = os.fork()
if child == 0:
    os._exit(0)
"""


@pytest.mark.skipif(not hasattr(os, "fork"), reason="needs fork")
@pytest.mark.parametrize("way", ["waits", "patience", "imports itself"])
def test_a_fork_waits_for_the_imports_of_other_threads_but_not_for_ever(way, tmp_path):
    (tmp_path / "slow.py").write_text(SLOW)
    (tmp_path / "forking.py").write_text(FORKING)
    (tmp_path / "needs.py").write_text("import forking\n")
    command = [sys.executable, "-c", IMPORTS, str(tmp_path), way]
    done = subprocess.run(command, check=False, capture_output=True, text=True, timeout=60)
    assert (done.returncode, done.stdout) == (0, "0\n"), done.stderr
