"""What the live page draws: colours, comparison, rays, noise, read-outs, and figures that it saves."""

from __future__ import annotations

import base64
import io
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from live_page import rest

CANVAS = """name => {
    const root = document.querySelector(".lommel-live-host").shadowRoot;
    return root.querySelector(name).toDataURL().split(",")[1];
}"""
PSF, HELD = ".now canvas", ".held canvas"


def seen(page: Any, name: str = PSF) -> np.ndarray:
    """Return the pixels of a canvas, shape (height, width, 3), from 0 to 255."""
    image = pytest.importorskip("PIL.Image")
    with image.open(io.BytesIO(base64.b64decode(page.evaluate(CANVAS, name)))) as picture:
        return np.asarray(picture.convert("RGB")).astype(float)


def answer(page: Any, name: str) -> np.ndarray:
    """Return an array of the settled PSF."""
    return np.array(page.evaluate(f"Array.from(live.result().psf.{name})"))


def move(page: Any, **change: Any) -> None:
    """Change the state and wait until everything is drawn."""
    page.evaluate("change => live.set(change)", change)
    rest(page)


def hold(page: Any, **change: Any) -> None:
    """Hold the present setting as A, and change B."""
    page.get_by_role("button", name="Hold as A").click()
    move(page, **change)


def place(page: Any, name: str = ".now .place") -> str:
    """Return the read-out, with plain minus signs."""
    assert page.locator(name).first.is_visible()
    return page.locator(name).first.inner_text().replace("−", "-")


def bar_label(page: Any) -> str:
    return page.locator(".of").inner_text()


def linear(levels: np.ndarray) -> np.ndarray:
    """Return linear light of sRGB levels, IEC 61966-2-1."""
    x = levels / 255
    return np.where(x <= 0.04045, x / 12.92, ((x + 0.055) / 1.055) ** 2.4)


# Colours


@pytest.mark.parametrize("stretch", ["linear", "sqrt", "log"])
def test_white_light_has_true_colours_whose_hue_no_stretch_changes(visit: Callable[..., Any], stretch: str) -> None:
    page = visit(f"/mounted#side=96&light=white&defocus=0.3&stretch={stretch}")
    planes = answer(page, "colour").reshape(3, 96, 96).transpose(1, 2, 0)
    image = seen(page)
    light = linear(image)
    most = planes.max(axis=2)
    share = np.maximum(most, 1e-30)
    wanted = {"linear": share, "sqrt": np.sqrt(share), "log": np.maximum(0, 1 + np.log10(share) / 5)}[stretch]
    assert np.abs(image.max(axis=2) / 255 - wanted).max() < 0.01
    bright = wanted > 0.2
    hue = planes[bright] / most[bright][:, None]
    assert np.abs(light[bright] / light[bright].max(axis=1, keepdims=True) - np.maximum(hue, 0)).max() < 0.03
    assert np.ptp(hue, axis=1).max() > 0.3  # rings are coloured
    assert "true colour" in bar_label(page)
    move(page, map="gray")
    assert np.ptp(seen(page), axis=2).max() == 0
    assert "true colour" not in bar_label(page)


# Comparison


def test_a_and_b_are_drawn_on_one_scale_or_each_on_its_own(visit: Callable[..., Any]) -> None:
    page = visit("/mounted#side=64&defocus=0&map=gray&stretch=linear&view=sampled&pixel=1")
    hold(page, defocus=0.5)
    strehl = page.evaluate("live.result().measures.strehl")
    middle = [image.shape[0] // 2 for image in (seen(page, HELD), seen(page))]
    assert seen(page, HELD)[middle[0], middle[0], 0] == 255
    assert seen(page)[middle[1], middle[1], 0] == pytest.approx(255 * strehl, abs=1.5)
    assert "of A and B" in bar_label(page)
    page.get_by_label("Scale of A and B").select_option("own")
    assert seen(page)[middle[1], middle[1], 0] == 255
    assert seen(page, HELD)[middle[0], middle[0], 0] == 255
    assert "of each" in bar_label(page)
    page.get_by_role("button", name="Let go").click()
    assert bar_label(page) == "of the brightest point"


def test_the_difference_is_white_where_a_is_b_and_signed_elsewhere(visit: Callable[..., Any]) -> None:
    page = visit("/mounted#side=64&defocus=0&stretch=linear")
    hold(page)
    page.get_by_label("How to compare").select_option("difference")
    neutral = seen(page)
    assert np.ptp(neutral.reshape(-1, 3), axis=0).max() == 0
    assert np.ptp(neutral[0, 0]) < 8
    move(page, defocus=0.5)
    image = seen(page)
    red, blue = image[32, 32, 0] - image[32, 32, 2], image[..., 0] - image[..., 2]
    assert red < -40  # B is darker on the axis, which is blue,
    assert blue.max() > 20  # and brighter around it, which is red
    assert page.locator(".frame.held").is_hidden()
    assert "B minus A" in bar_label(page)
    assert page.locator(".ticks").inner_text().count("−") == page.locator(".ticks").inner_text().count("+") > 0


def test_a_has_the_sampling_the_window_and_the_pixel_of_b(visit: Callable[..., Any]) -> None:
    page = visit("/mounted#side=64&view=sampled&pixel=1&coma=0.5&stretch=linear")
    hold(page, side=96, view="averaged", pixel=3)
    page.get_by_label("How to compare").select_option("difference")
    # One lens by one set of pixels is without difference, in the picture and in all numbers.
    assert np.ptp(seen(page).reshape(-1, 3), axis=0).max() == 0
    numbers = page.locator(".numbers small").all_inner_texts()
    assert numbers == ["as A"] * 5
    page.get_by_label("How to compare").select_option("beside")
    page.get_by_label("Scale of A and B").select_option("own")
    move(page, defocus=2, coma=0)
    assert page.locator(".frame.held.late").count() == 0
    text = page.locator(".held canvas").get_attribute("aria-label")
    alone = visit("/mounted#side=96&view=averaged&pixel=3&coma=0.5&stretch=linear")
    assert text == "A. " + alone.locator(PSF).get_attribute("aria-label")
    light = seen(page, HELD).sum(axis=2)
    assert np.unique(light).size == np.unique(seen(alone).sum(axis=2)).size
    # It goes back with the lens, and keeps the sampling.
    page.get_by_role("button", name="Exchange").click()
    rest(page)
    now = page.evaluate("live.state")
    assert [now[key] for key in ("coma", "defocus", "pixel", "view", "side")] == [0.5, 0.6, 3, "averaged", 96]


# Numbers


def test_all_light_is_never_said_to_be_in_a_window_that_misses_some(visit: Callable[..., Any]) -> None:
    page = visit("/mounted#defocus=0&f_number=5&view=sampled&pixel=10")
    inside = page.locator('dd[data-number="inside"]')
    assert inside.inner_text() == "99.980 %"
    move(page, side=64)
    assert inside.inner_text() == "99.8 %"
    # Of these only the pixels next to the axis are computed; the light is that of the whole window.
    move(page, side=512, pixel=50, view="averaged", coma=1, vanes=3)
    assert inside.inner_text().startswith("99.99")
    move(page, side=1024, pixel=200, f_number=1, vanes=0, coma=0)
    assert inside.inner_text() == "99.999902 %"


def test_a_zero_on_the_axis_is_below_the_proven_error_and_never_negative(visit: Callable[..., Any]) -> None:
    page = visit("/mounted#side=64&defocus=1")
    for defocus in (1, 2, 3):
        move(page, defocus=defocus)
        text = page.locator('dd[data-number="strehl"]').inner_text()
        assert re.fullmatch(r"< \de-\d+", text), text
        assert float(text[2:]) >= page.evaluate("live.result().measures.strehl_error")
        for node in (PSF, ".plots"):
            said = page.locator(node).first.evaluate("node => node.outerHTML")
            assert "e-1" not in said.replace("e-10", "")
    with page.expect_download() as caught:
        page.locator('[data-action="csv"]').click()
    lines = Path(caught.value.path()).read_text().splitlines()
    assert any(re.fullmatch(r"# strehl_on_axis=< \de-\d+", line) for line in lines)
    cells = [cell for line in lines if re.match(r"[-\d]", line) for cell in line.split(",") if cell]
    assert min(map(float, cells)) >= 0


# Read-outs


def test_the_value_under_the_pointer_is_that_of_the_array(visit: Callable[..., Any]) -> None:
    page = visit("/mounted#side=64&view=sampled&pixel=1&defocus=0.4&coma=0.3")
    size = seen(page).shape[0]
    box = page.locator(PSF).bounding_box()
    column, row = size // 2 + 2, size // 2 - 1
    page.mouse.move(box["x"] + (column + 0.5) * box["width"] / size, box["y"] + (row + 0.5) * box["height"] / size)
    text = place(page)
    found = re.fullmatch(r"x, y = (\S+), (\S+) µm: (\S+) of the brightest, (\S+) of the unaberrated peak ± \S+", text)
    assert found, text
    assert (float(found[1]), float(found[2])) == (2, -1)
    values = answer(page, "values").reshape(64, 64)
    measures = page.evaluate("({ ...live.result().measures, peak: live.result().psf.peak })")
    value = values[32 - 1, 32 + 2]
    assert float(found[3]) == pytest.approx(value / values.max(), rel=6e-3)
    assert float(found[4]) == pytest.approx(value / values.max() * measures["peak_strehl"], rel=6e-3)
    page.mouse.move(5, 5)
    assert page.locator(".now .place").is_hidden()


# Rays and noise


def test_rays_lie_where_the_geometry_has_them(visit: Callable[..., Any]) -> None:
    page = visit("/mounted#side=128&defocus=3")
    assert page.locator(".now .rays").is_hidden()
    move(page, rays="on")
    assert page.locator(".now .rays").is_visible()
    assert page.get_by_text("rays (geometrical optics)").is_visible()
    places = re.findall(r"M([\d.]+) ([\d.]+)", page.locator(".now .rays path").last.get_attribute("d"))
    x, y = (np.array(places, dtype=float) / 1000 - 64.5 / 128).T * 128 * page.evaluate("live.result().psf.pixel")
    reach = np.hypot(x, y).max()
    # 2 N times the slope of the wavefront, 2 W020 lambda rho, of marginal rays.
    assert reach == pytest.approx(2 * 4 * 2 * 3 * 0.55, rel=0.01)


def test_noise_is_drawn_as_electrons(visit: Callable[..., Any]) -> None:
    page = visit("/mounted#side=64&view=averaged&pixel=2&noise=on&photons=5000&map=gray&stretch=linear")
    counts = answer(page, "counts").reshape(64, 64)
    assert bar_label(page) == "electrons per pixel"
    ticks = [float(text) for text in page.locator(".ticks span").all_inner_texts()]
    assert 0.5 * counts.max() < ticks[-1] <= counts.max() * 1.05
    image = seen(page)
    crop = image.shape[0]
    first = 32 - crop // 2
    wanted = np.clip(counts[first : first + crop, first : first + crop] / counts.max(), 0, 1) * 255
    assert np.abs(image[..., 0] - wanted).max() < 2
    # Counted photons have no colour.
    move(page, light="white", map="auto")
    assert bar_label(page) == "electrons per pixel"
    assert np.ptp(seen(page), axis=2).max() == 0


# Figures


def longest(marked: np.ndarray) -> np.ndarray:
    """Return the indices of the longest run of True."""
    runs = np.split(np.arange(marked.size), np.flatnonzero(np.diff(marked)) + 1)
    return max((run for run in runs if marked[run[0]]), key=len, default=np.array([]))


def figure(page: Any) -> Any:
    image = pytest.importorskip("PIL.Image")
    with page.expect_download() as caught:
        page.locator('[data-action="png"]').click()
    with image.open(io.BytesIO(Path(caught.value.path()).read_bytes())) as picture:
        picture.load()
        return picture.text["Description"], np.asarray(picture.convert("RGB")).astype(int)


def test_the_png_is_a_figure_with_scale_bar_colour_bar_and_title(visit: Callable[..., Any]) -> None:
    page = visit("/mounted#side=64&defocus=0.25&map=viridis")
    text, picture = figure(page)
    assert text == "defocus=0.25&side=64&map=viridis"
    height, width, _ = picture.shape
    assert width >= 1024 + 64
    assert height > width
    assert (picture[:40] == 255).all()
    assert (picture[:, :40] == 255).all()
    assert (picture[50:100].min(axis=(0, 2)) < 128).any()  # the title
    # The panel, whose viridis is never white, between white rows.
    rows = longest((picture[:, width // 2 + 100] < 250).any(axis=1))
    assert len(rows) >= 1024
    # The scale bar: a white line as long as its text says.
    ruler = page.locator(".ruler span").inner_text().split()[0]
    field = 64 * page.evaluate("live.result().psf.pixel")
    white = (picture[rows[0] + 900 : rows[0] + 1020, 60 : width - 60] == 255).all(axis=2)
    assert max(len(longest(row)) for row in white) == pytest.approx(float(ruler) / field * 1024, abs=3)


def test_contrast_below_its_error_is_not_said_to_be_zero(visit: Callable[..., Any]) -> None:
    page = visit("/mounted#spherical=2&defocus=4&coma=1&astigmatism=1&trefoil=1&light=white&vanes=6")
    said = page.locator(".curve.mtf .readout").inner_text()
    error = page.evaluate("live.result().measures.mtf.error")
    assert error > 0
    assert re.search(r"MTF (x )?< 0\.00\d", said), said
    assert not re.search(r"(MTF|[xy]|pixel) 0(?!\.)", said), said
