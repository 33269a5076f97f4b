#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# A stock osgviewer in an OpenGL core profile: it is told once why there are no trees, and ends well.
# Usage: osgviewer_core_profile.sh PLUGIN_FOLDER FILE      exit 77: not possible here
set -euo pipefail
for program in osgviewer xvfb-run; do
    command -v "$program" >/dev/null || { echo "skipped: no $program (script/bootstrap test)"; exit 77; }
done
export OSG_LIBRARY_PATH=$1 OSG_RUN_FRAME_COUNT=5 OSG_WINDOW="0 0 320 240"
export OSG_GL_CONTEXT_VERSION=3.3 OSG_GL_CONTEXT_PROFILE_MASK=1
# OSG opens a display twice: an Xvfb that starts anew in between (no -noreset) breaks the second one.
said=$(timeout 120 xvfb-run -a -s "-noreset -screen 0 320x240x24" osgviewer "$2" 2>&1) || { echo "failed: $?, $said"; exit 1; }
told=$(grep -c "osgTreeWind: trees are not drawn in an OpenGL core profile" <<<"$said" || true)
[[ $told -eq 1 ]] || { echo "failed: told $told times, expected once, in: $said"; exit 1; }
