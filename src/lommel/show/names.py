"""The plots that `lommel.show` offers by name."""

from lommel.show.curves import encircled_energy, mtf
from lommel.show.focus import focus_curves, through_focus
from lommel.show.plot import difference
from lommel.show.rays import spots

__all__ = ["difference", "encircled_energy", "focus_curves", "mtf", "spots", "through_focus"]
