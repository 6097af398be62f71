"""The page of the command line names every command and every option, in the words of the commands."""

from __future__ import annotations

import re
from pathlib import Path

import command_options
from lommel.cli.main import commands

PAGE = (Path(__file__).resolve().parents[1] / "docs" / "command-line.md").read_text(encoding="utf-8")


def test_the_page_lists_every_command_and_includes_the_tables(tmp_path):
    listed = re.findall(r"^\| `lommel ([a-z-]+)", PAGE, flags=re.MULTILINE)
    assert sorted(listed) == sorted(commands())
    assert "```{include} _generated/commands.inc" in PAGE
    command_options.write(tmp_path)
    text = (tmp_path / "commands.inc").read_text(encoding="utf-8")
    assert re.findall(r"^### `lommel ([a-z-]+)`$", text, flags=re.MULTILINE) == sorted(commands())
