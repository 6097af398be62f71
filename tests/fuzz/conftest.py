"""What the fuzzers share: cases run in processes of their own, with little time and memory each.

`make fuzz` runs all of them, LOMMEL_FUZZ=1 of the environment; the tests a seeded sample.
"""

from __future__ import annotations

import json
import os
import resource
import signal
import sys
import traceback
import warnings
from collections.abc import Callable
from pathlib import Path

import pytest

FULL = os.environ.get("LOMMEL_FUZZ") == "1"


@pytest.fixture
def count() -> Callable[[int, int], int]:
    """How many cases: few in a test, all in `make fuzz`."""
    return lambda few, all_of_them: all_of_them if FULL else few


@pytest.fixture
def hunt() -> Callable[..., list[str]]:
    """Run ``case(k)``, which returns a finding or None, for k below `count`, and return all findings."""

    def run(case: Callable[[int], str | None], count: int, *, seconds: int = 20, memory: int = 2**31) -> list[str]:
        findings, first = [], 0
        while first < count:
            ended, found = _batch(case, first, count, seconds, memory)
            findings += found
            if ended < count:
                findings.append(f"case {ended}: it took more than {seconds} s, or ended the process")
            first = ended + 1
            if len(findings) > 1000:
                break
        return findings

    return run


def _batch(case, first, count, seconds, memory):
    """Run cases in a child, which is killed where one takes too long; return the first not run, and the findings."""
    read, write = os.pipe()
    with warnings.catch_warnings():
        # Libraries that other tests have started warn of their threads; a child that reads files needs none of these.
        warnings.simplefilter("ignore")
        child = os.fork()
    if child == 0:
        try:
            os.close(read)
            limit = int(Path("/proc/self/statm").read_text().split()[0]) * resource.getpagesize() + memory
            resource.setrlimit(resource.RLIMIT_AS, (limit, limit))
            signal.signal(signal.SIGALRM, signal.SIG_DFL)
            with os.fdopen(write, "w") as out:
                for k in range(first, count):
                    print(json.dumps({"at": k}), file=out, flush=True)
                    signal.alarm(seconds)
                    try:
                        found = case(k)
                    except BaseException:
                        found = f"the fuzzer itself: {traceback.format_exc()}"
                    signal.alarm(0)
                    if found:
                        print(json.dumps({"found": f"case {k}: {found}"}), file=out, flush=True)
                print(json.dumps({"at": count}), file=out, flush=True)
        finally:
            sys.stderr.flush()
            os._exit(0)
    os.close(write)
    at, found = first, []
    with os.fdopen(read) as lines:
        for line in lines:
            said = json.loads(line)
            at = said.get("at", at)
            found += [said["found"]] if "found" in said else []
    os.waitpid(child, 0)
    return at, found
