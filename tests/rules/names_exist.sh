#!/bin/sh
# Fails where a page or a comment names a file of this repository that is not there. Usage: names_exist.sh ROOT
#
# Looked at: pages (*.md), comments of C++, C, CMake, shell and Python, and comments of the shipped TOML files. A name is
#   - one with an ending of sources, scripts or pages (cpp hpp h sh py md cmake bib): some file must have it, or end in
#     it (`world.hpp`, `step/world.hpp`, `dem2d/step/world.hpp` all name one); with `*` at least one must fit;
#   - one with an ending of data or pictures that begins with a folder of the repository: it must be there;
#   - a decision (`docs/decisions/0008`);
#   - the target of a link of a page, from the folder of the page.
# On pages, code named right behind its file (`step/pairs.hpp` `add_pair`, `drop_pair`) must also stand in that file.
# Names with capitals alone (`R.toml`, `DIR/x.sh`) stand for others.
set -eu
cd "$1"
all=$(mktemp)
trap 'rm -f "$all"' EXIT
find . \( -name .git -o -path ./build -o -path ./try -o -path ./demo -o -name node_modules \) -prune -o -type f -print |
  sed 's|^\./||' | sort >"$all"

grep -E '\.(md|cpp|hpp|h|c|sh|py|cmake|toml|txt)$|^run$|^\.ci/' "$all" | tr '\n' '\0' | xargs -0 awk -v all="$all" '
  BEGIN {
    # of libraries; and what bitrock, the scripts of its tests and the readers of docs/guide write
    split("bit.h cairo.h hwy/highway.h hwy/foreach_target.h array.sh collect.sh summary.md my_rig.py my_table.py rings.py convert.py", other)
    for (i in other) known[other[i]] = 1
    while ((getline path < all) > 0) {
      files[++count] = path
      top = path
      if (sub("/.*", "/", top)) tops[top] = 1
      for (end = path; ; ) {
        known[end] = 1
        if (!match(end, "/")) break
        end = substr(end, RSTART + 1)
      }
      for (folder = path; sub("/[^/]*$", "", folder);) known[folder] = known[folder "/"] = 1
    }
  }
  function fits(name,   i, pattern) {
    if (name ~ /\*/) {
      pattern = name
      gsub(/\./, "\\.", pattern)
      gsub(/\*/, "[^/]*", pattern)
      for (i = 1; i <= count; ++i) if (files[i] ~ ("(^|/)" pattern "$")) return 1
      return 0
    }
    return name in known
  }
  function complain(name) { print FILENAME ":" FNR ": " name "   (there is no such file)"; bad = 1 }
  function normal(path) {
    while (sub("(^|/)[.]/", "/", path) || sub("[^/]+/[.][.](/|$)", "", path)) {}
    sub("^/", "", path)
    return path
  }
  function look(text,   name, top) {
    while (match(text, /[A-Za-z0-9_.\/*$<>{}-]+/)) {
      name = substr(text, RSTART, RLENGTH)
      text = substr(text, RSTART + RLENGTH)
      sub(/[.]+$/, "", name)
      if (name ~ /[$<>{}]/ || name ~ /^[.\/_]*$/ || name ~ /^_/ || name ~ /(^|\/)[A-Z]+[.\/]/) continue
      sub(/^([.][.]?\/)+/, "", name)
      if (name ~ /\// ) { top = name; sub("/.*", "/", top) } else top = ""
      if (top == "build/" || top == "try/" || top == "demo/") continue
      if (name ~ /decisions\/[0-9][0-9][0-9][0-9]$/) { if (!fits(name "*")) complain(name) }
      else if (name ~ /[a-z0-9_*]\.(cpp|hpp|h|sh|py|md|cmake|bib)$/) { if (!fits(name)) complain(name) }
      else if (name ~ /\.(toml|csv|json|png|gif|txt|css|js|h5)$/ && (top in tops) && !fits(name)) complain(name)
    }
  }
  function look_inside(text,   name, file, i, line, all) {
    while (match(text, /`[a-z0-9_\/]+\.(cpp|hpp|h)` `[a-z0-9_]+`(, `[a-z0-9_]+`)*/)) {
      count_inside = split(substr(text, RSTART, RLENGTH), parts, "`")
      text = substr(text, RSTART + RLENGTH)
      all = ""
      for (i = 1; i <= count; ++i) {
        if (("/" files[i]) !~ ("/" parts[2] "$")) continue
        while ((getline line < files[i]) > 0) all = all "\n" line
        close(files[i])
      }
      for (i = 4; i <= count_inside; i += 2) if (all !~ ("[^a-z0-9_]" parts[i] "[^a-z0-9_]")) complain(parts[i] " in " parts[2])
    }
  }
  FILENAME ~ /\.md$/ {
    look($0)
    look_inside($0)
    text = $0
    folder = FILENAME
    if (!sub("[^/]*$", "", folder)) folder = ""
    while (match(text, /\]\([^)]+\)/)) {
      name = substr(text, RSTART + 2, RLENGTH - 3)
      text = substr(text, RSTART + RLENGTH)
      sub("#.*", "", name)
      if (name != "" && name !~ /^[a-z]+:/ && !(normal(folder name) in known)) complain(name)
    }
    next
  }
  FILENAME ~ /\.(cpp|hpp|h|c)$/ { if (match($0, "//.*")) look(substr($0, RSTART)); next }
  match($0, "^ *#.*") || match($0, "  #.*") { look(substr($0, RSTART)) }
  END { exit bad }
' || exit 1
