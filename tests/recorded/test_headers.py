"""What images of other libraries state of camera and sampling: the same number by every way, or a sentence."""

from __future__ import annotations

import warnings

import numpy as np
import pytest

import lommel as lm
from lommel.cli.instruments import CameraNoise
from lommel.recorded.frames import Unusable, open_frames
from lommel.recorded.headers import metadata_of

nddata, fits = pytest.importorskip("astropy.nddata"), pytest.importorskip("astropy.io.fits")
xr = pytest.importorskip("xarray")
STARS = np.random.default_rng(0).poisson(300, (2, 9, 9)).astype(np.uint16)
READ = lm.Noise(read=5.0)


def header(**cards):
    return fits.Header({"EGAIN": 1.5, "RDNOISE": 5, "SATURATE": 60000, "XPIXSZ": 3.8} | cards)


def labelled(z=(0.0, 0.25, 0.5), y=0.108, x=0.108, unit="um", **more):
    sides = {"z": np.array(z), "y": y * np.arange(7), "x": x * np.arange(8)}
    stack = np.random.default_rng(1).poisson(90, (len(z), 7, 8)).astype(np.uint16)
    return xr.DataArray(
        stack, dims=("z", "y", "x"), coords={k: (k, v, {"units": unit}) for k, v in sides.items()} | more
    )


def told(job):
    with warnings.catch_warnings(record=True) as found:
        warnings.simplefilter("always")
        return job(), " ".join(str(one.message) for one in found)


def test_the_gain_of_a_header_is_the_same_by_file_container_and_command(tmp_path):
    fits.writeto(tmp_path / "a.fits", STARS, header(BUNIT="adu"))
    frames = open_frames(tmp_path / "a.fits")
    noise, saturation, _ = CameraNoise(read=5.0).resolve(frames.metadata, None)
    whole = nddata.CCDData(STARS, unit="adu", header=header())
    each = [nddata.CCDData(star, unit="adu", header=header()) for star in STARS]
    for images in (frames, whole, each):
        counts, words = told(lambda images=images: lm.Counts.of(images, noise=READ))
        assert (counts.noise, counts.stated, words) == (noise, saturation, "")
        assert counts.noise.white == 1.5
        assert counts[0].metadata["gain"] == 1.5
    assert told(lambda: frames.counts(noise=READ))[0].noise == noise
    assert (
        told(lambda: lm.Counts.of(nddata.CCDData(STARS, unit="electron", header=header()), noise=READ))[0].noise.white
        == 1.0
    )


@pytest.mark.parametrize(
    ("images", "noise", "white", "words"),
    [
        (nddata.CCDData(STARS, unit="adu"), READ, None, "No gain is known: 1 electron per count was assumed"),
        (nddata.CCDData(STARS, unit="ct"), READ, None, ""),
        (nddata.CCDData(STARS, unit="adu", header=header()), lm.Noise(white=2.5, read=5.0), 2.5, "; 2.5 was used."),
        (
            nddata.CCDData(STARS, unit="adu", header=header()),
            lm.Noise(read=2.0),
            1.5,
            "read noise of 5 electrons; 2 was",
        ),
        (nddata.CCDData(STARS, unit="adu", header={"GAIN": 120}), READ, None, "GAIN = 120, not used"),
        (xr.DataArray(STARS, dims=("z", "y", "x"), attrs={"units": "adu"}), READ, None, "No gain is known"),
    ],
)
def test_what_contradicts_the_noise_or_is_missing_is_told(images, noise, white, words):
    counts, found = told(lambda: lm.Counts.of(images, noise=noise))
    assert counts.noise.white == white
    assert words in found if words else found == ""
    with pytest.raises(ValueError, match="header of the images states gain -1"):
        lm.Counts.of(nddata.CCDData(STARS, unit="adu", header=header(EGAIN=-1)), noise=READ)


def test_coordinates_of_labelled_arrays_are_the_voxels_of_a_recording():
    wave = xr.DataArray(520, attrs={"units": "nm"})
    found = open_frames(labelled(emission=wave).transpose("x", "z", "y")).as_channels()
    assert (found.metadata["pixel"], found.metadata["step"]) == pytest.approx((108e-9, 250e-9))
    assert found.metadata["emission"] == (pytest.approx(520e-9),)
    assert "108 nm pixels, 250 nm planes apart" in " ".join(found.notes)
    held = lm.Counts.of(labelled(), noise=READ)
    assert held[0].metadata["pixel"] == pytest.approx(108e-9)
    uneven, unknown = open_frames(labelled(z=(0.0, 0.2, 1.0))), open_frames(labelled(unit="furlong"))
    assert uneven.metadata["step"] == Unusable("0.2 to 0.8 um")
    assert unknown.metadata["pixel"] == Unusable("0.108 furlong")
    assert metadata_of("stack", labelled(unit="", x=1.0))["pixel"] is None  # numbers of pixels
    lens = lm.Objective(NA=1.3, magnification=63, immersion=1.518)
    with pytest.raises(ValueError, match=r"states 0.2 to 0.8 um between planes, .*: give step="):
        lm.microscopy.deconvolve(labelled(z=(0.0, 0.2, 1.0)), lens, wavelength=6e-7, noise=READ)
    for other in (labelled(y=-0.108), labelled().isel(x=[0, 1, 2, 5, 6, 7])):
        with pytest.raises(ValueError, match=r"^images must have coordinates [xy] that rise in equal steps"):
            open_frames(other)
    with pytest.raises(ValueError, match=r"^opd must have square pixels, got coordinates in steps of 0.2 .* 0.1"):
        lm.fit_opd(labelled(y=0.2, x=0.1)[0], unit="nm", wavelength=550e-9)


def test_sizes_that_contradict_those_in_use_are_told():
    pupil = lm.Lens(focal_length=50e-3, f_number=8.0, focus_distance=2.0, wavelength=550e-9).pupil(2.0)
    sides = {k: (k, 3.8 * np.arange(5), {"units": "um"}) for k in "yx"}
    star = xr.DataArray(STARS[0, :5, :5], dims=("y", "x"), coords=sides)
    for images in (star, nddata.CCDData(star.values, unit="ct", header=header())):
        for pixel, words in ((3.8e-6, ""), (3.9e-6, "The images state pixels of 3.8 um, but 3.9 um was used.")):

            def fit(images=images, pixel=pixel):
                with pytest.raises(ValueError, match="more pixels than there are unknowns"):  # before any step
                    lm.retrieve(images, pupil, pixel=pixel, noise=READ, terms=30)

            assert told(fit)[1] == words


def test_voxels_of_beads_that_contradict_the_microscope_are_told():
    objective = lm.Objective(NA=1.3, magnification=63, immersion=1.518, sample=1.33)
    bead, microscope = labelled(z=np.arange(9) * 0.25), lm.Microscope(objective, wavelength=600e-9, pixel=6.1e-6)

    def fit(step):
        with pytest.raises(ValueError, match="more pixels than there are unknowns"):
            lm.fit_beads(bead[:, :2, :2], microscope, z=step * np.arange(9), noise=READ, terms=30, diameter=1e-7)

    words = "pixels of 108 nm in the sample, but 96.83 nm was used, and lengths across are 0.897 times as long"
    assert told(lambda: fit(0.25e-6))[1] == f"The images state {words}: correct the one that is wrong."
    words = "The images state planes 250 nm apart, but 300 nm was used, and lengths along z are 1.2 times as long:"
    assert words in told(lambda: fit(0.3e-6))[1]


def test_statements_that_contradict_a_stack_are_doubts_of_its_restoration():
    """2 % of difference are none; of one emission 5 %."""
    stack = labelled().assign_coords(emission=xr.DataArray(525.0, attrs={"units": "nm"}))
    objective = lm.Objective(NA=1.3, magnification=60, immersion=1.518, sample=1.518)
    method = lm.imaging.RichardsonLucy(steps=1, target=0.0)
    own = {"noise": READ, "direction": "up", "depth": 3e-6, "diagnosis": False, "method": method}

    def doubts(**stated):
        found, words = told(lambda: lm.microscopy.deconvolve(stack, objective, **own, **stated))
        doubts = [one for one in found.findings if one.severity == "doubt" and one.code != "not_settled"]
        assert words.count("was used") == len(doubts)  # told before, too
        return {one.code: one.text for one in doubts}

    assert doubts(step=0.254e-6, pixel=6.5e-6, wavelength=545e-9) == {}
    found = doubts(step=0.2e-6, pixel=13e-6)
    assert "planes 250 nm apart, but 200 nm was used, and lengths along z are 0.8 times" in found["contradiction"]
    assert "pixels of 108 nm in the sample, but 216.7 nm was used" in found["pixel_pitch"]
    found = doubts(wavelength=630e-9)["contradiction"]
    assert "an emission of 525 nm, but 630 nm was used, and the PSF is 1.2 times as wide" in found


def test_pixels_that_contradict_those_of_a_movie_are_a_doubt_of_its_molecules():
    objective = lm.Objective(NA=1.3, magnification=60, immersion=1.518, sample=1.33)
    pupil = objective.pupil(depth=1e-6, wavelength=525e-9)
    table = lm.localize.Table(pupil, shape=5, pixel=13e-6, z=(-1e-7, 1e-7))
    movie = labelled().rename(z="t").drop_vars("t")
    found, words = told(lambda: lm.localize.localize_movie(movie, table, noise=READ, flat=True))
    assert found.findings.get("pixel_pitch").severity == "doubt"
    assert "The images state pixels of 108 nm in the sample, but 216.7 nm was used" in words
