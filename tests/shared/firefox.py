"""A Firefox of the system, driven by WebDriver BiDi (https://www.w3.org/TR/webdriver-bidi)."""

from __future__ import annotations

import base64
import json
import os
import shutil
import subprocess
import time
from pathlib import Path
from typing import Any

BROWSERS = ("firefox", "firefox-esr")
PREFERENCES = {"browser.shell.checkDefaultBrowser": False, "datareporting.policy.dataSubmissionEnabled": False}


def path() -> str | None:
    """Return the path of a Firefox of the system, or None."""
    return os.environ.get("LOMMEL_FIREFOX") or next((at for name in BROWSERS if (at := shutil.which(name))), None)


class Firefox:
    """A headless Firefox with a profile of its own in an empty folder; its tabs are opened by :meth:`open`."""

    def __init__(self, folder: Path, preferences: dict[str, object] | None = None) -> None:
        import websocket

        lines = (
            f"user_pref({json.dumps(k)}, {json.dumps(v)});" for k, v in (PREFERENCES | (preferences or {})).items()
        )
        (folder / "user.js").write_text("\n".join(lines), encoding="utf-8")
        said = folder / "said.txt"
        command = [str(path()), "--headless", "--profile", str(folder), "--remote-debugging-port", "0", "--no-remote"]
        with said.open("wb") as out:
            self._process = subprocess.Popen(command, stdout=out, stderr=out, env=os.environ | {"HOME": str(folder)})
        self._asked = 0
        self.complaints: list[str] = []
        end = time.monotonic() + 60.0
        while "BiDi listening on " not in (text := said.read_text(errors="replace")):
            if time.monotonic() > end or self._process.poll() is not None:
                self._process.kill()
                raise RuntimeError(f"Firefox does not start: {text}")
            time.sleep(0.1)
        address = text.partition("BiDi listening on ")[2].split()[0]
        self._socket = websocket.create_connection(f"{address}/session", suppress_origin=True, timeout=120)
        self.call("session.new", capabilities={})
        self.call("session.subscribe", events=["log.entryAdded"])

    def call(self, method: str, **given: Any) -> Any:
        """Return the result of a command."""
        self._asked += 1
        self._socket.send(json.dumps({"id": self._asked, "method": method, "params": given}))
        while True:
            heard = json.loads(self._socket.recv())
            if heard.get("method") == "log.entryAdded" and heard["params"]["level"] in ("error", "warn"):
                self.complaints.append(str(heard["params"]["text"]))
            if heard.get("id") == self._asked:
                if heard["type"] == "error":
                    raise RuntimeError(f"{method}: {heard['message']}")
                return heard["result"]

    def open(self, address: str, width: int = 1280, height: int = 900, before: str = "") -> Tab:
        """Open a tab of a size, after a script `before` it."""
        context = self.call("browsingContext.create", type="tab")["context"]
        self.call("browsingContext.setViewport", context=context, viewport={"width": width, "height": height})
        if before:
            declaration = f"() => {{ {before} }}"
            self.call("script.addPreloadScript", functionDeclaration=declaration, contexts=[context])
        self.call("browsingContext.navigate", context=context, url=address, wait="complete")
        return Tab(self, context)

    def close(self) -> None:
        """End Firefox."""
        try:
            self.call("browser.close")
            self._process.wait(20)
        except (OSError, RuntimeError, subprocess.TimeoutExpired):
            self._process.kill()
        self._socket.close()


class Tab:
    """A tab, with the methods of Playwright's pages that the tests use."""

    def __init__(self, firefox: Firefox, context: str) -> None:
        self.firefox = firefox
        self._context = context

    def evaluate(self, expression: str) -> Any:
        """Return the value of an expression or its promise."""
        # JSON carries numbers as they are; undefined becomes None.
        text = f"Promise.resolve({expression}).then((value) => JSON.stringify(value) ?? 'null')"
        target = {"context": self._context}
        heard = self.firefox.call("script.evaluate", expression=text, target=target, awaitPromise=True)
        if heard["type"] == "exception":
            raise RuntimeError(heard["exceptionDetails"]["text"])
        return json.loads(heard["result"]["value"])

    def wait_for(self, expression: str, seconds: float = 30.0) -> None:
        """Wait until an expression is true."""
        end = time.monotonic() + seconds
        while not self.evaluate(expression):
            if time.monotonic() > end:
                raise TimeoutError(f"not within {seconds:g} s: {expression}")
            time.sleep(0.03)

    def pointer(self, kind: str, *actions: dict[str, Any]) -> None:
        """Perform actions of a pointer, "mouse" or "touch"."""
        source = {"type": "pointer", "id": kind, "parameters": {"pointerType": kind}, "actions": list(actions)}
        self.firefox.call("input.performActions", context=self._context, actions=[source])
        self.firefox.call("input.releaseActions", context=self._context)

    def press(self, *keys: str) -> None:
        """Press keys one after the other; names of keys that are no characters are their WebDriver code points."""
        actions = [{"type": kind, "value": key} for key in keys for kind in ("keyDown", "keyUp")]
        source = {"type": "key", "id": "keys", "actions": actions}
        self.firefox.call("input.performActions", context=self._context, actions=[source])

    def screenshot(self, file: Path) -> None:
        """Write what is seen as PNG."""
        data = self.firefox.call("browsingContext.captureScreenshot", context=self._context)["data"]
        file.write_bytes(base64.b64decode(data))

    def close(self) -> None:
        """Close the tab."""
        self.firefox.call("browsingContext.close", context=self._context)
