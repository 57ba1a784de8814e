# Studies that differ from a first one by one sed expression each; to be sourced. Wants out (a folder) and base (the study
# that is varied); the tables of features go to `rows`. B: the program, JOBS: cuts at a time.
B=${B:-build/release/cli/bitrock}
JOBS=${JOBS:-$(nproc)}
here=$(dirname "$0")
rocks=$(cd campaigns/rocks && pwd)
mkdir -p "$out/rocks"

vary_the_cut_under_mud() { # SEEDS: e.g. "1, 2, 3" (rocks)
  base=$out/cut_under_mud.toml
  sed "s/^seeds = .*/seeds = [${SEEDS:-1, 2, 3}]/" "$here/cut/mud.toml" >"$base"
}

rows=()
vary() { # name, sed expression; the first call is the study as it is, with the name base
  local name=$1 expression=$2 dir=$out/$1
  sed -e "$expression" -e "s|ROCKS|$rocks|; s|OWN|$(cd "$out/rocks" && pwd)|" "$base" >"$dir.toml"
  if [ "$name" != base ] && cmp -s "$dir.toml" "$out/base.toml"; then
    echo "$(basename "$0"): $name changes nothing (its expression finds nothing in $base)" >&2
    exit 1
  fi
  # a rock made for one study serves all that have the same bed; the program looks whether it is the right one
  mkdir -p "$dir/specimens"
  [ "$name" = base ] || cp -n "$out/base/specimens/"* "$dir/specimens/"
  "$B" campaign run "$dir.toml" --dir "$dir" --jobs "$JOBS" --quiet >&2
  "$B" campaign collect "$dir.toml" --dir "$dir" --quiet >&2
  rows+=("$dir/features.csv")
}
