# What the wear flats of tests/validation/edge.sh carry: the forces more than those of the sharp cutter in the same rocks.
# Wants ucs_Pa.
function of(name) { return name ~ /^dry/ ? "dry" : "base" }
function error(name, pairs, squares,  variance) {
  if (pairs < 2) return 0
  variance = (squares - pairs * name * name) / (pairs - 1)
  return sqrt((variance > 0 ? variance : 0) / pairs)
}
BEGIN { FS = "," }
FNR == 1 {
  name = FILENAME; sub(/\/features\.csv$/, "", name); sub(/.*\//, "", name)
  for (i = 1; i <= NF; ++i) at[$i] = i
  if (name ~ /flat/) flats[++count] = name
  next
}
{ seed = $(at["seed"]); x[name, seed] = $(at["x_mean_N_per_m"]); y[name, seed] = $(at["y_mean_N_per_m"]); seeds[seed] = 1 }
END {
  print "\n| wear flat, mm | mean stress on it over UCS | force along it over that into the rock |"
  print "|---|---|---|"
  for (k = 1; k <= count; ++k) {
    name = flats[k]; sharp = of(name); length_mm = name; sub(/.*flat /, "", length_mm)
    pairs = stress = squares = along = into = 0
    for (seed in seeds) {
      ++pairs
      dy = y[name, seed] - y[sharp, seed]
      s = dy / (length_mm * 1e-3) / ucs_Pa
      stress += s; squares += s * s; along += x[name, seed] - x[sharp, seed]; into += dy
    }
    printf "| %s | %.2f +- %.2f | %.2f |\n", name, stress / pairs, error(stress / pairs, pairs, squares), along / into
  }
}
