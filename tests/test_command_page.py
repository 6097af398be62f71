"""The page of the command line names every command and every option, in the words of the commands."""

from __future__ import annotations

import re
from pathlib import Path

import click
import pytest

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


@pytest.mark.parametrize("name", sorted(commands()))
def test_a_section_has_every_option_with_its_words_and_its_default(name):
    text = command_options.section(name)
    rows = [line for line in text.splitlines() if line.startswith("| `-")]
    options = [part for part in commands()[name].params if isinstance(part, click.Option)]
    # And --help.
    assert len(rows) == len(options) + 1
    plain = [re.sub(r"\\(.)", r"\1", row) for row in rows]
    for option in options:
        row = next(row for row in plain if option.opts[-1] in re.split("[` ,]+", row.partition("` |")[0]))
        assert " ".join((option.help or "").split()) in row
        if option.show_default and isinstance(option.default, float):
            assert f"[default: {option.default}" in row
    assert all(len(re.split(r"(?<!\\)\|", row)) == 4 for row in rows)
    assert "Examples" not in text
