"""The formats of photographs: PNG, JPEG and TIFF of 8 or 16 bits, and TIFF of floats."""

from __future__ import annotations

import struct
import zlib
from typing import Any

import numpy as np
from numpy.typing import NDArray

from lommel.base import atomic, reading
from lommel.base.optional import version

_BAND = 2**20  # pixels of a picture that are turned into an array at once


def read_png(data: bytes) -> tuple[NDArray[Any], Any, bytes | None]:
    """Return the values, the tags and the ICC profile of a PNG file, with all of 16 bits."""
    return _read(data, reading.png)


def read_jpeg(data: bytes) -> tuple[NDArray[Any], Any, bytes | None]:
    """Return the values, the tags and the ICC profile of a JPEG file."""
    return _read(data, reading.jpeg)


def _read(data: bytes, opener: Any) -> tuple[NDArray[Any], Any, bytes | None]:
    with opener(data) as file:
        if getattr(file, "is_animated", False):
            raise ValueError(f"it is an animation of {file.n_frames} frames")
        if "A" in file.mode or "transparency" in file.info:
            raise ValueError("it has alpha; flatten it first")
        if file.mode not in ("1", "L", "P", "RGB", "I", "I;16"):
            raise ValueError(f"its colours are {file.mode}, neither grey nor RGB")
        deep, grey, mode = file.format == "PNG" and data[24] == 16, file.mode != "RGB", file.tile[0][3]
        # That of a PNG may stand behind the image, and is looked for there.
        tags, profile = file.getexif(), file.info.get("icc_profile")
        values = _array(file)
    if not deep:
        return values, tags, profile
    if grey:
        return values.astype(np.uint16, copy=False), tags, profile
    if mode != "RGB;16B":
        raise ValueError(f"this Pillow reads 16-bit colour as {mode}; save it as TIFF")
    del file  # or its pixels would lie beside those that follow
    # Pillow keeps the high bytes of 16-bit colour; read as if bytes were swapped, the low ones.
    values = values.astype(np.uint16)
    values <<= 8
    with opener(data) as again:
        again.tile = [(*again.tile[0][:3], "RGB;16L")]
        values |= _array(again)
    return values, tags, profile


def _array(image: Any) -> NDArray[Any]:
    """Return the values of an image of Pillow, band by band: it makes two copies of what it is asked for."""
    width, height = image.size
    step, plain = max(1, _BAND // width), {"P": "RGB", "1": "L"}.get(image.mode)
    made: NDArray[Any] | None = None
    for top in range(0, height, step):
        part = image.crop((0, top, width, min(top + step, height)))
        band = np.asarray(part.convert(plain) if plain else part)
        if made is None:
            made = np.empty((height, *band.shape[1:]), band.dtype)
        made[top : top + step] = band
    assert made is not None
    return made


def read_tiff(data: bytes) -> tuple[NDArray[Any], Any, bytes | None]:
    """Return the values, the tags and the ICC profile of a TIFF file of one page."""
    import tifffile
    from PIL import Image

    with reading.tiff(data) as file:
        pages = [page for page in list[Any](file.pages) if not page.is_reduced]
        if len(pages) != 1:
            raise ValueError(f"it has {len(pages)} pages; give a file of one")
        page = pages[0]
        if page.extrasamples:
            raise ValueError("it has alpha or other further channels; flatten it first")
        if page.photometric not in (tifffile.PHOTOMETRIC.MINISBLACK, tifffile.PHOTOMETRIC.RGB):
            raise ValueError(f"its colours are {page.photometric.name}, neither grey nor RGB")
        values, axes, profile = page.asarray(), page.axes, page.iccprofile
    if values.shape != page.shape:
        raise ValueError(
            f"its values are of an unknown kind, {page.bitspersample} bits of the format {page.sampleformat}"
        )
    if axes == "SYX":
        values = np.moveaxis(values, 0, 2)
    elif axes not in ("YX", "YXS"):
        raise ValueError(f"its axes are {axes}, neither YX nor YXS")
    if values.dtype not in (np.uint8, np.uint16) and values.dtype.kind != "f":
        raise ValueError(f"it holds {values.dtype}, neither uint8, uint16 nor floats")
    tags = Image.Exif()
    if data[2:4] in (b"*\0", b"\0*"):  # Pillow knows those of at most 4 GB
        tags.load(data)
    return values.astype(values.dtype.newbyteorder("="), copy=False), tags, profile


def write_png(values: NDArray[Any], _quality: int, profile: bytes | None) -> bytes:
    """Return a PNG file; without losses, whatever the quality. It is compressed as far as it may be to be read."""
    bits = 8 * values.dtype.itemsize
    takes = reading.png_takes(values.shape[0] * values.shape[1], bits, values.ndim == 3)
    for level in (6, 0):
        write = _png_of_16_bits if bits == 16 else _png_of_8_bits
        made = write(values, profile, level)
        if reading.affords(takes, len(made)):
            break
    return made


def write_jpeg(values: NDArray[Any], quality: int, profile: bytes | None) -> bytes:
    """Return a JPEG file of this quality, 1 to 100, whose colours have the full resolution."""
    return _by_pillow(values, profile, "jpeg", quality=quality, subsampling=0)


def write_tiff(values: NDArray[Any], _quality: int, profile: bytes | None) -> bytes:
    """Return a TIFF file; without losses, whatever the quality."""
    import tifffile

    options = {"photometric": "rgb" if values.ndim == 3 else "minisblack", "software": f"lommel {version()}"}
    return atomic.contents(tifffile.imwrite, values, iccprofile=profile, metadata=None, **options)


def _by_pillow(values: NDArray[Any], profile: bytes | None, form: str, **options: Any) -> bytes:
    from PIL import Image

    return atomic.contents(Image.fromarray(values).save, form, icc_profile=profile, **options)


def _png_of_8_bits(values: NDArray[np.uint8], profile: bytes | None, level: int) -> bytes:
    return _by_pillow(values, profile, "png", compress_level=level)


def _png_of_16_bits(values: NDArray[np.uint16], profile: bytes | None, level: int) -> bytes:
    """Return a PNG, which Pillow writes in 16 bits for grey only; each row as its difference from the one above."""
    height, width = values.shape[:2]
    rows = values.astype(">u2").view(np.uint8).reshape(height, -1)
    lines = np.full((height, 1 + rows.shape[1]), 2, dtype=np.uint8)
    lines[0, 1:] = rows[0]
    np.subtract(rows[1:], rows[:-1], out=lines[1:, 1:])
    chunks = [(b"IHDR", struct.pack(">IIBBBBB", width, height, 16, 2 if values.ndim == 3 else 0, 0, 0, 0))]
    if profile is not None:
        chunks.append((b"iCCP", b"ICC Profile\0\0" + zlib.compress(profile)))
    chunks += [(b"IDAT", zlib.compress(lines.tobytes(), level)), (b"IEND", b"")]
    parts = [struct.pack(">I", len(d)) + name + d + struct.pack(">I", zlib.crc32(name + d)) for name, d in chunks]
    return b"\x89PNG\r\n\x1a\n" + b"".join(parts)
