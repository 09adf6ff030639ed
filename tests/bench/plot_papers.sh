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

# PSNR against time over the flight, a picture a terrain: methods as points, ammann as a line for each T.
for terrain in high_amplitude mountains_1024 mountains spectrogram coast; do
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
set title "Flight over $terrain, 480 x 270, llvmpipe: PSNR against time (Ammann et al. 2010, figure 7)" noenhanced
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
    for terrain in high_amplitude mountains_1024 mountains spectrogram coast; do
        grep -q "^$terrain," "$tables/$1.csv" || continue
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
has ammann_figure_4_map && gnuplot <<PLOT
set terminal pngcairo size 900,560 font "DejaVu Sans,10"
set output "$pictures/low_precision.png"
set title "5 samples and 2 halvings a cell over the spectrogram, 480 x 270 (figure 4): distance from the full mesh's"
set datafile separator ","
set logscale cb
set cbrange [0.001:10]
set cblabel "percent of the terrain's length (grey: sky in either)"
set palette defined (0 "#0d0887", 1 "#7e03a8", 2 "#cc4778", 3 "#f89540", 4 "#f0f921")
set object 1 rectangle from graph 0,0 to graph 1,1 behind fillcolor rgb "#999999"
set size ratio -1
unset tics
set cbtics
plot "$tables/ammann_figure_4_map.csv" every ::1 using 1:2:(\$3 < 0 ? NaN : \$3 < 0.001 ? 0.001 : \$3) with image notitle
PLOT
# Pictures side by side, with their names: montages OUT.jpg PREFIX SCALE COLUMNS NAME...
montages() {
    local out=$1 prefix=$2 scale=$3 columns=$4 name parts=()
    shift 4
    for name in "$@"; do
        [ -s "$tables/$prefix $name.ppm" ] && parts+=(-label "$name" "$tables/$prefix $name.ppm")
    done
    [ ${#parts[@]} -eq 0 ] || montage -font DejaVu-Sans -pointsize 14 "${parts[@]}" -filter point -resize "$scale" \
        -tile "${columns}x" -geometry +4+4 -quality 90 "$pictures/$out"
}
montages excerpts.jpg ammann_figure_9 200% 3 mesh 'ammann k 1 T 100' 'ammann k 1.5 T 100' hybrid 'clipmap n 511' 'clipmap n 127'
montages mesh_and_rays.jpg jeong_han_pictures 100% 2 mesh uniform
montages steps.jpg park_oh_figure_13 100% 2 'mountains fly' 'mountains walk'
echo "$pictures is written"
