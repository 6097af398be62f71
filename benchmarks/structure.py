"""Print the size and shape of the code: modules, lines, types, imports, and the path of some calls."""

from __future__ import annotations

import ast
import cProfile
import io
import pstats
import sys
import time
import tokenize
from collections import Counter
from collections.abc import Callable
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PACKAGE = ROOT / "src" / "lommel"
sys.path.insert(0, str(ROOT / "docs"))

DOCUMENTED = ast.Module | ast.ClassDef | ast.FunctionDef | ast.AsyncFunctionDef


def lines_of(path: Path) -> Counter[str]:
    """Return the numbers of lines of code, docstrings, comments and blanks of a file."""
    text = path.read_text(encoding="utf-8")
    docstrings: set[int] = set()
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, DOCUMENTED) and ast.get_docstring(node, clean=False) is not None:
            docstrings |= set(range(node.body[0].lineno, node.body[0].end_lineno + 1))  # type: ignore[operator]
    counted: Counter[str] = Counter()
    comments, code = set(), set()
    skipped = {tokenize.NL, tokenize.NEWLINE, tokenize.INDENT, tokenize.DEDENT, tokenize.ENDMARKER, tokenize.ENCODING}
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        if token.type == tokenize.COMMENT:
            comments.add(token.start[0])
        elif token.type not in skipped:
            code |= set(range(token.start[0], token.end[0] + 1))
    counted["docstrings"] = len(docstrings)
    counted["code"] = len(code - docstrings)
    counted["comments"] = sum(
        1
        for at in comments
        if not any(mark in text.splitlines()[at - 1] for mark in ("# type:", "# noqa", "# pragma"))
    )
    counted["lines"] = text.count("\n")
    counted["any"] = sum(
        (isinstance(node, ast.Name) and node.id == "Any") or (isinstance(node, ast.Attribute) and node.attr == "Any")
        for node in ast.walk(ast.parse(text))
    )
    return counted


def imports() -> dict[str, set[str]]:
    """Return the modules that each module is imported by."""
    import organisation

    importers: dict[str, set[str]] = {name: set() for name in organisation.modules()}
    for name, tree in organisation.modules().items():
        for _, other in organisation.imported(tree):
            if other != name and other in importers:
                importers[other].add(name)
    return importers


def path_of(call: Callable[[], object]) -> tuple[int, int]:
    """Return how many Python functions of the package one call runs, and in how many files."""
    call()
    profile = cProfile.Profile()
    profile.runcall(call)
    found = [
        (key, value[1])
        for key, value in pstats.Stats(profile).stats.items()
        if str(PACKAGE) in key[0]  # type: ignore[attr-defined]
    ]
    return sum(count for _, count in found), len({key[0] for key, _ in found})


def cpu_of(call: Callable[[], object], count: int = 2000) -> float:
    """Return the CPU time of a call in microseconds, the least of ten."""
    best = float("inf")
    for _ in range(10):
        start = time.process_time()
        for _ in range(count):
            call()
        best = min(best, (time.process_time() - start) / count)
    return 1e6 * best


def main() -> None:
    """Print the figures, one line each."""
    total: Counter[str] = Counter()
    files = sorted(PACKAGE.rglob("*.py"))
    for path in files:
        total += lines_of(path)
    importers = imports()
    single = [name for name, by in importers.items() if len(by) == 1 and not name.endswith("__init__")]
    for folder in ("methods", "optics"):
        print(f"modules in {folder}/ at its top level: {len(list((PACKAGE / folder).glob('[!_]*.py')))}")
    print(f"modules: {len(files)}, imported by exactly one other: {len(single)}")
    print(
        f"lines: {total['code']} of code, {total['docstrings']} of docstrings,"
        f" {total['comments']} of comments ({100 * total['comments'] / total['lines']:.1f} %)"
    )
    print(f"Any: {total['any']} times")
    for page in ("README.md", "CONTRIBUTING.md"):
        print(f"{page}: {len((ROOT / page).read_text(encoding='utf-8').splitlines())} lines")
    if "--list" in sys.argv:
        for name in single:
            print("  ", name, "<-", *importers[name])
    if "--calls" in sys.argv:
        import numpy as np

        import lommel as lm

        pupil = lm.Pupil(lm.Wavefront(nonradial={(3, 1): 1.0}))
        plan = lm.Plan(33, 0.5)
        calls, where = path_of(lambda: plan(pupil))
        print(
            f"a Zernike pupil by a plan: {calls} calls in {where} files, {cpu_of(lambda: plan(pupil)):.1f} us of CPU"
        )
        radial = lm.Pupil(lm.Wavefront(defocus=3.0))
        calls, where = path_of(lambda: plan(radial))
        print(
            f"a radial pupil by a plan: {calls} calls in {where} files, {cpu_of(lambda: plan(radial)):.1f} us of CPU"
        )
        truth = lm.Wavefront(nonradial={(2, 2): 0.4, (3, 1): 0.3, (3, -1): -0.2})
        images = [lm.psf(lm.Pupil(truth + lm.Wavefront(defocus=at)), 33, 0.5).intensity for at in (-3.0, 0.0, 3.0)]
        names = [(n, m) for n in range(2, 6) for m in range(-n, n + 1, 2)]
        stack = np.array(images)
        del stack, names


if __name__ == "__main__":
    main()
