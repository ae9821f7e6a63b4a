#!/usr/bin/env bash
# Pages of the C++ classes in build/doxygen/html. Fails on any warning: where a class, a function, a variable or a type has no words,
# and where the words do not fit.
set -euo pipefail
[ "${1:-}" != --help ] || { sed -n '2,3s/^# \?//p' "${BASH_SOURCE[0]}"; exit 0; }
cd "$(dirname "${BASH_SOURCE[0]}")/.."

out=build/doxygen
log=$out/warnings.log
rm -rf $out
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
  # The folders by name, not all of Modules less a pattern: a pattern sees the whole path, and the checkout may lie in src/.
  printf 'INPUT = %s/modules.dox\n' $out
  printf 'INPUT += %s\n' Modules/*/*/include
  # A comment of ours is about all that follows it up to an empty line, as ITK's are.
  printf 'INPUT_FILTER = "%s Utilities/doxygen_filter.py"\nDISTRIBUTE_GROUP_DOC = YES\n' /usr/bin/python3
  printf 'GENERATE_TAGFILE = %s/dentalscr.tag\n' $out
  printf 'PROJECT_NUMBER = %s\nOUTPUT_DIRECTORY = %s\nWARN_LOGFILE = %s\n' "$version" $out $log
  for module in Modules/*/*/itk-module.cmake; do
    printf 'PREDEFINED += %s_EXPORT=\n' "$(basename "$(dirname "$module")")"
  done
} | doxygen -

# Whatever doxygen says is an error, a member without words included, of a class as of a structure.
if [ -s $log ]; then
  cat $log >&2
  echo "$(wc -l <$log) members or pages without words or with wrong ones: a comment before each, or words in Utilities/doxygen_filter.py" >&2
  exit 1
fi
# A run that finds nothing to warn of has to have read something: nearly every header declares a class.
headers=$(find Modules/*/*/include -name 'itk*.h' | wc -l)
classes=$(find $out/html \( -name 'class*.html' -o -name 'struct*.html' \) ! -name '*-members.html' | wc -l)
if [ "$classes" -lt $((headers / 2)) ]; then
  echo "doxygen made pages of $classes classes from $headers headers" >&2
  exit 1
fi
echo "$out/html/index.html"
