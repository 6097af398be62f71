"""The live page: the core compiled for browsers, with every control; served, saved, or in a notebook."""
