"""The rooms of the code from the ground up, and pictures of them drawn from what their files import and include."""

from __future__ import annotations

import ast
import re
import textwrap
from collections import Counter
from dataclasses import dataclass
from functools import cache
from html import escape
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PACKAGE = ROOT / "src" / "lommel"
CORE = ROOT / "cpp" / "include" / "lommel"

# A room imports from those before it, and from itself; rooms of one line know nothing of each other.
ORDER = [
    {"base"},
    {"core"},
    {"special"},
    {"optics"},
    {"methods"},
    {"blur"},
    {"measures"},
    {"io"},
    {"show"},
    {"traced"},
    {"measured"},
    {"psf"},
    {"channel_psf"},
    {"estimation", "field", "stacks"},
    {"imaging"},
    {"lensfiles", "microscopy"},
    {"adapters", "page", "paper"},
    {"cli"},
    {"the package"},
]
# Those of the compiled core, by what they include.
CORE_ORDER = [
    {"question"},
    {"base"},
    {"bounds"},
    {"special"},
    {"pixels"},
    {"radial"},
    {"zernike"},
    {"chordal"},
    {"stratified"},
    {"paper", "imaging", "measures"},
]
# Files that stand in no folder of their room's name.
ALONE = {"_core": "core", "__main__": "cli", "__init__": "the package"}


def room(module: str) -> str:
    """Return the room of a module, given as its path from the package without suffix, such as methods/method."""
    first = module.split("/", maxsplit=1)[0]
    return ALONE.get(first, first)


def imported(tree: ast.AST) -> list[tuple[int, str]]:
    """Return the modules of the package that are imported anywhere, inside of functions too, each with the line."""
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


def _module(name: str) -> str:
    """Return the path of the module that a dotted name is, or is in."""
    path = PACKAGE.joinpath(*name.split(".")[1:])
    while not any(path.with_suffix(suffix).is_file() for suffix in (".py", ".pyi")):
        if (path / "__init__.py").is_file():
            path = path / "__init__"
            break
        path = path.parent
    return path.relative_to(PACKAGE).as_posix()


@cache
def modules() -> dict[str, ast.Module]:
    """Return the syntax tree of every file of the package, by its path without suffix."""
    return {
        path.relative_to(PACKAGE).with_suffix("").as_posix(): ast.parse(path.read_text(encoding="utf-8"))
        for path in sorted(PACKAGE.rglob("*.py"))
    }


def headers() -> dict[str, list[str]]:
    """Return what every header of the core includes of the others, by its path without suffix."""
    include = re.compile(r'^ *# *include "lommel/([\w/]+)\.hpp"', re.MULTILINE)
    return {
        path.relative_to(CORE).with_suffix("").as_posix(): include.findall(path.read_text(encoding="utf-8"))
        for path in sorted(CORE.rglob("*.hpp"))
    }


def upward(order: list[set[str]], here: str, needs: list[str]) -> list[str]:
    """Return what a file needs of rooms that do not stand before its own."""
    rank = {name: at for at, names in enumerate(order) for name in names}
    own = room(here)
    return [other for other in needs if room(other) != own and rank[room(other)] >= rank[own]]


@dataclass(frozen=True)
class House:
    """What there is to draw: rooms from the ground up, what each says of itself, its files, who needs whom."""

    rooms: list[str]
    about: dict[str, str]
    files: dict[str, list[str]]
    needs: Counter[tuple[str, str]]


def package() -> House:
    """Return the house of the package."""
    trees = modules()
    about = {
        room(name): ast.get_docstring(tree)
        for name, tree in trees.items()
        if name.endswith("__init__") or "/" not in name
    }
    about["cli"] = ast.get_docstring(trees["cli/__init__"])
    pairs = [(name, other) for name, tree in trees.items() for other in {other for _, other in imported(tree)}]
    return _house(ORDER, {r: (text or "").split("\n\n")[0] for r, text in about.items()}, list(trees), pairs)


def core() -> House:
    """Return the house of the compiled core."""
    return _house(
        CORE_ORDER, {}, list(headers()), [(name, other) for name, needs in headers().items() for other in needs]
    )


def _house(order: list[set[str]], about: dict[str, str], names: list[str], pairs: list[tuple[str, str]]) -> House:
    rooms = [name for names in order for name in sorted(names)]
    files: dict[str, list[str]] = {name: [] for name in rooms}
    for name in names:
        if "/" in name and not name.endswith("__init__"):
            files[room(name)].append(name.split("/", maxsplit=1)[1])
    needs = Counter((room(a), room(b)) for a, b in pairs if room(a) != room(b))
    return House(rooms, about, files, needs)


def picture(house: House, title: str) -> str:
    """Draw a house as SVG for a page: the ground floor below, and an arc from each room down to every one it needs.

    Pointing at a room shows what it needs; colours are those of the page, light or dark.
    """
    left, width, line = 120, 640, 17
    texts = {
        name: [
            *textwrap.wrap(re.sub(r":\w+:`(\w+)`", r"\1", house.about.get(name, "")), 76),
            *textwrap.wrap(" \u00b7 ".join(house.files[name]), 76, break_on_hyphens=False),
        ]
        for name in house.rooms
    }
    tops, top = {}, 4
    for name in reversed(house.rooms):
        tops[name] = top
        top += 30 + line * len(texts[name]) + 8
    parts = []
    for name in reversed(house.rooms):
        y, height = tops[name], 30 + line * len(texts[name])
        below = [(other, count) for (own, other), count in sorted(house.needs.items()) if own == name]
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
        hint = f"{name} needs {', '.join(f'{other} ({count})' for other, count in below) or 'no other room'}"
        parts.append(
            f'<g class="room"><title>{escape(hint)}</title>{"".join(arcs)}'
            f'<rect x="{left}" y="{y}" width="{width - left - 2}" height="{height}" rx="6"/>'
            f'<text class="name" x="{left + 14}" y="{y + 20}">{escape(name)}</text>{"".join(said)}</g>'
        )
    return (
        f'<svg class="rooms" role="img" viewBox="0 0 {width} {top}" xmlns="http://www.w3.org/2000/svg">'
        f"<title>{escape(title)}</title>{''.join(parts)}</svg>\n"
    )


def write(folder: Path) -> None:
    """Write the pictures that docs/organisation.md shows."""
    folder.mkdir(exist_ok=True)
    for name, house, title in (
        ("package", package(), "The rooms of the package, and what each imports"),
        ("core", core(), "The rooms of the compiled core, and what each includes"),
    ):
        (folder / f"{name}.svg").write_text(picture(house, title), encoding="utf-8")
