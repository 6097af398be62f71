"""The command ``lommel live``: the interactive page of a PSF."""

from __future__ import annotations

import webbrowser
from pathlib import Path

import click

from lommel.base import atomic
from lommel.cli.options import FILE, OUTPUT, argument, command, option
from lommel.lensfiles.lens_files import load_instrument
from lommel.page.server import PageServer, html
from lommel.page.state import state_of


@command()
def live(
    lens: Path | None = argument("lens", type=FILE, required=False),
    port: int | None = option(type=click.IntRange(0, 65535), help="Port of the page; by default any free port."),
    no_browser: bool = option(is_flag=True, help="Print the address without opening a browser."),
    saved: Path | None = option("--save", type=OUTPUT, metavar="FILE",
        help="Write the page to a stand-alone HTML file instead."),
) -> None:  # fmt: skip
    """Open an interactive page of the PSF in the browser.

    The page shows the PSF, its curves and a test image, with sliders for every parameter. It starts with the lens
    file LENS or, if none is given, with a defocused lens. All computation is done in the browser; the page is served
    to this machine only, stops at Ctrl-C, and sends no data.

    Examples
    --------
      lommel live
      lommel live hubble-1990.toml --port 8000 --no-browser
      lommel live hubble-1990.toml --save hubble.html
    """
    state: dict[str, float] = {}
    name = left_out = ""
    if lens is not None:
        instrument = load_instrument(lens)
        state, left_out = state_of(instrument)
        name = instrument.name or lens.name
        if left_out:
            click.echo(f"The page does not show {left_out}.", err=True)
    if saved is not None:
        atomic.write(saved, html(state, name, left_out, alone=True).encode())
        click.echo(f"wrote {saved}")
        return
    with PageServer(state, name, port or 0, left_out) as server:
        click.echo(f"{server.url} shows {name or 'lommel'}; Ctrl-C stops it.")
        if not no_browser:
            webbrowser.open(server.url)
        try:
            server.serve_forever()
        except KeyboardInterrupt:
            click.echo()
