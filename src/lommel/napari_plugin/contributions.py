"""Contributions to napari, as its manifest lists them: sample data, a reader, a widget with progress."""

from __future__ import annotations

import textwrap
from collections.abc import Callable, Generator, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, TypeAlias

import numpy as np

from lommel.base.arrays import Json, Values
from lommel.deconvolve.algorithms import RichardsonLucy
from lommel.lensfiles import example_files, of_kind
from lommel.lensfiles.camera_files import load_camera
from lommel.lensfiles.microscope_files import Microscope, load_microscope
from lommel.microscopy.deconvolution import deconvolve
from lommel.microscopy.stack_blur import StackBlur
from lommel.optics.layers.objective_pupil import ObjectivePupil
from lommel.psf import PSF
from lommel.psf import psf as compute
from lommel.recorded.frames import open_frames
from lommel.recorded.noise import Noise

if TYPE_CHECKING:
    from magicgui.widgets import Container, Widget
    from napari.layers import Layer

LayerData: TypeAlias = tuple[Values, Json, str]
"""Data, options and type of a layer."""

KEY = "lommel"  # key of this plugin in the metadata of a layer
EMISSION = "emission wavelength"  # key in the metadata of a layer: metres, or None
_METRES = {"meter": 1.0, "millimeter": 1e-3, "micrometer": 1e-6, "nanometer": 1e-9, "picometer": 1e-12}


def layer_of(psf: PSF, name: str) -> LayerData:
    """Return a PSF as a layer with its voxel size in micrometres."""
    scale = voxel(psf)
    options: Json = {"name": name, "metadata": {KEY: psf}, "colormap": "inferno", "gamma": 0.5}
    if scale is not None:
        options |= {"scale": scale, "units": ("um",) * len(scale)}
    return np.asarray(psf.values), options, "image"


def voxel(psf: PSF) -> tuple[float, ...] | None:
    """Return the size of a voxel in micrometres, for a microscope in the sample; None if the PSF has no metres."""
    if psf.pupil.unit != "m":
        return None
    magnification: float = 1.0
    steps: tuple[float, ...] = ()
    if isinstance(psf.pupil, ObjectivePupil):
        magnification = psf.pupil.magnification
        z = np.ravel(psf.pupil.z)
        steps = (1e6 * float(abs(z[1] - z[0])),) if z.size > 1 else ()
    sides = tuple(1e6 * side / magnification for side in psf.grid.pitch)
    stack_axes = (1.0,) * (np.ndim(psf.values) - len(sides) - len(steps))
    return (*stack_axes, *steps, *sides)


def psf_of(metadata: Json) -> PSF | None:
    """Return the PSF in the metadata of a layer, or None."""
    psf_in_metadata = metadata.get(KEY)
    return psf_in_metadata if isinstance(psf_in_metadata, PSF) else None


def reader(path: str | Sequence[str]) -> Callable[[str | Sequence[str]], list[LayerData]] | None:
    """Return a function that reads a PSF, or a stack with its voxel size; None for other files."""
    if not isinstance(path, str):
        return None
    layers: list[LayerData] | None
    try:
        layers = [layer_of(PSF.load(path), Path(path).name.partition(".")[0])]
    except (ValueError, OSError, ImportError, TypeError):
        layers = _channels(path)
    # The file is read here, once: napari calls the function immediately afterwards with the same path.
    return None if layers is None else lambda _: layers


def _channels(path: str) -> list[LayerData] | None:
    """Return the channels of a recorded stack as layers; None if the file has no voxel size."""
    try:
        with open_frames(path) as frames:
            recording = frames.as_channels()
            (count, planes), metadata = recording.shape[:2], recording.metadata
            if metadata["pixel"] is None or metadata["step"] is None or planes < 2:
                return None
            name = Path(path).name.partition(".")[0]
            scale = tuple(1e6 * metadata[side] for side in ("step", "pixel", "pixel"))
            options = {"scale": scale, "units": ("um",) * 3, "blending": "additive"}
            return [
                (
                    recording[k],
                    options
                    | {
                        "name": name if count == 1 else f"{name} {metadata['names'][k]}",
                        "metadata": {EMISSION: metadata["emission"][k]},
                    },
                    "image",
                )
                for k in range(count)
            ]
    except (ValueError, OSError, ImportError, TypeError):
        return None


def voxel_of(layer: Layer) -> tuple[float, float] | None:
    """Return the pixel size and the plane spacing of a stack, metres; None for a layer without a scale."""
    scale = [float(value) for value in layer.scale[-3:]]
    if all(value == 1.0 for value in scale):
        return None
    # A scale without a unit is taken to be in micrometres, as the scale bar of napari takes it.
    units = [_METRES.get(str(value), 1e-6) for value in layer.units[-3:]]
    return scale[2] * units[2], scale[0] * units[0]


_OBJECTIVE, _CAMERA = "zeiss-63x-1.4-oil", "hamamatsu-orca-flash4-v3"
_SHAPE = (24, 96, 96)
_BEADS, _BACKGROUND = 30, 10.0
_PHOTONS = 4e5  # electrons of the brightest bead in all planes together


def beads() -> list[LayerData]:
    """Return a stack of beads with the noise of a camera, in counts, and its PSF."""
    microscope, camera = load_microscope(example_files()[_OBJECTIVE]), load_camera(_CAMERA)
    beads_psf = compute(replace(microscope, planes=33, step=200e-9).pupil(), 65, camera.side)
    draw = np.random.default_rng(1)
    emitters = np.zeros(_SHAPE, np.float32)
    positions = tuple(draw.integers(0, side, _BEADS) for side in _SHAPE)
    emitters[positions] = _PHOTONS * draw.uniform(0.3, 1.0, _BEADS)
    # Planes are the last axis of the operator.
    blurred = np.moveaxis(StackBlur(beads_psf, _SHAPE).forward(np.moveaxis(emitters, 0, -1)), -1, 0)
    electrons = np.maximum(blurred, 0.0) + _BACKGROUND
    counts = np.rint(np.clip(camera.noise.record(electrons, draw), 0, 65535)).astype(np.uint16)
    options = {"name": "beads", "scale": voxel(beads_psf), "units": ("um",) * 3, "metadata": {KEY: camera}}
    return [(counts, options, "image"), layer_of(beads_psf, "PSF of the beads")]


Restored: TypeAlias = "tuple[Layer, Values, str, tuple[str, ...]]"  # layer of the stack, values, summary, notes
Work = Callable[[Callable[[float], None]], Restored]
"""Function that does the work; its argument is a callback for the fraction done, 0 to 1."""


class Cancelled(Exception):  # noqa: N818 (no error)
    """Raised by the callback for the fraction done after the user has cancelled the work."""


class Panel:
    """Fields of a widget, a button that starts work on them in a thread, and a button that cancels the work."""

    def __init__(self, fields: list[Widget], begin: Callable[[], Work], done: Callable[[Restored], str]) -> None:
        from magicgui.widgets import Container, Label, ProgressBar, PushButton

        self.run, self.cancel = PushButton(text="Deconvolve"), PushButton(text="Cancel", enabled=False)
        self.bar, self.status = ProgressBar(min=0, max=100, value=0), Label(value="")
        buttons = Container(widgets=[self.run, self.cancel], layout="horizontal", labels=False)
        self.widget: Container[Widget] = Container(widgets=[*fields, buttons, self.bar, self.status])
        self._begin, self._done, self._is_cancelled = begin, done, False
        self.run.clicked.connect(self.start)
        self.cancel.clicked.connect(self.stop)
        self.widget.panel = self  # keeps the panel alive as long as the widget, and accessible from it

    def start(self) -> None:
        """Start the work of the fields."""
        from napari.qt.threading import create_worker

        try:
            work = self._begin()
        except Exception as error:
            self._show_error(error)
            return

        def report(fraction: float) -> None:
            if self._is_cancelled:
                raise Cancelled
            worker.yielded.emit(fraction)

        def run() -> Generator[float, None, Restored | None]:
            yield 0.0
            try:
                return work(report)
            except Cancelled:
                return None

        self._is_cancelled = False
        self._set_running(True, "working")
        # Errors are shown in the widget; raised in the thread of the windows they would end napari.
        worker = create_worker(run, _start_thread=False, _ignore_errors=True)
        worker.yielded.connect(self._show_progress)
        worker.returned.connect(self._show_result)
        worker.errored.connect(self._show_error)
        worker.start()

    def stop(self) -> None:
        """Cancel the work."""
        self._is_cancelled = True

    def _show_progress(self, fraction: float) -> None:
        self.bar.value = round(100 * min(max(fraction, 0.0), 1.0))

    def _show_result(self, result: Restored | None) -> None:
        self._set_running(False, "cancelled" if result is None else self._done(result))

    def _show_error(self, error: Exception) -> None:
        self._set_running(False, str(error) or type(error).__name__)

    def _set_running(self, is_running: bool, status: str) -> None:
        self.run.enabled, self.cancel.enabled = not is_running, is_running
        self.bar.value, self.status.value = 0, status


_BY_DEPTH, _ESTIMATED, _STATED_BELOW = "by depth, of the objective", "estimated from the stack", "as stated below"
_WIDTH = 60  # largest number of characters in a line of notes


def deconvolution_widget() -> Container[Widget]:
    """Return the deconvolution widget, with fields for stack, voxels, objective or PSF, camera noise, and steps."""
    import napari
    from magicgui.widgets import ComboBox, FileEdit, FloatSpinBox, SpinBox

    viewer = napari.current_viewer()
    layers = viewer.layers

    def stacks(_: object) -> list[str]:
        return [layer.name for layer in layers if np.ndim(layer.data) == 3 and psf_of(layer.metadata) is None]

    def psfs(_: object) -> list[str]:
        return [_BY_DEPTH, *(layer.name for layer in layers if psf_of(layer.metadata) is not None)]

    stack, psf = ComboBox(label="stack", choices=stacks), ComboBox(label="PSF", choices=psfs)
    objective = ComboBox(label="objective", choices=list(of_kind("objective")), value=_OBJECTIVE)
    file = FileEdit(label="or file", filter="*.toml", nullable=True, value=None)
    depth = FloatSpinBox(label="depth (um)", min=0.0, max=1000.0, step=0.5)
    emission = FloatSpinBox(label="wavelength (nm)", min=200.0, max=2000.0, step=5.0)
    pixel = FloatSpinBox(label="pixel in sample (nm)", min=1.0, max=100_000.0, step=1.0)
    step = FloatSpinBox(label="step (nm)", min=1.0, max=100_000.0, step=10.0)
    cameras = [name for name in of_kind("camera") if load_camera(name).read is not None]
    camera = ComboBox(label="camera", choices=[_ESTIMATED, _STATED_BELOW, *cameras])
    gain = FloatSpinBox(label="electrons / count", min=0.001, max=1000.0, step=0.01, value=1.0)
    read = FloatSpinBox(label="read noise (e-)", min=0.0, max=1000.0, step=0.1, value=1.5)
    offset = FloatSpinBox(label="offset (counts)", min=0.0, max=65535.0, step=1.0, value=0.0)
    steps = SpinBox(label="steps at most", min=1, max=1000, value=RichardsonLucy().steps)

    def load() -> Microscope:
        """Return the microscope of the file, or of the example if no file is selected."""
        has_file = file.value is not None and Path(file.value).is_file()
        return load_microscope(file.value if has_file else of_kind("objective")[objective.value])

    def noise() -> None:
        if camera.value not in (_ESTIMATED, _STATED_BELOW):
            camera_noise = load_camera(camera.value).noise
            gain.value, read.value, offset.value = camera_noise.white or 1.0, camera_noise.read, camera_noise.offset

    def voxels() -> None:
        microscope = load()
        size = None if stack.value is None else voxel_of(layers[stack.value])
        default = microscope.pixel / microscope.objective.magnification, abs(microscope.step) or 200e-9
        pixel.value, step.value = (1e9 * length for length in size or default)
        # A stack states the wavelength of its channel; the wavelength of an objective file is only an example.
        wavelength = None if stack.value is None else layers[stack.value].metadata.get(EMISSION)
        emission.value = 1e9 * (wavelength or microscope.wavelength)

    def load_objective() -> None:
        depth.value = 1e6 * load().depth
        voxels()

    def refresh(_: object = None) -> None:
        stack.reset_choices()
        psf.reset_choices()
        voxels()

    def begin() -> Work:
        if stack.value is None:
            raise ValueError("open a stack of planes, rows and columns first")
        source, max_steps = layers[stack.value], steps.value
        kernel = None if psf.value == _BY_DEPTH else psf_of(layers[psf.value].metadata)
        camera_noise = None
        if camera.value != _ESTIMATED:
            camera_noise = Noise(white=gain.value, read=read.value, offset=offset.value)
        microscope = load()
        method = RichardsonLucy(steps=max_steps, target=1.0)
        sampling = {}
        if kernel is None:  # a PSF has the sampling of its stack
            sampling = {
                "depth": 1e-6 * depth.value,
                "wavelength": 1e-9 * emission.value,
                "step": 1e-9 * step.value,
                "pixel": 1e-9 * pixel.value * microscope.objective.magnification,
            }

        def restore(report: Callable[[float], None]) -> Restored:
            result = deconvolve(
                np.asarray(source.data),
                microscope if kernel is None else kernel,
                noise=camera_noise,
                method=method,
                progress=lambda fraction, _: report(fraction),
                **sampling,
            )
            (channel,) = result.channels
            summary = f"{channel.steps} steps, discrepancy {channel.discrepancy:.3g}, stopped: {channel.stopped}"
            return source, result.values, summary, result.notes

        return restore

    def done(result: Restored) -> str:
        source, values, summary, notes = result
        options = {"scale": source.scale, "units": source.units, "colormap": "inferno", "metadata": {KEY: notes}}
        viewer.add_image(values, name=f"{source.name} deconvolved", **options)
        return "\n".join([summary, *(textwrap.fill(note, _WIDTH) for note in notes)])

    camera.changed.connect(noise)
    for field in (objective, file):
        field.changed.connect(load_objective)
    stack.changed.connect(voxels)
    layers.events.inserted.connect(refresh)
    layers.events.removed.connect(refresh)
    load_objective()
    optics, recording = [objective, file, depth, emission, pixel, step, psf], [camera, gain, read, offset]
    return Panel([stack, *optics, *recording, steps], begin, done).widget
