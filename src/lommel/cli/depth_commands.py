"""The commands for depth from defocus: ``lommel depth``, and ``lommel precision``, how well it can be known."""

from __future__ import annotations

import math
import time
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click
import numpy as np

from lommel.base.units import format_length
from lommel.cli.parts import (
    FILE,
    Length,
    figure_format,
    instrument_of,
    one_line_errors,
    print_json,
    save_figure,
)
from lommel.cli.progress import progress

if TYPE_CHECKING:
    from lommel.imaging.defocus_depth import DefocusDepth
    from lommel.optics.lens import Lens

_MISFIT = 2.0
_ROWS, _POINTS = 11, 121


def _length(metres: float) -> str:
    """Return a distance as options take it."""
    return "infinity" if math.isinf(metres) else format_length(metres)


@click.command()
@click.argument("photos", type=FILE, nargs=-1, required=True)
@click.argument("lens", type=FILE)
@click.option(
    "--focus",
    "foci",
    type=Length(),
    multiple=True,
    help='Distance in focus of each photo in turn: "1.35 m"; one for all, or instead of the lens file\'s.',
)
@click.option("--f-number", "f_numbers", type=float, multiple=True, help="Of each photo in turn, or one for all.")
@click.option("--between", type=Length(), nargs=2, required=True, help="Nearest and farthest distance looked for.")
@click.option("--white", type=float, required=True, help="Electrons at white (5000); of floats, at the value 1.")
@click.option("--read", type=float, required=True, help="Noise of reading a pixel, rms electrons.")
@click.option("--offset", type=float, default=0.0, show_default=True, help="Light of a pixel that counted none.")
@click.option(
    "--encoding",
    type=click.Choice(["srgb", "linear"]),
    help="Of the photos' values. By default integers are sRGB, floats linear.",
)
@click.option(
    "--window",
    type=float,
    default=4.0,
    show_default=True,
    help="Rms width of the windows in which depth is the same, pixels.",
)
@click.option("--candidates", type=int, help="Distances that are tried; by default 61 or more.")
@click.option(
    "--exposure",
    "exposures",
    type=float,
    multiple=True,
    help="Light of each photo over the first's; by default as measured.",
)
@click.option(
    "--magnification",
    type=click.Choice(["registered", "lens"]),
    default="registered",
    show_default=True,
    help="Whether points are at the same pixel in all photos, or as large as a thin lens makes them.",
)
@click.option("--saturation", type=float, help="Values from here on are left out; of integers the largest always is.")
@click.option("--pixel", type=Length(), help='Pixel pitch, instead of the lens file\'s: "4 um".')
@click.option(
    "-o",
    "--output",
    "outputs",
    type=FILE,
    multiple=True,
    help="First the depth, then its deviation, metres: .tif, .npy or .pfm.",
)
@click.option("--sharp", type=FILE, help="The image in focus everywhere: .png, .jpg or .tif.")
@click.option("--plot", "figure", type=FILE, help="All three: .png, .pdf, .svg.")
@click.option("--json", "as_json", is_flag=True, help="Print what was found as JSON.")
@one_line_errors
def depth(
    photos: tuple[Path, ...],
    lens: Path,
    foci: tuple[float, ...],
    f_numbers: tuple[float, ...],
    white: float,
    read: float,
    offset: float,
    encoding: str | None,
    exposures: tuple[float, ...],
    pixel: float | None,
    outputs: tuple[Path, ...],
    sharp: Path | None,
    figure: Path | None,
    as_json: bool,
    **options: Any,
) -> None:
    """Find the distance of everything in photos of a scene that differ in focus, or in aperture.

    PHOTOS are two or more PNG, JPEG or TIFF of one size, taken from the same place, neither denoised nor sharpened.
    LENS is a lens file; --focus, or --f-number, says what each photo has of its own. What has no texture has no
    depth, NaN, and the deviation infinity.

    \b
    Examples:
      lommel depth near.tif far.tif lens.toml --focus 1.35m --focus 1.8m --between 1.2m 2m --white 5000 --read 3
      lommel depth near.tif far.tif lens.toml --f-number 4 --f-number 16 --between 2m inf --white 5000 --read 3
    """  # noqa: D301 (\b is meant)
    from lommel.cli.photo_job import read_as
    from lommel.estimation.noise import Noise
    from lommel.imaging import depth_from_defocus, read_photo, write_depth, write_photo
    from lommel.io import depthmaps
    from lommel.io import photos as photo_files

    if len(outputs) > 2:
        raise ValueError(f"--output must be the depth and its deviation, got {len(outputs)} files")
    for path in outputs:
        depthmaps.find(path, "--output")
    if sharp is not None:
        photo_files.find(sharp, "--sharp")
    if figure is not None:
        figure_format(figure)
    instrument = instrument_of(lens, pixel=pixel)
    if instrument.aberrations_of_field is not None:
        raise ValueError(f"{lens} has aberrations that vary over the field; depth from defocus has one set of them")
    lenses = _each(instrument.lens, len(photos), foci, f_numbers)
    with progress("reading") as started:
        pictures = [read_photo(path, encoding) for path in photos]
        kinds = {(one.values.dtype, one.encoding) for one in pictures}
        if len(kinds) > 1:
            raise ValueError("the photos must have one type and one encoding; give --encoding, or convert some")
        started("preparing the blur of every distance")
        start = time.perf_counter()
        found = depth_from_defocus(
            [one.values for one in pictures],
            lenses,
            instrument.side,
            encoding=pictures[0].encoding,
            noise=Noise(white=white, read=read, offset=offset),
            exposures=exposures or None,
            progress=lambda done, tiles: started(f"tile {done} of {tiles}", done / tiles),
            **options,
        )
        seconds = time.perf_counter() - start
        for path, values in zip(outputs, (found.depth, found.deviation), strict=False):
            write_depth(path, values)
        if sharp is not None:
            from lommel.base.encoding import to_light

            light = to_light("sharp", found.sharp, found.encoding, np.float32)
            dtype: Any = np.float32 if sharp.suffix.lower() in (".tif", ".tiff") else np.uint8
            dtype = found.sharp.dtype if found.sharp.dtype.kind == "u" and sharp.suffix.lower() != ".jpg" else dtype
            write_photo(sharp, light, encoding="linear" if dtype == np.float32 else "srgb", dtype=dtype)
        if figure is not None:
            save_figure(found.plot(), figure)
    files = [path for path in (*outputs, sharp, figure) if path is not None]
    facts = _facts(found, lenses, seconds) | {"pixel": instrument.side, "files": [str(path) for path in files]}
    facts["read"] = read_as(pictures[0], encoding)
    if as_json:
        print_json(facts)
        return
    _tell(facts, options)
    for path in files:
        click.echo(f"wrote {path}")


def _each(lens: Lens, count: int, foci: tuple[float, ...], f_numbers: tuple[float, ...]) -> list[Lens]:
    """Return the lens of each photo."""
    for name, given in (("--focus", foci), ("--f-number", f_numbers)):
        if len(given) not in (0, 1, count):
            raise ValueError(f"{name} must be given once, or for each of {count} photos, got {len(given)}")
    if count < 2:
        raise ValueError("PHOTOS must be two or more: one does not tell blur from soft texture; got 1")
    lenses = [lens] * count
    if f_numbers:
        lenses = [one.stopped(stop) for one, stop in zip(lenses, f_numbers * (count // len(f_numbers)), strict=True)]
    if foci:
        lenses = [one.focused(focus) for one, focus in zip(lenses, foci * (count // len(foci)), strict=True)]
    return lenses


def _facts(found: DefocusDepth, lenses: list[Lens], seconds: float) -> dict[str, Any]:
    """Return what there is to say, in plain types."""
    known = np.isfinite(found.deviation)
    inner = known if known.any() else None
    low, middle, high = np.percentile(found.depth[inner], [5.0, 50.0, 95.0]) if inner is not None else [math.nan] * 3
    return {
        "shape": list(found.depth.shape),
        "focus_distances": [_finite(one.focus_distance) for one in lenses],
        "f_numbers": [one.f_number for one in lenses],
        "focal_length": lenses[0].focal_length,
        "candidates": len(found.candidates),
        "exposures": list(found.exposures),
        "known": found.known,
        "depth": None if inner is None else {"5 %": low, "50 %": middle, "95 %": high},
        "deviation": None if inner is None else float(np.median(found.deviation[inner])),
        "misfit": float(np.median(found.misfit if inner is None else found.misfit[inner])),
        "seconds": seconds,
    }


def _finite(distance: float) -> float | str:
    return distance if math.isfinite(distance) else "infinity"


def _tell(facts: dict[str, Any], options: dict[str, Any]) -> None:
    click.echo(facts["read"])
    height, width = facts["shape"]
    foci = [_length(float(each) if each != "infinity" else math.inf) for each in facts["focus_distances"]]
    each = ", ".join(f"{focus} at f/{stop:.3g}" for focus, stop in zip(foci, facts["f_numbers"], strict=True))
    near, far = (_length(end) for end in options["between"])
    click.echo(f"{width} x {height} pixels of {format_length(facts['pixel'])}; focus {each}")
    click.echo(f"{facts['candidates']} distances from {near} to {far}, windows of {options['window']:g} pixels rms")
    if facts["depth"] is None:
        click.echo("no depth is known: there is no texture, or all of it is out of range")
    else:
        low, middle, high = (_length(facts["depth"][name]) for name in ("5 %", "50 %", "95 %"))
        click.echo(
            f"depth known at {100.0 * facts['known']:.3g} % of the pixels: {low} to {high} (5 to 95 %), "
            f"median {middle}, +- {format_length(facts['deviation'], digits=2)}"
        )
    told = f"misfit {facts['misfit']:.3g}"
    if facts["misfit"] > _MISFIT:
        click.echo(f"{told}: registration, noise or lens do not fit the photos; depths may be wrong")
    else:
        click.echo(f"{told} (about 1 where registration and noise hold)")


@click.command()
@click.argument("lens", type=FILE)
@click.option(
    "--focus",
    "foci",
    type=Length(),
    multiple=True,
    help='Distances in focus of two photos or more, or one for --pair and --best: "1.5 m".',
)
@click.option("--pair", type=float, help="Two photos, focused so many dioptres (1/m) before and behind --focus.")
@click.option("--best", is_flag=True, help="The two foci that know the distance of --focus best.")
@click.option("--f-number", type=float, help="Instead of the lens file's.")
@click.option("--photons", type=float, required=True, help="Electrons of a pixel on average.")
@click.option("--read", type=float, default=3.0, show_default=True, help="Noise of reading a pixel, rms electrons.")
@click.option(
    "--contrast", type=float, default=0.35, show_default=True, help="Of texture of 2 to 128 pixels, rms over mean."
)
@click.option(
    "--window",
    type=float,
    default=4.0,
    show_default=True,
    help="Rms width of the windows in which depth is the same, pixels.",
)
@click.option("--between", type=Length(), nargs=2, help="Nearest and farthest distance; by default about the foci.")
@click.option("--pixel", type=Length(), help='Pixel pitch, instead of the lens file\'s: "4 um".')
@click.option("--plot", "figure", type=FILE, help="Deviation over distance: .png, .pdf, .svg.")
@click.option("--json", "as_json", is_flag=True, help="Print it as JSON.")
@one_line_errors
def precision(
    lens: Path,
    foci: tuple[float, ...],
    pair: float | None,
    best: bool,
    f_number: float | None,
    photons: float,
    read: float,
    contrast: float,
    window: float,
    between: tuple[float, float] | None,
    pixel: float | None,
    figure: Path | None,
    as_json: bool,
) -> None:
    """Tell how well photos of different focus can tell depth, before they are taken.

    The bound of all estimators that compare photos with one another and know nothing of the texture, on average over
    textures as most scenes have. An aperture, a pair of foci and an exposure can be chosen by it.

    \b
    Examples:
      lommel precision lens.toml --focus "1.5 m" --pair 0.1 --photons 1e4 --plot precision.png
      lommel precision lens.toml --focus "1.5 m" --best --f-number 4 --photons 5000
      lommel precision lens.toml --focus "1.35 m" --focus "1.8 m" --photons 1e4 --between "1.2 m" "2.5 m"
    """  # noqa: D301 (\b is meant)
    from lommel.estimation.depth_precision import best_foci, depth_precision
    from lommel.estimation.noise import Noise

    if figure is not None:
        figure_format(figure)
    instrument = instrument_of(lens, pixel=pixel)
    one = instrument.lens if f_number is None else instrument.lens.stopped(f_number)
    noise: Any = {"noise": Noise(read=read), "photons": photons, "contrast": contrast, "window": window}
    if (pair is not None) + best + (len(foci) > 1) != 1 or not foci:
        raise ValueError("give --focus twice or more, or --focus once with --pair or with --best")
    start = time.perf_counter()
    if best:
        lenses = list(best_foci(one, foci[0], instrument.side, **noise).lenses)
    elif pair is not None:
        lenses = _around(one, foci[0], pair)
    else:
        lenses = [one.focused(focus) for focus in foci]
    near, far = between or _range([each.focus_distance for each in lenses])
    if not 0.0 < near < far:
        raise ValueError(f"--between must be the nearest and the farthest distance, got {near:g} m and {far:g} m")
    distance = np.geomspace(near, far, _ROWS if figure is None else _POINTS)
    deviation = np.asarray(depth_precision(lenses, distance, instrument.side, **noise))
    seconds = time.perf_counter() - start
    rows = np.linspace(0, len(distance) - 1, _ROWS).round().astype(int)
    told = ", ".join(_length(each.focus_distance) for each in lenses)
    if figure is not None:
        from lommel.show import depth_maps

        title = f"{instrument.name}\nfocus {told} at f/{one.f_number:.3g}, {photons:g} electrons a pixel"
        save_figure(depth_maps.precision(distance, {"": deviation}, title).figure, figure)
    if as_json:
        print_json(
            {
                "focus_distances": [_finite(each.focus_distance) for each in lenses],
                "f_number": one.f_number,
                "distance": distance.tolist(),
                "deviation": [float(each) if math.isfinite(each) else None for each in deviation],
                "seconds": seconds,
                "files": [] if figure is None else [str(figure)],
            }
        )
        return
    from lommel.cli import tables

    click.echo(f"f = {format_length(one.focal_length)}, f/{one.f_number:.3g}, focus {told}")
    click.echo(
        f"pixels of {format_length(instrument.side)}, {photons:g} electrons, contrast {contrast:g}, windows of "
        f"{window:g} pixels rms"
    )
    tables.print_precision([(float(distance[k]), float(deviation[k])) for k in rows])
    if figure is not None:
        click.echo(f"wrote {figure}")


def _around(lens: Lens, focus: float, dioptres: float) -> list[Lens]:
    """Return two lenses, focused so many dioptres before and behind a distance."""
    vergence = [1.0 / focus + sign * dioptres for sign in (1.0, -1.0)]
    if not dioptres > 0.0 or vergence[1] < 0.0:
        raise ValueError(f"--pair must be > 0 and at most {1.0 / focus:.4g} dioptres, infinity, got {dioptres:g}")
    return [lens.focused(1.0 / each if each > 0.0 else math.inf) for each in vergence]


def _range(foci: list[float]) -> tuple[float, float]:
    """Return distances from a little nearer than the nearest focus to a little farther than the farthest."""
    near, far = min(foci), max(foci)
    return 0.85 * near, 1.2 * far if math.isfinite(far) else 4.0 * near
