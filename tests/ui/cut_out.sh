#!/usr/bin/env bash
# A person's errand in a real window, no internals touched: over a raster in tiles one flies to a valley, draws a rectangle and cuts it out;
# a dam is sculpted across it, it rains, a lake rises, the brush breaches the dam; all is undone and redone, saved, put back; the
# mosaic is opened and shows the work. The raster keeps its bytes, and the mosaic every sample that was not worked on. Pictures
# stay in the folder.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/window.sh"

# Of each terrain:
# valley: where it lies in the picture that the window opens with
# wheel: the button that turns it there, and how often
# drawn: the drag over it from above; edges: about which ones that draws, m
# dam, breach: where they are in the picture that the window frames of these edges
# km_east, km_north: how many pixels a kilometre goes there
if [ -f "${TALUS_DATA:-}/santa_ynez_coast_30m_1537.tif" ]; then
    for part in santa_ynez_coast_30m_1537:0:46110:46110:0 bigtujunga_30m_1197x643:44010:40020:79920:20730; do
        IFS=: read -r name west north east south <<<"$part"
        gdal_translate -q -ot Float32 -a_srs EPSG:32611 -a_ullr "$west" "$north" "$east" "$south" "$TALUS_DATA/$name.tif" "$name.tif"
    done
    gdalbuildvrt -q parts.vrt bigtujunga_30m_1197x643.tif santa_ynez_coast_30m_1537.tif
    "$talus" tile parts.vrt whole.tif >/dev/null 2>&1
    valley=(418 254)
    wheel=(4 13)
    drawn=(360 415 444 72)
    edges=(33300 19500 36000 22800)
    first=15 # coordinates of the south-west sample
    spacing=30
    dam=(620 393 665 380)
    breach=(642 386)
    km_east=(189 -53)
    km_north=(-59 -88)
else
    "$talus" run --preset still --set terrain.kind=valley --set terrain.relief_m=400 --size 193x193 --spacing 20 --ticks 0 \
        --out valley.tif 2>/dev/null
    "$talus" tile valley.tif whole.tif >/dev/null 2>&1
    valley=(350 300)
    wheel=(5 4)
    drawn=(84 70 585 301)
    edges=(20 20 3180 3820)
    first=0
    spacing=20
    dam=(661 328 608 278)
    breach=(634 302)
    km_east=(169 -47)
    km_north=(-46 -57)
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
# There, as somebody would fly who has seen it, and drawn anew from near.
xdotool mousemove "${valley[@]}"
for _ in $(seq "${wheel[1]}"); do
    xdotool click "${wheel[0]}"
    frames 4
done
# From straight above a rectangle ends where it seems to.
over=("${valley[0]}" $((valley[1] + 400)))
drag "${valley[@]}" "${over[@]}" 3
shot 03_flown
click "Draw it"
drag "${drawn[@]}"
await_widget "Draw it"
shot 04_drawn
click "Cut it out"
await_widget Water
frames 4
shot 05_in_place
xdotool mousemove 600 600 key f
shot 06_framed
xdotool mousemove 600 600 key ctrl+shift+s
answer "$PWD/saved.exr"
await_word "saved .*saved.exr"
cp saved.exr valley.exr
# The edges of what was cut out: samples, and the first and last one's places.
read -r west south east north < <("$talus" info --json valley.exr | /usr/bin/python3 -c "
import json, sys
info = json.load(sys.stdin)
west, dx, _, north, _, dy = info['geotransform']
edges = west + dx / 2, north + (info['ny'] - 0.5) * dy, west + (info['nx'] - 0.5) * dx, north + dy / 2
print(*(round(edge) - $first for edge in edges))") || fail "the part does not say where it lies"
# The wheel goes to the ground that was seen a frame ago, so nobody gets anywhere twice to the sample.
for edge in 0 1 2 3; do
    at=($west $south $east $north)
    off=$((${at[edge]} - ${edges[edge]}))
    [ "${off#-}" -le $((5 * spacing)) ] || fail "the part that was drawn ends at ${at[edge]} m, not at ${edges[edge]}"
done

# Nothing was done yet.
click "Put back…"
answer "$PWD/nothing.vrt"
await_word "nothing is to be put back"
[ ! -e nothing.vrt ] && [ ! -e nothing.parts ] || fail "something was put back"

# Where the same ground is in the picture of the part that was drawn: it is framed about its middle.
in_part() {
    local right=$(((west + east - ${edges[0]} - ${edges[2]}) / 2)) up=$(((south + north - ${edges[1]} - ${edges[3]}) / 2))
    while [ $# -gt 0 ]; do
        echo $(($1 - (right * ${km_east[0]} + up * ${km_north[0]}) / 1000))
        echo $(($2 - (right * ${km_east[1]} + up * ${km_north[1]}) / 1000))
        shift 2
    done
}
dam=($(in_part "${dam[@]}"))
breach=($(in_part "${breach[@]}"))

click ramp
type_into brush.radius_m 70
drag "${dam[@]}"
shot 07_dam
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
shot 08_lake
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
shot 09_breach
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
shot 10_put_back
click "Fly over the whole"
for _ in $(seq 100); do [ -z "$(rect_of Play)" ] && break; sleep 0.1; done
[ -z "$(rect_of Play)" ] || fail "the whole did not open"
shot 11_whole
xdotool mousemove 600 600 key ctrl+o
answer "$PWD/worked.vrt"
await_work
click "Cut out"
shot 12_mosaic
close_window

sha256sum --quiet -c whole.sum || fail "the raster has other bytes"
# In the part the mosaic's ground is the document's; along its edges, and beyond, the raster's.
window() { # WEST SOUTH EAST NORTH, metres from the south-west sample
    echo "$(($1 + first)),$(($2 + first)),$(($3 + first)),$(($4 + first))"
}
"$talus" convert saved.exr worked.tif
"$talus" convert worked.vrt part.tif --window "$(window "$west" "$south" "$east" "$north")"
cmp worked.tif part.tif || fail "the mosaic has another ground than the document"
"$talus" convert whole.tif before.tif --window "$(window "$west" "$south" "$east" "$north")"
cmp -s before.tif part.tif && fail "the mosaic's ground is the raster's"
beside() { # NAME WEST SOUTH EAST NORTH
    "$talus" convert whole.tif "$1_before.tif" --window "$(window "${@:2}")"
    "$talus" convert worked.vrt "$1_after.tif" --window "$(window "${@:2}")"
    cmp "$1_before.tif" "$1_after.tif" || fail "$1 of the part the mosaic has another ground than the raster"
}
strip=$((10 * spacing))
[ "$west" -lt "$strip" ] || beside west $((west - strip)) "$south" "$west" "$north"
[ "$south" -lt "$strip" ] || beside south "$west" $((south - strip)) "$east" "$south"
beside east "$east" "$south" $((east + strip)) "$north"
[ "$first" = 0 ] || beside north "$west" "$north" "$east" $((north + strip))
gdalinfo -checksum worked.vrt >/dev/null || fail "GDAL does not read the mosaic"
echo "window: a valley was cut out, worked on and put back"
