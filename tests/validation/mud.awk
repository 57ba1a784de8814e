# Table of tests/validation/mud.sh: one row a variant, mean over its cuts and standard error. Wants ucs_Pa; base_name: of
# the cut that is varied.
function add(name, value) { sum[name] += value; squares[name] += value * value }
function largest(name, value) { value = value < 0 ? -value : value; if (value > most[name]) most[name] = value }
function mean(name) { return sum[name] / n }
function error(name,  variance) {
  if (n < 2) return 0
  variance = (squares[name] - n * mean(name) ^ 2) / (n - 1)
  return sqrt((variance > 0 ? variance : 0) / n)
}
function both(name, format) { return sprintf(format " +- " format, mean(name), error(name)) }
function row(  name) {
  if (n == 0) return
  name = file; sub(/\/features\.csv$/, "", name); sub(/.*\//, "", name)
  if (name == "base") name = base_name
  printf "| %s | %d | %s | %s | %s | %s | %.1f | %.0f | %.2f | %.2f |\n", name, n, both("e", "%.2f"), both("ratio", "%.2f"),
    both("cv", "%.2f"), both("top", "%.1f"), 100 * mean("low"), mean("cracks"), 100 * most["residual"], 100 * most["injected"]
  n = 0; split("", sum); split("", squares); split("", most)
}
BEGIN {
  FS = ","
  if (base_name == "") base_name = "**20 MPa, sealed, 2 mm, 20 deg, 1 m/s, damping 0.1**"
  print "| varied | rocks | E/UCS | F_y/F_x | CV of F_x | A_max/mean | way below a tenth of the mean, % | cracks a mm | residual, most, % | injected, most, % |"
  print "|---|---|---|---|---|---|---|---|---|---|"
}
FNR == 1 { row(); file = FILENAME; for (i = 1; i <= NF; ++i) at[$i] = i; next }
{
  ++n
  x = $(at["x_mean_N_per_m"])
  add("e", x / ($(at["depth_of_cut_mm"]) * 1e-3) / ucs_Pa)
  add("ratio", $(at["y_mean_N_per_m"]) / x)
  add("cv", $(at["x_sd_N_per_m"]) / x)
  add("top", $(at["x_amax_N_per_m"]) / x)
  add("low", $(at["x_low_force_share"]))
  add("cracks", ($(at["cracks_tensile"]) + $(at["cracks_shear"])) / ($(at["cut_length_m"]) * 1e3))
  largest("residual", $(at["energy_residual_fraction"]))
  largest("injected", $(at["energy_injected_fraction"]))
}
END { row() }
