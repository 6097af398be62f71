# The shared library with the C interface, cpp/c/lommel.h.
if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()

# What the interface needs of the kernels that are compiled once.
set(parts polar chordal_single chordal_double chordal pixels)
list(TRANSFORM parts PREPEND "${CMAKE_CURRENT_SOURCE_DIR}/cpp/compiled/")
list(TRANSFORM parts APPEND .cpp)
set(interface lommel live messages)
list(TRANSFORM interface PREPEND "${CMAKE_CURRENT_SOURCE_DIR}/cpp/c/")
list(TRANSFORM interface APPEND .cpp)
add_library(lommel_c SHARED ${interface} ${parts})
add_library(lommel::c ALIAS lommel_c)
target_link_libraries(lommel_c PRIVATE $<BUILD_INTERFACE:lommel>)
target_include_directories(
  lommel_c PUBLIC "$<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/cpp/c>" $<INSTALL_INTERFACE:include>)
target_compile_definitions(lommel_c PRIVATE LOMMEL_COMPILED LOMMEL_BUILDS_C "LOMMEL_VERSION=\"${PROJECT_VERSION}\"")

# Before 1.0 a minor version may change the interface.
set(abi ${PROJECT_VERSION_MAJOR})
if(PROJECT_VERSION_MAJOR EQUAL 0)
  set(abi 0.${PROJECT_VERSION_MINOR})
endif()
set_target_properties(
  lommel_c
  PROPERTIES OUTPUT_NAME lommel
             EXPORT_NAME c
             VERSION ${PROJECT_VERSION}
             SOVERSION ${abi}
             CXX_STANDARD 17
             CXX_STANDARD_REQUIRED ON
             CXX_EXTENSIONS OFF
             CXX_VISIBILITY_PRESET hidden
             VISIBILITY_INLINES_HIDDEN ON)

# As in the Python module: IEEE arithmetic, with fused multiply-adds.
if(MSVC)
  target_compile_options(lommel_c PRIVATE /W4 /fp:precise)
else()
  target_compile_options(lommel_c PRIVATE -Wall -Wextra -ffp-contract=fast -fno-math-errno -falign-functions=64)
endif()
# Only the functions of the header are looked up by name, and threads that sleep in the library keep it loaded.
if(CMAKE_SYSTEM_NAME STREQUAL "Linux")
  set(exports "${CMAKE_CURRENT_SOURCE_DIR}/cmake/exports_c.map")
  target_link_options(lommel_c PRIVATE "-Wl,--version-script=${exports}" -Wl,-z,nodelete -Wl,--no-undefined)
  set_target_properties(lommel_c PROPERTIES LINK_DEPENDS "${exports}")
endif()
