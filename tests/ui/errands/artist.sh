#!/usr/bin/env bash
# The artist's errand: a mountain valley from New to textured export (ground of 16 bits, flow, wear, deposition, slope), a
# picture, and a film once around it. TALUS FOLDER; pictures stay in the folder.
set -euo pipefail
source "$(dirname "$(realpath "${BASH_SOURCE[0]}")")/errand.sh"

open_window --ui-rects rects --window-size 1280x720
hit "New terrain…"
await_widget Generate
hit terrain.kind
hit "terrain.kind=valley"
enter terrain.nx 257
enter terrain.ny 257
enter terrain.relief_m 1200
frames 60
import -window root artist_1_new.png
hit Generate
await_work
frames 8
hit Erosion
hit climate
hit "climate=Monsoon"
hit rock
hit "rock=Layered sandstone"
frames 4
set -- $(rect_of Age)
clicks=$((clicks + 1))
drag $((($1 + $3) / 2)) $((($2 + $4) / 2)) $(($3 - 10)) $((($2 + $4) / 2))
frames 8
clicks=$((clicks + 2))
play 21
# A film of the last seconds, where ffmpeg is there to write one.
if command -v ffmpeg >/dev/null; then
    hit Record
    clicks=$((clicks + 2))
    play 4
    hit "End film"
    await_word "saved the film .*talus-0001.mp4"
    is_there talus-0001.mp4
else
    echo "artist: there is no ffmpeg, so no film was recorded"
    play 4
fi
shot artist_2_eroded
xdotool mousemove 600 400 key ctrl+e
hit maps
click "export path"
xdotool key ctrl+a type --delay 1 "$PWD/valley.png"
frames 8
import -window root artist_3_export.png
hit Write
await_word "wrote .*valley"
for map in ground flow wear deposition slope; do
    is_there "valley_$map.png"
    identify -format '%z' "valley_$map.png" | grep -q 16 || fail "$map has not 16 bits"
done
is_there valley.json
xdotool mousemove 600 400 key F12
await_word "saved the picture"
xdotool key ctrl+shift+s
name_file "$PWD/valley"
await_word "saved .*valley.exr"
took=$((SECONDS - begin))
close_window
"$talus" render valley.exr --turntable 24 --size 640x360 --set render.samples=1 --image turn.png 2>/dev/null
is_there turn-0023.png
if command -v ffmpeg >/dev/null; then
    ffmpeg -loglevel error -y -framerate 12 -i turn-%04d.png -pix_fmt yuv420p turn.mp4
    is_there turn.mp4
fi
echo "artist: $clicks clicks, $took s in the window"
