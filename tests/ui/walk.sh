#!/usr/bin/env bash
# A window on a virtual display: the camera walks over the ground, F12 saves a picture, and a window at rest does nothing.
set -euo pipefail
talus=$1
folder=$2
if [ -z "${TALUS_UNDER_XVFB:-}" ]; then
    TALUS_UNDER_XVFB=1 exec xvfb-run -a -s "-screen 0 1280x720x24" bash "$0" "$@"
fi
rm -rf "$folder"
mkdir -p "$folder"
cd "$folder"
export LIBGL_ALWAYS_SOFTWARE=1

fail() { echo "FAILED: $1"; cat window.log; exit 1; }
# Clock ticks of CPU time that the window took so far.
spent() { awk '{print $14 + $15}' "/proc/$pid/stat"; }
wait_for() {
    for _ in $(seq 100); do [ -f "$1" ] && return; sleep 0.1; done
    fail "F12 did not save $1"
}

"$talus" --preset alpine --set camera.mode=walk --set camera.walk_m_per_s=100 --set render.samples=3 --set render.view=slope >window.log 2>&1 &
pid=$!
trap 'kill "$pid" 2>/dev/null || true' EXIT
for _ in $(seq 100); do
    window=$(xdotool search --name 'Talus$' 2>/dev/null | head -n 1) && [ -n "$window" ] && break
    kill -0 "$pid" 2>/dev/null || fail "the window did not open"
    sleep 0.1
done
[ -n "${window:-}" ] || fail "no window appeared"
xdotool mousemove 900 300
sleep 3
xdotool key F12
wait_for talus-0001.png
xdotool keydown w
sleep 2
xdotool keyup w
# It comes to rest: samples are gathered, the ground is reached, and then nothing is drawn.
at_rest=
for _ in $(seq 60); do
    before=$(spent)
    sleep 1
    [ $(($(spent) - before)) -le 5 ] && at_rest=yes && break
done
[ -n "$at_rest" ] || fail "the window does not come to rest"
import -window root walked.png
xdotool key F12
wait_for talus-0002.png
moved=$(compare -metric AE talus-0001.png talus-0002.png null: 2>&1 || true)
[ "${moved%%.*}" -gt 100000 ] || fail "walking did not change the picture"
xdotool key ctrl+q
for _ in $(seq 100); do kill -0 "$pid" 2>/dev/null || break; sleep 0.1; done
kill -0 "$pid" 2>/dev/null && fail "Ctrl+Q did not close the window"
wait "$pid" || fail "the window ended with an error"
echo "window: walked, $moved pixels differ; at rest it takes no time"
