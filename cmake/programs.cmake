# The core's own test programs, which ctest runs, and each of its headers compiled with nothing included before it:
# CMakePresets.json has the compilers and sanitizers that `make sanitize` and `make test-arm` try them with.
enable_testing()
file(GLOB programs CONFIGURE_DEPENDS cpp/tests/*.cpp)
foreach(source ${programs})
  get_filename_component(name ${source} NAME_WE)
  add_executable(test_${name} ${source})
  target_link_libraries(test_${name} PRIVATE lommel)
  target_compile_options(test_${name} PRIVATE -Wall -Wextra)
  set_target_properties(test_${name} PROPERTIES CXX_STANDARD_REQUIRED ON CXX_EXTENSIONS OFF)
  add_test(NAME ${name} COMMAND test_${name})
endforeach()

# The example of the C interface reads frames from a pipe, and writes what the library does.
enable_language(C)
add_executable(live_depth examples/c/live_depth.c cpp/c/live.cpp cpp/c/messages.cpp)
target_include_directories(live_depth PRIVATE cpp/c)
target_link_libraries(live_depth PRIVATE lommel)
target_compile_definitions(live_depth PRIVATE "LOMMEL_VERSION=\"${PROJECT_VERSION}\"")
target_compile_options(live_depth PRIVATE -Wall -Wextra)
set_target_properties(live_depth PROPERTIES C_STANDARD 11 CXX_STANDARD_REQUIRED ON CXX_EXTENSIONS OFF)
add_test(NAME live_depth COMMAND "${CMAKE_COMMAND}" "-DEMULATOR=${CMAKE_CROSSCOMPILING_EMULATOR}"
                                 "-DWRITER=$<TARGET_FILE:test_live>" "-DREADER=$<TARGET_FILE:live_depth>"
                                 "-DFOLDER=${CMAKE_CURRENT_BINARY_DIR}/live_depth_files" -P "${CMAKE_CURRENT_SOURCE_DIR}/cmake/pipe.cmake")

# It compares tables made in double, as where there are no wider numbers, with wider ones.
target_compile_definitions(test_tables PRIVATE LOMMEL_WIDE=double)

file(GLOB_RECURSE headers CONFIGURE_DEPENDS cpp/include/*.hpp)
add_library(headers INTERFACE)
target_sources(headers INTERFACE FILE_SET HEADERS BASE_DIRS cpp/include FILES ${headers})
target_link_libraries(headers INTERFACE lommel)
set_target_properties(headers PROPERTIES VERIFY_INTERFACE_HEADER_SETS ON)
