#!/usr/bin/env bash
# A window is killed in the midst of a stroke, so many times (TALUS_KILLS, 2 unless given): the next one offers the work up to
# the last autosave, and it is the same to the bit.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/window.sh"

kills=${TALUS_KILLS:-2}
"$talus" run --preset alpine --size 257x257 --spacing 40 --ticks 0 --out start.exr 2>/dev/null
for kill in $(seq "$kills"); do
    cp start.exr ground.exr
    open_window ground.exr --ui-rects rects --window-size 1280x720 --set autosave.interval_s=1 --set water.rain_mm_per_h=50
    await_widget Play
    frames 2
    xdotool mousemove 600 400
    frames 8
    # Strokes and runs until the end comes, 3 to 9 seconds later.
    (
        while kill -0 "$pid" 2>/dev/null; do
            xdotool mousemove $((520 + RANDOM % 160)) $((320 + RANDOM % 140)) mousedown 1 2>/dev/null
            sleep 0.5
            xdotool mouseup 1 2>/dev/null
            sleep 0.2
            xdotool key space 2>/dev/null
        done
    ) &
    hand=$!
    sleep "$((3 + RANDOM % 7)).$((RANDOM % 10))"
    kill -9 "$pid"
    date +%s >killed
    wait "$pid" 2>/dev/null || true
    wait "$hand" 2>/dev/null || true
    xdotool mouseup 1
    autosave=$(ls -t state/talus/sessions/*/autosave.exr 2>/dev/null | head -n 1 || true)
    [ -n "$autosave" ] || fail "kill $kill: nothing was kept"
    age=$(($(cat killed) - $(stat -c %Y "$autosave")))
    [ "$age" -le 6 ] || fail "kill $kill: what was kept is $age s old, of an interval of 1 s"
    kept=$(hash_of "$autosave")
    [ -n "$kept" ] || fail "kill $kill: what was kept cannot be read"

    rm -f rects
    open_window --ui-rects rects --window-size 1280x720
    await_widget Recover
    frames 4
    [ "$kill" -gt 1 ] || import -window root offered.png
    click Recover
    # The scene that the window began with, and this one. Until then Ctrl+S is refused in words.
    for _ in $(seq 300); do [ "$(grep -c "begun with hash" window.log)" -lt 2 ] || break; sleep 0.1; done
    # Saved with what is recovered it goes to its own project.
    xdotool mousemove 600 400 key ctrl+s
    await_word "saved .*ground.exr"
    [ "$(hash_of ground.exr)" = "$kept" ] || fail "kill $kill: recovered it is another terrain"
    close_window
    [ -z "$(ls state/talus/sessions)" ] || fail "kill $kill: an orderly end left $(ls state/talus/sessions)"
    : >window.log
done
echo "window: killed $kills times, recovered each time"
