"""Packages that propagate any pupil to one image; each function yields configurations of one of them."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from benchmarks.setups import Setup
from benchmarks.truth import Question, Window

Array = NDArray[np.float64]
_ARCSEC = math.pi / 648000.0


def prysm(q: Window) -> Iterator[Setup]:
    """prysm: FFT of a padded pupil; matrix Fourier transform."""
    from prysm.coordinates import make_xy_grid
    from prysm.geometry import circle, truecircle
    from prysm.propagation import Wavefront

    wavelength, number = 0.5, 8.0  # micrometres

    def pupil(samples: int, mask: Callable[..., Array]) -> Callable[[], Any]:
        x, y = make_xy_grid(samples, diameter=2.0)
        t = x * x + y * y
        amplitude = mask(1.0, np.sqrt(t))
        # Phases go in as optical path, in nanometres.
        unit = 1000.0 * wavelength / (2.0 * math.pi)
        return lambda: Wavefront.from_amp_and_phase(amplitude, unit * q.phase(x, y, t), wavelength, 2.0 / samples)

    def by_fft(make: Callable[[], Any]) -> Any:
        return make().focus(2.0 * number, Q=round(1.0 / q.pixel)).intensity.data[256:-256, 256:-256]

    def by_matrix(make: Callable[[], Any]) -> Any:
        dx = q.pixel * wavelength * number
        return make().focus_fixed_sampling(2.0 * number, dx, q.n).intensity.data

    usual, fine = pupil(512, circle), pupil(2048, truecircle)
    yield Setup("FFT, 512 samples, Q = 2, circle", lambda: by_fft(usual))
    yield Setup("matrix DFT, 2048 samples, truecircle", lambda: by_matrix(fine))


def hcipy(q: Window) -> Iterator[Setup]:
    """HCIPy: its Fraunhofer propagator, which chooses between FFT and matrix transform."""
    import hcipy as h

    focal = h.make_focal_grid(q=round(1.0 / q.pixel), num_airy=q.n * q.pixel / 2.0)

    def pupil(samples: int, supersampling: int) -> Callable[[], Any]:
        grid = h.make_pupil_grid(samples, 1.0)
        disk = h.make_circular_aperture(1.0)
        aperture = disk(grid) if supersampling == 1 else h.evaluate_supersampled(disk, grid, supersampling)
        propagate = h.FraunhoferPropagator(grid, focal)
        x, y = 2.0 * np.asarray(grid.x), 2.0 * np.asarray(grid.y)
        t = x * x + y * y
        return lambda: propagate(h.Wavefront(aperture * np.exp(1j * q.phase(x, y, t)))).intensity.shaped

    yield Setup("FraunhoferPropagator, 512 samples, hard edge", pupil(512, 1))
    yield Setup("FraunhoferPropagator, 2048 samples, edge supersampled 8 times", pupil(2048, 8))


def poppy(q: Window) -> Iterator[Setup]:
    """POPPY: its optical system with a detector, that is a matrix Fourier transform."""
    import poppy as p
    from astropy import units

    wavelength, diameter = 1e-6, 1.0
    scale = q.pixel * wavelength / diameter / _ARCSEC
    unit = wavelength / (2.0 * math.pi)

    def system(samples: int, wavefront: Any) -> Any:
        train = p.OpticalSystem(pupil_diameter=diameter, npix=samples, oversample=1)
        train.add_pupil(p.CircularAperture(radius=diameter / 2))
        train.add_pupil(wavefront)
        train.add_detector(pixelscale=scale, fov_pixels=q.n, oversample=1)
        return train

    if isinstance(q, Question):
        # Zernike polynomials in Noll's order with unit rms: 4 is defocus, 11 spherical; metres of optical path.
        spherical = q.spherical / (6.0 * math.sqrt(5.0)) * unit
        defocus = (2.0 * q.defocus + q.spherical) / (2.0 * math.sqrt(3.0)) * unit
        coefficients = [0.0, 0.0, 0.0, defocus] + [0.0] * 6 + [spherical]

        def usual() -> Any:
            train = system(1024, p.ZernikeWFE(radius=diameter / 2, coefficients=coefficients))
            return train.calc_psf(wavelength)[0].data

        yield Setup("1024 samples, CircularAperture, ZernikeWFE, matrix DFT", usual, between=True)
    samples = 2048
    x, y = np.meshgrid(*[(np.arange(samples) - 0.5 * (samples - 1)) * 2.0 / samples] * 2)
    t = x * x + y * y
    flat = np.ones_like(t)
    pitch = diameter / samples * units.m / units.pixel
    element = p.ArrayOpticalElement(transmission=flat, opd=unit * q.phase(x, y, t), pixelscale=pitch)
    train = system(samples, element)

    def fine() -> Any:
        element.opd = unit * q.phase(x, y, t)
        return train.calc_psf(wavelength)[0].data

    yield Setup("2048 samples, CircularAperture, ArrayOpticalElement, matrix DFT", fine, between=True)


def dlux(q: Window) -> Iterator[Setup]:
    """dLux: its angular optical system, compiled by JAX."""
    import dLux
    import dLux.utils as dlu
    import jax

    wavelength, diameter = 1e-6, 1.0
    scale = q.pixel * wavelength / diameter / _ARCSEC

    def system(samples: int, oversample: int) -> Callable[[], Any]:
        coordinates = dlu.pixel_coords(samples, diameter)
        x, y = coordinates * (2.0 / diameter)
        t = x * x + y * y
        fine = dlu.pixel_coords(oversample * samples, diameter)
        edge = dlu.downsample(dlu.circle(fine, diameter / 2), oversample)
        train = dLux.AngularOpticalSystem(samples, diameter, [("pupil", dLux.Optic(edge, edge))], q.n, scale)

        # What is an argument, the compiler does not work out beforehand.
        @jax.jit
        def image(x: Any, y: Any, t: Any) -> Any:
            phase = q.phase(x, y, t)
            return train.set("pupil.opd", wavelength / (2.0 * math.pi) * phase).propagate_mono(wavelength)

        image(x, y, t)  # compiles it
        return lambda: image(x, y, t).block_until_ready()

    yield Setup("512 samples, float32, jax.jit", system(512, 5), between=True)
    config: Any = jax.config
    before = config.jax_enable_x64
    config.update("jax_enable_x64", True)
    try:
        yield Setup("2048 samples, float64, jax.jit", system(2048, 5), between=True)
    finally:
        config.update("jax_enable_x64", before)


class _Polar:
    """Gauss-Legendre nodes in t = rho^2 on equidistant rays: about the fewest for 1e-7; `points` are in radians."""

    def __init__(self, q: Window) -> None:
        far = math.hypot(q.n / 2, q.n / 2) * q.step
        along, around = q.slopes
        nodes, angles = math.ceil(0.25 * (0.5 * along + far) + 8.0), 4 * math.ceil(0.25 * (far + around + 30.0))
        u, w = np.polynomial.legendre.leggauss(nodes)
        angle = 2.0 * math.pi * (np.arange(angles) + 0.5) / angles
        self.q, self.t, self.weights = q, 0.5 * (u + 1.0)[:, None], (0.5 * w / angles)[:, None]
        self.x, self.y = np.sqrt(self.t) * np.cos(angle), np.sqrt(self.t) * np.sin(angle)
        self.points = q.step * np.stack([self.y.ravel(), self.x.ravel()], axis=1)

    def strengths(self) -> NDArray[np.complex128]:
        """Return the pupil function times the weights; of a radially symmetric phase each ring is computed once."""
        wave = self.weights * np.exp(1j * self.q.phase(self.x, self.y, self.t))
        return np.broadcast_to(wave, self.x.shape).ravel()

    def __str__(self) -> str:
        return f"{self.x.shape[0]} × {self.x.shape[1]} polar Gauss nodes"


def _square(field: NDArray[np.complex128]) -> Array:
    return np.asarray(field.real**2 + field.imag**2)


def finufft(q: Window) -> Iterator[Setup]:
    """FINUFFT: its 2-D transform of a pupil sampled at polar Gauss nodes."""
    import finufft as f

    polar = _Polar(q)
    y, x = np.ascontiguousarray(polar.points.T)

    def at_once(eps: float) -> Array:
        strengths = polar.strengths()
        return _square(f.nufft2d1(y, x, strengths, (q.n, q.n), eps=eps, nthreads=1))

    def planned(eps: float) -> Callable[[], Array]:
        plan = f.Plan(1, (q.n, q.n), eps=eps, nthreads=1)
        plan.setpts(y, x)
        return lambda: _square(plan.execute(polar.strengths()))

    yield Setup(f"nufft2d1, eps 1e-6 (the default), {polar}", lambda: at_once(1e-6))
    yield Setup(f"a plan, eps 5e-5: about the loosest for 1e-6, {polar}", planned(5e-5))


def ducc0(q: Window) -> Iterator[Setup]:
    """DUCC: its 2-D non-uniform transform of the same nodes, and its FFT."""
    import ducc0 as d

    polar = _Polar(q)
    points = polar.points
    out = np.zeros((q.n, q.n), np.complex128)

    def at_once(eps: float) -> Array:
        strengths = polar.strengths()
        return _square(d.nufft.nu2u(points=strengths, coord=points, forward=True, epsilon=eps, out=out, nthreads=1))

    def planned(eps: float) -> Callable[[], Array]:
        plan = d.nufft.plan(nu2u=True, coord=points, grid_shape=(q.n, q.n), epsilon=eps, nthreads=1)
        return lambda: _square(plan.nu2u(points=polar.strengths(), forward=True, out=out))

    yield Setup(f"nufft.nu2u, epsilon 1e-6, {polar}", lambda: at_once(1e-6))
    yield Setup(f"a plan, epsilon 3e-4: about the loosest for 1e-6, {polar}", planned(3e-4))
    padded = np.zeros((1024, 1024), np.complex128)
    padded[:512, :512] = 1.0
    yield Setup("fft.c2c of 1024² complex128, the FFT alone", lambda: d.fft.c2c(padded, nthreads=1), judged=False)
