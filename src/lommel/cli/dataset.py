"""Data sets of ``lommel blur --batch``: folders of photos and depth maps, blurred by random lenses."""

from __future__ import annotations

import math
import time
from pathlib import Path
from typing import Any

import click

from lommel.base.units import format_length
from lommel.cli.depth_maps import depth_line, depth_values, finite
from lommel.cli.options import Option, documented, with_options
from lommel.cli.output import Facts, Report
from lommel.cli.progress import progress
from lommel.imaging.datasets import FORMATS, LensRanges, render_dataset
from lommel.imaging.settings import Settings
from lommel.recorded.noise import Noise

OPTIONS = [
    Option("--batch", is_flag=True,
           help="Blur all photos of the folder PHOTO by the depth maps of the same names in the folder DEPTH into "
           "the folder --output, with ground truth. LENS may have pairs in place of numbers, from which a lens is "
           "drawn for each picture. Again after an interruption, the command goes on. Files that cannot be used are "
           "reported and left out, with exit code 3."),
    Option("--seed", type=int, default=0, help="Seed of the lenses and of the noise."),
    documented(render_dataset, "copies", type=int),
    documented(render_dataset, "workers", type=int, help="Number of processes."),
    documented(render_dataset, "form", type=click.Choice(FORMATS),
               help="Format of the images: png has 16 bits and the encoding of the photo, the others are linear."),
    documented(render_dataset, "shard", type=int,
               help="Number of pictures in each tar file, as WebDataset reads them; by default a file each."),
    documented(render_dataset, "psfs", type=int,
               help="Number of PSFs stored of each picture, by which its pixels are indexed, or 0."),
    Option("--white", type=float, default=None, help="Electrons at white, such as 5000, for photon noise."),
    Option("--read", type=float, default=None, help="Read noise, rms electrons; needs --white."),
]  # fmt: skip
DEFAULTS = {option.name: option.default for option in OPTIONS[1:]}
"""Of the options that one photo does not take."""

_OF_ONE = {
    "bits": "--bits", "pixel_from_exif": "--pixel-from-exif", "no_exif": "--no-exif", "last": "--focus-to",
    "frames": "--frames", "fps": "--fps", "camera": "--camera",
}  # fmt: skip


def render(out: Path, given: Facts) -> Report:
    """Render a data set by the options of the command."""
    for name, flag in _OF_ONE.items():
        if given.pop(name):
            raise ValueError(f"{flag} is for one photo, without --batch")
    given.pop("quality")
    photos, depths = given.pop("photo"), given.pop("depth")
    lenses = _lenses(given)
    white, read = given.pop("white"), given.pop("read")
    if white is None and read is not None:
        raise ValueError("--read needs --white, the electrons at white")
    options: dict[str, Any] = {"noise": None if white is None else Noise(white=white, read=read or 0.0)}
    for name in ("seed", "copies", "workers", "form", "psfs", "shard", "encoding"):
        options[name] = given.pop(name)
    values: dict[str, Any] = {**depth_values(given)}
    options |= {"depth_scale": values.pop("scale"), "inverse_depth": values.pop("inverse"), **values}
    Settings(**given)
    start, made = time.perf_counter(), 0
    done = total = 0
    failed: list[Facts] = []
    seen: list[Facts] = []
    try:
        with progress("reading") as started:
            for picture in render_dataset(photos, depths, out, lenses, on_error="skip", **options, **given):
                done, total = picture.done, picture.total
                if picture.failure is None:
                    made += 1
                    seen.append(picture.facts)
                    started(f"picture {done} of {total}", done / total)
                    continue
                reason = with_options(picture.failure)
                if reason not in [before["reason"] for before in failed]:  # of another copy
                    click.echo(f"Left out: {reason}", err=True)
                failed.append({"number": picture.number, **picture.facts, "reason": reason})
    except KeyboardInterrupt:
        there = f"{done} of {total} pictures are there" if made else "no picture was finished"
        click.echo(f"Interrupted: {there}; the same command goes on.", err=True)
        raise
    seconds = time.perf_counter() - start
    if failed and not done:
        raise ValueError(f"no picture could be rendered: {failed[0]['reason']}")
    facts = {"output": str(out), "rendered": made, "seconds": seconds, "failed": failed}
    said = f"{made} pictures rendered in {seconds:.3g} s" if made or failed else "all pictures were there"
    lines = [said, f"folder {out}"]
    if seen:
        shares = [each["depth_unknown"] for each in seen]
        ends = [float(end) for each in seen for end in each["depth_range"]] or [math.nan]
        foci = [float(each["focus_distance"]) for each in seen]
        focus = " to ".join(map(format_length, dict.fromkeys((min(foci), max(foci)))))
        share = sum(shares) / len(shares)
        facts |= {"depth": [finite(min(ends)), finite(max(ends))], "depth_unknown": share}
        lines.insert(0, depth_line(min(ends), max(ends), share, f"focus {focus}"))
    if failed:
        lines.append(f"{len(failed)} of {total} pictures left out; mend their files and give the same command again")
    return Report(facts, lines, converged=not failed)


def _lenses(given: Facts) -> LensRanges:
    """Return the lenses of a file, with what options say instead, or of the options."""
    from lommel.lensfiles.lens_ranges import load_lens_ranges

    own = {
        "focal_length": given.pop("focal_length"),
        "f_number": given.pop("f_number"),
        "focus_distance": given.pop("focus"),
        "pixel": given.pop("pixel"),
    }
    file = given.pop("lens")
    known = {name: value for name, value in own.items() if value is not None}
    if file is not None:
        return LensRanges(**{**vars(load_lens_ranges(file)), **known})
    if missing := [f"--{name.replace('_distance', '').replace('_', '-')}" for name in own if name not in known]:
        raise ValueError(f"give a lens file or {', '.join(missing)}")
    return LensRanges(**known)
