"""Blur over the field: its cost over that of blur by depth, and its true error at random sources.

    python benchmarks/field_blur.py [1000]

A sensor of 20 x 14 mm with coma of 1.5 and astigmatism of 1 wave in its corner, shown in 500 x 741 pixels. For some
pixels, tolerances and shares of light prints the windows and their nodes, the time that they take to be made and that
of a call over that of :class:`lommel.imaging.DepthBlur` with windows of the same size, and the largest and the median
sum of absolute differences to exact PSFs at so many random sources: of the same window, and of all light, with what
lies beyond 200 pixels as one sum. Then the same with a depth.
"""

from __future__ import annotations

import sys
import time
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

import lommel as lm
from benchmarks.timing import Contender, race
from lommel.imaging import DepthBlur, FieldBlur

SHAPE, SENSOR = (500, 741), (14e-3, 20e-3)
LENS = lm.Lens(focal_length=50e-3, f_number=4.0, focus_distance=2.0, wavelength=550e-9)
FIELD = lm.FieldMap.from_seidel(12.25e-3, W131=1.5, W222=1.0, aperture=LENS.pupil(2.0).unaberrated())
CASES = [
    # pixel, tol, energy
    (2e-6, 1e-2, 0.98),
    (2e-6, 1e-3, 0.98),
    (2e-6, 1e-4, 0.98),
    (2e-6, 1e-3, 0.995),
    (1e-6, 1e-3, 0.98),
    (1e-6, 1e-3, 0.995),
    (0.5e-6, 1e-3, 0.95),
    (2e-6, 3e-3, 1.0),
    (2e-6, 1e-3, 1.0),
]
FAR = 200  # pixels on each side, as far as exact PSFs are made
_FEW, _AT_ONCE = 100, 20  # sources that are compared so far


def light() -> NDArray[np.float32]:
    """Return an image."""
    return np.random.default_rng(0).random(SHAPE, dtype=np.float32)


@lru_cache(maxsize=8)
def by_depth(half: int, pixel: float, energy: float) -> DepthBlur:
    """Return a blur by depth whose windows have about the size of others."""
    energy = min(energy, 0.995)
    for defocus in np.geomspace(0.1, 300.0, 80):  # of an object in front of what is in focus
        distance = float(1.0 / (1.0 / 2.0 + defocus / (LENS.defocus(1.0) - LENS.defocus(np.inf)).item()))
        depth = np.full(SHAPE, distance)
        blur = DepthBlur(depth, LENS, pixel, energy=energy, threads=1, largest=512)
        if blur.banks[0].halves.max() >= half - 0.5:
            return blur
    raise ArithmeticError(f"no defocus makes windows of half {half}")


def off(blur: FieldBlur, count: int, depth: NDArray[np.float64] | None = None) -> tuple[NDArray[np.float64], float]:
    """Return sums of absolute differences to exact PSFs at random sources: of windows, and the most of all light."""
    rng, half = np.random.default_rng(1), blur.banks[0].half
    rows, columns = rng.integers(0, SHAPE[0], count), rng.integers(0, SHAPE[1], count)
    within: list[float] = []
    whole: list[float] = []
    for part in np.array_split(np.arange(count), max(1, count // _AT_ONCE)):
        y, x = ((np.arange(n) + 0.5) / n - 0.5 for n in SHAPE)
        y, x = SENSOR[0] * y[rows[part]], SENSOR[1] * x[columns[part]]
        pupil = FIELD.pupil(x, y)
        if depth is not None:
            added = pupil.wavefront + LENS.pupil(depth[rows[part], columns[part]]).wavefront
            pupil = lm.Pupil(added, wavelength=LENS.wavelength, f_number=LENS.working_f_number)
        far = max(FAR, half) if len(whole) < _FEW else half
        exact = lm.psf(pupil, 2 * far + 1, blur.pixel, tol=1e-7, dtype=np.float64).values
        for row, column, one in zip(rows[part], columns[part], exact, strict=True):
            made, near = blur.window(row, column), _middle(one, half)
            light = 1.0 if blur.banks[0].far else near.sum()
            within.append(np.abs(_middle(made, half) - near / light).sum())
            if far > half:
                # Beyond what is compared pixel by pixel, so much light is to be in one place or another.
                made = _middle(np.pad(made, max(0, far - len(made) // 2)), far)
                whole.append(np.abs(made - one).sum() + abs(made.sum() - one.sum()))
    return np.array(within), max(whole)


def _middle(window: NDArray[np.float64], half: int) -> NDArray[np.float64]:
    first = len(window) // 2 - half
    return window[first : first + 2 * half + 1, first : first + 2 * half + 1]


def main(count: int) -> None:
    """Measure, and print."""
    image = light()
    print("pixel   tol    energy  window  nodes    made     call/DepthBlur  error said  largest  median   all light")
    for pixel, tol, energy in CASES:
        given = {"tol": tol, "energy": energy, "threads": 1}
        start = time.process_time()
        blur = FieldBlur(FIELD, SHAPE, pixel, sensor=SENSOR, **given)
        first = time.process_time() - start
        half, (down, across, _) = blur.banks[0].half, blur.banks[0].axes
        other = by_depth(half, pixel, energy)
        mine = Contender("field", lambda _, made=blur: made.forward(image))
        result = race([mine, Contender("depth", lambda _, made=other: made.forward(image))], 7)
        ratio = result.ratio("field", "depth").median
        within, whole = off(blur, count)
        print(
            f"{pixel * 1e6:g} um  {tol:<6g} {energy:<6g}  {2 * half + 1:3}²   {down.count} x {across.count}  "
            f"{first:5.2f} s  {1e3 * result.median('field'):4.0f} ms, {ratio:4.1f} x  "
            f"{blur.error:.1e}  {within.max():.1e}  {np.median(within):.1e}  {whole:.1e}",
            flush=True,
        )
    y, x = np.mgrid[: SHAPE[0], : SHAPE[1]]
    depth = 1.0 / (1.0 / 2.0 + 0.033 * np.sin(x / 90.0) * np.cos(y / 70.0))
    start = time.process_time()
    blur = FieldBlur(FIELD, SHAPE, 4e-6, sensor=SENSOR, depth=depth, lens=LENS, threads=1)
    first = time.process_time() - start
    blur.forward(image)
    start = time.process_time()
    blur.forward(image)
    later = time.process_time() - start
    within, whole = off(blur, count, depth)
    counts = " x ".join(str(nodes.count) for nodes in blur.banks[0].axes)
    print(
        f"with depth, C_d from {blur.defocus.min():.1f} to {blur.defocus.max():.1f} rad, 4 um: window "
        f"{2 * blur.banks[0].half + 1}², {counts} nodes, made in {first:.1f} s, a call {later:.2f} s, error said "
        f"{blur.error:.1e}, largest {within.max():.1e}, median {np.median(within):.1e}, all light {whole:.1e}"
    )


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 1000)
