"""What is asked of a stack: checked once, described in plain types, answered chunk by chunk."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.base.cached import cached_property
from lommel.base.checksums import crc32
from lommel.base.optional import version
from lommel.blur.blurs import Blur
from lommel.methods.choice import candidates, first_proven
from lommel.methods.method import Method
from lommel.methods.question import for_axes
from lommel.optics.base_pupil import BasePupil, imaged
from lommel.optics.grid import Grid
from lommel.optics.stacked import apart, together
from lommel.psf import PSF, Plan
from lommel.stacks.layout import DEFAULT, FORMAT, Index, Layout, cut, layouts

_METRES = ("object_distance", "depth", "z", "wavelength")
_TAKEN = ("y", "x", "values", "error_bound", "scale", "method", "pupil", "chunks", "term")
_MOST_AXES = 8


@dataclass(frozen=True)
class Options:
    """The same, with defaults.

    Parameters
    ----------
    method, tol, normalize, dtype, integrate, fill, blur : optional
        As of :func:`lommel.psf`.
    center : (float, float) or (array_like, array_like), optional
        As of :func:`lommel.psf`; arrays broadcast with the stack.
    threads : int, optional
        At most so many, by default as many as there are processors; each computes a chunk. Not with a client.
    """

    method: Method | None = None
    tol: float | None = None
    normalize: str = "energy"
    dtype: DTypeLike | None = None
    center: tuple[ArrayLike, ArrayLike] | None = None
    integrate: bool | None = None
    fill: float | tuple[float, float] = 1.0
    blur: Blur | Sequence[Blur] = ()
    threads: int | None = None


@dataclass(frozen=True)
class Question:
    """All that is asked but the pupils, as workers are sent it."""

    window: tuple[int, int]
    pixel: float | tuple[float, float]
    integrate: bool
    fill: tuple[float, float]
    blur: tuple[Blur, ...]
    normalize: str
    dtype: str

    def answer(self, pupil: BasePupil, center: Any, ways: tuple[Method, ...]) -> PSF:
        """Return the PSFs of a stack around `center`, by the first of the methods that proves its tolerance."""

        def ask(way: Method) -> PSF:
            plan = Plan(
                self.window,
                self.pixel,
                method=way,
                normalize=self.normalize,
                dtype=self.dtype,
                center=center,
                integrate=self.integrate,
                fill=self.fill,
                blur=self.blur,
                threads=1,  # for sums of transforms by several differ in their last bits
            )
            return plan(pupil)

        return first_proven(ways, ask)[1]


@dataclass(frozen=True, eq=False)
class Request:
    """A stack that is asked for.

    Attributes
    ----------
    pupils : tuple of Pupil or ObjectivePupil
        One stack, or, where more than the phase differs, one for each of the first axis.
    listed : bool
        Whether it is that.
    question : Question
    ways : tuple
        The methods for each of the pupils, as they are tried: chosen for all of a stack, whatever the chunks.
    grid : Grid
        Of the whole stack.
    axes : dict of str to ndarray
    said : dict
        Its description, in plain types.
    arrays : dict of str to ndarray
        What differs between the pupils.
    """

    pupils: tuple[BasePupil, ...]
    listed: bool
    question: Question
    ways: tuple[tuple[Method, ...], ...]
    grid: Grid
    axes: dict[str, Array]
    said: dict[str, Any]
    arrays: dict[str, Array] = field(repr=False)

    def part(self, index: Index) -> tuple[BasePupil, Any, tuple[Method, ...]]:
        """Return the pupils of a chunk, the center of their windows, and the methods for them."""
        members = self.layouts["scale"]
        within = members.within(index)
        if not self.listed:
            center = self.grid[within].center if self.grid.stack else self.grid.center
            return self.pupils[0][within], center, self.ways[0]
        k = within[0].start
        one = self.pupils[k][within[1:]] if self.pupils[k].shape else self.pupils[k]
        return one.broadcast(members.part(index)), self.grid.center, self.ways[k]

    def seal(self, index: Index) -> int:
        """Return the checksum of the pupils of a chunk, as a store has them."""
        found = {f"pupil/{name}": at for name, at in self.arrays.items()}
        parts = {name: np.asarray(at[self.layouts[name].within(index)], "<f8") for name, at in found.items()}
        return crc32({}, parts)

    @cached_property
    def methods(self) -> list[Method]:
        """All methods that may be asked, each once."""
        return _different(self.ways)

    @cached_property
    def layouts(self) -> dict[str, Layout]:
        """The arrays of its store."""
        return layouts(self.said)


def requested(
    pupils: Any,
    shape: Any,
    pixel: float | tuple[float, float],
    axes: Mapping[str, Any] | None,
    chunk: int | None,
    options: Options,
) -> Request:
    """Return what is asked, checked; see :func:`lommel.psf_to`.

    Raises
    ------
    TypeError, ValueError
        If something is out of range, or does not fit the rest.
    """
    listed = isinstance(pupils, Sequence)
    stacks: tuple[BasePupil, ...] = tuple(imaged(one) for one in (pupils if listed else (pupils,)))
    plan = Plan(shape, pixel, **{name: value for name, value in vars(options).items() if name != "threads"})
    if not stacks:
        raise ValueError("pupils must not be an empty list")
    grid = plan.grid(stacks[0])
    for k, one in enumerate(stacks[1:], 1):
        for name, mine, first in (("shape", one.shape, stacks[0].shape), ("unit", one.unit, stacks[0].unit)):
            if mine != first:
                raise ValueError(f"pupils must all have the {name} of the first, {first}, got {mine} of pupils[{k}]")
    if listed:
        shared, arrays = _differences(stacks, listed)
        if len(shared) == 1:  # nothing but their phases tells them apart
            stacks, listed = (together(shared[0], arrays),), False
    if grid.stack:
        if listed:
            raise ValueError("center must be one (row, column) for listed pupils of several wavelengths or apertures")
        stacks = (for_axes(stacks[0], grid.stack),)
        grid = grid.broadcast(stacks[0].shape)
    stack = (len(stacks),) * listed + stacks[0].shape
    if not 1 <= len(stack) <= _MOST_AXES:
        raise ValueError(f"pupils must be a stack of 1 to {_MOST_AXES} axes, got shape {stack}; psf computes one")
    ways = tuple(candidates(one, grid, plan.tol) if plan.method is None else (plan.method,) for one in stacks)
    dtype = np.dtype(plan.dtype)
    question = Question(grid.shape, grid.pixel, grid.integrate, grid.fill, plan.blur, plan.normalize, dtype.name)
    shared, arrays = _differences(stacks, listed)
    if grid.stack:
        arrays |= {"row": np.asarray(grid.center[0]), "column": np.asarray(grid.center[1])}
    places, units = _axes(axes, stack, arrays, stacks[0].unit)
    fit = max(1, DEFAULT // (dtype.itemsize * math.prod(grid.shape)))
    most = fit if chunk is None else validation.integer("chunk", chunk, least=1, most=validation.MAX_VALUES)
    chunks = (*(1,) * listed, *cut(stack[1:] if listed else stack, most))
    said = {
        "software": f"lommel {version()}",
        "format": FORMAT,
        "stack": list(stack),
        "axes": units,
        "coordinates": crc32({}, dict(places)),
        "window": list(grid.shape),
        "pixel": grid.pixel,
        "unit": stacks[0].unit,
        "integrate": grid.integrate,
        "fill": list(grid.fill),
        "blur": [one.to_dict() for one in plan.blur],
        "center": None if grid.stack else list(grid.axis),
        "methods": [way.to_dict() for way in _different(ways)],
        "normalize": plan.normalize,
        "dtype": dtype.name,
        "chunks": list(chunks),
        "pupils": shared,
        "arrays": {name: [list(at.shape[len(stack) :]), crc32({}, {name: at})] for name, at in arrays.items()},
    }
    return Request(
        stacks, listed, question, ways, grid, places, json.loads(json.dumps(said, allow_nan=False)), arrays
    )


def _different(ways: tuple[tuple[Method, ...], ...]) -> list[Method]:
    found: list[Method] = []
    for way in (way for each in ways for way in each):
        if way not in found:
            found.append(way)
    return found


def _differences(stacks: tuple[BasePupil, ...], listed: bool) -> tuple[list[dict[str, Any]], dict[str, Array]]:
    """Return what pupils share, once where that is the same for all, and what differs, of the shape of the stack."""
    parts = [apart(one) for one in stacks]
    shared = [said for said, _ in parts]
    if not listed:
        return shared, parts[0][1]
    first = parts[0][1]
    for k, (_, other) in enumerate(parts):
        if {name: at.shape for name, at in other.items()} != {name: at.shape for name, at in first.items()}:
            raise ValueError(
                f"pupils must all be held in the same terms, got others of pupils[{k}] than of the first"
            )
    arrays = {name: np.stack([other[name] for _, other in parts]) for name in first}
    return (shared[:1] if all(said == shared[0] for said in shared) else shared), arrays


def _axes(
    given: Any, stack: tuple[int, ...], arrays: Mapping[str, Array], unit: str
) -> tuple[dict[str, Array], dict[str, str]]:
    """Return the coordinates of each axis of the stack, by name, and their units."""
    if given is None:
        given = _found(stack, arrays)
    if not isinstance(given, Mapping) or not all(isinstance(name, str) and name.isidentifier() for name in given):
        raise TypeError(f"axes must map names to coordinates, got {validation.shown(given)}")
    if len(given) != len(stack):
        raise ValueError(f"axes must name the {len(stack)} axes of a stack of shape {stack}, got {list(given)}")
    places, units = {}, {}
    for (name, value), count in zip(given.items(), stack, strict=True):
        if name in _TAKEN or name.endswith("_chunk"):
            raise ValueError(f"axes must not be called {', '.join(_TAKEN)} or ..._chunk, got {name}")
        known = "m" if name in _METRES else unit if name.startswith("field") else "1"
        if isinstance(value, tuple) and len(value) == 2 and isinstance(value[1], str):
            value, known = value
        # An object may be at infinity.
        at = np.array(validation.number_array(f"axes[{name!r}]", value), dtype=np.float64)
        if at.shape != (count,) or np.isnan(at).any():
            raise ValueError(f"axes[{name!r}] must be {count} numbers, got {validation.shown(value)}")
        places[name], units[name] = at, known
    return places, units


def _found(stack: tuple[int, ...], arrays: Mapping[str, Array]) -> dict[str, NDArray[Any]]:
    """Return the axes that pupils know themselves: those along which alone one of their lengths changes."""
    names: dict[int, tuple[str, NDArray[Any]]] = {}
    for name in ("object_distance", "depth", "z"):
        if name in arrays:
            for axis, count in enumerate(stack):
                along = np.moveaxis(arrays[name], axis, 0).reshape(count, -1)
                if axis not in names and count > 1 and np.all(along == along[:, :1]):
                    names[axis] = name, along[:, 0]
                    break
    left = {axis: (f"axis_{axis}", np.arange(count)) for axis, count in enumerate(stack)}
    return dict((left | names)[axis] for axis in range(len(stack)))
