"""Deliberate faults, one at a time, against the tests: `make mutants`, or `make mutants ONLY="ellipse psf.py:2"`.

Or faults that chance draws from all of the code: `make mutants FLAGS="--random 200 --seed 1 --only python"`.

The faults are in cpp.toml, of the core, and python.toml, of what computes error bounds and limits: for each file the
tests of its subject and a list of (old, new), old occurring once. Nothing is changed but copies below build/mutants.
Those in C++ are compiled together into one build, `(lommel_mutant(k) ? new : old)`, and chosen by the environment;
those in Python are written into a copy of src. For each the tests of its subject run first, and where these pass the
rest of the suite. A fault that nothing notices must be argued in its list; fewer than 95 % noticed is a failure, of
random ones fewer than 90 %.

What was found of random faults is kept in build/mutants/random-*.jsonl. The same command goes on with those that were
not judged, and judges again those that were not noticed.
"""

from __future__ import annotations

import argparse
import importlib.util
import itertools
import json
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
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path

import draw

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "shared"))
import programs

ROOT = Path(__file__).resolve().parents[2]
LISTS = [Path(__file__).with_name(name) for name in ("cpp.toml", "python.toml")]
PLACE = ROOT / "build" / "mutants"
SWITCH = """#pragma once
#include <cstdlib>
inline int lommel_mutant_chosen() { const char* k = std::getenv("LOMMEL_MUTANT"); return k ? std::atoi(k) : 0; }
inline const int lommel_mutant_on = lommel_mutant_chosen();
inline bool lommel_mutant(int k) { return lommel_mutant_on == k; }
"""
# Before the name of a test that `make test` leaves out.
SLOW = "slow tests alone: "
NOTICED = 0.95
NOTICED_AT_RANDOM = 0.9
# Tests of a subject that is not in the lists: so many files, those that name it most often.
NEAREST = 4


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
    start: int = -1  # where `old` is, if it need not be there once
    drawn: bool = False  # in the lists for its argument only, for runs whose faults are random

    def span(self, text: str) -> tuple[int, int]:
        """Return where it is in the text of its file."""
        start = self.start if self.start >= 0 else text.index(self.old)
        return start, start + len(self.old)

    def applied(self, text: str) -> str:
        """Return the text of its file with the fault."""
        start, end = self.span(text)
        return text[:start] + self.new + text[end:]

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
                name = f"{Path(*Path(file).parts[2:])}:{place}"
                argued, drawn = extra.get("argued", ""), extra.get("drawn", False)
                faults.append(Fault(len(faults) + 1, name, file, old, new, tests, argued, drawn=drawn))
    return faults


def misfits(faults: list[Fault]) -> list[str]:
    """Return what is wrong: patterns that are not in their file once, overlaps, tests that are not there."""
    wrong = []
    for fault in faults:
        path = ROOT / fault.file
        count = path.read_text(encoding="utf-8").count(fault.old) if path.exists() else 0
        if count != 1 or fault.old == fault.new:
            wrong.append(f"{fault.name}: {fault.old!r} is {count} times in {fault.file}")
        if fault.drawn and not fault.argued:
            wrong.append(f"{fault.name} is there for its argument, and has none")
        if fault.compiled and not fault.drawn and not _is_expression(fault.old, fault.new):
            wrong.append(f"{fault.name}: {fault.old!r} is no expression that a switch could stand for")
        wrong += [f"{fault.name}: no {test}" for test in fault.tests if not (ROOT / test.split("::")[0]).exists()]
    if not wrong:
        switches = [fault for fault in faults if fault.compiled and not fault.drawn]
        for file in sorted({fault.file for fault in switches}):
            text = (ROOT / file).read_text(encoding="utf-8")
            spans = sorted(_spans([fault for fault in switches if fault.file == file], text))
            wrong += [f"{file}: faults overlap at {b!r}" for a, b in itertools.pairwise(spans) if b[0] < a[1]]
    return wrong


def _is_expression(old: str, new: str) -> bool:
    """Return whether a switch could choose between two texts: statements, or whole expressions."""
    if old.endswith(";"):
        return not old.startswith("const ")
    begins_alone = not old.lstrip().startswith(("+ ", "- ", "* ", "/ ", "&& ", "|| "))
    return begins_alone and bool(new) and all(text.count("(") == text.count(")") for text in (old, new))


@cache
def _texts() -> dict[str, str]:
    """Return the text of each file of tests."""
    paths = sorted((ROOT / "tests").rglob("test_*.py"))
    return {path.relative_to(ROOT).as_posix(): path.read_text(encoding="utf-8") for path in paths}


def subject(file: str, listed: dict[str, list[str]]) -> tuple[str, ...]:
    """Return the tests of a file's subject, the nearest first: those of its list, its mirror, and those that name it.

    Where there are none, those listed of other files of its folder; last, all tests.
    """
    module = Path(file.removeprefix("src/lommel/").removeprefix("cpp/include/lommel/")).with_suffix("")
    mirror = f"tests/{module.with_name('test_' + module.name)}.py"
    found = listed.get(file, []) + [mirror] * (mirror in _texts())
    if file.endswith(".py"):
        # As a module or, without regard to capitals, as what it defines.
        named = re.compile(rf"\b{module.name}\b", re.IGNORECASE)
        counts = {test: len(named.findall(text)) for test, text in _texts().items()}
        found += sorted(filter(counts.get, counts), key=lambda test: -counts[test])[:NEAREST]
    beside = [test for one in sorted(listed) if Path(one).parent == Path(file).parent for test in listed[one]]
    return tuple(dict.fromkeys(found or beside))[: 2 * NEAREST] or ("tests",)


def _bound() -> set[str]:
    """Return the headers that the bindings include, and those that these do."""
    found, now = set[str](), set((ROOT / "cpp" / "bindings").iterdir())
    while now:
        text = "".join(path.read_text(encoding="utf-8") for path in now)
        headers = {f"cpp/include/{name}" for name in re.findall(r'^#include "(lommel/.*)"$', text, re.MULTILINE)}
        now = {ROOT / header for header in headers - found}
        found |= headers
    return found


def drawn(count: int, seed: int, only: str | None) -> list[Fault]:
    """Return faults that chance draws from the code, each with the tests of its subject; those in C++ compile."""
    folders = {"python": "src/lommel/**/*.py", "cpp": "cpp/include/**/*.hpp"}
    paths = [path for language, glob in folders.items() if only in (None, language) for path in ROOT.glob(glob)]
    texts = {path.relative_to(ROOT).as_posix(): path.read_text(encoding="utf-8") for path in sorted(paths)}
    # Headers that the page alone includes are not in the module.
    texts = {file: text for file, text in texts.items() if file.endswith(".py") or file in _bound()}
    entries = [tomllib.loads(listing.read_text(encoding="utf-8")) for listing in LISTS]
    listed = {file: entry["tests"] for listing in entries for file, entry in listing.items()}
    argued = {(fault.file, fault.applied(texts[fault.file])): fault.argued for fault in load() if fault.file in texts}
    faults: list[Fault] = []
    for number, (file, (start, end, new)) in enumerate(draw.draw(texts, seed), 1):
        text = texts[file]
        name = f"{Path(*Path(file).parts[2:])}:{text.count(chr(10), 0, start) + 1}"
        fault = Fault(number, name, file, text[start:end], new, subject(file, listed), "", start)
        fault = replace(fault, argued=argued.get((file, fault.applied(text)), ""))
        beside = [other.span(text) for other in faults if other.file == file and other.compiled]
        # Two switches in one place are none in another.
        if all((start, end) == span or end <= span[0] or span[1] <= start for span in beside):
            faults.append(fault)
        # Of those in C++ a few do not compile.
        if len(faults) >= count + sum(fault.compiled for fault in faults) // 4:
            refused = uncompiled([fault for fault in faults if fault.compiled])
            faults = [fault for fault in faults if fault not in refused]
            if len(faults) >= count:
                break
    return faults[:count]


def uncompiled(faults: list[Fault]) -> list[Fault]:
    """Return the faults that the compiler refuses where they stand, all being looked at together."""
    refused: list[Fault] = []
    if not faults:
        return refused
    build = configured(faults, PLACE / "checked", "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON")
    units = json.loads((build / "compile_commands.json").read_text(encoding="utf-8"))
    for unit in units:
        # A unit that compiles does so without some of the faults, too.
        while re.search("/(bindings|compiled)/", unit["file"]) and (
            said := _complaint(f"{unit['command']} -fsyntax-only -Werror=vla", build)
        ):
            places = set(re.findall(r"(cpp/include/\S+?):(\d+):\d+: error", said))
            left = [fault for fault in faults if fault not in refused]
            hit = _at(places, left) or _at(set(re.findall(r"(cpp/include/\S+?):(\d+):\d+:", said)), left)
            if not hit:
                sys.exit(f"no fault is where the compiler says that one is:\n{said[:6000]}")
            refused += hit
            configured([fault for fault in left if fault not in hit], PLACE / "checked")
    return refused


def _complaint(command: str, folder: Path) -> str:
    done = subprocess.run(command, shell=True, cwd=folder, capture_output=True, text=True, check=False)
    return done.stderr if done.returncode else ""


def _at(places: set[tuple[str, str]], faults: list[Fault]) -> list[Fault]:
    """Return the faults that are on such lines of files."""
    found = []
    for fault in faults:
        start, end = fault.span(text := (ROOT / fault.file).read_text(encoding="utf-8"))
        lines = range(text.count("\n", 0, start) + 1, text.count("\n", 0, end) + 2)
        found += [fault] if any((fault.file, str(line)) in places for line in lines) else []
    return found


def _spans(faults: list[Fault], text: str) -> dict[tuple[int, int], list[Fault]]:
    spans: dict[tuple[int, int], list[Fault]] = {}
    for fault in faults:
        spans.setdefault(fault.span(text), []).append(fault)
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


def configured(faults: list[Fault], place: Path, *options: str) -> Path:
    """Write the core with every fault in it, ready to be built; return the folder where it will be."""
    source, build = place / "cpp", place / "cmake"
    by_file = {file: [f for f in faults if f.file == file] for file in {f.file for f in faults}}
    needed = ("CMakeLists.txt", "pyproject.toml", "cmake/*", "cpp/**/*.[ch]pp")
    for path in itertools.chain.from_iterable(ROOT.glob(pattern) for pattern in needed):
        name = path.relative_to(ROOT).as_posix()
        text = path.read_text(encoding="utf-8")
        write(source / name, switched(text, by_file.get(name, [])).encode())
    write(source / "switch.hpp", SWITCH.encode())
    configure = [programs.cmake(), "-S", source, "-B", build, "-G", "Ninja"]
    configure += [f"-DCMAKE_MAKE_PROGRAM={programs.ninja()}"]
    configure += [
        f"-DPython_EXECUTABLE={sys.executable}",
        "-DCMAKE_BUILD_TYPE=Release",
        "-DLOMMEL_PYTHON=ON",
        "-DLOMMEL_TESTS=ON",
    ]
    configure += [f"-DCMAKE_CXX_FLAGS=-include {source / 'switch.hpp'}", *options]
    _run(*configure)
    return build


def compiled(faults: list[Fault], place: Path, jobs: int, *options: str) -> Path:
    """Build the core with every fault in it; return the folder that it is in."""
    build = configured(faults, place, *options)
    _run(programs.cmake(), "--build", build, "--parallel", jobs)
    return build


def _run(*command: object) -> None:
    done = subprocess.run([str(part) for part in command], capture_output=True, encoding="utf-8", check=False)
    if done.returncode:
        sys.exit(f"the faults in C++ do not compile:\n{done.stdout[-6000:]}{done.stderr[-2000:]}")


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
        script.write_text(f"#!{self.python}\nimport sys\nfrom lommel.cli.main import main\nsys.exit(main())\n")
        script.chmod(0o755)

    def pytest(self, number: int, tests: tuple[str, ...], limit: float, *options: str) -> str:
        """Return which test fails first, or "" if all pass."""
        command = [self.python, "-m", "pytest", "-x", "-q", "-p", "no:cacheprovider", *options]
        # A checksum notices every fault in its sources.
        command += ["--deselect=tests/page/test_server.py::test_the_module_is_made_of_these_sources"]
        command += ["--ignore=tests/test_tools.py", *tests]
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
        if running.returncode in (0, 5):  # passed, or there are no such tests
            return ""
        if running.returncode > 2:
            sys.exit(f"pytest did not run {tests}:\n{out[-3000:]}")
        failed = re.search(r"^(?:FAILED|ERROR) (\S+)", out, re.MULTILINE)
        return failed[1] if failed else f"ended by {running.returncode}: {out[-200:]!r}"

    def judge(self, fault: Fault, tests: tuple[str, ...], limit: float) -> str:
        """Return which test notices a fault, or "". The quick tests run first."""
        path, number = self.tree / fault.file, fault.number if fault.compiled else 0
        before = path.read_text(encoding="utf-8")
        if not fault.compiled:
            path.write_text(fault.applied(before), encoding="utf-8")
        try:
            if found := self.pytest(number, tests, limit, "--quick"):
                return found
            found = self.pytest(number, tests, limit, "--slow")
            return found and f"{SLOW}{found}"
        finally:
            path.write_text(before, encoding="utf-8")


class Found:
    """What was found of each fault, in a file that a later run reads; without one, nothing is kept."""

    def __init__(self, path: Path | None) -> None:
        self.path, self.known, self.lock = path, dict[tuple[str, ...], str](), threading.Lock()
        if path and path.exists():
            for line in path.read_text(encoding="utf-8").splitlines():
                entry = json.loads(line)
                self.known[tuple(entry["fault"])] = entry["found"]

    def _key(self, fault: Fault) -> tuple[str, ...]:
        return (fault.file, str(fault.start), fault.old, fault.new)

    def noticed(self, fault: Fault) -> str:
        """Return which test noticed a fault in an earlier run, or ""."""
        return self.known.get(self._key(fault), "")

    def keep(self, fault: Fault, found: str) -> None:
        """Write down which test noticed a fault, or that none did."""
        if self.path:
            with self.lock, self.path.open("a", encoding="utf-8") as file:
                file.write(json.dumps({"fault": self._key(fault), "found": found}) + "\n")


def shown(fault: Fault) -> str:
    """Return where a fault is, and the lines that it changes."""
    text = (ROOT / fault.file).read_text(encoding="utf-8")
    start, end = fault.span(text)
    first, last = text.rfind("\n", 0, start) + 1, (text.find("\n", end) + 1 or len(text) + 1) - 1
    old, new = text[first:last], text[first:start] + fault.new + text[end:last]
    why = fault.argued or "NOT ARGUED"
    return f"{fault.file}:{text.count(chr(10), 0, start) + 1}: {why}\n  - {old.strip()}\n  + {new.strip()}"


def main() -> None:
    """Judge the faults that are named, or all, or random ones."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("names", nargs="*", help="names, or parts of names, of faults (file.py:3)")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    parser.add_argument("--subject", action="store_true", help="run the tests of the subject only")
    parser.add_argument(
        "--trust", action="store_true", help="do not first make sure that the tests pass without a fault"
    )
    parser.add_argument("--random", type=int, metavar="N", help="draw so many faults instead of those in the lists")
    parser.add_argument("--seed", type=int, default=1, help="of what is drawn")
    parser.add_argument("--only", choices=("python", "cpp"), help="draw from one language")
    parser.add_argument("--limit", type=float, default=1200.0, help="seconds for the tests of a subject")
    parser.add_argument("--show", action="store_true", help="show the faults, and judge none")
    given = parser.parse_args()
    if given.random:
        faults, least, place = drawn(given.random, given.seed, given.only), NOTICED_AT_RANDOM, PLACE / "random"
        # That the code is slow is no fault, and what compiles in half the time is judged sooner.
        options = ["-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG"]
    else:
        listed, least, place, options = load(), NOTICED, PLACE, []
        if wrong := misfits(listed):
            sys.exit("\n".join(wrong))
        faults = [fault for fault in listed if not fault.drawn]
    chosen = [
        f
        for f in faults
        if not given.names
        or any(f"/{f.name}".endswith(f"/{o}") or (":" not in o and o in f.name) for o in given.names)
    ]
    if given.show:
        print("\n".join(shown(fault).replace("NOT ARGUED", " ".join(fault.tests)) for fault in chosen))
        return
    PLACE.mkdir(parents=True, exist_ok=True)
    listing = f"random-{given.seed}{f'-{given.only}' if given.only else ''}.jsonl"
    before = Found(PLACE / listing if given.random else None)
    open_ = [fault for fault in chosen if not before.noticed(fault)]
    switches = [f for f in faults if f.compiled]
    # Without a fault in C++ the core of the environment will do.
    core = importlib.util.find_spec("lommel._core")
    build = compiled(switches, place, given.jobs, *options) if switches else Path(core.origin).parent
    idle: queue.SimpleQueue[Workplace] = queue.SimpleQueue()
    for number in range(min(given.jobs, len(open_))):
        idle.put(Workplace(number, build))

    def make_sure(workplace: Workplace, *tests: str) -> None:
        # Tests that fail anyway would notice every fault.
        if not given.trust and (found := workplace.pytest(0, tests, 7200)):
            sys.exit(f"without a fault there is one already: {found}")

    if open_:
        first = idle.get()
        make_sure(first, *sorted({test for f in open_ for test in f.tests}))
        idle.put(first)
    lock, sure = threading.Lock(), []

    def judge(fault: Fault) -> tuple[Fault, str]:
        if found := before.noticed(fault):
            return fault, found
        workplace, start = idle.get(), time.monotonic()
        try:
            found = workplace.judge(fault, fault.tests, given.limit)
            if not found and not given.subject:
                with lock:
                    if not sure:
                        make_sure(workplace, "tests")
                        sure.append(True)
                found = workplace.judge(fault, ("tests",), 7200)
        finally:
            idle.put(workplace)
        before.keep(fault, found)
        said = found or (f"NOT NOTICED, argued: {fault.argued}" if fault.argued else "NOT NOTICED")
        print(f"{fault.name:36} {time.monotonic() - start:6.1f} s  {said}", flush=True)
        return fault, found

    start = time.monotonic()
    with ThreadPoolExecutor(given.jobs) as pool:
        results = list(pool.map(judge, chosen))
    missed = [fault for fault, found in results if not found]
    share = 1.0 - len(missed) / max(1, len(chosen))
    slow = sum(found.startswith(SLOW) for _, found in results)
    print(
        f"\n{len(chosen) - len(missed)} of {len(chosen)} noticed ({share:.1%}), {slow} of them by slow tests alone,",
        end=" ",
    )
    print(f"in {time.monotonic() - start:.0f} s")
    for fault in missed:
        print(shown(fault))
    if share < least or any(not fault.argued for fault in missed):
        sys.exit(1)


if __name__ == "__main__":
    main()
