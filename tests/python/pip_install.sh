#!/bin/sh
# `pip install .` of a copy of the checkout, without a network, gives a package that works from any folder. It compiles
# the libraries anew, which takes minutes: its label is `slow`. Skipped (77) where pip or a Debian package is missing.
#   pip_install.sh PYTHON SOURCE
set -eu
python=$1
source=$2
[ -n "$python" ] || { echo "skipped: no Python (see BITROCK_PYTHON)"; exit 77; }
"$python" -c 'import setuptools, pip, wheel, numpy' 2>/dev/null ||
  { echo "skipped: needs python3-pip, python3-setuptools, python3-wheel, python3-numpy"; exit 77; }
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
mkdir "$scratch/check out"
(cd "$source" && tar -cf - --exclude=./build --exclude=./demo --exclude=./try --exclude=./.git --exclude=node_modules .) |
  tar -xf - -C "$scratch/check out"
cd "$scratch/check out"
env -u PYTHONPATH "$python" -m pip install --quiet --no-index --no-build-isolation --no-deps --break-system-packages \
  --target "$scratch/packages" .
mkdir "$scratch/elsewhere"
cd "$scratch/elsewhere"
PYTHONPATH=$scratch/packages "$python" - <<'END'
import bitrock

assert str(bitrock.data_dir()).startswith(__import__("os").environ["PYTHONPATH"]), bitrock.data_dir()
model = bitrock.Model.load("campaigns/paper240/model.json")
said = model.predict(speed_m_per_s=0.5, depth_mm=2, rake_deg=15)
assert said["inside_training_range"] and said["x_amax_N_per_m"] > 1e3
run = bitrock.cut("campaigns/cuts/example.toml", cut_length_mm=2, bed_length_mm=12, bed_height_mm=8, energy=False)
assert run.force_x_N_per_m.size == 100
assert bitrock.parity(model, "campaigns/paper240/features.csv").same_data
print("installed:", bitrock.__version__, run)
END
