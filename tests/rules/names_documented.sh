#!/bin/sh
# Fails on a name of a header that has no comment: struct, member, function, enumerator, macro. Headers are those that
# Doxyfile.in names, all installed ones among them. Parameters are not asked for: the comment of a function tells them.
#   names_documented.sh ROOT
# Exit status 77: skipped (no doxygen).
set -eu
command -v doxygen >/dev/null || { echo "skipped: no doxygen"; exit 77; }
cd "$1"
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
{
  sed 's/@VERSION@//; s/@HAVE_DOT@/NO/' Doxyfile.in
  printf 'OUTPUT_DIRECTORY = "%s"\nWARN_LOGFILE = "%s/warnings"\n' "$scratch" "$scratch"
  printf 'GENERATE_HTML = NO\nGENERATE_XML = YES\nXML_PROGRAMLISTING = NO\n'
} | doxygen - >"$scratch/said" 2>&1 || { cat "$scratch/said"; exit 1; }
grep -q 'kind="file" language="C++"' "$scratch"/xml/*.xml || { echo "doxygen has read no header"; exit 1; }

# Doxygen does not warn of enumerators (before 1.10, where it must be asked to).
found=$({
  sed -n "s|^$PWD/||; s/: warning:/:/; /is not documented/p" "$scratch/warnings"
  awk '
    /<memberdef kind="enum"/ { silent = "" }
    /<enumvalue / { inside = 1; name = ""; said = 0 }
    inside && name == "" && /<name>/ { name = $0; gsub(/ *<[^>]*>/, "", name) }
    inside && /<para>/ { said = 1 }
    /<\/enumvalue>/ { inside = 0; if (!said) silent = silent " " name }
    silent != "" && /<location / {
      file = line = $0
      sub(/.* file="/, "", file); sub(/".*/, "", file)
      sub(/.* line="/, "", line); sub(/".*/, "", line)
      count = split(silent, names, " ")
      for (i = 1; i <= count; ++i) print file ":" line ": Enumerator " names[i] " is not documented."
      silent = ""
    }' "$scratch"/xml/*.xml
} | sort -u)
[ -z "$found" ] && exit 0
printf '%s\n' "$found"
echo "say what each is, with its unit: behind it (///<) or above it (///)"
exit 1
