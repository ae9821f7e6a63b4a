# The install tree: libraries, headers, the program, and a config file for find_package(DentalSCR).
include(CMakePackageConfigHelpers)
set(_config_dir "${CMAKE_INSTALL_LIBDIR}/cmake/DentalSCR")
get_property(DENTALSCR_MODULES GLOBAL PROPERTY DENTALSCR_TARGETS)

configure_package_config_file("${CMAKE_CURRENT_LIST_DIR}/DentalSCRConfig.cmake.in"
  "${PROJECT_BINARY_DIR}/DentalSCRConfig.cmake" INSTALL_DESTINATION "${_config_dir}")
write_basic_package_version_file("${PROJECT_BINARY_DIR}/DentalSCRConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/DentalSCRConfig.cmake" "${PROJECT_BINARY_DIR}/DentalSCRConfigVersion.cmake"
  DESTINATION "${_config_dir}" COMPONENT Development)
install(EXPORT DentalSCRTargets NAMESPACE DentalSCR:: DESTINATION "${_config_dir}" COMPONENT Development)
export(EXPORT DentalSCRTargets NAMESPACE DentalSCR:: FILE "${PROJECT_BINARY_DIR}/DentalSCRTargets.cmake")
