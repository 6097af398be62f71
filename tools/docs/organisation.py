"""The packages of the code in the order of their imports, their diagrams, and the list of their files."""

from __future__ import annotations

import ast
import re
import textwrap
from collections import Counter
from dataclasses import dataclass
from functools import cache
from html import escape
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PACKAGE = ROOT / "src" / "lommel"
CORE = ROOT / "cpp" / "include" / "lommel"

# A package imports from those before it and from itself; packages of one line do not import each other.
ORDER = [
    {"base"},
    {"core"},
    {"special"},
    {"fit"},
    {"optics"},
    {"telescopes"},
    {"methods"},
    {"blur"},
    {"measures"},
    {"traced"},
    {"psf"},
    {"channel_psf"},
    {"io"},
    {"recorded"},
    {"deconvolve"},
    {"show"},
    {"detection", "field", "stacks"},
    {"estimation"},
    {"imaging", "localize", "microscopy"},
    {"lensfiles"},
    {"report"},
    {"adapters", "compat", "napari_plugin", "page", "paper"},
    {"cli"},
    {"the package"},
]
# Folders of the compiled core, in the order of their includes.
CORE_ORDER = [
    {"limits"},
    {"base"},
    {"bounds"},
    {"special"},
    {"pixels"},
    {"radial"},
    {"zernike"},
    {"aperture"},
    {"chordal"},
    {"rim"},
    {"averages"},
    {"stratified"},
    {"paper", "imaging", "focal", "estimation", "localize"},
]
# Modules whose package has another name.
ALONE = {"_core": "core", "__main__": "cli", "__init__": "the package"}


def package_of(module: str) -> str:
    """Return the package of a module, given as its path without suffix, such as methods/method."""
    first = module.split("/", maxsplit=1)[0]
    return ALONE.get(first, first)


def imported(tree: ast.AST) -> list[tuple[int, str]]:
    """Return the modules imported anywhere in a file, also inside functions, each with its line."""
    found = []
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom):
            if node.level:
                raise ValueError(f"line {node.lineno}: imports are absolute here")
            names = [f"{node.module}.{alias.name}" for alias in node.names]
        elif isinstance(node, ast.Import):
            names = [alias.name for alias in node.names]
        else:
            continue
        found += [(node.lineno, _module(name)) for name in names if name.split(".")[0] == "lommel"]
    return found


def named(tree: ast.AST) -> list[tuple[int, str]]:
    """Return the modules named in strings, as ``"lommel.show.plot:psf"`` names one, each with its line."""
    found = []
    for node in ast.walk(tree):
        if isinstance(node, ast.Constant) and isinstance(node.value, str):
            whole = re.fullmatch(r"(lommel(?:\.\w+)+)\.?(?::\w+)?", node.value)
            found += [(node.lineno, _module(whole[1]))] if whole else []
    return [(line, module) for line, module in found if module != "__init__"]  # other names, as of entry points


def _module(name: str) -> str:
    """Return the path of the module that a dotted name belongs to."""
    path = PACKAGE.joinpath(*name.split(".")[1:])
    while not any(path.with_suffix(suffix).is_file() for suffix in (".py", ".pyi")):
        if (path / "__init__.py").is_file():
            path = path / "__init__"
            break
        path = path.parent
    return path.relative_to(PACKAGE).as_posix()


@cache
def modules() -> dict[str, ast.Module]:
    """Return the syntax tree of every module, by its path without suffix."""
    return {
        path.relative_to(PACKAGE).with_suffix("").as_posix(): ast.parse(path.read_text(encoding="utf-8"))
        for path in sorted(PACKAGE.rglob("*.py"))
    }


def headers() -> dict[str, list[str]]:
    """Return the headers that each header of the core includes, by their paths without suffix."""
    include = re.compile(r'^ *# *include "lommel/([\w/]+)\.hpp"', re.MULTILINE)
    return {
        path.relative_to(CORE).with_suffix("").as_posix(): include.findall(path.read_text(encoding="utf-8"))
        for path in sorted(CORE.rglob("*.hpp"))
    }


def upward(order: list[set[str]], here: str, needs: list[str]) -> list[str]:
    """Return the needs of a file that violate an order of packages."""
    rank = {name: at for at, names in enumerate(order) for name in names}
    own = package_of(here)
    return [other for other in needs if package_of(other) != own and rank[package_of(other)] >= rank[own]]


@dataclass(frozen=True)
class Layout:
    """Packages in the order of their imports, with descriptions, files and the number of imports between them."""

    packages: list[str]
    about: dict[str, str]
    files: dict[str, list[str]]
    needs: Counter[tuple[str, str]]


def package() -> Layout:
    """Return the layout of the Python package."""
    trees = modules()
    about = {
        package_of(name): ast.get_docstring(tree)
        for name, tree in trees.items()
        if "/" not in name.removesuffix("/__init__")
    }
    about["cli"] = ast.get_docstring(trees["cli/__init__"])
    pairs = [(name, other) for name, tree in trees.items() for other in {other for _, other in imported(tree)}]
    return _layout(ORDER, {r: (text or "").split("\n\n")[0] for r, text in about.items()}, list(trees), pairs)


def core() -> Layout:
    """Return the layout of the compiled core."""
    return _layout(
        CORE_ORDER, {}, list(headers()), [(name, other) for name, needs in headers().items() for other in needs]
    )


def _layout(order: list[set[str]], about: dict[str, str], names: list[str], pairs: list[tuple[str, str]]) -> Layout:
    packages = [name for names in order for name in sorted(names)]
    files: dict[str, list[str]] = {name: [] for name in packages}
    for name in names:
        if "/" in name and not name.endswith("__init__"):
            files[package_of(name)].append(name.split("/", maxsplit=1)[1])
    needs = Counter((package_of(a), package_of(b)) for a, b in pairs if package_of(a) != package_of(b))
    return Layout(packages, about, files, needs)


def picture(layout: Layout, title: str) -> str:
    """Return a layout as SVG: the first package at the bottom, an arc from each package to each it imports."""
    left, width, line = 120, 640, 17
    texts = {
        name: [
            *textwrap.wrap(re.sub(r":\w+:`(\w+)`", r"\1", layout.about.get(name, "")), 70),
            *textwrap.wrap(" \u00b7 ".join(layout.files[name]), 70, break_on_hyphens=False),
        ]
        for name in layout.packages
    }
    tops, top = {}, 4
    for name in reversed(layout.packages):
        tops[name] = top
        top += 30 + line * len(texts[name]) + 8
    parts = []
    for name in reversed(layout.packages):
        y, height = tops[name], 30 + line * len(texts[name])
        below = [(other, count) for (own, other), count in sorted(layout.needs.items()) if own == name]
        arcs = []
        for other, count in below:
            a, b = y + 16, tops[other] + 16
            reach = left - 10 - 140 * ((b - a) / top) ** 0.6
            path = f"M{left - 6} {a}C{reach:.0f} {a} {reach:.0f} {b} {left - 6} {b}"
            arcs.append(f'<path d="{path}" stroke-width="{min(0.8 + 0.12 * count, 3.5):.1f}"/>')
        said = [
            f'<text x="{left + 14}" y="{y + 38 + line * i}">{escape(text)}</text>'
            for i, text in enumerate(texts[name])
        ]
        hint = f"{name} imports {', '.join(f'{other} ({count})' for other, count in below) or 'no other package'}"
        parts.append(
            f'<g class="package"><title>{escape(hint)}</title>{"".join(arcs)}'
            f'<rect x="{left}" y="{y}" width="{width - left - 2}" height="{height}" rx="6"/>'
            f'<text class="name" x="{left + 14}" y="{y + 20}">{escape(name)}</text>{"".join(said)}</g>'
        )
    return (
        f'<svg class="packages" role="img" viewBox="0 0 {width} {top}" xmlns="http://www.w3.org/2000/svg">'
        f"<title>{escape(title)}</title>{''.join(parts)}</svg>\n"
    )


def listing() -> str:
    """Return the modules and headers with their descriptions, as Markdown."""
    texts = {
        f"{name}.py": re.sub(r":\w+:`~?([^`<]+)`", r"`\1`", (ast.get_docstring(tree) or "").split("\n\n")[0])
        for name, tree in modules().items()
    }
    comment = re.compile(r"(?:// ?.*\n)+")
    for name in headers():
        head = comment.match((CORE / f"{name}.hpp").read_text(encoding="utf-8"))
        texts[f"{name}.hpp"] = head[0].replace("// ", "").replace("//", "") if head else ""
    parts = []
    for order, suffix, title in ((ORDER, "py", "Package"), (CORE_ORDER, "hpp", "Compiled core")):
        for package in (name for names in order for name in sorted(names)):
            names = [n for n in texts if n.endswith(suffix) and package_of(n.removesuffix(f".{suffix}")) == package]
            rows = [f"| `{name}` | {_cell(texts[name])} |" for name in sorted(names) if texts[name]]
            parts.append(f"### {title}: {package}\n\n| file | contents |\n|---|---|\n" + "\n".join(rows) + "\n")
    return "\n".join(parts)


def _cell(text: str) -> str:
    parts = re.sub(r"``([^`]*)``", r"`\1`", " ".join(text.split())).replace("|", "\\|").split("`")
    return "`".join(part if k % 2 else re.sub(r"([*_<>$\[\]])", r"\\\1", part) for k, part in enumerate(parts))


def write(folder: Path) -> None:
    """Write the diagrams and the list of files that docs/organisation.md includes."""
    folder.mkdir(exist_ok=True)
    for name, layout, title in (
        ("package", package(), "The packages of lommel and their imports"),
        ("core", core(), "The folders of the compiled core and their includes"),
    ):
        (folder / f"{name}.svg").write_text(picture(layout, title), encoding="utf-8")
    (folder / "files.inc").write_text(listing(), encoding="utf-8")
