# cmake -DPROGRAM=... -DOUTPUT=... -DPAGES=... -P WriteManuals.cmake: the manual page of the program and of every verb, packed, with
# the PAGES that are written by hand, and a script of completion for each shell.
function(write_what_it_says _file)
  execute_process(COMMAND "${PROGRAM}" ${ARGN} OUTPUT_FILE "${_file}" COMMAND_ERROR_IS_FATAL ANY)
endfunction()

# Without the time of its packing: the same program gives the same file.
find_program(GZIP gzip REQUIRED)
function(pack _page)
  get_filename_component(_name "${_page}" NAME)
  execute_process(COMMAND "${GZIP}" -9 -n -c "${_page}" OUTPUT_FILE "${OUTPUT}/man/man1/${_name}.gz"
    COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE "${OUTPUT}")
file(MAKE_DIRECTORY "${OUTPUT}/man/man1" "${OUTPUT}/pages")
execute_process(COMMAND "${PROGRAM}" --describe OUTPUT_VARIABLE _description COMMAND_ERROR_IS_FATAL ANY)
string(JSON _count LENGTH "${_description}" verbs)
math(EXPR _last "${_count} - 1")
write_what_it_says("${OUTPUT}/pages/dentalscr.1" --man)
foreach(_index RANGE ${_last})
  string(JSON _verb GET "${_description}" verbs ${_index} name)
  write_what_it_says("${OUTPUT}/pages/dentalscr-${_verb}.1" --man ${_verb})
endforeach()
file(GLOB _pages "${OUTPUT}/pages/*.1")
foreach(_page IN LISTS _pages PAGES)
  pack("${_page}")
endforeach()
foreach(_shell bash zsh fish)
  write_what_it_says("${OUTPUT}/dentalscr.${_shell}" --completion ${_shell})
endforeach()
file(TOUCH "${OUTPUT}/written")
