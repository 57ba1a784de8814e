#!/usr/bin/env bash
# ParaView itself reads what `bitrock export vtk` wrote: a small cut is made, exported, and compared with its run file.
#   tests/paraview/read_back.sh PROGRAM ROCK.toml
# Needs Debian's packages paraview, python3-paraview and python3-h5py; ends with status 77 (skipped) without them.
set -euo pipefail

program=$1 rock=$2
here=$(cd "$(dirname "$0")" && pwd)
command -v pvpython >/dev/null || { echo "skipped: no pvpython (packages paraview python3-paraview)"; exit 77; }
/usr/bin/python3 -c 'import h5py' 2>/dev/null || { echo "skipped: no h5py (package python3-h5py)"; exit 77; }

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cat >"$scratch/cut.toml" <<END
rock = "$rock"
[cut]
cutter_speed_m_per_s = 2
depth_of_cut_mm = 2
back_rake_deg = 15
cut_length_mm = 6
[bed]
length_mm = 20
height_mm = 10
END
"$program" cut "$scratch/cut.toml" --frames 4 -o "$scratch/run.h5" --quiet
"$program" export vtk "$scratch/run.h5" -o "$scratch/vtk" --quiet
# what ParaView sees, and what the run file holds, in two interpreters: pvpython brings libraries of its own
pvpython --force-offscreen-rendering "$here/what_paraview_sees.py" "$scratch/vtk" "$scratch/seen.json"
/usr/bin/python3 "$here/compare.py" "$scratch/run.h5" "$scratch/seen.json"
