# SPDX-License-Identifier: GPL-3.0-or-later
# gnuplot -e "table='errors.txt'; svg='harmonic_errors.svg'" harmonic_errors.gp
# Blocks, each followed by two empty lines: "MESH, MAP", then lines "degree, relative root mean square, Hausdorff distance
# over the size".
set terminal svg size 1000,380 dynamic background 'white' font 'sans-serif,13'
set output svg
set logscale xy
set xrange [1:128]
set xlabel 'degree'
set xtics (1, 2, 4, 8, 16, 32, 64, 128)
set format y '%g'
set grid linecolor 'grey80'
set border 3
set tics nomirror
set key bottom left reverse Left samplen 2
stats table using 1 nooutput
set multiplot layout 1,2
set ylabel 'root mean square error / size'
plot for [i=0:STATS_blocks-2] table index i using 1:2 with linespoints linewidth 1.7 pointtype 7-i%2 pointsize 0.7 \
  linecolor i/2+1 title columnheader(1)
set ylabel 'Hausdorff distance / size'
unset key
plot for [i=0:STATS_blocks-2] table index i using 1:3 with linespoints linewidth 1.7 pointtype 7-i%2 pointsize 0.7 \
  linecolor i/2+1
