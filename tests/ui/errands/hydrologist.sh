#!/usr/bin/env bash
# The hydrologist's errand: a DEM, an hour of rain by a hyetograph and an inflow by a hydrograph, roughness from a raster of
# another coordinate system, a gauge, a section, a breach at a time; then the same again without a window, with the same hash,
# an inundation map, rasters each minute and a film. TALUS FOLDER; files and pictures stay in the folder.
set -euo pipefail
source "$(dirname "$(realpath "${BASH_SOURCE[0]}")")/errand.sh"

# A valley of 65 x 65 samples at 30 m with a dam across it, somewhere in Germany.
awk 'BEGIN { print "ncols 65\nnrows 65\nxllcorner 500000\nyllcorner 5600000\ncellsize 30"
    for (y = 0; y < 65; y++) { row = ""
        for (x = 0; x < 65; x++) {
            height = 300 - 0.5 * x + 0.08 * (y - 32) * (y - 32)
            if (x >= 30 && x <= 32 && height < 305) height = 305
            row = row " " height }
        print row } }' >dem.asc
gdal_translate -q -a_srs EPSG:25832 dem.asc dem.tif
# Woods on the slopes, in degrees.
awk 'BEGIN { print "ncols 65\nnrows 65\nxllcorner 500000\nyllcorner 5600000\ncellsize 30"
    for (y = 0; y < 65; y++) { row = ""; for (x = 0; x < 65; x++) row = row " " (y > 24 && y < 40 ? 0.03 : 0.1); print row } }' >n.asc
gdal_translate -q -a_srs EPSG:25832 n.asc n_utm.tif
gdalwarp -q -overwrite -t_srs EPSG:4326 n_utm.tif n.tif
printf 'time_s,rain_mm_per_h\n0,0\n600,20\n1200,80\n1800,40\n3600,0\n' >rain.csv
printf 'time_s,inflow_m3_per_s\n0,0\n900,60\n1800,120\n3600,20\n' >inflow.csv
cat >flood.toml <<'TOML'
title = "Flood"
[time]
tick_s = 5
speed = 600
[water]
manning = 0.04
boundary.west = "inflow"
boundary.east = "open"
inflow_over = "conveyance"
[[event]]
at_s = 2400
breach = { from_m = [900, 960], to_m = [960, 960], width_m = 40, crest_m = 305, bottom_m = 286, over_s = 300 }
TOML

open_window dem.tif --preset flood.toml --ui-rects rects --window-size 1280x720 --journal window.journal
await_widget Play
frames 8
hit Tables
# Before the tables' plots, which push it down.
hit "Choose a raster…"
name_file "$PWD/n.tif"
for pair in water.rain_mm_per_h:rain.csv water.inflow_m3_per_s:inflow.csv; do
    hit "number that follows"
    hit "follow ${pair%%:*}"
    hit "Choose a table…"
    name_file "$PWD/${pair#*:}"
    await_widget "end table of ${pair%%:*}"
done
frames 8
import -window root hydrologist_1_tables.png
hit Gauges
hit "Place a gauge"
press 490 278
await_widget "remove gauge 1"
hit "Draw a section"
clicks=$((clicks + 1))
drag 610 200 690 300
await_widget "remove section 1"
xdotool mousemove 640 12 key space
clicks=$((clicks + 2))
# The status line is no widget: it is played for as long as an hour takes at this speed, and a little more.
sleep 50
xdotool key space
xdotool mousemove 640 690
frames 600
import -window root hydrologist_2_flood.png
hit "Save as gauges.csv"
hit "Save as sections.csv"
xdotool mousemove 640 12 key ctrl+shift+s
name_file "$PWD/flood"
await_word "saved .*flood.exr"
took=$((SECONDS - begin))
close_window
is_there gauges.csv
is_there sections.csv
awk -F, 'NR > 1 { if ($3 > most) most = $3 } END { exit !(most > 0.1) }' gauges.csv || fail "the gauge saw no flood"
"$talus" replay window.journal --report replayed.json 2>/dev/null
[ "$(jq -r .hash replayed.json)" = "$(hash_of flood.exr)" ] || fail "the replay has another hash than the window"
mv gauges.csv gauges_window.csv
mv sections.csv sections_window.csv

# Without a window, from the files: twice, with the same hash.
mkdir -p rasters
run=(run --preset flood.toml --in dem.tif --drive water.rain_mm_per_h=rain.csv --drive water.inflow_m3_per_s=inflow.csv
    --raster manning=n.tif --gauge 600,960 --section 1200,600,1200,1320 --time 3600)
"$talus" "${run[@]}" --every 60 --layer depth --out 'rasters/depth_%03d.tif' --report first.json 2>/dev/null
film=()
command -v ffmpeg >/dev/null && film=(--every 60 --film flood.mp4 --set render.view=depth)
"$talus" "${run[@]}" --out end.exr --report second.json "${film[@]}" 2>/dev/null
[ "$(jq -r .hash first.json)" = "$(jq -r .hash second.json)" ] || fail "two runs differ"
"$talus" convert end.exr inundation.tif --maps depth_max,arrival_s
is_there inundation_depth_max.tif
is_there inundation_arrival_s.tif
[ "$(find rasters -name '*.tif' | wc -l)" = 61 ] || fail "there is not a raster for each minute"
[ ${#film[@]} = 0 ] || is_there flood.mp4
echo "hydrologist: $clicks clicks, $took s in the window"
