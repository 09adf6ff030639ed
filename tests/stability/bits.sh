#!/usr/bin/env bash
# What must stay the same to the bit where only the code is rebuilt: bits.sh TALUS prints the hash of every preset after 200 ticks,
# of a journal of 500 acts at random, of its replay at another size, and of the pictures of all methods and views.
# Compare the lists of two builds with diff.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
talus=$1
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
quietly() { "$@" >"$scratch/said" 2>&1 || { cat "$scratch/said" >&2; exit 1; }; }
hash_of() { sed -n 's/.*"hash": *"\([0-9a-f]*\)".*/\1/p' "$1" | head -n 1; }
# Of the pixels, not of the file.
pixels_of() { python3 - "$1" <<'PYTHON'
import hashlib, subprocess, sys
print(hashlib.sha1(subprocess.run(["convert", sys.argv[1], "rgb:-"], capture_output=True, check=True).stdout).hexdigest())
PYTHON
}

for preset in $("$talus" presets | awk '{print $1}'); do
    quietly "$talus" run --preset "$preset" --size 256x256 --ticks 200 --report "$scratch/report.json"
    printf 'preset %-14s %s\n' "$preset" "$(hash_of "$scratch/report.json")"
done

quietly "$talus" run --preset blank --size 129x129 --set terrain.kind=mountains --set terrain.relief_m=400 --ticks 0 --journal "$scratch/start.journal"
python3 "$here/random_journal.py" "$scratch/start.journal" 7 500 >"$scratch/acts.journal"
quietly "$talus" replay "$scratch/acts.journal" --report "$scratch/report.json" --out "$scratch/acts.exr"
echo "journal of 500 acts at random $(hash_of "$scratch/report.json")"
quietly "$talus" replay "$scratch/acts.journal" --size 97x97 --report "$scratch/report.json"
echo "the same at 97 x 97           $(hash_of "$scratch/report.json")"

quietly "$talus" run --preset rain-erosion --size 256x256 --ticks 400 --out "$scratch/rain.exr"
for method in exact boxes mesh hybrid; do
    quietly "$talus" render "$scratch/acts.exr" --method "$method" --size 640x360 --image "$scratch/picture.png"
    echo "method $method $(pixels_of "$scratch/picture.png")"
done
for view in $("$talus" parameters --json | jq -r '.[] | select(.name == "render.view").choices[]'); do
    for scene in acts rain; do
        quietly "$talus" render "$scratch/$scene.exr" --view "$view" --size 640x360 --image "$scratch/picture.png"
        echo "view $view of $scene $(pixels_of "$scratch/picture.png")"
    done
done
