#!/bin/sh
# Fails on a citation [Key2026] or [Key2026, sec. 3] whose key docs/references.bib does not have, and on one that names a
# section, equation, table, figure or chapter of a source that references.bib calls "not consulted". Usage:
# references.sh ROOT
set -eu
cd "$1"
find . \( -name .git -o -path ./build -o -path ./try -o -path ./demo -o -path ./tests/rules -o -name node_modules \) -prune -o \
  \( -name '*.md' -o -name '*.hpp' -o -name '*.cpp' -o -name '*.h' -o -name '*.toml' -o -name '*.sh' -o -name '*.py' \) -print |
  sort | tr '\n' '\0' | xargs -0 awk '
  BEGIN {
    while ((getline line < "docs/references.bib") > 0) {
      if (match(line, /^@[a-z]+\{[A-Za-z0-9]+/)) { key = substr(line, RSTART, RLENGTH); sub(/.*\{/, "", key); known[key] = 1 }
      if (line !~ /^%/ && line ~ /not consulted/) unread[key] = 1
    }
  }
  FNR == 1 { before = "" }
  {
    text = $0
    sub(/^ *(\/\/\/?|#) ?/, "", text)
    text = before text  # a citation may go over the end of a line
    before = ""
    while (match(text, /\[[A-Z][A-Za-z]+[0-9][0-9][0-9][0-9][^]]*(\]|$)/)) {
      cited = substr(text, RSTART + 1, RLENGTH - 1)
      text = substr(text, RSTART + RLENGTH)
      if (cited !~ /\]$/) { before = "[" cited " "; break }
      sub(/\]$/, "", cited)
      parts = split(cited, part, /[,;] */)
      for (i = 1; i <= parts; ++i) {
        if (part[i] ~ /^[A-Z][A-Za-z]+[0-9][0-9][0-9][0-9]$/) {
          key = part[i]
          if (!(key in known)) { print FILENAME ":" FNR ": [" cited "]   (docs/references.bib has no " key ")"; bad = 1 }
        } else if ((key in unread) && part[i] ~ /^(secs?|eqs?|tables?|figs?|chs?|algorithm|appendix)\.? [0-9A-Z]/) {
          print FILENAME ":" FNR ": [" cited "]   (docs/references.bib calls " key " not consulted: name no place in it)"
          bad = 1
        }
      }
    }
  }
  END { exit bad }
' || exit 1
