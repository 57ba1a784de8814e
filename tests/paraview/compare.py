"""Compares what ParaView saw (JSON) with the run file it was exported from. Ends with status 1 at the first difference."""
import json
import sys

import h5py

run = h5py.File(sys.argv[1], "r")
with open(sys.argv[2]) as file:
    seen = json.load(file)


def check(what, found, expected):
    if found != expected:
        sys.exit(f"{what}: ParaView saw {str(found)[:200]}, the run file holds {str(expected)[:200]}")


def near(what, found, expected, tolerance):
    if len(found) != len(expected) or any(abs(a - b) > tolerance for a, b in zip(found, expected)):
        sys.exit(f"{what}: ParaView saw {str(found)[:200]}, the run file holds {str(expected)[:200]}")


def single(values):
    return [value[0] for value in values]


groups = sorted(name for name in run["frames"] if name != "last") + ["last"]
times = [float(run[f"frames/{group}/time_s"][0]) for group in groups]
for series in ("discs", "joints", "cracks", "cutter"):
    check(f"time steps of {series}", [instant["time"] for instant in seen[series]], times)

for k, group in enumerate(groups):
    frame = run[f"frames/{group}"]
    x, y = frame["x_m"][:].tolist(), frame["y_m"][:].tolist()
    ids = frame["id"][:].tolist()

    discs = seen["discs"][k]
    check("positions", discs["points"], [[a, b, 0.0] for a, b in zip(x, y)])
    check("vertices", discs["cells"], [[i] for i in range(len(x))])
    check("radii", single(discs["point_arrays"]["radius_m"]), frame["radius_m"][:].tolist())
    check("ids", single(discs["point_arrays"]["id"]), ids)
    check("fragments", single(discs["point_arrays"]["fragment"]), frame["fragment"][:].tolist())
    velocity = zip(frame["velocity_x_m_per_s"][:].tolist(), frame["velocity_y_m_per_s"][:].tolist())
    check("velocities", discs["point_arrays"]["velocity_m_per_s"], [[a, b, 0.0] for a, b in velocity])

    joints = seen["joints"][k]
    pairs = zip(frame["joint_disc_1"][:].tolist(), frame["joint_disc_2"][:].tolist())
    check("joints", [[ids[a], ids[b]] for a, b in joints["cells"]], [list(pair) for pair in pairs])

    cracks = seen["cracks"][k]
    so_far = run["cracks/time_s"][:] <= times[k]
    for name in ("time_s", "length_m", "mode"):
        check(f"cracks: {name}", single(cracks["cell_arrays"][name]), run[f"cracks/{name}"][:][so_far].tolist())
    check("ends of cracks", cracks["cells"], [[2 * i, 2 * i + 1] for i in range(int(so_far.sum()))])
    # a crack whose discs have parted stays where it opened
    parted = single(cracks["cell_arrays"]["parted"])
    opened = list(zip(run["cracks/x_m"][:][so_far].tolist(), run["cracks/y_m"][:][so_far].tolist()))
    for i, (first, second) in enumerate(cracks["cells"]):
        if parted[i]:
            middle = [0.5 * (a + b) for a, b in zip(cracks["points"][first], cracks["points"][second])]
            near("a crack that has parted", middle[:2], opened[i], 1e-12)

    cutter = seen["cutter"][k]
    check("corners of the cutter", cutter["cells"], [[0, 1, 2, 3]])
    near("tip of the cutter", cutter["points"][0][:1], frame["tip_x_m"][:].tolist(), 0.0)
    sample = abs(run["force/time_s"][:] - times[k]).argmin()
    for axis in ("x", "y"):
        name = f"{axis}_N_per_m"
        check(f"force {axis}", single(cutter["cell_arrays"][f"force_{name}"]), [float(run[f"force/{name}"][sample])])

if not any(any(single(instant["cell_arrays"]["parted"])) for instant in seen["cracks"]):
    sys.exit("no crack has parted: this cut shows too little")
print(f"{len(groups)} time steps, {len(seen['discs'][-1]['points'])} discs, {len(seen['joints'][-1]['cells'])} joints, "
      f"{len(seen['cracks'][-1]['cells'])} cracks at the end: as in the run file")
