#!/usr/bin/env bash
# Which commit a build says it was made from: HEAD at build time, marked where files differ; and what it says in an
# archive, and in a tree inside another repository. Works on a small repository of its own with the house's script.
#   provenance.sh SOURCE [CMAKE]
# Exit status 77: skipped (no git).
set -euo pipefail
source=$1
cmake=${2:-cmake}
command -v git >/dev/null || { echo "skipped: no git"; exit 77; }
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
export GIT_CONFIG_GLOBAL=/dev/null GIT_CONFIG_NOSYSTEM=1
export GIT_AUTHOR_NAME=a GIT_AUTHOR_EMAIL=a@b GIT_COMMITTER_NAME=a GIT_COMMITTER_EMAIL=a@b

failures=0
# Builds nothing: asks the script, as every build does, and compares the text in quotes.
expect() {
  local tree=$1 wanted=$2 why=$3 said
  "$cmake" -DSOURCE="$tree" -DTEMPLATE="$tree/base/version.cpp.in" -DOUTPUT="$scratch/version.cpp" -DVERSION=9.8.7 \
    -P "$tree/cmake/commit.cmake"
  grep -q '"9.8.7"' "$scratch/version.cpp" || { echo "no version"; failures=1; }
  said=$(sed -n 's/.*git_commit = "\(.*\)";/\1/p' "$scratch/version.cpp")
  if [ "$said" != "$wanted" ]; then
    echo "$why: '$said' (wanted is '$wanted')"
    failures=1
  fi
}

tree=$scratch/tree
mkdir -p "$tree/base" "$tree/cmake"
cp "$source/base/version.cpp.in" "$tree/base/"
cp "$source"/cmake/{commit.cmake,archived_commit.txt} "$tree/cmake/"
cp "$source/.gitattributes" "$tree/"
git -C "$tree" init -q
git -C "$tree" add -A
git -C "$tree" commit -q -m first
first=$(git -C "$tree" rev-parse HEAD | cut -c 1-12)
expect "$tree" "$first" "a clean checkout"

before=$(stat -c %y "$scratch/version.cpp")
expect "$tree" "$first" "the same again"
[ "$before" = "$(stat -c %y "$scratch/version.cpp")" ] || { echo "written again without need"; failures=1; }

echo "int changed;" >>"$tree/base/version.cpp.in"
expect "$tree" "$first-dirty" "a changed file"
git -C "$tree" commit -q -a -m second
second=$(git -C "$tree" rev-parse HEAD | cut -c 1-12)
[ "$first" != "$second" ]
expect "$tree" "$second" "HEAD has moved, nothing was configured"
git -C "$tree" tag -a -m "a tag" v1
expect "$tree" "$second" "a tag changes nothing"

mkdir "$scratch/archive"
git -C "$tree" archive HEAD | tar -x -C "$scratch/archive"
expect "$scratch/archive" "$second, from an archive" "an archive by git"

mkdir "$scratch/copy"
cp -r "$tree"/{base,cmake} "$scratch/copy/"
expect "$scratch/copy" "unknown: built from an archive" "a copy without .git"

git -C "$scratch" init -q
git -C "$scratch" add copy/base
git -C "$scratch" commit -q -m "somebody else's"
expect "$scratch/copy" "unknown: built from an archive" "a tree inside another repository"
expect "$scratch/archive" "$second, from an archive" "an archive inside another repository"
exit $failures
