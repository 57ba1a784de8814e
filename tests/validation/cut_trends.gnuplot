# The figure of cut_trends.sh: `data` is the folder of its numbers, `picture` the file, `friction_angle` in degrees.
set terminal pngcairo size 1100,850 font "DejaVu Sans,10"
set output picture
set multiplot layout 2,2 margins 0.07,0.985,0.07,0.96 spacing 0.085,0.11
set grid lc rgb "#dddddd"
set key top left reverse Left samplen 2 spacing 1.1
set style line 1 lc rgb "#1b3a57" pt 7 ps 1 lw 2
set style line 2 lc rgb "#c2571a" lw 2
set style line 3 lc rgb "#888888" lw 2 dt 2
set angles degrees

stats data."/energy_rake.dat" using 4 nooutput
blocks = STATS_blocks
set xlabel "back rake [degrees]"
set ylabel "specific energy / UCS"
set xrange [8:32]
set yrange [0:*]
set palette defined (0 "#9fc5e8", 0.5 "#3d7fb5", 1 "#12263a")
unset colorbox
set key at screen 0.08,0.955 maxrows 2
plot for [b=0:blocks-1] data."/energy_rake.dat" index b using 1:2:3 with yerrorlines pt 7 lw 2 \
  lc palette frac (blocks > 1 ? b / (blocks - 1.0) : 1) title \
  system(sprintf("awk 'BEGIN { RS = \"\"; FS = \" \" } NR == %d { print $4 \" mm\" }' %s/energy_rake.dat", b + 1, data))

set key default
set key top left reverse Left samplen 2 spacing 1.1
psi = real(system("cat ".data."/psi.dat"))
set ylabel "F_y / F_x"
plot data."/ratio.dat" using 1:2 with points pt 7 ps 0.4 lc rgb "#bbbbbb" title "cases", \
  tan(x + psi) with lines ls 2 title sprintf("tan(rake + psi), psi = %.1f degrees", psi), \
  tan(x + friction_angle) with lines ls 3 title sprintf("psi = friction angle %.1f degrees", friction_angle), \
  data."/ratio_mean.dat" using 1:2:3 with yerrorbars ls 1 title "means"

set logscale xy
set xrange [0.4:8]
set yrange [0.1:1]
set xlabel "depth of cut [mm]"
set ylabel "specific energy / UCS"
set xtics (0.5, 1, 2, 3, 4, 5, 6)
set ytics (0.1, 0.15, 0.2, 0.3, 0.5, 0.7, 1)
set key top right noreverse Right
n = real(system("cat ".data."/power.dat"))
d0 = real(system("awk '{ print $1 }' ".data."/size.dat"))
e0 = real(system("awk '{ print $2 }' ".data."/size.dat"))
middle = e0 / sqrt(1 + 2 / d0) * 2 ** n  # the power through the law at 2 mm
plot data."/energy_depth.dat" using 1:2:3 with yerrorbars ls 1 title "means", \
  middle * x ** (-n) with lines ls 2 title sprintf("depth^{-%.2f}", n), \
  e0 / sqrt(1 + x / d0) with lines ls 3 title sprintf("size effect law, d_0 = %.2f mm", d0)

unset logscale y
set xrange [0.08:2.5]
set yrange [0:2]
set xlabel "cutting speed [m/s]"
set ylabel "over the other speeds between 0.5 and 2 m/s"
set xtics (0.1, 0.25, 0.5, 0.75, 1, 1.5, 2)
set ytics auto
plot data."/speed.dat" using 1:2:3 with yerrorbars ls 1 title "mean F_x", \
  data."/speed.dat" using ($1 * 1.03):4:5 with yerrorbars pt 5 lw 2 lc rgb "#c2571a" title "A_{max} x", \
  1 with lines ls 3 notitle
unset multiplot
