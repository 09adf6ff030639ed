#!/usr/bin/env bash
# Tools, panels and the menu without a mouse: F6 moves the keyboard into them, and Escape back to the picture.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/window.sh"

keys() {
    local key
    for key in "$@"; do
        xdotool key "$key"
        frames 4
    done
}

open_window --preset rain-erosion --ui-rects rects
await_widget Play
xdotool mousemove 600 640
frames 8
# The first arrow key goes to the first button: Play.
keys F6 Down space
await_widget Pause
keys space
await_widget Play
import -window root 1_tools.png
# The panels on the right, from the first one on: the second one is Water, which places springs.
keys F6 Right space
await_widget "Place a spring"
import -window root 2_panels.png
# In the picture again Space plays.
keys Escape space
await_widget Pause
keys space
await_widget Play
drop_and_close
echo "tools and panels were reached by keys alone"
