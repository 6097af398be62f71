"""The command ``lommel`` and the list of its commands, each imported when it is called."""

from __future__ import annotations

import io
import re
import sys
from collections.abc import Sequence
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, NoReturn

from lommel.base.optional import how_to_get, version
from lommel.base.options import near
from lommel.base.validation import shown
from lommel.cli import help_text

if TYPE_CHECKING:
    from lommel.cli.command import Command

COMMANDS = {
    "examples": "lens_commands",
    "info": "lens_commands",
    "psf": "psf_command",
    "live": "lens_commands",
    "compare": "lens_commands",
    "methods": "lens_commands",
    "stack": "psf_command",
    "blur": "photo_commands",
    "restore": "photo_commands",
    "deconvolve": "deconvolve_command",
    "align": "photo_commands",
    "depth": "photo_commands",
    "sfr": "sfr_command",
    "calibrate": "calibrate_command",
    "watch": "video_commands",
    "sharpen": "video_commands",
    "precision": "photo_commands",
    "retrieve": "fit_commands",
    "beads": "fit_commands",
    "fit-field": "fit_commands",
    "collimate": "collimate_command",
    "localize": "localize_command",
    "paper": "lens_commands",
}
"""Module of each command, in the order of the help; a command is the function of that name in the module."""

_TEXT = """\
Point spread functions (PSFs) of defocused and aberrated lenses, telescopes and microscopes.

Lenses and microscopes are described by TOML files; `lommel examples` lists the examples in the package. Lengths \
have units, such as 550nm, 3.45um or 1.5m; with a space they need quotes: "1.5 m". Each command has --help with \
examples."""
_WORD = 3  # letters of a word that is not looked for in summaries
EXAMPLES = """\
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
  lommel localize movie.tif zeiss-63x-astigmatic.toml --read 2 -o found.csv"""


def main(words: Sequence[str] | None = None) -> NoReturn:
    """Run a command line, by default that of this process, and exit."""
    for stream in (sys.stdout, sys.stderr):
        # Characters that a console or a pipe cannot encode are no error.
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors="backslashreplace")
    words = list(sys.argv[1:] if words is None else words)
    if words[:1] in (["--help"], ["-h"]) and len(words) > 1:
        words[:2] = words[1], words[0]
    name = words[0] if words else ""
    if name in ("", "--help", "-h"):
        rows = {
            **_summaries(),
            "--help, -h": "Display this message and exit.",
            "--version": "Display application version.",
        }
        commands = help_text.section("Commands", rows.items())
        print("Usage: lommel COMMAND", help_text.paragraphs(_TEXT), commands, f"Examples:\n{EXAMPLES}", sep="\n\n")
        sys.exit(0 if words else 2)
    if name == "--version":
        print(version())
        sys.exit()
    if name not in (*COMMANDS, "--install-completion"):
        # What a user calls a command may be in its summary: deblur is restore.
        texts = _summaries().items() if len(name) > _WORD else ()
        found = next((other for other, text in texts if name.lower() in text.lower()), None)
        hint = near(name, COMMANDS) if found is None else f"did you mean {found}?"
        print(f"Error: Unknown command {shown(name)}; {hint}", file=sys.stderr)
        sys.exit(2)
    try:
        from lommel.cli import command  # slow, and not needed above
    except ImportError as missing:  # pragma: no cover
        sys.exit(f"The command line needs {how_to_get(missing.name or 'cyclopts', 'cli')}")
    app = command.application()
    # Only the module of this command is imported: importing all takes longer than most commands run.
    for other in [name] if name in COMMANDS else COMMANDS:
        command_of(other).add_to(app, other)
    if name in COMMANDS:
        words[1:] = command_of(name).arranged(words[1:])
    else:
        app.register_install_completion_command()
    sys.exit(command.call(app, words))


def command_of(name: str) -> Command:
    """Return a command."""
    entry: Command = getattr(import_module(f"lommel.cli.{COMMANDS[name]}"), name.replace("-", "_"))
    return entry


def _summaries() -> dict[str, str]:
    """Return the first sentence of the docstring of each command, from the sources, which is quick."""
    folder = Path(__file__).parent
    sources = [(folder / f"{name}.py").read_text(encoding="utf-8") for name in dict.fromkeys(COMMANDS.values())]
    found = re.findall(r'^@command\b.*?^def (\w+)\(.*?^    """(.*?)$', "\n".join(sources), re.MULTILINE | re.DOTALL)
    return {name: dict(found)[name.replace("-", "_")] for name in COMMANDS}
