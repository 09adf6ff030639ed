#!/usr/bin/env bash
# Hashes of all presets after 100 ticks at 128 x 128 samples, on llvmpipe and on zink: they are the same.
set -euo pipefail
talus=$1
reports=$(mktemp -d)
trap 'rm -rf "$reports"' EXIT
export LIBGL_ALWAYS_SOFTWARE=1 XDG_RUNTIME_DIR="${XDG_RUNTIME_DIR:-$reports}"
differ=0
for preset in $("$talus" presets | awk '{print $1}'); do
    for driver in llvmpipe zink; do
        GALLIUM_DRIVER=$driver "$talus" run --preset "$preset" --size 128x128 --ticks 100 --report "$reports/$driver.json" \
            2>"$reports/said" || { cat "$reports/said" >&2; exit 1; }
        grep -qi "$driver" "$reports/said" || { echo "'$driver' is not the driver that ran: $(head -n 1 "$reports/said")" >&2; exit 1; }
    done
    one=$(jq -r .hash "$reports/llvmpipe.json")
    other=$(jq -r .hash "$reports/zink.json")
    [ "$one" = "$other" ] && same=same || { same=DIFFERENT; differ=1; }
    printf '%-14s %s %s %s\n' "$preset" "$one" "$other" "$same"
done
exit $differ
