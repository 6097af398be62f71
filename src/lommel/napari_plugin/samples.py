"""Sample data for napari: a PSF, and beads as a microscope records them."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from lommel.lensfiles.camera_files import load_camera
from lommel.lensfiles.example_files import example_files
from lommel.lensfiles.microscope_files import load_microscope
from lommel.microscopy.stack_blur import StackBlur
from lommel.napari_plugin.layers import KEY, LayerData, layer_of, voxel
from lommel.psf import PSF
from lommel.psf import psf as compute

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
