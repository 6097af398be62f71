"""Files of microscopes: what they may say, and how every fault in them is told with its key and line."""

from __future__ import annotations

import dataclasses
import math
import re
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

import lommel as lm
from lommel.io.zernike_tables import ZernikeTable
from lommel.lensfiles.microscope_files import describes_microscope
from lommel.lensfiles.toml_files import LensFileError
from lommel.optics.layers.stratified import Design

EXAMPLES = sorted((Path(__file__).resolve().parents[2] / "examples" / "objectives").glob("*.toml"))
PLAIN = """\
name = "oil"
source = "nobody"

[objective]
NA = 1.3
magnification = 60
working_distance = "0.2 mm"
immersion = 1.518

[coverslip]
index = 1.5255
thickness = "170 um"

[sample]
index = 1.33
depth = "2 um"

[emission]
wavelength = "520 nm"

[stack]
planes = 5
step = "200 nm"
origin = "paraxial"

[sensor]
pixel = "6.5 um"
shape = 9
"""


@pytest.fixture
def load(tmp_path: Path):
    """Write the file of a microscope with other lines in place of some, and load it."""

    def write_and_load(*changes: tuple[str, str], more: str = "") -> lm.Microscope:
        text = PLAIN + more
        for old, new in changes:
            assert old in text
            text = text.replace(old, new, 1)
        file = tmp_path / "objective.toml"
        file.write_text(text, encoding="utf-8")
        return lm.load_microscope(file)

    return write_and_load


def fault(load, *changes: tuple[str, str], more: str = "") -> str:
    """The message about a faulty file, after its path."""
    with pytest.raises(LensFileError) as caught:
        load(*changes, more=more)
    path, message = str(caught.value).split("objective.toml: ", 1)
    assert Path(path).is_dir()
    return message


def test_a_file_says_what_the_python_would(load):
    found = load()
    objective = lm.Objective(
        NA=1.3,
        magnification=60,
        immersion=1.518,
        working_distance=0.2e-3,
        coverslip=lm.Layer(1.5255, 170e-6),
        sample=1.33,
    )
    z = np.array([-400e-9, -200e-9, 0.0, 200e-9, 400e-9])
    assert found.objective == objective
    assert (found.name, found.source, found.window, found.pixel) == ("oil", "nobody", (9, 9), 6.5e-6)
    np.testing.assert_allclose(found.z, z, atol=1e-15)
    assert found.pupil() == objective.pupil(depth=2e-6, z=found.z, wavelength=520e-9, origin="paraxial")


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
def test_every_example_loads_and_says_where_its_figures_come_from(path):
    found = lm.load_microscope(path)
    assert len(found.name) > 12
    assert re.search(r"RRID SCR_\d{6}|list of objectives", found.source)
    assert found.planes > 1
    # Its name has the magnification and the aperture.
    assert f"{found.objective.magnification:g}x" in path.stem
    assert path.stem == "zeiss-63x-astigmatic" or f"-{found.objective.NA:g}" in path.stem
    assert 0.05e-3 < found.objective.working_distance < 20e-3
    assert lm.load_microscope(str(path)) == found


def test_a_file_without_a_stack_has_one_plane_at_the_brightest_focus(load):
    stack = PLAIN[PLAIN.index("[stack]") : PLAIN.index("[sensor]")]
    found = load((stack, ""))
    assert found.pupil().shape == ()
    assert found.pupil().focus == found.objective.focus(2e-6, wavelength=520e-9).brightest


def test_films_are_from_the_glass_to_the_sample_and_the_design_is_what_it_says(load):
    films = '[[films]]\nindex = 2.0\nthickness = "50 nm"\n[[films]]\nindex = 1.46\nthickness = "100 nm"\n'
    found = load(more=f'[design]\nimmersion = 1.515\n[design.coverslip]\nindex = 1.52\nthickness = "160 um"\n{films}')
    assert found.objective.films == (lm.Layer(2.0, 50e-9), lm.Layer(1.46, 100e-9))
    assert found.objective.design == Design(1.515, lm.Layer(1.52, 160e-6))
    alone = load(more="[design]\nimmersion = 1.515\n").objective
    assert alone.design == Design(1.515, alone.coverslip)


@pytest.mark.parametrize(("value", "powers"), [("0.5", (0.5,)), ("[0.4, -0.1]", (0.4, -0.1))])
def test_an_amplitude_is_a_number_or_powers_and_is_written_again(load, tmp_path, value, powers):
    made = load(("immersion = 1.518", f"immersion = 1.518\napodization = {value}"))
    light = lm.Apodization(powers)
    rho = np.array([0.3, 1.0])
    layers = made.pupil().layers
    np.testing.assert_allclose(np.exp(-layers.apodization((layers.NA * rho) ** 2)), light.value(rho), rtol=1e-14)
    made.save(tmp_path / "again.toml")
    assert lm.load_microscope(tmp_path / "again.toml").pupil() == made.pupil()


def test_a_focal_surface_is_written_again_and_faults_are_named(load, tmp_path):
    surface = '[focal_surface]\nframe = [100, 80]\nterms = { x = "0.1 um", yy = "-20 nm" }\n'
    made = load(more=surface)
    made.save(tmp_path / "again.toml")
    again = lm.load_microscope(tmp_path / "again.toml").focal_surface
    assert again == made.focal_surface == lm.localize.FocalSurface((100, 80), {"x": 1e-7, "yy": -2e-8})
    # At the last pixel of the first row u is 79/80, v is -99/100.
    assert again.z(0.0, 79.0) == pytest.approx(1e-7 * 79 / 80 - 2e-8 * 0.99**2, rel=1e-12)
    assert "frame" in fault(load, more=surface.replace("[100, 80]", "[0, 80]"))


def test_a_dipole_whose_light_was_computed_is_written_again(load, tmp_path):
    made = dataclasses.replace(load(), emitter=lm.Dipole(0.5 * math.pi, 0.25, wobble=0.75))
    assert made.pupil().emitter.moments.shape == (3, 3)
    made.save(tmp_path / "again.toml")
    again = lm.load_microscope(tmp_path / "again.toml").emitter
    assert (again.polar, again.azimuth, again.wobble) == pytest.approx((0.5 * math.pi, 0.25, 0.75), rel=1e-11)


def test_an_objective_that_dips_has_no_cover_glass(load):
    glass = PLAIN[PLAIN.index("[coverslip]") : PLAIN.index("[sample]")]
    found = load(("immersion = 1.518", "immersion = 1.333\ndipping = true"), ("1.3\n", "0.8\n"), (glass, ""))
    assert found.objective.coverslip is None
    missing = fault(load, (glass, ""))
    assert missing == "[coverslip] is missing; it may be left out only for an objective with dipping = true"
    assert "must be left out for an objective that dips" in fault(load, ("= 1.518", "= 1.518\ndipping = true"))


@pytest.mark.parametrize(
    ("more", "emitter"),
    [
        ('emitter = "isotropic"', lm.Dipole(0.0, 0.0, wobble=1.0)),
        ('emitter = "scalar"', lm.Scalar()),
        (
            '[emission.dipole]\npolar = "90 deg"\nazimuth = 0.5\nwobble = 0.25',
            lm.Dipole(math.pi / 2, 0.5, wobble=0.25),
        ),
        ("[emission.beam]", lm.Beam()),
        ('[emission.beam]\npolarization = "x"', lm.Beam("x")),
    ],
)
def test_what_emits_is_a_name_or_a_section(load, more, emitter):
    assert load(('"520 nm"\n', f'"520 nm"\n{more}\n')).emitter == emitter


def test_a_window_that_is_not_named_holds_the_rays_and_a_margin(load):
    found = load(("shape = 9", ""))
    assert found.shape is None
    assert found.window[0] == found.window[1]
    half = found.window[0] // 2 * found.pixel
    assert half >= float(found.pupil().geometric_radius().max())
    assert dataclasses.replace(found, planes=2, step=1e-3, depth=0.0, origin="coverslip").window == (513, 513)


@pytest.mark.parametrize(
    ("old", "new", "where", "what"),
    [
        ("NA = 1.3", "NA = 1.3\nna = 1.3", "objective.na (line 6)", "unknown key; did you mean NA?"),
        ("immersion = 1.518", "immersion = 0.9", "objective.immersion (line 8)", "a refractive index from 1 to 4"),
        ('depth = "2 um"', 'depth = "2 m"', "sample.depth (line 16)", 'for 2 um write "2 um"'),
        ('depth = "2 um"', 'depth = "2"', "sample.depth (line 16)", "write for example '2 um'"),
        ('"520 nm"', '"520 m"', "emission.wavelength (line 19)", 'for 520 nm write "520 nm"'),
        ('"200 nm"', '"0 nm"', "stack.step (line 23)", "not 0 and below 10 mm"),
    ],
)  # fmt: skip
def test_a_bad_entry_is_told_with_its_key_and_line(load, old, new, where, what):
    message = fault(load, (old, new))
    assert message.startswith(f"{where}: ")
    assert what in message
    assert "\n" not in message


@pytest.mark.parametrize(
    ("old", "new", "what"),
    [
        ("NA = 1.3", "NA = 1.6", "NA must be below the index of immersion, 1.518, got 1.6"),
        ('"0.2 mm"', '"0.2 m"', "working_distance is in metres"),
        ('depth = "2 um"', 'depth = "300 um"', "must be at most 200 um, where the objective touches the cover"),
        ("[sensor]", '[[films]]\nindex = 1.4\nthickness = "3 um"\n[sensor]', "films[0].thickness"),
        ("[sensor]", '[design.coverslip]\nindex = 1.5\nthickness = "1 um"\n[sensor]', ""),
        ("[sensor]", '[design.coverslip]\nindex = 1.2\nthickness = "1 um"\n[sensor]', "design.coverslip, 1.2"),
    ],
)
def test_what_cannot_be_together_is_told_in_the_words_of_the_library(load, old, new, what):
    if what:
        assert what in fault(load, (old, new))
    else:
        load((old, new))


def test_a_lens_is_no_microscope(load, lenses, tmp_path):
    load()
    assert describes_microscope(tmp_path / "objective.toml")
    assert not describes_microscope(lenses["phone"])


ZERNIKE = """\
[aberrations.zernike]
order = "noll"
unit = "nm"
normalization = "rms"

[aberrations.zernike.terms]
6 = 52.0
11 = -10.4
"""
MEASURED = lm.Wavefront.zernike({6: 0.1, 11: -0.02}, order="noll", unit="waves")


def same(one: lm.Wavefront | None, two: lm.Wavefront) -> bool:
    assert one is not None
    return all(np.all(np.abs(c) < 1e-12) for c in (one - two).to_zernike().values())


def test_zernike_terms_are_those_of_a_lens_file_at_the_wavelength_of_the_emission(load, tmp_path):
    found = load(more=ZERNIKE)
    assert same(found.aberrations, MEASURED)
    assert found.pupil() == dataclasses.replace(load(), aberrations=found.aberrations).pupil()
    assert same(found.pupil().aberrations, MEASURED)
    in_waves = ZERNIKE.replace('"nm"', '"waves"').replace("52.0", "0.1").replace("-10.4", "-0.02")
    assert same(load(more=in_waves).aberrations, MEASURED)
    elsewhere = in_waves.replace("\n\n", '\nwavelength = "1040 nm"\n\n')
    assert same(load(more=elsewhere).aberrations, 2.0 * MEASURED)
    assert load().aberrations is None
    assert load(more="[aberrations]\n").aberrations is None


@pytest.mark.parametrize("name", ["a.csv", "a.toml", "a.json"])
def test_a_table_that_lommel_wrote_may_stand_beside_the_file(load, tmp_path, name):
    table = ZernikeTable({6: 0.1, 11: -0.02}, "noll", "waves", "rms", wavelength=520e-9)
    lm.save_zernike(tmp_path / name, table)
    beside = f'[aberrations.zernike]\nfile = "{name}"\n'
    assert same(load(more=beside).aberrations, MEASURED)
    (tmp_path / "objective.toml").write_text(PLAIN + beside.replace("a.", "../a."), encoding="utf-8")
    with pytest.raises(LensFileError, match="must lie in the folder of the lens file"):
        lm.load_microscope(tmp_path / "objective.toml", folder_only=True)


def test_terms_of_too_high_a_degree_are_told(load):
    high = ZERNIKE.replace('"noll"', '"nm"').replace("6 =", '"32,2" =').replace("11 =", '"2,2" =')
    assert "aberrations must have terms up to degree 30, got (n, m) = (32, 2)" in fault(load, more=high)


def test_errors_of_fitted_terms_are_in_waves_and_written_beside_the_others(load, tmp_path):
    plain = load()
    names = "objective", "wavelength", "emitter", "pixel", "aberrations"
    found = SimpleNamespace(
        **{name: getattr(plain, name) for name in names}, errors={(3, 1): 0.2 * math.pi, "depth": 1e-7}
    )
    fitted = plain.fitted(found)
    assert fitted.errors == {"noll 8": pytest.approx(0.1), "depth": 1e-7}
    fitted.save(tmp_path / "fitted.toml")
    plain.save(tmp_path / "plain.toml")
    text = (tmp_path / "fitted.toml").read_text("utf-8")
    assert text.split("[errors]\n")[1].split() == ['"noll', '8"', "=", "0.1", '"depth"', "=", "1e-07"]
    assert "[errors]" not in (tmp_path / "plain.toml").read_text("utf-8")
