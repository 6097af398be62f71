"""Make the live page's module: the core compiled for browsers, and the files of this folder, in one ES module.

    python web/build.py           # writes src/lommel/page/lommel-live.js, which is committed
    python web/build.py --check   # fails if that file was made from other sources

The same bytes come out of the same files, wherever they lie; on other machines the tables of depth, which linear
algebra makes, may differ in their last digits.
"""

from __future__ import annotations

import argparse
import base64
import hashlib
import json
import re
import subprocess
import sys
import tempfile
import zlib
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent
MODULE = ROOT / "src" / "lommel" / "page" / "lommel-live.js"
# The files that determine the module, beside those of C++. What the tables of depth and the presets call in the rest
# of the package is not among them: it changes their last digits, if anything, and far more often.
SOURCES = (
    *("web/*.js", "web/*.css", "web/*.py", "examples/lenses/*.toml", "src/lommel/page/state.py"),
    *("src/lommel/imaging/focal_*.py", "src/lommel/estimation/focal_model.py"),
)
INCLUDE = re.compile(r'^\s*#include "([^"]+)"', re.MULTILINE)
# Fixed here and nowhere else: another set of them has the compiler build its library of C++ anew. Exceptions are said
# to the host (cpp/wasm/live.cpp); contracted products would differ from the other builds of the core.
FLAGS = [
    *("-target", "wasm32-wasi"),
    *("-std=c++17", "-O2", "-msimd128", "-ffp-contract=off", "-fno-math-errno", "-fignore-exceptions", "-fno-rtti"),
    # A fifth of the download for a twentieth of the time: what counts is written with vectors, and inlined by hand.
    *("-fno-unroll-loops", "-fno-vectorize", "-fno-slp-vectorize", "-mllvm", "-inline-threshold=30"),
    *("-Wall", "-Wextra", "-Wno-psabi"),
]
LINKED = ["-mexec-model=reactor", "-Wl,--strip-all"]
UNITS = {"live": [], "depth": ["-fvectorize", "-fslp-vectorize"]}  # and flags of their own
BANNER = """\
/*! lommel, BSD-3-Clause. The compiled core holds parts of libc++ and libc++abi (Apache-2.0 WITH LLVM-exception), of
musl, wasi-libc and Zig (MIT), and of cloudlibc (BSD-2-Clause); the notices are in LICENSES of sources and wheels. */
"""
IMPORT = re.compile(r'^import\s*\{([^}]*)\}\s*from\s*"\./([\w-]+\.js)";\n', re.MULTILINE)
COMMENT = re.compile(r"^[ \t]*//.*\n", re.MULTILINE)  # alone on its line
EXPORT = re.compile(r"^export (?=(?:async )?(?:function|class|const|let)\b)", re.MULTILINE)


def sources() -> list[Path]:
    """Return the files that determine the module: those of SOURCES, and the C++ files with all that they include."""
    found = {path for pattern in SOURCES for path in ROOT.glob(pattern)}
    waiting = [ROOT / "cpp" / "wasm" / f"{name}.cpp" for name in UNITS]
    while waiting:
        path = waiting.pop()
        if path not in found:
            found.add(path)
            for name in INCLUDE.findall(path.read_text(encoding="utf-8")):
                beside = path.parent / name
                waiting.append(beside if beside.is_file() else ROOT / "cpp" / "include" / name)
    return sorted(found, key=lambda path: path.relative_to(ROOT).as_posix())


def source_line() -> str:
    """Return the first line of the module: the compiler's version, and the SHA-256 of the sources without comments.

    Comments count where they share a line with code, and in docstrings.
    """
    (compiler,) = re.findall(r'"(ziglang==[\d.]+)"', (ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    digest = hashlib.sha256()
    for path in sources():
        mark = "#" if path.suffix in (".py", ".toml") else "//"
        text = re.sub(rf"^[ \t]*(?:{mark}.*)?\n", "", path.read_text(encoding="utf-8"), flags=re.MULTILINE)
        digest.update(f"{path.relative_to(ROOT).as_posix()} {len(text)}\n{text}".encode())
    return f"// Made by `make page` with {compiler}; SHA-256 of the sources: {digest.hexdigest()}\n"


def is_current(module: Path) -> bool:
    """Return whether a module was made from these sources."""
    return module.is_file() and module.read_bytes().startswith(source_line().encode())


def compiled() -> bytes:
    """Return the core as WebAssembly."""
    with tempfile.TemporaryDirectory() as folder:
        # From its own folder and by relative paths, so that no path is in the result.
        zig = [sys.executable, "-m", "ziglang", "c++"]
        objects = [f"{folder}/{name}.o" for name in UNITS]
        for (name, own), made in zip(UNITS.items(), objects, strict=True):
            command = [*zig, *FLAGS, *own, "-Icpp/include", "-c", f"cpp/wasm/{name}.cpp", "-o", made]
            subprocess.run(command, cwd=ROOT, check=True)
        subprocess.run([*zig, *FLAGS, *LINKED, *objects, "-o", f"{folder}/live.wasm"], cwd=ROOT, check=True)
        return Path(folder, "live.wasm").read_bytes()


def packed(data: bytes) -> str:
    """Return data deflated as far as it goes, as base64."""
    import zopfli.zlib  # late, as in module(): source_line() needs the standard library alone

    return base64.b64encode(zopfli.zlib.compress(data)).decode("ascii")


def read(name: str, made: dict[str, str]) -> str:
    """Return a file of the page, or one that is made."""
    return made[name] if name in made else (HERE / name).read_text(encoding="utf-8")


def ordered(entry: str, made: dict[str, str]) -> list[str]:
    """Return the names of a module and all that it imports, each after those that it imports."""
    order: list[str] = []

    def visit(name: str, on_the_way: tuple[str, ...] = ()) -> None:
        if name in on_the_way:
            raise ValueError(f"{' imports '.join((*on_the_way, name))}: a circle")
        if name not in order:
            for _, other in IMPORT.findall(read(name, made)):
                visit(other, (*on_the_way, name))
            order.append(name)

    visit(entry)
    return order


def names_of(names: str) -> list[str]:
    """Return the names in the braces of an import."""
    return [name for part in names.split(",") if (name := part.strip())]


def joined(order: list[str], made: dict[str, str], owner: dict[str, str], *, exports: bool = False) -> str:
    """Return modules as one, with the exports of the last or with none; `owner` gets where each name is declared."""
    texts = []
    for name in order:
        text = read(name, made)
        for names, other in IMPORT.findall(text):
            if " as " in names:
                raise ValueError(f"{name} renames what it imports from {other}, which joined files cannot")
        text = COMMENT.sub("", IMPORT.sub("", text))
        if re.search(r"^import\b", text, re.MULTILINE):
            raise ValueError(f'{name} has an import of another form than `import {{ a }} from "./b.js";`')
        if not (exports and name == order[-1]):
            text = EXPORT.sub("", text)
            if re.search(r"^export\b", text, re.MULTILINE):
                raise ValueError(f"{name} has an export of another form than that of a declaration")
        for found in re.findall(r"^(?:export )?(?:async )?(?:function\*?|class|const|let) (\w+)", text, re.MULTILINE):
            if owner.setdefault(found, name) != name:
                raise ValueError(f"{found} is declared both in {owner[found]} and in {name}")
        texts.append(text)
    return bare("\n".join(texts))


def bare(text: str) -> str:
    """Return a text without indentation, empty lines and lines of comments, which nothing here depends on."""
    return re.sub(r"^(?:\s*//.*\n|\s+)", "", text, flags=re.MULTILINE)


def constants(**values: object) -> str:
    """Return a module of constants."""
    return "".join(f"export const {name} = {json.dumps(value)};\n" for name, value in values.items())


def module(entry: str) -> str:
    """Return the text of the module."""
    from depths import depths  # beside this file, as is the next
    from presets import presets

    from lommel.page.state import DIRECTED, FIELDS, WHITE, colour_weights

    camera, tables = depths()
    made = {
        "packed.js": constants(wasmText=packed(compiled()), depthText=packed(tables)),
        "camera.js": constants(CAMERA=camera),
    }
    style = re.sub(r"/\*.*?\*/", "", (HERE / "live.css").read_text(encoding="utf-8"), flags=re.DOTALL)
    made["style.js"] = constants(styleText=bare(style))
    made["shipped.js"] = constants(SHIPPED=presets())
    terms = [{"name": name, "n": n, "m": m} for name, (n, m) in DIRECTED.items()]
    fields = {name: field.description() for name, field in FIELDS.items()}
    other = {"DIRECTED": terms, "WHITE": WHITE.tolist(), "COLOURS": colour_weights().round(6).tolist()}
    made["fields.js"] = constants(FIELDS=fields, **other)
    # What the page and its workers both run is one function, whose text the workers get from the page.
    both = ordered("worker.js", made)[:-1]
    made["workertext.js"] = ""
    own = [name for name in ordered(entry, made) if name not in both]
    imports = [found for name in (*own, "worker.js") for found in IMPORT.findall(read(name, made))]
    taken = ", ".join(sorted({name for names, other in imports if other in both for name in names_of(names)}))
    owner = {"common": "build.py"}
    common = f"const common = () => {{\n{joined(both, made, owner)}return {{ {taken} }};\n}};\n"
    begin, end = f'"use strict";const {{ {taken} }} = (', f")();{joined(['worker.js'], made, {})}"
    made["workertext.js"] = f"export const workerText = {json.dumps(begin)} + common + {json.dumps(end)};\n"
    return f"{source_line()}{BANNER}{common}const {{ {taken} }} = common();\n{joined(own, made, owner, exports=True)}"


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--output", default=MODULE, type=Path)
    parser.add_argument("--entry", default="live.js", help="the file whose exports the module has")
    parser.add_argument("--check", action="store_true", help="only fail if the file is of other sources")
    given = parser.parse_args()
    if given.check:
        sys.exit(not is_current(given.output))
    text = module(given.entry)
    given.output.parent.mkdir(parents=True, exist_ok=True)
    given.output.write_text(text, encoding="utf-8", newline="\n")
    sizes = [len(text.encode()), len(zlib.compress(text.encode(), 9))]
    print(f"{given.output}: {sizes[0] / 1e3:.0f} kB, {sizes[1] / 1e3:.0f} kB deflated")
