#!/usr/bin/env bash
# The long tests: one hash for release and debug, and kill -9 while saving leaves the old or the new file.
set -euo pipefail
release=$(realpath "$1")
debug=$(realpath "$2")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
hash_of() { "$release" info --json "$1" | sed -n 's/.*"hash": "\(.*\)".*/\1/p'; }

for program in "$release" "$debug"; do
    "$program" run --preset alpine --size 257x257 --ticks 200 --out "$(basename "$(dirname "$program")").exr" 2>/dev/null
done
echo "release $(hash_of release.exr), debug $(hash_of debug.exr)"
[ "$(hash_of release.exr)" = "$(hash_of debug.exr)" ]

"$release" run --preset alpine --size 1025x1025 --ticks 0 --out old.exr 2>/dev/null
old=$(hash_of old.exr)
cp old.exr target.exr
new=$("$release" run --in old.exr --ticks 1 --json 2>/dev/null | sed -n 's/.*"hash": "\(.*\)".*/\1/p')
kept=0
replaced=0
for i in $(seq 50); do
    cp old.exr target.exr
    "$release" run --in old.exr --ticks 1 --out target.exr >/dev/null 2>&1 &
    pid=$!
    # From before the save to after it.
    sleep "$(awk -v i="$i" 'BEGIN { printf "%.3f", 0.4 + i * 0.04 }')"
    kill -9 "$pid" 2>/dev/null || true
    wait "$pid" 2>/dev/null || true
    now=$(hash_of target.exr)
    if [ "$now" = "$old" ]; then kept=$((kept + 1)); elif [ "$now" = "$new" ]; then replaced=$((replaced + 1)); else echo "FAILED: kill $i left neither file"; exit 1; fi
    rm -f .target.exr.*
done
echo "kill -9 during a save, 50 times: $kept old, $replaced new, 0 broken"
[ "$kept" -gt 0 ] && [ "$replaced" -gt 0 ]
