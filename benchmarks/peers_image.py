"""Packages that propagate any pupil to one image; each function yields configurations of one of them."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from benchmarks.baselines import faster_ffts
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
    yield Setup("FFT, 512 samples, Q = 2, circle, default precision (double)", lambda: by_fft(usual))
    yield Setup("matrix DFT, 2048 samples, truecircle, default precision (double)", lambda: by_matrix(fine))


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

    yield Setup("FraunhoferPropagator, 512 samples, hard edge, default precision (double)", pupil(512, 1))
    yield Setup(
        "FraunhoferPropagator, 2048 samples, edge supersampled 8 times, default precision (double)", pupil(2048, 8)
    )


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

        yield Setup(
            "1024 samples, CircularAperture, ZernikeWFE, matrix DFT, default precision (double)", usual, between=True
        )
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

    yield Setup(
        "2048 samples, CircularAperture, ArrayOpticalElement, matrix DFT, default precision (double)",
        fine,
        between=True,
    )


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


def solvephase(q: Window) -> Iterator[Setup]:
    """solvephase: the forward model of its phase retrieval, an FFT or a matrix Fourier transform."""
    import solvephase as s

    wavelength = 1e-6

    def model(samples: int, supersample: int, precision: str) -> Callable[[], Any]:
        pupil = s.Pupil.circular(samples, supersample=supersample)
        options = {"sampling": 1.0 / q.pixel, "offset": -0.5, "precision": precision}
        forward = s.FocalPlaneModel(pupil, wavelength, q.n, **options)
        y, x = (2.0 * part for part in pupil.coordinates())
        t = x * x + y * y
        dtype = np.float32 if precision == "single" else np.float64
        return lambda: forward.forward(q.phase(x, y, t).astype(dtype)).images[0]

    yield Setup("512 samples, single precision", model(512, 4, "single"))
    yield Setup("2048 samples, edge supersampled 8 times, double precision", model(2048, 8, "double"))


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


class _Single:
    """The same in single precision: phase and exponential, and later the square, in one compiled pass each."""

    def __init__(self, polar: _Polar) -> None:
        import numba

        written = numba.njit(type(polar.q).written)

        @numba.njit(fastmath=True)
        def strengths(x: Any, y: Any, t: Any, weights: Any, constants: Any, out: Any) -> None:
            for i in range(out.size):
                phase = written(x[i], y[i], t[i], constants)
                out[i] = weights[i] * complex(np.cos(phase), np.sin(phase))

        @numba.njit(fastmath=True)
        def square(field: Any, out: Any) -> None:
            for i in range(out.size):
                out[i] = field[i].real * field[i].real + field[i].imag * field[i].imag

        shape, n = polar.x.shape, polar.q.n
        self._nodes = [
            np.ascontiguousarray(np.broadcast_to(part, shape).ravel(), dtype=np.float32)
            for part in (polar.x, polar.y, polar.t, polar.weights)
        ]
        self._constants = tuple(np.float32(c) for c in polar.q.constants)
        self._compiled = strengths, square
        self._out = np.empty(polar.x.size, np.complex64), np.empty((n, n), np.float32)
        self.points = polar.points.astype(np.float32)
        self.field = np.zeros((n, n), np.complex64)

    def strengths(self) -> NDArray[np.complex64]:
        """Return the pupil function times the weights."""
        self._compiled[0](*self._nodes, self._constants, self._out[0])
        return self._out[0]

    def square(self, field: NDArray[np.complex64]) -> NDArray[np.float32]:
        """Return its squared modulus."""
        self._compiled[1](field.ravel(), self._out[1].ravel())
        return self._out[1]


_LOOSE = "in single precision, phase and square compiled by numba"


def _square(field: NDArray[np.complex128]) -> Array:
    return np.asarray(field.real**2 + field.imag**2)


def finufft(q: Window) -> Iterator[Setup]:
    """FINUFFT: its 2-D transform of a pupil sampled at polar Gauss nodes."""
    import finufft as f

    polar = _Polar(q)
    y, x = np.ascontiguousarray(polar.points.T)

    def usual() -> Array:
        return _square(f.nufft2d1(y, x, polar.strengths(), (q.n, q.n), nthreads=1))

    yield Setup(f"nufft2d1, eps 1e-6 (the default), {polar}", usual)
    single = _Single(polar)
    plan = f.Plan(1, (q.n, q.n), eps=5e-5, dtype="complex64", nthreads=1)
    plan.setpts(y.astype(np.float32), x.astype(np.float32))

    def fast() -> NDArray[np.float32]:
        return single.square(plan.execute(single.strengths(), out=single.field))

    yield Setup(f"a plan, eps 5e-5, {_LOOSE}, {polar}", fast)


def ducc0(q: Window) -> Iterator[Setup]:
    """DUCC: its 2-D non-uniform transform of the same nodes, and its FFT."""
    import ducc0 as d

    polar = _Polar(q)
    out = np.zeros((q.n, q.n), np.complex128)

    def usual() -> Array:
        strengths = polar.strengths()
        return _square(
            d.nufft.nu2u(points=strengths, coord=polar.points, forward=True, epsilon=1e-6, out=out, nthreads=1)
        )

    yield Setup(f"nufft.nu2u, epsilon 1e-6, {polar}", usual)
    yield ducc0_single(q)
    for one in faster_ffts():
        yield Setup(f"{one.config}, 1024², the FFT alone", lambda call=one.call: call(None), judged=False)  # type: ignore[misc]


def ducc0_single(q: Window) -> Setup:
    """DUCC as those would run it who know it: single precision, about the loosest epsilon for errors of 1e-6."""
    import ducc0 as d

    polar = _Polar(q)
    single = _Single(polar)
    plan = d.nufft.plan(nu2u=True, coord=single.points, grid_shape=(q.n, q.n), epsilon=3e-4, nthreads=1)

    def fast() -> NDArray[np.float32]:
        return single.square(plan.nu2u(points=single.strengths(), forward=True, out=single.field))

    return Setup(f"a plan, epsilon 3e-4, {_LOOSE}, {polar}", fast)
