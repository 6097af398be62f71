"""README and documentation pages: their code and commands run, and their figures are right."""

from __future__ import annotations

import json
import re
import shlex
import shutil
import tomllib
import warnings
from contextlib import chdir, nullcontext
from importlib.util import find_spec
from itertools import chain, dropwhile, pairwise
from pathlib import Path
from typing import Any

import matplotlib as mpl
import matplotlib.pyplot as plt
import numpy as np
import pytest
import tifffile
from astropy.io import fits
from PIL import Image
from scipy.signal import fftconvolve
from scipy.special import j0

import api
import drawn
import lommel as lm
import organisation
import simulated_movies
import simulated_stacks
import slanted_edges
from benchmarks import accuracy, report
from command_lines import help_lines, lommel
from frameworks import hasty_programs
from lommel.estimation import field_fit
from lommel.methods import MatrixFourier
from lommel.microscopy import depth_model, refinement
from lommel.page import server
from lommel.paper import ClosedForm, Fraunhofer
from video_files import write_video

ROOT = Path(__file__).resolve().parent.parent
PAGES = [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted((ROOT / "docs").glob("*.md"))]
# Packages that the pages speak of and the environment of the tests has not.
ELSEWHERE = ("torch", "optiland", "pylops", "pyxu", "deepinv", "photutils", "napari", "galsim")

_TEXT = (".py", ".pyi", ".md", ".ipynb", ".toml", ".js", ".html")

# What takes seconds as the pages have it is run with less: a smaller blur, fewer layers, turbulence of one strength.
LESS = {
    "apertures": [("1.7, 2.5)", "1.99, 2.02)")],
    "colour": [("rgb = lm.colour_psf(lens.pupil(1.5)", "rgb = lm.colour_psf(lens.pupil(1.95)")],
    "scale": [("n_workers=2", "n_workers=1")],
    "sensor": [("(1.0, 3.0, 10.0)", "(1.0,)")],
    "start-camera": [("achromat.pupil(1.95), 65", "achromat.pupil(1.95), 17"), ("(3, 65, 65)", "(3, 17, 17)")],
    "training": [
        ("= 300, 8, 40, 12", "= 2, 2, 40, 2"),
        ("(BATCH, 12,", "(BATCH, 2,"),
        ("range(12)", "range(2)"),
        ("(WIDTH, 1), (WIDTH, WIDTH), (WIDTH, WIDTH)", "(WIDTH, 1)"),
    ],
    "deconvolve": [
        ("microscope, depth=6e-6)", "microscope, depth=6e-6, method=lm.imaging.RichardsonLucy(steps=4))"),
        ("steps=5", "steps=2"),
    ],
    "differentiable": [
        ("lens, [1.0, 4.0], 3.45e-6, jnp", "lens, [1.98, 2.02], 3.45e-6, jnp"),
        ("(1.5, 1.7)", "(1.59, 1.61)"),
    ],
    "field": [
        ("field.grid(5, 7,", "field.grid(2, 3,"),
        ("grid[0, 6]", "grid[0, 2]"),
        ("(120, 160)", "(48, 64)"),
        ("blur.window(0, 159)", "blur.window(0, 63)"),
        ("(120, 180, 3)", "(60, 90, 3)"),
    ],
}


def blocks(path: Path, language: str) -> list[tuple[str, str]]:
    """Return the blocks of a language, each on its own line numbers, and which line it begins at."""
    text = path.read_text(encoding="utf-8")
    found = re.finditer(rf"^```{language}\n(.*?)^```", text, flags=re.MULTILINE | re.DOTALL)
    lines = [(text.count("\n", 0, block.start()) + 1, block[1]) for block in found]
    return [("\n" * line + code, f"{path.name}:{line}") for line, code in lines]


def commands(path: Path) -> list[str]:
    """Return the command lines of a page, in README.md also those within the text and its table."""
    within = re.findall(r"`(lommel [^`]+)`", path.read_text(encoding="utf-8")) if path.name == "README.md" else []
    return within + [line for code, _ in blocks(path, "sh") for line in code.replace("\\\n", " ").splitlines()]


# Whose commands and code take measured data, which benchmarks/real_data.py fetches: see test_real_data.py.
MEASURED = ROOT / "docs" / "real-data.md"
SHOWN = [(path.name, line) for path in PAGES if path != MEASURED for line in commands(path)]
SHOWN += [("--help", line) for line in help_lines()]
LINES = [(name, words) for name, line in SHOWN if (words := shlex.split(line, comments=True))]


# Examples that `lommel examples` copies, by the small lens files of the tests that stand for them.
COPIES = {
    "phone.toml": "lens.toml",
    "nifty-fifty.toml": "lens.toml",
    "hubble-1990.toml": "hubble.toml",
    "newtonian-off-axis.toml": "newtonian.toml",
    "camera-field.toml": "camera.toml",
    "zeiss-63x-1.4-oil.toml": "objective.toml",
    "fitted.toml": "objective.toml",
    "embryo.ome.tif": "stack.ome.tif",
    "zeiss-63x-astigmatic.toml": "examples/objectives/zeiss-63x-astigmatic.toml",
    "nikon-60x-1.2-water.toml": "examples/objectives/nikon-60x-1.2-water.toml",
}


TELESCOPE = """[lens]
wavelength = "550 nm"
focal_length = "800 mm"
f_number = 8.0
focus_distance = inf
obscuration = 0.3
[object]
distance = inf
[sensor]
pixel = "4.4 um"
shape = 17
"""


@pytest.fixture(scope="module")
def files(tmp_path_factory) -> Path:
    """The files that the pages name, as small as they may be, in a folder of their own."""
    place = tmp_path_factory.mktemp("files")
    with chdir(place):
        write_files(place)
    return place


def write_files(place: Path) -> None:
    """Write them in the folder, which is the current one."""
    (place / "examples" / "lenses").mkdir(parents=True)
    (place / "examples" / "objectives").symlink_to(ROOT / "examples" / "objectives")
    for path in (ROOT / "examples" / "lenses").glob("*.toml"):
        small = re.sub(r"^shape = \d+$", "shape = 17", path.read_text(encoding="utf-8"), flags=re.MULTILINE)
        (place / "examples" / "lenses" / path.name).write_text(small, encoding="utf-8")
    lenses = {"lens": "phone", "hubble": "hubble-1990", "camera": "camera-field", "newtonian": "newtonian-off-axis"}
    for name, lens in lenses.items():
        (place / f"{name}.toml").symlink_to(Path("examples") / "lenses" / f"{lens}.toml")
    objective = (ROOT / "examples" / "objectives" / "zeiss-63x-1.4-oil.toml").read_text(encoding="utf-8")
    (place / "objective.toml").write_text(objective.replace("shape = 128", "shape = 17"), encoding="utf-8")
    y, x = np.mgrid[:64, :64]
    image = np.where((x // 8 + y // 8)[..., None] % 2, (200, 120, 40), (60, 140, 220)).astype(np.uint8)
    photo, exif = Image.fromarray(image), Image.Exif()
    exif[0x8769] = {0x829D: 1.8, 0x920A: 4.0}  # f-number and focal length, millimetres
    photo.save("photo.jpg", exif=exif)
    photo.save("photo.png")
    for name in ("photo", "raw"):
        photo.save(f"{name}.tif")
    texture = np.random.default_rng(0).integers(0, 256, (25, 25)).astype(np.uint8)
    for name, corner in (("shot-1", 0), ("shot-2", 3)):
        Image.fromarray(texture).resize((225, 225)).crop((corner, 0, 200 + corner, 200)).save(f"{name}.tif")
    star = np.exp(-0.5 * (np.arange(-8.0, 9.0) / 1.5) ** 2)
    Image.fromarray((200.0 * star[:, None] * star).astype(np.uint8)).save("star.tif")
    distance = np.where(x < 32, 1.9, 2.1)
    tifffile.imwrite("depth.tif", distance.astype(np.float32))
    Image.fromarray((1e3 * distance).astype(np.uint16)).save("depth.png")
    for name in ("photos", "depths"):
        (place / name).mkdir()
    photo.save("photos/a.png")
    tifffile.imwrite("depths/a.tif", distance.astype(np.float32))
    ranges = next(code for code, _ in blocks(ROOT / "docs" / "datasets.md", "toml"))
    (place / "lenses.toml").write_text(ranges, encoding="utf-8")
    bent = next(code for code, _ in blocks(ROOT / "docs" / "field.md", "toml") if "# bent.toml" in code)
    (place / "bent.toml").write_text(bent, encoding="utf-8")
    v, u = np.mgrid[-1:1:33j, -1:1:33j]
    np.save("opd.npy", 1e-7 * (u * u + v * v))
    np.save("measured.npy", u * u + v * v < 0.9)
    listing = "Listing of Zernike Fringe Coefficient Data\nWavelength : 0.6328 µm\nRMS (to chief) : 0.1 waves\n"
    terms = {4: 0.25, 9: -0.1}
    listing += "".join(f"Z {k:3d}\t {terms.get(k, 0.0)}\n" for k in range(1, 10))
    Path("zemax.txt").write_text(listing, encoding="utf-16")
    heights = [0.0, 0.5e-3, 1e-3]
    field = lm.Wavefront.zernike({4: [0.0, 0.1, 0.3]}, order="noll", unit="waves", wavelength=550e-9)
    lm.FieldMap.radial(heights, field, wavelength=550e-9, f_number=1.8).save("field.csv")
    lm.save_zernike("table.csv", lm.Wavefront(defocus=1.0, nonradial={(3, 1): 0.4}))
    molecules = simulated_movies.spread(3, 48, each=1, apart=20, seed=1)
    mean = simulated_movies.light(molecules, 3, 48, 5.0)
    camera = lm.Noise(white=0.46, read=1.6, offset=100.0)
    tifffile.imwrite("dark.tif", np.full((48, 48), 100, np.uint16))
    tifffile.imwrite("movie.tif", simulated_movies.recorded(mean, camera, 1), photometric="minisblack")
    simulated_stacks.write(Path("stack.ome.tif"), planes=9)
    seen = lm.load_microscope("objective.toml")
    astigmatic = lm.Wavefront.zernike({6: 0.5}, order="noll")
    planes = {
        "depth": 1e-7,
        "z": [-4e-7, -2e-7, 0.0, 2e-7, 4e-7],
        "wavelength": seen.wavelength,
        "aberrations": astigmatic,
    }
    bead = 2e4 * lm.psf(seen.objective.pupil(**planes), 15, seen.pixel).values + 5.0
    beads = lm.Noise(read=1.6, offset=100.0).record(bead, seed=1)
    tifffile.imwrite("bead.tif", np.round(beads).astype(np.uint16), photometric="minisblack")
    planes |= {"depth": 5e-8, "z": 1e-7 * (np.arange(9.0) - 4.0)}
    bead = 1e4 * lm.psf(seen.objective.pupil(**planes), 17, seen.pixel).values + 5.0
    beads = lm.Noise(read=1.6, offset=100.0).record(bead, seed=2)
    Path("2026-12-01").mkdir()
    for name in ("beads", "field-1", "field-2", "2026-12-01/green"):
        tifffile.imwrite(f"{name}.tif", np.round(beads).astype(np.uint16), photometric="minisblack")
    planes |= {"z": 2.5e-7 * (np.arange(9.0) - 4.0)}
    bead = 1e4 * lm.psf(seen.objective.pupil(**planes), 17, seen.pixel).values + 5.0
    voxel = {"PhysicalSizeX": 0.1032, "PhysicalSizeY": 0.1032, "PhysicalSizeZ": 0.25}
    tifffile.imwrite("beads.ome.tif", np.round(bead).astype(np.uint16), metadata={"axes": "ZYX", **voxel})
    lens = lm.load_instrument("lens.toml")
    light = lens.pupil()
    aberrated = light.wavefront + lm.Wavefront([-4.0, -3.0, 0.0, 3.0, 4.0], spherical=0.5)
    light = lm.Pupil(aberrated, wavelength=light.wavelength, f_number=light.f_number)
    stars = lm.psf(light, 33, lens.pixel).values
    Path("telescope.toml").write_text(TELESCOPE, encoding="utf-8")
    telescope = lm.load_instrument("telescope.toml")
    aberrated = telescope.pupil().carrying(lm.Wavefront(5.0, nonradial={(3, 1): 0.6}), None)
    donut = lm.psf(aberrated, 33, telescope.pixel).values
    sky = np.full((4, 140, 140), 20.0)
    for row, column in np.ndindex(3, 3):
        part = np.s_[:, 40 * row + 10 : 40 * row + 43, 40 * column + 10 : 40 * column + 43]
        sky[part] += 4e4 * np.stack([*stars[1:4], donut])
    y, x = (np.arange(5 * (side + 32)) / 5.0 - 16.0 for side in (88, 112))
    lines = [np.clip(5.0 * 26.0 / np.pi * np.sin(np.pi * (part - 9.0) / 26.0), -0.5, 0.5) for part in (y, x)]
    board = 0.5 + 2.0 * np.outer(*lines)
    blurred = lm.Pupil(lm.Wavefront(0.8), wavelength=light.wavelength, f_number=light.f_number)
    seen = fftconvolve(board, lm.psf(blurred, 121, lens.pixel / 5.0).values, mode="same")[80:-80, 80:-80]
    chart = 500.0 + 4500.0 * seen.reshape(88, 5, 112, 5).mean((1, 3))
    tifffile.imwrite(
        "chart.tif", lm.Noise(read=2.0).record(chart, seed=1).astype(np.float32), photometric="minisblack"
    )
    ring = telescope.pupil().carrying(lm.Wavefront(15.0, nonradial={(3, 1): 0.6}), None)
    ring = 2e5 * lm.psf(ring, 64, telescope.pixel, blur=lm.Jitter(4e-6), tol=1e-4).values + 20.0
    fits.PrimaryHDU(lm.Noise(read=2.0).record(ring, seed=3).astype(np.float32)).writeto("donut.fits")
    squares = slanted_edges.squares((150, 220), [(0.0, 0.0)], 90.0, 0.8)
    seen = np.rint(250.0 * np.clip(squares, 0.0, 1.0) ** (1.0 / 2.2)).astype(np.uint8)
    for suffix in ("png", "tif"):
        Image.fromarray(seen).save(f"squares.{suffix}")
    write_video(place / "edge.mkv", [seen[:96, :128]] * 2)
    colours = np.tile([[0.6, 1.0], [1.0, 0.7]], (squares.shape[0] // 2, squares.shape[1] // 2))  # RGGB
    tifffile.imwrite("mosaic.tif", np.rint(50000.0 * colours * squares).astype(np.uint16), photometric="minisblack")
    names = "inside", "stars", "outside", "donuts"
    for name, exposure in zip(names, lm.Noise(read=2.0).record(sky, seed=2), strict=True):
        fits.PrimaryHDU(exposure.astype(np.float32)).writeto(f"{name}.fits")
    stars = 3e4 * stars[[0, 2, 4]]
    for k, image in enumerate(np.round(lm.Noise(read=2.0).record(stars + 20.0, seed=1))):
        tifffile.imwrite(f"star-{k}.tif", np.maximum(image, 0.0).astype(np.uint16))
    tifffile.imwrite("spot.tif", np.round(stars[1] + 20.0).astype(np.float32))
    table = next(code for code, _ in blocks(ROOT / "docs" / "colour.md", "text"))
    (place / "sensor.csv").write_text(table.lstrip(), encoding="utf-8")
    (place / "cut.csv").write_text("wavelength (nm),transmission (%)\n380,98\n620,95\n680,2\n", encoding="utf-8")
    texture = np.random.default_rng(0).random((64, 80))
    for k, name in enumerate(("near", "far")):
        blurred = texture + np.roll(texture, 1, axis=k) + np.roll(texture, -1, axis=k)
        tifffile.imwrite(f"{name}.tif", (blurred / 4.0).astype(np.float32))
        pair = [(64.0 * each).astype(np.uint8) for each in (texture + 1.0, blurred)]
        write_video(place / f"{name}.mkv", [pair[k]] * 3)
    camera, scene = lm.load_instrument("lens.toml"), np.random.default_rng(1).random((192, 192))
    scene = sum(np.roll(scene, k, axis=(0, 1)) for k in range(3)) / 3.0
    for k, distance in enumerate((0.6, 1.5), 1):
        for seed, (name, focus) in enumerate((("near", 0.5), ("far", 2.0))):
            lens = camera.lens.focused(focus)
            seen = lm.imaging.depth_of_field(
                scene, np.full(scene.shape, distance), lens, camera.pixel, encoding="linear"
            ).values
            noisy = lm.Noise(white=1e4, read=3.0).record(1e4 * np.maximum(seen, 0.0), seed=2 * k + seed) / 1e4
            tifffile.imwrite(f"{name}-{k}.tif", noisy.astype(np.float32))
    for name in ("both.mkv", "both.mp4", "clip.mp4"):
        write_video(place / name, pair * 2, codec="mpeg4", stored="yuv420p")


@pytest.fixture
def folder(files, tmp_path, monkeypatch) -> Path:
    """A copy of these files, in the folder that tests run in."""
    shutil.copytree(files, tmp_path, symlinks=True, dirs_exist_ok=True)
    monkeypatch.chdir(tmp_path)
    # Which way the planes of a stack run is found after fewer steps, and misfits after one search.
    monkeypatch.setattr(refinement, "_STEPS", 4)
    for name, most in (("_MIN_HALF", 5), ("_MAX_HALF_PLANES", 5), ("_MAX_HALF_PIXELS", 7)):
        monkeypatch.setattr(depth_model, name, most)  # smaller PSFs
    monkeypatch.setattr(field_fit, "_MAX_SEARCHES", 1)
    # The live page, which need not be made, is served until Ctrl-C.
    (tmp_path / server.NAME).write_text("export default {};\n", encoding="utf-8")
    monkeypatch.setattr(server, "path", lambda: tmp_path / server.NAME)
    monkeypatch.setattr("webbrowser.open", lambda url: url.startswith("http://127.0.0.1:") or pytest.fail(url))
    monkeypatch.setattr("lommel.page.server.PageServer.serve_forever", interrupted)
    return tmp_path


def interrupted(_: object) -> None:
    raise KeyboardInterrupt


ALONE = ("scale",)  # pages whose blocks each run as a script in an empty folder
HASTY = ("differentiable", "training")  # pages whose programs run once or twice
CODE = [path for path in PAGES if blocks(path, "python") and path not in (MEASURED, *drawn.TUTORIALS)]


@pytest.mark.parametrize("path", CODE, ids=lambda path: path.stem)
def test_the_code_of_a_page_runs_from_top_to_bottom(path, folder, capsys, monkeypatch):
    names: dict[str, Any] = {}
    less = dict(LESS.get(path.stem, ()))
    assert all(much in path.read_text(encoding="utf-8") for much in less)
    for code, where in blocks(path, "python"):
        imported = re.findall(r"^(?:from|import) (\w+)", code, re.MULTILINE)
        if missing := [name for name in ELSEWHERE if name in imported and find_spec(name) is None]:
            assert len(missing) == 1
            continue
        for much, little in less.items():
            code = code.replace(much, little)
        if path.stem in ALONE:
            names = {"__name__": "__main__"}
            (empty := folder / where.rpartition(":")[2]).mkdir()
            monkeypatch.chdir(empty)
        with warnings.catch_warnings(), hasty_programs() if path.stem in HASTY else nullcontext():
            if any(name in code for name in ELSEWHERE):
                warnings.simplefilter("ignore")  # what they warn of is not ours
            exec(compile(code, where, "exec"), names)
        plt.close("all")
    if path.stem == "my-microscope":
        found = names["found"]
        assert f"found.message  # {found.message}\n" in path.read_text(encoding="utf-8")
        assert np.isnan(found.errors["sample"])
    if path.stem == "imaging":
        taken = names["photograph"].values
        assert taken.dtype == np.uint8
        # The object in focus is as it was, and the stripes behind it are gone.
        assert np.abs(taken[25:55, 45:75].astype(int) - (40, 120, 60)).max() <= 1
        assert np.ptp(taken[30, :30]) < 10 < np.ptp(names["image"][:, 0])


def command_here(lines: str, where: str) -> str:
    """Do in this process what a shell does with calls of `lommel`, and return what they print."""
    printed = []
    for line in lines.replace("\\\n", " ").splitlines():
        words = shlex.split(line, comments=True)
        if words:
            assert words[0] == "lommel", where
            files = [sorted(map(str, Path().glob(word))) if "*" in word else [word] for word in words[1:]]
            result = lommel(*chain.from_iterable(files))
            assert result.returncode == 0, result.stderr
            printed.append(result.stdout)
    return "".join(printed)


def test_code_that_is_not_run_is_python():
    shown = [block for path in PAGES for block in blocks(path, r"\{code-block\} python")]
    assert len(shown) > 2
    for code, where in shown:
        compile(code, where, "exec")


@pytest.mark.parametrize("path", drawn.TUTORIALS, ids=lambda path: path.stem)
def test_code_and_commands_of_a_tutorial_run_in_an_empty_folder_and_print_and_draw(path, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("COLUMNS", "92")
    if path.stem != "start":  # one as the documentation does, in a shell
        monkeypatch.setattr(drawn, "command", command_here)
    text = path.read_text(encoding="utf-8")
    for much, little in LESS.get(path.stem, ()):
        assert much in text
        text = text.replace(much, little)
    made = dict(drawn.parts(path, text))
    shown = [code.lstrip("\n") for code, _ in blocks(path, "text")]
    assert [name for name, each in made.items() if isinstance(each, str)] == shown
    assert set(made) - set(shown) == set(re.findall(r"(?:_generated/pictures|\(start)/([\w-]+)\.", text))
    for name in drawn.kept(path):
        # Drawn anew the picture is that beside the page, but for how versions of Matplotlib set type.
        drawn.save(made[name], tmp_path / f"{name}-again.png")
        kept = drawn.KEPT / f"{name}.png"
        assert kept.stat().st_size < 150_000
        with Image.open(kept) as old, Image.open(tmp_path / f"{name}-again.png") as new:
            assert np.abs(np.subtract(old.size, new.size)).max() <= 0.05 * max(old.size)
            small = [np.asarray(each.convert("RGB").resize((96, 96)), dtype=float) for each in (old, new)]
        # Pictures beside the pages are of the newest version.
        assert np.abs(small[0] - small[1]).mean() < (2.0 if mpl.__version_info__ >= (3, 11) else 8.0)
    for name, each in made.items():
        if isinstance(each, str):
            assert drawn.same(name, each), each
        elif isinstance(each, Path):
            assert each.stat().st_size > 1000


MISFITS = {"deconvolve", "depth", "localize", "restore", "watch"}
# Those of the tutorials run above.
TESTED = sorted(
    {
        shlex.join(words)
        for name, words in LINES
        if words[0] == "lommel" and name not in {path.name for path in drawn.TUTORIALS}
    }
)


@pytest.mark.parametrize("line", TESTED, ids=TESTED)
def test_a_command_of_the_pages_or_of_help_runs_and_writes_what_it_names(line, folder, call_lommel, monkeypatch):
    words = shlex.split(line)
    if words[1] == "--install-completion":  # which writes into the home folder, for the user's shell
        monkeypatch.setenv("HOME", str(folder))
        monkeypatch.setenv("SHELL", "/bin/bash")
    if words[1] == "paper":
        pytest.skip("takes half a minute; see test_paper.py")
    for name in COPIES.keys() & set(words):
        shutil.copyfile(folder / COPIES[name], folder / name)
    if words[1] == "deconvolve" and "--steps" not in words:
        words += ["--steps", "4", "--no-diagnosis"]  # which takes many steps
    result = call_lommel(*words[1:], folder=folder)
    # Photographs and clips are checkerboards that no lens has made, movies not of the objective, and few steps do not
    # reach the noise of a stack: verdicts say so.
    assert result.returncode in ((0, 3, 4) if words[1] in MISFITS else (0, 4)), result.stderr
    for option, name in pairwise(words):
        if option in ("-o", "--plot", "--figure", "--save"):
            assert (folder / name.replace("%03d", "001")).exists(), name


def test_other_commands_of_the_pages_are_targets_of_make_and_extras_of_the_package():
    targets = set(re.findall(r"^([a-z-]+):", (ROOT / "Makefile").read_text(encoding="utf-8"), flags=re.MULTILINE))
    extras = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]["optional-dependencies"]
    for name, line in LINES:
        words = list(dropwhile(lambda word: re.match(r"[A-Z]+=", word), line))  # variables of the environment
        if words[0] == "make":
            assert words[1] in targets, (name, words)
        elif words[0] == "pip":
            assert words[1] == "install", (name, words)
            for extra in re.findall(r"\[(\w+)\]", words[2]):
                assert extra in extras, (name, words)
        elif words[0] in ("git", "cd"):
            assert words[:2] in (["git", "clone"], ["cd", "lommel"]), (name, words)
        elif words[0] == "cmake":
            built = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
            options = re.findall(r"-D(\w+)=", " ".join(words))
            assert options
            assert all(f"option({option} " in built for option in options), (name, words)
        elif words[0] in ("cc", "c++"):  # tests/core/test_live_pipe.py runs them
            assert all((ROOT / word).exists() for word in words if word.endswith((".c", ".cpp"))), (name, words)
        elif words[0].startswith("./"):
            assert (ROOT / "examples" / "c" / f"{words[0][2:]}.c").exists(), (name, words)
        elif words[0] != "lommel":
            assert words[0] == ".venv/bin/python", (name, words)
            assert words[1] == "-m" or (ROOT / words[1]).exists(), (name, words)


def test_nothing_tells_readers_to_install_a_name_that_is_in_no_registry_yet():
    # Whoever registers the name first would run code on their machines; a built clone, or its address, is safe.
    sources = [
        path for folder in ("src", "examples") for path in (ROOT / folder).rglob("*.*") if path.suffix in _TEXT
    ]
    for path in [*PAGES, *sources]:
        text = " ".join(re.sub(r"^#", " ", path.read_text(encoding="utf-8"), flags=re.MULTILINE).split())
        for command in re.findall(r"pip install [^`\n]{0,80}", text):
            named = re.search(r"(?<![\w./])lommel\b(?:\[[\w,]*\])?+(?! @ git)", command.partition("#")[0])
            assert not named or "(the extra" in command, (path, command)


def test_the_telescope_of_the_page_about_field_maps_runs_as_it_is_and_with_vanes(folder, call_lommel):
    sections = [code for code, _ in blocks(ROOT / "docs" / "my-camera.md", "toml")]
    plain, vanes = sections[1:3]
    seen = []
    for text in (plain, plain + vanes):
        (folder / "own.toml").write_text(text, encoding="utf-8")
        pupil = lm.load_instrument(folder / "own.toml").pupil()
        seen.append(pupil.area)
        assert pupil.obscuration == 0.3
    assert seen[1] < seen[0]
    (folder / "own.toml").write_text(plain, encoding="utf-8")
    options = ("--defocus", 5, "--degree", 1, "--read", 2)
    result = call_lommel("fit-field", "donuts.fits", "own.toml", *options, folder=folder)
    assert result.returncode == 0, result.stderr
    assert result.stdout.startswith("converged: ")


def number(cell: str) -> float:
    """The number of a cell such as 2.0e-4 or 21 %."""
    return 0.01 * float(cell.removesuffix("%")) if cell.endswith("%") else float(cell)


def error_table() -> dict[str, list[str]]:
    """The cells of the table of errors in docs/choose.md, by row and without its first column."""
    text = (ROOT / "docs" / "choose.md").read_text(encoding="utf-8")
    rows = re.findall(r"^\| (-?\d+, \d+) \| (.*) \|$", text, flags=re.MULTILINE)
    return {name: cells.split(" | ") for name, cells in rows}


def test_the_bound_in_one_case_adds_up_to_that_of_the_psf_and_holds():
    text = (ROOT / "docs" / "bound.md").read_text(encoding="utf-8")
    names: dict[str, Any] = {}
    for code, where in blocks(ROOT / "docs" / "bound.md", "python"):
        exec(compile(code, where, "exec"), names)
    pupil, sampled = names["pupil"], {"integrate": False}
    assert names["bound"] == pytest.approx(names["psf"].error_bound, rel=1e-5)
    # Gauss's rule in place of all that the page speaks of; 4 pi is the integral of |U|^2 over the plane of v.
    t, weights = np.polynomial.legendre.leggauss(400)
    step = np.pi * 0.5e-6 / pupil.scale
    radii, places = np.unique(step * np.hypot(*(np.indices((101, 101)) - 50.0)), return_inverse=True)
    phases = 0.5 * weights * np.exp(1j * pupil.wavefront.defocus * (t + 1.0))
    exact = np.abs(j0(np.outer(radii, np.sqrt(0.5 * (t + 1.0)))) @ phases)[places].reshape(101, 101) ** 2
    exact *= step**2 / (4.0 * np.pi)
    single = lm.psf(pupil, 101, 0.5e-6, **sampled)
    errors = [np.abs(psf.values - exact).max() / exact.max() for psf in (names["psf"], single)]
    tight = lm.psf(pupil, 101, 0.5e-6, tol=1e-9, dtype="float64", **sampled)
    numbers = names["series"], names["pieces"], single.error_bound, lm.psf(pupil, 101, 0.5e-6).error_bound
    shown = [f"{numbers[0]:.4e}", f"{numbers[1]:.3e}", *(f"**{number:.2e}**" for number in numbers[2:])]
    for number in (*shown, *(f"{error:.1e}" for error in (*errors, names["nodes"], tight.error_bound))):
        assert number in text, number
    assert errors[0] < names["psf"].error_bound


def test_the_errors_of_methods_without_a_bound_are_those_of_the_table():
    table = error_table()
    assert list(table) == ["0, 0", "3, 0", "10, 0", "20, 0", "-5, 8"]
    for row, cells in table.items():
        defocus, spherical = map(float, row.split(","))
        pupil = lm.Pupil(lm.Wavefront(defocus, spherical))
        truth = lm.psf(pupil, 64, 0.25, method="hankel", dtype="float64")
        ways = (MatrixFourier(256), Fraunhofer(256), ClosedForm(), ClosedForm.best(pupil, 64, 0.25))
        for cell, method in zip(cells, ways, strict=True):
            error = lm.peak_error(lm.psf(pupil, 64, 0.25, method=method, dtype="float64"), truth)
            assert error == pytest.approx(number(cell), rel=0.06), (row, method)


def test_the_reference_lists_each_public_name_on_one_page():
    made = api.pages()
    overview, modules = made.pop("_generated/api.inc"), made.pop("reference/modules.md")
    names = re.findall(r"^   ([\w.]+)$", "".join(made.values()), flags=re.MULTILINE)
    assert len(names) == len(set(names))
    assert set(lm.__all__) < set(names)
    assert "\n   measures.energy.encircled_energy\n" in modules
    assert re.findall(r"^reference/.*$", overview, flags=re.MULTILINE) == [
        name.removesuffix(".md") for name in (*made, "reference/modules.md")
    ]
    assert "```{include} _generated/api.inc\n" in (ROOT / "docs" / "api.md").read_text(encoding="utf-8")


def test_the_pages_of_the_reference_are_written_without_those_of_sections_that_are_gone(tmp_path):
    (tmp_path / "reference").mkdir()
    (tmp_path / "reference" / "gone.md").touch()
    api.write(tmp_path)
    made = {path.relative_to(tmp_path).as_posix() for path in tmp_path.rglob("*.*")}
    assert made == set(api.pages())


def test_the_reference_has_a_section_for_new_names_of_every_package():
    for package in set().union(*organisation.ORDER) - {"cli", "napari_plugin", "paper", "the package"}:
        assert api.section_of(package)


def anchors(path: Path) -> set[str]:
    """Return the anchors of a page's headings, as MyST makes them."""
    text = re.sub(r"^```.*?^```", "", path.read_text(encoding="utf-8"), flags=re.MULTILINE | re.DOTALL)
    titles = re.findall(r"^#+ (.+)$", text, flags=re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", re.sub(r"\]\(.*?\)", "", title).lower()).replace(" ", "-") for title in titles}


@pytest.mark.parametrize("path", PAGES, ids=lambda path: path.stem)
def test_the_links_of_a_page_lead_to_pages_and_headings_that_exist(path):
    text = re.sub(r"^```.*?^```", "", path.read_text(encoding="utf-8"), flags=re.MULTILINE | re.DOTALL)
    for target in re.findall(r"\]\(([^)\s]+)\)", text):
        name, _, anchor = target.partition("#")
        if "//" in target or name.startswith("gallery/") or "_generated" in name:
            continue
        page = path.parent / name if name else path
        assert page.exists(), target
        if anchor:
            assert anchor in anchors(page), target


@pytest.mark.parametrize("path", PAGES, ids=lambda path: path.stem)
def test_the_names_that_a_page_refers_to_are_in_the_reference(path):
    listed = set(re.findall(r"^   ([\w.]+)$", "".join(api.pages().values()), flags=re.MULTILINE))
    for target in re.findall(
        r"\{(?:py:)?(?:class|func|meth|attr)\}`(?:[^`<]*<)?~?lommel\.([\w.]+)>?`", path.read_text("utf-8")
    ):
        assert target in listed or target.rpartition(".")[0] in listed, target


@pytest.mark.parametrize("path", PAGES, ids=lambda path: path.stem)
def test_the_source_files_that_a_page_names_exist(path):
    roots = [ROOT, ROOT / "src" / "lommel", ROOT / "cpp" / "include" / "lommel"]
    for name in re.findall(r"`([\w/]+\.(?:py|hpp))`", path.read_text(encoding="utf-8")):
        assert any((root / name).exists() for root in roots), name


def results_of(name: str) -> dict[str, Any]:
    return json.loads((ROOT / "benchmarks" / f"{name}.json").read_text("utf-8"))


def test_the_speeds_of_the_readme_are_those_of_the_results():
    table = (ROOT / "README.md").read_text(encoding="utf-8").partition("## How fast")[2].partition("\n## ")[0]
    rows = [line.strip("|").split("|") for line in table.splitlines() if line.startswith("|")][2:]
    for row, value in zip(rows, report.in_short(results_of("results")), strict=True):
        assert float(row[-1]) == pytest.approx(value, abs=0.05, rel=0.005), row


def test_what_the_readme_says_of_ffts_pairs_of_frames_and_fits_is_that_of_the_pages():
    readme = " ".join((ROOT / "README.md").read_text(encoding="utf-8").split())
    pages = {name: (ROOT / "docs" / f"{name}.md").read_text(encoding="utf-8") for name in ("live-depth", "trust")}
    (took,) = re.findall(r"ducc0's took ([\d.]+) \(complex128\)", results_of("results")["tables"][0]["about"])
    assert f"ducc0's took {took} of its time" in readme
    # What is slower than the FFT alone.
    (camera,) = (table["rows"] for table in results_of("results")["tables"] if table["key"] == "camera")
    speeds = {row["what"]: next(v["median"] for v in row.values() if isinstance(v, dict)) for row in camera}
    ends = ("f/4, 6 µm (2.7 λN), 0.1 waves rms, 1 PSF", "f/2.8, 4 µm (2.6 λN), 0.1 waves rms, 1 PSF",
            "jwst, f/20.2, 11 µm (0.99 λN), 0.1 waves rms, 50 PSFs",
            "f/8, 11.6 µm (2.6 λN), 0.1 waves rms, obscuration 0.3, 4 vanes, 50 PSFs",
            "f/8, 11.6 µm (2.6 λN), 0.1 waves rms, obscuration 0.3, 4 vanes, D / r0 = 12, 1 PSF")  # fmt: skip
    assert {work for work, speed in speeds.items() if speed < 1.0} == set(ends)
    one, other, jwst, vanes, seeing = (1.0 / speeds[end] for end in ends)
    assert (
        f"In times of a bare 128×128 FFT, too small for these PSFs: JWST {jwst:.2f}, a camera "
        f"{min(one, other):.2g} to {max(one, other):.2g}, vanes on pixels of 2.6 λN {vanes:.2g}, with "
        f"seeing {seeing:.0f}."
    ) in readme
    # Pairs a second in the table of three lenses, the sharp image included.
    rows = re.findall(r"^\| \d+ mm f/[\d.]+ \| \d+ rad \|(?:[^|]+\|){3} (\d+) \|", pages["live-depth"], re.MULTILINE)
    assert len(rows) == 3
    assert f"{min(map(int, rows))} to {max(map(int, rows))} pairs of 640×480 a second" in readme
    table = pages["trust"].partition("<!-- end -->")[0]
    runs = [[cell.strip() for cell in line.split("|")[1:-1]] for line in table.splitlines() if "|" in line]
    runs = [cells for cells in runs if cells[2] in ("right", "told", "right or told", "named")]
    good, named, wrong = (
        sum(int(cells[column]) for cells in runs if (cells[2] == "named") in kinds)
        for column, kinds in ((4, (False, True)), (6, (True,)), (6, (False, True)))
    )
    results = sum(int(cells[3]) for cells in runs)
    first = f"{results} results of {len(runs)} worlds: {good} called good, {wrong} of them wrong ("
    assert f"\n{first}" in pages["trust"]
    called = f"Of [{good} fits](docs/trust.md) of simulated data without a warning, {wrong} were off by over four "
    assert f"{called}standard errors. In {named} outputs list the cause" in readme


def test_the_readme_says_by_how_much_the_other_model_lowers_the_peak_of_its_psf():
    readme = " ".join((ROOT / "README.md").read_text(encoding="utf-8").split())
    lens = {"focal_length": 50e-3, "f_number": 1.8, "focus_distance": 2.0, "wavelength": 550e-9}
    lenses = (lm.Lens(**lens), lm.Lens(**lens, model="aplanatic"))
    first, other = (lm.psf(each.pupil(object_distance=1.9), 101, 0.5e-6).values.max() for each in lenses)
    assert f"has a peak {100.0 * (1.0 - other / first):.0f} % lower" in readme


def test_the_page_of_benchmarks_is_that_of_the_results():
    page = (ROOT / "docs" / "benchmarks.md").read_text(encoding="utf-8")
    assert page == report.write(results_of("results"), results_of("second"))


def test_the_text_of_the_page_of_accuracy_is_that_of_its_benchmark():
    assert accuracy.PAGE.read_text(encoding="utf-8").startswith(accuracy.TEXT)


@pytest.mark.parametrize("name", ["paper.md", "CHANGELOG.md"])
def test_the_speeds_of_the_paper_and_the_changelog_are_those_of_the_results(name):
    text = (ROOT / name).read_text(encoding="utf-8")
    for results in ("results", "second"):
        measured = report.in_short(results_of(results))
        for ratio in (measured[0], measured[4]):  # samples of a round pupil, and 1000 small images
            assert f"1/{ratio:.3g} " in " ".join(text.split()), results


def test_the_errors_of_the_paper_are_those_of_the_page_of_accuracy():
    text = " ".join((ROOT / "paper.md").read_text(encoding="utf-8").split())
    lines = accuracy.PAGE.read_text(encoding="utf-8").splitlines()
    rows = [line.strip("| ").split(" | ") for line in lines if line.startswith("| ") and "| its error |" not in line]
    # A measured number has no bound; a profile is no image.
    images = [row for row in rows if row[4] != "–" and "profiles" not in row[1]]
    others = [row for row in rows if row[4] == "–"]
    errors = [float(row[2]) for row in images if row[6] != "a formula"]
    told = re.search(r"closed forms are (\S+) to (\S+) of the peak.* up to (\d+) %.* at most (\S+)\. A second", text)
    worst = [max(float(row[column]) for row in others) for column in (2, 3)]
    assert [float(each) for each in told.groups()] == [
        min(errors),
        max(errors),
        100 * worst[0],
        float(f"{worst[1]:.0e}"),
    ]
    assert max(float(row[3]) for row in images) < 1e-7
    assert max(float(row[4]) for row in images) < 1e-6
    assert len({row[0].split()[0] for row in rows}) == 13
    assert "compares thirteen packages" in text


def test_the_numbers_of_instruments_that_are_told_are_those_of_the_files():
    objectives, cameras = (len(list((ROOT / "examples" / name).glob("*.toml"))) for name in ("objectives", "cameras"))
    guide, changes = ((ROOT / name).read_text(encoding="utf-8") for name in ("docs/guide.md", "CHANGELOG.md"))
    assert f"{objectives} objectives and {cameras} cameras" in guide
    assert f"{objectives} objectives and {cameras} camera sensors" in changes
