"""What the command line says of a lens, of a PSF and of a stack, for people and as data."""

from __future__ import annotations

import dataclasses
import json
import math
import re

import numpy as np
import pytest

import lommel as lm
from lommel.lensfiles.instrument import wide_enough
from lommel.lensfiles.microscope_files import Microscope
from lommel.report.image_quality import compare_methods
from lommel.report.optics import describe_lens, describe_stack
from lommel.show.drawing import SAMPLING
from objectives import MATCHED

LINE = re.compile(r"^(\S.*?)\s{2,}(\S.*?)\s*$", re.MULTILINE)


def stated(lenses, folder, name: str, sampling: str) -> str:
    """Write the lens file of an example that states how pixels take the light."""
    text = lenses[name].read_text(encoding="utf-8")
    line = {"": "", "pixel": "integrate = true\n", "center": "integrate = false\n"}[sampling]
    (folder / "own.toml").write_text(text.replace("[sensor]\n", f"[sensor]\n{line}"), encoding="utf-8")
    return "own.toml"


@pytest.mark.parametrize(("line", "sampling"), [("", "pixel"), ("pixel", "pixel"), ("center", "center")], ids=str)
def test_pixels_of_a_sensor_average_unless_told_otherwise(call_lommel, lenses, tmp_path, line, sampling):
    own = stated(lenses, tmp_path, "nifty-fifty", line)
    arguments = ("psf", own, "--object-distance", "1.2 m", "--shape", "21")
    shown = call_lommel(*arguments, "-o", "a.npz", folder=tmp_path)
    rows = dict(LINE.findall(shown.stdout))
    assert rows["sampling"] == SAMPLING[sampling]
    assert rows["pixel over lambda N"] == "3.398"
    made = lm.PSF.load(tmp_path / "a.npz")
    lens = lm.load_instrument(lenses["nifty-fifty"]).lens
    expected = lm.psf(lens.pupil(1.2), 21, 3.45e-6, integrate=sampling == "pixel")
    np.testing.assert_allclose(made.values, expected.values, rtol=0, atol=1e-6 * expected.values.max())
    facts = json.loads(call_lommel(*arguments, "--json", folder=tmp_path).stdout)["psf"]
    assert facts["sampling"] == made.sampling == sampling
    if sampling == "center":
        assert facts["sum"] == pytest.approx(float(expected.values.sum(dtype=float)))
        assert f"The sum of the values, {facts['sum']:.4g}, is not the light" in shown.stdout
    else:
        assert facts["sum"] is None
        assert expected.values.sum() == pytest.approx(facts["energy"], rel=1e-4)
        assert "sum to" not in shown.stdout


@pytest.mark.parametrize("obscuration", [0.0, 0.3, 0.6])
@pytest.mark.parametrize("wavefront", [(0.0, 0.0), (10.0, 0.0), (-5.0, 8.0), (60.0, -20.0)], ids=str)
@pytest.mark.parametrize("pixel", [0.4, 3.0])
def test_a_window_that_is_wide_enough_holds_about_98_per_cent(wavefront, obscuration, pixel):
    pupil = lm.Pupil(lm.Wavefront(*wavefront), obscuration=obscuration)
    side = wide_enough(pupil, pixel)
    assert side % 2
    assert 0.97 < lm.psf(pupil, side, pixel).energy < 0.9995


def test_info_tells_what_changes_over_the_field(call_lommel, lenses, tmp_path):
    facts = json.loads(call_lommel("info", lenses["camera-field"], "--json", folder=tmp_path).stdout)["field"]
    assert facts["seidel"] == {"W131": 2.0, "W222": 1.6, "W220": -0.9}
    assert [place["part"] for place in facts["places"]] == [0.0, 0.5, 0.7, 1.0]
    instrument = lm.load_instrument(lenses["camera-field"])
    for place in facts["places"]:
        pupil = instrument.field().pupil(18e-3 * place["part"], 12e-3 * place["part"])
        assert place["strehl"] == pytest.approx(lm.strehl(pupil))
        fine = lm.psf(pupil, 161, 0.25 * pupil.scale, integrate=False)
        assert place["strehl_at_peak"] == pytest.approx(fine.peak_strehl, rel=0.05)
        assert place["strehl_at_peak"] >= fine.peak_strehl - 1e-6
    assert json.loads(call_lommel("info", lenses["phone"], "--json", folder=tmp_path).stdout)["field"] is None


def test_what_lies_beyond_a_map_is_left_out(lenses, tmp_path):
    text = lenses["camera-field"].read_text(encoding="utf-8").replace("W131", 'edge = "15.5 mm"\nW131')
    (tmp_path / "own.toml").write_text(text, encoding="utf-8")
    facts = describe_lens(lm.load_instrument(tmp_path / "own.toml")).facts
    edge = 15.5e-3 / math.hypot(12e-3, 18e-3)
    assert [place["part"] for place in facts["field"]["places"]] == [0.0, 0.5, 0.7, pytest.approx(edge)]
    assert facts["field"]["places"][-1]["distance"] == pytest.approx(15.5e-3) == facts["place"]["to"]


def test_compare_takes_the_instrument_as_it_is_told_to_be(lenses):
    instrument = dataclasses.replace(lm.load_instrument(lenses["phone"]), shape=(5, 5))
    for integrate, sampling in ((None, "pixel"), (True, "pixel"), (False, "center")):
        one = dataclasses.replace(instrument, integrate=integrate)
        _, answers = compare_methods(one, [lm.methods.NijboerZernike()])
        assert {answer.sampling for answer in answers.values()} == {sampling}


def microscope(**planes) -> Microscope:
    return Microscope(MATCHED, 610e-9, 6.5e-6, depth=5e-6, emitter=lm.Scalar(), shape=(5, 6), name="oil", **planes)


def test_a_stack_is_described_plane_by_plane():
    taken = microscope(planes=3, step=0.3e-6)
    answer = lm.psf(taken.pupil(), taken.window, taken.pixel)
    found = describe_stack(answer, 0.5).facts["psf"]
    np.testing.assert_allclose(found["z"], [-0.3e-6, 0.0, 0.3e-6])
    np.testing.assert_array_equal(found["focus"], answer.pupil.focus)
    assert found["brightest"] == int(answer.values.max(axis=(1, 2)).argmax())
    assert found["energy"] == pytest.approx(answer.energy)
    assert found["shape"] == [3, 5, 6]
    assert json.loads(json.dumps(found, allow_nan=False)) == found


def test_one_plane_has_numbers_and_no_brightest():
    taken = microscope()
    found = describe_stack(lm.psf(taken.pupil(), taken.window, taken.pixel), 0.5).facts["psf"]
    assert (found["z"], found["brightest"]) == (0.0, None)
    assert found["energy"] == pytest.approx(float(lm.psf(taken.pupil(), taken.window, taken.pixel).energy))
