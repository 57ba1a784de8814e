#!/bin/sh
# The rule must catch what it is for: names of files that are not there, on pages and in comments.
set -eu
rule=$(dirname "$0")/names_exist.sh
house=$(mktemp -d)
trap 'rm -rf "$house"' EXIT
mkdir -p "$house/base" "$house/docs/decisions" "$house/campaigns" "$house/tests/unit"
touch "$house/docs/decisions/0001-a-choice.md" "$house/campaigns/article.toml" "$house/tests/unit/text_test.cpp"
printf '/// As in text.hpp; see docs/decisions/0001.\nint read_text();  // `base/text.hpp`\n' >"$house/base/text.hpp"
printf '# Text, by base/text.hpp and tests/unit/*_test.cpp\n' >"$house/base/CMakeLists.txt"
{
  echo '`base/text.hpp` `read_text`, [the first](decisions/0001-a-choice.md), [the same](../base/text.hpp#top),'
  echo '`campaigns/article.toml`, my.csv, `try/rock.toml`, `campaigns/R.toml`, <https://example.org/none.md>'
} >"$house/docs/page.md"
"$rule" "$house"
expect_refusal() {
  printf '%s\n' "$2" >"$house/$1"
  if "$rule" "$house" >/dev/null; then
    echo "not caught: $2 in $1"
    exit 1
  fi
  rm "$house/$1"
}
expect_refusal docs/other.md 'Coded in `base/forces.cpp`.'
expect_refusal docs/other.md 'Coded in `base/text.hpp` `write_text`.'
expect_refusal docs/other.md 'Coded in `base/text.hpp` `read_text`, `read`.'
expect_refusal docs/other.md 'See [the second](decisions/0002-another.md).'
expect_refusal docs/other.md 'Measured in `campaigns/finished.csv`.'
expect_refusal docs/other.md 'All of tests/unit/csv_*_test.cpp'
expect_refusal base/other.hpp '/// See forces.hpp.'
expect_refusal base/other.cpp 'int a = 0;  // docs/decisions/0002 says why'
expect_refusal base/other.sh '# usage: base/forces.sh'
"$rule" "$house"
