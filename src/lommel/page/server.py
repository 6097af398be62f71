"""The live page: its module `lommel-live.js` in pages of HTML, and their server on 127.0.0.1 only."""

from __future__ import annotations

import json
from collections.abc import Mapping
from html import escape
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from importlib import metadata
from pathlib import Path

from lommel.page.state import link

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
