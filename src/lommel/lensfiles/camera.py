"""A camera sensor: its pixels and its noise."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from lommel.base.units import format_length
from lommel.recorded.noise import Noise


@dataclass(frozen=True)
class Camera:
    """A camera sensor, as described by a file with a section [camera].

    Attributes
    ----------
    name, source : str
        Name, and source of the numbers.
    pixel : float or (float, float)
        Pixel pitch in metres; height and width of pixels that are not square.
    read : float or None
        Read noise, rms electrons; None where the file does not state it, like all that follows.
    full_well : float or None
        Electrons at which a pixel saturates.
    gain : float or None
        Electrons per count (e-/ADU).
    offset : float or None
        Counts of a pixel without electrons.
    excess : float
        Excess noise factor of electron multiplication, as of :class:`lommel.Noise`; 1 for none.
    """

    name: str
    source: str
    pixel: float | tuple[float, float]
    read: float | None = None
    full_well: float | None = None
    gain: float | None = None
    offset: float | None = None
    excess: float = 1.0

    def __repr__(self) -> str:
        pixel = (
            format_length(self.pixel) if isinstance(self.pixel, float) else " x ".join(map(format_length, self.pixel))
        )
        noise = "" if self.read is None else f", read noise {self.read:g} electrons"
        well = "" if self.full_well is None else f", full well {self.full_well:g} electrons"
        excess = "" if self.excess == 1.0 else f", excess noise {self.excess:g}"
        return f"<Camera {self.name!r}: pixels of {pixel}{noise}{well}{excess}>"

    def to_dict(self) -> dict[str, Any]:
        """Return what is known of the camera besides its pixels as plain data.

        Returns
        -------
        dict
        """
        return {name: value for name, value in vars(self).items() if name != "pixel"}

    @property
    def side(self) -> float:
        """Pitch of square pixels, metres; ValueError for other pixels."""
        if not isinstance(self.pixel, float):
            raise ValueError(f"pixel must be square, got that of {self.name!r}, {self.pixel}")
        return self.pixel

    @property
    def noise(self) -> Noise:
        """Noise of images in counts: gain (1 where it is not stated), read noise, offset (0), excess.

        Returns
        -------
        Noise

        Raises
        ------
        ValueError
            If the file does not state the read noise.
        """
        if self.read is None:
            raise ValueError(f"the file of {self.name!r} must state read, the read noise, for its noise")
        return Noise(white=self.gain, read=self.read, offset=self.offset or 0.0, excess=self.excess)
