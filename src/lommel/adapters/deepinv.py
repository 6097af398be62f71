"""Blurs and PSFs for DeepInverse (https://deepinv.github.io): linear physics with exact adjoints; a PSF generator.

deepinv and PyTorch are optional; they are imported only when a function of this module is called.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from functools import cache
from typing import TYPE_CHECKING, Any

import numpy as np

from lommel.base import validation
from lommel.base.optional import library
from lommel.deconvolve.linear import LinearBlur
from lommel.optics.pupil import Pupil
from lommel.optics.wavefront.wavefront import Wavefront
from lommel.psf import psf

if TYPE_CHECKING:
    from deepinv.physics import LinearPhysics
    from deepinv.physics.generator import PSFGenerator
    from torch import Tensor

    from lommel.base.arrays import Values

    _ImageFunction = Callable[[Values], Values]


def blur_physics(blur: LinearBlur, **options: object) -> LinearPhysics:
    """Return a blur as a ``deepinv.physics.LinearPhysics``.

    `A` and `A_adjoint` are computed by the compiled core on a CPU. PyTorch can differentiate both with respect to the
    image: the gradient of `A` is computed by `A_adjoint`, and vice versa.

    Parameters
    ----------
    blur : LinearBlur
        :class:`lommel.imaging.DepthBlur`, :class:`lommel.imaging.Occlusion`, :class:`lommel.imaging.FieldBlur` or
        another linear blur; depth and lens are constants.
    **options
        Options of ``LinearPhysics``, such as `noise_model`.

    Returns
    -------
    deepinv.physics.LinearPhysics
        Physics for tensors of shape (batch, channels, height, width), on any device and of any floating-point type.

    Raises
    ------
    ImportError
        If deepinv is not installed.
    TypeError, ValueError
        If `blur` is not a linear blur. `A` and `A_adjoint` raise ValueError if images do not have the shape of the
        blur.
    """
    library("deepinv", "this needs", "")
    from deepinv.physics import LinearPhysics

    validation.instance("blur", blur, LinearBlur)
    apply = _linear_function()

    def checked(images: Tensor) -> Tensor:
        expected = blur.channels, *blur.shape
        if images.ndim != 4 or tuple(images.shape[1:]) != expected:
            raise ValueError(f"images must have the shape (batch, *{expected}), got {tuple(images.shape)}")
        return images

    return LinearPhysics(
        A=lambda x, **_: apply(checked(x), blur.forward, blur.adjoint),
        A_adjoint=lambda y, **_: apply(checked(y), blur.adjoint, blur.forward),
        img_size=(blur.channels, *blur.shape),
        **options,
    )


@cache
def _linear_function() -> Callable[[Tensor, _ImageFunction, _ImageFunction], Tensor]:
    """Return a differentiable function (images, f, adjoint) that applies the linear f to each image of a batch."""
    import torch

    def apply_to_batch(images: Tensor, f: _ImageFunction) -> Tensor:
        results = [np.moveaxis(f(np.moveaxis(image, 0, -1)), -1, 0) for image in images.detach().cpu().numpy()]
        return torch.from_numpy(np.ascontiguousarray(np.stack(results))).to(images)

    class Linear(torch.autograd.Function):  # type: ignore[misc]
        @staticmethod
        def forward(ctx: Any, images: Tensor, f: _ImageFunction, adjoint: _ImageFunction) -> Tensor:
            ctx.functions = f, adjoint
            return apply_to_batch(images, f)

        @staticmethod
        def backward(ctx: Any, gradient: Tensor) -> Tensor:
            f, adjoint = ctx.functions
            # The gradient of f is its adjoint, applied as a Linear so that second derivatives are possible.
            return Linear.apply(gradient, adjoint, f), None, None

    return Linear.apply  # type: ignore[no-any-return]


def psf_generator(
    psf_size: tuple[int, int],
    zernike_index: Sequence[int] | Sequence[tuple[int, int]] = tuple(range(4, 12)),
    fc: float = 0.2,
    max_zernike_amplitude: float = 0.15,
    index_convention: str = "noll",
    *,
    tol: float = 1e-4,
    **options: object,
) -> PSFGenerator:
    """Return a generator of random PSFs with the signature of ``deepinv.physics.generator.DiffractionBlurGenerator``.

    The error of a PSF is at most `tol` times its peak (0.01 to 0.06 times for ``DiffractionBlurGenerator``). The
    computation takes about a thousandth of the time.

    Parameters
    ----------
    psf_size : (int, int)
        Height and width in pixels.
    zernike_index : sequence, default 4 to 11
        Indices of Zernike terms in the order `index_convention`, or pairs (n, m).
    fc : float, default 0.2
        Cutoff frequency, ``numerical aperture * pixel / wavelength``, at most 0.25.
    max_zernike_amplitude : float, default 0.15
        Full width of the uniform distribution of the coefficients around 0, waves rms.
    index_convention : {"noll", "ansi"}, default "noll"
        Convention of indices that are not pairs.
    tol : float, default 1e-4
        Tolerance relative to the peak.
    **options
        `device`, `dtype` and `rng` of ``deepinv.physics.generator.PSFGenerator``.

    Returns
    -------
    deepinv.physics.generator.PSFGenerator
        Its ``step(batch_size, seed=None, coeff=None)`` returns a dict with `filter`, PSFs of shape
        (batch, 1, height, width) that each sum to 1, and `coeff`, coefficients of shape (batch, terms).

    Raises
    ------
    ImportError
        If deepinv is not installed.
    TypeError, ValueError
        If an argument is out of range.
    """
    library("deepinv", "this needs", "")
    import torch
    from deepinv.physics.generator import PSFGenerator

    shape = validation.image_shape(psf_size, "psf_size")
    pixel = 2.0 * validation.real("fc", fc, above=0.0, most=0.25)
    width = validation.real("max_zernike_amplitude", max_zernike_amplitude, least=0.0)
    pairs = all(isinstance(index, tuple) for index in zernike_index)
    order = "nm" if pairs else validation.choice("index_convention", index_convention, ("noll", "ansi"))
    indices = tuple(zernike_index)

    class Generator(PSFGenerator):  # type: ignore[misc]
        """PSFs of random wavefronts."""

        def step(
            self, batch_size: int = 1, seed: int | None = None, coeff: Tensor | None = None, **_: object
        ) -> dict[str, Tensor]:
            self.rng_manual_seed(seed)
            if coeff is None:
                coeff = torch.rand((batch_size, len(indices)), generator=self.rng, **self.factory_kwargs)
                coeff = (coeff - 0.5) * width
            values = coeff.detach().cpu().numpy().astype(np.float64)
            # Coefficients of DeepInverse are in waves, with the opposite sign: the phase is -2 pi * sum(c_k Z_k).
            terms = dict(zip(indices, -2.0 * math.pi * values.T, strict=True))
            images = psf(Pupil(Wavefront.zernike(terms, order=order)), shape, pixel, tol=tol).values
            filters = torch.as_tensor(np.array(images), **self.factory_kwargs)[:, None]
            return {"filter": filters / filters.sum(dim=(-2, -1), keepdim=True), "coeff": coeff}

    return Generator(psf_size=shape, **options)
