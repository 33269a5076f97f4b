#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# SUMO shows examples/hosts/sumo on a virtual display: moving pictures, and not a word about a .treewind file.
# Usage: sumo.sh PLUGIN_FOLDER      exit 77: not possible here
set -euo pipefail
here=$(realpath "$(dirname "${BASH_SOURCE[0]}")")
for program in sumo-gui xvfb-run; do
    command -v "$program" >/dev/null || { echo "skipped: no $program (script/bootstrap test hosts)"; exit 77; }
done
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

OSG_LIBRARY_PATH=$1 timeout 120 xvfb-run -a -s "-noreset -screen 0 1024x768x24 -fbdir $work" \
    "$here/../../examples/hosts/sumo/run.sh" --end 15 --quit-on-end >"$work/said" 2>&1 &
running=$!
seen=""
while kill -0 "$running" 2>/dev/null; do
    picture=$(md5sum "$work/Xvfb_screen0" 2>/dev/null) && seen+=$picture$'\n' # it comes and goes with Xvfb
    sleep 0.1
done
wait "$running" || { echo "failed: exit status $?"; cat "$work/said"; exit 1; }
if grep -i treewind "$work/said" | grep -v "trees so far$"; then
    echo "failed: the lines above were said"
    exit 1
fi
different=$(sort -u <<<"$seen" | grep -c .)
[[ $different -ge 10 ]] || { echo "failed: $different different pictures, expected 10 or more"; exit 1; }
echo "passed: $different different pictures"
