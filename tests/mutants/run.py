"""Deliberate faults, one at a time, against the tests: `make mutants`, or `make mutants ONLY="ellipse psf.py:2"`.

The faults are in cpp.toml and python.toml beside this file: for each file of the project the tests of its subject and
a list of (old, new), old occurring once. Nothing is changed but copies below build/mutants. Those in C++ are compiled
together into one build, `(lommel_mutant(k) ? new : old)`, and chosen by the environment; those in Python are written
into a copy of src. For each the tests of its subject run first, and where these pass the rest of the suite. A fault
that nothing notices must be argued in its list; fewer than 95 % noticed is a failure.
"""

from __future__ import annotations

import argparse
import itertools
import os
import queue
import re
import shutil
import signal
import subprocess
import sys
import threading
import time
import tomllib
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
LISTS = [Path(__file__).with_name(name) for name in ("cpp.toml", "python.toml")]
PLACE = ROOT / "build" / "mutants"
SWITCH = """#pragma once
#include <cstdlib>
inline int lommel_mutant_chosen() { const char* k = std::getenv("LOMMEL_MUTANT"); return k ? std::atoi(k) : 0; }
inline const int lommel_mutant_on = lommel_mutant_chosen();
inline bool lommel_mutant(int k) { return lommel_mutant_on == k; }
"""
NOTICED = 0.95


@dataclass(frozen=True)
class Fault:
    """One fault: where it is, what it replaces by what, the tests of its subject, and why nobody need notice it."""

    number: int
    name: str
    file: str
    old: str
    new: str
    tests: tuple[str, ...]
    argued: str

    @property
    def compiled(self) -> bool:
        """Whether it is chosen at run time."""
        return self.file.startswith("cpp/")


def load() -> list[Fault]:
    """Return all faults of the lists."""
    faults: list[Fault] = []
    for listing in LISTS:
        for file, entry in tomllib.loads(listing.read_text(encoding="utf-8")).items():
            for place, (old, new, *more) in enumerate(entry["faults"], 1):
                extra = more[0] if more else {}
                tests = tuple(extra.get("tests", entry["tests"]))
                name = f"{Path(file).parent.name}/{Path(file).name}:{place}"
                faults.append(Fault(len(faults) + 1, name, file, old, new, tests, extra.get("argued", "")))
    return faults


def misfits(faults: list[Fault]) -> list[str]:
    """Return what is wrong: patterns that are not in their file once, overlaps, tests that are not there."""
    wrong = []
    for fault in faults:
        path = ROOT / fault.file
        count = path.read_text(encoding="utf-8").count(fault.old) if path.exists() else 0
        if count != 1 or fault.old == fault.new:
            wrong.append(f"{fault.name}: {fault.old!r} is {count} times in {fault.file}")
        if fault.compiled and fault.old.startswith(("+ ", "- ", "* ", "/ ", "&& ", "|| ")):
            wrong.append(f"{fault.name}: {fault.old!r} is no expression that a switch could stand for")
        wrong += [f"{fault.name}: no {test}" for test in fault.tests if not (ROOT / test.split("::")[0]).exists()]
    if not wrong:
        for file in sorted({f.file for f in faults if f.compiled}):
            spans = sorted(_spans([f for f in faults if f.file == file], (ROOT / file).read_text(encoding="utf-8")))
            wrong += [f"{file}: faults overlap at {b!r}" for a, b in itertools.pairwise(spans) if b[0] < a[1]]
    return wrong


def _spans(faults: list[Fault], text: str) -> dict[tuple[int, int], list[Fault]]:
    spans: dict[tuple[int, int], list[Fault]] = {}
    for fault in faults:
        start = text.index(fault.old)
        spans.setdefault((start, start + len(fault.old)), []).append(fault)
    return spans


def switched(text: str, faults: list[Fault]) -> str:
    """Return C++ with every fault behind its switch."""
    for (start, end), here in sorted(_spans(faults, text).items(), reverse=True):
        made = text[start:end]
        for fault in here:
            if fault.old.endswith(";"):
                made = f"if (lommel_mutant({fault.number})) {{ {fault.new} }} else {{ {made} }}"
            else:
                made = f"(lommel_mutant({fault.number}) ? ({fault.new}) : ({made}))"
        text = text[:start] + made + text[end:]
    return text


def write(path: Path, content: bytes) -> None:
    """Write what differs, so that the compiler sees what changed."""
    if not path.exists() or path.read_bytes() != content:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)


def compiled(faults: list[Fault]) -> Path:
    """Build the core with every fault in it; return the folder that it is in."""
    source, build = PLACE / "cpp", PLACE / "cmake"
    by_file = {file: [f for f in faults if f.file == file] for file in {f.file for f in faults}}
    needed = ("CMakeLists.txt", "pyproject.toml", "cmake/*", "cpp/**/*.[ch]pp")
    for path in itertools.chain.from_iterable(ROOT.glob(pattern) for pattern in needed):
        name = path.relative_to(ROOT).as_posix()
        text = path.read_text(encoding="utf-8")
        write(source / name, switched(text, by_file.get(name, [])).encode())
    write(source / "switch.hpp", SWITCH.encode())
    tools = Path(sys.executable).parent
    configure = [tools / "cmake", "-S", source, "-B", build, "-G", "Ninja", f"-DCMAKE_MAKE_PROGRAM={tools / 'ninja'}"]
    configure += [f"-DPython_EXECUTABLE={sys.executable}", "-DCMAKE_BUILD_TYPE=Release", "-DLOMMEL_PYTHON=ON"]
    configure += [f"-DCMAKE_CXX_FLAGS=-include {source / 'switch.hpp'}"]
    for command in (configure, [tools / "cmake", "--build", build]):
        done = subprocess.run([str(part) for part in command], capture_output=True, encoding="utf-8", check=False)
        if done.returncode:
            sys.exit(f"the faults in C++ do not compile:\n{done.stdout[-6000:]}{done.stderr[-2000:]}")
    return build


class Workplace:
    """A copy of the tree, and an environment that imports it and what the project's own environment has."""

    def __init__(self, number: int, build: Path) -> None:
        self.tree, venv = PLACE / f"tree{number}", PLACE / f"venv{number}"
        shutil.rmtree(self.tree, ignore_errors=True)
        listing = ["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"]
        names = subprocess.run(listing, cwd=ROOT, capture_output=True, check=True).stdout.decode().split("\0")
        for name in filter(None, names):
            if (ROOT / name).is_file():
                (self.tree / name).parent.mkdir(parents=True, exist_ok=True)
                shutil.copyfile(ROOT / name, self.tree / name)
        for module in build.glob("_core*"):
            shutil.copy(module, self.tree / "src" / "lommel")
        subprocess.run([sys.executable, "-m", "venv", "--clear", "--without-pip", venv], check=True)
        inside = Path(next(p for p in sys.path if p.endswith("site-packages")))
        packages = venv / inside.relative_to(sys.prefix)
        # The packages of .venv are there, but not its hook that imports the project from its own folder.
        (packages / "shared.pth").write_text(f"{self.tree / 'src'}\n{inside}\n")
        self.python, script = venv / "bin" / "python", venv / "bin" / "lommel"
        for tool in ("cmake", "ninja"):
            (venv / "bin" / tool).symlink_to(Path(sys.executable).with_name(tool))
        script.write_text(f"#!{self.python}\nimport sys\nfrom lommel.cli.main import main\nsys.exit(main())\n")
        script.chmod(0o755)

    def pytest(self, number: int, tests: tuple[str, ...], limit: float) -> str:
        """Return which test fails first, or "" if all pass."""
        command = [self.python, "-m", "pytest", "-x", "-q", "-p", "no:cacheprovider", "--hypothesis-seed=0"]
        command += ["--ignore=tests/test_mutants.py", *tests]
        environment = os.environ | {"LOMMEL_MUTANT": str(number), "HYPOTHESIS_PROFILE": "brief"}
        running = subprocess.Popen(
            [str(part) for part in command], cwd=self.tree, env=environment, encoding="utf-8", errors="replace",
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, start_new_session=True,
        )  # fmt: skip
        try:
            out = running.communicate(timeout=limit)[0]
        except subprocess.TimeoutExpired:
            os.killpg(running.pid, signal.SIGKILL)
            running.communicate()
            return f"not done after {limit:.0f} s"
        if running.returncode == 0:
            return ""
        if running.returncode > 2:
            sys.exit(f"pytest did not run {tests}:\n{out[-3000:]}")
        failed = re.search(r"^(?:FAILED|ERROR) (\S+)", out, re.MULTILINE)
        return failed[1] if failed else f"ended by {running.returncode}: {out[-200:]!r}"

    def judge(self, fault: Fault, tests: tuple[str, ...], limit: float) -> str:
        """Return which test notices a fault, or ""."""
        path, number = self.tree / fault.file, fault.number if fault.compiled else 0
        before = path.read_text(encoding="utf-8")
        if not fault.compiled:
            path.write_text(before.replace(fault.old, fault.new), encoding="utf-8")
        try:
            return self.pytest(number, tests, limit)
        finally:
            path.write_text(before, encoding="utf-8")


def main() -> None:
    """Judge the faults that are named, or all."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("only", nargs="*", help="names, or parts of names, of faults (file.py:3)")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    parser.add_argument("--subject", action="store_true", help="run the tests of the subject only")
    parser.add_argument(
        "--trust", action="store_true", help="do not first make sure that the tests pass without a fault"
    )
    given = parser.parse_args()
    faults = load()
    if wrong := misfits(faults):
        sys.exit("\n".join(wrong))
    chosen = [
        f
        for f in faults
        if not given.only or any(f"/{f.name}".endswith(f"/{o}") or (":" not in o and o in f.name) for o in given.only)
    ]
    build = compiled([f for f in faults if f.compiled])
    idle: queue.SimpleQueue[Workplace] = queue.SimpleQueue()
    for number in range(min(given.jobs, len(chosen))):
        idle.put(Workplace(number, build))

    def make_sure(workplace: Workplace, *tests: str) -> None:
        # Tests that fail anyway would notice every fault.
        if not given.trust and (found := workplace.pytest(0, tests, 7200)):
            sys.exit(f"without a fault there is one already: {found}")

    first = idle.get()
    make_sure(first, *sorted({test for f in chosen for test in f.tests}))
    idle.put(first)
    lock, sure = threading.Lock(), []

    def judge(fault: Fault) -> tuple[Fault, str]:
        workplace, start = idle.get(), time.monotonic()
        try:
            found = workplace.judge(fault, fault.tests, 1200)
            if not found and not given.subject:
                with lock:
                    if not sure:
                        make_sure(workplace, "tests")
                        sure.append(True)
                found = workplace.judge(fault, ("tests",), 7200)
        finally:
            idle.put(workplace)
        said = found or (f"NOT NOTICED, argued: {fault.argued}" if fault.argued else "NOT NOTICED")
        print(f"{fault.name:36} {time.monotonic() - start:6.1f} s  {said}", flush=True)
        return fault, found

    start = time.monotonic()
    with ThreadPoolExecutor(given.jobs) as pool:
        results = list(pool.map(judge, chosen))
    missed = [fault for fault, found in results if not found]
    share = 1.0 - len(missed) / max(1, len(chosen))
    print(f"\n{len(chosen) - len(missed)} of {len(chosen)} noticed ({share:.1%}) in {time.monotonic() - start:.0f} s")
    for fault in missed:
        print(f"{fault.name}: {fault.old!r} -> {fault.new!r}: {fault.argued or 'NOT ARGUED'}")
    if share < NOTICED or any(not fault.argued for fault in missed):
        sys.exit(1)


if __name__ == "__main__":
    main()
