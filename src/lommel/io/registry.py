"""Registry of file formats: contents, signatures, readers and writers."""

from __future__ import annotations

import warnings
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from os import PathLike
from pathlib import Path
from typing import Any, TypeAlias, TypeVar

from lommel.base import optional, reading, validation
from lommel.base.arrays import Json, Values

KINDS = {
    "psf": "a PSF",
    "colours": "a PSF in channels",
    "field": "a grid of PSFs",
    "photo": "a photograph",
    "frames": "frames",
    "depth map": "depth",
    "images": "images",
    "zernike": "Zernike coefficients",
    "opd": "an OPD map",
    "molecules": "a table of molecules",
    "video": "video",
}
"""The kinds of contents, and their names in messages."""

Arrays: TypeAlias = dict[str, Values]
"""The arrays of a file, by name."""

Description: TypeAlias = Json
"""How a PSF was computed, in plain types, written as JSON."""

DAMAGED = "its checksum does not match: it is damaged, or was changed after it was written"

_EXTRAS = {
    "tifffile": "images",
    "PIL.Image": "images",
    "astropy": "fits",
    "h5py": "hdf5",
    "OpenEXR": "exr",
    "pillow_heif": "heic",
    "av": "video",
}
"""The extras of this package that install the libraries of formats."""

_FORMATS: list[Format] = []
_Function = TypeVar("_Function", bound=Callable[..., object])


@dataclass(frozen=True)
class Format:
    """One file format of one kind of contents.

    Other packages add formats by entry points of the group ``lommel.formats``, each naming a Format. They are loaded
    when a file has none of the formats known so far.

    Parameters
    ----------
    kind : str
        "psf", "colours", "field", "photo", "frames", "depth map", "images", "zernike", "opd", "molecules" or "video".
    suffixes : tuple of str
        Suffixes of its files, in lower case, each with its dot.
    write, read : callable, optional
        See the notes; None where the format cannot be written or read.
    starts : tuple of bytes, default ()
        First bytes of its files, where the contents tell the format.
    holds : tuple of str, default ()
        Contents that not all formats of the kind hold, in words that follow those of the kind: "with derivatives",
        "of uint16".
    library : str, default ""
        The library that it needs, as it is imported.
    beside : str, default ""
        Suffix of a second file that belongs to the first; ``write`` returns both and ``read`` takes both.
    what : str, default ""
        A few words about the contents, for help texts: "OME-TIFF".
    readers : str, default ""
        Other programs that read it, for the table of formats.

    Raises
    ------
    ValueError
        If the kind is unknown.

    Notes
    -----
    ``write`` and ``read`` are, for each kind:

    - "psf": (PSF, description) to bytes; bytes to (``{"values": array}`` and derivatives, text of a description);
      a format with a file `beside`: to (bytes, bytes beside), and from both
    - "colours": as "psf", of a ColourPSF; a picture has nothing to read
    - "field": (PSFGrid, description, path), which writes by itself; (path, class of PSF) to (PSF, description)
    - "photo": (values, quality, ICC profile or None) to bytes, and where it holds "with EXIF" a fourth, the bytes of
      EXIF; bytes to (values, tags of EXIF, ICC profile or None), and perhaps a fourth, the bytes of EXIF
    - "frames": (list of values, milliseconds each, quality) to bytes
    - "depth map": values of float32 to bytes; (bytes, metres per level or None) to values
    - "images": read only, (bytes, name of one of several images or None) to (values, header), values of the shape
      (height, width) or (n, height, width), the header with the names of FITS
    - "opd": OPDMap to bytes; bytes to ``lommel.io.opd_files.Measured``
    - "molecules": (path, path beside it, if any) to a context manager, which yields what is called with rows and a
      ``lommel.localize.Recording`` in turn
    - "video": (path, seconds from a frame to the next, comment) to a context manager, which is called with values and
      the time in seconds of each frame; read by ``lommel.io.videos``
    - "zernike": (settings, terms), both by name, to text; bytes to (ZernikeTable or None, list of errors)

    Bytes are moved into place as a whole. Contents that a format cannot hold, or that are damaged, are a ValueError.
    A description is a dictionary of plain types, written as JSON after ``lommel.base.atomic.sealed`` has added the
    checksum of the arrays.
    """

    kind: str
    suffixes: tuple[str, ...]
    write: Any = None
    read: Any = None
    starts: tuple[bytes, ...] = ()
    holds: tuple[str, ...] = ()
    library: str = ""
    beside: str = ""
    what: str = ""
    readers: str = ""

    def __post_init__(self) -> None:
        validation.choice("kind", self.kind, KINDS)

    @property
    def name(self) -> str:
        """The name in messages: the longest of its suffixes, such as JPEG."""
        return max(self.suffixes, key=len).lstrip(".").upper()

    def places(self, path: Path) -> tuple[Path, ...]:
        """Return the files of a `path`: itself, and the one beside it if there is one."""
        return (path, path.with_suffix(self.beside)) if self.beside else (path,)

    def ready(self) -> Format:
        """Return this format; ImportError if its library is missing."""
        if self.library:
            optional.library(self.library, f"the format {self.name} needs", _EXTRAS.get(self.library, ""))
        return self


def register(*new_formats: Format) -> None:
    """Add formats.

    Parameters
    ----------
    *new_formats : Format

    Raises
    ------
    TypeError, ValueError
        If one is not a Format, or another format of its kind has one of its suffixes.
    """
    for new in new_formats:
        validation.instance("format", new, Format)
        taken = {suffix for form in formats(new.kind) for suffix in form.suffixes}
        if both := taken.intersection(new.suffixes):
            raise ValueError(f"suffixes must be new for {KINDS[new.kind]}, got {', '.join(sorted(both))}")
        _FORMATS.append(new)


def find(
    kind: str, path: str | PathLike[str], name: str = "path", *, verb: str = "write", holding: str = ""
) -> Format:
    """Return the format of a path by its suffix, ready to write or read; ValueError with all suffixes if none fits.

    `name` is the path's name in messages, `holding` one of :attr:`Format.holds`.
    """
    suffixes = validation.path(name, path).suffixes
    suffix, end = "".join(suffixes[-1:]).lower(), "".join(suffixes[-2:]).lower()  # .fits.gz has two
    if not any(end.endswith(form.suffixes) for form in _able(kind, verb)):
        _load_others()
    fit = [form for form in _able(kind, verb) if not holding or holding in form.holds]
    for form in fit:
        if end.endswith(form.suffixes):
            return form.ready()
        if suffix and suffix == form.beside:
            first = form.suffixes[0]
            raise ValueError(f"{name} must be the {first} file to which {validation.shown(str(path))} belongs")
    raise ValueError(
        f"{name} must end in {', '.join(suffix for form in fit for suffix in form.suffixes) or 'nothing known'} for "
        f"{f'{KINDS[kind]} {holding}'.rstrip()}, got {validation.shown(suffix)} in {validation.shown(str(path))}"
    )


def identify(kind: str, data: bytes) -> Format:
    """Return the format of the contents of a file by their first bytes, ready to read; ValueError if none fits."""
    for load in (None, _load_others) if data else ():
        if load:
            load()
        for form in _able(kind, "read"):
            if data.startswith(form.starts):
                return form.ready()
    *most, last = dict.fromkeys(form.name for form in _able(kind, "read") if form.starts)
    raise ValueError(f"is not a {', '.join(most)} or {last} file" if data else "is empty")


def suffixes(kind: str, *, described: bool = False) -> str:
    """Return the suffixes that can be written in one line, perhaps with a few words about the contents of each."""
    return ", ".join(
        form.suffixes[0] + (f" ({form.what})" if described and form.what else "") for form in _able(kind, "write")
    )


def documented(kind: str) -> Callable[[_Function], _Function]:
    """Return a decorator that puts the list of a kind's formats in place of ``{formats}`` in a docstring."""
    lines = [
        f"{', '.join(f'``{suffix}``' for suffix in form.suffixes)}: {form.what}." for form in _able(kind, "write")
    ]

    def made(function: _Function) -> _Function:
        if function.__doc__:  # there is none with python -OO
            function.__doc__ = function.__doc__.replace("{formats}", "\n    ".join(f"- {line}" for line in lines))
        return function

    return made


def formats(kind: str) -> list[Format]:
    """Return the formats of a kind."""
    return [form for form in _FORMATS if form.kind == kind]


def _able(kind: str, verb: str) -> list[Format]:
    return [form for form in formats(kind) if getattr(form, verb)]


@cache
def _load_others() -> None:
    """Register the formats of other packages, once; one that fails is left out with a warning."""
    from importlib.metadata import entry_points  # takes long

    for entry in entry_points(group="lommel.formats"):
        try:
            register(entry.load())
        except Exception as error:
            said = f"the format {entry.name} ({entry.value}) is left out: {reading.reason(error)}"
            warnings.warn(said, RuntimeWarning, stacklevel=4)
