# What find_package(lommel) finds.
include(CMakePackageConfigHelpers)

set(place share/cmake/lommel)
configure_package_config_file(
  cmake/lommelConfig.cmake.in "${CMAKE_CURRENT_BINARY_DIR}/lommelConfig.cmake"
  INSTALL_DESTINATION ${place}
  NO_SET_AND_CHECK_MACRO)
# Before 1.0 a minor version may change the interface.
set(independent ARCH_INDEPENDENT)
if(LOMMEL_C)
  set(independent)
endif()
write_basic_package_version_file(
  "${CMAKE_CURRENT_BINARY_DIR}/lommelConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion
  ${independent})
install(FILES "${CMAKE_CURRENT_BINARY_DIR}/lommelConfig.cmake" "${CMAKE_CURRENT_BINARY_DIR}/lommelConfigVersion.cmake"
        DESTINATION ${place})
install(TARGETS lommel EXPORT lommelTargets)
install(EXPORT lommelTargets NAMESPACE lommel:: DESTINATION ${place})
install(DIRECTORY cpp/include/lommel DESTINATION include)
if(LOMMEL_C)
  install(TARGETS lommel_c EXPORT lommelTargets)
  install(FILES cpp/c/lommel.h DESTINATION include)
endif()
