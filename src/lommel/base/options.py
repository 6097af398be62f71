"""Options of jobs: frozen dataclasses whose annotations state types, ranges and units, checked in one place."""

from __future__ import annotations

import dataclasses
import difflib
import inspect
import math
import re
import types
from collections.abc import Callable, Iterable, Mapping
from functools import cache
from typing import Annotated, Any, Literal, NamedTuple, Self, TypeVar, Union, get_args, get_origin, get_type_hints

from lommel.base import validation
from lommel.base.validation import shown

_Callable = TypeVar("_Callable", bound=Callable[..., object])


class In(NamedTuple):
    """Range of a number and its unit, in an annotation: ``Annotated[float, In(above=0.0, unit="metres")]``.

    The limits are those of :func:`lommel.base.validation.real`; of an integer, `least` and `most` are used.
    """

    above: float = -math.inf
    least: float = -math.inf
    below: float = math.inf
    most: float = math.inf
    infinite: bool = False
    unit: str = ""


class Shown(NamedTuple):
    """Form of an option on the command line, in an annotation; by default the flag is the name of the field.

    Parameters
    ----------
    flags : tuple of str
        Flags instead of ``--name``. The last flag with two dashes is the one in messages.
    length : str
        Unit of typical values ("m", "mm", "um", "nm") of a length, which has a unit on the command line and is in
        metres in Python.
    metavar : str
        Name of the value in the help.
    parse : callable
        Function that returns the value of a text, and raises ValueError.
    negative : str
        Flag for False, of an option that is True, False or None.
    writes : bool
        True for a path that is written: it must differ from all paths that are read or written.
    figure : bool
        True for a path to which a figure is drawn.
    hidden : bool
        True for a field that only Python has.
    """

    flags: tuple[str, ...] = ()
    length: str = ""
    metavar: str = ""
    parse: Callable[[str], Any] | None = None
    negative: str = ""
    writes: bool = False
    figure: bool = False
    hidden: bool = False


HIDDEN = Shown(hidden=True)


class Field(NamedTuple):
    """An option as its annotation states it; `kind` is its type without None, `checks` return converted values."""

    name: str
    kind: Any
    optional: bool
    limits: In
    shown: Shown
    checks: tuple[Callable[[str, Any], Any], ...]
    default: Any

    @classmethod
    def of(cls, name: str, hint: Any, default: Any) -> Self:
        """Return the parts of an annotation."""
        marks: tuple[Any, ...] = ()
        optional = False
        while True:
            if get_origin(hint) is Annotated:
                marks += hint.__metadata__
                hint = hint.__origin__
            elif get_origin(hint) in (types.UnionType, Union) and type(None) in get_args(hint):
                optional = True
                hint = Union[tuple(kind for kind in get_args(hint) if kind is not type(None))]  # noqa: UP007
            else:
                break
        limits = next((mark for mark in marks if isinstance(mark, In)), In())
        form = next((mark for mark in marks if isinstance(mark, Shown)), Shown())
        checks = tuple(mark for mark in marks if callable(mark))
        return cls(name, hint, optional, limits, form, checks, default)

    def check(self, value: Any) -> Any:
        """Return a value, converted; TypeError or ValueError names the field and what is allowed."""
        if value is None and (self.optional or self.kind is Any):
            return None
        if self.kind is bool:
            validation.truth(self.name, value)
        elif self.kind is int:
            least, most = (
                int(max(-(2.0**62), min(bound, 2.0**62))) for bound in (self.limits.least, self.limits.most)
            )
            value = validation.integer(self.name, value, least=least, most=most)
        elif self.kind is float:
            value = validation.real(self.name, value, **self.limits._asdict())
        elif self.kind is str:
            validation.instance(self.name, value, str)
        elif get_origin(self.kind) is Literal:
            validation.choice(self.name, value, get_args(self.kind))
        elif get_origin(self.kind) is Callable or self.kind is Callable:
            validation.function(self.name, value)
        for check in self.checks:
            value = check(self.name, value)
        return value


def fields_of(kind: Any) -> tuple[Field, ...]:
    """Return the fields of an options class; those of base classes come first."""
    return _fields_of(kind)


@cache
def _fields_of(kind: Any) -> tuple[Field, ...]:
    hints = get_type_hints(kind, include_extras=True)
    fields = ((item, item.default_factory) for item in dataclasses.fields(kind))
    return tuple(
        Field.of(item.name, hints[item.name], item.default if factory is dataclasses.MISSING else factory())
        for item, factory in fields
    )


@dataclasses.dataclass(frozen=True, kw_only=True)
class Options:
    """Base class of the options of a job, frozen dataclasses with ``kw_only=True``.

    An annotation states the type of a field, a range (:class:`In`), functions ``check(name, value)`` that return the
    value or raise an error, and the form on the command line (:class:`Shown`). The section Parameters of the
    docstring is the reference of the job's function, which :func:`listed` writes, and the help of its command.
    """

    def __post_init__(self) -> None:
        for field in fields_of(type(self)):
            object.__setattr__(self, field.name, field.check(getattr(self, field.name)))

    @classmethod
    def of(cls, job: str, options: Self | None, given: Mapping[str, Any]) -> Self:
        """Return options, changed by keywords; TypeError with a suggestion for a keyword that is no option."""
        names = [field.name for field in fields_of(cls)]
        for name in given:
            if name not in names:
                raise TypeError(f"{job}() has no option {shown(name)}; {near(name, names)}")
        if options is None:
            return cls(**given)
        base = validation.instance("options", options, cls)
        return dataclasses.replace(base, **given) if given else base


def listed(kind: type, **defaults: object) -> Callable[[_Callable], _Callable]:
    """Return a decorator that lists the fields of an options class in a signature and its docstring (``{options}``).

    The function has the keywords ``**given``; `defaults` are those that differ from the class.
    """

    def show(function: _Callable) -> _Callable:
        call: Any = function.__init__ if isinstance(function, type) else function  # type: ignore[misc]
        signature = inspect.signature(call)
        own = [p for p in signature.parameters.values() if p.kind is not p.VAR_KEYWORD]
        hints = get_type_hints(kind)
        fields = [
            inspect.Parameter(
                field.name,
                inspect.Parameter.KEYWORD_ONLY,
                default=defaults.get(field.name, field.default),
                annotation=hints[field.name],
            )
            for field in fields_of(kind)
        ]
        call.__signature__ = signature.replace(parameters=[*own, *fields])
        if function.__doc__:  # there is none with python -OO
            text = "\n".join(f"{head} : {body}" for head, body in _texts(kind).items())
            function.__doc__ = inspect.cleandoc(function.__doc__).replace("{options}", text)
        return function

    return show


def filled(**texts: str) -> Callable[[_Callable], _Callable]:
    """Return a decorator that replaces ``{name}`` in a docstring by a text."""

    def decorate(function: _Callable) -> _Callable:
        for name, text in texts.items():
            if function.__doc__:  # there is none with python -OO
                function.__doc__ = function.__doc__.replace(f"{{{name}}}", text)
        return function

    return decorate


def sentences(source: Callable[..., object], name: str) -> str:
    """Return the description of a parameter from the docstring of `source`, in one line and without its type."""
    texts = (body for head, body in _texts(source).items() if name in head.split(", "))
    text = " ".join(next(texts, "").partition("\n")[2].split())
    return re.sub(r":\w+:`(?:[^`<]*\.)?([^`]+)`|`{1,2}([^`]+)`{1,2}", r"\1\2", text)


def _texts(source: Callable[..., object]) -> dict[str, str]:
    """Return the text (type and description) of each entry of the section Parameters; base classes come first."""
    texts: dict[str, str] = {}
    for kind in reversed(getattr(source, "__mro__", (source,))):
        section = inspect.cleandoc(kind.__doc__ or "").partition("Parameters\n----------\n")[2]
        section = re.split(r"\n\n(?=\w+\n-+\n)", section)[0]
        texts |= re.findall(r"^([\w, ]+?)(?: : |$)(.*(?:\n(?!\w).*)*)", section.rstrip(), re.MULTILINE)
    return texts


def near(name: str, known: Iterable[str]) -> str:
    """Return a suggestion for a misspelt name, or the list of all valid names."""
    names = {candidate.lower(): candidate for candidate in known}
    # The name is cut to 60 characters, since the time of difflib grows with the square of the length.
    matches = difflib.get_close_matches(name[:60].lower(), names, n=1)
    return f"did you mean {names[matches[0]]}?" if matches else f"known are {', '.join(names.values())}"
