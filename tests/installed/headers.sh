#!/usr/bin/env bash
# Compiles every installed header alone, with nothing else of bitrock's source at hand: each brings along what it needs.
#   headers.sh PREFIX CXX...
set -euo pipefail
prefix=$(cd "$1" && pwd)
shift
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# alone CXX INCLUDE_FOLDER HEADER
alone() {
  local options=(-std=c++20)
  [[ $3 != *.h ]] || options=(-x c -std=c99)
  "$1" "${options[@]}" -fsyntax-only -Wall -Wextra -Wpedantic -Wno-missing-field-initializers -Werror -I"$2" \
    -include "$3" -x "$([[ $3 == *.h ]] && echo c || echo c++)" /dev/null
}
export -f alone

# What this test is for: a header that leans on others, or on one that is not installed, is refused.
mkdir "$scratch/bad"
echo 'inline std::size_t size() { return 0; }' >"$scratch/bad/leans.hpp"
echo '#include "base/not_installed.hpp"' >"$scratch/bad/internal.hpp"
for bad in leans internal; do
  if alone "$1" "$scratch/bad" $bad.hpp 2>"$scratch/message"; then
    echo "the test did not see that $bad.hpp cannot be compiled alone"
    exit 1
  fi
done

include=$prefix/include/bitrock
(cd "$include" && find . -name '*.hpp' -o -name '*.h') | sed 's|^\./||' | sort >"$scratch/headers"
[ -s "$scratch/headers" ] || { echo "no header in $include"; exit 1; }
seen=
for compiler in "$@"; do
  command -v "$compiler" >/dev/null || { echo "$compiler is not installed: passed over"; continue; }
  program=$(readlink -f "$(command -v "$compiler")")
  case " $seen " in *" $program "*) echo "$compiler is $program, too"; continue ;; esac
  seen="$seen $program"
  xargs -P 2 -I{} bash -c 'alone "$@"' alone "$compiler" "$include" {} <"$scratch/headers"
  echo "$compiler: $(wc -l <"$scratch/headers") headers, each alone"
done
