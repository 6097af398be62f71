"""What it takes from a fresh clone to a first picture, and from an edit to a passing test: ``make setup-times``.

The commit that is checked out, or ``--commit``, is cloned into a temporary folder, and `make psf` runs there step by
step, with no package in any cache. Two commits are compared by seconds of processors. A figure over its limit is
marked. The exit status is 1 if a count or a size is over, or a time although nothing else ran on the machine when the
measurement began.
"""

from __future__ import annotations

import argparse
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).resolve().parent.parent
# Runs a compiler and appends what it took to a file; small, for it starts once for each file that is compiled.
LAUNCHER = """
import os, sys
log, *command = sys.argv[1:]
_, status, used = os.wait4(os.posix_spawn(command[0], command, os.environ), 0)
with open(log, "a") as out:
    out.write(f"{used.ru_utime + used.ru_stime} {used.ru_maxrss} {command[-1]}\\n")
sys.exit(abs(os.waitstatus_to_exitcode(status)))
"""
# The binding that is edited, and the tests of its subject.
EDITED, SUBJECT = "cpp/bindings/special.cpp", "tests/special/test_bessel.py"


class Cost(NamedTuple):
    """What a command took, with all that it started: seconds by the clock and of processors."""

    wall: float
    cpu: float


class Unit(NamedTuple):
    """What compiling one file took: seconds of a processor, bytes of memory."""

    cpu: float
    memory: int
    source: str


class Figure(NamedTuple):
    """A line of the table; of one that is timed a busy machine may make anything."""

    name: str
    value: float
    limit: float
    unit: str
    timed: bool = True

    def __str__(self) -> str:
        value = f"{self.value:.0f}" if self.unit == "" else f"{self.value:.1f}"
        return f"{self.name:45}{value:>8}{self.limit:>8g} {self.unit:3}{'  over' if self.over else ''}".rstrip()

    @property
    def over(self) -> bool:
        """Whether the limit is exceeded."""
        return self.value > self.limit


class Clone:
    """A clone of its own, and what runs in it with empty caches."""

    def __init__(self, place: Path, commit: str) -> None:
        self.root, self.log, self.compiled = place / "lommel", place / "log", place / "compiled"
        self.compiled.touch()
        launcher = place / "launcher.py"
        launcher.write_text(LAUNCHER, encoding="utf-8")
        cold = {"UV_CACHE_DIR": str(place / "cache"), "PIP_NO_CACHE_DIR": "1", "CCACHE_DISABLE": "1"}
        launched = ";".join([sys.executable, "-IS", str(launcher), str(self.compiled)])
        self.environment = os.environ | cold | {"CMAKE_CXX_COMPILER_LAUNCHER": launched}
        # It would have each test read and rewrite the modules of its plugins anew.
        self.environment.pop("PYTHONDONTWRITEBYTECODE", None)
        subprocess.run(["git", "clone", "--quiet", "--no-checkout", ROOT, self.root], check=True)
        # By its hash, for what is named in one clone need not be in another.
        name = ["git", "rev-parse", "--verify", f"{commit}^{{commit}}"]
        found = subprocess.run(name, cwd=ROOT, check=True, capture_output=True, text=True).stdout.strip()
        subprocess.run(["git", "checkout", "--quiet", "--detach", found], cwd=self.root, check=True)

    def run(self, *command: str) -> Cost:
        """Return what a command took, or end with what it wrote if it fails."""
        print(*command, flush=True)
        start = time.perf_counter()
        with self.log.open("w") as log:
            process = subprocess.Popen(
                command, cwd=self.root, env=self.environment, stdout=log, stderr=subprocess.STDOUT
            )
            _, status, used = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        if process.returncode:
            sys.exit(f"{self.log.read_text(errors='replace')}\n{' '.join(command)} failed")
        return Cost(time.perf_counter() - start, used.ru_utime + used.ru_stime)

    def packages(self) -> int:
        """Return how many packages are in the environment beside this one."""
        found = {
            path.name.partition("-")[0] for path in self.root.glob(".venv/lib/python*/site-packages/*.dist-info")
        }
        return len(found - {"lommel"})

    def megabytes(self) -> float:
        """Return the size of all that is installed."""
        paths = [path for folder in (".venv", ".tools") for path in (self.root / folder).rglob("*")]
        return sum(path.lstat().st_blocks * 512 for path in paths) / 1e6

    def module(self) -> Path:
        """Return the path of the compiled module."""
        (found,) = self.root.glob(".venv/lib/python*/site-packages/lommel/_core*")
        return found

    def units(self) -> list[Unit]:
        """Return what was compiled of the project's own, the longest first."""
        scale = 1 if sys.platform == "darwin" else 1024
        own = f"{self.root / 'cpp'}/"
        units = []
        for line in self.compiled.read_text(encoding="utf-8").splitlines():
            cpu, memory, source = line.split(maxsplit=2)
            if source.startswith(own):
                units.append(Unit(float(cpu), int(memory) * scale, source.removeprefix(own)))
        return sorted(units, reverse=True)


def measure(clone: Clone) -> list[Figure]:
    """Print what each step takes, and return the figures that have a limit."""
    steps = {
        "uv": clone.run("make", "uv"),
        "packages": clone.run("make", ".venv/first.stamp"),
        "compile": clone.run("make", "build"),
    }
    units, packages, megabytes = clone.units(), clone.packages(), clone.megabytes()
    steps["picture"] = clone.run("make", "psf")
    steps["the rest of the packages"] = clone.run("make", "env")
    clone.run(".venv/bin/pytest", SUBJECT)  # Python compiles what it imports the first time
    with (clone.root / EDITED).open("a", encoding="utf-8") as source:
        source.write("// edited\n")
    steps[f"edit {EDITED}: make build"] = clone.run("make", "build")
    steps[f"pytest {SUBJECT}"] = clone.run(".venv/bin/pytest", SUBJECT)

    print(f"\n{'':45}{'wall, s':>8}{'CPU, s':>8}")
    for name, cost in steps.items():
        print(f"{name:45}{cost.wall:8.1f}{cost.cpu:8.1f}")
    print(f"\n{'compiled':45}{'CPU, s':>8}{'MB':>8}")
    for unit in units:
        print(f"{unit.source:45}{unit.cpu:8.1f}{unit.memory / 1e6:8.0f}")
    everything = f"{clone.megabytes():.0f} MB in {clone.packages()} packages"
    print(
        f"\ninstalled before the first picture: {megabytes:.0f} MB in {packages} packages; in the end {everything}\n"
    )

    *first, _, build, test = steps.values()
    return [
        Figure("make psf, wall", sum(cost.wall for cost in first), 100, "s"),
        Figure("make psf, CPU", sum(cost.cpu for cost in first), 200, "s"),
        Figure("longest unit, CPU", max(unit.cpu for unit in units), 40, "s"),
        Figure("memory of a compiler", max(unit.memory for unit in units) / 1e6, 600, "MB", timed=False),
        Figure("packages before the first picture", packages, 25, "", timed=False),
        Figure("module", clone.module().stat().st_size / 1e6, 4, "MB", timed=False),
        Figure("edit to passing test, wall", build.wall + test.wall, 10, "s"),
    ]


def main() -> None:
    """Measure and judge."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--test", action="store_true", help="time make test as well")
    parser.add_argument("--commit", default="HEAD", help="the commit to measure")
    options = parser.parse_args()
    busy = os.getloadavg()[0] / (os.cpu_count() or 1) > 0.25
    changed = subprocess.run(["git", "diff", "--quiet", "HEAD"], cwd=ROOT, check=False).returncode
    if changed and options.commit == "HEAD":
        print("What is not committed is left out.")
    with tempfile.TemporaryDirectory() as place:
        clone = Clone(Path(place), options.commit)
        figures = measure(clone)
        print(f"{'':45}{'':8}{'limit':>8}", *figures, sep="\n")
        if busy:
            print("The machine was busy: seconds are those of a quiet one at the least.")
        if options.test:
            cost = clone.run("make", "test")
            print(f"{'make test':45}{cost.wall:8.1f} s, of processors {cost.cpu:.1f} s")
    if any(figure.over and not (busy and figure.timed) for figure in figures):
        sys.exit(1)


if __name__ == "__main__":
    main()
