"""PSFs as bare numbers, .raw, for programs of one's own, with a small .json beside that says what they are."""

from __future__ import annotations

import json
import math
from typing import Any

import numpy as np

from lommel.base import reading, validation
from lommel.base.checksums import sealed
from lommel.io import labels
from lommel.measures.answer import Answer


def write(psf: Answer, description: dict[str, Any]) -> tuple[bytes, bytes]:
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


def write_turned(psf: Answer, description: dict[str, Any]) -> tuple[bytes, bytes]:
    """Return the text and the values, for a path that has the suffix of the text."""
    values, text = write(psf, description)
    return text, values


def read_turned(beside: bytes, data: bytes) -> tuple[dict[str, Any], str]:
    """Return the same from the text and the values."""
    return read(data, beside)
