"""Print the size and shape of the code: modules, lines, types, imports, and the path of some calls."""

from __future__ import annotations

import ast
import io
import itertools
import sys
import time
import tokenize
import tomllib
from collections import Counter
from collections.abc import Callable
from pathlib import Path
from types import FrameType
from typing import Any

ROOT = Path(__file__).resolve().parent.parent
PACKAGE = ROOT / "src" / "lommel"
LANGUAGES = {"cpp": {".hpp", ".cpp", ".h"}, "tests": {".py", ".cpp", ".hpp", ".c", ".h"}}
sys.path.insert(0, str(ROOT / "tools" / "docs"))


def lines_of(path: Path) -> Counter[str]:
    """Return the numbers of lines of code, docstrings, comments and blanks of a file."""
    text = path.read_text(encoding="utf-8")
    docstrings: set[int] = set()
    for node in ast.walk(ast.parse(text)):
        # Of modules, classes and functions, and those of attributes, which stand below their assignments.
        if isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant) and isinstance(node.value.value, str):
            docstrings |= set(range(node.lineno, (node.end_lineno or node.lineno) + 1))
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


def sizes() -> dict[str, int]:
    """Return the lines of code of each package of Python, and the lines of the C++ core and of the tests."""
    counted: Counter[str] = Counter()
    for path in PACKAGE.rglob("*.py"):
        folder = path.relative_to(PACKAGE).parts
        counted[folder[0] if len(folder) > 1 else "lommel"] += lines_of(path)["code"]
    for name, folders in (("cpp", ("cpp/include", "cpp/bindings")), ("tests", ("tests", "cpp/tests"))):
        files = (path for folder in folders for path in (ROOT / folder).rglob("*") if path.suffix in LANGUAGES[name])
        counted[name] = sum(path.read_bytes().count(b"\n") for path in files)
    return dict(counted)


def check_ceilings() -> None:
    """Exit with an error that names each package that has more lines than `ceilings.toml` allows, or is not in it."""
    ceilings = tomllib.loads((ROOT / "benchmarks" / "ceilings.toml").read_text(encoding="utf-8"))
    counted = sizes()
    over = [f"{name} has {lines}, at most {ceilings.get(name, 0)}" for name, lines in counted.items()
            if lines > ceilings.get(name, 0)]  # fmt: skip
    gone = [f"{name} is in ceilings.toml and not in the sources" for name in ceilings.keys() - counted.keys()]
    if over or gone:
        sys.exit(
            f"Lines of code: {'; '.join([*over, *gone])}. Delete, or raise the ceiling and say why in the commit."
        )


def imports() -> dict[str, set[str]]:
    """Return the modules that each module is imported by, and the stub of public names."""
    import organisation

    importers: dict[str, set[str]] = {name: set() for name in organisation.modules()}
    for name, tree in organisation.modules().items():
        for _, other in organisation.imported(tree):
            if other != name and other in importers:
                importers[other].add(name)
    for node in ast.parse((PACKAGE / "__init__.pyi").read_text(encoding="utf-8")).body:
        name = (getattr(node, "module", None) or "").removeprefix("lommel.").replace(".", "/")
        if name in importers:
            importers[name].add("__init__.pyi")
    return importers


def path_of(call: Callable[[], object]) -> tuple[int, int, int]:
    """Return the Python functions of the package that one call runs, their files and changes of file."""
    call()
    files: list[str] = []

    def note(frame: FrameType, event: str, _: object) -> None:
        if event == "call" and str(PACKAGE) in frame.f_code.co_filename:
            files.append(frame.f_code.co_filename)

    sys.setprofile(note)
    try:
        call()
    finally:
        sys.setprofile(None)
    return len(files), len(set(files)), sum(one != other for one, other in itertools.pairwise(files))


def cpu_of(call: Callable[[], object], count: int, rounds: int) -> float:
    """Return the CPU time of a call in microseconds, the least of some rounds."""
    best = float("inf")
    for _ in range(rounds):
        start = time.process_time()
        for _ in range(count):
            call()
        best = min(best, (time.process_time() - start) / count)
    return 1e6 * best


def main() -> None:
    """Print the figures, one line each; with `--ceilings` only compare the lines of each package with its ceiling."""
    if "--ceilings" in sys.argv:
        check_ceilings()
        return
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
        print_calls()


def print_calls() -> None:
    """Print the Python calls, files, changes of file and CPU time of some whole computations."""
    import numpy as np

    import lommel as lm

    plan, radial_plan = lm.Plan(33, 0.5), lm.Plan(33, 0.5)
    coma, defocused = lm.Pupil(lm.Wavefront(nonradial={(3, 1): 1.0})), lm.Pupil(lm.Wavefront(defocus=3.0))
    truth = lm.Wavefront(nonradial={(2, 2): 0.4, (3, 1): 0.3, (3, -1): -0.2})
    defocus, noise = (-3.0, 0.0, 3.0), lm.Noise(read=1.6)
    stars = [lm.psf(lm.Pupil(truth + lm.Wavefront(defocus=at)), 33, 0.5).values for at in defocus]
    counts = np.array([noise.record(1e5 * image.astype(np.float64), seed) for seed, image in enumerate(stars)])

    lens = lm.Lens(focal_length=50e-3, f_number=1.8, focus_distance=2.0, wavelength=550e-9)
    photo, depth = np.random.default_rng(0).random((64, 64)), np.tile(np.linspace(1.5, 4.0, 64), (64, 1))

    objective, z = lm.Objective(NA=1.4, magnification=63, immersion=1.518, sample=1.33), np.linspace(-8e-7, 8e-7, 9)
    light = objective.pupil(
        depth=50e-9, z=z, wavelength=600e-9, aberrations=lm.Wavefront.zernike({5: 0.4, 7: -0.3}, order="noll")
    )
    bead = noise.record(2e4 * lm.microscopy.bead(light, 100e-9, 17, 6.5e-6).values + 10, seed=1)
    microscope = lm.Microscope(objective, 600e-9, 6.5e-6)
    camera: dict[str, Any] = {"wavelength": 600e-9, "pixel": 6.5e-6, "noise": noise}

    rng, pupil = np.random.default_rng(5), lm.Pupil(lm.Wavefront(defocus=6.0))
    places = rng.uniform(20, 480, (8, 2))
    centers = 12.0 + places - np.round(places)
    windows = np.array(
        [
            noise.record(5e4 * lm.psf(pupil, 25, 1.0, center=tuple(at)).values + 5, seed)
            for seed, at in enumerate(centers)
        ]
    )

    def fit_field() -> object:
        targets = lm.detection.Targets(windows=windows, places=np.round(places), shape=(500, 500), noise=noise)
        return lm.fit_field(targets, lm.Pupil(), pixel=1.0, degree=1, defocus=6.0)

    steps = lm.imaging.RichardsonLucy(steps=5)
    calls: list[tuple[str, Callable[[], object], int]] = [
        ("a radial pupil by a plan", lambda: radial_plan(defocused), 2000),
        ("a Zernike pupil by a plan", lambda: plan(coma), 2000),
        (
            "a retrieval of three 33^2 images, 15 terms",
            lambda: lm.retrieve(counts, lm.Pupil(), pixel=0.5, noise=noise, terms=15, defocus=defocus),
            1,
        ),
        ("depth of field, 64^2", lambda: lm.imaging.depth_of_field(photo, depth, lens, 8e-6, encoding="linear"), 1),
        (
            "a fit of a bead, 9 planes of 17^2, 5 terms",
            lambda: lm.fit_beads(bead, microscope, z=z, noise=noise, diameter=100e-9, terms=5),
            1,
        ),
        (
            "a deconvolution of 9 planes of 17^2, 5 steps",
            lambda: lm.microscopy.deconvolve(
                bead, objective, depth=1e-6, step=200e-9, direction="up", method=steps, diagnosis=False, **camera
            ),
            1,
        ),
        ("a fit of a field, 8 stars of 25^2", fit_field, 1),
    ]
    for name, call, count in calls:
        number, files, changes = path_of(call)
        print(
            f"{name}: {number} calls in {files} files, {changes} changes of file,"
            f" {cpu_of(call, count, 10 if count > 1 else 2):.1f} us of CPU"
        )


if __name__ == "__main__":
    main()
