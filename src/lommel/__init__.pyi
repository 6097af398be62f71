"""Every public name of the package and where it lives: the one list, which type checkers and __init__.py read."""

from lommel import (
    adapters as adapters,
    base as base,
    blur as blur,
    compat as compat,
    estimation as estimation,
    field as field,
    fit as fit,
    imaging as imaging,
    io as io,
    lensfiles as lensfiles,
    localize as localize,
    measures as measures,
    methods as methods,
    microscopy as microscopy,
    napari_plugin as napari_plugin,
    optics as optics,
    page as page,
    recorded as recorded,
    show as show,
    special as special,
    stacks as stacks,
    telescopes as telescopes,
)
from lommel.channel_psf import ColourPSF as ColourPSF, colour_psf as colour_psf
from lommel.core.answers import ToleranceError as ToleranceError
from lommel.core.engine import clear_caches as clear_caches
from lommel.estimation.beads import (
    BeadFit as BeadFit,
    FittedBead as FittedBead,
    fit_beads as fit_beads,
)
from lommel.estimation.depth_precision import Foci as Foci, best_foci as best_foci, depth_precision as depth_precision
from lommel.estimation.distortion import Distortion as Distortion
from lommel.estimation.field_fit import FieldFit as FieldFit, FittedStars as FittedStars, fit_field as fit_field
from lommel.estimation.fisher import fisher as fisher
from lommel.estimation.fisher import Information as Information
from lommel.recorded.noise import Noise as Noise
from lommel.estimation.phase_retrieval import Retrieval as Retrieval, retrieve as retrieve
from lommel.field.maps import FieldMap as FieldMap, Foreshortening as Foreshortening
from lommel.field.psf_grid import PSFGrid as PSFGrid
from lommel.io.opd_files import load_opd as load_opd, save_opd as save_opd
from lommel.field.maps import Shading as Shading, Vignetting as Vignetting
from lommel.io.zernike_tables import (
    ZernikeTable as ZernikeTable,
    load_zernike as load_zernike,
    save_zernike as save_zernike,
)
from lommel.lensfiles.tables import load_channels as load_channels
from lommel.lensfiles.instrument import Camera as Camera
from lommel.lensfiles.camera_files import load_camera as load_camera
from lommel.lensfiles import example_files as example_files
from lommel.report.image_quality import ImageQuality as ImageQuality
from lommel.lensfiles.instrument import Instrument as Instrument
from lommel.lensfiles.lens_files import load_instrument as load_instrument
from lommel.lensfiles.microscope_files import Microscope as Microscope
from lommel.lensfiles.microscope_files import load_microscope as load_microscope
from lommel.detection.targets import (
    Crossings as Crossings,
    PointSources as PointSources,
    find_crossings as find_crossings,
    find_spots as find_spots,
    grid_indices as grid_indices,
)
from lommel.measures.aperture_means import (
    centroid as centroid,
    marechal as marechal,
    rms as rms,
    spot_radius as spot_radius,
    strehl as strehl,
)
from lommel.measures.errors import mse as mse, peak_error as peak_error
from lommel.measures.energy import best_focus as best_focus
from lommel.measures.slanted_edge import EdgeResponse as EdgeResponse, sfr as sfr
from lommel.measures.transfer import (
    focus_tolerance as focus_tolerance,
    mtf as mtf,
    mtf_frequency as mtf_frequency,
    otf as otf,
    ptf as ptf,
)
from lommel.methods.chordal_gauss import ChordalGauss as ChordalGauss
from lommel.methods.paper.closed_form import ClosedForm as ClosedForm
from lommel.methods.layers.chordal_debye import ChordalDebye as ChordalDebye
from lommel.methods.layers.debye_rings import DebyeRings as DebyeRings
from lommel.methods.layers.debye_wolf import DebyeWolf as DebyeWolf
from lommel.methods.paper.fraunhofer import Fraunhofer as Fraunhofer
from lommel.methods.paper.geometric import Geometric as Geometric
from lommel.methods.hankel import Hankel as Hankel
from lommel.methods.paper.huygens import HuygensFresnel as HuygensFresnel
from lommel.methods.paper.lommel_series import LommelSeries as LommelSeries
from lommel.methods.matrix_fourier import MatrixFourier as MatrixFourier
from lommel.methods.method import Method as Method
from lommel.methods.nijboer_zernike import NijboerZernike as NijboerZernike
from lommel.methods.nonuniform_fft import NonuniformFFT as NonuniformFFT
from lommel.methods.polychromatic import Polychromatic as Polychromatic
from lommel.methods.layers.stratified import Stratified as Stratified
from lommel.methods.paper.closed_form import TunedClosedForm as TunedClosedForm
from lommel.optics.aperture.mask import Mask as Mask
from lommel.optics.aperture.shapes import (
    CatEye as CatEye,
    Disc as Disc,
    Ellipse as Ellipse,
    Polygon as Polygon,
    Segments as Segments,
    Shape as Shape,
    Spider as Spider,
)
from lommel.optics.aperture.apodization import Apodization as Apodization
from lommel.optics.colour.spectrum import Channels as Channels
from lommel.optics.colour.dispersion import Colour as Colour
from lommel.optics.layers.emitter import Beam as Beam, Dipole as Dipole, Scalar as Scalar
from lommel.optics.wavefront.opd_fit import (
    WavefrontFit as WavefrontFit,
    fit_opd as fit_opd,
    fit_radial as fit_radial,
    opd_map as opd_map,
)
from lommel.optics.grid import Grid as Grid
from lommel.optics.layers.stratified import Design as Design, Layer as Layer
from lommel.optics.lens import Lens as Lens
from lommel.optics.layers.objective import Objective as Objective
from lommel.optics.wavefront.opd_fit import OPDMap as OPDMap
from lommel.optics.pupil import Pupil as Pupil
from lommel.optics.wavefront.wavefront import Wavefront as Wavefront
from lommel.page.server import live as live
from lommel.psf import PSF as PSF, Plan as Plan, psf as psf
from lommel.blur.blurs import (
    Blur as Blur,
    ChargeDiffusion as ChargeDiffusion,
    Jitter as Jitter,
    Motion as Motion,
    Seeing as Seeing,
)
from lommel.special.erf import AbramowitzErf as AbramowitzErf, FresnelErf as FresnelErf, TableErf as TableErf
from lommel.stacks import psf_to as psf_to
from lommel.stacks import PSFStack as PSFStack, open_stack as open_stack

__version__: str
