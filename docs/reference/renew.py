#!/usr/bin/env python3
"""Renews the pages of docs/reference that list what the program reads and writes: keys.md, flags.md, columns.md, json.md.

    python3 docs/reference/renew.py BUILD            writes them
    python3 docs/reference/renew.py BUILD --check    compares, and fails where one is not current

BUILD is the build folder, with the targets `bitrock` and `reference_pages`. Keys and flags come from the lists that the program
reads by; columns, arrays and JSON keys from what it writes in small runs of every subcommand. What arrays mean stands in the
files; what all else means, in meanings.toml.
"""
import csv
import difflib
import json
import os
import subprocess
import sys
import tempfile
import tomllib
from pathlib import Path

HERE = Path(__file__).resolve().parent
SHIPPED = HERE.parent.parent / "campaigns"
BY_HAND = "Made by `docs/reference/renew.py` from what the program writes in small runs; do not change it by hand.\n"

SKIP = 77  # of reference_pages on one core, and here of a program that was built without a part
WITHOUT = ("built without the plot library", "built without ONNX")

INPUTS = {
    "rock.toml": (SHIPPED / "rocks/article.toml").read_text(encoding="utf-8"),
    "quick_start.toml": (SHIPPED / "rocks/start.toml").read_text(encoding="utf-8")
                        + "\n[specimen]\nwidth_mm = 16\nheight_mm = 32\n",
    "target.toml": '[target]\nname = "small"\nyoungs_modulus_GPa = 1.6\n\n[start]\nrock = "quick_start.toml"\n\n'
                   "[calibration]\nseeds = 1\nscouting_seeds = 1\nmost_evaluations = 4\ntolerance_percent = 20\n",
    "cut.toml": 'rock = "rock.toml"\n\n[cut]\ncutter_speed_m_per_s = 2\ndepth_of_cut_mm = 2\nback_rake_deg = 15\n'
                "cut_length_mm = 4\n\n[bed]\nlength_mm = 20\nheight_mm = 10\n\n[fluid]\npressure_MPa = 5\n",
    "study.toml": 'rock = "rock.toml"\nseeds = [1]\n\n[grid]\ncutter_speeds_m_per_s = [2]\ndepths_of_cut_mm = [2, 3]\n'
                  "back_rakes_deg = [15]\n\n[cut]\ncut_length_mm = 4\n\n[bed]\nlength_mm = 20\nheight_mm = 10\n",
    "loads.csv": "bit_depth_m,run_in_hook_load_kN\n1230,530\n",
}
NAMED_BY_DATA = ("outputs", "search.kinds[].outputs")  # objects whose keys are the names of the networks' outputs

MODEL, BIT, DATA = SHIPPED / "paper240/model.json", SHIPPED / "bits/pdc15.toml", SHIPPED / "paper240/features.csv"

# Subcommand and its arguments; {} is the JSON file. The words in front are what the pages call it.
RUNS = [
    ("specimen", "specimen rock.toml --width-mm 16 --height-mm 16 -o specimen.h5"),
    ("specimen --check", "specimen rock.toml --check"),
    ("lab --check", "lab ucs quick_start.toml --check"),
    ("lab", "lab ucs quick_start.toml --seeds 1,2 --rate-check -o lab"),
    ("lab triaxial", "lab triaxial quick_start.toml --seeds 1,2 --confining-pressures-MPa 0,5"),
    ("lab toughness", "lab toughness quick_start.toml --seeds 1,2 --notch-lengths-mm 4,8"),
    ("calibrate", "calibrate target.toml -o calibrated.toml --validate-seeds 101"),
    ("calibrate --check", "calibrate target.toml --check -o another.toml"),
    ("cut", "cut cut.toml --frames 2 -o run.h5"),
    ("cut --check", "cut cut.toml --check"),
    ("campaign plan", "campaign plan study.toml"),
    ("campaign run", "campaign run study.toml --dir study"),
    ("campaign status", "campaign status --dir study"),
    ("campaign collect", "campaign collect --dir study"),
    ("campaign features", "campaign features study/forces.h5 -o features.csv"),
    ("campaign submit", "campaign submit --dir study --dry-run"),
    ("peaks", "peaks run.h5 --column x_N_per_m --parts 2"),
    ("train", "train pressures.csv -o pressures.json --epochs 2 --starts 1"),
    ("hold", "hold pressures.json fluid_pressure_MPa=10 -o held.json"),
    ("train --search", f"train {DATA} -o model.json --epochs 2 --starts 1 --search --folds 2"),
    ("train --check", f"train {DATA} -o model.json --check"),
    ("learn", "learn rock.toml study.toml -o learnt --batch 8 --hours 0.001"),
    ("predict", f"predict {MODEL} --speed-m-per-s 1 --depth-mm 2 --rake-deg 20 --cut-length-mm 50"),
    ("parity", f"parity {MODEL} {DATA}"),
    ("rebuild", "rebuild study/forces.h5 --draws 2"),
    ("signal", f"signal {BIT} --model {MODEL} --rpm 120 --rop-m-per-h 15 --duration-s 0.1 --rate-hz 1000 -o signal.csv"),
    ("drill run", f"drill run fed.toml --model {MODEL} -o drill.h5"),
    ("drill run --check", f"drill run short.toml --model {MODEL} --check"),
    ("drill run in a well", "drill run well.toml -o well.h5"),
    ("drill run in a well --check", "drill run well.toml --check"),
    ("drill statics", "drill statics well.toml"),
    ("drill fatigue", "drill fatigue well.h5"),
    ("drill modes", "drill modes short.toml"),
    ("drill modes in a well", "drill modes well.toml"),
    ("drill compare", f"drill compare short.toml --model {MODEL} --seeds 1,2 -o compare"),
    ("drill compare in a well", "drill compare well.toml --seeds 1 -o compare_well"),
    ("drill compare --check", f"drill compare short.toml --model {MODEL} --check"),
    ("drill survey", f"drill survey {SHIPPED}/drill/survey_example.csv --bit-depth-m 1700"),
    ("drill broomstick", f"drill broomstick {SHIPPED}/drill/deviated.toml --depths-m 1230 --frictions 0.25 --measured loads.csv"),
    ("drill broomstick --check", f"drill broomstick {SHIPPED}/drill/deviated.toml --check"),
    ("drill map", f"drill map short.toml --model {MODEL} --hook-load-kN 25:30:2 --rotation-rpm 60:90:2 -o map.csv"),
    ("report", "report study -o report.html"),
    ("snapshot", "snapshot run.h5 -o cut.png"),
    ("animate", "animate run.h5 -o frames"),
    ("export config", "export config run.h5 -o config.toml"),
    ("export vtk", "export vtk run.h5 -o vtk"),
    ("export vtk of a well", "export vtk well.h5 -o vtk_well"),
    ("export c", f"export c {MODEL} -o model.c"),
    ("export matlab", f"export matlab {MODEL} -o model.m"),
    ("export onnx", f"export onnx {MODEL} -o model.onnx"),
    ("export bit", f"export bit {MODEL} {BIT} -o bit.h"),
    ("export fmu", f"export fmu {MODEL} {BIT} -o bit.fmu"),
]
TABLES = [("Campaign: features.csv", "study/features.csv"), ("Campaign: features_mean.csv", "study/features_mean.csv"),
          ("Curve of a laboratory test", "lab/ucs_seed_1.csv"), ("Journal of a calibration", "calibrated.toml.journal.csv"),
          ("Force on a bit: signal", "signal.csv"), ("drill compare: summary.csv", "compare/summary.csv"),
          ("drill compare in a well: summary.csv", "compare_well/summary.csv"),
          ("drill broomstick", "broomstick.csv"), ("drill map", "map.csv")]
FILES = [("specimen.h5", "specimen.h5"), ("forces.h5", "study/forces.h5"), ("run.h5 (with --frames 2)", "run.h5"), ("drill.h5", "drill.h5"),
         ("well.h5", "well.h5")]


def short_case():
    """The shipped stick-slip case, one second of it."""
    text = (SHIPPED / "drill/stick_slip.toml").read_text(encoding="utf-8").replace("../", f"{SHIPPED}/")
    return text.replace("duration_s = 30", "duration_s = 1").replace("settling_s = 5", "settling_s = 0.2")


def fed_case():
    """The same below a block that an autodriller lowers."""
    hoist = 'hoist = "autodriller"\nline_stiffness_N_per_m = 8e6\nweight_on_bit_kN = 24.9'
    return short_case().replace("hook_load_kN = 15", hoist)


def short_well():
    """The shipped string in a deviated well, the beginning of its trip."""
    text = (SHIPPED / "drill/deviated.toml").read_text(encoding="utf-8").replace("../", f"{SHIPPED}/")
    text = text.replace('top = "split"', 'top = "split"\nevery_joint = true')
    text = text.replace("rotation_rpm = 60", 'rotation_rpm = 60\ncontrol = "soft_torque"')
    return text.replace("duration_s = 350", "duration_s = 1").replace("settling_s = 325", "settling_s = 0.2")


def under_pressures():
    """The shipped table as if every other case had been cut under mud."""
    header, *rows = DATA.read_text(encoding="utf-8").splitlines()
    return "\n".join([f"fluid_pressure_MPa,{header}"] + [f"{20 * (int(row.split(',')[0]) % 2)},{row}" for row in rows]) + "\n"


def ran(program, arguments, folder):
    done = subprocess.run([program, *arguments], cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          errors="replace")
    if done.returncode == SKIP or any(words in done.stdout for words in WITHOUT):
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


UNITS = {"N_m_s_per_rad": "N m s/rad", "rad_per_s": "rad/s", "m_per_s": "m/s", "m_per_h": "m/h", "N_per_m": "N/m", "N_m": "N m",
         "per_s": "1/s", "Pa": "Pa", "Hz": "Hz", "rpm": "rpm", "kN": "kN", "N": "N", "mm": "mm", "ms": "ms", "m": "m", "s": "s",
         "deg": "deg", "rad": "rad", "percent": "%"}
SPREAD = ("mean", "sd", "min", "max")  # of what the object around them names
STANDARD_ERROR = "_standard_error"  # at the end of the names of columns


class Meanings:
    """What meanings.toml says; it knows what has not been asked for."""

    def __init__(self):
        self.sections = tomllib.loads((HERE / "meanings.toml").read_text(encoding="utf-8"))
        self.unused = {(section, name) for section, names in self.sections.items() for name in names}
        self.missing = []

    def find(self, result, name):
        """The text of the section that fits best; None where there is none."""
        fitting = sorted((section for section in self.sections if result.startswith(section)), key=len, reverse=True)
        for section in [*fitting, "everywhere"]:
            if name in self.sections[section]:
                self.unused.discard((section, name))
                return self.sections[section][name]
        return None

    def of(self, result, path):
        """(unit, meaning); the unit is empty for texts."""
        parts = path.replace("[]", "").split(".")
        if parts[-1].endswith(STANDARD_ERROR) and result.startswith("Campaign"):
            unit, meaning = self.of(result, path.removesuffix(STANDARD_ERROR))
            return unit, f"standard error of the mean over the seeds: {meaning}"
        for first in range(len(parts)):
            text = self.find(result, ".".join(parts[first:]))
            if text is not None:
                break
        else:
            self.missing.append(f"{result}: {path}")
            return "", ""
        around = []
        end = first
        while end > 0:  # what the objects around it say, the innermost first
            fits = (begin for begin in range(end) if self.find(result, ".".join(parts[begin:end]) + ".") is not None)
            begin = next(fits, None)
            if begin is None:
                self.missing.append(f"{result}: {'.'.join(parts[:end])}.")
                break
            around.append(self.find(result, ".".join(parts[begin:end]) + "."))
            end = begin
        named = parts[-2] if parts[-1] in SPREAD and first > 0 else parts[-1]
        unit = next((UNITS[end] for end in UNITS if named.endswith("_" + end)), "1")
        said = []
        for words in [text, *filter(None, around)]:
            if words.startswith("["):
                unit, words = words[1:].split("] ", 1)
            said.append(words)
        return "" if unit == "text" else unit, "; ".join(said)

    def complain(self):
        wrong = [f"docs/reference/meanings.toml: no meaning of {name}" for name in self.missing]
        wrong += [f"docs/reference/meanings.toml: [{section}] {name} is the name of nothing" for section, name in sorted(self.unused)]
        if wrong:
            sys.exit("\n".join(wrong))


def json_section(name, value, meanings):
    kinds = {}
    for path, kind in leaves(value):
        kinds.setdefault(path, [])
        if kind and kind not in kinds[path]:
            kinds[path].append(kind)
    text = f"\n## bitrock {name}\n\n| key | value | unit | meaning |\n|---|---|---|---|\n"
    for path in sorted(kinds):
        unit, meaning = meanings.of(name, path)
        countable = not kinds[path] or {"number", "null"} & set(kinds[path])
        text += f"| `{path}` | {', '.join(sorted(kinds[path]))} | {unit if countable else ''} | {meaning} |\n"
    return text


def table(title, rows):
    return f"\n## {title}\n\n| name | unit | meaning |\n|---|---|---|\n" + "".join(
        f"| `{name}` | {unit} | {meaning} |\n" for name, unit, meaning in rows)


def pages(build):
    """name -> text"""
    program, lists = str(build / "cli/bitrock"), str(build / "docs/reference/reference_pages")
    meanings = Meanings()
    made = {"keys.md": ran(lists, ["keys"], "."), "flags.md": ran(lists, ["flags"], ".")}
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for file, text in {**INPUTS, "short.toml": short_case(), "fed.toml": fed_case(), "well.toml": short_well(),
                           "pressures.csv": under_pressures()}.items():
            (folder / file).write_text(text, encoding="utf-8")
        results = "# JSON keys\n\n" + BY_HAND + (
            "`--json FILE` writes them. *null*: the run had no value there; *NAME*: an\n"
            "output of the networks, such as `x_amax_N_per_m`; `[]`: a list. More: [formats.md](formats.md).\n")
        for words, command in RUNS:
            ran(program, [*command.split(), "--quiet", "--json", "result.json"], folder)
            results += json_section(words, json.loads((folder / "result.json").read_text(encoding="utf-8")), meanings)
        made["json.md"] = results
        columns = "# Columns of tables, arrays of files\n\n" + BY_HAND + "More: [formats.md](formats.md).\n\n# Tables (CSV)\n"
        for words, file in TABLES:
            with open(folder / file, encoding="utf-8") as lines:
                names = next(row for row in csv.reader(lines) if row and not row[0].startswith("#"))
            columns += table(words, [(column, *meanings.of(words, column)) for column in names])
        columns += "\n# Files (HDF5)\n"
        for words, file in FILES:
            found = json.loads(ran(lists, ["arrays", file], folder))
            columns += table(f"{words}: arrays", [(array["name"], array["unit"], array["meaning"]) for array in found["arrays"]])
            columns += table(f"{words}: attributes", [(known, *meanings.of(words, known)) for known in found["attributes"]])
        made["columns.md"] = columns
    meanings.complain()
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
