"""Stacks of PSFs larger than memory: computed chunk by chunk into a store, a Zarr folder, and read in parts.

A chunk is a file of each array. Writing one changes nothing else, and a process that is killed meanwhile leaves all
others as they were.

Every store has an identity, a random number. Each write compares it, so that nothing is written into another store
that has taken the place of this one, and every checksum includes it, so that chunks of another store are detected.
"""

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
from typing import Any, Self, TypeAlias, Unpack

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lommel.base import atomic, validation
from lommel.base.arrays import Array, Json, Values
from lommel.base.arrays import Index as ArrayIndex
from lommel.base.atomic import checksum, crc32, plain, sealed
from lommel.base.cached import cached_property
from lommel.base.optional import library, version
from lommel.base.options import near
from lommel.blur.blurs import blurs_from_dicts
from lommel.channel_psf import PSFKeywords
from lommel.io import zarr_folders
from lommel.io.psf_files import NORMALIZE, FileError, as_file_error
from lommel.io.registry import Arrays, Description
from lommel.io.zarr_folders import Layout, ZarrArray
from lommel.methods.choice import candidates, first_within_tolerance, fixed_order
from lommel.methods.method import Method
from lommel.methods.question import for_axes
from lommel.methods.registry import method_from_dict
from lommel.optics.base_pupil import BasePupil, Geometry, imaged
from lommel.optics.grid import Grid
from lommel.optics.layers.objective_pupil import PLANES, ObjectivePupil
from lommel.optics.pupil import Pupil
from lommel.optics.pupil import checked as checked_pupil
from lommel.optics.wavefront.wavefront import Wavefront
from lommel.psf import PSF, Plan
from lommel.special import zernike

KEY = "lommel"
IDENTITY = "identity"
WHAT = "a stack of PSFs"

FORMAT = 2
MAX_CHUNKS = 2**24
"""Largest number of chunks of a stack."""
DEFAULT = 2**24
"""Bytes of the values of a chunk by default."""
MARKS = "chunks/checksum"
"""The array with the checksum of each chunk, or -1 where it is not computed yet."""
OF_CHUNK = ("values", "error_bound", "scale", "method")
"""The computed arrays."""

Index = tuple[int, ...]
Center: TypeAlias = tuple[ArrayLike, ArrayLike]
Places: TypeAlias = ArrayLike | tuple[ArrayLike, str]
"""Coordinates along an axis of a stack, or these and their unit."""


def cut(shape: tuple[int, ...], most: int) -> tuple[int, ...]:
    """Return the shape of equal chunks of a stack, of at most so many members, each a run of the flattened stack."""
    # Axes are whole from the last on, as far as they fit.
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


def layouts(said: Description) -> dict[str, Layout]:
    """Return the arrays of the store of a description, by name; TypeError, ValueError or KeyError if it is none."""
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


@dataclass(frozen=True)
class Store:
    """An existing store, by its path and its description: a Zarr group of version 3 of plain arrays.

    A chunk is written in a folder named by the identity of the store, and moved into place: another store in its
    place has no such folder, and nothing is written. Other processes that see the same files can use it.
    """

    path: Path
    said: Description = field(repr=False)
    layouts: dict[str, Layout] = field(repr=False)

    @classmethod
    def create(cls, path: Path, said: Description, arrays: Arrays, *, new: bool) -> None:
        """Write a store without chunks, in place of an existing one, or FileExistsError if it has to be `new`."""

        def fill(folder: Path) -> None:
            zarr_folders.write_group(folder, {KEY: sealed(said, {})})
            for name, layout in layouts(said).items():
                array = ZarrArray(folder / name, layout)
                array.create(fill=missing(name, layout), attributes=units(said, name), values=arrays.get(name))
            ZarrArray(_scratch(folder, said), Layout((), (), "|u1")).create()

        atomic.write_folder(path, fill, new=new)

    @classmethod
    def open(cls, path: Path) -> Self:
        """Return the store at a path; FileError if there is something else."""
        if not path.is_dir():
            raise FileNotFoundError(2, os.strerror(2), str(path))
        with as_file_error(path, WHAT):
            said, found = checked(zarr_folders.attributes(path)[KEY])
            store = cls(path, said, found)
            for name in found:
                if ZarrArray.open(path / name) != store._array(name):
                    raise ValueError(f"its array {name} is stored in another way; zarr reads it")
            return store

    @property
    def mark(self) -> Path:
        """The file that calls hold while they compute into it."""
        return self.path / zarr_folders.META

    def _array(self, name: str) -> ZarrArray:
        return ZarrArray(self.path / name, self.layouts[name])

    def marks(self) -> NDArray[np.bool_]:
        """Return which chunks are computed: have a mark, and a file of each array."""
        found = np.ones(self.layouts[MARKS].grid, dtype=bool)
        for name in (*OF_CHUNK, MARKS):
            there = np.zeros_like(found)
            with as_file_error(self.path, WHAT), os.scandir(self.path / name) as entries:
                for entry in entries:
                    key, *numbers = entry.name.split(".")
                    if key == "c" and all(number.isdecimal() for number in numbers):
                        index = tuple(int(number) for number in numbers[: found.ndim])
                        there[index] = name != MARKS or (found[index] and self._mark(index) >= 0)
            found &= there
        return found

    def get(self, name: str, index: Index) -> Values | None:
        """Return a chunk of an array, or None where its file is missing."""
        with as_file_error(self.path, WHAT):
            try:
                return self._array(name).get(index)
            except FileNotFoundError:
                return None

    def put(self, parts: Arrays, index: Index) -> None:
        """Write a chunk of some arrays, whole or not at all; FileError if the store was replaced."""
        try:
            with atomic.whole_files(_scratch(self.path, self.said)) as write:
                for name, part in parts.items():
                    array = self._array(name)
                    write(array.file(index), array.packed(part))
        except (FileNotFoundError, NotADirectoryError):
            raise replaced(self.path) from None

    def keep(self, index: Index, made: Arrays, pupils: int) -> None:
        """Write a computed chunk, then its mark: a checksum that includes that of the requested `pupils`."""
        self.put(made, index)
        self.put({MARKS: np.full((1,) * len(index), self._sum(index, made, pupils))}, index)

    def chunk(self, index: Index) -> Arrays:
        """Return the arrays of a chunk, pupils too; ValueError if it is not computed yet, FileError if damaged."""
        mark = self._mark(index)
        if mark < 0:
            raise ValueError(
                f"chunk {index} of {validation.line(self.path)} is not there yet: call psf_to as before to go on"
            )
        made = {name: self.require(name, index) for name in OF_CHUNK}
        pupils = {name: self.require(name, index) for name in self.pupils}
        if self._sum(index, made, crc32({}, pupils)) != mark:
            raise FileError(
                f"chunk {index} of {validation.line(self.path)} is damaged: its checksum is another; to compute it "
                f"again remove {MARKS}/{self._array(MARKS).file(index).name} in it, and call psf_to as before"
            )
        return made | pupils

    def whole(self, name: str) -> Values:
        """Return a whole array, such as the error bounds; NaN where chunks are not computed yet."""
        layout = self.layouts[name]
        out = np.full(layout.shape, missing(name, layout), layout.dtype)
        for index in np.ndindex(*layout.grid):
            if (part := self.get(name, index)) is not None:
                out[layout.within(index)] = part
        return out

    @property
    def pupils(self) -> list[str]:
        """Names of the arrays that differ between pupils."""
        return [name for name in self.layouts if name.startswith("pupil/")]

    def require(self, name: str, index: Index) -> Values:
        """Return a chunk of an array that the store must have; FileError if it has not."""
        part = self.get(name, index)
        if part is None:
            raise FileError(f"{validation.line(self.path)} lacks chunk {index} of {name}")
        return part

    def _mark(self, index: Index) -> int:
        found = self.get(MARKS, index)
        return -1 if found is None else int(found.flat[0])

    def _sum(self, index: Index, made: Arrays, pupils: int) -> int:
        """Return the checksum of a chunk with its index, the identity of the store and the checksum of its pupils."""
        return crc32({"chunk": [int(i) for i in index], "store": self.said[IDENTITY], "pupils": pupils}, made)


def replaced(path: Path) -> FileError:
    """Return the error for a store that was removed or replaced."""
    return FileError(
        f"{validation.line(path)} was removed, or replaced by another call of psf_to, while its PSFs were computed; "
        "call psf_to again, with a path that nobody else writes to"
    )


def missing(name: str, layout: Layout) -> float:
    """Return the fill value of an array."""
    return -1 if name == MARKS else np.nan if layout.dtype[1] == "f" else 0


def units(said: Description, name: str) -> dict[str, str]:
    """Return the attributes of an array: the unit of a coordinate."""
    known = {"y": said["unit"], "x": said["unit"]} | said["axes"]
    return {"units": known[name]} if name in known else {}


def checked(description: Description) -> tuple[Description, dict[str, Layout]]:
    """Return the description of a store, checked, and its arrays."""
    if description["checksum"] != checksum(description, {}):
        raise ValueError("its description was changed after it was written")
    said = {name: value for name, value in description.items() if name != "checksum"}
    if said["format"] != FORMAT:
        raise ValueError(f"it is of format {said['format']}, and this version reads {FORMAT}")
    if not isinstance(said[IDENTITY], str) or len(said[IDENTITY]) != 32 or not said[IDENTITY].isalnum():
        raise ValueError(f"its identity must be 32 letters and digits, got {validation.shown(said[IDENTITY])}")
    return said, layouts(said)


def _scratch(folder: Path, said: Description) -> Path:
    """Return the folder where chunks are written, an empty array to readers of the group."""
    return folder / "chunks" / str(said[IDENTITY])


def path_of(store: str | os.PathLike[str]) -> Path:
    """Return the path of a store, links followed; ValueError if it does not end in .zarr."""
    path = validation.path("store", store)
    if path.suffix.lower() != ".zarr":
        instead = ", which stacks are written to instead of HDF5" if path.suffix.lower() in (".h5", ".hdf5") else ""
        raise ValueError(f"store must end in .zarr{instead}, got {validation.shown(str(path))}")
    return Path(os.path.realpath(path))


def open_stack(store: str | os.PathLike[str]) -> PSFStack:
    """Open a store that :func:`lommel.psf_to` wrote, or is writing.

    Parameters
    ----------
    store : path
        A folder ``.zarr``.

    Returns
    -------
    PSFStack

    Raises
    ------
    ValueError
        If it does not end in ``.zarr``.
    FileError
        If the store is damaged, or was not written by :func:`lommel.psf_to`.
    OSError
        If it cannot be read.
    """
    return PSFStack(Store.open(path_of(store)))


class PSFStack:
    """A stack of PSFs in a store, read by index: ``stack[index]`` is a :class:`lommel.PSF`.

    The checksum of each chunk is verified when it is read.

    Parameters
    ----------
    store : Store
        From :func:`lommel.open_stack`.

    Attributes
    ----------
    shape : tuple of int
        Shape of all values: that of the stack, height, width.
    dtype : dtype
    axes : dict of str to ndarray
        Names of the axes of the stack, and the coordinates along each.
    units : dict of str to str
        Unit of each axis.
    grid : Grid or None
        Grid of pixels, if all PSFs have one center, else None.

    Raises
    ------
    FileError
        If its coordinates are damaged.
    """

    def __init__(self, store: Store) -> None:
        self._store, said = store, store.said
        layout = store.layouts["values"]
        self.shape: tuple[int, ...] = layout.shape
        self.dtype = np.dtype(layout.dtype)
        self.units: dict[str, str] = dict(said["axes"])
        with as_file_error(store.path, WHAT):
            self.axes: dict[str, Array] = {name: store.require(name, (0,)) for name in self.units}
            if crc32({}, dict(self.axes)) != said["coordinates"]:
                raise FileError(f"the coordinates of {validation.line(store.path)} are damaged")
            validation.choice("normalize", said["normalize"], NORMALIZE)
            self._methods = [method_from_dict(one) for one in said["methods"]]
            self.grid: Grid | None = None if said["center"] is None else self._pixels(said["center"])
        self._last: tuple[Index, Arrays] | None = None

    def __getstate__(self) -> dict[str, object]:
        return vars(self) | {"_last": None}

    @property
    def ndim(self) -> int:
        """Number of axes of the values."""
        return len(self.shape)

    @property
    def done(self) -> tuple[int, int]:
        """Numbers of computed chunks and of all chunks."""
        marks = self._store.marks()
        return int(marks.sum()), marks.size

    @property
    def error_bound(self) -> Array:
        """Bound on the error of each PSF over its peak, the largest of its chunk; NaN if not computed yet."""
        return self._store.whole("error_bound")

    @property
    def scale(self) -> Array:
        """Factor of the intensity of each PSF; NaN if not computed yet."""
        return self._store.whole("scale")

    @property
    def dask(self) -> Any:
        """The values as a dask array with the chunks of the store; needs dask."""
        da = library("dask.array", "stacks as arrays of dask need", "dask")
        chunks = self._store.layouts["values"].chunks
        name = f"psf-stack-{crc32(self._store.said | {'path': str(self._store.path)}, {}):08x}"
        return da.from_array(_Values(self), chunks=chunks, name=name, asarray=False, meta=np.empty(0, self.dtype))

    def to_xarray(self) -> Any:
        """Return a lazy ``xarray.Dataset`` of `values`, `error_bound` and `scale`; needs xarray and dask."""
        xarray = library("xarray", "stacks in xarray need", "xarray")
        said, names = self._store.said, tuple(self.axes)
        places = dict(self.axes)
        if self.grid is not None:
            places |= {"y": self.grid.y, "x": self.grid.x}
        units = self.units | {"y": said["unit"], "x": said["unit"]}
        told_once = {name: said[name] for name in ("software", "pixel", "unit", "normalize")}
        return xarray.Dataset(
            {
                "values": ((*names, "y", "x"), self.dask, {"sampling": "pixel" if said["integrate"] else "center"}),
                "error_bound": (names, self.error_bound),
                "scale": (names, self.scale),
            },
            coords={name: (name, at, {"units": units[name]}) for name, at in places.items()},
            attrs=told_once,
        )

    def __len__(self) -> int:
        """Return the length of the first axis."""
        return self.shape[0]

    def __repr__(self) -> str:
        done, total = self.done
        axes = ", ".join(f"{name} {at.size}" for name, at in self.axes.items())
        there = "" if done == total else f", {done} of {total} chunks there"
        return f"<PSFStack {'x'.join(map(str, self.shape))} {self.dtype} ({axes}) in {self._store.path.name}{there}>"

    def __getitem__(self, index: ArrayIndex) -> PSF:
        """Return part of the stack in memory, indexed as a NumPy array.

        Raises
        ------
        IndexError
            If there is no such part.
        ValueError
            If a part is not computed yet, has more than 2^31 values, or is of several wavelengths or methods.
        FileError
            If it is damaged.
        """
        which, found = self._members(index)
        said = self._store.said
        ways = np.unique(found["method"])
        with as_file_error(self._store.path, WHAT):
            if ways[-1] >= len(self._methods):
                raise ValueError(f"it names method {ways[-1]} of {len(self._methods)}")
        if ways.size != 1:
            names = " and ".join(type(self._methods[way]).__name__ for way in ways)
            raise ValueError(f"these were computed by {names}; take them apart: stack[...] has one method")
        shared = said["pupils"]
        lights = np.unique(which // math.prod(self.shape[1:-2])) if len(shared) > 1 else np.zeros(1, int)
        if lights.size != 1:
            raise ValueError(
                "the pupils of the first axis differ in more than phase; take one: stack[k], or stack.dask"
            )
        pupils = {name.removeprefix("pupil/"): at for name, at in found.items() if name.startswith("pupil/")}
        center = said["center"] if said["center"] is not None else (pupils.pop("row"), pupils.pop("column"))
        bound = float(found["error_bound"].max())
        with as_file_error(self._store.path, WHAT):
            return PSF(
                values=found["values"],
                grid=self._pixels(center),
                pupil=join_pupils(shared[int(lights[0])], pupils),
                method=self._methods[int(ways[0])],
                normalize=said["normalize"],
                error_bound=None if math.isnan(bound) else bound,
                scale=found["scale"],
                blur=blurs_from_dicts(said["blur"]),
            )

    def _pixels(self, center: Center) -> Grid:
        said = self._store.said
        pixel = said["pixel"] if isinstance(said["pixel"], float) else tuple(said["pixel"])
        kept = {"integrate": said["integrate"], "fill": tuple(said["fill"])}
        return Grid(tuple(said["window"]), pixel, center=center, **kept)

    def _members(self, index: ArrayIndex, only: tuple[str, ...] | None = None) -> tuple[NDArray[np.intp], Arrays]:
        """Return the members of the flattened stack at an index, and their arrays by name."""
        stack = self.shape[:-2]
        which = np.asarray(np.arange(math.prod(stack)).reshape(stack)[index])
        if which.size == 0 or which.size * math.prod(self.shape[-2:]) > validation.MAX_VALUES:
            raise ValueError(f"{which.size} PSFs of {self.shape[-2:]} are none, or more than fit: 2^31 values")
        names = only or (*OF_CHUNK, *self._store.pupils)
        layouts = {name: self._store.layouts[name] for name in names}
        tails = {name: layout.shape[len(stack) :] for name, layout in layouts.items()}
        out = {name: np.empty((which.size, *tails[name]), layouts[name].dtype) for name in names}
        members = self._store.layouts["scale"]
        places = np.unravel_index(which.ravel(), stack)
        cut = tuple(place // size for place, size in zip(places, members.chunks, strict=True))
        chunks = np.ravel_multi_index(cut, members.grid)
        for chunk in np.unique(chunks):
            where = tuple(int(i) for i in np.unravel_index(chunk, members.grid))
            last = self._last  # of the calls before, since neighbours are usually read next
            if last is None or last[0] != where:
                self._last = last = where, self._store.chunk(where)
            # A chunk is a contiguous run of the flattened stack.
            at, first = np.flatnonzero(chunks == chunk), members.first(where)
            for name in names:
                out[name][at] = last[1][name].reshape(-1, *tails[name])[which.flat[at] - first]
        return which, {name: values.reshape(which.shape + tails[name]) for name, values in out.items()}


class _Values:
    """The values of a stack as dask indexes them."""

    def __init__(self, stack: PSFStack) -> None:
        self._stack, self.shape, self.dtype, self.ndim = stack, stack.shape, stack.dtype, stack.ndim

    def __getitem__(self, index: ArrayIndex) -> Values:
        parts = index if isinstance(index, tuple) else (index,)
        lead = self.ndim - 2
        values = self._stack._members(parts[:lead], ("values",))[1]["values"]
        window = parts[lead:]
        return values[(..., *window, *(slice(None),) * (2 - len(window)))]


_LENS, _OBJECTIVE = "Pupil", "ObjectivePupil"


def split_pupils(pupil: BasePupil) -> tuple[Json, dict[str, Array]]:
    """Return what the pupils of a stack share, for JSON, and arrays of what differs, the axes of the stack first."""
    first = pupil[(0,) * len(pupil.shape)] if pupil.shape else pupil
    shared = first.to_dict()
    if isinstance(pupil, ObjectivePupil):
        arrays = {name: np.asarray(getattr(pupil, name)) for name in PLANES}
        for name in PLANES:
            del shared[name]
        measured = pupil.aberrations
        if measured is not None and measured.shape:
            shared["aberrations"] = _terms(measured, arrays)
        return {"kind": _OBJECTIVE} | shared, arrays
    lens, arrays = checked_pupil(pupil), {}
    shared["wavefront"] = _terms(lens.wavefront, arrays)
    if lens.geometry is not None:
        arrays["object_distance"] = lens.geometry.distances.reshape(lens.shape)
        shared["geometry"]["object_distance"] = []
    return {"kind": _LENS} | shared, arrays


def join_pupils(shared: Json, arrays: Mapping[str, Array]) -> BasePupil:
    """Return the stack of :func:`split_pupils`, or part of it, bit by bit; TypeError, ValueError or KeyError."""
    plain = dict(shared)
    if validation.choice("kind", plain.pop("kind"), (_LENS, _OBJECTIVE)) == _OBJECTIVE:
        planes = {name: arrays[name] for name in PLANES}
        if "edge" not in arrays:
            return ObjectivePupil.from_dict(plain | planes)
        bare = ObjectivePupil.from_dict(plain | planes | {"aberrations": None})
        return replace(bare, aberrations=_wavefront(plain["aberrations"], arrays))
    geometry = plain.pop("geometry")
    if geometry is not None:
        geometry = Geometry.from_dict(geometry | {"object_distance": arrays["object_distance"].ravel().tolist()})
    bare_lens = Pupil.from_dict(plain | {"wavefront": {}, "geometry": None})
    return bare_lens.carrying(_wavefront(plain["wavefront"], arrays), geometry)


def _terms(wavefront: Wavefront, arrays: dict[str, Array]) -> Json:
    """Move the coefficients into the arrays, and return their terms and error."""
    arrays["edge"] = wavefront.edge
    if wavefront._powers is not None:
        arrays["powers"] = wavefront._powers
    return {"terms": [list(term) for term in wavefront.terms], "error": wavefront.error}


def _wavefront(said: Json, arrays: Mapping[str, Array]) -> Wavefront:
    terms = tuple(zernike.check_term(n, m) for n, m in said["terms"])
    edge = validation.real_array("edge", arrays["edge"]).copy()
    if edge.ndim == 0 or edge.shape[-1] != len(terms):
        raise ValueError(f"edge must have {len(terms)} coefficients each, got shape {edge.shape}")
    powers = validation.real_array("powers", arrays["powers"]).copy() if "powers" in arrays else None
    return Wavefront.trusted(terms, edge, validation.real("error", said["error"], least=0.0), powers)


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
    plan: Plan, pupils: BasePupil | Sequence[BasePupil], axes: Mapping[str, Places] | None, chunk: int | None
) -> Request:
    """Return a checked request; see :func:`lommel.psf_to`."""
    stacks, listed, grid = _stacks(pupils, plan)
    stack = (len(stacks), *stacks[0].shape) if listed else stacks[0].shape
    if not 1 <= len(stack) <= _MOST_AXES:
        raise ValueError(f"pupils must be a stack of 1 to {_MOST_AXES} axes, got shape {stack}; psf computes one")
    ways = tuple(
        fixed_order(candidates(one, grid, plan.tol), one, grid) if plan.method is None else (plan.method,)
        for one in stacks
    )
    flat = [way for each in ways for way in each]
    methods = [way for k, way in enumerate(flat) if way not in flat[:k]]
    dtype = np.dtype(plan.dtype)
    # Sums of transforms by several threads differ in their last bits, and chunks are the same wherever computed.
    asked: PSFKeywords = {"normalize": plan.normalize, "dtype": dtype, "blur": plan.blur, "threads": 1}
    asked |= {"integrate": grid.integrate, "fill": grid.fill}
    prepare = partial(Plan, grid.shape, grid.pixel, **asked)
    fit = max(1, DEFAULT // (dtype.itemsize * math.prod(grid.shape)))
    most = fit if chunk is None else validation.integer("chunk", chunk, least=1, most=validation.MAX_VALUES)
    shared, arrays = _differences(stacks, listed)
    if grid.stack:
        arrays |= {"row": np.asarray(grid.center[0]), "column": np.asarray(grid.center[1])}
    places, units = _axes(axes, stack, arrays, stacks[0].unit)
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
        "methods": [way.to_dict() for way in methods],
        "normalize": plan.normalize,
        "dtype": dtype.name,
        "chunks": [1, *cut(stack[1:], most)] if listed else cut(stack, most),
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
            stacks, listed = (join_pupils(shared[0], arrays),), False
    if grid.stack:
        if listed:
            raise ValueError("center must be one (row, column) for listed pupils of several wavelengths or apertures")
        stacks = (for_axes(stacks[0], grid.stack),)
        grid = grid.broadcast(stacks[0].shape)
    return stacks, listed, grid


def _differences(stacks: tuple[BasePupil, ...], listed: bool) -> tuple[list[Description], dict[str, Array]]:
    """Return what pupils share, once if it is the same for all, and the arrays that differ."""
    parts = [split_pupils(one) for one in stacks]
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
    given: Mapping[str, Places] | None, stack: tuple[int, ...], arrays: Mapping[str, Array], unit: str
) -> tuple[dict[str, Array], dict[str, str]]:
    """Return the coordinates of each axis of the stack, by name, and their units."""
    if given is None:
        given = _default_axes(stack, arrays)
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


def _default_axes(stack: tuple[int, ...], arrays: Mapping[str, Array]) -> Arrays:
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
    axes: Mapping[str, Places] | None = None,
    chunk: int | None = None,
    progress: Callable[[int, int], object] | None = None,
    client: object = None,
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
    path = path_of(store)
    validation.function("progress", progress, required=False)
    plan, (pool, slots) = Plan(shape, pixel, **options), _pool(client)
    if pool is not None and plan.threads:
        raise ValueError(f"threads must be left out with a client, which has its own, got {plan.threads}")
    there = Store.open(path) if path.exists() else None
    request = requested(plan, pupils, axes, chunk)
    if there is not None and chunk is None:
        same = replace(request, said=request.said | {"chunks": there.said["chunks"]})
        request = request if _difference(there.said, same.said) else same
    opened = _existing_or_new(path, there, request)
    marks = opened.marks()
    todo = [tuple(int(i) for i in index) for index in np.argwhere(~marks)]
    if pool is None:
        slots = min(plan.threads or os.cpu_count() or 1, max(1, len(todo)))
    with _locked(opened) if todo else nullcontext():
        _require_room(opened, len(todo))
        work = partial(_work, opened, request.methods, request.prepare)
        tasks = ((index, request.seal(index), *request.part(index)) for index in todo)
        with closing(_computed(pool, slots, work, tasks)) as found:
            for done, _ in enumerate(found, marks.size - len(todo) + 1):
                if progress is not None:
                    progress(done, marks.size)
    _require_there(opened)
    return PSFStack(opened)


def _existing_or_new(path: Path, there: Store | None, request: Request) -> Store:
    """Return the store of the request, new if there is none, or in place of an empty one of another request."""
    other = "" if there is None else _difference(there.said, request.said)
    if there is not None and not other:
        return there
    said = request.said | {IDENTITY: secrets.token_hex(16)}
    arrays: Arrays = {f"pupil/{name}": at for name, at in request.arrays.items()}
    if not request.grid.stack:
        arrays |= {"y": request.grid.y, "x": request.grid.x}
    with nullcontext() if there is None else _locked(there, alone=True):
        if there is not None and there.marks().any():
            raise _other_request(path, other)
        with suppress(FileExistsError):  # another call may have created it at the same time
            Store.create(path, said, arrays | request.axes, new=there is None)
    made = _opened(path)
    if other := _difference(made.said, request.said):
        raise _other_request(path, other)
    return made


def _other_request(path: Path, other: str) -> ValueError:
    return ValueError(
        f"store must be new, or asked for as it was: {validation.line(path)} holds PSFs of another request ({other})"
    )


@contextmanager
def _locked(store: Store, *, alone: bool = False) -> Iterator[None]:
    """Hold a store, with others to compute into it, or alone to replace it; ValueError if that cannot be."""
    with ExitStack() as held:
        try:
            known = held.enter_context(atomic.locked(store.mark, store.path, alone=alone))
        except FileNotFoundError:
            raise replaced(store.path) from None
        if alone and not known:
            raise atomic.unknown_use(store.path)
        # Without locks, every write still checks that the store was not replaced.
        _require_there(store)
        yield


def _opened(path: Path) -> Store:
    """Return the store that is at the path now; FileError if it is gone."""
    try:
        return Store.open(path)
    except FileNotFoundError:
        raise replaced(path) from None


def _require_there(store: Store) -> None:
    """Raise FileError if the store was replaced since it was opened."""
    if _opened(store.path).said != store.said:
        raise replaced(store.path)


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
    _, made = first_within_tolerance(ways, lambda way: prepare(method=way, center=center)(pupil))
    bound = np.nan if made.error_bound is None else made.error_bound
    parts: Arrays = {
        "values": made.values,
        "error_bound": np.full(pupil.shape, bound),
        "scale": np.asarray(made.scale),
        "method": np.full(pupil.shape, methods.index(made.method), np.uint8),
    }
    store.keep(index, parts, seal)
