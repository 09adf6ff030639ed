#!/usr/bin/env bash
# An event is added, given its time and value, happens while the water runs, and is undone; a breach is drawn over a dam, and
# nonsense is refused.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/window.sh"

"$talus" run --preset dam-break --set thermal.on=false --ticks 0 --out start.exr 2>/dev/null
open_window start.exr --ui-rects rects --window-size 1280x720 --set time.speed=20
await_word "begun with hash"
begun=$(sed -n 's/.*begun with hash //p' window.log | head -n 1)
await_widget Redo
click Tables
click "what an event sets"
click "event of water.rain_mm_per_h"
click "Add an event"
await_widget "remove event 1"
type_into "event 1 at" 5
type_into "event 1 value" 400
frames 4
import -window root 1_event.png
# From the top a line is drawn over the hills where one points.
xdotool mousemove 600 400 key t
frames 10
click "Draw a breach"
drag 480 520 640 540
await_widget "remove event 2"
type_into "event 2 at" 5
type_into "event 1 at" 4
# What is nonsense is not taken: the bottom stays below the crest, the time above 0.
xdotool mousemove 1100 600
for _ in $(seq 12); do xdotool click 5; frames 1; done
type_into "event 2 bottom" 99999
for _ in $(seq 12); do xdotool click 4; frames 1; done
type_into "event 1 at" -7
frames 4
import -window root 2_breach.png
xdotool mousemove 600 400
play 30
frames 6
import -window root 3_done.png
save_as rained.exr
grep -aq 'rain_mm_per_h = 400' rained.exr || fail "the event did not set the rain"
/usr/bin/python3 - <<'PY'
import re, sys
breach = re.search(rb'"bottom_m":([-0-9.e]+),"crest_m":([-0-9.e]+)', open("rained.exr", "rb").read())
bottom_m, crest_m = (float(n) for n in breach.groups())
if not bottom_m == crest_m:
    sys.exit(f"a bottom far over the crest was taken as {bottom_m} m, the crest is {crest_m} m high")
PY
# Back to before all of it.
for _ in $(seq 20); do
    xdotool key ctrl+z
    frames 4
done
[ -z "$(rect_of "remove event 1")" ] || fail "undone, the event is still listed"
save_as undone.exr
[ "$(hash_of undone.exr)" = "$begun" ] || fail "undone the terrain is not what it was: $begun, now $(hash_of undone.exr)"
close_window
echo "an event came to its time and was undone; a breach was drawn"
