#!/usr/bin/env bash
# Fails when a library for hosts needs or shows more than it promises: runtime_symbols.sh LIBRARY PREFIX COUNT [ALSO]
# It must load wherever an FMU, an S-function or a user subroutine loads: nothing of the C++ library, glibc 2.31 (Ubuntu
# 20.04, RHEL 9) or older, no variables; at least COUNT names, all of which begin with PREFIX. The core has no heap, no
# files and no printing; what an FMU needs of the C library is ALSO allowed (names with | between them).
set -euo pipefail
library=$1 prefix=$2 count=$3 also=${4:-memcpy}
failed=0

refuse() {
  echo "$1:"
  printf '  %s\n' $2
  failed=1
}

# What the compiler itself calls, and four functions of libm. The weak ones are those of every shared library.
allowed="memcpy|memmove|memset|memcmp|exp|expm1|log1p|floor|$also"
needed=$(nm -D --undefined-only "$library" | awk '$1 == "U" { sub(/@.*/, "", $2); print $2 }')
others=$(printf '%s\n' $needed | grep -Ev "^($allowed)$" || true)
[ -z "$others" ] || refuse "needs" "$others"
weak=$(nm -D --undefined-only "$library" | awk '$1 == "w" { sub(/@.*/, "", $2); print $2 }')
others=$(printf '%s\n' $weak | grep -Ev '^(__cxa_finalize|__gmon_start__|_ITM_(de)?registerTMCloneTable)?$' || true)
[ -z "$others" ] || refuse "may need" "$others"

shown=$(nm -D --defined-only "$library" | awk '{ print $2, $3 }')
others=$(printf '%s\n' "$shown" | grep -Ev "^T $prefix" | tr ' ' ':' || true)
[ -z "$others" ] || refuse "shows" "$others"
[ "$(printf '%s\n' "$shown" | grep -c "^T $prefix")" -ge "$count" ] || refuse "shows too little" "$(printf '%s' "$shown" | tr ' ' ':')"

newest=$(objdump -T "$library" | grep -o 'GLIBC_[0-9.]*' | sed 's/GLIBC_//' | sort -V | tail -1)
[ "$(printf '%s\n2.31\n' "$newest" | sort -V | tail -1)" = 2.31 ] || refuse "needs glibc" "$newest"

others=$(readelf -d "$library" | sed -n 's/.*(NEEDED).*\[\(.*\)\].*/\1/p' | grep -Ev '^lib[cm]\.so\.6$' || true)
[ -z "$others" ] || refuse "links" "$others"

# Variables of its own, as far as the names are still there: two instances would share them. The two __cpu_ ones are the
# compiler's: which vectors the machine has, written once when the library is loaded.
others=$(nm --defined-only "$library" 2>/dev/null | awk '$2 ~ /^[bBdDcC]$/ { print $3 }' |
  grep -Ev '^(completed\.[0-9]+|__dso_handle|__TMC_END__|_DYNAMIC|_GLOBAL_OFFSET_TABLE_|__bss_start|__cpu_model|__cpu_features2|_edata|_end|__[a-z_]*_array_entry)$' || true)
[ -z "$others" ] || refuse "keeps variables" "$others"

[ $failed = 0 ] && echo "$(basename "$library"): glibc $newest, $(printf '%s\n' "$shown" | wc -l) names, nothing else"
exit $failed
