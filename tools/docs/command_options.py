"""Arguments and options of every command as Markdown, from the commands themselves: what `--help` says, as tables."""

from __future__ import annotations

import inspect
from pathlib import Path

import click

from lommel.cli.main import commands, main


def write(folder: Path) -> None:
    """Write `commands.inc`, which the page of the command line includes, into a folder."""
    folder.mkdir(exist_ok=True)
    (folder / "commands.inc").write_text("\n".join(map(section, sorted(commands()))), encoding="utf-8")


def section(name: str) -> str:
    """Return the section of a command: how it is called, what it does, and a table of its options."""
    command = commands()[name]
    parent = click.Context(main, info_name="lommel", **main.context_settings)
    context = click.Context(command, info_name=name, parent=parent, terminal_width=10_000)
    usage = " ".join([f"lommel {name}", *command.collect_usage_pieces(context)])
    rows = [f"| `{_cell(option)}` | {_cell(_escaped(what))} |" for option, what in _records(command, context)]
    head = f"### `lommel {name}`\n\n`{usage}`\n\n{_what(command)}\n\n| option | says |\n|---|---|\n"
    return head + "\n".join(rows) + "\n"


def _what(command: click.Command) -> str:
    """Return what a command says of itself, without its examples."""
    told = inspect.cleandoc(command.help or "").partition("\b")[0]
    return _escaped(told.strip())


def _records(command: click.Command, context: click.Context) -> list[tuple[str, str]]:
    found = (part.get_help_record(context) for part in command.get_params(context) if isinstance(part, click.Option))
    return [record for record in found if record is not None]


def _cell(text: str) -> str:
    return " ".join(text.split()).replace("|", "\\|")


def _escaped(text: str) -> str:
    """Return words of a help as Markdown shows them: with its stars, brackets and backslashes."""
    parts = text.split("`")  # what is code stays
    return "`".join(
        part if k % 2 else "".join(f"\\{c}" if c in "\\*_<>[]$" else c for c in part) for k, part in enumerate(parts)
    )
