# Needs make, a C++17 compiler and a Python >= 3.11 with its headers. All else is installed, at the versions and hashes in
# requirements.lock, into .venv and .tools.
ifeq ($(filter oneshell,$(.FEATURES)),)
$(error This Makefile needs GNU make 4 or newer)
endif
SHELL := /bin/sh
.SHELLFLAGS := -eu -c
.ONESHELL .DELETE_ON_ERROR .SUFFIXES:
.PHONY: help env uv build core-tests psf photo test test-all browser test-c test-torch test-napari test-clang test-arm fuzz lowest mutants sanitize bench real-data setup-times peers docs page lint tidy types format changelog lock wheel sdist release clean FORCE

# make PYTHON=/usr/bin/python3.12 env picks an interpreter, CXX=clang++ a compiler; otherwise the first that will do is used.
PYTHON ?=
export CXX := $(if $(filter default,$(origin CXX)),$(firstword $(foreach name,c++ g++ clang++,$(if $(shell command -v $(name) 2>/dev/null),$(name))) c++),$(CXX))
find_python = .ci/python $(if $(PYTHON),"$(PYTHON)")
# Settings of another environment must not reach this one; indexes, caches and certificates for uv and pip stay in force.
network := %INDEX %INDEX_URL %FIND_LINKS %CACHE %CACHE_DIR %CERT %PROXY %TIMEOUT %RETRIES %OFFLINE %LINK_MODE %CONFIG_FILE \
	%KEYRING_PROVIDER PIP_TRUSTED_HOST UV_INDEX_% UV_HTTP_% UV_INSECURE_HOST UV_TORCH_BACKEND
unexport $(filter-out $(network),$(filter UV_% PIP_% PYTHON%,$(.VARIABLES))) CONDA_PREFIX VIRTUAL_ENV MAKEFLAGS MFLAGS
export PATH := $(subst $(CURDIR)/.venv/bin:,,$(PATH))
export PYTHONNOUSERSITE := 1
export UV_PYTHON_DOWNLOADS := never
# As pip does: among the certificates of the system may be that of a private authority.
export UV_SYSTEM_CERTS := 1
help: ## list these targets
	@awk -F ':.*## ' '/^[a-z-]+:.*## / { printf "make %-11s %s\n", $$1, $$2 }' Makefile
# The uv on PATH, where there is one that works, or else the locked one.
uv := $(if $(shell uv pip install --group build --no-python-downloads --help 2>/dev/null),uv,.tools/uv)
fetched := $(filter .tools/uv,$(uv))
.tools/uv: requirements.lock
	@python=$$($(find_python))
	.ci/uv "$$python"
uv: $(fetched)

# .venv is sound if it was made for this folder and this PYTHON, and its interpreter is still there.
sound := $(shell .venv/bin/python -Ic '' 2>/dev/null && case "$$(cat .venv/first.stamp)" in ("$(CURDIR)|$(PYTHON:%=%|)"*) echo yes;; esac)
locked := --require-hashes --constraint requirements.lock
install := pip install --python .venv $(locked) --requirement pyproject.toml
# .venv is filled in stages, of which the first compiles the package and runs make psf: with a CMake and a Ninja where
# scikit-build-core says that PATH has none that will do.
.venv/first.stamp: requirements.lock $(if $(sound),,FORCE) | $(fetched)
	@python=$$($(find_python))
	rm -rf .venv
	$(uv) venv --quiet --python "$$python" .venv
	$(uv) $(install) --extra images --group build
	missing=$$(.venv/bin/python -c 'from scikit_build_core.build import get_requires_for_build_editable as missing; print(*missing())')
	for tool in $$missing; do $(uv) pip install --python .venv $(locked) --group "$${tool%%[<>=]*}"; done
	echo "$(CURDIR)|$(PYTHON)|" >$@
# The groups dev, docs, page, real and maintain of pyproject.toml.
.venv/%.stamp: .venv/first.stamp | $(fetched)
	@$(uv) $(install) $(if $(filter dev,$*),--extra all) --group $*
	touch $@
env: .venv/dev.stamp ## make .venv with all that plots, tests and other formats take, as requirements.lock has it
# Compiles the package in the folder $(2) and installs it, editable, in the environment $(1).
package = PATH="$(CURDIR)/$(1)/bin:$$PATH" $(uv) pip install --quiet --python $(1) --reinstall --no-build-isolation --no-deps \
	--config-settings=build-dir='$(2)' --editable .
build_folder := build/{cache_tag}
folder = $(shell .venv/bin/python -c 'import sys; print("$(build_folder)".format(cache_tag=sys.implementation.cache_tag))')
cmake = "$(shell sed -n 's/^CMAKE_COMMAND:INTERNAL=//p' $(folder)/CMakeCache.txt)"
# The stamp lists the Python files, as the editable install does: where one is gone, that is made anew.
listed := $(shell cat .venv/build.stamp 2>/dev/null)
.venv/build.stamp: .venv/first.stamp pyproject.toml $(if $(filter-out $(wildcard $(listed)),$(listed)),FORCE)
	@echo "Compiling the core: one or two minutes of two processors where all of it is new"
	find src -name '*.py' >$@.new
	$(call package,.venv,$(build_folder))
	mv $@.new $@
# CMake knows what has changed since.
build: .venv/build.stamp ## compile the core and install the package, editable, in .venv
	@$(cmake) --build $(folder) $(if $(wildcard $(folder)/_core_tests.*),--target all core_tests)
	[ -n "$$(find $(folder) -maxdepth 1 -name '_core.*' -newer .venv/build.stamp)" ] || exit 0
	$(cmake) --install $(folder) --strip --prefix "$$(.venv/bin/python -c 'import sysconfig; print(sysconfig.get_path("platlib"))')" >/dev/null
	touch .venv/build.stamp
core-tests: build env ## compile what tests of the core alone call, once: make build then keeps it
	@$(cmake) --build $(folder) --target core_tests

psf: build ## compile, the first time, compute the PSF of Hubble in 1990 and draw it beside the design, to out/hubble-1990.*
	@mkdir -p out
	.venv/bin/lommel psf examples/lenses/hubble-1990.toml --output out/hubble-1990.tif
	.venv/bin/python examples/hubble.py out/hubble-1990.png
photo: build env ## blur a photograph by its depth, near, far and from one to the other; undo it; find the depth; to out/motorcycle-*
	@.venv/bin/python examples/motorcycle.py out
	PATH="$(CURDIR)/.venv/bin:$$PATH" sh examples/motorcycle.sh
pytest := .venv/bin/pytest --numprocesses auto --maxprocesses 4 --dist worksteal
# Runs the tests $(1); a file of the repository that is new or changed after them is an error.
tracked = git status --porcelain 2>/dev/null || true
define clean_after
before=$$($(tracked))
$(1) || status=$$?
after=$$($(tracked))
[ "$$before" = "$$after" ] || {
	printf 'make: files of the repository changed while the tests ran:\n%s\n' "$$after" >&2
	status=1
}
endef
test: core-tests lint ## build, lint, check the types and run all tests but the slowest
	@.venv/bin/mypy & types=$$!
	$(call clean_after,$(pytest) --quick)
	wait $$types
	exit $${status:-0}

# Packages of other projects are beside .venv, which stays as it is: in .tools/$(1) those of a group, for PYTHONPATH. The PyTorch of
# the lock brings 5 GB for graphics processors. TORCH takes another, without a hash: a wheel that is there, or, without those,
# UV_TORCH_BACKEND=cpu make test-torch TORCH="torch torchvision".
GROUP ?= peers
beside = TORCH="$(TORCH)" .ci/beside "$(uv)" $(1) $(2)
with = PYTHONPATH="$(CURDIR):$(subst .tools,$(CURDIR)/.tools,$(1))" $(pytest) -p no:cacheprovider -W default::DeprecationWarning
torch_tests := tests/traced tests/imaging/test_traced_blur.py tests/imaging/test_traced_sensor.py tests/imaging/field/test_blur.py \
	tests/adapters/test_deepinv.py
peer_tests := tests/adapters tests/compat tests/optics/layers/test_objective_peers.py
peers: build ## fetch other packages for make bench to compare with, or GROUP=lenses those of the adapters, into .tools/peers
	@$(call beside,peers,$(GROUP))
test-torch: build env ## run the tests of differentiable functions in PyTorch, in .tools/torch
	@$(call beside,torch,torch)
	$(call with,.tools/torch) $(torch_tests)
test-all: browser core-tests page .venv/page.stamp lint ## run all tests: slow and random ones, the live page in Chromium, C, PyTorch, peers: hours
	@.venv/bin/mypy
	LOMMEL_FUZZ=1 LOMMEL_C=1 $(pytest) --thorough || status=$$?
	for group in compat lenses peers torch; do
		$(call beside,$$group,$$group) || echo "make: the group $$group does not install here: tests of its packages are skipped" >&2
	done
	$(call with,.tools/compat:.tools/lenses:.tools/peers:.tools/torch) $(peer_tests) --thorough || status=$$?
	$(call with,.tools/torch) $(torch_tests) --thorough || status=$$?
	exit $${status:-0}
browser:
	@command -v "$${LOMMEL_BROWSER:-chromium}" || command -v chromium-browser || command -v google-chrome || \
		{ echo "make: tests of the live page need Chromium: install the package chromium, or set LOMMEL_BROWSER" >&2; exit 1; }
test-c: build env ## build the C interface and test it from C, ctypes and, where there is a rustc, Rust: a minute or two
	@LOMMEL_C=1 .venv/bin/pytest -n 0 tests/core/test_c_interface.py tests/core/test_live_pipe.py
# On Debian and Ubuntu the packages xvfb and xauth, and the libraries of Qt: libegl1, libxkbcommon-x11-0, libxcb-cursor0 and others.
test-napari: build env ## run the tests of the plugin in napari, under a virtual display (xvfb-run), in .tools/napari
	@command -v xvfb-run >/dev/null || { echo "make: there is no xvfb-run on PATH: install xvfb and xauth" >&2; exit 1; }
	$(call beside,napari,napari)
	PYTHONPATH="$(CURDIR)/.tools/napari" xvfb-run -a .venv/bin/pytest -p no:cacheprovider -W default tests/napari_plugin
fuzz: build env ## try what no user should: bad arguments, command lines and files
	@$(call clean_after,LOMMEL_FUZZ=1 .venv/bin/pytest tests/fuzz)
	exit $${status:-0}
mutants: core-tests ## put faults into a copy of the code, one by one, and see that the tests notice: hours
	@.venv/bin/python tests/mutants/run.py $(FLAGS) $(ONLY)

# Makes the environment .tools/$(1) of what the options $(2) ask for, compiles the package in build/$(1) and runs the tests.
define elsewhere
python=$$($(find_python))
rm -rf .tools/$(1)
$(uv) venv --quiet --python "$$python" .tools/$(1)
$(uv) pip install --quiet --python .tools/$(1) $(2) --requirement pyproject.toml --extra all --group dev --group tools
$(call package,.tools/$(1),build/$(1)' --config-settings='cmake.define.LOMMEL_TESTS=ON)
.tools/$(1)/$(pytest:.venv/%=%) -p no:cacheprovider
endef
test-clang: $(fetched) ## compile the core by clang++ and run the tests, in .tools/clang
	@export CXX=clang++
	$(call elsewhere,clang,$(locked))
# The oldest have no wheels for the newest Pythons: make lowest PYTHON=python3.11. The oldest matplotlib calls functions that newer
# versions of pyparsing warn of; what newer versions of others deprecate is nothing to the oldest. The oldest Hypothesis warns, now and
# then, of its own random numbers.
lowest: $(fetched) ## run the tests with the oldest versions of all dependencies that pyproject.toml allows, in .tools/lowest
	@$(call elsewhere,lowest,--resolution lowest-direct --only-binary :all: "pyparsing==3.2.*") -W default::DeprecationWarning \
		-W default::hypothesis.errors.HypothesisWarning \
		--deselect tests/test_core.py::test_the_stub_is_what_the_compiled_module_says_of_itself
# The core's own programs, as CMakePresets.json has them compiled. For ARM on Debian and Ubuntu: g++-aarch64-linux-gnu, qemu-user.
preset = PATH="$(CURDIR)/.venv/bin:$$PATH" cmake --workflow --preset $(1)
sanitize: .venv/first.stamp ## exercise the core under the compiler's sanitizers, and compile each header alone
	@for preset in address thread narrow standard; do $(call preset,$$preset); done
test-arm: .venv/first.stamp ## compile the core for 64-bit ARM and run its own programs, emulated: five minutes
	@$(call preset,arm)
tidy: .venv/maintain.stamp ## check the core by clang-tidy: half a minute
	@.venv/bin/clang-tidy --quiet cpp/tests/*.cpp cpp/compiled/*.cpp -- -std=c++17 -Icpp/include

docs: build env page .venv/docs.stamp ## write the documentation to docs/_build/html, running the gallery
	@rm -rf docs/api # may hold pages of names that are gone
	MPLBACKEND=Agg .venv/bin/python -m sphinx -q -W --keep-going -n -b html -d docs/_build/doctrees docs docs/_build/html
	.venv/bin/python tools/docs/check.py docs/_build/html
	echo "docs/_build/html/index.html"
# Which is committed, with a checksum of its sources: by times of files it would be compiled in every clone.
page: build ## make the live page's module, src/lommel/page/lommel-live.js, where its sources have changed; fetches 200 MB
	@.venv/bin/python web/build.py --check && exit
	$(uv) $(install) --group page
	.venv/bin/python web/build.py
cpp_formatted := $(wildcard cpp/bindings/* cpp/c/*pp cpp/compiled/* cpp/wasm/* cpp/include/lommel/*.hpp cpp/include/lommel/*/*.hpp cpp/tests/* tests/cmake_consume/*.cpp)
lint: env ## check the style, the format and that no package has grown past its ceiling
	@.venv/bin/ruff check
	.venv/bin/ruff format --check
	.venv/bin/clang-format --dry-run -Werror $(cpp_formatted)
	.venv/bin/python benchmarks/structure.py --ceilings
types: env ## check the types
	@.venv/bin/mypy
format: env ## rewrite the files in the project's format
	@.venv/bin/ruff check --fix-only
	.venv/bin/ruff format
	.venv/bin/clang-format -i $(cpp_formatted)
bench: build env ## measure against the FFT, NumPy and what peers there are; write docs/benchmarks.md
	@.venv/bin/python benchmarks/run.py --write
real-data: build env .venv/real.stamp ## fetch real data and write docs/real-data.md: ten minutes of one core
	@.venv/bin/python -m benchmarks.real_data $(FLAGS)
setup-times: ## measure the way from a fresh clone to a first picture, and from an edit to a passing test
	@python=$$($(find_python))
	"$$python" benchmarks/setup_times.py $(FLAGS)
changelog: .venv/maintain.stamp ## gather the fragments in changes/ into CHANGELOG.md, for a release
	@.venv/bin/towncrier build --yes --version "$$(sed -n 's/^version = "\(.*\)"$$/\1/p' pyproject.toml)" $(FLAGS)
compile = $(uv) pip compile --quiet --universal --python-version 3.11 --generate-hashes --no-annotate $(LOCKFLAGS)
# Pins that still do are kept; make lock LOCKFLAGS=--upgrade moves them all.
lock: $(fetched) ## pin anew, in requirements.lock, what pyproject.toml asks for
	@$(compile) --custom-compile-command "make lock" --output-file requirements.lock pyproject.toml --extra all \
		$(patsubst %,--group %,dev tools docs page real maintain accuracy torch napari)
	$(compile) --no-header --no-deps --group picasso >>requirements.lock
# Compiled where the editable install is, which is then made anew, for CMake has forgotten that it is one.
wheel: page build ## build a wheel in dist
	@rm .venv/build.stamp
	PATH="$(CURDIR)/.venv/bin:$$PATH" $(uv) build --wheel --config-setting=build-dir='$(build_folder)' --no-build-isolation --python .venv --out-dir dist
sdist: page ## pack the sources in dist
	@PATH="$(CURDIR)/.venv/bin:$$PATH" $(uv) build --sdist --no-build-isolation --python .venv --out-dir dist
release: page .venv/maintain.stamp ## make dist/release, all that a maintainer uploads: a quarter of an hour of two processors
	@UV=$(if $(fetched),"$(CURDIR)/.tools/uv",uv) .venv/bin/python release/build.py $(FLAGS)
clean: ## remove all that make made
	@rm -rf .venv .tools build dist docs/_build docs/_generated docs/api docs/reference docs/gallery docs/sg_execution_times.rst \
		.hypothesis .mypy_cache .pytest_cache .ruff_cache
	rm -f out/hubble-1990.tif out/hubble-1990.png out/motorcycle.png out/motorcycle-*
	find src tests examples benchmarks tools -type d -name __pycache__ -prune -exec rm -rf {} +
	[ ! -d out ] || rmdir out 2>/dev/null || echo "out holds other files; kept"
FORCE:
