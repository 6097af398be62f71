"""What is looked for on made pages is found, and nothing else."""

from __future__ import annotations

import pytest

import check


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
