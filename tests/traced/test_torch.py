"""Traced plans in PyTorch, where it is installed (make test-torch): autograd, functional transforms, modules."""

from __future__ import annotations

import warnings

import numpy as np
import pytest

import lommel as lm
from lommel.traced.chordal import Sums
from traced_windows import CASES, EDGE, by_steps, traced

torch = pytest.importorskip("torch")
make_fx = pytest.importorskip("torch.fx.experimental.proxy_tensor").make_fx
# What torch says of itself as it loads its parts.
pytestmark = pytest.mark.filterwarnings("ignore::FutureWarning", "ignore::DeprecationWarning")

RANGE = lm.Pupil(lm.Wavefront([-10.0, 10.0], [-1.0, 1.0]))
C = np.array([[3.0, 0.5], [-9.0, -1.0], [0.1, 0.0]])


@pytest.fixture(scope="module")
def f():
    return lm.Plan(9, 0.5, tol=1e-9).traced(RANGE, torch)


def test_gradients_of_first_and_second_order_are_those_of_differences(f):
    c = torch.tensor(C[:1], requires_grad=True)
    assert torch.autograd.gradcheck(f, (c,), atol=1e-8)
    assert torch.autograd.gradgradcheck(f, (c,), atol=1e-7)


def test_derivatives_are_those_of_the_core(f):
    found = torch.func.vmap(torch.func.jacfwd(f))(torch.tensor(C))
    assert torch.abs(found - torch.func.vmap(torch.func.jacrev(f))(torch.tensor(C))).max() < 1e-15
    exact = lm.psf(lm.Pupil(lm.Wavefront(*C.T)), 9, 0.5, tol=1e-11, derivatives=("defocus", "spherical"))
    for j, name in enumerate(("defocus", "spherical")):
        assert np.abs(found[..., j].numpy() - exact.derivatives[name]).max() < 1e-11 * exact.values.max()


def test_what_is_not_proven_is_told_or_poisoned(f):
    c = torch.tensor([[3.0, 0.5], [-900.0, 0.0]], dtype=torch.float64)
    with pytest.raises(lm.ToleranceError, match="defocus = -900"):
        f(c)
    images = f(c, check=False)
    assert torch.isnan(images[1]).all()
    assert torch.equal(images[0], f(c[0]))


def test_coefficients_of_another_kind_are_refused(f):
    with pytest.raises(ValueError, match="on the device"):
        f(torch.zeros(1, 2, device="meta"))


def test_products_of_less_precision_widen_the_bound():
    f = lm.Plan(9, 0.5, tol=3e-2).traced(RANGE, torch, precision="float32")
    before = f.error(torch.tensor(C))
    torch.set_float32_matmul_precision("high")
    try:
        assert (f.error(torch.tensor(C)) > before + 1e-4).all()
    finally:
        torch.set_float32_matmul_precision("highest")


def test_a_graph_of_it_is_whole(f):
    c = torch.tensor(C)
    assert torch.equal(torch.compile(f.__call__, fullgraph=True, backend="eager")(c), f(c))


@pytest.mark.parametrize("case", CASES.values(), ids=CASES)
def test_what_the_core_sums_has_the_gradients_of_pytorch(case):
    f = traced(case, EDGE, torch)
    for kind in (torch.float32, torch.float64):
        c = torch.tensor(EDGE, dtype=kind, requires_grad=True)
        weights = torch.rand(f(c).shape, generator=torch.Generator().manual_seed(0))

        def loss(function, c=c, weights=weights):
            return (weights * function(c)).sum()

        found, exact = (torch.autograd.grad(loss(one), c)[0] for one in (f, by_steps(f)))
        assert found.dtype == kind
        assert torch.abs(found - exact).max() < 1e-5 * torch.abs(exact).max()
        slopes = [torch.autograd.grad(loss(one), c, create_graph=True)[0] for one in (f, by_steps(f))]
        second = [torch.autograd.grad((slope**2).sum(), c)[0] for slope in slopes]
        assert torch.abs(second[0] - second[1]).max() < 1e-4 * torch.abs(second[1]).max()
        rows = torch.eye(3, dtype=torch.float32)
        many = [torch.autograd.grad(one(c)[:, 2, 2], c, rows, is_grads_batched=True)[0] for one in (f, by_steps(f))]
        assert torch.abs(many[0] - many[1]).max() < 1e-5 * torch.abs(many[1]).max()


def test_nothing_that_is_followed_is_left_to_the_core(monkeypatch):
    f, c = traced(CASES["odd"], EDGE, torch), torch.tensor(EDGE, dtype=torch.float32)
    images = f(c)
    made = make_fx(f)(c)
    asked = []
    monkeypatch.setattr(Sums, "intensity", lambda *given: asked.append(given))
    monkeypatch.setattr(Sums, "gradient", lambda *given: asked.append(given))
    tangent = torch.ones_like(c)
    _, slope = torch.func.jvp(f, (c,), (tangent,))
    with torch.autograd.forward_ad.dual_level():
        dual = f(torch.autograd.forward_ad.make_dual(c, tangent))
        assert torch.allclose(torch.autograd.forward_ad.unpack_dual(dual).tangent, slope, atol=1e-6)
    assert torch.func.vmap(torch.func.jacfwd(f))(c).shape == (3, 9, 9, 6)
    assert torch.func.grad(lambda c: f(c).sum())(c).shape == (3, 6)
    alike = {"atol": 1e-6 * float(images.max()), "rtol": 0.0}
    for function in (torch.func.vmap(f), made):
        assert torch.allclose(function(c), images, **alike)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", torch.jit.TracerWarning)
        program = torch.jit.trace(lambda c: f(c, check=False), (c,), check_trace=False)
    assert torch.allclose(program(0.5 * c), by_steps(f)(0.5 * c), **alike)
    assert not asked


@pytest.mark.filterwarnings("ignore::UserWarning")  # of caches
def test_compiled_programs_have_the_same_images_and_gradients():
    f = traced(CASES["odd"], EDGE, torch)
    c = torch.tensor(EDGE, dtype=torch.float32, requires_grad=True)
    found, exact = torch.compile(f.__call__, backend="eager")(c), f(c)
    assert torch.allclose(found, exact, rtol=0.0, atol=1e-6 * float(exact.max()))
    slopes = [torch.autograd.grad((images**2).sum(), c)[0] for images in (found, exact)]
    assert torch.abs(slopes[0] - slopes[1]).max() < 1e-5 * torch.abs(slopes[1]).max()
