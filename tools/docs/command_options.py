"""The help of every command as a page: what `lommel COMMAND --help` prints, under a heading."""

from __future__ import annotations

import io
from contextlib import redirect_stdout, suppress
from pathlib import Path
from unittest.mock import patch

from lommel.cli import main


def write(folder: Path) -> None:
    """Write `commands.inc`, which the page of the command line includes, into a folder."""
    folder.mkdir(exist_ok=True)
    (folder / "commands.inc").write_text("\n".join(map(section, sorted(main.COMMANDS))), encoding="utf-8")


def section(name: str) -> str:
    """Return the section of a command."""
    printed = io.StringIO()
    with redirect_stdout(printed), patch.dict("os.environ", {"COLUMNS": "92"}), suppress(SystemExit):
        main.main([name, "--help"])
    return f"### `lommel {name}`\n\n```text\n{printed.getvalue().strip()}\n```\n"
