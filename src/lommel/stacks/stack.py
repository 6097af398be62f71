"""Stacks of PSFs in a store, read in parts: :func:`open_stack`."""

from __future__ import annotations

import math
import os
from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from lommel.base import validation
from lommel.base.arrays import Array, Json
from lommel.base.checksums import crc32
from lommel.base.optional import library
from lommel.blur.blurs import blurs_from_dicts
from lommel.io.psf_files import NORMALIZE, FileError, told
from lommel.io.registry import Arrays, Values
from lommel.methods.registry import method_from_dict
from lommel.optics.base_pupil import BasePupil, Geometry
from lommel.optics.grid import Grid
from lommel.optics.layers.objective_pupil import PLANES, ObjectivePupil
from lommel.optics.pupil import Pupil, checked
from lommel.optics.wavefront.wavefront import Wavefront
from lommel.psf import PSF
from lommel.special import zernike
from lommel.stacks.store import OF_CHUNK, WHAT, Center, Index, Store, path_of


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
    lens, arrays = checked(pupil), {}
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
