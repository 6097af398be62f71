"""Twins in PyTorch, where it is installed (make test-torch): autograd, functional transforms, modules."""

from __future__ import annotations

import copy

import numpy as np
import pytest

import lommel as lm
from lommel.twins.module import module

torch = pytest.importorskip("torch")
# What torch says of itself as it loads its parts.
pytestmark = pytest.mark.filterwarnings("ignore::FutureWarning", "ignore::DeprecationWarning")

REACH = lm.Pupil(lm.Wavefront([-10.0, 10.0], [-1.0, 1.0]))
C = np.array([[3.0, 0.5], [-9.0, -1.0], [0.1, 0.0]])


@pytest.fixture(scope="module")
def f():
    return lm.Plan(9, 0.5, tol=1e-9).traced(REACH, torch)


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


def test_a_module_has_the_tables_as_buffers_and_no_parameters(f):
    layer = module(f)
    assert not list(layer.parameters())
    assert len(list(layer.buffers())) == len(f.tables[0])
    assert torch.equal(layer(torch.tensor(C)), f(torch.tensor(C)))
    assert torch.equal(copy.deepcopy(layer)(torch.tensor(C)), f(torch.tensor(C)))
    assert layer.certified(torch.tensor(C))[1].shape == (3,)
    with pytest.raises(TypeError, match="trace the plan anew"):
        layer.float()(torch.tensor(C))


def test_coefficients_of_another_kind_are_refused(f):
    with pytest.raises(ValueError, match="on the device"):
        f(torch.zeros(1, 2, device="meta"))
    with pytest.raises(TypeError, match="twin must be of torch"):
        module(lm.Plan(9, 0.5).traced(REACH))


def test_products_of_less_precision_widen_the_bound():
    f = lm.Plan(9, 0.5, tol=3e-2).traced(REACH, torch, precision="float32")
    before = f.error(torch.tensor(C))
    torch.set_float32_matmul_precision("high")
    try:
        assert (f.error(torch.tensor(C)) > before + 1e-4).all()
    finally:
        torch.set_float32_matmul_precision("highest")


def test_a_graph_of_it_is_whole(f):
    c = torch.tensor(C)
    assert torch.equal(torch.compile(f.__call__, fullgraph=True, backend="eager")(c), f(c))
