"""The formats of files: each says what it holds, how its files are known, and what writes and reads them.

Other packages add theirs by an entry point of the group ``lommel.formats`` that names a :class:`Format`; it is loaded
when a file is in none of the formats known so far. All but "field" write bytes, which are moved into place whole, and
raise ValueError for what they cannot hold or what is damaged:

============= ============================================== =======================================================
kind          write                                          read
============= ============================================== =======================================================
"psf"         (PSF, description) -> bytes                    bytes -> ({"values": array, ...}, text of description)
"field"       (PSFGrid, description, path), writes itself    (path, class of PSF) -> (PSF, description)
"photo"       (values, quality, ICC profile or None)         bytes -> (values, tags of EXIF, ICC profile or None)
"frames"      (list of values, milliseconds each, quality)   none
"depth map"   none                                           (bytes, metres a level or None) -> values, rows downwards
============= ============================================== =======================================================

A description is a dictionary of plain types, written as JSON after :func:`lommel.base.checksums.sealed` has added to
it the checksum of the arrays.
"""

from __future__ import annotations

import warnings
from dataclasses import dataclass
from functools import cache
from os import PathLike
from typing import Any

from lommel.base import optional, reading, validation

GROUP = "lommel.formats"

KINDS = {
    "psf": "a PSF",
    "field": "a grid of PSFs",
    "photo": "a photograph",
    "frames": "frames",
    "depth map": "a depth map",
}
"""What files hold, and what messages call it."""

_FORMATS: list[Format] = []


@dataclass(frozen=True)
class Format:
    """One way to have one kind of thing in files.

    Parameters
    ----------
    kind : str
        One of :data:`KINDS`.
    suffixes : tuple of str
        Of its files, in small letters, each with its dot.
    write, read : callable, optional
        What the table of this module says; None where it does not.
    starts : tuple of bytes, default ()
        What files begin with, where they are told by their content.
    holds : tuple of str, default ()
        What it holds that others of its kind do not, in words that follow those of the kind: "with derivatives".
    library, extra : str, default ""
        The library that it needs, as it is imported, and the extra of this package that brings it.
    """

    kind: str
    suffixes: tuple[str, ...]
    write: Any = None
    read: Any = None
    starts: tuple[bytes, ...] = ()
    holds: tuple[str, ...] = ()
    library: str = ""
    extra: str = ""

    def __post_init__(self) -> None:
        validation.choice("kind", self.kind, KINDS)


def register(*formats: Format) -> None:
    """Add formats.

    Parameters
    ----------
    *formats : Format

    Raises
    ------
    TypeError, ValueError
        If one is no Format, or has a suffix that another of its kind has.
    """
    for new in formats:
        validation.instance("format", new, Format)
        taken = {suffix for form in _FORMATS if form.kind == new.kind for suffix in form.suffixes}
        if both := taken.intersection(new.suffixes):
            raise ValueError(f"suffixes must be new for {KINDS[new.kind]}, got {', '.join(sorted(both))}")
        _FORMATS.append(new)


def find(
    kind: str, path: str | PathLike[str], name: str = "path", *, verb: str = "write", holding: str = ""
) -> Format:
    """Return the format of a path, told by its suffix.

    Parameters
    ----------
    kind : str
        One of :data:`KINDS`.
    path : path
    name : str, default "path"
        What messages call the path.
    verb : {"write", "read"}, default "write"
    holding : str, default ""
        What the format is to hold, one of :attr:`Format.holds`.

    Raises
    ------
    ValueError
        If there is none; the message has all suffixes that would do.
    ImportError
        If the format needs a library that is missing.
    """
    suffix = validation.path(name, path).suffix.lower()

    def able() -> list[Format]:
        return [form for form in _FORMATS if form.kind == kind and getattr(form, verb)]

    if not any(suffix in form.suffixes for form in able()):
        _load_others()
    fit = [form for form in able() if not holding or holding in form.holds]
    for form in fit:
        if suffix in form.suffixes:
            return _with_library(form)
    allowed = ", ".join(suffix for form in fit for suffix in form.suffixes)
    what = f"{KINDS[kind]} {holding}".rstrip()
    raise ValueError(
        f"{name} must end in {allowed or 'nothing known'} for {what}, "
        f"got {validation.shown(suffix)} in {validation.shown(str(path))}"
    )


def identify(kind: str, data: bytes) -> Format | None:
    """Return the format that reads the contents of a file, told by how they start; None if there is none.

    Parameters
    ----------
    kind : str
        One of :data:`KINDS`.
    data : bytes

    Raises
    ------
    ImportError
        If the format needs a library that is missing.
    """

    def told() -> Format | None:
        able = (form for form in _FORMATS if form.kind == kind and form.read)
        return next((form for form in able if data.startswith(form.starts)), None)

    form = told()
    if form is None:
        _load_others()
        form = told()
    return form and _with_library(form)


def _with_library(form: Format) -> Format:
    if form.library:
        optional.library(form.library, f"the format {form.suffixes[0]} needs", form.extra)
    return form


@cache
def _load_others() -> None:
    """Register what other packages bring, once; a warning tells of what fails, for the file may be of another."""
    from importlib.metadata import entry_points  # takes long

    for entry in entry_points(group=GROUP):
        try:
            register(entry.load())
        except Exception as error:
            said = f"the format {entry.name} ({entry.value}) of {GROUP} is left out: {reading.reason(error)}"
            warnings.warn(said, RuntimeWarning, stacklevel=4)
