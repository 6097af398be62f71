"""Tasks on threads, on an executor of concurrent.futures, or on the workers of a cluster (dask.distributed).

A task reads its data and writes its results where it runs. A cluster repeats tasks whose worker ended, and a worker
may outlive the call: a task must therefore write parts that are complete or absent, with the same bits each time.
"""

from __future__ import annotations

import asyncio
import ctypes
import logging
import os
import pickle
import secrets
import socket
from collections.abc import Callable, Generator, Iterable, Iterator
from concurrent import futures
from contextlib import contextmanager, nullcontext, suppress
from dataclasses import dataclass
from functools import cache, cached_property, lru_cache, partial
from importlib import import_module
from pathlib import Path
from threading import Lock, Thread
from typing import Any, Generic, TypeVar

from lommel.base import validation
from lommel.base.optional import library

_Task = TypeVar("_Task", bound=tuple[Any, ...])
_Result = TypeVar("_Result")
_Value = TypeVar("_Value")

_PATIENCE = 10.0
"""Seconds without a result after which a cluster is asked for its workers, and to connect to a scheduler."""
_ATTEMPTS = 8
"""Number of times that a task is submitted again after a cluster gave it up because its workers ended."""
_REUSED = 1 << 22
"""Size of the largest arrays whose memory a worker of a cluster reuses, bytes."""
_TRIM_THRESHOLD, _MMAP_THRESHOLD = -1, -3  # of malloc.h


class ExecutorError(RuntimeError):
    """Error of an executor that ended or gave up tasks; the same call with a new one continues."""


@dataclass(eq=False)
class _Submitted(Generic[_Task]):
    """A task, the future of its executor, the future of its result here, and how often the executor gave it up."""

    task: _Task
    remote: Any
    future: futures.Future[Any]
    losses: int = 0


@dataclass(frozen=True, eq=False)
class _Call(Generic[_Result]):
    """A call of a function, which dask names by a random number."""

    function: Callable[..., _Result]
    task: tuple[Any, ...]

    def __call__(self, *shared: Any) -> _Result:
        _reuse_freed_blocks()
        # In a thread that is not dask's: it samples the stacks of its own 100 times a second, and keeps those of the
        # last hour, 0.1 MB a second.
        return _begun(partial(self.function, *shared, *self.task)).result()

    def __dask_tokenize__(self) -> str:
        return secrets.token_hex(16)


@dataclass(frozen=True)
class Workers:
    """The workers of a client: `executor` is None for threads of this process; `slots` tasks are queued.

    A task that a worker computes alone may use as many as `threads`.
    """

    executor: futures.Executor | None
    slots: int
    client: Any = None
    threads: int = 1

    @classmethod
    def of(cls, client: Any, threads: int | None = None) -> Workers:
        """Return the workers of a client, or for None `threads` of this process, by default one per processor."""
        if client is None:
            return cls(None, threads or os.cpu_count() or 1)
        if threads:
            raise ValueError(f"threads must be left out with a client, whose workers are used, got {threads}")
        if isinstance(client, futures.Executor):
            return cls(client, 2 * (os.cpu_count() or 1))
        if callable(getattr(client, "get_executor", None)):
            threads_of = client.nthreads().values()
            return cls(client, 2 * max(1, sum(threads_of)), client, min(threads_of, default=1))
        raise TypeError(f"client must be a distributed.Client, an Executor or None, got {validation.shown(client)}")

    @property
    def at_once(self) -> int:
        """Number of tasks that are computed at the same time."""
        return self.slots if self.executor is None else max(1, self.slots // 2)

    def run(
        self,
        function: Callable[..., _Result],
        tasks: Iterable[_Task],
        *,
        ordered: bool = False,
        shared: Shared[Any] | None = None,
    ) -> Generator[tuple[_Task, _Result]]:
        """Call ``function(*task)`` for each task; yield tasks and results as they end, or in the order of the tasks.

        A value that is `shared` is the first argument of all calls; a cluster is sent it once, without a folder.
        At most `slots` + 1 tasks are queued. An error, or closing the generator, cancels them. ExecutorError if the
        executor ends or gives up a task.
        """
        queue: list[_Submitted[_Task]] = []
        pool = futures.ThreadPoolExecutor(self.slots) if self.executor is None else nullcontext(self.executor)
        with pool as executor:
            first = () if shared is None else (self._sent(shared),)
            try:
                source = iter(tasks)
                while True:
                    while len(queue) <= self.slots and (task := next(source, None)) is not None:
                        queue.append(_Submitted(task, *self._submit(executor, function, task, first)))
                    if not queue:
                        return
                    done = self._wait([each.future for each in (queue[:1] if ordered else queue)])
                    for each in [each for each in queue if each.future in done]:
                        try:
                            result = _result(each.future)
                        except Exception as error:
                            if type(error).__name__ != "KilledWorker":  # of distributed
                                raise
                            if (losses := each.losses + 1) > _ATTEMPTS:
                                raise ExecutorError(_KILLED) from None
                            each.remote, each.future = self._submit(executor, function, each.task, first)
                            each.losses = losses
                            continue
                        queue.remove(each)
                        yield each.task, result
                        if self.client is not None:
                            _release_freed_memory()
            finally:
                if self._is_connected():
                    for each in queue:
                        each.remote.cancel()

    def begin(self, function: Callable[..., object], task: _Task, count: int) -> None:
        """Call ``function(*task)`` so many times, without waiting: errors are not told, and results are lost."""
        if self.executor is not None:
            for _ in range(count):
                self._submit(self.executor, function, task, ())

    def _is_connected(self) -> bool:
        """Return False for a client that lost its scheduler, or was closed."""
        return getattr(self.client, "status", "running") == "running"

    def _sent(self, shared: Shared[Any]) -> Any:
        """Return a shared value for tasks: for a cluster the result of a task, which it repeats if it is lost."""
        if self.client is None:
            return shared
        with import_module("dask").config.set({"distributed.admin.large-graph-warning-threshold": "1 PB"}):
            return self.client.submit(_Call(_itself, (shared,)))

    def _submit(
        self, executor: Any, function: Callable[..., _Result], task: _Task, first: tuple[Any, ...]
    ) -> tuple[Any, futures.Future[_Result]]:
        """Return the future of the executor, and that of the result in this process."""
        try:
            # distributed would read and hash all arguments, such as a movie, for the name of a task.
            remote = executor.submit(
                *((_Call(function, task), *first) if self.client is not None else (function, *first, *task))
            )
            if isinstance(remote, futures.Future):
                return remote, remote
            future: futures.Future[_Result] = futures.Future()
            self.client.loop.add_callback(_arrive, remote, future)
            return remote, future
        except futures.BrokenExecutor:
            raise ExecutorError(_ENDED) from None
        except Exception:
            if self._is_connected():
                raise
            raise ExecutorError(_CANCELLED) from None

    def _wait(self, pending: list[futures.Future[_Result]]) -> set[futures.Future[_Result]]:
        """Return the futures that are done, at least one; warn if a cluster has no workers."""
        while True:
            patience = _PATIENCE if hasattr(self.client, "nthreads") else None
            if done := futures.wait(pending, patience, futures.FIRST_COMPLETED).done:
                return done
            try:
                workers = self.client.nthreads()
            except Exception:  # the scheduler does not answer, for which distributed raises many types
                workers = {}
            if not workers:
                validation.tell("no worker is connected to the cluster of the client: waiting for workers", Waiting)


def _begun(function: Callable[[], _Result]) -> futures.Future[_Result]:
    """Begin a call in a thread of its own, which the end of the process does not wait for."""
    future: futures.Future[_Result] = futures.Future()

    def call() -> None:
        try:
            future.set_result(function())
        except BaseException as error:
            future.set_exception(error)

    Thread(target=call, daemon=True).start()
    return future


def _release_freed_memory() -> None:
    """Return freed memory to the system: glibc keeps that of the threads of a client, more with each result."""
    with suppress(AttributeError, OSError, TypeError):  # of other C libraries
        ctypes.CDLL(None).malloc_trim(0)


@cache
def _reuse_freed_blocks() -> None:
    """Let glibc reuse the memory of arrays of up to `_REUSED` bytes.

    With MALLOC_TRIM_THRESHOLD_, which dask sets in workers, it returns each array above 128 KiB to the system: page
    faults took half of the time of a chunk of a stack. Larger arrays are returned all the same: memory stays low.
    """
    with suppress(AttributeError, OSError, TypeError):
        mallopt = ctypes.CDLL(None).mallopt
        mallopt(_MMAP_THRESHOLD, _REUSED)
        mallopt(_TRIM_THRESHOLD, 2 * _REUSED)


def _itself(value: _Value) -> _Value:
    return value


def called(workers: Workers | None, function: Callable[..., _Result], *task: Any) -> _Result:
    """Return ``function(*task)``, which a worker computes, or this process without workers."""
    return function(*task) if workers is None else next(workers.run(function, [task]))[1]


class Waiting(RuntimeWarning):
    """Warning that a cluster has no workers."""


_REPEAT = "repeat the call, which keeps the parts that were computed and computes the others"
_CANCELLED = f"the client cancelled tasks, as when the scheduler of its cluster ends: {_REPEAT}"
_ENDED = f"a process of the executor ended, as when memory is short: {_REPEAT}, with a new executor"
_KILLED = f"the workers that computed a task ended again and again, as when their memory is too small: {_REPEAT}"


async def _arrive(remote: Any, future: futures.Future[Any]) -> None:
    """Pass on the result of a future of dask, whose own executor logs a traceback if it is cancelled by then."""
    try:
        future.set_result(await remote)
    except Exception as error:
        future.set_exception(error)


def _result(future: futures.Future[_Result]) -> _Result:
    """Return the result of a future; ExecutorError if its executor cancelled it or ended."""
    try:
        return future.result()
    except futures.CancelledError:
        raise ExecutorError(_CANCELLED) from None
    except futures.BrokenExecutor:
        raise ExecutorError(_ENDED) from None


def unseen(place: Path) -> str:
    """Return the message for a folder that this process sees, and a worker does not."""
    return (
        f"a worker does not see {validation.line(place)}: choose a folder that all workers reach under this path, "
        "and repeat the call"
    )


class Shared(Generic[_Value]):
    """A value that tasks have in common: pickled once, and unpickled once by each process that uses it.

    The scheduler of a cluster passes it on as it is. With a `folder` that all workers see, it is in a new file there,
    and tasks have its path only: a client of dask keeps the last thousand tasks that it sent.
    """

    def __init__(self, value: _Value, folder: Path | None = None) -> None:
        self.value, self._folder = value, folder

    @cached_property
    def value(self) -> _Value:
        """The value."""
        with _UNPICKLING:
            value: _Value = _unpickled(self._pickled)
            return value

    @cached_property
    def _path(self) -> Path:
        assert self._folder is not None
        path = self._folder / secrets.token_hex(8)
        path.write_bytes(self._dumped())
        return path

    @cached_property
    def _pickled(self) -> bytes:
        return self._dumped()

    def _dumped(self) -> bytes:
        try:
            pickler: Any = import_module("cloudpickle")  # of dask: also for functions of scripts
        except ImportError:
            pickler = pickle
        data: bytes = pickler.dumps(self.value)
        return data

    def __getstate__(self) -> dict[str, bytes | Path | None]:
        return {"_pickled": self._pickled if self._folder is None else self._path, "_folder": None}


_UNPICKLING = Lock()


@lru_cache(maxsize=2)
def _unpickled(data: bytes | Path) -> Any:
    return pickle.loads(data.read_bytes() if isinstance(data, Path) else data)


def _knock(host: str, port: int) -> None:
    """Raise OSError at once if no program listens: distributed would try again, and wait for the name of a host."""

    def connect() -> None:
        try:
            socket.create_connection((host, port), _PATIENCE).close()
        except Exception as error:  # also UnicodeError of a name
            raise OSError(getattr(error, "strerror", None) or str(error)) from None

    _begun(connect).result(_PATIENCE)


@contextmanager
def connected(address: str | None) -> Iterator[Any]:
    """Yield a client of the cluster at an address, such as tcp://scheduler:8786, or None without an address."""
    if address is None:
        yield None
        return
    distributed = library("distributed", "a cluster needs", "")

    try:
        scheme, place = distributed.comm.parse_address(address)
        distributed.comm.registry.get_backend(scheme)
        host, port = distributed.comm.addressing.parse_host_port(place)
    except ValueError:
        host, port = "", 0
    if not host:
        form = "the address of a scheduler with its port, such as tcp://host:8786"
        raise ValueError(f"client must be {form}, got {validation.shown(address)}")

    async def reach() -> None:
        security = distributed.Security().get_connection_args("client")
        comm = distributed.comm.connect(address, timeout=_PATIENCE, **security)
        (await asyncio.wait_for(comm, _PATIENCE)).abort()

    try:
        _knock(host, port)
        asyncio.run(reach())  # a client that fails to connect would take 20 s more to close
    except Exception as error:  # also of programs that answer otherwise, such as MemoryError
        known = isinstance(error, OSError | ValueError)
        reason = str(error) or f"no answer within {_PATIENCE:g} s" if known else "another program does"
        raise ConnectionError(
            f"no scheduler of a dask cluster answers at {validation.shown(address)}: {validation.line(reason)}"
        ) from None
    client = distributed.Client(address, timeout=_PATIENCE)
    try:
        yield client
    finally:
        logger = logging.getLogger("distributed.client")
        level = logger.level
        if client.status != "running":  # it connects again, and logs a traceback if it is closed: the error is ours
            logger.setLevel(logging.CRITICAL)
        client.close()
        logger.setLevel(level)
