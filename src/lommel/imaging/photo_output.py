"""Photographs to files: light as PNG, JPEG or TIFF of 8 or 16 bits or floats."""

from __future__ import annotations

import io
import struct
import zlib
from os import PathLike
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import DTypeLike, NDArray

from lommel.base import atomic, validation
from lommel.base.encoding import ENCODINGS, from_light
from lommel.base.version import version
from lommel.imaging.photos import library

SUFFIXES = (".png", ".jpg", ".jpeg", ".tif", ".tiff")


def check_suffix(path: str | PathLike[str], name: str = "path") -> Path:
    """Return a path that a photograph can be written to; ValueError otherwise."""
    target = validation.path("path", path)
    if target.suffix.lower() not in SUFFIXES:
        raise ValueError(f"{name} must end in {', '.join(SUFFIXES)}, got {validation.shown(str(path))}")
    return target


def check_dtype(path: str | PathLike[str], dtype: DTypeLike) -> None:
    """Refuse values that the format of a photograph does not hold, with a ValueError."""
    target, kind = validation.path("path", path), np.dtype(dtype)
    most = {".png": 2, ".jpg": 1, ".jpeg": 1}.get(target.suffix.lower(), 4)
    if kind.itemsize > most:
        raise ValueError(f"{target.name} holds {'8 or 16' if most == 2 else '8'} bits, not {kind}")


def write_photo(
    path: str | PathLike[str],
    light: NDArray[Any],
    *,
    encoding: str = "srgb",
    dtype: DTypeLike = np.uint8,
    quality: int = 95,
    profile: bytes | None = None,
) -> float:
    """Write light as a photograph; the suffix chooses PNG, JPEG or TIFF.

    Integers end at black and white, as sensors do; what lies beyond by half a level or more is counted. Floats keep
    all. The file is written under a temporary name and moved into place.

    Parameters
    ----------
    path : path
        .png (uint8, uint16), .jpg (uint8) or .tif (uint8, uint16, float32).
    light : ndarray of float, shape (height, width) or (height, width, 3)
        1 is white.
    encoding : {"srgb", "linear"}, default "srgb"
        Of the values stored.
    dtype : uint8, uint16 or float32, default uint8
    quality : int, default 95
        Of a JPEG, 1 to 100; colours have the full resolution.
    profile : bytes, optional
        An ICC profile to store.

    Returns
    -------
    float
        Share of the values that were clipped.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range, or the format has no such values.
    OSError
        If the file cannot be written.
    """
    target = check_suffix(path)
    if profile is not None:
        validation.instance("profile", profile, bytes)
    values, clipped = stored(light, encoding, dtype)
    atomic.write(target, encoded(target, values, quality, profile))
    return clipped


def stored(light: NDArray[Any], encoding: str, dtype: DTypeLike) -> tuple[NDArray[Any], float]:
    """Return light as values of uint8, uint16 or float32 in an encoding, and the share that integers clip."""
    validation.choice("encoding", encoding, ENCODINGS)
    kind = validation.kind("dtype", dtype, np.uint8, np.uint16, np.float32)
    light = validation.array("light", light)
    if light.dtype.kind != "f":
        raise TypeError(f"light must hold floats, got {light.dtype}")
    if light.ndim not in (2, 3) or light.shape[2:] not in ((), (3,)) or 0 in light.shape:
        raise ValueError(f"light must have the shape (height, width) or (height, width, 3), got {light.shape}")
    if not np.all(np.isfinite(light)):
        raise ValueError(f"light must be finite, got {light[~np.isfinite(light)].flat[0]}")
    if kind.kind == "f":
        return from_light(light, encoding, kind), 0.0
    half = 0.5 / np.iinfo(kind).max
    within = np.clip(light, 0.0, 1.0)
    # Half a level of sRGB is less light than of linear values at black, and more at white.
    low, high = (half / 12.92, half * 2.4 / 1.055) if encoding == "srgb" else (half, half)
    clipped = float(np.mean((light < -low) | (light > 1.0 + high)))
    return from_light(within, encoding, kind), clipped


def encoded(target: Path, values: NDArray[Any], quality: int = 95, profile: bytes | None = None) -> bytes:
    """Return the bytes of a photograph in the format of the suffix of `target`."""
    validation.integer("quality", quality, least=1, most=100)
    check_dtype(target, values.dtype)
    suffix, buffer = target.suffix.lower(), io.BytesIO()
    if suffix in (".tif", ".tiff"):
        photometric = "rgb" if values.ndim == 3 else "minisblack"
        library("tifffile").imwrite(
            buffer,
            values,
            photometric=photometric,
            iccprofile=profile,
            metadata=None,
            software=f"lommel {version()}",
        )
        return buffer.getvalue()
    if values.dtype.itemsize == 2:
        return _png_of_16_bits(values, profile)
    form = {"format": "png"} if suffix == ".png" else {"format": "jpeg", "quality": quality, "subsampling": 0}
    library("PIL.Image").fromarray(values).save(buffer, icc_profile=profile, **form)
    return buffer.getvalue()


def _png_of_16_bits(values: NDArray[np.uint16], profile: bytes | None) -> bytes:
    """Return a PNG, which Pillow writes in 16 bits for grey only; each row as its difference from the one above."""
    height, width = values.shape[:2]
    rows = values.astype(">u2").view(np.uint8).reshape(height, -1)
    lines = np.full((height, 1 + rows.shape[1]), 2, dtype=np.uint8)
    lines[0, 1:] = rows[0]
    np.subtract(rows[1:], rows[:-1], out=lines[1:, 1:])
    chunks = [(b"IHDR", struct.pack(">IIBBBBB", width, height, 16, 2 if values.ndim == 3 else 0, 0, 0, 0))]
    if profile is not None:
        chunks.append((b"iCCP", b"ICC Profile\0\0" + zlib.compress(profile)))
    chunks += [(b"IDAT", zlib.compress(lines.tobytes())), (b"IEND", b"")]
    parts = [struct.pack(">I", len(d)) + name + d + struct.pack(">I", zlib.crc32(name + d)) for name, d in chunks]
    return b"\x89PNG\r\n\x1a\n" + b"".join(parts)
