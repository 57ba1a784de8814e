#!/bin/sh
# A page passes when its blocks print what it says, and only then.
set -eu
run=$(dirname "$0")/run_page.py
pages=$(mktemp -d)
trap 'rm -rf "$pages"' EXIT
page() { printf '%s\n' "$@" >"$pages/page.md"; }
refused() {
  if "$run" "$pages/page.md" "$pages" >/dev/null 2>&1; then
    echo "not caught: $1"
    exit 1
  fi
}

page '```sh' 'x=2; printf "one\n%d bits, 3 s\nend\n" $x' '```' '```text' '2 bits, ... s' '```' '```sh' 'echo $x' '```' \
  '```text' '2' '```'
"$run" "$pages/page.md" "$pages"
page '```sh' 'echo 2 bits' '```' '```text' '3 bits' '```'
refused "another line"
page '```sh' 'false' '```' '```sh' 'echo 1' '```' '```text' '1' '```'
refused "a command that fails"
page '```console' 'echo 1' '```' '```text' '1' '```'
refused "a page without anything to run"
