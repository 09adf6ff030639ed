#!/usr/bin/env bash
# From the start page to an eroded, saved heightmap, as docs/guide.md tells it: the clicks of a person, and the time that
# they took. Pictures stay in the folder.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/window.sh"

begin=$SECONDS
open_window --ui-rects rects --window-size 1280x720
await_widget "preset rain-erosion"
frames 4
import -window root 1_start.png
click "preset rain-erosion"
await_widget Play
click Play
sleep 10
click Pause
frames 4
import -window root 2_eroded.png
xdotool mousemove 600 600 key ctrl+e
await_widget "export path"
click "export path"
xdotool key ctrl+a type --delay 1 "$PWD/eroded.tif"
frames 4
import -window root 3_export.png
click Write
await_word "wrote .*eroded.tif"
took=$((SECONDS - begin))
import -window root 4_written.png
xdotool key ctrl+q
click "Drop the changes"
for _ in $(seq 100); do kill -0 "$pid" 2>/dev/null || break; sleep 0.1; done
"$talus" info eroded.tif >/dev/null || fail "the heightmap cannot be read"
[ "$took" -le 120 ] || fail "from the start page to the heightmap took $took s"
echo "window: from the start page to an eroded heightmap in $took s"
