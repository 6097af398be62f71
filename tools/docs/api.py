"""The API reference: pages of names by subject, from `lommel/__init__.pyi` and the `__all__` of packages."""

from __future__ import annotations

import ast
import re
import shutil
from functools import cache
from importlib import import_module
from operator import itemgetter
from pathlib import Path
from typing import NamedTuple

STUB = Path(__file__).resolve().parents[2] / "src" / "lommel" / "__init__.pyi"


class Section(NamedTuple):
    """A page of names: those of `lommel` defined in `modules`, a package's `__all__`, and `more`."""

    title: str
    text: str
    see: str
    modules: tuple[str, ...] = ()
    package: str = ""
    more: str = ""


# A name of `lommel` goes to the section with the longest module that its own begins with.
SECTIONS = [
    Section(
        "PSFs",
        "Compute PSFs and stacks, and prepare plans for many of them.",
        "See [](../start.md).",
        ("psf", "core", "traced"),
        more="traced.traced_psf.TracedPSF optics.grid.Grid",
    ),
    Section(
        "Blur of sensors and the atmosphere",
        "Multiply the transfer function by seeing, jitter, motion blur or charge diffusion.",
        "See [](../sensor.md).",
        ("blur",),
        more="blur.blurs.Blur",
    ),
    Section(
        "Colour",
        "Integrate over the spectral responses of a sensor; chromatic aberration.",
        "See [](../colour.md).",
        ("channel_psf", "lensfiles.tables", "optics.colour"),
        more="io.psf_files.save_colours show.plot.colour"
        " optics.colour.spectrum.Spectrum optics.colour.spectrum.Component",
    ),
    Section(
        "Lenses, pupils, apertures",
        "Describe a lens or a pupil: aperture, wavefront, wavelength, f-number.",
        "See [](../conventions.md) for signs and units, [](../command-line.md) for lens files.",
        (
            "optics",
            "optics.wavefront.wavefront",
            "telescopes",
            "report",
            "lensfiles.instrument",
            "lensfiles.lens",
        ),
        more="telescopes.elt telescopes.hst telescopes.jwst telescopes.keck telescopes.subaru telescopes.vlt"
        " lensfiles.toml_files.LensFileError report.image_quality.image_quality optics.aperture.shapes.Shape"
        " optics.wavefront.wavefront.path optics.wavefront.wavefront.expansion"
        " optics.aperture.opening.Opening optics.aperture.opening.Rule optics.aperture.opening.degree_needed",
    ),
    Section(
        "Measured wavefronts and Zernike tables",
        "Read and write OPD maps and Zernike tables, and fit Zernike terms.",
        "See [](../formats.md#measured-wavefronts).",
        ("optics.wavefront", "io.opd_files", "io.zernike_tables"),
        more="optics.wavefront.opd_fit.WavefrontFit io.zernike_tables.ZernikeTable"
        " io.opd_files.OPDFileError io.zernike_tables.ZernikeFileError",
    ),
    Section(
        "Cameras and example files",
        "Read the pixels and the noise of a camera; files of real instruments.",
        "See [](../instruments.md).",
        ("lensfiles",),
    ),
    Section(
        "Microscope objectives",
        "Describe an objective, its layers and the emitter.",
        "See [](../microscopes.md).",
        ("optics.layers", "lensfiles.microscope"),
        more="optics.layers.stratified.Design optics.layers.objective_pupil.ObjectivePupil"
        " optics.layers.objective.Focus optics.layers.objective.FocalField"
        " optics.layers.objective.Nyquist"
        " measures.spot.axial_fwhm measures.spot.stage",
    ),
    Section(
        "Scanning microscopes, beads, deconvolution",
        "Confocal, two-photon, STED and light-sheet PSFs, images of beads, 3-D deconvolution.",
        "See [](../microscopes.md#confocal-two-photon-light-sheet-beads).",
        ("microscopy", "deconvolve"),
        package="microscopy",
    ),
    Section(
        "Localisation of molecules",
        "Read movies, find molecules, fit their positions in 3-D, and write tables of them.",
        "See [](../localize.md).",
        ("localize",),
        package="localize",
    ),
    Section(
        "PSFs over the field",
        "Wavefronts, vignetting and PSFs at every position of the sensor.",
        "See [](../field.md).",
        ("field", "adapters"),
        more="field.maps.Vignetting field.maps.Foreshortening field.maps.Shading io.field_files.save"
        " show.plot.field adapters.optiland.pupil"
        " adapters.optiland.field_map adapters.rayoptics.pupil adapters.rayoptics.field_map"
        " adapters.batoid.pupil adapters.batoid.field_map",
    ),
    Section(
        "Stacks larger than memory",
        "Write and read stacks of PSFs in Zarr.",
        "See [](../scale.md).",
        ("stacks",),
        more="stacks.PSFStack",
    ),
    Section(
        "Methods",
        "Choose how the diffraction integral is evaluated; the fields of a method are its options.",
        "[](../choose.md) compares the methods. Your own method is a subclass of `Method`, or of `RadialMethod`"
        " if a radial profile is enough.",
        ("methods", "core.answers"),
        package="methods",
    ),
    Section(
        "The paper",
        "Methods of the paper, and approximations of the error function for its closed form.",
        "See [](../theory.md#the-closed-form-of-the-paper) and [](../paper.md).",
        ("paper",),
        package="paper",
    ),
    Section(
        "Measures",
        "MTF, Strehl ratio, encircled energy, widths, and differences of PSFs.",
        "See [](../numbers.md).",
        ("measures",),
        more="measures.energy.encircled_energy measures.energy.ensquared_energy measures.energy.radial_energy"
        " measures.energy.window_energy measures.energy.encircled measures.energy.Encircled"
        " measures.energy.image_centroid measures.energy.window_centroid"
        " measures.spot.axis_strehl measures.spot.peak_strehl measures.spot.fwhm measures.spot.energy_diameter"
        " measures.transfer.image_otf"
        " measures.errors.mse imaging.slanted_edge.EdgeResponse psf.Measured",
    ),
    Section(
        "Fisher information and phase retrieval",
        "Cramér-Rao bounds of parameters and depth; the wavefront from star images.",
        "See [](../estimation.md) and [](../retrieve.md).",
        ("estimation", "detection"),
        package="detection",
        more="estimation.fisher.Information estimation.phase_retrieval.Retrieval"
        " estimation.beads.BeadFit estimation.beads.FittedBead estimation.field_fit.FieldFit"
        " estimation.field_fit.FittedStars estimation.distortion.Distortion",
    ),
    Section(
        "Recorded images",
        "Open the images of files of every kind, and state the noise of a camera.",
        "See [](../formats.md#recorded-images).",
        ("recorded",),
        package="recorded",
    ),
    Section(
        "Fits",
        "What every fit reports: findings, and the verdict that follows from them.",
        "See [](../retrieve.md).",
        ("fit",),
        package="fit",
    ),
    Section(
        "Imaging",
        "Depth-of-field rendering, deblurring, depth from defocus, photographs and depth maps.",
        "See [](../imaging.md), [](../restore.md) and [](../depth.md).",
        ("imaging",),
        package="imaging",
        more="imaging.settings.WindowOptions imaging.traced_blur.TracedBlur adapters.deepinv.blur_physics"
        " adapters.deepinv.psf_generator imaging.field_blur.FieldBank"
        " imaging.bank.Bank"
        " methods.pixel_rule.pixel_rule methods.pixel_rule.PixelRule methods.pixel_rule.octant"
        " methods.pixel_rule.sums_of_windows methods.pixel_rule.quarters base.encoding.to_light"
        " base.encoding.from_light base.encoding.clipped_fraction",
    ),
    Section(
        "Video",
        "Frames of video files, streams and cameras, and pairs of them.",
        "See [](../live-depth.md).",
        package="io",
    ),
    Section("Live page", "Open the live page as a notebook widget.", "See [](../live.md).", ("page",)),
    Section(
        "Plots",
        "Plot PSFs, pupils, curves, spots and sections with matplotlib.",
        "See [](../pictures.md).",
        ("show",),
        more="show.plot.plot show.plot.sections show.plot.compare show.pupils.pupil show.pupils.wavefront"
        " show.plot.difference show.curves.mtf show.curves.encircled_energy show.plot.spots"
        " show.curves.through_focus show.curves.focus_curves show.plot.ray_positions",
    ),
    Section(
        "Files and units",
        "File formats of PSFs, and lengths with units.",
        "See [](../formats.md).",
        ("io", "base"),
        more="io.psf_files.save io.psf_files.describe io.psf_files.FileError io.registry.Format io.registry.register"
        " base.units.parse_length base.units.parse_angle base.units.parse_radius base.units.format_length",
    ),
    Section(
        "Signatures of other packages",
        "Functions of psfmodels, and models of photutils and GalSim.",
        "See [](../coming-from.md).",
        ("compat",),
        more="compat.psfmodels.make_psf compat.psfmodels.objective compat.photutils.effective_psf"
        " compat.photutils.image_psf compat.photutils.gridded_psf_model compat.photutils.save_stdpsf"
        " compat.galsim.interpolated_image",
    ),
    Section(
        "Special functions",
        "Each documents its published source.",
        "",
        ("special",),
        more="special.bessel.bessel_sequence special.bessel.j0_series"
        " special.bessel.j0_asymptotic special.bessel.tangent_line"
        " optics.aperture.shapes.disk_overlap special.erf.Erf"
        " special.erf.fresnel_auxiliary special.legendre.gauss_legendre special.piecewise.PiecewiseQuadratic"
        " special.piecewise.split_edges special.piecewise.fit_quadratics special.zernike.name"
        " special.zernike.polynomial special.zernike.rms_factor",
    ),
]

MODULES = """# Modules

Types that functions return, and functions of modules beneath the public names, for extensions. Import them by their
path: `from lommel.measures.energy import encircled_energy`.
"""


def public() -> dict[str, str]:
    """Return the names of `lommel` and the module of each, without the prefix of the package."""
    found = {}
    for node in ast.parse(STUB.read_text(encoding="utf-8")).body:
        if isinstance(node, ast.ImportFrom) and node.module != "lommel":
            found |= {alias.name: str(node.module).removeprefix("lommel.") for alias in node.names}
    return found


def section_of(module: str) -> Section:
    """Return the section that takes the names of a module: that of the longest prefix."""
    prefixes = [
        (len(prefix), section)
        for section in SECTIONS
        for prefix in section.modules
        if f"{module}.".startswith((f"{prefix}.", f"{prefix}_"))
    ]
    if not prefixes:
        raise ValueError(f"no section of tools/docs/api.py has the names of lommel.{module}; add its package to one")
    return max(prefixes, key=itemgetter(0))[1]


@cache
def groups() -> dict[str, tuple[Section, list[str], list[str]]]:
    """Return, by name of the page, each section with its public names and those of its modules."""
    found, names = {}, public()
    # What several packages have under one name is described once, and at the top where that has it.
    seen = {id(getattr(import_module(f"lommel.{module}"), name)) for name, module in names.items()}
    for section in SECTIONS:
        listed = sorted((name for name, module in names.items() if section_of(module) is section), key=str.lower)
        if section.package:
            package = import_module(f"lommel.{section.package}")
            own = {n: getattr(package, n) for n in package.__all__ if callable(getattr(package, n))}
            listed += [f"{section.package}.{n}" for n, one in own.items() if id(one) not in seen]
            seen |= {id(one) for one in own.values()}
        more = section.more.split()
        # Functions of `lommel.show` and methods have a short name too.
        short = [name for name in more if name.startswith("show.") or name.count(".") == 1]
        listed = list(dict.fromkeys([*listed, *short]))
        found[re.sub("[^a-z]+", "-", section.title.lower())] = section, listed, [n for n in more if n not in short]
    return found


def _table(names: list[str]) -> str:
    rows = "\n".join(f"   {name}" for name in names)
    head = ".. currentmodule:: lommel\n\n.. autosummary::\n   :nosignatures:\n   :toctree: ../api\n"
    return f"```{{eval-rst}}\n{head}\n{rows}\n```\n"


def pages() -> dict[str, str]:
    """Return the Markdown of a page for each section, by name, and of the overview that docs/api.md includes."""
    made, overview, tree, modules = {}, [], [], []
    for name, (section, listed, more) in groups().items():
        see = f" {section.see}" if section.see else ""
        if listed:
            made[f"reference/{name}.md"] = f"# {section.title}\n\n{section.text}{see}\n\n{_table(listed)}"
            links = ", ".join(f"{{py:obj}}`{each} <lommel.{each}>`" for each in listed)
            overview.append(f"## [{section.title}](reference/{name}.md)\n\n{section.text}\n\n{links}\n")
            tree.append(f"reference/{name}")
        if more:
            modules.append(f"## {section.title}\n\n{_table(more)}")
    made["reference/modules.md"] = "\n".join([MODULES, *modules])
    overview.append(f"## [Modules](reference/modules.md)\n\n{MODULES.split(maxsplit=2)[2]}")
    tree.append("reference/modules")
    made["_generated/api.inc"] = "\n".join([*overview, "```{toctree}\n:hidden:\n", *tree, "```\n"])
    return made


def write(folder: Path) -> None:
    """Write the pages into the folder of the documentation, without those of sections that are gone."""
    shutil.rmtree(folder / "reference", ignore_errors=True)
    for name, text in pages().items():
        (folder / name).parent.mkdir(exist_ok=True)
        (folder / name).write_text(text, encoding="utf-8")
