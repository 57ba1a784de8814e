#!/bin/sh
# Fails on an include that crosses a border of the house (docs/architecture.md). Usage: includes.sh ROOT
set -eu
root=$1

# module, then the modules it may include; longer names win (surrogate/net before surrogate)
borders='
base            base
campaigns       campaigns base dem2d peaks
cli             cli base campaigns dem2d peaks report runtime surrogate
dem2d           dem2d base
peaks           peaks base
report          report base
runtime         runtime base peaks surrogate/net
surrogate/export surrogate/export surrogate/net base
surrogate/net   surrogate/net base
surrogate/train surrogate/train surrogate/net base
'

cd "$root"
found=0
for module in $(printf '%s' "$borders" | awk 'NF { print $1 }'); do
  [ -d "$module" ] || continue
  allowed=$(printf '%s' "$borders" | awk -v module="$module" '$1 == module { $1 = ""; print }')
  offences=$(find "$module" \( -name '*.hpp' -o -name '*.cpp' -o -name '*.h' -o -name '*.c' \) -exec grep -Hn '^ *# *include *"' {} + |
    awk -v allowed="$allowed" -v module="$module" '
      BEGIN { count = split(allowed, names, " ") }
      {
        match($0, /"[^"]*"/); path = substr($0, RSTART + 1, RLENGTH - 2)
        good = 0
        for (i = 1; i <= count; ++i) if (index(path, names[i] "/") == 1) good = 1
        if (!good) print $0 "   (" module " may include: " allowed ")"
      }')
  if [ -n "$offences" ]; then
    printf '%s\n' "$offences"
    found=1
  fi
done
exit $found
