# Headers for Doxygen. It gives a comment to one name only; here the comment behind a declaration belongs to all of its names,
# and one written for C (/* ... */ or // ...) counts too:
#     double width, height;  ///< of the box [m]   ->   double width; /**< of the box [m] */ double height; /**< of the box [m] */
# Units in a list, one for each name, go each to its own. A comment above a declaration of several names counts for each of them.
# In headers of C the same holds of comments above a declaration and behind an enumerator. Lines keep their numbers.
#
# The comment at the head of a header is about the file, and its first sentence is also about the first struct, class or enum
# when that has no comment of its own: a file is about one thing.

# The names of a declaration, between commas that are in no bracket.
function split_names(text, names,    i, c, depth, count, part) {
  count = depth = 0
  part = ""
  for (i = 1; i <= length(text); ++i) {
    c = substr(text, i, 1)
    if (c ~ /[<({[]/) ++depth
    if (c ~ /[>)}\]]/) --depth
    if (c == "," && depth == 0) {
      names[++count] = part
      part = ""
    } else {
      part = part c
    }
  }
  names[++count] = part
  return count
}

# What is said of name number i of count: its own unit, or all of it.
function said(comment, i, count,    units) {
  return comment ~ /^\[[^\]]*\](, \[[^\]]*\])+$/ && split(comment, units, ", ") == count ? units[i] : comment
}

# Headers of C. A comment above #if is about the choice, not about what is declared next.
/^#define [A-Z_]+_H$/ { in_c = 1; print "/** @file"; getline; sub(/^\/\*/, " *"); print; next }
in_c && /^\/\*/ {
  block = $0
  while (block !~ /\*\/$/ && getline > 0) block = block "\n" $0
  if ((getline following) > 0 && following !~ /^#if/) sub(/^\/\*/, "/**", block)
  print block
  $0 = following
}
in_c && /^  [A-Z_0-9]+ = [0-9]+,? +\/\* / { sub(/\/\*/, "/**<") }

/^#pragma once/ { in_head = 1; print "/// @file"; next }
in_head && !/^\/\/\// { in_head = 0; sub(/\.  *[A-Z`*\[].*/, ".", above); head = above }
head != "" && /^(struct|class|enum) [^;]*\{/ {
  print (above == "" ? "/**" head " */ " : "") $0
  head = above = ""
  next
}

/^ *\/\/\/[^<]/ || /^ *\/\/\/$/ {
  text = $0
  sub(/^ *\/\/\/ ?/, "", text)
  above = above " " text
  print
  next
}

/^ *[A-Za-z_][A-Za-z0-9_:<>, *&]* [*&]?[A-Za-z_][A-Za-z0-9_]*(\[[0-9a-z_]+\])?( = [^;]*|\{[^;]*\}|, [^;()]*)?; *(\/\/|\/\*|$)/ &&
!/^ *(using|return|friend|typedef|template|namespace|struct|class|enum|delete|throw|if|for|else|case|extern) / {
  at = index($0, ";")
  declaration = substr($0, 1, at - 1)
  comment = substr($0, at + 1)
  open = ""
  if (comment ~ /^ *\/\/\/</) sub(/^ *\/\/\/< ?/, "", comment)
  else if (comment ~ /^ *\/\/ /) sub(/^ *\/\/ /, "", comment)
  else if (comment ~ /^ *\/\* .*\*\/ *$/) { sub(/^ *\/\* /, "", comment); sub(/ *\*\/ *$/, "", comment) }
  else if (comment ~ /^ *\/\* /) { sub(/^ *\/\* /, "", comment); open = "yes" }
  else comment = ""
  if (comment == "") comment = above
  above = ""
  count = split_names(declaration, names)
  if (comment == "" || comment ~ /NOLINT/) { print; next }
  first = names[1]
  type = first
  sub(/ = .*/, "", type)
  sub(/\{.*/, "", type)
  sub(/(\[[^\]]*\])?$/, "", type)
  sub(/[A-Za-z_][A-Za-z0-9_]*$/, "", type)
  line = first "; /**< " said(comment, 1, count) (open == "" || count > 1 ? " */" : "")
  for (i = 2; i <= count; ++i) {
    name = names[i]
    sub(/^ */, "", name)
    stem = type
    sub(/^ */, "", stem)
    line = line " " stem name "; /**< " said(comment, i, count) (open == "" || i < count ? " */" : "")
  }
  print line
  next
}

/^template </ { print; next }  # a comment above it is about what follows

{ above = ""; print }
