#!/usr/bin/env bash
# Fails when the Windows library of an FMU needs more than every Windows has, or shows other names than the standard's:
# fmu_symbols_win64.sh LIBRARY
set -euo pipefail
objdump=x86_64-w64-mingw32-objdump
command -v $objdump >/dev/null || { echo "skipped: no $objdump"; exit 77; }
said=$($objdump -p "$1")
needed=$(sed -n 's/.*DLL Name: //p' <<<"$said" | sort | tr '\n' ' ')
[ "$needed" = "KERNEL32.dll msvcrt.dll " ] || { echo "needs $needed"; exit 1; }
shown=$(sed -n '/Ordinal\/Name Pointer/,/^$/s/^.*\[ *[0-9]*\] //p' <<<"$said")
[ "$(grep -c '^fmi2' <<<"$shown")" = 34 ] && [ "$(wc -l <<<"$shown")" = 34 ] || { echo "shows:"; echo "$shown"; exit 1; }
echo "$(basename "$1"): needs $needed"
