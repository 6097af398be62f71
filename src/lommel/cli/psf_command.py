"""The commands ``lommel psf`` (lens, field, colours, microscope) and ``lommel stack`` (PSFs in a store on disk)."""

from __future__ import annotations

import ast
import dataclasses
import math
import time
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import Annotated, Any, ClassVar, Literal

import numpy as np

from lommel.base import validation
from lommel.base.executors import connected
from lommel.base.options import In, Options, Shown, filled
from lommel.base.units import ARCSEC, format_length
from lommel.base.validation import shown
from lommel.blur.blurs import Blur, Jitter, Seeing
from lommel.channel_psf import colour_psf
from lommel.cli.command import CLIENT, OUTPUT, PLOT, command
from lommel.cli.instruments import PLACE, WINDOW, Optics, Planes, Sensor, instrument_of, microscope_of
from lommel.cli.output import figure_format, progress, require_folder, save_figure, written
from lommel.field.psf_grid import PSFGrid
from lommel.io import field_files, psf_files
from lommel.io.registry import Format, suffixes
from lommel.methods import ERFS, METHODS, Method
from lommel.optics.colour.spectrum import Channels
from lommel.psf import psf as compute
from lommel.report import Facts, Report, Wrapped, optics
from lommel.report.table import told
from lommel.show.drawing import figure_of, fit_to_width, name_in_words
from lommel.stacks import psf_to


@command
def stack(
    lens: Path,
    /,
    *,
    between: Annotated[tuple[float, float], Shown(length="m", metavar="NEAR FAR")],
    count: Annotated[int, In(least=2, most=10**9)],
    output: Annotated[Path, OUTPUT._replace(metavar="FOLDER")],
    shape: Annotated[Any, WINDOW] = None,
    place: Annotated[tuple[float, float] | None, PLACE] = None,
    client: Annotated[str | None, CLIENT] = None,
    sensor: Sensor = Sensor(),
) -> Report:
    """Compute PSFs over a range of object distances, on disk.

    The PSFs are written to a store on disk, which may be larger than memory. An interrupted command can be repeated:
    it computes only the missing chunks.

    Parameters
    ----------
    between
        Nearest and farthest object distance, such as 1m 3m or 1m inf.
    count
        Number of distances, equally spaced in defocus.
    output
        Store to write, a folder .zarr.
    shape
        Window in pixels, such as 65 or 64x128 (height x width); overrides the file.
    place
        Place on the sensor, from its middle right and down (in FITS pictures up), such as 1.5mm -2mm; needs a section
        [field]. By default the axis.
    client
        Scheduler of a dask cluster that computes, such as tcp://host:8786; its workers must reach the store.

    Examples
    --------
      lommel stack phone.toml --between 1m inf --count 200 --shape 17 -o stack.zarr
    """
    near, far = between
    if not 0.0 < near < far:
        raise ValueError(f"--between must be two rising distances, got {near:g} and {far:g} metres")
    instrument = instrument_of(lens, shape=shape, place=place, **vars(sensor))
    with np.errstate(divide="ignore"):
        distances = 1.0 / np.linspace(1.0 / near, 1.0 / far, count)
    distances[0], distances[-1] = near, far
    window, start, steps = instrument.window, time.perf_counter(), 0
    with (
        progress(f"{count} PSFs of {window[0]} x {window[1]} pixels", elsewhere=client is not None) as report,
        connected(client) as cluster,
    ):

        def report_chunk(chunks: int, total: int) -> None:
            nonlocal steps
            steps += 1
            report(f"chunk {chunks} of {total}", chunks / total)

        store = psf_to(
            output,
            instrument.pupil(distances),
            window,
            instrument.pixel,
            integrate=instrument.integrate,
            progress=report_chunk,
            client=cluster,
        )
    bound, seconds = float(store.error_bound.max()), time.perf_counter() - start
    facts = {"store": str(output), "shape": list(store.shape), "dtype": str(store.dtype), "seconds": seconds}
    facts |= {"chunks": store.done[1], "computed": steps, "error_bound": None if math.isnan(bound) else bound}
    return told(facts) + optics.describe_place(instrument)


_Arcseconds = Annotated[float | None, In(above=0.0, most=60.0, unit="arcsec"), Shown(metavar="ARCSEC")]


@dataclass(frozen=True, kw_only=True)
class Air(Options):
    """Blur of images of telescopes on the ground.

    Parameters
    ----------
    seeing
        FWHM of long-exposure seeing (Kolmogorov) at 500 nm, in arcseconds.
    jitter
        Image motion during the exposure, arcseconds rms along each axis.
    """

    heading: ClassVar[str] = "Telescopes on the ground"
    seeing: _Arcseconds = None
    jitter: _Arcseconds = None

    def blur(self, focal_length: float) -> tuple[Blur, ...]:
        """Return the blur on the sensor."""
        blurs: tuple[Blur, ...] = ()
        if self.seeing is not None:
            blurs = (Seeing.from_fwhm(self.seeing * ARCSEC, focal_length),)
        return blurs if self.jitter is None else (*blurs, Jitter(self.jitter * ARCSEC * focal_length))


@dataclass(frozen=True, kw_only=True)
class Computation(Options):
    """Method, tolerance and unit of the values.

    Parameters
    ----------
    method
        How to evaluate the diffraction integral; `lommel methods` lists the methods.
    tol
        Tolerance, relative to the peak; by default set by the method (1e-6 for most).
    settings
        Option of the method, such as tangent=200 or erf=abramowitz:30; may be repeated.
    normalize
        energy: fraction of all light per pixel; emitted: fraction of the light that a microscope would collect from
        an emitter far from the cover glass; strehl: 1 = peak of the unaberrated PSF; peak: 1 = largest value.
    """

    heading: ClassVar[str] = "Computation"
    method: Annotated[
        str, Shown(("--method", "-m"), metavar="METHOD"), partial(validation.choice, allowed=("auto", *METHODS))
    ] = "auto"
    tol: float | None = None
    settings: Annotated[tuple[str, ...], Shown(("--set",), metavar="NAME=VALUE")] = ()
    normalize: Literal["energy", "emitted", "strehl", "peak"] = "energy"

    def arguments(self) -> Facts:
        """Return the arguments of :func:`lommel.psf`."""
        arguments = vars(self) | {"method": build_method(self.method, self.settings)}
        if any(setting.startswith("tol=") for setting in arguments.pop("settings")) and self.tol is not None:
            raise ValueError("tol is given twice, by --tol and by --set")
        return arguments


@command
@filled(psf=suffixes("psf", described=True), field=suffixes("field"), colours=suffixes("colours"))
def psf(
    lens: Path,
    /,
    *,
    outputs: Annotated[tuple[Path, ...], OUTPUT] = (),
    figure: Annotated[Path | None, PLOT] = None,
    stretch: Literal["sqrt", "linear", "log"] = "sqrt",
    lens_options: Optics = Optics(),
    field: Annotated[Any, WINDOW._replace(metavar="ROWSxCOLUMNS")] = None,
    colour: bool = False,
    mtf: bool = False,
    planes: Planes = Planes(),
    air: Air = Air(),
    computation: Computation = Computation(),
) -> Report:
    """Compute the PSF of a lens or a microscope.

    A file with a section [objective] describes a microscope: its PSF is a stack of planes, and a .png shows sections
    through it.

    Parameters
    ----------
    outputs
        Output file; may be repeated. Formats: {psf}. With --field: {field}. With --colour: {colours}.
    figure
        Figure with axes and a colour bar: .png, .pdf or .svg.
    stretch
        Brightness scale of figures; log reaches down to 1e-5 of the largest value and shows faint spikes.
    field
        Grid of PSFs over the sensor, such as 5x7; the lens file needs a section [field].
    colour
        PSFs in the colour channels of the lens file, or in red, green and blue.
    mtf
        Print the MTF at the Nyquist frequency and at half of it, pixel included: sagittal and tangential with --at or
        --field, else along x and y.

    Examples
    --------
      lommel psf hubble-1990.toml -o hubble.tif -o hubble.png
      lommel psf newtonian-off-axis.toml --plot star.png --stretch log
      lommel psf newtonian-off-axis.toml --seeing 1.2 --jitter 0.3 --plot seen.png
      lommel psf phone.toml --object-distance 1.2m --tol 1e-9 -o phone.npz
      lommel psf phone.toml --method closed-form --set tangent=200 --set erf=abramowitz:30
      lommel psf camera-field.toml --field 5x7 --plot field.png -o field.tif
      lommel psf camera-field.toml --field 5x7 --colour --mtf
      lommel psf camera-field.toml --at 15mm -10mm --jitter 2 -o corner.tif
      lommel psf camera-field.toml --at 15mm -10mm --colour --mtf --pixel 4um
      lommel psf nifty-fifty.toml --focus 1.2m --f-number 4 --wavelength 450nm
      lommel psf phone.toml --colour -o phone.png -o phone.npz
      lommel psf zeiss-63x-1.4-oil.toml --stack 64 --step 100nm --depth 2um -o psf.ome.tif -o psf.png
    """
    options, write = computation.arguments(), partial(_write, outputs, figure, stretch)
    lens_only: Facts = {"field": field, "colour": colour or None, "mtf": mtf or None}
    microscope = microscope_of(lens, **lens_only, **vars(air), **vars(lens_options), **vars(planes))
    if microscope is not None:
        window: Facts = {"shape": microscope.window, "pixel": microscope.pixel, "integrate": microscope.integrate}
        return write(
            lambda: compute(microscope.pupil(), **window, **options),
            lambda psfs, seconds: (
                optics.describe_microscope(microscope, foci=False) + optics.describe_stack(psfs, seconds)
            ),
            psf_files.find,
            microscope.name,
            sections=microscope.planes > 1,
        )
    instrument = instrument_of(lens, **vars(lens_options))
    options |= instrument.sensor_options
    if blur := air.blur(instrument.lens.focal_length):
        if field is not None or colour or mtf:
            raise ValueError("--seeing and --jitter are for one PSF: leave out --field, --colour and --mtf")
        options["blur"] = blur
        # Most of the light that seeing spreads is within three times its width.
        half_width = 3.0 * ARCSEC * ((air.seeing or 0.0) + 2.4 * (air.jitter or 0.0)) * instrument.lens.focal_length
        side = min(2 * math.ceil(half_width / min(instrument.pitch)) + 1, 1025)
        instrument = replace(instrument, shape=instrument.shape or (max(side, instrument.window[0]),) * 2)
    if lens_options.place is not None and field is not None:
        raise ValueError("--at is for one place: leave out --field")
    if field is not None and not isinstance(field, tuple):
        raise ValueError(f"--field must be ROWSxCOLUMNS such as 5x7, got {shown(field)}")
    if colour:
        options["channels"] = instrument.channels or Channels.rgb()
    options |= {"shape": instrument.window, "pixel": instrument.pixel}

    def make() -> Any:
        if field is not None:
            return instrument.field().grid(*field, sensor=instrument.sensor, **options)  # type: ignore[arg-type]
        return colour_psf(instrument.pupil(), **options) if colour else compute(instrument.pupil(), **options)

    def describe(psfs: Any, seconds: float) -> Report:
        seen = [f"{name} of {value:g} arcsec" for name, value in vars(air).items() if value is not None]
        if isinstance(psfs, PSFGrid) and not colour:
            report = optics.describe_field(instrument, psfs, seconds)
        elif colour:
            report = optics.describe_colour(instrument, getattr(psfs, "psf", psfs), seconds)
        else:
            report = optics.summarize_lens(instrument)
        if field is None:
            report += optics.describe_place(instrument)
        report += Report({}, [Wrapped(line) for line in seen])
        if field is None and not colour:
            report += optics.describe_psf(psfs, seconds)
        if not mtf:
            return report
        places: list[Any] = [(*(lens_options.place or (None, None)), instrument.pupil())]
        if isinstance(psfs, PSFGrid):
            over_field = instrument.field()
            places = [(x, y, over_field.pupil(x, y)) for y in psfs.y.tolist() for x in psfs.x.tolist()]
        return report + optics.describe_mtf(instrument, places, options.get("channels"))

    find = psf_files.find_colours if colour else psf_files.find
    if field is not None:
        find = partial(field_files.find, holding=field_files.DEPTHS_OR_CHANNELS if colour else "")
    focus, target = (format_length(d, digits=6) for d in (instrument.lens.focus_distance, instrument.object_distance))
    return write(make, describe, find, f"{instrument.name}\nfocus at {focus}, object at {target}")


def _write(
    outputs: tuple[Path, ...],
    figure: Path | None,
    stretch: str,
    make: Callable[[], Any],
    describe: Callable[[Any, float], Report],
    find: Callable[[Path, str], Format],
    title: str,
    sections: bool = False,
) -> Report:
    """Compute PSFs, write them, and return their report; with `sections`, a .png shows a stack like the figure."""
    # All paths are checked before anything is computed.
    files = [place for path in outputs for place in find(path, "--output").places(path)]
    for path in (*outputs, *files):
        require_folder(path)
    drawn_files = [path for path in outputs if sections and path.suffix.lower() == ".png"]
    for path in drawn_files:
        figure_format(path)
    if figure is not None:
        drawn_files.append(figure)
        files.append(figure)
    with progress("computing"):
        start = time.perf_counter()
        psfs = make()
        report = describe(psfs, time.perf_counter() - start)
        for path in outputs:
            if path not in drawn_files:
                psfs.save(path)
        if drawn_files:
            axes: Any = psfs.plot(stretch=stretch)
            drawn = figure_of(axes.flat[0] if hasattr(axes, "flat") else axes)
            text = fit_to_width(name_in_words(title), drawn)
            drawn.suptitle(f"{text}\n{drawn.get_suptitle()}".rstrip(), fontsize=9)
            for path in drawn_files:
                save_figure(lambda: drawn, path)
    report += written(files)
    if not files:
        report += Report({}, ["", Wrapped("Nothing was written: -o psf.tif or --plot psf.png saves the PSF.")])
    return report


def build_method(name: str, settings: tuple[str, ...] = ()) -> Method | None:
    """Return the method of a command-line name with ``NAME=VALUE`` settings, or None for "auto"."""
    if name == "auto":
        if settings:
            raise ValueError(f"--set needs --method, whose option it is, got --set {settings[0]}")
        return None
    kind = METHODS[name]
    option_names = {item.name for item in dataclasses.fields(kind)}  # type: ignore[arg-type]
    options: Facts = {}
    for setting in settings:
        key, equals, text = setting.partition("=")
        if not equals:
            raise ValueError(f"--set takes NAME=VALUE, got {shown(setting)}")
        if key in options:
            raise ValueError(f"{key} is given twice")
        if key not in option_names:
            allowed = f"its options are {', '.join(sorted(option_names))}" if option_names else "it has none"
            raise ValueError(f"{name} has no option {key!r}; {allowed}")
        options[key] = _erf(text) if key == "erf" else _value(text)
    try:
        return kind(**options)
    except (TypeError, ValueError) as error:
        raise type(error)(f"--set {error}") from None


def _erf(text: str) -> object:
    """Return the error function of a closed form from its name, which a colon and a number of terms may follow."""
    name, colon, count = text.partition(":")
    if name not in ERFS:
        raise ValueError(f"--set erf must be one of {', '.join(ERFS)}, with a count after a colon, got {shown(text)}")
    if colon and not dataclasses.fields(ERFS[name]):
        raise ValueError(f"--set erf={name} takes no count, got {shown(text)}")
    return ERFS[name](*([_value(count)] if colon else []))


def _value(text: str) -> Any:
    """Return the number, pair, truth value or word in a text."""
    try:
        return ast.literal_eval(text.title() if text.lower() in ("none", "true", "false") else text)
    except (ValueError, SyntaxError):
        return text
