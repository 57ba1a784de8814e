#!/usr/bin/env python3
"""Renews the pages of docs/reference that list what the program reads and writes: keys.md, flags.md, columns.md, json.md.

    python3 docs/reference/renew.py BUILD            writes them
    python3 docs/reference/renew.py BUILD --check    compares, and fails where one is not current

BUILD is the build folder, with the targets `bitrock` and `reference_pages`. Keys and flags come from the lists that the program
reads by; columns, arrays and JSON keys from what it writes in small runs of every subcommand.
"""
import csv
import difflib
import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
SHIPPED = HERE.parent.parent / "campaigns"
BY_HAND = "Made by `docs/reference/renew.py` from what the program writes in small runs; do not change it by hand.\n"

SKIP = 77  # of reference_pages on one core

INPUTS = {
    "rock.toml": (SHIPPED / "rocks/article.toml").read_text(encoding="utf-8"),
    "quick_start.toml": (SHIPPED / "rocks/start.toml").read_text(encoding="utf-8")
                        + "\n[specimen]\nwidth_mm = 16\nheight_mm = 32\n",
    "target.toml": '[target]\nname = "small"\nyoungs_modulus_GPa = 1.6\n\n[start]\nrock = "quick_start.toml"\n\n'
                   "[calibration]\nseeds = 1\nscouting_seeds = 1\nmost_evaluations = 4\ntolerance_percent = 20\n",
    "cut.toml": 'rock = "rock.toml"\n\n[cut]\ncutter_speed_m_per_s = 2\ndepth_of_cut_mm = 2\nback_rake_deg = 15\n'
                "cut_length_mm = 4\n\n[bed]\nlength_mm = 20\nheight_mm = 10\n",
    "study.toml": 'rock = "rock.toml"\nseeds = [1]\n\n[grid]\ncutter_speeds_m_per_s = [2]\ndepths_of_cut_mm = [2, 3]\n'
                  "back_rakes_deg = [15]\n\n[cut]\ncut_length_mm = 4\n\n[bed]\nlength_mm = 20\nheight_mm = 10\n",
}
NAMED_BY_DATA = ("outputs",)  # objects whose keys are the names of the networks' outputs

MODEL, BIT, DATA = SHIPPED / "paper240/model.json", SHIPPED / "bits/pdc15.toml", SHIPPED / "paper240/features.csv"

# Subcommand and its arguments; {} is the JSON file. The words in front are what the pages call it.
RUNS = [
    ("specimen", "specimen rock.toml --width-mm 16 --height-mm 16 -o specimen.h5"),
    ("specimen --check", "specimen rock.toml --check"),
    ("lab", "lab ucs quick_start.toml --seeds 1,2 --rate-check -o lab"),
    ("calibrate", "calibrate target.toml -o calibrated.toml --validate-seeds 101"),
    ("calibrate --check", "calibrate target.toml --check -o another.toml"),
    ("cut", "cut cut.toml --frames 2 -o run.h5"),
    ("cut --check", "cut cut.toml --check"),
    ("campaign plan", "campaign plan study.toml"),
    ("campaign run", "campaign run study.toml --dir study"),
    ("campaign status", "campaign status --dir study"),
    ("campaign collect", "campaign collect --dir study"),
    ("campaign submit", "campaign submit --dir study --dry-run"),
    ("peaks", "peaks run.h5 --column x_N_per_m --parts 2"),
    ("train", f"train {DATA} -o model.json --epochs 2 --starts 1"),
    ("predict", f"predict {MODEL} --speed-m-per-s 1 --depth-mm 2 --rake-deg 20 --cut-length-mm 50"),
    ("parity", f"parity {MODEL} {DATA}"),
    ("signal", f"signal {BIT} --model {MODEL} --rpm 120 --rop-m-per-h 15 --duration-s 0.1 --rate-hz 1000 -o signal.csv"),
    ("drill run", f"drill run short.toml --model {MODEL} -o drill.h5"),
    ("drill run --check", f"drill run short.toml --model {MODEL} --check"),
    ("drill modes", "drill modes short.toml"),
    ("drill compare", f"drill compare short.toml --model {MODEL} --seeds 1,2 -o compare"),
    ("drill map", f"drill map short.toml --model {MODEL} --hook-load-kN 25:30:2 --rotation-rpm 60:90:2 -o map.csv"),
    ("snapshot", "snapshot run.h5 -o cut.png"),
    ("export config", "export config run.h5 -o config.toml"),
    ("export vtk", "export vtk run.h5 -o vtk"),
    ("export c", f"export c {MODEL} -o model.c"),
    ("export fmu", f"export fmu {MODEL} {BIT} -o bit.fmu"),
]
TABLES = [("Campaign: features.csv", "study/features.csv"), ("Campaign: features_mean.csv", "study/features_mean.csv"),
          ("Curve of a laboratory test", "lab/ucs_seed_1.csv"), ("Journal of a calibration", "calibrated.toml.journal.csv"),
          ("Force on a bit: signal", "signal.csv"), ("drill compare: summary.csv", "compare/summary.csv"),
          ("drill map", "map.csv")]
FILES = [("specimen.h5", "specimen.h5"), ("run.h5 (with --frames 2)", "run.h5"), ("drill.h5", "drill.h5")]


def short_case():
    """The shipped stick-slip case, one second of it."""
    text = (SHIPPED / "drill/stick_slip.toml").read_text(encoding="utf-8").replace("../", f"{SHIPPED}/")
    return text.replace("duration_s = 30", "duration_s = 1").replace("settling_s = 5", "settling_s = 0.2")


def ran(program, arguments, folder):
    done = subprocess.run([program, *arguments], cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          errors="replace")
    if done.returncode == SKIP:
        print(done.stdout, end="")
        sys.exit(SKIP)
    if done.returncode:
        sys.exit(f"renew.py: {os.path.basename(program)} {' '.join(arguments)} ended with status {done.returncode}:\n{done.stdout}")
    return done.stdout


def leaves(value, path=""):
    """(path, kind) of every value; entries of a list share theirs, and so do objects that are named by data."""
    if isinstance(value, dict):
        for key, inner in value.items():
            yield from leaves(inner, f"{path}.{'NAME' if path in NAMED_BY_DATA else key}" if path else key)
    elif isinstance(value, list):
        if not value:
            yield f"{path}[]", ""
        for inner in value:
            yield from leaves(inner, f"{path}[]")
    else:
        kind = {bool: "true or false", str: "text", type(None): "null"}.get(type(value), "number")
        yield path, kind


def json_section(name, value):
    kinds = {}
    for path, kind in leaves(value):
        kinds.setdefault(path, [])
        if kind and kind not in kinds[path]:
            kinds[path].append(kind)
    rows = [f"| `{path}` | {', '.join(sorted(kinds[path]))} |" for path in sorted(kinds)]
    return f"\n## bitrock {name}\n\n| key | value |\n|---|---|\n" + "\n".join(rows) + "\n"


def pages(build):
    """name -> text"""
    program, lists = str(build / "cli/bitrock"), str(build / "docs/reference/reference_pages")
    made = {"keys.md": ran(lists, ["keys"], "."), "flags.md": ran(lists, ["flags"], ".")}
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for file, text in {**INPUTS, "short.toml": short_case()}.items():
            (folder / file).write_text(text, encoding="utf-8")
        results = "# JSON keys\n\n" + BY_HAND + (
            "`--json FILE` writes them. *null*: the run had no value there; *NAME*: an\n"
            "output of the networks, such as `x_amax_N_per_m`; `[]`: a list. What they mean: [formats.md](formats.md).\n")
        for words, command in RUNS:
            ran(program, [*command.split(), "--quiet", "--json", "result.json"], folder)
            results += json_section(words, json.loads((folder / "result.json").read_text(encoding="utf-8")))
        made["json.md"] = results
        columns = "# Columns of tables, arrays of files\n\n" + BY_HAND + (
            "Names end in their unit. What they mean: [formats.md](formats.md).\n\n# Tables (CSV)\n")
        for words, file in TABLES:
            with open(folder / file, encoding="utf-8") as table:
                names = next(row for row in csv.reader(table) if row and not row[0].startswith("#"))
            columns += f"\n## {words}\n\n" + ", ".join(f"`{column}`" for column in names) + "\n"
        columns += "\n# Files (HDF5)\n"
        for words, file in FILES:
            lines = [line.split(" ", 1) for line in ran(lists, ["arrays", file], folder).splitlines()]
            for kind, title in (("array", "arrays"), ("attribute", "attributes")):
                names = ", ".join(f"`{where}`" for what, where in lines if what == kind)
                columns += f"\n## {words}: {title}\n\n{names}\n"
        made["columns.md"] = columns
    return made


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    stale = []
    for name, text in pages(Path(sys.argv[1]).resolve()).items():
        page = HERE / name
        kept = page.read_text(encoding="utf-8") if page.exists() else ""
        if kept == text:
            continue
        if "--check" in sys.argv:
            stale.append("".join(difflib.unified_diff(kept.splitlines(True), text.splitlines(True), f"docs/reference/{name}",
                                                      "what the program says", n=0)))
        else:
            page.write_text(text, encoding="utf-8")
            print(f"docs/reference/{name}")
    if stale:
        sys.exit("\n".join(stale) + f"\nrenew them:  python3 docs/reference/renew.py {sys.argv[1]}")


main()
