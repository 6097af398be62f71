"""The commands ``lommel depth`` (depth from defocus) and ``lommel precision`` (its Cramér-Rao bound)."""

from __future__ import annotations

import math
import time
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

import numpy as np

from lommel.base.arrays import plain
from lommel.base.encoding import to_light
from lommel.base.options import In, Shown
from lommel.cli.command import OUTPUT, PLOT, command, filled
from lommel.cli.instruments import MaskedPhotoNoise, Sensor, instrument_of, noise_of, radial_instrument
from lommel.cli.messages import with_options
from lommel.cli.output import progress, save_figure, written
from lommel.cli.photo_commands import apply_mask, output_type, read_as
from lommel.estimation.depth_precision import CONTRAST, WINDOW, best_depth_foci, depth_precision
from lommel.imaging import DefocusOptions, depth_from_defocus, read_photo, write_depth, write_photo
from lommel.io import photos as photo_files
from lommel.io.registry import suffixes
from lommel.lensfiles.instrument import Instrument
from lommel.recorded.noise import Noise
from lommel.report import Facts, Report, finite
from lommel.report.table import described, records_of, told
from lommel.show.drawing import figure_of

if TYPE_CHECKING:
    from lommel.imaging.defocus_depth import DefocusDepth
    from lommel.imaging.defocus_verdict import DefocusVerdict
    from lommel.io.photos import Photograph
    from lommel.optics.lens import Lens

_READ = 3.0  # default read noise, rms electrons, without a camera
_ROWS, _POINTS = 11, 121  # numbers of distances in the table and in the figure


BETWEEN = Shown(length="m", metavar="NEAR FAR")
"""Form of the nearest and the farthest distance."""


@dataclass(frozen=True, kw_only=True)
class PairCamera(Sensor):
    """Lens settings and camera of images that differ in focus or aperture.

    Parameters
    ----------
    foci
        Focus distance from the lens, not from the sensor, such as 1.35m: once for all images, or repeated for each;
        overrides the lens file.
    f_numbers
        F-number: once for all images, or repeated for each; overrides the lens file.
    """

    foci: Annotated[tuple[float, ...], Shown(("--focus",), length="m")] = ()
    f_numbers: Annotated[tuple[float, ...], Shown(("--f-number",))] = ()

    def instrument(self, lens: Path) -> Instrument:
        """Return the instrument of a lens file with this camera and pixel pitch."""
        return radial_instrument(lens, "depth from defocus", camera=self.camera, pixel=self.pixel)


def each_lens(
    lens: Lens, count: int, foci: tuple[float, ...], f_numbers: tuple[float, ...], images: str = "photos"
) -> list[Lens]:
    """Return the lens of each photo."""
    for name, numbers in (("--focus", foci), ("--f-number", f_numbers)):
        if len(numbers) not in (0, 1, count):
            raise ValueError(f"{name} must be given once, or for each of {count} {images}, got {len(numbers)}")
    if count < 2:
        raise ValueError("PHOTOS must be two or more: in a single photo blur looks like smooth texture; got 1")
    lenses = [lens.stopped(stop) for stop in f_numbers] or [lens]
    lenses *= count // len(lenses)
    if foci:
        lenses = [copy.focused(focus) for copy, focus in zip(lenses, foci * (count // len(foci)), strict=True)]
    return lenses


def lens_facts(lenses: list[Lens]) -> Facts:
    """Return focus distances and f-numbers of several frames."""
    return {
        "focus_distances": [finite(lens.focus_distance) for lens in lenses],
        "f_numbers": [lens.f_number for lens in lenses],
        "focal_length": lenses[0].focal_length,
    }


def verdict_report(verdict: DefocusVerdict) -> Report:
    """Return the report of the test of lenses and noise, and of the parts that could not be tested."""
    untested_finding = verdict.findings.get("untested")
    facts = verdict.to_dict()
    del facts["misfit"]  # commands report their own misfit
    facts |= {"agrees": verdict.agrees, "untested": untested_finding and untested_finding.numbers["what"]}
    lines = [] if math.isnan(verdict.misfit) else [verdict.summary]
    lines += [finding.text for finding in verdict.findings]
    return Report(facts, [*map(with_options, lines)], verdict.converged)


@command
@filled(depths=suffixes("depth map"), photos=suffixes("photo"))
def depth(
    photos: list[Path],
    lens: Path,
    /,
    *,
    between: Annotated[tuple[float, float], BETWEEN],
    outputs: Annotated[tuple[Path, ...], OUTPUT] = (),
    sharp: Annotated[Path | None, Shown(metavar="FILE", writes=True)] = None,
    figure: Annotated[Path | None, PLOT] = None,
    encoding: Literal["srgb", "linear"] | None = None,
    cameras: PairCamera = PairCamera(),
    options: DefocusOptions = DefocusOptions(),
    photo_noise: MaskedPhotoNoise = MaskedPhotoNoise(),
) -> Report:
    """Estimate a depth map from photos (depth from defocus).

    PHOTOS are two or more PNG, JPEG or TIFF files of one size, taken from the same place with different focus or
    aperture, neither denoised nor sharpened. LENS is a lens file. Areas without texture have no depth: NaN, with an
    infinite standard error.

    Parameters
    ----------
    between
        Nearest and farthest distance to search, such as 1m 3m or 1m inf.
    outputs
        Depth map in metres; given a second time, its standard error: {depths}.
    sharp
        All-in-focus image, encoded as PHOTOS: {photos}.
    figure
        Figure of depth map, standard error and all-in-focus image: .png, .pdf or .svg.
    encoding
        Encoding of the photos' values; by default integers are sRGB and floats are linear.
    mask
        Image that is not 0 at pixels to ignore; one for all photos, or one for each.

    Examples
    --------
      lommel depth near.tif far.tif phone.toml --focus 1.3m --focus 2m --between 1m 3m --white 5000 --read 3 -o d.tif
    """
    if len(outputs) > 2:
        raise ValueError(f"--output takes the depth map and its standard error, got {len(outputs)} files")
    for path in outputs:
        photo_files.find_depth(path, "--output")
    if sharp is not None:
        photo_files.find(sharp, "--sharp")
    instrument = cameras.instrument(lens)
    noise = noise_of(vars(photo_noise), instrument.camera, photographs=True)
    lenses = each_lens(instrument.lens, len(photos), cameras.foci, cameras.f_numbers)
    with progress("reading") as status:
        pictures = [read_photo(path, encoding) for path in photos]
        if len({(picture.values.dtype, picture.encoding) for picture in pictures}) > 1:
            raise ValueError("the photos must have one type and one encoding; give --encoding or convert them")
        images = apply_mask([picture.values for picture in pictures], photo_noise.mask)
        status("computing the PSFs of every distance")
        start = time.perf_counter()
        estimate = depth_from_defocus(
            images,
            lenses,
            instrument.side,
            encoding=pictures[0].encoding,
            noise=noise,
            between=between,
            progress=lambda finished, tiles: status(f"tile {finished} of {tiles}", finished / tiles),
            options=options,
        )
        seconds = time.perf_counter() - start
        status("comparing the blur with the blur of other apertures")
        estimate.verdict  # noqa: B018 (computed here, and kept)
        for path, values in zip(outputs, (estimate.depth, estimate.errors), strict=False):
            write_depth(path, values)
        if sharp is not None:
            _write_sharp(sharp, estimate, pictures[0])
        if figure is not None:
            save_figure(estimate.plot(), figure)
    facts = estimate.to_dict() | lens_facts(lenses) | {"seconds": seconds, "pixel": instrument.side}
    facts["read"] = read_as(pictures[0], encoding)
    none = "no depth found: the photos have no texture, or all of it is out of range"
    text = [none] if facts["depth"] is None else []
    return told(facts) + Report({}, text) + verdict_report(estimate.verdict) + written([*outputs, sharp, figure])


def _write_sharp(path: Path, estimate: DefocusDepth, photo: Photograph) -> None:
    """Write the all-in-focus image in the type and encoding of `photo` if the format can store them."""
    image = to_light("sharp", estimate.sharp, estimate.encoding, np.float32)
    dtype, encoding = output_type(photo, path)
    write_photo(path, image, encoding=encoding, dtype=dtype)


@command
def precision(
    lens: Path,
    /,
    *,
    foci: Annotated[tuple[float, ...], Shown(("--focus",), length="m")],
    photons: Annotated[float, In(above=0.0)],
    pair: float | None = None,
    best: bool = False,
    f_number: float | None = None,
    between: Annotated[tuple[float, float] | None, BETWEEN] = None,
    read: float | None = None,
    figure: Annotated[Path | None, PLOT] = None,
    sensor: Sensor = Sensor(),
) -> Report:
    """Compute the achievable depth precision (Cramer-Rao bound).

    The bound is the least standard error of the distance of a textured surface, estimated from photos with
    different focus. It assumes a random texture with the power spectrum of natural scenes, and holds for every
    unbiased estimator without knowledge of the texture; strong edges allow better precision. Use it to choose
    aperture, focus distances and exposure before taking the photos.

    Parameters
    ----------
    foci
        Focus distance, such as 1.5m; repeat for each photo (two or more), or give once with --pair or --best.
    photons
        Mean signal per pixel, in detected photons (electrons).
    pair
        Two photos, one focused this many dioptres (1/m) nearer than --focus, the other that many farther.
    best
        Find the two focus distances that give the best precision for a surface at --focus.
    f_number
        F-number; overrides the lens file.
    between
        Nearest and farthest distance to list; by default around the focus distances.
    read
        Read noise, rms electrons; by default from the camera, or 3.
    figure
        Figure of the standard error against the distance: .png, .pdf or .svg.

    Examples
    --------
      lommel precision phone.toml --focus 1.5m --pair 0.1 --photons 1e4 --plot precision.png
      lommel precision nifty-fifty.toml --focus 1.5m --best --f-number 4 --photons 5000
      lommel precision phone.toml --focus 1.35m --focus 1.8m --photons 1e4 --between 1.2m 2.5m
    """
    if (pair is not None) + best + (len(foci) > 1) != 1:
        raise ValueError("give --focus twice or more, or --focus once with --pair or with --best")
    instrument = instrument_of(lens, **vars(sensor))
    if read is None:
        read = _READ if instrument.camera is None or instrument.camera.read is None else instrument.camera.read
    lens_in_use = instrument.lens if f_number is None else instrument.lens.stopped(f_number)
    noise = Noise(white=photons, read=read)
    start = time.perf_counter()
    if best:
        lenses = list(best_depth_foci(lens_in_use, foci[0], instrument.side, noise=noise))
    elif pair is not None:
        lenses = _lens_pair(lens_in_use, foci[0], pair)
    else:
        lenses = [lens_in_use.focused(focus) for focus in foci]
    nearest, *_, farthest = sorted(photo.focus_distance for photo in lenses)
    # The default range is from a little nearer than the nearest focus to a little farther than the farthest.
    near, far = between or (0.85 * nearest, 1.2 * farthest if math.isfinite(farthest) else 4.0 * nearest)
    if not 0.0 < near < far:
        raise ValueError(f"--between must be the nearest and the farthest distance, got {near:g} m and {far:g} m")
    distance = np.geomspace(near, far, _ROWS if figure is None else _POINTS)
    errors = np.asarray(depth_precision(lenses, distance, instrument.side, noise=noise))
    seconds = time.perf_counter() - start
    if figure is not None:
        from lommel.show import estimates

        title = f"{instrument.name}\nf/{lens_in_use.f_number:.3g}, {photons:g} electrons a pixel"
        axes = estimates.precision(distance, {"": errors}, title, [photo.focus_distance for photo in lenses])
        save_figure(figure_of(axes), figure)
    facts = {
        "focus_distances": [finite(photo.focus_distance) for photo in lenses],
        "f_number": lens_in_use.f_number,
        "distance": distance.tolist(),
        "errors": plain(errors),
        "seconds": seconds,
    }
    rows = [
        {"distance": float(distance[k]), "standard_error": float(errors[k])}
        for k in np.linspace(0, len(distance) - 1, _ROWS).round().astype(int)
    ]
    setting = {name: facts[name] for name in ("focus_distances", "f_number", "seconds")} | {"pixel": instrument.side}
    setting |= {"electrons": photons, "contrast": CONTRAST, "window_rms": WINDOW}
    return Report(facts, [*described(setting), "", records_of("", rows)]) + written([figure])


def _lens_pair(lens: Lens, focus: float, dioptres: float) -> list[Lens]:
    """Return two lenses, one focused `dioptres` nearer and one focused `dioptres` farther than a distance."""
    vergence = [1.0 / focus + sign * dioptres for sign in (1.0, -1.0)]
    if not dioptres > 0.0 or vergence[1] < 0.0:
        raise ValueError(
            f"--pair must be > 0 and at most {1.0 / focus:.4g} dioptres (focus at infinity), got {dioptres:g}"
        )
    return [lens.focused(1.0 / v if v > 0.0 else math.inf) for v in vergence]
