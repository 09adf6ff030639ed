#!/usr/bin/env bash
# Sculpting while water runs, in a real window at 1280 x 720: TALUS FOLDER [SAMPLES] [SECONDS]. Strokes around a circle, by
# the mouse; from the window's own log of frames: how long a frame takes, and how old the oldest movement in its dabs is when
# its picture is presented. Wall time.
set -euo pipefail
samples=${3:-512}
seconds=${4:-60}
source "$(dirname "${BASH_SOURCE[0]}")/../ui/window.sh"

open_window --preset waves --set "terrain.nx=$samples" --set "terrain.ny=$samples" \
    --set "terrain.spacing_m=$(awk "BEGIN { print 1536 / $samples }")" --frame-log frames.csv --ui-rects rects --window-size 1280x720
await_widget Play
sleep 3
xdotool mousemove 620 380
sleep 1
xdotool key space
sleep 2
end=$((SECONDS + seconds))
step=0
while [ "$SECONDS" -lt "$end" ]; do
    xdotool mousemove 670 360
    sleep 0.1
    xdotool mousedown 1
    for _ in $(seq 60); do
        step=$((step + 1))
        # shellcheck disable=SC2046
        xdotool mousemove $(awk "BEGIN { print int(600 + 70 * cos($step * 0.12)), int(360 + 50 * sin($step * 0.12)) }")
        sleep 0.02
    done
    xdotool mouseup 1
    sleep 0.3
done
xdotool key space
sleep 1
xdotool key ctrl+q
click "Drop the changes"
for _ in $(seq 100); do kill -0 "$pid" 2>/dev/null || break; sleep 0.1; done

# Of the time from the first dab to the last.
quantiles() { sort -n | awk -v name="$1" '{ v[NR] = $1 } END { printf "%-34s median %6.1f  p95 %6.1f  p99 %6.1f ms\n", name, v[int(NR * 0.5) + 1], v[int(NR * 0.95) + 1], v[int(NR * 0.99) + 1] }'; }
awk -F, 'NR > 1 && $8 > 0 { if (!first) first = NR; last = NR } END { print first, last }' frames.csv >range
read -r first last <range
sed -n "${first},${last}p" frames.csv >sculpted.csv
echo "$samples a side: $(wc -l <sculpted.csv) frames, $(awk -F, '$8 > 0' sculpted.csv | wc -l) with dabs"
awk -F, 'NR > 1 { print 1000 * ($1 - before) } { before = $1 }' sculpted.csv | quantiles "from frame to frame"
awk -F, '$8 > 0 { print $9 + $7 }' sculpted.csv | quantiles "from movement to its picture"
for part in 2:dabs 3:ticks 4:picture 5:panels 6:present; do
    awk -F, -v k="${part%%:*}" '{ print $k }' sculpted.csv | quantiles "  ${part#*:}"
done
