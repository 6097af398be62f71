"""Stacks of PSFs larger than memory: computed chunk by chunk into a store (a Zarr folder), and read in parts.

A chunk is a block of the stack, and has one file in each computed array. Writing a chunk changes no other file, so
that a killed process leaves the other chunks intact.

Every store has an identity, a random number. Each chunk is first written to a scratch folder named after it: if
another store has replaced this one, that folder is missing and the write fails. Every checksum includes the identity,
so that a chunk copied from another store is detected. "Pupils" are the pupils of the stack, one for each PSF.
"""

from __future__ import annotations

import math
import os
import secrets
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import closing, contextmanager, suppress
from dataclasses import dataclass, field, replace
from functools import partial
from pathlib import Path
from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lommel.base import atomic, executors, validation
from lommel.base.arrays import Array, Json, Values
from lommel.base.arrays import Index as ArrayIndex
from lommel.base.atomic import checksum, crc32, plain, sealed
from lommel.base.cached import cached_property
from lommel.base.executors import Workers
from lommel.base.optional import version
from lommel.blur.blurs import blurs_from_dicts
from lommel.io import zarr_folders
from lommel.io.psf_files import FileError, as_file_error
from lommel.io.registry import Arrays, Description
from lommel.io.zarr_folders import Layout, ZarrArray
from lommel.methods.choice import candidates, first_within_tolerance, fixed_order
from lommel.methods.method import Method
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
KIND = "a stack of PSFs"

FORMAT = 2
DEFAULT_CHUNK_BYTES = 2**24
"""Default size of the values of a chunk in bytes."""
CHECKSUMS = "chunks/checksum"
"""Name of the array with the checksum of each chunk, -1 for a chunk that is not computed yet."""
COMPUTED_ARRAYS = ("values", "error_bound", "scale", "method")
"""Names of the arrays that are computed chunk by chunk."""

Index = tuple[int, ...]


def chunk_shape(shape: tuple[int, ...], max_psfs: int) -> tuple[int, ...]:
    """Return the shape of equal chunks of a stack: at most `max_psfs` PSFs, contiguous in the flattened stack."""
    # A chunk spans whole axes, beginning with the last axis, while the chunk has at most `max_psfs` PSFs.
    chunk = [1] * len(shape)
    for axis in reversed(range(len(shape))):
        parts = -(-shape[axis] // min(max_psfs, shape[axis]))
        chunk[axis] = -(-shape[axis] // parts)
        if parts > 1:
            break
        max_psfs //= shape[axis]
        if max_psfs < 2:
            break
    return tuple(chunk)


def layouts(description: Description) -> dict[str, Layout]:
    """Return the layout of each array of a store."""
    stack, window, chunks = (tuple(description[name]) for name in ("stack", "window", "chunks"))
    names = tuple(description["axes"])
    result = {
        "values": Layout(stack + window, chunks + window, np.dtype(description["dtype"]).str, (*names, "y", "x")),
        "error_bound": Layout(stack, chunks, "<f8", names),
        "scale": Layout(stack, chunks, "<f8", names),
        "method": Layout(stack, chunks, "|u1", names),
    }
    for name, (sizes, _) in description["arrays"].items():
        terms = tuple(sizes)
        result[f"pupil/{name}"] = Layout(stack + terms, chunks + terms, "<f8", (*names, "term")[: len(stack + terms)])
    chunk_grid = result["scale"].grid
    result[CHECKSUMS] = Layout(chunk_grid, (1,) * len(chunk_grid), "<i8", tuple(f"{name}_chunk" for name in names))
    lengths = dict(zip(names, stack, strict=True)) | {"y": window[0], "x": window[1]}
    return result | {name: Layout((n,), (n,), "<f8", (name,)) for name, n in lengths.items()}


@dataclass(frozen=True)
class Store:
    """An existing store, with its path, description and array layouts: a Zarr 3 group of plain arrays.

    A chunk is first written to a scratch folder whose name is the identity of the store, and then moved into place.
    If another store has replaced this one, the scratch folder is missing and the write fails. Several processes can
    use one store.
    """

    path: Path
    description: Description = field(repr=False)
    layouts: dict[str, Layout] = field(repr=False)

    @classmethod
    def create(cls, path: Path, description: Description, arrays: Arrays) -> None:
        """Write a store without chunks; FileExistsError if the path exists."""
        units = {"y": description["unit"], "x": description["unit"]} | description["axes"]

        def fill(folder: Path) -> None:
            zarr_folders.write_group(folder, {KEY: sealed(description, {})})
            for name, layout in layouts(description).items():
                attributes = {"units": units[name]} if name in units else {}
                array = ZarrArray(folder / name, layout)
                array.create(fill=fill_value(name, layout), attributes=attributes, values=arrays.get(name))
            ZarrArray(_scratch(folder, description), Layout((), (), "|u1")).create()

        atomic.write_folder(path, fill, exclusive=True)

    @classmethod
    def open(cls, path: Path) -> Self:
        """Open the store at a path; FileNotFoundError if there is no folder, FileError if it is no valid store."""
        if not path.is_dir():
            raise FileNotFoundError(2, os.strerror(2), str(path))
        with as_file_error(path, KIND):
            description = zarr_folders.attributes(path)[KEY]
            if description.pop("checksum") != checksum(description, {}):
                raise ValueError("its description was changed after it was written")
            if description["format"] != FORMAT:
                raise ValueError(
                    f"it has format {description['format']}, and this version of lommel reads format {FORMAT}"
                )
            return cls(path, description, layouts(description))

    def _array(self, name: str) -> ZarrArray:
        return ZarrArray(self.path / name, self.layouts[name])

    def computed(self) -> NDArray[np.bool_]:
        """Return an array with True for each chunk that has a checksum and a file in each of COMPUTED_ARRAYS."""
        arrays, grid = [self._array(name) for name in (*COMPUTED_ARRAYS, CHECKSUMS)], self.layouts[CHECKSUMS].grid
        complete = (all(array.file(index).exists() for array in arrays) for index in np.ndindex(grid))
        return np.fromiter(complete, bool, math.prod(grid)).reshape(grid)

    def read(self, name: str, index: Index) -> Values:
        """Return a chunk of an array; FileError if its file is missing or damaged."""
        with as_file_error(self.path, KIND):
            return self._array(name).get(index)

    def put(self, parts: Arrays, index: Index) -> None:
        """Write one chunk of several arrays, all or none of them; FileError if the store was removed or replaced."""
        try:
            with atomic.whole_files(_scratch(self.path, self.description)) as write:
                for name, part in parts.items():
                    array = self._array(name)
                    write(array.file(index), array.packed(part))
        except (FileNotFoundError, NotADirectoryError):
            raise replaced_error(self.path) from None

    def write_chunk(self, index: Index, arrays: Arrays, pupil_checksum: int) -> None:
        """Write a computed chunk, then its checksum, which includes the checksum of the requested pupils."""
        self.put(arrays, index)
        self.put({CHECKSUMS: np.full((1,) * len(index), self._crc32(index, arrays, pupil_checksum))}, index)

    def read_chunk(self, index: Index) -> Arrays:
        """Return the arrays of a chunk and its pupils; ValueError if it is not computed yet, FileError if damaged."""
        file = self._array(CHECKSUMS).file(index)
        if not file.exists():
            raise ValueError(
                f"chunk {index} of {validation.line(self.path)} is not computed yet; "
                "call psf_to again with the same arguments to compute the missing chunks"
            )
        arrays = {name: self.read(name, index) for name in COMPUTED_ARRAYS}
        pupils = {name: self.read(name, index) for name in self.pupils}
        if self._crc32(index, arrays, crc32({}, pupils)) != int(self.read(CHECKSUMS, index).flat[0]):
            raise FileError(
                f"chunk {index} of {validation.line(self.path)} is damaged (wrong checksum); to compute it again, "
                f"remove {CHECKSUMS}/{file.name} in this folder and call psf_to again"
            )
        return arrays | pupils

    @property
    def pupils(self) -> list[str]:
        """Names of the arrays of pupil parameters that vary over the stack."""
        return [name for name in self.layouts if name.startswith("pupil/")]

    def _crc32(self, index: Index, arrays: Arrays, pupil_checksum: int) -> int:
        """Compute the checksum of the arrays and index of a chunk, the store's identity and the pupils' checksum."""
        return crc32(
            {"chunk": [int(i) for i in index], "store": self.description[IDENTITY], "pupils": pupil_checksum}, arrays
        )


def replaced_error(path: Path) -> FileError:
    """Return the error for a store that was removed or replaced."""
    return FileError(
        f"{validation.line(path)} was removed, or replaced by another call of psf_to, while its PSFs were computed; "
        "call psf_to again, with a path that no other call writes to"
    )


def fill_value(name: str, layout: Layout) -> float:
    """Return the fill value of an array: -1 for checksums, NaN for floating-point numbers, else 0."""
    return -1 if name == CHECKSUMS else np.nan if layout.dtype[1] == "f" else 0


def _scratch(folder: Path, description: Description) -> Path:
    """Return the scratch folder of new chunks, which readers of the Zarr group see as an empty array."""
    return folder / "chunks" / str(description[IDENTITY])


def path_of(store: str | os.PathLike[str]) -> Path:
    """Return the path of a store with links resolved; ValueError if `store` does not end in .zarr."""
    path = validation.path("store", store)
    if path.suffix.lower() != ".zarr":
        raise ValueError(f"store must end in .zarr, got {validation.shown(str(path))}")
    return Path(os.path.realpath(path))


def open_stack(store: str | os.PathLike[str]) -> PSFStack:
    """Open a store that :func:`lommel.psf_to` wrote, or is still writing.

    Parameters
    ----------
    store : path
        Zarr folder, ending in ``.zarr``.

    Returns
    -------
    PSFStack

    Raises
    ------
    ValueError
        If `store` does not end in ``.zarr``.
    FileError
        If the store is damaged, or was not written by :func:`lommel.psf_to`.
    OSError
        If the store cannot be read.
    """
    return PSFStack(Store.open(path_of(store)))


class PSFStack:
    """A stack of PSFs in a store, read by index: ``stack[index]`` is a :class:`lommel.PSF`.

    The checksum of a chunk is verified whenever the chunk is read.

    Parameters
    ----------
    store : Store
        From :func:`lommel.open_stack`.

    Attributes
    ----------
    shape : tuple of int
        Shape of the values: the shape of the stack, then height and width of a PSF.
    dtype : dtype
        Type of the values.
    axes : dict of str to ndarray
        Coordinates along each axis of the stack, by the name of the axis.

    Raises
    ------
    FileError
        If the coordinates are damaged.
    """

    def __init__(self, store: Store) -> None:
        self._store, layout = store, store.layouts["values"]
        self.shape: tuple[int, ...] = layout.shape
        self.dtype = np.dtype(layout.dtype)
        self.axes: dict[str, Array] = {name: store.read(name, (0,)) for name in store.description["axes"]}
        if crc32({}, dict(self.axes)) != store.description["coordinates"]:
            raise FileError(f"the coordinates of {validation.line(store.path)} are damaged")
        self._last_chunk: tuple[Index, Arrays] | None = None

    @property
    def done(self) -> tuple[int, int]:
        """Number of computed chunks, and number of all chunks."""
        computed = self._store.computed()
        return int(computed.sum()), computed.size

    @property
    def error_bound(self) -> Array:
        """Error bound of each PSF / its peak, the maximum over its chunk; NaN if unknown or not computed yet."""
        layout = self._store.layouts["error_bound"]
        bounds = np.full(layout.shape, np.nan)
        for index in np.argwhere(self._store.computed()):
            bounds[layout.within(tuple(index))] = self._store.read("error_bound", tuple(index))
        return bounds

    def __len__(self) -> int:
        """Return the length of the first axis."""
        return self.shape[0]

    def __repr__(self) -> str:
        done, total = self.done
        axes = ", ".join(f"{name} {values.size}" for name, values in self.axes.items())
        note = "" if done == total else f", {done} of {total} chunks computed"
        return f"<PSFStack {'x'.join(map(str, self.shape))} {self.dtype} ({axes}) in {self._store.path.name}{note}>"

    def __getitem__(self, index: ArrayIndex) -> PSF:
        """Return the PSFs at a NumPy index into the axes of the stack, as one :class:`lommel.PSF` in memory.

        Raises
        ------
        IndexError
            If the index is out of range.
        ValueError
            If the part is not computed yet, has no PSF or more than 2^31 values, or if its PSFs were computed by
            different methods or for pupils that differ in more than the phase, such as the wavelength.
        FileError
            If a chunk is damaged.
        """
        members, arrays = self._members(index)
        description = self._store.description
        methods = [method_from_dict(description["methods"][k]) for k in np.unique(arrays["method"])]
        if len(methods) != 1:
            names = " and ".join(type(method).__name__ for method in methods)
            raise ValueError(f"these PSFs were computed by {names}; choose an index whose PSFs have one method")
        descriptions = description["pupils"]
        first_index = np.unique(members // math.prod(self.shape[1:-2])) if len(descriptions) > 1 else np.zeros(1, int)
        if first_index.size != 1:
            raise ValueError("the pupils of the first axis differ in more than phase; choose one by stack[k]")
        pupils = {name.removeprefix("pupil/"): array for name, array in arrays.items() if name.startswith("pupil/")}
        pixel = description["pixel"] if isinstance(description["pixel"], float) else tuple(description["pixel"])
        window, fill = tuple(description["window"]), tuple(description["fill"])
        bound = float(arrays["error_bound"].max())
        return PSF(
            values=arrays["values"],
            grid=Grid(window, pixel, center=description["center"], integrate=description["integrate"], fill=fill),
            pupil=join_pupils(descriptions[int(first_index[0])], pupils),
            method=methods[0],
            normalize=description["normalize"],
            error_bound=None if math.isnan(bound) else bound,
            scale=arrays["scale"],
            blur=blurs_from_dicts(description["blur"]),
        )

    def _members(self, index: ArrayIndex) -> tuple[NDArray[np.intp], Arrays]:
        """Return the positions of the PSFs stack[index] in the flattened stack, and their arrays by name."""
        stack = self.shape[:-2]
        members = np.asarray(np.arange(math.prod(stack)).reshape(stack)[index])
        if members.size == 0 or members.size * math.prod(self.shape[-2:]) > validation.MAX_VALUES:
            raise ValueError(
                f"the index must select at least one PSF and at most 2^31 values, "
                f"got {members.size} PSFs of shape {self.shape[-2:]}"
            )
        layouts = {name: self._store.layouts[name] for name in (*COMPUTED_ARRAYS, *self._store.pupils)}
        shapes = {name: layout.shape[len(stack) :] for name, layout in layouts.items()}
        arrays = {name: np.empty((members.size, *shapes[name]), layout.dtype) for name, layout in layouts.items()}
        layout = layouts["scale"]
        positions = np.unravel_index(members.ravel(), stack)
        chunk_indices = tuple(position // size for position, size in zip(positions, layout.chunks, strict=True))
        chunks = np.ravel_multi_index(chunk_indices, layout.grid)
        for chunk in np.unique(chunks):
            chunk_index = tuple(int(i) for i in np.unravel_index(chunk, layout.grid))
            # The last chunk stays in memory, since consecutive calls often read neighbouring PSFs.
            loaded = self._last_chunk
            if loaded is None or loaded[0] != chunk_index:
                self._last_chunk = loaded = chunk_index, self._store.read_chunk(chunk_index)
            # A chunk is a contiguous run of the flattened stack.
            selected, start = np.flatnonzero(chunks == chunk), layout.first(chunk_index)
            for name, values in arrays.items():
                values[selected] = loaded[1][name].reshape(-1, *shapes[name])[members.flat[selected] - start]
        return members, {name: values.reshape(members.shape + shapes[name]) for name, values in arrays.items()}


_LENS, _OBJECTIVE = "Pupil", "ObjectivePupil"


def split_pupils(pupil: BasePupil) -> tuple[Json, dict[str, Array]]:
    """Return the parameters that all pupils of a stack share (plain JSON), and arrays of the varying parameters."""
    first_pupil = pupil[(0,) * len(pupil.shape)] if pupil.shape else pupil
    shared = first_pupil.to_dict()
    if isinstance(pupil, ObjectivePupil):
        arrays = {name: np.asarray(getattr(pupil, name)) for name in PLANES}
        for name in PLANES:
            del shared[name]
        aberrations = pupil.aberrations
        if aberrations is not None and aberrations.shape:
            shared["aberrations"] = _split_wavefront(aberrations, arrays)
        return {"kind": _OBJECTIVE} | shared, arrays
    lens, arrays = checked_pupil(pupil), {}
    shared["wavefront"] = _split_wavefront(lens.wavefront, arrays)
    if lens.geometry is not None:
        arrays["object_distance"] = lens.geometry.distances.reshape(lens.shape)
        shared["geometry"]["object_distance"] = []
    return {"kind": _LENS} | shared, arrays


def join_pupils(shared: Json, arrays: Mapping[str, Array]) -> BasePupil:
    """Rebuild the pupils, bit for bit, from the results of :func:`split_pupils`; the arrays may be sliced."""
    parameters = dict(shared)
    if parameters.pop("kind") == _OBJECTIVE:
        planes = {name: arrays[name] for name in PLANES}
        if "edge" not in arrays:
            return ObjectivePupil.from_dict(parameters | planes)
        without_aberrations = ObjectivePupil.from_dict(parameters | planes | {"aberrations": None})
        return replace(without_aberrations, aberrations=_join_wavefront(parameters["aberrations"], arrays))
    geometry = parameters.pop("geometry")
    if geometry is not None:
        geometry = Geometry.from_dict(geometry | {"object_distance": arrays["object_distance"].ravel().tolist()})
    without_wavefront = Pupil.from_dict(parameters | {"wavefront": {}, "geometry": None})
    return without_wavefront.carrying(_join_wavefront(parameters["wavefront"], arrays), geometry)


def _split_wavefront(wavefront: Wavefront, arrays: dict[str, Array]) -> Json:
    """Add the coefficients of a wavefront to `arrays`; return its terms and its error bound."""
    arrays["edge"] = wavefront.edge
    if wavefront._powers is not None:
        arrays["powers"] = wavefront._powers
    return {"terms": [list(term) for term in wavefront.terms], "error": wavefront.error}


def _join_wavefront(description: Json, arrays: Mapping[str, Array]) -> Wavefront:
    """Return the wavefront from the result of :func:`_split_wavefront` and the arrays that it added."""
    terms = tuple(zernike.check_term(n, m) for n, m in description["terms"])
    # Copies, since arrays of a wavefront are frozen.
    powers = np.array(arrays["powers"]) if "powers" in arrays else None
    return Wavefront.trusted(terms, np.array(arrays["edge"]), description["error"], powers)


_AXES_IN_METRES = ("object_distance", "depth", "z", "wavelength")
_RESERVED_NAMES = ("y", "x", "values", "error_bound", "scale", "method", "pupil", "chunks", "term")
_MAX_AXES = 8


@dataclass(frozen=True, eq=False)
class Request:
    """Checked arguments of :func:`psf_to`: the pupils, their methods, and the description of the store.

    Attributes
    ----------
    pupils : tuple of Pupil or ObjectivePupil
        One stack; if `listed`, one stack for each index of the first axis.
    listed : bool
        True if the pupils of the first axis differ in more than the phase.
    prepare : partial of Plan
        Plan without method, which each chunk adds; it is sent to the workers.
    method_order : tuple
        For each of `pupils`, the methods in the order in which they are tried; the order is the same for all chunks.
    grid : Grid
    axes : dict of str to ndarray
        Coordinates along each axis of the stack.
    methods : list
        All methods of `method_order` without repetition.
    description : dict
        Description of the store, in plain types.
    arrays : dict of str to ndarray
        Arrays of the pupil parameters that vary over the stack.
    """

    pupils: tuple[BasePupil, ...]
    listed: bool
    prepare: partial[Plan]
    method_order: tuple[tuple[Method, ...], ...]
    grid: Grid
    axes: dict[str, Array]
    methods: list[Method]
    description: Description
    arrays: dict[str, Array] = field(repr=False)

    def part(self, index: Index) -> tuple[BasePupil, tuple[Method, ...]]:
        """Return the pupils of a chunk, and the methods to try."""
        layout = self.layouts["scale"]
        part_slices = layout.within(index)
        if not self.listed:
            return self.pupils[0][part_slices], self.method_order[0]
        k = part_slices[0].start
        pupil = self.pupils[k][part_slices[1:]] if self.pupils[k].shape else self.pupils[k]
        return pupil.broadcast(layout.part(index)), self.method_order[k]

    def pupil_checksum(self, index: Index) -> int:
        """Return the checksum of the pupil arrays of a chunk, as a store computes it."""
        arrays = {f"pupil/{name}": values for name, values in self.arrays.items()}
        parts = {name: np.asarray(values[self.layouts[name].within(index)], "<f8") for name, values in arrays.items()}
        return crc32({}, parts)

    @cached_property
    def layouts(self) -> dict[str, Layout]:
        """Layouts of the arrays of the requested store."""
        return layouts(self.description)


def requested(
    plan: Plan, pupils: BasePupil | Sequence[BasePupil], axes: Mapping[str, ArrayLike] | None, chunk: int | None
) -> Request:
    """Check the arguments of :func:`lommel.psf_to`; return them as a Request."""
    stacks, listed, grid = _check_stacks(pupils, plan)
    stack = (len(stacks), *stacks[0].shape) if listed else stacks[0].shape
    if not 1 <= len(stack) <= _MAX_AXES:
        raise ValueError(
            f"pupils must be a stack of 1 to {_MAX_AXES} axes, got shape {stack}; use lommel.psf for a single pupil"
        )
    method_order = tuple(
        fixed_order(candidates(pupil, grid, plan.tol), pupil, grid) if plan.method is None else (plan.method,)
        for pupil in stacks
    )
    all_methods = [method for order in method_order for method in order]
    methods = [method for k, method in enumerate(all_methods) if method not in all_methods[:k]]
    dtype = np.dtype(plan.dtype)
    # One thread for each chunk: sums by several threads may differ in their last bits from one computer to another.
    keywords: dict[str, Any] = {"normalize": plan.normalize, "dtype": dtype, "blur": plan.blur, "threads": 1}
    keywords |= {"integrate": grid.integrate, "fill": grid.fill, "center": grid.axis}
    prepare = partial(Plan, grid.shape, grid.pixel, **keywords)
    max_psfs = max(1, DEFAULT_CHUNK_BYTES // (dtype.itemsize * math.prod(grid.shape)))
    if chunk is not None:
        max_psfs = validation.integer("chunk", chunk, least=1, most=validation.MAX_VALUES)
    shared_parameters, arrays = _split_stacks(stacks, listed)
    coordinates, units = _check_axes(axes, stack, arrays, stacks[0].unit)
    description = {
        "software": f"lommel {version()}",
        "format": FORMAT,
        "stack": list(stack),
        "axes": units,
        "coordinates": crc32({}, dict(coordinates)),
        "window": list(grid.shape),
        "pixel": grid.pixel,
        "unit": stacks[0].unit,
        "integrate": grid.integrate,
        "fill": list(grid.fill),
        "blur": [part.to_dict() for part in plan.blur],
        "center": list(grid.axis),
        "methods": [method.to_dict() for method in methods],
        "normalize": plan.normalize,
        "dtype": dtype.name,
        "chunks": [1, *chunk_shape(stack[1:], max_psfs)] if listed else chunk_shape(stack, max_psfs),
        "pupils": shared_parameters,
        "arrays": {
            name: [list(array.shape[len(stack) :]), crc32({}, {name: array})] for name, array in arrays.items()
        },
    }
    return Request(stacks, listed, prepare, method_order, grid, coordinates, methods, plain(description), arrays)


def _check_stacks(pupils: BasePupil | Sequence[BasePupil], plan: Plan) -> tuple[tuple[BasePupil, ...], bool, Grid]:
    """Return the pupils as one or several stacks, True if several (one for each first index), and the grid."""
    listed = isinstance(pupils, Sequence)
    stacks: tuple[BasePupil, ...] = tuple(
        imaged(pupil) for pupil in (pupils if isinstance(pupils, Sequence) else [pupils])
    )
    if not stacks:
        raise ValueError("pupils must not be an empty list")
    grid = plan.grid(stacks[0])
    if grid.stack:
        raise ValueError("center must be one (row, column) in a store, got arrays")
    for k, pupil in enumerate(stacks[1:], 1):
        for name, value, expected in (("shape", pupil.shape, stacks[0].shape), ("unit", pupil.unit, stacks[0].unit)):
            if value != expected:
                raise ValueError(
                    f"pupils must all have the {name} of the first, {expected}, got {value} for pupils[{k}]"
                )
    if listed:
        shared_parameters, arrays = _split_stacks(stacks, listed)
        if len(shared_parameters) == 1:  # only their phases differ
            stacks, listed = (join_pupils(shared_parameters[0], arrays),), False
    return stacks, listed, grid


def _split_stacks(stacks: tuple[BasePupil, ...], listed: bool) -> tuple[list[Description], dict[str, Array]]:
    """Return the shared parameters of each stack of pupils (once if equal), and arrays of the other parameters."""
    parts = [split_pupils(pupil) for pupil in stacks]
    shared = [description for description, _ in parts]
    if not listed:
        return shared, parts[0][1]
    first_arrays = parts[0][1]
    for k, (_, other) in enumerate(parts):
        if {name: v.shape for name, v in other.items()} != {name: v.shape for name, v in first_arrays.items()}:
            raise ValueError(
                f"pupils must all have the same wavefront terms, got other terms for pupils[{k}] than for the first"
            )
    arrays = {name: np.stack([other[name] for _, other in parts]) for name in first_arrays}
    return (shared[:1] if all(description == shared[0] for description in shared) else shared), arrays


def _check_axes(
    axes: Mapping[str, ArrayLike] | None, stack: tuple[int, ...], arrays: Mapping[str, Array], unit: str
) -> tuple[dict[str, Array], dict[str, str]]:
    """Return the coordinates along each axis of the stack, by the name of the axis, and their units."""
    if axes is None:
        axes = _default_axes(stack, arrays)
    if not isinstance(axes, Mapping) or not all(isinstance(name, str) and name.isidentifier() for name in axes):
        raise TypeError(f"axes must map names to coordinates, got {validation.shown(axes)}")
    if len(axes) != len(stack):
        raise ValueError(f"axes must name the {len(stack)} axes of a stack of shape {stack}, got {list(axes)}")
    coordinates, units = {}, {}
    for (name, value), count in zip(axes.items(), stack, strict=True):
        if name in _RESERVED_NAMES or name.endswith("_chunk"):
            raise ValueError(f"axes must not be called {', '.join(_RESERVED_NAMES)} or ..._chunk, got {name}")
        axis_unit = "m" if name in _AXES_IN_METRES else unit if name.startswith("field") else "1"
        # Infinite coordinates are allowed, since an object may be at infinity.
        numbers = np.array(validation.number_array(f"axes[{name!r}]", value, axis_unit), dtype=np.float64)
        if numbers.shape != (count,) or np.isnan(numbers).any():
            raise ValueError(f"axes[{name!r}] must be {count} numbers, got {validation.shown(value)}")
        coordinates[name], units[name] = numbers, axis_unit
    return coordinates, units


def _default_axes(stack: tuple[int, ...], arrays: Mapping[str, Array]) -> Arrays:
    """Return for each axis the object distance, depth or z if it varies along this axis only, else indices."""
    names: dict[int, tuple[str, Array]] = {}
    for name in ("object_distance", "depth", "z"):
        if name in arrays:
            for axis, count in enumerate(stack):
                rows = np.moveaxis(arrays[name], axis, 0).reshape(count, -1)
                if axis not in names and count > 1 and np.all(rows == rows[:, :1]):
                    names[axis] = name, rows[:, 0]
                    break
    indices = {axis: (f"axis_{axis}", np.arange(count)) for axis, count in enumerate(stack)}
    return dict((indices | names)[axis] for axis in range(len(stack)))


def psf_to(
    store: str | os.PathLike[str],
    pupils: BasePupil | Sequence[BasePupil],
    shape: int | tuple[int, int],
    pixel: float | tuple[float, float],
    *,
    axes: Mapping[str, ArrayLike] | None = None,
    chunk: int | None = None,
    progress: Callable[[int, int], object] | None = None,
    client: object = None,
    **options: Any,
) -> PSFStack:
    """Compute a stack of PSFs that may exceed memory, chunk by chunk, into a Zarr store.

    If the computation ends early (error, Ctrl-C, killed process), a further call with the same arguments computes the
    missing chunks. The values of a chunk equal ``lommel.psf(pupils[chunk], ..., threads=1).values`` bit for bit,
    independent of the order of computation.

    Parameters
    ----------
    store : path
        Zarr folder (version 3) to create or complete, ending in ``.zarr``.
    pupils : Pupil or ObjectivePupil, or sequence of these
        A stack of pupils. A sequence of stacks of equal shape forms the first axis, for example one stack for each
        wavelength. If the stacks differ in more than the phase, each chunk belongs to one of them, and `center` must
        be a single position.
    shape, pixel
        As for :func:`lommel.psf`.
    axes : mapping of str to array_like, optional
        Coordinates by the name of the axis, in the order of the axes of the stack. By default an axis is
        ``object_distance``, ``depth`` or ``z`` if this parameter of the pupils varies along that axis only, else
        ``axis_0`` and so on. Units: metres for ``object_distance``, ``depth``, ``z`` and
        ``wavelength``, the unit of the pupils for names that begin with ``field``, else 1.
    chunk : int, optional
        Maximum number of PSFs in a chunk. By default an existing store keeps its chunks, and a new store has as many
        PSFs in a chunk as fit in 16 MiB. Another `chunk` may change the values within their error bounds.
    progress : callable, optional
        Called as ``progress(done, chunks)`` after each computed chunk.
    client : distributed.Client or concurrent.futures.Executor, optional
        Executor that computes the chunks; by default threads of this process. Its workers must reach the store under
        the same path.
    **options
        ``method``, ``tol``, ``normalize``, ``dtype``, ``center``, ``integrate``, ``fill`` and ``blur`` as for
        :func:`lommel.psf`; ``threads``, the number of chunks computed in parallel, by default the number of
        processors; not allowed with a `client`.

    Returns
    -------
    PSFStack
        The complete store, opened by :func:`lommel.open_stack`.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range, or if the store holds PSFs for other arguments.
    FileError
        If the path holds something other than a store, or if the store is damaged, or removed while it is computed.
    ToleranceError
        If the tolerance cannot be met; chunks that were already computed remain in the store.
    OSError
        If the store cannot be written.
    RuntimeError
        If the client cancels chunks, as when the scheduler of its cluster ends. The same call, with a new client,
        completes the store.

    Warns
    -----
    RuntimeWarning
        If no worker is connected to the cluster for ten seconds; the call waits for workers.

    Examples
    --------
    >>> import lommel as lm
    >>> import numpy as np
    >>> lens = lm.Lens(focal_length=50e-3, f_number=1.8, focus_distance=2.0, wavelength=550e-9)
    >>> stack = lm.psf_to("depths.zarr", lens.pupil(np.linspace(1.0, 3.0, 5000)), 33, 3e-6)  # doctest: +SKIP
    """
    path = path_of(store)
    validation.function("progress", progress, required=False)
    plan = Plan(shape, pixel, **options)
    workers = Workers.of(client, plan.threads)
    request = requested(plan, pupils, axes, chunk)
    if not path.exists():
        arrays: Arrays = {f"pupil/{name}": values for name, values in request.arrays.items()}
        arrays |= request.axes | {"y": request.grid.y, "x": request.grid.x}
        with suppress(FileExistsError):  # another call may have created the store at the same time
            Store.create(path, request.description | {IDENTITY: secrets.token_hex(16)}, arrays)
    target = Store.open(path)
    if chunk is None:  # an existing store keeps its chunks
        request = replace(request, description=request.description | {"chunks": target.description["chunks"]})
    if difference := _difference(target.description, request.description):
        raise ValueError(
            f"{validation.line(path)} holds PSFs computed with other arguments ({difference}); "
            "repeat those arguments, choose a new store or remove this one"
        )
    computed = target.computed()
    todo = [tuple(int(i) for i in index) for index in np.argwhere(~computed)]
    compute = partial(_compute_chunk, target, request.methods, request.prepare)
    tasks = ((index, request.pupil_checksum(index), *request.part(index)) for index in todo)
    with closing(workers.run(compute, tasks)) as results, _seen(target, client):
        for done, _ in enumerate(results, computed.size - len(todo) + 1):
            if progress is not None:
                progress(done, computed.size)
    return PSFStack(target)


@contextmanager
def _seen(store: Store, client: object) -> Iterator[None]:
    """Raise the error of a replaced store as that of a worker that does not see it, where this process does."""
    try:
        yield
    except FileError:
        if client is not None and _scratch(store.path, store.description).is_dir():
            raise FileError(executors.unseen(store.path)) from None
        raise


def _difference(stored: Description, requested: Description) -> str:
    """Return the first difference of two descriptions in words, with `chunks` compared last; "" if they are equal."""
    for name in sorted(requested, key=lambda name: (name == "chunks", name not in ("software", "stack", "window"))):
        if stored.get(name) != requested[name]:
            if name in ("arrays", "pupils", "coordinates"):
                return "the coordinates differ" if name == "coordinates" else "the pupils differ"
            return (
                f"{name}: {validation.shown(stored.get(name))} in the store, now {validation.shown(requested[name])}"
            )
    return ""


def _compute_chunk(
    store: Store,
    methods: list[Method],
    prepare: partial[Plan],
    index: Index,
    pupil_checksum: int,
    pupil: BasePupil,
    method_order: tuple[Method, ...],
) -> None:
    """Compute a chunk by the first method that meets the tolerance, and write it to the store."""
    _, psf = first_within_tolerance(method_order, lambda method: prepare(method=method)(pupil))
    bound = np.nan if psf.error_bound is None else psf.error_bound
    parts: Arrays = {
        "values": psf.values,
        "error_bound": np.full(pupil.shape, bound),
        "scale": np.asarray(psf.scale),
        "method": np.full(pupil.shape, methods.index(psf.method), np.uint8),
    }
    store.write_chunk(index, parts, pupil_checksum)
