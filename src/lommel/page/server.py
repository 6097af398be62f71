"""The live page for browsers: its module `lommel-live.js`, its HTML, a local server and a notebook widget."""

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
from lommel.base.optional import library, require
from lommel.lensfiles.instrument import Instrument
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
    """Return the path of `lommel-live.js`; FileNotFoundError if it is missing."""
    module = Path(__file__).with_name(NAME)
    if not module.is_file():
        raise FileNotFoundError(
            f"the live page's module is missing ({module}): restore it from the repository of the sources, or run "
            "`make page` there"
        )
    return module


def documentation() -> str:
    """Return the address of the documentation from the metadata of the package, or an empty string."""
    try:
        addresses = metadata.metadata("lommel").get_all("Project-URL") or []
    except metadata.PackageNotFoundError:
        return ""
    pairs = (address.partition(", ") for address in addresses)
    return next((url for name, _, url in pairs if name.lower() == "documentation" and url.startswith("https://")), "")


def html(state: Mapping[str, object], lens: str = "", left_out: str = "", *, alone: bool = False) -> str:
    """Return the HTML of the page with a `state`, the name of its `lens`, and features of the lens that it lacks.

    With `alone`, the page contains the module; otherwise the module is loaded from the folder of the page.
    """
    # HTML ends a script at the first "</script"; in strings of JavaScript "<\/script" has the same value.
    text = path().read_text(encoding="utf-8").replace("</script", "<\\/script") if alone else ""
    source = "" if alone else f"src={json.dumps(NAME)} "
    attributes = {"name": lens, "without": left_out, "docs": documentation()}
    data_attributes = "".join(f' data-lommel-{key}="{escape(value)}"' for key, value in attributes.items() if value)
    title = escape(lens or "lommel")
    return _PAGE.format(title=title, source=source, state=escape(link(state)), more=data_attributes, text=text)


# The page may run its module and the WebAssembly core inside it, start workers and show images; it sends no data.
_POLICY = (
    "default-src 'none'; script-src 'self' 'wasm-unsafe-eval' blob:; worker-src blob:; style-src 'unsafe-inline'; "
    "img-src data: blob:; base-uri 'none'; form-action 'none'; frame-ancestors 'none'"
)
_HEADERS = (
    ("Cache-Control", "no-store"),
    ("Content-Security-Policy", _POLICY),
    ("X-Content-Type-Options", "nosniff"),
)


class PageServer(ThreadingHTTPServer):
    """Local HTTP server of the live page with an initial state; port 0 selects a free port."""

    daemon_threads = True
    request_queue_size = 128  # largest number of waiting connections; each browser opens several

    def __init__(self, state: Mapping[str, object], lens: str, port: int = 0, left_out: str = "") -> None:
        page = html(state, lens, left_out).encode()
        self.contents = {
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
    default_request_version = "HTTP/1.0"  # version assumed for an invalid request: its error response has headers
    timeout = 10.0  # seconds before a client that sends nothing is disconnected

    def do_GET(self) -> None:
        # Against DNS rebinding: a foreign page whose name resolves to 127.0.0.1 still sends its name as the host.
        port = self.server.server_port
        # If there are several Host headers, a proxy could use another header than this server.
        hosts = self.headers.get_all("Host", [])
        if len(hosts) != 1 or hosts[0] not in {f"127.0.0.1:{port}", f"localhost:{port}"}:
            return self.send_error(403)
        entry = self.server.contents.get(self.path.partition("?")[0])
        if entry is None:
            return self.send_error(404)
        content, media_type = entry
        self.send_response(200)
        self.send_header("Content-Type", f"{media_type}; charset=utf-8")
        self.send_header("Content-Length", str(len(content)))
        self.end_headers()
        if self.command == "GET":
            self.wfile.write(content)
        return None

    do_HEAD = do_GET  # noqa: N815 (the name that http.server requires)

    def end_headers(self) -> None:
        """Send the headers that all responses have, including errors, and end the headers."""
        for name, value in _HEADERS:
            self.send_header(name, value)
        super().end_headers()

    def log_message(self, *_: object) -> None:
        """Suppress the log of requests."""


def live(lens: Instrument | str | PathLike[str] | None = None, **state: Any) -> Any:
    """Return the live page as a notebook widget, for Jupyter, VS Code, marimo and other hosts of anywidget.

    Every control is a synchronised trait of the widget: ``w.coma = 0.5`` moves the slider, and ``w.observe(...,
    "coma")`` is notified when the slider is dragged. ``w.state`` is a dict of the values of all controls; assigning
    a dict changes the controls that it contains. ``w.psf()`` computes the :class:`lommel.PSF` that the page shows in
    Python, without noise; it takes further arguments of :func:`lommel.psf`.

    Parameters
    ----------
    lens : Instrument, str or path, optional
        Initial lens: a lens file, or the result of :func:`lommel.load_instrument`.
    **state
        Initial values of controls. Without a lens the page begins with 0.6 waves of `defocus`, so that a first
        change shows; ``defocus=0.0`` begins in focus.

        - Wavefront, waves at the edge of the pupil: `defocus` and `spherical` (W020 and W040), `coma`, `astigmatism`,
          `trefoil` and their directions (`coma_angle`, ..., degrees); `zernike`, terms "n,m:waves;..." in waves rms.
        - `focus`: "waves", or "distances", where `focal_length` (mm), `f_number`, `focus_distance` and
          `object_distance` (m) determine the defocus, as in :meth:`lommel.Lens.pupil`.
        - Lens and light: `f_number`, `obscuration` and `vane_width` (fractions of the aperture radius), `vanes`
          (0 to 8), `vane_angle` (degrees), `wavelength` (nm), `light` ("mono", "white").
        - Sensor: `pixel` (um), `view` ("fine", "sampled", "averaged"), `side` (pixels), `noise` ("off", "on"),
          `photons`, `read_noise` (electrons).
        - Display: `rays` ("off", "on"), `stretch`, `map`, `waves_unit`, `length_unit`, `picture`.

        Also `controls`, a list of the controls to show, and `theme`, "light" or "dark", by default the theme of
        the notebook.

    Returns
    -------
    anywidget.AnyWidget

    Raises
    ------
    ImportError
        If anywidget is not installed; the extra "live" of this package installs it.
    FileNotFoundError
        If the page's module is missing from the package.
    TypeError, ValueError
        If a control is unknown, if its value is invalid, or if the lens is outside the range of the controls.

    Examples
    --------
    >>> w = lm.live("examples/lenses/hubble-1990.toml")  # doctest: +SKIP
    >>> w.psf().values.shape  # doctest: +SKIP
    (512, 512)
    """
    widget_class = _widget_class()
    display = {name: state.pop(name) for name in ("controls", "theme") if name in state}
    start: Json = {}
    if lens is not None:
        if not isinstance(lens, Instrument):
            if not isinstance(lens, (str, PathLike)):
                raise TypeError(
                    f"lens must be an Instrument or the path of a lens file, got {validation.shown(lens)}"
                )
            require("pydantic", "lens files need", "cli")
            from lommel.lensfiles.lens_files import load_instrument  # late: the extra "live" has no pydantic

            lens = load_instrument(lens)
        start, _ = state_of(lens)
    return widget_class(**complete(start | state), **display)


@cache
def _widget_class() -> type:
    """Return the class of the widget, defined here because its base class is in the optional package anywidget."""
    anywidget: Any = library("anywidget", "lm.live() needs", "live")
    traitlets: Any = library("traitlets", "lm.live() needs", "live")

    class Text(traitlets.Unicode):  # type: ignore[misc]
        """Trait for a string of Zernike terms."""

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
        number = traitlets.CInt if isinstance(field, Whole) else traitlets.CFloat
        return number(field.initial, min=field.low, max=field.high).tag(sync=True)

    class Live(anywidget.AnyWidget):  # type: ignore[misc]
        """The live page; see :func:`lommel.live`."""

        _esm = path()
        controls = traitlets.List(traitlets.Unicode()).tag(sync=True)
        theme = traitlets.Enum(("light", "dark"), default_value=None, allow_none=True).tag(sync=True)

        @property
        def state(self) -> Json:
            """Values of all controls."""
            return {name: getattr(self, name) for name in FIELDS}

        @state.setter
        def state(self, change: Json) -> None:
            values = complete(self.state | change)
            with self.hold_sync():
                for name, value in values.items():
                    setattr(self, name, value)

        def psf(self, **options: Any) -> PSF:
            """Return the PSF that the page shows, computed in Python without noise."""
            return psf_of(self.state, **options)

        def __repr__(self) -> str:
            changed = ", ".join(
                f"{name}={value!r}" for name, value in self.state.items() if value != FIELDS[name].initial
            )
            return f"Live({changed})"

    widget_class: type = type("Live", (Live,), {name: trait(field) for name, field in FIELDS.items()})
    return widget_class
