"""What is told of localised molecules: movies by images of tables, with one thing wrong at a time."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

import lommel as lm
import simulated_movies as simulated
from lommel.localize import LocalizeOptions, Table, checks, localize_movie
from lommel.localize.localizations import joined
from lommel.localize.movie_fits import movie_blocks

CAMERA = lm.Noise(white=0.5, read=1.5, offset=100.0)


def table_of(**changes) -> Table:
    return Table(simulated.pupil(**changes), 15, 6.5e-6, z=(-0.7e-6, 0.7e-6), tol=1e-3)


@pytest.fixture(scope="module")
def table() -> Table:
    return table_of()


def light(of: Table, frames=20, photons=800.0, background=8.0, surface=None) -> np.ndarray:
    """Electrons of frames of 100 x 100 with 16 molecules each, at other places in each; on a surface or at any z."""
    draw = np.random.default_rng(7)
    seen = np.full((frames, 100, 100), background)
    for frame in seen:
        down, across = draw.integers(-5, 6, 2)
        for row in range(20, 100, 20):
            for column in range(20, 100, 20):
                place = 7.0 + draw.uniform(-0.5, 0.5, 2)
                where = np.s_[row + down - 7 : row + down + 8, column + across - 7 : column + across + 8]
                z = draw.uniform(-5e-7, 5e-7) if surface is None else draw.normal(surface(row, column), 2e-8)
                frame[where] += photons * of(*place, z)
    return seen


@pytest.fixture(scope="module")
def mean(table) -> np.ndarray:
    return light(table)


def test_a_movie_that_is_as_stated_is_reliable(table, mean):
    found = localize_movie(CAMERA.record(mean, 1), table, noise=CAMERA)
    assert (found.converged, found.reliable, found.status) == (True, True, "converged")
    assert [each.code for each in found.findings] == ["untested"]
    assert found.findings[0].text.startswith("not excluded: ")
    assert found.summary.startswith(f"{found.kept.sum()} molecules in 20 frames, median discrepancy ")
    told = found.to_dict()
    assert told["converged"] is True
    assert (told["spots"], told["written"], told["frames"]) == (found.spots, int(found.kept.sum()), 20)
    assert told["medians"]["photons"] == np.median(found.table["photons"][found.kept])
    assert "table" not in told


@pytest.mark.parametrize("depth", [0.0, 1e-6])
def test_the_right_sign_of_the_astigmatism_is_the_likelier(depth):
    """Also of dim molecules on the cover glass, each of which alone cannot tell."""
    right, wrong = (table_of(depth=depth, aberrations=sign * simulated.ASTIGMATISM) for sign in (1.0, -1.0))
    frames = np.random.default_rng(7).poisson(light(right, 30))
    assert localize_movie(frames, right).reliable
    found = localize_movie(frames, wrong)
    assert (found.converged, found.status) == (False, "opposite_astigmatism")
    numbers = found.findings.get("opposite_astigmatism").numbers
    assert numbers["log_likelihood"] > 4.0 * numbers["error"] > 0.0
    assert 300 < numbers["molecules"] <= 480
    assert "opposite_astigmatism" not in localize_movie(frames, wrong, flat=True).findings.codes


@pytest.mark.parametrize(
    ("term", "size", "biased"), [(8, 0.2, "column"), (7, -0.2, "row"), (11, 0.15, "z"), (9, 0.03, "")]
)
def test_a_term_that_the_table_lacks_is_named(term, size, biased, table):
    """And what it moves: little of what is small."""
    other = table_of(aberrations=simulated.ASTIGMATISM + lm.Wavefront.zernike({term: size}, order="noll"))
    found = localize_movie(CAMERA.record(light(other, photons=2000.0), 3), table, noise=CAMERA)
    told = found.findings.get("other_explanation")
    assert told.severity == ("doubt" if biased else "note")
    name = next(iter(told.numbers))
    assert name.startswith(f"noll {term} ")
    assert told.numbers[name]["size"][0] == pytest.approx(size, rel=0.2)
    bias = told.numbers["bias"]
    assert max(bias, key=bias.get) == biased or max(bias.values()) < 0.5
    assert "tilted_background" not in found.findings.codes


@pytest.mark.parametrize(("short", "long", "direction"), [(0.5, 0.5, None), (0.1, 0.6, 40.0)])
def test_blur_is_named_with_its_size_and_direction(short, long, direction, table):
    """Vibration, and motion during an exposure: a Gaussian, by its transfer function."""
    y, x = np.fft.fftfreq(100)[:, None], np.fft.rfftfreq(100)
    turn = np.exp(1j * np.radians(direction or 0.0)) * (x - 1j * y)
    transfer = np.exp(-2.0 * np.pi**2 * ((long * turn.real) ** 2 + (short * turn.imag) ** 2))
    blurred = np.fft.irfft2(np.fft.rfft2(light(table, 8, 2000.0)) * transfer, (100, 100))
    found = localize_movie(CAMERA.record(np.maximum(blurred, 0.0), 3), table, noise=CAMERA)
    told = found.findings.get("other_explanation")
    assert next(iter(told.numbers)) == "blur"
    assert told.numbers["blur"]["size"][0] == pytest.approx(0.5 * (short**2 + long**2), rel=0.15)
    assert told.text.startswith("the data favour blur of 0.")
    named = [word for word in told.text.split() if "degrees" in told.text]
    assert abs(float(named[named.index("degrees") - 1]) - direction) < 6.0 if direction else not named


CHANGED = {
    "depth": lambda pupil, by: replace(pupil, depth=pupil.depth + by),
    "wavelength": lambda pupil, by: pupil.in_light(pupil.wavelength * (1.0 + by)),
    **{
        name: lambda pupil, by, name=name: replace(
            pupil, layers=replace(pupil.layers, **{name: getattr(pupil.layers, name) + by})
        )
        for name in ("sample", "immersion", "NA")
    },
}


def test_changes_are_differences_of_tables(table):
    made = checks.ChangeImages(table)
    places = np.array([7.3, 6.1]), np.array([6.6, 8.2]), np.array([-0.35e-6, 0.41e-6])
    images = made(*places)
    for name, (k, *_) in made.columns.items():
        if name == "blur":
            continue
        if k < len(checks._TERMS):
            step, (n, m) = 1e-3, checks._TERMS[k]
            waves = [simulated.ASTIGMATISM + lm.Wavefront.zernike({(n, m): by}) for by in (step, -step)]
            pupils = [simulated.pupil(aberrations=wave) for wave in waves]
        else:
            step = 0.02 * checks._CONSTANTS[name]
            pupils = [CHANGED[name](simulated.pupil(), by) for by in (step, -step)]
        ends = [Table(pupil, 15, 6.5e-6, z=table.z, tol=1e-4)(*places).astype(float) for pupil in pupils]
        difference = (ends[0] - ends[1]) / (2 * step)
        np.testing.assert_allclose(
            images[:, k], difference, rtol=0, atol=0.03 * np.abs(difference).max(), err_msg=name
        )
    assert list(made.columns)[len(checks._TERMS) :] == [*checks._CONSTANTS, "blur"]
    sizes = np.linspace(-0.5, 0.7, len(made.scales)) * made.scales
    together = np.einsum("k,nkyx->nyx", sizes, images)
    np.testing.assert_allclose(made.combined(sizes)(*places)[:, 0], together, atol=1e-6 * np.abs(together).max())


def test_excess_noise_that_is_not_stated_is_told(table, mean):
    draw = np.random.default_rng(4)
    doubled = 2.0 * draw.poisson(mean / 2.0)
    found = localize_movie(doubled, table, noise=lm.Noise(read=0.0))
    assert found.status == "excess_noise"
    assert found.findings.get("excess_noise").numbers["factor"] == pytest.approx(2.0, abs=0.1)
    assert "excess_noise" not in localize_movie(doubled, table, noise=lm.Noise(read=0.0, excess=2.0)).findings.codes


def test_molecules_beside_others_are_doubtful(table, mean):
    crowd = mean + 0.8 * np.roll(mean - 8.0, 5, 2) * (np.arange(20) % 4 == 0)[:, None, None]
    found = localize_movie(CAMERA.record(crowd, 2), table, noise=CAMERA)
    told = found.findings.get("crowded")
    assert told.severity == "doubt"
    assert told.numbers["doubtful"] == (found.doubtful & found.kept).sum()
    assert (found.table["frame"][found.doubtful & found.kept] % 4 == 0).mean() > 0.95
    assert not {"misfit", "tilted_background"} & set(found.findings.codes)


def test_crowding_comes_before_the_optics(table, mean):
    """Four movies in one: 64 molecules a frame."""
    crowd = sum(np.roll(mean - 8.0, (3 * k, 7 * k), (1, 2))[:: -1 if k % 2 else 1] for k in range(4)) + 8.0
    found = localize_movie(CAMERA.record(crowd, 2), table, noise=CAMERA)
    told = found.findings.get("crowded")
    assert (found.status, told.severity, found.findings[0]) == ("crowded", "error", told)
    assert 0.2 < told.numbers["box_by_chance"] < 0.7
    assert told.numbers["pair_by_chance"] < 0.1


@pytest.mark.parametrize(
    ("surface", "size"),
    [
        (lambda row, column: 1e-7 * (column - 50) / 50, 1.4e-7),
        (lambda row, column: 1e-7 * ((row - 50) ** 2 + (column - 50) ** 2) / 2500, 1.2e-7),
        (lambda row, column: 0.0, None),
    ],
)
def test_a_focal_surface_that_is_tilted_or_curved_is_told(surface, size, table):
    """Of molecules on a membrane, as a membrane in a flat one; and never corrected."""
    found = localize_movie(CAMERA.record(light(table, 8, 2000.0, surface=surface), 3), table, noise=CAMERA)
    told = found.findings.get("not_flat")
    assert (told is None, found.reliable) == ((False, False) if size else (True, True))
    if size:
        assert told.numbers["size"] == pytest.approx(size, rel=0.25)
        assert found.findings[0] is told


def test_a_focal_surface_that_was_named_is_stated_and_taken_off(table):
    """As of beads on the glass, whose finding is the section of the file; then of another movie."""
    tilted = light(
        table, 8, 2000.0, surface=lambda row, column: 1.5e-7 * (column - 50) / 50 + 5e-8 * (row / 50 - 1) ** 2
    )
    told = localize_movie(CAMERA.record(tilted, 3), table, noise=CAMERA).findings.get("not_flat")
    terms = told.numbers["surface"]
    assert [terms[name] for name in ("x", "y", "xx", "xy", "yy")] == pytest.approx([1.5e-7, 0, 0, 0, 5e-8], abs=3e-8)
    assert f'[focal_surface] frame = [100, 100], terms = {{ x = "{1e9 * terms["x"]:.3g} nm", y = ' in told.text
    surface = lm.localize.FocalSurface((100, 100), terms)
    found = localize_movie(CAMERA.record(tilted, 4), table, noise=CAMERA, surface=surface)
    assert found.findings.codes == ("untested",)
    assert "focal surface" not in found.message
    pulls = found.table["z"][found.kept] / np.hypot(2e-8, found.table["z_error"][found.kept])
    assert np.sqrt(np.mean(pulls**2)) < 1.3


@pytest.mark.parametrize(
    ("along", "frame", "wanted"), [("z", (100, 90), "frame is"), ("depth", (100, 100), "along depth")]
)
def test_a_focal_surface_of_another_frame_or_along_the_depth_is_refused(along, frame, wanted):
    images = Table(simulated.pupil(), 15, 6.5e-6, z=(1e-6, 1.1e-6), along=along, tol=1e-2)
    with pytest.raises(ValueError, match=wanted):
        localize_movie(np.ones((1, 100, 100)), images, surface=lm.localize.FocalSurface(frame, {"x": 1e-7}))


def test_structure_of_the_background_is_the_cause_rather_than_the_optics(table, mean):
    y, x = np.mgrid[:100, :100]
    outline = mean + 40.0 * np.exp(-(((np.hypot(y - 50, x - 50) - 30.0) / 1.5) ** 2))
    found = localize_movie(CAMERA.record(outline, 2), table, noise=CAMERA)
    assert found.findings[0].code in ("misfit", "crowded")
    assert "background that is not flat" in found.message or "the background is not flat" in found.message
    assert "sign of the astigmatism" not in found.message


@pytest.mark.parametrize(
    ("changes", "code", "severity"),
    [({"white": 1.5}, "misfit", "error"), ({"white": 0.1}, "too_quiet", "doubt"),
     ({"offset": 125.0}, "below_offset", "doubt")],
)  # fmt: skip
def test_a_wrong_camera_is_told(changes, code, severity, table, mean):
    stated = {"white": 0.5, "read": 1.5, "offset": 100.0} | changes
    found = localize_movie(CAMERA.record(mean[:10], 1), table, noise=lm.Noise(**stated))
    assert found.findings.get(code).severity == severity


def test_full_pixels_are_left_out_and_told(table, mean):
    counts = np.minimum(CAMERA.record(10.0 * mean, 1), 700.0)
    found = localize_movie(lm.Counts.of(counts, noise=CAMERA, saturation=700.0), table)
    assert found.findings.get("left_out").numbers == {"saturated": found.saturated, "left_out": 0}
    assert found.saturated > 100
    assert found.converged


def test_clipping_that_is_not_stated_comes_before_crowding_and_the_optics(table, mean):
    found = localize_movie(np.minimum(CAMERA.record(10.0 * mean, 1), 700.0), table, noise=CAMERA)
    doubts = [each.code for each in found.findings if each.severity == "doubt"]
    assert doubts[0] == "flat_top"
    assert found.message.split(": ")[1].endswith("pixels have exactly the largest value, 700")


def test_a_wavefront_that_leaves_the_sign_of_z_open_is_told(mean):
    plain = table_of(aberrations=lm.Wavefront.zernike({8: 0.1}, order="noll", unit="waves"))
    assert localize_movie(mean[:1], plain).findings.get("sign_open").severity == "doubt"
    assert localize_movie(mean[:1], plain, flat=True).findings.get("sign_open") is None


def test_a_pixel_that_is_not_of_the_camera_is_told(mean):
    one = Table(simulated.pupil(), 15, 0.1e-6, z=(-0.7e-6, 0.7e-6), tol=1e-3)
    assert localize_movie(mean[:1], one).findings.get("pixel_pitch").severity == "doubt"


def test_fits_at_the_ends_of_z_are_told(mean):
    one = Table(simulated.pupil(), 15, 6.5e-6, z=(-0.2e-6, 0.2e-6), tol=1e-3)
    found = joined(list(movie_blocks(CAMERA.record(mean[:5], 1), one, CAMERA, LocalizeOptions(), block=2)))
    assert found.findings.get("z_range").numbers == {"ends": found.ends, "spots": found.spots}
    assert found.ends > 0.3 * found.spots


def test_spots_in_the_same_place_of_many_frames_are_counted(table):
    """Where one pixel is bright in every frame, or in some, or in few; and nowhere in a short movie."""
    frames = np.random.default_rng(0).poisson(5.0, (40, 70, 70)).astype(float)
    frames[:, 20, 33] += 400.0
    frames[::2, 50, 30] += 400.0
    frames[::5, 50, 55] += 400.0
    *_, last = movie_blocks(frames, table, None, LocalizeOptions(), block=6)
    (one, other) = last.findings.get("recurring").numbers["places"]
    assert one[2] == 40
    assert abs(np.subtract(one[:2], (20, 33))).max() <= 2
    assert other[2] == 20
    assert abs(np.subtract(other[:2], (50, 30))).max() <= 2
    assert localize_movie(frames[:15], table).findings.get("recurring") is None


def test_a_movie_without_molecules_has_no_answer(table):
    found = localize_movie(np.random.default_rng(0).poisson(5.0, (4, 40, 40)), table)
    assert (found.status, found.converged, found.summary) == ("no_light", False, "0 molecules in 4 frames")
    assert len(found) == 0


def test_spots_that_are_all_at_the_border_are_not_called_too_dim(table):
    frames = np.random.default_rng(0).poisson(5.0, (4, 40, 40)).astype(float)
    frames[:2, 3, 20] += 400.0
    found = localize_movie(frames, table)
    side = table.shape[0]
    assert (found.status, found.converged, found.borders) == ("not_settled", False, 2)
    assert (
        f"none of 2 spots can be fitted: boxes of {side} x {side} pixels reach beyond the border at 2"
        in found.message
    )


def test_findings_of_blocks_are_of_the_movie_so_far(table, mean):
    counts = CAMERA.record(mean, 1)
    *parts, last = movie_blocks(counts, table, CAMERA, LocalizeOptions(), block=6)
    assert last.summary == localize_movie(counts, table, noise=CAMERA).summary
    assert [part.summary.split(" in ")[0] for part in parts] != [last.summary.split(" in ")[0]] * 3
