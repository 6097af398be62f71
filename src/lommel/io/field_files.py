"""Save and load grids of PSFs over the field, with the positions of the PSFs."""

from __future__ import annotations

import os
from collections.abc import Callable
from dataclasses import replace
from functools import partial
from os import PathLike
from pathlib import Path

import numpy as np

from lommel.base import atomic, validation
from lommel.base.arrays import Array
from lommel.base.atomic import sealed
from lommel.base.options import filled
from lommel.io import psf_files, psf_formats, registry, zarr_folders
from lommel.io.psf_files import FileError, Made
from lommel.io.registry import Arrays, Description, Format
from lommel.io.zarr_folders import Layout, ZarrArray
from lommel.measures.psf_like import ColourPSFLike, PSFGridLike, is_psf
from lommel.optics.colour.spectrum import Channels

_KEY = "field"  # key of the positions of the PSFs in a description
DEPTHS_OR_CHANNELS = "at several distances or in channels"

ChannelPSFs = tuple[Channels, tuple[Made, ...]]
"""Channels, and the PSFs of each channel."""


def _read(source: Path, kind: Callable[..., Made]) -> tuple[Made | ChannelPSFs[Made], Description]:
    """Read a file; return (1) its PSFs, which `kind` builds, with their channels if any, and (2) its description."""
    form = psf_files.find(source, verb="read")
    return psf_files.read(form, source, "a grid of PSFs", partial(_rebuild, kind=kind))


def _rebuild(
    arrays: Arrays, description: Description, kind: Callable[..., Made]
) -> tuple[Made | ChannelPSFs[Made], Description]:
    """Return (1) the PSFs that `kind` builds from arrays and a description, and (2) the description."""
    if "channels" in description:
        return psf_files.rebuild_colours(arrays, description, kind), description
    return psf_files.rebuild(arrays, description, kind), description


def _write_tiff(grid: PSFGridLike, description: Description, target: Path) -> None:
    """Write one page for each PSF, with its position in the metadata of OME-TIFF."""
    assert is_psf(grid.psf)
    factor, unit = psf_formats.ome_unit(grid.unit)
    y, x = (part.ravel() * factor for part in np.meshgrid(grid.y, grid.x, indexing="ij"))
    planes = {"PositionX": x.tolist(), "PositionY": y.tolist()}
    planes |= dict.fromkeys(("PositionXUnit", "PositionYUnit"), [unit] * x.size)
    atomic.write(target, psf_formats.write_tiff(grid.psf, description, planes))


def _grid_format(form: Format) -> Format:
    """Return a format for grids of PSFs that writes a grid as a stack of PSFs in the format `form`."""

    def write(grid: PSFGridLike, description: Description, target: Path) -> None:
        psf_files.write(form, target, grid.psf, description)

    return replace(form, kind="field", write=write, read=_read, holds=(*form.holds, DEPTHS_OR_CHANNELS))


def _write_zarr(grid: PSFGridLike, description: Description, target: Path) -> None:
    """Write the array of values and one array of coordinates for each axis."""
    if grid.psf.grid.stack:
        raise ValueError(
            "path must not end in .zarr if each PSF has its own center, since a store has one x and one y axis"
        )
    values = np.ascontiguousarray(grid.values)
    sealed_description = sealed(description, {"values": values})
    if (target.exists() or target.is_symlink()) and not (target / "zarr.json").is_file():
        raise ValueError(f"path must be new or a Zarr store, got {validation.shown(str(target))}, which is neither")

    def fill(folder: Path) -> None:
        zarr_folders.write_group(folder, {"lommel": sealed_description})
        coordinates: Description = {"field_y": grid.y, "field_x": grid.x}
        coordinates |= {"y": grid.psf.grid.y, "x": grid.psf.grid.x}
        coordinates |= {"depth": grid.depths, "channel": np.arange(values.shape[-3])}
        units = {"depth": "m", "channel": "1"}
        chunk = (*[1] * (values.ndim - 2), *values.shape[-2:])  # one PSF per chunk
        layout = Layout(values.shape, chunk, values.dtype.str, grid.dims)
        ZarrArray(folder / "values", layout).create(values=values)
        for name in grid.dims:
            axis = coordinates[name]
            array = ZarrArray(folder / name, Layout(axis.shape, axis.shape, axis.dtype.str, (name,)))
            array.create(attributes={"units": units.get(name, grid.unit)}, values=axis)

    atomic.write_folder(target, fill)


def _read_zarr(source: Path, kind: Callable[..., Made]) -> tuple[Made | ChannelPSFs[Made], Description]:
    """Read a Zarr folder; return its PSFs and its description as :func:`_read` does."""
    if not source.exists():
        raise FileNotFoundError(2, os.strerror(2), str(source))
    with psf_files.as_file_error(source, "a grid of PSFs"):
        description = dict(zarr_folders.attributes(source)["lommel"])
        return _rebuild({"values": ZarrArray.open(source / "values").read()}, description, kind)


registry.register(
    Format("field", (".tif", ".tiff"), _write_tiff, _read, library="tifffile",
           what="OME-TIFF, one page per PSF", readers="Fiji, Bio-Formats, napari"),
    Format("field", (".zarr",), _write_zarr, _read_zarr, holds=(DEPTHS_OR_CHANNELS,),
           what="Zarr version 3", readers="zarr, xarray"),
    *(_grid_format(form) for form in registry.formats("psf") if form.write not in psf_files.PICTURES),
)  # fmt: skip
find = partial(registry.find, "field")


@filled(formats=registry.listing("field"))
def save(grid: PSFGridLike, path: str | PathLike[str]) -> None:
    """Write a grid of PSFs; the suffix chooses the format.

    {formats}

    In OME-TIFF each page is a PSF; PositionX and PositionY of its plane are the position on the sensor (micrometres,
    or ``reference frame`` for lambda*N). Zarr has the array ``values`` (field_y, field_x, y, x), coordinate arrays of
    all dimensions, as xarray expects, and the description as the attribute ``lommel``. The other formats contain a
    stack of PSFs; in FITS, HDF5 and MATLAB the positions are named ``field_y`` and ``field_x``. With several
    distances (depth, metres) or channels, the axes in all formats but OME-TIFF are (field_y, field_x, depth,
    channel, y, x), which MATLAB shows as (y, x, field_y, field_x, depth, channel).

    Each file has the description of :func:`lommel.io.psf_files.save`, with the positions and the sensor size, so that
    :meth:`lommel.PSF.load` reads the stack from all formats but ``.zarr``. Files are written under a temporary name
    and moved into place; an existing ``.zarr`` folder is replaced if it is a Zarr store.

    Parameters
    ----------
    grid : PSFGrid
    path : path

    Raises
    ------
    ValueError
        If the suffix is unknown; if the format cannot store the derivatives, distances or channels of the grid; for
        derivatives with channels; for ``.zarr``, if each PSF has its own center or `path` is no Zarr store.
    ImportError
        If tifffile, astropy or h5py is not installed.
    OSError
        If the file cannot be written.
    """
    psf = grid.psf
    if isinstance(psf, ColourPSFLike):
        description, form = psf_files.describe_colours(psf), find(path, holding=DEPTHS_OR_CHANNELS)
    else:
        contents = "" if grid.depths is None else DEPTHS_OR_CHANNELS
        form = find(path, holding="with derivatives" if psf.derivatives else contents)
        description = psf_files.describe(psf)
    field: Description = {"x": grid.x.tolist(), "y": grid.y.tolist(), "sensor": list(grid.sensor)}
    if grid.depths is not None:  # JSON has no infinity
        field["depths"] = [None if np.isinf(s) else s for s in grid.depths.tolist()]
    form.write(grid, description | {_KEY: field | {"unit": grid.unit}}, Path(path))


def load(
    path: str | PathLike[str], kind: Callable[..., Made]
) -> tuple[Made | ChannelPSFs[Made], Array, Array, tuple[float, float], Array | None]:
    """Read a grid of PSFs; return (1) PSFs, (2) x, (3) y, (4) the sensor size (height, width), (5) distances.

    `kind` builds the PSFs; in colour they are (channels, PSFs of each channel). At a single distance (5) is None.
    """
    form, source = find(path, verb="read"), Path(path)
    psf, description = form.read(source, kind)
    if _KEY not in description:
        raise FileError(f"{validation.line(source)} is not a grid of PSFs: no positions; PSF.load reads it")
    field = description[_KEY]
    depths = field.get("depths")
    if depths is not None:
        depths = np.array([np.inf if s is None else s for s in depths], np.float64)
    return psf, np.array(field["x"]), np.array(field["y"]), tuple(field["sensor"]), depths
