# Needs make, a C++17 compiler and a Python >= 3.11 with its headers. All else is fetched, at the
# versions and hashes in requirements.lock, into .venv and .tools.

ifeq ($(filter oneshell,$(.FEATURES)),)
$(error This Makefile needs GNU make 4 or newer)
endif

SHELL := /bin/sh
.SHELLFLAGS := -eu -c
.ONESHELL:
.DELETE_ON_ERROR:
.SUFFIXES:
.PHONY: help env uv build psf photo fetch test test-c test-torch test-napari test-clang test-arm fuzz lowest mutants sanitize bench setup-times peers docs page lint tidy types format changelog lock wheel sdist release clean FORCE

# make PYTHON=/usr/bin/python3.12 env picks an interpreter; otherwise the first that will do is used.
PYTHON ?=

# What other environments leave behind must not reach this one. Indexes, caches and certificates
# that are set for pip or uv stay in force.
unexport CONDA_PREFIX PYTHONDONTWRITEBYTECODE PYTHONHOME PYTHONOPTIMIZE PYTHONPATH PYTHONSAFEPATH PYTHONSTARTUP PYTHONWARNINGS VIRTUAL_ENV
unexport PIP_CONSTRAINT PIP_NO_BINARY PIP_NO_DEPS PIP_PREFIX PIP_PYTHON PIP_REQUIREMENT PIP_ROOT PIP_TARGET
unexport UV_BUILD_CONSTRAINT UV_CONSTRAINT UV_DIRECTORY UV_EXCLUDE UV_EXCLUDE_NEWER UV_FORK_STRATEGY
unexport UV_MANAGED_PYTHON UV_NO_BINARY UV_NO_BUILD UV_NO_BUILD_ISOLATION UV_NO_MANAGED_PYTHON UV_NO_VERIFY_HASHES
unexport UV_OVERRIDE UV_PRERELEASE UV_PROJECT UV_PROJECT_ENVIRONMENT UV_PYTHON UV_PYTHON_PREFERENCE
unexport UV_REQUIRE_HASHES UV_RESOLUTION UV_SYSTEM_PYTHON UV_VENV_SEED UV_WORKING_DIR UV_WORKING_DIRECTORY
# An activated .venv must not have its own uv or Python remake it.
export PATH := $(subst $(CURDIR)/.venv/bin:,,$(PATH))
# No make is started from here, and ninja cannot use the job server of this one.
unexport MAKEFLAGS MFLAGS
export PIP_REQUIRE_VIRTUALENV := 0
export PIP_ROOT_USER_ACTION := ignore
export PIP_USER := 0
export PYTHONNOUSERSITE := 1
export UV_PYTHON_DOWNLOADS := never

# Sets $py to the interpreter that .venv is made with: the first that has the headers to compile
# against, or else the first that is new enough. Of an active virtualenv it is the base one.
define find_python
py=
for wanted in Python.h ""; do
	for name in $(if $(PYTHON),"$(PYTHON)",python3 python3.14 python3.13 python3.12 python3.11 python); do
		py=$$("$$name" -c '$(print_python)' "$$wanted" 2>/dev/null) && break 2
		py=
	done
done
if [ -z "$$py" ]; then
	echo "make: no Python >= 3.11 $(if $(PYTHON),at $(PYTHON),on PATH). Install one, or name it: make PYTHON=/path/to/python3 env" >&2
	exit 1
fi
endef

define print_python
import os, sys, sysconfig
assert sys.version_info >= (3, 11)
assert os.path.exists(os.path.join(sysconfig.get_path("include"), sys.argv[1]))
print(sys._base_executable)
endef

# Prints what requirements.lock has of the package $(1).
locked = awk -v name="$(1)==" 'index($$0, name) == 1 { on = 1 } on { print } on && !/\\$$/ { exit }' requirements.lock

# Sets $uv: the one on PATH, where there is one that works, or else the locked one in .tools. A pip that is there already
# fetches it in a third of the time of one in a new environment.
define find_uv
uv=uv
if ! uv pip install --group build --no-python-downloads --help >/dev/null 2>&1; then
	uv="$(CURDIR)/.tools/uv"
	mkdir -p .tools
	$(call locked,uv) >.tools/uv.txt.new
	if ! [ -x .tools/uv ] || ! cmp -s .tools/uv.txt.new .tools/uv.txt; then
		$(find_python)
		echo "Fetching uv into .tools"
		rm -rf .tools/uv .tools/tmp
		set -- --quiet --disable-pip-version-check --require-hashes --no-deps --only-binary :all: --requirement .tools/uv.txt.new
		if PYTHONNOUSERSITE= "$$py" -m pip --version >/dev/null 2>&1; then
			PYTHONNOUSERSITE= "$$py" -m pip install --target .tools/tmp "$$@"
		elif "$$py" -m venv .tools/tmp >/dev/null 2>&1; then
			.tools/tmp/bin/python -m pip install "$$@"
		else
			echo "make: $$py has neither venv nor pip to fetch uv with." >&2
			echo "make: install uv, or on Debian and Ubuntu python3-venv or python3-pip." >&2
			exit 1
		fi
		mv .tools/tmp/bin/uv .tools/uv
		rm -rf .tools/tmp
	fi
	mv .tools/uv.txt.new .tools/uv.txt
fi
endef

# What other environments than .venv are asked for.
everything := --requirement pyproject.toml --extra all --group dev --group tools

# Makes the environment .tools/$(1), beside .venv, of what the options $(2) ask for.
define environment
$(find_uv)
$(find_python)
rm -rf .tools/$(1)
"$$uv" venv --quiet --python "$$py" .tools/$(1)
"$$uv" pip install --quiet --python .tools/$(1)/bin/python $(2)
endef

# Compiles the package in build/$(1) and installs it in .tools/$(1).
define installed
PATH="$(CURDIR)/.tools/$(1)/bin:$$PATH" "$$uv" pip install --quiet --python .tools/$(1)/bin/python \
	--no-build-isolation --no-deps --config-settings=build-dir=build/$(1) --editable .
endef

help: ## list these targets
	@awk -F ':.*## ' '/^[a-z-]+:.*## / { printf "make %-11s %s\n", $$1, $$2 }' Makefile

# .venv is sound if it was made for this folder and this PYTHON, and its interpreter is still there.
env_is_sound := $(shell { .venv/bin/python -I -c '' && [ "$$(sed -n 1p .venv/first.stamp)" = "$(CURDIR)" ] && \
	{ [ -z "$(PYTHON)" ] || [ "$$(sed -n 2p .venv/first.stamp)" = "$(PYTHON)" ]; } && echo yes; } 2>/dev/null)

# What pyproject.toml asks for, at the versions and hashes of requirements.lock, without which nothing is installed.
install := pip install --python .venv/bin/python --require-hashes --constraint requirements.lock --requirement pyproject.toml

# .venv is filled in two stages, of which a first picture takes the first alone: what compiles the package and runs make psf.
# Whether it takes a CMake and a Ninja too is for scikit-build-core to say.
.venv/first.stamp: requirements.lock $(if $(env_is_sound),,FORCE)
	@$(find_uv)
	$(find_python)
	rm -rf .venv
	"$$uv" venv --quiet --python "$$py" .venv
	printf '%s\n' "$(CURDIR)" "$(PYTHON)" >.venv/first.stamp.new
	"$$uv" $(install) --extra images --group build
	missing=$$(.venv/bin/python -c 'from scikit_build_core.build import get_requires_for_build_editable as missing; print(*missing())')
	if [ -n "$$missing" ]; then
		for tool in $$missing; do $(call locked,$${tool%%[<>=]*}); done >.venv/tools.txt
		"$$uv" pip install --python .venv/bin/python --require-hashes --requirement .venv/tools.txt
	fi
	mv .venv/first.stamp.new $@

env: .venv/env.stamp ## make .venv with all that plots, tests and other formats take, as requirements.lock has it

.venv/env.stamp: .venv/first.stamp
	@$(find_uv)
	"$$uv" $(install) --extra all --group dev
	touch $@

uv:
	@$(find_uv)

cpp_formatted := $(wildcard cpp/bindings/* cpp/c/*.cpp cpp/compiled/* cpp/wasm/* cpp/include/lommel/*.hpp cpp/include/lommel/*/*.hpp cpp/tests/* tests/cmake_consume/*.cpp)

# Python files are read from src, so only C++ ones lead to a rebuild when they change. But one of any
# kind that was there at the last build and is gone also does, for the editable install has it on its
# list. A stamp takes its time from the start of the work, so that no edit made meanwhile is missed.
# What is in cpp/wasm is for browsers.
cpp_files := $(sort $(shell find cpp -path cpp/wasm -prune -o -type f -print 2>/dev/null))
all_files := $(sort $(cpp_files) $(shell find src -type f -name '*.py' 2>/dev/null))
gone_files := $(filter-out $(all_files),$(shell cat .venv/build.stamp 2>/dev/null))

build: .venv/build.stamp ## compile the core and install the package, editable, in .venv

# Wheels are compiled in the folder of the editable install, with all that it has.
build_folder := build/{cache_tag}

# Where C++ files alone have changed since the package was installed, its module is compiled and put there without a new install.
.venv/build.stamp: .venv/first.stamp pyproject.toml CMakeLists.txt $(wildcard cmake/*) $(cpp_files) $(if $(gone_files),FORCE)
	@echo "$(all_files)" >$@.new
	echo "Compiling the core: one or two minutes of two processors where all of it is new"
	folder=build/$$(.venv/bin/python -c 'import sys; print(sys.implementation.cache_tag)')
	cmake=$$(awk -F = '/^CMAKE_COMMAND:/ { print $$2 }' "$$folder/CMakeCache.txt" 2>/dev/null) || :
	if $(if $(filter-out $(cpp_files),$?),false,[ -x "$$cmake" ] && grep -q '^SKBUILD_STATE:.*=editable$$' "$$folder/CMakeCache.txt"); then
		"$$cmake" --build "$$folder"
		"$$cmake" --install "$$folder" --strip --prefix "$$(.venv/bin/python -c 'import sysconfig; print(sysconfig.get_path("platlib"))')" >/dev/null
		mv $@.new $@
		exit
	fi
	rm -f $@
	if ! .venv/bin/python -c '$(print_python)' Python.h >/dev/null 2>&1; then
		echo "make: the headers of this Python (Python.h) are missing." >&2
		echo "make: install python3-dev (Debian, Ubuntu) or python3-devel (Fedora), or choose another: make PYTHON=... env" >&2
		exit 1
	fi
	$(find_uv)
	PATH="$(CURDIR)/.venv/bin:$$PATH" "$$uv" pip install --quiet --python .venv/bin/python --reinstall --no-build-isolation --no-deps \
		--config-settings=build-dir='$(build_folder)' --editable .
	mv $@.new $@

psf: build ## compile, the first time, compute the PSF of Hubble in 1990 and draw it beside the design, to out/hubble-1990.*
	@mkdir -p out
	.venv/bin/lommel psf examples/lenses/hubble-1990.toml --output out/hubble-1990.tif
	.venv/bin/python examples/hubble.py out/hubble-1990.png

# Where the depth is unknown, it is that of the nearest point.
photo: build env ## blur a photograph by its depth, near, far and from one to the other; undo it; find the depth; to out/motorcycle-*
	@.venv/bin/python examples/motorcycle.py out
	lens=examples/motorcycle.toml
	set -- out/motorcycle-depth.tif "$$lens" --missing nearest
	.venv/bin/lommel blur out/motorcycle.png "$$@" --focus 2.4m --output out/motorcycle-near.png
	.venv/bin/lommel blur out/motorcycle.png "$$@" --focus 4.8m --output out/motorcycle-far.png
	.venv/bin/lommel blur out/motorcycle.png "$$@" --focus 2.2m --focus-to 4.8m --frames 6 --tol 1e-3 \
		--output out/motorcycle-pull.webp
	.venv/bin/lommel restore out/motorcycle-near.png "$$@" --focus 2.4m --white 50000 --read 3 \
		--output out/motorcycle-restored.png
	.venv/bin/lommel depth out/motorcycle-near.png out/motorcycle-far.png "$$lens" --focus 2.4m --focus 4.8m \
		--between 2m 5.2m --white 50000 --read 3 --output out/motorcycle-found.tif --plot out/motorcycle-found.png

# Fills uv's cache with what .venv lacks while the core is compiled, in a folder of its own: .venv is locked meanwhile.
fetch: .venv/first.stamp
	@[ ! -e .venv/env.stamp ] || exit 0
	$(find_uv)
	{ "$$uv" $(install) --extra all --group dev --quiet --target .tools/fetched || :; rm -rf .tools/fetched; } >/dev/null 2>&1 &

# Types are checked meanwhile: one processor would wait.
test: fetch build env lint ## build, lint, check the types and run the tests
	@.venv/bin/mypy & types=$$!
	.venv/bin/pytest --numprocesses auto --maxprocesses 4 --dist worksteal || status=$$?
	wait $$types
	exit $${status:-0}

# Beside .venv, for the package index has PyTorch with all that graphics processors need: 5 GB, of which none is used here.
# UV_TORCH_BACKEND=cpu make test-torch takes it from its own index, which has one without; TORCH=... a wheel that is there.
TORCH ?= torch
test-torch: build ## run the tests of differentiable functions in PyTorch, in .tools/torch
	@$(call environment,torch,$(everything) --extra torch "$(TORCH)" deepinv)
	$(call installed,torch)
	.tools/torch/bin/python -m pytest -p no:cacheprovider -W default::DeprecationWarning tests/traced \
		tests/imaging/test_traced_blur.py tests/imaging/test_traced_sensor.py tests/adapters/test_deepinv.py

# Compiles the core once more, as a shared library.
test-c: build env ## build the C interface and test it from C, ctypes and, where there is a rustc, Rust: a minute or two
	@LOMMEL_C=1 .venv/bin/pytest -n 0 tests/core/test_c_interface.py

# Needs a virtual display (on Debian and Ubuntu the packages xvfb and xauth, and the libraries of Qt: libegl1, libxkbcommon-x11-0,
# libxcb-cursor0 and others).
test-napari: build ## run the tests of the plugin in napari, under a virtual display, in .tools/napari
	@command -v xvfb-run >/dev/null || { echo "make: there is no xvfb-run on PATH: install xvfb and xauth" >&2; exit 1; }
	$(call environment,napari,$(everything) "napari[pyqt6]>=0.6")
	$(call installed,napari)
	xvfb-run -a .tools/napari/bin/python -m pytest -p no:cacheprovider -W default tests/napari_plugin

# Needs clang++ (on Debian and Ubuntu the package clang).
test-clang: ## compile the core by clang++ and run the tests, in .tools/clang
	@command -v clang++ >/dev/null || { echo "make: there is no clang++ on PATH: install clang" >&2; exit 1; }
	$(call environment,clang,--require-hashes --constraint requirements.lock $(everything))
	export CXX=clang++
	$(call installed,clang)
	.tools/clang/bin/python -m pytest -p no:cacheprovider --numprocesses auto --maxprocesses 4 --dist worksteal

# Needs a cross compiler and an emulator (on Debian and Ubuntu the packages g++-aarch64-linux-gnu and qemu-user). There long
# double has four times the bits, in software: tables are compared in double.
ARM_CXX ?= aarch64-linux-gnu-g++
ARM ?= qemu-aarch64
test-arm: ## compile the core for 64-bit ARM and run its own programs, emulated: five minutes
	@for tool in $(ARM_CXX) $(ARM); do
		command -v $$tool >/dev/null || { echo "make: there is no $$tool on PATH: install g++-aarch64-linux-gnu and qemu-user" >&2; exit 1; }
	done
	mkdir -p build
	for program in calls slopes layers measures exercise tables molecules occlusion; do
		echo "$(ARM_CXX): $$program"
		wide=
		if [ $$program = tables ]; then wide=-DLOMMEL_WIDE=double; fi
		$(ARM_CXX) -std=c++17 -O2 -static $$wide -Wall -Wextra -Werror -Wno-psabi -Icpp/include cpp/tests/$$program.cpp -o build/$$program.arm -pthread
		$(ARM) build/$$program.arm
	done

# 100 000 bad arguments, 2 000 bad command lines, 1 000 mutations of each kind of file; `make test` has a sample.
fuzz: build env ## try what no user should: bad arguments, command lines and files
	@LOMMEL_FUZZ=1 .venv/bin/pytest tests/fuzz

# Everything that pyproject.toml names, at the lowest version that it allows. The oldest have no wheels for the newest
# Pythons: make lowest PYTHON=python3.11.
lowest: ## run the tests with the oldest versions of all dependencies, in .tools/lowest
	@# The oldest matplotlib calls functions that newer versions of pyparsing warn of.
	$(call environment,lowest,--resolution lowest-direct --only-binary :all: $(everything) "pyparsing==3.2.*")
	$(call installed,lowest)
	# What newer versions of others deprecate is nothing to the oldest; the stub is as the locked nanobind writes it.
	.tools/lowest/bin/python -m pytest -p no:cacheprovider -W default::DeprecationWarning \
		--deselect tests/test_core.py::test_the_stub_is_what_the_compiled_module_says_of_itself

# Of the core, of error bounds and of limits, as tests/mutants lists them: hours of work for one processor. ONLY="ellipse.hpp
# debye.py:2" takes some, FLAGS=--subject the tests of their subject only, FLAGS="--random 200 --seed 1" faults that chance
# draws from all of the code.
mutants: build env ## put faults into a copy of the code, one by one, and see that the tests notice
	@.venv/bin/python tests/mutants/run.py $(FLAGS) $(ONLY)

# The core alone, without Python: memory, undefined behaviour, then data races; and as it is where there are neither
# threads nor wider numbers than double.
sanitize: ## exercise the compiled core under the compiler's sanitizers
	@mkdir -p build
	# Runs the program $$2 with the sanitizers $$1, compiled with the remaining arguments.
	sanitized() {
		kind=$$1 program=$$2
		shift 2
		echo "sanitizers: $$kind: $$program $$*"
		$(CXX) -std=c++17 -O1 -g -fno-omit-frame-pointer -fsanitize=$$kind -fno-sanitize-recover=all "$$@" \
			-Wall -Wextra -Wno-psabi -Icpp/include cpp/tests/$$program.cpp -o build/$$program -pthread
		build/$$program
	}
	for kind in address,undefined thread; do
		for program in calls exercise slopes layers molecules occlusion; do sanitized $$kind $$program; done
	done
	sanitized address,undefined exercise -DLOMMEL_SINGLE_THREADED -DLOMMEL_WIDE=double
	sanitized address,undefined tables -DLOMMEL_WIDE=double
	sanitized address,undefined measures
	# Where there are no vectors, and nothing that other compilers do not know.
	sanitized address,undefined calls -DLOMMEL_WITHOUT_VECTORS -pedantic-errors
	sanitized address,undefined layers -DLOMMEL_WITHOUT_VECTORS -pedantic-errors
	sanitized address,undefined molecules -DLOMMEL_WITHOUT_VECTORS -pedantic-errors
	# Each header with nothing included before it.
	for header in $(wildcard cpp/include/lommel/*.hpp cpp/include/lommel/*/*.hpp); do
		$(CXX) -std=c++17 -O0 -fsyntax-only -Wall -Wextra -Wno-psabi -Icpp/include -x c++ /dev/null -include "$$header"
	done

# What Sphinx needs comes on top of what is in .venv, and only when the pages are asked for.
.venv/docs.stamp: .venv/env.stamp docs/requirements.lock
	@$(find_uv)
	"$$uv" pip install --quiet --python .venv/bin/python --require-hashes --requirement docs/requirements.lock
	touch $@

docs: build page .venv/docs.stamp ## write the documentation to docs/_build/html, running the gallery
	@rm -rf docs/api # may hold pages of names that are gone
	MPLBACKEND=Agg .venv/bin/python -m sphinx -q -W --keep-going -n -b html -d docs/_build/doctrees docs docs/_build/html
	.venv/bin/python docs/check.py docs/_build/html
	echo "docs/_build/html/index.html"

# A compiler for browsers, which needs no root, and what its tests drive browsers with: 200 MB on top of what is in .venv. The
# first time the compiler makes its own library of C++.
.venv/page.stamp: .venv/first.stamp web/requirements.lock
	@$(find_uv)
	"$$uv" pip install --quiet --python .venv/bin/python --require-hashes --requirement web/requirements.lock
	touch $@

page_module := src/lommel/page/lommel-live.js
page: $(page_module) ## make the live page's module, src/lommel/page/lommel-live.js; fetches 200 MB the first time

$(page_module): .venv/build.stamp .venv/page.stamp $(wildcard web/* cpp/wasm/*) src/lommel/page/state.py $(wildcard examples/lenses/*)
	@.venv/bin/python web/build.py --output $@

lint: env ## check the style and the format
	@.venv/bin/ruff check
	.venv/bin/ruff format --check
	.venv/bin/clang-format --dry-run -Werror $(cpp_formatted)

# Beside .venv: 50 MB that no test needs.
.tools/maintain.stamp: .ci/requirements.lock
	@$(call environment,maintain,--require-hashes --requirement .ci/requirements.lock)
	touch $@

# The core's own programs and compiled parts include every header between them; .clang-tidy has the checks.
tidy: .tools/maintain.stamp ## check the core by clang-tidy: half a minute
	@for unit in cpp/tests/*.cpp cpp/compiled/*.cpp; do
		.tools/maintain/bin/clang-tidy --quiet "$$unit" -- -std=c++17 -Icpp/include
	done

# FLAGS=--draft shows what it would write; see changes/README.md.
changelog: .tools/maintain.stamp ## gather the fragments in changes/ into CHANGELOG.md, for a release
	@.tools/maintain/bin/towncrier build --yes --version "$$(sed -n 's/^version = "\(.*\)"$$/\1/p' pyproject.toml)" $(FLAGS)

types: env ## check the types
	@.venv/bin/mypy

bench: build env ## measure against the FFT, NumPy and what peers there are; write docs/benchmarks.md
	@.venv/bin/python benchmarks/run.py --write

# A fresh clone of what is committed, with nothing in the caches of uv and pip; FLAGS=--test runs the tests in it as well.
setup-times: ## measure the way from a fresh clone to a first picture, and from an edit to a passing test
	@$(find_python)
	"$$py" benchmarks/setup_times.py $(FLAGS)

# Beside .venv, which stays as requirements.lock has it. One of the packages brings PyTorch: gigabytes.
GROUP ?= peers
peers: build ## fetch other packages for make bench to compare with, into .tools/peers
	@$(find_uv)
	rm -rf .tools/peers
	"$$uv" pip install --quiet --python .venv/bin/python --target .tools/peers --constraint requirements.lock --group $(GROUP)
	# Of Picasso its fits alone, without the windows that it draws.
	"$$uv" pip install --quiet --python .venv/bin/python --target .tools/peers --no-deps picassosr==0.11.3

format: env ## rewrite the files in the project's format
	@.venv/bin/ruff check --fix-only
	.venv/bin/ruff format
	.venv/bin/clang-format -i $(cpp_formatted)

# Pins that still do are kept; make lock LOCKFLAGS=--upgrade moves them all.
lock: ## pin anew, in the files requirements.lock, what pyproject.toml asks for
	@$(find_uv)
	# Sets the lock file $$1 to what the remaining arguments ask for.
	compile() {
		file=$$1
		shift
		if [ -f "$$file" ]; then cp "$$file" "$$file.new"; fi
		"$$uv" pip compile --quiet --universal --python-version 3.11 --generate-hashes \
			--no-annotate --custom-compile-command "make lock" $(LOCKFLAGS) --output-file "$$file.new" "$$@"
		if cmp -s "$$file.new" "$$file"; then rm "$$file.new"; else mv "$$file.new" "$$file"; fi
	}
	compile requirements.lock --extra all --group dev --group tools pyproject.toml
	{
		echo "# Written from requirements.lock by make lock: what builds wheels is what builds here. See docs/releasing.md."
		sed -nE 's/^((cmake|nanobind|ninja|packaging|pathspec|scikit-build-core)==[^ ;]+).*/\1/p' requirements.lock
	} >.ci/build-constraints.txt
	compile docs/requirements.lock --extra all --group docs --constraints requirements.lock pyproject.toml
	compile web/requirements.lock --extra all --group page --constraints requirements.lock pyproject.toml
	compile .ci/requirements.lock --group maintain --constraints requirements.lock

wheel: page ## build a wheel in dist
	@$(find_uv)
	PATH="$(CURDIR)/.venv/bin:$$PATH" "$$uv" build --wheel --config-setting=build-dir='$(build_folder)' --no-build-isolation --python .venv/bin/python --out-dir dist

sdist: page ## pack the sources, with the live page, in dist
	@$(find_uv)
	PATH="$(CURDIR)/.venv/bin:$$PATH" "$$uv" build --sdist --no-build-isolation --python .venv/bin/python --out-dir dist

# Of what is committed. FLAGS="--arm FOLDER" adds a wheel for 64-bit ARM; see docs/releasing.md.
release: page .tools/maintain.stamp ## make dist/release, all that a maintainer uploads: a quarter of an hour of two processors
	@$(find_uv)
	UV="$$uv" .venv/bin/python release/build.py $(FLAGS)

clean: ## remove all that make made
	@rm -rf .venv .tools build dist requirements.lock.new docs/requirements.lock.new web/requirements.lock.new
	rm -f $(page_module)
	rm -rf docs/_build docs/_generated docs/api docs/gallery docs/sg_execution_times.rst
	rm -rf .hypothesis .mypy_cache .pytest_cache .ruff_cache
	rm -f out/hubble-1990.tif out/hubble-1990.png out/motorcycle.png out/motorcycle-*
	find src tests examples benchmarks -type d -name __pycache__ -prune -exec rm -rf {} +
	if [ -d out ]; then rmdir out 2>/dev/null || echo "out holds other files; kept"; fi

FORCE:
