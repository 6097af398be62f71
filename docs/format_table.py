"""The table of file formats for the page of formats, from the registry."""

from __future__ import annotations

from pathlib import Path

from lommel.io import colour_files, depthmaps, field_files, opd_files, photos, psf_files, registry, zernike_tables

# What a file holds, and what writes and reads it.
CONTENTS = {
    psf_files: ("psf", "a PSF or a stack", "`psf.save`", "`PSF.load`"),
    colour_files: ("colours", "[a PSF in colour channels](colour.md)", "`psf.save`", "`ColourPSF.load`"),
    field_files: ("field", "[a grid of PSFs over the field](field.md)", "`grid.save`", "`PSFGrid.load`"),
    opd_files: ("opd", "an OPD map", "`lm.save_opd`", "`lm.load_opd`"),
    zernike_tables: ("zernike", "Zernike coefficients", "`wavefront.save`", "`lm.load_zernike`, lens files"),
    photos: ("photo", "a photograph", "`lm.imaging.write_photo`", "`lm.imaging.read_photo`, `lommel blur`"),
    depthmaps: ("depth map", "a depth map", "`lm.imaging.write_depth`", "`lm.imaging.read_depth`"),
}  # fmt: skip


def rows() -> list[str]:
    """Return the rows of the table."""
    found = []
    for kind, holds, writer, reader in CONTENTS.values():
        for form in registry.formats(kind):
            files = ", ".join(f"`{suffix}`" for suffix in (*form.suffixes, *filter(None, [form.beside])))
            what = f"{holds}: {form.what}" if form.what else holds
            read = "; ".join(filter(None, [reader if form.read else "", form.readers]))
            found.append(f"| {files} | {what} | {writer if form.write else ''} | {read} |")
    return found


def write(folder: Path) -> None:
    """Write `formats.inc`, which the page of formats includes, into a folder."""
    folder.mkdir(exist_ok=True)
    head = ["| file | holds | written by | read by |", "|---|---|---|---|"]
    (folder / "formats.inc").write_text("\n".join([*head, *rows(), ""]), encoding="utf-8")
