#!/usr/bin/env bash
# A person's errand in a real window, no internals touched: over a raster in tiles a rectangle is drawn and the valley in it cut out;
# a dam is sculpted across it, it rains, a lake rises, the brush breaches the dam; all is undone and redone, saved, put back; the
# mosaic is opened and shows the work. The raster keeps its bytes, and the mosaic every sample that was not worked on. Pictures
# stay in the folder.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/window.sh"

# The valley, and where the dam begins, ends and is breached in the picture that the window frames of it (dam.sh).
if [ -f "${TALUS_DATA:-}/santa_ynez_coast_30m_1537.tif" ]; then
    for part in santa_ynez_coast_30m_1537:0:46110:46110:0 bigtujunga_30m_1197x643:44010:40020:79920:20730; do
        IFS=: read -r name west north east south <<<"$part"
        gdal_translate -q -ot Float32 -a_srs EPSG:32611 -a_ullr "$west" "$north" "$east" "$south" "$TALUS_DATA/$name.tif" "$name.tif"
    done
    gdalbuildvrt -q parts.vrt bigtujunga_30m_1197x643.tif santa_ynez_coast_30m_1537.tif
    "$talus" tile parts.vrt whole.tif >/dev/null 2>&1
    edges=(33300 19500 36000 22800)
    first=15 # coordinates of the south-west sample
    spacing=30
    dam=(620 393 665 380)
    breach=(642 386)
else
    "$talus" run --preset still --set terrain.kind=valley --set terrain.relief_m=400 --size 193x193 --spacing 20 --ticks 0 \
        --out valley.tif 2>/dev/null
    "$talus" tile valley.tif whole.tif >/dev/null 2>&1
    edges=(0 0 3200 3840)
    first=0
    spacing=20
    dam=(661 328 608 278)
    breach=(634 302)
fi
sha256sum whole.tif >whole.sum

shot() {
    frames 20
    import -window root "$1.png"
}
# The name that a file dialog asks for.
answer() {
    await_widget "file name"
    click "file name"
    xdotool key ctrl+a type --delay 1 "$1"
    frames 4
    xdotool key Return
}

open_window whole.tif --tiled --ui-rects rects --window-size 1280x720
await_widget Log
frames 20
shot 01_overview

# Beside the terrain a drag chooses nothing; over it, it does.
click "Cut out"
click "Draw it"
drag 30 660 60 680
await_widget "Drag over the ground…"
drag 300 260 500 220
await_widget "Draw it"
shot 02_drawn
names=(map.west_m map.south_m map.east_m map.north_m)
for i in 0 1 2 3; do type_into "${names[$i]}" "${edges[$i]}"; done
shot 03_typed
# There from near, as somebody would fly who has found it.
xdotool mousemove 400 300
for _ in $(seq 5); do xdotool click 4; frames 2; done
xdotool keydown w
frames 12
xdotool keyup w
shot 04_flown
click "Cut it out"
await_widget Water
frames 4
shot 04_in_place
xdotool mousemove 600 600 key f
shot 05_framed
xdotool mousemove 600 600 key ctrl+shift+s
answer "$PWD/saved.exr"
await_word "saved .*saved.exr"
cp saved.exr valley.exr

# Nothing was done yet.
click "Put back…"
answer "$PWD/nothing.vrt"
await_word "nothing is to be put back"
[ ! -e nothing.vrt ] && [ ! -e nothing.parts ] || fail "something was put back"

click ramp
type_into brush.radius_m 70
drag "${dam[@]}"
shot 06_dam
save dam.exr
[ "$(hash_of dam.exr)" != "$(hash_of valley.exr)" ] || fail "the ramp changed nothing"

click Simulation
# Slopes that slide would work on all of the part, its edges too.
click thermal.on
type_into time.tick_s 1
type_into time.speed 60
click Water
type_into water.rain_mm_per_h 10000
xdotool mousemove 600 600
for _ in $(seq 8); do
    play 8
    save lake.exr
    deepest=$(depth lake.exr)
    [ "${deepest%.*}" -lt 10 ] || break
done
shot 07_lake
[ "${deepest%.*}" -ge 10 ] || fail "no lake rose: $deepest m at most"

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
xdotool key space
shot 08_breach
save breach.exr
# Back to before the dam, and forth again.
click History
click "history 0"
save undone.exr
[ "$(hash_of undone.exr)" = "$(hash_of valley.exr)" ] || fail "undo to before the dam is not the valley to the bit"
last=$(sed -n 's/.* history \([0-9]*\)$/\1/p' rects | sort -n | tail -n 1)
click "history $last"
save redone.exr
[ "$(hash_of redone.exr)" = "$(hash_of breach.exr)" ] || fail "redo is not the breach to the bit"

# Back into its place. A mosaic that is there is asked for.
click "Cut out"
click "Put back…"
echo "of somebody else" >worked.vrt
answer "$PWD/worked.vrt"
await_widget "Put it back"
click Cancel
for _ in $(seq 100); do [ -z "$(rect_of "Put it back")" ] && break; sleep 0.1; done
frames 8
[ "$(cat worked.vrt)" = "of somebody else" ] || fail "a mosaic was replaced though that was not wanted"
click "Put back…"
answer "$PWD/worked.vrt"
click "Put it back"
await_word "put [0-9]* samples back: .*worked.vrt is the whole with them"
shot 09_put_back
click "Fly over the whole"
for _ in $(seq 100); do [ -z "$(rect_of Play)" ] && break; sleep 0.1; done
[ -z "$(rect_of Play)" ] || fail "the whole did not open"
shot 10_whole
xdotool mousemove 600 600 key ctrl+o
answer "$PWD/worked.vrt"
await_work
click "Cut out"
shot 11_mosaic
close_window

sha256sum --quiet -c whole.sum || fail "the raster has other bytes"
# In the part the mosaic's ground is the document's; along its edges, and beyond, the raster's.
window() { # WEST SOUTH EAST NORTH, metres from the south-west sample
    echo "$(($1 + first)),$(($2 + first)),$(($3 + first)),$(($4 + first))"
}
"$talus" convert saved.exr worked.tif
"$talus" convert worked.vrt part.tif --window "$(window "${edges[@]}")"
cmp worked.tif part.tif || fail "the mosaic has another ground than the document"
"$talus" convert whole.tif before.tif --window "$(window "${edges[@]}")"
cmp -s before.tif part.tif && fail "the mosaic's ground is the raster's"
read -r west south east north <<<"${edges[*]}"
beside() { # NAME WEST SOUTH EAST NORTH
    "$talus" convert whole.tif "$1_before.tif" --window "$(window "${@:2}")"
    "$talus" convert worked.vrt "$1_after.tif" --window "$(window "${@:2}")"
    cmp "$1_before.tif" "$1_after.tif" || fail "$1 of the part the mosaic has another ground than the raster"
}
strip=$((10 * spacing))
[ "$west" = 0 ] || beside west $((west - strip)) "$south" "$west" "$north"
[ "$south" = 0 ] || beside south "$west" $((south - strip)) "$east" "$south"
beside east "$east" "$south" $((east + strip)) "$north"
[ "$first" = 0 ] || beside north "$west" "$north" "$east" $((north + strip))
gdalinfo -checksum worked.vrt >/dev/null || fail "GDAL does not read the mosaic"
echo "window: a valley was cut out, worked on and put back"
