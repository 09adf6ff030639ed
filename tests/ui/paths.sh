#!/usr/bin/env bash
# Paths in a real window: a road is drawn by clicks, a point of it is moved, its grade is shown, it is built, undone to the bit
# and redone; a raster of roughness is taken; a section is drawn, counted while it rains, and its table saved.
# Screenshots stay in the folder.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/window.sh"

shot() {
    frames 8
    import -window root "$1.png"
}
press() { # X Y: a press that a frame sees, and its end
    xdotool mousemove "$1" "$2"
    frames 6
    xdotool mousedown 1
    frames 4
    xdotool mouseup 1
    frames 4
}

awk 'BEGIN { print "ncols 129\nnrows 129\nxllcorner 0\nyllcorner 0\ncellsize 10"
    for (y = 0; y < 129; y++) { row = ""; for (x = 0; x < 129; x++) row = row " " 100 + 0.4 * x + 15 * sin(x / 9) * sin(y / 7); print row } }' >hills.asc
awk 'BEGIN { print "ncols 129\nnrows 129\nxllcorner 0\nyllcorner 0\ncellsize 10"
    for (y = 0; y < 129; y++) { row = ""; for (x = 0; x < 129; x++) row = row " 0.08"; print row } }' >n.asc
open_window hills.asc --ui-rects rects --window-size 1280x720
frames 8
xdotool mousemove 600 400 key ctrl+shift+s
await_widget "file name"
frames 2
xdotool key ctrl+a type --delay 1 "$PWD/saved.exr"
xdotool key Return
await_word "saved .*saved.exr"
cp saved.exr before.exr

click Paths
type_into path.width_m 30
click "Draw it"
press 480 390
press 560 330
press 640 350
press 720 300
await_widget "path of 4 points"
shot 1_drawn
# A point is moved, and none is put.
drag 640 350 660 250
await_widget "path of 4 points"
shot 2_moved
sed -n 's/.* path no steeper than \([0-9.]*\) %$/\1/p' rects >grade
awk '{ exit !($1 > 0 && $1 <= 8.01) }' grade || fail "the grade that is shown is not at most 8 %: $(cat grade)"
save draft.exr
[ "$(hash_of draft.exr)" = "$(hash_of before.exr)" ] || fail "drawing a path changed the ground"
xdotool mousemove 600 600
frames 4
xdotool key BackSpace
await_widget "path of 3 points"
press 730 290
await_widget "path of 4 points"
click "Build it"
await_work
shot 3_built
save road.exr
[ "$(hash_of road.exr)" != "$(hash_of before.exr)" ] || fail "the road was not built"
xdotool mousemove 600 600 key ctrl+z
frames 6
save undone.exr
[ "$(hash_of undone.exr)" = "$(hash_of before.exr)" ] || fail "undo of the road is not the ground to the bit"
xdotool mousemove 600 600 key ctrl+shift+z
frames 6
save redone.exr
[ "$(hash_of redone.exr)" = "$(hash_of road.exr)" ] || fail "the road did not come back"
# Who takes a tool of the brush sculpts, and puts no points.
click raise
drag 440 300 480 300
save raised.exr
[ "$(hash_of raised.exr)" != "$(hash_of road.exr)" ] || fail "the brush did nothing while a path was being drawn"
xdotool mousemove 600 600 key ctrl+z
frames 6

click Tables
click "Choose a raster…"
await_widget "file name"
frames 2
xdotool key ctrl+a type --delay 1 "$PWD/n.asc"
xdotool key Return
await_work
frames 6
save rough.exr
"$talus" run --in rough.exr --ticks 0 --layer manning --out n.tif 2>/dev/null
highest=$("$talus" info --json n.tif | sed -n 's/.*"height_max": \([0-9.]*\).*/\1/p')
case $highest in 0.08* | 0.0799*) ;; *) fail "the raster is not in the terrain: $highest" ;; esac

click Gauges
click "Draw a section"
drag 480 230 560 370
await_widget "remove section 1"
click Simulation
type_into time.tick_s 1
type_into time.speed 60
click Water
type_into water.rain_mm_per_h 2000
xdotool mousemove 600 600
play 4
click Gauges
shot 4_section
click "Save as sections.csv"
frames 6
[ "$(head -n 1 sections.csv)" = "time_s,discharge_1_m3_per_s,volume_1_m3" ] || fail "the table has another heading"
[ "$(wc -l <sections.csv)" -ge 4 ] || fail "the section has few rows"
tail -n 1 sections.csv | awk -F, '{ exit !($3 > 1 || $3 < -1) }' || fail "no water passed the section: $(tail -n 1 sections.csv)"
save end.exr
close_window
echo "a road was drawn, moved, built, undone and redone; $(($(wc -l <sections.csv) - 1)) rows of a section"
