#!/bin/sh
# The rule must catch what it is for: keys that are not in the list, and places in sources that nobody has read.
set -eu
rule=$(dirname "$0")/references.sh
house=$(mktemp -d)
trap 'rm -rf "$house"' EXIT
mkdir -p "$house/docs" "$house/base"
printf '@article{Read2001,\n  note = {abstract read}\n}\n@book{Unread1999,\n  note = {not consulted}\n}\n' >"$house/docs/references.bib"
printf '/// As in [Read2001, eq. 3] and [Unread1999]; both in [Read2001, sec. 2,\n/// eq. 4; Unread1999].\n' >"$house/base/a.hpp"
"$rule" "$house"
expect_refusal() {
  printf '%s\n' "$1" >"$house/base/b.hpp"
  if "$rule" "$house" >/dev/null; then
    echo "not caught: $1"
    exit 1
  fi
}
expect_refusal '/// [Nobody2020]'
expect_refusal '/// [Read2001, Nobody2020]'
expect_refusal '/// [Unread1999, eq. 7]'
expect_refusal '/// [Unread1999, secs. 2, 3]'
expect_refusal '/// [Read2001, sec. 1; Unread1999, table 2]'
expect_refusal "$(printf '/// in [Unread1999,\n/// ch. 4]')"
