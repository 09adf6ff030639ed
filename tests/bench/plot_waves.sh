#!/usr/bin/env bash
# Draws error against run time of the water: plot_waves.sh OUTPUT_OF_THE_BENCHMARK PICTURE.png
set -euo pipefail
table=$1
picture=$2
# A block of lines for each scene and order, named on its first line.
blocks=$(mktemp)
trap 'rm -f "$blocks"' EXIT
awk -F '\t' 'NF == 6 && $2 ~ /^[12]$/ {
    name = $1 ", order " $2
    if (name != last) { if (last != "") printf "\n\n"; printf "\"%s\"\n", name; last = name }
    print $5, $4
}' "$table" >"$blocks"
gnuplot <<PLOT
set terminal pngcairo size 900,560 font "DejaVu Sans,11"
set output "$picture"
set title "Water: error against run time, 64 to 512 samples a side"
set xlabel "CPU seconds"
set ylabel "relative L1 of depth"
set logscale xy
set format y "10^{%T}"
set key outside right autotitle columnheader
plot for [i=0:5] "$blocks" index i using 1:2 with linespoints linewidth 2 pointtype 7
PLOT
echo "$picture is written"
