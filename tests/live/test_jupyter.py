"""The widget in JupyterLab: what is dragged there reaches Python, and what Python sets moves the slider."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
import threading
from importlib.util import find_spec

import pytest

if find_spec("jupyterlab") is None:
    pytest.skip("jupyterlab is not installed, which shows the widget", allow_module_level=True)

CELLS = [
    "import lommel as lm\nw = lm.live(side=64, coma=0.5)\nw",
    "print('coma', w.coma, w.psf().values.shape, w.psf().pixel)",
    "w.state = {'defocus': 1.25, 'coma': 0.75}",
]


@pytest.fixture
def lab(module, tmp_path):
    """The address of a JupyterLab with a notebook, which the user is free to open."""
    cells = [
        {"cell_type": "code", "id": f"c{i}", "metadata": {}, "source": text, "outputs": [], "execution_count": None}
        for i, text in enumerate(CELLS)
    ]
    kernel = {"kernelspec": {"name": "python3", "display_name": "Python 3", "language": "python"}}
    notebook = {"cells": cells, "metadata": kernel, "nbformat": 4, "nbformat_minor": 5}
    (tmp_path / "live.ipynb").write_text(json.dumps(notebook), encoding="utf-8")
    folders = ("JUPYTER_CONFIG_DIR", "JUPYTER_DATA_DIR", "JUPYTER_RUNTIME_DIR", "IPYTHONDIR")
    home = {name: str(tmp_path / name) for name in folders}
    options = ["--no-browser", "--allow-root", "--port=0", "--IdentityProvider.token=", "--ServerApp.ip=127.0.0.1"]
    command = [sys.executable, "-m", "jupyterlab", *options, f"--ServerApp.root_dir={tmp_path}"]
    with subprocess.Popen(command, env=os.environ | home, stderr=subprocess.PIPE, text=True, cwd=tmp_path) as process:
        for line in process.stderr:
            if found := re.search(r"http://127\.0\.0\.1:\d+", line):
                break
        else:
            pytest.fail("JupyterLab did not start")
        # What it says from here on is read, lest it wait for a reader.
        threading.Thread(target=process.stderr.read, daemon=True).start()
        yield found[0]
        process.terminate()


def run(page, cell):
    """Run a cell, and wait until it has."""
    cells = page.locator(".jp-CodeCell")
    cells.nth(cell).locator(".cm-content").click()
    page.keyboard.press("Shift+Enter")
    prompt = "document.querySelectorAll('.jp-CodeCell')[cell].querySelector('.jp-InputPrompt').textContent"
    page.wait_for_function(f"cell => /[0-9]/.test({prompt})", arg=cell)


def test_the_widget_and_python_follow_one_another(lab, browser):
    page = browser.new_page(viewport={"width": 1400, "height": 2200})
    page.goto(f"{lab}/lab/tree/live.ipynb")
    page.wait_for_selector(".jp-CodeCell .cm-content", timeout=60_000)
    page.get_by_text("| Idle").wait_for(timeout=60_000)
    run(page, 0)
    page.wait_for_selector(".lommel-live-host:not([data-busy])", state="attached", timeout=60_000)
    coma = page.locator('input[type=range][data-key="coma"]')
    coma.focus()
    before = float(coma.input_value())
    for _ in range(5):
        page.keyboard.press("ArrowRight")  # which JupyterLab would take for its own
    page.wait_for_timeout(500)
    after = page.locator('input[type=text][data-key="coma"]').input_value()
    assert float(coma.input_value()) > before
    run(page, 1)
    printed = page.locator(".jp-CodeCell").nth(1).locator(".jp-OutputArea-output").inner_text()
    assert printed.startswith(f"coma {float(after)} (64, 64)")
    run(page, 2)
    page.wait_for_function("""() => document.querySelector('.lommel-live-host').shadowRoot
        .querySelector('input[type=text][data-key="defocus"]').value === "1.25" """)
    assert page.locator('input[type=text][data-key="coma"]').input_value() == "0.75"
    page.close()
