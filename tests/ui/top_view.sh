#!/usr/bin/env bash
# The view from the top is a map: T looks straight down and back, equal ways on the screen are equal ways on the ground, on
# hills and in valleys, the wheel keeps what is under the mouse, and the next window of the project looks as this one did.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/window.sh"

place_gauge() {
    click "Place a gauge"
    press_at "$1" "$2"
}
look() { frames 6; import -window root "$1.png"; }
differing() { compare -metric AE "$1.png" "$2.png" null: 2>&1 || true; }

open_window --preset alpine --ui-rects rects --window-size 1280x720 --set render.shadows=false
await_widget Redo
click Gauges
xdotool mousemove 600 300
look 1_before
xdotool key t
look 2_top
[ "$(differing 1_before 2_top)" -gt 100000 ] || fail "T did not change the view"
place_gauge 500 250
place_gauge 600 250
place_gauge 600 400
# Six steps nearer: what is under the mouse stays there, and 100 pixels are fewer metres.
xdotool mousemove 600 400
frames 6
for _ in 1 2 3 4 5 6; do xdotool click 4; frames 2; done
look 3_nearer
place_gauge 600 400
place_gauge 700 400
# The right button shifts the map.
xdotool mousemove 700 400 mousedown 3
frames 4
xdotool mousemove 650 420
frames 4
xdotool mousemove 600 400
frames 4
xdotool mouseup 3
frames 8
place_gauge 600 400
look 4_shifted
xdotool mousemove 600 640
save_as map.exr
/usr/bin/python3 - <<'PY'
import re, sys
told = re.findall(rb'"at_m":\[([-0-9.e]+),([-0-9.e]+)\]', open("map.exr", "rb").read())
places = [(float(x), float(y)) for x, y in told]
print("gauges at", places)
a, b, c, same, d, shifted = places
def near(what, is_m, should_m, within_m):
    if abs(is_m - should_m) > within_m:
        sys.exit(f"{what}: {is_m} m, not {should_m} m")
pixel_m = (b[0] - a[0]) / 100
near("along a row the way north", b[1] - a[1], 0, 0.2 * pixel_m)
near("150 pixels down are 150 pixels", b[1] - c[1], 150 * pixel_m, 0.5 * pixel_m)
near("down a column the way east", c[0] - b[0], 0, 0.2 * pixel_m)
near("the wheel keeps the place east", same[0], c[0], pixel_m)
near("the wheel keeps the place north", same[1], c[1], pixel_m)
near("six steps nearer", (d[0] - same[0]) / 100, pixel_m * 0.85 ** 6, 0.02 * pixel_m)
near("what was shifted lies under the mouse, east", shifted[0], d[0], pixel_m)
near("and north", shifted[1], d[1], pixel_m)
PY
look 5_kept
close_window
open_window map.exr --ui-rects rects --window-size 1280x720
await_widget Redo
click Gauges
xdotool mousemove 600 640
look 6_reopened
[ "$(differing 5_kept 6_reopened)" -lt 20000 ] || fail "the project does not look as it did: $(differing 5_kept 6_reopened) pixels"
xdotool mousemove 600 300 key t
look 7_back
[ "$(differing 6_reopened 7_back)" -gt 100000 ] || fail "T did not go back"
xdotool key f
look 8_whole
xdotool key t f
look 9_whole_from_top
close_window
echo "the view from the top keeps ways, places and its project"
