#!/bin/sh
# The rule must catch what it is for: one name for two types.
set -eu
rule=$(dirname "$0")/types_once.sh
house=$(mktemp -d)
trap 'rm -rf "$house"' EXIT
mkdir -p "$house/studies/campaign" "$house/studies/well" "$house/runtime"
printf 'namespace bitrock::studies {\nstruct Survey {\n};\n}\n' >"$house/studies/campaign/status.hpp"
printf 'namespace bitrock::studies {\nstruct Survey;\nstruct WellSurvey {\n};\n}\n' >"$house/studies/well/survey.hpp"
printf 'namespace bitrock::runtime {\nstruct Survey {\n};\n}\n' >"$house/runtime/survey.hpp"
"$rule" "$house"
for kind in 'struct Survey {' 'class Survey final {' 'enum class Survey : int {' 'struct alignas(64) Survey {'; do
  printf 'namespace bitrock::studies {\n%s\n};\n}\n' "$kind" >"$house/studies/well/survey.hpp"
  if "$rule" "$house" >/dev/null; then
    echo "not caught: $kind"
    exit 1
  fi
done
