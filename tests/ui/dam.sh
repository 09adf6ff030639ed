#!/usr/bin/env bash
# A person's session in a real window, no internals touched: a file is opened by the dialog and cropped to a valley, a dam
# is sculpted across it, it rains, a lake rises behind the dam, the brush breaches it; everything is undone to before the
# dam and redone, played on, saved, exported, closed and opened again: the same hash. The session's journal replays
# without a window to that hash, on one thread and on two. A screenshot of each step stays in the folder.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/window.sh"

# The valley, and where the dam begins, ends and is breached in the picture that the window frames of it.
if [ -f "${TALUS_DATA:-}/santa_ynez_coast_30m_1537.tif" ]; then
    file=$TALUS_DATA/santa_ynez_coast_30m_1537.tif
    edges=(33300 19500 36000 22800)
    dam=(620 393 665 380)
    breach=(642 386)
else
    "$talus" run --preset still --set terrain.kind=valley --set terrain.relief_m=400 --size 193x193 --spacing 20 --ticks 0 \
        --out valley.tif 2>/dev/null
    file=$PWD/valley.tif
    edges=(0 0 3200 3840)
    dam=(661 328 608 278)
    breach=(634 302)
fi

shot() {
    frames 4
    import -window root "$1.png"
}

open_window --preset blank --journal window.journal --ui-rects rects --window-size 1280x720
await_widget Play
frames 2
xdotool mousemove 600 400 key ctrl+o
await_widget "file name"
frames 2
# Faster than frames: what was typed must all come before Return.
xdotool type --delay 1 "$file"
xdotool key Return
await_widget "Open it"
shot 01_import
click "Open it"
await_work
shot 02_opened

click Map
names=(map.west_m map.south_m map.east_m map.north_m)
for i in 0 1 2 3; do type_into "${names[$i]}" "${edges[$i]}"; done
click Crop
await_work
shot 03_valley
xdotool mousemove 600 600 key ctrl+shift+s
await_widget "file name"
frames 2
xdotool key ctrl+a type --delay 1 "$PWD/saved.exr"
xdotool key Return
await_word "saved .*saved.exr"
cp saved.exr valley.exr

click ramp
type_into brush.radius_m 70
drag "${dam[@]}"
shot 04_dam
save dam.exr
[ "$(hash_of dam.exr)" != "$(hash_of valley.exr)" ] || fail "the ramp changed nothing"

click Simulation
type_into time.tick_s 1
type_into time.speed 60
click Water
type_into water.rain_mm_per_h 10000
xdotool mousemove 600 600
# A machine that does other things as well fills it more slowly.
for _ in $(seq 8); do
    play 8
    save lake.exr
    deepest=$(depth lake.exr)
    [ "${deepest%.*}" -lt 10 ] || break
done
shot 05_lake

click lower
type_into brush.radius_m 60
type_into brush.rate_m_per_s 60
xdotool mousemove "${breach[@]}"
frames 4
xdotool key space
sleep 1
xdotool mousedown 1
sleep 2.5
xdotool mouseup 1
sleep 2
shot 06_breach
# In mid-rain, back to before the dam: there it pauses.
click History
click "history 1"
shot 07_undone
save undone.exr
[ "$(hash_of undone.exr)" = "$(hash_of valley.exr)" ] || fail "undo to before the dam is not the valley to the bit"
last=$(sed -n 's/.* history \([0-9]*\)$/\1/p' rects | sort -n | tail -n 1)
click "history $last"
shot 08_redone
xdotool mousemove 600 600
play 3
shot 09_played
save played.exr
[ "$(hash_of played.exr)" != "$(hash_of lake.exr)" ] || fail "nothing happened after the lake"

xdotool mousemove 600 600 key ctrl+e
click heightmap
shot 10_export
click "export path"
xdotool key ctrl+a type --delay 1 "$PWD/exported.tif"
click Write
await_word "wrote .*exported.tif"
close_window

"$talus" info exported.tif >/dev/null || fail "the export cannot be read"
cp window.journal session.journal
open_window saved.exr --ui-rects rects --window-size 1280x720
await_widget Play
shot 11_reopened
save reopened.exr
close_window
[ "$(hash_of reopened.exr)" = "$(hash_of played.exr)" ] || fail "closed and opened again it is another terrain"
for threads in 1 2; do
    LP_NUM_THREADS=$threads "$talus" replay session.journal --out replayed.exr 2>replay.log ||
        { cat replay.log; fail "the journal does not replay"; }
    [ "$(hash_of replayed.exr)" = "$(hash_of played.exr)" ] || fail "replayed on $threads threads it is another terrain"
done

# The lake lies where the valley was dry.
[ "${deepest%.*}" -ge 10 ] || fail "behind the dam the water is only $deepest m deep"
echo "window: a lake of $deepest m behind a dam, breached, undone, redone, saved, exported, reopened, replayed: $(hash_of played.exr)"
