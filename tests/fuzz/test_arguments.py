"""Bad arguments, over the whole public interface: ValueError or TypeError, one line that names the argument."""

from __future__ import annotations

import contextlib
import dataclasses
import math
import random
import tempfile
import warnings
from pathlib import Path

import numpy as np
import pytest

import lommel as lm
from lommel import imaging
from lommel.field import maps
from lommel.io.psf_files import FileError
from lommel.io.zernike_tables import ZernikeTable
from lommel.methods import METHODS, Hankel, NijboerZernike, Polychromatic
from lommel.paper import AbramowitzErf, ClosedForm, LommelSeries, TableErf
from lommel.recorded.frames import RecordingError

SQUARE = np.linspace(0.1, 1.0, 24 * 24).reshape(24, 24)
DEPTH = 1.8 + 0.3 * SQUARE
PUPIL = lm.Pupil(lm.Wavefront(1.0, 0.5))
LIGHT = lm.Apodization()
COMA = lm.Pupil(lm.Wavefront(1.0, nonradial={(3, 1): 0.5}), obscuration=0.2)
LENS = lm.Lens(focal_length=50e-3, f_number=4.0, focus_distance=2.0, wavelength=550e-9)
CAMERA = LENS.pupil(1.9)
VANES = lm.Pupil(spider=lm.Spider.equal(3, width=0.1), obscuration=0.2)
STACK = lm.Pupil(lm.Wavefront([0.0, 1.0]))
PSF = lm.psf(PUPIL, 5, 0.5)
ODD = lm.psf(COMA, 5, 0.5)
FIELD = lm.FieldMap.from_seidel(1.0, W131=0.5)
GRID = FIELD.grid(2, 2, sensor=(1.0, 1.0), shape=5, pixel=0.5)
PLAN = imaging.FocusPlan(SQUARE, DEPTH, LENS, 8e-6, encoding="linear")
BLUR = imaging.DepthBlur(DEPTH, LENS, 8e-6)
CHART = lm.opd_map(lm.Wavefront(1.0), 24, unit="radians")
MASK = lm.Mask(np.ones((8, 8)))
RANGES = imaging.LensRanges(focal_length=50e-3, f_number=4.0, focus_distance=2.0, pixel=8e-6)
VOXELS = np.random.default_rng(0).poisson(100.0, (3, 12, 12)).astype(np.float32)
MICROSCOPE = lm.load_microscope(Path(__file__).parents[2] / "examples" / "objectives" / "zeiss-63x-1.4-oil.toml")
PLANES = lm.psf(MICROSCOPE.objective.pupil(depth=2e-6, z=[-3e-7, 0.0, 3e-7], wavelength=520e-9), 9, 6.5e-6)
ONCE = imaging.RichardsonLucy(steps=1)
OBJECTIVE = MICROSCOPE.objective
EMISSION = OBJECTIVE.pupil(depth=1e-6, wavelength=520e-9)
LASER = OBJECTIVE.pupil(depth=1e-6, wavelength=520e-9, emitter=lm.Beam("circular"))
PAIR = [LENS, LENS.focused(2.2)]
STAR = 1e4 * lm.psf(lm.Pupil(lm.Wavefront(1.0)), 9, 0.5).values
SPOTS = lm.localize.Table(
    MICROSCOPE.objective.pupil(depth=0.0, wavelength=520e-9), shape=9, pixel=6.5e-6, z=(-2e-7, 2e-7), tol=1e-2
)


def rendered(**given: object) -> list[object]:
    """Render a whole data set of one picture, each time in another folder, of which relative paths are parts."""
    if isinstance(out := given["out"], Path):
        given["out"] = tempfile.mkdtemp(dir=out.parent)
    with tempfile.TemporaryDirectory(dir=".") as folder, contextlib.chdir(folder):
        return list(imaging.render_dataset(**given))


def tagged(name: str, call, **valid: object) -> tuple[str, object, dict[str, object]]:
    return name, call, valid


def entries(folder: Path) -> list[tuple[str, object, dict[str, object]]]:
    """Every public callable, as its name, what calls it, and arguments that are right."""
    lens = {"focal_length": 50e-3, "wavelength": 550e-9, "f_number": 4.0, "focus_distance": 2.0, "obscuration": 0.1}
    image = {"image": SQUARE, "depth": DEPTH, "lens": LENS, "pixel": 8e-6}
    scene = image | {"encoding": "linear"}
    window = {"shape": 5, "pixel": 0.5, "normalize": "energy", "dtype": "float32", "center": (2.0, 2.5), "threads": 1}
    window |= {"integrate": False, "tol": 1e-6}
    at = {"fx": [0.1, 0.2], "fy": 0.1}
    scale = {"wavelength": 550e-9, "f_number": 2.0, "obscuration": 0.1}
    units_of = {"order": "noll", "unit": "waves", "normalization": "rms", "wavelength": 550e-9}
    seidel = dict.fromkeys(("W020", "W040", "W060", "W080", "W131", "W222", "W220", "W311"), 0.1)
    of_voxels = {
        "depth": 2e-6,
        "wavelength": 520e-9,
        "pixel": 6.5e-6,
        "step": 3e-7,
        "noise": lm.Noise(read=1.0),
        "direction": "up",
        "background": 0.0,
        "method": ONCE,
        "diagnosis": False,
        "memory": 1e9,
    }
    psf_parts = {f.name: getattr(PSF, f.name) for f in dataclasses.fields(PSF) if f.init}
    found = [
        tagged("psf", lm.psf, pupil=PUPIL, method=None, derivatives=(), **window | {"integrate": True}),
        tagged("psf", lm.psf, pupil=COMA, method=NijboerZernike(), **window),
        tagged("psf", lm.psf, pupil=VANES, **window),
        tagged("psf", lm.psf, pupil=CAMERA, **window | {"pixel": 1e-6, "integrate": True}),
        tagged("psf", lm.psf, pupil=PUPIL, shape=5, pixel=0.5, derivatives=["defocus"]),
        tagged("psf", lm.psf, pupil=CAMERA, shape=5, pixel=1e-6, method=Polychromatic([5e-7, 6e-7], [1, 2])),
        tagged("Plan", lm.Plan, **window),
        tagged("Plan()", lm.Plan(5, 0.5), pupil=PUPIL, derivatives=(), out=np.empty((5, 5), np.float32)),
        tagged("PSF", lm.PSF, **psf_parts),
        tagged("Wavefront", lm.Wavefront, defocus=1.0, spherical=[1.0, 2.0], higher=[0.1], nonradial={(3, 1): 0.5}),
        tagged("Wavefront.zernike", lm.Wavefront.zernike, terms={4: 0.1, 8: 0.2}, **units_of | {"unit": "metres"}),
        tagged("Wavefront.to_zernike", lm.Wavefront(1.0).to_zernike, **units_of),
        tagged("Wavefront.from_seidel", lm.Wavefront.from_seidel, **seidel, field=(0.5, 0.5)),
        tagged("Wavefront.balanced_spherical", lm.Wavefront.balanced_spherical, rms=0.1, obscuration=0.2),
        tagged("Wavefront.phase", COMA.wavefront.phase, rho=[0.1, 0.5], theta=0.3),
        tagged("Wavefront.rotated", COMA.wavefront.rotated, angle=0.3),
        tagged("Wavefront.scaled", COMA.wavefront.scaled, radius=0.3),
        tagged("Wavefront.flipped", COMA.wavefront.flipped, axis="x"),
        tagged("Wavefront*", COMA.wavefront.__mul__, factor=2.0),
        tagged("Wavefront/", COMA.wavefront.__truediv__, divisor=2.0),
        tagged("Pupil", lm.Pupil, wavefront=lm.Wavefront(), **scale, apodization=0.1, geometry=None),
        tagged("Apodization", lm.Apodization, powers=[0.1, -0.2], error=1e-9),
        tagged("Apodization.gaussian", lm.Apodization.gaussian, g=0.5),
        tagged("Apodization.cosine", lm.Apodization.cosine, sine=0.5, power=-0.5),
        tagged("Apodization.value", lm.Apodization.gaussian(1.0).value, rho=[0.1, 0.5]),
        tagged("Apodization.scaled", lm.Apodization.gaussian(1.0).scaled, ratio=0.5),
        tagged("Pupil", lm.Pupil, spider=VANES.spider, vignetting=lm.Ellipse(0.9, 0.8), mask=MASK),
        tagged("Pupil.v", PUPIL.v, radius=[0.1]),
        tagged("Pupil.values", COMA.values, x=[0.1, 0.2], y=0.1),
        tagged("Spider", lm.Spider, width=0.1, angles=(0.1, 0.2)),
        tagged("Spider.equal", lm.Spider.equal, count=3, width=0.1, first=0.1),
        tagged("Ellipse", lm.Ellipse, a=0.9, b=0.8, angle=0.1),
        tagged("CatEye", lm.CatEye, shift=(0.1, 0.2), radius=0.9),
        tagged("Mask", lm.Mask, values=np.ones((4, 4))),
        tagged("Mask.sample", lm.Mask.sample, function=lambda x, y: x > y, side=4),
        tagged("Mask.at", MASK.at, x=np.array([0.1]), y=np.array([0.2])),
        tagged("Lens", lm.Lens, **lens, aberrations=lm.Wavefront(1.0), spider=VANES.spider),
        tagged("Lens.defocus", LENS.defocus, object_distance=[1.0, 2.0]),
        tagged("Lens.pupil", LENS.pupil, object_distance=[1.0, 2.0]),
        tagged("encircled_energy", PSF.encircled_energy, radius=[0.5, 1.0], about="axis"),
        tagged("encircled_energy", ODD.encircled_energy, radius=[0.5, 1.0], about="centroid"),
        tagged("ensquared_energy", PSF.ensquared_energy, half_width=[0.5, 1.0], about="axis"),
        tagged("ensquared_energy", ODD.ensquared_energy, half_width=[0.5, 1.0], about="centroid"),
        tagged("energy_diameter", PSF.energy_diameter, fraction=0.5, about="axis"),
        tagged("energy_diameter", ODD.energy_diameter, fraction=0.3, about="axis"),
        tagged("fwhm", PSF.fwhm, along="mean"),
        tagged("PSF.otf", PSF.otf, **at),
        tagged("PSF.mtf", ODD.mtf, **at),
        tagged("PSF.profile", PSF.profile, radius=[0.1, 0.2]),
        tagged("PSF.plot", PSF.plot, ax=None, stretch="sqrt"),
        tagged("PSF.save", PSF.save, path=folder / "a.npz"),
        tagged("PSF.load", lm.PSF.load, path=folder / "psf.npz"),
        tagged("PSF[]", lm.psf(STACK, 3, 0.5).__getitem__, index=0),
        tagged("Wavefront[]", STACK.wavefront.__getitem__, index=0),
        tagged("Pupil[]", STACK.__getitem__, index=0),
        tagged("FieldMap.on_grid", lm.FieldMap.on_grid, x=[0.0, 1.0], y=[0.0, 1.0],
               wavefront=lm.Wavefront([[0.0, 1.0], [2.0, 3.0]]), **scale),
        tagged("FieldMap.scattered", lm.FieldMap.scattered, x=[0.0, 1.0, 0.0], y=[0.0, 0.0, 1.0],
               wavefront=lm.Wavefront([0.0, 1.0, 2.0]), **scale),
        tagged("FieldMap.radial", lm.FieldMap.radial, height=[0.0, 1.0], wavefront=lm.Wavefront([0.0, 1.0]),
               azimuth=0.1, **scale),
        tagged("FieldMap.from_seidel", lm.FieldMap.from_seidel, edge=1.0, **seidel, **scale),
        tagged("FieldMap.pupil", FIELD.pupil, x=0.1, y=[0.1, 0.2]),
        tagged("FieldMap.psf", FIELD.psf, x=0.1, y=0.2, shape=3, pixel=0.5, method=NijboerZernike()),
        tagged("colour_psf", lm.colour_psf, pupil=CAMERA, shape=3, pixel=1e-6, channels=[5e-7, 6e-7], tol=1e-6),
        tagged("Channels", lm.Channels, wavelengths=[5e-7, 6e-7], weights=[[1.0, 2.0]], names=["a"]),
        tagged("Channels.bands", lm.Channels.bands, centers=[5e-7, 6e-7], width=5e-8, count=2),
        tagged("Channels.from_curves", lm.Channels.from_curves, wavelengths=[5e-7, 6e-7], curves=[[1.0, 2.0]],
               tol=1e-2, paths=1e-6),
        tagged("Colour", lm.Colour, wavelengths=[5e-7, 6e-7], focus_shift=[0.0, 1e-5], lateral=[0.0, 1e-6],
               heights=1e-2),
        tagged("FieldMap.grid", FIELD.grid, rows=1, columns=2, sensor=(1.0, 1.0), shape=3, pixel=0.5, method=None),
        tagged("PSFGrid", lm.PSFGrid, psf=GRID.psf, x=GRID.x, y=GRID.y, sensor=GRID.sensor),
        tagged("PSFGrid.plot", GRID.plot, ax=None, stretch="sqrt"),
        tagged("PSFGrid.save", GRID.save, path=folder / "g.npz"),
        tagged("PSFGrid.load", lm.PSFGrid.load, path=folder / "grid.npz"),
        tagged("fit_opd", lm.fit_opd, opd=CHART, unit="metres", wavelength=550e-9, mask=None, degree=3,
               center=(11.5, 11.5), radius=12.0),
        tagged("fit_opd", lm.fit_opd, opd=np.nan_to_num(CHART), unit="waves", wavelength=550e-9,
               mask=~np.isnan(CHART)),
        tagged("opd_map", lm.opd_map, wavefront=lm.Wavefront(1.0), shape=8, unit="waves", wavelength=550e-9,
               center=(3.0, 3.0), radius=3.0),
        tagged("ZernikeTable", ZernikeTable, terms={4: 0.1}, **units_of),
        tagged("ZernikeTable.from_wavefront", ZernikeTable.from_wavefront, wavefront=lm.Wavefront(1.0),
               **units_of),
        tagged("ZernikeTable.wavefront", ZernikeTable({4: 1.0}, "noll", "nm", "rms").wavefront, wavelength=5e-7),
        tagged("OPDMap", lm.OPDMap, values=CHART, spacing=1e-3, wavelength=5e-7),
        tagged("fit_opd", lm.fit_opd, opd=lm.OPDMap(CHART), wavelength=550e-9, degree=3),
        tagged("save_opd", lm.save_opd, path=folder / "o.csv", opd=lm.OPDMap(CHART)),
        tagged("load_opd", lm.load_opd, path=folder / "opd.npy", unit="nm", spacing=1e-3, wavelength=5e-7),
        tagged("Wavefront.save", lm.Wavefront(1.0).save, path=folder / "w.csv", **units_of),
        tagged("load_zernike", lm.load_zernike, path=folder / "table.json"),
        tagged("save_zernike", lm.save_zernike, path=folder / "t.csv", table=lm.load_zernike(folder / "table.json")),
        tagged("load_instrument", lm.load_instrument, path=folder / "lens.toml", folder_only=False),
        tagged("best_focus", lm.best_focus, pupil=PUPIL, radius=1.0),
        tagged("centroid", lm.centroid, pupil=COMA),
        tagged("marechal", lm.marechal, pupil=COMA),
        tagged("rms", lm.rms, pupil=COMA, unit="waves"),
        tagged("strehl", lm.strehl, pupil=COMA),
        tagged("spot_radius", lm.spot_radius, pupil=COMA),
        tagged("peak_error", lm.peak_error, values=SQUARE, reference=SQUARE),
        tagged("mtf", lm.mtf, pupil=PUPIL, **at, pixel=0.5, spectrum=None, tol=1e-8),
        tagged("otf", lm.otf, pupil=COMA, **at, pixel=0.5, spectrum=None, tol=1e-6),
        tagged("ptf", lm.ptf, pupil=COMA, **at),
        tagged("mtf_frequency", lm.mtf_frequency, pupil=lm.Pupil(), level=0.5, angle=0.1, pixel=None),
        tagged("DepthBlur", imaging.DepthBlur, lens=LENS, depth=DEPTH, pixel=8e-6, channels=[550e-9],
               energy=0.9, tol=1e-3, largest=11, dtype=np.float64, threads=1),
        tagged("DepthBlur.forward", BLUR.forward, image=SQUARE),
        tagged("DepthBlur.adjoint", BLUR.adjoint, image=SQUARE),
        tagged("FocusPlan", imaging.FocusPlan, **scene, occlusion=True),
        tagged("FocusPlan()", PLAN, focus_distance=2.0, f_number=5.6, out=None),
        tagged("depth_of_field", imaging.depth_of_field, **scene, energy=0.9, tol=1e-3),
        tagged("by_tiles", imaging.depth_of_field, **scene, tile=16, out=None, progress=None),
        tagged("read_depth", imaging.read_depth, path=folder / "depth.npy", scale=0.5, unknown=(0.0,)),
        tagged("read_photo", imaging.read_photo, path=folder / "photo.png", encoding="srgb"),
        tagged("write_photo", imaging.write_photo, path=folder / "p.png", light=SQUARE, encoding="srgb",
               dtype=np.uint8, like=None),
        tagged("Apodization.zernike", lm.Apodization.zernike, terms={2: 0.1}),
        tagged("Channels.rgb", lm.Channels.rgb, width=5e-8, count=2),
        tagged("LensRanges", imaging.LensRanges, focal_length=50e-3, f_number=(2.0, 4.0),
               focus_distance=(1.0, math.inf), pixel=8e-6, spherical=0.1, wavelength=550e-9),
        tagged("render_dataset", rendered, photos=[folder / "photo.png"], depths=[folder / "depth.npy"],
               out=folder / "set", lenses=RANGES, seed=1, copies=1, on_error="raise", workers=1),
        tagged("localize.fit", lm.localize.fit, table=SPOTS, images=np.ones((2, 9, 9)), noise=lm.Noise(read=1.0),
               starts=1, threads=1),
        tagged("deconvolve", lm.microscopy.deconvolve, stack=VOXELS, microscope=MICROSCOPE, **of_voxels),
        tagged("deconvolve", lm.microscopy.deconvolve, stack=VOXELS, microscope=PLANES, noise=lm.Noise(read=1.0),
               method=ONCE, background=0.0),
        tagged("Seeing", lm.Seeing, r0=0.1, focal_length=2.0, wavelength=5e-7, outer_scale=20.0),
        tagged("Seeing.from_fwhm", lm.Seeing.from_fwhm, fwhm=5e-6, focal_length=2.0, wavelength=5e-7),
        tagged("Jitter", lm.Jitter, sigma=1.0, across=0.5, angle=0.1),
        tagged("Motion", lm.Motion, length=1.0, angle=0.1),
        tagged("Noise", lm.Noise, white=0.5, read=1.0, offset=100.0, excess=1.5),
        tagged("Noise.record", lm.Noise(read=1.0).record, electrons=SQUARE, seed=1),
        tagged("Disc", lm.Disc, radius=0.5, center=(0.1, 0.2)),
        tagged("Polygon.regular", lm.Polygon.regular, sides=5, radius=0.5, angle=0.1),
        tagged("Polygon.strip", lm.Polygon.strip, start=(0.0, 0.0), end=(1.0, 0.0), width=0.1),
        tagged("Polygon.half_plane", lm.Polygon.half_plane, angle=0.1, offset=0.2),
        tagged("Shape.turned", lm.Disc(0.5).turned, angle=0.1),
        tagged("Segments", lm.Segments, shapes=(lm.Disc(0.5),), piston=(0.1,), tip=(0.1,), tilt=(0.1,)),
        tagged("Segments.hexagonal", lm.Segments.hexagonal, rings=1, gap=0.01, middle=False, angle=0.1),
        tagged("Segments.phased", lm.Segments.hexagonal(1).phased, piston=0.1, tip=0.1, tilt=0.1, unit="waves"),
        tagged("Dipole", lm.Dipole, polar=0.5, azimuth=0.1, wobble=0.2),
        tagged("Scalar", lm.Scalar, apodization="uniform", supercritical=True),
        tagged("Layer", lm.Layer, index=1.5, thickness=1e-4),
        tagged("Objective", lm.Objective, NA=1.2, magnification=60.0, immersion=1.333, working_distance=3e-4,
               coverslip=lm.Layer(1.5255, 170e-6), sample=1.36, apodization=0.1),
        tagged("Objective.pupil", OBJECTIVE.pupil, depth=1e-6, z=1e-7, wavelength=5e-7, origin="brightest",
               emitter="isotropic", aberrations=lm.Wavefront(0.1)),
        tagged("Objective.fields", OBJECTIVE.fields, radius=1e-7, depth=1e-6, focus=1e-6, wavelength=5e-7, tol=1e-6),
        tagged("Objective.focus", OBJECTIVE.focus, depth=1e-6, wavelength=5e-7),
        tagged("Objective.collected", OBJECTIVE.collected, depth=1e-6, wavelength=5e-7),
        tagged("Objective.nyquist", OBJECTIVE.nyquist, wavelength=5e-7),
        tagged("Vignetting", maps.Vignetting, height=[0.0, 1.0], shift=[0.0, 0.5], radius=1.1),
        tagged("Foreshortening", maps.Foreshortening, height=[0.0, 1.0], along=[1.0, 0.8], across=[1.0, 0.9]),
        tagged("Shading", maps.Shading, height=[0.0, 1.0], light=[1.0, 0.8]),
        tagged("Shading.cos4", maps.Shading.cos4, distance=0.1),
        tagged("FieldMap.seen_through", FIELD.seen_through, vignetting=maps.Vignetting([0.0, 1.0], [0.0, 0.5]),
               shading=maps.Shading.cos4(0.1)),
        tagged("FieldMap.illumination", FIELD.illumination, x=0.1, y=0.2),
        tagged("fisher", lm.fisher, pupil=PUPIL, shape=5, pixel=0.5, of=("row", "defocus"), photons=1e3,
               background=1.0, noise=lm.Noise(read=1.0)),
        tagged("find_spots", lm.detection.find_spots, images=100.0 * SQUARE, noise=lm.Noise(read=1.0), window=15,
               threshold=8.0),
        tagged("find_crossings", lm.detection.find_crossings, images=np.kron(np.eye(2), np.ones((30, 30))) * 900.0,
               noise=lm.Noise(read=1.0), window=15, threshold=8.0),
        tagged("grid_indices", lm.detection.grid_indices, places=[[0.0, 0.0], [0.0, 9.0], [9.0, 0.0], [9.0, 9.0]]),
        tagged("slanted_edge", imaging.slanted_edge, shape=(9, 9), angle=5.0, supersample=2),
        tagged("bead", lm.microscopy.bead, pupil=EMISSION, diameter=1e-7, shape=3, pixel=6.5e-6, tol=1e-3),
        tagged("confocal", lm.microscopy.confocal, excitation=EMISSION, emission=EMISSION, shape=3, pixel=6.5e-6,
               pinhole=1.0, tol=1e-3),
        tagged("localize.find", lm.localize.find, frames=np.ones((1, 24, 24)), box=15, threshold=6.0),
        tagged("localize_movie", lm.localize.localize_movie, movie=np.ones((1, 24, 24)), table=SPOTS,
               noise=lm.Noise(read=1.0)),
        tagged("restore", imaging.restore, photo=SQUARE, depth=DEPTH, lens=LENS, pixel=8e-6, encoding="linear",
               noise=lm.Noise(white=1e3, read=1.0), method=ONCE, saturation=1.0),
        tagged("FieldBlur", imaging.FieldBlur, field_map=FIELD, shape=(5, 6), pixel=0.1, largest=40, tol=0.1,
               energy=0.6),
        tagged("depth_precision", lm.depth_precision, lenses=PAIR, distance=1.9, pixel=8e-6,
               noise=lm.Noise(white=1e3, read=1.0), contrast=0.3),
        tagged("depth_from_defocus", imaging.depth_from_defocus, photographs=[SQUARE, SQUARE[::-1]], lenses=PAIR,
               pixel=8e-6, encoding="linear", noise=lm.Noise(white=1e3, read=1.0), between=(1.8, 2.3)),
        tagged("retrieve", lm.retrieve, images=STAR, pupil=lm.Pupil(), pixel=0.5, noise=lm.Noise(read=2.0),
               defocus=1.0, terms=2, seed=1),
        tagged("two_photon", lm.microscopy.two_photon, excitation=LASER, shape=3, pixel=6.5e-6, tol=1e-3),
        tagged("light_sheet", lm.microscopy.light_sheet, emission=EMISSION, thickness=1e-6, shape=3, pixel=6.5e-6,
               offset=0.0, tol=1e-3),
        tagged("load_camera", lm.load_camera, path="andor-zyla-5.5"),
        tagged("Polychromatic", Polychromatic, wavelengths=[5e-7, 6e-7], weights=[1.0, 2.0], method=Hankel(),
               tol=1e-6),
        tagged("ClosedForm.best", ClosedForm.best, pupil=PUPIL, shape=5, pixel=0.5),
    ]  # fmt: skip
    for name, kind in {**METHODS, "table": TableErf, "abramowitz": AbramowitzErf}.items():
        valid = {f.name: getattr(kind(), f.name) for f in dataclasses.fields(kind) if f.init}
        if valid:
            found.append(tagged(name, kind, **valid))
        if hasattr(kind, "field") and name != "huygens-fresnel":
            found.append(tagged(f"{name}.field", kind().field, pupil=lm.Pupil(lm.Wavefront(2.0)), v=[1.0, 2.0]))
        if hasattr(kind, "on_ray"):
            found.append(tagged(f"{name}.on_ray", kind().on_ray, s=[1.0, -2.0]))
    return found


def hostile(folder: Path) -> list[object]:
    """What an argument may be in place of what it should be."""
    masked = np.ma.masked_array([0.1, 0.2], mask=[True, False])
    pixels = np.ma.masked_array(SQUARE, mask=SQUARE > 0.5)
    numbers = [math.nan, math.inf, -math.inf, 0, 0.0, -0.0, -1, 1, 2.5, 1e300, -1e300, 5e-324, 1e-300, 1e20, 10**30]
    numbers += [10**400, 2**31, 2**63, -(2**63), 1e6, 1e-6, 3, 7, 1j, True, np.float32("nan"), np.longdouble("1e400")]
    words = ["", "x", "1", "nan", "energy", "a\nb", "\0", "ä" * 5000, b"1", "1 mm", "waves", "../.."]
    others = [None, (), [], {}, set(), object(), int, np, lambda *_: 0, slice(None), iter([1.0]), NotImplemented, ...]
    arrays = [np.array([]), np.array([[]]), np.zeros((0, 5)), np.array(["1"]), np.array([None]), np.array([object()])]
    arrays += [np.array([(1, 2.0)], dtype="i,f"), np.array(["2020"], dtype="M8[s]"), SQUARE.view(np.matrix), masked]
    arrays += [pixels, np.ma.masked, np.array([1j]), np.array([True]), np.array(math.nan), np.full((24, 24), np.inf)]
    arrays += [np.zeros((3, 3, 3)), np.zeros((24, 24)), -SQUARE, SQUARE.astype(int), np.ones((24, 24), bool)]
    arrays += [
        np.broadcast_to(1.0, (50, 60)),
        [[1.0], [1.0, 2.0]],
        [1.0, math.nan],
        ["a"],
        [None],
        [[]],
        [1.0] * 5000,
    ]
    arrays += [np.array([1e308, 1e308]), np.array([5e-324]), [10**400], np.array([1.0, -1.0]), range(3), (1.0, 2.0)]
    arrays += [np.float16(1.0), np.array([2.0], ">f8"), np.array([1, 2], np.uint8), [masked, masked], (math.nan, 1.0)]
    objects = [PUPIL, STACK, COMA, VANES, lm.Wavefront(1.0), lm.Wavefront([1.0, 2.0, 3.0]), LENS, PSF, GRID, FIELD]
    objects += [Hankel(), Hankel, LommelSeries(), lm.Ellipse(0.5, 0.5), MASK, VANES.spider, folder]
    objects += [folder / "nowhere.npz", {"height": ()}, {4: "x"}, {(2, 2): 1e308}, {"a": 1}, [(4, 1.0), (4, 2.0)]]
    return numbers + words + others + arrays + objects


def complaint(error: Exception, entry: str, argument: str, value: object) -> str | None:
    """Return what is wrong with an error, if anything is."""
    message = str(error)
    kind = type(error).__name__
    if isinstance(error, Warning) or not isinstance(error, (ValueError, TypeError, OSError)):
        # Documented: indices are NumPy's.
        if isinstance(error, IndexError | OverflowError) and entry.endswith("[]"):
            return None
        return f"{kind}: {message[:300]}"
    if isinstance(error, FileError | RecordingError | OSError):
        return None
    if len(message.splitlines()) != 1 or len(message) > (1500 if entry in MANY else 400):
        return f"a message of {len(message.splitlines())} lines, {len(message)} characters: {message[:400]!r}"
    if argument in ("function", "phase", "progress") and callable(value):
        return None  # it may raise what it likes
    words = (*NAMES.get(argument, ()), argument, *([value.name] if isinstance(value, Path) else []))
    if not entry.endswith("[]") and not any(word in message for word in words):
        return f"names no {argument}: {kind}: {message}"
    return None


# Every fault of these is told at once.
MANY = {"load_zernike", "load_instrument"}
# Other words for what an argument is; what has the right kind is judged by what it is for.
NAMES: dict[str, tuple[str, ...]] = {
    "pupil": ("out must", "values must", "supports", "needs a pupil", "derivatives", "aberrations", "dtype"),
    "method": ("supports", "needs", "derivatives", "dtype", "erf"),
    "wavelengths": ("wavelength",),
    "channels": ("wavelength", "weight"),
    "light": ("aberrations",),
    "v": ("aberrations",),
    "terms": ("term", "coefficient", "Zernike index"),
    "rho": ("samples",),
    "degree": ("samples",),
    "opd": ("samples", "residual"),
    "phase": ("samples", "residual"),
    "radius": ("samples", "must not be empty"),
    "center": ("samples",),
    "mask": ("samples", "opd", "aperture"),
    "path": ("camera must be",),
    "stack": ("path must be",),
    "tol": ("residual",),
    "function": ("values",),
    "out": ("dtype",),
    "dtype": ("bits",),
    "focal_length": ("focal length",),
    "nonradial": ("a term",),
    "focus_distance": ("windows",),
    "f_number": ("windows", "lambda*N"),
    "lens": ("windows", "aberrations"),
    "pixel": ("windows",),
    "energy": ("windows",),
    "largest": ("windows",),
    "depth": ("windows",),
    "depths": ("windows", "depth map"),
    "photos": ("photo",),
    "wavefront": ("wavelength", "table"),
    "angle": ("must not be empty",),
    "rms": ("must not be empty",),
    "x": ("position", "shape"),
    "y": ("position", "shape"),
    "index": ("a single",),
    "psf": ("of PSFs",),
    **dict.fromkeys(("W020", "W040", "W060", "W080", "W131", "W222", "W220", "W311"), ("must not be empty",)),
}


@pytest.fixture
def files(tmp_path: Path) -> Path:
    """A folder with a file of each kind that entries read."""
    lm.psf(PUPIL, 3, 0.5).save(tmp_path / "psf.npz")
    GRID.save(tmp_path / "grid.npz")
    np.save(tmp_path / "depth.npy", DEPTH)
    imaging.write_photo(tmp_path / "photo.png", SQUARE)
    (tmp_path / "lens.toml").write_text(
        'name = "a"\n[lens]\nfocal_length = "50 mm"\nf_number = 2\nwavelength = "550 nm"\n'
        '[sensor]\npixel = "3 um"\nshape = 9\n'
    )
    lm.save_zernike(tmp_path / "table.json", ZernikeTable({4: 0.1}, "noll", "nm", "rms"))
    lm.save_opd(tmp_path / "opd.npy", lm.OPDMap(CHART))
    return tmp_path


def refused(entry: tuple[str, object, dict[str, object]], argument: str, value: object) -> str | None:
    """Return what is wrong with how a value of one argument is refused, if anything is."""
    name, call, valid = entry
    told = f"{name}({argument}={' '.join(repr(value).split())[:80]})"
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        warnings.filterwarnings("ignore", "the matrix subclass")
        warnings.filterwarnings("ignore", "all of the depth, .* is beyond the hyperfocal distance")
        try:
            call(**valid | {argument: value})
        except MemoryError:
            return f"{told}: MemoryError"
        except Exception as error:
            wrong = complaint(error, name, argument, value)
            return f"{told}: {wrong}" if wrong else None
    return None


@pytest.mark.filterwarnings("ignore:the matrix subclass:PendingDeprecationWarning")
def test_bad_arguments_are_refused_by_name(files, hunt, count):
    known, bad = entries(files), hostile(files)

    def case(k: int) -> str | None:
        draw = random.Random(k)
        entry = draw.choice(known)
        argument, value = draw.choice(list(entry[2])), draw.choice(bad)
        return refused(entry, argument, value)

    findings = hunt(case, count(800, 100_000), seconds=20)
    assert not findings, "\n".join(findings)


# What no argument of a kind is; any argument is no object without properties.
OF_NO_KIND = {
    bool: ("yes", 2),
    int: ("1", 2.5, math.nan, True, -1, 10**30),
    float: ("1", b"1", 1j, math.nan, math.inf, -math.inf, True, {}),
    list: ("1", 1j, math.nan, ["1"], [1j], [math.nan], [math.inf]),  # of floats
    str: (1, "no such"),
}
# Attributes of results are not checked; numbers without a unit are angles; texts of messages may show anything.
UNCHECKED = {
    ("PSF", name) for name in ("normalize", "error_bound", "scale", "derivatives", "derivative_bounds", "blur")
}
UNCHECKED |= {("Noise.record", "seed"), ("retrieve", "seed")}
UNCHECKED |= {(name, "index") for name in ("PSF[]", "Wavefront[]", "Pupil[]")}
INFINITE = {("Lens", "focus_distance"), ("Seeing", "outer_scale"), ("depth_precision", "distance")}
INFINITE |= {("restore", "saturation")}  # none
INFINITE |= {(f"Lens.{name}", "object_distance") for name in ("defocus", "pupil")}


@pytest.mark.quick
def test_what_an_argument_cannot_be_is_refused_by_name_whatever_the_argument(files):
    found = []
    for entry, call, given in entries(files):
        call(**given)  # what is right is taken
        for name, valid in given.items():
            kind = type(valid) if not isinstance(valid, list) or isinstance(valid[0], float) else object
            for value in (object(), *OF_NO_KIND.get(kind, ())):
                if (entry, name) in UNCHECKED or ((entry, name) in INFINITE and value in (math.inf, [math.inf])):
                    continue
                if name == "encoding" and value == 1:  # a number
                    continue
                try:
                    call(**given | {name: value})
                except Exception as error:
                    told = complaint(error, entry, name, value)
                else:
                    told = "is taken"
                found += [f"{entry}({name}={value!r}): {told}"] if told else []
    assert not found, "\n".join(found)


@pytest.mark.parametrize("kind", ["array", "recording"])
@pytest.mark.parametrize("value", [-1e300, 1e300])
def test_a_stack_of_what_no_camera_counts_is_refused_at_once(value, kind):
    stack = VOXELS.astype(np.float64)
    stack[1, 5, 5] = value
    given = {"depth": 2e-6, "wavelength": 520e-9, "pixel": 6.5e-6, "step": 3e-7, "method": ONCE}
    held = stack if kind == "array" else lm.recorded.open_frames(stack).as_channels()
    for noise in (lm.Noise(read=1.0), None):
        with pytest.raises(ValueError, match=r"^stack must be within 1e\+15, or NaN where a value is unknown"):
            lm.microscopy.deconvolve(held, MICROSCOPE, noise=noise, **given)
    with pytest.raises(ValueError, match=r"^stack must be within 1e\+15"):
        lm.microscopy.deconvolve(held, PLANES, noise=lm.Noise(read=1.0), method=ONCE)
