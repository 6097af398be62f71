"""PSFs as OME-TIFF: all values, the pixel size, and the description."""

from __future__ import annotations

import json
from functools import partial

from lommel.base import atomic, reading
from lommel.base.checksums import sealed
from lommel.io import metadata
from lommel.io.registry import Arrays, Description
from lommel.measures.psf_like import PSFLike
from lommel.optics.layers.objective_pupil import ObjectivePupil


def write(psf: PSFLike, description: Description, planes: Description | None = None) -> bytes:
    """Return an OME-TIFF; `planes` are OME attributes of its pages, which are then no stack in depth."""
    import tifffile

    metric, pupil = psf.unit == "m", psf.pupil
    height, width = (side * (1e6 if metric else 1.0) for side in psf.grid.pitch)
    if isinstance(pupil, ObjectivePupil):
        description = description | metadata.note(pupil)
    unit = "µm" if metric else "reference frame"
    fields: Description = {
        "axes": "YX" if psf.values.ndim == 2 else "RYX" if planes else "ZYX",
        "PhysicalSizeX": width,
        "PhysicalSizeXUnit": unit,
        "PhysicalSizeY": height,
        "PhysicalSizeYUnit": unit,
        "Name": "point spread function",
        "Description": json.dumps(sealed(description, {"values": psf.values}), allow_nan=False),
    }
    if planes:
        fields["Plane"] = planes
    values = psf.values if psf.values.ndim == 2 else psf.values.reshape(-1, *psf.shape[-2:])
    write = partial(tifffile.imwrite, photometric="minisblack")
    if not isinstance(pupil, ObjectivePupil):
        return atomic.contents(write, values, ome=True, metadata=fields)
    made, pages = tifffile.OmeXml(), (pupil.focus.size, 1, 1, psf.shape[-2], psf.shape[-1], 1)
    made.addimage(values.dtype, values.shape, pages, **fields | metadata.ome_image(psf, pupil))
    xml = metadata.with_objective(made.tostring(declaration=True), pupil)
    return atomic.contents(write, values, description=xml.encode(), metadata=None)


def read(data: bytes) -> tuple[Arrays, str]:
    """Return the values and the description."""
    from xml.etree import ElementTree as ET

    # Python builds an object for every element.
    reading.afford(512 * data.count(b"<"), len(data), 10)
    with reading.tiff(data) as file:
        if not file.ome_metadata:
            raise ValueError("no OME description")
        description = ET.fromstring(file.ome_metadata).find(".//{*}Image/{*}Description")
        if description is None or not description.text:
            raise ValueError("no description of how it was made")
        if file.series[0].nbytes > len(data):
            raise ValueError(f"its pages have {file.series[0].nbytes} bytes, more than the file")
        return {"values": file.asarray()}, description.text
