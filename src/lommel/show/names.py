"""The plots that `lommel.show` offers by name."""

from lommel.show.curves import encircled_energy, focus_curves, mtf, through_focus
from lommel.show.plot import difference, spots

__all__ = ["difference", "encircled_energy", "focus_curves", "mtf", "spots", "through_focus"]
