"""The version of the package, as its metadata has it."""

from __future__ import annotations


def version() -> str:
    """Return the version that is installed."""
    from importlib import metadata  # takes as long as the rest of `import lommel`

    return metadata.version("lommel")
