"""Interferogram files of Code V, .int: Zernike coefficients or a grid, in plain text."""

from __future__ import annotations

import io
import math
import re
from array import array
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from lommel.base import validation
from lommel.base.arrays import Array

_SIZES = {"GRD": 2, "ZRN": 1, "ZFR": 1}
_NUMBERS = ("WVL", "SSZ", "NDA", "XSC")
_FLAGS = ("NNB",)  # how to interpolate between the points of a grid
_HOLDS = {"WFR": "a wavefront", "SUR": "the shape of a surface", "FIL": "a filter of intensity"}


class Interferogram(NamedTuple):
    """A grid (GRD), Zernike terms in Code V's order (ZRN), or Fringe terms (ZFR)."""

    kind: str
    size: tuple[int, ...]  # columns and rows of a grid, or the number of terms
    wavelength: float  # metres
    values: Array  # waves at this wavelength
    missing: NDArray[np.bool_]  # marked by NDA


def parse(text: str) -> Interferogram:
    """Return the contents of a file that is a wavefront."""
    # The first line is a title, the second one such as ZFR 37 WFR WVL 0.6328 SSZ 1000 NDA 32767; lines that begin
    # with ! are comments. A value over SSZ is in waves at WVL micrometres.
    lines = (line for line in io.StringIO(text) if line.strip() and not line.lstrip().startswith("!"))
    title, sizes = next(lines, ""), next(lines, "")
    stored = array("d", (_number(word[0], "a value") for line in lines for word in re.finditer(r"\S+", line)))
    if not title or not sizes or not stored:
        raise ValueError("it has no title, line of sizes and values")
    words = sizes.upper().split()
    kind = words[0]
    if kind not in _SIZES:
        raise ValueError(f"its second line must begin with {', '.join(_SIZES)}, got {validation.shown(words[0])}")
    count = _SIZES[kind]
    size = tuple(_whole(word) for word in words[1 : 1 + count])
    rest, holds, told = words[1 + count :], [], {}
    while rest:
        word = rest.pop(0)
        if word in _HOLDS:
            holds.append(word)
        elif word in _FLAGS:
            continue
        elif word in _NUMBERS and rest:
            told[word] = _number(rest.pop(0), word)
        else:
            raise ValueError(f"its second line holds {validation.shown(word)}, which is unknown")
    if holds != ["WFR"]:
        what = " and ".join(_HOLDS[word] for word in holds) or "nothing that it names"
        raise ValueError(f"it must hold a wavefront (WFR), got {what}")
    if missing := [word for word in ("WVL", "SSZ") if not told.get(word, 0.0) > 0.0]:
        raise ValueError(f"it does not state {' and '.join(missing)}, the wavelength and the value of one wave")
    wavelength = validation.wavelength(1e-6 * told["WVL"])
    wanted = size[0] * size[-1] if count == 2 else size[0]
    if len(size) != count or len(stored) != wanted:
        raise ValueError(f"it says {' x '.join(map(str, size))} values, got {len(stored)}")
    nothing = told.get("NDA")
    values = np.array(stored)
    none = np.zeros(values.shape, np.bool_) if nothing is None else values == nothing
    return Interferogram(kind, size, wavelength, values / told["SSZ"], none)


def term(index: int) -> tuple[int, int]:
    """Return (n, m) of a term in Code V's order (ZRN), from 1: by n, and from cos(n theta) to sin(n theta)."""
    n = 0
    while index > (n + 1) * (n + 2) // 2:
        n += 1
    return n, n - 2 * (index - n * (n + 1) // 2 - 1)


def _whole(word: str) -> int:
    if not word.isdecimal() or not 0 < int(word) <= validation.MAX_SIDE:
        raise ValueError(f"a size must be an integer from 1 to {validation.MAX_SIDE}, got {validation.shown(word)}")
    return int(word)


def _number(word: str, name: str) -> float:
    try:
        value = float(word.replace("D", "E"))
        return value if math.isfinite(value) else validation.real(name, value)
    except ValueError:
        raise ValueError(f"{name} must be a finite number, got {validation.shown(word)}") from None
