"""Packages for microscopes, which compute a stack through focus; each function yields configurations of one."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

from benchmarks.setups import Focus, Setup


def psf_generator(focus: Focus) -> Iterator[Setup]:
    """psf-generator: Richards and Wolf's scalar integral, radial by Simpson's rule, Cartesian by chirp-z."""
    import torch
    from psf_generator import ScalarCartesianPropagator, ScalarSphericalPropagator

    torch.set_num_threads(1)
    # It spreads n pixels over the field of view of n, ends included, and the planes likewise.
    options: dict[str, Any] = {
        "n_pix_psf": focus.n,
        "wavelength": 1000.0 * focus.wavelength,
        "na": focus.aperture,
        "pix_size": 1000.0 * focus.pixel * (focus.n - 1) / focus.n,
        "defocus_step": 2000.0 * float(focus.z[-1]) / focus.planes,
        "n_defocus": focus.planes,
        "n_i": focus.index,
        "n_i0": focus.index,
    }

    def call(kind: Any, samples: int, **more: Any) -> Any:
        field = kind(n_pix_pupil=samples, **options, **more).compute_focus_field()
        return (field.real**2 + field.imag**2)[:, 0].numpy()

    radial, cartesian = ScalarSphericalPropagator, ScalarCartesianPropagator
    yield Setup("Cartesian, 128 samples, float32 (the defaults)", lambda: call(cartesian, 128, sz_correction=False))
    yield Setup("radial, 128 samples, float32 (the defaults)", lambda: call(radial, 128, cos_factor=True))
    yield Setup("radial, 129 samples, float32", lambda: call(radial, 129, cos_factor=True))
    before = torch.get_default_dtype()
    torch.set_default_dtype(torch.float64)
    try:
        yield Setup("radial, 513 samples, float64", lambda: call(radial, 513, cos_factor=True))
    finally:
        torch.set_default_dtype(before)


def psfmodels(focus: Focus) -> Iterator[Setup]:
    """psfmodels: Gibson and Lanni's scalar integral by Simpson's rule, pixels averaged."""
    from psfmodels import make_psf

    n = focus.index

    def call(oversampling: int) -> Callable[[], Any]:
        return lambda: make_psf(
            list(focus.z),
            focus.n,
            dxy=focus.pixel,
            NA=focus.aperture,
            wvl=focus.wavelength,
            ns=n,
            ni=n,
            ni0=n,
            ng=n,
            ng0=n,
            oversample_factor=oversampling,
            normalize=False,
            model="scalar",
        )

    yield Setup("make_psf, oversample_factor 3 (the default), pixels averaged", call(3), averaged=True)
    yield Setup("make_psf, oversample_factor 9, pixels averaged", call(9), averaged=True)


def microscpsf(focus: Focus) -> Iterator[Setup]:
    """MicroscPSF: Li, Xue and Blu's series of Bessel functions, interpolated linearly."""
    from microscPSF import microscPSF  # a module

    n = focus.index
    # A large magnification, so that the sine condition is that of the others.
    scope = microscPSF.m_params | {"NA": focus.aperture, "ng0": n, "ng": n, "ni0": n, "ni": n, "ns": n, "M": 1e4}

    def fine(sampling: int) -> Any:
        radii = microscPSF.calcRv(focus.pixel, focus.n, sampling=sampling)
        profiles = microscPSF.gLZRFocalScan(scope, radii, focus.z, normalize=False, wvl=focus.wavelength)
        return microscPSF.psfRZToPSFXYZ(focus.pixel, focus.n, radii, profiles)

    def usual() -> Any:
        return microscPSF.gLXYZFocalScan(scope, focus.pixel, focus.n, focus.z, normalize=False, wvl=focus.wavelength)

    yield Setup("gLXYZFocalScan (the defaults: 2 radii a pixel)", usual)
    yield Setup("gLZRFocalScan at 64 radii a pixel", lambda: fine(64))
