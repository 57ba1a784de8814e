#!/bin/sh
# The rule must catch what it is for: a name of any kind without a comment, in headers of C++ and of C.
# Exit status 77: skipped (no doxygen).
set -eu
command -v doxygen >/dev/null || { echo "skipped: no doxygen"; exit 77; }
rule=$(dirname "$0")/names_documented.sh
root=$(dirname "$0")/../..
house=$(mktemp -d)
trap 'rm -rf "$house"' EXIT
mkdir -p "$house/docs" "$house/base" "$house/runtime"
cp "$root/Doxyfile.in" "$house"
cp "$root"/docs/*.awk "$house/docs"

# Headers in which all has a comment, but for a member ($1) and what follows the struct ($2), when they have none.
cpp() {
  {
    printf '#pragma once\n/// Cuts.\nnamespace bitrock {\n/// One.\nstruct Cut {\n'
    printf '  double depth, rake;  ///< [m], [rad]\n%s\n};\n%s\n}\n' "$1" "$2"
  } >"$house/base/cut.hpp"
}
c() {
  {
    printf '#ifndef CUT_H\n#define CUT_H\n/* Cuts\n * for C. */\n#include <stddef.h>\n/* One. */\ntypedef struct {\n'
    printf '  double depth; /* [m] */\n%s\n} cut;\n%s\n#endif\n' "$1" "$2"
  } >"$house/runtime/cut.h"
}
cpp '  bool deep() const;  ///< above 1 mm' '/// Kinds.
enum class Kind {
  flat,  ///< one
  deep   ///< other
};'
c '' '/* Kinds. */
enum {
  CUT_FLAT = 0, /* one */
  CUT_DEEP = 1  /* other */
};
/* Makes one. */
void make(cut* made);'
"$rule" "$house"

expect_refusal() {
  if said=$("$rule" "$house"); then echo "missed: $1"; exit 1; fi
  case "$said" in
    *"$1"*) ;;
    *) echo "another reason for $1: $said"; exit 1 ;;
  esac
}
cpp '  double speed;' ''
expect_refusal speed
cpp '  bool deep() const;' ''
expect_refusal deep
cpp '' '/// A line above one name.
int counted();
int uncounted();'
expect_refusal uncounted
cpp '' 'struct Bare {  // what the head of the file says is about Cut
  int first;  ///< [1]
};'
expect_refusal Bare
cpp '' '/// Kinds.
enum class Kind {
  flat,  ///< one
  deep
};'
expect_refusal 'Enumerator deep'
cpp '' '#define CUT_MACRO 1'
expect_refusal CUT_MACRO
cpp '' ''
c '  double speed;' ''
expect_refusal speed
c '' 'void make(cut* made);'
expect_refusal make
c '' '/* Kinds. */
enum {
  CUT_FLAT = 0, /* one */
  CUT_DEEP = 1
};'
expect_refusal CUT_DEEP
c '' 'typedef struct {
  double first; /* [m] */
} bare;'
expect_refusal bare
rm "$house/base/cut.hpp" "$house/runtime/cut.h"
expect_refusal 'no header'
