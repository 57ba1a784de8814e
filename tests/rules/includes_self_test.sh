#!/bin/sh
# The rule must catch what it is for: a planted forbidden include fails, an allowed one passes.
set -eu
rule=$(dirname "$0")/includes.sh
house=$(mktemp -d)
trap 'rm -rf "$house"' EXIT
mkdir -p "$house/base" "$house/dem2d" "$house/surrogate/export" "$house/surrogate/net" "$house/surrogate/train" "$house/runtime"
echo '#include "base/files.hpp"' >"$house/dem2d/good.cpp"
echo '#include "surrogate/net/model.hpp"' >"$house/runtime/good.hpp"
"$rule" "$house"
expect_refusal() {
  printf '%s\n' "$2" >"$house/$1"
  if "$rule" "$house" >/dev/null; then
    echo "not caught: $2 in $1"
    exit 1
  fi
  rm "$house/$1"
}
expect_refusal dem2d/bad.hpp '#include "peaks/statistics.hpp"'
expect_refusal base/bad.cpp '  # include "dem2d/step/step.hpp"'
expect_refusal surrogate/net/bad.hpp '#include "surrogate/train/adam.hpp"'
expect_refusal surrogate/export/bad.hpp '#include "surrogate/train/adam.hpp"'
expect_refusal runtime/bad.cpp '#include "surrogate/train/train.hpp"'
expect_refusal runtime/bad.cpp '#include "neighbour.hpp"'
"$rule" "$house"
