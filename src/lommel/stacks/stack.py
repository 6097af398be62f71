"""Stacks of PSFs in a store, a Zarr folder: how chunks are cut, written, marked, checked, and read in parts.

Stores of PSF stacks, Zarr folders: how chunks are cut, written, marked and checked.
A chunk is a file of each array. Writing one changes nothing else, and a process that is killed meanwhile leaves all
others as they were.

Every store has an identity, a random number. Each write compares it, so that nothing is written into another store
that has taken the place of this one, and every checksum includes it, so that chunks of another store are detected.
"""

from __future__ import annotations

import math
import os
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any, Self, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lommel.base import atomic, validation
from lommel.base.arrays import Array, Json
from lommel.base.checksums import checksum, crc32, sealed
from lommel.base.optional import library
from lommel.blur.blurs import blurs_from_dicts
from lommel.io import zarr_folders
from lommel.io.psf_files import NORMALIZE, FileError, told
from lommel.io.registry import Arrays, Description, Values
from lommel.io.zarr_folders import Layout, ZarrArray
from lommel.methods.registry import method_from_dict
from lommel.optics.base_pupil import BasePupil, Geometry
from lommel.optics.grid import Grid
from lommel.optics.layers.objective_pupil import PLANES, ObjectivePupil
from lommel.optics.pupil import Pupil
from lommel.optics.pupil import checked as checked_pupil
from lommel.optics.wavefront.wavefront import Wavefront
from lommel.psf import PSF
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
        with told(path, WHAT):
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
            with told(self.path, WHAT), os.scandir(self.path / name) as entries:
                for entry in entries:
                    key, *numbers = entry.name.split(".")
                    if key == "c" and all(number.isdecimal() for number in numbers):
                        index = tuple(int(number) for number in numbers[: found.ndim])
                        there[index] = name != MARKS or (found[index] and self._mark(index) >= 0)
            found &= there
        return found

    def get(self, name: str, index: Index) -> Values | None:
        """Return a chunk of an array, or None where its file is missing."""
        with told(self.path, WHAT):
            try:
                return self._array(name).get(index)
            except FileNotFoundError:
                return None

    def put(self, parts: Arrays, index: Index) -> None:
        """Write a chunk of some arrays, whole or not at all; FileError if the store was replaced."""
        try:
            with atomic.together(_scratch(self.path, self.said)) as write:
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
        made = {name: self.given(name, index) for name in OF_CHUNK}
        pupils = {name: self.given(name, index) for name in self.pupils}
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

    def given(self, name: str, index: Index) -> Values:
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
        with told(store.path, WHAT):
            self.axes: dict[str, Array] = {name: store.given(name, (0,)) for name in self.units}
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

    def __getitem__(self, index: Any) -> PSF:
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
        with told(self._store.path, WHAT):
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
        with told(self._store.path, WHAT):
            return PSF(
                values=found["values"],
                grid=self._pixels(center),
                pupil=together(shared[int(lights[0])], pupils),
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

    def _members(self, index: Any, only: tuple[str, ...] | None = None) -> tuple[NDArray[np.intp], Arrays]:
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

    def __getitem__(self, index: Any) -> Values:
        parts = index if isinstance(index, tuple) else (index,)
        lead = self.ndim - 2
        values = self._stack._members(parts[:lead], ("values",))[1]["values"]
        window = parts[lead:]
        return values[(..., *window, *(slice(None),) * (2 - len(window)))]


_LENS, _OBJECTIVE = "Pupil", "ObjectivePupil"


def apart(pupil: BasePupil) -> tuple[Json, dict[str, Array]]:
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


def together(shared: Json, arrays: Mapping[str, Array]) -> BasePupil:
    """Return the stack of :func:`apart`, or of parts of its arrays, bit by bit; TypeError, ValueError or KeyError."""
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
