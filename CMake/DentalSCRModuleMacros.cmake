# The part of ITK's module system that Debian does not package, under the names that ITK gives it, so that a module of ours
# could move into an ITK tree unchanged:
#   itk-module.cmake           itk_module(<Name> DEPENDS ... TEST_DEPENDS ... DESCRIPTION "...")
#   CMakeLists.txt             project(<Name>) ; itk_module_impl()
#   src/CMakeLists.txt         itk_module_add_library(<Name> ...)
#   test/CMakeLists.txt        itk_module_test() ; CreateGoogleTestDriver(<Name> "${<Name>-Test_LIBRARIES}" "...")
# A dependency that starts with "ITK" is one of ITK's own modules, any other is ours.
include(GenerateExportHeader)

# A function: a macro would split a description at its semicolons.
function(itk_module _name)
  cmake_parse_arguments(PARSE_ARGV 1 _itk_module "" "DESCRIPTION" "DEPENDS;TEST_DEPENDS")
  if(_itk_module_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "itk_module(${_name}): unknown arguments ${_itk_module_UNPARSED_ARGUMENTS}")
  endif()
  set(itk-module ${_name} PARENT_SCOPE)
  set(DENTALSCR_MODULE_${_name}_DEPENDS ${_itk_module_DEPENDS} PARENT_SCOPE)
  set(DENTALSCR_MODULE_${_name}_TEST_DEPENDS ${_itk_module_TEST_DEPENDS} PARENT_SCOPE)
  set(DENTALSCR_MODULE_${_name}_DESCRIPTION "${_itk_module_DESCRIPTION}" PARENT_SCOPE)
endfunction()

# Splits a dependency list into targets of ours, and libraries and include folders of ITK.
function(_dentalscr_resolve_dependencies _targets _itk_libraries _itk_includes)
  set(targets)
  set(libraries)
  set(includes ${ITK_INCLUDE_DIRS})
  foreach(dependency IN LISTS ARGN)
    if(dependency MATCHES "^ITK")
      itk_module_config(_dependency ${dependency})
      list(APPEND libraries ${_dependency_LIBRARIES})
    else()
      list(APPEND targets ${dependency})
    endif()
  endforeach()
  list(REMOVE_DUPLICATES libraries)
  set(${_targets} ${targets} PARENT_SCOPE)
  set(${_itk_libraries} ${libraries} PARENT_SCOPE)
  set(${_itk_includes} ${includes} PARENT_SCOPE)
endfunction()

macro(itk_module_impl)
  set(_dentalscr_module_dir "${CMAKE_CURRENT_SOURCE_DIR}")
  if(EXISTS "${CMAKE_CURRENT_SOURCE_DIR}/src/CMakeLists.txt")
    add_subdirectory(src)
  else()
    dentalscr_add_header_library(${PROJECT_NAME})
  endif()
  if(DENTALSCR_BUILD_TESTING)
    _dentalscr_compile_headers_alone(${PROJECT_NAME} "${_dentalscr_module_dir}")
    if(EXISTS "${CMAKE_CURRENT_SOURCE_DIR}/test/CMakeLists.txt")
      add_subdirectory(test)
    endif()
  endif()
endmacro()

# Every public header compiles alone: it includes what it uses, in whatever order others include it. That is shown where a
# source file of the module or of its tests includes it first, as the house's order of includes wants; a header that is
# nobody's first gets a source file of its own. The build is the test.
function(_dentalscr_compile_headers_alone _name _dir)
  file(GLOB headers CONFIGURE_DEPENDS "${_dir}/include/*.h")
  file(GLOB sources "${_dir}/src/*.cxx" "${_dir}/test/*.cxx")
  set(first)
  foreach(source IN LISTS sources)
    file(STRINGS "${source}" line REGEX "^#include" LIMIT_COUNT 1)
    if(line MATCHES "\"(.+)\"")
      list(APPEND first "${CMAKE_MATCH_1}")
    endif()
  endforeach()
  set(alone)
  foreach(header IN LISTS headers)
    get_filename_component(header "${header}" NAME)
    if(NOT header IN_LIST first)
      set(source "${CMAKE_CURRENT_BINARY_DIR}/headers/${header}.cxx")
      file(CONFIGURE OUTPUT "${source}" CONTENT "#include \"${header}\"\n" @ONLY)
      list(APPEND alone "${source}")
    endif()
  endforeach()
  if(alone)
    add_library(${_name}Headers OBJECT ${alone})
    dentalscr_target_settings(${_name}Headers)
    target_compile_options(${_name}Headers PRIVATE -O0)
    target_link_libraries(${_name}Headers PRIVATE ${_name})
  endif()
endfunction()

# What a library and a header-only module have in common: scope is PUBLIC or INTERFACE.
function(_dentalscr_configure_module _name _scope)
  _dentalscr_resolve_dependencies(targets itk_libraries itk_includes ${DENTALSCR_MODULE_${_name}_DEPENDS})
  set(module_dir "${DENTALSCR_MODULE_${_name}_DIR}")
  set(binary_dir "${PROJECT_BINARY_DIR}/include")
  add_library(DentalSCR::${_name} ALIAS ${_name})
  target_include_directories(${_name} ${_scope}
    "$<BUILD_INTERFACE:${module_dir}/include>"
    "$<BUILD_INTERFACE:${binary_dir}>"
    "$<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/DentalSCR>")
  # By the config file's ITK_INCLUDE_DIRS after installation, so that no path of the build machine is exported.
  target_include_directories(${_name} SYSTEM ${_scope} "$<BUILD_INTERFACE:${itk_includes}>")
  target_link_libraries(${_name} ${_scope} ${targets} ${itk_libraries})
  target_compile_features(${_name} ${_scope} cxx_std_17)
  install(TARGETS ${_name} EXPORT DentalSCRTargets
    RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}" COMPONENT Runtime
    LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT Runtime NAMELINK_COMPONENT Development
    ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT Development)
  if(EXISTS "${module_dir}/include")
    install(DIRECTORY "${module_dir}/include/" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/DentalSCR" COMPONENT Development)
  endif()
  set_property(GLOBAL APPEND PROPERTY DENTALSCR_TARGETS ${_name})
endfunction()

function(itk_module_add_library _name)
  add_library(${_name} ${ARGN})
  dentalscr_target_settings(${_name})
  set_target_properties(${_name} PROPERTIES
    OUTPUT_NAME "DentalSCR${_name}"
    VERSION ${DentalSCR_VERSION}
    SOVERSION ${DentalSCR_VERSION_MAJOR}.${DentalSCR_VERSION_MINOR})
  if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang" AND UNIX AND NOT APPLE)
    # A library's own functions are found when it is linked, not by name each time that it is loaded; data, hence types and
    # singletons, are still one for all libraries.
    target_link_options(${_name} PRIVATE "LINKER:-Bsymbolic-functions")
  endif()
  set(header_target ${_name})
  if(NOT BUILD_SHARED_LIBS)
    # The compile commands and the header of a shared library, so that the wheel's objects come from ccache.
    target_compile_definitions(${_name} PRIVATE ${_name}_EXPORTS)
    set(header_target ${_name}Header)
    add_library(${header_target} SHARED EXCLUDE_FROM_ALL ${ARGN})
    set_target_properties(${header_target} PROPERTIES DEFINE_SYMBOL ${_name}_EXPORTS)
  endif()
  set(DENTALSCR_MODULE_${_name}_DIR "${_dentalscr_module_dir}")
  set(PROJECT_BINARY_DIR "${DentalSCR_BINARY_DIR}")
  _dentalscr_configure_module(${_name} PUBLIC)
  generate_export_header(${header_target} BASE_NAME ${_name} EXPORT_MACRO_NAME ${_name}_EXPORT
    EXPORT_FILE_NAME "${DentalSCR_BINARY_DIR}/include/${_name}Export.h")
  install(FILES "${DentalSCR_BINARY_DIR}/include/${_name}Export.h"
    DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/DentalSCR" COMPONENT Development)
endfunction()

# Files that travel in a library, as pages do: dentalscr_embed_files(<library> <Namespace> Name=file ...). Each becomes a
# function Name() of itk::<Namespace>, which itk<Namespace>.h declares, and which gives the file's bytes as std::string_view.
set(DENTALSCR_EMBED_FILES "${CMAKE_CURRENT_LIST_DIR}/DentalSCREmbedFiles.cmake")
function(dentalscr_embed_files _name _namespace)
  set(output "${CMAKE_CURRENT_BINARY_DIR}/itk${_namespace}.cxx")
  list(JOIN ARGN "|" parts)
  set(files ${ARGN})
  list(TRANSFORM files REPLACE "^[A-Za-z]+=" "")
  add_custom_command(
    OUTPUT "${output}"
    COMMAND "${CMAKE_COMMAND}" "-DPARTS=${parts}" "-DNAMESPACE=${_namespace}" "-DOUTPUT=${output}" -P "${DENTALSCR_EMBED_FILES}"
    DEPENDS ${files} "${DENTALSCR_EMBED_FILES}"
    COMMENT "Putting the files of ${_namespace} into the library"
    VERBATIM)
  target_sources(${_name} PRIVATE "${output}")
  # The header stands among the sources.
  target_include_directories(${_name} PRIVATE "${CMAKE_CURRENT_SOURCE_DIR}")
endfunction()

# A part of a module that links what takes long to load: where libraries are shared, a library of its own beside the others,
# which the module loads with LoadLibraryFunction() under the file name that DEFINITION defines for it; else its sources are
# the module's own and DEFINITION is not defined.
function(dentalscr_add_loaded_library _name)
  cmake_parse_arguments(PARSE_ARGV 1 _loaded "" "FOR;DEFINITION" "SOURCES;ITK_MODULES;LIBRARIES")
  if(_loaded_UNPARSED_ARGUMENTS OR NOT _loaded_FOR OR NOT _loaded_DEFINITION OR NOT _loaded_SOURCES)
    message(FATAL_ERROR "dentalscr_add_loaded_library(${_name}): FOR, DEFINITION and SOURCES are needed, "
      "unknown arguments: ${_loaded_UNPARSED_ARGUMENTS}")
  endif()
  if(NOT BUILD_SHARED_LIBS OR NOT UNIX)
    target_sources(${_loaded_FOR} PRIVATE ${_loaded_SOURCES})
    # A program names no modules, as a module does, of which its libraries would come.
    if(_loaded_ITK_MODULES)
      itk_module_config(_loaded_itk ${_loaded_ITK_MODULES})
    endif()
    target_link_libraries(${_loaded_FOR} PRIVATE ${_loaded_itk_LIBRARIES} ${_loaded_LIBRARIES})
    return()
  endif()
  itk_module_config(_loaded_itk ${_loaded_ITK_MODULES})
  add_library(${_name} MODULE ${_loaded_SOURCES})
  dentalscr_target_settings(${_name})
  set_target_properties(${_name} PROPERTIES
    OUTPUT_NAME "DentalSCR${_name}-${DentalSCR_VERSION_MAJOR}.${DentalSCR_VERSION_MINOR}")
  # It lies among libraries that are linked, and what looks after these wants a name in it.
  target_link_options(${_name} PRIVATE "LINKER:-soname,$<TARGET_FILE_NAME:${_name}>")
  # Headers of the module, but no link: the module is built after what it loads.
  target_include_directories(${_name} PRIVATE "$<TARGET_PROPERTY:${_loaded_FOR},INCLUDE_DIRECTORIES>")
  target_include_directories(${_name} SYSTEM PRIVATE ${ITK_INCLUDE_DIRS})
  target_compile_features(${_name} PRIVATE cxx_std_17)
  target_link_libraries(${_name} PRIVATE ${_loaded_itk_LIBRARIES} ${_loaded_LIBRARIES})
  install(TARGETS ${_name} LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT Runtime)
  target_compile_definitions(${_loaded_FOR} PRIVATE ${_loaded_DEFINITION}="$<TARGET_FILE_NAME:${_name}>")
  target_link_libraries(${_loaded_FOR} PRIVATE ${CMAKE_DL_LIBS})
  add_dependencies(${_loaded_FOR} ${_name})
endfunction()

# A part of a module that others may link and that links VTK, which the module itself does not: a shared library beside it, in an
# export set of its own, since whoever finds DentalSCR need not have VTK. It is a component for find_package().
function(dentalscr_add_vtk_library _name)
  cmake_parse_arguments(PARSE_ARGV 1 _vtk "" "FOR" "SOURCES")
  add_library(${_name} SHARED ${_vtk_SOURCES})
  add_library(DentalSCR::${_name} ALIAS ${_name})
  dentalscr_target_settings(${_name})
  set_target_properties(${_name} PROPERTIES
    OUTPUT_NAME "DentalSCR${_name}"
    VERSION ${DentalSCR_VERSION}
    SOVERSION ${DentalSCR_VERSION_MAJOR}.${DentalSCR_VERSION_MINOR})
  set(libraries)
  foreach(component IN LISTS DENTALSCR_VTK_COMPONENTS)
    list(APPEND libraries VTK::${component})
  endforeach()
  target_include_directories(${_name} SYSTEM PRIVATE ${ITK_INCLUDE_DIRS})
  target_link_libraries(${_name} PUBLIC ${_vtk_FOR} VTK::CommonCore VTK::CommonDataModel VTK::RenderingCore
    PRIVATE ${libraries} X11::X11 nlohmann_json::nlohmann_json)
  vtk_module_autoinit(TARGETS ${_name} MODULES ${libraries})
  set(PROJECT_BINARY_DIR "${DentalSCR_BINARY_DIR}")
  generate_export_header(${_name} BASE_NAME ${_name} EXPORT_MACRO_NAME ${_name}_EXPORT
    EXPORT_FILE_NAME "${DentalSCR_BINARY_DIR}/include/${_name}Export.h")
  install(FILES "${DentalSCR_BINARY_DIR}/include/${_name}Export.h"
    DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/DentalSCR" COMPONENT Development)
  install(TARGETS ${_name} EXPORT DentalSCRVTKTargets
    LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT View NAMELINK_COMPONENT Development)
  set_property(GLOBAL APPEND PROPERTY DENTALSCR_VTK_TARGETS ${_name})
endfunction()

function(dentalscr_add_header_library _name)
  add_library(${_name} INTERFACE)
  set(DENTALSCR_MODULE_${_name}_DIR "${_dentalscr_module_dir}")
  set(PROJECT_BINARY_DIR "${DentalSCR_BINARY_DIR}")
  _dentalscr_configure_module(${_name} INTERFACE)
endfunction()

macro(itk_module_test)
  set(${PROJECT_NAME}-Test_LIBRARIES ${PROJECT_NAME})
  set(_dentalscr_test_itk_libraries)
  foreach(_dependency IN LISTS DENTALSCR_MODULE_${PROJECT_NAME}_TEST_DEPENDS)
    if(_dependency MATCHES "^ITK")
      itk_module_config(_dentalscr_test ${_dependency})
      list(APPEND ${PROJECT_NAME}-Test_LIBRARIES ${_dentalscr_test_LIBRARIES})
    else()
      list(APPEND ${PROJECT_NAME}-Test_LIBRARIES ${_dependency})
    endif()
  endforeach()
endmacro()

# Reads every itk-module.cmake, orders the modules by their dependencies and adds them. A cycle is an error.
macro(dentalscr_add_modules _root)
  file(GLOB _module_files CONFIGURE_DEPENDS "${_root}/*/*/itk-module.cmake")
  set(_pending)
  foreach(_file IN LISTS _module_files)
    include("${_file}")
    get_filename_component(_module_path "${_file}" DIRECTORY)
    set(DENTALSCR_MODULE_${itk-module}_PATH "${_module_path}")
    list(APPEND _pending ${itk-module})
  endforeach()
  if(DENTALSCR_ONLY_MODULES)
    set(_wanted)
    set(_open ${DENTALSCR_ONLY_MODULES})
    while(_open)
      list(POP_FRONT _open _module)
      if(NOT _module MATCHES "^ITK" AND NOT _module IN_LIST _wanted)
        list(APPEND _wanted ${_module})
        list(APPEND _open ${DENTALSCR_MODULE_${_module}_DEPENDS} ${DENTALSCR_MODULE_${_module}_TEST_DEPENDS})
      endif()
    endwhile()
    set(_pending ${_wanted})
  endif()
  set(_added)
  while(_pending)
    set(_progress FALSE)
    foreach(_module IN LISTS _pending)
      set(_ready TRUE)
      foreach(_dependency IN LISTS DENTALSCR_MODULE_${_module}_DEPENDS DENTALSCR_MODULE_${_module}_TEST_DEPENDS)
        if(NOT _dependency MATCHES "^ITK" AND NOT _dependency IN_LIST _added)
          set(_ready FALSE)
        endif()
      endforeach()
      if(_ready)
        add_subdirectory("${DENTALSCR_MODULE_${_module}_PATH}")
        list(APPEND _added ${_module})
        list(REMOVE_ITEM _pending ${_module})
        set(_progress TRUE)
      endif()
    endforeach()
    if(NOT _progress)
      message(FATAL_ERROR "Modules with a missing or circular dependency: ${_pending}")
    endif()
  endwhile()
endmacro()
