"""A browser, and a server of pages with the live page's module, as it is committed."""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterator
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any

import pytest

import check
from lommel.page import server as page_module

HEAD = """<!doctype html><html lang="en"><meta charset="utf-8"><title>test</title><link rel="icon" href="data:,">
<meta name="viewport" content="width=device-width, initial-scale=1"><body style="margin:0">"""
PAGES = {
    # As anybody writes it.
    "/": HEAD + '<script type="module" src="lommel-live.js" data-lommel></script>',
    # With the handle for the test to hold.
    "/mounted": HEAD
    + """<div id="place"></div><script type="module">
import { mount } from "./lommel-live.js";
const controls = new URLSearchParams(location.search).get("controls") ?? "";
window.live = mount(document.querySelector("#place"), { url: true, controls });
</script>""",
    "/empty": HEAD + '<script type="module">window.lommel = await import("./lommel-live.js");</script>',
}
IDLE = ".lommel-live-host:not([data-busy])"


@pytest.fixture(scope="session")
def module() -> Path:
    """The module."""
    return page_module.path()


@pytest.fixture(scope="session")
def browser() -> Iterator[Any]:
    """A Chromium of the system."""
    api = pytest.importorskip("playwright.sync_api", reason="playwright is not installed, which drives the browser")
    if not check.browser():
        pytest.skip("there is no Chromium to open the live page with")
    with api.sync_playwright() as play:
        made = check.launched(play)
        yield made
        made.close()


@pytest.fixture(scope="session")
def site(module: Path) -> Iterator[str]:
    """The address of a server with the module and pages around it."""
    served = {name: (text.encode(), "text/html") for name, text in PAGES.items()}
    served["/live"] = (page_module.html({}, "A lens").encode(), "text/html")  # as `lommel live` writes it
    served["/lommel-live.js"] = (module.read_bytes(), "text/javascript")

    class Handler(BaseHTTPRequestHandler):
        def do_GET(self) -> None:
            body, kind = served.get(self.path.split("?")[0], (b"", ""))
            self.send_response(200 if kind else 404)
            self.send_header("Content-Type", f"{kind or 'text/plain'}; charset=utf-8")
            self.send_header("Content-Length", str(len(body)))
            self.end_headers()
            self.wfile.write(body)

        def log_message(self, *_: object) -> None:
            pass

    server = ThreadingHTTPServer(("127.0.0.1", 0), Handler)
    threading.Thread(target=server.serve_forever, daemon=True).start()
    yield f"http://127.0.0.1:{server.server_port}"
    server.shutdown()
    server.server_close()


@pytest.fixture
def visit(browser: Any, site: str) -> Iterator[Callable[..., Any]]:
    """Open a page and wait until it rests; what the browser complains of, or a foreign request, fails the test."""
    contexts, complaints = [], []

    def opened(path: str = "/mounted", *, wait: str = IDLE, before: str = "", **options: Any) -> Any:
        context = browser.new_context(**{"viewport": {"width": 1280, "height": 900}} | options)
        contexts.append(context)
        page = context.new_page()
        page.add_init_script(before)
        page.on("console", lambda said: complaints.append(said.text) if said.type != "info" else None)
        page.on("pageerror", lambda error: complaints.append(str(error)))
        page.on("requestfailed", lambda request: complaints.append(f"failed: {request.url[:200]}"))
        ours = (site, "blob:", "data:")
        page.on("request", lambda r: None if r.url.startswith(ours) else complaints.append(f"foreign: {r.url}"))
        page.goto(site + path)
        if wait:
            page.wait_for_selector(wait, state="attached")
        return page

    yield opened
    for context in contexts:
        context.close()
    assert complaints == []
