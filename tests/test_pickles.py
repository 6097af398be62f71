"""Copies and pickles of an object of each public class: they compute the same, bit by bit."""

from __future__ import annotations

import copy
import inspect
import pickle
from collections.abc import Callable, Mapping
from dataclasses import fields, is_dataclass
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import tifffile
from PIL import Image

import lommel as lm
from lommel import imaging, localize, methods, microscopy, paper
from lommel.core.answers import not_met
from lommel.detection import targets
from lommel.fit.findings import Finding, Findings
from lommel.io.videos import FramePair, VideoFrame, video_frames
from lommel.recorded.frames import Frames, open_frames

cloudpickle = pytest.importorskip("cloudpickle")
PIXEL, RNG = 4e-6, np.random.default_rng(3)
IMAGE = RNG.uniform(0.1, 0.9, (64, 64)).astype(np.float32)
LENS = lm.Lens(focal_length=35e-3, f_number=8.0, focus_distance=1.35, wavelength=540e-9)
PAIR, NOISE = [LENS, LENS.focused(1.8)], lm.Noise(white=1e4, read=3.0)
PUPIL = lm.Pupil(lm.Wavefront(defocus=1.0), wavelength=540e-9, f_number=8.0)
DRY = lm.Objective(NA=0.8, magnification=20.0, immersion=1.0, sample=1.0)
LIT = DRY.pupil(depth=0.0, wavelength=520e-9)
STACK = RNG.poisson(200.0, (5, 24, 24)).astype(np.uint16)
DEPTHS = np.full(IMAGE.shape, 1.5)
LASER = DRY.pupil(depth=0.0, wavelength=488e-9, emitter=lm.Beam("circular"))
LASER_PLANES = DRY.pupil(depth=0.0, wavelength=520e-9, z=np.linspace(-2e-6, 2e-6, 5))
INFO = localize.MovieInfo(2, 9, 9, 1e-7, (7, 7), "z")
ONE, NUMBERS = np.ones(1), np.zeros((1, 2), int)
SPOT = RNG.poisson(5.0, (2, 32, 32)).astype(np.uint16)
SPOT[:, 14:17, 14:17] += 500
RESPONSE = imaging.EdgeResponse(ONE, ONE, ONE, (1.0, 1.0), 0.1, 0.5)
FINDINGS = Findings([Finding("misfit", "doubt", "it does not fit", {"by": 2.0})])
OTHER_MODULES = ("detection", "imaging", "io", "localize", "measures", "methods", "microscopy", "paper", "recorded")


def public() -> dict[str, type]:
    """Return the public classes of which there can be objects, by their names."""
    found: dict[str, type] = {}
    for module in (lm, *(getattr(lm, name) for name in (*OTHER_MODULES, "show", "telescopes"))):
        prefix = module.__name__.removeprefix("lommel").lstrip(".")
        for name in getattr(module, "__all__", dir(module)):
            thing = getattr(module, name)
            if (
                inspect.isclass(thing)
                and not inspect.isabstract(thing)
                and thing.__module__.startswith("lommel")
                and thing not in found.values()
            ):
                found[f"{prefix}.{name}".lstrip(".")] = thing
    return found


@cache
def disk() -> lm.PSF:
    return lm.psf(PUPIL, 9, PIXEL)


@cache
def depth() -> imaging.DefocusDepth:
    photographs = [
        imaging.depth_of_field(IMAGE, np.full(IMAGE.shape, 1.5), one, PIXEL, encoding="linear").values for one in PAIR
    ]
    return imaging.depth_from_defocus(photographs, PAIR, PIXEL, encoding="linear", noise=NOISE, between=(1.2, 2.0))


@cache
def restored() -> microscopy.RestoredStack:
    return microscopy.deconvolve(
        STACK, DRY, noise=lm.Noise(white=1.0, read=1.0), wavelength=520e-9, pixel=PIXEL, step=1e-6, depth=2e-5,
        direction="up", method=imaging.RichardsonLucy(steps=1, target=0.0), background=0.0, diagnosis=False,
    )  # fmt: skip


@cache
def recording() -> Frames:
    return open_frames(STACK)


@cache
def plan() -> lm.Plan:
    prepared = lm.Plan(9, PIXEL)
    prepared(PUPIL)
    return prepared


@cache
def blur() -> imaging.DepthBlur:
    return imaging.DepthBlur(DEPTHS, LENS, PIXEL)


@cache
def table() -> localize.Table:
    return localize.Table(LIT, 7, 6.5e-6, z=(-2e-7, 2e-7), tol=1e-2)


@cache
def stack_blur() -> microscopy.StackBlur:
    return microscopy.StackBlur(lm.psf(LASER_PLANES, 9, 2e-6), STACK.shape)


def found() -> dict[str, Any]:
    """Return what targets of both kinds have."""
    return {
        "windows": IMAGE[None], "places": NUMBERS, "shape": (64, 64), "noise": NOISE, "centers": ONE[:, None],
        "refused": (targets.Refused(1, 2, 3.0, "edge"),), "left_out": 0, "_counts": lm.Counts.of(IMAGE, noise=NOISE),
    }  # fmt: skip


MADE: dict[str, Callable[[], Any]] = {
    "Apodization": lambda: lm.Apodization((0.1,)),
    "BeadOptions": lambda: lm.BeadOptions(diameter=1e-7, progress=print),
    "Beam": lambda: lm.Beam("radial"),
    "Camera": lambda: lm.Camera("name", "source", 6.5e-6, read=1.0),
    "CatEye": lambda: lm.CatEye((0.3, 0.1)),
    "Channels": lambda: lm.Channels([5e-7, 6e-7], [[1.0, 0.5], [0.0, 1.0], [1.0, 0.0]]),
    "Colour": lambda: lm.Colour([5e-7, 6e-7], [0.0, 1e-5]),
    "ColourPSF": lambda: lm.colour_psf(LENS.pupil(1.5), 9, PIXEL, lm.Channels([5e-7, 6e-7], [[1.0, 0.5]])),
    "Counts": lambda: lm.Counts.of(IMAGE, noise=NOISE),
    "Dipole": lambda: lm.Dipole(0.3, 0.2),
    "Disc": lambda: lm.Disc(0.5),
    "Ellipse": lambda: lm.Ellipse(0.5, 0.4, 0.1),
    "FieldFitOptions": lambda: lm.FieldFitOptions(degree=2),
    "FieldMap": lambda: lm.FieldMap.from_seidel(20e-3, W131=1.0, aperture=PUPIL.unaberrated()),
    "Instrument": lambda: lm.load_instrument(lm.example_files()["nifty-fifty"]),
    "Jitter": lambda: lm.Jitter(1e-6),
    "Layer": lambda: lm.Layer(1.5, 1e-4),
    "Lens": lambda: LENS,
    "Mask": lambda: lm.Mask(np.eye(4)),
    "Microscope": lambda: lm.load_microscope(lm.example_files()["zeiss-63x-astigmatic"]),
    "Motion": lambda: lm.Motion(1e-5, 0.3),
    "Noise": lambda: lm.Noise(white=1.0 + IMAGE, read=2.0),
    "OPDMap": lambda: lm.OPDMap(IMAGE, wavelength=5e-7),
    "Objective": lambda: DRY,
    "PSF": disk,
    "PSFGrid": lambda: lm.PSFGrid(
        lm.psf(LENS.pupil(np.full((1, 1), 1.5)), 9, PIXEL),
        [0.0],
        [0.0],
        (1e-3, 1e-3),
    ),
    "Plan": plan,
    "Polygon": lambda: lm.Polygon(((0.0, 0.0), (1.0, 0.0), (0.0, 1.0))),
    "Pupil": lambda: PUPIL,
    "RetrieveOptions": lambda: lm.RetrieveOptions(terms=10),
    "Scalar": lm.Scalar,
    "Seeing": lambda: lm.Seeing(0.1),
    "Segments": lambda: lm.Segments((lm.Disc(0.3), lm.Disc(0.2, (0.6, 0.0)))),
    "Spider": lambda: lm.Spider(0.05, (0.0, 1.0)),
    "ToleranceError": lambda: not_met(1e-9, 1e-6, "the peak"),
    "Wavefront": lambda: lm.Wavefront(0.5, 0.1),
    "detection.Crossings": lambda: targets.Crossings(
        **found(), kind="crossing", indices=NUMBERS, contrast=ONE, square=9.0
    ),
    "detection.PointSources": lambda: targets.PointSources(**found(), score=ONE, flux=ONE, candidate=None),
    "detection.Targets": lambda: lm.detection.Targets(
        windows=IMAGE[None], places=[[9, 9]], shape=(64, 64), noise=NOISE
    ),
    "imaging.Aligned": lambda: imaging.Aligned((IMAGE,), np.s_[1:5, 2:6], *[ONE] * 5),
    "imaging.Blend": imaging.Blend,
    "imaging.BlurOptions": lambda: imaging.BlurOptions(tile=32),
    "imaging.CalibratedPlane": lambda: imaging.CalibratedPlane(*map(float, range(6))),
    "imaging.ChartEdge": lambda: imaging.ChartEdge(1.0, 2.0, 3.0, 4.0, "horizontal", RESPONSE),
    "imaging.DatasetOptions": lambda: imaging.DatasetOptions(copies=2, noise=NOISE),
    "imaging.DatasetPicture": lambda: imaging.DatasetPicture(1, 2, 3, (Path("a"),), {"a": 1}),
    "imaging.DefocusDepth": depth,
    "imaging.DefocusOptions": lambda: imaging.DefocusOptions(focus_error=0.1),
    "imaging.DefocusVerdict": lambda: imaging.DefocusVerdict(
        findings=FINDINGS, summary="text", misfit=1.0, scale=1.0, scale_error=0.1, lens_error={"a": [1.0]}
    ),
    "imaging.DepthBlur": blur,
    "imaging.DepthMapOptions": lambda: imaging.DepthMapOptions(scale=1e-3),
    "imaging.EdgeChart": lambda: imaging.EdgeChart(
        edges=(), refused=((1.0, 2.0, "why"),), shape=(9, 9), findings=FINDINGS
    ),
    "imaging.EdgeResponse": lambda: RESPONSE,
    "imaging.Exif": lambda: imaging.Exif(0.05, 2.0, b"12"),
    "imaging.FieldBlur": lambda: imaging.FieldBlur(
        lm.FieldMap.from_seidel(20e-3, W131=1.0, aperture=LENS.pupil(1.5).unaberrated()), 32, PIXEL
    ),
    "imaging.FocalCalibration": lambda: imaging.FocalCalibration(
        findings=FINDINGS,
        summary="text",
        lenses=tuple(PAIR),
        f_number_scale=1.0,
        f_number_error=0.1,
        focus_shifts=(0.0, 0.1),
        focus_error=0.1,
        origin=0.0,
        origin_error=0.1,
        covariance=np.eye(4),
        planes=(),
    ),
    "imaging.FocusPlan": lambda: imaging.FocusPlan(IMAGE, DEPTHS, LENS, PIXEL, encoding="linear"),
    "imaging.LensRanges": lambda: imaging.LensRanges(
        focal_length=0.05, f_number=(2.0, 8.0), focus_distance=1.0, pixel=4e-6
    ),
    "imaging.LiveDepth": lambda: imaging.LiveDepth(
        PAIR, PIXEL, between=(1.2, 2.0), noise=NOISE, shape=(64, 64), light=5e3
    ),
    "imaging.LiveDepthMap": lambda: imaging.LiveDepthMap(IMAGE, IMAGE, IMAGE, (1.0, 1.0), 9.0),
    "imaging.LiveDepthOptions": lambda: imaging.LiveDepthOptions(sharp=True),
    "imaging.LiveSharpen": lambda: imaging.LiveSharpen(
        LENS, PIXEL, between=(1.2, 2.0), noise=lm.Noise(read=3.0), shape=(64, 64)
    ),
    "imaging.Occlusion": lambda: imaging.Occlusion(blur()),
    "imaging.OnePass": imaging.OnePass,
    "imaging.PhotoError": lambda: imaging.PhotoError("text"),
    "imaging.Photograph": lambda: imaging.Photograph(IMAGE, "linear", imaging.Exif(0.05)),
    "imaging.Rendered": lambda: imaging.Rendered(imaging.Photograph(IMAGE, "linear"), 0.1, 0.1, 9),
    "imaging.Restoration": lambda: imaging.restore(
        IMAGE, np.full(IMAGE.shape, 1.5), LENS, PIXEL, encoding="linear", noise=NOISE, method=imaging.OnePass()
    ),
    "imaging.RestoreOptions": lambda: imaging.RestoreOptions(method=imaging.Blend()),
    "imaging.RichardsonLucy": lambda: imaging.RichardsonLucy(steps=9),
    "imaging.TotalVariation": lambda: imaging.TotalVariation(steps=9),
    "io.FramePair": lambda: FramePair(IMAGE, IMAGE, 0.5),
    "io.VideoError": lambda: lm.io.VideoError("text"),
    "io.VideoFrame": lambda: VideoFrame(IMAGE, 0.5),
    "localize.FocalSurface": lambda: localize.FocalSurface((64, 64), {"x": 1e-7}),
    "localize.Localizations": lambda: localize.Localizations(
        np.zeros(2, [("frame", int), ("row", float)]), INFO, findings=FINDINGS, summary="text"
    ),
    "localize.LocalizeOptions": lambda: localize.LocalizeOptions(flat=True),
    "localize.Molecules": lambda: localize.fit(table(), table()(3.0, 3.0, [0.0]) * 1e3 + 1.0),
    "localize.MovieInfo": lambda: INFO,
    "localize.Spots": lambda: localize.find(SPOT, 7, noise=lm.Noise(read=1.0), width=1.2),
    "localize.Table": table,
    "methods.Bead": lambda: methods.Bead(1e-7),
    "methods.ChordalDebye": methods.ChordalDebye,
    "methods.ChordalGauss": methods.ChordalGauss,
    "methods.Confocal": lambda: methods.Confocal(LIT),
    "methods.DebyeRings": methods.DebyeRings,
    "methods.DebyeWolf": methods.DebyeWolf,
    "methods.Hankel": methods.Hankel,
    "methods.MatrixFourier": methods.MatrixFourier,
    "methods.NijboerZernike": methods.NijboerZernike,
    "methods.NonuniformFFT": methods.NonuniformFFT,
    "methods.Polychromatic": lambda: methods.Polychromatic([5e-7, 6e-7]),
    "methods.Sted": lambda: methods.Sted(LASER, depletion=LASER, saturation=9.0),
    "methods.Stratified": methods.Stratified,
    "methods.TwoPhoton": methods.TwoPhoton,
    "microscopy.DeconvolveOptions": lambda: microscopy.DeconvolveOptions(depth=1e-6),
    "microscopy.MeasuredPSF": lambda: microscopy.MeasuredPSF(STACK / 1.0, 1e-7, 1e-7, 3, FINDINGS),
    "microscopy.Modality": lambda: microscopy.Modality("confocal", 4.88e-7),
    "microscopy.RestoredChannel": lambda: restored().channels[0],
    "microscopy.RestoredStack": restored,
    "microscopy.StackBlur": stack_blur,
    "paper.AbramowitzErf": paper.AbramowitzErf,
    "paper.ClosedForm": paper.ClosedForm,
    "paper.Fraunhofer": paper.Fraunhofer,
    "paper.FresnelErf": paper.FresnelErf,
    "paper.Geometric": paper.Geometric,
    "paper.HuygensFresnel": paper.HuygensFresnel,
    "paper.LommelSeries": paper.LommelSeries,
    "paper.TableErf": paper.TableErf,
    "paper.TunedClosedForm": paper.TunedClosedForm,
    "recorded.Frames": recording,
    "recorded.RecordingError": lambda: lm.recorded.RecordingError("text"),
    "recorded.Unusable": lambda: lm.recorded.Unusable("text"),
}
UNHASHABLE = ("Microscope", "imaging.DatasetPicture", "localize.FocalSurface", "methods.Confocal", "methods.Sted")
"""What is equal to its copies, and has a dict, or pupils that have arrays."""

OTHERS = ("io.FramePairs", "io.VideoFrames", "telescopes.Shape")
"""What is read once, and the base of apertures."""

COMPUTED: dict[str, Callable[[Any], Any]] = {
    "Plan": lambda it: it(PUPIL).values,
    "imaging.DefocusDepth": lambda it: (it.depth, it.sharp, it.to_dict()),
    "imaging.DepthBlur": lambda it: it.forward(IMAGE),
    "imaging.FieldBlur": lambda it: it.forward(IMAGE[:32, :32]),
    "imaging.FocusPlan": lambda it: it().values,
    "imaging.LiveDepth": lambda it: it(1e4 * IMAGE, 1e4 * IMAGE.T),
    "imaging.LiveSharpen": lambda it: it(1e3 * IMAGE, 1.5),
    "imaging.Occlusion": lambda it: it.forward(IMAGE),
    "localize.Table": lambda it: it([3.0, 3.2], 2.9, 1e-7, derivatives=True),
    "microscopy.RestoredStack": lambda it: (np.asarray(it), it.recording[:], it.to_dict()),
    "microscopy.StackBlur": lambda it: it.forward(np.moveaxis(STACK, 0, 2).astype(np.float32)),
    "recorded.Frames": lambda it: (it[:], it.axes, it.metadata, it.notes),
}
"""What an object computes; of the others, their attributes."""


def same(one: Any, other: Any) -> bool:
    """Return whether two objects have the same type, and the same attributes bit by bit."""
    if type(one) is not type(other):
        return False
    if isinstance(one, np.ndarray):
        return one.dtype == other.dtype and one.shape == other.shape and one.tobytes() == other.tobytes()
    if isinstance(one, Mapping):
        return list(one) == list(other) and all(same(one[key], other[key]) for key in one)
    if isinstance(one, tuple | list):
        return len(one) == len(other) and all(map(same, one, other))
    if isinstance(one, BaseException):
        return same((one.args, vars(one)), (other.args, vars(other)))
    if is_dataclass(one):
        return all(same(getattr(one, each.name), getattr(other, each.name)) for each in fields(one))
    if vars(type(one)).get("__eq__") is None and hasattr(one, "__dict__"):
        return same(vars(one), vars(other))
    return bool(one == other or one != one)


COPIES: dict[str, Callable[[Any], Any]] = {
    "copy": copy.copy,
    "deepcopy": copy.deepcopy,
    "pickle": lambda it: pickle.loads(pickle.dumps(it)),
    "cloudpickle": lambda it: pickle.loads(cloudpickle.dumps(it)),
}


def test_each_public_class_has_an_object_here():
    assert sorted((*MADE, *OTHERS)) == sorted(public())


@pytest.mark.parametrize("name", MADE)
def test_copies_and_pickles_compute_the_same(name):
    thing = MADE[name]()
    assert type(thing) is public()[name]
    compute = COMPUTED.get(name, lambda it: it)
    want = copy.deepcopy(compute(thing))
    for way, copied in COPIES.items():
        assert same(compute(copied(thing)), want), way
        has_equality = type(thing).__eq__ is not object.__eq__
        assert (copied(thing) == thing) is (has_equality or copied(thing) is thing), way
        if has_equality and name not in UNHASHABLE:
            assert hash(copied(thing)) == hash(thing), way


@pytest.mark.parametrize("way", COPIES)
def test_frames_of_files_are_read_again_from_their_file(way):
    np.save("stack.npy", STACK)
    tifffile.imwrite("stack.tif", STACK, compression="zlib")
    restored().save("stack.zarr")
    for name in ("stack.npy", "stack.tif", "stack.zarr"):
        frames = open_frames(name)
        want = frames[...]
        with COPIES[way](frames) as once, COPIES[way](once) as again:
            if way != "copy":  # which shares the file
                frames.close()
            np.testing.assert_array_equal(again[...], want)
            assert again.path.name == name


def test_frames_of_a_file_that_changed_are_refused():
    np.save("stack.npy", STACK)
    data = pickle.dumps(open_frames("stack.npy"))
    np.save("stack.npy", STACK[:3])
    with pytest.raises(lm.recorded.RecordingError, match="has changed"):
        pickle.loads(data)


def test_a_copied_live_depth_has_its_own_arrays_and_no_frames():
    live, frames = MADE["imaging.LiveDepth"](), (1e4 * IMAGE, 1e4 * IMAGE.T)
    found = copy.deepcopy(live(*frames))
    for way, copied in COPIES.items():
        again = copied(live)
        with pytest.raises(ValueError, match="there are no frames yet"):
            again.aliases()
        again(*frames[::-1])
        assert same(live._depth, found.depth), way


@pytest.mark.parametrize("way", COPIES)
def test_frames_of_a_video_are_neither_copied_nor_pickled(way):
    Image.fromarray((255.0 * IMAGE).astype(np.uint8)).save("frame0.png")
    with video_frames(Path("frame%d.png")) as frames, pytest.raises(TypeError, match="read once"):
        COPIES[way](frames)
