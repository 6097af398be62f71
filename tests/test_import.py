"""What `import lommel` brings, what it does not, and which way the modules depend on each other."""

from __future__ import annotations

import ast
import pickle
import re
import runpy
import subprocess
import sys
import tomllib
from graphlib import TopologicalSorter
from importlib.metadata import version
from pathlib import Path

import pytest

import lommel as lm
import organisation
from cases import each

HEADERS = organisation.headers()
ROOT = Path(__file__).resolve().parent.parent
TYPED = ROOT / "tests" / "shared" / "typed.py"


def python(code: str) -> str:
    command = [sys.executable, "-W", "error", "-c", code]
    result = subprocess.run(command, capture_output=True, text=True, timeout=300, check=False)
    assert result.returncode == 0, result.stderr
    return result.stdout


def test_importing_the_package_imports_no_library_that_is_optional_or_slow():
    loaded = set(python("import sys, lommel; print(*sys.modules)").split())
    assert "lommel.psf" in loaded
    assert not loaded & {"scipy", "matplotlib", "pydantic", "cyclopts", "rich", "tifffile", "PIL", "tomllib"}


@pytest.mark.parametrize("code", ["lm.load_instrument", "lm.live('lens.toml')"])
def test_lens_files_without_their_library_name_the_extra_that_brings_it(code):
    blocked = (
        "import sys, importlib.util as u; f = u.find_spec; u.find_spec = lambda n: n != 'pydantic' and f(n) or None"
    )
    told = python(f"{blocked}\nsys.modules['pydantic'] = None\nimport lommel as lm\ntry: {code}\n"
                  "except ImportError as error: print(error)")  # fmt: skip
    assert 'pydantic: pip install pydantic (the extra "cli" of lommel' in told


def test_what_makes_pupils_waits_until_one_is_made():
    made = {"lommel.optics.pupil", "lommel.optics.wavefront.wavefront", "lommel.special.zernike"}
    assert not set(python("import sys, lommel; print(*sys.modules)").split()) & made
    code = "import sys, lommel as lm; lm.Pupil(); print(*sys.modules)"
    assert set(python(code).split()) >= made


def test_a_psf_by_the_default_method_needs_no_optional_library():
    code = "import sys, lommel as lm; lm.psf(lm.Pupil(lm.Wavefront(9.0)), 9, 0.5); print(*sys.modules)"
    assert not set(python(code).split()) & {"matplotlib", "pydantic", "cyclopts", "rich", "tifffile", "PIL"}


@pytest.mark.parametrize(
    "code",
    [
        "import lommel.psf, lommel as lm",
        "import lommel as lm; import lommel.psf",
        "import lommel as lm; lm.Pupil, lm.best_focus; import lommel.psf, lommel.measures",
        "from lommel.psf import PSF; import lommel as lm",
    ],
)
def test_psf_is_the_function_however_the_module_of_its_name_was_imported(code):
    assert python(f"{code}; print(lm.psf(lm.Pupil(), 3, 0.5).shape)") == "(3, 3)\n"


@each("name", lm.__all__)
def test_every_public_name_resolves_to_a_thing_of_that_name(name):
    assert getattr(lm, name).__name__ == name
    assert name in dir(lm)
    assert getattr(lm, name).__doc__


def test_a_star_import_brings_the_public_names_and_nothing_else():
    names = set(python("from lommel import *; print(*dir())").split())
    assert {name for name in names if not name.startswith("__")} == set(lm.__all__)


def test_type_checkers_see_every_name_and_no_other():
    # What is of another module is exported by being called the same; what is missing there is found by `make types`.
    stub = ast.parse(Path(lm.__file__).with_suffix(".pyi").read_text(encoding="utf-8"))
    imports = [node for node in stub.body if isinstance(node, ast.ImportFrom)]
    exported = {name.asname for node in imports for name in node.names if name.name == name.asname}
    modules = {name.asname for node in imports if node.module == "lommel" for name in node.names}
    assert exported - modules == set(lm.__all__)
    assert len(exported) <= 95, "name what programs call; results and options are found in their modules"
    assert [ast.unparse(node) for node in stub.body[1:] if node not in imports] == ["__version__: str"]
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    assert TYPED.relative_to(ROOT).as_posix() in project["tool"]["mypy"]["files"]


def test_what_types_are_stated_of_the_package_is_so():
    runpy.run_path(str(TYPED), run_name="__main__")


@each("name", ["psf", "Pupil", "PSF", "strehl"])
def test_what_is_pickled_is_the_thing_itself(name):
    assert pickle.loads(pickle.dumps(getattr(lm, name))) is getattr(lm, name)


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


def upward(here: str, tree: ast.AST) -> list[str]:
    needs = [*organisation.imported(tree), *organisation.named(tree)]
    return organisation.upward(organisation.ORDER, here, [other for _, other in needs])


def test_the_files_that_are_read_are_those_that_are_imported():
    assert Path(lm.__file__).parent == organisation.PACKAGE


def test_every_file_has_a_place_in_the_order():
    assert {organisation.package_of(name) for name in organisation.modules()} == set().union(*organisation.ORDER)
    assert {organisation.package_of(name) for name in HEADERS} == set().union(*organisation.CORE_ORDER)


@pytest.mark.quick
def test_data_flows_one_way():
    found = {name: upward(name, tree) for name, tree in organisation.modules().items()}
    assert {name: others for name, others in found.items() if others} == {}


def test_the_table_of_modules_has_every_package_in_the_order_of_imports():
    table = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8").partition("\n|---|---|\n")[2].partition("\n\n")[0]
    names = re.findall(r"`(\w+)(?:\.py)?`", " ".join(line.split("|")[1] for line in table.splitlines()))
    rank = {name: at for at, packages in enumerate(organisation.ORDER) for name in packages}
    assert rank.keys() - names == {"the package"}
    listed = [name for name in names if name in rank]
    assert listed == sorted(listed, key=rank.get)


def test_headers_include_one_way():
    found = {name: organisation.upward(organisation.CORE_ORDER, name, others) for name, others in HEADERS.items()}
    assert {name: others for name, others in found.items() if others} == {}


@pytest.mark.quick
def test_no_file_needs_itself_by_way_of_others():
    needs = {
        name: {other for _, other in organisation.imported(tree)} for name, tree in organisation.modules().items()
    }
    assert set(TopologicalSorter(needs).static_order()) == {*needs, "_core"}
    assert set(TopologicalSorter(HEADERS).static_order()) == set(HEADERS)


def test_the_list_of_files_describes_every_module_and_header():
    listed = set(re.findall(r"^\| `([\w/.]+)` \| .+ \|$", organisation.listing(), flags=re.MULTILINE))
    assert listed == {f"{name}.py" for name in organisation.modules()} | {f"{name}.hpp" for name in HEADERS}
