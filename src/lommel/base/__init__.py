"""The ground that all rooms stand on: checks, units, encodings, files read and written with care."""
