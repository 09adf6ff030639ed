#!/usr/bin/env bash
# A project in a real window: a new terrain is generated from the start page, saved as a scene, rained on under a gauge,
# looked at from a camera that is kept, and saved; opened again it is the same picture with all that was placed, and the
# scene makes the first terrain again. Screenshots stay in the folder.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/window.sh"

shot() {
    xdotool mousemove 640 12
    frames 600
    import -window root "$1.png"
}
# The middle of the picture, without panels, menus and status.
same_picture() {
    for one in "$1" "$2"; do convert "$one.png" -crop 520x560+320+60 +repage "$one.crop.png"; done
    compare -metric AE "$1.crop.png" "$2.crop.png" null: 2>differ || true
    [ "$(cat differ)" = 0 ] || fail "$1 and $2 differ in $(cat differ) pixels"
}
name_file() {
    await_widget "file name"
    frames 2
    xdotool key ctrl+a type --delay 1 "$1"
    xdotool key Return
}

open_window --ui-rects rects --window-size 1280x720
click "New terrain…"
await_widget Generate
click terrain.kind
click "terrain.kind=valley"
type_into terrain.nx 129
type_into terrain.ny 97
type_into terrain.spacing_m 10
type_into terrain.relief_m 300
type_into water.sea_level_m 40
frames 60
import -window root 1_new.png
begun=$(grep -c "begun with hash" window.log)
click Generate
await_work
for _ in $(seq 100); do [ "$(grep -c "begun with hash" window.log)" -gt "$begun" ] && break; sleep 0.1; done
first=$(grep "begun with hash" window.log | tail -n 1)
shot 2_generated
xdotool search --name '^New valley - Talus$' >/dev/null || fail "the window is not called by the new terrain"

click File
click "Save as a scene…"
name_file "$PWD/valley"
await_word "saved the scene .*valley.toml"

click Water
type_into water.rain_mm_per_h 200
click Gauges
click "Place a gauge"
xdotool mousemove 600 260
frames 8
xdotool mousedown 1
frames 4
xdotool mouseup 1
await_widget "remove gauge 1"
xdotool mousemove 640 12
play 2
click View
drag 500 300 600 330 3
click "camera name"
xdotool type --delay 1 "over the valley"
xdotool key Return
await_widget "camera over the valley"
xdotool mousemove 500 300
for _ in 1 2 3; do xdotool click 4; done
click Gauges
xdotool mousemove 500 300 key ctrl+shift+s
name_file "$PWD/project"
await_word "saved .*project.exr"
# The sentence that says so goes away.
sleep 7
shot 3_saved
close_window

open_window project.exr --ui-rects rects --window-size 1280x720
await_widget "remove gauge 1"
shot 4_reopened
same_picture 3_saved 4_reopened
click View
click "camera over the valley"
shot 5_camera
close_window
"$talus" render project.exr --camera "over the valley" --image camera.png 2>/dev/null || fail "the kept camera draws nothing"
"$talus" render project.exr --camera "none" --image none.png 2>refusal && fail "a camera that is not there was drawn"
grep -q "it must be one of: over the valley" refusal || fail "the refusal lists no cameras: $(cat refusal)"

open_window valley.toml --ui-rects rects --window-size 1280x720
await_word "begun with hash"
[ "$(grep "begun with hash" window.log | tail -n 1)" = "$first" ] || fail "the scene makes another terrain"
# The dialog lists what it can open, and goes where a folder is named.
mkdir -p folder
cp project.exr folder/inner.exr
touch folder/notes.txt
xdotool mousemove 500 300 key ctrl+o
name_file "$PWD/folder"
await_widget "file inner.exr"
[ -z "$(rect_of "file notes.txt")" ] || fail "a file is listed that cannot be opened"
click "all files"
await_widget "file notes.txt"
import -window root 6_files.png
click "file inner.exr"
click Open
await_work
await_widget "remove gauge 1"
close_window
echo "a new terrain, its scene and its project came back as they were"
