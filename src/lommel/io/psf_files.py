"""Save and load PSFs, single or in colour channels, with a description of how the values were computed."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import AbstractContextManager
from dataclasses import replace
from functools import partial
from os import PathLike
from pathlib import Path
from typing import TypeVar

import numpy as np

from lommel.base import atomic, display, reading
from lommel.base.arrays import Values
from lommel.base.atomic import checksum
from lommel.base.optional import version
from lommel.base.options import filled
from lommel.blur.blurs import blurs_from_dicts
from lommel.io import fits_images, psf_formats, registry
from lommel.io.psf_formats import SLOPE, derivative_name
from lommel.io.registry import DAMAGED, Arrays, Description, Format
from lommel.measures.psf_like import ColourPSFLike, PSFLike
from lommel.methods import method_from_dict
from lommel.optics.base_pupil import BasePupil
from lommel.optics.colour.spectrum import Channels
from lommel.optics.grid import Grid
from lommel.optics.layers.objective_pupil import ObjectivePupil
from lommel.optics.pupil import FieldPupil, Pupil

Made = TypeVar("Made", bound=PSFLike)
_Result = TypeVar("_Result")

_form, _DERIVATIVES = partial(Format, "psf"), ("with derivatives",)
registry.register(
    _form((".tif", ".tiff"), psf_formats.write_tiff, psf_formats.read_tiff, library="tifffile",
          what="OME-TIFF", readers="Fiji, Bio-Formats, napari"),
    _form((".npy",), psf_formats.write_npy, psf_formats.read_npy,
          what="NumPy array", readers="NumPy, cnpy"),
    _form((".npz",), psf_formats.write_npz, psf_formats.read_npz, holds=_DERIVATIVES,
          what="NumPy archive", readers="NumPy, cnpy"),
    _form((".png",), psf_formats.write_png, library="PIL.Image",
          what="16-bit picture, square root of the values", readers="every picture viewer"),
    _form(fits_images.SUFFIXES, psf_formats.write_fits, psf_formats.read_fits, library="astropy",
          what="FITS", readers="astropy, DS9, MATLAB, Fiji"),
    _form(fits_images.PACKED, fits_images.packed(psf_formats.write_fits), psf_formats.read_fits, library="astropy",
          what="compressed FITS", readers="astropy, DS9"),
    _form((".h5", ".hdf5"), psf_formats.write_hdf5, psf_formats.read_hdf5, library="h5py", holds=_DERIVATIVES,
          what="HDF5", readers="h5py, MATLAB, Julia"),
    _form((".mat",), psf_formats.write_mat, psf_formats.read_mat, library="h5py",
          what="MATLAB 7.3", readers="MATLAB since R2006b, h5py; not SciPy"),
)  # fmt: skip
find = partial(registry.find, "psf")


class FileError(ValueError):
    """A file that is damaged, or was not written by this package."""


@display.save.register(PSFLike)
@filled(formats=registry.listing("psf"))
def save(psf: PSFLike, path: str | PathLike[str]) -> None:
    """Write a PSF; the suffix chooses the format.

    {formats}

    NumPy archives and HDF5 also hold derivatives. A PNG shows a single PSF, enlarged to 512 pixels or more, and
    cannot be loaded. For other programs see :doc:`/formats`.

    Every other file has a description in JSON: version, pupil, method with its options, normalization, pixel, error
    bound, and a checksum of description and values, which loading requires. A file is written under a temporary name
    and moved into place, so that after an error the previous file remains; links are followed and permissions kept.

    Parameters
    ----------
    psf : PSF
    path : path

    Raises
    ------
    ValueError
        If the suffix is unknown, for a PNG of a stack, or for derivatives in a format that cannot hold them.
    ImportError
        If tifffile, Pillow, astropy or h5py is not installed.
    OSError
        If the file cannot be written.
    """
    form = find(path, holding="with derivatives" if psf.derivatives else "")
    write(form, Path(path), psf, describe(psf))


def write(form: Format, target: Path, psf: PSFLike | ColourPSFLike, description: Description) -> None:
    """Write PSFs and their description."""
    atomic.write(target, form.write(psf, description))


@display.register("load PSF")
def load(path: str | PathLike[str], kind: Callable[..., Made]) -> Made:
    """Read a PSF, which `kind` builds; FileError if the file is damaged or was not written by this package."""
    return read(find(path, verb="read"), Path(path), "a PSF", partial(rebuild, kind=kind))


def read(form: Format, source: Path, contents: str, rebuild: Callable[[Arrays, Description], _Result]) -> _Result:
    """Return ``rebuild(arrays, description)`` for a file with `contents`, such as "a PSF"; FileError if damaged."""
    data = reading.contents(source)
    with as_file_error(source, contents):
        arrays, text = form.read(data)
        return rebuild(arrays, reading.json(text))


def as_file_error(source: Path, contents: str) -> AbstractContextManager[None]:
    """Convert every error except ImportError to a FileError that names the file."""
    return reading.refused_as(FileError, source, f"is not {contents} written by lommel")


def describe(psf: PSFLike) -> Description:
    """Return a description of how a PSF was computed, in plain types.

    Parameters
    ----------
    psf : PSF

    Returns
    -------
    dict
        All attributes but the values and derivatives; ``lommel.base.atomic.sealed`` adds the checksum.
    """
    # Optional entries are written only if needed, so that most files equal the files of older versions.
    optional_entries: Description = {"fill": list(psf.grid.fill)} if psf.grid.partly else {}
    if psf.blur:
        optional_entries["blur"] = [blur.to_dict() for blur in psf.blur]
    return {
        "software": f"lommel {version()}",
        "pupil": {"kind": type(psf.pupil).__name__} | psf.pupil.to_dict(),
        "method": psf.method.to_dict(),
        "sampling": psf.sampling,
        "normalize": psf.normalize,
        "pixel": psf.pixel,
        "center": [np.asarray(part).tolist() for part in psf.grid.center],
        "integrate": psf.grid.integrate,
        **optional_entries,
        "unit": psf.unit,
        "error_bound": psf.error_bound,
        "derivative_bounds": {str(name): bound for name, bound in psf.derivative_bounds.items()},
        "scale": psf.scale.tolist(),
        "shape": list(psf.shape),
        "dtype": str(psf.values.dtype),
    }


def rebuild(arrays: Arrays, description: Description, kind: Callable[..., Made]) -> Made:
    """Return the PSF that `kind` builds from the arrays of a file and the description with its checksum."""
    if "channels" in description:
        raise ValueError("it has channels; ColourPSF.load, or PSFGrid.load, reads it")
    _require_intact(arrays, description)
    return _build(arrays, description, kind)


def _require_intact(arrays: Arrays, description: Description) -> None:
    """Raise ValueError unless the checksum of the description is that of arrays and description."""
    if "checksum" not in description:
        raise ValueError("it has no checksum, so it may be incomplete; save it again")
    if description["checksum"] != checksum(description, arrays):
        raise ValueError(DAMAGED)


def _build(arrays: Arrays, description: Description, kind: Callable[..., Made]) -> Made:
    """Return the PSF that `kind` builds from arrays and a description that are as they were written."""
    entries = dict(description["pupil"])  # files of older versions have no kind: the pupil is a Pupil
    kinds = {pupil_class.__name__: pupil_class for pupil_class in (Pupil, ObjectivePupil, FieldPupil)}
    pupil: BasePupil = kinds[entries.pop("kind", "Pupil")].from_dict(entries)
    shape = tuple(description["shape"])

    def restored(stored: Values) -> Values:
        return stored.astype(description["dtype"], copy=False).reshape(shape)  # in the byte order of this machine

    return kind(
        values=restored(arrays["values"]),
        grid=Grid(
            shape[-2:],
            description["pixel"],
            center=description["center"],
            integrate=description["integrate"],
            fill=description.get("fill", 1.0),
        ),
        pupil=pupil,
        method=method_from_dict(description["method"]),
        normalize=description["normalize"],
        error_bound=description["error_bound"],
        scale=np.asarray(description["scale"], np.float64),
        derivatives={
            derivative_name(name.removeprefix(SLOPE)): restored(slope)
            for name, slope in arrays.items()
            if name.startswith(SLOPE)
        },
        blur=blurs_from_dicts(description.get("blur", ())),
        derivative_bounds={derivative_name(k): bound for k, bound in description["derivative_bounds"].items()},
    )


PICTURES = (psf_formats.write_tiff, psf_formats.write_png)  # these formats have other functions for channels
_PER_CHANNEL = ("pupil", "method", "error_bound", "scale")  # entries that the description has for each channel


def _write_tiff(answer: ColourPSFLike, description: Description) -> bytes:
    import tifffile

    values = np.ascontiguousarray(answer.values)
    fields = psf_formats.ome(answer, "CYX" if values.ndim == 3 else "ZCYX", description)
    fields["Channel"] = {"Name": list(answer.channels.names)}
    pages = values if values.ndim == 3 else values.reshape(-1, *values.shape[-3:])
    write = partial(tifffile.imwrite, photometric="minisblack")
    return atomic.contents(write, pages, ome=True, metadata=fields)


registry.register(
    *(replace(form, kind="colours", holds=()) for form in registry.formats("psf") if form.write not in PICTURES),
    Format("colours", (".tif", ".tiff"), _write_tiff, psf_formats.read_tiff, library="tifffile", what="OME-TIFF"),
    Format(
        "colours",
        (".png",),
        psf_formats.write_png,
        library="PIL.Image",
        what="8-bit picture, square root of the values",
    ),
)
find_colours = partial(registry.find, "colours")


@display.save.register(ColourPSFLike)
@filled(formats=registry.listing("colours"))
def save_colours(answer: ColourPSFLike, path: str | PathLike[str]) -> None:
    """Write PSFs in channels; the suffix chooses the format.

    {formats}

    A PNG shows the square root of the values over the largest of all channels, three channels as red, green and blue,
    a single one in grey, enlarged to 512 pixels or more; it cannot be loaded. Other files have the description of
    :func:`lommel.io.psf_files.save` and the channels.

    Parameters
    ----------
    answer : ColourPSF
    path : path

    Raises
    ------
    ValueError
        If the suffix is unknown, for derivatives, or for a PNG of a stack or of channels that are neither one nor
        three.
    ImportError
        If tifffile, Pillow, astropy or h5py is not installed.
    OSError
        If the file cannot be written.
    """
    write(find_colours(path), Path(path), answer, describe_colours(answer))


@display.register("load channels")
def load_colours(path: str | PathLike[str], kind: Callable[..., Made]) -> tuple[Channels, tuple[Made, ...]]:
    """Read channels and their PSFs, which `kind` builds; FileError if the file is damaged or has other contents."""
    form = find_colours(path, verb="read")
    return read(form, Path(path), "a PSF in channels", partial(rebuild_colours, kind=kind))


def describe_colours(answer: ColourPSFLike) -> Description:
    """Return the description of the first PSF and the entries that each channel has; ValueError for derivatives."""
    if any(psf.derivatives for psf in answer.psfs):
        raise ValueError('derivatives are saved channel by channel, as by answer["red"].save("red.npz")')
    descriptions = [describe(psf) for psf in answer.psfs]
    entries = [{name: item[name] for name in _PER_CHANNEL} for item in descriptions]
    return descriptions[0] | {"channels": answer.channels.to_dict(), "each": entries, "shape": list(answer.shape)}


def rebuild_colours(
    arrays: Arrays, description: Description, kind: Callable[..., Made]
) -> tuple[Channels, tuple[Made, ...]]:
    """Return the channels and their PSFs, which `kind` builds, from the arrays and the description of a file."""
    if "channels" not in description:
        raise ValueError("it has no channels; PSF.load reads it")
    values = np.ascontiguousarray(arrays["values"]).reshape(description["shape"])
    _require_intact({"values": values}, description)
    channels, channel_entries = Channels.from_dict(description["channels"]), description["each"]
    psfs, common = [], {name: entries for name, entries in description.items() if name not in ("channels", "each")}
    for channel_values, channel in zip(np.moveaxis(values, -3, 0), channel_entries, strict=True):
        entries = common | {name: channel[name] for name in _PER_CHANNEL} | {"shape": list(channel_values.shape)}
        psfs.append(_build({"values": channel_values}, entries, kind))
    return channels, tuple(psfs)
