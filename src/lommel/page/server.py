"""A server of the live page for the browser of this machine, on 127.0.0.1 only."""

from __future__ import annotations

from collections.abc import Mapping
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer

from lommel.page import module

# What a page may do: run its own module with the core in it, in its own workers, and draw. Nothing is sent.
_POLICY = (
    "default-src 'none'; script-src 'self' 'wasm-unsafe-eval' blob:; worker-src blob:; style-src 'unsafe-inline'; "
    "img-src data: blob:; base-uri 'none'; form-action 'none'; frame-ancestors 'none'"
)
_ALWAYS = (
    ("Cache-Control", "no-store"),
    ("Content-Security-Policy", _POLICY),
    ("X-Content-Type-Options", "nosniff"),
)


class PageServer(ThreadingHTTPServer):
    """Serves the page that starts in a state; port 0 is any that is free."""

    daemon_threads = True
    request_queue_size = 128  # connections that wait: a browser opens several, and others may come with it

    def __init__(self, state: Mapping[str, object], lens: str, port: int = 0, left_out: str = "") -> None:
        page = module.html(state, lens, left_out).encode()
        self.served = {
            "/": (page, "text/html"),
            "/index.html": (page, "text/html"),
            f"/{module.NAME}": (module.path().read_bytes(), "text/javascript"),
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
        """Send what every answer has, that of an error too."""
        for name, value in _ALWAYS:
            self.send_header(name, value)
        super().end_headers()

    def log_message(self, *_: object) -> None:
        """Write nothing."""
