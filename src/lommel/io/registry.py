"""The formats of files: each says what it holds, how its files are known, and what writes and reads them."""

from __future__ import annotations

import warnings
from dataclasses import dataclass
from functools import cache
from os import PathLike
from pathlib import Path
from typing import Any

from lommel.base import optional, reading, validation

KINDS = {
    "psf": "a PSF",
    "colours": "a PSF in channels",
    "field": "a grid of PSFs",
    "photo": "a photograph",
    "frames": "frames",
    "depth map": "depth",
    "images": "images",
    "zernike": "Zernike coefficients",
    "opd": "a map of path differences",
}
"""What files hold, and what messages call it."""

_FORMATS: list[Format] = []


@dataclass(frozen=True)
class Format:
    """One way to have one kind of thing in files.

    A package adds one by an entry point of the group ``lommel.formats`` that names it. It is loaded when a file is in
    none of the formats known so far.

    Parameters
    ----------
    kind : {"psf", "colours", "field", "photo", "frames", "depth map", "images", "zernike", "opd"}
    suffixes : tuple of str
        Of its files, in small letters, each with its dot.
    write, read : callable, optional
        See the notes; None where it does not.
    starts : tuple of bytes, default ()
        What files begin with, where they are told by their content.
    holds : tuple of str, default ()
        What not all of its kind hold, in words that follow those of the kind: "with derivatives", "of uint16".
    library, extra : str, default ""
        The library that it needs, as it is imported, and the extra of this package that brings it.
    beside : str, default ""
        The suffix of a second file that belongs to the first; of these, ``write`` returns and ``read`` takes both.

    Raises
    ------
    ValueError
        If there is no such kind.

    Notes
    -----
    ``write`` and ``read`` are, for each kind:

    - "psf": (PSF, description) to bytes; bytes to (``{"values": array}`` and derivatives, text of a description);
      a format with a file `beside`: to (bytes, bytes beside), and from both
    - "colours": as "psf", of a ColourPSF; a picture has nothing to read
    - "field": (PSFGrid, description, path), which writes by itself; (path, class of PSF) to (PSF, description)
    - "photo": (values, quality, ICC profile or None) to bytes; bytes to (values, tags of EXIF, ICC profile or None)
    - "frames": (list of values, milliseconds each, quality) to bytes
    - "depth map": values of float32 to bytes; (bytes, metres a level or None) to values
    - "images": read only, bytes to values, shape (height, width) or (n, height, width)
    - "opd": OPDMap to bytes; bytes to ``lommel.io.opd_files.Measured``
    - "zernike": read only, bytes to (ZernikeTable or None, what is wrong with it)

    What is written as bytes is moved into place whole. What cannot be held, or is damaged, is a ValueError. A
    description is a dictionary of plain types, written as JSON after ``lommel.base.checksums.sealed`` has added the
    checksum of the arrays.
    """

    kind: str
    suffixes: tuple[str, ...]
    write: Any = None
    read: Any = None
    starts: tuple[bytes, ...] = ()
    holds: tuple[str, ...] = ()
    library: str = ""
    extra: str = ""
    beside: str = ""

    def __post_init__(self) -> None:
        validation.choice("kind", self.kind, KINDS)

    @property
    def name(self) -> str:
        """What messages call it: the longest of its suffixes, such as JPEG."""
        return max(self.suffixes, key=len).lstrip(".").upper()

    def places(self, path: Path) -> tuple[Path, ...]:
        """Return a `path`, and that of the file beside it if there is one."""
        return (path, path.with_suffix(self.beside)) if self.beside else (path,)

    def ready(self) -> Format:
        """Return this format; ImportError if its library is missing."""
        if self.library:
            optional.library(self.library, f"the format {self.name} needs", self.extra)
        return self


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
    """Return the format of a path by its suffix, ready to write or read; ValueError with all suffixes if none is.

    `name` is what messages call the path, `holding` one of :attr:`Format.holds`.
    """
    suffixes = validation.path(name, path).suffixes
    suffix, end = "".join(suffixes[-1:]).lower(), "".join(suffixes[-2:]).lower()  # which .fits.gz is
    if not any(end.endswith(form.suffixes) for form in _able(kind, verb)):
        _load_others()
    fit = [form for form in _able(kind, verb) if not holding or holding in form.holds]
    for form in fit:
        if end.endswith(form.suffixes):
            return form.ready()
    raise ValueError(
        f"{name} must end in {', '.join(suffix for form in fit for suffix in form.suffixes) or 'nothing known'} for "
        f"{f'{KINDS[kind]} {holding}'.rstrip()}, got {validation.shown(suffix)} in {validation.shown(str(path))}"
    )


def identify(kind: str, data: bytes) -> Format:
    """Return the format of the contents of a file by how they start, ready to read; ValueError if there is none."""
    for load in (None, _load_others) if data else ():
        if load:
            load()
        for form in _able(kind, "read"):
            if data.startswith(form.starts):
                return form.ready()
    *most, last = dict.fromkeys(form.name for form in _able(kind, "read") if form.starts)
    raise ValueError(f"is not a {', '.join(most)} or {last} file" if data else "is empty")


def _able(kind: str, verb: str) -> list[Format]:
    return [form for form in _FORMATS if form.kind == kind and getattr(form, verb)]


@cache
def _load_others() -> None:
    """Register what other packages bring, once; a warning tells of what fails, for the file may be of another."""
    from importlib.metadata import entry_points  # takes long

    for entry in entry_points(group="lommel.formats"):
        try:
            register(entry.load())
        except Exception as error:
            said = f"the format {entry.name} ({entry.value}) is left out: {reading.reason(error)}"
            warnings.warn(said, RuntimeWarning, stacklevel=4)
