"""What the documentation is made of: links, pictures, commands and references lead somewhere."""

from __future__ import annotations

import re
import tomllib
from pathlib import Path

import matplotlib.pyplot as plt
import pytest
import yaml

import check
import command_options
import drawn
from check import empty_axes
from lommel.cli.main import COMMANDS


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


def test_each_picture_of_the_page_is_drawn_and_says_what_it_shows(tmp_path):
    shown = re.findall(r"!\[(.+?)\]\(_generated/pictures/([\w-]+)\.png\)", drawn.PAGE.read_text(encoding="utf-8"))
    names = [name for _, name in shown]
    assert len(names) == len(set(names)) >= 12
    made = []
    for name, figure in drawn.parts(drawn.PAGE):
        made.append(name)
        texts = [axes for axes in figure.axes if not axes.axison]  # of sections, which have words in a corner
        for axes in texts:
            axes.set_visible(False)
        assert not empty_axes(figure), name
        assert figure.get_suptitle() or any(
            axes.get_title(place) for axes in figure.axes for place in ("left", "center")
        )
        labels = [axes.get_xlabel() + axes.get_ylabel() for axes in figure.axes]
        assert any(re.search(r"\(.+\)", label) for label in labels), labels
    assert made == names
    assert not plt.get_fignums()


PAGE = (Path(__file__).resolve().parents[1] / "docs" / "command-line.md").read_text(encoding="utf-8")


def test_the_page_includes_the_help_of_every_command(tmp_path):
    listed = re.findall(r"^\| `lommel ([a-z-]+)", PAGE, flags=re.MULTILINE)
    assert listed
    assert set(listed) <= set(COMMANDS)
    assert "```{include} _generated/commands.inc" in PAGE
    command_options.write(tmp_path)
    text = (tmp_path / "commands.inc").read_text(encoding="utf-8")
    assert re.findall(r"^### `lommel ([a-z-]+)`$", text, flags=re.MULTILINE) == sorted(COMMANDS)


ROOT = Path(__file__).resolve().parent.parent
TEXT = (ROOT / "paper.md").read_text(encoding="utf-8")


def test_references_and_bibliography_are_the_same():
    cited = set(re.findall(r"@([a-z]+\d{4})", TEXT))
    entries = re.findall(r"^@\w+\{(\w+),", (ROOT / "paper.bib").read_text(encoding="utf-8"), re.MULTILINE)
    assert sorted(cited) == sorted(entries)


def test_the_head_is_what_journals_read():
    head = yaml.safe_load(TEXT.split("---\n")[1])
    assert {"title", "tags", "authors", "affiliations", "date", "bibliography"} <= head.keys()
    assert (ROOT / head["bibliography"]).is_file()
    names = {str(part["index"]) for part in head["affiliations"]}
    assert {str(author["affiliation"]) for author in head["authors"]} <= names


def test_the_pages_that_it_names_exist():
    assert all((ROOT / name).is_file() for name in re.findall(r"`(docs/[\w.-]+\.md)`", TEXT))


def test_every_theorem_of_the_certificate_names_its_code_and_the_tests_that_sweep_it():
    listed = tomllib.loads((ROOT / "docs" / "theorems.toml").read_text(encoding="utf-8"))["theorem"]
    parts = [part.read_text(encoding="utf-8") for part in sorted((ROOT / "docs").glob("certificate-*.md"))]
    assert all("\n\n**Theorem.** " in part.partition("\n## ")[0] for part in parts)
    sections = [name for part in parts for name in re.findall(r"^## (.+)$", part, re.MULTILINE)]
    assert sorted(theorem["section"] for theorem in listed) == sorted(sections)
    for theorem in listed:
        assert theorem["bounds"]
        for name in (*theorem["code"], *theorem["tests"]):
            assert (ROOT / name).is_file(), (theorem["section"], name)
        assert theorem["tests"]
