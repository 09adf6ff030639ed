#!/usr/bin/env bash
# A tick that takes longer than anybody waits: the window answers beside it, what was asked for waits, and undo takes the tick
# back to the bit. It is left by closing the window too.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/window.sh"

"$talus" run --preset slopes --size 64x48 --ticks 4 --set water.rain_mm_per_h=500 --out wet.exr 2>/dev/null
before=$(hash_of wet.exr)
open_window wet.exr --ui-rects rects --window-size 1280x720
await_widget Play
click Simulation
# It is given back with the rest.
type_into time.tick_s 1e7
xdotool mousemove 600 400 key period
frames 20
click Water
await_widget water.manning
type_into water.manning 0.05
await_word "waits for its end"
import -window root waits.png
# What waits is taken back first, then, by the second undo, the run.
xdotool mousemove 600 400 key ctrl+z
await_word "taken back before it was done"
xdotool key ctrl+z
await_word "once more takes the run back"
xdotool key ctrl+z
await_word "the run was taken back"
frames 8
# The tick's length.
xdotool mousemove 600 400 key ctrl+z
frames 8
save_as after.exr
[ "$(hash_of after.exr)" = "$before" ] || fail "what was saved is not what was there before"

# Played under a stroke, many keys, and left.
click Simulation
type_into time.speed 1e6
type_into time.tick_s 1e7
click Play
frames 20
drag 500 400 700 350
before=$(grep -c "waits for its end" window.log)
xdotool mousemove 600 400 key period key period key period
for _ in $(seq 100); do [ "$(grep -c "waits for its end" window.log)" -gt "$before" ] && break; sleep 0.1; done
[ "$(grep -c "waits for its end" window.log)" -gt "$before" ] || fail "no tick goes on"
frames 8
xdotool key ctrl+q
click "Drop the changes"
for _ in $(seq 100); do kill -0 "$pid" 2>/dev/null || break; sleep 0.1; done
kill -0 "$pid" 2>/dev/null && fail "the window did not close"
wait "$pid" || fail "the window ended with an error"
echo "passed"
