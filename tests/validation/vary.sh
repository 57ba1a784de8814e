# Studies that differ from a first one by one sed expression each; to be sourced. Wants B (the program), JOBS, out (a
# folder), rocks (folder of the rock files) and base (the study that is varied); the tables of features go to `rows`.
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
