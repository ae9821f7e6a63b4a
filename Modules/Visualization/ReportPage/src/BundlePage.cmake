# Bundles the page's script with its libraries: cmake -DPAGE=… -DOUTPUT=… -DENABLED=… -DNPM=… -DNODE=… -P BundlePage.cmake
# Writes OUTPUT/report.js and OUTPUT/licences.json. Never fails: without npm, or where the registry can't be reached, both are
# empty, which is how the library knows that it has none, and the page does without. Where bundling was wanted and failed,
# OUTPUT/failed says why; the next time that the build is configured it is tried again.
file(MAKE_DIRECTORY "${OUTPUT}/bundling")
file(REMOVE "${OUTPUT}/failed")
set(_done FALSE)
if(ENABLED)
  # In the build folder: nothing is left in the sources.
  file(GLOB _files "${PAGE}/*.json" "${PAGE}/*.mjs" "${PAGE}/.npmrc")
  file(COPY ${_files} "${PAGE}/src" DESTINATION "${OUTPUT}/bundling")
  file(SHA256 "${PAGE}/package-lock.json" _lock)
  set(_stamp "${OUTPUT}/bundling/node_modules/.${_lock}")
  if(NOT EXISTS "${_stamp}")
    # Versions and checksums are those of the lock file; no package runs a script of its own.
    execute_process(
      COMMAND "${NPM}" ci --ignore-scripts --no-audit --no-fund --prefer-offline --fetch-retries=1 --fetch-timeout=30000
        --loglevel=error
      WORKING_DIRECTORY "${OUTPUT}/bundling" RESULT_VARIABLE _status OUTPUT_VARIABLE _log ERROR_VARIABLE _log TIMEOUT 180)
    if(_status EQUAL 0 AND IS_DIRECTORY "${OUTPUT}/bundling/node_modules")
      file(WRITE "${_stamp}" "")
    else()
      string(PREPEND _log "npm: ${_status}\n")
    endif()
  endif()
  if(EXISTS "${_stamp}")
    # Aside: what a bundler that fails has written already is no bundle.
    set(_made "${OUTPUT}/bundling/made")
    file(REMOVE_RECURSE "${_made}")
    file(MAKE_DIRECTORY "${_made}")
    execute_process(COMMAND "${NODE}" build.mjs "${_made}" WORKING_DIRECTORY "${OUTPUT}/bundling" RESULT_VARIABLE _status
      OUTPUT_VARIABLE _log ERROR_VARIABLE _log TIMEOUT 120)
    set(_script "")
    set(_licences "")
    foreach(_part script=report.js licences=licences.json)
      string(REGEX MATCH "^([a-z]+)=(.+)$" _matched "${_part}")
      if(EXISTS "${_made}/${CMAKE_MATCH_2}")
        file(READ "${_made}/${CMAKE_MATCH_2}" _${CMAKE_MATCH_1} LIMIT 4096)
      endif()
    endforeach()
    # A bundle of nothing, or of libraries whose licences nobody can list, is not passed on.
    if(_status EQUAL 0 AND NOT _script STREQUAL "" AND _licences MATCHES "^\\[[ \n]*{")
      file(RENAME "${_made}/report.js" "${OUTPUT}/report.js")
      file(RENAME "${_made}/licences.json" "${OUTPUT}/licences.json")
      set(_done TRUE)
    else()
      string(PREPEND _log "node: ${_status}\n")
    endif()
  endif()
  if(NOT _done)
    message("The report page is built without plots and scene, since its libraries could not be bundled:\n${_log}")
    file(WRITE "${OUTPUT}/failed" "${_log}")
  endif()
endif()
if(NOT _done)
  file(WRITE "${OUTPUT}/report.js" "")
  file(WRITE "${OUTPUT}/licences.json" "[]")
endif()
