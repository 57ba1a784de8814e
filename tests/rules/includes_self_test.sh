#!/bin/sh
# The rule must catch what it is for: a planted forbidden include fails, an allowed one passes.
set -eu
rule=$(dirname "$0")/includes.sh
house=$(mktemp -d)
trap 'rm -rf "$house"' EXIT
mkdir -p "$house/base" "$house/dem2d/step" "$house/surrogate/export" "$house/surrogate/net" "$house/surrogate/train" \
  "$house/runtime/bit" "$house/runtime/core" "$house/runtime/fmu" "$house/studies" "$house/views"
echo '#include "base/files.hpp"' >"$house/dem2d/step/good.cpp"
echo '#include "surrogate/net/model.hpp"' >"$house/runtime/bit/good.hpp"
echo '#include "studies/campaign/study.hpp"' >"$house/views/good.hpp"
"$rule" "$house"
expect_refusal() {
  printf '%s\n' "$2" >"$house/$1"
  if "$rule" "$house" >/dev/null; then
    echo "not caught: $2 in $1"
    exit 1
  fi
  rm "$house/$1"
}
expect_refusal dem2d/step/bad.hpp '#include "peaks/statistics.hpp"'
expect_refusal base/bad.cpp '  # include "dem2d/step/step.hpp"'
expect_refusal surrogate/net/bad.hpp '#include "surrogate/train/adam.hpp"'
expect_refusal surrogate/export/bad.hpp '#include "surrogate/train/adam.hpp"'
expect_refusal runtime/bit/bad.cpp '#include "surrogate/train/train.hpp"'
expect_refusal runtime/bit/bad.cpp '#include "neighbour.hpp"'
expect_refusal runtime/core/bad.cpp '#include "runtime/fmu/fmu.hpp"'
expect_refusal runtime/core/bad.cpp '#include "runtime/bit/bit.hpp"'
expect_refusal dem2d/step/bad.cpp '#include "dem2d/specimen/rock.hpp"'
expect_refusal studies/bad.cpp '#include "views/cut/picture.hpp"'
expect_refusal views/bad.cpp '#include <ranges>'
expect_refusal runtime/somewhere.cpp '#include "base/files.hpp"'
"$rule" "$house"
