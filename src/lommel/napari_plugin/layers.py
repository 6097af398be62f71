"""PSFs, recorded stacks and sample data as layers of napari, and back."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any, TypeAlias

import numpy as np

from lommel.base.arrays import Json
from lommel.lensfiles.camera_files import load_camera
from lommel.lensfiles.example_files import example_files
from lommel.lensfiles.microscope_files import load_microscope
from lommel.microscopy.stack_blur import StackBlur
from lommel.optics.layers.objective_pupil import ObjectivePupil
from lommel.psf import PSF
from lommel.psf import psf as compute
from lommel.recorded.recordings import open_recording

LayerData: TypeAlias = tuple[Any, Json, str]
"""Data, options and type of a layer."""

KEY = "lommel"  # of what a layer's metadata holds for this plugin
EMISSION = "emission wavelength"  # of a layer's metadata, metres, or None
_METRES = {"meter": 1.0, "millimeter": 1e-3, "micrometer": 1e-6, "nanometer": 1e-9, "picometer": 1e-12}


def layer_of(psf: PSF, name: str) -> LayerData:
    """Return a PSF as a layer with its voxel size in micrometres."""
    scale = voxel(psf)
    options: Json = {"name": name, "metadata": {KEY: psf}, "colormap": "inferno", "gamma": 0.5}
    if scale is not None:
        options |= {"scale": scale, "units": ("um",) * len(scale)}
    return np.asarray(psf.values), options, "image"


def voxel(psf: PSF) -> tuple[float, ...] | None:
    """Return the size of a voxel in micrometres, that of a microscope in the sample; None where it has no metres."""
    if psf.pupil.unit != "m":
        return None
    magnification: float = 1.0
    steps: tuple[float, ...] = ()
    if isinstance(psf.pupil, ObjectivePupil):
        magnification = psf.pupil.magnification
        z = np.ravel(psf.pupil.z)
        steps = (1e6 * float(abs(z[1] - z[0])),) if z.size > 1 else ()
    sides = tuple(1e6 * side / magnification for side in psf.grid.pitch)
    others = (1.0,) * (np.ndim(psf.values) - len(sides) - len(steps))
    return (*others, *steps, *sides)


def psf_of(metadata: Json) -> PSF | None:
    """Return the PSF that a layer was made of, by its metadata, or None."""
    found = metadata.get(KEY)
    return found if isinstance(found, PSF) else None


def reader(path: str | Sequence[str]) -> Callable[[str | Sequence[str]], list[LayerData]] | None:
    """Return a function that reads a PSF, or a stack with its voxel size; None for other files."""
    if not isinstance(path, str):
        return None
    found: list[LayerData] | None
    try:
        found = [layer_of(PSF.load(path), Path(path).name.partition(".")[0])]
    except (ValueError, OSError, ImportError, TypeError):
        found = _channels(path)
    # Read once: napari calls the function at once with the same path.
    return None if found is None else lambda _: found


def _channels(path: str) -> list[LayerData] | None:
    """Return a stack that a microscope recorded, a layer for each channel; None where a file has no voxel size."""
    try:
        with open_recording(path) as opened:
            count, planes = opened.shape[:2]
            if opened.pixel is None or opened.step is None or planes < 2:
                return None
            name = Path(path).name.partition(".")[0]
            scale = tuple(1e6 * side for side in (opened.step, opened.pixel, opened.pixel))
            shared = {"scale": scale, "units": ("um",) * 3, "blending": "additive"}
            return [
                (
                    np.asarray(opened.stack(k)),
                    shared
                    | {
                        "name": name if count == 1 else f"{name} {opened.names[k]}",
                        "metadata": {EMISSION: opened.emission[k]},
                    },
                    "image",
                )
                for k in range(count)
            ]
    except (ValueError, OSError, ImportError, TypeError):
        return None


def voxel_of(layer: Any) -> tuple[float, float] | None:
    """Return the pixel and the step between planes of a stack, metres; None of a layer that has no scale."""
    scale = [float(each) for each in layer.scale[-3:]]
    if all(each == 1.0 for each in scale):
        return None
    # Readers that state no unit mean micrometres, as napari's scale bar does.
    units = [_METRES.get(str(each), 1e-6) for each in layer.units[-3:]]
    return scale[2] * units[2], scale[0] * units[0]


_OBJECTIVE, _CAMERA = "zeiss-63x-1.4-oil", "hamamatsu-orca-flash4-v3"
_SHAPE = (24, 96, 96)
_BEADS, _BACKGROUND = 30, 10.0
_PHOTONS = 4e5  # electrons of the brightest bead in all planes together


def psf() -> list[LayerData]:
    """Return the PSF of an objective, 33 planes of 65 x 65 pixels."""
    return [layer_of(_psf(33, 65), _OBJECTIVE)]


def beads() -> list[LayerData]:
    """Return a stack of beads with the noise of a camera, in counts, and its PSF."""
    made, camera = _psf(33, 65), load_camera(_CAMERA)
    draw = np.random.default_rng(1)
    truth = np.zeros(_SHAPE, np.float32)
    where = tuple(draw.integers(0, side, _BEADS) for side in _SHAPE)
    truth[where] = _PHOTONS * draw.uniform(0.3, 1.0, _BEADS)
    # Planes are the last axis of the operator.
    blurred = np.moveaxis(StackBlur(made, _SHAPE).forward(np.moveaxis(truth, 0, -1)), -1, 0)
    seen = np.maximum(blurred, 0.0) + _BACKGROUND
    counts = np.rint(np.clip(camera.noise.record(seen, draw), 0, 65535)).astype(np.uint16)
    options = {"name": "beads", "scale": voxel(made), "units": ("um",) * 3, "metadata": {KEY: camera}}
    return [(counts, options, "image"), layer_of(made, "PSF of the beads")]


def _psf(planes: int, side: int) -> PSF:
    """Return the PSF of the example objective with the camera of the samples."""
    microscope = load_microscope(example_files()[_OBJECTIVE])
    one = replace(microscope, planes=planes, step=200e-9, pixel=load_camera(_CAMERA).side)
    return compute(one.pupil(), side, one.pixel)
