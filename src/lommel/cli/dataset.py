"""Data sets of ``lommel blur --batch``: folders of photos and depth maps, blurred by random lenses."""

from __future__ import annotations

import math
import time
from pathlib import Path
from typing import TYPE_CHECKING

import click

from lommel.base.units import format_length
from lommel.cli.depth_maps import depth_line, finite
from lommel.cli.options import Group, documented, option, with_options
from lommel.cli.output import Facts, Report
from lommel.cli.progress import progress
from lommel.imaging.datasets import FORMATS, LensRanges, render_dataset
from lommel.imaging.settings import Settings
from lommel.recorded.noise import Noise

if TYPE_CHECKING:
    from lommel.cli.photo_commands import PhotoOptions


class DataSet(Group, heading="Data set"):
    """A data set in place of one photograph."""

    # fmt: off
    batch: bool = option(is_flag=True,
        help="Blur all photos of the folder PHOTO by the depth maps of the same names in the folder DEPTH into the "
        "folder --output, with ground truth. LENS may have pairs in place of numbers, from which a lens is drawn for "
        "each picture. Again after an interruption, the command goes on. Files that cannot be used are reported and "
        "left out, with exit code 3.")
    seed: int = option(type=int, default=0, help="Seed of the lenses and of the noise.")
    copies: int = documented(render_dataset, "copies", type=int)
    workers: int = documented(render_dataset, "workers", type=int, help="Number of processes.")
    form: str = documented(render_dataset, "form", type=click.Choice(FORMATS),
        help="Format of the images: png has 16 bits and the encoding of the photo, the others are linear.")
    shard: int | None = documented(render_dataset, "shard", type=int,
        help="Number of pictures in each tar file, as WebDataset reads them; by default a file each.")
    psfs: int = documented(render_dataset, "psfs", type=int,
        help="Number of PSFs stored of each picture, by which its pixels are indexed, or 0.")
    white: float | None = option(type=float, default=None, help="Electrons at white, such as 5000, for photon noise.")
    read: float | None = option(type=float, default=None, help="Read noise, rms electrons; needs --white.")
    # fmt: on

    def arguments(self) -> Facts:
        """Return the arguments of :func:`lommel.imaging.render_dataset`."""
        given = vars(self).copy()
        white, read = given.pop("white"), given.pop("read")
        if white is None and read is not None:
            raise ValueError("--read needs --white, the electrons at white")
        del given["batch"]
        return given | {"noise": None if white is None else Noise(white=white, read=read or 0.0)}


_OF_ONE = {
    "bits": "--bits", "pixel_from_exif": "--pixel-from-exif", "no_exif": "--no-exif", "last": "--focus-to",
    "frames": "--frames", "fps": "--fps", "camera": "--camera",
}  # fmt: skip


def render(
    out: Path,
    files: tuple[Path, Path, Path | None],
    focus: float | None,
    pull: Facts,
    data: DataSet,
    options: PhotoOptions,
) -> Report:
    """Render a data set of photos and depth maps in folders, and of the lenses of a file, into a folder."""
    photos, depths, lens = files
    stated = vars(options.made) | vars(options.seen) | pull
    for name, flag in _OF_ONE.items():
        if stated[name]:
            raise ValueError(f"{flag} is for one photo, without --batch")
    lenses = _lenses(lens, stated | {"focus_distance": focus})
    given = data.arguments() | {"encoding": options.encoding}
    values: Facts = {**options.depth_values}
    given |= {"depth_scale": values.pop("scale"), "inverse_depth": values.pop("inverse"), **values}
    Settings(**options.settings)
    given |= options.settings
    start, made = time.perf_counter(), 0
    done = total = 0
    failed: list[Facts] = []
    seen: list[Facts] = []
    try:
        with progress("reading") as started:
            for picture in render_dataset(photos, depths, out, lenses, on_error="skip", **given):
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
        between = " to ".join(map(format_length, dict.fromkeys((min(foci), max(foci)))))
        share = sum(shares) / len(shares)
        facts |= {"depth": [finite(min(ends)), finite(max(ends))], "depth_unknown": share}
        lines.insert(0, depth_line(min(ends), max(ends), share, f"focus {between}"))
    if failed:
        lines.append(f"{len(failed)} of {total} pictures left out; mend their files and give the same command again")
    return Report(facts, lines, converged=not failed)


def _lenses(file: Path | None, stated: Facts) -> LensRanges:
    """Return the lenses of a file, with what options say instead, or of the options."""
    from lommel.lensfiles.lens_ranges import load_lens_ranges

    own = {name: stated[name] for name in ("focal_length", "f_number", "focus_distance", "pixel")}
    known = {name: value for name, value in own.items() if value is not None}
    if file is not None:
        return LensRanges(**{**vars(load_lens_ranges(file)), **known})
    if missing := [f"--{name.replace('_distance', '').replace('_', '-')}" for name in own if name not in known]:
        raise ValueError(f"give a lens file or {', '.join(missing)}")
    return LensRanges(**known)
