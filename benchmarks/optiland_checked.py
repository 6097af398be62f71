"""PSFs of six lenses of optiland at three fields against Huygens' sum; ``--write`` writes docs/optiland-checked.md.

The truth is Huygens' sum over rays that optiland traced, with exact distances, written out here: no FFT and nothing
of lommel. `make peers GROUP=lenses` installs optiland; run with ``PYTHONPATH=.tools/peers``.
"""

from __future__ import annotations

import argparse
import os
import re
import time
import warnings
from collections.abc import Callable, Iterator
from importlib.metadata import version
from pathlib import Path
from types import SimpleNamespace
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

import lommel as lm

Array = NDArray[Any]

PAGE = Path(__file__).resolve().parent.parent / "docs" / "optiland-checked.md"
LENSES = ("CookeTriplet", "DoubleGauss", "TessarLens", "HeliarLens", "ReverseTelephoto", "Telephoto")
FIELDS = (0.0, 0.7, 1.0)
SIDE, PITCH = 33, 0.5
"""Pixels of the windows, and their pitch in lambda*N."""


class Case(NamedTuple):
    """A lens of ``optiland.samples.objectives`` at a field (0, Hy)."""

    name: str
    field: float

    @property
    def optic(self) -> Any:
        """The lens."""
        from optiland.samples import objectives

        return getattr(objectives, self.name)()


class Found(NamedTuple):
    """Errors over the peak of one case, and processor time in seconds."""

    strehl: float
    lommel: float
    bound: float
    circular: float
    fft: float
    huygens: float
    at_true_pitch: float
    seconds: float
    huygens_seconds: float


def huygens(optic: Any, field: tuple[float, float], across: Array, upwards: Array, *, about: Any = None) -> Array:
    """Return the intensity at places about the chief ray's (or `about`), micrometres: a sum of spherical waves.

    Rays at 40 Gauss-Legendre nodes of the squared radius by 96 angles of the entrance pupil, of equal flux, meet the
    reference sphere at q with the path W: ``sum w exp(ik(|p - q| - W)) / |p - q|``, times Kirchhoff's obliquity.
    """
    from optiland.wavefront import Wavefront

    node, weight = np.polynomial.legendre.leggauss(40)
    angle = 2.0 * np.pi * (np.arange(96) + 0.5) / 96
    x, y = (np.outer(np.sqrt(0.5 * (1.0 + node)), part(angle)).ravel() for part in (np.cos, np.sin))
    micrometres = optic.primary_wavelength
    points = SimpleNamespace(x=x, y=y)
    data = Wavefront(optic, [field], [micrometres], distribution=points).get_data(field, micrometres)
    k = 2e3 * np.pi / micrometres  # lengths are millimetres
    sphere = np.stack([np.asarray(part, dtype=float) for part in (data.pupil_x, data.pupil_y, data.pupil_z)])
    center = np.reshape(np.array(data.reference_center, dtype=float), (3, 1))
    normal = (center - sphere) / float(np.ravel(data.radius)[0])
    wave = np.repeat(weight, 96) * np.exp(-2j * np.pi * np.asarray(data.opd, dtype=float))
    start = center[:2, 0] if about is None else np.array(about)
    made = np.empty((len(upwards), len(across)))
    for row, up in enumerate(upwards):
        place = np.stack([start[0] + 1e-3 * across, np.full(len(across), start[1] + 1e-3 * up)])
        place = np.concatenate([place, np.full((1, len(across)), center[2, 0])])
        towards = place[:, None, :] - sphere[:, :, None]
        distance = np.sqrt((towards**2).sum(axis=0))
        cosine = (normal[:, :, None] * towards).sum(axis=0) / distance
        spherical = np.exp(1j * k * (distance - abs(float(np.ravel(data.radius)[0])))) / distance
        made[row] = np.abs(wave @ (spherical * 0.5 * (1.0 + cosine))) ** 2
    return made


def error(found: Array, truth: Array) -> float:
    """Return the largest error over the peak, in the unit that fits best."""
    scale = (found * truth).sum() / (found * found).sum()
    return float(np.abs(scale * found - truth).max() / truth.max())


def timed(call: Callable[[], Any]) -> tuple[Any, float]:
    """Return what a function returns the second time, and its processor time."""
    call()
    start = time.process_time()
    made = call()
    return made, time.process_time() - start


def steps(side: int, pitch: float) -> Array:
    """Return places of pixels about the middle of pixel side // 2."""
    return (np.arange(side) - side // 2) * pitch


def ours(case: Case, pitch: float, **options: Any) -> lm.PSF:
    """Return the PSF of a traced lens, rows downwards."""
    from lommel.adapters import optiland

    pupil = optiland.pupil(case.optic, (0.0, case.field), degree=16, **options)
    return lm.psf(pupil, SIDE, 1e-6 * pitch, integrate=False, threads=1)


def check(case: Case) -> Found:
    """Return the errors of one lens at one field."""
    from optiland.psf import FFTPSF, HuygensPSF

    from lommel.adapters import optiland

    optic, field = case.optic, (0.0, case.field)
    pupil = optiland.pupil(optic, field, degree=16)
    micrometres = float(optic.primary_wavelength)
    pitch = PITCH * micrometres * float(pupil.f_number)
    places = steps(SIDE, pitch)
    truth = huygens(optic, field, places, places)
    exact, seconds = timed(lambda: ours(case, pitch))
    theirs, huygens_seconds = timed(
        lambda: HuygensPSF(optic, field, micrometres, num_rays=128, image_size=SIDE, pixel_pitch=1e-3 * pitch)
    )
    middle = float(theirs.cx), float(theirs.cy)
    stated, true = (
        error(theirs.psf, huygens(optic, field, *2 * (steps(SIDE, one),), about=middle))
        for one in (pitch, pitch * SIDE / (SIDE - 1))
    )
    fft = FFTPSF(optic, field, micrometres, num_rays=128, grid_size=1024)
    whole = np.asarray(fft.psf)
    # The samples within the window, at the pitch that their axes have.
    own = float(np.ravel(fft._get_psf_units(whole)[0])[0]) / whole.shape[1]
    half = int(SIDE // 2 * pitch / own)
    part = slice(whole.shape[0] // 2 - half, whole.shape[0] // 2 + half + 1, 4)
    samples = np.arange(-half, half + 1, 4) * own
    return Found(
        float(lm.strehl(pupil)),
        error(exact.values[::-1], truth),
        float(exact.error_bound),
        error(ours(case, pitch, circular=True).values[::-1], truth),
        error(whole[part, part], huygens(optic, field, samples, samples)),
        stated,
        true,
        seconds,
        huygens_seconds,
    )


def table() -> Iterator[str]:
    """Yield the lines of the table."""
    names = (
        "lens",
        "field",
        "Strehl ratio",
        "lommel",
        "bound",
        "circle",
        "`FFTPSF`",
        "`HuygensPSF`",
        "at its true pitch",
    )
    yield f"| {' | '.join(names)} |"
    yield "|---" * len(names) + "|"
    ratios = []
    for name in LENSES:
        for field in FIELDS:
            found = check(Case(name, field))
            ratios.append(found.huygens_seconds / found.seconds)
            print(name, field, found, flush=True)
            errors = found.lommel, found.bound, found.circular, found.fft, found.huygens, found.at_true_pitch
            told = " | ".join(f"{value:.1e}" for value in errors)
            yield f"| {name} | {field:g} | {found.strehl:.3f} | {told} |"
    yield ""
    yield (
        f"With optiland {version('optiland')}. `HuygensPSF` took {min(ratios):.2g} to {max(ratios):.2g} times the "
        "processor time of lommel, both with the tracing of rays."
    )


def draw(path: Path) -> None:
    """Draw a field of the Cooke triplet in three ways, and how they differ from Huygens' sum."""
    import matplotlib.pyplot as plt
    from optiland.psf import HuygensPSF

    from lommel.adapters import optiland

    case = Case("CookeTriplet", 1.0)
    optic = case.optic
    micrometres = float(optic.primary_wavelength)
    pitch = PITCH * micrometres * float(optiland.pupil(optic, (0.0, 1.0)).f_number)
    places = steps(SIDE, pitch)
    truth = huygens(optic, (0.0, 1.0), places, places)
    theirs = HuygensPSF(optic, (0.0, 1.0), micrometres, num_rays=128, image_size=SIDE, pixel_pitch=1e-3 * pitch)
    own = huygens(optic, (0.0, 1.0), places, places, about=(float(theirs.cx), float(theirs.cy)))
    shown = [
        ("lommel", ours(case, pitch).values[::-1], truth),
        ("lommel, circle", ours(case, pitch, circular=True).values[::-1], truth),
        ("HuygensPSF", np.asarray(theirs.psf), own),
    ]
    figure, axes = plt.subplots(2, 4, figsize=(11.0, 5.6), layout="constrained")
    edge = places[-1] + 0.5 * pitch
    view: dict[str, Any] = {"extent": (-edge, edge, -edge, edge), "origin": "lower"}
    values = axes[0, 0].imshow(np.sqrt(truth / truth.max()), vmin=0, vmax=1, **view)
    axes[0, 0].set_title("Huygens' sum")
    axes[1, 0].set_axis_off()
    for column, (title, found, exact) in enumerate(shown, 1):
        found = found * (found * exact).sum() / (found * found).sum()
        axes[0, column].imshow(np.sqrt(np.maximum(found, 0) / truth.max()), vmin=0, vmax=1, **view)
        axes[0, column].set_title(title)
        off = axes[1, column].imshow((found - exact) / exact.max(), vmin=-0.1, vmax=0.1, cmap="RdBu_r", **view)
        axes[1, column].set_title(f"at most {error(found, exact):.1e}")
    for ax in axes.flat:
        ax.set(xlabel="x (µm)", ylabel="y upwards (µm)")
    figure.colorbar(values, ax=axes[0, :], label="square root of I over the peak")
    figure.colorbar(off, ax=axes[1, :], label="difference over the peak")
    figure.suptitle("Cooke triplet, f/5, 20 degrees off the axis")
    figure.savefig(path, dpi=110)
    plt.close(figure)


def main() -> None:
    """Print the table, or write it into the page."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--write", action="store_true", help="write docs/optiland-checked.md and its picture")
    given = parser.parse_args()
    warnings.filterwarnings("ignore")
    lines = "\n".join(table())
    if given.write:
        page = PAGE.read_text(encoding="utf-8")
        mark = r"(<!-- figures: written by benchmarks/optiland_checked.py -->\n\n)(.*?)(\n\n<!-- end -->)"
        PAGE.write_text(
            re.sub(mark, lambda found: found[1] + lines + found[3], page, flags=re.DOTALL), encoding="utf-8"
        )
        draw(PAGE.with_suffix(".png"))
    print(lines)


if __name__ == "__main__":
    os.environ.setdefault("NUMBA_NUM_THREADS", "1")
    main()
