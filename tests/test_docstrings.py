"""Docstrings of the reference say what goes in, what comes out, and what is raised."""

from __future__ import annotations

import ast
import inspect
import re
import textwrap
from pathlib import Path
from pkgutil import resolve_name
from typing import Any

import pytest

PAGE = Path(__file__).parents[1] / "docs" / "api.md"
ROOMS = ("lommel.imaging", "lommel.field", "lommel.lensfiles", "lommel.adapters", "lommel.optics.lens")


def referred() -> dict[str, Any]:
    """What the reference lists from these rooms, and the public methods of its classes."""
    found = {}
    for name in re.findall(r"^   ([\w.]+)$", PAGE.read_text(encoding="utf-8"), re.MULTILINE):
        thing = resolve_name(f"lommel.{name}")
        if not str(getattr(thing, "__module__", "")).startswith(ROOMS):
            continue
        found[name] = thing
        if isinstance(thing, type):
            own = {key: value for key, value in vars(thing).items() if not key.startswith("_")}
            methods = {key: getattr(value, "__func__", value) for key, value in own.items()}
            found |= {f"{name}.{key}": m for key, m in methods.items() if inspect.isfunction(m)}
    return found


def lacking(thing: Any) -> list[str]:
    """The sections that a docstring should have and has not, and the arguments that it does not name."""
    text = inspect.getdoc(thing) or ""
    if isinstance(thing, type) and issubclass(thing, Exception):
        return [] if text else ["a word"]
    section = {
        name: f"\n{name}\n{'-' * len(name)}\n" in text for name in ("Parameters", "Attributes", "Returns", "Raises")
    }
    signature = inspect.signature(thing)
    arguments = [name for name in signature.parameters if name not in ("self", "cls") and name[0] != "_"]
    found = [f"{name} of its arguments" for name in arguments if not re.search(rf"\b{name}\b", text)]
    if arguments and not (section["Parameters"] or (isinstance(thing, type) and section["Attributes"])):
        found.append("Parameters")
    if isinstance(thing, type):
        return found
    if signature.return_annotation not in ("None", None) and not section["Returns"]:
        found.append("Returns")
    body = ast.parse(textwrap.dedent(inspect.getsource(thing))).body[0].body  # type: ignore[attr-defined]
    if any(isinstance(node, ast.Raise) for part in body for node in ast.walk(part)) and not section["Raises"]:
        found.append("Raises")
    return found


REFERRED = referred()


def test_the_reference_has_these_rooms():
    assert len(REFERRED) > 60
    assert {"Lens.stopped", "FieldMap.psf", "imaging.DepthBlur.forward", "load_zernike"} <= REFERRED.keys()


@pytest.mark.parametrize("name", REFERRED)
def test_a_docstring_is_complete(name):
    assert lacking(REFERRED[name]) == []


def test_what_a_docstring_lacks_is_found():
    def f(a: int, b: int) -> int:
        """Do.

        Parameters
        ----------
        a : int
        """
        if a:
            raise ValueError
        return 1

    assert lacking(f) == ["b of its arguments", "Returns", "Raises"]
