"""The same data in every file that can hold them: equal answers of all commands, or a sentence with the way out."""

from __future__ import annotations

import json
import logging
import math
import re
import subprocess
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import pandas as pd
import pytest
import tifffile
from astropy.io import fits
from PIL import Image

import containers
import lommel as lm
from lommel.base.encoding import to_light
from lommel.base.options import Options
from lommel.cli import deconvolve_command, localize_command
from lommel.estimation import beads, field_fit, phase_retrieval
from lommel.lensfiles.lens_files import load_instrument
from objectives import OIL_FILE
from small_recordings import DEPTH, bead, coloured, grey, movie, sky, stack, stars

ROOT = Path(__file__).resolve().parents[2]
ASTIGMATIC = ROOT / "examples" / "objectives" / "zeiss-63x-astigmatic.toml"
STAR_LENS = """
[lens]
focal_length = "20 mm"
f_number = 4.0
wavelength = "550 nm"
[sensor]
pixel = "1.1 um"
shape = 33
"""
TELESCOPE = """
[lens]
wavelength = "550 nm"
focal_length = "800 mm"
f_number = 8.0
focus_distance = inf
[object]
distance = inf
[sensor]
pixel = "2.2 um"
shape = 33
"""
PHOTO_LENS = """
[lens]
focal_length = "50 mm"
f_number = 2.8
focus_distance = "2 m"
wavelength = "550 nm"
[sensor]
pixel = "30 um"
shape = 33
"""
Facts = dict[str, Any]
Call = Callable[..., "subprocess.CompletedProcess[str]"]


IMAGES = {"retrieve": stars, "beads": bead, "deconvolve": stack, "fit-field": sky, "localize": movie}
OPTIONS = {
    "retrieve": "star.toml --defocus -4 0 4 --gain 0.5 --read 2 --offset 100 --terms 5",
    "beads": "oil.toml --pixel 6.3um --step 250nm --gain 1 --read 1.6 --offset 100 --terms 1",
    "deconvolve": "oil.toml --gain 1 --read 1.6 --offset 100 --steps 2 --direction up --background 0 "
    "--no-diagnosis -o restored.ome.tif",
    "fit-field": "sky.toml --defocus -2.5 0 2.5 --gain 1 --read 2 --offset 50 --window 17 --degree 0 --terms 5 "
    "--known-blur 0",
    "localize": "glass.toml --gain 0.46 --read 1.6 --offset 100 --z -300nm 300nm --reach 1 -o table.csv",
    "blur": "photo.toml -o out.tif",
    "restore": "photo.toml --white 5000 --read 3 -o out.tif",
}
SIZES = "--axes ZYX --pixel 6.3um --step 250nm"  # of a stack whose file does not state them
NAMED = (
    "images",
    "beads",
    "stack",
    "movie",
    "seconds",
    "files",
    "notes",
    "read",
    "encoding",
)  # of files, and of time
REFERENCE = {"deconvolve": "ome-tiff"}

WAY = re.compile(
    r"[:;,.] (?:or )?(?:save|give|state|name|write|unpack|flatten|install|convert|pass|open|say|choose|take)\b"
    r"|\bis to be [a-z]+ed\b|\bbeside it$|\bin one folder\?$"
    # What is read, or what it must be.
    r"|\bis not an? [A-Z, a-z.]+ file\b|\ba depth map has\b|\bneither [a-zA-Z0-9, ]+ nor\b"
)
LIBRARY = re.compile(r"Traceback|<[A-Z]\w+|[a-z]Error\b|\brequires the\b|zero-size|0x[0-9a-f]{4}")


class Answer(NamedTuple):
    """What a command said in numbers, or its sentence."""

    facts: Facts | None
    refusal: str


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A folder with the files of all lenses."""
    for name, text in (("star", STAR_LENS), ("sky", TELESCOPE), ("oil", OIL_FILE), ("photo", PHOTO_LENS)):
        (tmp_path / f"{name}.toml").write_text(text, encoding="utf-8")
    (tmp_path / "glass.toml").write_text(ASTIGMATIC.read_text(encoding="utf-8"), encoding="utf-8")
    return tmp_path


def answered(result: subprocess.CompletedProcess[str], folder: Path, log: pytest.LogCaptureFixture) -> Answer:
    """Return the numbers of a result, or its refusal, of which nothing is printed but one sentence."""
    assert not [record for record in log.records if record.levelno >= logging.WARNING]
    if result.returncode in (1, 2):
        assert result.stdout == ""
        assert not LIBRARY.search(result.stderr), result.stderr
        (line,) = re.findall(r"^Error: (.*(?:\n.+)*)", result.stderr, re.MULTILINE)
        return Answer(None, " ".join(line.split()))
    assert result.returncode in (0, 3, 4), result.stderr
    assert result.stderr == ""
    facts = json.loads(result.stdout)
    for name, read in READ.items():
        if (folder / name).exists():
            facts[name] = read(folder / name)
            (folder / name).unlink()
    return Answer({name: value for name, value in facts.items() if name not in NAMED}, "")


READ: dict[str, Callable[[Path], Any]] = {
    "restored.ome.tif": lambda path: tifffile.imread(path).tolist(),
    "table.csv": lambda path: pd.read_csv(path).to_dict("list"),
    "out.tif": lambda path: tifffile.imread(path).tolist(),
    "found.npy": lambda path: np.load(path).tolist(),
}


def flat(value: Any, at: str = "") -> Iterator[tuple[str, Any]]:
    """Yield all parts of facts with their places."""
    if isinstance(value, dict):
        for name, part in value.items():
            yield from flat(part, f"{at}/{name}")
    elif isinstance(value, list):
        yield f"{at}/length", len(value)
        for k, part in enumerate(value):
            yield from flat(part, f"{at}/{k}")
    else:
        yield at, value


def equal(found: Facts, expected: Facts, share: float, least: float = 0.0) -> None:
    """Check that facts are the same, and numbers to a share of themselves or to `least`."""
    one, other = dict(flat(found)), dict(flat(expected))
    assert one.keys() == other.keys()
    for at, value in other.items():
        if share and isinstance(value, float):
            assert one[at] == pytest.approx(value, rel=share, abs=least, nan_ok=True), at
        else:
            assert one[at] == value or (value != value and one[at] != one[at]), at


def upside_down(facts: Facts) -> Facts:
    """Return facts with the direction of coma in a picture that is shown with its first row at the bottom: FITS."""
    coma = facts.get("coma")
    return facts | {"coma": coma | {"degrees": -coma["degrees"] % 360.0}} if coma else facts


EXPECTED: dict[str, Facts] = {}


def once(key: str, find: Callable[[], Answer]) -> Facts:
    """Return the answer to the plain container, which is asked for once."""
    if key not in EXPECTED:
        answer = find()
        assert answer.facts is not None, answer.refusal
        EXPECTED[key] = answer.facts
    return EXPECTED[key]


def cases(names: Sequence[tuple[str, ...]]) -> list[Any]:
    """Return cases of a command and a container."""
    return [pytest.param(*each, id=" - ".join(each)) for each in names]


# ---------------------------------------------------------------------------------------- stacks, stars and movies

ZARRS = [name for name in containers.ALL if name.startswith("ome-zarr")]
SEVERAL = ["tiffs", "pngs", "npys", "fitses", "ome-tiff of several files, all named"]
NO_TIFF = [name for name in containers.BARE if name.startswith(("np", "fits", "hdf5")) and name not in SEVERAL]


def ask(command: str, name: str, folder: Path, call: Call, log: Any, handed: list[list[Any]] | None = None) -> Answer:
    """Return what a command answers to its images in a container, or what it hands to its estimator."""
    place = folder / "images"
    place.mkdir()
    words = containers.ALL[name](IMAGES[command](), place)
    more = SIZES.split() if command == "deconvolve" and name in containers.BARE else []
    result = call(command, *words, *OPTIONS[command].split(), *more, "--json", folder=folder)
    place.rename(folder / "done")
    return Answer(dict(flat(in_numbers(handed.pop()))), "") if handed else answered(result, folder, log)


IMAGE_CASES = cases([(command, name) for command in IMAGES for name in containers.ALL])


def is_refused(answer: Answer, command: str, name: str) -> bool:
    """Return whether there is no answer, which a sentence with a way out says, where that is allowed."""
    if answer.facts is None:
        assert WAY.search(answer.refusal), answer.refusal
        assert name in REFUSED or (command, name) == ("localize", "ome-tiff, a thumbnail first"), answer.refusal
    return answer.facts is None


@pytest.fixture
def handed(monkeypatch: pytest.MonkeyPatch) -> list[list[Any]]:
    """Have commands end where they would estimate; return what they hand to estimators."""
    calls: list[list[Any]] = []
    coloured()  # made by what is replaced below

    def estimate(*arguments: Any, **options: Any) -> None:
        calls.append([*arguments, options])
        raise SystemExit(0)

    def restore(recording: Any, microscope: lm.Microscope, noise: Any, options: Any, **given: Any) -> None:
        sizes = recording.metadata
        pixel = options.pixel or sizes["pixel"] * microscope.objective.magnification
        given |= vars(options) | {"pixel": pixel, "step": options.step or sizes["step"]}
        estimate(recording.only_channel("stack")[...], noise, given)

    for module, name, stub in (
        (phase_retrieval, "fit_stars", estimate),
        (beads, "fit_beads", estimate),
        (field_fit, "fit_targets", lambda targets, *more, **given: estimate(vars(targets), *more, given)),
        (localize_command, "Table", lambda *arguments, **options: None),
        (localize_command, "movie_blocks", lambda movie, *more, **given: estimate(movie[...], *more, given)),
        (deconvolve_command, "run", restore),
        (lm.imaging, "depth_of_field", estimate),
        (lm.imaging, "restore", lambda photo, *more, encoding, **given: estimate(
            to_light("photo", photo, encoding, np.float64), *more, given
        )),
    ):  # fmt: skip
        monkeypatch.setattr(module, name, stub)
    return calls


def in_numbers(value: Any) -> Any:
    """Return what images are handed on with as numbers and texts; lenses, of files of their own, as nothing."""
    if isinstance(value, lm.Counts | Options):
        return in_numbers(vars(value))
    if isinstance(value, dict):
        return {name: in_numbers(part) for name, part in value.items() if name != "_counts"}
    if isinstance(value, list | tuple):
        return list(map(in_numbers, value))
    if isinstance(value, np.ndarray):
        return [list(value.shape), np.ma.getmaskarray(value).tobytes(), np.asarray(value, np.float64).tobytes()]
    if isinstance(value, lm.Noise):
        return repr(value)
    return value if isinstance(value, float | int | str | None) else None


@pytest.mark.parametrize(("command", "name"), IMAGE_CASES)
def test_images_in_any_file_are_read_as_the_same_numbers_or_a_way_out(
    command, name, folder, call_lommel, caplog, handed
):
    answer = ask(command, name, folder, call_lommel, caplog, handed)
    if is_refused(answer, command, name) or name in REFUSED:  # then by the estimator: a bead of one plane
        return
    (folder / "done").rename(folder / "other")
    plain = REFERENCE.get(command, "tiff")
    expected = once(f"{command}, read", lambda: ask(command, plain, folder, call_lommel, caplog, handed))
    equal(answer.facts, expected, 1e-9)


@pytest.mark.drawn("name")
@pytest.mark.parametrize(("command", "name"), IMAGE_CASES)
def test_images_in_any_file_have_the_same_answer_or_a_way_out(command, name, folder, call_lommel, caplog):
    answer = ask(command, name, folder, call_lommel, caplog)
    if is_refused(answer, command, name):
        return
    (folder / "done").rename(folder / "other")
    plain = REFERENCE.get(command, "tiff")
    expected = once(command, lambda: ask(command, plain, folder, call_lommel, caplog))
    if name.startswith("fits"):
        expected = upside_down(expected)
    inexact = "float32" in name or name in containers.STATED
    # Frames of float32 are also fitted in single precision.
    equal(answer.facts, expected, (1e-5 if command == "localize" else 1e-6) if inexact else 0.0)


REFUSED = {
    "tiff in colour", "tiff, planes as colours of one page", "tiff.gz", "npz", "hdf5", "fits.bz2", "npy of five axes",
    "fits, tiles compressed", "fits, an extension each", "tiff, lzw",
    "ome-tiff, a thumbnail last", *ZARRS, *SEVERAL, *NO_TIFF,
}  # fmt: skip


def with_header(command: str, folder: Path, **cards: object) -> Path:
    """Write images with cards in their header."""
    unit = fits.PrimaryHDU(IMAGES[command]())
    unit.header.update(cards)
    unit.writeto(folder / "header.fits", overwrite=True)
    return folder / "header.fits"


HEADED = {"retrieve": 0.5, "beads": 1.0, "localize": 0.46, "fit-field": 1.0}


@pytest.mark.drawn
@pytest.mark.parametrize("command", HEADED)
def test_a_gain_and_a_read_noise_of_the_header_are_taken_named_or_told_to_be_unusable(
    command, folder, call_lommel, caplog
):
    def asked(words: list[str], **cards: object) -> tuple[Answer, str]:
        result = call_lommel(command, with_header(command, folder, **cards), *words, "--json", folder=folder)
        return answered(result, folder, caplog), " ".join(json.loads(result.stdout)["notes"])

    words, gain = OPTIONS[command].split(), HEADED[command]
    without = [word for k, word in enumerate(words) if "--gain" not in (word, words[k - 1])]
    expected, said = asked(words)
    assert "header" not in said
    assert "No gain is known" not in said
    assert "No gain is known: 1 electron per count was assumed" in asked(without, BUNIT="adu")[1]
    taken, said = asked(without, EGAIN=gain, RDNOISE=9.5, SATURATE=60000)
    assert f"Taken from the header of the images: a gain of {gain:g} electrons per count." in said
    assert "The header of the images states a read noise of 9.5 electrons; " in said
    assert "Taken from the header of the images: saturation at 60000." in said
    for facts in (taken.facts, expected.facts):
        facts.pop("noise", None)
        facts.pop("assumed", None)
    equal(taken.facts, expected.facts, 1e-12)
    _, said = asked(words, EMGAIN=300)
    assert "Taken from the header of the images: an electron-multiplying camera, excess noise 2" in said
    named, said = asked(words, EGAIN=3.0)
    assert f"states a gain of 3 electrons per count; {gain:g} was used." in said
    named.facts.pop("noise", None)
    named.facts.pop("assumed", None)
    equal(named.facts, expected.facts, 1e-12)
    _, said = asked(words, EGAIN=-2.0)
    assert "The header of the images states gain -2.0, which cannot be used." in said
    for stated, cards in (("gain -2.0", {"EGAIN": -2.0}), ("values in adu/s, neither counts ", {"BUNIT": "adu/s"})):
        result = call_lommel(command, with_header(command, folder, **cards), *without, "--json", folder=folder)
        assert re.search(rf"header of the images states {stated}.*: state --gain", result.stderr), result.stderr
    _, said = asked(words, BAYERPAT="RGGB")
    assert "states BAYERPAT = RGGB, a mosaic of colours" in said
    has_lens = command in ("retrieve", "fit-field")
    _, said = asked(words, FOCALLEN=7e5, **{"XPIXSZ": 99.0} if has_lens else {})  # of microscopes a doubt
    assert ("The header of the images states pixels of 99 um; " in said) is has_lens
    assert ("states a focal length of 700 m; " in said) is has_lens
    if command in ("retrieve", "fit-field"):
        instrument = load_instrument(folder / words[0])
        lens, scale = instrument.lens, instrument.side / instrument.lens.focal_length * 648000 / math.pi
        sizes = {"FOCALLEN": 1e3 * lens.focal_length, "APTDIA": 1e3 * lens.aperture_diameter}
        cards = {**sizes, "FOCRATIO": lens.f_number, "PIXSCALE": scale}
        assert "was used" not in asked(words, **cards)[1]
        assert f"states {1.1 * scale:.3g} arcsec per pixel; {scale:.3g} was" in asked(words, PIXSCALE=1.1 * scale)[1]
        assert f"f/{1.1 * lens.f_number:.3g}; {lens.f_number:.3g}" in asked(words, FRATIO=1.1 * lens.f_number)[1]
        assert "an aperture of " in asked(words, APTDIA=1.1 * sizes["APTDIA"])[1]
        assert "500 nm in its coordinates; " in asked(words, CDELT1=5e-4, CUNIT1="mm")[1]
    _, said = asked(without, GAIN=120)
    assert (
        "No gain is known: 1 electron per count was assumed; --gain states it. The header states GAIN = 120" in said
    )


def test_files_whose_headers_contradict_each_other_are_refused(folder, call_lommel, caplog):
    names = []
    for k, (image, gain) in enumerate(zip(stars(), (0.5, 0.48, 0.5), strict=True)):
        unit = fits.PrimaryHDU(image)
        unit.header["EGAIN"] = gain
        unit.writeto(folder / f"star-{k}.fits")
        names.append(folder / f"star-{k}.fits")
    words = [word for word in OPTIONS["retrieve"].split() if word not in ("--gain", "0.5")]
    result = call_lommel("retrieve", *names, *words, "--json", folder=folder)
    assert "states gain of 0.5, 0.48 in different files: state --gain" in result.stderr
    result = call_lommel("retrieve", *names, *words, "--gain", "0.5", "--json", folder=folder)
    assert "states gain of 0.5, 0.48 in different files, which cannot be used" in result.stdout


@pytest.mark.parametrize("command", list(IMAGES))
def test_an_ome_tiff_that_lacks_files_is_refused(command, folder, call_lommel, caplog):
    words = containers.set_of_ome(IMAGES[command](), folder)
    (folder / "plane-1.ome.tif").unlink()
    answer = answered(
        call_lommel(command, *words, *OPTIONS[command].split(), "--json", folder=folder), folder, caplog
    )
    assert WAY.search(answer.refusal), answer.refusal


MASKS = {
    "npy of bool": lambda mask, path: np.save(path.with_suffix(".npy"), mask),
    "npy, Fortran order": lambda mask, path: np.save(path.with_suffix(".npy"), np.asfortranarray(mask)),
    "npy of float64": lambda mask, path: np.save(path.with_suffix(".npy"), mask.astype(float)),
    "tiff of bool": lambda mask, path: tifffile.imwrite(path.with_suffix(".tif"), mask, photometric="minisblack"),
    "tiff of bits": lambda mask, path: Image.fromarray(mask).save(path.with_suffix(".tif")),
    "tiff of 0 and 255": lambda mask, path: tifffile.imwrite(path.with_suffix(".tif"), 255 * mask.astype(np.uint8)),
    "png of bits": lambda mask, path: Image.fromarray(mask).save(path.with_suffix(".png")),
    "png of 0 and 255": lambda mask, path: Image.fromarray(255 * mask.astype(np.uint8)).save(
        path.with_suffix(".png")
    ),
    "fits": lambda mask, path: fits.PrimaryHDU(mask.astype(np.uint8)).writeto(path.with_suffix(".fits")),
    "fits.gz": lambda mask, path: fits.PrimaryHDU(mask.astype(np.int16)).writeto(path.with_suffix(".fits.gz")),
}


@pytest.mark.parametrize("name", MASKS)
def test_a_mask_in_any_file_leaves_out_the_same_pixels(name, folder, call_lommel):
    np.save(folder / "sky.npy", sky())
    mask = np.zeros(sky().shape[1:], dtype=bool)
    mask[16, 17:19] = mask[31] = True
    (folder / "masks").mkdir()
    MASKS[name](mask, folder / "masks" / "mask")
    (path,) = (folder / "masks").iterdir()
    words = ["sky.npy", *OPTIONS["fit-field"].split(), "--mask", path, "--json"]
    found = json.loads(call_lommel("fit-field", *words, folder=folder).stdout)
    np.save(folder / "sky.npy", np.where(mask, np.nan, sky()))
    expected = once("masked sky", lambda: Answer(json.loads(call_lommel(
        "fit-field", "sky.npy", *OPTIONS["fit-field"].split(), "--json", folder=folder
    ).stdout), ""))  # fmt: skip
    assert found["left_out"] == 3 * mask.sum()
    assert found["waves"] == expected["waves"]


# ------------------------------------------------------------------------------------- photographs and depth maps


IN_COLOUR = ["png, a palette", "gif", *(name for name in containers.GREY if "in colour" in name)]
KINDS = {
    "grey": (grey, containers.GREY),
    "coloured": (coloured, containers.COLOUR),
    "depth": (lambda: DEPTH, containers.DEPTHS),
}
PHOTO_CASES = [(command, kind, name) for command in ("blur", "restore") for kind in KINDS for name in KINDS[kind][1]]


@pytest.mark.drawn("name")
@pytest.mark.parametrize(("command", "kind", "name"), cases(PHOTO_CASES))
def test_a_photograph_and_a_depth_map_in_any_file_are_read_as_the_same_numbers_or_a_way_out(
    command, kind, name, folder, call_lommel, caplog, handed
):
    values, writers = KINDS[kind]
    (folder / "any").mkdir()
    photo, depth = containers.PHOTOS["png"](grey(), folder), containers.DEPTHS["npy"](DEPTH, folder)
    written = writers[name](values(), folder / "any")
    photo, depth = (photo, written) if kind == "depth" else (written, depth)
    options = [*OPTIONS[command].split(), *photo[1:], *depth[1:], "--json"]
    result = call_lommel(command, photo[0], depth[0], *options, folder=folder)
    if not handed:
        answer = answered(result, folder, caplog)
        assert WAY.search(answer.refusal), answer.refusal
        return
    light, distance = handed.pop()[:2]
    expected = to_light("photo", grey() if kind == "depth" else values(), "srgb", np.float64)
    if kind == "grey" and name in IN_COLOUR:
        expected = np.repeat(expected[..., None], 3, axis=2)
    np.testing.assert_allclose(light, expected, rtol=0.0, atol=1e-6)
    np.testing.assert_allclose(distance, DEPTH, rtol=0.0, atol=1e-6)
