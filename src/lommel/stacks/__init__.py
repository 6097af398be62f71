"""Stacks of PSFs larger than memory: computed chunk by chunk into Zarr, resumed, read lazily."""
