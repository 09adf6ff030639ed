#!/usr/bin/env bash
# Marks stand in the picture: a gauge behind a ridge shows from above, a hill in front hides it, and it shows again. Of a
# ramp's line that a ridge hides, a thin one stays. Screenshots stay in the folder.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/window.sh"

shot() {
    frames 8
    import -window root "$1.png"
}
# Pixels of a colour on a screenshot.
count() { convert "$1.png" -fill black +opaque "$2" -fill white -opaque "$2" -format '%[fx:round(w*h*mean)]' info:; }
yellow='rgb(250,205,60)'
turn() {
    xdotool mousemove 600 "$1"
    frames 4
    xdotool mousedown 3
    for _ in $(seq 10); do
        xdotool mousemove_relative -- 0 "$2"
        frames 3
    done
    xdotool mouseup 3
}

awk 'BEGIN { print "ncols 129\nnrows 129\nxllcorner 0\nyllcorner 0\ncellsize 10"
    for (y = 0; y < 129; y++) { row = ""; for (x = 0; x < 129; x++) row = row (y >= 60 && y <= 64 ? " 150" : " 0"); print row } }' >ridge.asc
open_window ridge.asc --ui-rects rects
frames 8
click Gauges
click "Place a gauge"
# On the flat behind the ridge.
xdotool mousemove 560 195
frames 6
xdotool mousedown 1
frames 4
xdotool mouseup 1
await_widget "remove gauge 1"
shot 1_seen
seen=$(count 1_seen "$yellow")
[ "$seen" -gt 100 ] || fail "the gauge's sign does not show: $seen pixels"

turn 400 -12
shot 2_hidden
hidden=$(count 2_hidden "$yellow")
[ "$hidden" -eq 0 ] || fail "the ridge does not hide the gauge: $hidden pixels"

turn 400 12
shot 3_seen_again
again=$(count 3_seen_again "$yellow")
[ "$again" -gt 100 ] || fail "the gauge's sign does not come back: $again pixels"

click ramp
xdotool mousemove 600 370
frames 6
xdotool mousedown 1
frames 4
xdotool mousemove 610 300
frames 4
xdotool mousemove 600 185
shot 4_ramp
xdotool mouseup 1
frames 4
xdotool key ctrl+z
frames 4
# Of the part before the ridge's face, and of the line's nearer end.
for part in hidden:100x30+550+215 seen:100x60+550+290; do
    convert 4_ramp.png -crop "${part#*:}" +repage "ramp_${part%:*}.png"
    convert 3_seen_again.png -crop "${part#*:}" +repage "before_${part%:*}.png"
done
solid=$(count ramp_seen "$yellow")
[ "$solid" -gt 30 ] || fail "the ramp's line does not show before the ridge: $solid pixels"
behind=$(count ramp_hidden "$yellow")
[ "$behind" -eq 0 ] || fail "the ridge does not hide the ramp's line: $behind pixels"
thin=$(compare -fuzz 12% -metric AE before_hidden.png ramp_hidden.png null: 2>&1 || true)
[ "$thin" -gt 20 ] || fail "behind the ridge nothing of the ramp's line is left: $thin pixels"

# A gauge that was placed is unsaved work.
drop_and_close
echo "the sign has $seen pixels, $hidden behind the ridge, $again once more; the ramp has $solid of its line, of what is behind $thin of the thin one"
