#!/usr/bin/env bash
# ParaView itself reads what `bitrock export vtk` wrote: a small cut, or a short trip of a string into a well, is made, exported,
# and compared with its file.
#   tests/paraview/read_back.sh PROGRAM ROCK.toml | CASE.toml
# Needs Debian's packages paraview, python3-paraview and python3-h5py; ends with status 77 (skipped) without them.
set -euo pipefail

program=$1 input=$2
here=$(cd "$(dirname "$0")" && pwd)
command -v pvpython >/dev/null || { echo "skipped: no pvpython (packages paraview python3-paraview)"; exit 77; }
/usr/bin/python3 -c 'import h5py' 2>/dev/null || { echo "skipped: no h5py (package python3-h5py)"; exit 77; }

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
if grep -q '^\[well\]' "$input"; then
  sed -e 's/^duration_s = .*/duration_s = 2/' -e 's/^settling_s = .*/settling_s = 1/' -e 's/^source = .*/source = "none"/' \
    -e '/^model = /d' -e 's/^file = .*/friction_radius_mm = 80/' -e 's/^\[well\]/&\nframes = 5/' "$input" >"$scratch/well.toml"
  "$program" drill run "$scratch/well.toml" -o "$scratch/well.h5" --quiet
  "$program" export vtk "$scratch/well.h5" -o "$scratch/vtk" --quiet
  pvpython --force-offscreen-rendering "$here/what_paraview_sees.py" "$scratch/vtk" "$scratch/seen.json" string hole
  /usr/bin/python3 "$here/compare_well.py" "$scratch/well.h5" "$scratch/seen.json"
  exit
fi
cat >"$scratch/cut.toml" <<END
rock = "$input"
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
pvpython --force-offscreen-rendering "$here/what_paraview_sees.py" "$scratch/vtk" "$scratch/seen.json" discs joints cracks cutter
/usr/bin/python3 "$here/compare.py" "$scratch/run.h5" "$scratch/seen.json"
