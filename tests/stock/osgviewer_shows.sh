#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Shows a file in a stock osgviewer on a virtual display, or in the program and with the words of $viewer: it has to
# end well, say nothing of warnings or errors, and show moving pictures.
# Usage: osgviewer_shows.sh PLUGIN_FOLDER FILE [OSGVIEWER_OPTION...]      exit 77: not possible here
set -euo pipefail
folder=$1 file=$2
shift 2

for program in osgviewer xvfb-run; do
    command -v "$program" >/dev/null || { echo "skipped: no $program (script/bootstrap test)"; exit 77; }
done
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# Xvfb keeps its screen in a file, which is looked at while osgviewer runs.
export OSG_LIBRARY_PATH=$folder OSG_WINDOW="0 0 320 240"
# Few frames, slow enough to be told apart.
export OSG_RUN_FRAME_COUNT=${frames:-30} OSG_RUN_MAX_FRAME_RATE=15
# OSG opens a display twice: an Xvfb that starts anew in between (no -noreset) breaks the second one.
timeout 120 xvfb-run -a -s "-noreset -screen 0 320x240x24 -fbdir $work" ${viewer:-osgviewer} "$@" "$file" >"$work/said" 2>&1 &
running=$!
seen=""
while kill -0 "$running" 2>/dev/null; do
    picture=$(md5sum "$work/Xvfb_screen0" 2>/dev/null) && seen+=$picture$'\n' # it comes and goes with Xvfb
    sleep 0.1
done
wait "$running" || { echo "failed: exit status $?"; cat "$work/said"; exit 1; }

if grep -iE "warning|error" "$work/said"; then
    echo "failed: the lines above were said"
    exit 1
fi
different=$(sort -u <<<"$seen" | grep -c .)
# Two may be the empty screen and the first picture.
[[ $different -ge 5 ]] || { echo "failed: $different different pictures, expected 5 or more"; exit 1; }
echo "passed: $different different pictures"
