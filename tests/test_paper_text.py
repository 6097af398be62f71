"""The text for a journal: every reference is in its bibliography, and none there is without a place."""

from __future__ import annotations

import re
from pathlib import Path

import yaml

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
