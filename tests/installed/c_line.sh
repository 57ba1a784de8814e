#!/usr/bin/env bash
# A C program with the force on a bit is compiled by one line, with the flags spelt out and with those of pkg-config,
# also when the prefix was moved.
#   c_line.sh PREFIX CC EXAMPLES
set -euo pipefail
cc=$2
examples=$(cd "$3" && pwd)
example=$(cd "$(dirname "$0")" && pwd)/example.sh
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cp -r "$1" "$scratch/moved"
prefix=$scratch/moved
cd "$scratch"
"$prefix/bin/bitrock" export bit campaigns/paper240/model.json campaigns/bits/pdc15.toml -o bit.h --quiet
"$cc" -std=c99 -Wall -Wextra -Werror "$examples/fixed_step.c" -I. -I"$prefix/include/bitrock" -L"$prefix/lib" \
  -lbitrock_runtime -Wl,-rpath,"$prefix/lib" -lm -o spelt_out
"$example" "$examples/README.md" fixed_step ./spelt_out
export PKG_CONFIG_PATH=$prefix/lib/pkgconfig
# shellcheck disable=SC2046
"$cc" -std=c99 "$examples/fixed_step.c" -I. $(pkg-config --cflags --libs bitrock_runtime) -lm -o by_pkg_config
"$example" "$examples/README.md" fixed_step ./by_pkg_config
