#!/usr/bin/env bash
# A window on a virtual display: a stroke of the mouse changes the ground under the cursor, undo takes it back to the
# bit, play runs, replaying the window's journal gives the window's terrain. Screenshots stay in the folder.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/window.sh"

# Saves with Ctrl+S and waits until the file is a new one.
save() {
    local before
    before=$(stat -c %i ground.exr)
    xdotool key ctrl+s
    for _ in $(seq 100); do
        [ "$(stat -c %i ground.exr)" != "$before" ] && return
        sleep 0.1
    done
    fail "Ctrl+S did not save"
}

"$talus" run --preset alpine --size 257x257 --spacing 40 --ticks 0 --out ground.exr 2>/dev/null
cp ground.exr start.exr
open_window ground.exr --journal window.journal
frames 8
import -window root 1_open.png

# A click that jumps from the ground onto a panel is the panel's.
for _ in 1 2 3 4 5; do
    xdotool mousemove 620 330
    frames 6
    xdotool mousemove 150 585 mousedown 1 sleep 0.2 mouseup 1
    frames 4
done
save
[ "$(hash_of ground.exr)" = "$(hash_of start.exr)" ] || fail "a click on the panel was a stroke on the ground"

xdotool mousemove 620 330
frames 8
xdotool mousedown 1
sleep 1
xdotool mousemove 635 335
frames 8
xdotool mouseup 1
frames 8
import -window root 2_stroke.png
save
cp ground.exr stroke.exr
[ "$(hash_of stroke.exr)" != "$(hash_of start.exr)" ] || fail "the stroke changed nothing"

xdotool key ctrl+z
frames 4
import -window root 3_undone.png
save
[ "$(hash_of ground.exr)" = "$(hash_of start.exr)" ] || fail "undo is not the start to the bit"

xdotool key ctrl+shift+z
save
[ "$(hash_of ground.exr)" = "$(hash_of stroke.exr)" ] || fail "redo is not the stroke to the bit"

xdotool key space
sleep 2
xdotool key space
frames 4
import -window root 4_played.png
save
[ "$(hash_of ground.exr)" != "$(hash_of stroke.exr)" ] || fail "play changed nothing"
cp ground.exr played.exr

close_window

# The journal starts from the file as it was opened.
cp start.exr ground.exr
"$talus" replay window.journal --out replayed.exr 2>replay.log || { cat replay.log; fail "the journal does not replay"; }
[ "$(hash_of replayed.exr)" = "$(hash_of played.exr)" ] || fail "the replay is not the window's terrain"

# What the stroke changed lies under the cursor: the pictures differ there, and not in a corner far from it.
difference=$(compare -metric AE -extract 60x40+590+310 1_open.png 2_stroke.png null: 2>&1 || true)
[ "${difference%%.*}" -gt 100 ] || fail "the picture shows no stroke under the cursor"
echo "window: stroke, undo, redo, play, save, replay: $(hash_of played.exr)"
