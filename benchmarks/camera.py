"""A camera's question: averages over pixels beside FFTs, beside samples, and around an axis for each pupil."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray
from scipy.fft import fft, fft2, ifft, irfft, rfft

import lommel as lm
from benchmarks.contenders import engine, through_focus
from benchmarks.report import Table
from benchmarks.timing import Contender, Measured, Settings, Spread, no_values, race
from benchmarks.truth import RANDOM, Mixed, Question, Truth, exact, exact_averages, intensity
from lommel.blur.blurs import KOLMOGOROV
from lommel.special.legendre import gauss_legendre

SIDE, TOL = 33, 1e-4
_WAVELENGTH = 550e-9
_TERMS = range(4, 16)  # Noll: degrees 2 to 4
_JUDGED = 4  # members of the stack, of each some pixels
_PIXELS = ((16, 16), (16, 17), (13, 19), (22, 16), (11, 21), (24, 9), (2, 30))

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Lenses:
    """Random wavefronts of 12 Zernike terms, and what stands before and behind them.

    Attributes
    ----------
    waves : float
        All terms together, rms.
    count : int
        Pupils of a call.
    obscuration : float
    vanes : int
        Of a fiftieth of the radius.
    over_r0 : float
        The diameter over Fried's parameter; 0 without an atmosphere.
    telescope : str
        One of :mod:`lommel.telescopes`, or "".
    """

    waves: float
    count: int = 1000
    obscuration: float = 0.0
    vanes: int = 0
    over_r0: float = 0.0
    telescope: str = ""

    @property
    def coefficients(self) -> Array:
        """Waves, (count, terms)."""
        c = np.random.default_rng(1873).normal(size=(self.count, len(_TERMS)))
        return np.asarray(self.waves * c / np.linalg.norm(c, axis=1, keepdims=True))

    def fresh(self, times: int) -> list[lm.Pupil]:
        """Return stacks that differ in the seventh digit; a pupil by itself where there is one."""
        c, made = self.coefficients, []
        spider = lm.Spider.equal(self.vanes, width=0.02) if self.vanes else None
        stop = getattr(lm.telescopes, self.telescope)() if self.telescope else None
        for k in range(times):
            each = (1.0 - 1e-7 * k) * (c[k % len(c)] if self.count == 1 else c)
            terms = dict(zip(_TERMS, np.moveaxis(each, -1, 0), strict=True))
            wavefront = lm.Wavefront.zernike(terms, order="noll", unit="waves")
            made.append(lm.Pupil(wavefront, obscuration=self.obscuration, spider=spider, stop=stop))
        return made

    def averaged(self, pixel: float, tol: float, *, integrate: bool = True, dtype: type = np.float32) -> Contender:
        """Return one ``lm.psf`` of all, averaged over pixels or sampled."""

        def call(pupils: lm.Pupil) -> lm.PSF:
            blur = lm.Seeing(1.0 / self.over_r0) if self.over_r0 else ()
            return lm.psf(pupils, SIDE, pixel, integrate=integrate, blur=blur, tol=tol, threads=1, dtype=dtype)

        return Contender("averaged" if integrate else "sampled", call, "", self.fresh, intensity)


@dataclass(frozen=True)
class Camera:
    """A row: pixels of a pitch (metres), the lenses, the tolerance, and the least ratio to FFTs of 128²."""

    f_number: float
    pitch: float
    lenses: Lenses
    must: float | None
    tol: float = TOL

    @property
    def pixel(self) -> float:
        """In lambda N."""
        return self.pitch / (_WAVELENGTH * self.f_number)

    def __str__(self) -> str:
        given = self.lenses
        parts = [given.telescope] * bool(given.telescope) + [
            f"f/{self.f_number:g}, {self.pitch * 1e6:g} µm ({self.pixel:.2g} λN), {given.waves:g} waves rms"
        ]
        parts += [f"obscuration {given.obscuration:g}"] * (given.obscuration > 0.0)
        parts += [f"{given.vanes} vanes"] * (given.vanes > 0) + [f"D / r0 = {given.over_r0:g}"] * (
            given.over_r0 > 0.0
        )
        parts += [f"tol {self.tol:g}"] * (self.tol != TOL)
        return ", ".join([*parts, f"{given.count} PSF{'s' * (given.count > 1)}"])


CAMERAS = (
    Camera(1.8, 1e-6, Lenses(0.1), 2.0),
    Camera(1.8, 2e-6, Lenses(0.1), 2.0),
    Camera(1.8, 4e-6, Lenses(0.1), 1.65),
    Camera(2.8, 4e-6, Lenses(0.1), 2.0),
    Camera(2.8, 4e-6, Lenses(0.1, count=1), None),
    Camera(2.8, 4e-6, Lenses(0.1), 1.0, tol=1e-6),
    Camera(2.8, 4e-6, Lenses(0.1, obscuration=0.3), 1.0),
    Camera(2.8, 4e-6, Lenses(0.2), 0.7),
    Camera(4.0, 6e-6, Lenses(0.1), 2.0),
    Camera(4.0, 6e-6, Lenses(0.1, count=1), None),
    Camera(8.0, 2.2e-6, Lenses(0.1, obscuration=0.3, vanes=4), None),
    Camera(8.0, 4.4e-6, Lenses(0.1, obscuration=0.3, vanes=4), None),
    Camera(8.0, 11.6e-6, Lenses(0.1, count=50, obscuration=0.3, vanes=4), None),
    Camera(13.4, 3.7e-6, Lenses(0.1, count=50, telescope="vlt"), None),
    Camera(20.2, 11e-6, Lenses(0.1, count=50, telescope="jwst"), None),
    Camera(8.0, 11.6e-6, Lenses(0.1, count=1, obscuration=0.3, vanes=4, over_r0=12.0), None),
)


def camera(settings: Settings) -> Table:
    """Measure and judge every row."""
    table = Table(
        "camera",
        "Pixels of a camera",
        f"{SIDE}² pixels at {_WAVELENGTH * 1e9:g} nm, each the average over its area; 12 random Zernike terms, Noll "
        f"{_TERMS[0]} to {_TERMS[-1]}; tol 1e-4 unless said, float32, one thread, each call with other pupils. "
        "Beside SciPy's FFT of 128² complex128 alone, in the cache, for each PSF, though windows of pixels of 2 λN "
        "and more do not fit into it. And beside the whole method in complex64, of the smallest size tried whose "
        "averages are as exact as tol. It is written as an expert would: grey edges, the phase by a matrix of "
        "Zernike terms, pruned FFTs, pixels and seeing by their transfer function. True errors over the peak: "
        "against quadrature of pupil and pixels (with vanes: NonuniformFFT at 1e-7; through seeing: that method with "
        "2048²).",
        {
            "what": "text",
            "must": "text",
            "FFTs of 128² over it": "spread",
            "verdict": "text",
            "FFTs of equal error over it": "spread",
            "their side and error": "text",
            "it over its samples": "spread",
            "true error": "error",
            "bound": "error",
        },
    )
    for camera in CAMERAS[3:5] if settings.quick else CAMERAS:
        settings.tick(str(camera))
        table.add(*_row(camera, settings))
    return table


def _row(camera: Camera, settings: Settings) -> tuple[object, ...]:
    lenses, pixel, tol = camera.lenses, camera.pixel, camera.tol
    mine, plain = lenses.averaged(pixel, tol), ffts(128, np.complex128, lenses.count)
    whole, off = smallest_fft(lenses, pixel, _exact(lenses, pixel), tol)
    one = lenses.coefficients[0]
    expert = Contender("expert", lambda _: whole.image(one))
    others = [plain, expert]
    if not lenses.over_r0:
        others.append(lenses.averaged(pixel, tol, integrate=False))
    result = race([mine, *others], settings.rounds)
    # The expert's images are made one by one.
    each = Spread.of(lenses.count * result.seconds[expert.name] / result.seconds[mine.name])
    ratio = result.ratio(plain.name, mine.name)
    missed = camera.must is not None and ratio.median < camera.must
    answer = mine.call(lenses.fresh(1)[0])
    return (
        str(camera),
        None if camera.must is None else f"≥ {camera.must:g}x",
        ratio,
        "no target" if camera.must is None else "MISSED" if missed else "must",
        each,
        f"{whole.side}², {off:.1e}" + ", the most exact tried" * (off > tol),
        None if lenses.over_r0 else result.ratio(mine.name, "sampled"),
        error(result.values[mine.name], lenses, pixel),
        float(np.max(answer.error_bound)),
    )


def ffts(side: int, dtype: type, count: int) -> Contender:
    """SciPy's FFT alone, one after the other, of an array that stays in the cache."""
    one = np.exp(1j * np.random.default_rng(1).normal(size=(side, side))).astype(dtype)

    def call(_: object) -> None:
        for _again in range(count):
            fft2(one, workers=1)

    config = f"scipy.fft.fft2 of {side}² {np.dtype(dtype)}, {count} times in the cache, the FFT alone"
    return Contender(f"FFTs {side}²", call, config, values=no_values)


class WholeFFT:
    """What an expert would write: grey edges, pruned FFTs, pixels and seeing by their transfer function.

    Attributes
    ----------
    side : int
        Samples of the FFT along each axis.
    across : int
        Samples of a pixel of the image along each axis; two per lambda N hold its intensity.
    """

    def __init__(self, lenses: Lenses, pixel: float, side: int, across: int) -> None:
        self.side, self.across = side, across
        step = pixel / across  # lambda N
        radius = 0.5 * side * step  # of the pupil, samples
        half = math.ceil(radius + 0.5)
        place = np.arange(-half, half + 1) / radius
        pupil = replace(lenses, waves=0.0, count=1).fresh(1)[0]
        clear = _clear(pupil, place, 1.0 / radius)
        self.amplitude = (clear * (pupil.transmission / clear.sum())).astype(np.float32)
        terms = [_zernike(j, place, place[:, None]).ravel() for j in _TERMS]
        self.basis = (2.0 * math.pi * np.stack(terms)).astype(np.float32)
        self.kept = (across * (np.arange(SIDE) - SIDE // 2)) % side
        f = np.fft.fftfreq(side, step)  # over the cut-off, 1 / (lambda N)
        self.bands = min(side // 2, math.ceil(side * step)) + 1
        along, down = np.abs(f[: self.bands]), f[:, None]
        through = np.sinc(pixel * along) * np.sinc(pixel * down)
        if lenses.over_r0:
            through *= np.exp(-KOLMOGOROV * (lenses.over_r0 * np.hypot(along, down)) ** (5.0 / 3.0))
        self.through = through.astype(np.float32)

    def image(self, coefficients: Array) -> NDArray[np.float32]:
        """Return the averages of one wavefront, given in waves."""
        phase = coefficients.astype(np.float32) @ self.basis
        light = self.amplitude * np.exp(1j * phase.reshape(self.amplitude.shape))
        light = fft(fft(light, self.side, axis=1, workers=1), self.side, axis=0, workers=1)
        bands = rfft(light.real**2 + light.imag**2, axis=1, workers=1)[:, : self.bands]
        rows = ifft(fft(bands, axis=0, workers=1) * self.through, axis=0, workers=1)[self.kept]
        return np.asarray(irfft(rows, self.side, axis=1, workers=1)[:, self.kept])


def _zernike(j: int, x: Array, y: Array) -> Array:
    """Return a term in waves of its coefficient in waves rms."""
    small = 0.02
    pupil = lm.Pupil(lm.Wavefront.zernike({j: small}, order="noll", unit="waves"))
    inside = np.minimum(1.0, 1.0 / np.maximum(np.hypot(x, y), 1e-9))  # cells at the edge have their term at the edge
    return np.angle(pupil.values(*np.broadcast_arrays(x * inside, y * inside))) / (2.0 * math.pi * small)


def _clear(pupil: lm.Pupil, place: Array, cell: float) -> Array:
    """Return the part of each cell that the aperture leaves clear: by 16 x 16 points where an edge may cross it."""
    corner = np.abs(
        pupil.values(*np.meshgrid(edges := np.append(place - 0.5 * cell, place[-1] + 0.5 * cell), edges))
    )[0]
    four = np.stack([corner[:-1, :-1], corner[:-1, 1:], corner[1:, :-1], corner[1:, 1:]])
    clear = four.mean(axis=0)
    row, column = np.nonzero(np.ptp(four, axis=0))
    fine = cell * ((np.arange(16) + 0.5) / 16.0 - 0.5)
    x, y = (place[at][:, None, None] + part for at, part in ((column, fine), (row, fine[:, None])))
    clear[row, column] = np.abs(pupil.values(x, y))[0].mean(axis=(1, 2))
    return np.asarray(clear)


def smallest_fft(lenses: Lenses, pixel: float, exact: Array, tol: float) -> tuple[WholeFFT, float]:
    """Return the smallest FFT tried that is as exact as `tol` for the first pupil, else the best; and its error."""
    best: tuple[WholeFFT, float] | None = None
    for side in (128, 192, 256, 384, 512, 768, 1024, 1536, 2048):
        fewest = math.ceil(2.0 * pixel)
        for across in range(fewest, fewest + 4):
            if side < 1.1 * SIDE * across:  # light would wrap into the window
                break
            one = WholeFFT(lenses, pixel, side, across)
            error = float(np.abs(one.image(lenses.coefficients[0]) - exact).max() / exact.max())
            if best is None or error < best[1]:
                best = one, error
            if error <= tol:
                return best
    if best is None:
        raise ValueError(f"no FFT tried holds a window of {SIDE} pixels of {pixel:g} lambda N")
    return best


def _exact(lenses: Lenses, pixel: float) -> Array:
    """Return the averages of the first pupil to seven digits or more."""
    first = replace(lenses, count=1)
    return np.reshape(intensity(first.averaged(pixel, 1e-7, dtype=np.float64).call(first.fresh(1)[0])), (SIDE, SIDE))


def error(values: NDArray[np.float64], lenses: Lenses, pixel: float) -> float:
    """Return the largest error over the peak."""
    if lenses.over_r0:
        fine = WholeFFT(lenses, pixel, 2048, math.ceil(2.0 * pixel) + 1).image(lenses.coefficients[0])
        return float(np.abs(values - fine).max() / fine.max())
    pupils = lenses.fresh(1)[0]
    if lenses.vanes or lenses.telescope:
        many = pupils[:_JUDGED]
        exact = intensity(lm.psf(many, SIDE, pixel, integrate=True, method=lm.methods.NonuniformFFT(1e-7)))
        return float((np.abs(values[:_JUDGED] - exact).max(axis=(1, 2)) / exact.max(axis=(1, 2))).max())
    return _error_by_quadrature(np.reshape(values, (-1, SIDE, SIDE)), pupils, pixel)


def _error_by_quadrature(values: NDArray[np.float64], pupils: lm.Pupil, pixel: float) -> float:
    """Return that of some pixels of some members, by quadrature of pupil and pixels."""
    step = math.pi * pixel
    x, weight = np.polynomial.legendre.leggauss(8 + int(0.8 * step))
    turns = step * SIDE
    r, w = gauss_legendre(40 + int(0.4 * turns), pupils.obscuration, 1.0)
    angles = 80 + int(1.2 * turns)
    theta = 2.0 * math.pi * np.arange(angles) / angles
    across, down = np.outer(r, np.cos(theta)).ravel(), np.outer(r, np.sin(theta)).ravel()
    rule = np.repeat(2.0 / angles * w * r, angles)
    worst = 0.0
    for i in range(min(_JUDGED, len(values))):
        light = np.reshape((pupils[i] if pupils.shape else pupils).values(across, down), -1) * rule
        for row, column in _PIXELS:
            vy, vx = (step * (at - SIDE // 2 + 0.5 * x) for at in (row, column))
            field = (np.exp(-1j * np.outer(vy, down)) * light) @ np.exp(-1j * np.outer(across, vx))
            exact = 0.25 * weight @ np.abs(field) ** 2 @ weight
            worst = max(worst, abs(float(values[i, row, column]) - exact) / float(values[i].max()))
    return worst


_PIXELS_JUDGED = 500  # pixels of a large window
_PIXEL = 3.45e-6
_DISTANCES = np.linspace(0.5, 5.0, 1000)


def average(pupil: lm.Pupil, rows: NDArray[np.int64], columns: NDArray[np.int64], step: float) -> NDArray[np.float64]:
    """Return the averages over pixels so many rows and columns from the axis, by Gauss's rule on each."""
    x, w = np.polynomial.legendre.leggauss(8 + int(0.8 * step))
    y_at, x_at = rows[:, None, None] + 0.5 * x[:, None], columns[:, None, None] + 0.5 * x
    return np.asarray(0.25 * np.einsum("kab,a,b->k", exact(pupil, y_at, x_at, step), w, w))


def average_truth(question: Question) -> Truth:
    """Return the averages over the middle pixel and 499 others, half of them near the axis, where the light is."""
    n = question.n
    rows, columns = np.random.default_rng(1885).integers(0, n, (2, _PIXELS_JUDGED))
    rows[0] = columns[0] = n // 2
    rows[1:250] = n // 2 + rows[1:250] % 32 - 16
    columns[1:250] = n // 2 + columns[1:250] % 32 - 16
    values = average(question.pupil(), rows - n // 2, columns - n // 2, question.step)
    return Truth((rows, columns), values, float(values.max()))


def over_samples(settings: Settings, *, pixel: float) -> Measured:
    """Measure 512², averaged, against the same window sampled."""
    q = Question(10.0, 3.0, pixel=pixel)
    mine, other = (
        engine(q, name=name, out=True, integrate=integrate)
        for name, integrate in (("averaged", True), ("sampled", False))
    )
    result = race([mine, other], settings.rounds)
    error = average_truth(q).error(result.values[mine.name])
    return Measured(result.ratio(mine.name, other.name), error, f"{q}: {mine.config}")


def general_over_samples(settings: Settings, *, pixel: float) -> Measured:
    """Measure 512² of a pupil that is not radially symmetric, averaged, against the same window sampled."""
    q = Mixed(pixel=pixel, directions=RANDOM[0])
    mine, other = (
        engine(q, name=name, out=True, integrate=integrate)
        for name, integrate in (("averaged", True), ("sampled", False))
    )
    result = race([mine, other], settings.rounds)
    values = result.values[mine.name]
    bright = int(np.argmax(values)) // q.n
    rows = np.array([bright - 1, bright, bright + 1, 7])
    exact_values = exact_averages(q, rows)
    worst = float(np.abs(values[rows] - exact_values).max() / exact_values.max())
    return Measured(result.ratio(mine.name, other.name), worst, f"{q}: {mine.config}. Error of four rows")


def stack_over_samples(settings: Settings) -> Measured:
    """Measure the stack of the front page, averaged, against the same stack sampled."""
    lens = lm.Lens(focal_length=50e-3, f_number=1.8, focus_distance=2.0, wavelength=550e-9)
    n = 33
    plans = {integrate: lm.Plan(n, _PIXEL, integrate=integrate, threads=1) for integrate in (True, False)}

    def fresh(count: int) -> list[lm.Pupil]:
        return [lens.pupil(object_distance=_DISTANCES * (1.0 + 1e-9 * k)) for k in range(count)]

    def contender(name: str, integrate: bool) -> Contender:
        out = np.zeros((_DISTANCES.size, n, n), np.float32)
        return Contender(name, lambda pupil: plans[integrate](pupil, out=out), fresh=fresh, values=intensity)

    result = race([contender("averaged", True), contender("sampled", False)], settings.rounds)
    made, pupil, worst = result.values["averaged"], fresh(1)[0], 0.0
    step = float(pupil.v(_PIXEL))
    rows = np.array([0, 0, 1, 2, 5, 16])
    for i in range(0, _DISTANCES.size, 111):
        values = average(pupil[i], rows, rows[::-1].copy(), step)
        got = made[i][n // 2 + rows, n // 2 + rows[::-1]]
        worst = max(worst, float(np.abs(got - values).max() / made[i].max()))
    note = "f/1.8, 550 nm, focused at 2 m, objects at 0.5 to 5 m; a Plan, float32, `out=` given, one thread"
    return Measured(result.ratio("averaged", "sampled"), worst, note)


_COUNT, _SIDE = 1000, 25
_LOOKED = np.array([0, 9, 12, 13, 20])  # pixels on the diagonal


def over_centred(settings: Settings, *, pixel: float, integrate: bool) -> Measured:
    """Measure 1000 of 25², each around its own axis, against the same stack around pixels."""
    centers = _SIDE // 2 + np.random.default_rng(1900).uniform(-0.5, 0.5, (2, _COUNT))
    fresh = through_focus(6.0, _COUNT, 1.5)

    def contender(name: str, **options: object) -> Contender:
        plan = lm.Plan(_SIDE, pixel, integrate=integrate, threads=1, **options)  # type: ignore[arg-type]
        out = np.zeros((_COUNT, _SIDE, _SIDE), np.float32)
        return Contender(name, lambda pupil: plan(pupil, out=out), fresh=fresh, values=intensity)

    result = race([contender("own", center=centers), contender("centred")], settings.rounds)
    made, pupil, worst = result.values["own"], fresh(1)[0], 0.0
    for i in range(0, _COUNT, 111):
        y, x = _LOOKED - centers[:, i, None]
        truth = (average if integrate else exact)(pupil[i], y, x, math.pi * pixel)
        worst = max(worst, float(np.abs(made[i][_LOOKED, _LOOKED] - truth).max() / made[i].max()))
    note = f"abs(C_d) <= 6, C_s = 1.5, pixel {pixel:g} λN; a Plan, float32, `out=` given, one thread"
    return Measured(result.ratio("own", "centred"), worst, note)
