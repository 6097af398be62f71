"""Grids of PSFs to files and back: pages or chunks with their positions, and the description that PSFs carry."""

from __future__ import annotations

import os
import stat
from os import PathLike
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from lommel.base import atomic, optional, reading, validation
from lommel.base.arrays import Array
from lommel.base.checksums import sealed
from lommel.io import psf_files
from lommel.io.psf_files import FileError, Made
from lommel.measures.answer import AnswerGrid

SUFFIXES = (".tif", ".tiff", ".zarr", ".npz")

_KEY = "field"  # of what a description says about the positions


def check_suffix(path: str | PathLike[str], name: str = "path") -> str:
    """Return the suffix in small letters; ValueError if it is none of :data:`SUFFIXES`."""
    suffix = validation.path("path", path).suffix.lower()
    if suffix not in SUFFIXES:
        raise ValueError(
            f"{name} must end in {', '.join(SUFFIXES)} for a grid of PSFs, got {validation.shown(str(path))}"
        )
    return suffix


def save(grid: AnswerGrid, path: str | PathLike[str]) -> None:
    """Write a grid of PSFs; the suffix chooses the format.

    ``.tif``: one OME-TIFF, a page for each PSF, row by row (axis R, tiles), with its position on the sensor as
    PositionX and PositionY of its plane (micrometres, or ``reference frame`` for lambda*N). ``.zarr``: a Zarr group
    of version 3 with the array ``values`` (field_y, field_x, y, x) and a coordinate array for each dimension, named
    as xarray expects; the description is the attribute ``lommel``. ``.npz``: as a stack of PSFs.

    Each has the JSON description of :func:`lommel.io.psf_files.save` with the positions and the size of the sensor
    added, so that :meth:`lommel.PSF.load` reads the stack from ``.tif`` and ``.npz``. All is written under a
    temporary name and moved into place; a ``.zarr`` folder that was there is replaced if it is a Zarr store.

    Raises
    ------
    ValueError
        If the suffix is unknown, for derivatives in anything but ``.npz``, or if there is something at the path of
        a ``.zarr`` that is no Zarr store.
    ImportError
        If tifffile or zarr is not installed.
    OSError
        If it cannot be written.
    """
    suffix = check_suffix(path)
    psf, target = grid.psf, validation.path("path", path)
    if psf.derivatives and suffix != ".npz":
        raise ValueError(f"path must end in .npz for PSFs with derivatives, got {validation.shown(str(path))}")
    field = {"x": grid.x.tolist(), "y": grid.y.tolist(), "sensor": list(grid.sensor), "unit": grid.unit}
    description = psf_files.describe(psf) | {_KEY: field}
    if suffix == ".zarr":
        _write_zarr(grid, target, sealed(description, {"values": grid.values}))
        return
    if suffix == ".npz":
        atomic.write(target, psf_files._npz(psf, description))
        return
    factor, unit = (1e6, "µm") if grid.unit == "m" else (1.0, "reference frame")
    y, x = (part.ravel() * factor for part in np.meshgrid(grid.y, grid.x, indexing="ij"))
    planes = {"PositionX": x.tolist(), "PositionY": y.tolist()}
    planes |= dict.fromkeys(("PositionXUnit", "PositionYUnit"), [unit] * x.size)
    atomic.write(target, psf_files._tiff(psf, description, planes))


def load(path: str | PathLike[str], kind: type[Made]) -> tuple[Made, Array, Array, tuple[float, float]]:
    """Read what :func:`lommel.io.field_files.save` wrote: PSFs of this kind, their places x and y, the sensor.

    Raises
    ------
    FileError
        If it is damaged or was not written by this package as a grid of PSFs.
    OSError
        If it cannot be read.
    """
    source = validation.path("path", path)
    suffix = check_suffix(path)
    psf, description = _read_zarr(source, kind) if suffix == ".zarr" else psf_files.load_described(source, kind)
    try:
        field = description[_KEY]
        x, y = validation.real_array("x", field["x"]), validation.real_array("y", field["y"])
        height, width = (validation.real("sensor", side, above=0.0) for side in field["sensor"])
        if psf.pupil.shape != (y.size, x.size):
            raise ValueError(f"positions of shape {(y.size, x.size)} for PSFs of shape {psf.pupil.shape}")
    except KeyError:
        raise FileError(f"{validation.line(source)} is not a grid of PSFs: no positions; PSF.load reads it") from None
    except (ValueError, TypeError) as error:
        raise FileError(
            f"{validation.line(source)} is not a grid of PSFs written by lommel: {reading.reason(error)}"
        ) from error
    return psf, x, y, (height, width)


def _zarr() -> Any:
    return optional.library("zarr", "this format needs", "zarr")


def _write_zarr(grid: AnswerGrid, target: Path, description: dict[str, Any]) -> None:
    zarr = _zarr()
    if (target.exists() or target.is_symlink()) and not (target / "zarr.json").is_file():
        raise ValueError(
            f"path must be new or a Zarr store, got {validation.shown(str(target))}, which is something else"
        )

    def fill(folder: Path) -> None:
        group = zarr.create_group(folder, zarr_format=3, attributes={"lommel": description})
        shape = grid.values.shape
        dimensions = {"field_y": grid.y, "field_x": grid.x, "y": grid.psf.grid.y, "x": grid.psf.grid.x}
        # A chunk for each PSF: what is read together.
        store = group.create_array(
            "values",
            shape=shape,
            chunks=(1, 1, *shape[2:]),
            dtype=grid.values.dtype,
            compressors=None,  # so that its size is known before it is read
            dimension_names=list(dimensions),
        )
        store[...] = grid.values
        for name, positions in dimensions.items():
            axis = group.create_array(
                name,
                shape=positions.shape,
                dtype="float64",
                dimension_names=[name],
                attributes={"units": grid.unit},
            )
            axis[...] = positions

    atomic.write_folder(target, fill)


def _read_zarr(source: Path, kind: type[Made]) -> tuple[Made, dict[str, Any]]:
    zarr = _zarr()
    if not source.exists():
        raise FileNotFoundError(2, os.strerror(2), str(source))
    try:
        size = _size(source)
        group = zarr.open_group(source, mode="r")
        description: dict[str, Any] = dict(group.attrs["lommel"])
        store = group["values"]
        if store.compressors or store.filters or store.shards or store.nbytes > size:
            raise ValueError(f"its values take {store.nbytes} bytes, plainly stored, got {size}")
        values: NDArray[Any] = np.asarray(store[...])
        return psf_files.rebuild({"values": values}, description, kind), description
    except Exception as error:
        raise FileError(
            f"{validation.line(source)} is not a grid of PSFs written by lommel: {reading.reason(error)}"
        ) from error


def _size(folder: Path) -> int:
    """Return the bytes of all files in a folder, which must hold nothing else but folders."""
    total = 0
    for path in folder.rglob("*"):
        if path.is_dir() and not path.is_symlink():
            continue
        status = path.lstat()
        if not stat.S_ISREG(status.st_mode):
            raise ValueError(f"{path.name} is no regular file")
        if path.name == "zarr.json" and status.st_size > reading.MAX_PIXELS:
            raise ValueError(f"its description has {status.st_size} bytes; the limit is {reading.MAX_PIXELS}")
        total += status.st_size
    return total
