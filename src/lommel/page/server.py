"""The live page for browsers: its module `lommel-live.js`, pages of HTML, their local server, a notebook's widget."""

from __future__ import annotations

import json
from collections.abc import Mapping
from functools import cache
from html import escape
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from importlib import metadata
from os import PathLike
from pathlib import Path
from typing import Any

from lommel.base import validation
from lommel.base.arrays import Json
from lommel.base.optional import library
from lommel.lensfiles.instrument import Instrument
from lommel.lensfiles.lens_files import load_instrument
from lommel.page.state import FIELDS, Terms, Whole, Word, complete, link, psf_of, state_of
from lommel.psf import PSF

NAME = "lommel-live.js"
_PAGE = """<!doctype html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<link rel="icon" href="data:,">
<title>{title}</title>
<style>body {{ margin: 0; }}</style>
<body>
<main><script type="module" {source}data-lommel="{state}" data-lommel-heading="1"{more}>{text}</script></main>
</body>
</html>
"""


def path() -> Path:
    """Return the path of the module; FileNotFoundError if it was not built by `make page`."""
    found = Path(__file__).with_name(NAME)
    if not found.is_file():
        raise FileNotFoundError(
            f"the live page's module is not there ({found}): wheels bring it, and in a copy of the sources "
            "`make page` makes it"
        )
    return found


def documentation() -> str:
    """Return the address of the documentation that the installed package names, or an empty string."""
    try:
        addresses = metadata.metadata("lommel").get_all("Project-URL") or []
    except metadata.PackageNotFoundError:
        return ""
    named = (address.partition(", ") for address in addresses)
    return next((url for name, _, url in named if name.lower() == "documentation" and url.startswith("https://")), "")


def html(state: Mapping[str, object], lens: str = "", left_out: str = "", *, alone: bool = False) -> str:
    """Return the HTML of a page that starts in a state, that of the lens of this name, less what is left out of it.

    `alone` it has the module inside, else beside it.
    """
    # Within a script only its end has a meaning; in strings of the module it may be written so too.
    text = path().read_text(encoding="utf-8").replace("</script", "<\\/script") if alone else ""
    source = "" if alone else f"src={json.dumps(NAME)} "
    said = {"name": lens, "without": left_out, "docs": documentation()}
    more = "".join(f' data-lommel-{key}="{escape(value)}"' for key, value in said.items() if value)
    title = escape(lens or "lommel")
    return _PAGE.format(title=title, source=source, state=escape(link(state)), more=more, text=text)


# What a page may do: run its own module with the core in it, in its own workers, and draw. Nothing is sent.
_POLICY = (
    "default-src 'none'; script-src 'self' 'wasm-unsafe-eval' blob:; worker-src blob:; style-src 'unsafe-inline'; "
    "img-src data: blob:; base-uri 'none'; form-action 'none'; frame-ancestors 'none'"
)
_ALWAYS = (("Cache-Control", "no-store"), ("Content-Security-Policy", _POLICY), ("X-Content-Type-Options", "nosniff"))


class PageServer(ThreadingHTTPServer):
    """Serves the page that starts in a state; port 0 is any that is free."""

    daemon_threads = True
    request_queue_size = 128  # connections that wait: a browser opens several, and others may come with it

    def __init__(self, state: Mapping[str, object], lens: str, port: int = 0, left_out: str = "") -> None:
        page = html(state, lens, left_out).encode()
        self.served = {
            "/": (page, "text/html"),
            "/index.html": (page, "text/html"),
            f"/{NAME}": (path().read_bytes(), "text/javascript"),
        }
        super().__init__(("127.0.0.1", port), _Handler)

    @property
    def url(self) -> str:
        """Address of the page."""
        return f"http://127.0.0.1:{self.server_port}/"


class _Handler(BaseHTTPRequestHandler):
    server: PageServer
    server_version, sys_version = "lommel", ""
    default_request_version = "HTTP/1.0"  # of what cannot be read: answers have headers then too
    timeout = 10.0  # for clients that connect and send nothing

    def do_GET(self) -> None:
        # A page of elsewhere whose name is pointed here by its DNS is still called by that name.
        port = self.server.server_port
        # A second name could be the one that others on the way go by.
        named = self.headers.get_all("Host", [])
        if len(named) != 1 or named[0] not in {f"127.0.0.1:{port}", f"localhost:{port}"}:
            return self.send_error(403)
        found = self.server.served.get(self.path.partition("?")[0])
        if found is None:
            return self.send_error(404)
        content, kind = found
        self.send_response(200)
        self.send_header("Content-Type", f"{kind}; charset=utf-8")
        self.send_header("Content-Length", str(len(content)))
        self.end_headers()
        if self.command == "GET":
            self.wfile.write(content)
        return None

    do_HEAD = do_GET  # noqa: N815 (as http.server calls it)

    def end_headers(self) -> None:
        """Send the headers of every answer, also of errors."""
        for name, value in _ALWAYS:
            self.send_header(name, value)
        super().end_headers()

    def log_message(self, *_: object) -> None:
        """Write nothing."""


def live(lens: Instrument | str | PathLike[str] | None = None, **state: Any) -> Any:
    """Return the live page as a notebook widget, for Jupyter, VS Code, marimo and other hosts of anywidget.

    Every control is a synchronised trait of the widget: ``w.coma = 0.5`` moves the slider, and ``w.observe(...,
    "coma")`` is notified when it is dragged. ``w.state`` is a dict of all controls, and can be set to a dict of some;
    ``w.psf()`` returns the :class:`lommel.PSF` that the page shows, without noise, computed in Python, with further
    arguments as of :func:`lommel.psf`.

    Parameters
    ----------
    lens : Instrument, str or path, optional
        Initial lens: a lens file, or the result of :func:`lommel.load_instrument`.
    **state
        Initial values of controls.

        - Wavefront, waves at the edge of the pupil: `defocus` and `spherical` (W020 and W040), `coma`, `astigmatism`,
          `trefoil` with `coma_angle` and so on (degrees); `zernike`, further terms "n,m:waves;..." in waves rms.
        - `focus`: "waves", or "distances", where `focal_length` (mm), `f_number`, `focus_distance` and
          `object_distance` (m) give the defocus, as :meth:`lommel.Lens.pupil` does.
        - Lens and light: `f_number`, `obscuration`, `vanes` (0 to 8), `vane_width` (over the radius), `vane_angle`
          (degrees), `wavelength` (nm), `light` ("mono", "white").
        - Sensor: `pixel` (um), `view` ("fine", "sampled", "averaged"), `side` (pixels), `noise` ("off", "on"),
          `photons`, `read_noise` (electrons).
        - Display: `rays` ("off", "on"), `stretch`, `map`, `waves_unit`, `length_unit`, `picture`.

        Also `controls`, a list of those to show, and `theme`, "light" or "dark", by default that of the notebook.

    Returns
    -------
    anywidget.AnyWidget

    Raises
    ------
    ImportError
        If anywidget is not installed; the extra "live" of this package installs it.
    FileNotFoundError
        If the page's module was not built.
    TypeError, ValueError
        If a control is unknown or its value invalid, or the lens is out of their range.

    Examples
    --------
    >>> w = lm.live("examples/lenses/hubble-1990.toml")  # doctest: +SKIP
    >>> w.psf().values.shape  # doctest: +SKIP
    (512, 512)
    """
    kind = _kind()
    look = {name: state.pop(name) for name in ("controls", "theme") if name in state}
    start: Json = {}
    if lens is not None:
        if not isinstance(lens, Instrument):
            if not isinstance(lens, (str, PathLike)):
                raise TypeError(
                    f"lens must be an Instrument or the path of a lens file, got {validation.shown(lens)}"
                )
            lens = load_instrument(lens)
        start, _ = state_of(lens)
    return kind(**complete(start | state), **look)


@cache
def _kind() -> type:
    """Return the class of the widget, which is that of an optional library."""
    anywidget: Any = library("anywidget", "lm.live() needs", "live")
    traitlets: Any = library("traitlets", "lm.live() needs", "live")

    class Text(traitlets.Unicode):  # type: ignore[misc]
        """A text of Zernike terms."""

        def validate(self, owner: object, value: object) -> str:
            try:
                return str(FIELDS[self.name].accepted(self.name, value))
            except (TypeError, ValueError) as error:
                raise traitlets.TraitError(str(error)) from None

    def trait(field: Any) -> Any:
        if isinstance(field, Word):
            return traitlets.Enum(field.choices, default_value=field.initial).tag(sync=True)
        if isinstance(field, Terms):
            return Text(field.initial).tag(sync=True)
        kind = traitlets.CInt if isinstance(field, Whole) else traitlets.CFloat
        return kind(field.initial, min=field.low, max=field.high).tag(sync=True)

    class Live(anywidget.AnyWidget):  # type: ignore[misc]
        """The live page; see :func:`lommel.live`."""

        _esm = path()
        controls = traitlets.List(traitlets.Unicode()).tag(sync=True)
        theme = traitlets.Enum(("light", "dark"), default_value=None, allow_none=True).tag(sync=True)

        @property
        def state(self) -> Json:
            """What the controls say."""
            return {name: getattr(self, name) for name in FIELDS}

        @state.setter
        def state(self, change: Json) -> None:
            whole = complete(self.state | change)
            with self.hold_sync():
                for name, value in whole.items():
                    setattr(self, name, value)

        def psf(self, **options: Any) -> PSF:
            """Return the PSF that the page shows, by this Python."""
            return psf_of(self.state, **options)

        def __repr__(self) -> str:
            said = ", ".join(
                f"{name}={value!r}" for name, value in self.state.items() if value != FIELDS[name].initial
            )
            return f"Live({said})"

    made: type = type("Live", (Live,), {name: trait(field) for name, field in FIELDS.items()})
    return made
