# Language level, output folders, warnings and floating-point rules for our own targets.
if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()

set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

include(GNUInstallDirs)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/bin")
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/lib")
set(CMAKE_ARCHIVE_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/lib")
file(RELATIVE_PATH _dentalscr_bin_to_lib "/${CMAKE_INSTALL_BINDIR}" "/${CMAKE_INSTALL_LIBDIR}")
# Installed anywhere, the program finds its libraries; in a system's own folders the loader does.
option(DENTALSCR_INSTALL_RPATH "Installed programs and libraries look for each other by relative paths" ON)
if(DENTALSCR_INSTALL_RPATH)
  set(CMAKE_INSTALL_RPATH "$ORIGIN;$ORIGIN/${_dentalscr_bin_to_lib}")
endif()

find_program(DENTALSCR_CCACHE ccache)
if(DENTALSCR_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER "${DENTALSCR_CCACHE}")
  if(SKBUILD AND NOT DEFINED ENV{CCACHE_BASEDIR})
    # pip builds in a folder of another name each time, FOLDER/NAME/build: by paths relative to it the objects are found again.
    cmake_path(GET PROJECT_BINARY_DIR PARENT_PATH _dentalscr_temporary)
    cmake_path(GET _dentalscr_temporary PARENT_PATH _dentalscr_temporary)
    list(PREPEND CMAKE_CXX_COMPILER_LAUNCHER
      "${CMAKE_COMMAND}" -E env "CCACHE_BASEDIR=${_dentalscr_temporary}" CCACHE_NOHASHDIR=1)
  endif()
endif()

# With CMAKE_UNITY_BUILD a library's sources are compiled a dozen at a time, so that ITK's headers are read once for all of them:
# half the time where nothing is in a compiler cache, and the same bits. Whoever edits has it off: one file would be a dozen.
if(CMAKE_UNITY_BUILD AND NOT CMAKE_UNITY_BUILD_BATCH_SIZE)
  set(CMAKE_UNITY_BUILD_BATCH_SIZE 12)
endif()

# Sources that cannot be read with others: those that include Eigen, as ITK's headers bring another one under the same include
# guards, and those that define a macro for a header which another source may have read before.
function(_dentalscr_keep_apart target)
  get_target_property(sources ${target} SOURCES)
  foreach(source IN LISTS sources)
    get_filename_component(path "${source}" ABSOLUTE)
    if(path MATCHES "[.]cxx$" AND EXISTS "${path}")
      file(STRINGS "${path}" apart REGEX "^#(include <Eigen/|define [A-Z]+_INSTANTIATE)" LIMIT_COUNT 1)
      if(apart)
        set_source_files_properties("${source}" PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
      endif()
    endif()
  endforeach()
endfunction()

# Applied to every target of ours, not to what is found: dentalscr_target_settings(<target>).
function(dentalscr_target_settings target)
  get_target_property(unity ${target} UNITY_BUILD)
  if(unity)
    _dentalscr_keep_apart(${target})
  endif()
  # ITK's macros end in stray semicolons: no -Wpedantic.
  if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
    # No contraction: a fused multiply-add would make the bits depend on the machine.
    target_compile_options(${target} PRIVATE -Wall -Wextra -Woverloaded-virtual -Wnon-virtual-dtor -ffp-contract=off)
    if(DENTALSCR_WARNINGS_AS_ERRORS)
      target_compile_options(${target} PRIVATE -Werror)
    endif()
  endif()
endfunction()
