#!/bin/sh
# Fails where two headers define a type of one name in one namespace: a program that holds both is undefined, and only the
# sanitizers may notice. Usage: types_once.sh ROOT
set -eu
cd "$1"
find . \( -name .git -o -path ./build -o -path ./try -o -path ./demo -o -path ./tests -o -name node_modules \) -prune -o -name '*.hpp' -print |
  sort | tr '\n' '\0' | xargs -0 awk '
  FNR == 1 { space = "" }
  /^namespace [A-Za-z0-9_:]+ \{/ && space == "" { space = $2 }
  /^(struct|class|enum|enum class) [A-Za-z0-9_]+[^;]*\{/ {
    name = $0
    sub(/^(enum class|enum|struct|class) /, "", name)
    sub(/^alignas\([^)]*\) /, "", name)
    sub(/[^A-Za-z0-9_].*/, "", name)
    key = space "::" name
    if (key in home && home[key] != FILENAME) { print FILENAME ":" FNR ": " key " is defined in " home[key] ", too"; bad = 1 }
    home[key] = FILENAME
  }
  END { exit bad }
' || exit 1
