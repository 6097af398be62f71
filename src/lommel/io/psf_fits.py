"""PSFs as FITS: the values, the header keywords that astronomy programs read, and the description."""

from __future__ import annotations

import json

import numpy as np

from lommel.base import validation
from lommel.base.checksums import sealed
from lommel.io import fits_images, metadata
from lommel.io.registry import Arrays, Description
from lommel.measures.psf_like import PSFLike

_NAME = "LOMMEL"  # of the extension whose bytes are the description
_MOST_WAVES = 1000  # the names of cards have 8 characters
_COUNTS = {"energy": "pixel-1", "emitted": "pixel-1"}


def write(psf: PSFLike, description: Description) -> bytes:
    """Return a FITS file; PIXELSCL, WAVELEN, WAVEn and WGHTn are as POPPY and WebbPSF write them."""
    said = json.dumps(sealed(description, {"values": psf.values}), allow_nan=False).encode()
    return fits_images.write(
        [
            (psf.values, _header(psf, description)),
            (np.frombuffer(said, np.uint8), {"EXTNAME": (_NAME, "JSON: how it was made")}),
        ]
    )


def read(data: bytes) -> tuple[Arrays, str]:
    """Return the values and the description."""
    images = fits_images.read(data, validation.MAX_VALUES)
    described = [image for image in images if image.header.get("EXTNAME") == _NAME and image.values.dtype == np.uint8]
    if len(described) != 1:
        raise ValueError("no description of how it was made")
    return {"values": images[0].values}, described[0].values.tobytes().decode()


def _header(psf: PSFLike, description: Description) -> Description:
    metric, angle = psf.unit == "m", metadata.arcseconds(psf)
    cards: Description = {
        "CREATOR": "lommel",
        "BUNIT": (_COUNTS.get(psf.normalize, ""), "share of the light" if psf.normalize in _COUNTS else "of a peak"),
        "NORMALIZ": (psf.normalize, "what a value of 1 stands for"),
    }
    if angle is not None:
        cards["PIXELSCL"] = (angle, "[arcsec/pixel] seen from the lens, on the axis")
    if metric:
        for side, pitch in zip("YX", psf.grid.pitch, strict=True):
            cards[f"{side}PIXSZ"] = (1e6 * pitch, "[um] of a pixel on the sensor")
    elif isinstance(psf.pixel, float):
        cards["PIXELSZ"] = (psf.pixel, "[lambda*N] of a pixel on the sensor")
    waves, shares = metadata.light(psf)
    if waves.size:
        cards["WAVELEN"] = (float(waves @ shares), "[m] mean wavelength")
        cards["NWAVES"] = (waves.size, "number of wavelengths")
    for k in range(min(waves.size, _MOST_WAVES)):
        cards[f"WAVE{k}"] = (float(waves[k]), "[m] wavelength")
        cards[f"WGHT{k}"] = (float(shares[k]), "its share of the light")
    pitches = dict(zip("yx", psf.grid.pitch, strict=True))
    # FITS counts its axes from the last, and their entries from 1.
    for k, (name, places, unit) in enumerate(reversed(metadata.axes(psf, description)), 1):
        cards[f"CTYPE{k}"] = name.upper()
        step = pitches[name] if name in pitches else places is not None and metadata.step(places)
        if places is None or not step:
            continue
        cards[f"CRPIX{k}"] = (1.0 - float(places[0]) / step, "where it is 0, on the axis")
        cards[f"CRVAL{k}"], cards[f"CDELT{k}"] = 0.0, step
        if unit == "m":
            cards[f"CUNIT{k}"] = unit
    return cards
