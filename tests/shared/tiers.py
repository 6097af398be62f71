"""Two tiers of tests, as options of pytest: ``--quick`` for each change, ``--thorough`` nightly and before a release.

`tests/slow_tests.txt` lists the tests that take more than `SLOW` seconds of a processor. ``--quick`` leaves them out,
except for a few that the hash of the commit draws: the same ones in each run of a commit, others in the next commit.
``--slow`` runs those that ``--quick`` leaves out. ``--thorough`` runs all tests and seeds random searches anew, by a
seed that it prints and that ``--thorough SEED`` takes. ``--measure`` writes the list; ``--quick --measure`` after it
adds tests that pay for what slow tests prepared, such as a fixture of their module. In ``--quick`` a test that is not
listed and takes more than `TOO_SLOW` times `SLOW`, twice in succession, fails.
"""

from __future__ import annotations

import ast
import hashlib
import os
import random
import re
import subprocess
import time
from collections import defaultdict
from collections.abc import Iterator
from functools import cache
from importlib import import_module
from pathlib import Path

import pytest
from hypothesis import settings

ROOT = Path(__file__).resolve().parents[2]
LIST = ROOT / "tests" / "slow_tests.txt"
SLOW = 0.15  # seconds of a processor
TOO_SLOW = 4.0  # in units of SLOW
DRAWN = 0.01  # the share of slow tests that is in the quick tier
# Whatever each test takes: the live page needs a browser.
ELSEWHERE = ("tests/live/",)
# Their first import is no cost of the test that happens to come first.
COMMON = ("astropy.io.fits", "cyclopts", "dask.array", "h5py", "jax.numpy", "matplotlib.pyplot", "pydantic")
HEADER = """# Tests that take more than 0.15 s of a processor, with the seconds that they took; a function stands for
# all of its cases. Written by `pytest --measure`; see tests/shared/tiers.py. Its loop took {:.1f} ms.
"""


def pytest_addoption(parser: pytest.Parser) -> None:
    """Add the options of both tiers."""
    group = parser.getgroup("tiers")
    group.addoption("--quick", action="store_true", help="leave out the tests of tests/slow_tests.txt, but for a few")
    group.addoption("--slow", action="store_true", help="run what --quick leaves out alone")
    group.addoption(
        "--thorough",
        nargs="?",
        type=int,
        const=-1,
        metavar="SEED",
        help="search at random, from a seed that is printed",
    )
    group.addoption("--measure", action="store_true", help="write the costs of tests to tests/slow_tests.txt")


@pytest.hookimpl(tryfirst=True)
def pytest_configure(config: pytest.Config) -> None:
    """Choose how random searches are seeded, before Hypothesis looks at its options."""
    for marker in (
        "quick: is of the quick tier, whatever it takes: it alone notices what it tests",
        "theorem: checks mathematics of the certificate that no line of the package computes",
        "drawn(each): the quick tier has one case, which the commit draws, for each value of the parameter `each`",
    ):
        config.addinivalue_line("markers", marker)
    if config.option.thorough is not None:
        if config.option.thorough < 0:  # in the first process only: those of pytest-xdist are handed its options
            config.option.thorough = random.SystemRandom().randrange(2**32)
        config.option.hypothesis_seed = config.option.thorough
        settings.load_profile(os.environ.get("HYPOTHESIS_PROFILE", "random"))
    if config.option.measure:
        config.pluginmanager.register(Costs(), "costs")
    elif config.option.quick:
        config.pluginmanager.register(Limit(), "limit")


def pytest_report_header(config: pytest.Config) -> list[str]:
    """Say which tests run, and the seed to find a failure with again."""
    told = []
    if config.option.quick:
        told += [f"quick tests, and some of the {len(slow_tests())} slow ones in {LIST.name}, drawn by {commit()}"]
    if config.option.thorough is not None:
        told += [f"random search: repeat it by --thorough {config.option.thorough}"]
    return told


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Leave out the tests of the other tier."""
    if config.option.quick != config.option.slow:
        share = 0.0 if config.option.measure else DRAWN
        drawn = drawn_cases(items)
        kept, left = [], []
        for item in items:
            quick = item in drawn if item.get_closest_marker("drawn") else is_quick(item, share)
            (kept if quick == config.option.quick else left).append(item)
        config.hook.pytest_deselected(items=left)
        items[:] = kept


def is_quick(test: pytest.Item, share: float) -> bool:
    """Return whether a test is of the quick tier: not listed, or of the `share` of listed ones that is drawn."""
    name = test.nodeid
    if name.startswith(ELSEWHERE) or test.get_closest_marker("theorem"):
        return False
    if test.get_closest_marker("quick"):
        return True
    return chance(name) < share or not {name, name.partition("[")[0]} & slow_tests().keys()


def chance(name: str) -> float:
    """Return a number from 0 to 1 that the commit draws for a test."""
    return int.from_bytes(hashlib.sha256(f"{commit()} {name}".encode()).digest()[:8]) / 2**64


def drawn_cases(items: list[pytest.Item]) -> set[pytest.Item]:
    """Return the cases of tests with the marker `drawn` that are of the quick tier."""
    groups = defaultdict(list)
    for item in items:
        if marker := item.get_closest_marker("drawn"):
            values = [item.callspec.params[name] for name in marker.args]
            groups[item.nodeid.partition("[")[0], *values].append(item)
    return {min(group, key=lambda item: chance(item.nodeid)) for group in groups.values()}


@cache
def slow_tests() -> dict[str, float]:
    """Return the list: names of tests or of functions, each with its seconds."""
    lines = LIST.read_text(encoding="utf-8").splitlines() if LIST.exists() else []
    rows = (line.split(maxsplit=1) for line in lines if line and not line.startswith("#"))
    return {name: float(cost) for cost, name in rows}


@cache
def loop_listed() -> float:
    """Return the milliseconds of `loop` where the list was measured."""
    found = re.search(r"loop took ([\d.]+) ms", LIST.read_text(encoding="utf-8")) if LIST.exists() else None
    return float(found[1]) if found else loop()


def loop() -> float:
    """Return the milliseconds of a processor that a loop in Python takes, the least of several."""
    costs = []
    for _ in range(5):
        start = time.process_time()
        sum(k % 7 for k in range(200_000))
        costs.append(1e3 * (time.process_time() - start))
    return min(costs)


@cache
def commit() -> str:
    """Return the hash of the commit that is checked out; sources without one have their own name."""
    asked = ["git", "rev-parse", "--short=12", "HEAD"]
    try:
        done = subprocess.run(asked, cwd=ROOT, capture_output=True, text=True, check=True)
    except (OSError, subprocess.CalledProcessError):
        return "no commit"
    return done.stdout.strip()


class Costs:
    """Measures the tests that run, and writes the list of slow ones."""

    def __init__(self) -> None:
        self.measured: dict[str, float] = {}
        self.start = 0.0

    def pytest_runtestloop(self) -> None:
        """Import what many tests use, so that it is no cost of the first."""
        for name in COMMON:
            import_module(name)

    @pytest.hookimpl(wrapper=True, tryfirst=True)
    def pytest_runtest_setup(self) -> Iterator[None]:
        """Note the time of processors before a test and what it uses."""
        self.start = processor_time()
        return (yield)

    @pytest.hookimpl(wrapper=True)
    def pytest_runtest_makereport(self, item: pytest.Item, call: pytest.CallInfo[None]) -> Iterator[None]:
        """Hand the cost of a test to the first process, as a property of its last report."""
        if call.when == "teardown" and not item.get_closest_marker("drawn"):
            item.user_properties.append(("cost", processor_time() - self.start))
        return (yield)

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        """Collect the costs of tests, in whatever process they ran."""
        if report.when == "teardown" and (cost := dict(report.user_properties).get("cost")) is not None:
            self.measured[report.nodeid] = cost

    def pytest_sessionfinish(self, session: pytest.Session) -> None:
        """Write the list, in the first process."""
        if not hasattr(session.config, "workerinput"):
            whole = session.config.args_source is pytest.Config.ArgsSource.TESTPATHS
            text = HEADER.format(loop() if whole else loop_listed()) + "".join(lines(self.measured, slow_tests()))
            LIST.write_text(text, encoding="utf-8")


class Limit:
    """Fails quick tests that are slow and not listed, in units of the speed of the processor."""

    def __init__(self) -> None:
        self.seconds = TOO_SLOW * SLOW * max(1.0, loop() / loop_listed())

    @pytest.hookimpl(wrapper=True)
    def pytest_pyfunc_call(self, pyfuncitem: pytest.Function) -> Iterator[object]:
        """Call a test that takes too long once more, as its fixtures and caches are then there, and fail it then."""
        start = processor_time()
        done = yield
        first = processor_time() - start
        exempt = any(map(pyfuncitem.get_closest_marker, ("quick", "drawn")))
        if first > self.seconds and not exempt and is_quick(pyfuncitem, 0.0):
            start = processor_time()
            try:
                pyfuncitem.obj(**{name: pyfuncitem.funcargs[name] for name in pyfuncitem._fixtureinfo.argnames})
            except (Exception, SystemExit, pytest.fail.Exception, pytest.skip.Exception):
                return done  # it changes what it finds, such as files
            second = processor_time() - start
            if second > self.seconds:
                said = f"takes {first:.1f} and {second:.1f} s of a processor and is not in {LIST.name}: "
                said += "make it quicker, or add it by .venv/bin/pytest --quick --measure FILE"
                pytest.fail(said, pytrace=False)
        return done


def processor_time() -> float:
    """Return the seconds of processors that this process and its children that ended have taken."""
    used = os.times()
    return time.process_time() + used.children_user + used.children_system


def lines(measured: dict[str, float], before: dict[str, float]) -> list[str]:
    """Return the lines of the list: of measured tests, and of listed ones that did not run but are there."""
    cases = defaultdict(list)
    for test in measured:
        cases[test.partition("[")[0]].append(test)
    slow = {
        name: cost for name, cost in before.items() if name not in measured and name not in cases and is_there(name)
    }
    for function, tests in cases.items():
        costs = {test: round(measured[test], 2) for test in tests if measured[test] > SLOW}
        if len(costs) == len(tests) > 1:
            slow[function] = round(sum(costs.values()) / len(costs), 2)
        else:
            slow |= costs
    return [f"{cost:6.2f} {name}\n" for name, cost in sorted(slow.items())]


def is_there(name: str) -> bool:
    """Return whether the file of a test has its function."""
    file, _, function = name.partition("[")[0].partition("::")
    return function.rpartition("::")[2] in functions(file)


@cache
def functions(file: str) -> frozenset[str]:
    """Return the names of the functions in a file of tests."""
    path = ROOT / file
    tree = ast.parse(path.read_text(encoding="utf-8")) if path.is_file() else ast.Module([], [])
    return frozenset(node.name for node in ast.walk(tree) if isinstance(node, ast.FunctionDef))
