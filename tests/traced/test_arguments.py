"""Plan.traced: its arguments, its refusals and its imports."""

from __future__ import annotations

import pickle
import subprocess
import sys
import types

import numpy as np
import pytest

import lommel as lm
from lommel.traced.namespaces import Namespace

RANGE = lm.Pupil(lm.Wavefront([-10.0, 10.0]))
LENS = lm.Lens(focal_length=50e-3, f_number=8.0, focus_distance=2.0, wavelength=550e-9)


def test_importing_the_package_and_tracing_in_numpy_load_no_framework():
    code = (
        "import sys, lommel as lm; lm.Plan(5, 0.5).traced(lm.Pupil(lm.Wavefront([-1.0, 1.0])))([0.5, 0.0]);"
        "print(*{name.partition('.')[0] for name in sys.modules})"
    )
    loaded = subprocess.run([sys.executable, "-W", "error", "-c", code], capture_output=True, text=True, check=True)
    assert not set(loaded.stdout.split()) & {"jax", "torch", "cupy", "array_api_compat", "array_api_strict"}


def test_a_lens_is_a_function_of_distance():
    f = lm.Plan(9, 3.45e-6).traced(LENS.pupil([1.0, 5.0]))
    distance = np.array([1.1, 2.0, 4.9])
    c = np.stack([f.defocus(distance), np.zeros(3)], axis=-1)
    assert np.allclose(f.defocus(distance), LENS.defocus(distance), rtol=1e-12, atol=1e-12)
    assert f.defocus(np.inf) == pytest.approx(float(LENS.defocus(np.inf)))
    exact = lm.psf(LENS.pupil(distance), 9, 3.45e-6, tol=1e-10)
    assert np.abs(f(c) - exact.values).max() <= 1e-6 * exact.values.max()


def test_a_lens_with_aberrations_of_all_kinds_takes_distances_too():
    coma = lm.Wavefront(nonradial={(3, 1): [-1.0, 1.0]})
    lens = lm.Lens(focal_length=50e-3, f_number=8.0, focus_distance=2.0, wavelength=550e-9, aberrations=coma)
    f = lm.Plan(5, 3e-6, integrate=False).traced(lens.pupil([[1.5], [2.5]]))
    assert f.terms == ((2, 0), (4, 0), (3, 1))
    exact = lm.psf(lens.pupil(1.7)[1], 5, 3e-6, integrate=False, tol=1e-9)
    found = f(np.array([float(f.defocus(1.7)), 0.0, 1.0]))
    assert np.abs(found - exact.values).max() <= 1e-6 * exact.values.max()


def test_other_wavefronts_have_other_columns():
    assert lm.Plan(5, 0.5).traced(lm.Pupil(lm.Wavefront(1.0, 0.5, (0.2,)))).terms == ("defocus", "spherical", "rho^6")
    zernike = lm.Wavefront.zernike({(2, 0): 1.0, (4, 0): 0.3})
    f = lm.Plan(5, 0.5).traced(lm.Pupil(zernike))
    assert f.terms == ((2, 0), (4, 0))
    exact = lm.psf(lm.Pupil(zernike), 5, 0.5, tol=1e-10).values
    assert np.abs(f(zernike.edge) - exact).max() <= 1e-6 * exact.max()
    # Terms that are all 0 have columns, on which nothing depends.
    flat = lm.Plan(5, 0.5).traced(lm.Pupil(zernike + lm.Wavefront(nonradial={(3, 1): 0.0})))
    assert flat.terms == ((2, 0), (4, 0), (3, 1))
    assert np.array_equal(flat([*zernike.edge, 7.0]), f(zernike.edge))


def test_an_aplanatic_lens_leaves_out_what_it_says_and_has_no_formula_for_distances():
    lens = lm.Lens(focal_length=50e-3, f_number=2.0, focus_distance=2.0, wavelength=550e-9, model="aplanatic")
    pupil = lens.pupil([1.9, 2.1])
    f = lm.Plan(9, 1e-6).traced(pupil)
    exact = lm.psf(pupil, 9, 1e-6, tol=1e-9).values
    assert np.abs(f(pupil.wavefront.edge) - exact).max() <= 1e-6 * exact.max()
    with pytest.raises(ValueError, match="paraxial lens"):
        f.defocus(1.0)


def test_a_traced_plan_is_pickled_with_its_tables():
    f = lm.Plan(9, 0.5).traced(RANGE)
    again = pickle.loads(pickle.dumps(f))
    assert np.array_equal(again([3.0, 0.0]), f([3.0, 0.0]))
    assert repr(again) == repr(f)
    assert "defocus, spherical; float64 inside, float32, tol=1e-06" in repr(f)


@pytest.mark.parametrize(
    ("c", "error", "message"),
    [
        ([1.0, 2.0, 3.0], ValueError, r"must have one column for each of \('defocus', 'spherical'\), got the shape"),
        (1.0, ValueError, r"the shape \(\)"),
        ([99.0, 0.0], lm.ToleranceError, "defocus = 99"),
        ([np.nan, 0.0], lm.ToleranceError, "defocus = nan"),
    ],
)
def test_coefficients_that_are_no_answer_are_refused(c, error, message):
    with pytest.raises(error, match=message):
        lm.Plan(9, 0.5).traced(RANGE)(c)


@pytest.mark.parametrize("plan", [{"normalize": "emitted"}, {"center": ([1.0, 2.0], [1.0, 2.0])}])
def test_what_a_traced_plan_would_leave_out_is_refused(plan):
    with pytest.raises(ValueError, match=next(iter(plan))):
        lm.Plan(9, 0.5, **plan).traced(RANGE)


def test_what_is_no_round_pupil_is_refused():
    with pytest.raises(TypeError, match=r"a Lens; lens\.pupil"):
        lm.Plan(9, 0.5).traced(LENS)
    with pytest.raises(ValueError, match="round aperture"):
        lm.Plan(9, 0.5).traced(lm.Pupil(spider=lm.Spider(width=0.1, angles=[0.0])))


def test_phases_beyond_what_float32_was_split_for_have_no_bound():
    far, near = [14.0, 0.0], [11.0, 0.0]
    assert np.isfinite(lm.Plan(41, 0.5, tol=1e-2).traced(RANGE).error(far))
    f = lm.Plan(41, 0.5, tol=1e-2).traced(RANGE, precision="float32")
    assert np.isfinite(f.error(near))
    assert np.isinf(f.error(far))


def test_wavefronts_refuse_tensors_and_name_what_takes_them():
    jax = pytest.importorskip("jax")
    for bad in (
        lambda: lm.Wavefront(jax.numpy.ones(2)),
        lambda: lm.Wavefront(0.0, jax.numpy.ones(2)),
        lambda: lm.Wavefront(nonradial={(3, 1): jax.numpy.ones(2)}),
        lambda: lm.Wavefront.zernike({(2, 0): jax.numpy.ones(2)}),
        lambda: lm.Wavefront.from_seidel(W040=jax.numpy.ones(2)),
        lambda: jax.grad(lambda c: lm.Wavefront(c).defocus)(1.0),
    ):
        with pytest.raises(TypeError, match=r"a JAX array, whose gradients would be lost: .*traced"):
            bad()


@pytest.mark.parametrize("given", [{"pixel": (0.5, 0.6)}, {"fill": 0.5, "integrate": True}, {"blur": lm.Jitter(0.5)}])
def test_pixels_and_blur_that_cannot_be_traced_are_refused(given):
    with pytest.raises(ValueError, match="a traced plan needs square pixels"):
        lm.Plan(**{"shape": 9, "pixel": 0.5} | given).traced(lm.Pupil(lm.Wavefront([0.0, 1.0])))


@pytest.mark.parametrize(("precision", "bits"), [("highest", None), ("high", 11), ("medium", 8)])
def test_products_of_pytorch_round_operands_to_the_bits_of_their_type(monkeypatch, precision, bits):
    # TF32 and bfloat16 have so many bits, with the leading one: numbers of these are off by half of the last.
    torch = types.SimpleNamespace(get_float32_matmul_precision=lambda: precision)
    monkeypatch.setitem(sys.modules, "torch", torch)
    namespace = Namespace("torch", None)
    assert namespace.coarseness(2.0**-53) == 0.0
    assert namespace.coarseness(2.0**-24) == (0.0 if bits is None else 0.5 * 2.0 ** (1 - bits))
