"""The front door of stacks: :func:`psf_to`, which computes what a store lacks."""

from __future__ import annotations

import errno
import os
import secrets
import shutil
from collections.abc import Callable, Generator, Iterator, Mapping, Sequence
from concurrent import futures
from contextlib import ExitStack, closing, contextmanager, nullcontext, suppress
from dataclasses import replace
from pathlib import Path
from typing import Any, Unpack

import numpy as np
from numpy.typing import NDArray

from lommel.base import options as shared
from lommel.base import validation
from lommel.base.options import shares
from lommel.channel_psf import PSFKeywords
from lommel.io.psf_files import FileError
from lommel.methods.method import Method
from lommel.optics.base_pupil import BasePupil
from lommel.stacks.layout import Index
from lommel.stacks.request import Options, Question, Request, requested
from lommel.stacks.stack import PSFStack, kind
from lommel.stacks.store import IDENTITY, Store, replaced

# Of file systems, such as some of networks, that do not know which files are in use.
_NO_LOCKS = {errno.ENOLCK, errno.ENOSYS, errno.ENOTSUP, errno.EOPNOTSUPP, errno.EINVAL, errno.EBADF}


@shares(PSFKeywords, Options)
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
    """Compute the PSFs of a stack that need not fit into memory, chunk by chunk into a store.

    Called again with the same arguments, after an error, Ctrl-C or the end of the process, it computes the chunks
    that are not there yet. The values of a chunk are those of ``lommel.psf(pupils[chunk], ..., threads=1)``, bit
    by bit, wherever and in whatever order it is computed.

    Parameters
    ----------
    store : path
        ``.zarr``, a folder (Zarr version 3), or ``.h5``, ``.hdf5``, a file.
    pupils : Pupil or ObjectivePupil, or sequence of these
        A stack. Listed ones, of one shape, are the first axis, such as one for each wavelength; where more than the
        phase tells them apart no chunk holds two of them, and all have one center.
    shape, pixel
        As of :func:`lommel.psf`.
    axes : mapping of str to array_like or (array_like, str), optional
        Names of the axes of the stack, in order, each with its coordinates and perhaps their unit. By default the
        object distances, or depths and z, of the pupils, where these change along one axis alone, else
        ``axis_0`` and so on. Metres are those of ``object_distance, depth, z, wavelength``, and what begins with
        ``field`` has the unit of the pupils.
    chunk : int, optional
        At most so many PSFs in each chunk; by default as many as 16 MiB hold, or as the store was begun with. Chunks
        are cut by this and by what is asked alone. Other chunks make other values, within the bounds of both.
    progress : callable, optional
        Called as ``progress(done, chunks)`` after each chunk that is computed.
    client : distributed.Client or concurrent.futures.Executor, optional
        What computes the chunks; by default threads of this process. Workers write into a ``.zarr`` themselves, and
        have to see it under the same path; an HDF5 file is written by this process.
    {options}

    Returns
    -------
    PSFStack
        As :func:`lommel.open_stack` reads it.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range, or if there are PSFs in the store that were asked for otherwise.
    FileError
        If there is something else at the path, if the store is damaged, if another call computes another request into
        it, or if it was removed or replaced meanwhile.
    ToleranceError
        If the tolerance cannot be met; what was computed before stays.
    ImportError
        If h5py is not installed, for a store in HDF5.
    OSError
        If the store cannot be written, or does not fit on the disk.

    Examples
    --------
    >>> import lommel as lm
    >>> import numpy as np
    >>> lens = lm.Lens(focal_length=50e-3, f_number=1.8, focus_distance=2.0, wavelength=550e-9)
    >>> stack = lm.psf_to("depths.zarr", lens.pupil(np.linspace(1.0, 3.0, 5000)), 33, 3e-6)  # doctest: +SKIP
    """
    shared.require_known(psf_to, options, PSFKeywords)
    given = Options(**options)
    place, path = kind(validation.path("store", store)), Path(os.path.realpath(store))
    if progress is not None and not callable(progress):
        raise TypeError(f"progress must be callable, got {validation.shown(progress)}")
    threads = None if given.threads is None else validation.integer("threads", given.threads, least=1, most=1024)
    pool, slots = _pool(client)
    if pool is not None and threads is not None:
        raise ValueError(f"threads must be left out with a client, which has its own, got {threads}")
    there = place.open(path) if path.exists() else None
    request = requested(pupils, shape, pixel, axes, chunk, given)
    if there is not None and chunk is None:
        same = replace(request, said=request.said | {"chunks": there.said["chunks"]})
        request = request if _difference(there.said, same.said) else same
    opened = _begun(place, path, there, request)
    marks = opened.marks()
    todo = [tuple(int(i) for i in index) for index in np.argwhere(~marks)]
    if pool is None:
        slots = min(threads or os.cpu_count() or 1, max(1, len(todo)))
    with _held(opened) if todo else nullcontext():
        _require_room(opened, len(todo))
        by_caller = client is not None and opened.one_file
        tasks = ((index, request.seal(index), request.question, *request.part(index)) for index in todo)
        found = _computed(pool, slots, None if by_caller else opened, tasks, request.methods)
        with closing(found):
            for done, (index, seal, made) in enumerate(found, marks.size - len(todo) + 1):
                if made is not None:
                    opened.keep(index, made, seal)
                if progress is not None:
                    progress(done, marks.size)
    _require_there(opened)
    return PSFStack(opened)


def _begun(place: type[Store], path: Path, there: Store | None, request: Request) -> Store:
    """Return the store, begun anew where there is none, or one with nothing in it that was asked for otherwise."""
    other = "" if there is None else _difference(there.said, request.said)
    if there is not None and not other:
        return there
    said = request.said | {IDENTITY: secrets.token_hex(16)}
    arrays: dict[str, NDArray[Any]] = {f"pupil/{name}": at for name, at in request.arrays.items()}
    if not request.grid.stack:
        arrays |= {"y": request.grid.y, "x": request.grid.x}
    with nullcontext() if there is None else _held(there, other):
        if there is not None and there.marks().any():
            raise ValueError(
                f"store must be new, or asked for as it was: {validation.line(path)} holds PSFs of another "
                f"request ({other})"
            )
        with suppress(FileExistsError):  # of another call at the same time, for the same perhaps
            place.create(path, said, arrays | request.axes, new=there is None)
    made = _opened(place, path)
    if other := _difference(made.said, request.said):
        raise _busy(path, other)
    return made


@contextmanager
def _held(store: Store, other: str = "") -> Iterator[None]:
    """Hold a store to compute into it, or alone, to begin it anew, since `other` is asked: FileError if in use."""
    with ExitStack() as held:
        try:
            held.enter_context(store.held(alone=bool(other)))
        except FileNotFoundError:
            raise replaced(store.path) from None
        except BlockingIOError:
            raise _busy(store.path, other or "it is being begun anew") from None
        except OSError as error:
            if error.errno not in _NO_LOCKS:
                raise
            if other:
                raise FileError(
                    f"{validation.line(store.path)} was begun for another request ({other}), and its file system "
                    "does not tell whether somebody computes it; remove it if nobody does, or name another store"
                ) from None
            # Else whoever would replace it has to know, and every write looks whether somebody did.
        _require_there(store)
        yield


def _busy(path: Path, other: str) -> FileError:
    return FileError(
        f"{validation.line(path)} is in use by another call of psf_to, of another request ({other}); "
        "wait until that has ended, or name another store"
    )


def _opened(place: type[Store], path: Path) -> Store:
    """Return the store that is there now; FileError if there is none any more."""
    try:
        return place.open(path)
    except FileNotFoundError:
        raise replaced(path) from None


def _require_there(store: Store) -> None:
    """Raise FileError where there is another store by now than the one that was opened."""
    if _opened(type(store), store.path).said != store.said:
        raise replaced(store.path)


def _difference(there: Mapping[str, Any], asked: Mapping[str, Any]) -> str:
    """Return the first thing that two descriptions say otherwise, chunks last, in words; "" if there is none."""
    for name in sorted(asked, key=lambda name: (name == "chunks", name not in ("software", "stack", "window"))):
        if there.get(name) != asked[name]:
            if name in ("arrays", "pupils", "coordinates"):
                return "the coordinates are others" if name == "coordinates" else "the pupils are others"
            return f"{name}: {validation.shown(there.get(name))} there, {validation.shown(asked[name])} asked for"
    return ""


def _require_room(store: Store, chunks: int) -> None:
    """Raise OSError where the disk has no room for so many chunks."""
    values = store.layouts["values"]
    needed = chunks * values.nbytes // max(1, int(np.prod(values.grid)))
    free = shutil.disk_usage(store.path.parent).free
    if needed > free:
        raise OSError(
            28, f"the store needs {needed / 1e9:.3g} GB more, and {free / 1e9:.3g} GB are free", str(store.path)
        )


def _pool(client: Any) -> tuple[futures.Executor | None, int]:
    """Return what computes, and how many chunks are to be under way with it."""
    if client is None:
        return None, 0
    if isinstance(client, futures.Executor):
        return client, 2 * (os.cpu_count() or 1)
    if callable(getattr(client, "get_executor", None)):
        return client.get_executor(), 2 * max(1, sum(client.nthreads().values()))
    raise TypeError(f"client must be a distributed.Client, an Executor or None, got {validation.shown(client)}")


_Task = tuple[Index, int, Question, BasePupil, Any, tuple[Method, ...]]
_Made = tuple[Index, int, dict[str, NDArray[Any]] | None]


def _computed(
    pool: futures.Executor | None, slots: int, store: Store | None, tasks: Iterator[_Task], methods: list[Method]
) -> Generator[_Made]:
    """Yield chunks as they are done, a few under way at any time; after an error none is begun."""
    own = futures.ThreadPoolExecutor(slots) if pool is None else None
    under_way: set[futures.Future[_Made]] = set()
    try:
        for task in tasks:
            if len(under_way) > slots:
                done, under_way = futures.wait(under_way, return_when=futures.FIRST_COMPLETED)
                yield from (one.result() for one in done)
            under_way.add((own or pool).submit(_work, store, methods, *task))  # type: ignore[union-attr]
        yield from (one.result() for one in futures.as_completed(under_way))
    finally:
        for one in under_way:
            one.cancel()
        if own is not None:
            own.shutdown(cancel_futures=True)


def _work(
    store: Store | None,
    methods: list[Method],
    index: Index,
    seal: int,
    question: Question,
    pupil: BasePupil,
    center: Any,
    ways: tuple[Method, ...],
) -> _Made:
    """Compute a chunk, and keep it where a store is given."""
    made = question.answer(pupil, center, ways)
    bound = np.nan if made.error_bound is None else made.error_bound
    parts: dict[str, NDArray[Any]] = {
        "values": made.values,
        "error_bound": np.full(pupil.shape, bound),
        "scale": np.asarray(made.scale),
        "method": np.full(pupil.shape, methods.index(made.method), np.uint8),
    }
    if store is None:
        return index, seal, parts
    store.keep(index, parts, seal)
    return index, seal, None
