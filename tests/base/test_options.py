"""Options of functions, notes, optional libraries, and what is registered for things."""

from __future__ import annotations

import inspect
import warnings
from collections.abc import Callable
from dataclasses import dataclass
from typing import Annotated, Any, Literal

import numpy as np
import pytest

import lommel as lm
from lommel.base import optional
from lommel.base.options import In, Options, listed, sentences


@dataclass(frozen=True, kw_only=True)
class Cloth(Options):
    """What a tailor asks.

    Parameters
    ----------
    length, width : float, default 1
        Metres,
        before it is washed.
    colour : str, default "blue"
        Of the cloth, see :func:`lommel.psf`.
    shrink : callable, optional

    Raises
    ------
    ValueError
        If there is none.
    """

    length: Annotated[float, In(above=0.0, unit="metres")] = 1.0
    width: Annotated[float, In(above=0.0, unit="metres")] = 1.0
    colour: Literal["blue", "red"] = "blue"
    shrink: Callable[[float], float] | None = None


@dataclass(frozen=True, kw_only=True)
class Silk(Cloth):
    """What a tailor of silk asks.

    Parameters
    ----------
    colour : str, default "red"
        Dyed.
    shine : bool, default True
    """

    colour: Literal["blue", "red"] = "red"
    shine: bool = True


@listed(Cloth, width=2.0)
def sew(pattern: str, *, by: str = "hand", options: Cloth | None = None, **given: Any) -> Cloth:
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
    return Cloth.of("sew", options, given)


@listed(Silk)
class Tailor:
    """Sews.

    Parameters
    ----------
    {options}
    """

    def __init__(self, *, options: Silk | None = None, **given: Any) -> None:
        self.options = Silk.of("Tailor", options, given)


def test_a_subclass_restates_an_option_in_its_place_and_adds_others():
    shown = [(name, p.default) for name, p in inspect.signature(Tailor).parameters.items()][1:]
    assert shown == [("length", 1.0), ("width", 1.0), ("colour", "red"), ("shrink", None), ("shine", True)]
    assert 'before it is washed.\ncolour : str, default "red"\n    Dyed.\nshrink' in inspect.getdoc(Tailor)
    assert sentences(Silk, "colour") == "Dyed."
    assert sentences(Silk, "width") == "Metres, before it is washed."
    assert sentences(Cloth, "colour") == "Of the cloth, see psf."


def test_a_signature_shows_each_option_with_its_default():
    shown = {name: p.default for name, p in inspect.signature(sew).parameters.items() if p.kind is p.KEYWORD_ONLY}
    assert shown == {"by": "hand", "options": None, "length": 1.0, "width": 2.0, "colour": "blue", "shrink": None}


def test_keywords_change_an_object_which_is_checked_and_stays():
    wide = Cloth(width=3)
    assert sew("coat") == Cloth()
    assert sew("coat", options=wide, colour="red") == Cloth(width=3.0, colour="red")
    assert (wide.width, wide.colour) == (3.0, "blue")
    assert isinstance(wide.width, float)
    with pytest.raises(TypeError, match=r"^options must be a Silk, got Cloth\("):
        Tailor(options=wide)
    with pytest.raises(ValueError, match=r"^width must be > 0 metres, got 0$"):
        sew("coat", width=0.0)
    with pytest.raises(TypeError, match=r"^shrink must be callable, got 3$"):
        sew("coat", shrink=3)


def test_a_note_names_the_line_of_the_caller():
    lens = lm.Lens(focal_length=50e-3, f_number=4.0, focus_distance=2.0, wavelength=550e-9)
    plan = lm.imaging.depth_of_field
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always")
        plan(np.full((20, 30), 0.5), np.full((20, 30), 2500.0), lens, 20e-6, encoding="linear")
        lm.imaging.DepthBlur(np.full((20, 30), 2500.0), lens, 20e-6)
    assert [each.filename for each in told] == 2 * [__file__]
    assert told[1].lineno == told[0].lineno + 1


def test_a_library_that_is_there_and_cannot_be_loaded_is_not_called_missing(tmp_path, monkeypatch):
    (tmp_path / "loaded_by_halves.py").write_text("raise ImportError('m.so: failed to map segment')")
    monkeypatch.syspath_prepend(tmp_path)
    with pytest.raises(ImportError, match=r"^plots need loaded_by_halves, which cannot be loaded: m\.so: failed"):
        optional.library("loaded_by_halves", "plots need", "plot")
    with pytest.raises(ImportError, match=r"^plots need nowhere_at_all: pip install nowhere_at_all \(the extra"):
        optional.library("nowhere_at_all", "plots need", "plot")


class Child(lm.Wavefront):
    pass


@pytest.mark.parametrize("thing", [lm.Pupil(), lm.Wavefront(), Child()])
def test_what_is_registered_for_a_class_is_found_for_those_that_inherit_from_it(thing):
    assert "<table" in thing._repr_html_()
