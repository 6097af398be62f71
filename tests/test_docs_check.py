"""What is looked for on made pages is found, and nothing else."""

from __future__ import annotations

import shutil
from concurrent.futures import ThreadPoolExecutor

import pytest

import check


def apart(function, *given):
    """Call a function in another thread: a browser of tests/live keeps the event loop of this one."""
    with ThreadPoolExecutor(1) as pool:
        return pool.submit(function, *given).result()


@pytest.fixture
def folder(tmp_path):
    (tmp_path / "_static").mkdir()
    (tmp_path / "_static" / "theme.html").write_text('<a href="{{ nowhere }}">template</a>', encoding="utf-8")
    (tmp_path / "a.html").write_text(
        '<h1 id="here">A</h1><a name="there"></a><a href="#here">1</a><a href="b.html#place%20two">2</a>'
        '<a href="https://elsewhere.invalid/x">3</a><img src="p.png" srcset="p.png, p.png 2x">'
        '<a href="mailto:x@y">4</a>',
        encoding="utf-8",
    )
    (tmp_path / "b.html").write_text('<p id="place two"><a href="a.html#there">back</a>', encoding="utf-8")
    (tmp_path / "p.png").touch()
    return tmp_path


def test_links_within_and_between_pages_that_lead_somewhere_are_no_faults(folder):
    assert check.broken_links(folder) == []


def test_links_to_settings_of_the_live_page_name_its_fields(folder):
    (folder / "live.html").touch()
    page = '<p id="place two"><a href="live.html#rays=on&amp;defocus=3">x</a><a href="live.html#none=1">y</a>'
    (folder / "b.html").write_text(page, encoding="utf-8")
    assert check.broken_links(folder) == ["b.html: live.html#none=1"]


@pytest.mark.parametrize("link", ["#nowhere", "c.html", "b.html#nowhere", "../a.html"])
def test_links_that_lead_nowhere_are_told_with_their_page(link, folder):
    (folder / "b.html").write_text(f'<p id="place two"><a href="{link}">x</a>', encoding="utf-8")
    assert check.broken_links(folder) == [f"b.html: {link}"]


def test_pictures_that_are_missing_are_told(folder):
    (folder / "p.png").unlink()
    assert check.broken_links(folder) == ["a.html: p.png"]


def test_pages_wider_than_a_phone_are_told_where_there_is_a_browser(folder, monkeypatch):
    pytest.importorskip("playwright", reason="playwright is not installed, which drives the browser")
    if not check.browser():
        pytest.skip("there is no Chromium to open pages with")
    assert apart(check.wide_pages, folder) == []
    (folder / "b.html").write_text('<body style="margin:0"><div style="width:600px">x</div>', encoding="utf-8")
    assert apart(check.wide_pages, folder) == ["b.html: 600 pixels"]


PAGE = (
    '<!doctype html><html lang="en"><title>t</title><body style="background:{}"><main><h1>T</h1>'
    '<p style="color:{}">text</p>{}</main></html>'
)


def test_elements_that_break_wcag_are_named_with_page_theme_and_rule(tmp_path):
    pytest.importorskip("playwright", reason="playwright is not installed, which drives the browser")
    pytest.importorskip("axe_playwright_python", reason="axe-core is not installed")
    if not check.browser():
        pytest.skip("there is no Chromium to open pages with")
    styles = "<style>[data-theme=dark] p {color: #333!important} [data-theme=dark] body {background: #000!important}"
    pages = {
        "good": PAGE.format("white", "black", '<img src="p.png" alt="P">'),
        "image": PAGE.format("white", "black", '<img src="p.png">'),
        "light": PAGE.format("white", "#ccc", ""),
        "dark": PAGE.format("white", "black", f"{styles}</style>"),
    }
    for name, text in pages.items():
        (tmp_path / f"{name}.html").write_text(text, encoding="utf-8")
    assert apart(check.inaccessible, tmp_path) == [
        "dark.html, dark: color-contrast: p",
        "image.html, light: image-alt: img",
        "light.html, light: color-contrast: p",
        "light.html, dark: color-contrast: p",
    ]


def test_pages_of_the_reference_are_sampled_and_all_others_are_examined(tmp_path, monkeypatch):
    monkeypatch.setattr(check, "REFERENCE_PAGES", 2)
    (tmp_path / "api").mkdir()
    for name, size in (("api/a", 3), ("api/b", 9), ("api/c", 5), ("x", 1), ("y", 2)):
        (tmp_path / f"{name}.html").write_text("-" * size, encoding="utf-8")
    names = [path.relative_to(tmp_path).as_posix() for path in check.sample(tmp_path)]
    assert names == ["api/b.html", "api/c.html", "x.html", "y.html"]


def test_without_a_browser_the_check_says_that_it_did_not_look(folder, monkeypatch, capsys):
    monkeypatch.delenv("LOMMEL_BROWSER", raising=False)
    monkeypatch.setattr(shutil, "which", lambda name: None)
    assert check.main(folder) == 0
    assert "not checked" in capsys.readouterr().out
    (folder / "p.png").unlink()
    assert check.main(folder) == 1
    assert "broken link: a.html: p.png" in capsys.readouterr().out
