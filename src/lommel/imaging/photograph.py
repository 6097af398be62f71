"""One scene, photographed again and again: only what the focus and the stop change is computed anew."""

from __future__ import annotations

from collections import OrderedDict
from dataclasses import replace
from typing import Any, Unpack

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lommel.base import validation
from lommel.base.encoding import to_light
from lommel.base.options import require_known, shares
from lommel.imaging.blur import DepthBlur, require_lens
from lommel.imaging.occlusion import Occlusion
from lommel.imaging.scene import Photograph, fill_missing, photograph, stored
from lommel.imaging.settings import Keywords, Settings
from lommel.optics.lens import Lens


@shares(Keywords, Settings)
class FocusPlan:
    """A scene, and the lens that is focused on it: for live use, where focus and stop change from frame to frame.

    Everything is checked and the image decoded once. A frame computes the windows of its focus, and what hides what
    in it, unless that focus is among the last ones; then it spreads the light and encodes it. The answer is that of
    :func:`lommel.imaging.depth_of_field` with the same arguments, bit for bit. Without `occlusion` a frame of a new
    focus takes a fraction of the time; one of a focus that is remembered, little less.

    Parameters
    ----------
    image, depth, lens, pixel, encoding
        As of :func:`lommel.imaging.depth_of_field`. The image and the depth are copied.
    keep : int, default 4
        How many settings of the lens are remembered, 1 to 1000: coming back to one costs no windows, and what hides
        what is known. A setting takes some MiB, 8 bytes for each point and as many for each channel of it, and with
        `occlusion` what :class:`lommel.imaging.Occlusion` keeps; with ``energy=1`` as many again for each channel and
        each product of the remainder (16 in float64), of which there are up to five or so.
    {options}

    Raises
    ------
    TypeError, ValueError
        As :func:`lommel.imaging.depth_of_field`; and if the windows of `lens` as it is given exceed `largest`, since
        they are computed at once.

    Examples
    --------
    >>> lens = Lens(focal_length=50e-3, f_number=4.0, focus_distance=2.0, wavelength=550e-9)
    >>> plan = FocusPlan(np.ones((40, 60), np.float32), np.full((40, 60), 2.5), lens, 8e-6, encoding="linear")
    >>> plan(focus_distance=2.5).window < plan(focus_distance=2.0).window
    True
    """

    def __init__(
        self,
        image: ArrayLike,
        depth: ArrayLike,
        lens: Lens,
        pixel: float,
        *,
        encoding: str,
        keep: int = 4,
        **options: Unpack[Keywords],
    ) -> None:
        require_lens(lens, "image, depth, lens, pixel")
        self.settings = Settings.of(FocusPlan, options, Keywords)
        given = validation.array("image", image)
        if given.ndim not in (2, 3) or 0 in given.shape:
            raise ValueError(
                f"image must have the shape (height, width) or (height, width, channels), got {given.shape}"
            )
        distances = np.array(fill_missing(depth, self.settings.missing))
        if distances.shape != given.shape[:2]:
            raise ValueError(f"depth must have the shape of the image, {given.shape[:2]}, got {distances.shape}")
        self.lens = lens
        self.shape, self.dtype = given.shape, given.dtype
        self._encoding = encoding
        self._light = to_light("image", given, encoding, self.settings.dtype)
        self._depth = distances
        self._keep = validation.integer("keep", keep, least=1, most=1000)
        self._pixel = pixel
        self._channels = self.settings.channels(given.shape, lens.wavelength)
        self._known: OrderedDict[tuple[float, float], Occlusion] = OrderedDict()
        self.blur()

    def lens_at(self, *, focus_distance: float | None = None, f_number: float | None = None) -> Lens:
        """Return the lens at another focus (metres) or f-number (as engraved); None leaves that of `lens`.

        See :meth:`lommel.Lens.focused` and :meth:`lommel.Lens.stopped`.

        Parameters
        ----------
        focus_distance, f_number : float, optional
            Metres, and as engraved.

        Returns
        -------
        Lens

        Raises
        ------
        TypeError, ValueError
            As :meth:`lommel.Lens.focused` and :meth:`lommel.Lens.stopped`.
        """
        lens = self.lens if f_number is None else self.lens.stopped(f_number)
        return lens if focus_distance is None else lens.focused(focus_distance)

    def blur(self, *, focus_distance: float | None = None, f_number: float | None = None) -> DepthBlur:
        """Return the linear operator at a focus and f-number; the last ones are remembered.

        Parameters
        ----------
        focus_distance, f_number : float, optional
            Metres, and as engraved.

        Returns
        -------
        DepthBlur

        Raises
        ------
        TypeError, ValueError
            As :meth:`lens_at`, and if the blur exceeds the largest window allowed.
        """
        return self._at(focus_distance, f_number).blur

    def _at(self, focus_distance: float | None, f_number: float | None) -> Occlusion:
        """Return what makes the light of a focus and f-number, either way."""
        lens = self.lens_at(focus_distance=focus_distance, f_number=f_number)
        key = (lens.sensor_distance, lens.aperture_diameter)
        if key in self._known:
            self._known.move_to_end(key)
            return self._known[key]
        made = Occlusion(DepthBlur(self._depth, lens, self._pixel, channels=self._channels, **self.settings.of_blur))
        self._known[key] = made
        if len(self._known) > self._keep:
            self._known.popitem(last=False)
        return made

    def __call__(
        self,
        *,
        focus_distance: float | None = None,
        f_number: float | None = None,
        out: NDArray[Any] | None = None,
    ) -> Photograph:
        """Return the photograph at a focus and f-number.

        Parameters
        ----------
        focus_distance : float, optional
            Object distance in focus, metres, more than the focal length, may be infinite; by default that of the
            lens. The sensor moves, and with it the working f-number.
        f_number : float, optional
            Focal length over the diameter of the aperture; by default that of the lens.
        out : ndarray, optional
            Where to write the values: of the shape and type of the image.

        Returns
        -------
        Photograph

        Raises
        ------
        TypeError, ValueError
            If an argument is out of range, or the blur exceeds the largest window allowed. `out` is then untouched.
        """
        if out is not None:
            self._check(out)
        occlusion = self._at(focus_distance, f_number)
        seen = (occlusion if self.settings.occlusion else occlusion.blur).forward(self._light)
        values, clipped = stored(seen, self._encoding, self.dtype, self.settings.threads or 0)
        made = photograph(values, occlusion.blur, clipped)
        if out is None:
            return made
        np.copyto(out, made.values)
        return replace(made, values=out)

    def _check(self, out: Any) -> None:
        if not isinstance(out, np.ndarray):
            raise TypeError(f"out must be an array, got {type(out).__name__}")
        if out.shape != self.shape:
            raise ValueError(f"out must have the shape of the image, {self.shape}, got {out.shape}")
        if out.dtype != self.dtype:
            raise TypeError(f"out must have the type of the image, {self.dtype}, got {out.dtype}")
        if not out.flags.writeable:
            raise ValueError("out must be writeable")


@shares(Keywords, Settings)
def depth_of_field(
    image: ArrayLike, depth: ArrayLike, lens: Lens, pixel: float, *, encoding: str, **options: Unpack[Keywords]
) -> Photograph:
    """Blur a sharp image as a lens would, each point by its own distance, with diffraction, aberration and colour.

    Every point of the image spreads its own pixel-averaged PSF; see :class:`lommel.imaging.blur.DepthBlur`,
    and :func:`lommel.imaging.occlusion.occlude` of what hides what.

    Parameters
    ----------
    image : array_like, shape (height, width) or (height, width, channels)
        Unsigned integers (white is their largest value) or floats (white is 1).
    depth : array_like, shape (height, width)
        Distance of each point from the lens, metres; may be infinite.
    lens : Lens
        With radially symmetric aberrations.
    pixel : float
        Pixel pitch, metres.
    encoding : {"srgb", "linear"}
        Of the values of `image`, and of the result.
    {options}

    Returns
    -------
    Photograph

    Raises
    ------
    TypeError, ValueError
        If an argument is unknown or out of range, if shapes do not match, if the lens is not radially symmetric, if
        the blur exceeds `largest`, or if an image has two or four channels and no `wavelengths` are given: it may
        have alpha.
    """
    require_known(depth_of_field, options, Keywords)
    return FocusPlan(image, depth, lens, pixel, encoding=encoding, **options)()
