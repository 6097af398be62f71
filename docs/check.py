"""What made pages must hold: axes that show something, links that lead somewhere, no page wider than a phone."""

from __future__ import annotations

import os
import shutil
import sys
from html.parser import HTMLParser
from pathlib import Path
from typing import Any
from urllib.parse import unquote, urlsplit

import numpy as np

PHONE = 390  # pixels, as phones count them
BROWSERS = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable")


def empty_axes(figure: Any) -> list[str]:
    """Return what is written on axes in which nothing is to be seen: without artists, or of a single colour."""
    figure.canvas.draw()
    picture = np.asarray(figure.canvas.buffer_rgba())
    found = []
    for axes in figure.axes:
        left, low, right, high = (round(side) for side in axes.get_window_extent().extents)
        inside = picture[picture.shape[0] - high + 3 : picture.shape[0] - low - 3, left + 3 : right - 3]
        seen = np.ptp(inside.reshape(-1, 4).astype(int), axis=0).any()
        if axes.get_visible() and not (axes.has_data() and seen):
            found.append(f"{axes.get_title()!r}, x {axes.get_xlabel()!r}")
    return found


def scrape(block: Any, block_vars: dict[str, Any], gallery_conf: dict[str, Any], **options: Any) -> str:
    """Take the figures of a block of the gallery, as Sphinx-Gallery does, where all of their axes show something."""
    import matplotlib.pyplot as plt
    from sphinx_gallery.scrapers import matplotlib_scraper

    for figure in map(plt.figure, plt.get_fignums()):
        if empty := empty_axes(figure):
            raise ValueError(f"{block_vars['src_file']}: axes that show nothing: {', '.join(empty)}")
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
            if not target.exists() or (place and target in pages and place not in pages[target].places):
                found.append(f"{path.relative_to(folder.resolve())}: {link}")
    return found


def browser() -> str | None:
    """Return the path of a Chromium of the system, or None."""
    return os.environ.get("LOMMEL_BROWSER") or next((at for name in BROWSERS if (at := shutil.which(name))), None)


def launched(play: Any) -> Any:
    """Return that Chromium, started by Playwright."""
    # Root has no sandbox, as in containers.
    return play.chromium.launch(executable_path=browser(), args=["--no-sandbox"] if os.geteuid() == 0 else [])


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


def main(folder: Path) -> int:
    """Check a folder of pages, say what is wrong, and return the exit status."""
    wide = wide_pages(folder)
    if wide is None:
        print(
            f"no Chromium on PATH nor LOMMEL_BROWSER: whether pages fit a phone of {PHONE} pixels was not looked at"
        )
    faults = [f"broken link: {each}" for each in broken_links(folder)] + [f"too wide: {each}" for each in wide or ()]
    print("\n".join(faults), end="\n" if faults else "")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1])))
