"""What there is to say about a lens and its PSFs, as plain data."""
