"""Files: PSFs, grids of them, photographs, depths and frames, each kind in formats that a registry knows."""
