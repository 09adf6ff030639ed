#!/usr/bin/env bash
# Pictures of every panel, for docs/gallery: TALUS FOLDER [SCALE]. At scale 2 the display is 2560 x 1440.
set -euo pipefail
scale=${3:-1}
if [ -z "${TALUS_UNDER_XVFB:-}" ]; then
    TALUS_UNDER_XVFB=1 exec xvfb-run -a -s "-screen 0 $((1280 * scale))x$((720 * scale))x24 -noreset" bash "$0" "$@"
fi
source "$(dirname "${BASH_SOURCE[0]}")/window.sh"

open_window --ui-rects rects --window-size "$((1280 * scale))x$((720 * scale))" --ui-scale "$scale"
await_widget "Go on with this scene"
xdotool mousemove $((600 * scale)) $((690 * scale))
sleep 4
import -window root start.png
click "preset rain-erosion"
await_widget Play
sleep 4
xdotool mousemove $((600 * scale)) $((400 * scale))
sleep 0.5
# Something to see in history, ledger and profiler.
xdotool mousedown 1
sleep 1.5
xdotool mouseup 1
for panel in Ledger Simulation Water Erosion Tables View Mask Paths Map History Gauges Presets Log Profiler; do
    click "$panel"
    if [ "$panel" = Ledger ] || [ "$panel" = Profiler ]; then
        xdotool mousemove $((600 * scale)) $((600 * scale)) key space
        sleep 6
        [ "$panel" = Profiler ] || xdotool key space
    fi
    xdotool mousemove $((600 * scale)) $((600 * scale))
    sleep 2
    import -window root "$(echo "$panel" | tr 'A-Z' 'a-z').png"
done
xdotool key space
for tool in noise terrace erode stamp; do
    click "$tool"
    sleep 1
    import -window root "tool_$tool.png"
done
xdotool mousemove $((600 * scale)) $((600 * scale)) key ctrl+e
sleep 2
import -window root export.png
xdotool key Escape
sleep 1
xdotool key ctrl+n
sleep 3
import -window root new.png
xdotool key Escape
sleep 1
xdotool key ctrl+o
sleep 2
import -window root open.png
kill "$pid"
