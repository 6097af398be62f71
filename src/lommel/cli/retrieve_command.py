"""The command ``lommel retrieve``: phase retrieval, the wavefront from star images."""

from __future__ import annotations

import errno
from dataclasses import replace
from pathlib import Path
from typing import Annotated

from lommel.cli.command import OUTPUT, PLOT, command
from lommel.cli.instruments import CameraNoise
from lommel.cli.messages import report_findings
from lommel.cli.output import progress, save_figure, written
from lommel.estimation import EFFORT
from lommel.estimation.options import RetrieveOptions
from lommel.report import Report, Wrapped
from lommel.report.table import tables


@command
def retrieve(
    images: list[Path],
    lens: Path,
    /,
    *,
    options: RetrieveOptions = RetrieveOptions(),
    blur: bool = False,
    output: Annotated[Path | None, OUTPUT] = None,
    figure: Annotated[Path | None, PLOT] = None,
    camera: CameraNoise = CameraNoise(),
) -> Report:
    """Estimate a wavefront from star images (phase retrieval).

    IMAGES, of a star or another point source, are TIFF (one image per page), OME-Zarr, NPY, FITS (file.fits[SCI]
    selects one of several images) or 16-bit PNG files of one size, linear in light (no JPEG, no sRGB). LENS is a lens
    file with aperture, wavelength, f-number and pixel pitch; its wavefront is the starting point. Several images need
    the --defocus of each (phase diversity). One image leaves the common sign of the even terms (total defocus,
    astigmatism, spherical) undetermined: the solution nearer to the starting point is returned, or the solution whose
    first even term is positive if both are equally near.

    Coefficients are of Zernike terms in Noll's order, normalised to unit rms, in radians with standard errors;
    defocus and spherical by name are C_d and C_s. The reduced chi-squared (chi2) is about 1 where pupil, pixel pitch
    and noise are right. The exit code is 3 for a misfit, and 4 for a result in doubt.

    Parameters
    ----------
    terms
        Number of Zernike terms from defocus on (Noll 4, 5, ...), or names: "defocus, spherical", "noll 5, noll 6", or
        as printed, "coma x, coma y".
    defocus
        Known defocus C_d of each image in radians, such as -4 0 4, or one for all; of a single image 0 by default.
        Positive where the sensor was moved towards the lens. The phase is 2 C_d rho^2, rho = 1 at the edge of the
        pupil, so that one wave of defocus is C_d = pi.
    also
        Nuisance parameters to estimate jointly: "center, f_number, wavelength, obscuration", or none.
    blur
        Estimate blur by seeing and a Gaussian (jitter, charge diffusion) in each image, for telescopes on the ground.
    output
        Wavefront as Zernike coefficients in Noll's order: .json, .toml or .csv.
    figure
        Figure of images, model, residuals and terms: .png, .pdf or .svg.

    Examples
    --------
      lommel retrieve star-*.tif phone.toml --defocus -4 0 4 --read 2 -o wave.json --plot fit.png
      lommel retrieve star-1.tif star-2.tif phone.toml --defocus 0 4 --terms "defocus, spherical" --read 2
    """
    from lommel.cli.fit_field_command import blurs_in_words
    from lommel.estimation.phase_retrieval import fit_stars
    from lommel.estimation.star_images import label
    from lommel.io import zernike_tables
    from lommel.recorded.counts import Counts
    from lommel.recorded.frames import read_images

    if output is not None:
        zernike_tables.find(output, "--output")
    instrument = camera.instrument(lens)
    with progress("reading") as status:
        read = read_images(_files(images))
        noise, saturation, header = camera.resolve(read.metadata, instrument.camera)
        stars = read[...]
        if not options.defocus and len(stars) > 1:
            raise ValueError(f"--defocus must be given for {len(stars)} images: one number for each, such as -4 0 4")
        status("fitting")
        result = fit_stars(
            Counts.of(stars, noise=noise, mask=camera.mask_of(stars), saturation=saturation),
            instrument.pupil(),
            pixel=instrument.side,
            noise=None,
            options=replace(
                options,
                blur=blur,
                progress=lambda share, chi2: status(
                    f"start {int(EFFORT.starts * share) + 1} of at most {EFFORT.starts}, chi2 {chi2:.3g}", share
                ),
            ),
            effort=EFFORT._replace(integrate=instrument.integrate),
        )
    if output is not None:
        result.save(output)
    if figure is not None:
        save_figure(result.plot(names=list(read.names)), figure)
    files = written([output, figure], lambda path: ": square roots of images and model" if path == figure else "")
    facts = {"images": list(read.names)} | result.to_dict() | {"notes": [*read.notes, *header]}
    row, column = result.center.T.tolist()
    titles = dict(zip(facts["coefficients"], map(label, result.coefficients), strict=True))
    blurs = blurs_in_words(result, instrument.side, None)
    shown = tables(facts | {"row": row, "column": column}, titles)
    verdict = Wrapped(facts["message"].partition("; ")[0], "bold")
    return report_findings(facts, verdict, "", *shown, *blurs, "") + files


def _files(paths: list[Path]) -> list[Path]:
    """Return the files; patterns that the shell has not expanded are expanded in the order of names."""
    from lommel.recorded.frames import part_of

    files: list[Path] = []
    for path in paths:
        if path.exists() or part_of(path)[1] is not None or not set("*?[") & set(path.name):
            files.append(path)
        elif matches := sorted(path.parent.glob(path.name)):
            files += matches
        else:
            raise FileNotFoundError(errno.ENOENT, "No file matches", str(path))
    return files
