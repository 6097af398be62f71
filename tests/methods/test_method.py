"""The face every method has: shapes, refusals, its options in plain types, and the bound on the intensity."""

from __future__ import annotations

import json
import math

import numpy as np
import pytest

import lommel as lm
from lommel import Lens, Pupil, Wavefront
from lommel.methods import (
    ERFS,
    METHODS,
    Hankel,
    MatrixFourier,
    Method,
    NijboerZernike,
    NonuniformFFT,
    RadialMethod,
    method_from_dict,
)
from lommel.paper import AbramowitzErf, ClosedForm, Fraunhofer, Geometric, HuygensFresnel, LommelSeries, TableErf

LENS = Lens(focal_length=2e-3, f_number=8.0, focus_distance=0.5, wavelength=500e-9)
ALL = [pytest.param(kind(), id=name) for name, kind in METHODS.items()]
RADIAL = [pytest.param(kind(), id=name) for name, kind in METHODS.items() if issubclass(kind, RadialMethod)]
OPTIONED = [
    NijboerZernike(tol=1e-9),
    Hankel(tol=1e-3),
    LommelSeries(),
    HuygensFresnel(symmetry=False),
    Fraunhofer(samples=64, padding=2.5, edge="grey"),
    MatrixFourier(samples=99, edge="binary"),
    NonuniformFFT(tol=1e-9),
    ClosedForm(tangent=50, erf=AbramowitzErf(17), variant="printed"),
    ClosedForm(erf=TableErf(99)),
    Geometric(rings=3),
]


@pytest.mark.parametrize("method", RADIAL)
def test_the_field_has_the_shape_of_the_stack_then_that_of_v(method: RadialMethod) -> None:
    v = np.array([[3.0, 0.0, 1.0], [0.5, 3.0, 7.0]])
    one, many = LENS.pupil(0.5), LENS.pupil(np.full((2, 1), 0.4))
    assert method.field(one, 1.0).shape == ()
    assert method.field(one, v).shape == (2, 3)
    assert method.field(many, v).shape == (2, 1, 2, 3)
    assert method.field(one, v).dtype == np.complex128


@pytest.mark.parametrize("method", RADIAL)
def test_radii_may_come_in_any_order_and_again(method: RadialMethod) -> None:
    pupil = LENS.pupil(0.3)
    rising = np.linspace(0.0, 9.0, 10)
    order = np.array([3, 9, 0, 3, 3, 7])
    assert method.field(pupil, rising[order]) == pytest.approx(method.field(pupil, rising)[order], rel=0, abs=1e-8)


@pytest.mark.parametrize("method", RADIAL)
def test_no_radii_have_no_field(method: RadialMethod) -> None:
    assert method.field(LENS.pupil(0.3), np.zeros(0)).shape == (0,)


@pytest.mark.parametrize("v", [5e-324, 1e-310, 1e-200, 1e-100, 1e-30])
@pytest.mark.parametrize("method", RADIAL)
def test_next_to_the_axis_the_field_is_that_on_the_axis(method: RadialMethod, v: float) -> None:
    pupil = LENS.pupil(0.3)
    assert abs(method.field(pupil, v) - method.field(pupil, 0.0)) <= 1e-9


@pytest.mark.parametrize("method", RADIAL)
def test_every_pixel_holds_the_square_of_the_field_at_its_centre(method: RadialMethod) -> None:
    pupil = LENS.pupil([0.3, 0.5])
    answer = lm.psf(
        pupil, (5, 8), 0.8 * pupil.scale, method=method, normalize="strehl", dtype=np.float64, integrate=False
    )
    y, x = np.mgrid[-2:3, -4:4]
    field = method.field(pupil, 0.8 * math.pi * np.hypot(y, x))
    assert answer.values == pytest.approx(np.abs(field) ** 2, rel=0, abs=2e-6)


@pytest.mark.parametrize("method", ALL)
def test_each_pupil_of_a_stack_has_the_image_it_has_alone(method: Method) -> None:
    pupils = LENS.pupil([0.3, 0.5, math.inf])
    stack = lm.psf(pupils, (6, 7), 0.9 * pupils.scale, method=method, normalize="strehl", dtype=np.float64)
    assert stack.shape == (3, 6, 7)
    for i, values in enumerate(stack.values):
        alone = lm.psf(pupils[i], (6, 7), 0.9 * pupils.scale, method=method, normalize="strehl", dtype=np.float64)
        assert np.abs(values - alone.values).max() <= 2e-6 * alone.values.max()


def test_what_each_method_supports() -> None:
    plain, aberrated, physical = Pupil(Wavefront(1.0)), Pupil(Wavefront(1.0, 1.0)), LENS.pupil(0.3)
    supported = {
        name: [kind().unsupported(pupil) is None for pupil in (plain, aberrated, physical)]
        for name, kind in METHODS.items()
    }
    assert supported == {
        "nijboer-zernike": [True, True, True],
        "hankel": [True, True, True],
        "lommel-series": [True, False, True],
        "huygens-fresnel": [False, False, True],
        "fraunhofer": [True, True, True],
        "matrix-fourier": [True, True, True],
        "nonuniform-fft": [True, True, True],
        "closed-form": [True, True, True],
        "tuned-closed-form": [True, True, True],
        "geometric": [True, True, True],
        "chordal-gauss": [True, True, True],
    }


@pytest.mark.parametrize("method", [*OPTIONED, *(kind() for kind in METHODS.values())], ids=repr)
def test_a_method_comes_back_from_its_plain_types_through_json(method: Method) -> None:
    described = json.loads(json.dumps(method.to_dict()))
    assert described["name"] == type(method).__name__
    assert method_from_dict(described) == method


def test_the_names_of_the_command_line_are_all_the_methods() -> None:
    assert {kind.__name__ for kind in (*METHODS.values(), *ERFS.values())} <= {*lm.methods.__all__, *lm.paper.__all__}
    assert {kind.sampling for name, kind in METHODS.items() if name != "geometric"} == {"center"}
    assert METHODS["geometric"].sampling == "pixel"


def test_the_bound_of_a_stack_is_that_of_its_worst_pupil() -> None:
    pupils = Pupil(Wavefront([0.0, 100.0]))
    together = lm.psf(pupils, 9, 0.5, method=Hankel(tol=1e-6), dtype=np.float64)
    bounds = Hankel(tol=1e-6).intensity(pupils, together.grid, 1).error
    assert bounds is not None
    assert bounds[1] > bounds[0]
    assert together.error_bound == pytest.approx(bounds.max() + 2.0**-53, rel=1e-12)


def test_methods_are_values_that_compare_and_hash() -> None:
    assert NijboerZernike(tol=1e-6) == NijboerZernike()
    assert len({NijboerZernike(), NijboerZernike(1e-6), Hankel(), Hankel(1e-9)}) == 3
    with pytest.raises(AttributeError):
        Hankel().tol = 1.0  # type: ignore[misc]
