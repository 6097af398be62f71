"""One option has one default, by whatever function or command a photograph or a stack is made or restored."""

from __future__ import annotations

import importlib
import inspect
import pkgutil
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest

from lommel.cli.main import commands
from lommel.imaging.settings import Settings

EXCEPTIONS: dict[tuple[str, str], str] = {
    ("tol", "FieldBlur"): "bounds a sum of absolute differences, not the error over the peak",
    ("tol", "field_photograph"): "as of FieldBlur",
    ("tol", "StraightBlur"): "as of FieldBlur",
    ("tol", "bead"): "that of a PSF, as of lommel.psf, not of a blur",
    ("tol", "confocal"): "as of beads",
    ("tol", "light_sheet"): "as of beads",
    ("tol", "sted"): "as of beads",
    ("tol", "two_photon"): "as of beads",
    ("integrate", "bead"): "recorded by a camera, whose pixels average; scanned images are of points",
    ("normalize", "bead"): "is emission, in shares of its light; scanned images are relative to the focus",
    ("normalize", "light_sheet"): "as of beads",
    ("offset", "light_sheet"): "is a distance of sheet and focus, not a value of pixels",
    ("largest", "traced_blur"): "there is no image yet, half of whose side it could be",
    ("background", "Restoration"): "is what was found, not what to find",
    ("background", "RestoredChannel"): "as of Restoration",
    ("saturation", "restore_with"): "its light has no white that pixels could be full at",
    ("steps", "TotalVariation"): "counts steps of another kind than those of Richardson and Lucy",
    ("steps", "lommel restore"): "None takes that of the method",
    ("method", "lommel restore"): "spells out what None is elsewhere",
    ("sharp", "LiveDepth"): "asks for images, where lommel depth names a file",
    ("unknown", "Restoration"): "is the share that was found, not what means unknown",
    ("unknown", "lommel blur"): "is repeated for each value",
    ("unknown", "lommel restore"): "as of lommel blur",
    ("wavelength", "LensRanges"): "is the light of lenses drawn at random, which no file describes",
}
"""Options that differ, where, and why that is meant."""

PACKAGES = ("lommel.imaging", "lommel.microscopy")


def functions() -> Iterator[tuple[str, Any]]:
    """Yield what is public in the packages, and every other function or class there that takes several settings."""
    shown = {id(value) for package in PACKAGES for value in vars(importlib.import_module(package)).values()}
    settings = set(Settings.__annotations__)
    seen = set()
    for package in map(importlib.import_module, PACKAGES):
        names = [package.__name__, *(m.name for m in pkgutil.walk_packages(package.__path__, package.__name__ + "."))]
        for module in map(importlib.import_module, names):
            for name, found in vars(module).items():
                if name.startswith("_") or not (inspect.isfunction(found) or inspect.isclass(found)):
                    continue
                if not found.__module__.startswith(PACKAGES) or id(found) in seen:
                    continue
                seen.add(id(found))
                try:
                    taken = set(inspect.signature(found).parameters)
                except ValueError:  # of a class that is not made by calling it
                    continue
                if id(found) in shown or len(taken & settings) > 3:
                    yield name, found


def photo_commands() -> Iterator[tuple[str, Any]]:
    """Yield the commands that take photographs with their depth, or of different focus."""
    for name, command in commands().items():
        if {p.name for p in command.params} & {"photo", "photos"}:
            yield f"lommel {name}", command


def defaults() -> dict[str, dict[str, Any]]:
    """Return the defaults of each option by what takes it."""
    out: dict[str, dict[str, Any]] = {}
    for name, function in functions():
        for parameter in inspect.signature(function).parameters.values():
            if parameter.default is not parameter.empty:
                value = parameter.default
                if parameter.name == "dtype":
                    value = np.dtype(value)
                out.setdefault(parameter.name, {})[name] = value
    for name, command in photo_commands():
        parsed = command.make_context(name, [], resilient_parsing=True).params
        for parameter in command.params:
            if parameter.param_type_name == "option" and not parameter.required:
                value = parsed[str(parameter.name)]
                out.setdefault(str(parameter.name), {})[name] = None if value == () else value
    return out


DEFAULTS = defaults()


def test_all_ways_are_found():
    found = {name for name, _ in functions()} | {name for name, _ in photo_commands()}
    known = {
        "depth_of_field", "FocusPlan", "restore", "restore_with", "DepthBlur", "FieldBlur", "traced_blur", "Settings",
        "depth_from_defocus", "deconvolve", "StackBlur", "bead", "confocal", "sted", "light_sheet", "two_photon",
        "lommel blur", "lommel restore", "lommel depth",
    }  # fmt: skip
    assert known <= found


@pytest.mark.parametrize("option", [name for name, given in DEFAULTS.items() if len(given) > 1])
def test_an_option_has_one_default(option):
    alike = {where: value for where, value in DEFAULTS[option].items() if (option, where) not in EXCEPTIONS}
    assert len({repr(value) for value in alike.values()}) <= 1, alike


def test_exceptions_are_none_but_those_that_differ():
    for option, where in EXCEPTIONS:
        others = {repr(value) for name, value in DEFAULTS[option].items() if (option, name) not in EXCEPTIONS}
        assert repr(DEFAULTS[option][where]) not in others, (option, where)
    assert len({DEFAULTS["tol"][where] for where in ("bead", "confocal", "light_sheet", "sted", "two_photon")}) == 1


def test_near_things_hide_far_ones_wherever_photographs_are_made():
    assert set(map(repr, DEFAULTS["occlusion"].values())) == {"True"}
    assert len(DEFAULTS["occlusion"]) >= 6
