"""The widget that computes the PSF of a microscope."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from lommel.lensfiles.camera_files import load_camera
from lommel.lensfiles.example_files import of_kind
from lommel.napari_plugin.layers import layer_of
from lommel.napari_plugin.panel import ObjectiveFields, Panel
from lommel.psf import PSF, psf

if TYPE_CHECKING:
    from magicgui.widgets import Container

_OWN = "of the file"


def psf_widget() -> Container[Any]:
    """Return the widget: an objective of the examples or of a file, a camera, depth, light, planes and window."""
    import napari
    from magicgui.widgets import ComboBox, FloatSpinBox, SpinBox

    viewer = napari.current_viewer()

    objective = ObjectiveFields()
    camera = ComboBox(label="camera", choices=[_OWN, *of_kind("camera")])
    depth = FloatSpinBox(label="depth (um)", min=0.0, max=1000.0, step=0.5)
    light = FloatSpinBox(label="wavelength (nm)", min=200.0, max=2000.0, step=5.0)
    planes = SpinBox(label="planes", min=1, max=1024)
    step = FloatSpinBox(label="step (nm)", min=1.0, max=100_000.0, step=10.0)
    side = SpinBox(label="pixels", min=3, max=1025, value=65)

    def fill() -> None:
        found = objective.chosen()
        depth.value, light.value = 1e6 * found.depth, 1e9 * found.wavelength
        planes.value, step.value = found.planes, 1e9 * abs(found.step) or 100.0

    def begin() -> Callable[[Callable[[float], None]], PSF]:
        found = objective.chosen()
        kept = found.camera if camera.value == _OWN else load_camera(camera.value)
        asked = replace(
            found,
            depth=1e-6 * depth.value,
            wavelength=1e-9 * light.value,
            planes=planes.value,
            step=1e-9 * step.value if planes.value > 1 else 0.0,
            pixel=found.pixel if kept is None or camera.value == _OWN else kept.side,
            camera=kept,
        )

        def work(tell: Callable[[float], None]) -> PSF:
            made = psf(asked.pupil(), side.value, asked.pixel, integrate=asked.integrate)
            tell(1.0)
            return made

        return work

    def done(made: PSF) -> str:
        data, options, _ = layer_of(
            made, f"PSF {objective.name.value if objective.file.value is None else Path(objective.file.value).stem}"
        )
        viewer.add_image(data, **options)
        return "" if made.error_bound is None else f"error at most {made.error_bound:.1e} of the peak"

    objective.connect(fill)
    fill()
    return Panel(
        [objective.name, objective.file, camera, depth, light, planes, step, side], "Compute", begin, done
    ).widget
