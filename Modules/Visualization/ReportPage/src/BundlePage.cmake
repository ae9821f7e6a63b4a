# Bundles the page's script with its libraries: cmake -DPAGE=… -DOUTPUT=… -DENABLED=… -DNPM=… -DNODE=… -P BundlePage.cmake
# Writes OUTPUT/report.js and OUTPUT/licences.json. Never fails: without npm, or where the registry can't be reached, both are
# empty, and the page does without.
file(MAKE_DIRECTORY "${OUTPUT}/bundling")
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
      WORKING_DIRECTORY "${OUTPUT}/bundling" RESULT_VARIABLE _failed OUTPUT_VARIABLE _log ERROR_VARIABLE _log TIMEOUT 180)
    if(_failed EQUAL 0)
      file(WRITE "${_stamp}" "")
    endif()
  endif()
  if(EXISTS "${_stamp}")
    execute_process(COMMAND "${NODE}" build.mjs "${OUTPUT}" WORKING_DIRECTORY "${OUTPUT}/bundling" RESULT_VARIABLE _failed
      OUTPUT_VARIABLE _log ERROR_VARIABLE _log TIMEOUT 120)
    if(_failed EQUAL 0)
      set(_done TRUE)
    endif()
  endif()
  if(NOT _done)
    message("The report page is built without plots and scene, since its libraries could not be bundled:\n${_log}")
  endif()
endif()
if(NOT _done)
  file(WRITE "${OUTPUT}/report.js" "")
  file(WRITE "${OUTPUT}/licences.json" "[]")
endif()
