"""Options that several functions share: what signatures and docstrings show of them, and what is refused."""

from __future__ import annotations

import inspect
from dataclasses import dataclass
from typing import TypedDict, Unpack

import pytest

from lommel.base.options import near, require_known, sentence, shares


class Keywords(TypedDict, total=False):
    """Of a tailor."""

    length: float
    width: float
    colour: str


@dataclass
class Cloth:
    """What a tailor asks.

    Parameters
    ----------
    length, width : float, default 1
        Metres,
        before it is washed.
    colour : str, default "blue"
        Of the cloth.
    thread : str
        Not asked.

    Raises
    ------
    ValueError
        If there is none.
    """

    length: float = 1.0
    width: float = 1.0
    colour: str = "blue"
    thread: str = "cotton"


@shares(Keywords, Cloth, width=2.0)
def sew(pattern: str, *, by: str = "hand", **options: Unpack[Keywords]) -> None:
    """Sew.

    Parameters
    ----------
    pattern : str
    by : str, default "hand"
    {options}

    Notes
    -----
    Slowly.
    """
    require_known(sew, options, Keywords)


@shares(Keywords, Cloth)
class Tailor:
    """Sews.

    Parameters
    ----------
    {options}
    """

    def __init__(self, **options: Unpack[Keywords]) -> None:
        require_known(Tailor, options, Keywords)


def test_a_signature_shows_each_option_with_its_default():
    shown = {name: p.default for name, p in inspect.signature(sew).parameters.items() if p.kind is p.KEYWORD_ONLY}
    assert shown == {"by": "hand", "length": 1.0, "width": 2.0, "colour": "blue"}
    assert inspect.signature(sew).parameters["colour"].annotation == "str"
    assert list(inspect.signature(Tailor).parameters) == ["length", "width", "colour"]


def test_a_docstring_has_the_text_of_the_options_that_are_shared_and_of_no_other():
    assert inspect.getdoc(sew) == (
        'Sew.\n\nParameters\n----------\npattern : str\nby : str, default "hand"\n'
        "length, width : float, default 1\n    Metres,\n    before it is washed.\n"
        'colour : str, default "blue"\n    Of the cloth.\n\nNotes\n-----\nSlowly.'
    )
    assert Tailor.__doc__.count("colour : ") == 1
    assert sentence(Cloth, "width") == "Metres, before it is washed."


def test_what_is_no_option_is_named_with_those_that_are():
    sew("coat", width=1.5, by="machine")
    with pytest.raises(TypeError, match=r"^sew\(\) has no option 'color'; did you mean colour\?$"):
        sew("coat", color="red")
    with pytest.raises(TypeError, match=r"^Tailor\(\) has no option 'x'; known are length, width, colour$"):
        Tailor(x=1)


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("na", "did you mean NA?"),
        ("MAGNIFICATION", "did you mean magnification?"),
        ("zoom", "known are NA, magnification"),
    ],
)
def test_a_name_in_other_letters_is_told_as_it_is_written(name, said):
    assert near(name, ["NA", "magnification"]) == said
