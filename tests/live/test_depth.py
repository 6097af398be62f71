"""The lesson on depth: what the module finds beside the package, the computed clip, and the camera."""

from __future__ import annotations

import importlib.util
from collections.abc import Callable, Iterator
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest
import scipy.ndimage
import scipy.signal

import check
import lommel as lm
import scenes
from lommel.imaging.focal_tables import Taps

SMALLER = ("first", "second", "sharp")

ROOT = Path(__file__).resolve().parents[2]
NUMBERS = "[data-depth=numbers]"
# Frames and bytes go as lists; NaN and infinity, which JSON has not, come as null.
START = """async (text) => {
    const url = URL.createObjectURL(new Blob([text], { type: "text/javascript" }));
    const { createCore, Engine } = await import(url);
    globalThis.depths = new Engine(await createCore()).depths;
    globalThis.list = (values) => Array.from(values, (value) => (Number.isFinite(value) ? value : null));
}"""
FOUND = """([first, second]) => {
    const { found, sharp } = depths.found(...[first, second].map((one) => Uint16Array.from(one)));
    return [list(found), list(sharp)];
}"""
PAIR = """([n, light, swapped]) => {
    const { found, sharp, frames, things } = depths.pair(n, light, swapped);
    return { found: list(found), sharp: list(sharp), frames: frames.map(list), things };
}"""
LEAST = """([n, light, swapped]) => {
    const { found, things } = depths.pair(n, light, swapped);
    return { found: list(found), things };
}"""


@pytest.fixture(scope="module")
def web() -> ModuleType:
    """The tables as the page's module was made with them."""
    spec = importlib.util.spec_from_file_location("web_depths", ROOT / "web" / "depths.py")
    assert spec is not None
    assert spec.loader is not None
    made = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(made)
    return made


@pytest.fixture(scope="module")
def engine(module: Path, browser: Any) -> Iterator[Any]:
    """A page with the engine of depth."""
    page = browser.new_page()
    page.evaluate(START, module.read_text(encoding="utf-8"))
    yield page
    page.close()


def maps(found: list[Any], down: int, across: int) -> np.ndarray:
    """Depth, standard error and misfit; NaN where not known."""
    return np.array([np.nan if value is None else value for value in found]).reshape(3, down, across)


def test_depth_is_that_of_python_by_the_same_tables(engine: Any, tmp_path: Path) -> None:
    foci, shape = (1.35, 1.8), (96, 128)
    thin = [scenes.ThinLens(35e-3, 8.0, focus, 540e-9, 4e-6) for focus in foci]
    leaves = scenes.texture("leaves", 128)
    frames = [one[:96] for one in scenes.record(scenes.plane(leaves, thin, 1.5, 3000.0), seed=1)]
    live = lm.imaging.LiveDepth(
        [scenes.lommel_lens(lens) for lens in thin],
        4e-6,
        between=(1.2, 2.0),
        noise=lm.Noise(white=1.0, read=3.0, offset=100.0),
        shape=shape,
        light=3000,
        sharp=True,
    )
    live.save(tmp_path / "tables.lml")
    tables = list((tmp_path / "tables.lml").read_bytes())
    engine.evaluate(
        "([file, height, width]) => depths.camera(Uint8Array.from(file), height, width)", [tables, *shape]
    )
    answers = [engine.evaluate(FOUND, [one.ravel().tolist() for one in frames]) for _ in range(2)]
    assert answers[0] == answers[1]  # to the bit
    mine, theirs = maps(answers[0][0], 24, 32), live(*frames)
    known = np.isfinite(theirs.errors)
    assert known.mean() > 0.7
    assert np.array_equal(np.isfinite(mine[0]), known)
    for one, other in zip(mine, (theirs.depth, theirs.errors, theirs.misfit), strict=True):
        np.testing.assert_allclose(one[known], other[known], rtol=1e-4)
    sharp = np.array(answers[0][1]).reshape(shape)
    np.testing.assert_allclose(sharp, live.sharp(), atol=1e-4 * sharp.mean())


def test_packed_tables_find_the_depth_of_those_of_python(engine: Any, web: ModuleType) -> None:
    engine.evaluate("([bytes, stop]) => depths.open(Uint8Array.from(bytes), stop)", [list(web.packed(8.0)), 8.0])
    for light in (300, 3000):
        answer = engine.evaluate(PAIR, [60, light, False])
        assert answer["found"] == engine.evaluate(LEAST, [60, light, False])["found"]
        mine = maps(answer["found"], 60, 80)
        live = web.live(8.0)
        theirs = live(*[np.array(one, dtype=np.uint16).reshape(web.SHAPE) for one in answer["frames"]])
        both = np.isfinite(mine[0]) & np.isfinite(theirs.errors)
        assert np.mean(np.isfinite(mine[0]) != np.isfinite(theirs.errors)) < 0.005
        off = np.abs(mine[0] - theirs.depth)[both] / theirs.errors[both]
        assert np.percentile(off, 99) < 0.02
        assert np.percentile(np.abs(mine[1] / theirs.errors - 1.0)[both], 99) < 0.05
        sharp = np.array(answer["sharp"]).reshape(web.SHAPE)
        assert np.sqrt(np.mean((sharp - live.sharp()) ** 2)) < 0.01 * light


def inner(things: list[dict[str, Any]]) -> np.ndarray:
    """Which thing is seen by the whole window of a block; -1 near edges."""
    y, x = 4 * np.mgrid[0:60, 0:80] + 2
    owner = np.full((60, 80), len(things) - 1)
    for k, thing in reversed(list(enumerate(things[:-1]))):
        across, down = ((at - thing["middle"][i]) / thing["half"][i] for i, at in enumerate((x, y)))
        owner[np.hypot(across, down) < 1 if thing.get("round") else np.maximum(abs(across), abs(down)) < 1] = k
    even = scipy.ndimage.minimum_filter(owner, 9) == scipy.ndimage.maximum_filter(owner, 9)
    even[:8] = even[-8:] = False
    even[:, :8] = even[:, -8:] = False
    return np.where(even, owner, -1)


def scores(engine: Any, web: ModuleType, stop: float, light: float) -> np.ndarray:
    """Errors over standard errors in the clip, away from edges."""
    engine.evaluate("([bytes, stop]) => depths.open(Uint8Array.from(bytes), stop)", [list(web.packed(stop)), stop])
    made = []
    for n in (5, 110):
        answer = engine.evaluate(LEAST, [n, light, False])
        depth, errors, _ = maps(answer["found"], 60, 80)
        owner = inner(answer["things"])
        truth = np.array([thing["distance"] for thing in answer["things"]])[owner]
        made.append(((depth - truth) / errors)[(owner >= 0) & np.isfinite(depth)])
    return np.concatenate(made)


@pytest.mark.parametrize("stop", [16.0, 11.0, 8.0, 5.6])
def test_depth_of_the_clip_is_off_by_its_standard_error(engine: Any, web: ModuleType, stop: float) -> None:
    z = scores(engine, web, stop, 3000)
    assert len(z) > 2500
    assert abs(np.median(z)) < 0.2
    assert 0.75 < 1.4826 * np.median(np.abs(z - np.median(z))) < 1.1
    assert np.mean(np.abs(z) > 3) < 0.01


def test_the_numbers_of_the_answer_are_those_of_the_package(
    visit: Callable[..., Any], engine: Any, web: ModuleType
) -> None:
    tables = web.live(8.0)._levels[0].engine
    one = tables.channels[0]
    errors = np.interp(1 / np.array([1.5, 1.8, 1.9])[::-1], one.vergence, one.errors)[::-1]
    errors *= one.step / np.sqrt(tables._pixels) * np.array([1.5, 1.8, 1.9]) ** 2
    assert [f"{1e3 * error:.0f}" for error in errors] == ["5", "13", "17"]
    assert f"{2 / (1 / 1.35 + 1 / 1.8):.2f}" == "1.54"
    page = visit("/mounted?lesson=depth")
    answer = page.locator(".lesson details > p:not(.note, :has(math))").text_content()
    said = "f/8 and 3000 electrons the standard error is 5 mm at 1.5 m, but 13 mm at 1.8 m and 17 mm at 1.9 m"
    assert said in " ".join(answer.split())
    # Exchanged pictures fit as well, mirrored in 1 / distance about the middle of the foci.
    engine.evaluate("([bytes, stop]) => depths.open(Uint8Array.from(bytes), stop)", [list(web.packed(8.0)), 8.0])
    right, wrong = (engine.evaluate(LEAST, [60, 3000, swapped]) for swapped in (False, True))
    owner = inner(right["things"])
    (depth, _, misfit), (other, _, worse) = (maps(one["found"], 60, 80) for one in (right, wrong))
    both = (owner >= 0) & np.isfinite(depth) & np.isfinite(other)
    assert both.sum() > 1000
    assert np.median(1 / depth[both] + 1 / other[both]) == pytest.approx(1 / 1.35 + 1 / 1.8, rel=0.01)
    assert np.median(worse[both]) < np.median(misfit[both]) + 0.1 < 1.25


def test_single_frames_are_filtered_as_polynomials_say_and_become_sharper(engine: Any, web: ModuleType) -> None:
    coefficients, taps = web.blur_filters(), Taps.of(5).values
    size, radius = (64, 96), 2.0
    disk = np.hypot(*np.mgrid[-8:8:0.125, -8:8:0.125] + 0.0625) < radius
    points = np.kron(scenes.averaged(scenes.texture("leaves", 96)), np.ones((8, 8)))[: 64 * 8]
    spread = scipy.signal.fftconvolve(points, disk / disk.sum(), mode="same")
    true, frame = (3000 * one.reshape(64, 8, 96, 8).mean(axis=(1, 3)) for one in (points, spread))
    frame = np.random.default_rng(0).poisson(frame).astype(float)
    head, filters = web.depths()[0], web.depths()[1]
    bytes_ = list(filters[-head["sizes"][-1] :])
    sharpen = (
        "([bytes, frame, ...size]) => list(depths.sharpen(Uint8Array.from(bytes), Float32Array.from(frame), ...size))"
    )
    made = np.array(engine.evaluate(sharpen, [bytes_, frame.ravel().tolist(), *size, radius])).reshape(size)
    kernel = np.array([*taps[:0:-1], *taps])
    terms = [frame]
    for m in range(1, coefficients.shape[1]):
        last = terms[-1]
        for axis in (0, 1):
            last = scipy.ndimage.convolve1d(last, kernel, axis=axis, mode="reflect")
        step = 2 * last - terms[-1]
        terms.append(step if m == 1 else 2 * step - terms[-2])
    at = radius / head["largest"] * (head["blurs"] - 1)
    wanted = np.einsum("m,mij->ij", coefficients[round(at)], np.stack(terms))
    assert at == pytest.approx(round(at))
    np.testing.assert_allclose(made, wanted, atol=0.003 * frame.mean())
    assert made.mean() == pytest.approx(frame.mean(), rel=2e-3)
    inside = np.s_[12:-12, 12:-12]
    assert np.std((made - true)[inside]) < 0.8 * np.std((frame - true)[inside])


@pytest.fixture(scope="module")
def filming(browser: Any) -> Iterator[Any]:
    """A Chromium with a camera that shows a pattern."""
    flags = ["--use-fake-device-for-media-stream", "--use-fake-ui-for-media-stream", "--no-sandbox"]
    made = browser.browser_type.launch(executable_path=check.browser(), args=flags)
    yield made
    made.close()


def test_a_camera_is_sharpened_here_and_let_go(filming: Any, site: str) -> None:
    page = filming.new_page()
    requests: list[str] = []
    page.goto(f"{site}/live?lesson=depth")
    page.locator(NUMBERS, has_text="depth known").wait_for()
    page.on("request", lambda request: requests.append(request.url))
    page.get_by_label("Pictures", exact=True).select_option("camera")
    page.locator(NUMBERS, has_text="sharpened in").wait_for()
    assert page.locator(".depth [role=status]").inner_text().startswith("No picture leaves this page")
    assert page.locator("[data-picture=depth]").is_hidden()
    grab = """(name) => { const node = document.querySelector(".lommel-live-host").shadowRoot
        .querySelector(`[data-picture=${name}] canvas`);
        return Array.from(node.getContext("2d").getImageData(0, 0, node.width, node.height).data); }"""
    page.get_by_role("button", name="Pause").click()
    blur = page.get_by_label("Radius of the blur")
    contrasts = []
    for key, wanted in (("Home", "0.0 pixels"), ("End", "6.0 pixels")):
        blur.focus()
        page.keyboard.press(key)
        assert blur.get_attribute("aria-valuetext") == wanted
        page.wait_for_timeout(500)
        taken, sharp = (np.array(page.evaluate(grab, name)).reshape(480, 640, 4) for name in ("first", "sharp"))
        assert taken[..., :3].std() > 20
        contrasts.append(np.diff(sharp[..., 1].astype(float), axis=1).std())
    assert contrasts[1] > 1.2 * contrasts[0]
    page.get_by_label("Pictures", exact=True).select_option("pairs")
    page.locator(NUMBERS, has_text="depth known").wait_for()
    assert requests == []
    page.close()


@pytest.mark.parametrize("locale", ["en-US", "de-DE"])
def test_the_map_is_the_largest_picture_and_all_are_on_the_screen(visit: Callable[..., Any], locale: str) -> None:
    page = visit("/mounted?lesson=depth", viewport={"width": 1366, "height": 768}, locale=locale)
    page.wait_for_timeout(500)
    boxes = {name: page.locator(f'[data-picture="{name}"] canvas').bounding_box() for name in ("depth", *SMALLER)}
    assert all(boxes["depth"]["width"] > 2.5 * boxes[name]["width"] for name in SMALLER)
    assert all(box["y"] + box["height"] <= 768 for box in boxes.values())
    assert boxes["sharp"]["x"] + boxes["sharp"]["width"] > 0.9 * 1366
    assert page.evaluate("document.documentElement.scrollHeight") <= 769
