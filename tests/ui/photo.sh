#!/usr/bin/env bash
# A photo over terrain in tiles, in a real window: a picture has the bits of `talus render`; a part that is cut out keeps it, so
# does what stands around; a photo that breaks in mid-flight and comes back. Pictures stay in the folder.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/window.sh"

"$talus" tile --generate mountains,2049x1601 --spacing 10 ground.tif 2>/dev/null
# Colours by height, twice as fine as the ground, north of it a strip without colours.
printf '0%% 30 60 20\n30%% 90 90 40\n60%% 150 120 90\n80%% 140 130 120\n100%% 250 250 250\n' >colours.txt
gdaldem color-relief -q -alpha ground.tif colours.txt coloured.tif
gdal_translate -q -srcwin 0 200 2049 1401 -outsize 4098 2802 -r bilinear coloured.tif photo.tif
"$talus" tile --texture photo.tif tiled.tif >/dev/null 2>&1
for band in 1 2 3 4; do
    [ "$(gdalinfo -checksum photo.tif | grep Checksum | sed -n ${band}p)" = "$(gdalinfo -checksum tiled.tif | grep Checksum | sed -n ${band}p)" ] ||
        fail "band $band has other colours"
done

open_window ground.tif --tiled --texture tiled.tif --ui-rects rects --window-size 1280x720 --set autosave.interval_s=86400
await_widget Log
frames 20
xdotool key F12
await_word "saved the picture talus-0001.png"
size=$(identify -format %wx%h talus-0001.png)
"$talus" render ground.tif --tiled --texture tiled.tif --size "$size" --image rendered.png 2>/dev/null
differing=$(compare -metric AE talus-0001.png rendered.png null: 2>&1) || fail "$differing pixels of the picture are others"
"$talus" render ground.tif --tiled --size "$size" --image bare.png 2>/dev/null
# How far off a picture is, in shares of all light.
off() { compare -metric MAE "$1" "$2" null: 2>&1 | sed 's/.*(\(.*\))/\1/'; }
awk "BEGIN { exit !($(off bare.png rendered.png) > 0.02) }" || fail "the photo is not seen"

# Towards the ground; the photo breaks meanwhile.
cp tiled.tif whole.tif
size_bytes=$(stat -c %s tiled.tif)
dd if=/dev/zero of=tiled.tif bs=65536 seek=1 count=$((size_bytes / 65536 * 6 / 10)) conv=notrunc 2>/dev/null
xdotool mousemove 480 420
for _ in $(seq 12); do xdotool click 4; frames 2; done
await_word "tiled.tif' cannot be read.*coarser tiles are shown there, and it is tried again"
frames 4
import -window root 1_broken.png
kill -0 "$pid" || fail "the flight ended"
dd if=whole.tif of=tiled.tif bs=65536 conv=notrunc 2>/dev/null
await_word "tiles can be read again"
frames 20
import -window root 2_mended.png

# A part is worked in under the same photo, from the same eye; its panels take more of the picture's sides.
xdotool key f
for _ in $(seq 3); do xdotool click 4; frames 2; done
xdotool key F12
await_word "saved the picture talus-0002.png"
names=(map.west_m map.south_m map.east_m map.north_m)
edges=(6000 5000 14000 11000)
click "Cut out"
for i in 0 1 2 3; do type_into "${names[$i]}" "${edges[$i]}"; done
click "Cut it out"
await_widget Water
frames 20
import -window root 3_part.png
xdotool mousemove 600 600 key F12
await_word "saved the picture talus-0003.png"
convert talus-0002.png -gravity center -crop "$(identify -format %wx%h talus-0003.png)+0+0" +repage middle.png
awk "BEGIN { exit !($(off middle.png talus-0003.png) < 0.01) }" ||
    fail "the part looks otherwise than the whole: $(off middle.png talus-0003.png)"
xdotool key space
frames 30
xdotool key space
frames 4
import -window root 4_played.png
xdotool key ctrl+q
click "Drop the changes"
for _ in $(seq 100); do kill -0 "$pid" 2>/dev/null || break; sleep 0.1; done
wait "$pid" || fail "the window ended with an error"
grep "^talus: " window.log | grep -v "tiled.tif\|tiles can be read again" && fail "the window met an error"

# What cannot be laid is refused, or said in words.
for wish in "--texture absent.tif" "--texture colours.txt"; do
    ended=0
    timeout 20 "$talus" ground.tif --tiled $wish >refused.log 2>&1 || ended=$?
    [ "$ended" = 1 ] || fail "$wish: ended with $ended"
    [ "$(grep -c "^talus: " refused.log)" = 1 ] || fail "$wish: $(cat refused.log)"
done
gdal_translate -q -a_ullr 900000 100 900100 0 photo.tif beside.tif
open_window ground.tif --tiled --texture beside.tif --ui-rects rects --window-size 1280x720
await_word "the photo is not shown: 'beside.tif' lies beside the terrain"
close_window
echo "window: flew under a photo and worked in a part of it"
