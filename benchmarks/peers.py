"""Other packages, where they are installed: each by its own means, judged by the same quadrature."""

from __future__ import annotations

import math
import warnings
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from importlib.metadata import PackageNotFoundError, version
from importlib.util import find_spec
from itertools import islice
from typing import Any

import numpy as np
from numpy.typing import NDArray

import lommel as lm
from benchmarks.contenders import engine, faster_ffts
from benchmarks.report import Table
from benchmarks.timing import Contender, Settings, race
from benchmarks.truth import (
    RANDOM,
    Mixed,
    Question,
    Window,
    aperture_error,
    exact,
    exact_stack,
    stack_error,
    truth,
)


@dataclass(frozen=True)
class Setup:
    """One configuration of a package.

    Attributes
    ----------
    config : str
    call : callable
        Computes the image or the stack; the grids, masks and plans that do not depend on the aberrations are there.
    between : bool
        Whether the axis of the window lies between its middle pixels.
    averaged : bool
        Whether pixels average the intensity over their area.
    judged : bool
        Whether what `call` returns is an intensity that can be judged.
    """

    config: str
    call: Callable[[], Any]
    between: bool = False
    averaged: bool = False
    judged: bool = True


@dataclass(frozen=True)
class Focus:
    """A stack through focus of a scalar microscope, all refractive indices alike.

    The phase ``k z sqrt(n^2 - NA^2 rho^2)`` is no paraxial one: its series in rho^2 to rho^20, which at this NA is
    exact to 1e-5 rad, is what lommel is given.
    """

    n: int = 255
    planes: int = 64
    aperture: float = 0.8
    index: float = 1.5
    wavelength: float = 0.55
    pixels: float = 0.5
    reach: float = 20.0

    @property
    def pixel(self) -> float:
        """Pixel pitch in micrometres."""
        return self.pixels * self.wavelength / (2.0 * self.aperture)

    @property
    def z(self) -> NDArray[np.float64]:
        """Defocus in micrometres, C_d = `reach` at the ends; whole nanometres, as one of the packages needs them."""
        far = 2.0 * self.reach * self.index * self.wavelength / (np.pi * self.aperture**2)
        return np.linspace(-1.0, 1.0, self.planes) * round(1000.0 * far) / 1000.0

    def pupil(self, share: float = 1.0) -> lm.Pupil:
        """Return the stack of pupils."""
        phase = 2.0 * np.pi / self.wavelength * self.index * share * self.z
        square, term, series = (self.aperture / self.index) ** 2, 1.0, []
        for k in range(1, 11):
            term *= -square * (1.5 - k) / k
            series.append(phase * term)
        return lm.Pupil(lm.Wavefront(0.5 * series[0], series[1], series[2:]))

    def fresh(self, count: int) -> list[lm.Pupil]:
        """Return that many new stacks."""
        return [self.pupil(1.0 - 1e-7 * k) for k in range(count)]

    def exact(self, *, averaged: bool) -> NDArray[np.float64]:
        """Return the exact stack, of samples or of averages over pixels (25 points each)."""
        if not averaged:
            return exact_stack(self.pupil(), self.n, self.pixels)
        x, w = np.polynomial.legendre.leggauss(5)
        # A quadrant, from the axis outwards, is enough.
        half = self.n // 2
        at = np.arange(half + 1)[:, None] + 0.5 * x
        total = np.zeros((self.planes, half + 1, half + 1))
        for j in range(x.size):
            for i in range(x.size):
                part = exact(self.pupil(), at[:, j, None], at[:, i], np.pi * self.pixels)
                total += 0.25 * w[j] * w[i] * part
        mirror = np.abs(np.arange(self.n) - half)
        return total[:, mirror[:, None], mirror]


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


Adapter = Callable[[Any], Iterator[Setup]]


def _adapters() -> tuple[dict[str, tuple[str, Adapter]], dict[str, tuple[str, Adapter]]]:
    """Return the adapters of images and of stacks: name of the distribution to that of the module, and function."""
    images: dict[str, tuple[str, Adapter]] = {
        "prysm": ("prysm", prysm),
        "hcipy": ("hcipy", hcipy),
        "poppy": ("poppy", poppy),
        "dLux": ("dLux", dlux),
        "solvephase": ("solvephase", solvephase),
        "finufft": ("finufft", finufft),
        "ducc0": ("ducc0", ducc0),
    }
    stacks: dict[str, tuple[str, Adapter]] = {
        "psf-generator": ("psf_generator", psf_generator),
        "psfmodels": ("psfmodels", psfmodels),
        "MicroscPSF-Py": ("microscPSF", microscpsf),
    }
    return images, stacks


def peer_versions() -> dict[str, str]:
    """Return the versions of the packages that are installed."""
    found = {}
    for group in _adapters():
        for name in group:
            try:
                found[name] = version(name)
            except PackageNotFoundError:
                continue
    return found


_COLUMNS = {"package": "text", "configuration": "text", "over lommel": "spread", "true error": "error", "": "text"}


def images(settings: Settings) -> Table:
    """One PSF of 512² by packages that propagate any pupil."""
    q = Question(10.0, 3.0)
    table = Table(
        "peers",
        "Other packages: one PSF",
        f"512², {q}, one thread. Each package is given the same pupil and, where it can, the same window. Its grids, "
        "masks, plans and compiled code are there beforehand, so what is timed is the phase, the propagation and the "
        "squared modulus. The true error is against quadrature at the radii of the package's own pixels, its values "
        "multiplied by the one number that fits best, since the units of intensity differ. Of each package there is "
        "a usual configuration and the most exact one that still is reasonable. Values are samples: here a pixel in "
        "units of λN samples its centre, as poppy, prysm and hcipy do; one in metres averages over its area unless "
        "integrate=False is given.",
        _COLUMNS,
    )
    middle = (q.n - 1) / 2.0
    between = Question(q.defocus, q.spherical, center=(middle, middle))

    def error(one: Setup, values: NDArray[Any]) -> float:
        return truth(between if one.between else q).error(values, fit=True)

    return _run(settings, table, _adapters()[0], q, {False: engine(q)}, error)


def nonradial(settings: Settings) -> Table:
    """One PSF of 512² of a pupil that is not radially symmetric, by the same packages."""
    asked = [Mixed(pixel=pixel, directions=RANDOM[0]) for pixel in (0.25, 0.5, 1.0)]
    table = Table(
        "peers-nonradial",
        "Other packages: one PSF of a pupil that is not radially symmetric",
        f"512², coma, astigmatism, trefoil and defocus of {asked[1].reach:g} rad each, directions "
        f"{asked[1].degrees}, one thread, in the same way. Of packages that sample the pupil on a lattice there is "
        "only their usual configuration, at 0.5 λN. An image turned by half a turn, as transforms of the other "
        "sign make it, is as good.",
        {"pixel": "text"} | _COLUMNS,
    )
    images = _adapters()[0]
    for q in asked[1:2] if settings.quick else asked:

        def error(one: Setup, values: NDArray[Any], q: Mixed = q) -> float:
            seen = replace(q, center=((q.n - 1) / 2.0, (q.n - 1) / 2.0)) if one.between else q
            return min(aperture_error(way, values, fit=True) for way in (seen, seen.turned()))

        most = {"prysm": 1, "hcipy": 1, "dLux": 1, "solvephase": 1, "ducc0": 2}
        adapters = {name: one for name, one in images.items() if q.pixel == 0.5 or name in ("finufft", "ducc0")}
        _run(settings, table, adapters, q, {False: engine(q)}, error, most, before=(f"{q.pixel:g} λN",))
    return table


def stacks(settings: Settings) -> Table:
    """64 planes through focus by packages for microscopes."""
    focus = Focus(planes=16 if settings.quick else 64, n=127 if settings.quick else 255)
    table = Table(
        "peers-stack",
        "Other packages: a stack through focus",
        f"{focus.planes} planes of {focus.n}², abs(C_d) ≤ {focus.reach:g}, pixels of {focus.pixels:g} λN, one "
        f"thread: a scalar microscope of NA {focus.aperture:g} with every refractive index {focus.index:g}, so that "
        "nothing but the defocus is left. The packages have it as k z √(n² − NA² ρ²), which lommel is given as its "
        "series to ρ²⁰. Errors as above, each plane over its own peak, one factor for the stack. A package that "
        "averages over pixels is judged by averages, and compared with `integrate=True`.",
        _COLUMNS,
    )
    mine = {
        averaged: Contender(
            "lommel",
            lambda pupils, averaged=averaged: lm.psf(pupils, focus.n, focus.pixels, threads=1, integrate=averaged),  # type: ignore[misc]
            fresh=focus.fresh,
            values=lambda answer: answer.values,
        )
        for averaged in (False, True)
    }
    known: dict[bool, NDArray[np.float64]] = {}

    def error(one: Setup, values: NDArray[Any]) -> float:
        if one.averaged not in known:
            known[one.averaged] = focus.exact(averaged=one.averaged)
        reference = known[one.averaged]
        got = np.asarray(values, dtype=np.float64).reshape(reference.shape)
        return stack_error(got * (np.vdot(got, reference) / np.vdot(got, got)), reference)

    return _run(settings, table, _adapters()[1], focus, mine, error)


def _run(
    settings: Settings,
    table: Table,
    adapters: dict[str, tuple[str, Adapter]],
    question: Any,
    mine: dict[bool, Contender],
    error: Callable[[Setup, NDArray[Any]], float],
    most: Mapping[str, int] | None = None,
    before: tuple[str, ...] = (),
) -> Table:
    """Measure each package; `most` limits how many of its configurations, `before` comes first in every row."""
    for name, (module, adapter) in adapters.items():
        if find_spec(module) is None:
            table.add(*before, name, None, None, None, "skipped: not installed")
            continue
        setup: Setup | None = None
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                for setup in islice(adapter(question), 1 if settings.quick else (most or {}).get(name)):
                    settings.tick(f"{name}, {setup.config}")
                    one = Contender(name, lambda _, call=setup.call: call())  # type: ignore[misc]
                    first = mine[setup.averaged]
                    result = race([first, one], settings.rounds, budget=0.5 if settings.quick else 2.0)
                    judged = error(setup, result.values[name]) if setup.judged else None
                    table.add(*before, name, setup.config, result.ratio(name, first.name), judged, None)
        except Exception as reason:  # whatever another package raises belongs in its row
            said = " ".join(str(reason).split())[:100]
            table.add(*before, name, setup.config if setup else None, None, None, f"{type(reason).__name__}: {said}")
    return table
