"""PSFs as plain arrays: .npy with the description after the array, .npz, and .raw with a .json file beside it."""

from __future__ import annotations

import io
import json
import math
import re
import zipfile

import numpy as np

from lommel.base import atomic, reading, validation
from lommel.base.checksums import sealed
from lommel.io import metadata
from lommel.io.registry import Arrays, Description
from lommel.measures.psf_like import PSFLike

SLOPE = "derivative "
"""Prefix of the names of derivatives in a file."""

_TERM = re.compile(r"\(([0-9]+), (-?[0-9]+)\)")
_MARK = b"\n#lommel "  # between the array and the description in a .npy file


def name(said: str) -> str | tuple[int, int]:
    """Return the name of a derivative from its text in a file; a Zernike term is (n, m)."""
    found = _TERM.fullmatch(said)
    return (int(found[1]), int(found[2])) if found else said


def npy(psf: PSFLike, description: Description) -> bytes:
    """Return an array with the description behind it."""
    said = _text(description, {"values": psf.values}).encode()
    return atomic.contents(np.save, psf.values, allow_pickle=False) + _MARK + said


def read_npy(data: bytes) -> tuple[Arrays, str]:
    """Return the values and the description."""
    values, rest = reading.npy(data)
    if not rest.startswith(_MARK):
        raise ValueError("no description of how it was made")
    return {"values": values}, rest.removeprefix(_MARK).decode()


def npz(psf: PSFLike, description: Description) -> bytes:
    """Return an archive of the values, the derivatives and the description."""
    arrays = {"values": psf.values} | {f"{SLOPE}{name}": values for name, values in psf.derivatives.items()}
    return archive(arrays, description)


def archive(arrays: Arrays, description: Description) -> bytes:
    """Return an archive of arrays and their description."""
    # As bytes: readers of NumPy's files in other languages do not support texts.
    said = np.frombuffer(_text(description, arrays).encode(), np.uint8)
    stored = {
        name: atomic.contents(np.save, values, allow_pickle=False)
        for name, values in (arrays | {"description": said}).items()
    }
    # NumPy always writes 64-bit sizes, which other readers do not support. Uncompressed where it would inflate to
    # more than `reading` allows.
    file = io.BytesIO()
    for way in (zipfile.ZIP_DEFLATED, zipfile.ZIP_STORED):
        file = io.BytesIO()
        with zipfile.ZipFile(file, "w") as made:
            for name, array in stored.items():
                made.writestr(zipfile.ZipInfo(f"{name}.npy"), array, way)
        if reading.affords(reading.NPZ_TIMES * sum(map(len, stored.values())), file.tell()):
            break
    return file.getvalue()


def read_npz(data: bytes) -> tuple[Arrays, str]:
    """Return the values, the derivatives and the description."""
    arrays = reading.npz(data)
    said = arrays.pop("description")(reading.MAX_PIXELS)
    text = said.tobytes().decode() if said.dtype == np.uint8 else str(said)  # which it was at first
    most = math.prod(reading.json(text)["shape"])
    return {name: read(most) for name, read in arrays.items()}, text


def _text(description: Description, arrays: Arrays) -> str:
    return json.dumps(sealed(description, arrays), allow_nan=False)


def raw(psf: PSFLike, description: Description) -> tuple[bytes, bytes]:
    """Return the values, little-endian, the last axis fastest; and the .json beside that describes them."""
    waves, shares = metadata.light(psf)
    stored = psf.values.astype(psf.values.dtype.newbyteorder("<"))
    said = {
        "shape": list(psf.shape),
        "axes": [axis.name for axis in metadata.axes(psf, description)],
        "dtype": str(psf.values.dtype),
        "byte_order": "little",
        "order": "C",
        "pixel": psf.pixel,
        "unit": psf.unit,
        "wavelength": waves.tolist(),
        "weight": shares.tolist(),
        "lommel": sealed(description, {"values": psf.values}),
    }
    return stored.tobytes(), (json.dumps(said, indent=1, allow_nan=False) + "\n").encode()


def read_raw(data: bytes, beside: bytes) -> tuple[Arrays, str]:
    """Return the values and the description."""
    if len(beside) > reading.MAX_PIXELS:
        raise ValueError(f"the .json beside it has {len(beside)} bytes; the limit is {reading.MAX_PIXELS}")
    description = reading.json(beside)["lommel"]
    kind = validation.choice("dtype", description["dtype"], ("float32", "float64"))
    values = np.frombuffer(data, np.dtype(kind).newbyteorder("<"))
    if values.size != math.prod(description["shape"]):
        raise ValueError(f"it holds {values.size} values, the .json beside it says {description['shape']}")
    return {"values": values.astype(kind)}, json.dumps(description)
