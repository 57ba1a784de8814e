#!/bin/sh
# Runs the tests of the Python package. Skipped (77) where the package was not built or pytest is missing.
#   run.sh PYTHON PACKAGE_FOLDER PROGRAM SOURCE
set -eu
python=$1
package=$2
export BITROCK_PROGRAM=$3 BITROCK_SOURCE=$4
[ -n "$python" ] && [ -f "$package/bitrock/__init__.py" ] || { echo "skipped: the package is not built (see BITROCK_PYTHON)"; exit 77; }
"$python" -c 'import pytest' 2>/dev/null || { echo "skipped: no pytest (python3-pytest)"; exit 77; }
PYTHONPATH=$package PYTHONDONTWRITEBYTECODE=1 MPLBACKEND=Agg exec "$python" -m pytest -q -p no:cacheprovider "$4/tests/python"
