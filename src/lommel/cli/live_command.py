"""The command for the live page: ``lommel live``."""

from __future__ import annotations

import webbrowser
from pathlib import Path

import click

from lommel.cli.parts import FILE, one_line_errors


@click.command()
@click.argument("lens", type=FILE, required=False)
@click.option("--port", type=click.IntRange(0, 65535), default=0, help="By default any that is free.")
@click.option("--no-browser", is_flag=True, help="Print the address and open nothing.")
@click.option("--save", "saved", type=FILE, metavar="FILE",
              help="Write the page to a file that opens on its own, and end.")  # fmt: skip
@one_line_errors
def live(lens: Path | None, port: int, no_browser: bool, saved: Path | None) -> None:
    """Open the live page: sliders, and the PSF, its curves and a picture that follow them.

    Starts with what a lens file describes, or in defocus. The page is served to this machine alone, until Ctrl-C; it
    computes in the browser and sends nothing.

    \b
    Examples:
      lommel live
      lommel live hubble.toml --port 8000 --no-browser
      lommel live hubble.toml --save hubble.html
    """  # noqa: D301 (\b is meant)
    from lommel.base import atomic
    from lommel.lensfiles.lens_files import load_instrument
    from lommel.page import module
    from lommel.page.server import PageServer
    from lommel.page.state import state_of

    state: dict[str, float] = {}
    title = "lommel"
    if lens is not None:
        instrument = load_instrument(lens)
        state, left_out = state_of(instrument)
        title = instrument.name or lens.name
        if left_out:
            click.echo(f"The page leaves out {left_out}.", err=True)
    if saved is not None:
        atomic.write(saved, module.html(state, title, alone=True).encode())
        return
    with PageServer(state, title, port) as server:
        click.echo(f"{server.url} shows {title}; Ctrl-C ends.")
        if not no_browser:
            webbrowser.open(server.url)
        try:
            server.serve_forever()
        except KeyboardInterrupt:
            click.echo()
