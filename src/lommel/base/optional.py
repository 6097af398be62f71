"""Optional libraries: imported where they are used, with a message on how to install them."""

from __future__ import annotations

from importlib import import_module
from pathlib import Path
from types import ModuleType

# Extras that no target of the Makefile installs.
_NOT_LOCKED = ("torch", "cupy")
_TO_INSTALL = {
    "OpenEXR": "openexr",
    "PIL": "pillow",
    "pillow_heif": "pillow-heif",
    "cv2": "opencv-python-headless",
    "dask": '"dask[array]"',
}


def library(name: str, user: str, extra: str) -> ModuleType:
    """Return an optional module; ImportError that names its `user` and the `extra` that installs it."""
    try:
        return import_module(name)
    except ModuleNotFoundError:
        raise ImportError(f"{user} {how_to_get(name, extra)}") from None
    except ImportError as error:  # installed, but cannot be loaded, for example for lack of memory
        raise ImportError(f"{user} {name}, which cannot be loaded: {' '.join(str(error).split())}") from None


def require(name: str, user: str, extra: str) -> None:
    """Raise the ImportError of :func:`library` if a module is missing, without importing the module."""
    from importlib.util import find_spec  # late: rarely needed

    if find_spec(name.partition(".")[0]) is None:
        raise ImportError(f"{user} {how_to_get(name, extra)}")


def how_to_get(name: str, extra: str) -> str:
    """Return instructions to install a module, for users of wheels and of clones of the repository."""
    top = name.partition(".")[0]
    # The environment of a clone has no pip.
    clone = Path(__file__).parents[3] / "Makefile"
    clone_hint = "; in a clone, make env" if clone.is_file() and extra not in _NOT_LOCKED else ""
    extra_hint = f' (the extra "{extra}" of lommel brings it{clone_hint})' if extra else ""
    return f"{top}: pip install {_TO_INSTALL.get(top, top)}{extra_hint}"


def version() -> str:
    """Return the installed version."""
    from importlib import metadata  # late: takes as long as the rest of `import lommel`

    return metadata.version("lommel")
