"""What the live page draws: colours, comparison, rays, noise, read-outs, and figures that it saves."""

from __future__ import annotations

import base64
import io
import itertools
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from live_page import rest, slider

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


def test_one_wavelength_is_in_inferno_unless_another_map_is_chosen(visit: Callable[..., Any]) -> None:
    page = visit("/mounted#side=64&defocus=0")
    assert list(seen(page)[32, 32]) == [252, 255, 164]
    move(page, map="viridis")
    assert list(seen(page)[32, 32]) == [253, 231, 37]


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


def test_the_difference_of_one_lens_over_two_grids_is_small(visit: Callable[..., Any]) -> None:
    page = visit("/mounted#side=512&defocus=0.6&stretch=linear")
    hold(page, side=384)
    page.get_by_label("How to compare").select_option("difference")
    # Ticks are the largest difference over the brightest point: that of straight lines between samples.
    largest = max(float(text.lstrip("+−")) for text in page.locator(".ticks span").all_inner_texts())
    assert largest < 0.003


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


def test_an_a_that_the_sampling_of_b_would_take_long_for_is_let_go_in_words(visit: Callable[..., Any]) -> None:
    page = visit("/mounted#side=64&coma=8&defocus=10&light=white")
    page.get_by_role("button", name="Hold as A").click()
    move(page, coma=0, light="mono")
    assert page.locator(HELD).is_visible()
    move(page, view="averaged", pixel=50, side=512)
    said = page.locator(".notice").inner_text()
    assert said.startswith("A was let go, for with this sampling it cannot be computed: it would take too long.")
    assert page.locator(HELD).is_hidden()
    assert page.locator('dd[data-number="strehl"]').inner_text() != "–"


def test_a_is_shown_by_a_button_while_both_are_in_turn(visit: Callable[..., Any]) -> None:
    page = visit("/mounted#side=64", reduced_motion="reduce")
    hold(page, defocus=2)
    page.get_by_label("How to compare").select_option("flicker")
    page.wait_for_timeout(1000)
    assert page.locator(HELD).is_hidden()
    page.get_by_role("button", name="Show A").click()
    assert page.locator(HELD).is_visible()
    assert page.locator(PSF).is_hidden()
    page.get_by_role("button", name="Show B").click()
    assert page.locator(PSF).is_visible()


def test_a_keeps_its_curves_and_its_picture_on_the_sensor(visit: Callable[..., Any]) -> None:
    page = visit("/mounted#side=64&astigmatism=0.5&pixel=3")
    assert page.locator("path.held").count() == 0
    a = seen(page, ".picture canvas")
    hold(page, astigmatism=0, defocus=3)
    curves = page.locator(".curve", has_text="MTF").locator("path.held")
    assert curves.count() == 2
    assert curves.nth(0).get_attribute("d") != curves.nth(1).get_attribute("d")
    b = seen(page, ".picture canvas")
    page.get_by_label("through A").check()
    page.wait_for_timeout(500)
    assert np.array_equal(seen(page, ".picture canvas"), a)
    page.get_by_label("through A").uncheck()
    assert np.array_equal(seen(page, ".picture canvas"), b)
    assert not np.array_equal(a, b)


def test_differences_of_shares_are_in_points(visit: Callable[..., Any]) -> None:
    page = visit("/mounted#side=64&view=sampled&pixel=1&defocus=0")
    inside = page.evaluate("live.result().measures.inside")
    hold(page, defocus=1)
    by = 100 * (page.evaluate("live.result().measures.inside") - inside)
    text = page.locator('dd[data-number="inside"] small').inner_text()
    found = re.fullmatch(r"([+−])([\d.]+) points from A", text)
    assert found, text
    assert float(found[1].replace("−", "-") + found[2]) == pytest.approx(by, abs=0.06)


# Numbers


def test_a_window_that_is_not_computed_whole_is_said(visit: Callable[..., Any]) -> None:
    page = visit("/mounted#side=512&view=sampled&vanes=4&defocus=0")
    computed = page.locator(".computed")
    assert computed.inner_text() == "computed: 64 × 64 of 512 × 512 pixels"
    assert page.evaluate("live.result().psf.side") == 64
    move(page, vanes=0)
    assert computed.is_hidden()
    move(page, view="fine", coma=0.3)
    assert computed.is_hidden()
    track = slider(page, "coma").bounding_box()
    page.mouse.move(track["x"] + 0.2 * track["width"], track["y"] + 0.5 * track["height"])
    page.mouse.down()
    page.mouse.move(track["x"] + 0.3 * track["width"], track["y"] + 0.5 * track["height"], steps=4)
    # In one look: the words are gone as soon as the whole picture is there.
    computed.filter(has_text="while it moves 256 × 256 samples").wait_for(state="visible")
    page.mouse.up()
    rest(page)
    assert computed.is_hidden()


def test_why_no_error_is_proven_is_said_and_where_one_is_the_pointer_reads_it(visit: Callable[..., Any]) -> None:
    page = visit("/mounted#side=64")
    for vanes in (0, 3):
        move(page, vanes=vanes)
        assert page.locator(".why").count() == (vanes > 0)
        page.locator(PSF).hover()
        text = place(page)
        bound = page.evaluate("live.result().psf.bound")
        assert (bound is None) == (vanes > 0)
        found = re.search(r" of the unaberrated peak ± (\de-\d+)$", text)
        assert bool(found) == (vanes == 0), text
        if found:
            assert bound <= float(found[1]) <= 2.1 * bound
    assert page.locator(".why dd").inner_text().startswith("No bound is proven with vanes: ")


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


def test_arrow_keys_move_a_cursor_over_the_psf_and_the_wavefront(visit: Callable[..., Any]) -> None:
    page = visit("/mounted#side=64&view=sampled&pixel=1&defocus=0.4&length_unit=lambdaN")
    page.locator(PSF).focus()
    page.keyboard.press("ArrowRight")
    assert place(page).startswith("x, y = 0, 0 λN: 1 of the brightest")
    page.keyboard.press("ArrowRight")
    page.keyboard.press("ArrowDown")
    step = 1 / (0.55 * 4)
    found = re.match(r"x, y = (\S+), (\S+) λN", place(page))
    assert [float(found[1]), float(found[2])] == pytest.approx([step, step], rel=5e-3)
    assert page.locator(".now .place").get_attribute("aria-live") == "polite"
    page.keyboard.press("Escape")
    assert page.locator(".now .place").is_hidden()
    page.locator(".small canvas").first.focus()
    page.keyboard.press("ArrowUp")
    found = re.fullmatch(r"x, y = (\S+), (\S+) of the radius: (\S+) waves", place(page, ".spot .place"))
    assert found
    page.keyboard.press("Shift+ArrowRight")
    x, y, waves = re.fullmatch(
        r"x, y = (\S+), (\S+) of the radius: (\S+) waves", place(page, ".spot .place")
    ).groups()
    assert float(waves) == pytest.approx(0.4 * (float(x) ** 2 + float(y) ** 2), abs=2e-3)


def test_a_touch_reads_the_value(visit: Callable[..., Any]) -> None:
    page = visit("/mounted#side=64", has_touch=True, viewport={"width": 390, "height": 844})
    box = page.locator(PSF).bounding_box()
    page.touchscreen.tap(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    assert "of the unaberrated peak" in place(page)


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


def test_the_png_of_a_comparison_has_both(visit: Callable[..., Any]) -> None:
    page = visit("/mounted#side=64&rays=on")
    _, one = figure(page)
    hold(page, defocus=2)
    text, both = figure(page)
    assert "defocus=2" in text
    assert both.shape[1] > 2 * 1024 > one.shape[1]
    page.get_by_label("How to compare").select_option("difference")
    assert figure(page)[1].shape[1] == one.shape[1]


def test_noise_is_shown_by_pixels_of_the_sensor(visit: Callable[..., Any]) -> None:
    page = visit("/mounted#side=64&photons=1000")
    page.locator('select[data-key="noise"]').select_option("on")
    rest(page)
    assert page.evaluate("live.state.view") == "averaged"
    assert bar_label(page) == "electrons per pixel"
    move(page, view="fine")
    assert bar_label(page).endswith("without noise: that is of the sensor's pixels")


def test_differences_below_the_assumed_error_are_none_where_none_is_proven(visit: Callable[..., Any]) -> None:
    page = visit("/mounted#side=64&vanes=3&defocus=0.6")
    page.locator('[data-action="hold"]').click()
    move(page, defocus=0.6000002)
    assert page.locator('[data-number="strehl"] small').inner_text() == "as A"
    move(page, defocus=0.6002)
    assert page.locator('[data-number="strehl"] small').inner_text().endswith("from A")


def test_fringes_that_the_picture_does_not_resolve_are_grey(visit: Callable[..., Any]) -> None:
    said = {}
    for waves in (5, 172):
        page = visit(f"/mounted#side=64&defocus={waves}")
        said[waves] = page.locator(".pupils .note").last.inner_text()
    assert said[5] == "no central obscuration"
    assert said[172] == "grey: too many fringes to draw"
    edge = page.locator('canvas[aria-label^="Pupil"]').evaluate(
        "node => Array.from(node.getContext('2d').getImageData(node.width - 8, node.width / 2 - 8, 4, 16).data)"
    )
    assert max(edge[::4]) - min(edge[::4]) < 3
    assert 100 < edge[0] < 160


def test_frequencies_of_the_star_are_marked_at_their_radius(visit: Callable[..., Any]) -> None:
    page = visit("/mounted#side=64&pixel=1")
    marks = page.locator(".rings text").evaluate_all(
        "all => all.map((node) => [node.textContent, node.getAttribute('x')])"
    )
    assert marks.pop()[0] == "cycles/mm"
    assert [name for name, _ in marks] == ["50", "100"]
    for name, place in marks:  # 36 cycles around, so many micrometres from the middle
        assert float(place) - 192 == pytest.approx(36 / (2 * 3.14159265) / (float(name) * 1e-3), rel=1e-6)
    page.get_by_label("Picture", exact=True).select_option("text")
    page.locator(".rings").wait_for(state="hidden")


def test_side_by_side_holds_the_tail_of_either(visit: Callable[..., Any]) -> None:
    page = visit("/mounted#defocus=0&coma=1.5&coma_angle=0")
    hold(page, coma=0)
    page.get_by_label("Scale of A and B").select_option("own")
    for name in (PSF, HELD):
        picture = seen(page, name).sum(axis=2)
        picture = picture - picture.min()
        edge = np.concatenate([picture[0], picture[-1], picture[:, 0], picture[:, -1]])
        assert edge.max() < 0.12 * picture.max(), name
    # The field of A's tail, of which B alone shows less.
    wide = page.evaluate("2 * live.result().measures.energy.r.at(-1)")
    text = page.locator(".ruler span").inner_text().split()[0]
    share = float(page.locator(".ruler i").evaluate("node => node.style.width").rstrip("%")) / 100
    assert float(text) / share > 1.5 * wide / 2**0.5
    # Outside of its own window B has no values.
    area = page.locator(PSF).bounding_box()
    page.mouse.move(area["x"] + 3, area["y"] + 3)
    assert place(page) == "beyond the window of B"


def test_legends_name_both_settings(visit: Callable[..., Any]) -> None:
    page = visit("/mounted#side=64&coma=0.3")
    legend = page.locator("figure.mtf .legend")
    assert legend.inner_text().split("\n") == ["x", "y", "with pixel", "limit"]
    hold(page, coma=0.6)
    assert legend.inner_text().split("\n") == ["A x", "A y", "B x", "B y", "with pixel", "limit"]
    assert page.locator("figure.profile .legend").inner_text().split("\n") == [
        "A",
        "B: mean over angle",
        "unaberrated",
    ]


@pytest.mark.parametrize("photons", [10000, 14000, 17000, 20000, 1e6])
@pytest.mark.parametrize("width", [390, 680, 1366])
def test_labels_of_the_bar_do_not_overlap(visit: Callable[..., Any], photons: float, width: int) -> None:
    telescope = "defocus=0&coma=0.5&f_number=5&obscuration=0.25&vanes=4&pixel=3.76&view=averaged&noise=on&side=64"
    page = visit(f"/mounted#{telescope}&stretch=sqrt&photons={photons}", viewport={"width": width, "height": 768})
    bar = page.locator(".ticks").bounding_box()
    places = sorted((node.bounding_box() for node in page.locator(".ticks span").all()), key=lambda box: box["x"])
    assert len(places) > 2
    assert all(a["x"] + a["width"] < b["x"] for a, b in itertools.pairwise(places))
    assert places[-1]["x"] + places[-1]["width"] <= bar["x"] + bar["width"] + 1


def test_arrow_keys_read_the_mtf_at_round_frequencies(visit: Callable[..., Any]) -> None:
    page = visit("/mounted#side=64&defocus=0")
    page.locator(".curve.mtf .plot").focus()
    page.keyboard.press("Shift+ArrowLeft")
    said = []
    for _ in range(13):
        page.keyboard.press("ArrowLeft")
        said.append(page.locator(".curve.mtf .readout").inner_text())
    assert any(text.startswith("100 cycles/mm: x, y") for text in said), said


def test_contrast_below_its_error_is_not_said_to_be_zero(visit: Callable[..., Any]) -> None:
    page = visit("/mounted#spherical=2&defocus=4&coma=1&astigmatism=1&trefoil=1&light=white&vanes=6")
    said = page.locator(".curve.mtf .readout").inner_text()
    error = page.evaluate("live.result().measures.mtf.error")
    assert error > 0
    assert re.search(r"MTF (x )?< 0\.00\d", said), said
    assert not re.search(r"(MTF|[xy]|pixel) 0(?!\.)", said), said


def test_numbers_of_a_wavefront_that_is_refused_are_not_those_before(visit: Callable[..., Any]) -> None:
    refusing = """const { postMessage } = Worker.prototype;
    Worker.prototype.postMessage = function (message) {
      const refused = message.arguments[0].defocus === 13;
      postMessage.call(this, refused ? { ...message, method: "refuse" } : message);
    };"""
    page = visit("/mounted#side=64&coma=0.5", before=refusing)
    assert page.get_by_text(re.compile(r"\d waves P–V")).count() == 1
    move(page, defocus=13)
    assert page.get_by_text(re.compile(r"\d waves P–V")).count() == 0
