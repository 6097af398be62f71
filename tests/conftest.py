"""What every test shares."""

from __future__ import annotations

import os

# Before NumPy is imported. Where other processes have the processors, threads for products of small matrices wait for
# each other four times as long as one takes for all.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import gc
import pickle
import shutil
import signal
import subprocess
import sys
from collections.abc import Callable, Iterator
from itertools import count
from pathlib import Path

import matplotlib as mpl
import pytest
from hypothesis import HealthCheck, Phase, settings

import lommel as lm

pytest_plugins = ["tiers"]
mpl.use("Agg")

# Nothing that is collected (tests, their modules, the libraries that these import) goes before the end: to look for
# garbage among it takes as long as to collect it.
gc.disable()

# Files that tests write need not outlive a power failure, and disks that are busy take long to make sure of that.
os.fsync = lambda descriptor: None

# A shell starts what it runs in the background deaf to Ctrl-C, and nohup deaf to the end of the terminal: so would be
# what the tests start and interrupt.
for ignored, handler in ((signal.SIGINT, signal.default_int_handler), (signal.SIGHUP, signal.SIG_DFL)):
    if signal.getsignal(ignored) is signal.SIG_IGN:
        signal.signal(ignored, handler)

# No deadline: shared machines stall. Searches have the same cases in every run, except for `pytest --thorough`, whose
# finds become examples of their tests. HYPOTHESIS_PROFILE=thorough searches longer.
settings.register_profile(
    "quick", deadline=None, max_examples=40, derandomize=True, suppress_health_check=[HealthCheck.too_slow]
)
settings.register_profile("random", settings.get_profile("quick"), derandomize=False)
settings.register_profile("thorough", deadline=None, max_examples=1000)
# Where it only matters whether a test fails (tests/mutants).
settings.register_profile("brief", settings.get_profile("quick"), phases=[Phase.explicit, Phase.generate])
settings.load_profile(os.environ.get("HYPOTHESIS_PROFILE", "quick"))

ROOT = Path(__file__).resolve().parent.parent
TERMINAL = ("FORCE_COLOR", "TTY_COMPATIBLE", "TTY_INTERACTIVE", "NO_COLOR", "COLUMNS", "LINES")
MEMORY = 800 * 2**20  # bytes, in a process that runs tests
RESIDENT = {"after": 0}
FOLDERS = count()
DESCRIBED: dict[bytes, object] = {}
LENSES = sorted((ROOT / "examples" / "lenses").glob("*.toml"))


@pytest.hookimpl(tryfirst=True)
def pytest_runtestloop() -> None:
    """Look for garbage, but among what the tests make alone."""
    gc.freeze()
    gc.enable()


@pytest.fixture(autouse=True)
def own_folder(tmp_path_factory: pytest.TempPathFactory) -> Iterator[None]:
    """Run each test in an empty folder, so that no relative path, "../.." included, is one of the repository."""
    folder = tmp_path_factory.getbasetemp() / "own" / "folders" / str(next(FOLDERS))
    folder.mkdir(parents=True)
    os.chdir(folder)
    yield
    os.chdir(ROOT)
    try:
        folder.rmdir()
    except OSError:
        shutil.rmtree(folder, ignore_errors=True)


@pytest.fixture(params=LENSES, ids=lambda path: path.stem)
def lens_file(request: pytest.FixtureRequest) -> Path:
    """Each lens file of the examples."""
    return request.param


@pytest.fixture(scope="session")
def lenses() -> dict[str, Path]:
    """The lens files of the examples by name."""
    return {path.stem: path for path in LENSES}


@pytest.fixture(scope="session")
def camera() -> lm.Lens:
    """A 50 mm f/1.8 camera lens, focused at 2 m."""
    return lm.Lens(focal_length=50e-3, f_number=1.8, focus_distance=2.0, wavelength=550e-9)


@pytest.fixture(scope="session")
def run_lommel() -> Callable[..., subprocess.CompletedProcess[str]]:
    """Run the installed `lommel` as a user does, with warnings as errors and a pipe for a terminal."""
    script = Path(sys.executable).with_name("lommel")
    environment = {name: value for name, value in os.environ.items() if name not in TERMINAL}
    environment |= {"PYTHONWARNINGS": "error", "PYTHONUTF8": "1"}

    def run(*arguments: object, folder: Path) -> subprocess.CompletedProcess[str]:
        command = [str(script), *map(str, arguments)]
        return subprocess.run(
            command, cwd=folder, env=environment, capture_output=True, encoding="utf-8", timeout=300, check=False
        )

    return run


@pytest.fixture
def call_lommel(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> Callable[..., subprocess.CompletedProcess[str]]:
    """Do what the installed `lommel` does, in this process, which is a hundred times as fast."""
    from lommel.cli.main import main

    for name in TERMINAL:
        monkeypatch.delenv(name, raising=False)

    def call(*arguments: object, folder: Path) -> subprocess.CompletedProcess[str]:
        monkeypatch.chdir(folder)
        with pytest.raises(SystemExit) as ended:
            main([str(part) for part in arguments])
        shown = capsys.readouterr()
        return subprocess.CompletedProcess(["lommel", *arguments], ended.value.code, shown.out, shown.err)

    return call


@pytest.fixture
def described_once(monkeypatch: pytest.MonkeyPatch) -> None:
    """Have `lommel info` compute what it says of a lens once, for its tables and its JSON."""
    from lommel.report import optics

    describe = optics.describe_lens

    def kept(instrument: object) -> object:
        key = pickle.dumps(instrument)
        if key not in DESCRIBED:
            DESCRIBED[key] = describe(instrument)
        return DESCRIBED[key]

    monkeypatch.setattr(optics, "describe_lens", kept)


@pytest.fixture(autouse=True)
def little_memory() -> Iterator[None]:
    """Free what packages keep, and cycles of large arrays, where a process has grown past `MEMORY`."""
    yield
    # What is left after that, such as compiled code, is not looked for again at once.
    if resident() > max(MEMORY, RESIDENT["after"] + MEMORY // 6):
        if "jax" in sys.modules:
            sys.modules["jax"].clear_caches()
        gc.collect()
        lm.clear_caches()
        RESIDENT["after"] = resident()


def resident() -> int:
    """Return the bytes of memory of this process, where the system tells them."""
    told = Path("/proc/self/statm")
    return int(told.read_text(encoding="ascii").split()[1]) * os.sysconf("SC_PAGE_SIZE") if told.exists() else 0


@pytest.fixture(autouse=True)
def close_figures() -> Iterator[None]:
    """Close the figures that a test left open."""
    yield
    if "matplotlib.pyplot" in sys.modules:
        sys.modules["matplotlib.pyplot"].close("all")
