# Packages for Debian by CPack: Utilities/package.sh makes and checks them. Three, so that who registers needs no VTK, and who
# compiles nothing no headers:
#   dentalscr          the program with the libraries, manual pages, completion
#   dentalscr-view     what the verb view starts, with VTK
#   libdentalscr-dev   headers, CMake files, examples
set(CPACK_PACKAGE_NAME dentalscr)
set(CPACK_PACKAGE_VENDOR "The DentalSCR authors")
# Who makes them signs them, in the words that Debian's own tools ask for.
if(DEFINED ENV{DEBEMAIL})
  set(CPACK_PACKAGE_CONTACT "$ENV{DEBFULLNAME} <$ENV{DEBEMAIL}>")
else()
  set(CPACK_PACKAGE_CONTACT "The DentalSCR authors <dentalscr@localhost>")
endif()
# Each has a first line of its own, below.
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")
set(CPACK_GENERATOR DEB)
set(CPACK_STRIP_FILES ON)
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_PACKAGING_INSTALL_PREFIX "${CMAKE_INSTALL_PREFIX}")
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE
  WORLD_READ WORLD_EXECUTE)
set(CPACK_COMPONENTS_ALL Runtime Development)
if(TARGET RegistrationSceneVTK)
  list(APPEND CPACK_COMPONENTS_ALL View)
endif()

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS_POLICY ">=")
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS "${CMAKE_LIBRARY_OUTPUT_DIRECTORY}")
set(_version "${DentalSCR_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}")
string(CONCAT _words "Takes two scans of the teeth and a tracing of the radiograph, and gives\n"
  "the scans in the coordinate system of the cephalogram, with a picture to\n"
  "judge them by, an expected error and a verdict. Research software, not a\n"
  "medical device.")

set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME dentalscr)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SECTION science)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_RECOMMENDS "dentalscr-view (= ${_version})")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SUGGESTS "libdentalscr-dev (= ${_version})")
set(CPACK_DEBIAN_RUNTIME_DESCRIPTION "aligns intraoral scans with a cephalometric radiograph\n${_words}")

# The loader's list of libraries is made anew once, after all packages.
file(WRITE "${PROJECT_BINARY_DIR}/triggers" "activate-noawait ldconfig\n")
# Where root runs the modules for 3D Slicer, Python keeps beside them what it has compiled, and no package knows of these files.
file(WRITE "${PROJECT_BINARY_DIR}/prerm" "#!/bin/sh
set -e
rm -rf ${CMAKE_INSTALL_PREFIX}/share/dentalscr/slicer/__pycache__ ${CMAKE_INSTALL_PREFIX}/share/dentalscr/slicer/DentalSCRLib/__pycache__
")
file(CHMOD "${PROJECT_BINARY_DIR}/prerm" PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE
  WORLD_READ WORLD_EXECUTE)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_CONTROL_EXTRA "${PROJECT_BINARY_DIR}/triggers;${PROJECT_BINARY_DIR}/prerm")
set(CPACK_DEBIAN_VIEW_PACKAGE_CONTROL_EXTRA "${PROJECT_BINARY_DIR}/triggers")

set(CPACK_DEBIAN_VIEW_PACKAGE_NAME dentalscr-view)
set(CPACK_DEBIAN_VIEW_PACKAGE_SECTION science)
set(CPACK_DEBIAN_VIEW_PACKAGE_DEPENDS "dentalscr (= ${_version})")
set(CPACK_DEBIAN_VIEW_PACKAGE_RECOMMENDS "xvfb")
set(CPACK_DEBIAN_VIEW_DESCRIPTION "shows scans that dentalscr has aligned, in space\nWhat the verb view of dentalscr starts: a window or a picture, and files\nfor 3D Slicer, ParaView and Blender.")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libdentalscr-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
# ITK's C++ interface changes between releases: the config file asks for the one that this was built with.
math(EXPR _next "${ITK_VERSION_PATCH} + 1")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "dentalscr (= ${_version}), libinsighttoolkit5-dev (>= ${ITK_VERSION}), \
libinsighttoolkit5-dev (<< ${ITK_VERSION_MAJOR}.${ITK_VERSION_MINOR}.${_next}~)")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SUGGESTS "dentalscr-view (= ${_version}), libvtk9-dev, libcli11-dev")
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION "toolkit of ITK process objects for cephalometric registration\nHeaders, CMake files and examples of the libraries that dentalscr is made\nof: geometry, simulated radiographs, contours, registration, uncertainty.")

# What Debian wants of every package, and nobody else.
set(CPACK_PRE_BUILD_SCRIPTS "${CMAKE_CURRENT_LIST_DIR}/DentalSCRDebianFiles.cmake")
set(CPACK_DENTALSCR_VERSION "${_version}")
include(CPack)
