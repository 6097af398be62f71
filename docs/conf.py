"""Sphinx configuration; see `make docs`."""

from __future__ import annotations

import re
import shutil
import sys
import warnings
from pathlib import Path
from typing import Any

import lommel
from lommel.page import server

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "tools" / "docs"))

import api  # noqa: E402
import command_options  # noqa: E402
import drawn  # noqa: E402
import format_table  # noqa: E402
import instrument_tables  # noqa: E402
import organisation  # noqa: E402
import thumbnails  # noqa: E402

# The reference and what pages include are written from the code: diagrams, figures, options, and the live page of
# `make page`.
api.write(HERE)
organisation.write(HERE / "_generated")
drawn.write(HERE / "_generated")
command_options.write(HERE / "_generated")
format_table.write(HERE / "_generated")
instrument_tables.write(HERE / "_generated")
(HERE / "_generated" / "live").mkdir(exist_ok=True)
shutil.copy(server.path(), HERE / "_generated" / "live")

project = "lommel"
author = "the lommel authors"
copyright = author  # noqa: A001
version = release = lommel.__version__

extensions = [
    "myst_parser",
    "numpydoc",
    "sphinx.ext.autodoc",
    "sphinx.ext.autosummary",
    "sphinx_copybutton",
    "sphinx_gallery.gen_gallery",
    "sphinx-mathjax-offline",
]
source_suffix = {".md": "markdown", ".rst": "restructuredtext"}
exclude_patterns = ["_build", "gallery/**/*.ipynb", "gallery/**/*.py", "gallery/**/*.md5", "sg_execution_times.rst"]
templates_path = ["_templates"]
myst_enable_extensions = ["amsmath", "colon_fence", "deflist", "dollarmath"]
myst_heading_anchors = 3

# A name in single backquotes is code; no reference is guessed from it.
default_role = "code"
nitpicky = True
autosummary_generate = True
# On file systems without case, psf would overwrite PSF.
autosummary_filename_map = {"lommel.psf": "lommel.psf-function"}
autodoc_member_order = "bysource"
autodoc_typehints = "none"
numpydoc_show_class_members = False

sphinx_gallery_conf = {
    "examples_dirs": "../examples/gallery",
    "gallery_dirs": "gallery",
    "filename_pattern": r"\.py$",
    "subsection_order": [
        f"../examples/gallery/{part}" for part in ("cameras", "depth", "microscopes", "telescopes", "class")
    ],
    "within_subsection_order": "FileNameSortKey",
    "backreferences_dir": "gallery/uses",
    "doc_module": ("lommel",),
    "image_scrapers": ("check.scrape",),
    "image_srcset": ["2x"],
    "capture_repr": (),
    "abort_on_example_error": True,
    "download_all_examples": False,
    "show_memory": False,
    "show_signature": False,
    "write_computation_times": False,
}

html_theme = "pydata_sphinx_theme"
html_title = f"lommel {release}"
html_static_path = ["_static", "_generated/live"]
html_css_files = ["lommel.css"]
html_show_sourcelink = False
# Pages that belong to no section need no list of those beside them.
html_sidebars: dict[str, list[str]] = {page: [] for page in ("index", "live", "versions")}
copybutton_exclude = ".linenos, .gp, .go"
html_copy_source = False
html_theme_options = {
    "navbar_align": "left",
    "navbar_end": ["theme-switcher"],
    "navigation_with_keys": False,
    "collapse_navigation": True,
    "header_links_before_dropdown": 10,
    "footer_start": ["copyright"],
    "footer_end": [],
    "secondary_sidebar_items": ["page-toc"],
    "show_prev_next": False,
    "pygments_light_style": "a11y-high-contrast-light",
    "pygments_dark_style": "a11y-high-contrast-dark",
}

# What a script warns of is an error here as in the tests.
warnings.filterwarnings("error", module=r"lommel(\.|$)")


def read_comments(_app: Any, _docname: str, source: list[str]) -> None:
    """Make directives of comments, which code hosts hide: index entries, and code beside its picture."""
    for comment, directive in (
        (r"index: (.*)", r"```{index} \1\n```"),
        ("beside", ":::{container} beside"),
        ("end of beside", ":::"),
    ):
        source[0] = re.sub(f"^<!-- {comment} -->$", directive, source[0], flags=re.MULTILINE)


def leave_out(_app: Any, docname: str, source: list[str]) -> None:
    """Remove pages that other targets write from the table of contents if they do not exist."""
    if docname == "inside":
        for page in ("paper", "benchmarks"):
            if not (HERE / f"{page}.md").exists():
                source[0] = source[0].replace(f"{page}\n", "")


def index_again(*_: Any) -> list[str]:
    """Read the page inside.md again at every build, since it depends on which pages exist."""
    return ["inside"]


def name_summaries(_app: Any, _page: str, _template: str, context: dict[str, Any], _doctree: Any) -> None:
    """Name the buttons that open lists in the sidebar, which the theme leaves without a text."""
    made = context.get("generate_toctree_html")

    def named(*arguments: Any, **options: Any) -> Any:
        tree = made(*arguments, **options)
        for summary in tree.find_all("summary") if hasattr(tree, "find_all") else ():
            summary["aria-label"] = f"Pages of {summary.find_previous('a').get_text()}"
        return tree

    context["generate_toctree_html"] = named


def setup(app: Any) -> None:
    """Connect to Sphinx."""
    app.connect("builder-inited", lambda _: thumbnails.place(HERE / "gallery"), priority=900)  # after the gallery
    app.connect("html-page-context", name_summaries, priority=900)  # after the theme
    app.connect("env-get-outdated", index_again)
    app.connect("source-read", leave_out)
    app.connect("source-read", read_comments)
