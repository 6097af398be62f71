"""Every public name of the package and where it lives: the one list, which type checkers and __init__.py read."""

from lommel import (
    detection as detection,
    imaging as imaging,
    io as io,
    localize as localize,
    measures as measures,
    methods as methods,
    microscopy as microscopy,
    paper as paper,
    recorded as recorded,
    show as show,
    telescopes as telescopes,
)
from lommel.blur.blurs import Jitter as Jitter, Motion as Motion, Seeing as Seeing
from lommel.channel_psf import ColourPSF as ColourPSF, colour_psf as colour_psf
from lommel.core.answers import ToleranceError as ToleranceError
from lommel.core.engine import clear_caches as clear_caches
from lommel.estimation.beads import fit_beads as fit_beads
from lommel.estimation.depth_precision import best_depth_foci as best_depth_foci, depth_precision as depth_precision
from lommel.estimation.field_fit import fit_field as fit_field
from lommel.estimation.fisher import fisher as fisher
from lommel.estimation.options import (
    BeadOptions as BeadOptions,
    FieldFitOptions as FieldFitOptions,
    RetrieveOptions as RetrieveOptions,
)
from lommel.estimation.phase_retrieval import retrieve as retrieve
from lommel.field.maps import FieldMap as FieldMap
from lommel.field.psf_grid import PSFGrid as PSFGrid
from lommel.imaging.slanted_edge import sfr as sfr
from lommel.io.opd_files import load_opd as load_opd, save_opd as save_opd
from lommel.io.zernike_tables import load_zernike as load_zernike, save_zernike as save_zernike
from lommel.lensfiles import example_files as example_files
from lommel.lensfiles.camera_files import load_camera as load_camera
from lommel.lensfiles.instrument import Camera as Camera, Instrument as Instrument
from lommel.lensfiles.lens_files import load_instrument as load_instrument
from lommel.lensfiles.microscope_files import Microscope as Microscope, load_microscope as load_microscope
from lommel.lensfiles.tables import load_channels as load_channels
from lommel.measures.aperture_means import (
    centroid as centroid,
    marechal as marechal,
    rms as rms,
    spot_radius as spot_radius,
    strehl as strehl,
)
from lommel.measures.energy import best_focus as best_focus
from lommel.measures.errors import peak_error as peak_error
from lommel.measures.transfer import (
    focus_tolerance as focus_tolerance,
    mtf as mtf,
    mtf_frequency as mtf_frequency,
    otf as otf,
    ptf as ptf,
)
from lommel.optics.aperture.apodization import Apodization as Apodization
from lommel.optics.aperture.mask import Mask as Mask
from lommel.optics.aperture.shapes import (
    CatEye as CatEye,
    Disc as Disc,
    Ellipse as Ellipse,
    Polygon as Polygon,
    Segments as Segments,
    Spider as Spider,
)
from lommel.optics.colour.dispersion import Colour as Colour
from lommel.optics.colour.spectrum import Channels as Channels
from lommel.optics.layers.emitter import Beam as Beam, Dipole as Dipole, Scalar as Scalar
from lommel.optics.layers.objective import Objective as Objective
from lommel.optics.layers.stratified import Layer as Layer
from lommel.optics.lens import Lens as Lens
from lommel.optics.pupil import Pupil as Pupil
from lommel.optics.wavefront.opd_fit import OPDMap as OPDMap, fit_opd as fit_opd, opd_map as opd_map
from lommel.optics.wavefront.wavefront import Wavefront as Wavefront
from lommel.page.server import live as live
from lommel.psf import PSF as PSF, Plan as Plan, psf as psf
from lommel.recorded.counts import Counts as Counts
from lommel.recorded.noise import Noise as Noise
from lommel.stacks import open_stack as open_stack, psf_to as psf_to

__version__: str
