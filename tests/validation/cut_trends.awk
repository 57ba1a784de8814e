# The sums behind tests/validation/cut_trends.sh: rows of features.csv in, markdown tables out; with `plots` set, also the
# data of the figures in that folder.
#
#   E = mean F_x / depth, the specific energy [MPa]; shown over `ucs` [MPa]
#   F_y / F_x = tan(rake + psi), psi: least squares over the cases [DetournayDefourny1992]
#   E = A depth^-n with one n and an A for each speed and rake: least squares of the logarithms over the cases
#   E = E0 / sqrt(1 + depth / d0), likewise with one d0: the size effect law [LinZhou2013]
#
# A case is a speed, depth and rake; its forces are means over seeds. Errors are standard errors.
BEGIN {
  FS = ","
  pi = atan2(0, -1)
}

FNR == 1 {
  split("", place)
  for (i = 1; i <= NF; ++i) place[$i] = i
  needed = split("seed cutter_speed_m_per_s depth_of_cut_mm back_rake_deg cut_length_m x_amax_N_per_m x_mean_N_per_m " \
                 "y_mean_N_per_m chips cracks_tensile cracks_shear hash", names, " ")
  for (i = 1; i <= needed; ++i) if (!(names[i] in place)) refuse(FILENAME ": column " names[i] " is missing")
  next
}

{
  hash = $place["hash"]
  if (hash in seen) next
  seen[hash] = 1
  ++rows
  speed[rows] = $place["cutter_speed_m_per_s"] + 0
  depth[rows] = $place["depth_of_cut_mm"] + 0
  rake[rows] = $place["back_rake_deg"] + 0
  seed[rows] = $place["seed"]
  force_x[rows] = $place["x_mean_N_per_m"] / 1000
  force_y[rows] = $place["y_mean_N_per_m"] / 1000
  largest[rows] = $place["x_amax_N_per_m"] / 1000
  chips[rows] = $place["chips"]
  length_mm[rows] = $place["cut_length_m"] * 1000
  chips_per_mm[rows] = chips[rows] / length_mm[rows]
  cracks_per_mm[rows] = ($place["cracks_tensile"] + $place["cracks_shear"]) / length_mm[rows]
  row_of[speed[rows], depth[rows], rake[rows], seed[rows]] = rows
  energy[rows] = force_x[rows] / depth[rows] / ucs

  key = speed[rows] SUBSEP depth[rows] SUBSEP rake[rows]
  if (!(key in members)) {
    case_key[++cases] = key
    case_speed[cases] = speed[rows]
    case_depth[cases] = depth[rows]
    case_rake[cases] = rake[rows]
  }
  ++members[key]
  case_x[key] += force_x[rows]
  case_y[key] += force_y[rows]
}

function refuse(message) {
  print "cut_trends: " message > "/dev/stderr"
  refused = 1
  exit 2
}

function tan(degrees) { return sin(degrees * pi / 180) / cos(degrees * pi / 180) }

# Distinct values of column[1..n], sorted, into list; returns how many.
function distinct(column, n, list,    i, j, found, value, has) {
  found = 0
  for (i = 1; i <= n; ++i) {
    value = column[i]
    if (value in has) continue
    has[value] = 1
    for (j = ++found; j > 1 && list[j - 1] > value; --j) list[j] = list[j - 1]
    list[j] = value
  }
  return found
}

# A sample grown by `take`, asked by `average` and `error_of`.
function forget(sample) { split("", sample); sample["n"] = sample["sum"] = sample["squares"] = 0 }
function take(sample, value) { ++sample["n"]; sample["sum"] += value; sample["squares"] += value * value }
function average(sample) { return sample["sum"] / sample["n"] }
function error_of(sample,    variance) {
  if (sample["n"] < 2) return 0
  variance = (sample["squares"] - sample["sum"] ^ 2 / sample["n"]) / (sample["n"] - 1)
  return variance > 0 ? sqrt(variance / sample["n"]) : 0
}
function shown(sample, format) {
  if (sample["n"] == 0) return "-"
  if (sample["n"] == 1) return sprintf(format, average(sample))
  return sprintf(format " ± " format, average(sample), error_of(sample))
}

# Probability of `k` or more heads in `n` throws.
function heads(k, n,    i, j, logarithm, sum) {
  for (i = k; i <= n; ++i) {
    logarithm = -n * log(2)
    for (j = 1; j <= i; ++j) logarithm += log((n - i + j) / j)
    sum += exp(logarithm)
  }
  return sum
}

function rule(columns,    line) {
  line = "|"
  while (columns-- > 0) line = line "---|"
  return line
}

# ---- specific energy and rake

function energy_and_rake(    a, b, i, line, sample, file) {
  print "### Specific energy over UCS (" ucs " MPa), by depth and rake\n"
  line = "| depth [mm] |"
  for (b = 1; b <= rakes; ++b) line = line " " rake_list[b] " deg |"
  print line " all |"
  print rule(rakes + 2)
  file = plots "/energy_rake.dat"
  for (a = 1; a <= depths; ++a) {
    if (plots != "" && a > 1) print "\n" > file
    line = "| " depth_list[a] " |"
    for (b = 1; b <= rakes + 1; ++b) {
      forget(sample)
      for (i = 1; i <= rows; ++i) {
        if (depth[i] == depth_list[a] && (b > rakes || rake[i] == rake_list[b])) take(sample, energy[i])
      }
      line = line " " shown(sample, "%.3f") " |"
      if (plots != "" && b <= rakes && sample["n"] > 0) {
        print rake_list[b], average(sample), error_of(sample), depth_list[a] > file
      }
    }
    print line
  }
  slopes_over_rake()
}

# One slope for each speed, depth and seed that has three rakes or more, over the mean of the group.
function slopes_over_rake(    i, key, n, x, y, xx, xy, slope, sample, rising) {
  for (i = 1; i <= rows; ++i) {
    key = speed[i] SUBSEP depth[i] SUBSEP seed[i]
    ++n[key]
    x[key] += rake[i]
    y[key] += energy[i]
    xx[key] += rake[i] ^ 2
    xy[key] += rake[i] * energy[i]
  }
  forget(sample)
  rising = 0
  for (key in n) {
    if (n[key] < 3) continue
    slope = (xy[key] - x[key] * y[key] / n[key]) / (xx[key] - x[key] ^ 2 / n[key])
    take(sample, 1000 * slope / (y[key] / n[key]))
    if (slope > 0) ++rising
  }
  if (sample["n"] == 0) return
  printf "\nSlope over rake: %s %% per 10 degrees; E rises in %d of %d groups of one speed, depth and rock (by chance so " \
         "many or more: %.2g).\n", shown(sample, "%.1f"), rising, sample["n"], heads(rising, sample["n"])
}

# ---- direction of the force

# Cases of one depth, or of all when `only` is empty; returns how many were taken.
function ratios(only,    k) {
  taken = 0
  for (k = 1; k <= cases; ++k) {
    if (only != "" && case_depth[k] != only) continue
    angle[++taken] = case_rake[k]
    ratio[taken] = case_y[case_key[k]] / case_x[case_key[k]]
    inverse_force[taken] = members[case_key[k]] / case_x[case_key[k]]
  }
  return taken
}

# With `has_rubbing` the axial force has a part that does not cut: F_y = tan(rake + psi) F_x + rubbing, the best for psi.
function misfit(psi,    k, sum, products, squares) {
  rubbing = 0
  if (has_rubbing) {
    for (k = 1; k <= taken; ++k) {
      products += (ratio[k] - tan(angle[k] + psi)) * inverse_force[k]
      squares += inverse_force[k] ^ 2
    }
    rubbing = products / squares
  }
  for (k = 1; k <= taken; ++k) sum += (ratio[k] - tan(angle[k] + psi) - rubbing * inverse_force[k]) ^ 2
  return sum
}

# Sets fitted_psi, its error, and r_squared, of the ratios taken.
function fit_psi(    psi, best, k, low, high, third, sum, squares, jacobian) {
  best = -40
  for (psi = -40; psi <= 40; ++psi) if (misfit(psi) < misfit(best)) best = psi
  low = best - 1
  high = best + 1
  while (high - low > 1e-7) {  # by thirds: far below any error
    third = (high - low) / 3
    if (misfit(low + third) < misfit(high - third)) high -= third
    else low += third
  }
  fitted_psi = (low + high) / 2
  for (k = 1; k <= taken; ++k) {
    sum += ratio[k]
    squares += ratio[k] ^ 2
    jacobian += ((1 + tan(angle[k] + fitted_psi) ^ 2) * pi / 180) ^ 2
  }
  psi_error = sqrt(misfit(fitted_psi) / (taken - 1) / jacobian)
  r_squared = 1 - misfit(fitted_psi) / (squares - sum ^ 2 / taken)
}

# Slope of the force's angle over the rake: 1 if one psi holds for all rakes.
function angle_slope(    k, x, y, xx, xy, yy, n, value, left) {
  for (k = 1; k <= taken; ++k) {
    value = atan2(ratio[k], 1) * 180 / pi
    x += angle[k]; y += value; xx += angle[k] ^ 2; xy += angle[k] * value; yy += value ^ 2
  }
  xx -= x * x / taken; xy -= x * y / taken; yy -= y * y / taken
  left = yy - xy * xy / xx
  return sprintf("%.2f ± %.2f", xy / xx, left > 0 ? sqrt(left / (taken - 2) / xx) : 0)
}

function force_direction(    a, b, k, psi, text, sample, local) {
  print "\n### Direction of the force: F_y / F_x = tan(rake + psi)\n"
  ratios("")
  fit_psi()
  psi = fitted_psi
  text = sprintf("One psi for all %d cases: psi = %.2f ± %.2f degrees, R2 = %.3f over cases", taken, psi, psi_error,
                 r_squared)
  text = text sprintf(". The angle of the force grows by %s degrees for each degree of rake (1 by the formula)",
                      angle_slope())
  has_rubbing = 1
  fit_psi()
  text = text sprintf(".\nWith a force that rubs and does not cut, F_y = tan(rake + psi) F_x + f: psi = %.2f degrees, " \
                      "f = %.2f kN/m, R2 = %.3f", fitted_psi, rubbing, r_squared)
  has_rubbing = 0
  print "| rake [deg] | F_y / F_x | tan(rake + psi) | psi of this rake [deg] |\n" rule(4)
  for (b = 1; b <= rakes; ++b) {
    forget(sample)
    forget(local)
    for (k = 1; k <= taken; ++k) {
      if (angle[k] != rake_list[b]) continue
      take(sample, ratio[k])
      take(local, atan2(ratio[k], 1) * 180 / pi - angle[k])
      if (plots != "") print angle[k], ratio[k], case_depth[k] > (plots "/ratio.dat")
    }
    printf "| %s | %s | %.3f | %s |\n", rake_list[b], shown(sample, "%.3f"), tan(rake_list[b] + psi), shown(local, "%.1f")
    if (plots != "") print rake_list[b], average(sample), error_of(sample) > (plots "/ratio_mean.dat")
  }
  print "\n| depth [mm] | psi [deg] | R2 |\n" rule(3)
  for (a = 1; a <= depths; ++a) {
    if (ratios(depth_list[a]) < 3) continue
    fit_psi()
    printf "| %s | %.2f ± %.2f | %.3f |\n", depth_list[a], fitted_psi, psi_error, r_squared
  }
  printf "\n%s. The cutter's friction angle is %.1f degrees.\n", text, friction_angle
  if (plots != "") print psi > (plots "/psi.dat")
}

# ---- specific energy and depth

# Logarithms of depth and energy of the cases, less the mean of their speed and rake. A case whose mean force is not
# positive has none.
function logarithms(    k, group, n, x, y, e) {
  points = groups = skipped = 0
  for (k = 1; k <= cases; ++k) {
    e = case_x[case_key[k]] / members[case_key[k]] / case_depth[k]
    if (e <= 0) { ++skipped; continue }
    group = case_speed[k] SUBSEP case_rake[k]
    if (!(group in n)) ++groups
    ++n[group]
    log_depth[++points] = log(case_depth[k])
    log_energy[points] = log(e)
    group_of[points] = group
    x[group] += log_depth[points]
    y[group] += log_energy[points]
  }
  for (k = 1; k <= points; ++k) {
    level_x[k] = x[group_of[k]] / n[group_of[k]]
    level_y[k] = y[group_of[k]] / n[group_of[k]]
  }
}

# One power: sets power, power_error, sum_of_squares.
function fit_power(    k, x, y, xx, xy, yy) {
  for (k = 1; k <= points; ++k) {
    x = log_depth[k] - level_x[k]
    y = log_energy[k] - level_y[k]
    xx += x * x
    xy += x * y
    yy += y * y
  }
  power = -xy / xx
  sum_of_squares = yy - xy * xy / xx
  if (sum_of_squares < 0) sum_of_squares = 0
  freedom = points - groups - 1
  power_error = freedom > 0 ? sqrt(sum_of_squares / freedom / xx) : 0
}

# Two powers that meet at a depth: sets power_below, power_above, their errors, broken_squares.
function fit_break(at,    k, group, n, z, mean_z, x, u, y, xx, xu, uu, xy, uy, yy, det, bx, bu, s2) {
  for (k = 1; k <= points; ++k) {
    ++n[group_of[k]]
    z[group_of[k]] += log_depth[k] > log(at) ? log_depth[k] - log(at) : 0
  }
  for (k = 1; k <= points; ++k) {
    x = log_depth[k] - level_x[k]
    u = (log_depth[k] > log(at) ? log_depth[k] - log(at) : 0) - z[group_of[k]] / n[group_of[k]]
    y = log_energy[k] - level_y[k]
    xx += x * x; xu += x * u; uu += u * u; xy += x * y; uy += u * y; yy += y * y
  }
  det = xx * uu - xu * xu
  bx = (uu * xy - xu * uy) / det
  bu = (xx * uy - xu * xy) / det
  broken_squares = yy - bx * xy - bu * uy
  if (broken_squares < 0) broken_squares = 0
  s2 = broken_squares / (freedom - 1)
  power_below = -bx
  power_above = -bx - bu
  below_error = sqrt(s2 * uu / det)
  above_error = sqrt(s2 * (uu + xx + 2 * xu) / det)
}

# What the size effect law with this d0 leaves, and in size_level the mean logarithm of its E0.
function size_misfit(d0,    k, group, n, sum, squares, value, left) {
  size_level = 0
  for (k = 1; k <= points; ++k) {
    value = log_energy[k] + 0.5 * log(1 + exp(log_depth[k]) / d0)
    ++n[group_of[k]]
    sum[group_of[k]] += value
    squares += value ^ 2
    size_level += value / points
  }
  for (group in n) squares -= sum[group] ^ 2 / n[group]
  return squares > 0 ? squares : 0
}

# Between a thousandth and a thousandfold of 1 mm, by thirds of the logarithm.
function fit_size_effect(    low, high, third) {
  low = log(0.001)
  high = log(1000)
  while (high - low > 1e-9) {
    third = (high - low) / 3
    if (size_misfit(exp(low + third)) < size_misfit(exp(high - third))) high -= third
    else low += third
  }
  size_squares = size_misfit(exp((low + high) / 2))
  return exp((low + high) / 2)
}

function energy_and_depth(    a, i, k, key, best, best_squares, sample, steps, e1, e2, f, size, file) {
  print "\n### Specific energy over depth: E ~ depth^-n\n"
  print "| depth [mm] | grains | E / UCS | n to the next depth |\n" rule(4)
  file = plots "/energy_depth.dat"
  for (a = 1; a <= depths; ++a) {
    forget(sample)
    for (i = 1; i <= rows; ++i) if (depth[i] == depth_list[a]) take(sample, energy[i])
    forget(steps)
    for (k = 1; k <= cases && a < depths; ++k) {
      if (case_depth[k] != depth_list[a]) continue
      key = case_speed[k] SUBSEP depth_list[a + 1] SUBSEP case_rake[k]
      if (!(key in members)) continue
      e1 = case_x[case_key[k]] / members[case_key[k]] / depth_list[a]
      e2 = case_x[key] / members[key] / depth_list[a + 1]
      if (e1 > 0 && e2 > 0) take(steps, log(e1 / e2) / log(depth_list[a + 1] / depth_list[a]))
    }
    printf "| %s | %.3g | %s | %s |\n", depth_list[a], depth_list[a] / grain, shown(sample, "%.3f"), shown(steps, "%.2f")
    if (plots != "") print depth_list[a], average(sample), error_of(sample) > file
  }
  if (depths < 2) return
  logarithms()
  fit_power()
  printf "\nOne power for all %d cases: n = %.3f ± %.3f.", points, power, power_error
  if (skipped > 0) printf " Left out for a mean force that is not positive: %d.", skipped
  print ""
  if (plots != "") print power > (plots "/power.dat")
  size = fit_size_effect()
  printf "Size effect law E = E0 / sqrt(1 + depth / d0): d0 = %.2f mm, E0 / UCS = %.3f; it leaves %.1f %% from case to case, " \
         "the power %.1f %%.\n", size, exp(size_level) / ucs, 100 * sqrt(size_squares / points),
         100 * sqrt(sum_of_squares / points)
  if (plots != "") print size, exp(size_level) / ucs > (plots "/size.dat")
  if (freedom < 3) return
  for (a = 2; a < depths; ++a) {
    fit_break(depth_list[a])
    if (a > 2 && broken_squares >= best_squares) continue
    best = depth_list[a]
    best_squares = broken_squares
  }
  if (best == "") return
  fit_break(best)
  f = best_squares > 0 ? (sum_of_squares - best_squares) / (best_squares / (freedom - 1)) : 0
  printf "Best break at %s mm: n = %.3f ± %.3f below, %.3f ± %.3f above; F = %.1f with 1 and %d degrees of freedom " \
         "(above 4 in one of twenty by chance; more often, as the best of several breaks was taken).\n", \
         best, power_below, below_error, power_above, above_error, f, freedom - 1
}

# ---- speed

# Logarithm of what a cut gives over the mean of the other speeds between 0.5 and 2 m/s, same depth, rake and seed.
function over_others(v, value, sample,    i, j, key, n, sum) {
  forget(sample)
  for (i = 1; i <= rows; ++i) {
    if (speed[i] != v || value[i] <= 0) continue
    n = sum = 0
    for (j = 1; j <= speeds; ++j) {
      key = speed_list[j] SUBSEP depth[i] SUBSEP rake[i] SUBSEP seed[i]
      if (speed_list[j] == v || speed_list[j] < 0.5 || speed_list[j] > 2 || !(key in row_of)) continue
      if (value[row_of[key]] <= 0) continue
      sum += value[row_of[key]]
      ++n
    }
    if (n > 0) take(sample, log(value[i] / (sum / n)))
  }
}

function as_ratio(sample) {
  if (sample["n"] < 2) return "-"
  return sprintf("%.3f ± %.3f", exp(average(sample)), exp(average(sample)) * error_of(sample))
}

function forces_and_speed(    c, line, x, y, m, h) {
  print "\n### Speed: each cut over the mean of the other speeds between 0.5 and 2 m/s, same depth, rake and rock\n"
  print "| speed [m/s] | cuts | mean F_x | mean F_y | A_max x | chips per length |\n" rule(6)
  for (c = 1; c <= speeds; ++c) {
    over_others(speed_list[c], force_x, x)
    over_others(speed_list[c], force_y, y)
    over_others(speed_list[c], largest, m)
    over_others(speed_list[c], chips_per_mm, h)
    printf "| %s | %d | %s | %s | %s | %s |\n", speed_list[c], x["n"], as_ratio(x), as_ratio(y), as_ratio(m), as_ratio(h)
    if (plots != "" && x["n"] > 1) {
      print speed_list[c], exp(average(x)), exp(average(x)) * error_of(x), exp(average(m)), exp(average(m)) * error_of(m) \
        > (plots "/speed.dat")
    }
  }
}

# Logarithm of what the fastest cuts give over the slowest of the same depth, rake and seed, at one depth.
function fastest_over_slowest(d, value, sample,    i, key) {
  forget(sample)
  for (i = 1; i <= rows; ++i) {
    if (speed[i] != speed_list[speeds] || depth[i] != d) continue
    key = speed_list[1] SUBSEP d SUBSEP rake[i] SUBSEP seed[i]
    if (!(key in row_of) || value[i] <= 0 || value[row_of[key]] <= 0) continue
    take(sample, log(value[i] / value[row_of[key]]))
  }
}

function speed_by_depth(    a, x, y, m, h, c) {
  if (speeds < 2) return
  printf "\n### Speed by depth: cuts at %s m/s over those at %s m/s, same rake and rock\n\n", speed_list[speeds], speed_list[1]
  print "| depth [mm] | pairs | mean F_x | mean F_y | A_max x | chips per length | cracks per length |\n" rule(7)
  for (a = 1; a <= depths; ++a) {
    fastest_over_slowest(depth_list[a], force_x, x)
    fastest_over_slowest(depth_list[a], force_y, y)
    fastest_over_slowest(depth_list[a], largest, m)
    fastest_over_slowest(depth_list[a], chips_per_mm, h)
    fastest_over_slowest(depth_list[a], cracks_per_mm, c)
    printf "| %s | %d | %s | %s | %s | %s | %s |\n", depth_list[a], x["n"], as_ratio(x), as_ratio(y), as_ratio(m),
           as_ratio(h), as_ratio(c)
  }
}

# ---- chips

function chips_of_cuts(    a, i, sample, travel, least, few, n) {
  print "\n### Chips\n"
  print "| depth [mm] | cuts | chips a cut | least | cuts with fewer than 15 | depths of travel a chip |\n" rule(6)
  for (a = 1; a <= depths; ++a) {
    forget(sample)
    forget(travel)
    least = ""
    few = 0
    for (i = 1; i <= rows; ++i) {
      if (depth[i] != depth_list[a]) continue
      take(sample, chips[i])
      if (chips[i] > 0) take(travel, length_mm[i] / chips[i] / depth[i])
      if (least == "" || chips[i] < least) least = chips[i]
      if (chips[i] < 15) ++few
    }
    printf "| %s | %d | %s | %d | %d | %s |\n", depth_list[a], sample["n"], shown(sample, "%.1f"), least, few,
           shown(travel, "%.2f")
  }
}

END {
  if (refused) exit 2
  if (rows < 2) refuse("no rows")
  depths = distinct(depth, rows, depth_list)
  rakes = distinct(rake, rows, rake_list)
  speeds = distinct(speed, rows, speed_list)
  line = ""
  for (c = 1; c <= speeds; ++c) line = line (c > 1 ? ", " : "") speed_list[c]
  printf "%d cuts, %d cases; speeds %s m/s.\n\n", rows, cases, line
  energy_and_rake()
  force_direction()
  energy_and_depth()
  forces_and_speed()
  speed_by_depth()
  chips_of_cuts()
}
