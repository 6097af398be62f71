"""The live page's module, `lommel-live.js`, and pages of HTML around it."""

from __future__ import annotations

import json
from collections.abc import Mapping
from html import escape
from importlib import metadata
from pathlib import Path

from lommel.page.state import link

NAME = "lommel-live.js"
_PAGE = """<!doctype html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<link rel="icon" href="data:,">
<title>{title}</title>
<style>body {{ margin: 0; }}</style>
<body>
<main><script type="module" {source}data-lommel="{state}" data-lommel-heading="1"{more}>{text}</script></main>
</body>
</html>
"""


def path() -> Path:
    """Return the path of the module; FileNotFoundError if it was not built by `make page`."""
    found = Path(__file__).with_name(NAME)
    if not found.is_file():
        raise FileNotFoundError(
            f"the live page's module is not there ({found}): wheels bring it, and in a copy of the sources "
            "`make page` makes it"
        )
    return found


def documentation() -> str:
    """Return the address of the documentation that the installed package names, or an empty string."""
    try:
        addresses = metadata.metadata("lommel").get_all("Project-URL") or []
    except metadata.PackageNotFoundError:
        return ""
    named = (address.partition(", ") for address in addresses)
    return next((url for name, _, url in named if name.lower() == "documentation" and url.startswith("https://")), "")


def html(state: Mapping[str, object], lens: str = "", left_out: str = "", *, alone: bool = False) -> str:
    """Return the HTML of a page that starts in a state, that of the lens of this name, less what is left out of it.

    `alone` it has the module inside, else beside it.
    """
    # Within a script only its end has a meaning; in strings of the module it may be written so too.
    text = path().read_text(encoding="utf-8").replace("</script", "<\\/script") if alone else ""
    source = "" if alone else f"src={json.dumps(NAME)} "
    said = {"name": lens, "without": left_out, "docs": documentation()}
    more = "".join(f' data-lommel-{key}="{escape(value)}"' for key, value in said.items() if value)
    title = escape(lens or "lommel")
    return _PAGE.format(title=title, source=source, state=escape(link(state)), more=more, text=text)
