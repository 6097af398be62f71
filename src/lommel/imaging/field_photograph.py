"""Photographs through a field map: distortion and lateral colour by resampling, blur by the PSFs of the field."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Unpack

import numpy as np
from numpy.typing import ArrayLike

from lommel.base import validation
from lommel.base.arrays import Array, Values
from lommel.base.encoding import scene_light
from lommel.base.options import shares
from lommel.field.maps import FieldMap, require_one_aperture
from lommel.imaging.field_blur import FieldBlur, PointLight
from lommel.imaging.photograph import Photograph, require_image, stored
from lommel.imaging.settings import FieldKeywords, Settings, Spectrum
from lommel.optics.colour.spectrum import Channels
from lommel.optics.pupil import Pupil

PLACES = 1e-3
"""Accuracy of the places that pixels are taken from, pixels, checked half-way between nodes."""

_FEW = 4096  # pixels whose places are computed one by one
_MOST = 257  # nodes along a side
_MODES = {"reflect": "reflect", "extend": "nearest", "zero": "grid-constant"}  # borders as SciPy calls them


@shares(FieldKeywords, Settings)
def field_photograph(
    image: ArrayLike,
    field_map: FieldMap,
    pixel: float,
    *,
    encoding: str,
    center: tuple[float, float] | None = None,
    sensor: tuple[float, float] | None = None,
    wavelengths: Channels | Sequence[Spectrum] | None = None,
    tol: float = 1e-3,
    **options: Unpack[FieldKeywords],
) -> Photograph:
    """Render a sharp image as a lens records it: blur over the field, distortion, lateral colour, shading.

    The image is what an ideal lens would record. Each channel is resampled by quintic splines to where the tilts of
    the map move its light (:meth:`lommel.FieldMap.displacement`), then blurred by :class:`lommel.imaging.FieldBlur`
    with the PSFs of the map without these tilts, and multiplied by the shading of the map. This is the blur by the
    PSFs of the map with its tilts, for displacements of any size.

    Parameters
    ----------
    image : array_like, shape (height, width) or (height, width, channels)
        Unsigned integers (white is their largest value) or floats (white is 1).
    field_map : FieldMap
        Positions are those without distortion. Lateral and axial colour are those of the lens of its aperture.
    pixel : float
        Pixel pitch, in the unit of the map (metres if it has a wavelength).
    encoding : {"srgb", "linear"}
        Of the values of `image`, and of the result.
    center, sensor
        As of :class:`lommel.imaging.FieldBlur`. A `sensor` larger than the image exaggerates PSFs, not distortion.
    wavelengths : Channels or sequence, optional
        :class:`lommel.Channels`, or a wavelength (metres) or pairs of wavelength and weight for each channel. By
        default that of the map for a grey image, and 600, 540 and 460 nm for one of three channels.
    tol : float, default 1e-3
        As of :class:`lommel.imaging.FieldBlur`.
    {options}

    Returns
    -------
    Photograph
        Without resampling, no pixel is off by more than ``error + 2 * lost`` times the brightest point, in light;
        `error` is the largest sum of absolute differences between interpolated and exact windows.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range; if light comes from beyond the map; if the map has vignetting.

    Notes
    -----
    A uniform scene stays uniform but for the shading, which is the relative illumination as measured: where
    distortion stretches the picture, points have more light. :class:`lommel.imaging.FieldBlur` with the tilts in its
    windows conserves the light of points instead.

    Places are accurate to 0.001 pixel. Splines change a Gaussian of standard deviation 1 pixel by 0.3 % of its peak,
    of 1.5 pixels by 0.04 %, of 2 pixels by 0.005 %; next to sharp edges they overshoot, and light below 0 becomes 0.

    Examples
    --------
    >>> field = lm.FieldMap.from_seidel(2.5e-3, W311=-60.0, W131=0.5, wavelength=550e-9, f_number=4.0)
    >>> image = np.zeros((60, 80, 3), np.float32)
    >>> image[30, 60] = 1.0
    >>> made = lm.imaging.field_photograph(image, field, 4e-6, encoding="linear", sensor=(3e-3, 4e-3))
    >>> made.values.shape
    (60, 80, 3)
    """
    validation.instance("field_map", field_map, FieldMap)
    given = validation.array("image", image)
    require_image("image", given.shape)
    require_one_aperture(field_map)
    settings = Settings.of(field_photograph, dict(options), FieldKeywords)
    known = field_map.pupil_without_wavefront.wavelength
    spectra: Sequence[Spectrum] | None = None
    if known is not None:
        spectra = Settings(wavelengths=wavelengths).channels(given.shape, known)
    elif wavelengths is not None or given.ndim == 3:
        raise ValueError("image must be grey, without wavelengths=, for a map without a wavelength; make the map "
                         "with wavelength= and f_number=")  # fmt: skip
    light = scene_light("image", given, encoding, settings.dtype)
    shape = (given.shape[0], given.shape[1])
    blur = StraightBlur(field_map, shape, pixel, center=center, sensor=sensor, channels=spectra, tol=tol, **options)
    planes = light.reshape(*shape, -1)
    moved = np.empty_like(planes)
    for k, spectrum in enumerate(blur.spectra):
        moved[..., k] = resampled(planes[..., k], blur, spectrum)
    seen = blur.forward(moved.reshape(light.shape))
    if field_map.shading is not None:
        lit = np.asarray(field_map.illumination(blur.x, blur.y[:, None]), dtype=seen.dtype)
        seen = seen * lit.reshape(*shape, *(1,) * (seen.ndim - 2))
    values, clipped = stored(seen, encoding, given.dtype, settings.threads or 0)
    side = max(bank.window(blur.y[0], blur.x[0]).shape[0] for bank in blur.banks)
    return Photograph(values, blur.lost, blur.error, side, clipped)


class StraightLight(PointLight):
    """The PSF of the light that arrives at a position of the sensor, centred there."""

    def pupil(self, y: Array, x: Array, defocus: Array) -> Pupil:
        """Return the stack of pupils whose light arrives at places, without the tilts that move it there."""
        return self.field_map.untilted(x, y, self.spectrum)


class StraightBlur(FieldBlur):
    """Blur of an image that is distorted already, by the PSFs of a map without their tilts."""

    @property
    def _points(self) -> type[PointLight]:
        return StraightLight

    def _reached(self, x: Array, y: Array) -> None:
        """Raise ValueError where light comes from beyond the map."""
        for spectrum in self.spectra:
            self.field_map.undistorted(x, y, spectrum)


def resampled(plane: Values, blur: StraightBlur, spectrum: Spectrum | None) -> Values:
    """Return a plane of light with each point where the map moves it, by quintic splines."""
    from scipy.ndimage import map_coordinates

    pitch = [float(along[1] - along[0]) if len(along) > 1 else blur.pixel for along in (blur.y, blur.x)]
    down, across = _places(blur.field_map, blur.y, blur.x, spectrum, PLACES * min(pitch))
    at = np.stack([(down - blur.y[0]) / pitch[0], (across - blur.x[0]) / pitch[1]])
    if all(np.abs(found - here).max() <= PLACES for found, here in zip(at, np.indices(plane.shape), strict=True)):
        return plane
    made: Values = map_coordinates(plane, at, order=5, mode=_MODES[blur.border], output=plane.dtype)
    return np.maximum(made, 0.0) if plane.min() >= 0.0 else made


def _places(field_map: FieldMap, y: Array, x: Array, spectrum: Spectrum | None, tol: float) -> tuple[Array, Array]:
    """Return y and x without distortion of the light that arrives at rows and columns, off by at most `tol`."""
    from scipy.interpolate import RectBivariateSpline

    if len(y) * len(x) <= _FEW or min(len(y), len(x)) < 16:
        across, down = field_map.undistorted(x, y[:, None], spectrum)
        return down, across
    count = 9
    while count <= _MOST:
        # Over positions from 0 to 1, because FITPACK compares with absolute tolerances.
        nodes, between = np.linspace(0.0, 1.0, count), (np.arange(count - 1) + 0.5) / (count - 1)
        known, exact = (
            field_map.undistorted(x[0] + part * (x[-1] - x[0]), y[0] + part[:, None] * (y[-1] - y[0]), spectrum)[::-1]
            for part in (nodes, between)
        )
        splines = [RectBivariateSpline(nodes, nodes, part, kx=5, ky=5, s=0) for part in known]
        off = max(float(np.abs(s(between, between) - e).max()) for s, e in zip(splines, exact, strict=True))
        if off <= tol:
            down, across = (s(*(np.linspace(0.0, 1.0, len(along)) for along in (y, x))) for s in splines)
            return down, across
        count = 2 * count - 1
    raise ValueError("distortion of the map must be smooth over the field, and changes between close pixels")
