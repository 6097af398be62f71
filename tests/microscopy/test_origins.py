"""One set of planes, named from three origins of the stage, is one set of planes to every public function."""

from __future__ import annotations

import inspect
import re
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

import lommel as lm

WATER = lm.Objective(
    NA=1.2, immersion=1.333, working_distance=0.28e-3, coverslip=lm.Layer(1.5255, 170e-6), sample=1.36
)
STEP, PIXEL, WAVE = 0.4e-6, 1e-7, 525e-9
WINDOW: dict[str, Any] = {"shape": 5, "pixel": PIXEL, "tol": 1e-4}
SCAN = WINDOW | {"shape": 3, "tol": 1e-3}
ORIGINS = ("brightest", "coverslip", "paraxial")
# Planes about the brightest focus of the emission, measured from the cover glass.
FOCUS = WATER.focus(3e-6, wavelength=WAVE).brightest + np.array([-1.0, 0.0, 1.0, 2.0]) * STEP


def pupil(origin: str, wavelength: float = WAVE, focus: Any = FOCUS, **given: Any) -> Any:
    """Return the pupil in these planes, with z from an origin."""
    focal = WATER.focus(3e-6, wavelength=wavelength)
    zero = {"coverslip": 0.0, "paraxial": focal.paraxial, "brightest": focal.brightest}[origin]
    return WATER.pupil(depth=3e-6, z=focus - zero, origin=origin, wavelength=wavelength, **given)


def laser(origin: str, kind: str = "circular", wavelength: float = 488e-9) -> Any:
    return pupil(origin, wavelength, emitter=lm.Beam(kind))


def depletion(origin: str) -> Any:
    return laser(origin, "vortex", 775e-9)


def stack_blur(origin: str) -> Any:
    image = np.zeros((5, 5, 6))
    image[2, 2, 2] = 1.0
    return lm.microscopy.StackBlur(lm.psf(pupil(origin), **WINDOW), (6, 5, 5), np.float64).forward(image)


def restored(origin: str) -> Any:
    recording = np.random.default_rng(0).poisson(20.0, (4, 12, 12)).astype(np.float32)
    given = {"noise": lm.Noise(read=1.0), "method": lm.imaging.RichardsonLucy(steps=3)}
    return lm.microscopy.deconvolve(recording, lm.psf(pupil(origin), **WINDOW), **given).values


def table(origin: str) -> Any:
    single = pupil(origin, focus=FOCUS[1])
    images = lm.localize.Table(single, 7, PIXEL, z=(single.z - 1e-7, single.z + 1e-7), tol=1e-2)
    return np.asarray(images(3.2, 2.9, single.z + 0.5e-7)) / images(3.0, 3.0, single.z).max()


def stored(origin: str) -> Any:
    return lm.psf_to(f"{origin}.zarr", pupil(origin), **WINDOW)[:].values


def sampled(method: Any) -> Any:
    return lambda o: lm.psf(pupil(o), 3, PIXEL, method=method(o), normalize="strehl", integrate=False)


FUNCTIONS = {
    "psf": lambda o: lm.psf(pupil(o), **WINDOW),
    "Plan": lambda o: lm.Plan(5, PIXEL, tol=1e-4)(pupil(o)),
    "colour_psf": lambda o: lm.colour_psf(pupil(o), 5, PIXEL, channels=lm.Channels([WAVE], [[1.0]]), tol=1e-3),
    "psf_to": stored,
    "fisher": lambda o: lm.fisher(pupil(o), 5, PIXEL, of=["photons", "z"], photons=1e3, background=1.0).matrix,
    "bead": lambda o: lm.microscopy.bead(pupil(o), 2e-7, **SCAN),
    "confocal": lambda o: lm.microscopy.confocal(laser(o), pupil(o), **SCAN),
    "two_photon": lambda o: lm.microscopy.two_photon(laser(o, wavelength=800e-9), **SCAN),
    "sted": lambda o: lm.microscopy.sted(laser(o), depletion(o), pupil(o), saturation=5.0, **SCAN),
    "light_sheet": lambda o: lm.microscopy.light_sheet(pupil(o), 1e-6, **WINDOW),
    "StackBlur": stack_blur,
    "deconvolve": restored,
    "Confocal": sampled(lambda o: lm.methods.Confocal(laser(o), 1.0, 1e-3)),
    "Sted": sampled(lambda o: lm.methods.Sted(laser(o), 1.0, 1e-3, depletion=depletion(o), saturation=5.0)),
    "Table": table,
    "axial_fwhm": lambda o: lm.psf(pupil(o), 5, PIXEL).axial_fwhm(),
    "PSF": lambda o: replace(lm.psf(pupil(o), **WINDOW), normalize="energy"),
}


@pytest.mark.parametrize("name", FUNCTIONS)
def test_the_same_planes_by_three_origins_have_the_same_answer(name):
    one, *others = (np.asarray(getattr(found, "values", found)) for found in map(FUNCTIONS[name], ORIGINS))
    assert one.any()
    for other in others:
        assert other == pytest.approx(one, rel=1e-6, abs=1e-7 * float(np.abs(one).max()))


def test_every_public_function_of_an_objectives_pupil_is_compared():
    taking = set()
    for module in (lm, lm.imaging, lm.localize, lm.measures, lm.methods, lm.microscopy, lm.show):
        for name, thing in ((name, getattr(module, name)) for name in getattr(module, "__all__", dir(module))):
            called = vars(thing).get("__init__") if inspect.isclass(thing) else thing
            if re.search("ObjectivePupil|BasePupil", str(getattr(called, "__annotations__", ""))):
                taking.add(name)
    assert taking == set(FUNCTIONS) - {"Plan", "StackBlur", "deconvolve", "axial_fwhm"}


@pytest.mark.parametrize("origin", ORIGINS)
def test_a_sheet_is_brightest_in_the_focal_plane(origin):
    plain, lit = (
        f(pupil(origin), **WINDOW) for f in (lm.psf, lambda p, **w: lm.microscopy.light_sheet(p, 1e-6, **w))
    )
    depths = np.linspace(2e-6, 4e-6, 41)
    in_focus = np.interp(FOCUS, WATER.focus(depths, wavelength=WAVE).brightest, depths)
    sheet = 2.0 ** -(((in_focus - 3e-6) / 0.5e-6) ** 2)
    assert lit.values == pytest.approx(plain.values * sheet[:, None, None], rel=5e-3)
