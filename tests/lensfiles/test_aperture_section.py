"""The section [aperture] of lens files: what it describes, and how its faults are told."""

from __future__ import annotations

import math

import numpy as np
import pytest
from astropy.io import fits
from PIL import Image

import lommel as lm
from lommel.lensfiles.lens_files import LensFileError

PLAIN = """\
name = "a"
[lens]
focal_length = "800 mm"
f_number = 4.0
wavelength = "550 nm"
[sensor]
pixel = "1 um"
shape = 9
"""


@pytest.fixture
def load(tmp_path):
    def load(section: str) -> lm.Instrument:
        (tmp_path / "lens.toml").write_text(PLAIN + section, encoding="utf-8")
        return lm.load_instrument(tmp_path / "lens.toml")

    return load


def test_vanes_have_a_width_in_metres_and_equal_angles(load):
    pupil = load('[aperture.spider]\nvanes = 3\nwidth = "2 mm"\nfirst = "90 deg"\n').pupil()
    assert pupil.spider == lm.Spider.equal(3, 0.02, math.pi / 2)


def test_vanes_may_lie_at_any_angles(load):
    pupil = load('[aperture.spider]\nangles = ["0 deg", "45 deg"]\nwidth = "2 mm"\n').pupil()
    assert pupil.spider.angles == pytest.approx((0.0, math.pi / 4))


def test_vignetting_is_an_ellipse_or_a_cats_eye(load):
    assert load('[aperture.ellipse]\na = 1\nb = 0.8\nangle = "30 deg"\n').pupil().vignetting == lm.Ellipse(
        1.0, 0.8, math.pi / 6
    )
    assert load("[aperture.cat_eye]\nshift = [0.4, 0.2]\n").pupil().vignetting == lm.CatEye((0.4, 0.2))


@pytest.mark.parametrize("suffix", [".npy", ".png", ".tif", ".fits", ".fits.gz"])
@pytest.mark.parametrize("holds", ["amplitude", "intensity"])
def test_a_mask_is_read_from_beside_the_lens_file_its_rows_downwards(load, tmp_path, suffix, holds):
    levels = np.zeros((8, 8), np.uint8)
    levels[5:, :], levels[5, 2] = 255, 51
    if suffix == ".npy":
        np.save(tmp_path / "mask.npy", levels / 255)
    elif ".fits" in suffix:
        fits.PrimaryHDU(levels / 255).writeto(tmp_path / f"mask{suffix}")
    else:
        Image.fromarray(levels).save(tmp_path / f"mask{suffix}")
    pupil = load(f'[aperture.mask]\nfile = "mask{suffix}"\nholds = "{holds}"\n').pupil()
    expected = levels / 255 if holds == "amplitude" else np.sqrt(levels / 255)
    np.testing.assert_allclose(pupil.mask.values, expected)
    # y rises with the rows: light passes where it is positive.
    assert abs(pupil.values(0.1, 0.6)[0]) == 1.0
    assert pupil.values(0.1, -0.6)[0] == 0.0


@pytest.mark.parametrize(
    ("section", "what"),
    [
        (
            "[aperture]\nvanes = 3\n",
            "aperture.vanes (line 10): unknown key; known are spider, ellipse, cat_eye, mask, telescope",
        ),
        ('[aperture.spider]\nwidth = "2 mm"\n', "aperture.spider (line 9): needs vanes"),
        ('[aperture.spider]\nwidth = "2 mm"\nvanes = 3\nangles = [0.0]\n', "exactly one of the two"),
        ('[aperture.spider]\nwidth = "2 mm"\nfirst = 0.1\nangles = [0.0]\n', "first has no meaning with angles"),
        ('[aperture.spider]\nwidth = "2 mm"\nvanes = 0\n', "aperture.spider.vanes (line 11): Input should be"),
        ('[aperture.spider]\nwidth = "2 mm"\nvanes = 3\nfirst = "1 mm"\n', "aperture.spider.first (line 12)"),
        ('[aperture.spider]\nwidth = "0 mm"\nvanes = 3\n', "aperture.spider.width (line 10): must be positive"),
        (
            '[aperture.spider]\nwidth = "2 m"\nvanes = 3\n',
            "aperture.spider.width (line 10): must be below the diameter",
        ),
        ('[aperture.spider]\nwidth = "190 mm"\nvanes = 8\n', "must leave part of the aperture clear"),
        ("[aperture.ellipse]\na = 1\nb = 1200\n", "aperture.ellipse.b (line 11): Input should be less than"),
        ("[aperture.cat_eye]\nshift = [2.0, 0.0]\n", "aperture.cat_eye (line 9): shift must be shorter than"),
        ("[aperture.cat_eye]\nshift = [0, 0]\n[aperture.ellipse]\na = 1\nb = 1\n", "one of ellipse and cat_eye"),
        ('[aperture.mask]\nfile = "nowhere.npy"\n', "aperture.mask.file (line 10): 'nowhere.npy' cannot be read"),
        ('[aperture.mask]\nfile = "lens.toml"\n', "must end in .npy, .png, .tif, .tiff, .fits,"),
        ('[aperture.mask]\nfile = "junk.fits"\n', "'junk.fits' is not a FITS image"),
        ('[aperture.mask]\nfile = "junk.npy"\n', "'junk.npy' is not an array"),
        ('[aperture.mask]\nfile = "junk.png"\n', "'junk.png' is not a picture"),
        ('[aperture.mask]\nfile = "colour.png"\n', "must be a grey picture, got one in colour"),
        ('[aperture.mask]\nfile = "oblong.npy"\n', "values must be a square array"),
        ('[aperture.mask]\nfile = "nan.npy"\n', "values"),
        ("[aperture.mask]\nfile = 3\n", "must be the name of a file"),
    ],
)
def test_a_fault_is_told_where_it_is(load, tmp_path, section, what):
    for name in ("junk.npy", "junk.png", "junk.fits"):
        (tmp_path / name).write_bytes(b"junk")
    Image.new("RGB", (4, 4)).save(tmp_path / "colour.png")
    np.save(tmp_path / "oblong.npy", np.ones((3, 4)))
    np.save(tmp_path / "nan.npy", np.full((4, 4), np.nan))
    with pytest.raises(LensFileError) as caught:
        load(section)
    assert what in str(caught.value)


BLOCKED = """\
[[aperture.blocked]]
type = "disc"
radius = "30 mm"
[[aperture.blocked]]
type = "strip"
start = ["0 m", 0.1]
end = ["300 mm", 0.1]
width = "2 mm"
[[aperture.blocked]]
type = "ellipse"
a = 0.1
b = "5 mm"
angle = "90 deg"
center = [0.5, "-20 mm"]
"""


def test_blocked_parts_are_taken_from_the_disc_in_metres_or_over_the_radius(load):
    lens = load(BLOCKED).lens  # of a radius of 100 mm
    parts = (
        lm.Disc(0.3)
        | lm.Polygon.strip((0.0, 0.1), (3.0, 0.1), 0.02)
        | lm.Ellipse(0.1, 0.05, math.pi / 2, (0.5, -0.2))
    )
    stop = lm.Disc() - parts
    assert lm.Pupil(stop=lens.stop).area == pytest.approx(lm.Pupil(stop=stop).area, rel=1e-12)
    at = np.linspace(-1, 1, 41)
    np.testing.assert_allclose(lens.stop.margin(at, at[:, None]), stop.margin(at, at[:, None]), atol=1e-12)


def test_clear_parts_are_joined(load):
    text = '[[aperture.clear]]\ntype = "disc"\nradius = 0.2\ncenter = [-0.5, 0]\n'
    text += '[[aperture.clear]]\ntype = "polygon"\ncorners = [[0.2, -0.2], [0.6, -0.2], [0.6, 0.2]]\n'
    text += '[[aperture.clear]]\ntype = "hexagon"\nradius = "10 mm"\ncenter = [0, 0.5]\n'
    area = math.pi * 0.2**2 + 0.08 + 1.5 * math.sqrt(3.0) * 0.1**2
    assert load(text).pupil().area == pytest.approx(area / math.pi, rel=1e-12)


def test_segments_have_phases_in_waves(load, tmp_path):
    text = '[aperture.segments]\nrings = 1\ngap = "1 mm"\n'
    bare = lm.Segments.hexagonal(1, 0.001 / 0.1)
    assert load(text).lens.stop == bare
    listed = load(text + "piston = [0.5, 0, 0, 0, 0, 0]\ntilt = [0, 0.25, 0, 0, 0, 0]\n").lens.stop
    assert listed == bare.phased([math.pi, 0, 0, 0, 0, 0], 0.0, [0, math.pi / 2, 0, 0, 0, 0])
    (tmp_path / "phases.txt").write_text("# piston, tip, tilt\n0.5, 0, 0\n0 0 0.25\n" + "0 0 0  # flat\n" * 4)
    assert load(text + 'file = "phases.txt"\n').lens.stop == listed
    np.savetxt(tmp_path / "pistons.txt", [0.5, 0, 0, 0, 0, 0])
    assert load(text + 'file = "pistons.txt"\n').lens.stop.piston == listed.piston


@pytest.mark.parametrize("name", sorted(lm.telescopes.DIAMETERS))
def test_a_telescope_is_named(load, name):
    lens = load(f'[aperture]\ntelescope = "{name}"\n').lens
    assert lens.stop == getattr(lm.telescopes, name)()


@pytest.mark.parametrize(
    ("section", "what"),
    [
        ('[[aperture.blocked]]\ntype = "circle"\n', "'hexagon' or 'strip', got 'circle'"),
        ('[[aperture.blocked]]\nradius = 0.1\n', "aperture.blocked.type"),
        ('[[aperture.blocked]]\ntype = "disc"\n', "aperture.blocked (line 9): a disc needs radius"),
        ('[[aperture.clear]]\ntype = "disc"\nradius = 1\nwidth = 1\n', "width has no meaning for a disc"),
        ('[[aperture.clear]]\ntype = "disc"\nradius = "1"\n', "aperture.clear.radius (line 11): '1' is a length"),
        ('[[aperture.clear]]\ntype = "disc"\nradius = true\n', "must be a length with a unit or a number"),
        ('[[aperture.clear]]\ntype = "disc"\nsize = 1\n', "aperture.clear.size (line 11): unknown key"),
        (
            '[[aperture.blocked]]\ntype = "disc"\nradius = 0.1\n[[aperture.blocked]]\ntype = "disc"\nradius = 0\n',
            "aperture.blocked, entry 2, disc (line 12): radius must be",
        ),
        ('[[aperture.blocked]]\ntype = "disc"\nradius = 1.5\n', "must leave part of the aperture clear"),
        ("[aperture.segments]\ngap = 0.1\n", "aperture.segments (line 9): gap has no meaning without rings"),
        ("[aperture.segments]\npiston = [0.1]\n", "segments needs rings or a telescope with segments"),
        ('[aperture]\ntelescope = "keck"\n[aperture.segments]\nrings = 2\n', "exactly one of them"),
        ('[aperture]\ntelescope = "vlt"\n[aperture.segments]\nrings = 2\n', "takes one of segments and telescope"),
        ('[aperture]\ntelescope = "gtc"\n', "aperture.telescope (line 10): Input should be 'elt', 'hst'"),
        ("[aperture.segments]\nrings = 1\npiston = [0.1]\n", "aperture.segments.piston (line 11): must have one"),
        ("[aperture.segments]\nrings = 1\ngap = 1.1\n", "aperture.segments (line 11): gap must leave something"),
        ('[aperture.segments]\nrings = 1\nfile = "few.txt"\n', "aperture.segments.file (line 11): must have one row"),
        ('[aperture.segments]\nrings = 1\nfile = "words.txt"\n', "line 2: must hold piston, or piston, tip and tilt"),
        ('[aperture.segments]\nrings = 1\nfile = "two.txt"\n', "one number or three in every line, got '0.1 0.2'"),
        ('[aperture.segments]\nrings = 1\nfile = "none.txt"\n', "'none.txt' holds no numbers"),
        ('[aperture.segments]\nrings = 1\nfile = "few.txt"\ntip = [0]\n', "takes file or the lists"),
    ],
)  # fmt: skip
def test_a_fault_of_a_shape_names_its_entry(load, tmp_path, section, what):
    (tmp_path / "few.txt").write_text("1\n2\n")
    (tmp_path / "words.txt").write_text("1\none\n")
    (tmp_path / "two.txt").write_text("0.1 0.2\n" * 6)
    (tmp_path / "none.txt").write_text("# nothing\n")
    with pytest.raises(LensFileError) as caught:
        load(section)
    assert what in str(caught.value)


def test_complex_numbers_are_no_intensity(load, tmp_path):
    np.save(tmp_path / "phase.npy", np.full((8, 8), 1j))
    load('[aperture.mask]\nfile = "phase.npy"\n')
    with pytest.raises(ValueError, match=r'must hold real numbers with holds = "intensity", got complex ones'):
        load('[aperture.mask]\nfile = "phase.npy"\nholds = "intensity"\n')
