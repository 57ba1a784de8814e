#!/bin/sh
# The rule must catch what it is for: tests that pages name and nobody has written.
set -eu
rule=$(dirname "$0")/tests_exist.sh
house=$(mktemp -d)
trap 'rm -rf "$house"' EXIT
mkdir -p "$house/docs" "$house/tests/unit"
printf 'TEST(Text, IsRead) {\n}\nTEST_F(Cut, HasTheSameBits) {\n}\n' >"$house/tests/unit/text_test.cpp"
echo 'add_test(NAME rules.includes COMMAND rule)' >"$house/tests/CMakeLists.txt"
echo '`Text.IsRead`, `Cut.Has...`, `Text.*`, ctest -R "^Cut\.\|includes" and `ctest --preset release -R IsRead`' >"$house/docs/good.md"
"$rule" "$house"
expect_refusal() {
  printf '%s\n' "$1" >"$house/docs/bad.md"
  if "$rule" "$house" >/dev/null; then
    echo "not caught: $1"
    exit 1
  fi
}
expect_refusal 'Guarded by `Text.IsWritten`.'
expect_refusal 'Guarded by `Text.IsRe`.'
expect_refusal 'Guarded by `Text.Was...`.'
expect_refusal 'Guarded by `Bits.*`.'
expect_refusal '`ctest --preset release -R "^Text\.|Forces"`'
