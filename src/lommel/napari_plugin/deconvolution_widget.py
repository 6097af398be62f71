"""The widget that deconvolves a stack."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import numpy as np

from lommel.estimation.noise import Noise
from lommel.imaging.deconvolution import RichardsonLucy
from lommel.imaging.restoration import Restoration
from lommel.lensfiles.camera_files import load_camera
from lommel.lensfiles.example_files import of_kind
from lommel.microscopy.deconvolution import deconvolve
from lommel.napari_plugin.layers import psf_of
from lommel.napari_plugin.panel import Panel

if TYPE_CHECKING:
    from magicgui.widgets import Container


def deconvolution_widget() -> Container[Any]:
    """Return the widget: a stack, a PSF that the PSF widget made or a file had, the camera's noise, and steps."""
    import napari
    from magicgui.widgets import ComboBox, FloatSpinBox, SpinBox

    viewer = napari.current_viewer()
    layers = viewer.layers

    def stacks(_: Any) -> list[str]:
        return [one.name for one in layers if np.ndim(one.data) == 3 and psf_of(one.metadata) is None]

    def psfs(_: Any) -> list[str]:
        return [one.name for one in layers if psf_of(one.metadata) is not None]

    stack, psf = ComboBox(label="stack", choices=stacks), ComboBox(label="PSF", choices=psfs)
    stated = [name for name in of_kind("camera") if load_camera(name).read is not None]
    camera = ComboBox(label="camera", choices=["other", *stated])
    gain = FloatSpinBox(label="electrons / count", min=0.001, max=1000.0, step=0.01, value=1.0)
    read = FloatSpinBox(label="read noise (e-)", min=0.0, max=1000.0, step=0.1, value=1.5)
    offset = FloatSpinBox(label="offset (counts)", min=0.0, max=65535.0, step=1.0, value=0.0)
    steps = SpinBox(label="steps at most", min=1, max=1000, value=50)

    def fill() -> None:
        if camera.value != "other":
            noise = load_camera(camera.value).noise
            gain.value, read.value, offset.value = noise.white or 1.0, noise.read, noise.offset

    def refresh(_: Any = None) -> None:
        stack.reset_choices()
        psf.reset_choices()

    def begin() -> Callable[[Callable[[float], None]], tuple[Any, Restoration]]:
        if stack.value is None:
            raise ValueError("open a stack of planes, rows and columns first")
        if psf.value is None:
            raise ValueError("compute a PSF first, by the widget PSF of a microscope, or open the file of one")
        source, kernel = layers[stack.value], psf_of(layers[psf.value].metadata)
        assert kernel is not None  # as the choices have it
        noise = Noise(white=gain.value, read=read.value, offset=offset.value)
        most = steps.value

        def work(tell: Callable[[float], None]) -> tuple[Any, Restoration]:
            method = RichardsonLucy(steps=most, target=1.0)
            # Shares of the steps: how many are needed shows at the end.
            found = deconvolve(
                np.asarray(source.data), kernel, noise, method=method, progress=lambda step, _d, _l: tell(step / most)
            )
            return source, found

        return work

    def done(made: tuple[Any, Restoration]) -> str:
        source, found = made
        options = {"scale": source.scale, "units": source.units, "colormap": "inferno"}
        viewer.add_image(found.values, name=f"{source.name} deconvolved", **options)
        return f"{found.steps} steps, discrepancy {found.discrepancy:.3g}, stopped: {found.stopped}"

    camera.changed.connect(fill)
    layers.events.inserted.connect(refresh)
    layers.events.removed.connect(refresh)
    return Panel([stack, psf, camera, gain, read, offset, steps], "Deconvolve", begin, done).widget
