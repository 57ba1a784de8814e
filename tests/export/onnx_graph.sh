#!/bin/sh
# onnx_graph.py by Debian's Python, whose packages other Pythons do not see; skipped without it.
[ -x /usr/bin/python3 ] || { echo "skipped: no /usr/bin/python3 (package python3-onnx)"; exit 77; }
exec /usr/bin/python3 "$(dirname "$0")/onnx_graph.py" "$@"
