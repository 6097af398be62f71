"""PSFs as NumPy keeps arrays: .npy, with the description behind the array, where NumPy does not look, and .npz."""

from __future__ import annotations

import io
import json
import math
import re
import zipfile
from typing import Any

import numpy as np
from numpy.typing import NDArray

from lommel.base import atomic, reading, validation
from lommel.base.checksums import sealed
from lommel.io import labels
from lommel.measures.psf_like import PSFLike

SLOPE = "derivative "
"""Before the name of a derivative in a .npz file."""

_TERM = re.compile(r"\(([0-9]+), (-?[0-9]+)\)")
_MARK = b"\n#lommel "  # between the array and the description in a .npy file


def name(said: str) -> str | tuple[int, int]:
    """Return the name of a derivative, which files say as text: that of a Zernike term is (n, m)."""
    found = _TERM.fullmatch(said)
    return (int(found[1]), int(found[2])) if found else said


def npy(psf: PSFLike, description: dict[str, Any]) -> bytes:
    """Return an array with the description behind it."""
    said = _text(description, {"values": psf.values}).encode()
    return atomic.contents(np.save, psf.values, allow_pickle=False) + _MARK + said


def read_npy(data: bytes) -> tuple[dict[str, Any], str]:
    """Return the values, and the description as it stands."""
    values, rest = reading.npy(data)
    if not rest.startswith(_MARK):
        raise ValueError("no description of how it was made")
    return {"values": values}, rest.removeprefix(_MARK).decode()


def npz(psf: PSFLike, description: dict[str, Any]) -> bytes:
    """Return an archive of the values, the derivatives and the description."""
    arrays = {"values": psf.values} | {f"{SLOPE}{name}": values for name, values in psf.derivatives.items()}
    return archive(arrays, description)


def archive(arrays: dict[str, NDArray[Any]], description: dict[str, Any]) -> bytes:
    """Return an archive of arrays and their description."""
    # As bytes: readers of NumPy's files in other languages know no text.
    said = np.frombuffer(_text(description, arrays).encode(), np.uint8)
    stored = {
        name: atomic.contents(np.save, values, allow_pickle=False)
        for name, values in (arrays | {"description": said}).items()
    }
    # As NumPy would, but with sizes of 32 bits where these do, which is what other readers know; plainly where it
    # would inflate to more than is read.
    file = io.BytesIO()
    for way in (zipfile.ZIP_DEFLATED, zipfile.ZIP_STORED):
        file = io.BytesIO()
        with zipfile.ZipFile(file, "w") as made:
            for name, array in stored.items():
                made.writestr(zipfile.ZipInfo(f"{name}.npy"), array, way)
        if reading.affords(reading.NPZ_TIMES * sum(map(len, stored.values())), file.tell()):
            break
    return file.getvalue()


def read_npz(data: bytes) -> tuple[dict[str, Any], str]:
    """Return the values and the derivatives, and the description as it stands."""
    arrays = reading.npz(data)
    said = arrays.pop("description")(reading.MAX_PIXELS)
    text = said.tobytes().decode() if said.dtype == np.uint8 else str(said)  # which it was at first
    most = math.prod(reading.json(text)["shape"])
    return {name: read(most) for name, read in arrays.items()}, text


def _text(description: dict[str, Any], arrays: dict[str, Any]) -> str:
    return json.dumps(sealed(description, arrays), allow_nan=False)


def write(psf: PSFLike, description: dict[str, Any]) -> tuple[bytes, bytes]:
    """Return the values, little-endian, the last axis fastest; and the text that says so."""
    waves, shares = labels.light(psf)
    stored = psf.values.astype(psf.values.dtype.newbyteorder("<"))
    said = {
        "shape": list(psf.shape),
        "axes": [axis.name for axis in labels.axes(psf, description)],
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


def read(data: bytes, beside: bytes) -> tuple[dict[str, Any], str]:
    """Return the values, and the description as it stands."""
    if len(beside) > reading.MAX_PIXELS:
        raise ValueError(f"the .json beside it has {len(beside)} bytes; the limit is {reading.MAX_PIXELS}")
    description = reading.json(beside)["lommel"]
    kind = validation.choice("dtype", description["dtype"], ("float32", "float64"))
    values = np.frombuffer(data, np.dtype(kind).newbyteorder("<"))
    if values.size != math.prod(description["shape"]):
        raise ValueError(f"it holds {values.size} values, the .json beside it says {description['shape']}")
    return {"values": values.astype(kind)}, json.dumps(description)


def write_turned(psf: PSFLike, description: dict[str, Any]) -> tuple[bytes, bytes]:
    """Return the text and the values, for a path that has the suffix of the text."""
    values, text = write(psf, description)
    return text, values


def read_turned(beside: bytes, data: bytes) -> tuple[dict[str, Any], str]:
    """Return the same from the text and the values."""
    return read(data, beside)
