"""Checks of built pages: axes that show something, links, width on a phone, and WCAG AA by axe-core."""

from __future__ import annotations

import os
import shutil
import sys
from html.parser import HTMLParser
from importlib.resources import files
from pathlib import Path
from typing import Any
from urllib.parse import parse_qsl, unquote, urlsplit

import numpy as np

import thumbnails
from lommel.page.state import FIELDS

PHONE = 390  # pixels, as phones count them
# Of the pages in `api` examined with axe-core.
REFERENCE_PAGES = 4
# Sets the theme, runs axe-core and returns pairs of rule and selector.
# Until the first answer, numbers are dimmed.
COMPUTED = """() => {
  const time = document.querySelector(".lommel-live-host")?.shadowRoot.querySelector('dd[data-number="time"]');
  return time?.textContent.trim() && getComputedStyle(time).opacity === "1";
}"""
AXE = """async ([theme, rules]) => {
  Object.assign(document.documentElement.dataset, { theme, mode: theme });
  await new Promise((done) => setTimeout(done, 50));
  const { violations } = await axe.run({ exclude: ["mjx-container"] }, { ...rules, resultTypes: ["violations"] });
  return violations.flatMap(({ id, nodes }) => nodes.map(({ target }) => [id, target.join(" ")]));
}"""
BROWSERS = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable")


def empty_axes(figure: Any) -> list[str]:
    """Return what is written on axes in which nothing is to be seen: without artists, or of a single colour."""
    figure.canvas.draw()
    picture = np.asarray(figure.canvas.buffer_rgba())
    found = []
    for axes in figure.axes:
        left, low, right, high = (round(side) for side in axes.get_window_extent().extents)
        # Without the frame; colour bars may be few pixels wide.
        edge = min(3, (right - left) // 4, (high - low) // 4)
        inside = picture[picture.shape[0] - high + edge : picture.shape[0] - low - edge, left + edge : right - edge]
        seen = np.ptp(inside.reshape(-1, 4).astype(int), axis=0).any()
        if axes.get_visible() and not (axes.has_data() and seen):
            found.append(f"{axes.get_title()!r}, x {axes.get_xlabel()!r}")
    return found


def scrape(block: Any, block_vars: dict[str, Any], gallery_conf: dict[str, Any], **options: Any) -> str:
    """Take the figures of a block of the gallery, as Sphinx-Gallery does, where all of their axes show something."""
    import matplotlib.pyplot as plt
    from sphinx_gallery.scrapers import matplotlib_scraper

    for k, figure in enumerate(map(plt.figure, plt.get_fignums()), start=1):
        if empty := empty_axes(figure):
            raise ValueError(f"{block_vars['src_file']}: axes that show nothing: {', '.join(empty)}")
        thumbnails.keep(Path(block_vars["src_file"]).stem, len(block_vars["image_path_iterator"]) + k, figure)
    return str(matplotlib_scraper(block, block_vars, gallery_conf, **options))


class _Page(HTMLParser):
    """The places of a page, and what it leads to or shows."""

    def __init__(self, path: Path) -> None:
        super().__init__()
        self.places: set[str] = set()
        self.links: list[str] = []
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        for name, value in attrs:
            if value and (name == "id" or (tag == "a" and name == "name")):
                self.places.add(value)
            elif value and name in ("href", "src"):
                self.links.append(value)
            elif value and name == "srcset":
                self.links += [each.split()[0] for each in value.split(",")]


def _made(folder: Path) -> list[Path]:
    """Return the pages of a folder, without templates that the theme leaves beside its pictures."""
    return [path for path in sorted(folder.rglob("*.html")) if "_static" not in path.relative_to(folder).parts]


def broken_links(folder: Path) -> list[str]:
    """Return which links of which page lead to no file, or to no place on its page.

    Parameters
    ----------
    folder : Path
        Of pages in HTML. Links to other sites are not followed.

    Returns
    -------
    list of str
    """
    pages = {path.resolve(): _Page(path) for path in _made(folder)}
    found = []
    for path, page in pages.items():
        for link in dict.fromkeys(page.links):
            parts = urlsplit(link)
            if parts.scheme or parts.netloc:
                continue
            target = (path.parent / unquote(parts.path)).resolve() if parts.path else path
            place = unquote(parts.fragment)
            # After the live page's address comes a setting, as in #defocus=1&rays=on.
            setting = target.name == "live.html" and parse_qsl(parts.fragment)
            if setting and target.exists() and all(key in FIELDS for key, _ in setting):
                continue
            if not target.exists() or (place and target in pages and place not in pages[target].places):
                found.append(f"{path.relative_to(folder.resolve())}: {link}")
    return found


def browser() -> str | None:
    """Return the path of a Chromium of the system, or None."""
    return os.environ.get("LOMMEL_BROWSER") or next((at for name in BROWSERS if (at := shutil.which(name))), None)


def launched(play: Any) -> Any:
    """Return that Chromium, started by Playwright."""
    # Pages load modules from beside them; root has no sandbox, as in containers.
    options = ["--allow-file-access-from-files", *["--no-sandbox"] * (os.geteuid() == 0)]
    return play.chromium.launch(executable_path=browser(), args=options)


def wide_pages(folder: Path, width: int = PHONE) -> list[str] | None:
    """Return which pages are wider than a screen, and by what; None where there is no browser to tell.

    Parameters
    ----------
    folder : Path
        Of pages in HTML.
    width : int, default 390
        Pixels.

    Returns
    -------
    list of str or None
    """
    if not browser():
        return None
    from playwright.sync_api import sync_playwright

    found = []
    with sync_playwright() as play:
        made = launched(play)
        view = made.new_page(viewport={"width": width, "height": 844})
        for path in _made(folder):
            view.goto(path.resolve().as_uri())
            wide = view.evaluate("document.documentElement.scrollWidth")
            if wide > width:
                found.append(f"{path.relative_to(folder)}: {wide} pixels")
        made.close()
    return found


def sample(folder: Path) -> list[Path]:
    """Return the pages to examine with axe-core: all, but only the largest in `api`, which two templates make."""
    made = _made(folder)
    reference = [path for path in made if path.parent.name == "api"]
    largest = sorted(reference, key=lambda path: path.stat().st_size)[-REFERENCE_PAGES:]
    return [path for path in made if path not in reference or path in largest]


def inaccessible(folder: Path) -> list[str] | None:
    """Return which elements break WCAG 2.2 level AA in the light or the dark theme; None where there is no browser.

    Parameters
    ----------
    folder : Path
        Of pages in HTML; see `sample`.

    Returns
    -------
    list of str or None
        Page, theme, rule of axe-core and selector.
    """
    if not browser():
        return None
    from playwright.sync_api import sync_playwright

    axe = (files("axe_playwright_python") / "axe.min.js").read_text(encoding="utf-8")
    found = []
    with sync_playwright() as play:
        made = launched(play)
        view = made.new_page(viewport={"width": 1280, "height": 900}, reduced_motion="reduce")
        for path in sample(folder):
            view.goto(path.resolve().as_uri())
            live = view.locator(".live").count() > 0
            if live:
                view.wait_for_selector(".live .lommel-live")
                view.wait_for_function(COMPUTED)
            view.evaluate(axe)
            rules: dict[str, Any] = {"runOnly": ["wcag2a", "wcag2aa"]}
            if live:
                rules["rules"] = {"target-size": {"enabled": True}}
            # Only the rules on colour depend on the theme.
            for theme, chosen in ("light", rules), ("dark", {"runOnly": ["color-contrast", "link-in-text-block"]}):
                for rule, selector in view.evaluate(AXE, [theme, chosen]):
                    found.append(f"{path.relative_to(folder)}, {theme}: {rule}: {selector}")
        made.close()
    return found


def main(folder: Path) -> int:
    """Check a folder of pages, say what is wrong, and return the exit status."""
    wide, barriers = wide_pages(folder), inaccessible(folder)
    if wide is None:
        print(f"no Chromium on PATH nor LOMMEL_BROWSER: width on a phone of {PHONE} pixels and WCAG AA not checked")
    faults = [f"broken link: {each}" for each in broken_links(folder)]
    faults += [f"too wide: {each}" for each in wide or ()] + [f"WCAG AA: {each}" for each in barriers or ()]
    print("\n".join(faults), end="\n" if faults else "")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1])))
