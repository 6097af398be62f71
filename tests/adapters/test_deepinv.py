"""DeepInverse: a physics whose adjoint is exact, and PSFs beside those of its generator."""

from __future__ import annotations

import numpy as np
import pytest

import lommel as lm

torch = pytest.importorskip("torch")
deepinv = pytest.importorskip("deepinv")

from lommel.adapters.deepinv import blur_physics, psf_generator  # noqa: E402

DRAW = np.random.default_rng(0)
LENS = lm.Lens(focal_length=16e-3, f_number=4.0, focus_distance=2.0, wavelength=550e-9)


def blurs():
    """Return blurs of 16 by 20 pixels."""
    depth = DRAW.uniform(1.5, 4.0, (16, 20))
    by_depth = lm.imaging.DepthBlur(depth, LENS, 3.45e-6, channels=lm.imaging.RED_GREEN_BLUE, dtype=np.float64)
    field = lm.FieldMap.from_seidel(6e-3, W131=1.5, W222=1.0, wavelength=550e-9, f_number=4.0)
    return (
        by_depth,
        lm.imaging.Occlusion(by_depth),
        lm.imaging.FieldBlur(field, (16, 20), 2e-6, largest=16, dtype=np.float64),
    )


@pytest.mark.parametrize("blur", blurs(), ids=lambda blur: type(blur).__name__)
def test_the_adjoint_is_exact_and_the_gradient(blur):
    physics = blur_physics(blur)
    x = torch.tensor(DRAW.random((2, blur.channels, 16, 20)), requires_grad=True)
    y = torch.tensor(DRAW.random(x.shape), requires_grad=True)
    one, other = ((a * b).sum().item() for a, b in ((physics.A(x), y), (x, physics.A_adjoint(y))))
    assert one == pytest.approx(other, rel=1e-12)
    assert abs(float(physics.adjointness_test(x.detach()))) < 1e-9
    (gradient,) = torch.autograd.grad((physics(x) * y.detach()).sum(), x)
    assert torch.allclose(gradient, physics.A_adjoint(y.detach()), atol=1e-12)
    image = np.moveaxis(x[0].detach().numpy(), 0, -1)
    assert np.allclose(np.moveaxis(physics.A(x)[0].detach().numpy(), 0, -1), blur.forward(image).reshape(image.shape))
    with pytest.raises(ValueError, match="shape"):
        physics.A(x[..., 1:])


def test_generated_psfs_are_those_of_deepinv_but_for_their_error():
    ours = psf_generator((31, 31), fc=0.2)
    theirs = deepinv.physics.generator.DiffractionBlurGenerator((31, 31), fc=0.2, pupil_size=(1024, 1024))
    found = ours.step(3, seed=0)
    other = theirs.step(3, coeff=found["coeff"])["filter"]
    assert found["filter"].shape == (3, 1, 31, 31)
    assert torch.allclose(found["filter"].sum(dim=(-2, -1)), torch.ones(3, 1))
    assert float((found["filter"] - other).abs().max()) < 0.02 * float(other.max())
    assert torch.equal(ours.step(3, seed=0)["filter"], found["filter"])
    assert ours.step(2, seed=1)["coeff"].abs().max() <= 0.075
