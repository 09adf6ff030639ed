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
xdotool key ctrl+a type --delay 1 4
xdotool key Tab
await_work
hit "m: the largest value"
xdotool key ctrl+a type --delay 1 200
xdotool key Tab
await_work
import -window root developer_1_import.png
hit "Open it"
await_work
frames 8
# A pad where the stroke begins.
hit flatten
enter brush.radius_m 60
enter brush.falloff 0.3
clicks=$((clicks + 1))
drag 520 330 535 330
drag 520 330 535 330
# A road up the hill.
hit Paths
enter path.width_m 8
enter path.grade_percent 8
hit "Draw it"
press 520 330
press 600 300
press 560 260
press 660 250
press 640 210
frames 20
import -window root developer_2_road.png
sed -n 's/.* path no steeper than \([0-9.]*\) %$/\1/p' rects >grade
awk '{ exit !($1 > 0 && $1 <= 8.01) }' grade || fail "the road is steeper than 8 %: $(cat grade)"
hit "Build it"
await_work
# A river's bed.
hit path.kind
hit "path.kind=river"
press 700 420
press 760 360
press 790 300
hit "Build it"
await_work
# A crater of the shelf.
hit stamp
enter brush.radius_m 90
hit "stamp crater"
frames 4
press 420 430
# Water stands in the crater and runs in the river.
hit water
enter brush.radius_m 20
enter brush.rate_m_per_s 3
for way in "700 420 760 360" "760 360 790 300" "420 430 424 430"; do
    clicks=$((clicks + 1))
    drag $way
done
clicks=$((clicks + 2))
play 1
hit Simulation
shot developer_3_land
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
shot developer_4_end
close_window
open_window land.exr --ui-rects rects --window-size 1280x720
await_widget time.speed
shot developer_5_reopened
for one in developer_4_end developer_5_reopened; do convert "$one.png" -crop 520x560+320+60 +repage "$one.crop.png"; done
compare -metric AE developer_4_end.crop.png developer_5_reopened.crop.png null: 2>differ || true
[ "$(cat differ)" = 0 ] || fail "the project looks otherwise when it is opened again, in $(cat differ) pixels"
[ "$(hash_of land.exr)" = "$hash" ] || fail "another hash"
close_window
echo "game developer: $clicks clicks, $took s in the window"
