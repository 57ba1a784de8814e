#!/usr/bin/env bash
# Installs a build into an empty prefix, for the tests that look at what is installed.
#   prefix.sh BUILD CMAKE PREFIX
set -euo pipefail
rm -rf "$3"
"$2" --install "$1" --prefix "$3" >/dev/null
