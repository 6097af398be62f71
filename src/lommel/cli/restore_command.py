"""The command that undoes the blur of a photograph: ``lommel restore``."""

from __future__ import annotations

import time
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click
import numpy as np

from lommel.base.units import format_length
from lommel.cli.parts import FILE, Length, one_line_errors, print_json
from lommel.cli.photo_commands import finite, photo_command, terminated_as_interrupted
from lommel.cli.photo_job import Request
from lommel.cli.progress import progress
from lommel.io.photos import find, write_photo

if TYPE_CHECKING:
    from lommel.imaging.restoration import Restoration

_METHODS = ("richardson-lucy", "total-variation")


@click.command()
@photo_command
@click.option("-o", "--output", required=True, type=FILE, help=".png, .jpg or .tif.")
@click.option("--focus", type=Length(), help='Distance in focus: "1.5 m", "inf"; instead of the lens file\'s.')
@click.option("--white", type=float, required=True, help="Electrons of a pixel that is white.")
@click.option("--read", type=float, required=True, help="Noise of reading a pixel, rms electrons.")
@click.option(
    "--offset", type=float, default=0.0, show_default=True, help="Light of a pixel that counted none; white is 1."
)
@click.option("--saturation", type=float, help="Light from which on pixels are full, below white, which is 1.")
@click.option(
    "--method",
    type=click.Choice(_METHODS),
    default=_METHODS[0],
    show_default=True,
    help="Likelihood alone, or edges kept and the rest smooth: better, in ten times the time.",
)
@click.option("--steps", type=int, help="At most so many; by default 200, or 150 for each strength that is tried.")
@click.option("--target", type=float, default=0.9, show_default=True, help="Discrepancy at which to stop.")
@click.option("--strength", type=float, help="Of the total variation, instead of what the noise asks for.")
@one_line_errors
def restore(
    output: Path,
    focus: float | None,
    white: float,
    read: float,
    offset: float,
    saturation: float | None,
    method: str,
    steps: int | None,
    target: float,
    strength: float | None,
    as_json: bool,
    **options: Any,
) -> None:
    """Undo the blur of a photograph whose depth and lens are known, as far as its noise lets it.

    PHOTO is PNG, JPEG or TIFF, grey or RGB, neither sharpened nor freed of noise. DEPTH has the distance of each of
    its points from the lens, in metres: a grey TIFF, NPY, PFM or PNG of the same size. LENS is a lens file; without
    it, focal length and f-number are the options', or those of the photo's EXIF.

    The discrepancy compares what the lens would make of the result with the photograph: about 1 where they differ by
    the noise alone. One that stays above shows that depth, lens or noise do not fit.

    \b
    Examples:
      lommel restore photo.jpg depth.tif lens.toml --white 5000 --read 3 -o sharp.jpg
      lommel restore photo.jpg depth.tif lens.toml --white 5000 --read 3 --method total-variation -o sharp.png
    """  # noqa: D301 (\b is meant)
    from lommel.estimation.noise import Noise
    from lommel.imaging.restoration import restore as restored

    request = Request.of(options)
    find(output, "--output")
    noise = Noise(white=white, read=read, offset=offset)
    way = _method(method, steps, target, strength)
    with terminated_as_interrupted(), progress("reading") as started:
        job = request.job(output)
        find(output, "--output", holding=f"of {job.dtype}")
        lens = job.lens(focus, "--focus")
        started("preparing the blur")
        start = time.perf_counter()
        found = restored(
            job.picture.values,
            job.depth,
            lens,
            job.pixel,
            encoding=job.picture.encoding,
            noise=noise,
            method=way,
            saturation=saturation,
            progress=lambda step, discrepancy, left: started(
                f"step {step}, discrepancy {discrepancy:.3g}", _share(time.perf_counter() - start, left)
            ),
            **vars(request.settings),
        )
        seconds = time.perf_counter() - start
        same = job.encoding == job.picture.encoding
        clipped = write_photo(
            output,
            np.asarray(found.light),
            encoding=job.encoding,
            dtype=job.dtype,
            quality=request.quality,
            profile=job.picture.profile if same else None,
        )
    facts = job.facts(lens) | {"focus_distance": finite(lens.focus_distance), "seconds": seconds}
    _tell(facts | _outcome(found, method) | {"clipped": clipped, "files": [str(output)]}, as_json)


def _method(name: str, steps: int | None, target: float, strength: float | None) -> Any:
    """Return the method that the options describe."""
    from lommel.imaging import RichardsonLucy, TotalVariation

    given: dict[str, Any] = {"target": target} | ({} if steps is None else {"steps": steps})
    if name == _METHODS[1]:
        return TotalVariation(strength=strength, **given)
    if strength is not None:
        raise ValueError(f"--strength has a meaning with --method {_METHODS[1]} only")
    return RichardsonLucy(**given)


def _outcome(found: Restoration, method: str) -> dict[str, Any]:
    return {
        "method": method,
        "discrepancy": {"photo": found.before, "result": found.discrepancy, "by_channel": list(found.by_channel)},
        "steps": found.steps,
        "stopped": found.stopped,
        "strength": found.strength,
        "unknown": found.unknown,
    }


def _tell(facts: dict[str, Any], as_json: bool) -> None:
    if as_json:
        print_json(facts)
        return
    click.echo(facts["read"])
    height, width, *_ = facts["shape"]
    click.echo(
        f"{width} x {height} pixels of {format_length(facts['pixel'])}; "
        f"f = {format_length(facts['focal_length'])}, f/{facts['f_number']:.3g}"
    )
    values = facts["discrepancy"]
    click.echo(f"discrepancy {values['photo']:.3g} of the photo, {values['result']:.3g} of the result")
    if facts["strength"] is not None:
        click.echo(f"strength of the total variation {facts['strength']:.3g}")
    why = {"noise": "the rest is noise", "steps": "as many as allowed; it fits no better yet"}
    reason = facts["stopped"]
    click.echo(f"stopped after {facts['steps']} steps: {why.get(reason, reason)}")
    for name, text in (("unknown", "saturated or unknown"), ("clipped", "clipped at white")):
        if facts[name]:
            click.echo(f"{text}: {100.0 * facts[name]:.2g} % of the values")
    for name in facts["files"]:
        click.echo(f"wrote {name}")


def _share(spent: float, left: float) -> float:
    """Return how much of the work is done."""
    return spent / max(spent + left, 1e-9)
