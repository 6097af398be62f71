"""What averaging over the pixels costs beside sampling their centres."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

import lommel as lm
from benchmarks.engine import engine
from benchmarks.mixed import RANDOM, Mixed, exact_averages
from benchmarks.settings import Settings
from benchmarks.targets import Measured
from benchmarks.timing import Contender, race
from benchmarks.truth import Question, Truth, exact, intensity

_JUDGED = 500  # pixels of a large window
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
    rows, columns = np.random.default_rng(1885).integers(0, n, (2, _JUDGED))
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
    return Measured(result.ratio(mine.name, other.name), worst, f"{q}: {mine.config}; error of four rows")


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
