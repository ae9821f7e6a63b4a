#!/usr/bin/env bash
# Pages of the C++ classes in build/doxygen/html. Fails on any warning, and where a public class has no words.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

out=build/doxygen
log=$out/warnings.log
mkdir -p $out
version=$(sed -n 's/^ *VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt | head -n 1)

# A group for every module, in the words of its itk-module.cmake.
{
  printf '/** \\mainpage Classes of DentalSCR\nBy module: the page Modules. By concept: Documentation/ClassIndex.md. */\n'
  for file in Modules/*/*/itk-module.cmake; do
    name=$(basename "$(dirname "$file")")
    printf '/** \\defgroup %s %s\n\\brief %s */\n' "$name" "$name" "$(tr '\n' ' ' <"$file" | sed -n 's/.*DESCRIPTION *"\([^"]*\)".*/\1/p')"
  done
} >$out/modules.dox

{
  cat Documentation/Doxyfile
  printf 'INPUT = Modules %s/modules.dox\n' $out
  printf 'PROJECT_NUMBER = %s\nOUTPUT_DIRECTORY = %s\nWARN_LOGFILE = %s\n' "$version" $out $log
  for module in Modules/*/*/itk-module.cmake; do
    printf 'PREDEFINED += %s_EXPORT=\n' "$(basename "$(dirname "$module")")"
  done
} | doxygen -

# Members speak by their names; everything else counts.
if grep -Ev 'warning: Member .* is not documented\.$' $log; then
  exit 1
fi
echo "$out/html/index.html"
