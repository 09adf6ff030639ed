#!/usr/bin/env bash
# Over terrain in tiles: a picture has the bits of `talus render`; what changes terrain is refused in words; a file that breaks
# in mid-flight and comes back; from one terrain to another and back. Pictures stay in the folder.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/window.sh"

"$talus" tile --generate mountains,8200x601 --spacing 10 wide.tif 2>/dev/null
"$talus" run --preset alpine --size 257x257 --ticks 0 --out small.exr 2>/dev/null

open_window wide.tif --ui-rects rects --window-size 1280x720
await_widget Log
frames 20
import -window root 1_overview.png
[ -z "$(rect_of Play)" ] && [ -z "$(rect_of Water)" ] || fail "what changes terrain is offered"

xdotool key F12
await_word "saved the picture talus-0001.png"
size=$(identify -format %wx%h talus-0001.png)
"$talus" render wide.tif --size "$size" --image rendered.png 2>/dev/null
differing=$(compare -metric AE talus-0001.png rendered.png null: 2>&1) || fail "$differing pixels of the picture are others"

# Nothing happens to it, and the window says why.
xdotool key space
await_word "'wide.tif' is shown in tiles: it can be looked at, and not changed or written"
xdotool key ctrl+s key ctrl+e key 3 key bracketleft
frames 4
[ -z "$(rect_of "export path")" ] || fail "an export is offered of what cannot be written"
[ "$(grep -c "^talus: 'wide.tif' is shown in tiles" window.log)" = 3 ] || fail "not each key was refused in words"
grep "^talus: " window.log | grep -v "is shown in tiles" && fail "the window met an error"

# Towards the ground and along it; the file breaks meanwhile.
cp wide.tif whole.tif
size_bytes=$(stat -c %s wide.tif)
# Overviews stand behind the finest level.
dd if=/dev/zero of=wide.tif bs=65536 seek=1 count=$((size_bytes / 65536 * 7 / 10)) conv=notrunc 2>/dev/null
xdotool mousemove 480 420
for _ in $(seq 8); do xdotool click 4; frames 2; done
xdotool keydown w
await_word "coarser tiles are shown there, and it is tried again"
await_word "'wide.tif' was changed by another program"
xdotool keyup w
frames 4
import -window root 2_broken.png
kill -0 "$pid" || fail "the flight ended"
dd if=whole.tif of=wide.tif bs=65536 conv=notrunc 2>/dev/null
await_word "tiles can be read again"
frames 20
import -window root 3_mended.png

# What is no terrain, though it is large, is refused in words, and the flight goes on.
head -c 2000000 /dev/zero >row.bil
printf 'NROWS 1\nNCOLS 1000000\nNBANDS 1\nNBITS 16\nPIXELTYPE SIGNEDINT\nLAYOUT BIL\n' >row.hdr
xdotool key ctrl+o
await_widget "file name"
click "file name"
xdotool key ctrl+a type --delay 1 "$PWD/row.bil"
frames 4
xdotool key Return
await_word "row.bil' holds 1000000 x 1 samples, each side must have at least 2"
xdotool keydown w
frames 20
xdotool keyup w
[ -z "$(rect_of Play)" ] || fail "the terrain in tiles is there no more"

# A terrain to work in, and back.
xdotool key ctrl+o
await_widget "file name"
click "file name"
xdotool key ctrl+a type --delay 1 "$PWD/small.exr"
frames 4
xdotool key Return
await_widget Play
[ -n "$(rect_of Water)" ] || fail "the panels of a terrain to work in are not there"
xdotool key space
frames 10
xdotool key space
xdotool key ctrl+o
await_widget "file name"
click "file name"
xdotool key ctrl+a type --delay 1 "$PWD/wide.tif"
frames 4
xdotool key Return
click "Drop the changes"
for _ in $(seq 100); do [ -z "$(rect_of Play)" ] && break; sleep 0.1; done
[ -z "$(rect_of Play)" ] || fail "the terrain in tiles did not open again"
frames 20
import -window root 4_again.png
close_window

# What is not measured yet is flown over meanwhile; the options that the window was opened with hold. Overviews that a file has
# not are made beside it.
gdal_translate -q -co COMPRESS=DEFLATE wide.tif plain.tif
rm wide.tif.tiles
number=2
for file in wide plain; do
    rm -f rects
    open_window $file.tif --ui-rects rects --window-size 1280x720 --set render.view=slope
    await_widget Log
    [ -z "$(rect_of Play)" ] || fail "$file.tif is not what is shown"
    xdotool keydown w
    await_word "'$file.tif' is measured"
    xdotool keyup w
    [ -e $file.tif.tiles ] || fail "the bounds of $file.tif were not kept"
    [ "$(grep -n "first picture" window.log | cut -d: -f1)" -lt "$(grep -n "is measured" window.log | cut -d: -f1)" ] ||
        fail "the first picture waited for bounds"
    xdotool key f
    frames 20
    xdotool key F12
    await_word "saved the picture talus-000$number.png"
    "$talus" render $file.tif --view slope --size "$size" --image slope.png 2>/dev/null
    differing=$(compare -metric AE talus-000$number.png slope.png null: 2>&1) || fail "$differing pixels of the slopes are others"
    number=$((number + 1))
    close_window
done
[ -e plain.tif.ovr ] || fail "no overviews were made"
[ "$(gdalinfo plain.tif | grep -c "Overviews: 4100x301, 2050x151")" = 1 ] || fail "GDAL sees no overviews"
measured=$(stat -c %Y.%s wide.tif.tiles)
open_window wide.tif --ui-rects rects --window-size 1280x720
frames 4
[ "$(grep -c "begun with hash" window.log)" = 1 ] && [ "$(stat -c %Y.%s wide.tif.tiles)" = "$measured" ] || fail "it was measured again"
close_window

# What a terrain in tiles has not is refused at once, also where it would be measured first.
rm wide.tif.tiles
for wish in "--preset waves" "--set render.view=depth" "--set water.rain_mm_per_h=5" "--set render.method=mesh" "--journal j"; do
    ended=0
    timeout 20 "$talus" wide.tif $wish >refused.log 2>&1 || ended=$?
    [ "$ended" = 1 ] || fail "$wish: ended with $ended"
    [ "$(grep -c "^talus: " refused.log)" = 1 ] || fail "$wish: $(cat refused.log)"
done
echo "window: flew over terrain in tiles"
