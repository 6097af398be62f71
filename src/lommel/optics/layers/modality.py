"""Illumination and detection of a microscope, on which the PSF of a stack depends."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, get_args

from lommel.base import validation

Kind = Literal["widefield", "confocal", "spinning disc", "light sheet", "two-photon"]


@dataclass(frozen=True)
class Modality:
    """Illumination and detection of a microscope, for the deconvolution of its stacks.

    Parameters
    ----------
    kind : {"widefield", "confocal", "spinning disc", "light sheet", "two-photon"}, default "widefield"
        Kind of microscope.
    excitation : float, optional
        Vacuum wavelength of the excitation, metres. "confocal", "spinning disc" and "two-photon" take it from the
        stack if it is not given here.
    pinhole : float, default 1
        Pinhole diameter in Airy units, for "confocal" and "spinning disc".
    thickness : float, optional
        Full width at half maximum of the "light sheet", metres; the sheet stays in the focal plane.

    Raises
    ------
    TypeError, ValueError
        If an argument is of another type or out of range, or a light sheet has no thickness.
    """

    kind: Kind = "widefield"
    excitation: float | None = None
    pinhole: float = 1.0
    thickness: float | None = None

    def __post_init__(self) -> None:
        validation.choice("kind", self.kind, get_args(Kind))
        validation.real("pinhole", self.pinhole, above=0.0)
        if self.excitation is not None:
            validation.wavelength(self.excitation, "excitation")
        if self.thickness is not None:
            validation.real("thickness", self.thickness, above=0.0)
        elif self.kind == "light sheet":
            raise ValueError('thickness must be given for a "light sheet": its full width at half maximum, metres')

    @property
    def spreads(self) -> bool:
        """Whether light out of focus is recorded."""
        return self.kind in ("widefield", "light sheet")


WIDEFIELD = Modality()
