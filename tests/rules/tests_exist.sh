#!/bin/sh
# Fails where a page names a test that is not there: `Suite.Name`, also with an end left out (`Suite.Beginning...`,
# `Suite.*`), and ctest -R "pattern", of which each alternative must find a test. Usage: tests_exist.sh ROOT
set -eu
cd "$1"
names=$(mktemp)
trap 'rm -f "$names"' EXIT
{
  grep -ohE '^ *TEST(_F|_P)?\([A-Za-z0-9]+, *[A-Za-z0-9]+' tests/*/*.cpp | sed 's/.*(//; s/, */./'
  sed -n 's/.*add_test(NAME \([a-z_.]*\).*/\1/p' tests/CMakeLists.txt
} | sort -u >"$names"

find . \( -name .git -o -path ./build -o -path ./try -o -path ./demo -o -name node_modules \) -prune -o -name '*.md' -print |
  sort | tr '\n' '\0' | xargs -0 awk -v names="$names" '
  BEGIN { while ((getline name < names) > 0) tests[++count] = name }
  function any(pattern,   i) {
    for (i = 1; i <= count; ++i) if (tests[i] ~ pattern) return 1
    return 0
  }
  function complain(what) { print FILENAME ":" FNR ": " what "   (there is no such test)"; bad = 1 }
  {
    text = $0
    while (match(text, /`[A-Z][a-z][A-Za-z0-9]*\.([A-Z][A-Za-z0-9]*)?[.*A-Za-z]*`/)) {
      name = substr(text, RSTART + 1, RLENGTH - 2)
      text = substr(text, RSTART + RLENGTH)
      pattern = "^" name (name ~ /[.]$/ ? "" : "$")
      sub(/\.\.\./, "", pattern)
      gsub(/\./, "\\.", pattern)
      gsub(/\*/, ".*", pattern)
      if (!any(pattern)) complain(name)
    }
    text = $0
    while (match(text, /ctest [^`]*-R +("[^"]+"|[^ `"]+)/)) {
      pattern = substr(text, RSTART, RLENGTH)
      text = substr(text, RSTART + RLENGTH)
      sub(/.*-R +/, "", pattern)
      gsub(/"/, "", pattern)
      alternatives = split(pattern, alternative, /\\?\|/)
      for (i = 1; i <= alternatives; ++i) if (!any(alternative[i])) complain("ctest -R " alternative[i])
    }
  }
  END { exit bad }
' || exit 1
