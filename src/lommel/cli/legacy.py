"""The command ``lommel`` and the list of its commands, each imported when it is called."""

from __future__ import annotations

import io
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from importlib import import_module
from typing import TYPE_CHECKING

from lommel.base.optional import how_to_get
from lommel.base.validation import brief

try:
    import click
    import rich as _rich  # noqa: F401 (the tables need it)
except ImportError as missing:  # pragma: no cover
    sys.exit(f"The command line needs {how_to_get(missing.name or 'click', 'cli')}")


if TYPE_CHECKING:
    pass

from lommel.cli.main import COMMANDS, GENERATED


class _Commands(click.Group):
    """Group of all commands, which shortens long error messages."""

    def make_context(self, *args: object, **options: object) -> click.Context:
        for stream in (sys.stdout, sys.stderr):
            # Characters that a console or a pipe cannot encode are no error.
            if isinstance(stream, io.TextIOWrapper):
                stream.reconfigure(errors="backslashreplace")
        with _short_errors():
            return super().make_context(*args, **options)  # type: ignore[arg-type]

    def invoke(self, ctx: click.Context) -> object:
        with _short_errors():
            return super().invoke(ctx)

    def list_commands(self, ctx: click.Context) -> list[str]:
        """Return the names of all commands."""
        return [name for name in COMMANDS if name not in GENERATED]

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        """Return the command with a name, or None."""
        if cmd_name not in COMMANDS or cmd_name in GENERATED:
            return None
        # Only the module of this command is imported: importing all takes longer than most commands run.
        entry: click.Command = getattr(import_module(f"lommel.cli.{COMMANDS[cmd_name]}"), cmd_name.replace("-", "_"))
        return entry


@contextmanager
def _short_errors() -> Iterator[None]:
    """Shorten the parts of a command line that Click repeats in its errors."""
    try:
        yield
    except click.ClickException as error:
        if not isinstance(error, click.exceptions.NoArgsIsHelpError):  # its message is the help
            vars(error).update(message=brief(error.message, 240))
        raise


@click.group(cls=_Commands, context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 100})
@click.version_option(package_name="lommel")
def old_main() -> None:
    """Point spread functions (PSFs) of defocused and aberrated lenses, telescopes and microscopes.

    Lenses and microscopes are described by TOML files; `lommel examples` lists the examples in the package.
    Lengths have units, such as 550nm, 3.45um or 1.5m; with a space they need quotes: "1.5 m". Each command has --help
    with examples.

    \b
    Examples:
      lommel examples phone                  # copy an example lens file
      lommel info    phone.toml              # Strehl ratio, blur, MTF
      lommel psf     phone.toml -o psf.tif -o psf.png    # data and a picture
      lommel psf     zeiss-63x-1.4-oil.toml -o stack.ome.tif    # of a microscope
      lommel live    phone.toml              # interactive PSF in the browser
      lommel compare phone.toml --figure compare.png     # accuracy and speed
      lommel stack   phone.toml --between 1m 3m --count 500 -o depths.zarr
      lommel blur    photo.jpg depth.tif phone.toml --focus 2m -o out.jpg
      lommel restore photo.tif depth.tif phone.toml --white 5000 --read 3 -o s.tif
      lommel deconvolve stack.ome.tif zeiss-63x-1.4-oil.toml -o restored.ome.tif
      lommel retrieve star-*.tif phone.toml --defocus -4 0 4 --read 2
      lommel localize movie.tif zeiss-63x-astigmatic.toml --read 2 -o found.csv
    """  # noqa: D301 (Click keeps the line breaks of a paragraph that begins with \b)


def commands() -> dict[str, click.Command]:
    """Return all commands by their names."""
    context = click.Context(old_main)
    return {
        name: command for name in old_main.list_commands(context) if (command := old_main.get_command(context, name))
    }
