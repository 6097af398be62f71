"""Lessons of the live page: links set their states, steps can be done, numbers of answers are true."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
import pytest
from scipy import optimize, special

import lommel as lm
from live_page import fragment, rest, state
from lommel.page.state import psf_of, pupil_of

LESSONS = ("airy", "quarter", "axis", "contrast", "hubble", "coma")
HUBBLE = {"spherical": 8.14, "f_number": 24, "obscuration": 0.33, "focal_length": 57600}
# What a student does in each lesson, by its steps.
DONE: dict[str, list[list[dict[str, Any]]]] = {
    "airy": [
        [{"stretch": "log"}, {"point": ("profile", 1.22)}],
        [{"length_unit": "um"}, {"f_number": 9}],
        [{"obscuration": 0.33}],
    ],
    "quarter": [
        [{"defocus": 0.1}, {"defocus": 0.26}],
        [{"defocus": 0}, {"spherical": 0.25}],
        [{"spherical": 1}, {"defocus": -1.02}],
    ],
    "axis": [
        [{"defocus": 1}],
        [{"defocus": 1.5}, {"defocus": 2}],
        [{"defocus": 1, "obscuration": 0.5}, {"defocus": 1.33}],
    ],
    "contrast": [[{"defocus": 2}], [{"length_unit": "lambdaN"}, {"point": ("mtf", 0.084)}], [{"defocus": 3}]],
    "hubble": [
        [{"defocus": -5}, {"point": ("energy", 0.1)}],
        [{"defocus": -1}, {"defocus": -10}],
        [{"spherical": 0}, {"defocus": 0}],
    ],
    "coma": [
        [{"defocus": -1}, {"defocus": 1}],
        [{"coma": 0}, {"astigmatism": 0.6}, {"defocus": -1}],
        [{"coma": 0.4}, {"astigmatism": 0.4}],
    ],
}


def point(page: Any, plot: str, at: float) -> None:
    """Move the mouse over a curve to a place on its axis."""
    node = page.locator(f"figure.{plot} svg")
    node.scroll_into_view_if_needed()
    place, end = node.bounding_box(), page.evaluate(END, plot)
    page.mouse.move(place["x"] + 40 + (place["width"] - 50) * at / end, place["y"] + 40)


# The end of the axis of a curve in the unit of its label.
END = """plot => { const { state } = live, { measures } = live.result();
    const lambdaN = 1000 / (state.wavelength * state.f_number);
    const unit = { um: 1, arcsec: 206.264806247 / state.focal_length, lambdaN };
    const [length, { r, f }] = [unit[state.length_unit], measures[plot]];
    return r ? r.at(-1) * length : f.at(-1) * (state.length_unit === "um" ? 1 : 0.001 / length); }"""


def strehl(**waves: float) -> float:
    return float(lm.strehl(pupil_of({"defocus": 0.0} | waves)))


def zero(function: Callable[[float], float], low: float, high: float) -> float:
    return float(optimize.brentq(function, low, high))


def least(function: Callable[[float], float], low: float, high: float) -> float:
    return float(optimize.minimize_scalar(function, bounds=(low, high), method="bounded", options={"xatol": 1e-7}).x)


def airy() -> Iterator[tuple[str, float]]:
    rings = {}
    for obscuration in (0.0, 0.33):
        image = lm.psf(lm.Pupil(obscuration=obscuration), 65, 0.1)
        ring = least(lambda r, image=image: float(image.profile([r])[1][0]), 0.9, 1.5)
        rings[obscuration] = ring, 100 * float(image.encircled_energy(ring))
    (ring, share), (narrow, less) = rings.values()
    yield from (("2.44", 2 * ring), ("5.4", 2 * ring * 0.55 * 4), ("83.8", share), ("16.2", 100 - share))
    yield from (("0.33", 0.33), ("1.10", narrow), ("65.4", less))
    yield "1.22", ring


def quarter() -> Iterator[tuple[str, float]]:
    def moved(shift: float) -> float:
        lens = lm.Lens(focal_length=0.05, f_number=4, sensor_distance=0.05 + shift, wavelength=550e-9)
        return abs(float(lm.strehl(lens.pupil(np.inf)))) - strehl(defocus=0.25)

    best = least(lambda w: -strehl(spherical=1.0, defocus=w), -2, 0)
    balanced = pupil_of({"spherical": 1.0, "defocus": -1.0})
    sigma = float(lm.rms(balanced, unit="waves"))
    shift = zero(moved, 1e-6, 1e-4)
    yield from (("1", -best), ("0.075", sigma), ("13.4", 1 / sigma), ("0.803", float(lm.marechal(balanced))))
    yield from (("0.800", strehl(spherical=1.0, defocus=-1.0)), ("0.800", strehl(spherical=0.25)))
    yield from (("0.811", strehl(defocus=0.25)), ("2", shift / (550e-9 * 4**2)), ("18", 1e6 * shift))


def axis() -> Iterator[tuple[str, float]]:
    for waves in (1, 2, 3):
        assert strehl(defocus=waves) < 1e-12
        yield str(waves), waves
    first = least(lambda w: strehl(defocus=w, obscuration=0.5), 1.1, 1.6)
    assert strehl(defocus=first, obscuration=0.5) < 1e-9
    yield from (("1.5", 1.5), ("0.045", strehl(defocus=1.5)), ("0.5", 0.5), ("0.75", 1 / first), ("1.33", first))
    yield "0.090", strehl(defocus=1, obscuration=0.5)


def contrast() -> Iterator[tuple[str, float]]:
    def transfer(waves: float, frequency: Any) -> Any:
        return lm.otf(lm.Pupil(lm.Wavefront.from_seidel(W020=waves)), frequency).real

    first, second = (zero(lambda f: float(transfer(2, f)), *place) for place in ((0.06, 0.1), (0.14, 0.19)))
    a = float(special.jn_zeros(1, 1)[0])
    unit = 0.55e-3 * 4  # lambda N, mm
    yield from (("2", 2), ("0.084", first), ("0.167", second), ("38", first / unit), ("76", second / unit))
    yield from (("3.83", a), ("0.076", a / (8 * math.pi * 2)), ("3", 3), ("0.051", a / (8 * math.pi * 3)))
    yield "0.054", zero(lambda f: float(transfer(3, f)), 0.04, 0.06)
    yield "11", -100 * float(transfer(2, np.linspace(first, second, 101)).min())
    yield from (("1", 1), ("8", 8), ("020", 20))


def hubble() -> Iterator[tuple[str, float]]:
    def pupil(waves: float) -> lm.Pupil:
        return pupil_of(HUBBLE | {"defocus": waves})

    def within(light: lm.Pupil) -> float:
        return 100 * float(lm.psf(light, 9, 2.5e-6).encircled_energy(57.6 * math.radians(0.1 / 3600)))

    focus = least(lambda w: float(lm.rms(pupil(w))), -12, -6)
    scan = np.arange(-14.0, 0.0, 0.25)
    assert max(within(pupil(w)) for w in scan) < 16.5
    assert max(float(lm.strehl(pupil(w))) for w in scan) < 0.2
    yield from (("9.0", -focus), ("0.48", float(lm.rms(pupil(focus), unit="waves"))), ("0.8", 0.8))
    yield from (("0.075", math.sqrt(-math.log(0.8)) / math.tau), ("0.1", 0.1), ("1993", 1993))
    yield from (("16", within(pupil(-5.33))), ("89", within(pupil(0.0).unaberrated())))


def coma() -> Iterator[tuple[str, float]]:
    def image(**waves: float) -> Any:
        return psf_of({"side": 33, "view": "sampled", "pixel": 1, **waves}).values

    for d in (0.4, 1.0):
        one, other = (image(coma=0.6, defocus=sign * d) for sign in (1, -1))
        assert np.abs(one - other).max() < 1e-6 * one.max()
        one, other = (image(astigmatism=0.6, defocus=sign * d) for sign in (1, -1))
        assert np.abs(one - np.rot90(other)).max() < 1e-6 * one.max()
        assert np.abs(one - other).max() > 0.3 * one.max()
    yield from (("180", 180), ("90", 90), ("0.8", 0.8))
    for name, text in (("coma", "0.21"), ("astigmatism", "0.18")):
        yield text, zero(lambda w, name=name: strehl(**{name: w}) - 0.8, 0.1, 0.4)


@pytest.mark.parametrize("name", LESSONS)
def test_the_numbers_of_an_answer_are_those_of_the_package(visit: Callable[..., Any], name: str) -> None:
    page = visit(f"/?lesson={name}")
    answer = page.locator(".lesson details > p:not(.note, :has(math))").text_content()
    known = list(
        {"airy": airy, "quarter": quarter, "axis": axis, "contrast": contrast, "hubble": hubble, "coma": coma}[name]()
    )
    for text, value in known:
        digits = len(text.partition(".")[2])
        assert abs(float(text) - value) <= 0.5001 * 10**-digits, (text, value)
    said = set(re.findall(r"\d+(?:\.\d+)?", answer))
    assert said <= {text for text, _ in known}
    assert len(said) >= 5


@pytest.mark.parametrize("name", LESSONS)
def test_a_link_opens_a_lesson_whose_steps_can_be_done_in_turn(visit: Callable[..., Any], name: str) -> None:
    page = visit(f"/mounted?lesson={name}")
    lesson = page.locator(".lesson")
    assert lesson.locator(".question").inner_text().endswith("?")
    assert len(lesson.locator(".question").inner_text()) > 30
    details = lesson.locator("details")
    assert details.get_attribute("open") is None
    details.locator("summary").click()
    assert details.locator("math").first.is_visible()
    assert re.search(r"doi:10\.", details.locator(".note").inner_text())
    begun = state(page)
    assert begun["defocus"] == pytest.approx(-5.33 if name == "hubble" else 0, abs=0.005)
    assert lesson.locator("li.done").count() == 0
    assert lesson.locator("li").count() == len(DONE[name])
    for count, changes in enumerate(DONE[name]):
        for change in changes:
            assert lesson.locator("li.done").count() == count, change
            if "point" in change:
                point(page, *change["point"])
            else:
                page.evaluate("change => live.set(change)", change)
            rest(page)
        assert lesson.locator("li.done").count() == count + 1, changes
    page.locator('button[data-action="reset"]').click()
    rest(page)
    assert state(page) == begun


def test_what_is_dragged_in_a_lesson_can_be_shared(visit: Callable[..., Any]) -> None:
    page = visit("/mounted?lesson=coma#defocus=0.75&coma=0.5")
    assert page.get_by_label("Lessons").input_value() == "coma"
    assert (state(page)["defocus"], state(page)["coma"]) == (0.75, 0.5)
    # Also what the lesson sets and the reader takes back.
    page = visit("/mounted?lesson=hubble")
    page.evaluate("live.set({ spherical: 0, defocus: 0.6, length_unit: 'um' })")
    rest(page)
    link = fragment(page)
    assert "spherical=0" in link
    page = visit(f"/mounted?lesson=hubble#{link}")
    assert (state(page)["spherical"], state(page)["defocus"], state(page)["length_unit"]) == (0, 0.6, "um")
    assert state(page)["f_number"] == 24
    page = visit("/mounted?lesson=__proto__")
    assert page.locator(".lesson").is_hidden()
