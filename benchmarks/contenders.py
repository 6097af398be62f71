"""The contenders: lommel's public calls, the FFT, copying memory, the strongest answers in plain NumPy and SciPy."""

from __future__ import annotations

import math
import time
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from functools import lru_cache, partial
from importlib.util import find_spec
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

import lommel as lm
from benchmarks.timing import Contender, Measured, Settings, no_values, race
from benchmarks.truth import Window, intensity, stack_error

Array = NDArray[np.float64]
Fresh = Callable[[int], list[lm.Pupil]]


@lru_cache(maxsize=1)
def fft(side: int = 1024) -> Contender:
    """SciPy's FFT alone, as fast as it gets: no pupil is sampled, no intensity taken, nothing allocated.

    It works in place (and is unitary, so that nothing grows), in the fastest of several buffers: with the physical
    pages that a buffer happens to get, large ones or scattered small ones, the same call takes up to twice as long.
    """
    from scipy.fft import fft2

    x = np.arange(side) - side // 2
    t = np.minimum((x[:, None] ** 2 + x**2) / (side / 4) ** 2, 1.0)
    padded = np.where(t < 1.0, np.exp(20j * t), 0.0)

    def seconds(buffer: NDArray[np.complex128]) -> float:
        taken = []
        for _ in range(4):
            start = time.perf_counter()
            fft2(buffer, norm="ortho", overwrite_x=True, workers=1)
            taken.append(time.perf_counter() - start)
        return min(taken)

    if side <= 1024:
        # All are kept until one is chosen, or each would get the pages of the one before.
        padded = min([padded.copy() for _ in range(8)], key=seconds)
    config = f"scipy.fft.fft2 of {side}² complex128, in place, the FFT alone"
    return Contender(
        f"FFT {side}²",
        lambda _: fft2(padded, norm="ortho", overwrite_x=True, workers=1),
        config,
        values=no_values,
    )


def faster_ffts(side: int = 1024) -> list[Contender]:
    """DUCC's FFT alone, in place, in double and in single precision, where it is installed."""
    if find_spec("ducc0") is None:
        return []
    import ducc0

    def one(dtype: Any) -> Contender:
        padded = np.full((side, side), 0.5, dtype)
        options = {"out": padded, "inorm": 1, "nthreads": 1}
        name = np.dtype(dtype).name
        return Contender(name, lambda _: ducc0.fft.c2c(padded, **options), f"ducc0.fft.c2c, {name}", values=no_values)

    return [one(np.complex128), one(np.complex64)]


def copy(shape: tuple[int, ...], dtype: Any) -> Contender:
    """Copy an array of that shape: what writing the answer costs at least."""
    source, target = np.ones(shape, dtype), np.zeros(shape, dtype)
    config = f"np.copyto of {'×'.join(map(str, shape))} {np.dtype(dtype)}"
    return Contender("np.copyto", lambda _: np.copyto(target, source), config, values=no_values)


class Fold:
    """Distinct radii of an n x n window, and where each pixel finds its own."""

    def __init__(self, n: int, step: float) -> None:
        self.n, self.middle = n, n // 2
        i = np.arange(self.middle + 1)
        squares, place = np.unique(i[:, None] ** 2 + i**2, return_inverse=True)
        self.v = step * np.sqrt(squares)
        self.quadrant = place.ravel()
        mirror = np.abs(np.arange(n) - self.middle)
        self.full = place.reshape(i.size, i.size)[mirror[:, None], mirror].ravel()

    def gather(self, profiles: NDArray[Any], out: NDArray[Any]) -> None:
        """Write profiles (k, radii) as images (k, n, n), pixel by pixel."""
        np.take(profiles, self.full, axis=1, out=out.reshape(len(out), -1), mode="clip")

    def mirror(self, profiles: NDArray[Any], out: NDArray[Any]) -> None:
        """Write profiles (k, radii) as images (k, n, n), a quadrant and its mirror images."""
        m, rest = self.middle, self.n - self.middle
        q = np.take(profiles, self.quadrant, axis=1, mode="clip").reshape(-1, m + 1, m + 1)
        out[:, m:, m:] = q[:, :rest, :rest]
        out[:, m:, :m] = q[:, :rest, m:0:-1]
        out[:, :m, m:] = q[:, m:0:-1, :rest]
        out[:, :m, :m] = q[:, m:0:-1, m:0:-1]


class Plain:
    """Gauss-Legendre in rho^2 with a cached table of J0, onto the pixels.

    Parameters
    ----------
    n, step
        Side of the window, pixel pitch in v.
    nodes : int
        Of the quadrature.
    radii : int
        At so many equidistant radii, then interpolated, unless the way is "direct".
    product : {"gemm", "gemv"}
        One real matrix product for real and imaginary parts, or two with a vector.
    way : {"spline", "pixels", "sparse", "direct"}
        `CubicSpline` onto the distinct radii, or onto every pixel; a cached sparse matrix of local cubics; or
        quadrature at each distinct radius.
    write : {"mirror", "gather"}
    dtype : float32 or float64
    count : int
        Of images.
    """

    def __init__(
        self,
        n: int,
        step: float,
        nodes: int,
        radii: int = 0,
        *,
        product: str = "gemm",
        way: str = "spline",
        write: str = "mirror",
        dtype: Any = np.float32,
        count: int = 1,
    ) -> None:
        from scipy.special import j0

        self.fold = Fold(n, step)
        self.product, self.way, self.write = product, way, write
        self.v = self.fold.v if way == "direct" else np.linspace(0.0, self.fold.v[-1], radii)
        x, w = np.polynomial.legendre.leggauss(nodes)
        self.t, self.weights = 0.5 * (x + 1.0), 0.5 * w
        self.powers = np.stack([self.t, self.t * self.t])
        self.kernel = np.ascontiguousarray(j0(np.sqrt(self.t)[:, None] * self.v))
        self.out = np.empty((count, n, n), dtype)
        self.matrix = _local_cubics(self.v, self.fold.v) if way == "sparse" else None

    def __call__(self, pupil: lm.Pupil) -> NDArray[Any]:
        """Return the images (k, n, n), in an array that the next call uses again."""
        self.part(pupil.coefficients(), self.out)
        return self.out

    def part(self, coefficients: Array, out: NDArray[Any]) -> None:
        """Write the images of phases ``c_1 t + c_2 t^2``."""
        profiles = self._profiles(coefficients)
        if self.way == "pixels":
            self._spline(profiles, out)
            return
        if self.matrix is not None:
            profiles = (self.matrix @ profiles.T).T
        elif self.way == "spline":
            profiles = self._splined(profiles)
        profiles = profiles.astype(out.dtype, copy=False)
        (self.fold.mirror if self.write == "mirror" else self.fold.gather)(profiles, out)

    def _profiles(self, coefficients: Array) -> Array:
        phase = coefficients @ self.powers
        k = len(phase)
        waves = np.empty((2 * k, self.t.size))
        np.cos(phase, out=waves[:k])
        np.sin(phase, out=waves[k:])
        waves *= self.weights
        if self.product == "gemm":
            field = waves @ self.kernel
            a, b = field[:k], field[k:]
        else:
            a, b = (waves[0] @ self.kernel)[None], (waves[1] @ self.kernel)[None]
        np.multiply(a, a, out=a)
        np.multiply(b, b, out=b)
        return np.asarray(np.add(a, b, out=a))

    def _splined(self, profiles: Array) -> Array:
        from scipy.interpolate import CubicSpline

        if len(profiles) == 1:
            return np.asarray(CubicSpline(self.v, profiles[0])(self.fold.v))[None]
        return np.asarray(CubicSpline(self.v, profiles, axis=1)(self.fold.v))

    def _spline(self, profiles: Array, out: NDArray[Any]) -> None:
        from scipy.interpolate import CubicSpline

        at, flat = self.fold.v[self.fold.full], out.reshape(len(out), -1)
        if len(out) == 1:
            flat[0] = CubicSpline(self.v, profiles[0])(at)
        else:
            flat[:] = CubicSpline(self.v, profiles, axis=1)(at)

    def __str__(self) -> str:
        product = "one GEMM" if self.product == "gemm" else "two GEMV"
        ways = {
            "pixels": f"{self.v.size} radii, CubicSpline onto every pixel",
            "spline": f"{self.v.size} radii, CubicSpline onto the distinct radii, {self.write}",
            "sparse": f"{self.v.size} radii, cached sparse matrix of local cubics, {self.write}",
            "direct": f"the {self.v.size} distinct radii, {self.write}",
        }
        return f"{self.t.size} nodes, {product}, {ways[self.way]}"


def _local_cubics(v: Array, at: Array) -> Any:
    """Return the sparse matrix of four-point Lagrange interpolation from equidistant `v`."""
    from scipy.sparse import csr_array

    place = at / (v[1] - v[0])
    first = np.clip(np.floor(place).astype(np.int64) - 1, 0, v.size - 4)
    p = place - first
    weights = np.stack(
        [
            -(p - 1) * (p - 2) * (p - 3) / 6,
            p * (p - 2) * (p - 3) / 2,
            -p * (p - 1) * (p - 3) / 2,
            p * (p - 1) * (p - 2) / 6,
        ],
        axis=1,
    )
    columns = first[:, None] + np.arange(4)
    return csr_array((weights.ravel(), columns.ravel(), 4 * np.arange(at.size + 1)), shape=(at.size, v.size))


def fewest(
    n: int, step: float, pupil: lm.Pupil, reference: Array, *, way: str, dtype: Any = np.float32, tol: float = 1e-6
) -> tuple[int, int]:
    """Return about the fewest nodes and radii (to 3 %) with an error below `tol`, found by trying."""

    def good(nodes: int, radii: int) -> bool:
        one = Plain(n, step, nodes, radii, way=way, dtype=dtype, count=len(reference))
        return stack_error(one(pupil), reference) <= tol

    nodes, radii = 32, 512
    while not good(nodes, radii):
        nodes, radii = nodes * 2, radii * 2
        if radii > 2**17:
            raise ArithmeticError(f"plain quadrature does not reach {tol:g}")
    # Each in turn as few as the other's present number allows.
    if way != "direct":
        radii = _least(lambda r: good(nodes, r), radii // 8, radii)
    nodes = _least(lambda k: good(k, radii), nodes // 8, nodes)
    return nodes, radii


def _least(good: Callable[[int], bool], low: int, high: int) -> int:
    while high > math.ceil(1.03 * low):
        middle = (low + high) // 2
        low, high = (low, middle) if good(middle) else (middle, high)
    return high


def plain(name: str, way: Plain, fresh: Fresh, *, threads: int = 1) -> Contender:
    """Make a contender; two threads each take half of a stack."""
    if threads == 1:
        return Contender(name, way, str(way), fresh)
    pool = ThreadPoolExecutor(threads)
    edges = np.linspace(0, len(way.out), threads + 1).astype(int)
    parts = [slice(a, b) for a, b in pairwise(edges)]

    def call(pupil: lm.Pupil) -> NDArray[Any]:
        coefficients = pupil.coefficients()
        list(pool.map(lambda part: way.part(coefficients[part], way.out[part]), parts))
        return way.out

    return Contender(name, call, f"{way}, {threads} threads", fresh)


def engine(
    question: Window,
    *,
    name: str = "lommel",
    method: lm.methods.Method | None = None,
    threads: int = 1,
    out: bool = False,
    dtype: Any = None,
    **options: Any,
) -> Contender:
    """Make one PSF, each time of a new pupil: by ``lm.psf`` or, into an array that is there already, by a plan."""
    q = question
    if method is not None:
        options["method"] = method
    if q.center is not None:
        options["center"] = q.center
    if dtype is not None:
        options["dtype"] = dtype
    call = _into(np.zeros((q.n, q.n), dtype or np.float32), q.n, q.pixel, threads, options) if out else None

    def fresh_array(pupil: lm.Pupil) -> lm.PSF:
        return lm.psf(pupil, q.n, q.pixel, threads=threads, **options)

    return Contender(name, call or fresh_array, describe(method, threads, out, dtype), q.fresh, intensity)


def stack(
    fresh: Callable[[int], list[lm.Pupil]],
    n: int,
    pixel: float,
    *,
    name: str = "lommel",
    method: lm.methods.Method | None = None,
    threads: int = 1,
    out: bool = False,
    dtype: Any = np.float64,
) -> Contender:
    """Make a stack of PSFs at once, each time of a new stack of pupils; with `out`, by a plan."""
    options: dict[str, Any] = {"dtype": dtype} if method is None else {"dtype": dtype, "method": method}
    call = _into(np.zeros((*fresh(1)[0].shape, n, n), dtype), n, pixel, threads, options) if out else None

    def fresh_array(pupils: lm.Pupil) -> lm.PSF:
        return lm.psf(pupils, n, pixel, threads=threads, **options)

    return Contender(name, call or fresh_array, describe(method, threads, out, dtype), fresh, intensity)


def _into(out: NDArray[Any], n: int, pixel: float, threads: int, options: dict[str, Any]) -> Callable[[Any], lm.PSF]:
    """Return a function that computes PSFs into an array that is there already."""
    plan = lm.Plan(n, pixel, threads=threads, **{k: v for k, v in options.items() if k != "derivatives"})
    return partial(plan, out=out, derivatives=options.get("derivatives", ()))


def describe(method: lm.methods.Method | None, threads: int, out: bool, dtype: Any) -> str:
    """Say in words what was asked for."""
    parts = ["lm.Plan(...)" if out else "lm.psf(...)", "default method, tol 1e-6" if method is None else repr(method)]
    parts += [] if dtype is None else [str(np.dtype(dtype))]
    parts += ["out= given"] if out else []
    return ", ".join([*parts, f"threads={threads}"])


def through_focus(reach: float, count: int, spherical: float = 0.0) -> Callable[[int], list[lm.Pupil]]:
    """Return a maker of stacks of pupils from ``C_d = -reach`` to ``reach``."""
    defocus = np.linspace(-reach, reach, count)

    def fresh(times: int) -> list[lm.Pupil]:
        return [lm.Pupil(lm.Wavefront(defocus * (1.0 - 1e-7 * k), spherical)) for k in range(times)]

    return fresh


def over_abs(
    settings: Settings, mine: Contender, error: Callable[[NDArray[Any]], float] | None, note: str
) -> Measured:
    """Measure a call against the modulus of 33² complex numbers, which takes a few microseconds."""
    field = np.exp(1j * np.arange(33.0**2)).reshape(33, 33)
    other = Contender("abs", lambda _: np.abs(field))
    result = race([mine, other], settings.rounds)
    found = None if error is None else error(result.values[mine.name])
    note = (
        f"{note}, {1e6 * result.median(mine.name):.2g} µs. Against np.abs, {1e6 * result.median(other.name):.2g} µs"
    )
    return Measured(result.ratio(mine.name, other.name), found, note)


def by_plan(q: Window, *, pupils: bool = False) -> Contender:
    """One window of a new pupil by a plan; `pupils`: and making that, of 5 rad of defocus."""
    live, frame = lm.Plan(q.n, q.pixel, threads=1), np.zeros((q.n, q.n), np.float32)
    if pupils:
        return Contender(
            "plan", lambda _: live(lm.Pupil(lm.Wavefront(5.0)), out=frame), values=lambda a: a.values / a.scale
        )
    return Contender("plan", lambda pupil: live(pupil, out=frame), fresh=q.fresh, values=lambda a: a.values / a.scale)
