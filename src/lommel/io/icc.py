"""Tone curves of ICC profiles (ICC.1:2022) of matrix type and of grey, and profiles of such curves."""

from __future__ import annotations

import struct
from collections.abc import Sequence

import numpy as np

from lommel.base.arrays import Array
from lommel.base.encoding import CLOSE, LEVELS, Encoding, ToneCurves, agree

_PARAMETERS = (1, 3, 4, 5, 7)  # number of parameters of each type of parametric curve
_MAX_TAGS = 256
# Red, green and blue (XYZ of the illuminant D50) of sRGB and of Adobe RGB.
SRGB = ((0.4361, 0.2225, 0.0139), (0.3851, 0.7169, 0.0971), (0.1431, 0.0606, 0.7141))
ADOBE_RGB = ((0.6097, 0.3111, 0.0195), (0.2053, 0.6257, 0.0609), (0.1492, 0.0632, 0.7446))
_D50 = (0.9642, 1.0, 0.8249)
BT709 = (1.0 / 0.45, 1.0 / 1.099, 0.099 / 1.099, 1.0 / 4.5, 0.081)
"""Parameters of the curve of ITU-R BT.709."""


def encoding_of(profile: bytes, *, grey: bool) -> Encoding:
    """Return the encoding of a photograph, grey or of three channels, with an ICC profile.

    Parameters
    ----------
    profile : bytes
    grey : bool

    Returns
    -------
    {"srgb", "linear"}, float or ToneCurves
        "srgb" and "linear" where the curves agree with these up to :data:`lommel.base.encoding.CLOSE`.

    Raises
    ------
    ValueError
        If the profile is damaged, or has other than tone curves; the message says which.
    """
    try:
        (count,) = struct.unpack_from(">I", profile, 128)
        entries = [struct.unpack_from(">4sII", profile, 132 + 12 * k) for k in range(min(count, _MAX_TAGS))]
        tags = {name: profile[start : start + size] for name, start, size in entries}
        names = [b"kTRC"] if b"kTRC" in tags else [b"rTRC", b"gTRC", b"bTRC"]
        if not set(names) <= tags.keys():
            raise ValueError("has look-up tables (LUT), or else no tone curves")
        if names == [b"kTRC"] and profile[20:24] != b"XYZ ":
            raise ValueError("has a curve of lightness (L*) in place of light")
        curves = [_curve(tags[name]) for name in names]
    except (struct.error, ZeroDivisionError):
        raise ValueError("is damaged") from None
    light = np.array([curve for curve, _ in curves])
    if (light == light[0]).all():
        light = light[:1]
    elif grey:
        raise ValueError("has different curves for red, green and blue, but the photograph is grey")
    rising = np.maximum.accumulate(light, axis=1)  # rounded parameters may leave a dip where two parts join
    if not (np.abs(rising - light).max() <= CLOSE and (light[:, -1] > light[:, 0]).all()):
        raise ValueError("has tone curves that fall")
    stated, gamma = ToneCurves(profile, rising), curves[0][1]
    known: list[Encoding] = ["srgb", "linear"]
    if len(light) == 1 and gamma is not None and 0.1 <= gamma <= 10.0:
        known.append(gamma)
    return next((encoding for encoding in known if agree(encoding, stated)), stated)


def _curve(tag: bytes) -> tuple[Array, float | None]:
    """Return (1) the light of a curve at `LEVELS`, 0 to 1, (2) its exponent if it is a power."""
    if tag[:4] == b"curv":
        (count,) = struct.unpack_from(">I", tag, 8)
        if count > 1:
            table = np.array(struct.unpack_from(f">{min(count, len(tag))}H", tag, 12)) / 65535.0
            return np.interp(LEVELS, np.linspace(0.0, 1.0, count), table), None
        kind, given = 0, [struct.unpack_from(">H", tag, 12)[0] / 256.0 if count else 1.0]
    else:
        kind = struct.unpack_from(">H", tag, 8)[0] if tag[:4] == b"para" else len(_PARAMETERS)
        if kind >= len(_PARAMETERS):
            raise ValueError("has tone curves of an unknown type")
        given = [value / 65536.0 for value in struct.unpack_from(f">{_PARAMETERS[kind]}i", tag, 12)]
    # light = (a x + b)^g + e from x = d on, else c x + f.
    g, a, b, c, d, e, f = given + [1.0, 0.0, 0.0, 0.0, 0.0, 0.0][len(given) - 1 :]
    if kind in (1, 2):
        c, d, e, f = 0.0, -b / a, c, c
    with np.errstate(all="ignore"):  # powers of 0 and of large numbers, which the caller refuses
        light = np.where(d <= LEVELS, np.maximum(a * LEVELS + b, 0.0) ** g + e, c * LEVELS + f)
    return np.clip(light, 0.0, 1.0), g if kind == 0 else None


def profile_of(curve: Sequence[float], *, grey: bool, colours: Sequence[Sequence[float]] = SRGB) -> bytes:
    """Return an ICC profile (version 4) of a parametric curve: an exponent, or g, a, b, c and d."""

    def fixed(values: Sequence[float]) -> bytes:
        return struct.pack(f">{len(values)}i", *(round(65536.0 * value) for value in values))

    def text(words: str) -> bytes:
        encoded = words.encode("utf-16-be")
        return b"mluc\0\0\0\0" + struct.pack(">II2s2sII", 1, 12, b"en", b"US", len(encoded), 28) + encoded

    tone = b"para\0\0\0\0" + struct.pack(">HH", _PARAMETERS.index(len(curve)), 0) + fixed(curve)
    tags = {b"desc": text("tone curve"), b"cprt": text("CC0"), b"wtpt": b"XYZ \0\0\0\0" + fixed(_D50)}
    for name, colour in zip((b"rXYZ", b"gXYZ", b"bXYZ"), () if grey else colours, strict=not grey):
        tags[name] = b"XYZ \0\0\0\0" + fixed(colour)
    tags |= dict.fromkeys([b"kTRC"] if grey else [b"rTRC", b"gTRC", b"bTRC"], tone)
    table, body = struct.pack(">I", len(tags)), b""
    for name, tag in tags.items():
        padded = tag.ljust(-(-len(tag) // 4) * 4, b"\0")
        table += name + struct.pack(">II", 132 + 12 * len(tags) + len(body), len(tag))
        body += padded
    kinds = b"mntrGRAYXYZ " if grey else b"mntrRGB XYZ "
    head = struct.pack(">I4xI12s6H", 128 + len(table) + len(body), 0x04400000, kinds, 2026, 1, 1, 0, 0, 0)
    head += b"acsp" + bytes(28) + fixed(_D50)
    return head.ljust(128, b"\0") + table + body
