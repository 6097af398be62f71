"""The section [aberrations.zernike] of lens and microscope files."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from lommel.base import validation
from lommel.io import text_files, zernike_tables
from lommel.io.zernike_tables import ZernikeTable
from lommel.lensfiles.toml_files import Context, Toml, read_beside
from lommel.optics.wavefront.wavefront import Wavefront


def read(raw: Toml, text: str, context: Context) -> tuple[ZernikeTable | None, list[str]]:
    """Return the table of [aberrations.zernike], if there is one, and its errors."""
    above = raw.get("aberrations")
    section = above.get("zernike") if isinstance(above, dict) else None
    if not isinstance(section, dict):
        return None, []  # absent, or an error that pydantic reports

    def where(keys: Sequence[str]) -> str:
        return text_files.place(text, ["aberrations", "zernike", *keys])

    if "file" not in section:
        return zernike_tables.build_section(section, where)
    try:
        if others := [key for key in section if key != "file"]:
            raise ValueError(f"the file states everything; leave out {', '.join(others)}")
        table = read_beside(context, section["file"], "the path of a table", zernike_tables.load_zernike)
        if table.wavelength is None and table.unit in ("radians", "waves"):
            raise ValueError(f"{validation.line(section['file'])}: must state the wavelength of its {table.unit}")
        return table, []
    except ValueError as error:
        # One line for each error of the table.
        return None, [f"{where(['file'])}: {'; '.join(part.strip() for part in str(error).splitlines())}"]


def wavefront(table: ZernikeTable, wavelength: float) -> Wavefront:
    """Return the wavefront of a table at a wavelength, which its waves and radians refer to unless it has its own."""
    own = wavelength if table.wavelength is None else table.wavelength
    return replace(table, wavelength=own).wavefront(wavelength)
