"""`lommel collimate`, run as a user runs it."""

from __future__ import annotations

import itertools
import json
import math
import os
import re
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

import lommel as lm
from lommel.cli import collimate_command
from lommel.cli.collimate_command import Telescope, _advice, _change, _hour, _pictures, _read, _vector
from lommel.cli.instruments import Sensor
from lommel.estimation import collimation
from lommel.estimation.collimation import Vector
from lommel.fit.findings import Finding
from lommel.imaging import write_photo

OPTIONS = ["--aperture", "200mm", "--focal-length", "2m", "--pixel", "7.6um"]


@pytest.fixture
def folder(tmp_path):
    """Two pictures of a star with coma up and to the right as PNG shows it, and an empty one."""
    wave = lm.Wavefront.zernike({7: -0.16, 8: 0.12}, order="noll", unit="waves") + lm.Wavefront(6.0 * np.pi)
    pupil = lm.Pupil(wave, obscuration=0.35, wavelength=550e-9, f_number=10.0)
    light = lm.psf(pupil, 72, 7.6e-6, blur=lm.Jitter(8e-6), tol=1e-4).values
    for seed in (1, 2):
        counts = lm.Noise(read=2.0).record(4e5 * light + 10.0, seed=seed)
        Image.fromarray(np.rint(np.clip(counts, 0, 65000)).astype(np.uint16)).save(tmp_path / f"star-{seed}.png")
    Image.fromarray(np.random.default_rng(0).integers(90, 110, (72, 72)).astype(np.uint16)).save(tmp_path / "sky.png")
    (tmp_path / "notes.txt").write_text("no picture", encoding="utf-8")
    return tmp_path


def test_pictures_of_a_folder_and_their_mean_say_where_the_coma_points(folder, call_lommel):
    result = call_lommel("collimate", ".", *OPTIONS, "--obscuration", 0.35, "--plot", "coma.pdf", folder=folder)
    assert result.returncode == 3  # of the empty picture
    lines = result.stdout.replace("\n  ", " ").splitlines()  # without wrapping
    sky, first, _, mean, tail, cassegrain, newtonian, _, stated, wrote = lines
    assert sky == "sky.png: not measured: the picture must show a star, got none above the noise"
    assert first.startswith("star-1.png: coma 0.")
    assert mean.startswith("mean of 2: coma 0.")
    assert re.search(r"towards 1 o'clock \(5[2-5] \+- 1 degrees\)", mean)
    assert "tail towards 1 o'clock" in tail
    assert "bright at 7 o'clock" in tail
    assert "towards 1 o'clock by the screws of the secondary" in cassegrain
    assert "towards 7 o'clock by the screws of the primary" in newtonian
    assert "pixel 7.6 um, aperture 200 mm, focal length 2 m, wavelength 550 nm." in stated
    assert wrote == "wrote coma.pdf"
    result = call_lommel("collimate", "star-1.png", *OPTIONS, "--json", folder=folder)
    facts = json.loads(result.stdout)
    assert facts["coma"]["degrees"] == pytest.approx(53.1, abs=2.0)
    assert facts["pictures"][0]["spherical"] is None  # depends on the obscuration
    assert facts["coma"]["error"] > 0.1 * facts["coma"]["waves"]


def test_what_is_missing_is_named_with_its_option(folder, call_lommel):
    result = call_lommel("collimate", "sky.png", "--aperture", "200mm", folder=folder)
    assert result.returncode == 2
    assert "add --focal-length 2m --pixel 3.8um" in result.stderr
    result = call_lommel("collimate", "sky.png", "--watch", folder=folder)
    assert "--watch needs one folder" in result.stderr


def test_the_header_states_the_telescope():
    header = {"aperture": 0.2, "focal_length": 2.0, "sensor_pixel": 3.8e-6}
    lens, pixel = Telescope(focal_length=1.0).instrument(header, Sensor())
    assert (lens.f_number, lens.obscuration, pixel) == (5.0, 0.33, 3.8e-6)
    assert Telescope(obscuration=0.0).instrument(header, Sensor(pixel=2e-6))[1] == 2e-6
    with pytest.raises(ValueError, match="--telescope must not be combined"):
        Telescope(lens=Path("t.toml"), aperture=0.2).instrument(header, Sensor())


@pytest.mark.parametrize(("rows", "down"), [(None, False), ("TOP-DOWN", True), ("BOTTOM-UP", False)])
def test_fits_files_are_shown_from_the_bottom_unless_they_say_otherwise(tmp_path, rows, down):
    fits = pytest.importorskip("astropy.io.fits")
    values = np.arange(20, dtype=np.uint8).reshape(4, 5)
    values[0, 0] = 255
    fits.writeto(tmp_path / "a.fits", values, fits.Header({} if rows is None else {"ROWORDER": rows}))
    picture, header, shown_down = _read(tmp_path / "a.fits")
    assert shown_down == down
    assert np.isnan(picture[0, 0])  # saturated
    assert picture[3, 4] == 19.0
    assert header["format"] == "FITS"


def test_colours_and_encodings_are_linear_light(tmp_path):
    for name, colour in (("a", (0, 128, 255)), ("b", (0, 128, 128))):
        Image.fromarray(np.full((6, 6, 3), colour, np.uint8)).save(tmp_path / f"{name}.png")
    assert np.isnan(_read(tmp_path / "a.png")[0]).all()
    values, header, down = _read(tmp_path / "b.png")
    assert values == pytest.approx(2.0 / 3.0 * 128.0 / 255.0, abs=1e-6)
    assert (header["notes"], down) == (["values linear, mean of colours"], True)
    assert _read(tmp_path / "b.png", "srgb")[0] == pytest.approx(2.0 / 3.0 * 0.2159, abs=1e-3)
    # JPEG is sRGB; other files are linear unless they state another encoding.
    Image.fromarray(np.full((6, 6), 128, np.uint8)).save(tmp_path / "c.jpg")
    Image.fromarray(np.full((6, 6), 128, np.uint8)).save(tmp_path / "c.png")
    write_photo(tmp_path / "d.png", np.full((6, 6), 0.2), encoding=2.2)
    assert _read(tmp_path / "c.jpg")[0] == pytest.approx(0.2159, abs=2e-3)
    assert _read(tmp_path / "c.png")[0] == pytest.approx(128.0)
    assert _read(tmp_path / "d.png")[0] == pytest.approx(0.2, abs=2e-3)
    np.save(tmp_path / "e.npy", np.ones((6, 6)))
    with pytest.raises(ValueError, match="--encoding is of PNG"):
        _read(tmp_path / "e.npy", "srgb")


def test_angles_are_those_of_the_picture_as_shown():
    vector = Vector.of(0.1 + 0.1j, 0.01)
    assert _vector(vector, down=False)["degrees"] == pytest.approx(45.0)
    assert _vector(vector, down=True)["degrees"] == pytest.approx(315.0)
    assert _vector(Vector.of(0.1j, 0.01, 2), down=True, folds=2)["degrees"] == pytest.approx(135.0)
    assert [_hour(angle) for angle in (90.0, 60.0, 0.0, 270.0, 180.0, 100.0)] == [12, 1, 3, 6, 9, 12]


def test_new_pictures_are_read_once_and_when_whole(tmp_path, monkeypatch):
    growing, steps = tmp_path / "b.fits", itertools.count()

    def wait(_):
        step = next(steps)
        if step < 3:
            growing.write_bytes(bytes(1 + min(step, 1)))
        stop.requested = step > 5

    stop = type("Stop", (), {"requested": False})()
    monkeypatch.setattr(collimate_command.time, "sleep", wait)
    (tmp_path / "a.png").write_bytes(b"1")
    found = [(path.name, path.stat().st_size) for path in _pictures([tmp_path], stop, watch=True)]
    assert found == [("a.png", 1), ("b.fits", 2)]


def test_watched_pictures_come_by_age_also_once_overwritten_and_removed_ones_do_not_matter(tmp_path, monkeypatch):
    def write(name, second):
        (tmp_path / name).write_bytes(b"123")
        os.utime(tmp_path / name, (second, second))

    stop = type("Stop", (), {"requested": False})()
    sleeps = iter([None, None, lambda: write("b.fits", 30), None, lambda: setattr(stop, "requested", True)])
    monkeypatch.setattr(collimate_command.time, "sleep", lambda _: (next(sleeps) or (lambda: None))())
    write("b.fits", 10)
    write("a.fits", 20)
    write("c.fits", 5)
    found = []
    for path in _pictures([tmp_path], stop, watch=True):
        if not found:
            (tmp_path / "a.fits").unlink()
        found.append(path.name)
    assert found == ["c.fits", "b.fits", "a.fits", "b.fits"]


def test_orders_of_rows_are_mixed_and_the_last_picture_of_a_session_counts(tmp_path, monkeypatch):
    fits = pytest.importorskip("astropy.io.fits")
    values = np.random.default_rng(0).random((30, 30))
    fits.writeto(tmp_path / "a.fits", values)
    fits.writeto(tmp_path / "b.fits", values, fits.Header({"ROWORDER": "TOP-DOWN"}))

    def measured(image, *_, **__):
        coma = next(comas)
        told = [
            Finding("hot_pixels", "note", "2 hot pixels left out"),
            Finding("untested", "note", "not tested: all"),
        ]
        verdict = {"converged": fits_well, "reliable": True, "message": "misfit: chi2 9; noise; wrong"}
        fit = type("Fit", (), verdict | {"findings": told})()
        fields = {"components": coma, "spherical": (0.0, 0.1), "waves": 5.0, "fit": fit, "drift": (7.4, -0.2)}
        fields |= {"coma": Vector.of(coma, 0.01), "astigmatism": Vector.of(0.0j, 0.01, 2), "steady": 0.0}
        return type("One", (), fields | {"star": collimation.Star(10.0, 12.0, 7.0)})()

    monkeypatch.setattr(collimation, "measure_collimation", measured)
    fits_well, drawn = True, []
    monkeypatch.setattr(collimate_command.show.estimates, "collimation", lambda *args: drawn.append(args))
    monkeypatch.setattr(collimate_command, "save_figure", lambda draw, _: draw())
    telescope = Telescope(aperture=0.2, focal_length=2.0, obscuration=0.3)
    job = {"telescope": telescope, "sensor": Sensor(pixel=3.8e-6)}
    comas = iter([0.1 + 0.2j, 0.1 - 0.2j])  # upwards in both pictures
    facts = collimate_command.collimate.function([tmp_path / "a.fits", tmp_path / "b.fits"], **job).facts
    assert facts["coma"]["degrees"] == pytest.approx(63.435)
    assert facts["coma"]["waves"] == pytest.approx(abs(0.1 + 0.2j))
    # Misfits have no errors but those of the scatter.
    fits_well, comas = False, iter([0.1 + 0.2j])
    line, advice, _ = (part.text for part in collimate_command.collimate.function([tmp_path / "b.fits"], **job).parts)
    assert advice.startswith("The direction may be wrong")
    assert line.startswith("b.fits: coma about 0.22 waves towards 5 o'clock, errors unknown: misfit: chi2 9; noise;")
    assert line.endswith("; 2 hot pixels left out")
    comas = iter([0.1 + 0.2j, 0.12 + 0.2j, 0.11 + 0.2j])
    report = collimate_command.collimate.function([tmp_path / "a.fits"] * 3, **job)
    assert not report.succeeded
    assert report.facts["coma"]["error"] == pytest.approx(0.01 / math.sqrt(6.0))
    fits_well = True
    comas = iter([0.3])
    report = collimate_command.collimate.function([tmp_path / "b.fits"], **job)
    assert "; the star drifted by 7 pixels along 11 degrees; 2 hot pixels left out" in report.parts[0].text
    comas = iter([0.3, 0.1 + 0.2j])
    monkeypatch.setattr(
        collimate_command, "_pictures", lambda *_, **__: iter([tmp_path / "b.fits", tmp_path / "a.fits"])
    )
    report = collimate_command.collimate.function([tmp_path], watch=True, **job)
    assert report.facts["coma"]["degrees"] == pytest.approx(63.435)
    picture, star, angle, _ = drawn[-1]
    assert (picture[0, 0], star.row, np.degrees(angle)) == pytest.approx((values[-1, 0], 19.0, 63.435))


def test_a_change_of_coma_tells_how_often_to_repeat_it():
    change = _change(0.3 + 0.1j, 0.2 + 0.1j, 0.01)
    assert change == {
        "waves": pytest.approx(0.1),
        "degrees": pytest.approx(180.0),
        "times": pytest.approx(2.0),
        "left": pytest.approx(0.1),
    }
    assert _change(0.3 + 0.0j, 0.4 + 0.0j, 0.01)["times"] == pytest.approx(-4.0)
    assert _change(0.3 + 0.0j, 0.32 + 0.0j, 0.01) is None


def reflected(place: np.ndarray, along: np.ndarray, mirror: tuple[float, float, float, float, float]):
    """Return where a ray in the meridional plane (across, along the axis) meets a conic mirror, and where it goes.

    The mirror is its vertex on the axis, radius, conic constant, tilt, and the distance from its vertex to the pivot.
    """
    vertex, radius, conic, tilt, pivot = mirror
    turn = np.array([[math.cos(tilt), math.sin(tilt)], [-math.sin(tilt), math.cos(tilt)]])
    centre, shift = np.array([0.0, vertex + pivot]), np.array([0.0, pivot])
    (y, z), (l, n) = turn @ (place - centre) + shift, turn @ along
    # y^2 + k z^2 - 2 R z = 0, at the root nearer to the vertex
    k = 1.0 + conic
    a, b, c = l * l + k * n * n, y * l + (k * z - radius) * n, y * y + (k * z - 2.0 * radius) * z
    root = math.sqrt(b * b - a * c)
    step = min(-(b + root) / a, (root - b) / a, key=lambda at: abs(z + at * n)) if abs(a) > 1e-12 else -c / (2.0 * b)
    y, z = y + step * l, z + step * n
    normal = np.array([y, k * z - radius]) / math.hypot(y, k * z - radius)
    after = np.array([l, n]) - 2.0 * (l * normal[0] + n * normal[1]) * normal
    return turn.T @ (np.array([y, z]) - shift) + centre, turn.T @ after


def star_and_tail(mirrors, screen: float) -> tuple[float, float]:
    """Return where the chief ray of a star meets the screen, and the tail: mean marginal ray less chief ray."""
    at = []
    for height in (-100.0, 0.0, 100.0):
        place, along = np.array([height, 1000.0]), np.array([0.0, -1.0])
        for mirror in mirrors:
            place, along = reflected(place, along, mirror)
        at.append(place[0] + (screen - place[1]) * along[0] / along[1])
    return at[1], 0.5 * (at[0] + at[2]) - at[1]


@pytest.mark.parametrize("tilt", [1e-3, -1e-3])
def test_rays_through_tilted_mirrors_move_the_star_as_the_advice_says(tilt):
    # 200 mm f/10: primary f/3, secondary 170 mm within its focus; hyperbola, or spheres as in a Schmidt-Cassegrain,
    # tilted about its vertex or a point 50 mm behind it.
    prime, inside, times = 600.0, 170.0, 10.0 / 3.0
    radius, hyperbola = 2.0 / (1.0 / inside - 1.0 / (times * inside)), -(((times + 1.0) / (times - 1.0)) ** 2)
    for primary, secondary, pivot in ((-1.0, hyperbola, 0.0), (-1.0, hyperbola, 50.0), (0.0, 0.0, 0.0)):
        mirrors = [
            (0.0, 2.0 * prime, primary, 0.0, 0.0),
            (prime - inside, radius, secondary, tilt, pivot),
        ]
        star, tail = star_and_tail(mirrors, prime - (1.0 + times) * inside)
        assert star * tail < 0.0  # the star moves away from the tail that is added, towards the one that is there
        if not pivot:
            assert (abs(star), abs(tail)) == (pytest.approx(1.133, abs=1e-3), pytest.approx(0.0106, abs=1e-4))
    # 200 mm f/4: a tilted parabola
    star, tail = star_and_tail([(0.0, 1600.0, -1.0, tilt, 0.0)], 800.0)
    assert star * tail > 0.0  # towards the added tail
    assert (abs(star), abs(tail)) == (pytest.approx(1.6, abs=1e-3), pytest.approx(0.0094, abs=1e-4))
    _, cassegrain, newtonian, _ = _advice({"degrees": 90.0, "error": 0.01})  # the tail to cancel is upwards
    assert "move the star towards 12 o'clock" in cassegrain
    assert "move the star towards 6 o'clock" in newtonian
