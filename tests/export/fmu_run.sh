#!/usr/bin/env bash
# Exports a bit with the shipped model and runs it in a program that holds nothing of bitrock.
#   fmu_run.sh BITROCK FMU_RUN SOURCE CMAKE
# By hand, for Windows, in a folder where the FMU is unpacked (the lines must be the same):
#   x86_64-w64-mingw32-g++ -std=c++20 -O2 -static -I SOURCE SOURCE/tests/export/fmu_run.cpp -o fmu_run.exe
#   wine fmu_run.exe binaries/win64/bitrock_bit.dll GUID "file:///Z:$PWD/resources"
set -euo pipefail
bitrock=$1 fmu_run=$2 source=$3 cmake=$4
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"
"$bitrock" export fmu "$source/campaigns/paper240/model.json" "$source/campaigns/bits/pdc15.toml" -o bit.fmu --quiet
"$cmake" -E tar xf bit.fmu
guid=$(sed -n 's/.*guid="\([^"]*\)".*/\1/p' modelDescription.xml)
"$fmu_run" binaries/linux64/bitrock_bit.so "$guid" "file://$scratch/resources" >lines
[ "$(wc -l <lines)" = 30 ] || { echo "30 lines expected:"; cat lines; exit 1; }
[ "$(cut -d' ' -f2 lines | sort -u | wc -l)" -gt 20 ] || { echo "the torque hardly changes:"; cat lines; exit 1; }
tail -1 lines
