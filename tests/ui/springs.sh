#!/usr/bin/env bash
# A spring is placed by a click, dragged by its sign, given another rate by typing, gives water, and is undone; so is a gauge
# dragged. A stroke that crosses a sign moves nothing.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/window.sh"

# Pixels of a colour on the screen.
count() { import -window root "$1.png"; convert "$1.png" -fill black +opaque "$2" -fill white -opaque "$2" -format '%[fx:round(w*h*mean)]' info:; }
blue='rgb(90,190,255)'
yellow='rgb(250,205,60)'
# Where the sign of that colour stands: its mean column and row.
middle() { import -window root sign.png; convert sign.png -crop 670x650+260+25 -fill black +opaque "$1" -fill white -opaque "$1" txt:- | awk -F'[,:]' '/white|#FFFFFF|\(255\)|gray\(255\)/ {x += $1; y += $2; n++} END {print 260 + int(x / n), 25 + int(y / n)}'; }

"$talus" run --preset alpine --set thermal.on=false --ticks 0 --out start.exr 2>/dev/null
open_window start.exr --ui-rects rects
await_word "begun with hash"
begun=$(sed -n 's/.*begun with hash //p' window.log | head -n 1)
frames 8
click Water
click "Place a spring"
press_at 600 380
await_widget "remove spring 1"
[ "$(count 1_placed "$blue")" -gt 100 ] || fail "the spring has no sign"
read -r x y < <(middle "$blue")
drag "$x" "$y" $((x - 60)) $((y + 20))
frames 8
read -r to_x to_y < <(middle "$blue")
[ "$to_x" -lt $((x - 40)) ] && [ "$to_y" -gt "$y" ] || fail "the sign was dragged from $x,$y and stands at $to_x,$to_y"
# The foot stays under the mouse as far as it was when the sign was taken.
[ $((to_x - x + 60)) -ge -4 ] && [ $((to_x - x + 60)) -le 4 ] || fail "dragged by 60 pixels to the left it went from $x to $to_x"
# A stroke of the brush over the sign is a stroke.
drag $((to_x - 60)) $((to_y + 30)) $((to_x + 60)) $((to_y - 30))
frames 8
xdotool mousemove 600 640 key ctrl+z
frames 8
read -r same_x same_y < <(middle "$blue")
[ "$same_x" -eq "$to_x" ] && [ "$same_y" -eq "$to_y" ] || fail "a stroke over the sign moved it from $to_x,$to_y to $same_x,$same_y"
# A click into a number is enough to type another one.
click "spring 1 rate"
xdotool key ctrl+a type 4000
xdotool key Return
frames 6
xdotool mousemove 600 640
play 4
save_as flooded.exr
deepest=$(depth flooded.exr)
awk "BEGIN { exit !($deepest > 0.05) }" || fail "the spring gives no water: at most $deepest m"

click Gauges
click "Place a gauge"
press_at 640 330
await_widget "remove gauge 1"
frames 20
[ "$(count 3_gauge "$yellow")" -gt 100 ] || fail "the gauge has no sign"
read -r x y < <(middle "$yellow")
drag "$x" "$y" $((x + 50)) $((y + 10))
frames 20
read -r to_x to_y < <(middle "$yellow")
[ "$to_x" -gt $((x + 30)) ] || fail "the gauge was dragged from $x,$y and stands at $to_x,$to_y"

# Nothing of this was a stroke: what is undone is the run, the rate, the move and the spring.
xdotool mousemove 600 640
for _ in 1 2 3 4; do
    xdotool key ctrl+z
    frames 4
done
save_as undone.exr
[ "$(hash_of undone.exr)" = "$begun" ] || fail "four times undone the terrain is not what it was: $begun, now $(hash_of undone.exr)"
close_window
echo "a spring was placed, dragged, set to a rate and undone; it gave water $deepest m deep"
