#!/usr/bin/env bash
# The panels at both sides are dragged to another width, folded and brought back, and the next window has them as they were.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/window.sh"

right_of() { rect_of "$1" | cut -d' ' -f3; }
left_of() { rect_of "$1" | cut -d' ' -f1; }

open_window --preset blank --ui-rects rects --window-size 1280x720
await_widget Redo
frames 4
tools=$(right_of Redo)
panels=$(left_of Simulation)
drag $((tools + 7)) 500 $((tools + 77)) 500
drag $((panels - 8)) 500 $((panels - 108)) 500
frames 4
wider=$(right_of Redo)
[ "$wider" -ge $((tools + 60)) ] && [ "$wider" -le $((tools + 80)) ] || fail "the tools end at $wider, not 70 further than $tools"
begins=$(left_of Simulation)
[ "$begins" -le $((panels - 90)) ] && [ "$begins" -ge $((panels - 110)) ] || fail "the panels begin at $begins, not 100 before $panels"
# However far it is dragged, the picture keeps some room, and nothing lies on anything else.
drag $((begins - 8)) 500 5 500
frames 4
least=$(left_of Simulation)
[ "$least" -gt $((wider + 100)) ] || fail "the panels lie over the picture and the tools: from $least on, tools to $wider"
drag $((least - 8)) 500 $((begins - 8)) 500
frames 4
import -window root 1_dragged.png

click "View menu"
click "Tools at the left"
await_widget "unfold Tools"
click "View menu"
click "Panels at the right"
await_widget "unfold Panels"
[ -z "$(rect_of Redo)" ] && [ -z "$(rect_of Simulation)" ] || fail "what is folded is still there"
import -window root 2_folded.png
click "unfold Tools"
await_widget Redo
kept=$(left_of "unfold Panels")
close_window

open_window --preset blank --ui-rects rects
await_widget Redo
frames 4
[ "$(right_of Redo)" -eq "$wider" ] || fail "the tools ended at $wider and end at $(right_of Redo) in the next window"
[ "$(left_of "unfold Panels")" -eq "$kept" ] || fail "the panels are not folded in the next window"
click "unfold Panels"
await_widget Simulation
frames 4
again=$(left_of Simulation)
[ "$again" -ge $((begins - 3)) ] && [ "$again" -le $((begins + 3)) ] || fail "the panels began at $begins, now at $again"
close_window
echo "sides: tools from $tools to $wider, panels from $panels to $begins, folded, unfolded, kept"
