"""The command `lommel live`, as a user runs it: the page of a lens, served or saved."""

from __future__ import annotations

import re
import signal
import subprocess
import sys
import urllib.request

import pytest

from live_page import PIXELS


@pytest.fixture
def running(module, lenses):
    """The command at work, and the address that it prints."""
    command = [sys.executable, "-m", "lommel", "live", str(lenses["hubble-1990"]), "--no-browser"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
        line = process.stdout.readline()
        yield process, line
        process.kill()


def test_it_serves_the_page_of_a_lens_until_ctrl_c(running):
    process, line = running
    found = re.fullmatch(r"(http://127\.0\.0\.1:\d+/) shows Hubble .*; Ctrl-C stops it\.\n", line)
    assert found, line
    with urllib.request.urlopen(found[1], timeout=10) as answer:
        assert b"f_number=24&amp;obscuration=0.33" in answer.read()
    process.send_signal(signal.SIGINT)
    assert process.wait(10) == 0
    assert process.stderr.read() == ""


def test_the_page_that_it_opens_shows_the_lens(running, browser):
    _, line = running
    page = browser.new_page()
    complaints = []
    page.on("console", lambda said: complaints.append(said.text))
    page.on("pageerror", lambda error: complaints.append(str(error)))
    page.goto(line.split()[0])
    page.wait_for_selector(".lommel-live-host:not([data-busy])", state="attached")
    assert page.title().startswith("Hubble Space Telescope")
    assert page.locator("main h1").inner_text() == page.title()
    assert page.locator("main").count() == page.locator("h1").count() == 1
    assert page.locator('input[type=text][data-key="f_number"]').input_value() == "24"
    page.close()
    assert complaints == []


def test_a_saved_page_opens_from_its_file_and_draws_the_same(running, run_lommel, lenses, tmp_path, browser):
    done = run_lommel("live", lenses["hubble-1990"], "--save", "hubble.html", folder=tmp_path)
    assert (done.returncode, done.stdout, done.stderr) == (0, "wrote hubble.html\n", "")
    pixels = []
    for address in (running[1].split()[0], (tmp_path / "hubble.html").as_uri()):
        page = browser.new_page()
        page.goto(address)
        page.wait_for_selector(".lommel-live-host:not([data-busy])", state="attached")
        pixels.append(page.evaluate(PIXELS))
        page.close()
    assert pixels[0] == pixels[1]
    assert len(pixels[0]) > 1000
