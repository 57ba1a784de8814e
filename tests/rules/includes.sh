#!/bin/sh
# Fails on an include that crosses a border of the house (docs/architecture.md), between modules and between the folders
# of a module. Usage: includes.sh ROOT
set -eu
root=$1

# A room, then the rooms it may include besides itself. The longest name that fits a file is its room; a room that is
# named stands for all rooms inside it.
borders='
base
bench               base peaks dem2d surrogate report runtime studies views
cli                 base peaks dem2d surrogate report runtime studies views
dem2d/contact       base
dem2d/cut           base dem2d/contact dem2d/fluid dem2d/specimen dem2d/step dem2d/tool
dem2d/fluid         base
dem2d/files         base dem2d/contact dem2d/cut dem2d/fluid dem2d/specimen dem2d/step dem2d/tool
dem2d/lab           base dem2d/contact dem2d/fluid dem2d/specimen dem2d/step dem2d/tool
dem2d/specimen      base dem2d/contact dem2d/step dem2d/tool
dem2d/step          base dem2d/contact dem2d/fluid dem2d/tool
dem2d/tool          base
docs/reference      base cli dem2d runtime studies
peaks               base
python              base peaks dem2d surrogate report runtime studies views
report              base
runtime/bit         base peaks surrogate/net runtime/core runtime/signal
runtime/core        base peaks surrogate/net runtime/laws runtime/signal
runtime/drillstring base peaks surrogate/net runtime/bit runtime/core runtime/laws runtime/signal
runtime/fmu         base surrogate/net runtime/bit runtime/core runtime/drillstring runtime/laws runtime/signal runtime/well
runtime/laws        base
runtime/signal      base peaks
runtime/source      surrogate/export surrogate/net runtime/bit runtime/core
runtime/well        base peaks surrogate/net runtime/bit runtime/core runtime/drillstring runtime/laws runtime/signal
studies             base peaks dem2d surrogate report runtime
surrogate/export    base peaks surrogate/net
surrogate/net       base peaks
surrogate/train     base peaks surrogate/net
views               base peaks dem2d surrogate report runtime studies
'

cd "$root"
set --
for house in $(printf '%s' "$borders" | awk 'NF { split($1, part, "/"); print part[1] }' | sort -u); do
  [ ! -d "$house" ] || set -- "$@" "$house"
done
[ $# -gt 0 ] || exit 0
views=$(find "$@" \( -name '*.hpp' -o -name '*.cpp' \) -exec grep -Hn '^ *# *include *<ranges>' {} +) || true
if [ -n "$views" ]; then
  echo "$views"
  echo "clang 14 does not compile the views of the library of g++ 12, both of Debian 12 (std::span, or a loop)"
  exit 1
fi
find "$@" \( -name '*.hpp' -o -name '*.cpp' -o -name '*.h' -o -name '*.c' \) -exec grep -Hn '^ *# *include *"' {} + |
  awk -v borders="$borders" '
    function inside(path, room) { return index(path, room "/") == 1 }
    BEGIN {
      count = split(borders, lines, "\n")
      for (i = 1; i <= count; ++i) if (split(lines[i], words, " ")) { rooms[words[1]] = lines[i] }
    }
    {
      file = $0; sub(/:.*/, "", file)
      match($0, /"[^"]*"/); path = substr($0, RSTART + 1, RLENGTH - 2)
      room = ""
      for (name in rooms) if (inside(file, name) && length(name) > length(room)) room = name
      good = 0
      if (room != "") {
        n = split(rooms[room], may, " ")
        for (i = 1; i <= n; ++i) if (inside(path, may[i])) good = 1
      }
      if (!good) {
        print $0 "   (" (room == "" ? "a folder that tests/rules/includes.sh does not know" : "may include: " rooms[room]) ")"
        bad = 1
      }
    }
    END { exit bad }'
