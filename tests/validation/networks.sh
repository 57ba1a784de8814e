#!/usr/bin/env bash
# The networks, examined (docs/results/validation.md): kinds compared by cross-validation, then the chosen one, and the article's
# procedure beside it, against cases neither has seen. Writes the model, its pages and figures into FOLDER and Markdown to
# the standard output; two minutes of one core.
#   tests/validation/networks.sh FOLDER FEATURES.csv        B: the program
set -euo pipefail
B=${B:-build/release/cli/bitrock}
out=$1
features=$2
mkdir -p "$out"
"$B" train "$features" -o "$out/model.json" --search --jobs 2 --json "$out/train.json" \
  --rock "article rock in grains of 0.5 mm" >&2
"$B" parity "$out/model.json" "$features" --json "$out/parity.json" --report "$out/parity.html" --figures "$out" >&2
"$B" train "$features" -o "$out/article.json" --as-in-the-article --quiet
"$B" parity "$out/article.json" "$features" --json "$out/article_parity.json" --quiet
/usr/bin/python3 - "$out" <<'PY'
import json
import sys

read = lambda name: json.load(open(f"{sys.argv[1]}/{name}.json"))
search, parity, article, model = read("train")["search"], read("parity"), read("article_parity"), read("model")
names = list(search["kinds"][0]["outputs"])
short = lambda name: name.replace("_N_per_m", "").replace("_per_m", "").replace("amax", "A_max").replace("amean", "A_mean")
percent = lambda share: "-" if share is None else f"{100 * share:.1f} %"
number = lambda value: "-" if value is None else f"{value:.3g}"

origin = model["provenance"]
print(f"{len(origin['train_cases'])} cases to learn from, {len(origin['validation_cases'])} to say when to stop, "
      f"{len(origin['test_cases'])} to test.\n")
print(f"### Kinds of network: error on cases left out, in standard errors of the data ({search['folds']} folds)\n")
print("| kind | all | gain | " + " | ".join(map(short, names)) + " |")
print("|---|---|---|" + "---|" * len(names))
for kind in search["kinds"]:
    gain = f"{kind['gain']:.3f} ± {kind['gain_standard_error']:.3f}" if kind["gain_standard_error"] else "-"
    print(f"| {kind['name']} | {kind['error_in_standard_errors']:.3f} | {gain} | "
          + " | ".join(f"{kind['outputs'][name]:.2f}" for name in names) + " |")
print(f"\nChosen: {origin['choice']}.\n")
print("### Cases held out: network against the mean over the cuts\n")
print("| output | standard error of the means | RMS error | in standard errors | 95 % | the article's procedure | "
      "mean deviation | by noise alone | largest | by noise alone | R2 | verdict |")
print("|---|---|---|---|---|---|---|---|---|---|---|---|")
for name in names:
    output, held = parity["outputs"][name], parity["outputs"][name]["held_out"]
    noise = held["noise_alone"] or {"mean": None, "max": None}
    unit = output["unit"]
    interval = f"{number(output['times_noise_low'])} to {number(output['times_noise_high'])}"
    print(f"| {short(name)} | {number(held['dem_standard_error_by_law'])} {unit} | {number(held['rmse'])} {unit} | "
          f"{number(held['rmse_over_standard_error'])} | {interval} | "
          f"{number(article['outputs'][name]['held_out']['rmse_over_standard_error'])} | "
          f"{percent(held['mean_deviation'])} | {percent(noise['mean'])} | {percent(held['max_deviation'])} | "
          f"{percent(noise['max'])} | {number(held['r2'])} | {output['verdict']} |")
PY
