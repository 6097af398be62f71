# The compiled core of the Python package.
if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()

find_package(Python 3.11 REQUIRED COMPONENTS Interpreter Development.Module ${SKBUILD_SABI_COMPONENT})

# nanobind tells where its CMake files are, whether or not scikit-build-core runs this.
execute_process(
  COMMAND "${Python_EXECUTABLE}" -m nanobind --cmake_dir
  OUTPUT_VARIABLE nanobind_ROOT
  OUTPUT_STRIP_TRAILING_WHITESPACE
  COMMAND_ERROR_IS_FATAL ANY)
find_package(nanobind CONFIG REQUIRED)

# One file a room, of which the compiler does again only what has changed, and what several of them would compile (see
# cpp/include/lommel/base/once.hpp). Those that take longest come first, so that none is left over at the end.
file(GLOB rooms CONFIGURE_DEPENDS cpp/bindings/*.cpp cpp/compiled/*.cpp)
set(longest compiled/polar.cpp compiled/layers.cpp bindings/zernike.cpp compiled/spread_single.cpp compiled/composite_single.cpp bindings/bounds_disk.cpp
            bindings/radial.cpp)
list(TRANSFORM longest PREPEND "${CMAKE_CURRENT_SOURCE_DIR}/cpp/")
list(REMOVE_ITEM rooms ${longest})
list(PREPEND rooms ${longest})
# Of nanobind's own files, whose time goes into the same headers, several are compiled as one.
set(CMAKE_UNITY_BUILD ON)
# STABLE_ABI takes effect from Python 3.12 on, FREE_THREADED in Pythons without a global lock: nothing in the core relies
# on that. NOMINSIZE keeps -O3 rather than nanobind's -Os.
nanobind_add_module(_core STABLE_ABI FREE_THREADED NB_STATIC NOMINSIZE NB_SUPPRESS_WARNINGS ${rooms})
target_link_libraries(_core PRIVATE lommel)
target_compile_definitions(_core PRIVATE LOMMEL_COMPILED)
set_target_properties(_core PROPERTIES UNITY_BUILD OFF CXX_STANDARD 17 CXX_STANDARD_REQUIRED ON CXX_EXTENSIONS OFF)

# No -ffast-math: the error bounds assume IEEE arithmetic. Fused multiply-adds, where a kernel is compiled for
# them, round once instead of twice and are within the bounds. -fno-math-errno: nobody reads errno, and loops with square
# roots become vectors. -falign-functions: how fast a loop is must not depend on what is linked before it (a tenth, measured).
if(MSVC)
  target_compile_options(_core PRIVATE /W4 /fp:precise)
else()
  target_compile_options(_core PRIVATE -Wall -Wextra -ffp-contract=fast -fno-math-errno -falign-functions=64)
endif()

# Templates of the standard library are visible by default: to look up their long names is a quarter of loading the core.
if(CMAKE_SYSTEM_NAME STREQUAL "Linux")
  set(exports "${CMAKE_CURRENT_SOURCE_DIR}/cmake/exports.map")
  target_link_options(_core PRIVATE "-Wl,--version-script=${exports}")
  set_target_properties(_core PROPERTIES LINK_DEPENDS "${exports}")
endif()

install(TARGETS _core LIBRARY DESTINATION lommel)

# The examples stand at the top of the sources, where an editable installation finds them; wheels have them within.
if(NOT SKBUILD_STATE STREQUAL "editable")
  install(DIRECTORY examples/lenses examples/objectives examples/cameras examples/class examples/notebooks DESTINATION lommel/examples
          FILES_MATCHING PATTERN "*.toml" PATTERN "*.ipynb")
endif()
