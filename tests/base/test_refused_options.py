"""What options of jobs refuse, generated from the annotations of all their classes."""

from __future__ import annotations

import dataclasses
import importlib
import math
from collections.abc import Iterator
from typing import Any, Literal, get_args, get_origin

import numpy as np
import pytest

from lommel.base.options import Field, Options, fields_of
from lommel.cli.main import COMMANDS

for module in {f"lommel.cli.{name}" for name in COMMANDS.values()}:
    importlib.import_module(module)

WRONG = {
    float: ["1", [1.0], math.nan, 1j, np.ma.masked],
    int: ["1", 1.5, True, 2**70],
    bool: [1, "yes"],
}


def classes(kind: type[Options] = Options) -> Iterator[type[Options]]:
    """The classes of the package all of whose fields have a default."""
    for child in kind.__subclasses__():
        required = any(field.default is dataclasses.MISSING for field in fields_of(child))
        if child.__module__.startswith("lommel.") and not required:
            yield child
        yield from classes(child)


CLASSES = sorted(set(classes()), key=lambda kind: (kind.__module__, kind.__name__))


def refused(field: Field) -> list[Any]:
    """Values of other types, just beyond the limits, and not finite."""
    limits, values = field.limits, list(WRONG.get(field.kind, []))
    values += [] if field.optional or field.checks or field.kind not in WRONG else [None]
    if get_origin(field.kind) is Literal:
        values += ["x", 3]
    if field.kind is float:
        values += [limit for limit in (limits.above, limits.below) if math.isfinite(limit)]
        values += [math.nextafter(limits.least, -math.inf)] if math.isfinite(limits.least) else []
        values += [math.nextafter(limits.most, math.inf)] if math.isfinite(limits.most) else []
        values += [] if limits.infinite else [math.inf, -math.inf]
    if field.kind is int:
        values += [int(limits.least) - 1] if math.isfinite(limits.least) else []
        values += [int(limits.most) + 1] if math.isfinite(limits.most) else []
    return values


@pytest.mark.parametrize("kind", CLASSES, ids=lambda kind: f"{kind.__module__}.{kind.__name__}")
def test_options_refuse_other_types_and_values_out_of_range_by_name(kind):
    for field in fields_of(kind):
        for value in refused(field):
            with pytest.raises((TypeError, ValueError)) as caught:
                kind(**{field.name: value})
            text = str(caught.value)
            assert text.startswith(field.name), (field.name, value, text)
            assert "\n" not in text
            assert len(text) < 300


@pytest.mark.parametrize("kind", CLASSES, ids=lambda kind: f"{kind.__module__}.{kind.__name__}")
def test_limits_are_allowed_and_a_misspelt_option_is_suggested(kind):
    for field in fields_of(kind):
        values = [limit for limit in (field.limits.least, field.limits.most) if math.isfinite(limit)]
        for value in (*map(field.kind, values), *(get_args(field.kind) if get_origin(field.kind) is Literal else ())):
            assert getattr(kind(**{field.name: value}), field.name) == value
    longest = max((field.name for field in fields_of(kind)), key=len)
    with pytest.raises(TypeError, match=f"job\\(\\) has no option '{longest}x'; did you mean {longest}"):
        kind.of("job", None, {f"{longest}x": 1})
    with pytest.raises(TypeError, match="options must be"):
        kind.of("job", "x", {})
