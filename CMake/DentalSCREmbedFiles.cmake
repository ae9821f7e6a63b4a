# Makes a C++ file of text files, for dentalscr_embed_files():
# cmake "-DPARTS=Name=file|…" -DNAMESPACE=ReportParts -DOUTPUT=file -P DentalSCREmbedFiles.cmake
# Each part becomes a function of itk::NAMESPACE, which itkNAMESPACE.h declares.
set(_source "#include \"itk${NAMESPACE}.h\"\n\nnamespace itk\n{\nnamespace ${NAMESPACE}\n{\n")
string(REPLACE "|" ";" _parts "${PARTS}")
foreach(_part IN LISTS _parts)
  string(REGEX MATCH "^([A-Za-z]+)=(.*)$" _matched "${_part}")
  set(_name "${CMAKE_MATCH_1}")
  # As bytes: a text may hold anything, and a string literal not every quote.
  file(READ "${CMAKE_MATCH_2}" _bytes HEX)
  string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," _bytes "${_bytes}")
  string(APPEND _source "namespace\n{\nconst unsigned char ${_name}Bytes[] = { ${_bytes}0 };\n}\n"
    "std::string_view\n${_name}()\n{\n  return { reinterpret_cast<const char *>(${_name}Bytes), sizeof(${_name}Bytes) - 1 };\n}\n")
endforeach()
string(APPEND _source "} // namespace ${NAMESPACE}\n} // namespace itk\n")
file(WRITE "${OUTPUT}" "${_source}")
