#!/usr/bin/env bash
# Installs a build into an empty prefix and builds a small program of somebody else against it.
#   tests/installed/find_package.sh BUILD CMAKE
set -euo pipefail
build=$1
cmake=$2
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
"$cmake" --install "$build" --prefix "$scratch/prefix" >"$scratch/log"
"$cmake" -S "$(dirname "$0")" -B "$scratch/build" -DCMAKE_PREFIX_PATH="$scratch/prefix" >"$scratch/log"
"$cmake" --build "$scratch/build"
"$scratch/build/somebody_else"
