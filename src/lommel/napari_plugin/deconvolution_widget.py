"""The widget that deconvolves a stack."""

from __future__ import annotations

import textwrap
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import numpy as np

from lommel.imaging.deconvolution import RichardsonLucy
from lommel.lensfiles.camera_files import load_camera
from lommel.lensfiles.example_files import of_kind
from lommel.microscopy.deconvolution import deconvolve
from lommel.microscopy.restoration import restore
from lommel.napari_plugin.layers import EMISSION, KEY, psf_of, voxel_of
from lommel.napari_plugin.panel import ObjectiveFields, Panel
from lommel.recorded.noise import Noise

if TYPE_CHECKING:
    from magicgui.widgets import Container

_BY_DEPTH, _ESTIMATED, _STATED = "by depth, of the objective", "estimated from the stack", "as stated below"
_WIDTH = 60  # letters of a line of notes


def deconvolution_widget() -> Container[Any]:
    """Return the widget: a stack with its voxels, an objective or a PSF, the camera's noise, and steps."""
    import napari
    from magicgui.widgets import ComboBox, FloatSpinBox, SpinBox

    viewer = napari.current_viewer()
    layers = viewer.layers

    def stacks(_: Any) -> list[str]:
        return [one.name for one in layers if np.ndim(one.data) == 3 and psf_of(one.metadata) is None]

    def psfs(_: Any) -> list[str]:
        return [_BY_DEPTH, *(one.name for one in layers if psf_of(one.metadata) is not None)]

    stack, objective, psf = (
        ComboBox(label="stack", choices=stacks),
        ObjectiveFields(),
        ComboBox(label="PSF", choices=psfs),
    )
    depth = FloatSpinBox(label="depth (um)", min=0.0, max=1000.0, step=0.5)
    light = FloatSpinBox(label="wavelength (nm)", min=200.0, max=2000.0, step=5.0)
    pixel = FloatSpinBox(label="pixel in sample (nm)", min=1.0, max=100_000.0, step=1.0)
    step = FloatSpinBox(label="step (nm)", min=1.0, max=100_000.0, step=10.0)
    stated = [name for name in of_kind("camera") if load_camera(name).read is not None]
    camera = ComboBox(label="camera", choices=[_ESTIMATED, _STATED, *stated])
    gain = FloatSpinBox(label="electrons / count", min=0.001, max=1000.0, step=0.01, value=1.0)
    read = FloatSpinBox(label="read noise (e-)", min=0.0, max=1000.0, step=0.1, value=1.5)
    offset = FloatSpinBox(label="offset (counts)", min=0.0, max=65535.0, step=1.0, value=0.0)
    steps = SpinBox(label="steps at most", min=1, max=1000, value=RichardsonLucy().steps)

    def noise() -> None:
        if camera.value not in (_ESTIMATED, _STATED):
            known = load_camera(camera.value).noise
            gain.value, read.value, offset.value = known.white or 1.0, known.read, known.offset

    def voxels() -> None:
        found = objective.chosen()
        size = None if stack.value is None else voxel_of(layers[stack.value])
        own = found.pixel / found.objective.magnification, abs(found.step) or 200e-9
        pixel.value, step.value = (1e9 * length for length in size or own)
        # That of a file is of its channel, that of an objective an example.
        known = None if stack.value is None else layers[stack.value].metadata.get(EMISSION)
        light.value = 1e9 * (known or found.wavelength)

    def microscope() -> None:
        found = objective.chosen()
        depth.value = 1e6 * found.depth
        voxels()

    def refresh(_: Any = None) -> None:
        stack.reset_choices()
        psf.reset_choices()
        voxels()

    def begin() -> Callable[[Callable[[float], None]], tuple[Any, Any, str, tuple[str, ...]]]:
        if stack.value is None:
            raise ValueError("open a stack of planes, rows and columns first")
        source, most = layers[stack.value], steps.value
        kernel = None if psf.value == _BY_DEPTH else psf_of(layers[psf.value].metadata)
        known = None
        if camera.value != _ESTIMATED:
            known = Noise(white=gain.value, read=read.value, offset=offset.value)
        elif kernel is not None:
            raise ValueError(f"choose a camera: its noise is estimated for PSFs {_BY_DEPTH} only")
        found = objective.chosen()
        given: dict[str, Any] = {
            "depth": 1e-6 * depth.value,
            "wavelength": 1e-9 * light.value,
            "step": 1e-9 * step.value,
        }
        given |= {"pixel": 1e-9 * pixel.value * found.objective.magnification, "noise": known}
        method = RichardsonLucy(steps=most, target=1.0)

        def by_depth(tell: Callable[[float], None]) -> tuple[Any, Any, str, tuple[str, ...]]:
            values = np.asarray(source.data)
            made = restore(values, found, method=method, progress=lambda share, _: tell(share), **given)
            (each,) = made.channels
            words = f"{each.steps} steps, discrepancy {each.discrepancy:.3g}, stopped: {each.stopped}"
            return source, made.values, words, made.notes

        def by_one(tell: Callable[[float], None]) -> tuple[Any, Any, str, tuple[str, ...]]:
            assert kernel is not None
            assert known is not None
            values = np.asarray(source.data)
            # Shares of the steps: how many are needed shows at the end.
            made = deconvolve(values, kernel, known, method=method, progress=lambda count, _d, _l: tell(count / most))
            words = f"{made.steps} steps, discrepancy {made.discrepancy:.3g}, stopped: {made.stopped}"
            return source, made.values, words, ()

        return by_depth if kernel is None else by_one

    def done(made: tuple[Any, Any, str, tuple[str, ...]]) -> str:
        source, values, words, notes = made
        options = {"scale": source.scale, "units": source.units, "colormap": "inferno", "metadata": {KEY: notes}}
        viewer.add_image(values, name=f"{source.name} deconvolved", **options)
        return "\n".join([words, *(textwrap.fill(note, _WIDTH) for note in notes)])

    camera.changed.connect(noise)
    objective.connect(microscope)
    stack.changed.connect(voxels)
    layers.events.inserted.connect(refresh)
    layers.events.removed.connect(refresh)
    microscope()
    fields = [
        stack,
        objective.name,
        objective.file,
        depth,
        light,
        pixel,
        step,
        psf,
        camera,
        gain,
        read,
        offset,
        steps,
    ]
    return Panel(fields, "Deconvolve", begin, done).widget
