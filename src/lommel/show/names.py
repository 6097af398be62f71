"""The pictures that this room has by name."""

from lommel.show.differences import difference
from lommel.show.energy import encircled_energy
from lommel.show.focus import focus_curves, through_focus
from lommel.show.rays import spots
from lommel.show.transfer import mtf

__all__ = ["difference", "encircled_energy", "focus_curves", "mtf", "spots", "through_focus"]
