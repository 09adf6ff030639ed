#!/usr/bin/env bash
# A window on a virtual display: the camera walks over the ground, F12 saves a picture, and a window at rest does nothing.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/window.sh"

# Clock ticks of CPU time that the window took so far.
spent() { awk '{print $14 + $15}' "/proc/$pid/stat"; }
wait_for() {
    for _ in $(seq 100); do [ -f "$1" ] && return; sleep 0.1; done
    fail "F12 did not save $1"
}

open_window --preset alpine --set camera.mode=walk --set camera.walk_m_per_s=100 --set render.samples=3 --set render.view=slope
xdotool mousemove 900 300
frames 8
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
close_window
echo "window: walked, $moved pixels differ; at rest it takes no time"
