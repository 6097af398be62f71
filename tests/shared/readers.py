"""The public functions and methods that open files, found in the code: those whose calls lead to what opens one."""

from __future__ import annotations

import ast
import importlib
import inspect
import sys
import types
from collections.abc import Callable, Iterator
from typing import Any

import lommel
import organisation

# Whatever reads a file begins with one of these; ".read" is that of a format, or of anything else.
OPENERS = {"lommel.base.reading." + name for name in ("contents", "start", "size", "tiff_on_disk")} | {".read"}
PACKAGES = ("imaging", "localize", "microscopy")


def _calls(name: str, tree: ast.Module) -> Iterator[tuple[str, set[str]]]:
    """Yield each function of a module, and each class, with what it calls; names are whole."""
    module = "lommel." + name.replace("/", ".").removesuffix(".__init__")
    known: dict[str, str] = {}
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom):
            known |= {one.asname or one.name: f"{node.module}.{one.name}" for one in node.names}
    known |= {node.name: f"{module}.{node.name}" for node in tree.body if hasattr(node, "name")}

    def of(node: ast.AST, owner: str = "") -> set[str]:
        found = set()
        for one in ast.walk(node):
            if isinstance(one, ast.Name) and one.id in known:
                found.add(known[one.id])
            elif isinstance(one, ast.Constant) and str(one.value).startswith("load "):
                found.add(".read")  # what lommel.base.display calls by its name
            elif isinstance(one, ast.Call) and isinstance(one.func, ast.Attribute) and one.func.attr == "read":
                found.add(".read")
            elif isinstance(one, ast.Attribute) and isinstance(one.value, ast.Name):
                base = owner if one.value.id in ("self", "cls") else known.get(one.value.id)
                found.add(f"{base}.{one.attr}")
        return found

    for node in tree.body:
        if isinstance(node, ast.FunctionDef):
            yield f"{module}.{node.name}", of(node)
        elif isinstance(node, ast.ClassDef):
            own = f"{module}.{node.name}"
            methods = [one for one in node.body if isinstance(one, ast.FunctionDef)]
            for one in methods:
                yield f"{own}.{one.name}", of(one, own)
            yield own, {f"{own}.{one.name}" for one in methods if one.name in ("__init__", "__post_init__")}


def _opening() -> set[str]:
    """Return all functions whose calls lead to what opens a file."""
    calls = dict(call for name, tree in organisation.modules().items() for call in _calls(name, tree))
    found = set(OPENERS)
    while more := {name for name, called in calls.items() if called & found} - found:
        found |= more
    return found


def _public() -> Iterator[tuple[str, Any]]:
    """Yield public functions and methods by the names by which they are called."""
    for home in (lommel, *(importlib.import_module(f"lommel.{name}") for name in PACKAGES)):
        for name in home.__all__:
            value = getattr(home, name)
            where = name if home is lommel else f"{home.__name__.removeprefix('lommel.')}.{name}"
            if inspect.isclass(value):
                for own, member in inspect.getmembers(
                    value, lambda one: inspect.isfunction(one) or inspect.ismethod(one)
                ):
                    if not own.startswith("_"):
                        yield f"{where}.{own}", member
            elif inspect.isfunction(value):
                yield where, value


def public_readers() -> dict[str, types.CodeType]:
    """Return the code of each public function and method that opens a file, by its name."""
    opening = _opening()
    return {
        name: inspect.unwrap(getattr(one, "__func__", one)).__code__
        for name, one in _public()
        if f"{one.__module__}.{one.__qualname__}" in opening
    }


def called(work: Callable[[], object], wanted: set[types.CodeType]) -> set[types.CodeType]:
    """Return which of these functions some work calls, in this thread."""
    found, before = set[types.CodeType](), sys.gettrace()

    def note(frame: types.FrameType, _event: str, _: object) -> None:
        if frame.f_code in wanted:
            found.add(frame.f_code)

    sys.settrace(note)
    try:
        work()
    finally:
        sys.settrace(before)
    return found
