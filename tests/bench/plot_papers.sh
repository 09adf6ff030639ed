#!/usr/bin/env bash
# Draws the tables of ./dev bench papers: plot_papers.sh FOLDER_OF_TABLES FOLDER_OF_PICTURES
set -euo pipefail
tables=$1
pictures=$2
mkdir -p "$pictures"
lines=$(mktemp -d)
trap 'rm -rf "$lines"' EXIT
head='set terminal pngcairo size 900,520 font "DejaVu Sans,10"
set key outside right noenhanced
set grid'

# Tables that were not made are left out.
has() { [ -s "$tables/$1.csv" ]; }

# Error against time over the flight, a picture a terrain: methods as points, ammann as a line for each T.
for terrain in high_amplitude mountains spectrogram; do
    has flight && grep -q "^$terrain," "$tables/flight.csv" || continue
    awk -F, -v terrain="$terrain" -v folder="$lines" '
        NR == 1 || $1 != terrain { next }
        $3 ~ /^ammann/ { split($3, word, " "); print $4, $6 > (folder "/T " word[5]); next }
        { print $4, $6 > (folder "/" $3) }' "$tables/flight.csv"
    plots=
    for file in "$lines"/*; do
        name=$(basename "$file")
        style='with points pointtype 7 pointsize 1.4'
        [[ $name == T\ * ]] && { name="ammann, $name, k 0.5 to 2"; style='with linespoints pointtype 6'; }
        plots+="${plots:+, }\"$file\" using 1:2 $style title \"$name\""
    done
    gnuplot <<PLOT
$head
set output "$pictures/flight_$terrain.png"
set title "Flight over $terrain, 480 x 270, llvmpipe: error against time (Ammann et al. 2010, figure 7)" noenhanced
set xlabel "milliseconds of CPU time a frame"
set ylabel "PSNR, dB, against the bilinear surface"
set logscale x
plot $plots
PLOT
    rm -f "$lines"/*
done

# Lines of one column over another for each terrain.
series() { # TABLE X Y [FILTER]
    local terrain plots=
    for terrain in high_amplitude mountains spectrogram; do
        awk -F, -v terrain="$terrain" -v x="$2" -v y="$3" "NR > 1 && \$1 == terrain ${4:-} { print \$x, \$y }" \
            "$tables/$1.csv" >"$lines/$terrain $3"
        plots+="${plots:+, }\"$lines/$terrain $3\" using 1:2 with linespoints pointtype 7 title \"$terrain${5:-}\""
    done
    echo "$plots"
}
has ammann_figure_6 && gnuplot <<PLOT
$head
set output "$pictures/cell_size.png"
set title "ammann: time by the size of cells (Ammann et al. 2010, figure 6), 1024 x 768, llvmpipe"
set xlabel "samples in a row of a cell"
set ylabel "milliseconds of CPU time a frame"
set logscale x 2
set yrange [0:]
plot $(series ammann_figure_6 2 3)
PLOT
has ammann_figure_5 && gnuplot <<PLOT
$head
set output "$pictures/angle.png"
set title "Rays of ammann by the angle of the view (figure 5), 480 x 270"
set xlabel "degrees over the horizon"
set ylabel "PSNR, dB, against the full mesh"
plot $(series ammann_figure_5 2 4 '&& $3 == 1' ', 5 samples, 2 halvings'), $(series ammann_figure_5 2 5 '&& $3 == 1' ', 64 samples, 25 halvings')
PLOT
echo "$pictures is written"
