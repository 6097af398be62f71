"""The phase across the pupil: Zernike terms, measured maps, fits."""
