# The install tree: libraries, headers, the program, and a config file for find_package(DentalSCR).
include(CMakePackageConfigHelpers)
set(_config_dir "${CMAKE_INSTALL_LIBDIR}/cmake/DentalSCR")
get_property(DENTALSCR_MODULES GLOBAL PROPERTY DENTALSCR_TARGETS)
# Components too, but only whoever asks for them needs VTK.
get_property(DENTALSCR_VTK_MODULES GLOBAL PROPERTY DENTALSCR_VTK_TARGETS)

# All modules in one target, but for the program's verbs, which are no library for others.
add_library(DentalSCR INTERFACE)
add_library(DentalSCR::DentalSCR ALIAS DentalSCR)
set(_umbrella ${DENTALSCR_MODULES})
list(REMOVE_ITEM _umbrella CommandLine)
target_link_libraries(DentalSCR INTERFACE ${_umbrella})
install(TARGETS DentalSCR EXPORT DentalSCRTargets COMPONENT Development)

configure_package_config_file("${CMAKE_CURRENT_LIST_DIR}/DentalSCRConfig.cmake.in"
  "${PROJECT_BINARY_DIR}/DentalSCRConfig.cmake" INSTALL_DESTINATION "${_config_dir}")
write_basic_package_version_file("${PROJECT_BINARY_DIR}/DentalSCRConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/DentalSCRConfig.cmake" "${PROJECT_BINARY_DIR}/DentalSCRConfigVersion.cmake"
  DESTINATION "${_config_dir}" COMPONENT Development)
install(EXPORT DentalSCRTargets NAMESPACE DentalSCR:: DESTINATION "${_config_dir}" COMPONENT Development)
export(EXPORT DentalSCRTargets NAMESPACE DentalSCR:: FILE "${PROJECT_BINARY_DIR}/DentalSCRTargets.cmake")
if(DENTALSCR_VTK_MODULES)
  install(EXPORT DentalSCRVTKTargets NAMESPACE DentalSCR:: DESTINATION "${_config_dir}" COMPONENT Development)
  export(EXPORT DentalSCRVTKTargets NAMESPACE DentalSCR:: FILE "${PROJECT_BINARY_DIR}/DentalSCRVTKTargets.cmake")
endif()

install(FILES "${DentalSCR_SOURCE_DIR}/LICENSE" "${DentalSCR_SOURCE_DIR}/CITATION.cff"
  DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/dentalscr" COMPONENT Runtime)
# Scripts, for whoever has 3D Slicer: Documentation/Slicer.md.
install(DIRECTORY "${DentalSCR_SOURCE_DIR}/Slicer/" DESTINATION "${CMAKE_INSTALL_DATADIR}/dentalscr/slicer"
  USE_SOURCE_PERMISSIONS COMPONENT Runtime PATTERN "__pycache__" EXCLUDE)
install(DIRECTORY "${DentalSCR_SOURCE_DIR}/Examples/" DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/dentalscr/examples"
  COMPONENT Development PATTERN "__pycache__" EXCLUDE PATTERN ".*" EXCLUDE)
