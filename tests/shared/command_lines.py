"""Command lines of ``lommel`` in this process, and those of its help."""

from __future__ import annotations

import io
import subprocess
from contextlib import redirect_stderr, redirect_stdout

from lommel.cli import main


def lommel(*words: object) -> subprocess.CompletedProcess[str]:
    """Run a command line, and return its exit code and what it prints."""
    out, errors = io.StringIO(), io.StringIO()
    with redirect_stdout(out), redirect_stderr(errors):
        try:
            main.main([str(word) for word in words])
        except SystemExit as ended:
            code = ended.code
    return subprocess.CompletedProcess(["lommel", *words], code, out.getvalue(), errors.getvalue())


def help_lines() -> list[str]:
    """Return the examples in the help of all commands."""
    texts = [main.EXAMPLES]
    texts += [main.command_of(name).function.__doc__ for name in main.COMMANDS]
    lines = (line.strip() for text in texts for line in (text or "").replace("\\\n", " ").splitlines())
    return [line for line in lines if line.startswith("lommel ")]
