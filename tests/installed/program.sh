#!/usr/bin/env bash
# What `cmake --install` gives is enough to work with, from any folder, also when the prefix was moved: the shipped rocks,
# cases and networks are there and found, no folder is empty.
#   program.sh BUILD CMAKE
set -euo pipefail
build=$1
cmake=$2
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
"$cmake" --install "$build" --prefix "$scratch/first" >"$scratch/log"
mv "$scratch/first" "$scratch/moved to"
empty=$(find "$scratch/moved to" -type d -empty)
[ -z "$empty" ] || { echo "empty folders: $empty"; exit 1; }

bitrock="$scratch/moved to/bin/bitrock"
shipped="$scratch/moved to/share/bitrock/campaigns"
for file in paper240/model.json paper240/features.csv paper240/features_mean.csv paper240.toml demo.toml eight.toml \
  bits/pdc15.toml cuts/example.toml drill/normal.toml drill/survey_example.csv rocks/article.toml rocks/targets/article.toml; do
  [ -s "$shipped/$file" ] || { echo "not installed: $file"; exit 1; }
done
[ -s "$scratch/moved to/share/doc/bitrock/docs/reference/formats.md" ] || { echo "not installed: docs/reference/formats.md"; exit 1; }

mkdir "$scratch/work"
cd "$scratch/work"
[ "$("$bitrock" --data-dir)" = "$(dirname "$shipped")" ] || { echo "--data-dir: $("$bitrock" --data-dir)"; exit 1; }
ln -s "$bitrock" here  # a link to the program finds the files, too
model=campaigns/paper240/model.json
bit=campaigns/bits/pdc15.toml
./here predict $model --speed-m-per-s 0.5 --depth-mm 2 --rake-deg 15 --quiet
./here signal $bit --model $model --rpm 120 --rop-m-per-h 15 --duration-s 1 --quiet -o force.csv
for case in normal stick_slip bit_bounce; do
  ./here drill modes campaigns/drill/$case.toml --quiet
done
./here drill run campaigns/drill/normal.toml --quiet -o normal.h5
./here drill map campaigns/drill/stick_slip.toml --check --quiet
./here drill survey campaigns/drill/survey_example.csv --quiet
./here drill compare campaigns/drill/bit_bounce.toml --check --quiet -o compare
./here export c $model --quiet -o model.c
./here export matlab $model --quiet
./here export fmu $model $bit --quiet
./here parity $model campaigns/paper240/features.csv --quiet
./here cut campaigns/cuts/example.toml --check --quiet
./here campaign plan campaigns/paper240.toml --quiet
./here specimen campaigns/rocks/granite.toml --check --quiet
./here calibrate campaigns/rocks/targets/article.toml --check --quiet
./here train campaigns/paper240/features.csv --check --quiet
for file in force.csv normal.h5 model.c bitrock_predict.m bit.fmu; do
  [ -s $file ] || { echo "not written: $file"; exit 1; }
done

# What stands here comes before what is shipped.
mkdir -p campaigns/paper240
echo "no model" >$model
if ./here predict $model --speed-m-per-s 0.5 --depth-mm 2 --rake-deg 15 --quiet 2>message; then
  echo "the file of this folder was passed over"
  exit 1
fi
grep -q "^bitrock: $model" message || { cat message; exit 1; }

# Without its files the program says so.
cp "$bitrock" alone
status=0
./alone --data-dir 2>message || status=$?
[ $status -eq 2 ] && grep -q "no shipped files" message || { cat message; exit 1; }
