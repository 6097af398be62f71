"""Lenses: aperture, wavefront, pupil."""
