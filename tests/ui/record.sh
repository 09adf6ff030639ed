#!/usr/bin/env bash
# The button Record: a film of the view beside the project, by a program in ffmpeg's place that keeps what it is given; pictures
# of F12 go there too. Without ffmpeg it says so, and a film that goes on when the window closes is written.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/window.sh"

mkdir project bin
printf '#!/bin/sh\nfor last; do :; done\necho "$@" >>"%s/words"\ncat >"${last#file:}"\n' "$PWD" >bin/ffmpeg
chmod +x bin/ffmpeg
"$talus" run --preset rain-erosion --size 97x97 --ticks 2 --out project/wet.exr 2>/dev/null
PATH=$PWD/bin:$PATH open_window project/wet.exr --ui-rects rects --window-size 1280x720
await_widget Play
xdotool mousemove 600 400 key F12
await_word "saved the picture project/talus-0001.png"

# Two seconds of play are a film of two seconds and more, of pictures of the view's size that differ.
click Record
await_widget "End film"
click Play
sleep 2
click Pause
import -window root recording.png
click "End film"
await_word "saved the film project/talus-0001.mp4"
await_widget Record
bytes=$(stat -c %s project/talus-0001.mp4)
size=$(grep -o 'video_size [0-9x]*' words | tail -n 1 | cut -d' ' -f2)
frame=$((3 * ${size%x*} * ${size#*x}))
[ $((bytes % frame)) = 0 ] || fail "the film has no whole number of pictures of $size"
[ $((bytes / frame)) -ge 50 ] || fail "the film has $((bytes / frame)) pictures of more than two seconds"
head -c "$frame" project/talus-0001.mp4 >first.rgb
tail -c "$frame" project/talus-0001.mp4 >last.rgb
cmp -s first.rgb last.rgb && fail "the film stands still"
# Its first picture is the view's: as the saved one, but for how many samples a pixel has.
convert -size "$size" -depth 8 rgb:first.rgb first.png
error=$( (compare -metric RMSE first.png project/talus-0001.png null: 2>&1 || true) | sed 's/.*(\(.*\))/\1/')
awk "BEGIN { exit !($error < 0.06) }" || fail "the film's first picture is not the view: $error"

# One that goes on when the window closes is written.
xdotool mousemove 600 400 key F9
await_widget "End film"
xdotool key period
frames 8
drop_and_close
[ "$(stat -c %s project/talus-0002.mp4)" -ge "$frame" ] || fail "the second film was not written"

# Without ffmpeg it says so.
printf '#!/bin/sh\nPATH=/nowhere exec "%s" "$@"\n' "$talus" >without
chmod +x without
talus=$PWD/without
open_window project/wet.exr --ui-rects rects --window-size 1280x720
await_widget Play
click Record
await_word "there is no program ffmpeg"
await_widget Record
close_window
echo "passed"
