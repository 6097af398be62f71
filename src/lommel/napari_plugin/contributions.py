"""Contributions to napari, as its manifest lists them: sample data, a reader, two widgets with progress."""

from __future__ import annotations

import textwrap
from collections.abc import Callable, Generator, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Generic, TypeAlias, TypeVar

import numpy as np

from lommel.base.arrays import Json, Values
from lommel.deconvolve.algorithms import RichardsonLucy
from lommel.lensfiles import example_files, of_kind
from lommel.lensfiles.camera_files import load_camera
from lommel.lensfiles.microscope_files import Microscope, load_microscope
from lommel.microscopy.deconvolution import deconvolve
from lommel.microscopy.restoration import restore
from lommel.microscopy.stack_blur import StackBlur
from lommel.optics.layers.objective_pupil import ObjectivePupil
from lommel.psf import PSF
from lommel.psf import psf as compute
from lommel.recorded.noise import Noise
from lommel.recorded.recordings import open_recording

if TYPE_CHECKING:
    from magicgui.widgets import Container, Widget
    from napari.layers import Layer

_Made = TypeVar("_Made")
Work = Callable[[Callable[[float], None]], _Made]
"""Work that is called with a function that takes the share done."""

LayerData: TypeAlias = tuple[Values, Json, str]
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


def voxel_of(layer: Layer) -> tuple[float, float] | None:
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


class Cancelled(Exception):  # noqa: N818 (no error)
    """The user has stopped the work."""


def start(
    work: Work[_Made],
    *,
    done: Callable[[_Made | None], object],
    failed: Callable[[Exception], object],
    progress: Callable[[float], object],
) -> Callable[[], None]:
    """Start work in a thread and return a function that asks it to stop.

    `work` is called with a function that takes the share done; that raises :class:`Cancelled` once asked to stop. The
    others are called in the thread of the windows: `done` with the result, or None where the work was stopped.
    """
    from napari.qt.threading import create_worker

    stop = False

    def shares() -> Generator[float, None, _Made | None]:
        yield 0.0

        def tell(share: float) -> None:
            if stop:
                raise Cancelled
            worker.yielded.emit(share)

        try:
            return work(tell)
        except Cancelled:
            return None

    # Errors are told in the widget; raised again between windows they would end napari.
    worker = create_worker(shares, _start_thread=False, _ignore_errors=True)
    worker.yielded.connect(progress)
    worker.returned.connect(done)
    worker.errored.connect(failed)
    worker.start()

    def ask() -> None:
        nonlocal stop
        stop = True

    return ask


class ObjectiveFields:
    """Two fields: an objective of the examples, or the file of one."""

    def __init__(self) -> None:
        from magicgui.widgets import ComboBox, FileEdit

        self.name = ComboBox(label="objective", choices=list(of_kind("objective")), value="zeiss-63x-1.4-oil")
        self.file = FileEdit(label="or file", filter="*.toml", nullable=True, value=None)

    def chosen(self) -> Microscope:
        """Return the microscope of the file, or of the example where there is none."""
        own = self.file.value is not None and Path(self.file.value).is_file()
        return load_microscope(self.file.value if own else of_kind("objective")[self.name.value])

    def connect(self, fill: Callable[[], object]) -> None:
        """Call a function whenever another one is chosen."""
        self.name.changed.connect(fill)
        self.file.changed.connect(fill)


class Panel(Generic[_Made]):
    """Fields of a widget, with a button that works on them in a thread, and one that stops it."""

    def __init__(self, fields: list[Widget], label: str,
                 begin: Callable[[], Work[_Made]], done: Callable[[_Made], str]) -> None:  # fmt: skip
        from magicgui.widgets import Container, Label, ProgressBar, PushButton

        self.run, self.cancel = PushButton(text=label), PushButton(text="Cancel", enabled=False)
        self.bar, self.status = ProgressBar(min=0, max=100, value=0), Label(value="")
        buttons = Container(widgets=[self.run, self.cancel], layout="horizontal", labels=False)
        self.widget: Container[Widget] = Container(widgets=[*fields, buttons, self.bar, self.status])
        self._begin, self._done = begin, done
        self._stop: Callable[[], None] = lambda: None
        self.run.clicked.connect(self.start)
        self.cancel.clicked.connect(self.stop)
        self.widget.panel = self  # keeps it as long as the widget, and lets tests find it

    def start(self) -> None:
        """Start the work of the fields."""
        try:
            job = self._begin()
        except Exception as error:
            self._say(error)
            return
        self._busy(True)
        self.status.value = "working"
        self._stop = start(job, done=self._finish, failed=self._say, progress=self._show)

    def stop(self) -> None:
        """Ask the work to stop."""
        self._stop()

    def _show(self, share: float) -> None:
        self.bar.value = round(100 * min(max(share, 0.0), 1.0))

    def _finish(self, result: _Made | None) -> None:
        self._busy(False)
        self.status.value = "cancelled" if result is None else self._done(result)

    def _say(self, error: Exception) -> None:
        self._busy(False)
        self.status.value = str(error) or type(error).__name__

    def _busy(self, busy: bool) -> None:
        self.run.enabled, self.cancel.enabled = not busy, busy
        self.bar.value = 0


_OWN = "of the file"


def psf_widget() -> Container[Widget]:
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

    def begin() -> Work[PSF]:
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
            made = compute(asked.pupil(), side.value, asked.pixel, integrate=asked.integrate)
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


_BY_DEPTH, _ESTIMATED, _STATED = "by depth, of the objective", "estimated from the stack", "as stated below"
_WIDTH = 60  # letters of a line of notes


Restored: TypeAlias = "tuple[Layer, Values, str, tuple[str, ...]]"  # the layer, the values, a line on them, notes


def deconvolution_widget() -> Container[Widget]:
    """Return the widget: a stack with its voxels, an objective or a PSF, the camera's noise, and steps."""
    import napari
    from magicgui.widgets import ComboBox, FloatSpinBox, SpinBox

    viewer = napari.current_viewer()
    layers = viewer.layers

    def stacks(_: object) -> list[str]:
        return [one.name for one in layers if np.ndim(one.data) == 3 and psf_of(one.metadata) is None]

    def psfs(_: object) -> list[str]:
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

    def refresh(_: object = None) -> None:
        stack.reset_choices()
        psf.reset_choices()
        voxels()

    def begin() -> Work[Restored]:
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
        method = RichardsonLucy(steps=most, target=1.0)

        def by_depth(tell: Callable[[float], None]) -> Restored:
            values = np.asarray(source.data)
            made = restore(
                values, found, depth=1e-6 * depth.value, wavelength=1e-9 * light.value, step=1e-9 * step.value,
                pixel=1e-9 * pixel.value * found.objective.magnification, noise=known, method=method,
                progress=lambda share, _: tell(share),
            )  # fmt: skip
            (each,) = made.channels
            words = f"{each.steps} steps, discrepancy {each.discrepancy:.3g}, stopped: {each.stopped}"
            return source, made.values, words, made.notes

        def by_one(tell: Callable[[float], None]) -> Restored:
            assert kernel is not None
            assert known is not None
            values = np.asarray(source.data)
            # Shares of the steps: how many are needed shows at the end.
            made = deconvolve(values, kernel, known, method=method, progress=lambda count, _d, _l: tell(count / most))
            words = f"{made.steps} steps, discrepancy {made.discrepancy:.3g}, stopped: {made.stopped}"
            return source, made.values, words, ()

        return by_depth if kernel is None else by_one

    def done(made: Restored) -> str:
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
