"""Computation of stacks of PSFs, chunk by chunk into a store: :func:`psf_to`."""

from __future__ import annotations

import math
import os
import secrets
import shutil
from collections.abc import Callable, Generator, Iterator, Mapping, Sequence
from concurrent import futures
from contextlib import ExitStack, closing, contextmanager, nullcontext, suppress
from dataclasses import dataclass, field, replace
from functools import partial
from pathlib import Path
from typing import Any, Unpack

import numpy as np

from lommel.base import atomic, validation
from lommel.base.arrays import Array
from lommel.base.cached import cached_property
from lommel.base.checksums import crc32, plain
from lommel.base.optional import version
from lommel.base.options import near
from lommel.channel_psf import PSFKeywords
from lommel.io.registry import Arrays, Description
from lommel.io.zarr_folders import Layout
from lommel.methods.choice import candidates, first_proven, settled
from lommel.methods.method import Method
from lommel.methods.question import for_axes
from lommel.optics.base_pupil import BasePupil, imaged
from lommel.optics.grid import Grid
from lommel.psf import Plan
from lommel.stacks import stack as stores
from lommel.stacks.stack import Center, Index, PSFStack, Store, apart, layouts, together

_METRES = ("object_distance", "depth", "z", "wavelength")
_TAKEN = ("y", "x", "values", "error_bound", "scale", "method", "pupil", "chunks", "term")
_MOST_AXES = 8


@dataclass(frozen=True, eq=False)
class Request:
    """A checked request for a stack: its pupils, their methods, and its description.

    Attributes
    ----------
    pupils : tuple of Pupil or ObjectivePupil
        One stack, or, where more than the phase differs and `listed`, one for each of the first axis.
    prepare : partial of Plan
        All that is asked but the pupils, their center and their method, as it is sent to workers.
    ways : tuple
        The methods for each of the pupils, in order: chosen for all of a stack, whatever the chunks.
    methods : list
        All of them, each once.
    said : dict
        The description, in plain types.
    arrays : dict of str to ndarray
        Arrays that differ between the pupils.
    """

    pupils: tuple[BasePupil, ...]
    listed: bool
    prepare: partial[Plan]
    ways: tuple[tuple[Method, ...], ...]
    grid: Grid
    axes: dict[str, Array]
    methods: list[Method]
    said: Description
    arrays: dict[str, Array] = field(repr=False)

    def part(self, index: Index) -> tuple[BasePupil, Center, tuple[Method, ...]]:
        """Return the pupils of a chunk, the center of their windows, and their methods."""
        members = self.layouts["scale"]
        within = members.within(index)
        if not self.listed:
            center = self.grid[within].center if self.grid.stack else self.grid.center
            return self.pupils[0][within], center, self.ways[0]
        k = within[0].start
        one = self.pupils[k][within[1:]] if self.pupils[k].shape else self.pupils[k]
        return one.broadcast(members.part(index)), self.grid.center, self.ways[k]

    def seal(self, index: Index) -> int:
        """Return the checksum of the pupils of a chunk, as in a store."""
        found = {f"pupil/{name}": at for name, at in self.arrays.items()}
        parts = {name: np.asarray(at[self.layouts[name].within(index)], "<f8") for name, at in found.items()}
        return crc32({}, parts)

    @cached_property
    def layouts(self) -> dict[str, Layout]:
        """The arrays of its store."""
        return layouts(self.said)


def requested(
    plan: Plan, pupils: BasePupil | Sequence[BasePupil], axes: Mapping[str, Any] | None, chunk: int | None
) -> Request:
    """Return a checked request; see :func:`lommel.psf_to`."""
    stacks, listed, grid = _stacks(pupils, plan)
    stack = (len(stacks), *stacks[0].shape) if listed else stacks[0].shape
    if not 1 <= len(stack) <= _MOST_AXES:
        raise ValueError(f"pupils must be a stack of 1 to {_MOST_AXES} axes, got shape {stack}; psf computes one")
    ways = tuple(
        settled(candidates(one, grid, plan.tol), one, grid) if plan.method is None else (plan.method,)
        for one in stacks
    )
    flat = [way for each in ways for way in each]
    methods = [way for k, way in enumerate(flat) if way not in flat[:k]]
    dtype = np.dtype(plan.dtype)
    # Sums of transforms by several threads differ in their last bits.
    asked: PSFKeywords = {"normalize": plan.normalize, "dtype": dtype, "blur": plan.blur, "threads": 1}
    asked |= {"integrate": grid.integrate, "fill": grid.fill}
    prepare = partial(Plan, grid.shape, grid.pixel, **asked)
    fit = max(1, stores.DEFAULT // (dtype.itemsize * math.prod(grid.shape)))
    most = fit if chunk is None else validation.integer("chunk", chunk, least=1, most=validation.MAX_VALUES)
    shared, arrays = _differences(stacks, listed)
    if grid.stack:
        arrays |= {"row": np.asarray(grid.center[0]), "column": np.asarray(grid.center[1])}
    places, units = _axes(axes, stack, arrays, stacks[0].unit)
    said = {
        "software": f"lommel {version()}",
        "format": stores.FORMAT,
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
        "methods": [way.to_dict() for way in methods],
        "normalize": plan.normalize,
        "dtype": dtype.name,
        "chunks": [1, *stores.cut(stack[1:], most)] if listed else stores.cut(stack, most),
        "pupils": shared,
        "arrays": {name: [list(at.shape[len(stack) :]), crc32({}, {name: at})] for name, at in arrays.items()},
    }
    return Request(stacks, listed, prepare, ways, grid, places, methods, plain(said), arrays)


def _stacks(pupils: BasePupil | Sequence[BasePupil], plan: Plan) -> tuple[tuple[BasePupil, ...], bool, Grid]:
    """Return the pupils as one stack, or as one for each of the first axis, whether they are that, and the grid."""
    listed = isinstance(pupils, Sequence)
    stacks: tuple[BasePupil, ...] = tuple(
        imaged(one) for one in (pupils if isinstance(pupils, Sequence) else [pupils])
    )
    if not stacks:
        raise ValueError("pupils must not be an empty list")
    grid = plan.grid(stacks[0])
    for k, one in enumerate(stacks[1:], 1):
        for name, mine, first in (("shape", one.shape, stacks[0].shape), ("unit", one.unit, stacks[0].unit)):
            if mine != first:
                raise ValueError(f"pupils must all have the {name} of the first, {first}, got {mine} of pupils[{k}]")
    if listed:
        shared, arrays = _differences(stacks, listed)
        if len(shared) == 1:  # only their phases differ
            stacks, listed = (together(shared[0], arrays),), False
    if grid.stack:
        if listed:
            raise ValueError("center must be one (row, column) for listed pupils of several wavelengths or apertures")
        stacks = (for_axes(stacks[0], grid.stack),)
        grid = grid.broadcast(stacks[0].shape)
    return stacks, listed, grid


def _differences(stacks: tuple[BasePupil, ...], listed: bool) -> tuple[list[Description], dict[str, Array]]:
    """Return what pupils share, once if it is the same for all, and the arrays that differ."""
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
    given: Mapping[str, Any] | None, stack: tuple[int, ...], arrays: Mapping[str, Array], unit: str
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


def _found(stack: tuple[int, ...], arrays: Mapping[str, Array]) -> Arrays:
    """Return the default axes: distances, depths and z that change along one axis only, else indices."""
    names: dict[int, tuple[str, Array]] = {}
    for name in ("object_distance", "depth", "z"):
        if name in arrays:
            for axis, count in enumerate(stack):
                along = np.moveaxis(arrays[name], axis, 0).reshape(count, -1)
                if axis not in names and count > 1 and np.all(along == along[:, :1]):
                    names[axis] = name, along[:, 0]
                    break
    left = {axis: (f"axis_{axis}", np.arange(count)) for axis, count in enumerate(stack)}
    return dict((left | names)[axis] for axis in range(len(stack)))


def psf_to(
    store: str | os.PathLike[str],
    pupils: BasePupil | Sequence[BasePupil],
    shape: int | tuple[int, int],
    pixel: float | tuple[float, float],
    *,
    axes: Mapping[str, Any] | None = None,
    chunk: int | None = None,
    progress: Callable[[int, int], object] | None = None,
    client: Any = None,
    **options: Unpack[PSFKeywords],
) -> PSFStack:
    """Compute a stack of PSFs that may exceed memory, chunk by chunk, into a Zarr store.

    Called again with the same arguments, after an error, Ctrl-C or the end of the process, it computes the missing
    chunks. The values of a chunk are those of ``lommel.psf(pupils[chunk], ..., threads=1)``, bit for bit, independent
    of the order of computation.

    Parameters
    ----------
    store : path
        ``.zarr``, a folder (Zarr version 3).
    pupils : Pupil or ObjectivePupil, or sequence of these
        A stack. A sequence of stacks of one shape forms the first axis, such as one for each wavelength; if they
        differ in more than the phase, no chunk holds two of them, and all have one center.
    shape, pixel
        As of :func:`lommel.psf`.
    axes : mapping of str to array_like or (array_like, str), optional
        Names of the axes of the stack, in order, each with its coordinates and optionally their unit. By default the
        object distances, or depths and z, of the pupils, if these change along one axis only, else ``axis_0`` and so
        on. ``object_distance, depth, z, wavelength`` are in metres; names that begin with ``field`` have the unit of
        the pupils.
    chunk : int, optional
        Maximum number of PSFs in a chunk; by default as many as fit in 16 MiB, or that of an existing store. Values
        depend on it within their error bounds.
    progress : callable, optional
        Called as ``progress(done, chunks)`` after each computed chunk.
    client : distributed.Client or concurrent.futures.Executor, optional
        Executor of the chunks; by default threads of this process. Workers write into the store under the same path.
    **options
        ``method``, ``tol``, ``normalize``, ``dtype``, ``center``, ``integrate``, ``fill`` and ``blur`` as of
        :func:`lommel.psf`; ``threads``, by default one for each processor, each of which computes a chunk, not with a
        client.

    Returns
    -------
    PSFStack
        As :func:`lommel.open_stack` reads it.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range, or if the store holds PSFs of another request, or another call computes these.
    FileError
        If the path holds something else, or if the store is damaged, removed or replaced.
    ToleranceError
        If the tolerance cannot be met; chunks that were computed before stay.
    OSError
        If the store cannot be written, or does not fit on the disk.

    Examples
    --------
    >>> import lommel as lm
    >>> import numpy as np
    >>> lens = lm.Lens(focal_length=50e-3, f_number=1.8, focus_distance=2.0, wavelength=550e-9)
    >>> stack = lm.psf_to("depths.zarr", lens.pupil(np.linspace(1.0, 3.0, 5000)), 33, 3e-6)  # doctest: +SKIP
    """
    if stray := [name for name in options if name not in PSFKeywords.__annotations__]:
        raise TypeError(f"psf_to() has no option {stray[0]!r}; {near(stray[0], PSFKeywords.__annotations__)}")
    path = stores.path_of(store)
    validation.function("progress", progress, required=False)
    plan, (pool, slots) = Plan(shape, pixel, **options), _pool(client)
    if pool is not None and plan.threads:
        raise ValueError(f"threads must be left out with a client, which has its own, got {plan.threads}")
    there = Store.open(path) if path.exists() else None
    request = requested(plan, pupils, axes, chunk)
    if there is not None and chunk is None:
        same = replace(request, said=request.said | {"chunks": there.said["chunks"]})
        request = request if _difference(there.said, same.said) else same
    opened = _begun(path, there, request)
    marks = opened.marks()
    todo = [tuple(int(i) for i in index) for index in np.argwhere(~marks)]
    if pool is None:
        slots = min(plan.threads or os.cpu_count() or 1, max(1, len(todo)))
    with _held(opened) if todo else nullcontext():
        _require_room(opened, len(todo))
        work = partial(_work, opened, request.methods, request.prepare)
        tasks = ((index, request.seal(index), *request.part(index)) for index in todo)
        with closing(_computed(pool, slots, work, tasks)) as found:
            for done, _ in enumerate(found, marks.size - len(todo) + 1):
                if progress is not None:
                    progress(done, marks.size)
    _require_there(opened)
    return PSFStack(opened)


def _begun(path: Path, there: Store | None, request: Request) -> Store:
    """Return the store of the request, new if there is none, or in place of an empty one of another request."""
    other = "" if there is None else _difference(there.said, request.said)
    if there is not None and not other:
        return there
    said = request.said | {stores.IDENTITY: secrets.token_hex(16)}
    arrays: Arrays = {f"pupil/{name}": at for name, at in request.arrays.items()}
    if not request.grid.stack:
        arrays |= {"y": request.grid.y, "x": request.grid.x}
    with nullcontext() if there is None else _held(there, alone=True):
        if there is not None and there.marks().any():
            raise _taken(path, other)
        with suppress(FileExistsError):  # another call may have created it at the same time
            Store.create(path, said, arrays | request.axes, new=there is None)
    made = _opened(path)
    if other := _difference(made.said, request.said):
        raise _taken(path, other)
    return made


def _taken(path: Path, other: str) -> ValueError:
    return ValueError(
        f"store must be new, or asked for as it was: {validation.line(path)} holds PSFs of another request ({other})"
    )


@contextmanager
def _held(store: Store, *, alone: bool = False) -> Iterator[None]:
    """Hold a store, with others to compute into it, or alone to replace it; ValueError if that cannot be."""
    with ExitStack() as held:
        try:
            known = held.enter_context(atomic.in_use(store.mark, store.path, alone=alone))
        except FileNotFoundError:
            raise stores.replaced(store.path) from None
        if alone and not known:
            raise atomic.unsure(store.path)
        # Without locks, every write still checks that the store was not replaced.
        _require_there(store)
        yield


def _opened(path: Path) -> Store:
    """Return the store that is at the path now; FileError if it is gone."""
    try:
        return Store.open(path)
    except FileNotFoundError:
        raise stores.replaced(path) from None


def _require_there(store: Store) -> None:
    """Raise FileError if the store was replaced since it was opened."""
    if _opened(store.path).said != store.said:
        raise stores.replaced(store.path)


def _difference(there: Description, asked: Description) -> str:
    """Return the first difference of two descriptions in words, chunks last; "" if there is none."""
    for name in sorted(asked, key=lambda name: (name == "chunks", name not in ("software", "stack", "window"))):
        if there.get(name) != asked[name]:
            if name in ("arrays", "pupils", "coordinates"):
                return "the coordinates are others" if name == "coordinates" else "the pupils are others"
            return f"{name}: {validation.shown(there.get(name))} there, {validation.shown(asked[name])} asked for"
    return ""


def _require_room(store: Store, chunks: int) -> None:
    """Raise OSError if the disk has no space for so many chunks."""
    values = store.layouts["values"]
    needed = chunks * values.nbytes // max(1, int(np.prod(values.grid)))
    free = shutil.disk_usage(store.path.parent).free
    if needed > free:
        raise OSError(
            28, f"the store needs {needed / 1e9:.3g} GB more, and {free / 1e9:.3g} GB are free", str(store.path)
        )


def _pool(client: Any) -> tuple[futures.Executor | None, int]:
    """Return the executor of a client, and how many chunks to submit at a time."""
    if client is None:
        return None, 0
    if isinstance(client, futures.Executor):
        return client, 2 * (os.cpu_count() or 1)
    if callable(getattr(client, "get_executor", None)):
        return client.get_executor(), 2 * max(1, sum(client.nthreads().values()))
    raise TypeError(f"client must be a distributed.Client, an Executor or None, got {validation.shown(client)}")


def _computed(
    pool: futures.Executor | None, slots: int, work: Callable[..., None], tasks: Iterator[tuple[object, ...]]
) -> Generator[None]:
    """Yield as chunks are done, a few of them at a time; after an error no other is begun."""
    under_way: set[futures.Future[None]] = set()
    with futures.ThreadPoolExecutor(slots) if pool is None else nullcontext(pool) as executor:
        try:
            for task in tasks:
                if len(under_way) > slots:
                    done, under_way = futures.wait(under_way, return_when=futures.FIRST_COMPLETED)
                    yield from (one.result() for one in done)
                under_way.add(executor.submit(work, *task))
            yield from (one.result() for one in futures.as_completed(under_way))
        finally:
            for one in under_way:
                one.cancel()


def _work(
    store: Store,
    methods: list[Method],
    prepare: partial[Plan],
    index: Index,
    seal: int,
    pupil: BasePupil,
    center: Center,
    ways: tuple[Method, ...],
) -> None:
    """Compute a chunk, and write it."""
    _, made = first_proven(ways, lambda way: prepare(method=way, center=center)(pupil))
    bound = np.nan if made.error_bound is None else made.error_bound
    parts: Arrays = {
        "values": made.values,
        "error_bound": np.full(pupil.shape, bound),
        "scale": np.asarray(made.scale),
        "method": np.full(pupil.shape, methods.index(made.method), np.uint8),
    }
    store.keep(index, parts, seal)
