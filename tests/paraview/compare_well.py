"""Compares what ParaView saw (JSON) of a string in a well with the file it was exported from. Ends with status 1 at the first
difference."""
import json
import sys

import h5py

run = h5py.File(sys.argv[1], "r")
with open(sys.argv[2]) as file:
    seen = json.load(file)


def check(what, found, expected):
    if found != expected:
        sys.exit(f"{what}: ParaView saw {str(found)[:200]}, the file holds {str(expected)[:200]}")


def triples(names, part):
    return [list(values) for values in zip(*(run[f"string/{name}"][part].astype(float).tolist() for name in names))]


times = run["string/time_s"][:].tolist()
check("time steps", [instant["time"] for instant in seen["string"]], times)
first = 0
for k, nodes in enumerate(run["string/nodes"][:].tolist()):
    instant, part = seen["string"][k], slice(first, first + nodes)
    first += nodes
    check("nodes", instant["points"], triples(("north_m", "east_m", "down_m"), part))
    check("the line", instant["cells"], [list(range(nodes))])
    arrays = instant["point_arrays"]
    check("offsets", arrays["offset_m"], triples(("offset_north_m", "offset_east_m", "offset_down_m"), part))
    for name in ("measured_depth_m", "side_force_N", "tension_N", "torque_N_m", "bending_moment_N_m", "von_mises_Pa"):
        check(name, [value[0] for value in arrays[name]], run[f"string/{name}"][part].astype(float).tolist())
depths = [value[0] for value in seen["hole"][0]["point_arrays"]["measured_depth_m"]]
if not 0.0 == depths[0] < depths[-1] or depths[-1] < max(run["string/measured_depth_m"][:]):
    sys.exit(f"the hole goes from {depths[0]} to {depths[-1]} m")
print(f"{len(times)} instants, {nodes} nodes at the end: as in the file")
