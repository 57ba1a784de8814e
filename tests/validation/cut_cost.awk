# Tables of features.csv, one a study (the study is the name of the folder), to one markdown table: what a study changes
# against the first. Of each condition (speed, depth, rake) that both have, the difference of the mean logarithms; of
# these the mean over conditions, as a percentage, with its standard error from the scatter of cuts within conditions
# (pooled over both studies), and in brackets the difference over its error. `core`: time on a core, over the first's.
BEGIN {
  FS = ","
  count = split("x_mean y_mean x_amax x_amean peaks chips", quantity, " ")
  split("mean F_x,mean F_y,A_max x,A_mean x,peaks x,chips", title, ",")
}

FNR == 1 {
  for (i = 1; i <= NF; ++i) place[$i] = i
  parts = split(FILENAME, path, "/")
  name[++studies] = path[parts - 1]
  next
}

function add(c, what, value) {
  value = log(value)
  sum[studies, c, what] += value
  squares[studies, c, what] += value * value
}

{
  c = $place["cutter_speed_m_per_s"] "/" $place["depth_of_cut_mm"] "/" $place["back_rake_deg"]
  if (!rows[studies, c]++ && studies == 1) conditions[++known] = c
  ++cuts[studies]
  metres = $place["cut_length_m"]
  add(c, "x_mean", $place["x_mean_N_per_m"])
  add(c, "y_mean", $place["y_mean_N_per_m"])
  add(c, "x_amax", $place["x_amax_N_per_m"])
  add(c, "x_amean", $place["x_amean_N_per_m"])
  add(c, "peaks", ($place["x_np1"] + $place["x_np23"] + $place["x_np4"]) / metres)
  add(c, "chips", ($place["chips"] > 0 ? $place["chips"] : 0.5) / metres)
  core[studies, c] += $place["core_s"]
  lost = $place["energy_residual_fraction"]
  if (lost < 0) lost = -lost
  if (lost > residual[studies]) residual[studies] = lost
}

function within(s, c, what) {  # sum of squares about the mean of the condition
  return squares[s, c, what] - sum[s, c, what] ^ 2 / rows[s, c]
}

function cell(s, what,    k, c, n, difference, scatter, freedom, inverse, error, text) {
  for (k = 1; k <= known; ++k) {
    c = conditions[k]
    if (!rows[s, c]) continue
    ++n
    difference += sum[s, c, what] / rows[s, c] - sum[1, c, what] / rows[1, c]
    scatter += within(s, c, what) + within(1, c, what)
    freedom += rows[s, c] + rows[1, c] - 2
    inverse += 1 / rows[s, c] + 1 / rows[1, c]
  }
  difference /= n
  error = sqrt(scatter / freedom * inverse) / n
  text = sprintf("%+.1f ± %.1f %%", 100 * difference, 100 * error)
  return error > 0 ? text sprintf(" (%+.1f)", difference / error) : text
}

function core_ratio(s,    k, c, mine, first) {
  for (k = 1; k <= known; ++k) {
    c = conditions[k]
    if (!rows[s, c]) continue
    mine += core[s, c] / rows[s, c]
    first += core[1, c] / rows[1, c]
  }
  return mine / first
}

END {
  line = "| study | cuts | core | residual |"
  rule = "|---|---|---|---|"
  for (q = 1; q <= count; ++q) {
    line = line " " title[q] " |"
    rule = rule "---|"
  }
  print line
  print rule
  for (s = 1; s <= studies; ++s) {
    line = sprintf("| %s | %d | %.2f | %.3f %% |", name[s], cuts[s], core_ratio(s), 100 * residual[s])
    for (q = 1; q <= count; ++q) line = line " " (s == 1 ? "" : cell(s, quantity[q])) " |"
    print line
  }
}
