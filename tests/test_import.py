"""What `import lommel` brings, what it does not, and which way the modules depend on each other."""

from __future__ import annotations

import ast
import subprocess
import sys
from importlib.metadata import version
from pathlib import Path

import pytest

import lommel as lm

PACKAGE = Path(lm.__file__).parent
MODULES = sorted(PACKAGE.rglob("*.py"))

# Each imports only what stands before it, or beside it in a package of its own.
ORDER = [
    {"validation", "atomic", "optional", "_core"},
    {"core"},
    {"units"},
    {"reading"},
    {"special"},
    {"descriptions", "aplanatic"},
    {"wavefront", "aperture", "apodization"},
    {"fitting", "faults", "opening"},
    {"zernikefile"},
    {"pupil"},
    {"lens", "interpolation"},
    {"grid"},
    {"methods"},
    {"quality"},
    {"psf"},
    {"imaging", "fieldmap"},
    {"fieldtable", "adapters", "instrument"},
    {"entries"},
    {"aperturefile"},
    {"lensfile"},
    {"metrics", "files", "plot"},
    {"fieldfiles"},
    {"encircled", "transfer", "spot"},
    {"report"},
    {"paper"},
    {"tables"},
    {"cli_parts"},
    {"cli_imaging", "cli_methods"},
    {"cli"},
    {"__main__"},
]
RANK = {name: rank for rank, names in enumerate(ORDER) for name in names}


def python(code: str) -> str:
    command = [sys.executable, "-W", "error", "-c", code]
    result = subprocess.run(command, capture_output=True, text=True, timeout=300, check=False)
    assert result.returncode == 0, result.stderr
    return result.stdout


def test_importing_the_package_imports_no_library_that_is_optional_or_slow():
    loaded = set(python("import sys, lommel; print(*sys.modules)").split())
    assert "lommel.psf" in loaded
    assert not loaded & {"scipy", "matplotlib", "pydantic", "click", "rich", "tifffile", "PIL", "tomllib"}


def test_a_psf_by_the_default_method_needs_no_optional_library():
    code = "import sys, lommel as lm; lm.psf(lm.Pupil(lm.Wavefront(9.0)), 9, 0.5); print(*sys.modules)"
    assert not set(python(code).split()) & {"matplotlib", "pydantic", "click", "rich", "tifffile", "PIL"}


@pytest.mark.parametrize(
    "code",
    [
        "import lommel.psf, lommel as lm",
        "import lommel as lm; import lommel.psf",
        "import lommel as lm; lm.Pupil, lm.best_focus; import lommel.psf, lommel.metrics",
        "from lommel.psf import PSF; import lommel as lm",
    ],
)
def test_psf_is_the_function_however_the_module_of_its_name_was_imported(code):
    assert python(f"{code}; print(lm.psf(lm.Pupil(), 3, 0.5).shape)") == "(3, 3)\n"


@pytest.mark.parametrize("name", lm.__all__)
def test_every_public_name_resolves_to_a_thing_of_that_name(name):
    assert getattr(lm, name).__name__ == name
    assert name in dir(lm)
    assert getattr(lm, name).__doc__


def test_a_star_import_brings_every_public_name():
    names = set(python("from lommel import *; print(*dir())").split())
    assert set(lm.__all__) <= names


def test_an_unknown_name_is_an_attribute_error():
    with pytest.raises(AttributeError, match="module 'lommel' has no attribute 'fft'"):
        lm.fft  # noqa: B018


def test_imaging_is_there_when_it_is_asked_for():
    assert python("import sys, lommel; print('lommel.imaging' in sys.modules)") == "False\n"
    assert python("import lommel as lm; print(lm.imaging.depth_of_field.__name__)") == "depth_of_field\n"
    assert "imaging" in dir(lm)


def test_the_version_is_that_of_the_metadata():
    assert lm.__version__ == version("lommel")
    assert "__version__" in dir(lm)


def room(path: Path) -> str:
    """The part of the package that a file belongs to."""
    return path.relative_to(PACKAGE).with_suffix("").parts[0]


def test_every_module_has_a_place_in_the_order():
    assert {room(path) for path in MODULES} | {"_core"} == set(RANK) | {"__init__"}


def imported(node: ast.Import | ast.ImportFrom) -> list[str]:
    """The rooms of the package that a statement imports."""
    if isinstance(node, ast.ImportFrom):
        assert node.level == 0
        if node.module == "lommel":
            return [alias.name for alias in node.names]
        names = [node.module or ""]
    else:
        names = [alias.name for alias in node.names]
    return [name.split(".")[1] for name in names if name.startswith("lommel.")]


@pytest.mark.parametrize(
    "path", [path for path in MODULES if room(path) != "__init__"], ids=lambda path: str(path.relative_to(PACKAGE))
)
def test_data_flows_one_way(path):
    tree = ast.parse(path.read_text(encoding="utf-8"))
    inside = {
        id(statement)
        for function in ast.walk(tree)
        if isinstance(function, ast.FunctionDef)
        for statement in ast.walk(function)
    }
    at_module_level = [
        statement
        for statement in ast.walk(tree)
        if isinstance(statement, ast.Import | ast.ImportFrom) and id(statement) not in inside
    ]
    here = room(path)
    assert at_module_level or len(tree.body) <= 1
    for statement in at_module_level:
        for other in imported(statement):
            assert RANK[other] < RANK[here] or other == here, f"{here} imports {other} (line {statement.lineno})"
