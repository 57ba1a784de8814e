# Formulas of our pages in the words of doxygen: ```math blocks and $...$. Called by Doxyfile.in.
/^ *```math/ { print "\\f["; inside = 1; next }
inside && /^ *```/ { print "\\f]"; inside = 0; next }
inside { print; next }
/^ *```/ { code = !code }
!code && !/`[^`]*\$/ {
  text = ""
  while (match($0, /\$[^$]+\$/)) {
    text = text substr($0, 1, RSTART - 1) "\\f$" substr($0, RSTART + 1, RLENGTH - 2) "\\f$"
    $0 = substr($0, RSTART + RLENGTH)
  }
  $0 = text $0
}
{ print }
