"""Methods for microscope objectives: light through plane layers."""
