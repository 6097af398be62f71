"""Files: PSFs, PSF grids, photographs, depth maps and frames, in registered formats."""
