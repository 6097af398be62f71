"""Registry of file formats: contents, signatures, readers and writers."""

from __future__ import annotations

from dataclasses import dataclass
from os import PathLike
from pathlib import Path
from typing import Any, TypeAlias

from lommel.base import optional, validation
from lommel.base.arrays import Json, Values

KINDS = {
    "psf": "a PSF",
    "colours": "a PSF in channels",
    "field": "a grid of PSFs",
    "photo": "a photograph",
    "depth map": "depth",
    "images": "images",
    "zernike": "Zernike coefficients",
    "opd": "an OPD map",
    "molecules": "a table of molecules",
    "video": "video",
}
"""The kinds of contents of files, and their names in messages."""

Arrays: TypeAlias = dict[str, Values]
"""The arrays of a file, by name."""

Description: TypeAlias = Json
"""Description of how a PSF was computed, in plain types; stored as JSON."""

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
"""The extra of this package that installs a library, by the name of the library."""

_FORMATS: list[Format] = []


@dataclass(frozen=True)
class Format:
    """One file format of one kind of contents.

    :func:`lommel.io.registry.register` adds formats.

    Parameters
    ----------
    kind : str
        "psf", "colours", "field", "photo", "depth map", "images", "zernike", "opd", "molecules" or "video".
    suffixes : tuple of str
        Suffixes of the files, in lower case and with a dot.
    write, read : callable, optional
        Functions as described in the notes; None if the format cannot be written or read.
    starts : tuple of bytes, default ()
        First bytes of the files, if they identify the format.
    holds : tuple of str, default ()
        Contents that this format supports and that other formats of the kind may not, such as "with derivatives" or
        "of uint16". In messages they follow the name of the kind.
    library : str, default ""
        Import name of a required library.
    beside : str, default ""
        Suffix of a second file that belongs to the first file; ``write`` returns the bytes of both files, and the
        arguments of ``read`` are both.
    what : str, default ""
        Short name of the format for help texts: "OME-TIFF".
    readers : str, default ""
        Other programs that read the format, for the table of formats.

    Notes
    -----
    Signatures of ``write`` and ``read`` for each kind:

    - "psf": write(PSF, description) -> bytes; read(bytes) -> (dict of arrays: "values" and derivatives, description
      as text)
    - "colours": as "psf", for a ColourPSF; pictures are not read
    - "field": write(PSFGrid, description, path), which writes the file itself; read(path, class of PSF) -> (PSF,
      description)
    - "photo": write(values, ICC profile or None) -> bytes, and if `holds` has "with EXIF" a third argument,
      the EXIF bytes; read(bytes) -> (values, EXIF tags, ICC profile or None), optionally followed by the EXIF bytes
    - "depth map": write(float32 values) -> bytes; read(bytes, metres per level or None) -> values
    - "images": read(bytes, name of one of several images or None) -> (values, header); the values have the shape
      (height, width) or (n, height, width), the header has the names of FITS
    - "opd": write(OPDMap) -> bytes; read(bytes) -> ``lommel.io.opd_files.Measured``
    - "molecules": write(path[, path beside]) -> context manager that yields a function of rows and a
      ``lommel.localize.MovieInfo``, which is called repeatedly
    - "video": write(path, seconds between frames, comment) -> context manager that yields a function of values and
      time (seconds) of a frame; ``lommel.io.videos`` reads videos
    - "zernike": write(settings, terms) -> text, both dicts by name; read(bytes) -> (ZernikeTable or None, errors)

    Files are moved into place when they are complete. ``write`` raises ValueError for contents that the format does
    not support, ``read`` for damaged contents. A description is a dictionary of plain types, written as JSON after
    ``lommel.base.atomic.sealed`` has added a checksum of description and arrays.
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

    @property
    def name(self) -> str:
        """Name in messages: the longest suffix in capitals without its dot, such as JPEG."""
        return max(self.suffixes, key=len).lstrip(".").upper()

    def places(self, path: Path) -> tuple[Path, ...]:
        """Return the paths of the files of this format: `path`, and the second file if the format has one."""
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

    """
    _FORMATS.extend(new_formats)


def find(
    kind: str, path: str | PathLike[str], name: str = "path", *, verb: str = "write", holding: str = ""
) -> Format:
    """Return the format of a path from its suffix; ValueError with all suffixes if the suffix is unknown.

    `verb` is "write" or "read", `name` the name of the path in messages, and `holding` a required entry of
    :attr:`Format.holds`. ImportError if the library of the format is missing.
    """
    suffixes = validation.path(name, path).suffixes
    suffix, end = "".join(suffixes[-1:]).lower(), "".join(suffixes[-2:]).lower()  # .fits.gz consists of two suffixes
    forms = [form for form in _formats_with(kind, verb) if not holding or holding in form.holds]
    for form in forms:
        if end.endswith(form.suffixes):
            return form.ready()
        if suffix and suffix == form.beside:
            main_suffix = form.suffixes[0]
            raise ValueError(f"{name} must be the {main_suffix} file to which {validation.shown(str(path))} belongs")
    allowed = ", ".join(suffix for form in forms for suffix in form.suffixes) or "nothing known"
    got = f"{validation.shown(suffix)} in {validation.shown(str(path))}"
    raise ValueError(f"{name} must end in {allowed} for {f'{KINDS[kind]} {holding}'.rstrip()}, got {got}")


def identify(kind: str, data: bytes) -> Format:
    """Return the format of a file from its first bytes; ValueError if unknown, ImportError without the library."""
    for form in _formats_with(kind, "read") if data else ():
        if data.startswith(form.starts):
            return form.ready()
    *first_names, last_name = dict.fromkeys(form.name for form in _formats_with(kind, "read") if form.starts)
    raise ValueError(f"is not a {', '.join(first_names)} or {last_name} file" if data else "is empty")


def suffixes(kind: str, *, described: bool = False) -> str:
    """Return the first suffix of each writable format of a kind as text, with the format's name if `described`."""
    return ", ".join(
        form.suffixes[0] + (f" ({form.what})" if described and form.what else "")
        for form in _formats_with(kind, "write")
    )


def listing(kind: str) -> str:
    """Return a list of the writable formats of a kind, for a docstring."""
    lines = [
        f"- {', '.join(f'``{suffix}``' for suffix in form.suffixes)}: {form.what}."
        for form in _formats_with(kind, "write")
    ]
    return "\n    ".join(lines)


def formats(kind: str) -> list[Format]:
    """Return the formats of a kind."""
    return [form for form in _FORMATS if form.kind == kind]


def _formats_with(kind: str, verb: str) -> list[Format]:
    """Return the formats of a kind that have the function `verb`, "write" or "read"."""
    return [form for form in formats(kind) if getattr(form, verb)]
