"""Plans: a question asked of many pupils."""

from __future__ import annotations

import copy
import dataclasses
import pickle
import subprocess
import sys
import tracemalloc
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

import lommel as lm
from lommel.methods import LAYERED, METHODS, ChordalGauss, Hankel, NijboerZernike
from lommel.paper import Fraunhofer, Geometric, LommelSeries


def test_a_plan_answers_what_psf_answers():
    plan = lm.Plan((33, 40), 0.4, normalize="peak", dtype=np.float64)
    for pupil in (lm.Pupil(), lm.Pupil(lm.Wavefront(7.0), obscuration=0.3), lm.Pupil(lm.Wavefront([1.0, 2.0]))):
        expected = lm.psf(pupil, (33, 40), 0.4, normalize="peak", dtype=np.float64)
        assert np.array_equal(plan(pupil).values, expected.values)


def test_a_plan_forgets_the_pupil_it_was_asked_about_before():
    coma, lens = lm.Wavefront(3.0, nonradial={(3, 1): 1.0}), {"wavelength": 5e-4, "f_number": 2.0}
    pupils = [
        lm.Pupil(lm.Wavefront(3.0)),
        lm.Pupil(lm.Wavefront(3.0), obscuration=0.3),
        lm.Pupil(lm.Wavefront(3.0), apodization=1.0),
        lm.Pupil(lm.Wavefront([3.0])),
        lm.Pupil(coma),
        lm.Pupil(lm.Wavefront(3.0), **lens),
        lm.Pupil(lm.Wavefront(3.0), **lens | {"f_number": 3.0}),
        lm.Pupil(lm.Wavefront(3.0), **lens | {"wavelength": 6e-4}),
        lm.Pupil(lm.Wavefront(3.0)),
    ]
    for normalize in ("energy", "strehl", "peak"):
        plan = lm.Plan(9, 1e-3, normalize=normalize)
        for pupil in (*pupils, *pupils[::-1]):
            answer, expected = plan(pupil), lm.Plan(9, 1e-3, normalize=normalize)(pupil)
            assert np.array_equal(answer.values, expected.values)
            assert (answer.grid, answer.method) == (expected.grid, expected.method)
            assert answer.error_bound == expected.error_bound
            assert np.array_equal(answer.scale, expected.scale)


def test_a_plan_forgets_whether_a_microscope_had_aberrations():
    water = {"immersion": 1.33, "sample": 1.33, "working_distance": 0.2e-3, "coverslip": None}
    objective = lm.Objective(NA=1.2, magnification=60, **water)
    coma = lm.Wavefront.zernike({(3, 1): 0.1}, unit="waves")
    for emitter in (lm.Beam("x"), "isotropic"):
        plain = objective.pupil(depth=0.0, z=0.0, wavelength=520e-9, emitter=emitter)
        on_top = objective.pupil(depth=0.0, z=0.0, wavelength=520e-9, emitter=emitter, aberrations=coma)
        plan = lm.Plan(5, 6e-6)
        for pupil in (plain, on_top, plain):
            assert np.array_equal(plan(pupil).values, lm.Plan(5, 6e-6)(pupil).values)


def test_calls_with_what_another_had_answer_as_if_it_had_not_been():
    pupil, other = lm.Pupil(lm.Wavefront(3.0)), lm.Pupil(lm.Wavefront(4.0), obscuration=0.2)
    first = lm.psf(pupil, 1, 0.5)
    kept = first.values.copy()
    assert not np.array_equal(lm.psf(other, 1, 0.5).values, kept)
    assert np.array_equal(first.values, kept)
    assert lm.psf(pupil, 1, 0.5, dtype="float64").values.dtype == np.float64
    assert lm.psf(pupil, 1, 0.5, method="hankel").method == Hankel()
    # What is equal to an argument that was taken, and is none.
    for given, name in (({"shape": True}, "shape"), ({"pixel": True}, "pixel"), ({"method": []}, "method")):
        with pytest.raises(TypeError, match=f"{name} must be"):
            lm.psf(**{"pupil": pupil, "shape": 1, "pixel": 1} | given)
    with pytest.raises(TypeError, match="threads must be"):
        lm.psf(pupil, 1, 1.0, threads=True)


def test_a_plan_refuses_a_pupil_whatever_it_took_before():
    plan = lm.Plan(9, 0.5, method="lommel-series")
    plan(lm.Pupil(lm.Wavefront(3.0)))
    with pytest.raises(ValueError, match="supports defocus only"):
        plan(lm.Pupil(lm.Wavefront(3.0, 1.0)))
    with pytest.raises(TypeError, match="pupil must be a Pupil, got a Wavefront"):
        plan(lm.Wavefront(3.0))
    with pytest.raises(ValueError, match="more than the limit"):
        lm.Plan(16384, 0.5)(lm.Pupil(lm.Wavefront(np.zeros(9))))


@pytest.mark.parametrize("defocus", [3.0, [3.0, 4.0], [[3.0], [4.0]]])
def test_the_answer_of_a_plan_is_what_the_constructor_makes_of_its_parts(defocus):
    answer = lm.Plan(9, 0.5)(lm.Pupil(lm.Wavefront(defocus)), derivatives=("defocus",))
    made = lm.PSF(**{item.name: getattr(answer, item.name) for item in dataclasses.fields(lm.PSF)})
    assert type(answer) is type(made)
    assert list(vars(answer)) == list(vars(made))
    assert all(vars(answer)[name] is part for name, part in vars(made).items())
    assert answer.scale.shape == np.shape(defocus)
    assert type(answer.error_bound) is float
    others = [
        copy.copy(answer),
        copy.deepcopy(answer),
        pickle.loads(pickle.dumps(answer)),
        dataclasses.replace(answer),
    ]
    for other in (made, *others):
        assert repr(other) == repr(answer)
        assert other.pupil == answer.pupil
        for name in ("values", "scale"):
            assert np.array_equal(getattr(other, name), getattr(answer, name))
        assert np.array_equal(other.derivatives["defocus"], answer.derivatives["defocus"])
    with pytest.raises(dataclasses.FrozenInstanceError):
        answer.values = made.values


SHORT = {
    "plain": {},
    "obscured": {"obscuration": 0.4},
    "apodized": {"apodization": 1.5},
    "any amplitude": {"apodization": lm.Apodization([0.0, 0.5, 0.2]), "obscuration": 0.2},
    "a stack": {"wavefront": lm.Wavefront([[1.0, 2.0], [3.0, 4.0], [5.0, 60.0]], 2.0)},
    "a stack of one": {"wavefront": lm.Wavefront([3.0])},
    "zeros that depend on the direction": {"wavefront": lm.Wavefront(4.0, nonradial={(3, 1): 0.0})},
    "higher orders": {"wavefront": lm.Wavefront.zernike({(2, 0): 1.0, (6, 0): 0.5, (10, 0): -0.7})},
}


@pytest.mark.parametrize("normalize", ["energy", "strehl", "peak"])
@pytest.mark.parametrize("asked", [{}, {"integrate": True}, {"center": (3.3, 5.0)}, {"dtype": float, "tol": 1e-9}])
@pytest.mark.parametrize("name", SHORT)
def test_the_shortcut_of_a_plan_leads_where_the_method_does(name, asked, normalize):
    pupil = lm.Pupil(**({"wavefront": lm.Wavefront(7.0, 1.0)} | SHORT[name]))
    plan = lm.Plan((9, 8), 0.7, normalize=normalize, **asked)
    answer = plan(pupil)
    scale, bound = plan._prepared.shortcut(pupil, values := np.empty_like(answer.values))
    method, images, _ = plan._prepared.images(pupil)
    assert answer.method == method
    assert answer.values.tobytes() == images.values.tobytes() == values.tobytes()
    assert answer.scale.shape == pupil.shape
    assert answer.scale.tobytes() == images.scale.tobytes() == scale.tobytes()
    assert answer.error_bound == images.error.max() == bound


@pytest.mark.parametrize(
    ("pupil", "center", "there"),
    [
        (lm.Pupil(lm.Wavefront(3.0, error=1e-9)), None, True),
        (lm.Pupil(apodization=lm.Apodization([1.0], error=1e-9)), None, False),
        (lm.Pupil(lm.Wavefront(3.0, nonradial={(3, 1): 1.0})), None, False),
        (lm.Pupil(lm.Wavefront([3.0, 4.0])), ([3.0, 4.0], 5.0), False),
    ],
)
def test_what_has_no_shortcut_is_asked_of_the_method(pupil, center, there):
    plan = lm.Plan(9, 0.5, center=center, method="nijboer-zernike")
    answer = plan(pupil)
    shortcut = plan._prepared.shortcut
    assert (shortcut is not None) == there
    assert not there or shortcut(pupil, np.empty_like(answer.values)) is None
    images = plan._prepared.images(pupil, ())[1]
    assert answer.values.tobytes() == images.values.tobytes()
    assert answer.error_bound == images.error.max()


def test_a_plan_that_was_asked_can_be_copied_and_sent_to_other_processes():
    pupil, plan = lm.Pupil(lm.Wavefront(3.0)), lm.Plan(9, 0.5)
    expected = plan(pupil).values
    for other in (copy.copy(plan), copy.deepcopy(plan), pickle.loads(pickle.dumps(plan))):
        assert np.array_equal(other(pupil).values, expected)


def test_a_plan_that_a_thread_holds_to_the_end_of_the_process_goes_quietly():
    code = """
import threading, lommel as lm
plan = lm.Plan(9, 0.5)
plan(lm.Pupil())
threading.Thread(target=lambda held=plan: threading.Event().wait(), daemon=True).start()
"""
    ended = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert (ended.stdout, ended.stderr) == ("", "")


def test_one_plan_serves_many_threads():
    plan, pupils = lm.Plan(33, 0.5), [lm.Pupil(lm.Wavefront(0.1 * k), obscuration=k % 2 / 3) for k in range(40)]
    expected = [lm.psf(pupil, 33, 0.5).values for pupil in pupils]

    def ask(k: int) -> np.ndarray:
        return plan(pupils[k % 40], out=np.empty((33, 33), np.float32)).values

    with ThreadPoolExecutor(4) as pool:
        for k, values in enumerate(pool.map(ask, range(400))):
            assert np.array_equal(values, expected[k % 40])


def test_out_receives_the_values_and_is_the_answer():
    out = np.full((2, 33, 33), np.nan, np.float32)
    pupil = lm.Pupil(lm.Wavefront([3.0, 4.0]))
    answer = lm.Plan(33, 0.5)(pupil, out=out)
    assert answer.values is out
    assert np.array_equal(out, lm.psf(pupil, 33, 0.5).values)


def test_after_the_first_call_nothing_large_is_allocated():
    plan, out = lm.Plan(512, 0.5, threads=1), np.empty((512, 512), np.float32)
    pupils = [lm.Pupil(lm.Wavefront(c)) for c in (10.0, 11.0, 12.0)]
    for pupil in pupils:
        plan(pupil, out=out)
    tracemalloc.start()
    for pupil in pupils:
        plan(pupil, out=out)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert peak < 20_000


@pytest.mark.parametrize(
    ("out", "error", "message"),
    [
        (np.empty((33, 32), np.float32), ValueError, r"out must have the shape \(33, 33\), got \(33, 32\)"),
        (np.empty((33, 33), np.float64), ValueError, "out must be of float32, got float64"),
        (np.empty((33, 33), ">f4"), ValueError, "out must be of float32, got >f4"),
        (np.empty((33, 66), np.float32)[:, ::2], ValueError, "writable, got an array of other strides"),
        (np.broadcast_to(np.float32(0), (33, 33)), ValueError, "out must be C-contiguous and writable"),
        (np.frombuffer(bytes(4 * 33 * 33), np.float32).reshape(33, 33), ValueError, "got a read-only array"),
    ],
)
def test_an_out_that_cannot_hold_the_answer_is_refused(out, error, message):
    plan = lm.Plan(33, 0.5)
    for _ in range(2):
        with pytest.raises(error, match=message):
            plan(lm.Pupil(), out=out)
        plan(lm.Pupil())


@pytest.mark.parametrize("tol", [1e-3, 1e-6, 1e-9])
def test_a_tolerance_is_that_of_the_method_chosen_or_named(tol):
    coma = lm.Pupil(lm.Wavefront(nonradial={(3, 1): 2.0}))
    for pupil, method in ((lm.Pupil(lm.Wavefront(3.0)), NijboerZernike), (coma, ChordalGauss)):
        exact = lm.psf(pupil, 33, 0.3, method=method(1e-11), dtype="float64")
        for named in (None, method(), method(1e-5)):
            answer = lm.Plan(33, 0.3, method=named, tol=tol)(pupil)
            assert answer.method == method(tol)
            assert answer.values.dtype == (np.float32 if tol >= 1e-6 else np.float64)
            assert lm.peak_error(answer, exact) <= answer.error_bound <= tol
    assert lm.psf(coma, 33, 0.3, tol=tol).method == ChordalGauss(tol)
    assert lm.psf(coma, 33, 0.3, method=NijboerZernike(tol)).method.tol == tol


def test_a_tolerance_for_a_method_without_one_is_refused():
    for method in (Geometric(), Fraunhofer(), LommelSeries()):
        with pytest.raises(ValueError, match=f"tol=0.001 must be left out for {type(method).__name__}, which has no"):
            lm.psf(lm.Pupil(), 9, 0.5, tol=1e-3, method=method)


@pytest.mark.parametrize("name", [*METHODS, *LAYERED])
def test_a_method_is_called_by_its_name_too(name):
    assert lm.Plan(5, 0.5, method=name).method == (METHODS | LAYERED)[name]()
