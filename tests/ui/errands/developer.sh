#!/usr/bin/env bash
# The game developer's errand: a picture of 16 bits opened with its scale, a pad, a winding road of at most 8 %, a crater, a
# river with water in it, files for Unity, Godot and glTF, and the project opened again as it was. TALUS FOLDER; pictures stay.
set -euo pipefail
source "$(dirname "$(realpath "${BASH_SOURCE[0]}")")/errand.sh"

"$talus" run --preset blank --set terrain.kind=hills --set terrain.nx=257 --set terrain.ny=257 --set terrain.relief_m=200 \
    --ticks 0 --out heights.png 2>/dev/null
rm -f heights.png.*
open_window --ui-rects rects --window-size 1280x720
hit "Open a file…"
name_file "$PWD/heights.png"
await_widget "import spacing"
clicks=$((clicks + 1))
click "import spacing"
xdotool key ctrl+a type --delay 1 8
xdotool key Tab
await_work
hit "Largest value, m"
xdotool key ctrl+a type --delay 1 160
xdotool key Tab
await_work
import -window root developer_1_import.png
hit "Open it"
await_work
frames 8
# From the top, a pad where the stroke begins.
hit "Top view"
frames 8
hit flatten
enter brush.radius_m 60
enter brush.falloff 0.3
clicks=$((clicks + 1))
drag 406 552 414 552
drag 406 552 414 552
# A road down from it.
hit Paths
enter path.width_m 20
enter path.grade_percent 8
hit "Draw it"
press 406 552
press 445 580
press 470 540
press 500 575
press 520 530
press 560 554
press 595 540
frames 20
import -window root developer_2_road.png
sed -n 's/.* path no steeper than \([0-9.]*\) %$/\1/p' rects >grade
awk '{ exit !($1 > 0 && $1 <= 8.01) }' grade || fail "the road is steeper than 8 %: $(cat grade)"
hit "Build it"
await_work
# A river's bed down the valley.
hit path.kind
hit "path.kind=river"
enter path.width_m 30
press 764 478
press 754 418
press 774 359
press 793 314
press 796 259
press 793 210
hit "Build it"
await_work
# A crater of the shelf.
hit stamp
enter brush.radius_m 110
hit "stamp crater"
frames 4
press 396 200
# A spring fills the river.
hit Water
enter spring.rate_m3_per_s 150
hit "Place a spring"
press 764 478
await_widget "remove spring 1"
hit Simulation
enter time.tick_s 1
enter time.speed 100
clicks=$((clicks + 2))
play 25
shot developer_3_river
hit "Top view"
hit "Fit view"
shot developer_4_land
xdotool mousemove 600 400 key ctrl+shift+s
name_file "$PWD/land"
await_word "saved .*land.exr"
for kind in unity:land.raw godot:land.r16 mesh:land.glb; do
    xdotool mousemove 600 400 key ctrl+e
    hit "${kind%%:*}"
    click "export path"
    xdotool key ctrl+a type --delay 1 "$PWD/${kind#*:}"
    hit Write
    await_word "wrote .*${kind#*:}"
    is_there "${kind#*:}"
    frames 8
done
hash=$(hash_of land.exr)
took=$((SECONDS - begin))
sleep 7
shot developer_5_end
close_window
open_window land.exr --ui-rects rects --window-size 1280x720
await_widget time.speed
shot developer_6_reopened
for one in developer_5_end developer_6_reopened; do convert "$one.png" -crop 520x560+320+60 +repage "$one.crop.png"; done
compare -metric AE developer_5_end.crop.png developer_6_reopened.crop.png null: 2>differ || true
[ "$(cat differ)" = 0 ] || fail "the project looks otherwise when it is opened again, in $(cat differ) pixels"
[ "$(hash_of land.exr)" = "$hash" ] || fail "another hash"
close_window
echo "game developer: $clicks clicks, $took s in the window"
