#!/usr/bin/env bash
# What hands found broken in dialogs and menus, by the same steps: settings of an import are changed, dialogs stay in the
# middle of a window that changes its size, Escape closes menus, a right click unsets, a failed export can be mended, names
# are completed, panels do not overlap in a narrow window, and the start page does not cover a file that was named.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/window.sh"

gone() {
    for _ in $(seq 50); do [ -z "$(rect_of "$1")" ] && return; sleep 0.1; done
    fail "'$1' is still there"
}
# Types over what a field holds.
type_over() {
    click "$1"
    xdotool key ctrl+a type --delay 1 "$2"
    xdotool key Return
    frames 8
}
resize() {
    xdotool search --name 'Talus$' windowsize "$1" "$2"
    frames 8
}
# Whether a widget lies within a window of this width.
within() {
    local name=$1 width=$2
    await_widget "$name"
    set -- $(rect_of "$name")
    [ "$1" -ge 0 ] && [ "$3" -le "$width" ] || fail "'$name' lies at $1 to $3 of $width pixels"
}

"$talus" run --preset slopes --size 97x81 --ticks 0 --out ground.exr --out heights.tif 2>/dev/null
mkdir bin
printf '#!/bin/sh\necho "$@" >"%s/words"\n[ ! -f "%s/chosen" ] || exec cat "%s/chosen"\nexit 1\n' "$PWD" "$PWD" "$PWD" >bin/zenity
chmod +x bin/zenity
PATH=$PWD/bin:$PATH open_window ground.exr --ui-rects rects --window-size 1280x720 --journal window.journal
await_widget Play
frames 2

# The import dialog reads the file again and shows another picture of it.
xdotool mousemove 600 400 key ctrl+o
await_widget "file name"
xdotool key ctrl+a type --delay 1 "$PWD/heights.tif"
xdotool key Return
for spacing in 12.5 80 25; do type_over "import spacing" "$spacing"; done
grep -q "OpenGL reports" window.log && fail "a change of the import's settings broke the picture"
import -window root 1_import.png
# It follows the middle of the window.
resize 900 600
set -- $(rect_of "Open it")
middle=$(rect_of "Cancel import")
[ "$1" -ge 0 ] && [ "$(echo "$middle" | cut -d' ' -f3)" -le 900 ] || fail "the dialog is not in the window"
import -window root 2_small.png
resize 1280 720
click "Open it"
await_work

# The desktop's own dialog, by a program in its place: what is chosen there is opened; closed, nothing is.
xdotool mousemove 600 400 key ctrl+o
click "Desktop's dialog…"
frames 4
[ -n "$(rect_of "file name")" ] || fail "a desktop's dialog in which nothing was chosen did something"
grep -q -- '--file-filter=.*\*\.tif' words || fail "the desktop's dialog was not asked for heightmaps: $(cat words)"
echo "$PWD/heights.tif" >chosen
click "Desktop's dialog…"
await_widget "import spacing"
click "Cancel import"
frames 4

# A name without an ending is completed.
xdotool mousemove 600 400 key ctrl+shift+s
await_widget "file name"
xdotool key ctrl+a type --delay 1 "$PWD/valley"
xdotool key Return
await_word "saved .*valley.exr"
"$talus" info --json valley.exr | grep -q '"dx": 25' || fail "the spacing that was typed is not the terrain's"

# Escape closes menus, and the start page only when no menu is open.
click File
await_widget "Save as…"
click "Start page"
await_widget "Open a file…"
click Edit
await_widget "Start the scene over"
xdotool key Escape
gone "Start the scene over"
[ -n "$(rect_of "Open a file…")" ] || fail "Escape closed the menu and the start page"
xdotool key Escape
gone "Open a file…"

# A right click unsets.
type_into thermal.bedrock_deg 55
set -- $(rect_of thermal.bedrock_deg)
xdotool mousemove $((($1 + $3) / 2)) $((($2 + $4) / 2))
frames 2
xdotool click 3
frames 8

# A number follows the table that is chosen; one that is none is named, with its line.
printf 'time_s,value\n0,90\nsoon,3\n' >storm.csv
click Tables
click "Choose a table…"
type_over "file name" "$PWD/storm.csv"
await_word "storm.csv.: line 3 is 'soon,3'"
printf 'time_s,value\n0,90\n20,700\n60,0\n' >storm.csv
click "Choose a table…"
type_over "file name" "$PWD/storm.csv"
await_work
await_widget "end table of water.rain_mm_per_h"
frames 4
import -window root 3_table.png
click Water
frames 4
import -window root 3_follows.png

# An export that fails says why, and the dialog stays.
xdotool mousemove 600 400 key ctrl+e
type_over "export path" "$PWD/no/such/folder/a.tif"
click Write
frames 8
await_widget Write
import -window root 3_failed_export.png
type_over "export path" "$PWD/mended"
click Write
await_word "wrote .*mended.tif"
gone Write

# Maps are written together, each in its file, and one says what they hold.
xdotool mousemove 600 400 key ctrl+e
await_widget maps
click maps
await_widget "map deposition"
click "map deposition"
click "map curvature"
# Escape closes the list alone.
click as
frames 3
xdotool key Escape
frames 3
await_widget Write
import -window root 3_maps.png
type_over "export path" "$PWD/land.png"
click Write
await_word "wrote .*land_ground.png and 5 more"
gone Write
for map in ground flow wear slope curvature; do
    [ -s "land_$map.png" ] || fail "the map $map was not written"
done
[ ! -e land_deposition.png ] || fail "a map was written that was not chosen"
[ "$(grep -c '"map"' land.json)" = 5 ] || fail "land.json does not say what the maps hold"

# Narrow, everything is in one column beside the picture.
resize 560 600
within Water 560
within Tools 560
[ -z "$(rect_of Play)" ] || fail "the tools lie over the panels"
click Tools
within Play 560
import -window root 4_narrow.png
resize 1280 720
await_widget Play
drop_and_close
grep -q '"name":"water.rain_mm_per_h","op":"drive","rows":\[\[' window.journal || fail "the journal does not hold the table"
grep -q '"name":"thermal.bedrock_deg","op":"set","value":null' window.journal || fail "the right click did not unset"

# Work that an earlier session left is told, and does not cover the file that was named.
open_window ground.exr --ui-rects rects --window-size 1280x720 --set autosave.interval_s=1 --set water.rain_mm_per_h=50
await_widget Play
frames 2
xdotool mousemove 600 400
frames 8
xdotool mousedown 1 sleep 0.6 mouseup 1
for _ in $(seq 100); do ls state/talus/sessions/*/autosave.exr >/dev/null 2>&1 && break; sleep 0.1; done
kill -9 "$pid"
wait "$pid" 2>/dev/null || true
rm -f rects
open_window ground.exr --ui-rects rects --window-size 1280x720
await_widget Play
await_word "ended with unsaved work"
[ -z "$(rect_of Recover)" ] || fail "the start page covers the file that was named"
import -window root 5_left_behind.png
click File
click "Start page"
await_widget Recover
xdotool key Escape
frames 4
close_window
echo "window: dialogs and menus do what was mended"
