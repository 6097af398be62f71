"""The command ``lommel psf``: PSFs of a lens, over its field of view or in colour, and of a microscope."""

from __future__ import annotations

import dataclasses
import time
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, Generic, TypeVar

import click

from lommel.base.validation import shown
from lommel.channel_psf import ColourPSF, colour_psf
from lommel.cli import reports, tables
from lommel.cli.options import (
    FILE,
    INTEGRATE,
    JSON,
    LENS,
    OBJECT_DISTANCE,
    PIXEL,
    SHAPE,
    STACK,
    Facts,
    Option,
    Shape,
    command,
    documented,
    figure_format,
    instrument_of,
    microscope_of,
    picture_size,
    plot_option,
    print_json,
    require_folder,
    save_figure,
    under,
)
from lommel.cli.progress import progress
from lommel.field.psf_grid import PSFGrid
from lommel.io import colour_files, field_files, psf_files
from lommel.io.registry import Format, suffixes
from lommel.methods import ERFS, METHODS, Method
from lommel.optics.colour.spectrum import Channels
from lommel.psf import PSF
from lommel.psf import psf as compute

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from lommel.lensfiles.instrument import Instrument
    from lommel.lensfiles.microscope_files import Microscope

Made = TypeVar("Made", bound=PSF | ColourPSF | PSFGrid)


@dataclass(frozen=True, kw_only=True)
class _Product(Generic[Made]):
    """Functions that compute, describe, draw and store one kind of PSF."""

    size: str
    find: Callable[[Path, str], Format]
    make: Callable[[], Made]
    describe: Callable[[Made, float], Facts]
    show: Callable[[Made, Facts], None]
    draw: Callable[[Made], Figure]
    mtf: Callable[[Made], Facts] | None = None
    note: Callable[[Made, Path], str] = lambda *_: ""
    drawn: str = ""
    sections: bool = False  # of a stack, which a .png shows as its figure does


@command(
    LENS,
    Option("-o", "--output", "outputs", multiple=True, type=FILE,
           help=f"Output file; may be repeated. Formats: {suffixes('psf', described=True)}. "
           f"With --field: {suffixes('field')}. "
           f"With --colour: {suffixes('colours')}."),
    plot_option("Figure with axes and a colour bar (square-root scale)"),
    OBJECT_DISTANCE,
    PIXEL,
    SHAPE,
    INTEGRATE,
    Option("--field", type=Shape(), metavar="ROWSxCOLUMNS",
           help="Grid of PSFs over the sensor, such as 5x7; the lens file needs a section [field]."),
    Option("--colour", is_flag=True, help="PSFs in the colour channels of the lens file, or in red, green and blue."),
    Option("--mtf", is_flag=True,
           help="Print the MTF at the Nyquist frequency and at half of it, pixel included, along x and y."),
    JSON,
    *STACK,
    *under(
        "Computation",
        Option("-m", "--method", "method_name", default="auto", metavar="METHOD",
               type=click.Choice(("auto", *METHODS)),
               help="How to evaluate the diffraction integral; `lommel methods` lists the methods."),
        documented(compute, "tol", type=float,
                   help="Tolerance, relative to the peak; by default that of the method (1e-6 for most)."),
        Option("--set", "settings", multiple=True, metavar="NAME=VALUE",
               help="Option of the method, such as tangent=200 or erf=abramowitz:30; may be repeated."),
        Option("--normalize", default="energy", type=click.Choice(psf_files.NORMALIZE),
               help="energy: fraction of all light per pixel; emitted: fraction of the light that a microscope would "
               "collect from an emitter far from the cover glass; strehl: 1 = peak of the unaberrated PSF; "
               "peak: 1 = largest value."),
        Option("--dtype", type=click.Choice(["float32", "float64"]),
               help="Type of the values; by default float64 for a --tol below 1e-6, else float32."),
    ),
)  # fmt: skip
def psf(
    lens: Path,
    outputs: tuple[Path, ...],
    figure: Path | None,
    field: int | tuple[int, int] | None,
    colour: bool,
    mtf: bool,
    as_json: bool,
    method_name: str,
    settings: tuple[str, ...],
    **given: object,
) -> None:
    """Compute the PSF of a lens or a microscope.

    A file with a section [objective] describes a microscope: its PSF is a stack of planes, and a .png shows sections
    through it.

    Examples
    --------
      lommel psf hubble-1990.toml -o hubble.tif -o hubble.png
      lommel psf phone.toml --object-distance 1.2m --tol 1e-9 -o phone.npz
      lommel psf phone.toml --method closed-form --set tangent=200 --set erf=abramowitz:30
      lommel psf camera-field.toml --field 5x7 --plot field.png -o field.tif
      lommel psf camera-field.toml --field 5x7 --colour --mtf
      lommel psf phone.toml --colour -o phone.png -o phone.npz
      lommel psf zeiss-63x-1.4-oil.toml --stack 64 --step 100nm --depth 2um -o psf.ome.tif -o psf.png
    """
    options: Facts = {name: given.pop(name) for name in ("tol", "normalize", "dtype")}
    options["method"] = build_method(method_name, settings)
    if options["tol"] is not None and any(setting.startswith("tol=") for setting in settings):
        raise ValueError("tol is given twice, by --tol and by --set")
    microscope = microscope_of(lens, field=field, colour=colour or None, mtf=mtf or None, **given)
    if microscope is not None:
        _write(_of_microscope(microscope, options), outputs, figure, mtf, as_json)
        return
    instrument = instrument_of(lens, **{name: value for name, value in given.items() if name not in _STACK})
    options |= instrument.sensor_options
    channels = (instrument.channels or Channels.rgb()) if colour else None
    product: _Product[Any]
    if field is not None:
        product = _of_field(instrument, field, channels, options)
    elif channels is not None:
        product = _in_colour(instrument, channels, options)
    else:
        product = _of_lens(instrument, options)
    _write(product, outputs, figure, mtf, as_json)


_STACK = ("stack", "step", "depth")


def _write(product: _Product[Any], outputs: tuple[Path, ...], figure: Path | None, mtf: bool, as_json: bool) -> None:
    """Compute a product, write its files, and print its description."""
    # All is checked before anything is computed.
    written = [place for path in outputs for place in product.find(path, "--output").places(path)]
    for path in (*outputs, *written):
        require_folder(path)
    drawn = [path for path in outputs if product.sections and path.suffix.lower() == ".png"]
    drawn += [] if figure is None else [figure]
    for path in drawn:
        figure_format(path)
    with progress(product.size):
        start = time.perf_counter()
        made = product.make()
        facts = product.describe(made, time.perf_counter() - start)
        if mtf and product.mtf is not None:
            facts |= {"mtf": product.mtf(made)}
        for path in outputs:
            if path not in drawn:
                made.save(path)
        if drawn:
            picture = product.draw(made)
            for path in drawn:
                save_figure(picture, path)
    files = [*written, *([] if figure is None else [figure])]
    if as_json:
        print_json(facts | {"files": [str(path) for path in files]})
        return
    product.show(made, facts)
    if "mtf" in facts:
        tables.print_mtf(facts["mtf"])
    for path in files:
        click.echo(f"wrote {path}{product.drawn if path in drawn else product.note(made, path)}")


def _of_lens(instrument: Instrument, options: Facts) -> _Product[PSF]:
    """Return the PSF of a lens on the axis."""

    def show(made: PSF, facts: Facts) -> None:
        tables.print_lens(facts)
        tables.print_psf(made, facts["psf"])

    def draw(made: PSF) -> Figure:
        axes = _first(made.plot())
        axes.set_title(f"{instrument.name}\n{axes.get_title()}", fontsize=9)
        found: Figure = axes.figure
        return found

    return _Product(
        size=_size(instrument.window),
        find=psf_files.find,
        make=lambda: compute(instrument.pupil(), instrument.window, instrument.pixel, **options),
        describe=lambda made, seconds: (
            reports.describe_lens(instrument) | {"psf": reports.describe_psf(made, seconds)}
        ),
        show=show,
        draw=draw,
        mtf=lambda _: reports.describe_mtf(instrument),
        note=picture_size,
        drawn=": square root of the values",
    )


def _of_field(
    instrument: Instrument, field: int | tuple[int, int], channels: Channels | None, options: Facts
) -> _Product[PSFGrid]:
    """Return PSFs on a grid over the sensor, in channels where these are given."""
    if not isinstance(field, tuple):
        raise ValueError(f"--field must be ROWSxCOLUMNS such as 5x7, got {shown(field)}")
    rows, columns = field
    colours = {} if channels is None else {"channels": channels}
    given = {"shape": instrument.window, "pixel": instrument.pixel, **options, **colours}

    def make() -> PSFGrid:
        field_map = instrument.field()
        assert instrument.sensor is not None  # which a lens file with a field has
        return field_map.grid(rows, columns, sensor=instrument.sensor, **given)

    def describe(made: PSFGrid, seconds: float) -> Facts:
        if isinstance(made.psf, ColourPSF):
            return reports.describe_colour(instrument, made.psf, seconds)
        return reports.describe_field(instrument, made, seconds)

    def show(made: PSFGrid, facts: Facts) -> None:
        if channels is None:
            tables.print_field(made, facts)
        else:
            tables.print_colour(facts)

    def draw(made: PSFGrid) -> Figure:
        axes = _first(made.plot())
        axes.set_title(instrument.name, fontsize=9, loc="left", pad=22)
        found: Figure = axes.figure
        return found

    return _Product(
        size=f"{rows} x {columns} PSFs of {_size(instrument.window)}",
        find=partial(field_files.find, holding="" if channels is None else field_files.SEVERAL),
        make=make,
        describe=describe,
        show=show,
        draw=draw,
        mtf=lambda made: reports.describe_mtf(instrument, made, channels),
        drawn="" if channels else ": square root of the values, each PSF normalized to its maximum",
    )


def _in_colour(instrument: Instrument, channels: Channels, options: Facts) -> _Product[ColourPSF]:
    """Return the PSFs of a lens in colour channels."""

    def draw(made: ColourPSF) -> Figure:
        found: Figure = _first(made.plot()).figure
        found.suptitle(instrument.name, fontsize=9)
        return found

    return _Product(
        size=f"{len(channels)} channels of {_size(instrument.window)}",
        find=colour_files.find,
        make=lambda: colour_psf(instrument.pupil(), instrument.window, instrument.pixel, channels, **options),
        describe=lambda made, seconds: reports.describe_colour(instrument, made, seconds),
        show=lambda _, facts: tables.print_colour(facts),
        draw=draw,
        mtf=lambda _: reports.describe_mtf(instrument, None, channels),
    )


def _of_microscope(microscope: Microscope, options: Facts) -> _Product[PSF]:
    """Return the PSF of a microscope in all planes of its stack."""
    stack = microscope.planes > 1

    def show(made: PSF, facts: Facts) -> None:
        tables.print_microscope(facts)
        tables.print_stack(made, facts["psf"])

    def draw(made: PSF) -> Figure:
        found: Figure = _first(made.plot()).figure
        found.suptitle(microscope.name, fontsize=9)
        return found

    return _Product(
        size=(f"{microscope.planes} x " if stack else "") + _size(microscope.window),
        find=psf_files.find,
        make=lambda: compute(
            microscope.pupil(), microscope.window, microscope.pixel, integrate=microscope.integrate, **options
        ),
        describe=lambda made, seconds: (
            reports.describe_microscope(microscope, foci=False) | {"psf": reports.describe_stack(made, seconds)}
        ),
        show=show,
        draw=draw,
        note=picture_size,
        drawn=f": {'sections xy, xz and yz, ' if stack else ''}square root of the values",
        sections=stack,
    )


def _size(window: tuple[int, int]) -> str:
    return f"{window[0]} x {window[1]} pixels"


def _first(axes: Any) -> Any:
    """Return the axes of a figure, the first of several."""
    return axes.flat[0] if hasattr(axes, "flat") else axes


def build_method(name: str, settings: tuple[str, ...] = ()) -> Method | None:
    """Return the method of a command-line name with ``NAME=VALUE`` settings, or None for "auto"."""
    if name == "auto":
        if settings:
            raise ValueError(f"--set needs --method, whose option it is, got --set {settings[0]}")
        return None
    kind = METHODS[name]
    known = {item.name for item in dataclasses.fields(kind)}  # type: ignore[arg-type]
    options: Facts = {}
    for setting in settings:
        key, equals, text = setting.partition("=")
        if not equals:
            raise ValueError(f"--set takes NAME=VALUE, got {shown(setting)}")
        if key in options:
            raise ValueError(f"{key} is given twice")
        if key not in known:
            allowed = f"its options are {', '.join(sorted(known))}" if known else "it has none"
            raise ValueError(f"{name} has no option {key!r}; {allowed}")
        options[key] = _erf(text) if key == "erf" else _value(text)
    try:
        return kind(**options)
    except (TypeError, ValueError) as error:
        raise type(error)(f"--set {error}") from None


def _erf(text: str) -> object:
    """Return the error function of a closed form from its name, with a count of terms behind a colon."""
    name, colon, count = text.partition(":")
    if name not in ERFS:
        raise ValueError(f"--set erf must be one of {', '.join(ERFS)}, with a count after a colon, got {shown(text)}")
    if colon and not dataclasses.fields(ERFS[name]):
        raise ValueError(f"--set erf={name} takes no count, got {shown(text)}")
    return ERFS[name](*([_value(count)] if colon else []))


def _value(text: str) -> Any:
    """Return the number, pair, truth value or word that a text stands for."""
    if "," in text:
        return tuple(_value(part) for part in text.split(","))
    words = {"none": None, "true": True, "false": False}
    if text.lower() in words:
        return words[text.lower()]
    for kind in (int, float):
        try:
            return kind(text)
        except ValueError:
            continue
    return text
