# A window of Talus on a virtual display, for the scripts beside: source it with the script's own arguments, TALUS and the
# folder for logs and screenshots, which becomes the current one.
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

# Opens it with the options given; `pid` is its process.
open_window() {
    local window=
    "$talus" "$@" >window.log 2>&1 &
    pid=$!
    trap 'kill "$pid" 2>/dev/null || true' EXIT
    for _ in $(seq 100); do
        window=$(xdotool search --name 'Talus$' 2>/dev/null | head -n 1) && [ -n "$window" ] && return
        kill -0 "$pid" 2>/dev/null || fail "the window did not open"
        sleep 0.1
    done
    fail "no window appeared"
}

close_window() {
    xdotool key ctrl+q
    for _ in $(seq 100); do kill -0 "$pid" 2>/dev/null || break; sleep 0.1; done
    kill -0 "$pid" 2>/dev/null && fail "Ctrl+Q did not close the window"
    wait "$pid" || fail "the window ended with an error"
}
