"""How a stack is cut into chunks, and which arrays a store of it holds: by what was asked alone."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from lommel.base import validation

FORMAT = 2
MAX_CHUNKS = 2**24
"""Most chunks of a stack, which may have 2^31 PSFs."""
DEFAULT = 2**24
"""Bytes of the values of a chunk where none was named."""
MARKS = "chunks/checksum"
"""The array with the checksum of each chunk, or -1 where that is not there yet."""
OF_CHUNK = ("values", "error_bound", "scale", "method")
"""What is computed of a chunk."""

Index = tuple[int, ...]


def cut(shape: tuple[int, ...], most: int) -> tuple[int, ...]:
    """Return the shape of chunks of at most so many members each, which are alike but for the last of an axis.

    Axes are whole from the last on, as far as they fit, and cut evenly: a chunk is a run of the flattened stack.

    Parameters
    ----------
    shape : tuple of int
        Of the stack.
    most : int
        1 or more.

    Returns
    -------
    tuple of int
    """
    chunk = [1] * len(shape)
    for axis in reversed(range(len(shape))):
        parts = -(-shape[axis] // min(most, shape[axis]))
        chunk[axis] = -(-shape[axis] // parts)
        if parts > 1:
            break
        most //= shape[axis]
        if most < 2:
            break
    return tuple(chunk)


@dataclass(frozen=True)
class Layout:
    """An array of a store.

    Parameters
    ----------
    shape, chunks : tuple of int
    dtype : str
        Such as "<f4".
    dimensions : tuple of str
        Names of its axes.
    """

    shape: tuple[int, ...]
    chunks: tuple[int, ...]
    dtype: str
    dimensions: tuple[str, ...]

    @property
    def grid(self) -> tuple[int, ...]:
        """How many chunks there are along each axis."""
        return tuple(-(-n // c) for n, c in zip(self.shape, self.chunks, strict=True))

    def within(self, index: Index) -> tuple[slice, ...]:
        """Return where a chunk is in the array; axes that `index` does not name are not cut."""
        whole = (*index, *(0,) * (len(self.shape) - len(index)))
        sides = zip(whole, self.chunks, self.shape, strict=True)
        return tuple(slice(i * c, min((i + 1) * c, n)) for i, c, n in sides)

    def first(self, index: Index) -> int:
        """Return the place in the flattened array of the first value of a chunk."""
        place = tuple(part.start for part in self.within(index))
        return int(np.ravel_multi_index(place, self.shape)) if place else 0

    def part(self, index: Index) -> tuple[int, ...]:
        """Return the shape of a chunk, smaller at the end of an axis."""
        return tuple(part.stop - part.start for part in self.within(index))

    @property
    def nbytes(self) -> int:
        """Bytes of all of it."""
        return math.prod(self.shape) * np.dtype(self.dtype).itemsize


def layouts(said: Mapping[str, Any]) -> dict[str, Layout]:
    """Return the arrays of the store of a description, by name; those of "pupil/" and of axes among them.

    Parameters
    ----------
    said : mapping
        As ``lommel.stacks.request`` makes it.

    Returns
    -------
    dict of str to Layout

    Raises
    ------
    TypeError, ValueError, KeyError
        If it is no such description.
    """
    stack, window, chunks = (tuple(int(n) for n in said[name]) for name in ("stack", "window", "chunks"))
    names = tuple(said["axes"])
    kind = {"float32": "<f4", "float64": "<f8"}[said["dtype"]]
    if not len(names) == len(stack) == len(chunks) >= 1 or min(*stack, *chunks, *window) < 1 or len(window) != 2:
        raise ValueError(f"axes {names}, chunks {chunks} and windows {window} for a stack of shape {stack}")
    count = math.prod(-(-n // c) for n, c in zip(stack, chunks, strict=True))
    if math.prod(stack) > validation.MAX_VALUES or count > MAX_CHUNKS:
        raise ValueError(
            f"a stack must have at most {validation.MAX_VALUES} PSFs in {MAX_CHUNKS} chunks, "
            f"got {math.prod(stack)} in {count}"
        )
    found = {
        "values": Layout(stack + window, chunks + window, kind, (*names, "y", "x")),
        "error_bound": Layout(stack, chunks, "<f8", names),
        "scale": Layout(stack, chunks, "<f8", names),
        "method": Layout(stack, chunks, "|u1", names),
    }
    if not all(name.isidentifier() for name in (*names, *said["arrays"])) or {*names} & {*found, "y", "x"}:
        raise ValueError(f"axes {names} and arrays {list(said['arrays'])} are not names of this kind")
    for name, (more, _) in said["arrays"].items():
        further = tuple(int(n) for n in more)
        found[f"pupil/{name}"] = Layout(
            stack + further, chunks + further, "<f8", (*names, "term")[: len(stack + further)]
        )
    marks = found["scale"].grid
    found[MARKS] = Layout(marks, (1,) * len(marks), "<i8", tuple(f"{name}_chunk" for name in names))
    places = {name: (n, "<f8") for name, n in zip(names, stack, strict=True)}
    if said["center"] is not None:
        places |= {"y": (window[0], "<f8"), "x": (window[1], "<f8")}
    return found | {name: Layout((n,), (n,), dtype, (name,)) for name, (n, dtype) in places.items()}
