"""How smooth the live page is: each slider dragged by the mouse for two seconds, in a Chromium of the system.

    python benchmarks/live.py [src/lommel/page/lommel-live.js]

Prints, for each slider, the work of the page in a frame (median, worst; ms), the share of frames that came within
20 ms of the one before, and the tasks that took longer than 50 ms. The engine works beside the page, so its time
shows only in how many point spread functions were drawn a second.

With `--states 500` it draws so many random states over the ranges of all controls, always the same ones, and prints
those that take longer than a second until all of the page is of the new state, as it meets them; quantiles of
that time; and the slowest, with what the engine takes for their PSF, the images of their FWHM and light in the
window, their curves and their picture.
"""

from __future__ import annotations

import argparse
import math
import shutil
import statistics
import time
from pathlib import Path
from typing import Any

import numpy as np
from playwright.sync_api import TimeoutError as Timeout
from playwright.sync_api import sync_playwright

from lommel.page.state import FIELDS, Real, Whole, Word, link

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


STATES = """<!doctype html><title>bench</title><link rel="icon" href="data:,"><body>
<script type="module">
import { createCore, Engine, mount } from "./lommel-live.js";
window.live = mount(document.body);
window.settled = async (state) => {
  const begin = performance.now();
  live.set(state);
  do await new Promise(requestAnimationFrame);
  while (document.querySelector("[data-busy]"));
  return performance.now() - begin;
};
window.parts = async (state) => {
  const engine = new Engine(await createCore());
  const picture = new Float32Array(3 * 256 * 256).fill(0.5);
  const timed = (run) => {
    const begin = performance.now();
    try { run(); } catch (error) { return error.message; }
    return Math.round(performance.now() - begin);
  };
  return [
    timed(() => engine.psf(state)), timed(() => engine.extents(state)), timed(() => engine.curves(state)),
    timed(() => engine.blur(state, picture, 256, 256)),
  ];
};
window.ready = true;
</script>"""
PATIENCE = 20.0  # seconds, after which a state counts as that, and a new page begins


def random_state(rng: np.random.Generator) -> dict[str, Any]:
    """Return values of all controls in their ranges, those of logarithmic sliders evenly on that scale."""

    def value(field: Any) -> Any:
        if isinstance(field, Word):
            return field.choices[int(rng.integers(len(field.choices)))]
        if not isinstance(field, Real):
            return ""
        if isinstance(field, Whole):
            return int(rng.integers(int(field.low), int(field.high), endpoint=True))
        if field.row.step is None and field.low > 0:
            return float(np.exp(rng.uniform(math.log(field.low), math.log(field.high))))
        return float(rng.uniform(field.low, field.high))

    return {name: value(field) for name, field in FIELDS.items()} | {
        "picture": str(rng.choice(["star", "bars", "text"]))
    }


def states(module: Path, count: int) -> None:
    """Print how long random states take to settle."""
    rng = np.random.default_rng(1885)
    drawn = [random_state(rng) for _ in range(count)]
    times = []
    with sync_playwright() as play:
        path = shutil.which("chromium") or shutil.which("google-chrome")
        browser = play.chromium.launch(executable_path=path, args=["--no-sandbox"])

        def opened() -> Any:
            page = browser.new_page(viewport={"width": 1280, "height": 900})
            page.route("http://page/*", lambda route, _: serve(route, module, "", STATES))
            page.goto("http://page/")
            page.wait_for_function("window.ready && !document.querySelector('[data-busy]')")
            return page

        page = opened()
        for k, state in enumerate(drawn):
            page.evaluate(
                "state => { window.took = null; settled(state).then((ms) => { window.took = ms; }); }", state
            )
            try:
                page.wait_for_function("window.took !== null", timeout=1e3 * PATIENCE)
                times.append(1e-3 * page.evaluate("took"))
            except Timeout:
                times.append(PATIENCE)
                page.close()
                page = opened()
            if times[-1] > 1.0:
                print(f"state {k}: {times[-1]:.2f} s", flush=True)
        shares = (0.5, 0.9, 0.95, 0.99, 1.0)
        found = ", ".join(
            f"{share:.0%} {at:.2f}" for share, at in zip(shares, np.quantile(times, shares), strict=True)
        )
        print(f"{count} states settle in (s): {found}; {sum(t > 3 for t in times)} take longer than 3 s")
        for k in np.argsort(times)[::-1][:20]:
            shown = {key: float(f"{x:.3g}") if isinstance(x, float) else x for key, x in drawn[k].items()}
            parts = page.evaluate("parts", drawn[k]) if times[k] < PATIENCE else "?"
            print(f"{times[k]:6.2f} s, PSF, extents, curves, picture (ms): {parts}; {link(shown)}")
        browser.close()


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


def serve(route: Any, module: Path, state: str, text: str = PAGE) -> None:
    """Answer a request of the page."""
    if route.request.url.endswith(".js"):
        route.fulfill(path=module, content_type="text/javascript")
    else:
        route.fulfill(body=text.replace("STATE", state), content_type="text/html")


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
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("module", type=Path, nargs="?", default=MODULE)
    parser.add_argument("--states", type=int, default=0)
    given = parser.parse_args()
    states(given.module, given.states) if given.states else main(given.module)
