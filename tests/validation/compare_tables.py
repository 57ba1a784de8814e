#!/usr/bin/python3
"""Two tables of the same cuts, case by case: python3 tests/validation/compare_tables.py OLD.csv NEW.csv [CASES.csv]

OLD and NEW are features.csv of one study by two engines or two definitions. Cuts of the same speed, depth, rake and seed are pairs.
Prints, for each depth, the mean of new over old and its standard error over the pairs, and how often a case (mean over its seeds)
lies farther apart than twice the standard error of both. CASES.csv gets a row a case.
"""
import collections
import csv
import math
import statistics
import sys

KEYS = ("cutter_speed_m_per_s", "depth_of_cut_mm", "back_rake_deg", "seed")
COLUMNS = ("x_mean_N_per_m", "y_mean_N_per_m", "x_amax_N_per_m", "y_amax_N_per_m", "x_amean_N_per_m", "y_amean_N_per_m",
           "x_np1", "x_np23", "x_np4", "cracks_tensile")


def table(path):
    with open(path, newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    return {tuple(float(row[key]) for key in KEYS): {column: float(row[column]) for column in COLUMNS} for row in rows}


def error(values):
    return statistics.stdev(values) / math.sqrt(len(values)) if len(values) > 1 else math.nan


def case_rows(pairs):
    """For each case and column: old, new, difference over the standard error of both."""
    cases = collections.defaultdict(list)
    for key, pair in pairs.items():
        cases[key[:3]].append(pair)
    for case, list_of_pairs in sorted(cases.items()):
        for column in COLUMNS:
            old, new = ([pair[side][column] for pair in list_of_pairs] for side in (0, 1))
            scatter = math.hypot(error(old), error(new))
            off = (statistics.mean(new) - statistics.mean(old)) / scatter if scatter > 0.0 else math.nan
            yield (*case, column, len(old), statistics.mean(old), statistics.mean(new), off)


def main(old_path, new_path, cases_path=None):
    old, new = table(old_path), table(new_path)
    pairs = {key: (old[key], new[key]) for key in old.keys() & new.keys()}
    if not pairs:
        sys.exit("the tables have no cut in common")
    rows = list(case_rows(pairs))
    print(f"{len(pairs)} cuts of {len(old)} and {len(new)} are in both.\n")
    print("| depth [mm] | cuts | " + " | ".join(COLUMNS) + " | cases beyond 2 s.e. [%] |")
    print("|---" * (len(COLUMNS) + 3) + "|")
    for depth in sorted({key[1] for key in pairs}):
        cells = []
        for column in COLUMNS:
            ratios = [b[column] / a[column] for key, (a, b) in pairs.items() if key[1] == depth and a[column] > 0.0]
            cells.append(f"{statistics.mean(ratios):.3f} ± {error(ratios):.3f}" if ratios else "-")
        known = [abs(row[-1]) > 2.0 for row in rows if row[1] == depth and row[3] in COLUMNS[:4] and not math.isnan(row[-1])]
        beyond = f"{100.0 * sum(known) / len(known):.0f}" if known else "-"
        count = sum(key[1] == depth for key in pairs)
        print(f"| {depth:g} | {count} | " + " | ".join(cells) + f" | {beyond} |")
    print("\nNew over old: mean and standard error over the cuts. Last column: of the means and highest forces of the cases; with three "
          "cuts a case chance gives some 12 %.")
    if cases_path:
        with open(cases_path, "w", newline="", encoding="utf-8") as file:
            writer = csv.writer(file)
            writer.writerow((*KEYS[:3], "column", "seeds", "old", "new", "difference_over_standard_error"))
            writer.writerows(rows)


if __name__ == "__main__":
    if len(sys.argv) not in (3, 4):
        sys.exit(__doc__)
    main(*sys.argv[1:])
