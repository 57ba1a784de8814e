# Tables of features.csv, one a study (the study is the name of the folder), to one markdown table: means over the rows
# with their standard errors, and in brackets how far from the first study, in standard errors of the difference.
# Rows of two studies count as independent, also in the same rock: a cut in other conditions breaks elsewhere.
BEGIN {
  FS = ","
  count = split("x_mean y_mean x_amax x_amean peaks chips", quantity, " ")
  title["x_mean"] = "mean F_x [kN/m]"
  title["y_mean"] = "mean F_y [kN/m]"
  title["x_amax"] = "A_max x [kN/m]"
  title["x_amean"] = "A_mean x [kN/m]"
  title["peaks"] = "peaks x [1/m]"
  title["chips"] = "chips [1/m]"
}

FNR == 1 {
  for (i = 1; i <= NF; ++i) place[$i] = i
  parts = split(FILENAME, path, "/")
  study = path[parts - 1]
  name[++studies] = study
  next
}

function add(what, value) {
  sum[study, what] += value
  squares[study, what] += value * value
}

{
  metres = $place["cut_length_m"]
  ++rows[study]
  add("x_mean", $place["x_mean_N_per_m"] / 1000)
  add("y_mean", $place["y_mean_N_per_m"] / 1000)
  add("x_amax", $place["x_amax_N_per_m"] / 1000)
  add("x_amean", $place["x_amean_N_per_m"] / 1000)
  add("peaks", ($place["x_np1"] + $place["x_np23"] + $place["x_np4"]) / metres)
  add("chips", $place["chips"] / metres)
}

function mean(s, what) { return sum[s, what] / rows[s] }

function standard_error(s, what,    m, variance) {
  m = mean(s, what)
  variance = (squares[s, what] - rows[s] * m * m) / (rows[s] - 1)
  return variance > 0 ? sqrt(variance / rows[s]) : 0
}

# As many decimals as the error deserves.
function shown(value, error,    decimals) {
  decimals = error >= 10 ? 0 : error >= 1 ? 1 : 2
  return sprintf("%.*f ± %.*f", decimals, value, decimals, error)
}

function cell(s, what,    base, error, text) {
  base = name[1]
  text = shown(mean(s, what), standard_error(s, what))
  if (s == base) return text
  error = sqrt(standard_error(s, what) ^ 2 + standard_error(base, what) ^ 2)
  return error > 0 ? text sprintf(" (%+.1f)", (mean(s, what) - mean(base, what)) / error) : text
}

END {
  line = "| study | cuts |"
  rule = "|---|---|"
  for (q = 1; q <= count; ++q) {
    line = line " " title[quantity[q]] " |"
    rule = rule "---|"
  }
  print line
  print rule
  for (k = 1; k <= studies; ++k) {
    s = name[k]
    if (rows[s] < 2) {
      print "cut_sensitivity.awk: " s " has fewer than two cuts" > "/dev/stderr"
      exit 2
    }
    line = "| " s " | " rows[s] " |"
    for (q = 1; q <= count; ++q) line = line " " cell(s, quantity[q]) " |"
    print line
  }
}
