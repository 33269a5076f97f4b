#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# A stock osgviewer in an OpenGL core profile: it shows trees, we say nothing, and it ends well. OSG itself complains
# about what it applies there, unless it is built for core profiles.
# Usage: osgviewer_core_profile.sh PLUGIN_FOLDER FILE      exit 77: not possible here
set -euo pipefail
for program in osgviewer xvfb-run; do
    command -v "$program" >/dev/null || { echo "skipped: no $program (script/bootstrap test)"; exit 77; }
done
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export OSG_LIBRARY_PATH=$1 OSG_RUN_FRAME_COUNT=30 OSG_RUN_MAX_FRAME_RATE=15 OSG_WINDOW="0 0 320 240"
export OSG_GL_CONTEXT_VERSION=3.3 OSG_GL_CONTEXT_PROFILE_MASK=1
# OSG opens a display twice: an Xvfb that starts anew in between (no -noreset) breaks the second one.
timeout 120 xvfb-run -a -s "-noreset -screen 0 320x240x24 -fbdir $work" osgviewer "$2" >"$work/said" 2>&1 &
running=$!
colours=0 # of the pixels of the screen, which Xvfb keeps in a file: one or two without trees
while kill -0 "$running" 2>/dev/null; do
    seen=$(tail -c 307200 "$work/Xvfb_screen0" 2>/dev/null | od -An -v -w4 -tx4 | sort -u | wc -l) || seen=0
    colours=$((seen > colours ? seen : colours))
    sleep 0.2
done
wait "$running" || { echo "failed: exit status $?"; cat "$work/said"; exit 1; }
! grep osgTreeWind "$work/said" || { echo "failed: the lines above were said"; exit 1; }
[[ $colours -gt 100 ]] || { echo "failed: $colours colours on the screen, expected more than 100"; exit 1; }
echo "passed: $colours colours"
