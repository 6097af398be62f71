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

# Compiler options and the exported symbol, for all that is linked into a module.
function(set_core_options target)
  target_link_libraries(${target} PRIVATE lommel)
  target_compile_definitions(${target} PRIVATE LOMMEL_COMPILED)
  set_target_properties(
    ${target}
    PROPERTIES UNITY_BUILD OFF
               CXX_STANDARD 17
               CXX_STANDARD_REQUIRED ON
               CXX_EXTENSIONS OFF
               CXX_VISIBILITY_PRESET hidden
               POSITION_INDEPENDENT_CODE ON)
  # No -ffast-math: the error bounds assume IEEE arithmetic. Fused multiply-adds, where a kernel is compiled for
  # them, round once instead of twice and are within the bounds. -fno-math-errno: nobody reads errno, and loops with square
  # roots become vectors. -falign-functions: how fast a loop is must not depend on what is linked before it (a tenth, measured).
  if(MSVC)
    target_compile_options(${target} PRIVATE /W4 /fp:precise)
  else()
    target_compile_options(${target} PRIVATE -Wall -Wextra -ffp-contract=fast -fno-math-errno -falign-functions=64
                                             -fno-stack-protector -ffunction-sections -fdata-sections)
  endif()
  # Templates of the standard library are visible by default: to look up their long names is a quarter of loading the core.
  get_target_property(kind ${target} TYPE)
  if(CMAKE_SYSTEM_NAME STREQUAL "Linux" AND kind STREQUAL "MODULE_LIBRARY")
    set(exports "${CMAKE_CURRENT_SOURCE_DIR}/cmake/exports.map")
    target_link_options(${target} PRIVATE "-Wl,--version-script=${exports}")
    set_target_properties(${target} PROPERTIES LINK_DEPENDS "${exports}")
  endif()
endfunction()

# What is compiled once for both modules: kernels for pixels of either type, which headers then declare as extern templates. What
# takes longest comes first, so that none is left over at the end.
file(GLOB compiled CONFIGURE_DEPENDS cpp/compiled/*.cpp)
set(longest polar chordal layers spread_double composite_single)
list(TRANSFORM longest PREPEND "${CMAKE_CURRENT_SOURCE_DIR}/cpp/compiled/")
list(TRANSFORM longest APPEND .cpp)
list(REMOVE_ITEM compiled ${longest})
add_library(lommel_compiled OBJECT ${longest} ${compiled})
set_core_options(lommel_compiled)
# Vector kernels ask for -O3 themselves (cpp/include/lommel/base/simd.hpp); of all else, half of the code, -O1 compiles in half the
# time, and calls take at most a twentieth longer. Without the other options what kernels call would not be inlined into them.
set(cheap -O1)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  list(APPEND cheap -fstrict-aliasing -fdevirtualize -finline-functions -finline-small-functions -fpartial-inlining
       -findirect-inlining)
  target_compile_options(lommel_compiled PRIVATE "$<$<CONFIG:Release>:${cheap}>")
endif()
# Files that share their headers are compiled as one.
function(compile_together target folder)
  set(group "${ARGN}")
  list(TRANSFORM group PREPEND "${CMAKE_CURRENT_SOURCE_DIR}/cpp/${folder}/")
  list(TRANSFORM group APPEND .cpp)
  set_source_files_properties(${group} PROPERTIES UNITY_GROUP "${ARGV2}")
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
endfunction()
compile_together(lommel_compiled compiled chordal_single chordal_double)
compile_together(lommel_compiled compiled composite_single composite_double)
compile_together(lommel_compiled compiled field_spread filter estimation)
compile_together(lommel_compiled compiled spread_double spread_single)

# Of nanobind's own files, whose time goes into the same headers, several are compiled as one.
set(CMAKE_UNITY_BUILD ON)
# STABLE_ABI takes effect from Python 3.12 on, FREE_THREADED in Pythons without a global lock: nothing in the core relies
# on that. NOMINSIZE keeps -O3 rather than nanobind's -Os.
set(module_options STABLE_ABI FREE_THREADED NB_STATIC NOMINSIZE NB_SUPPRESS_WARNINGS)
file(GLOB bindings CONFIGURE_DEPENDS cpp/bindings/*.cpp)
set(test_bindings ${bindings})
list(FILTER bindings EXCLUDE REGEX "/tests_[a-z]*\\.cpp$")
list(FILTER test_bindings INCLUDE REGEX "/(tests_[a-z]*|process)\\.cpp$")
nanobind_add_module(_core ${module_options} ${bindings} $<TARGET_OBJECTS:lommel_compiled>)
set_core_options(_core)
install(TARGETS _core LIBRARY DESTINATION lommel)
# Half of the time of small bindings goes into the headers of nanobind.
compile_together(_core bindings module process special pixels estimation paper)
compile_together(_core bindings focal localize)
compile_together(_core bindings zernike aperture)
# nanobind takes a third less time to compile by -O1, and no longer to run.
get_target_property(linked _core LINK_LIBRARIES)
list(FILTER linked INCLUDE REGEX "^nanobind")
foreach(target _core ${linked})
  if(NOT MSVC)
    target_compile_options(${target} PRIVATE "$<$<CONFIG:Release>:${cheap}>")
  endif()
endforeach()

# What tests alone call, in a module of its own that is neither built nor installed by default. The target core_tests does both
# in the environment of this Python; with LOMMEL_TESTS it is a part of the package.
option(LOMMEL_TESTS "Build and install the module of functions that only tests call as well" OFF)
if(NOT LOMMEL_TESTS)
  set(excluded EXCLUDE_FROM_ALL)
endif()
nanobind_add_module(_core_tests ${module_options} ${test_bindings} $<TARGET_OBJECTS:lommel_compiled>)
set_core_options(_core_tests)
if(NOT MSVC)
  target_compile_options(_core_tests PRIVATE "$<$<CONFIG:Release>:${cheap}>")
endif()
install(TARGETS _core_tests LIBRARY DESTINATION lommel COMPONENT tests ${excluded})
if(NOT LOMMEL_TESTS)
  set_target_properties(_core_tests PROPERTIES EXCLUDE_FROM_ALL ON)
endif()
add_custom_target(
  core_tests
  COMMAND "${CMAKE_COMMAND}" --install "${CMAKE_CURRENT_BINARY_DIR}" --component tests --prefix "${Python_SITEARCH}"
  DEPENDS _core_tests)

# The examples stand at the top of the sources, where an editable installation finds them; wheels have them within.
if(NOT SKBUILD_STATE STREQUAL "editable")
  install(DIRECTORY examples/lenses examples/objectives examples/cameras examples/class examples/notebooks DESTINATION lommel/examples
          FILES_MATCHING PATTERN "*.toml" PATTERN "*.ipynb")
endif()
