"""What every public docstring says: its parameters, what it returns, what it raises.

Functions and classes have sections for them, as numpydoc reads them. A method may tell them in a sentence that names
each parameter in backquotes, and leave to the method that it overrides, or to the function that it links, what they
say.
"""

from __future__ import annotations

import ast
import contextlib
import functools
import inspect
import re
import textwrap
from collections.abc import Callable, Iterator
from importlib import import_module
from typing import Any

import pytest

import api
import lommel as lm
import organisation
from lommel import imaging, methods
from lommel.base import validation
from lommel.base.options import Options

LISTED = [name for _, listed, more in api.groups().values() for name in (*listed, *more)]
MODULES = {module.__name__.removeprefix("lommel."): module.__all__ for module in (imaging, methods)}
# Those that raise.
CHECKS = {name for name, thing in vars(validation).items() if inspect.isfunction(thing)} - {"shown", "brief", "line"}


def resolved(name: str) -> Any:
    """The thing of a dotted name below the package, whose modules are imported as they are met."""
    *modules, last = name.split(".")
    for k in range(len(modules), 0, -1):
        try:
            return functools.reduce(getattr, [*modules[k:], last], import_module(".".join(["lommel", *modules[:k]])))
        except ModuleNotFoundError as error:
            if not str(error.name).startswith("lommel"):
                return error  # of an adapter, without the package that it adapts
        except AttributeError:
            return None
    return functools.reduce(getattr, name.split("."), lm)


NAMES = [*LISTED, *lm.__all__, *(f"{module}.{name}" for module, names in MODULES.items() for name in names)]
KNOWN = {  # each by its first name
    thing: name for name in reversed(NAMES) if callable(thing := resolved(name))
}
THINGS = {name: thing for thing, name in KNOWN.items()}


def sections(doc: str | None) -> dict[str, str]:
    """The sections of a docstring by their names; what stands before them has none."""
    cut = re.split(r"^(\w[\w ]*)\n-{3,}$", inspect.cleandoc(doc or ""), flags=re.MULTILINE)
    assert len({*cut[1::2]}) == len(cut[1::2]), f"a section comes twice: {cut[1::2]}"
    return {"": cut[0], **dict(zip(cut[1::2], cut[2::2], strict=True))}


def explained(told: dict[str, str]) -> set[str]:
    """The names of parameters that sections explain."""
    heads = re.findall(r"^(\*{0,2}\w[\w, *]*?)(?: : .*)?$", told.get("Parameters", ""), flags=re.MULTILINE)
    heads += re.findall(r"^(\w[\w, ]*?)(?: : .*)?$", told.get("Attributes", ""), flags=re.MULTILINE)
    return {name.strip().lstrip("*") for head in heads for name in head.split(",")}


def parameters(thing: Callable[..., Any]) -> set[str]:
    return {name for name in inspect.signature(thing).parameters if name not in ("self", "cls") and name[0] != "_"}


def own(node: ast.AST) -> Iterator[ast.AST]:
    """The nodes of a function, without those of functions inside it."""
    for child in ast.iter_child_nodes(node):
        if not isinstance(child, ast.FunctionDef | ast.Lambda):
            yield child
            yield from own(child)


def raises(function: Callable[..., Any]) -> bool:
    """Whether a function raises by itself, or calls one of the checks that all entries share."""
    tree = ast.parse(textwrap.dedent(inspect.getsource(inspect.unwrap(function)))).body[0]
    for node in own(tree):
        if isinstance(node, ast.Raise) and "NotImplementedError" not in ast.unparse(node):
            return True
        if isinstance(node, ast.Call) and ast.unparse(node.func) in {f"validation.{check}" for check in CHECKS}:
            return True
    return False


def returns(function: Callable[..., Any]) -> bool:
    return inspect.signature(function).return_annotation not in (None, "None")


def lacking(thing: Any) -> list[str]:
    """What the docstring of a function or a class should have in sections, and has not."""
    told = sections(thing.__doc__)
    if inspect.isclass(thing) and issubclass(thing, Exception):
        return [] if told[""] else ["a word"]
    made = [made_by(thing, part) for part in ("__init__", "__post_init__")] if inspect.isclass(thing) else [thing]
    # What a base class checks of options that a class does not have is not an error of that class.
    made = made if parameters(thing) or not inspect.isclass(thing) else []
    # Options classes have the parameters of their base classes, too.
    bases = thing.__mro__[1:] if inspect.isclass(thing) and issubclass(thing, Options) else ()
    inherited = {name for base in bases for name in explained(sections(base.__doc__))}
    found = sorted(parameters(thing) - explained(told) - inherited)
    if not inspect.isclass(thing):
        found += sorted(explained(told) - parameters(thing))
        found += ["Returns"] if returns(thing) and not told.keys() & {"Returns", "Yields"} else []
    return found + (["Raises"] if any(f and raises(f) for f in made) and "Raises" not in told else [])


def made_by(kind: type, name: str) -> Callable[..., Any] | None:
    """A method as the package wrote it, not a dataclass."""
    function = getattr(kind, name, None)
    return function if inspect.isfunction(function) and function.__code__.co_filename != "<string>" else None


def test_every_name_that_the_reference_lists_is_there():
    assert [name for name in LISTED if resolved(name) is None] == []


@pytest.mark.quick  # nothing else reads the docstring of a new function
def test_a_public_thing_has_sections_for_parameters_results_and_errors():
    found = {name: lack for name, thing in THINGS.items() if (lack := lacking(thing))}
    assert found == {}, "docstrings lack these parameters and numpydoc sections: see Rules in CONTRIBUTING.md"


# Defaults, by their syntax: adapters too, whose packages need not be there.

DEFAULT = re.compile(r"^ *([\w, ]+?) : .*?, default (.+)$", re.MULTILINE)
AS_OF = re.compile(r"^ *([\w, ]+?)(?: : .*)?\n +As of :func:`(\w+)`", re.MULTILINE)


def defaults(node: ast.FunctionDef | ast.ClassDef) -> dict[str, ast.expr]:
    """The defaults of parameters, or of the fields of a dataclass."""
    if isinstance(node, ast.ClassDef):
        inside = [part for part in node.body if isinstance(part, ast.FunctionDef) and part.name == "__init__"]
        fields = [part for part in node.body if isinstance(part, ast.AnnAssign) and part.value]
        return defaults(inside[0]) if inside else {ast.unparse(part.target): part.value for part in fields}
    given = node.args
    positional = [*given.posonlyargs, *given.args]
    pairs = [*zip(positional[len(positional) - len(given.defaults) :], given.defaults, strict=True)]
    pairs += [(name, value) for name, value in zip(given.kwonlyargs, given.kw_defaults, strict=True) if value]
    return {name.arg: value for name, value in pairs}


def constants(tree: ast.Module) -> dict[str, Any]:
    """The numbers and texts that a module names."""
    found = {}
    for part in tree.body:
        if isinstance(part, ast.Assign) and isinstance(part.targets[0], ast.Name):
            with contextlib.suppress(ValueError):
                found[part.targets[0].id] = ast.literal_eval(part.value)
    return found


def wrong_defaults(tree: ast.Module) -> Iterator[str]:
    """Which defaults are not those that the docstring states, or not those of the function that it refers to."""
    nodes = [node for node in ast.walk(tree) if isinstance(node, ast.FunctionDef | ast.ClassDef)]
    named = {node.name: defaults(node) for node in nodes}
    known = constants(tree)
    for node in nodes:
        stated, here = ast.get_docstring(node) or "", defaults(node)
        for names, default in DEFAULT.findall(stated):
            with contextlib.suppress(ValueError, SyntaxError):  # of those that a sentence states
                each = names.split(", ")
                value = ast.literal_eval(default)
                values = value if isinstance(value, tuple) and len(each) == len(value) > 1 else (value,) * len(each)
                for name, value in zip(each, values, strict=True):
                    given = here.get(name, ast.Name("inherited"))
                    found = known.get(given.id, value) if isinstance(given, ast.Name) else ast.literal_eval(given)
                    # None stands for a default that can be changed.
                    if found != value and (found, value) != (None, {}):
                        yield f"{node.name}: {name} is {ast.unparse(given)}, not {value}"
        for names, other in AS_OF.findall(stated):
            for name in names.split(", "):
                if other in named and name in here and name in named[other]:
                    mine, its = ast.unparse(here[name]), ast.unparse(named[other][name])
                    if mine != its:
                        yield f"{node.name}: {name} is {mine}, not {its} as of {other}"


def test_defaults_are_those_that_docstrings_state():
    wrong = {name: told for name, tree in organisation.modules().items() if (told := list(wrong_defaults(tree)))}
    assert wrong == {}


def test_no_docstring_has_a_modulus_that_sphinx_takes_for_a_substitution():
    # "|name|" is a substitution of reStructuredText unless it is quoted, and pages have warnings as errors.
    quoted, found = r"``.*?``|`[^`]*`|\.\. math::.*?(?=\n\S|\Z)", []
    for name, tree in organisation.modules().items():
        for node in ast.walk(tree):
            if isinstance(node, ast.ClassDef | ast.FunctionDef) and (doc := ast.get_docstring(node)):
                plain = re.sub(quoted, "", doc, flags=re.DOTALL)
                found += [f"{name}: {each}" for each in re.findall(r"(?<!\S)\|\w[^|\n]*\|", plain)]
    assert found == []
