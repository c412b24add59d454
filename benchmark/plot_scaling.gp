# SPDX-License-Identifier: GPL-3.0-or-later
# gnuplot -e "csv='FOLDER/scaling.csv'; svg='FOLDER/scaling.svg'" plot_scaling.gp
set terminal svg size 900,800 dynamic background 'white'
set output svg
set datafile separator ','
set key autotitle columnhead outside right
set logscale xy
set xlabel 'vertices'
set format x '10^{%T}'
set grid

backends = system(sprintf("awk -F, '!/^#/ && $4 != \"backend\" && !seen[$4]++ { print $4 }' '%s'", csv))
weights = 'barycentric conformal'
# column n of the rows of one backend and weight
of(n, b, w) = strcol(4) eq b && strcol(3) eq w ? column(n) : NaN

set multiplot layout 3,1
set ylabel 'seconds'
plot for [b in backends] for [w in weights] csv using 2:(of(9, b, w)) with points title b.', '.w
unset logscale y
set yrange [0:*]
set ylabel 'cost in sweeps'
plot for [b in backends] for [w in weights] csv using 2:(of(11, b, w)) with points title b.', '.w
set ylabel 'bytes per vertex'
plot for [b in backends] for [w in weights] csv using 2:(of(12, b, w)) with points title b.', '.w
unset multiplot
