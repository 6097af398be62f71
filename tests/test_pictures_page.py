"""The page of pictures: the code above each draws it, and nothing on it is empty."""

from __future__ import annotations

import re

import matplotlib.pyplot as plt
import pytest

import drawn
from check import empty_axes


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


def test_the_code_of_readme_draws_its_picture():
    assert not empty_axes(drawn.first_psf())
    assert "(docs/first-psf.png)" in (drawn.PAGE.parents[1] / "README.md").read_text(encoding="utf-8")
    assert (drawn.PAGE.parent / "first-psf.png").exists()


def test_pictures_are_written_as_files(tmp_path):
    page = tmp_path / "page.md"
    page.write_text(
        "```python\nimport matplotlib.pyplot as plt\nplt.plot([0, 1])\n```\n![a](_generated/pictures/one.png)\n",
        encoding="utf-8",
    )
    assert [name for name, _ in drawn.parts(page)] == ["one"]
    drawn.write(tmp_path / "out", [page])
    assert (tmp_path / "out" / "pictures" / "one.png").read_bytes()[:4] == b"\x89PNG"


def test_a_picture_without_code_is_an_error(tmp_path):
    page = tmp_path / "page.md"
    page.write_text("![a](_generated/pictures/one.png)\n", encoding="utf-8")
    with pytest.raises(ValueError, match=r"page\.md: no code above the picture one draws one"):
        list(drawn.parts(page))
