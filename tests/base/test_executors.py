"""Tasks on executors: results in order, few tasks in progress, and executors that end."""

from __future__ import annotations

import logging
import os
import pickle
import platform
import re
import socket
import subprocess
import sys
import threading
import time
from concurrent.futures import BrokenExecutor, Executor, Future, ProcessPoolExecutor, ThreadPoolExecutor
from types import SimpleNamespace

import numpy as np
import pytest

from lommel.base import executors
from lommel.base.executors import ExecutorError, Shared, Workers, connected


def numbers(count):
    return [(k,) for k in range(count)]


def test_results_come_as_they_end_or_in_order():
    gates = [threading.Event() for _ in range(3)]

    def wait(k: int) -> int:
        gates[k].wait(5.0)
        if k:
            gates[k - 1].set()
        return 10 * k

    for ordered, expected in ((False, [2, 1, 0]), (True, [0, 1, 2])):
        gates[2].set()
        with ThreadPoolExecutor(3) as pool:
            results = list(Workers(pool, 3).run(wait, numbers(3), ordered=ordered))
        assert (sorted(results) if not ordered else results) == [((k,), 10 * k) for k in range(3)]
        if not ordered:
            assert {task[0] for task, _ in results} == set(expected)
        for gate in gates:
            gate.clear()


class Immediate(Executor):
    """Executor that computes at once; `fates` are exceptions of the first calls of each task, by its number."""

    def __init__(self, **fates: list[Exception]) -> None:
        self.fates, self.futures = fates, []

    def submit(self, function, *task):
        future = Future()
        self.futures.append(future)
        if task and (fates := self.fates.get(f"task{task[0]}")):
            future.set_exception(fates.pop(0))
        else:
            future.set_result(function(*task))
        return future


class KilledWorker(Exception):  # noqa: N818 (the name in distributed)
    """As distributed raises it for a task whose workers ended four times."""


def test_tasks_whose_workers_ended_are_submitted_again():
    pool = Immediate(task1=[KilledWorker(), KilledWorker()])
    assert [result for _, result in Workers(pool, 2).run(str, numbers(4), ordered=True)] == ["0", "1", "2", "3"]
    assert len(pool.futures) == 6
    endless = Immediate(task1=[KilledWorker() for _ in range(99)])
    with pytest.raises(ExecutorError, match="ended again and again, as when their memory is too small"):
        list(Workers(endless, 2).run(str, numbers(4)))


def test_an_executor_that_ended_is_named():
    with pytest.raises(ExecutorError, match=r"a process of the executor ended.* repeat the call"):
        list(Workers(Immediate(task2=[BrokenExecutor()]), 2).run(str, numbers(4)))


def test_closing_cancels_queued_tasks():
    class Waiting(Executor):
        def __init__(self) -> None:
            self.futures = []

        def submit(self, function, *task):
            self.futures.append(future := Future())
            if not task[0]:
                future.set_result(None)
            return future

    pool = Waiting()
    results = Workers(pool, 3).run(str, numbers(100))
    next(results)
    results.close()
    assert [future.cancelled() for future in pool.futures] == [False, True, True, True]


def test_errors_of_a_task_are_raised():
    with pytest.raises(ZeroDivisionError):
        list(Workers.of(None, 2).run(lambda k: 1 // k, numbers(3)))


class Counted:
    """A value that counts how often it is pickled and unpickled."""

    pickled, unpickled = 0, 0

    def __reduce__(self):
        Counted.pickled += 1
        return _count, ()


def _count():
    Counted.unpickled += 1
    return Counted()


def test_shared_values_are_pickled_and_unpickled_once():
    shared = Shared(Counted())
    copies = [pickle.loads(pickle.dumps(pickle.loads(pickle.dumps(shared)))) for _ in range(3)]
    assert (Counted.pickled, Counted.unpickled) == (1, 0)  # a scheduler passes them on
    assert all(copy.value is copies[0].value for copy in copies)
    assert isinstance(copies[0].value, Counted)
    assert (Counted.pickled, Counted.unpickled) == (1, 1)


def test_tasks_have_the_path_of_a_shared_value_in_a_folder(tmp_path):
    shared = Shared(np.arange(5000), tmp_path)
    tasks = [pickle.dumps(pickle.loads(pickle.dumps(shared))) for _ in range(2)]
    assert all(len(task) < 1000 for task in tasks)
    assert len(list(tmp_path.iterdir())) == 1
    assert "_pickled" not in vars(shared)  # it would be in memory twice
    np.testing.assert_array_equal(pickle.loads(tasks[0]).value, np.arange(5000))


def test_the_arguments_of_a_task_are_not_hashed():
    """As dask does for the name of a task, which would read a movie."""
    tokenize = pytest.importorskip("dask.tokenize").tokenize
    names = []

    class Movie:
        def __reduce__(self):
            raise AssertionError("read")

    class Client(Immediate):
        status = "running"

        def get_executor(self):
            return self

        def nthreads(self):
            return {"worker": 2}

        def submit(self, function, *task):
            names.append(tokenize(function, *task))
            return super().submit(function, *task)

    assert [result for _, result in Workers.of(Client()).run(lambda movie: 3, [(Movie(),)] * 2)] == [3, 3]
    assert len(set(names)) == 2


def test_a_cluster_is_sent_a_shared_value_once():
    pytest.importorskip("dask")

    class Client(Immediate):
        sent = 0

        def get_executor(self):
            return self

        def nthreads(self):
            return {"worker": 1}

        def submit(self, call, *others):
            data = pickle.dumps((call, [each for each in others if not isinstance(each, Future)]))
            Client.sent += len(data)
            return super().submit(call, *[each.result() if isinstance(each, Future) else each for each in others])

    client = Client()
    results = Workers(client, 2, client).run(_at, numbers(50), shared=Shared(np.arange(5000)))
    assert [result for _, result in results] == list(range(50))
    assert 40_000 < Client.sent < 70_000


def _at(shared, k):
    return shared.value[k]


def test_clients_are_checked():
    with pytest.raises(TypeError, match=r"client must be a distributed.Client, an Executor or None, got 'tcp"):
        Workers.of("tcp://host:8786")
    with ThreadPoolExecutor(1) as pool, pytest.raises(ValueError, match="threads must be left out with a client"):
        Workers.of(pool, 2)


def test_tasks_of_a_cluster_are_in_no_thread_that_dask_samples():
    """It keeps the stacks of the threads that it made, which take 0.3 GB after an hour."""
    assert executors._Call(threading.get_ident, ())() != threading.get_ident()
    with pytest.raises(ZeroDivisionError):
        executors._Call(divmod, (1, 0))()


@pytest.mark.parametrize(
    "answer", [None, b"", b"SSH-2.0-OpenSSH_9.6 and sixty-four bytes of whatever follows\r\n" * 2]
)
def test_an_address_without_a_scheduler_is_named(answer, monkeypatch):
    pytest.importorskip("distributed")
    monkeypatch.setattr(executors, "_PATIENCE", 0.1)
    with connected(None) as client:
        assert client is None
    with socket.create_server(("127.0.0.1", 0)) as server:
        address = f"tcp://127.0.0.1:{server.getsockname()[1]}"

        def serve():
            server.accept()[0].close()  # of a try whether anybody listens
            with server.accept()[0] as connection:
                connection.sendall(answer)
                connection.recv(4096)

        if answer is None:
            server.close()  # nobody listens
        elif answer:
            threading.Thread(target=serve, daemon=True).start()
        reason = {None: "Connection refused", b"": "no answer within 0.1 s"}.get(answer, "another program does")
        begun = time.monotonic()
        with pytest.raises(ConnectionError, match=rf"no scheduler .* '{address}': {reason}"), connected(address):
            pass
        assert time.monotonic() - begun < 5.0


@pytest.mark.parametrize("address", ["", "tcp://", "host", "tcp://host", ":8786", "host:port", "http://host:8786"])
def test_an_address_without_host_or_port_is_refused(address):
    pytest.importorskip("distributed")
    message = f"client must be the address of a scheduler with its port, such as tcp://host:8786, got '{address}'"
    with pytest.raises(ValueError, match=re.escape(message)), connected(address):
        pass


def test_the_name_of_a_host_is_not_waited_for(monkeypatch):
    pytest.importorskip("distributed")
    monkeypatch.setattr(executors, "_PATIENCE", 0.05)
    end = threading.Event()
    monkeypatch.setattr(socket, "getaddrinfo", lambda *_, **__: end.wait(20.0) and [])
    begun = time.monotonic()
    with (
        pytest.raises(ConnectionError, match=r"answers at 'tcp://name:8786': no answer"),
        connected("tcp://name:8786"),
    ):
        pass
    assert time.monotonic() - begun < 10.0
    end.set()


@pytest.mark.parametrize("status", ["running", "connecting"])
def test_a_client_without_its_scheduler_ends_without_a_traceback(status, monkeypatch, caplog):
    distributed = pytest.importorskip("distributed")

    class Client:
        def __init__(self, address, timeout):
            self.status = status

        def close(self):
            logging.getLogger("distributed.client").error("Traceback")

    async def connect(address, **_):
        return SimpleNamespace(abort=lambda: None)

    monkeypatch.setattr(distributed, "Client", Client)
    monkeypatch.setattr(executors, "_knock", lambda *_: None)
    monkeypatch.setattr(distributed.comm, "connect", connect)
    for _ in range(2):  # the second time, the level of the log is as before
        with pytest.raises(ExecutorError), connected("tcp://scheduler:8786"):
            raise ExecutorError
    assert caplog.messages == ["Traceback"] * 2 * (status == "running")


def _exit(_):
    import os

    os._exit(1)


def test_a_process_that_was_killed_is_named():
    import multiprocessing

    with (
        ProcessPoolExecutor(1, multiprocessing.get_context("spawn")) as pool,
        pytest.raises(ExecutorError, match="a process of the executor ended"),
    ):
        list(Workers.of(pool).run(_exit, numbers(5)))


def test_results_within_patience_need_no_workers_asked(monkeypatch):
    monkeypatch.setattr(executors, "_PATIENCE", 60.0)

    class Client:
        status = "running"

        def nthreads(self):
            raise AssertionError("asked")

    assert len(list(Workers(Immediate(), 2, Client()).run(str, numbers(3)))) == 3


def test_the_freed_memory_of_each_result_of_a_cluster_is_released(monkeypatch):
    calls, release = [], executors._release_freed_memory
    monkeypatch.setattr(executors, "_release_freed_memory", lambda: calls.append(release()))
    for client, count in ((SimpleNamespace(status="running"), 3), (None, 0)):
        calls.clear()
        assert len(list(Workers(Immediate(), 2, client).run(str, numbers(3)))) == 3
        assert len(calls) == count


_PAGES = """
import resource
from lommel.base.executors import _Call
task = _Call(lambda: [len(bytes(1 << 20)) for _ in range(80)], ())
task()
before = resource.getrusage(resource.RUSAGE_SELF).ru_minflt
task()
print(resource.getrusage(resource.RUSAGE_SELF).ru_minflt - before)
"""


@pytest.mark.skipif(platform.libc_ver()[0] != "glibc", reason="the setting is one of glibc")
def test_tasks_reuse_freed_memory_in_spite_of_the_setting_of_dask():
    setting = os.environ | {"MALLOC_TRIM_THRESHOLD_": "65536"}
    done = subprocess.run([sys.executable, "-c", _PAGES], env=setting, capture_output=True, check=True)
    assert int(done.stdout) < 5000  # page faults: 256 for each of 80 blocks that is returned to the system


def test_tasks_of_a_cluster_are_cancelled_in_silence(caplog):
    """While their results arrive, of which the executor of the client would log tracebacks."""
    distributed = pytest.importorskip("distributed")
    with (
        distributed.LocalCluster(1, threads_per_worker=2, processes=False, dashboard_address=":0") as cluster,
        distributed.Client(cluster) as client,
    ):
        for count in range(30):
            results = Workers.of(client).run(_late, numbers(100))
            for _ in range(1 + count % 7):
                next(results)
            results.close()
        deadline = time.monotonic() + 30.0
        while cluster.scheduler.tasks and time.monotonic() < deadline:
            time.sleep(0.01)
        assert not cluster.scheduler.tasks
    assert [message for message in caplog.messages if "Exception" in message] == []


def _late(k):
    time.sleep(0.002 * (k % 5))
