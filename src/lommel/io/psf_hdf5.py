"""PSFs as HDF5, and as .mat files of MATLAB, version 7.3."""

from __future__ import annotations

import io
import json
import struct
import zlib
from collections.abc import Callable
from typing import Any

import numpy as np

from lommel.base import reading, validation
from lommel.base.checksums import sealed
from lommel.io import metadata
from lommel.io.psf_numpy import SLOPE
from lommel.io.registry import DAMAGED, Arrays, Description, Values
from lommel.measures.psf_like import PSFLike

_BLOCK = 512  # bytes before HDF5 begins
_SEAL, _MARK = 128, b"lommel crc32 "  # behind the head of MATLAB's files
_MATLAB = b"MATLAB 7.3 MAT-file, Platform: lommel, HDF5 schema 1.00 ."


def write(psf: PSFLike, description: Description) -> bytes:
    """Return an HDF5 file: `values` with plain attributes and dimension scales, derivatives, `description`."""
    arrays = {"values": psf.values} | {f"{SLOPE}{name}": values for name, values in psf.derivatives.items()}
    said = json.dumps(sealed(description, arrays), allow_nan=False)
    waves, shares = metadata.light(psf)
    plain: Description = {
        "pixel": psf.pixel,
        "unit": psf.unit,
        "normalize": psf.normalize,
        "sampling": psf.sampling,
    }
    plain |= {"wavelength": waves, "weight": shares} if waves.size else {}
    plain |= {} if psf.error_bound is None else {"error_bound": psf.error_bound}

    axes = metadata.axes(psf, description)

    def fill(file: Any) -> None:
        file.create_dataset("description", data=np.bytes_(said.encode()), track_times=False)
        for name, places, unit in axes:
            if places is not None:
                scale = file.create_dataset(name, data=places, track_times=False)
                scale.attrs["units"] = np.bytes_(unit)
                scale.make_scale(name)
        for name, values in arrays.items():
            stored = file.create_dataset(name, data=values, track_times=False)
            for key, value in plain.items():
                stored.attrs[key] = np.bytes_(value) if isinstance(value, str) else value
            for k, axis in enumerate(axes):
                stored.dims[k].label = axis.name
                if axis.places is not None:
                    stored.dims[k].attach_scale(file[axis.name])

    return _sealed(_filled(fill), b"")


def read(data: bytes) -> tuple[Arrays, str]:
    """Return the values, the derivatives and the description."""
    with _opened(data) as file:
        text = bytes(_array(file, "description", data)).decode()
        names = ["values", *(name for name in file if name.startswith(SLOPE))]
        if (total := sum(file[name].nbytes for name in names if _plain(file, name))) > len(data):
            raise ValueError(f"its arrays take {total} bytes of {len(data)}")
        return {name: _array(file, name, data) for name in names}, text


def write_mat(psf: PSFLike, description: Description) -> bytes:
    """Return a .mat file: `values` of the size [height width stack], `x`, `y`, `wavelength`, `description`, ..."""
    said = json.dumps(sealed(description, {"values": psf.values}), allow_nan=False)
    waves, shares = metadata.light(psf)
    texts = {"unit": psf.unit, "normalize": psf.normalize, "sampling": psf.sampling, "description": said}
    arrays = {"values": _for_matlab(psf.values), "pixel": np.array([[psf.pixel]])}
    places = ((axis.name, axis.places) for axis in metadata.axes(psf, description))
    arrays |= {name: at.reshape(-1, 1) for name, at in places if at is not None}
    arrays |= {"wavelength": waves[:, None], "weight": shares[:, None]} if waves.size else {}

    def fill(file: Any) -> None:
        for name, values in arrays.items():
            stored = file.create_dataset(name, data=values, track_times=False)
            stored.attrs["MATLAB_class"] = np.bytes_("single" if values.dtype == np.float32 else "double")
        for name, text in texts.items():
            codes = np.frombuffer(text.encode("utf-16-le"), "<u2")[:, None]
            stored = file.create_dataset(name, data=codes, track_times=False)
            stored.attrs["MATLAB_class"] = np.bytes_("char")
            stored.attrs["MATLAB_int_decode"] = np.int32(2)

    # Text, no subsystem, version 2.0, byte order.
    return _sealed(_filled(fill), _MATLAB.ljust(116) + bytes(8) + struct.pack("<H", 0x0200) + b"IM")


def read_mat(data: bytes) -> tuple[Arrays, str]:
    """Return the values and the description."""
    with _opened(data) as file:
        text = _array(file, "description", data).astype("<u2").tobytes().decode("utf-16-le")
        return {"values": np.ascontiguousarray(_for_matlab(_array(file, "values", data)))}, text


def _for_matlab(values: Values) -> Values:
    """Return the axes (..., y, x) in the order of HDF5 that MATLAB reverses to (y, x, ...)."""
    stack = range(values.ndim - 2)
    return values.transpose(*reversed(stack), values.ndim - 1, values.ndim - 2)


def _filled(fill: Callable[[Any], None]) -> bytearray:
    import h5py

    file = io.BytesIO()
    # The oldest version, for old readers.
    with h5py.File(file, "w", libver="earliest", userblock_size=_BLOCK) as made:
        fill(made)
    return bytearray(file.getvalue())


def _sealed(data: bytearray, head: bytes) -> bytes:
    """Return a file with its head and a checksum, since the HDF5 library may crash on damaged files."""
    data[: len(head)] = head
    mark = _MARK + _sum(data)
    data[_SEAL : _SEAL + len(mark)] = mark
    return bytes(data)


def _sum(data: bytes | bytearray) -> bytes:
    return f"{zlib.crc32(memoryview(data)[_BLOCK:]):08x}".encode()


def _opened(data: bytes) -> Any:
    if not data.startswith(_MARK, _SEAL):
        raise ValueError("no checksum of how it was written")
    if not data.startswith(_sum(data), _SEAL + len(_MARK)):
        raise ValueError(DAMAGED)
    return reading.hdf5(data)


def _plain(file: Any, name: str) -> bool:
    import h5py

    return isinstance(file.get(name, getlink=True), h5py.HardLink) and isinstance(file[name], h5py.Dataset)


def _array(file: Any, name: str, data: bytes) -> Values:
    """Return an array that is stored contiguously in the file itself."""
    if not _plain(file, name):
        raise ValueError(f"no array {name!r}")
    found = file[name]
    if found.chunks is not None or found.nbytes > 8 * validation.MAX_VALUES:
        raise ValueError(f"{name!r} must be stored in one piece, got {found.nbytes} bytes of {len(data)}")
    if name == "description" and found.nbytes > 2 * reading.MAX_PIXELS:
        raise ValueError(f"its description has {found.nbytes} bytes; the limit is {2 * reading.MAX_PIXELS}")
    return reading.hdf5_values(found, len(data))
