"""Other packages for microscopes, each asked for the same light; ``--write`` writes docs/microscopes-peers.md."""

from __future__ import annotations

import re
import sys
import warnings
from collections.abc import Callable, Iterator
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

import lommel as lm

PAGE = Path(__file__).resolve().parent.parent / "docs" / "microscopes-peers.md"
OIL, WATER = 1.515, 1.33
DEPTH = 2e-6
WAVE = 610e-9

Array = NDArray[Any]


class Row(NamedTuple):
    """What was asked, and how far the answer is from that of lommel: over the peak of the stack, or as it says."""

    asked: str
    found: float
    unit: str = " of the peak"

    @property
    def told(self) -> str:
        """The figure as the page has it."""
        return f"{self.found:.1e}" if self.unit == " of the peak" else f"{self.found:.3g}{self.unit}"


def oil(NA: float) -> lm.Objective:
    """Return an objective for oil above a sample of water."""
    return lm.Objective(
        NA=NA,
        magnification=60,
        immersion=OIL,
        working_distance=150e-6,
        coverslip=lm.Layer(1.5255, 170e-6),
        sample=WATER,
    )


def one_medium(NA: float, index: float) -> lm.Objective:
    """Return an objective in the medium of the sample, without a cover glass."""
    return lm.Objective(NA=NA, magnification=60, immersion=index, working_distance=1e-3, coverslip=None, sample=index)


def apart(theirs: Array, ours: Array) -> float:
    """Return the largest difference of stacks, each over its own largest value."""
    return float(np.abs(theirs / theirs.max() - ours / ours.max()).max())


def radii(side: int, pitch: float) -> Array:
    """Return the distances of pixels from the middle one."""
    x = (np.arange(side) - side // 2) * pitch
    return np.hypot(x, x[:, None])


def scalar(objective: lm.Objective, side: int, pitch: float, *, emitter: Any = "scalar", **at: Any) -> Array:
    """Return the light of the scalar model at points about the axis, `pitch` metres apart in the sample."""
    pupil = objective.pupil(**at, wavelength=WAVE, origin="coverslip", emitter=emitter)
    pixel = objective.magnification * pitch
    return np.asarray(lm.psf(pupil, side, pixel, tol=1e-10, integrate=False, dtype=np.float64).values)


def psfmodels() -> Iterator[Row]:
    """psfmodels: Gibson and Lanni, scalar and vectorial, Simpson's rule, profiles interpolated linearly."""
    import psfmodels as peer

    z = np.linspace(-1.0, 3.0, 21)
    focus = DEPTH * OIL / WATER + 1e-6 * z - DEPTH  # its z is 0 at the glass
    for NA in (1.2, 1.3, 1.4):
        layers = {"NA": NA, "ni": OIL, "ni0": OIL, "ng": 1.5255, "ng0": 1.5255, "ns": WATER, "tg": 170, "tg0": 170}
        asked = {"params": {**layers, "ti0": 150, "sf": 1}, "pz": 1e6 * DEPTH, "wvl": 1e6 * WAVE, "normalize": False}
        objective, r = oil(NA), radii(21, 50e-9)
        for name, model, ours in (
            ("scalar", peer.scalar_psf, scalar(objective, 21, 50e-9, depth=DEPTH, z=focus)),
            (
                "vectorial",
                peer.vectorial_psf,
                objective.fields(r, depth=DEPTH, focus=focus, wavelength=WAVE).intensity,
            ),
        ):
            theirs = model(z, nx=21, dxy=0.05, **asked)
            yield Row(f"{name}, NA {NA}, radii of whole pixels", apart(theirs[:, 10, 10:], ours[:, 10, 10:]))
            if NA == 1.3:
                yield Row(f"{name}, NA {NA}, all pixels", apart(theirs, ours))
    stack = peer.make_psf(z=51, nx=51, pz=20, NA=1.4, ns=WATER, ni=OIL, wvl=0.61)
    axis = stack[:, 25, 25]
    yield Row("make_psf(z=51, pz=20): plane that is brightest, from 0; the middle is 25", float(axis.argmax()), "")
    yield Row("the middle plane on the axis, over the brightest", float(axis[25] / axis.max()), "")


def microscpsf() -> Iterator[Row]:
    """MicroscPSF-Py: Gibson and Lanni, scalar, a series of 100 Bessel functions."""
    from microscPSF import microscPSF

    r, z = np.linspace(0.0, 1.5, 31), np.linspace(-3.0, 1.0, 21)
    for NA, depth in ((1.3, 2.0), (1.3, 5.0), (1.4, 2.0), (1.4, 50.0), (1.49, 50.0)):
        # A large magnification, so that its sine condition is that of the others.
        index = {"ng": 1.5255, "ng0": 1.5255, "ni": OIL, "ni0": OIL, "ns": WATER}
        scope = microscPSF.m_params | index | {"NA": NA, "M": 1e4}
        at = depth * OIL / WATER
        moved = z - at  # its zv is minus the focus
        theirs = microscPSF.gLZRFocalScan(scope, r, moved, normalize=False, pz=depth, wvl=1e6 * WAVE)
        published = lm.Scalar(supercritical=False)
        line = scalar(oil(NA), 61, 50e-9, emitter=published, depth=1e-6 * depth, z=-1e-6 * moved)
        ours = line[:, 30, 30:]
        yield Row(f"profiles, NA {NA}, {depth:g} um deep, without supercritical light", apart(theirs, ours))


def psf_generator() -> Iterator[Row]:
    """psf-generator: one medium, or the phase of Gibson and Lanni; Simpson's rule, single precision."""
    from psf_generator import ScalarSphericalPropagator, VectorialSphericalPropagator

    side, planes, pitch, step = 41, 11, 50.0, 100.0
    # The field of view of n pixels is spread over n samples, its ends included, and the planes likewise.
    grid = {"n_pix_psf": side, "pix_size": pitch * (side - 1) / side, "wavelength": 1e9 * WAVE, "n_defocus": planes}
    grid |= {"defocus_step": step * (planes - 1) / planes, "na": 1.3, "n_i": OIL, "n_i0": OIL}

    def light(kind: Any, **given: Any) -> Array:
        made = kind(**grid, **given)
        z.append(1e-9 * np.linspace(made.defocus_min, made.defocus_max, planes))
        field = np.asarray(made.compute_focus_field())
        return (np.abs(field) ** 2).sum(axis=1)

    z: list[Array] = []
    medium = one_medium(1.3, OIL)
    for nodes in (128, 129):
        theirs = light(ScalarSphericalPropagator, n_pix_pupil=nodes, cos_factor=True)
        ours = scalar(medium, side, 1e-9 * pitch, depth=0.0, z=-z[-1])
        yield Row(f"scalar, one medium, {nodes} angles", apart(theirs, ours))
    theirs = light(VectorialSphericalPropagator, n_pix_pupil=129, apod_factor=True)
    pupil = medium.pupil(depth=0.0, z=-z[-1], wavelength=WAVE, origin="coverslip", emitter=lm.Beam("x"))
    ours = lm.psf(pupil, side, 60e-9 * pitch, tol=1e-8, integrate=False).values
    yield Row("x-polarised, one medium, 129 angles", apart(theirs, ours))
    for depth in (2.0, 20.0):
        given = {"z_p": 1e3 * depth, "n_s": WATER, "n_g": 1.5255, "n_g0": 1.5255, "t_i0": 150e3, "n_pix_pupil": 1025}
        theirs = light(ScalarSphericalPropagator, cos_factor=True, gibson_lanni=True, **given)
        start = 1e-6 * depth * OIL / WATER
        # Its radii and defocus have the index of the sample where angles are those in the immersion.
        for scale, told in ((1.0, ""), (WATER / OIL, ", against radii and z times n_s / n_i")):
            focus = start - scale * z[-1]
            ours = scalar(oil(1.3), side, scale * 1e-9 * pitch, depth=1e-6 * depth, z=focus)
            yield Row(f"gibson_lanni=True, {depth:g} um deep{told}", apart(theirs, ours))


def pyotf() -> Iterator[Row]:
    """pyotf: one medium, by the FFT of a sampled pupil."""
    from pyotf.otf import HanserPSF

    NA, index = 1.2, 1.33
    for kind, side in (("total", 128), ("total", 512), ("none", 512)):
        made = HanserPSF(
            wl=1e9 * WAVE, na=NA, ni=index, res=80.0, size=side, zres=200.0, zsize=10, vec_corr=kind, condition="sine"
        )
        part = slice(side // 2 - 16, side // 2 + 17)
        theirs = made.PSFi[:, part, part]
        objective, focus = one_medium(NA, index), 1e-9 * made.zrange
        if kind == "total":
            ours = objective.fields(radii(33, 80e-9), depth=0.0, focus=focus, wavelength=WAVE).intensity
        else:
            ours = scalar(objective, 33, 80e-9, emitter=lm.Scalar("aplanatic"), depth=0.0, z=focus)
        yield Row(f'vec_corr="{kind}", {side}^2 samples, the middle 33^2', apart(theirs, ours))
    made = HanserPSF(wl=1e9 * WAVE, na=NA, ni=index, res=80.0, size=32, zres=200.0, zsize=5)
    yield Row("zsize=5: plane in focus, from 0; the middle is 2", float(made.PSFi.max(axis=(1, 2)).argmax()), "")


PEERS: dict[str, Callable[[], Iterator[Row]]] = {
    "psfmodels": psfmodels,
    "MicroscPSF-Py": microscpsf,
    "psf-generator": psf_generator,
    "pyotf": pyotf,
}
"""By the name of the distribution."""


def compared(name: str) -> tuple[str, list[Row]] | None:
    """Return the version of a package and what it says; None where it is not installed."""
    try:
        found = version(name)
    except PackageNotFoundError:
        return None
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # what others warn of is not ours
        return found, list(PEERS[name]())


BEGIN, END = "<!-- figures: written by benchmarks/microscope_peers.py -->", "<!-- end of figures -->"


def tables() -> str:
    """Return the tables of the page; a package that is not here is said not to have run."""
    parts = []
    for name, peer in PEERS.items():
        answer, told = compared(name), (peer.__doc__ or "").split(": ", 1)[1]
        if answer is None:
            parts.append(f"### {name}: not run\n\n{told}\n")
            continue
        rows = "\n".join(f"| {row.asked} | {row.told} |" for row in answer[1])
        head = f"### {name} {answer[0]}\n\n{told[0].upper()}{told[1:]}\n"
        parts.append(f"{head}\n| configuration | difference or value |\n|---|---|\n{rows}\n")
    return "\n".join(parts)


def main() -> None:
    """Print the tables, or put them into the page."""
    made = tables()
    if "--write" not in sys.argv[1:]:
        print(made)
        return
    text = PAGE.read_text(encoding="utf-8")
    between = re.compile(f"(?<={re.escape(BEGIN)}\n).*?(?={re.escape(END)})", re.DOTALL)
    PAGE.write_text(between.sub(lambda _: f"\n{made}\n", text), encoding="utf-8")


if __name__ == "__main__":
    main()
