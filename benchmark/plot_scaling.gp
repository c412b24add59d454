# SPDX-License-Identifier: GPL-3.0-or-later
# gnuplot -e "csv='FOLDER/scaling.csv'; svg='FOLDER/scaling.svg'" plot_scaling.gp
set terminal svg size 1150,370 dynamic background 'white' font 'sans-serif,13'
set output svg
set datafile separator ','
set datafile commentschars '#'
set datafile missing NaN # or lines would be interrupted by the rows of others
set key autotitle columnhead top left reverse Left samplen 2
set logscale x
set xlabel 'vertices'
set format x '10^{%T}'
set grid linecolor 'grey80'
set border 3
set tics nomirror

backends = system(sprintf("awk -F, '!/^#/ && $4 != \"backend\" && !seen[$4]++ { print $4 }' '%s'", csv))
weights = 'barycentric clamped'
# a column, by its name, of the rows of one backend and weight
of(name, b, w) = strcol('backend') eq b && strcol('weights') eq w ? column(name) : NaN
width = 1.7

set multiplot layout 1,3
set logscale y
set format y '%g'
set ylabel 'seconds'
plot for [b in backends] for [w in weights] csv using 'vertices':(of('total s', b, w)) \
  with linespoints linewidth width pointtype 7 pointsize 0.6 title b.', '.w
unset logscale y
unset key
set yrange [0:*]
set ylabel 'cost in sweeps'
plot for [b in backends] for [w in weights] csv using 'vertices':(of('cost in sweeps', b, w)) \
  with linespoints linewidth width pointtype 7 pointsize 0.6
set ylabel 'bytes per vertex'
plot for [b in backends] for [w in weights] csv using 'vertices':(of('bytes per vertex', b, w)) \
  with linespoints linewidth width pointtype 7 pointsize 0.6
unset multiplot
