#!/usr/bin/env bash
# Stamps of the shelf, and erosion directed in an artist's words, as a person clicks them: one press is one stamp however long it is
# held, a control is one act, and a rectangle that is drawn says where water takes. The history says what was done.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/window.sh"

highest_of() { "$talus" info --json "$1" | sed -n 's/.*"height_max": \([-0-9.e+]*\).*/\1/p'; }

open_window --preset blank --set terrain.nx=193 --set terrain.ny=193 --ui-rects rects --window-size 1280x720
await_widget Play
frames 4
click stamp
type_into brush.radius_m 300
click "stamp volcano"
frames 4
xdotool mousemove 600 330
frames 8
xdotool mousedown 1
frames 40
xdotool mouseup 1
frames 8
import -window root 1_volcano.png
save_as volcano.exr
# 232 m at 1 km of width.
highest=$(highest_of volcano.exr)
awk "BEGIN { exit !($highest > 125 && $highest < 145) }" || fail "the volcano is $highest m high"
xdotool mousemove 600 600 key ctrl+z
frames 8

# Another shape, so that a person's own folder is not empty.
mkdir -p config/talus/stamps
"$talus" run --preset slopes --size 65x65 --ticks 0 --out config/talus/stamps/hills.tif 2>/dev/null
sleep 2.5
click "own stamps"
click "own stamp hills.tif"
await_work
click History
await_widget "history 2"
xdotool key Escape

click Erosion
click climate
click "climate=Rainstorm"
click rock
click "rock=Shale"
frames 6
set -- $(rect_of Strength)
drag $((($1 + $3) / 2)) $((($2 + $4) / 2)) $(($3 - 12)) $((($2 + $4) / 2))
frames 6
click "Draw a rectangle"
drag 560 300 640 380
frames 8
import -window root 2_erosion.png
[ -n "$(rect_of "Draw a rectangle")" ] || fail "the rectangle was not drawn"
click History
frames 4
import -window root 3_history.png
# Volcano undone, own stamp; climate, rock, strength and rectangle are an act each.
await_widget "history 6"
[ -z "$(rect_of "history 7")" ] || fail "a control is more than one act"
save_as directed.exr
close_window
echo "passed"
