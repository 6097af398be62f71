"""Grids of PSFs to files and back: pages or chunks with their positions, and the description that PSFs carry."""

from __future__ import annotations

import os
from collections.abc import Callable
from functools import partial
from os import PathLike
from pathlib import Path
from typing import Any

import numpy as np

from lommel.base import atomic, reading, validation
from lommel.base.arrays import Array
from lommel.base.checksums import sealed
from lommel.io import (
    colour_files,
    fits_images,
    psf_files,
    psf_fits,
    psf_hdf5,
    psf_numpy,
    psf_tiff,
    registry,
    zarr_folders,
)
from lommel.io.psf_files import FileError, Made
from lommel.io.registry import Format
from lommel.io.zarr_folders import ZarrArray
from lommel.measures.psf_like import ColourPSFLike, PSFGridLike, PSFLike, is_psf

_KEY = "field"  # of what a description says about the positions
_AXES = "at several distances or in channels"


def save(grid: PSFGridLike, path: str | PathLike[str]) -> None:
    """Write a grid of PSFs; the suffix chooses the format.

    ``.tif``: one OME-TIFF, a page for each PSF, row by row (axis R, tiles), with its position on the sensor as
    PositionX and PositionY of its plane (micrometres, or ``reference frame`` for lambda*N). ``.zarr``: a Zarr group
    of version 3 with the array ``values`` (field_y, field_x, y, x) and a coordinate array for each dimension, named
    as xarray expects; the description is the attribute ``lommel``. ``.npz``, ``.fits``, ``.h5``, ``.mat``: as a stack
    of PSFs, in all but the first with the places on the sensor, ``field_y`` and ``field_x``.
    With several distances (depth, metres) and channels, whose numbers stand for the names in the description,
    ``.zarr`` and ``.npz`` hold (field_y, field_x, depth, channel, y, x).

    Each has the JSON description of :func:`lommel.io.psf_files.save` with the positions and the size of the sensor
    added, so that :meth:`lommel.PSF.load` reads the stack from all but ``.zarr``. All is written under a
    temporary name and moved into place; a ``.zarr`` folder that was there is replaced if it is a Zarr store.

    Parameters
    ----------
    grid : PSFGrid
    path : path

    Raises
    ------
    ValueError
        If the suffix is unknown, for derivatives in anything but ``.npz`` and ``.h5`` or in channels, for distances
        or channels in anything but ``.npz`` and ``.zarr``, or if there is something at the path of a ``.zarr`` that
        is no Zarr store.
    ImportError
        If tifffile, astropy or h5py is not installed.
    OSError
        If it cannot be written.
    """
    psf = grid.psf
    if isinstance(psf, ColourPSFLike):
        colour_files.require_plain(psf)
        form, said = find(path, holding=_AXES), colour_files.describe(psf)
    else:
        deep = "" if grid.depths is None else _AXES
        form, said = find(path, holding="with derivatives" if psf.derivatives else deep), psf_files.describe(psf)
    field: dict[str, Any] = {"x": grid.x.tolist(), "y": grid.y.tolist(), "sensor": list(grid.sensor)}
    if grid.depths is not None:  # JSON has no infinity
        field["depths"] = [None if np.isinf(s) else s for s in grid.depths.tolist()]
    form.write(grid, said | {_KEY: field | {"unit": grid.unit}}, Path(path))


def load(
    path: str | PathLike[str], kind: Callable[..., Made]
) -> tuple[Any, Array, Array, tuple[float, float], Array | None]:
    """Read what :func:`lommel.io.field_files.save` wrote.

    Returns
    -------
    psf : PSF or (Channels, tuple of PSF)
        Of this kind.
    x, y : ndarray
        Their places.
    sensor : (float, float)
    depths : ndarray or None

    Raises
    ------
    FileError
        If it is damaged or was not written by this package as a grid of PSFs.
    OSError
        If it cannot be read.
    """
    form, source = find(path, verb="read"), Path(path)
    psf, description = form.read(source, kind)
    if _KEY not in description:
        raise FileError(f"{validation.line(source)} is not a grid of PSFs: no positions; PSF.load reads it")
    with psf_files.told(source, "a grid of PSFs"):
        field = description[_KEY]
        x, y = validation.real_array("x", field["x"]), validation.real_array("y", field["y"])
        height, width = (validation.real("sensor", side, above=0.0) for side in field["sensor"])
        depths = field.get("depths")
        if depths is not None:
            depths = np.array([np.inf if s is None else validation.real("depths", s, above=0.0) for s in depths])
        one, places = psf[1][0] if isinstance(psf, tuple) else psf, (y.size, x.size)
        if one.pupil.shape != places + (() if depths is None else depths.shape):
            raise ValueError(f"positions of shape {places} for PSFs of shape {one.pupil.shape}")
    return psf, x, y, (height, width), depths


def _read(source: Path, kind: Callable[..., Made]) -> tuple[Any, dict[str, Any]]:
    form, data = psf_files.find(source, verb="read"), reading.contents(source)
    with psf_files.told(source, "a grid of PSFs"):
        arrays, text = form.read(data)
        return _rebuilt(arrays, reading.json(text), kind)


def _rebuilt(
    arrays: dict[str, Any], description: dict[str, Any], kind: Callable[..., Made]
) -> tuple[Any, dict[str, Any]]:
    if "channels" in description:
        return colour_files.rebuild(arrays["values"], description, kind), description
    return psf_files.rebuild(arrays, description, kind), description


def _write_tiff(grid: PSFGridLike, description: dict[str, Any], target: Path) -> None:
    assert is_psf(grid.psf)
    factor, unit = (1e6, "µm") if grid.unit == "m" else (1.0, "reference frame")
    y, x = (part.ravel() * factor for part in np.meshgrid(grid.y, grid.x, indexing="ij"))
    planes = {"PositionX": x.tolist(), "PositionY": y.tolist()}
    planes |= dict.fromkeys(("PositionXUnit", "PositionYUnit"), [unit] * x.size)
    atomic.write(target, psf_tiff.write(grid.psf, description, planes))


def _as_stack(write: Callable[[PSFLike, dict[str, Any]], bytes]) -> Callable[..., None]:
    """Return what writes a grid as the stack of PSFs that it is."""
    return lambda grid, description, target: atomic.write(target, write(grid.psf, description))


def _write_npz(grid: PSFGridLike, description: dict[str, Any], target: Path) -> None:
    psf = grid.psf
    made = colour_files.npz(psf, description) if isinstance(psf, ColourPSFLike) else psf_numpy.npz(psf, description)
    atomic.write(target, made)


def _write_zarr(grid: PSFGridLike, description: dict[str, Any], target: Path) -> None:
    if grid.psf.grid.stack:
        raise ValueError(
            "path must not end in .zarr for PSFs with a center each, since all have one x and one y there"
        )
    values = np.ascontiguousarray(grid.values)
    said = sealed(description, {"values": values})
    if (target.exists() or target.is_symlink()) and not (target / "zarr.json").is_file():
        raise ValueError(
            f"path must be new or a Zarr store, got {validation.shown(str(target))}, which is something else"
        )

    def fill(folder: Path) -> None:
        zarr_folders.write_group(folder, {"lommel": said})
        places: dict[str, Any] = {"field_y": grid.y, "field_x": grid.x, "y": grid.psf.grid.y, "x": grid.psf.grid.x}
        places |= {"depth": grid.depths, "channel": np.arange(values.shape[-3])}
        dimensions = {name: places[name] for name in grid.dims}
        units = {"depth": "m", "channel": "1"}
        chunk = (*[1] * (values.ndim - 2), *values.shape[-2:])  # for each PSF: what is read together
        ZarrArray(folder / "values", values.shape, chunk, values.dtype.str).create(list(dimensions), values=values)
        for name, positions in dimensions.items():
            said_of = {"units": units.get(name, grid.unit)}
            place = ZarrArray(folder / name, positions.shape, positions.shape, positions.dtype.str)
            place.create([name], attributes=said_of, values=positions)

    atomic.write_folder(target, fill)


def _read_zarr(source: Path, kind: Callable[..., Made]) -> tuple[Made, dict[str, Any]]:
    if not source.exists():
        raise FileNotFoundError(2, os.strerror(2), str(source))
    with psf_files.told(source, "a grid of PSFs"):
        description = dict(zarr_folders.attributes(source)["lommel"])
        return _rebuilt({"values": ZarrArray.open(source / "values").read()}, description, kind)


_form = partial(Format, "field", read=_read)
_fits, _hdf5 = (partial(_form, library=name, extra=extra) for name, extra in (("astropy", "fits"), ("h5py", "hdf5")))
_DERIVED = ("with derivatives",)
registry.register(
    _form((".tif", ".tiff"), _write_tiff, library="tifffile", extra="images"),
    Format("field", (".zarr",), _write_zarr, _read_zarr, holds=(_AXES,)),
    _form((".npz",), _write_npz, holds=(*_DERIVED, _AXES)),
    _fits(fits_images.SUFFIXES, _as_stack(psf_fits.write)),
    _fits(fits_images.PACKED, _as_stack(fits_images.packed(psf_fits.write))),
    _hdf5((".h5", ".hdf5"), _as_stack(psf_hdf5.write), holds=_DERIVED),
    _hdf5((".mat",), _as_stack(psf_hdf5.write_mat)),
)
find = partial(registry.find, "field")
