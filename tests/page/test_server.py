"""The server of the live page, and pages around its module: three names for this machine, and nothing else."""

from __future__ import annotations

import http.client
import socket
import threading
from collections.abc import Iterator

import pytest

from lommel.page import server as page_server
from lommel.page.server import PageServer
from web import build as web_build


@pytest.fixture
def made(tmp_path, monkeypatch):
    """A module that was made."""
    file = tmp_path / page_server.NAME
    file.write_text('const end = "</script>"; // µ\n', encoding="utf-8")
    monkeypatch.setattr(page_server, "path", lambda: file)
    return file


@pytest.fixture
def server(made) -> Iterator[PageServer]:
    with PageServer({"defocus": 1.5, "view": "sampled"}, "A <b> lens & more") as running:
        threading.Thread(target=running.serve_forever, kwargs={"poll_interval": 0.01}, daemon=True).start()
        yield running
        running.shutdown()


def raw(server, text) -> str:
    with socket.create_connection(server.server_address, timeout=5) as connection:
        connection.sendall(text.encode())
        return b"".join(iter(lambda: connection.recv(65536), b"")).decode()


def test_a_second_name_is_refused_whichever_comes_first(server):
    right, wrong = f"Host: 127.0.0.1:{server.server_port}", "Host: example.org"
    for names in ((right, wrong), (wrong, right), (right, right)):
        assert " 403 " in raw(server, "\r\n".join(["GET / HTTP/1.0", *names, "", ""])).splitlines()[0]
    assert " 200 " in raw(server, f"GET / HTTP/1.0\r\n{right}\r\n\r\n").splitlines()[0]


@pytest.mark.parametrize(
    ("first", "host", "status"),
    [
        ("GET /x HTTP/1.0", "", 404),
        ("GET / HTTP/1.0", "example.org", 403),
        ("BREW / HTTP/1.0", "", 501),
        ("junk", "", 400),
    ],
)
def test_pages_of_errors_may_do_as_little_as_others(server, first, host, status):
    told = raw(server, f"{first}\r\nHost: {host or f'127.0.0.1:{server.server_port}'}\r\n\r\n")
    assert f" {status} " in told.splitlines()[0]
    head = told.partition("\r\n\r\n")[0]
    assert "Content-Security-Policy: default-src 'none'" in head
    assert "X-Content-Type-Options: nosniff" in head
    assert head.count("Content-Security-Policy") == 1


def ask(server, path, *, host=None, method="GET"):
    connection = http.client.HTTPConnection("127.0.0.1", server.server_port, timeout=5)
    connection.putrequest(method, path, skip_host=True)
    if host != "":
        connection.putheader("Host", host or f"127.0.0.1:{server.server_port}")
    connection.endheaders()
    answer = connection.getresponse()
    body = answer.read()
    connection.close()
    return answer, body


def test_the_page_and_its_module_are_served(server, made):
    for path in ("/", "/index.html", "/?controls=defocus"):
        answer, body = ask(server, path)
        assert (answer.status, answer.getheader("Content-Type")) == (200, "text/html; charset=utf-8")
        assert b'data-lommel="defocus=1.5&amp;view=sampled"' in body
        assert b"<title>A &lt;b&gt; lens &amp; more</title>" in body
        assert "connect-src" not in answer.getheader("Content-Security-Policy")
        assert "default-src 'none'" in answer.getheader("Content-Security-Policy")
    answer, body = ask(server, f"/{page_server.NAME}")
    assert (answer.status, answer.getheader("Content-Type")) == (200, "text/javascript; charset=utf-8")
    assert body == made.read_bytes()
    answer, body = ask(server, "/", method="HEAD")
    assert (answer.status, body) == (200, b"")
    assert int(answer.getheader("Content-Length")) > 100


@pytest.mark.parametrize("path", ["/../etc/passwd", "/state.py", "/lommel-live.js/", "/%2e%2e/x", "*"])
def test_other_names_are_not_there(server, path):
    assert ask(server, path)[0].status == 404


@pytest.mark.parametrize("host", ["example.org", "127.0.0.1", "localhost.example.org", "", "127.0.0.1:1"])
def test_another_host_is_refused(server, host):
    assert ask(server, "/", host=host)[0].status in (400, 403)
    assert ask(server, "/", host=f"localhost:{server.server_port}")[0].status == 200


def test_only_this_machine_is_listened_to(server):
    assert server.server_address[0] == "127.0.0.1"
    assert ask(server, "/", method="POST")[0].status == 501
    with socket.create_connection(server.server_address, timeout=5) as raw:
        raw.sendall(b"\x00\xff nonsense\r\n\r\n")
        assert b"400" in raw.recv(1000)
    assert ask(server, "/")[0].status == 200


def test_a_page_alone_has_the_module_inside(made):
    text = page_server.html({}, alone=True)
    assert 'const end = "<\\/script>"' in text
    assert text.count("</script") == 1
    assert "src=" not in text
    assert 'data-lommel=""' in text


def test_the_module_is_made_of_these_sources():
    assert web_build.is_current(page_server.path()), "the sources of the live page have changed: run make page"


def test_the_checksum_is_of_code_that_the_page_is_made_of(tmp_path, monkeypatch):
    files = {
        "pyproject.toml": 'page = ["ziglang==0.17.0"]\n',
        "cpp/wasm/live.cpp": '#include "light.hpp"\n#include "lommel/a.hpp"\n',
        "cpp/wasm/depth.cpp": "int depth;\n",
        "cpp/wasm/light.hpp": "int light;\n",
        "cpp/include/lommel/a.hpp": '#pragma once\n#include "lommel/b.hpp"\n',
        "cpp/include/lommel/b.hpp": "int b;\n",
        "cpp/include/lommel/unused.hpp": "int unused;\n",
        "web/live.js": "let a;\n",
        "web/depths.py": "a = 1\n",
        "examples/lenses/phone.toml": "f_number = 2\n",
    }

    def written(changes: dict[str, str]) -> str:
        for name, text in (files | changes).items():
            (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
            (tmp_path / name).write_text(text, encoding="utf-8")
        return web_build.source_line()

    monkeypatch.setattr(web_build, "ROOT", tmp_path)
    line = written({})
    for name, text in files.items():
        mark = "#" if name.endswith((".py", ".toml")) else "//"
        assert written({name: f"  {mark} a comment\n\n{text}{mark} another\n"}) == line
        is_counted = name not in ("pyproject.toml", "cpp/include/lommel/unused.hpp")
        assert (written({name: f"{text}more\n"}) != line) == is_counted, name
    assert written({"pyproject.toml": 'page = ["ziglang==0.17.1"]\n'}) != line
