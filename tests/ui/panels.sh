#!/usr/bin/env bash
# Pictures of every panel and of the dialogs, for docs/gallery: TALUS FOLDER [WIDTHxHEIGHT] [THEME]. Panels are as large as the
# window is wide.
set -euo pipefail
size=${3:-1280x720}
theme=${4:-plain}
width=${size%x*}
if [ -z "${TALUS_UNDER_XVFB:-}" ]; then
    TALUS_UNDER_XVFB=1 exec xvfb-run -a -s "-screen 0 ${size}x24 -noreset" bash "$0" "$@"
fi
source "$(dirname "${BASH_SOURCE[0]}")/window.sh"

# A place in a window of 1280 x 720, in this one.
at() { echo $(($1 * width / 1280)) $(($2 * width / 1280)); }
picture() {
    sleep 1
    frames 4
    import -window root "$1.png"
}
rest() { xdotool mousemove $(at 600 600); }

"$talus" run --preset slopes --size 129x97 --ticks 0 --out heights.tif 2>/dev/null
open_window --ui-rects rects --window-size "$size" --ui-scale "$(awk "BEGIN { print $width / 1280 }")" --theme "$theme"
await_widget "Go on with this scene"
xdotool mousemove $(at 600 690)
sleep 3
picture start
click "preset rain-erosion"
await_widget Play
sleep 3
# Something to see in history, ledger and profiler.
xdotool mousemove $(at 600 400) mousedown 1
sleep 1.5
xdotool mouseup 1
for panel in Ledger Simulation Water Erosion Tables View Mask Paths Map History Gauges Presets Log Profiler; do
    click "$panel"
    rest
    if [ "$panel" = Ledger ] || [ "$panel" = Profiler ]; then
        xdotool key space
        sleep 5
        [ "$panel" = Profiler ] || xdotool key space
    fi
    picture "$(echo "$panel" | tr 'A-Z' 'a-z')"
done
xdotool key space
for tool in noise terrace erode stamp; do
    click "$tool"
    rest
    picture "tool_$tool"
done
# A dialog by its key, until Escape.
dialog() {
    rest
    xdotool key "$1"
    picture "$2"
    xdotool key Escape
    frames 8
}
dialog ctrl+e export
dialog ctrl+n new
dialog ctrl+o open
dialog F1 keys
dialog ctrl+q question
click "View menu"
picture menu
xdotool key Escape
frames 8
rest
xdotool key ctrl+o
await_widget "file name"
frames 8
xdotool key ctrl+a type --delay 2 "$PWD/heights.tif"
xdotool key Return
await_widget "import spacing"
picture import
click "Cancel import"
frames 8
# What it finds of this device takes a while.
click Help
click "Verify this device"
for _ in $(seq 120); do
    [ -z "$(rect_of "Close")" ] || break
    sleep 5
done
await_widget "Close"
picture verify
kill "$pid"
