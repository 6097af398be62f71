"""Stacks as files of OME-TIFF and OME-Zarr, with the voxel sizes, channels and wavelengths of a recording."""

from __future__ import annotations

import errno
from contextlib import suppress
from pathlib import Path
from typing import Any

import numpy as np

from lommel.base import atomic, optional, reading
from lommel.base.arrays import Json, Values
from lommel.base.validation import line, shown
from lommel.recorded.frames import Frames

_JSON = 2**24  # largest size of a parsed description, bytes
_CHUNK = (32, 128, 128)  # chunks of written OME-Zarr: planes, rows, columns


def save_stack(path: Path, values: Values, recording: Frames, description: str = "") -> None:
    """Write a stack, (channels, planes, height, width) or with times before, with its metadata, atomically.

    The format is OME-TIFF if the name ends in .tif or .tiff, OME-Zarr (0.4) if it ends in .zarr.
    """
    if kind_of(path) == "zarr":
        atomic.write_folder(path, lambda folder: _fill_zarr(folder, values, recording, path.stem, description))
    else:
        with atomic.temporary_for(path) as temporary, atomic.as_path_error(path):
            _fill_tiff(temporary, values, recording, description)


def kind_of(path: Path, recording: str | Path | None = None) -> str:
    """Return "zarr" or "tiff", by the ending of a path.

    Raise ValueError for other endings, or if the path is the `recording` from which the stack was restored;
    FileExistsError for a folder that holds no restored stack; ImportError if the library is not installed.
    """
    if recording is not None and path.resolve() == reading.part_of(Path(recording))[0].resolve():
        raise ValueError(f"the restored stack must not replace the recording, got {line(path)} for both")
    file_name = path.name.lower()
    if file_name.endswith(".zarr"):
        optional.require("zarr", "writing OME-Zarr needs", "zarr")
        require_own(path)
        return "zarr"
    if file_name.endswith((".tif", ".tiff")):
        optional.require("tifffile", "writing OME-TIFF needs", "images")
        return "tiff"
    raise ValueError(f"a stack must end in .ome.tif or .ome.zarr, got {shown(path.name)}")


def require_own(path: Path) -> None:
    """Raise FileExistsError unless a path is free or holds a stack written by this package, which may be replaced."""
    replaceable = not (path.exists() or path.is_symlink())
    if not replaceable:
        with suppress(OSError, ValueError):
            replaceable = "lommel" in reading.json(reading.contents(path / ".zattrs", _JSON))
    if not replaceable:
        raise FileExistsError(errno.EEXIST, "holds no restored stack, and is not replaced", str(path))


def _fill_tiff(target: Path, values: Values, recording: Frames, description: str) -> None:
    import tifffile

    fields: Json = {"axes": "TCZYX"[-values.ndim :], "Description": description}
    for key, letters in (("pixel", "XY"), ("step", "Z")):
        if (value := recording.metadata[key]) is not None:
            for letter in letters:
                # Rounded to twelve digits, so that 6.5e-08 m is written as 0.065 micrometres.
                fields[f"PhysicalSize{letter}"] = float(f"{1e6 * value:.12g}")
                fields[f"PhysicalSize{letter}Unit"] = "µm"
    channel: Json = {"Name": list(recording.metadata["names"])}
    for key, name in (("emission", "EmissionWavelength"), ("excitation", "ExcitationWavelength")):
        waves = recording.metadata[key]
        if waves and all(wave is not None for wave in waves):
            channel |= {name: [float(f"{1e9 * wave:.12g}") for wave in waves], f"{name}Unit": ["nm"] * len(waves)}
    fields["Channel"] = channel
    # Offsets in a TIFF file have 32 bits: 32 MB are left for the metadata.
    is_big = values.nbytes > 2**32 - 2**25
    tifffile.imwrite(target, values, ome=True, metadata=fields, photometric="minisblack", bigtiff=is_big)


def new_zarr(folder: Path, shape: tuple[int, ...], recording: Frames, name: str, description: str = "") -> Any:
    """Return the array of a new OME-Zarr (0.4) of float32, (channels, planes, height, width) or with times before."""
    import zarr

    group = zarr.create_group(str(folder), zarr_format=2)
    others: list[Json] = [{"name": "t", "type": "time"}, {"name": "c", "type": "channel"}][3 - len(shape) :]
    sides = [1.0] * len(others)
    known_sides = [recording.metadata[key] for key in ("step", "pixel", "pixel")]
    sides += [1.0 if value is None else float(f"{1e6 * value:.12g}") for value in known_sides]
    space: list[Json] = [{"name": letter, "type": "space"} for letter in "zyx"]
    for axis, value in zip(space, known_sides, strict=True):
        axis |= {} if value is None else {"unit": "micrometer"}
    group.attrs["multiscales"] = [
        {
            "version": "0.4",
            "name": name,
            "axes": [*others, *space],
            "datasets": [{"path": "0", "coordinateTransformations": [{"type": "scale", "scale": sides}]}],
        }
    ]
    channels: list[Json] = [
        {"label": name, "active": True, "color": "FFFFFF"} for name in recording.metadata["names"]
    ]
    for channel, wave in zip(channels, recording.metadata["emission"], strict=False):
        if wave is not None:
            channel["emission_wavelength"] = float(f"{1e9 * wave:.12g}")
    group.attrs["omero"] = {"channels": channels}
    group.attrs["lommel"] = {"description": description}
    chunks = (1,) * len(others) + tuple(min(limit, side) for limit, side in zip(_CHUNK, shape[-3:], strict=True))
    return group.create_array(
        "0", shape=shape, dtype="float32", chunks=chunks, chunk_key_encoding={"name": "v2", "separator": "/"}
    )


def _fill_zarr(folder: Path, values: Values, recording: Frames, name: str, description: str) -> None:
    array = new_zarr(folder, values.shape, recording, name, description)
    for place in np.ndindex(values.shape[:-3]):
        for plane in range(0, values.shape[-3], _CHUNK[0]):
            part = (*place, slice(plane, plane + _CHUNK[0]))
            array[part] = values[part]
