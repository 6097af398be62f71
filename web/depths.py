"""Tables of live depth for the live page: of LiveDepth for a lens at several f-numbers, and of one blurred frame."""

from __future__ import annotations

import struct
from functools import cache
from typing import Any

import numpy as np

import lommel as lm
from lommel.base.arrays import Array
from lommel.estimation.focal_model import FocalLight, FocalModel
from lommel.imaging.focal_engine import CONTRAST, FocalEngine
from lommel.imaging.focal_tables import SharpTables, Taps

STOPS = (16.0, 11.0, 8.0, 5.6)
SETUP = {"focal_length": 35e-3, "wavelength": 540e-9, "pixel": 4e-6, "foci": [1.35, 1.8], "between": [1.2, 2.0]}
"""Metres."""
NOISE = {"read": 3.0, "offset": 100.0}
"""Electrons, of one a count."""
LIGHT = 3000.0
SHAPE = (240, 320)
BLURS = 25
"""Filters of single frames, for blur from none to a radius of LARGEST pixels."""
LARGEST = 6.0
_TOP, _SHARP = 32767, 1023  # largest whole numbers; sharp images do with fewer


@cache
def live(f_number: float) -> lm.imaging.LiveDepth:
    """Return what finds depth in Python as the page does."""
    near, far = SETUP["foci"]
    lens = lm.Lens(
        focal_length=SETUP["focal_length"], f_number=f_number, focus_distance=near, wavelength=SETUP["wavelength"]
    )
    noise = lm.Noise(white=1.0, **NOISE)
    lenses, pixel, between = [lens, lens.focused(far)], SETUP["pixel"], tuple(SETUP["between"])
    return lm.imaging.LiveDepth(lenses, pixel, between=between, noise=noise, shape=SHAPE, light=LIGHT, sharp=True)


def blur_filters() -> Array:
    """Return Wiener's filters of single frames by their blur, (BLURS, degree + 1)."""
    lens = lm.Lens(focal_length=4e-3, f_number=2.0, wavelength=SETUP["wavelength"])
    # The radius of the blur is half the aperture times vergence times the distance of the sensor.
    pixel = 4e-6
    vergence = np.linspace(0.0, LARGEST * pixel / (0.5 * lens.aperture_diameter * lens.focal_length), BLURS)
    light = FocalLight(LIGHT, NOISE["read"], (1.0,), CONTRAST)
    tables = SharpTables(FocalModel.of([lens], vergence, ((lens.wavelength, 1.0),), pixel, light), Taps.of(5), 12)
    return np.asarray(tables.mixes(tables.pixel) @ tables.basis[:, 0])


def packed(f_number: float) -> bytes:
    """Return the tables of an f-number in little space, which depths.js unpacks to a file of LiveDepth.save().

    Numbers of 32 bits, then whole ones of 16 in two planes of bytes, those of candidates by their second differences.
    Energies are products of what the residuals are mixed of, of which there are fewer.
    """
    engine: FocalEngine = live(f_number)._levels[0].engine
    tables, images = engine.channels[0], engine.images[0]
    data = engine.tables(1.0, NOISE["offset"], 65535.0)
    whole, numbers = struct.unpack_from("<14i", data), struct.unpack_from("<16f", data, 56)
    weights = np.asarray(engine._weights)
    basis, mixes = _scaled(tables.basis, tables.mixes[:, 0])
    kept, sharp = _scaled(images.basis, engine.factors(0, None))
    sizes = np.abs(tables.basis).max(axis=(1, 2))  # of images, which are of equal power: concentrations are of these
    curves = [(mixes / sizes, _TOP), (sharp, _SHARP)]
    curves += [(one[:, None], _TOP) for one in tables.statistics()]
    steps = [float(np.abs(each).max()) / top for each, top in curves]
    smooth = [_differences(np.rint(each.T / step)) for (each, _), step in zip(curves, steps, strict=True)]
    values = np.concatenate([each.ravel() for each in (*(np.rint(_TOP * one) for one in (basis, kept)), *smooth)])
    floats = np.asarray([*whole, *numbers, *weights, *steps, *sizes], dtype="<f4")
    return floats.tobytes() + _planes(values)


def _scaled(basis: Array, mixes: Any) -> tuple[Array, Array]:
    """Return images whose largest factor is 1, whatever the signs of singular vectors are, and what mixes them."""
    flat = basis.reshape(len(basis), -1)
    tops = np.take_along_axis(flat, np.abs(flat).argmax(axis=1)[:, None], axis=1)[:, 0]
    return basis / tops[:, None, None], np.asarray(mixes, dtype=float) * tops


def _differences(rows: Array) -> Array:
    """Return second differences along rows, the first two of each as if 0 were before."""
    return np.diff(np.pad(rows, ((0, 0), (2, 0))), n=2, axis=1)


def _planes(values: Array) -> bytes:
    """Return whole numbers modulo 2^16: all low bytes, then all high ones."""
    pairs = (values % 65536.0).astype("<u2").view(np.uint8).reshape(-1, 2)
    return pairs.T.tobytes()


def depths() -> tuple[dict[str, Any], bytes]:
    """Return what the page knows of its camera, and its tables, one after the other; the last is the blur's."""
    filters = blur_filters()
    step = float(np.abs(filters).max()) / _TOP
    last = np.asarray([*Taps.of(5).padded(), step], dtype="<f4").tobytes()
    last += _planes(_differences(np.rint(filters.T / step)).ravel())
    parts = [*(packed(stop) for stop in STOPS), last]
    told = {
        **SETUP,
        **NOISE,
        "stops": STOPS,
        "height": SHAPE[0],
        "width": SHAPE[1],
        "blurs": BLURS,
        "largest": LARGEST,
    }
    return {**told, "sizes": [len(part) for part in parts]}, b"".join(parts)
