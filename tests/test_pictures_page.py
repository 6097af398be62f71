"""The page of pictures: the code above each draws it, and nothing on it is empty."""

from __future__ import annotations

import re

import matplotlib.pyplot as plt

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
