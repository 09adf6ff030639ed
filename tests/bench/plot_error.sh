#!/usr/bin/env bash
# Draws error against run time: plot_error.sh OUTPUT_OF_A_BENCHMARK PICTURE.png TITLE
# Its table has columns scene, a setting, n, error, run_time_s, substeps, under a line of their names.
set -euo pipefail
table=$1
picture=$2
title=$3
# A block of lines for each scene and setting, named on its first line.
blocks=$(mktemp)
trap 'rm -f "$blocks"' EXIT
awk -F '\t' 'NF == 6 && $1 == "scene" { setting = $2; next }
NF == 6 {
    name = $1 ", " setting " " $2
    if (name != last) { if (last != "") printf "\n\n"; printf "\"%s\"\n", name; last = name }
    print $5, $4
}' "$table" >"$blocks"
count=$(grep -c '^"' "$blocks")
gnuplot <<PLOT
set terminal pngcairo size 900,560 font "DejaVu Sans,11"
set output "$picture"
set title "$title"
set xlabel "seconds"
set ylabel "relative L1"
set logscale xy
set format y "10^{%T}"
set key outside right autotitle columnheader noenhanced
plot for [i=0:$((count - 1))] "$blocks" index i using 1:2 with linespoints linewidth 2 pointtype 7
PLOT
echo "$picture is written"
