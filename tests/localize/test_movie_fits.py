"""Movies to localisations: against molecules at known places, made by lommel.psf."""

from __future__ import annotations

import math
from contextlib import nullcontext

import h5py
import numpy as np
import pandas as pd
import pytest
import tifffile

import lommel as lm
import simulated_movies as simulated
from lommel.localize import LocalizeOptions, Table, localize_movie, writer
from lommel.localize.localizations import joined
from lommel.localize.movie_fits import gaussian_widths, movie_blocks
from lommel.recorded.frames import open_frames

PIXEL = simulated.PIXEL / simulated.MAGNIFICATION
CAMERA = lm.Noise(white=0.46, read=1.6, offset=100.0)
FRAMES, SIDE = 25, 112


@pytest.fixture(scope="module")
def table() -> Table:
    return Table(simulated.pupil(), shape=15, pixel=simulated.PIXEL, z=(-0.7e-6, 0.7e-6), reach=3.0)


@pytest.fixture(scope="module")
def molecules() -> simulated.Molecules:
    return simulated.spread(FRAMES, SIDE, each=6, apart=20, seed=1)


@pytest.fixture(scope="module")
def counts(molecules) -> np.ndarray:
    return simulated.recorded(simulated.light(molecules, FRAMES, SIDE, 8.0), CAMERA, 2)


def in_blocks(movie, table, block, **options):
    """Return the localisations of blocks of so many frames."""
    return list(movie_blocks(movie, table, CAMERA, LocalizeOptions(**options), block=block))


def errors(found: lm.localize.Localizations, true: simulated.Molecules) -> pd.DataFrame:
    """The error of each localisation over its standard error, and the molecule that it is."""
    rows = found.table[found.kept]
    x, y = (true.column + 0.5) * PIXEL, (true.row + 0.5) * PIXEL  # from the corner of the first pixel
    far = np.hypot(rows["x"][:, None] - x, rows["y"][:, None] - y)
    far[rows["frame"][:, None] != true.frame] = np.inf
    mine = far.argmin(axis=1)
    truth = {"x": x, "y": y, "z": true.z, "photons": true.photons}
    off = {name: (rows[name] - values[mine]) / rows[f"{name}_error"] for name, values in truth.items()}
    off["background"] = (rows["background"] - 8.0) / rows["background_error"]
    return pd.DataFrame(off | {"molecule": mine})


def test_molecules_off_the_brightest_part_of_their_images_are_found():
    # With coma the brightest part is up to four pixels aside, beyond the reach of a box around it.
    objective = lm.Objective(NA=1.45, magnification=100, immersion=1.518, sample=1.34)
    coma = lm.Wavefront.zernike({6: 0.2, 8: 0.05}, order="noll", unit="waves")
    light = {"depth": 0.4e-6, "wavelength": 670e-9, "aberrations": coma}
    rng = np.random.default_rng(3)
    z = rng.uniform(0.45e-6, 0.65e-6, 60)
    row, column = 20.0 + rng.uniform(-0.5, 0.5, (2, 60))
    images = lm.psf(objective.pupil(z=z, **light), 41, 11e-6, center=(row, column), tol=1e-4).values
    movie = CAMERA.record(1500.0 * images + 12.0, rng)
    table = Table(objective.pupil(**light), shape=15, pixel=11e-6, z=(-0.7e-6, 0.7e-6))
    found = localize_movie(movie, table, noise=CAMERA)
    rows = found.table[found.kept]
    assert len(rows) >= 57
    frame = rows["frame"]
    for name, truth in (("x", (column + 0.5) * 110e-9), ("y", (row + 0.5) * 110e-9), ("z", z)):
        off = (rows[name] - truth[frame]) / rows[f"{name}_error"]
        assert np.abs(off).max() < 5.0
        assert 0.75 < math.sqrt((off**2).mean()) < 1.25


def test_molecules_are_where_they_were_put_within_the_stated_deviations(table, molecules, counts):
    found = localize_movie(counts, table, noise=CAMERA)
    assert (found.spots, found.borders, found.recording.frames) == (molecules.frame.size, 0, FRAMES)
    assert found.counts["converged"] >= molecules.frame.size - 1
    off = errors(found, molecules)
    assert off["molecule"].is_unique
    for name in ("x", "y", "z", "photons", "background"):
        spread = math.sqrt((off[name] ** 2).mean())
        assert 0.85 < spread < 1.15, name
        assert abs(off[name].mean()) < 0.3, name
    assert off[["x", "y", "z"]].abs().max().max() < 4.5
    rows = found.table[found.kept]
    assert np.median(rows["x_error"]) < 10e-9
    assert np.median(rows["z_error"]) < 25e-9
    assert abs(np.median(rows["discrepancy"])) < 0.4
    assert rows["score"].min() > 6.0


def test_a_file_in_blocks_gives_what_the_array_gives(table, counts, tmp_path):
    tifffile.imwrite(tmp_path / "movie.tif", counts, photometric="minisblack")
    whole, told = localize_movie(counts, table, noise=CAMERA), []
    found = joined(in_blocks(tmp_path / "movie.tif", table, 7, progress=lambda *at: told.append(at)))
    np.testing.assert_array_equal(found.table, whole.table)
    assert (found.spots, found.overlapping) == (whole.spots, whole.overlapping)
    assert told == [(7, 25), (14, 25), (21, 25), (25, 25)]
    assert (found.recording.name, whole.recording.name) == ("movie.tif", "")
    with open_frames(tmp_path / "movie.tif").as_stack() as movie:
        parts = in_blocks(movie, table, 10)
    assert [len(part.table) for part in parts] == [int((whole.table["frame"] // 10 == k).sum()) for k in range(3)]
    with writer(tmp_path / "a.csv") as write:
        for part in parts:
            write(part)
    whole.save(tmp_path / "b.csv")
    assert (tmp_path / "a.csv").read_bytes() == (tmp_path / "b.csv").read_bytes()


def bright(top, frames=40):
    """A movie of one emitter whose brightest pixels exceed by a fifth what the camera can count."""
    one = simulated.Molecules(*(np.array([value]) for value in (0, 17.3, 18.8, 0.1e-6, 1.0)))
    image = simulated.light(one, 1, 64, 0.0)[:, :40, :40]
    light = 10.0 + image * (1.2 * top / image.max())
    return np.round(CAMERA.record(np.repeat(light, frames, axis=0), seed=2))


@pytest.mark.parametrize("bits", [12, 16])
@pytest.mark.parametrize("kind", [np.uint16, np.float32, np.int32])
def test_saturated_pixels_do_not_move_molecules(bits, kind, table):
    most = 2**bits - 1
    raw = bright((most - 100) * 0.46)
    movie = np.minimum(raw, most).astype(kind)
    found = joined(in_blocks(movie, table, 7))
    known = np.where(movie < most, raw, np.nan)
    for other in (
        localize_movie(known, table, noise=CAMERA),
        localize_movie(lm.Counts.of(movie, noise=CAMERA, saturation=most), table),
    ):
        assert len(found) == len(other) == found.kept.sum() == 40
        for name in ("x", "y", "z", "photons"):
            np.testing.assert_allclose(found.table[name], other.table[name], rtol=1e-6, atol=1e-12)
    for name, true in (("x", 19.3 * PIXEL), ("y", 17.8 * PIXEL), ("z", 0.1e-6)):
        off = (found.table[name] - true) / found.table[f"{name}_error"]
        assert abs(off.mean()) < 0.8  # with the saturated pixels taken as light up to 7


def test_movies_that_do_not_tell_z_have_x_and_y_of_all_spots(tmp_path):
    objective = lm.Objective(NA=1.4, magnification=63, immersion=1.518, sample=1.33)
    pupil = objective.pupil(depth=0.5e-6, wavelength=600e-9)  # without astigmatism
    table = Table(pupil, shape=11, pixel=6.5e-6, z=(-0.2e-6, 0.2e-6))
    rng = np.random.default_rng(4)
    z, (row, column) = rng.uniform(-0.3e-6, 0.3e-6, 40), 20.0 + rng.uniform(-0.5, 0.5, (2, 40))
    light = objective.pupil(depth=0.5e-6, wavelength=600e-9, z=z)
    images = lm.psf(light, 41, 6.5e-6, center=(row, column), tol=1e-4).values
    movie = CAMERA.record(800.0 * images + 5.0, rng)
    deep, flat = (localize_movie(movie, table, noise=CAMERA, flat=flat) for flat in (False, True))
    assert deep.kept.sum() < 30 < 40 == flat.kept.sum()  # the others end at an end of the range of z
    assert np.isnan(flat.table["z"]).all()
    for name, true in (("x", column + 0.5), ("y", row + 0.5)):
        off = (flat.table[name] - true * PIXEL) / flat.table[f"{name}_error"]
        assert abs(off.mean()) < 0.5
        assert off.std() < 1.5
    flat.save(tmp_path / "flat.csv", tmp_path / "flat.hdf5")
    assert not any("z" in name.split() for name in pd.read_csv(tmp_path / "flat.csv").columns)
    with h5py.File(tmp_path / "flat.hdf5") as file:
        assert {"x", "y", "lpx"} <= set(file["locs"].dtype.names)
        assert not {"z", "lpz"} & set(file["locs"].dtype.names)
    assert "z:" not in (tmp_path / "flat.yaml").read_text()
    assert flat.plot().get_figure(root=True).axes[1:] == []  # no bar of colours


def test_depth_is_found_where_the_table_runs_along_it():
    pupil = simulated.OBJECTIVE.pupil(
        depth=0.5e-6, z=0.0, origin="brightest", wavelength=600e-9, aberrations=simulated.ASTIGMATISM
    )
    table = Table(pupil, shape=15, pixel=simulated.PIXEL, z=(0.2e-6, 0.8e-6), along="depth", reach=3.0)
    depths = np.linspace(0.3e-6, 0.7e-6, 5)
    focus = float(pupil.focus)
    emitters = simulated.OBJECTIVE.pupil(
        depth=depths, z=focus, origin="coverslip", wavelength=600e-9, aberrations=simulated.ASTIGMATISM
    )
    frames = 5000.0 * lm.psf(emitters, 41, simulated.PIXEL, dtype="float64").values + 5.0
    found = localize_movie(frames, table)
    assert found.counts["converged"] == 5
    np.testing.assert_allclose(found.table["z"], depths, atol=1e-9)  # no noise: the error is the table's
    np.testing.assert_allclose(found.table["x"], 20.5 * PIXEL, atol=1e-10)
    assert found.recording.along == "depth"


def test_the_wavefront_of_a_bead_on_the_glass_serves_for_molecules_deep_in_the_sample():
    unknown = lm.Wavefront.zernike({6: 0.15, 7: 0.04, 8: -0.03, 11: 0.05}, order="noll", unit="waves")
    planes = {"depth": 0.1e-6, "z": np.linspace(-8e-7, 8e-7, 9), "wavelength": 600e-9}
    of_bead = 2e4 * lm.psf(simulated.OBJECTIVE.pupil(**planes, aberrations=unknown), 25, simulated.PIXEL).values + 5.0
    camera = lm.Noise(read=1.6, offset=100.0)
    bead = lm.fit_beads(
        [camera.record(of_bead, seed=1)],
        lm.Microscope(simulated.OBJECTIVE, 600e-9, simulated.PIXEL),
        z=planes["z"],
        noise=camera,
        diameter=1e-9,
        depth=0.1e-6,
        terms=11,
        priors={},
    )
    z, deep = np.linspace(-0.5e-6, 0.5e-6, 21), {"depth": 1e-6, "wavelength": 600e-9}
    images = lm.psf(simulated.OBJECTIVE.pupil(**deep, z=z, aberrations=unknown), 15, simulated.PIXEL).values
    one = Table(simulated.OBJECTIVE.pupil(**deep, aberrations=bead.aberrations), z=(-0.9e-6, 0.9e-6))
    error = 1e9 * (lm.localize.fit(one, 5000.0 * images + 10.0).z - z)
    assert np.sqrt((error**2).mean()) < 2.0
    assert abs(np.polyfit(1e9 * z, error, 1)[0]) < 0.003


def test_gaussian_widths_are_those_of_gaussians_fitted_to_the_images(table):
    heights, tall, wide = gaussian_widths(table)
    assert (heights[0], heights[-1]) == table.z
    from scipy.optimize import curve_fit

    y, x = np.mgrid[-7:8, -7:8]

    def gaussian(_, height, sy, sx, y0, x0):
        return (height * np.exp(-(((y - y0) / sy) ** 2) / 2 - (((x - x0) / sx) ** 2) / 2)).ravel()

    for k in (16, 32, 48):
        image = np.asarray(table(7, 7, heights[k]), float)
        (_, sy, sx, *_), _ = curve_fit(gaussian, None, image.ravel(), p0=(image.max(), 2.0, 2.0, 0.0, 0.0))
        assert tall[k] == pytest.approx(abs(sy), rel=0.2)
        assert wide[k] == pytest.approx(abs(sx), rel=0.2)
    assert tall[0] > 2 * wide[0]
    assert wide[-1] > 1.5 * tall[-1]


@pytest.mark.parametrize("kind", ["array", "folder"])
def test_missing_chunks_of_a_movie_are_a_doubt_and_blamed_on_no_offset(kind, table, counts, tmp_path):
    zarr = pytest.importorskip("zarr")
    group = zarr.create_group(str(tmp_path / "a.zarr"), zarr_format=3)
    axes = [{"name": name, "type": "space", "unit": "micrometer"} for name in "zyx"]
    sizes = [{"type": "scale", "scale": [1.0, PIXEL * 1e6, PIXEL * 1e6]}]
    datasets = [{"path": "0", "coordinateTransformations": sizes}]
    group.attrs["ome"] = {"multiscales": [{"axes": axes, "datasets": datasets}]}
    array = group.create_array("0", data=counts[:8], chunks=(2, SIDE, SIDE))
    (tmp_path / "a.zarr" / "0" / "c" / "0" / "0" / "0").unlink()
    with nullcontext() if kind == "folder" else pytest.warns(UserWarning, match="1 of the 4 chunks"):
        found = localize_movie(array if kind == "array" else tmp_path / "a.zarr", table, noise=CAMERA)
    (finding,) = [one for one in found.findings if one.code == "missing_chunks"]
    assert (finding.severity, finding.numbers) == ("doubt", {"missing": 1, "chunks": 4})
    assert "missing and count as 0: c/0/0/0; " in finding.text
    assert "below_offset" not in {one.code for one in found.findings}
    assert set(found.table["frame"]) == set(range(2, 8))


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"movie": lm.Counts.of(np.ones((2, 40, 40)), noise=CAMERA, mask=np.ones((40, 40), bool))}, "neither masked"),
        ({"movie": lm.Counts.of(np.ones((2, 40, 40)), noise=CAMERA), "noise": CAMERA}, "noise must be omitted"),
    ],
)
def test_bad_arguments_are_told(changes, message, table):
    given = {"movie": np.zeros((2, 40, 40)), "table": table} | changes
    with pytest.raises((TypeError, ValueError, OSError), match=message):
        localize_movie(given.pop("movie"), given.pop("table"), **given)


def test_an_uneven_background_is_tilted_where_its_slope_is_seen(table):
    true = simulated.spread(40, 64, each=3, apart=18, seed=7)
    even = simulated.light(true, 40, 64, 15.0)
    for slope, background, least, most in ((0.0, "auto", 0.0, 0.4), (0.4, "auto", 0.0, 0.4), (0.4, "flat", 1.0, 9.0)):
        seen = CAMERA.record(even + slope * (np.arange(64) - 31.5), 3)
        found = localize_movie(seen, table, noise=CAMERA, background=background)
        assert least <= abs(errors(found, true)["x"].mean()) < most
        told = found.findings.get("tilted_background")
        assert (told is not None) == (slope > 0.0)
        if told is not None:
            assert told.severity == ("doubt" if background == "flat" else "note")
            assert told.numbers["slope"] == pytest.approx(slope, abs=4 * told.numbers["error"])
            assert told.numbers["sigmas"] > 20


def test_pixels_of_a_mask_are_left_out(table, counts, molecules):
    """As those that a masked array hides; with a hot pixel a molecule is where it was."""
    hot = np.zeros((SIDE, SIDE), bool)
    hot[int(molecules.row[0]) + 3, int(molecules.column[0])] = True
    seen = counts[:1] + np.where(hot, 900, 0).astype(counts.dtype)
    found = localize_movie(lm.Counts.of(seen, noise=CAMERA, mask=hot), table)
    hidden = localize_movie(np.ma.masked_array(seen, hot[None]), table, noise=CAMERA)
    np.testing.assert_array_equal(found.table, hidden.table)
    assert found.left_out == 1
    assert found.findings.get("left_out").numbers == {"saturated": 0, "left_out": 1}
    assert errors(found, molecules)[["x", "y"]].abs().max().max() < 4.5
