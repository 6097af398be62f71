"""Stacks of PSFs larger than memory: computed chunk by chunk into Zarr or HDF5, resumed, read lazily."""
