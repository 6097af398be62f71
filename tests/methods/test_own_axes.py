"""An axis for each pupil of a stack: what one pupil with one axis gives, within the bound, and what is refused."""

from __future__ import annotations

from functools import lru_cache

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.special import j0

import lommel as lm
from lommel import _core
from lommel.methods import ChordalGauss, Hankel, MatrixFourier, NijboerZernike, NonuniformFFT, Polychromatic
from lommel.optics.grid import Grid
from lommel.paper import ClosedForm, Fraunhofer, Geometric, HuygensFresnel, LommelSeries, TunedClosedForm

RNG = np.random.default_rng(7)
N = 12
DEFOCUS, SPHERICAL = RNG.uniform(-6, 6, N), RNG.uniform(-2, 2, N)
CENTER = (RNG.uniform(8, 16, N), RNG.uniform(-3, 20, N))
PUPILS = {
    "radial": lm.Pupil(lm.Wavefront(DEFOCUS, SPHERICAL)),
    "obscured": lm.Pupil(lm.Wavefront(DEFOCUS, SPHERICAL), obscuration=0.4),
    "apodized": lm.Pupil(lm.Wavefront(DEFOCUS, SPHERICAL), apodization=0.8),
    "metric": lm.Pupil(lm.Wavefront(DEFOCUS), wavelength=500e-9, f_number=8.0),
    "coma": lm.Pupil(lm.Wavefront(0.3 * DEFOCUS, nonradial={(3, 1): 0.5 * SPHERICAL, (1, -1): 0.4})),
    "coma, obscured": lm.Pupil(lm.Wavefront(nonradial={(3, 1): 0.5 * SPHERICAL}), obscuration=0.3),
}


@lru_cache
def rule(hundreds: int) -> tuple[np.ndarray, np.ndarray]:
    return np.polynomial.legendre.leggauss(200 + 100 * hundreds)


def quadrature(pupil: lm.Pupil, y: np.ndarray, x: np.ndarray) -> np.ndarray:
    """Return I of one radial pupil at places in v, by Gauss's rule over rho^2."""
    s, w = rule(int(np.hypot(np.abs(y).max(), np.abs(x).max()) / 200.0))
    low = pupil.obscuration**2
    t = low + (1.0 - low) * 0.5 * (s + 1.0)
    power = 0.5 * (1.0 - low) * w * np.exp(1j * pupil.radial_phase(t)[0]) * pupil.illumination.at(t)
    field = np.sum(j0(np.hypot(y, x)[..., None] * np.sqrt(t)) * power, axis=-1)
    return field.real**2 + field.imag**2


def one_by_one(answer: lm.PSF, **options) -> list[lm.PSF]:
    """Return what each pupil has on its own, around the axis that the answer says it has."""
    return [
        lm.psf(
            answer.pupil[index],
            answer.grid.shape,
            answer.pixel,
            center=answer[index].grid.center,
            dtype=np.float64,
            normalize=answer.normalize,
            integrate=answer.grid.integrate,
            **options,
        )
        for index in np.ndindex(answer.pupil.shape)
    ]


@pytest.mark.parametrize("integrate", [False, True])
@pytest.mark.parametrize("normalize", ["energy", "strehl", "peak"])
@pytest.mark.parametrize("name", PUPILS)
def test_each_pupil_has_what_it_has_alone(name, normalize, integrate):
    pupil = PUPILS[name]
    pixel = 0.6 * pupil.scale
    answer = lm.psf(pupil, (21, 18), pixel, center=CENTER, normalize=normalize, integrate=integrate, tol=1e-7)
    assert answer.error_bound <= 1e-7
    for i, alone in enumerate(one_by_one(answer, tol=1e-9)):
        off = np.abs(answer.values[i].astype(np.float64) - alone.values).max()
        top = 1.0 if normalize == "peak" else max(alone.values.max(), float(answer.values[i].max()))
        # Where the window misses the peak, errors relate to what is brighter than all that is in it.
        assert off <= (1e-7 + 1e-9) * top or alone.values.max() < 0.2 * alone.scale
        assert answer.scale[i] == pytest.approx(alone.scale, rel=1e-6)


@pytest.mark.parametrize("method", [NijboerZernike(1e-6), ChordalGauss(1e-6)])
@pytest.mark.parametrize("dtype", [np.float32, np.float64])
def test_every_method_that_takes_several_axes_agrees(method, dtype):
    for name in ("radial", "coma"):
        answer = lm.psf(PUPILS[name][:6], 15, 0.5, center=(CENTER[0][:6], 8.3), method=method, dtype=dtype)
        for i, alone in enumerate(one_by_one(answer, tol=1e-9)):
            assert np.abs(answer.values[i] - alone.values).max() <= 1.1e-7 * max(
                alone.values.max(), 0.2 * alone.scale
            )


@pytest.mark.parametrize("level", ["portable", "avx2", "avx512"])
def test_errors_stay_within_the_bound(level):
    rng = np.random.default_rng({"portable": 1, "avx2": 2, "avx512": 3}[level])
    _core.limit_instructions(level)
    try:
        for i in range(25):
            count, tol = int(rng.integers(1, 8)), 10.0 ** rng.uniform(-11, -2)
            pitch, side = 10.0 ** rng.uniform(-1.3, 0.6), int(rng.integers(1, 14))
            pupil = lm.Pupil(
                lm.Wavefront(rng.uniform(-9, 9, count), rng.uniform(-5, 5, count)),
                obscuration=float(rng.choice([0.0, 0.3])),
                apodization=float(rng.choice([0.0, 1.2])),
            )
            # Around the middle, mostly; some far beside the window.
            away = rng.uniform(-1.0, 1.0, (2, count)) * (2.0 if i % 4 else 30.0)
            answer = lm.psf(
                pupil, side, pitch, center=side // 2 + away, tol=tol, normalize="strehl", dtype=np.float64
            )
            assert answer.error_bound <= tol
            places = np.linspace(0.0, 8.0 + 2 * np.abs(answer.pupil.radial_terms()).sum() / count, 400)
            for p in range(count):
                y, x = (np.pi * part[p] for part in (answer.grid.y, answer.grid.x))
                exact = quadrature(pupil[p], y[:, None], x)
                peak = max(exact.max(), quadrature(pupil[p], np.zeros(1), places).max())
                off = np.abs(answer.values[p] * (pupil.amplitude**2) - exact).max() / peak
                assert off <= answer.error_bound + 1e-14, (i, p)
    finally:
        _core.limit_instructions("avx512")


def test_averages_of_many_pupils_are_each_around_their_own_axis():
    rng = np.random.default_rng(9)
    pupil = lm.Pupil(lm.Wavefront(rng.uniform(-5, 5, 300)))
    answer = lm.psf(pupil, 9, 0.5, center=(rng.uniform(3, 5, 300), 4.2), integrate=True, dtype=np.float64)
    for i in (0, 63, 64, 65, 150, 299):
        alone = lm.psf(pupil[i], 9, 0.5, center=(answer.grid.center[0][i], 4.2), integrate=True, dtype=np.float64)
        assert np.abs(answer.values[i] - alone.values).max() <= 2e-6 * alone.values.max()


def test_averages_stay_within_the_bound():
    rng = np.random.default_rng(4)
    s, w = np.polynomial.legendre.leggauss(18)
    for _ in range(25):
        tol, pitch, side = 10.0 ** rng.uniform(-10, -3), 10.0 ** rng.uniform(-1, 0.5), int(rng.integers(1, 8))
        pupil = lm.Pupil(lm.Wavefront(rng.uniform(-5, 5, 3), rng.uniform(-2, 2, 3)))
        center = side // 2 + rng.uniform(-1, 1, (2, 3))
        answer = lm.psf(
            pupil, side, pitch, center=center, tol=tol, integrate=True, normalize="strehl", dtype=np.float64
        )
        for p in range(3):
            y, x = (np.pi * (part[p][:, None] + 0.5 * pitch * s) for part in (answer.grid.y, answer.grid.x))
            fine = quadrature(pupil[p], y[:, :, None, None], x)
            exact = 0.25 * np.einsum("yaxb,a,b->yx", fine, w, w)
            # What averages relate to is the largest there is: about that around the axis or the brightest found.
            assert np.abs(answer.values[p] - exact).max() <= answer.error_bound * max(exact.max(), fine.max()) + 1e-14


def test_derivatives_have_the_same_axes():
    asked = ("defocus", "spherical")
    for integrate in (False, True):
        stack = lm.psf(
            PUPILS["radial"][:5], 9, 0.5, center=([4, 4.2, 3.7, 5, 4], 4.5), derivatives=asked, integrate=integrate
        )
        for i in range(5):
            alone = lm.psf(
                stack.pupil[i], 9, 0.5, center=stack[i].grid.center, derivatives=asked, integrate=integrate, tol=1e-8
            )
            for name in asked:
                off = np.abs(stack.derivatives[name][i] - alone.derivatives[name]).max()
                assert off <= 1.01 * (stack.derivative_bounds[name] + 1e-8) * max(
                    alone.values.max(), 0.2 * alone.scale
                )


@settings(max_examples=40)
@given(
    st.sampled_from([(), (1,), (3,), (2, 3), (2, 1)]), st.sampled_from([(), (1,), (3,), (2, 1), (4, 1, 1)]), st.data()
)
def test_pupils_and_axes_broadcast(stack, rows, data):
    columns = data.draw(st.sampled_from([(), (3,), (1, 3)]))
    pupil = lm.Pupil(lm.Wavefront(np.full(stack, 2.0)))
    center = (np.full(rows, 2.3), np.linspace(1, 2, int(np.prod(columns))).reshape(columns))
    shape = np.broadcast_shapes(stack, rows, columns)
    answer = lm.psf(pupil, (4, 5), 0.5, center=center)
    assert answer.values.shape == (*shape, 4, 5)
    assert answer.pupil.shape == answer.scale.shape == shape
    one = rows == columns == ()
    assert answer.grid.stack == (() if one else shape)
    if shape:
        last = answer[(-1,) * len(shape)]
        expected = lm.psf(lm.Pupil(lm.Wavefront(2.0)), (4, 5), 0.5, center=last.grid.center, tol=1e-9)
        np.testing.assert_allclose(last.values, expected.values, atol=1e-6 * expected.scale)


def test_a_plan_keeps_its_axes_and_writes_where_it_is_told():
    center = ([4.2, 4.5, 3.9], [4, 4.1, 4.4])
    plan, frames = lm.Plan(9, 0.5, center=center), np.empty((3, 9, 9), np.float32)
    for defocus in (1.0, [1.0, 2.0, 3.0]):
        pupil = lm.Pupil(lm.Wavefront(defocus))
        answer = plan(pupil, out=frames)
        assert answer.values is frames
        np.testing.assert_array_equal(frames, lm.psf(pupil, 9, 0.5, center=center).values)
    with pytest.raises(ValueError, match="center must broadcast with the stack of pupils, got centres of shape"):
        plan(lm.Pupil(lm.Wavefront([1.0, 2.0])))
    with pytest.raises(ValueError, match=r"out must have the shape \(3, 9, 9\), got \(9, 9\)"):
        plan(lm.Pupil(), out=np.empty((9, 9), np.float32))


def test_a_lens_and_a_field_have_them_too():
    lens = lm.Lens(focal_length=50e-3, f_number=8, focus_distance=2.0, wavelength=550e-9)
    answer = lm.psf(lens.pupil(1.5), 15, 3e-6, center=([7, 7.3], [7.1, 6.8]))
    assert answer.pupil.geometry.object_distance == (1.5, 1.5)
    assert answer[1].pupil.geometry.object_distance == (1.5,)
    white = Polychromatic([450e-9, 550e-9, 650e-9], weights=[1, 2, 1])
    stack = lm.psf(lens.pupil([1.5, 1.8]), 15, 3e-6, center=([7, 7.3], [7.1, 6.8]), method=white)
    for i, alone in enumerate(one_by_one(stack, method=white)):
        assert np.abs(stack.values[i] - alone.values).max() <= 2.1e-6 * alone.values.max()


@pytest.mark.parametrize(
    "method",
    [
        Hankel(),
        LommelSeries(),
        ClosedForm(),
        TunedClosedForm(),
        Fraunhofer(),
        MatrixFourier(),
        NonuniformFFT(),
        Geometric(),
        Polychromatic([500e-9], [1.0], method=Hankel()),
        HuygensFresnel(),
        HuygensFresnel(symmetry=False),
    ],
)
def test_methods_that_take_one_axis_say_so(method):
    lens = lm.Lens(focal_length=50e-3, f_number=8, focus_distance=2.0, wavelength=500e-9)
    said = r"center must be one \(row, column\).*its own center, or use NijboerZernike or ChordalGauss"
    for integrate in (None, True):
        with pytest.raises(ValueError, match=said):
            lm.psf(lens.pupil([1.9, 2.1]), 9, 3e-6, center=([4, 4.3], 4), method=method, integrate=integrate)


@pytest.mark.parametrize("name", ["metric", "coma"])
def test_measures_are_those_of_each(name):
    pupil = PUPILS[name][:4]
    unit = pupil.scale
    place = ([16, 16.4, 15, 17.2], [16.1, 15, 18, 16.5])
    # Four pupils and one may be sampled by methods of their own, whose values agree within the tolerance.
    answer = lm.psf(pupil, 33, 0.5 * unit, center=place, tol=1e-11, dtype=float)
    radius = np.array([1.0, 3.0]) * unit
    for i in range(4):
        one = answer[i]
        assert one.grid == Grid(33, 0.5 * unit, center=one.grid.center, integrate=answer.grid.integrate)
        for found in ("energy", "strehl", "peak_strehl", "centroid"):
            np.testing.assert_allclose(getattr(answer, found)[i], getattr(one, found), rtol=1e-12, atol=1e-15 * unit)
        for about in ("axis", "centroid"):
            np.testing.assert_allclose(
                answer.encircled_energy(radius, about=about)[i], one.encircled_energy(radius, about=about), rtol=1e-12
            )
            np.testing.assert_allclose(
                answer.ensquared_energy(radius, about=about)[i], one.ensquared_energy(radius, about=about), rtol=1e-12
            )
        np.testing.assert_allclose(answer.otf(0.3 / unit, 0.1 / unit)[i], one.otf(0.3 / unit, 0.1 / unit), rtol=1e-12)
        np.testing.assert_allclose(answer.fwhm()[i], one.fwhm(), rtol=1e-12)
        for found, alone in zip(answer.profile(), one.profile(), strict=True):
            np.testing.assert_array_equal(found[i], alone)
    # By default they agree within what is stated: 2e-8 and 4 A e, e being the tolerance times the peak per area.
    usual = lm.psf(pupil, 33, 0.5 * unit, center=place)
    e = 1e-6 * 0.25 * np.pi / unit**2 * usual.peak_strehl[:, None]
    for measured in (usual.encircled_energy(radius), [usual[i].encircled_energy(radius) for i in range(4)]):
        assert (np.abs(measured - answer.encircled_energy(radius)) <= 2e-8 + 4.0 * np.pi * radius**2 * e).all()
    # Wherever the axis is, the light is around it.
    assert np.abs(answer.centroid - lm.centroid(pupil)).max() < 0.3 * unit


@pytest.mark.parametrize("side", [1, 2, 3, 5])
def test_samples_far_apart_are_around_the_axis_of_their_own_pupil(side):
    pupils = lm.Pupil(lm.Wavefront(np.linspace(0.0, 3.0, 6), 1.0))
    rows, columns = side // 2 + np.random.default_rng(0).uniform(-0.5, 0.5, (2, 6))
    together = lm.psf(pupils, side, 60.0 / side + 30.0, center=(rows, columns), normalize="strehl")
    for k, one in enumerate(together.values):
        alone = lm.psf(
            pupils[k], side, 60.0 / side + 30.0, center=(rows[k], columns[k]), normalize="strehl", tol=1e-9
        )
        peak = lm.psf(pupils[k], 65, 0.3, normalize="strehl").values.max()
        assert np.abs(one - alone.values).max() <= 1.01e-6 * peak
