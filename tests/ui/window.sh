# A window of Talus on a virtual display, for the scripts beside: source it with the script's own arguments, TALUS and the
# folder for logs and screenshots, which becomes the current one.
talus=$1
folder=$2
ui=$(dirname "$(realpath "${BASH_SOURCE[0]}")")
if [ -z "${TALUS_UNDER_XVFB:-}" ]; then
    TALUS_UNDER_XVFB=1 exec xvfb-run -a -s "-screen 0 1280x720x24 -noreset" bash "$0" "$@"
fi
rm -rf "$folder"
mkdir -p "$folder"
cd "$folder"
export LIBGL_ALWAYS_SOFTWARE=1
# Nothing of the person's own, and nothing left to them.
export XDG_STATE_HOME=$PWD/state XDG_CONFIG_HOME=$PWD/config

fail() {
    local ended=0
    echo "FAILED: $1"
    import -window root failed.png 2>/dev/null || true
    if [ -n "${pid:-}" ] && ! kill -0 "$pid" 2>/dev/null; then
        wait "$pid" || ended=$?
        echo "the window has ended with $ended"
    fi
    exit 1
}
# A script that does not end well says what the window said: a crash writes there what led to it.
last_words() {
    local code=$?
    [ "$code" = 0 ] || cat window.log 2>/dev/null || true
    [ -z "${pid:-}" ] || kill "$pid" 2>/dev/null || true
}
trap last_words EXIT

# Opens it with the options given; `pid` is its process, `ping` one that knows when it has drawn.
open_window() {
    local window=
    [ -z "${ping_PID:-}" ] || kill "$ping_PID" 2>/dev/null || true
    wait "${ping_PID:-}" 2>/dev/null || true
    "$talus" "$@" >window.log 2>&1 &
    pid=$!
    for _ in $(seq 100); do
        window=$(xdotool search --name 'Talus$' 2>/dev/null | head -n 1) && [ -n "$window" ] && break
        kill -0 "$pid" 2>/dev/null || fail "the window did not open"
        sleep 0.1
    done
    [ -n "$window" ] || fail "no window appeared"
    coproc ping { exec /usr/bin/python3 "$ui/ping.py" "$window" 2>ping.log; }
}

# Waits until the window has drawn so many frames with what was done, or has nothing left to draw.
frames() {
    local said= part= whole=
    [ -n "${ping_PID:-}" ] || fail "nobody asks the window: $(cat ping.log)"
    echo "$1" >&"${ping[1]}"
    for _ in $(seq 600); do
        # A word may come in two parts.
        read -r -t 0.1 -u "${ping[0]}" part && whole=yes
        said+=$part
        [ -z "$whole" ] || break
        kill -0 "$pid" 2>/dev/null || return 0
    done
    [ "$said" = drawn ] || fail "the window does not answer: $said $(cat ping.log)"
}

# Waits until long work that was asked for is done: it says so from its first frame on.
await_work() {
    frames 4
    for _ in $(seq 600); do
        [ -z "$(rect_of "Cancel work")" ] && return
        sleep 0.1
    done
    fail "the work does not end"
}

close_window() {
    xdotool key ctrl+q
    for _ in $(seq 100); do kill -0 "$pid" 2>/dev/null || break; sleep 0.1; done
    kill -0 "$pid" 2>/dev/null && fail "Ctrl+Q did not close the window"
    wait "$pid" || fail "the window ended with an error"
}

# Closes a window whose work is not saved.
drop_and_close() {
    xdotool mousemove 600 400 key ctrl+q
    click "Drop the changes"
    for _ in $(seq 100); do kill -0 "$pid" 2>/dev/null || break; sleep 0.1; done
    kill -0 "$pid" 2>/dev/null && fail "the window did not close"
    wait "$pid" || fail "the window ended with an error"
}

# Where a named widget is, as "left top right bottom"; the window must have been opened with --ui-rects rects.
rect_of() { sed -n "s/^\([-0-9]* [-0-9]* [-0-9]* [-0-9]*\) $1\$/\1/p" rects 2>/dev/null | head -n 1; }
# Waits until the widget is there.
await_widget() {
    for _ in $(seq 150); do [ -n "$(rect_of "$1")" ] && return; sleep 0.1; done
    fail "there is no widget '$1'"
}
# Clicks in the middle of a named widget, once it is there and has stopped moving.
click() {
    local before= now
    await_widget "$1"
    for _ in $(seq 50); do
        now=$(rect_of "$1")
        [ "$now" = "$before" ] && break
        before=$now
        frames 2
    done
    set -- $now
    xdotool mousemove $((($1 + $3) / 2)) $((($2 + $4) / 2))
    frames 2
    xdotool mousedown 1
    frames 2
    xdotool mouseup 1
    frames 2
}
# Types an exact number into a parameter.
type_into() {
    local name=$1
    await_widget "$name"
    set -- "$2" $(rect_of "$name")
    xdotool mousemove $((($2 + $4) / 2)) $((($3 + $5) / 2))
    frames 2
    xdotool keydown ctrl mousedown 1
    frames 2
    xdotool mouseup 1 keyup ctrl
    frames 2
    xdotool key ctrl+a type --delay 1 -- "$1"
    frames 2
    xdotool key Return
    frames 2
}
# Waits for a line in the window's own words.
await_word() {
    for _ in $(seq "${2:-300}"); do grep -q "$1" window.log && return; sleep 0.1; done
    fail "the window never said '$1'"
}
hash_of() { "$talus" info --json "$1" | sed -n 's/.*"hash": "\(.*\)".*/\1/p'; }
# Presses the left button at a place of the picture, once the mouse is known to be there.
press_at() {
    xdotool mousemove "$1" "$2"
    frames 8
    xdotool mousedown 1
    frames 4
    xdotool mouseup 1
    frames 8
}
# A drag of the left button, or of another one, slowly enough that the cursor is read on the way.
drag() {
    xdotool mousemove "$1" "$2"
    frames 8
    xdotool mousedown "${5:-1}"
    frames 8
    xdotool mousemove $((($1 + $3) / 2)) $((($2 + $4) / 2))
    frames 8
    xdotool mousemove "$3" "$4"
    frames 8
    xdotool mouseup "${5:-1}"
    frames 4
}
# Lets time run for so many seconds.
play() {
    xdotool key space
    sleep "$1"
    xdotool key space
    frames 4
}
# Saves the document under a name in the folder.
save_as() {
    xdotool mousemove 600 600 key ctrl+shift+s
    await_widget "file name"
    frames 4
    xdotool key ctrl+a type --delay 1 "$PWD/$1"
    xdotool key Return
    await_word "saved .*$1"
    await_work
}
# How deep the water of a document is at most, m.
depth() { "$talus" convert "$1" depth.tif --layer water && "$talus" info --json depth.tif | sed -n 's/.*"height_max": \([0-9.]*\).*/\1/p'; }
# Saves to saved.exr, which the document must have been saved to before, and copies that.
save() {
    local said
    said=$(grep -c "saved .*saved.exr" window.log || true)
    xdotool key ctrl+s
    for _ in $(seq 150); do
        [ "$(grep -c "saved .*saved.exr" window.log || true)" -gt "$said" ] && break
        sleep 0.1
    done
    cp saved.exr "$1"
}
