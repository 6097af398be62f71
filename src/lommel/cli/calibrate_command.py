"""The command ``calibrate``: f-number and foci of a lens from photos of planes at known distances."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

from lommel import imaging
from lommel.base.encoding import Encoding
from lommel.base.options import Shown
from lommel.cli.command import ENCODING, OUTPUT, command
from lommel.cli.instruments import MaskedPhotoNoise, noise_of, radial_instrument
from lommel.cli.messages import report_findings
from lommel.cli.output import progress, require_file, written
from lommel.cli.photo_commands import PairCamera, apply_mask, each_lens, read_alike
from lommel.imaging.focal_engine import Magnified
from lommel.report import Report


@command
def calibrate(
    photos: list[Path],
    lens: Path,
    /,
    *,
    distances: Annotated[tuple[float, ...], Shown(("--distance",), length="m")],
    origin: Annotated[float | None, Shown(length="m")] = None,
    output: Annotated[Path | None, OUTPUT] = None,
    encoding: Annotated[Encoding | None, ENCODING] = None,
    cameras: PairCamera = PairCamera(),
    registration: Magnified = Magnified(),
    photo_noise: MaskedPhotoNoise = MaskedPhotoNoise(),
) -> Report:
    """Calibrate f-number and foci by planes at known distances.

    PHOTOS are two photos of each plane, with different focus or aperture, in the order of --distance: PNG, JPEG or
    TIFF files of one size, taken as for `lommel depth`. A plane is a flat textured surface, such as a newspaper on a
    wall, parallel to the sensor, that fills the frame. LENS is a lens file.

    One plane determines a shift of both foci. A second one, on the other side of a focus, adds the f-number, a third
    the difference of the foci.

    Parameters
    ----------
    distances
        Distance of a plane, such as 1.25m; repeat for each pair of photos.
    origin
        Point from which distances count, in front of the lens (its entrance pupil), such as 20mm for the front rim;
        negative for the sensor. By default 0 +- 20 mm, unless the planes determine it: 3 % of a distance of 0.6 m, as
        part of the errors.
    output
        Lens file with a section [calibration], which `lommel depth` and `lommel watch` use: .toml.
    encoding
        Encoding of the photos' values: srgb, linear, or a number, as 1.8 for light = value ** 1.8; by default as the
        photos state (ICC profile), else integers are sRGB; floats are linear.
    white
        Number of electrons at white, with which the misfit is judged; by default it is not.
    mask
        Image that is not 0 at pixels to ignore; one for all photos, or one for each of a pair.

    Examples
    --------
      lommel calibrate near-1.tif far-1.tif phone.toml --focus 0.5m --focus 2m --distance 0.6m --origin 20mm -o a.toml
    """
    require_file(output, ".toml")
    if len(photos) != 2 * len(distances):
        raise ValueError(f"photos must be two for each of {len(distances)} distances, got {len(photos)}")
    instrument = radial_instrument(lens, camera=cameras.camera, pixel=cameras.pixel)
    if instrument.calibration is not None:
        raise ValueError(f"{lens} has a section [calibration]: give the lens file before calibration")
    noise = None
    if photo_noise.white is not None:
        noise = noise_of(vars(photo_noise), instrument.camera, photographs=True)
    with progress("reading") as status:
        pictures = read_alike(photos, encoding)
        values = [picture.values for picture in pictures]
        pairs = [apply_mask(values[k : k + 2], photo_noise.mask) for k in range(0, len(values), 2)]
        status("fitting the lens")
        found = imaging.calibrate_focus(
            pairs,
            distances,
            each_lens(instrument, 2, cameras),
            instrument.side,
            encoding=pictures[0].encoding,
            noise=noise,
            origin=origin,
            magnification=registration.magnification,
        )
        if output is not None and found.converged:
            found.save(output, lens)
    notes = [f"{output} is not written: depth by this lens would be wrong"] if output and not found.converged else []
    report = report_findings(found.to_dict() | {"notes": notes}, *str(found).splitlines(), headed=False)
    return report + written([output] if found.converged else [])
