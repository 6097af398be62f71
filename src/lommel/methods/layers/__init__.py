"""Methods for light through the plane layers of a microscope."""
