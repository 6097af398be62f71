"""How smooth the live page is: each slider dragged by the mouse for two seconds, in a Chromium of the system.

    python benchmarks/live.py [src/lommel/page/lommel-live.js]

Prints, for each slider, the work of the page in a frame (median, worst; ms), the share of frames that came within
20 ms of the one before, and the tasks that took longer than 50 ms. The engine works beside the page, so its time
shows only in how many point spread functions were drawn a second.
"""

from __future__ import annotations

import shutil
import statistics
import sys
import time
from pathlib import Path
from typing import Any

from playwright.sync_api import sync_playwright

MODULE = Path(__file__).resolve().parent.parent / "src" / "lommel" / "page" / "lommel-live.js"
SLIDERS = ("defocus", "spherical", "coma", "coma_angle", "astigmatism", "trefoil", "f_number", "obscuration", "pixel")
WATCH = """
const seen = (window.seen = { begins: [], work: [], long: 0, drawn: 0 });
const add = (run) => function (...given) {
  const begin = performance.now();
  try { return run.apply(this, given); } finally { ended(begin, seen.work.length - 1); }
};
// What waits for a promise draws a few microtasks later.
const ended = async (begin, frame) => {
  for (let i = 0; i < 12; i++) await null;
  seen.work[frame] += performance.now() - begin;
};
const frame = window.requestAnimationFrame.bind(window);
window.requestAnimationFrame = (run) => frame(add(run));
const { set } = Object.getOwnPropertyDescriptor(Worker.prototype, "onmessage");
Object.defineProperty(Worker.prototype, "onmessage", { set(run) { set.call(this, add(run)); } });
const put = CanvasRenderingContext2D.prototype.putImageData;
CanvasRenderingContext2D.prototype.putImageData = function (image, ...at) {
  if (this.canvas.parentNode?.classList?.contains("now")) seen.drawn++;
  return put.call(this, image, ...at);
};
const turn = (now) => { seen.begins.push(now); seen.work.push(0); frame(turn); };
frame(turn);
new PerformanceObserver((list) => { seen.long += list.getEntries().length; }).observe({ type: "longtask" });
"""
PAGE = """<!doctype html><title>bench</title><link rel="icon" href="data:,"><body>
<script type="module" src="lommel-live.js" data-lommel="STATE"></script>"""


def main(module: Path) -> None:
    """Measure a module."""
    with sync_playwright() as play:
        path = shutil.which("chromium") or shutil.which("google-chrome")
        browser = play.chromium.launch(executable_path=path, args=["--no-sandbox"])
        for state in ("", "coma=0.5&astigmatism=0.3", "light=white&coma=0.5"):
            page = browser.new_page(viewport={"width": 1280, "height": 900})
            page.add_init_script(WATCH)
            page.route("http://page/*", lambda route, _, state=state: serve(route, module, state))
            page.goto("http://page/")
            page.wait_for_selector(".lommel-live-host:not([data-busy])", state="attached")
            print(f"{state or 'defaults'}:  work median / worst (ms), intervals <= 20 ms, long tasks, PSFs / s")
            for key in SLIDERS:
                print(f"  {key:<12}", drag(page, key))
            page.close()
        browser.close()


def serve(route: Any, module: Path, state: str) -> None:
    """Answer a request of the page."""
    if route.request.url.endswith(".js"):
        route.fulfill(path=module, content_type="text/javascript")
    else:
        route.fulfill(body=PAGE.replace("STATE", state), content_type="text/html")


def drag(page: Any, key: str, seconds: float = 2.0) -> str:
    """Drag a slider, and return a line of numbers."""
    place = page.locator(f'input[type=range][data-key="{key}"]').bounding_box()
    y = place["y"] + place["height"] / 2
    page.wait_for_timeout(1000)
    page.mouse.move(place["x"] + 0.3 * place["width"], y)
    page.mouse.down()
    page.evaluate("Object.assign(seen, { begins: [], work: [], long: 0, drawn: 0 })")
    begin = time.perf_counter()
    while (at := (time.perf_counter() - begin) / seconds) < 1:
        page.mouse.move(place["x"] + (0.3 + 0.6 * abs((2 * at) % 2 - 1)) * place["width"], y)
        time.sleep(0.008)
    seen = page.evaluate("seen")
    page.mouse.up()
    page.locator(f'input[type=range][data-key="{key}"]').dblclick()
    page.wait_for_timeout(300)
    work = seen["work"][1:-1]
    waits = [b - a for a, b in zip(seen["begins"], seen["begins"][1:], strict=False)]
    smooth = sum(wait <= 20 for wait in waits) / len(waits)
    rate = seen["drawn"] / seconds
    return f"{statistics.median(work):5.1f} / {max(work):5.1f}   {smooth:5.0%}   {seen['long']}   {rate:.0f}"


if __name__ == "__main__":
    main(Path(sys.argv[1]) if sys.argv[1:] else MODULE)
