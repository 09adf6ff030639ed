#!/usr/bin/env bash
# Every method's error against its time over generated mountains of four sizes and the survey's twelve cameras:
# error_against_time.sh TALUS FOLDER writes error_against_time.tsv and .png there.
set -euo pipefail
talus=$1
folder=$2
mkdir -p "$folder"
table=$folder/error_against_time.tsv
printf 'samples\tmethod\ttolerance_px\tcpu_ms\tpsnr_db\tmean_px\tlargest_px\tbeyond_4px\twrong_coverage\tsteps_mean\tsteps_p99\n' >"$table"
for samples in 512 1024 2048 4096; do
    "$talus" compare --preset alpine --samples "${samples}x$samples" --tolerance 0,0.1,0.5,1,2,4 --json 2>/dev/null |
        jq -r --arg n "$samples" '.results[] | [$n, .method, .tolerance_px, .cpu_ms, .psnr_db, .mean_px, .largest_px,
            .beyond_limit, .wrong_coverage, .steps_mean, .steps_p99] | @tsv' >>"$table"
done
gnuplot <<PLOT
set terminal pngcairo size 900,560 font "DejaVu Sans,11"
set output "$folder/error_against_time.png"
set title "Error against time, twelve cameras at 480 x 270 (point size: 512 to 4096 samples a side)"
set xlabel "CPU ms a frame"
set ylabel "mean error in pixels (errors below 1e-6 drawn there)"
set logscale xy
set format y "10^{%T}"
set yrange [5e-7:10]
set key outside right
set datafile separator "\t"
size(n) = log(n) / log(2) / 4 - 1
plot for [m in "exact boxes mesh hybrid"] "$table" using (strcol(2) eq m ? \$4 : 1/0):(\$6 > 1e-6 ? \$6 : 1e-6):(size(\$1)) \
    with points pointtype 7 pointsize variable title m
PLOT
echo "$table and $folder/error_against_time.png are written"
