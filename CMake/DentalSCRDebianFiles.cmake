# CPack runs this when the files of the packages are in their folders: adds copyright and changelog, which Debian wants of each.
string(TIMESTAMP _date "%a, %d %b %Y %H:%M:%S +0000" UTC)
set(_changelog "${CPACK_TEMPORARY_DIRECTORY}/changelog.Debian")
file(WRITE "${_changelog}" "dentalscr (${CPACK_DENTALSCR_VERSION}) unstable; urgency=medium

  * Built by CPack; what has changed stands in CHANGELOG.md of the source.

 -- ${CPACK_PACKAGE_CONTACT}  ${_date}
")
set(_copyright "Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/
Upstream-Name: DentalSCR

Files: *
Copyright: 2026 The DentalSCR authors
License: Apache-2.0
 On Debian systems the text of the Apache License, version 2.0, is in
 /usr/share/common-licenses/Apache-2.0.
")
# The letters of the overlays travel in a library, and what the page of a report is drawn with does, too.
file(READ "/usr/share/doc/fonts-dejavu-core/copyright" _font)
set(_embedded "
In the library libDentalSCROverlayPainting the font DejaVu Sans travels, under these terms:

${_font}
In the library libDentalSCRReportPage the scripts three.js (MIT) and Observable Plot (ISC) travel with what they use;
the pages that it writes show the licence of each.
")
set(_names Runtime dentalscr Development libdentalscr-dev View dentalscr-view)
while(_names)
  list(POP_FRONT _names _component _package)
  set(_root "${CPACK_TEMPORARY_DIRECTORY}/${_component}")
  if(IS_DIRECTORY "${_root}")
    set(_doc "${_root}/usr/share/doc/${_package}")
    file(MAKE_DIRECTORY "${_doc}")
    if(_component STREQUAL Runtime)
      file(WRITE "${_doc}/copyright" "${_copyright}${_embedded}")
      # Loaded by name and linked by nobody: no package can come to depend on them.
      set(_overrides "# Parts of libraries that are loaded by their file name when they are first needed; nothing links them.\n")
      file(GLOB_RECURSE _parts RELATIVE "${_root}" "${_root}/usr/lib/libDentalSCR*-*.so" "${_root}/usr/lib/*/libDentalSCR*-*.so")
      list(SORT _parts)
      foreach(_part IN LISTS _parts)
        string(REGEX MATCH "(libDentalSCR[A-Za-z]+)-([0-9.]+)[.]so$" _name "${_part}")
        string(APPEND _overrides
          "dentalscr: ships-undeclared-shared-library ${CMAKE_MATCH_1} ${CMAKE_MATCH_2} for ${_part} [shlibs]\n")
      endforeach()
      file(WRITE "${_root}/usr/share/lintian/overrides/dentalscr" "${_overrides}")
    else()
      file(WRITE "${_doc}/copyright" "${_copyright}")
    endif()
    execute_process(COMMAND gzip -9 -n -c "${_changelog}" OUTPUT_FILE "${_doc}/changelog.Debian.gz"
      COMMAND_ERROR_IS_FATAL ANY)
  endif()
endwhile()
file(REMOVE "${_changelog}")
