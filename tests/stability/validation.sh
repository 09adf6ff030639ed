#!/usr/bin/env bash
# The tests that hang on order, on zink under Vulkan's validation layer with its check of synchronisation: it says nothing but
# what is known to be Mesa's. Arguments: the build's folder; the tests, as ctest's -R takes them.
# Where Mesa's packing of textures into buffers confuses the layer's record of image layouts, the layer itself ends by a
# segmentation fault (layer 1.3.239, Mesa 22.3.6), of a test or of a script's window (139): such tests are listed, and count
# as not shown.
set -euo pipefail
build=$1
tests=$2
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
export LIBGL_ALWAYS_SOFTWARE=1 GALLIUM_DRIVER=zink MESA_LOADER_DRIVER_OVERRIDE=zink XDG_RUNTIME_DIR="${XDG_RUNTIME_DIR:-$scratch}"
export VK_INSTANCE_LAYERS=VK_LAYER_KHRONOS_validation VK_LAYER_ENABLES=VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT
# The commonest of them, one a draw, is left out by the layer itself.
export VK_LAYER_MESSAGE_ID_FILTER=VUID-VkGraphicsPipelineCreateInfo-renderPass-06581

# What is Mesa's, and why. OpenGL has no pipelines, descriptor sets or image layouts: a program cannot get them wrong.
known=(
    VUID-VkGraphicsPipelineCreateInfo-  # pipelines are made with more dynamic state, and more resources, than declared
    VUID-vkCmdDrawMultiEXT-None-02859   # the same state is set in pipelines that do not declare it
    "vkCmdSetColor[A-Za-z]*EXT: parameter attachmentCount" # the same, of pictures without colours
    VUID-VkDescriptorSetLayoutCreateInfo-binding-00279 # two bindings of one number in a set of zink's
    # Textures that are packed into buffers are read by a draw of zink's; it does not note the layout that it leaves them in.
    UNASSIGNED-CoreValidation-DrawState-InvalidImageLayout
    VUID-VkDescriptorImageInfo-imageLayout-00344
    VUID-VkImageMemoryBarrier2-oldLayout-01197
    VUID-vkCmdDispatch-None-02699
    VUID-vkCmdDispatchIndirect-None-02699
    VUID-vkCmdDrawMultiEXT-None-02699
    # Changes of layout that zink puts beside stores and reads without waiting for them, or for stores alone. What a shader of ours
    # stores and another reads, without such a change between, is not among these.
    "SYNC-HAZARD.*usage: SYNC_IMAGE_LAYOUT_TRANSITION"
)
printf '%s\n' "${known[@]}" >"$scratch/known"

ctest --test-dir "$build" -R "$tests" -j "$(nproc)" --verbose >"$scratch/said" || true
ran=$(grep -ac '^ *[0-9]*/[0-9]* Test ' "$scratch/said")
passed=$(grep -ac '^ *[0-9]*/[0-9]* Test .* Passed ' "$scratch/said")
mapfile -t layers < <(awk '
    /^[0-9]+: the window has ended with 139$/ { window[$1 + 0] = 1 }
    /^ *[0-9]+\/[0-9]+ Test +#/ {
        number = $0; sub(/.*#/, "", number); number += 0
        name = $0; sub(/.*#[0-9]+: /, "", name); sub(/ \.\..*/, "", name)
        if (/Exception: SegFault/ || (/\*\*\*Failed/ && number in window)) print name
    }' "$scratch/said")
grep -a '(ERROR / SPEC)' "$scratch/said" >"$scratch/errors" || true
[ -s "$scratch/errors" ] || { echo "the layer said nothing at all, not even what is Mesa's: is it installed?" >&2; exit 1; }
grep -v -f "$scratch/known" "$scratch/errors" >"$scratch/ours" || true
echo "$ran tests: $passed passed, the layer ended in ${#layers[@]}; $(wc -l <"$scratch/errors") messages, $(wc -l <"$scratch/ours") not known"
printf '  the layer ended in %s\n' "${layers[@]:-none}"
sed 's/^\([0-9]*: \)\?\([A-Z][A-Za-z0-9_-]*\)(.*/\2/' "$scratch/errors" | sort | uniq -c
head -n 5 "$scratch/ours"
[ ! -s "$scratch/ours" ] && [ $((passed + ${#layers[@]})) -eq "$ran" ]
