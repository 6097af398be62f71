"""PSFs, and grids of them, to files and back."""
