#!/usr/bin/env bash
# Pages of the C++ classes in build/doxygen/html. Fails on any warning, where a public class has no words, and where more
# functions have none than before.
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

# Of members only how many have no words counts; everything else that doxygen says is an error.
if grep -Ev 'warning: Member .* is not documented\.$' $log; then
  exit 1
fi
# Lower this with every comment; never raise it. A function stands once, however many classes inherit it.
allowed=405
silent=$(grep '(function) of .* is not documented\.$' $log | sed 's/: warning: .*//' | sort -u || true)
count=$(printf '%s\n' "$silent" | grep -c . || true)
if [ "$count" -gt $allowed ]; then
  printf '%s\n' "$silent"
  echo "$count functions have no words in a header, and $allowed had none before: say what the new ones are for" >&2
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
