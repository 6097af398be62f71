"""Field of view of a lens: aberrations, vignetting and PSFs that vary over the sensor."""
