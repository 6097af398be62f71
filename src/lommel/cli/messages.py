"""Messages of commands: errors, notes and findings, which name options instead of arguments."""

from __future__ import annotations

import dataclasses
import os
import re
import sys
import warnings
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager, suppress
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

from lommel.base.executors import ExecutorError, Waiting
from lommel.base.units import with_units
from lommel.base.validation import Early, brief, line
from lommel.cli.interrupts import discard
from lommel.lensfiles import example_files
from lommel.report import Facts, Report, Wrapped

if TYPE_CHECKING:
    from rich.console import RenderableType

_running: list[tuple[Mapping[str, str], set[str]]] = [({}, set())]  # flags by arguments, and the arguments given


def print_report(report: Report | None, notes: list[str], *, as_json: bool) -> int:
    """Print a report with the notes of the library, and return its exit code."""
    if report is not None:
        if notes:
            report += Report({"notes": [*report.facts.get("notes", []), *notes]}, note_lines("note", notes))
        report.print(as_json=as_json)
    sys.stdout.flush()  # now, where a failure can still be reported
    return 0 if report is None else report.exit_code


def report_error(error: Exception, notes: list[str]) -> int:
    """Print an error and the notes before it, and return the exit code."""
    if isinstance(error, BrokenPipeError):
        discard(sys.stdout.fileno())  # the reader has closed the pipe; Python's writing at exit would fail
        return 1
    if any(text in str(error) for text in _SHORTAGES):
        error = MemoryError(f"memory, or the number of threads, is short: {brief(line(error), 240)}")
    for row in (*note_lines("Note", notes), f"Error: {_message(error)}"):
        print(row, file=sys.stderr)
    try:
        sys.stdout.flush()
    except OSError:
        discard(sys.stdout.fileno())  # the error occurred in writing
    return 2 if isinstance(error, _USER_ERRORS) else 1


_NOTES = 5  # largest number of notes that are printed


def note_lines(label: str, notes: list[str]) -> list[str]:
    """Return lines with the first notes, and a line with the number of further notes."""
    further = [f"{len(notes) - _NOTES} more, which --json lists"] if len(notes) > _NOTES else []
    return [f"{label}: {note}" for note in [*notes[:_NOTES], *further]]


@contextmanager
def collected_notes(notes: list[str]) -> Iterator[None]:
    """Add the UserWarnings of the library to a list of notes, without duplicates."""
    with warnings.catch_warnings():
        warnings.simplefilter("always", UserWarning)
        old_show = warnings.showwarning

        def show(message: Warning | str, category: type[Warning], *place: Any, **keywords: Any) -> None:
            if issubclass(category, Waiting | Early):  # now, since the wait, or the computation, may be long
                print(f"Note: {with_options(str(message))}", file=sys.stderr)
            elif not issubclass(category, UserWarning):
                old_show(message, category, *place, **keywords)
            elif (note := with_options(str(message))) not in notes:
                notes.append(note)

        warnings.showwarning = show
        yield


_SHORTAGES = ("can't start new thread", "failed to map segment")  # messages if memory or threads are short
_USER_ERRORS = (ValueError, TypeError, ArithmeticError, OSError, ImportError, MemoryError, ExecutorError)


def _message(error: Exception) -> str:
    if isinstance(error, OSError) and error.strerror:
        if not error.filename:
            return error.strerror
        return f"{brief(line(error.filename), 240)}: {error.strerror}{_hint(error)}"
    if getattr(error, "names_keys", False):
        return str(error)
    if isinstance(error, _USER_ERRORS):
        return with_options(str(error) or type(error).__name__)
    return (
        f"this is a bug in lommel, not in your input: {type(error).__name__}: {brief(line(error), 200)}; please "
        "report it with the traceback that LOMMEL_TRACEBACK=1 shows"
    )


def _hint(error: OSError) -> str:
    """Return a hint how to copy a missing file, if it is an example of the package."""
    name = Path(os.fsdecode(error.filename)).name.removesuffix(".toml")
    with suppress(FileNotFoundError):  # if the examples are missing, too
        if isinstance(error, FileNotFoundError) and name in example_files():
            return f"; `lommel examples {name}` copies {example_files()[name].name} to this folder"
    return ""


# Matches a method with its options in brackets, which is kept, or a word that may be the name of an argument:
# "`missing`", "largest=", "tol=1e-9", "f_number"; but not --set tol=1, lens.f_number (of a file) or words in quotes.
_NAMES = re.compile(r"[A-Z]\w*\([^()]*\)|`([a-z_]+)`|(?<!--set )(?<![.'])\b([a-z][a-z_]*)(=)?(?=([\w'\"(\[])?)")
_METHOD = re.compile(r"--method (\w+)\(.*?\)")


@cache
def _methods() -> tuple[dict[str, str], set[str]]:
    """Return the names of methods on the command line by those of their classes, and the names of their options."""
    from lommel.methods import METHODS  # late: only messages need it

    options = {item.name for kind in METHODS.values() for item in dataclasses.fields(kind)}  # type: ignore[arg-type]
    return {kind.__name__: name for name, kind in METHODS.items()}, options


def with_options(message: str) -> str:
    """Return a message of the library with the options of the running command for its arguments and methods."""
    flags, given = _running[-1]
    first = message.partition(" must ")[0]
    # A value that was not on the command line may be from a file, whose key is the name of the argument.
    if first in given and first in flags:
        message = flags[first] + message.removeprefix(first)
    # A flag has no value: "per_plane=True" is --per-plane, and "per_plane must be False" is to leave it out.
    message = re.sub(r"(--[a-z-]+) True\b", r"\1", _NAMES.sub(_flag_in, message))
    message = re.sub(r"(--[a-z-]+) must be False\b", r"\1 must be left out", message)
    message = re.sub(r", in metres, such as (\d+)e-9", r", such as \1nm", message).replace(
        ", in metres", ", with a unit"
    )
    return _METHOD.sub(lambda match: f"--method {_methods()[0].get(match[1], match[1])}", with_units(message))


def given_flags() -> dict[str, str]:
    """Return the options that the command line states, by the names of arguments."""
    flags, given = _running[-1]
    return {name: flags[name] for name in sorted(given) if name in flags}


def flag_of(name: str) -> str:
    """Return the option of the running command for an argument, as messages state it."""
    return _running[-1][0].get(name, name)


def _flag_in(match: re.Match[str]) -> str:
    """Return the option for a match of `_NAMES`, or the matched text if there is no such option."""
    quoted, name, equals, value = match.groups()
    word, flags = quoted or name, _running[-1][0]
    if word in flags and (quoted or equals or "_" in word):
        return flags[word] + (" " if equals and value else "")
    if equals and value and "settings" in flags and word in _methods()[1]:
        return f"--set {match[0]}"
    return match[0]


def verdict_lines(facts: Facts, summary: str) -> list[Wrapped]:
    """Return the status of a fit with the named cause, if any, in bold, and the summary."""
    head = facts["message"].partition("; ")[0]
    second = [] if summary.partition("; ")[0] in head else [Wrapped(summary)]
    return [Wrapped(with_options(head), "bold"), *second, Wrapped("")]


def finding_lines(facts: Facts, *, headed: bool = True) -> list[Wrapped]:
    """Return the findings and notes of a result, one line each, in the order of the message, at most ten lines.

    Without the cause that a line above has, of a report that is `headed` by the message.
    """
    from lommel.fit.findings import place_of, shortened  # late: only fits have findings

    reliable, head = facts["reliable"], facts["message"].partition("; ")[0].partition(": ")[2]
    others = [f for f in facts["findings"] if not headed or f["text"] != head]
    others.sort(key=lambda f: place_of(f["code"], f["severity"], reliable))
    names = {f["code"]: f"{f['code'].replace('_', ' ')}: " for f in others} | {"untested": ""}
    texts = [(f["code"], names[f["code"]] + with_options(f["text"])) for f in others]
    return [Wrapped(line) for line in (*shortened(texts), *facts["notes"])]


def report_findings(facts: Facts, *parts: RenderableType, headed: bool = True) -> Report:
    """Return the report of a fit with findings and notes, which come last and name the options of the command."""
    facts = facts | {"notes": [with_options(note) for note in facts["notes"]]}
    return Report(facts, [*parts, *finding_lines(facts, headed=headed)], facts["converged"])


def run_job(
    job: Callable[[], Report | None], flags: Mapping[str, str], given: Iterable[str], *, as_json: bool
) -> int:
    """Do the job of a command, print its report, and return the exit code.

    `flags` are the options by the names of arguments, and `given` the arguments that the command line states. Errors
    that a user can cause are one line, with exit code 2; errors of the program have exit code 1. A fit that did not
    converge, or a data set without some of its pictures, has exit code 3, and a fit that converged, but is in doubt,
    exit code 4. With the environment variable LOMMEL_TRACEBACK set, Python's traceback is shown instead.
    """
    notes: list[str] = []
    if sys.stdout is None:  # the caller has closed it
        sys.stdout = Path(os.devnull).open("w")  # noqa: SIM115
    _running.append((flags, set(given)))
    try:
        with collected_notes(notes):
            report = job()
        return print_report(report, notes, as_json=as_json)
    except KeyboardInterrupt:
        for row in (*note_lines("Note", notes), "Aborted!"):
            print(row, file=sys.stderr)
        return 1
    except Exception as error:
        if os.environ.get("LOMMEL_TRACEBACK") and not isinstance(error, BrokenPipeError):
            raise
        return report_error(error, notes)
    finally:
        _running.pop()
