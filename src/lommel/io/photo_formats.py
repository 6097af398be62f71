"""The formats of photographs: PNG, JPEG and TIFF of 8 or 16 bits, and TIFF of floats."""

from __future__ import annotations

import io
import struct
import zlib
from typing import Any

import numpy as np
from numpy.typing import NDArray

from lommel.base import atomic, reading
from lommel.base.version import version


# Both are opened as what they are: Pillow's limit on the size of pictures from strangers is not for one's own.
def read_png(data: bytes) -> tuple[NDArray[Any], Any, bytes | None]:
    """Return the values, the tags and the ICC profile of a PNG file, with all of 16 bits."""
    from PIL.PngImagePlugin import PngImageFile

    return _read(data, PngImageFile)


def read_jpeg(data: bytes) -> tuple[NDArray[Any], Any, bytes | None]:
    """Return the values, the tags and the ICC profile of a JPEG file."""
    from PIL.JpegImagePlugin import JpegImageFile

    return _read(data, JpegImageFile)


def _read(data: bytes, opener: Any) -> tuple[NDArray[Any], Any, bytes | None]:
    def load(rawmode: str | None = None) -> NDArray[Any]:
        with opener(io.BytesIO(data)) as again:
            if rawmode is not None:
                again.tile = [(*again.tile[0][:3], rawmode)]
            again.load()
            return np.asarray(again.convert(plain) if (plain := {"P": "RGB", "1": "L"}.get(again.mode)) else again)

    with opener(io.BytesIO(data)) as file:
        reading.pixels(*file.size)
        if getattr(file, "is_animated", False):
            raise ValueError(f"it is an animation of {file.n_frames} frames")
        if "A" in file.mode or "transparency" in file.info:
            raise ValueError("it has alpha; flatten it first")
        if file.mode not in ("1", "L", "P", "RGB", "I", "I;16"):
            raise ValueError(f"its colours are {file.mode}, neither grey nor RGB")
        deep, grey, mode = file.format == "PNG" and data[24] == 16, file.mode != "RGB", file.tile[0][3]
        # That of a PNG may stand behind the image, and is looked for there.
        tags, profile = file.getexif(), file.info.get("icc_profile")
    if not deep:
        return load(), tags, profile
    if grey:
        return load().astype(np.uint16), tags, profile
    if mode != "RGB;16B":
        raise ValueError(f"this Pillow reads 16-bit colour as {mode}; save it as TIFF")
    # Pillow keeps the high bytes of 16-bit colour; read as if bytes were swapped, the low ones.
    return load().astype(np.uint16) << 8 | load("RGB;16L"), tags, profile


def read_tiff(data: bytes) -> tuple[NDArray[Any], Any, bytes | None]:
    """Return the values, the tags and the ICC profile of a TIFF file of one page."""
    import tifffile
    from PIL import Image

    reading.tiff(data)
    with tifffile.TiffFile(io.BytesIO(data)) as file:
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
    """Return a PNG file; without losses, whatever the quality."""
    return _png_of_16_bits(values, profile) if values.dtype.itemsize == 2 else _by_pillow(values, profile, "png")


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
