#!/bin/sh
# The rule must catch what it is for: a test that no build file names.
set -eu
rule=$(dirname "$0")/sources_listed.sh
house=$(mktemp -d)
trap 'rm -rf "$house"' EXIT
mkdir -p "$house/tests/unit" "$house/base" "$house/build"
echo 'add_test_program(unit SOURCES unit/files_test.cpp unit/text_test.cpp)  # not unit/zip_test.cpp' >"$house/tests/CMakeLists.txt"
echo 'bitrock_module(base SOURCES files.cpp)' >"$house/base/CMakeLists.txt"
touch "$house/tests/unit/files_test.cpp" "$house/tests/unit/text_test.cpp" "$house/base/files.cpp" "$house/build/made.cpp"
"$rule" "$house"
expect_refusal() {
  touch "$house/$1"
  if "$rule" "$house" >/dev/null; then
    echo "not caught: $1"
    exit 1
  fi
  rm "$house/$1"
}
expect_refusal tests/unit/lock_test.cpp
expect_refusal tests/unit/zip_test.cpp
expect_refusal tests/unit/more_files_test.cpp
expect_refusal tests/files_test.cpp
expect_refusal base/zip.cpp
"$rule" "$house"
